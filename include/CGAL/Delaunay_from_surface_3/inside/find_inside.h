// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_FIND_INSIDE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_FIND_INSIDE_H

// Finds the winding numbers of tetrahedra, and whether they define an inside.

#include <CGAL/Delaunay_from_surface_3/Inside_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/arrays/complete_arrays.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Sort_by_halves.h>
#include <CGAL/Delaunay_from_surface_3/inside/Regions.h>
#include <CGAL/Delaunay_from_surface_3/inside/Winding_field.h>
#include <CGAL/Delaunay_from_surface_3/support/Disjoint_sets.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The following finds the orientation of triangles, and where they are not closed.
//
// turn_alike() turns triangles of a surface whose parts were put together carelessly, so that
// neighbours agree.
//
// open_edges() finds the edges that triangles pass more often in one direction than in the other.
// The winding number jumps at triangles only, and it is an integer if there is no such edge. The
// size of the openings is estimated: each connected set of these edges is joined with its middle by
// triangles, which would close it. Linear, apart from open edges.

// Groups the sides of triangles by edges. Side 3 t + k of triangle t leads from its corner k to the
// next one, or back if the triangle has been turned.
class Sides
{
public:
  // Takes triangles on n vertices, none of which has a vertex twice. Keeps a reference to them.
  Sides(const std::vector<Corners>& triangles, std::size_t n)
    : m_triangles(triangles)
    , m_is_turned(triangles.size(), 0)
    , m_lists(in_lists<std::uint32_t>(
          n, Listed_items(
                 3 * triangles.size(),
                 [&](std::size_t s) { return (std::min)(ends(s)[0], ends(s)[1]); },
                 [&](std::size_t s) { return std::uint32_t(s); })))
  {
  }

  const std::vector<Corners>& triangles() const { return m_triangles; }
  bool is_turned(std::size_t t) const { return m_is_turned[t] != 0; }
  void turn(std::size_t t) { m_is_turned[t] = char(1 - m_is_turned[t]); }

  std::array<std::size_t, 2> ends(std::size_t side) const
  {
    const Corners& t = m_triangles[side / 3];
    const std::size_t a = t[side % 3], b = t[(side + 1) % 3];
    return m_is_turned[side / 3] != 0 ? std::array<std::size_t, 2>{b, a}
                                      : std::array<std::size_t, 2>{a, b};
  }

  // Calls visit(low, high, sides) for each edge, with its ends and a vector of its sides.
  template <class Visit>
  void for_each_edge(const Visit& visit) const
  {
    std::vector<std::pair<std::size_t, std::uint32_t>> others; // the other end of a side, and it
    std::vector<std::uint32_t> sides;
    for (std::size_t low = 0; low < m_lists.size(); ++low) {
      others.clear();
      for (const std::uint32_t* s = m_lists.begin(low); s != m_lists.end(low); ++s)
        others.emplace_back((std::max)(ends(*s)[0], ends(*s)[1]), *s);
      std::sort(others.begin(), others.end());
      for (std::size_t i = 0; i < others.size();) {
        const std::size_t high = others[i].first;
        for (sides.clear(); i < others.size() && others[i].first == high; ++i)
          sides.push_back(others[i].second);
        visit(low, high, sides);
      }
    }
  }

private:
  const std::vector<Corners>& m_triangles;
  std::vector<char> m_is_turned;
  Lists<std::uint32_t> m_lists;
};

// Finds for each side the other side of its edge, or `none` if there is no or more than one other.
class Other_sides
{
public:
  static constexpr std::uint32_t none = std::uint32_t(-1);

  explicit Other_sides(const Sides& sides)
    : m_others(3 * sides.triangles().size(), none)
  {
    sides.for_each_edge([&](std::size_t, std::size_t, const std::vector<std::uint32_t>& of_edge) {
      const std::uint32_t s = of_edge.front(), t = of_edge.back();
      if (of_edge.size() != 2)
        return;
      m_others[s] = t;
      m_others[t] = s;
      m_do_agree = m_do_agree && sides.ends(s)[0] == sides.ends(t)[1];
    });
  }

  std::uint32_t operator[](std::size_t side) const { return m_others[side]; }

  // Returns whether each edge with two triangles is passed once in each direction.
  bool do_agree() const { return m_do_agree; }

private:
  std::vector<std::uint32_t> m_others;
  bool m_do_agree = true;
};

// Turns triangles so that those joined by edges with two triangles agree: in a component that is
// not coherent, it turns the triangles that disagree with most of the area. If both kinds have the
// same area, like the halves of a sphere, it turns the kind that makes the volume positive. A
// coherent component stays as it is: if it looks inwards, it is the wall of a cavity. A component
// that is not orientable stays, too; returns how many of these there are. The coordinates
// point_of(v) must be safe from overflow. Linear.
template <class PointOf>
std::size_t turn_alike(Sides& sides, const PointOf& point_of)
{
  std::size_t not_orientable = 0;
  const Other_sides others(sides);
  if (others.do_agree())
    return not_orientable;
  const std::vector<Corners>& triangles = sides.triangles();
  // Tells whether a triangle disagrees with the first of its component; -1 if it is not seen yet.
  std::vector<signed char> kind(triangles.size(), -1);
  std::vector<std::uint32_t> component;
  for (std::size_t first = 0; first < triangles.size(); ++first) {
    if (kind[first] >= 0)
      continue;
    bool is_orientable = true;
    double areas[2] = {0, 0}, volume = 0; // the volume if the triangles of kind 1 are turned
    kind[first] = 0;
    component.assign(1, std::uint32_t(first));
    for (std::size_t i = 0; i < component.size(); ++i) {
      const std::size_t t = component[i];
      const Vector_3d p = point_of(triangles[t][0]);
      const Vector_3d n =
          cross(minus(point_of(triangles[t][1]), p), minus(point_of(triangles[t][2]), p));
      areas[kind[t]] += std::sqrt(dot(n, n));
      volume += (kind[t] == 0 ? 1 : -1) * dot(n, p);
      for (std::size_t s = 3 * t; s < 3 * t + 3; ++s) {
        if (others[s] == Other_sides::none)
          continue;
        const std::uint32_t u = others[s] / 3;
        const bool agrees = sides.ends(s)[0] == sides.ends(others[s])[1];
        const auto expected = (signed char)(agrees ? kind[t] : 1 - kind[t]);
        if (kind[u] < 0) {
          kind[u] = expected;
          component.push_back(u);
        }
        is_orientable = is_orientable && kind[u] == expected;
      }
    }
    if (!is_orientable) {
      ++not_orientable;
      continue;
    }
    const bool are_equal = std::abs(areas[0] - areas[1]) <= 1e-9 * areas[0];
    const int to_turn = (are_equal ? volume > 0 : areas[0] > areas[1]) ? 1 : 0;
    if (std::any_of(component.begin(), component.end(), [&](auto t) { return kind[t] == 1; }))
      for (const std::uint32_t t : component)
        if (kind[t] == to_turn)
          sides.turn(t);
  }
  return not_orientable;
}

struct Open_edge
{
  std::size_t ends[2]; // in the direction in which triangles pass it more often
  std::size_t times;   // the excess over the other direction
};

inline std::vector<Open_edge> open_edges(const Sides& sides)
{
  std::vector<Open_edge> open;
  sides.for_each_edge([&](std::size_t low, std::size_t high, const auto& of_edge) {
    int sum = 0;
    for (const std::uint32_t s : of_edge)
      sum += sides.ends(s)[0] == low ? 1 : -1;
    if (sum != 0)
      open.push_back({{sum > 0 ? low : high, sum > 0 ? high : low}, std::size_t(std::abs(sum))});
  });
  return open;
}

// Returns for each edge the first one of the connected set of edges to which it belongs.
inline std::vector<std::size_t> first_connected_ones(const std::vector<Open_edge>& edges)
{
  std::vector<std::array<std::size_t, 2>> at; // a vertex, and an edge there
  for (std::size_t k = 0; k < edges.size(); ++k)
    for (const std::size_t v : edges[k].ends)
      at.push_back({v, k});
  std::sort(at.begin(), at.end());
  Disjoint_sets<std::size_t> joined(edges.size());
  for (std::size_t i = 1; i < at.size(); ++i)
    if (at[i][0] == at[i - 1][0])
      joined.unite(at[i][1], at[i - 1][1]);
  std::vector<std::size_t> first_of(edges.size(), edges.size()), firsts;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    std::size_t& first = first_of[joined.root(k)];
    first = (std::min)(first, k);
    firsts.push_back(first);
  }
  return firsts;
}

// Returns the triangles that would close open edges, and their area for each connected set, at the
// place of its first edge.
// The coordinates point_of(v) must be safe from overflow.
template <class PointOf>
std::pair<std::vector<Triangle_3d>, std::vector<double>>
closing_triangles(const std::vector<Open_edge>& edges, const PointOf& point_of)
{
  const std::vector<std::size_t> sets = first_connected_ones(edges);
  std::vector<Vector_3d> middles(edges.size(), Vector_3d{0, 0, 0});
  std::vector<double> ends(edges.size(), 0);
  for (std::size_t k = 0; k < edges.size(); ++k)
    for (const std::size_t v : edges[k].ends) {
      const Vector_3d p = point_of(v);
      for (std::size_t j = 0; j < 3; ++j)
        middles[sets[k]][j] += p[j];
      ++ends[sets[k]];
    }
  std::vector<Triangle_3d> triangles;
  std::vector<double> areas(edges.size(), 0);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    Vector_3d middle = middles[sets[k]];
    for (double& x : middle)
      x /= ends[sets[k]];
    triangles.insert(triangles.end(), edges[k].times,
                     {point_of(edges[k].ends[0]), point_of(edges[k].ends[1]), middle});
    const Vector_3d n = area_vector(triangles.back());
    areas[sets[k]] += double(edges[k].times) * std::sqrt(dot(n, n));
  }
  return {std::move(triangles), std::move(areas)};
}

inline std::string percent(double share)
{
  return std::to_string(std::lround(100 * share)) + " %";
}

// Judges the winding numbers, weighted by volumes.
class Judge_inside
{
  double m_sure = 0, m_doubtful = 0, m_inside = 0, m_cut_off_inside = 0, m_cut_off_outside = 0;

public:
  void add(double number, double volume, double cut_off, Inside_3& inside)
  {
    const double size = std::abs(number);
    const bool is_doubtful = std::abs(size - std::round(size)) > 0.1;
    inside.number_of_doubtful += std::size_t(is_doubtful);
    inside.number_of_multiple += std::size_t(size > 1.5);
    if (is_doubtful)
      m_doubtful += volume;
    else if (size > 0.5)
      m_sure += volume;
    if (size >= 0.5)
      m_inside += volume;
    (size >= 0.5 ? m_cut_off_inside : m_cut_off_outside) += cut_off;
  }

  // Throws Surface_input_error if there is no inside.
  void finish(double share_of_largest, Inside_3& inside) const
  {
    if (m_inside == 0 && inside.share_of_openings == 0)
      throw Surface_input_error(
          std::string("the surface has no inside: no tetrahedron is inside; ") +
          (m_cut_off_outside > 0
               ? "faces are not facets of the triangulation, but cross tetrahedra; remedy: "
                 "refine the surface first"
               : "there are no faces with an area, or each is given twice, once turned "
                 "round; remedy: give each face once"));
    inside.doubtful_volume = m_inside > 0 ? m_doubtful / m_inside : 0;
    const double cut_off = m_cut_off_inside + m_cut_off_outside;
    inside.crossed_volume = cut_off > 0 ? cut_off / (m_inside + m_cut_off_outside) : 0;
    if (!has_inside(inside.share_of_openings, share_of_largest))
      throw Surface_input_error("the surface has no inside: by its winding numbers too much is in "
                                "doubt, and its openings have " +
                                percent(inside.share_of_openings) + " of its area, the largest " +
                                percent(share_of_largest) +
                                "; remedy: close them, and leave out walls inside the solid");
  }

private:
  // Returns whether the surface bounds a solid. It does if more volume is surely inside than in
  // doubt, however wide the openings are. If one opening lies in a plane, like the open deck of a
  // ship's hull, the numbers exceed 1/2 up to there, but much may be in doubt: then it is enough
  // that no more is in doubt than inside, the openings are not so wide that the surface is rather a
  // dish, and the others are small, unlike the two ends of a tube.
  bool has_inside(double share_of_openings, double share_of_largest) const
  {
    constexpr double widest = 0.3;
    return m_inside > 0 && (m_sure > m_doubtful || (share_of_openings <= widest &&
                                                    share_of_largest >= 0.9 * share_of_openings &&
                                                    m_doubtful <= m_inside));
  }
};

// Refers to the tetrahedra vertices_of(c) of a triangulation, in the frame of a field.
template <class VerticesOf, class NeighborsOf>
struct Tetrahedra
{
  const std::vector<Vector_3d>& points;
  std::size_t number;
  const VerticesOf& vertices_of;
  const NeighborsOf& neighbors_of;

  std::array<Vector_3d, 4> operator()(std::size_t c) const
  {
    const auto v = vertices_of(c);
    const auto at = [&](std::size_t k) { return points[std::size_t(v[k])]; };
    return {at(0), at(1), at(2), at(3)};
  }
  Vector_3d center(std::size_t c) const
  {
    const std::array<Vector_3d, 4> p = (*this)(c);
    Vector_3d x;
    for (std::size_t j = 0; j < 3; ++j)
      x[j] = (p[0][j] + p[1][j] + p[2][j] + p[3][j]) / 4;
    return x;
  }
};

// Finds the numbers of all tetrahedra, in an order in which successive ones are near each other.
template <class Cells>
void find_numbers(const Winding_tree& tree, const Cells& cells, double* numbers,
                  const Executor& executor)
{
  constexpr std::size_t most = Winding_tree::most;
  std::vector<double> centers;
  centers.reserve(3 * cells.number);
  for (std::size_t c = 0; c < cells.number; ++c) {
    const Vector_3d x = cells.center(c);
    centers.insert(centers.end(), x.begin(), x.end());
  }
  const Point_array queries(centers.data(), cells.number);
  std::vector<std::size_t> order(cells.number);
  std::iota(order.begin(), order.end(), std::size_t(0));
  Sort_by_halves()(queries, order.data(), order.data() + order.size(), executor);
  const std::size_t groups = (order.size() + most - 1) / most;
  for_each_block(executor, groups, number_of_blocks(executor, groups, 64),
                 [&](std::size_t begin, std::size_t end, std::size_t) {
                   Steps step(executor);
                   Vector_3d q[most];
                   double found[most];
                   for (std::size_t k = most * begin; k < (std::min)(most * end, order.size());
                        k += most, step(64 * most)) {
                     const std::size_t n = (std::min)(most, order.size() - k);
                     for (std::size_t i = 0; i < n; ++i)
                       q[i] = vector_of(queries[order[k + i]]);
                     tree(q, n, found);
                     for (std::size_t i = 0; i < n; ++i)
                       numbers[order[k + i]] = found[i];
                   }
                 });
}

// Does the same by regions: the number of the surface minus the number of the triangles that close
// it is an integer.
template <class Cells, class Ask>
void find_numbers_by_regions(const Cells& cells, Regions<Cells>& regions,
                             const std::vector<Triangle_3d>& closing, const Ask& ask,
                             double* numbers, const Executor& executor)
{
  constexpr double unseen = 0.002; // a negligible part of a number that is compared with 1/2
  const Winding_tree closing_tree(std::vector<Triangle_3d>(closing), unseen);
  const auto of_closing = [&](std::size_t c) {
    return closing.empty() ? 0 : closing_tree(cells.center(c));
  };
  const std::vector<std::int32_t> whole =
      regions.numbers(closing, [&](std::size_t c) { return ask(c) - of_closing(c); });
  for_each_cell(cells.number, executor,
                [&](std::size_t c) { numbers[c] = whole[c] + of_closing(c); });
}

// Returns for each tetrahedron a bound on the share of it that is not on the side of its centre of all
// triangles that pass through it: the way from the centre to any other place crosses one of them.
template <class Cells>
std::vector<double> shares_cut_off(const Cells& cells,
                                   const std::vector<Cutting_triangle>& triangles,
                                   const Executor& executor)
{
  std::vector<double> shares(cells.number, 0);
  if (triangles.empty())
    return shares;
  const Box_tree tree{std::vector<Cutting_triangle>(triangles)};
  for_each_cell(cells.number, executor, [&](std::size_t c) {
    const std::array<Vector_3d, 4> p = cells(c);
    Box_3d box;
    for (const Vector_3d& corner : p)
      box.add(corner);
    tree.visit(box, [&](const Cutting_triangle& t) {
      if (shares[c] < 1 && passes_inside(t, p, box))
        shares[c] = (std::min)(1., shares[c] + share_beyond(t, p));
    });
  });
  return shares;
}

// Holds the triangles of faces on n points by their vertices, without those with a vertex twice.
struct Triangles_of_faces
{
  std::vector<Corners> triangles;
  std::vector<std::uint32_t> faces; // the face of each triangle

  template <class FaceRange, class VertexOf>
  Triangles_of_faces(const FaceRange& of_faces, std::size_t n, const VertexOf& vertex_of)
  {
    const auto at = [&](std::size_t i) { return std::uint32_t(vertex_of(i)); };
    for_each_triangle(of_faces, n, [&](std::size_t i, std::size_t j, std::size_t k, std::size_t f) {
      const Corners t = {at(i), at(j), at(k)};
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
        return;
      triangles.push_back(t);
      faces.push_back(std::uint32_t(f));
    });
  }

  // Reverses the triangles that are turned in `sides`; returns the number of their faces.
  std::size_t turn(const Sides& sides)
  {
    std::size_t number = 0, last = std::size_t(-1);
    for (std::size_t t = 0; t < triangles.size(); ++t)
      if (sides.is_turned(t)) {
        std::swap(triangles[t][1], triangles[t][2]);
        number += std::size_t(faces[t] != last);
        last = faces[t];
      }
    return number;
  }
};

// Makes the triangles agree, and returns the edges where they are still open.
template <class PointOf>
std::vector<Open_edge> orient(Triangles_of_faces& surface, std::size_t n, const PointOf& point_of,
                              Inside_3& inside)
{
  Sides sides(surface.triangles, n);
  if (const std::size_t number = turn_alike(sides, point_of); number > 0)
    throw Surface_input_error(
        "the surface has no inside: it is not orientable, as a Möbius strip or Klein's bottle is "
        "not; remedy: cut it open, or leave out the faces of such parts, of which there are " +
        std::to_string(number));
  std::vector<Open_edge> open = open_edges(sides);
  inside.number_of_turned = surface.turn(sides);
  return open;
}

// Throws if there are too many tetrahedra (m) or points (n) to find an inside.
inline void check_sizes(std::size_t m, std::size_t n)
{
  if (m >= std::size_t(1) << 30 || n >= std::size_t(1) << 31)
    throw std::length_error("an inside is found of fewer than 2^30 tetrahedra and 2^31 points");
}

// Finds the neighbours of tetrahedra on n points, from their corners; -1 stands for none.
template <class Index>
std::vector<std::array<Index, 4>> neighbors_of_corners(const Corners_view<Index>& tetrahedra,
                                                       std::size_t n, const Executor& executor)
{
  check_sizes(tetrahedra.number, n);
  std::vector<std::array<Index, 4>> neighbors(tetrahedra.number, {-1, -1, -1, -1});
  match_facets<4>(
      tetrahedra, n,
      [&](std::size_t c, std::size_t k, std::size_t d) { neighbors[c][k] = Index(d); }, executor);
  return neighbors;
}

// Returns the area of triangles.
inline double area_of(const std::vector<Corners>& triangles, const std::vector<Vector_3d>& points)
{
  double area = 0;
  for (const Corners& t : triangles) {
    const Vector_3d n = area_vector({points[t[0]], points[t[1]], points[t[2]]});
    area += std::sqrt(dot(n, n));
  }
  return area;
}

// Judges the numbers of all tetrahedra, given the area of the triangles and of each opening.
template <class Cells>
void judge_inside(const Cells& cells, const std::vector<Cutting_triangle>& no_facets, double area,
                  const std::vector<double>& openings, Inside_3& inside, const Executor& executor)
{
  double share_of_largest = 0;
  for (const double a : openings) {
    const double share = area > 0 ? a / area : a;
    inside.share_of_openings += share;
    share_of_largest = (std::max)(share_of_largest, share);
  }
  for (const Cutting_triangle& t : no_facets)
    inside.missing_area += std::abs(t.number) * std::sqrt(dot(t.normal, t.normal)) / 2 / area;
  const std::vector<double> shares = shares_cut_off(cells, no_facets, executor);
  Judge_inside judge;
  Steps step(executor);
  for (std::size_t c = 0; c < cells.number; ++c, step()) {
    const std::array<Vector_3d, 4> p = cells(c);
    const double volume =
        std::abs(dot(minus(p[1], p[0]), cross(minus(p[2], p[0]), minus(p[3], p[0]))));
    judge.add(inside.winding_numbers[c], volume, shares[c] * volume, inside);
  }
  judge.finish(share_of_largest, inside);
}

// Tells what may be wrong with an inside, and the remedies; returns no text if little may be wrong.
inline std::string warning_of(const Inside_3& inside)
{
  constexpr double much_doubtful = 0.05, much_crossed = 0.1;
  std::string text;
  if (inside.doubtful_volume > much_doubtful)
    text =
        percent(inside.doubtful_volume) +
        " of the volume inside is in doubt, near openings; remedy: close these, for instance with "
        "MeshLab or CGAL's triangulate_hole()";
  if (inside.crossed_volume > much_crossed)
    text +=
        (text.empty() ? "" : "; ") + percent(inside.crossed_volume) +
        " of the volume may be wrong, in tetrahedra that cross the surface: faces with " +
        percent(inside.missing_area) +
        " of its area are no facets of the triangulation; remedy: refine the surface first, for "
        "instance with MeshLab, Gmsh or CGAL's isotropic_remeshing()";
  return text;
}

// Finds the inside for m tetrahedra vertices_of(c), across whose facets lie the tetrahedra
// neighbors_of(c), or numbers out of range where there are none, and for faces whose point i is
// vertex vertex_of(i).
template <class FaceRange, class VerticesOf, class NeighborsOf, class VertexOf>
Inside_3 find_inside(const Point_array& points, const FaceRange& faces, std::size_t m,
                     const VerticesOf& vertices_of, const NeighborsOf& neighbors_of,
                     const VertexOf& vertex_of, const Executor& executor)
{
  check_sizes(m, points.size());
  Triangles_of_faces surface(faces, points.size(), vertex_of);
  const Unit_frame frame = frame_of(faces, points);
  std::vector<Vector_3d> in_frame;
  in_frame.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    in_frame.push_back(frame(vector_of(points[i])));
  const Tetrahedra<VerticesOf, NeighborsOf> cells = {in_frame, m, vertices_of, neighbors_of};
  Inside_3 inside;
  executor.interruption_point();
  const auto point_of = [&](std::size_t v) { return in_frame[v]; };
  const auto [closing, areas] =
      closing_triangles(orient(surface, points.size(), point_of, inside), point_of);
  const auto tree_of_all = [&] {
    std::vector<Triangle_3d> triangles;
    for (const Corners& t : surface.triangles)
      triangles.push_back({in_frame[t[0]], in_frame[t[1]], in_frame[t[2]]});
    return Winding_tree(std::move(triangles));
  };
  inside.winding_numbers.resize(m);
  Regions<Tetrahedra<VerticesOf, NeighborsOf>> regions(cells, surface.triangles, executor);
  if (closing.size() <= surface.triangles.size() / 8) {
    std::optional<Winding_tree> tree; // rarely needed
    const auto ask = [&](std::size_t c) {
      if (!tree)
        tree = tree_of_all();
      return (*tree)(cells.center(c));
    };
    find_numbers_by_regions(cells, regions, closing, ask, inside.winding_numbers.data(), executor);
  } else {
    find_numbers(tree_of_all(), cells, inside.winding_numbers.data(), executor);
  }
  judge_inside(cells, regions.no_facets(), area_of(surface.triangles, in_frame), areas, inside,
               executor);
  return inside;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_FIND_INSIDE_H
