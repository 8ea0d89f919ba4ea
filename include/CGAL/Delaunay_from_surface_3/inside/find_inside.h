// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_FIND_INSIDE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_FIND_INSIDE_H

// The winding numbers of tetrahedra, and whether they make an inside.

#include <CGAL/Delaunay_from_surface_3/Inside_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/arrays/match_facets.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Sort_by_halves.h>
#include <CGAL/Delaunay_from_surface_3/inside/Multipole.h>
#include <CGAL/Delaunay_from_surface_3/inside/Regions.h>
#include <CGAL/Delaunay_from_surface_3/inside/Triangle_table.h>
#include <CGAL/Delaunay_from_surface_3/inside/Unit_frame.h>
#include <CGAL/Delaunay_from_surface_3/inside/Winding_field.h>
#include <CGAL/Delaunay_from_surface_3/inside/Winding_tree.h>
#include <CGAL/Delaunay_from_surface_3/inside/openings.h>
#include <CGAL/Delaunay_from_surface_3/inside/solid_angle.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/blocks.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
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

// What the numbers say, weighted by volumes.
class Judge_inside
{
  double m_sure = 0, m_doubtful = 0, m_inside = 0;

public:
  void add(double number, double volume, Inside_3& inside)
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
  }

  double doubtful_volume() const { return m_inside > 0 ? m_doubtful / m_inside : 0; }

  // Where more is in doubt than surely inside, and the openings are wide, the surface is no border
  // of a solid. Where an opening lies in a plane, as that of a hull without a deck, the numbers are
  // more than 1/2 up to there, however wide it is: then it is enough if not more is in doubt than
  // inside, and the other openings are small; those of a tube are not.
  bool has_inside(double share_of_openings, double share_of_largest) const
  {
    constexpr double widest = 0.3;
    return m_inside > 0 && (m_sure > m_doubtful || (share_of_openings <= widest &&
                                                    share_of_largest >= 0.9 * share_of_openings &&
                                                    m_doubtful <= m_inside));
  }
};

// The tetrahedra vertices_of(c) of a triangulation, in the frame of a field.
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

// Those of all tetrahedra, in an order in which successive ones are near each other.
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
                   Vector_3d q[most];
                   double found[most];
                   for (std::size_t k = most * begin; k < (std::min)(most * end, order.size());
                        k += most) {
                     const std::size_t n = (std::min)(most, order.size() - k);
                     for (std::size_t i = 0; i < n; ++i)
                       q[i] = vector_of(queries[order[k + i]]);
                     tree(q, n, found);
                     for (std::size_t i = 0; i < n; ++i)
                       numbers[order[k + i]] = found[i];
                   }
                 });
}

// The same by regions: the number of the surface less that of the triangles that close it is a whole one.
template <class Cells, class Ask>
void find_numbers_by_regions(const Cells& cells, const std::vector<Corners>& triangles,
                             const std::vector<Triangle_3d>& closing, const Ask& ask,
                             double* numbers, const Executor& executor)
{
  constexpr double unseen = 0.002; // of a number that is compared with one half
  const Winding_tree closing_tree(std::vector<Triangle_3d>(closing), unseen);
  const auto of_closing = [&](std::size_t c) {
    return closing.empty() ? 0 : closing_tree(cells.center(c));
  };
  const std::vector<std::int32_t> whole =
      Regions<Cells>(cells, triangles, closing, executor).numbers([&](std::size_t c) {
        return ask(c) - of_closing(c);
      });
  for_each_block(executor, cells.number, number_of_blocks(executor, cells.number, 1024),
                 [&](std::size_t first, std::size_t last, std::size_t) {
                   for (std::size_t c = first; c < last; ++c)
                     numbers[c] = whole[c] + of_closing(c);
                 });
}

// The triangles of faces on n points by their vertices; not those with a vertex twice.
template <class FaceRange, class VertexOf>
std::vector<Corners> corners_of(const FaceRange& faces, std::size_t n, const VertexOf& vertex_of)
{
  std::vector<Corners> triangles;
  const auto at = [&](std::size_t i) { return std::uint32_t(vertex_of(i)); };
  for_each_triangle(faces, n, [&](std::size_t i, std::size_t j, std::size_t k) {
    const Corners t = {at(i), at(j), at(k)};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
      triangles.push_back(t);
  });
  return triangles;
}

// An inside is found of m tetrahedra on n points.
inline void check_sizes(std::size_t m, std::size_t n)
{
  if (m >= std::size_t(1) << 30 || n >= std::size_t(1) << 31)
    throw std::length_error("an inside is found of fewer than 2^30 tetrahedra and 2^31 points");
}

// Those of tetrahedra on n points whose neighbours are not known; -1 where there is none.
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

// Of m tetrahedra vertices_of(c), opposite to which lie the tetrahedra neighbors_of(c), or other
// numbers where there are none, and faces whose points have the vertices vertex_of(i).
template <class FaceRange, class VerticesOf, class NeighborsOf, class VertexOf>
Inside_3 find_inside(const Point_array& points, const FaceRange& faces, std::size_t m,
                     const VerticesOf& vertices_of, const NeighborsOf& neighbors_of,
                     const VertexOf& vertex_of, const Executor& executor)
{
  check_sizes(m, points.size());
  const std::vector<Corners> triangles = corners_of(faces, points.size(), vertex_of);
  const Unit_frame frame(points);
  std::vector<Vector_3d> in_frame;
  in_frame.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    in_frame.push_back(frame(vector_of(points[i])));
  const Tetrahedra<VerticesOf, NeighborsOf> cells = {in_frame, m, vertices_of, neighbors_of};
  const auto [closing, areas] = closing_triangles(open_edges(faces, points.size(), vertex_of),
                                                  [&](std::size_t v) { return in_frame[v]; });
  Inside_3 inside;
  inside.winding_numbers.resize(m);
  const auto tree_of_all = [&] { return Winding_tree(triangles_in(frame, faces, points)); };
  if (closing.size() <= triangles.size() / 8) {
    std::optional<Winding_tree> tree; // rarely needed
    const auto ask = [&](std::size_t c) {
      if (!tree)
        tree = tree_of_all();
      return (*tree)(cells.center(c));
    };
    find_numbers_by_regions(cells, triangles, closing, ask, inside.winding_numbers.data(),
                            executor);
  } else {
    find_numbers(tree_of_all(), cells, inside.winding_numbers.data(), executor);
  }

  double area = 0, share_of_largest = 0;
  for (const Corners& t : triangles) {
    const Vector_3d n = area_vector({in_frame[t[0]], in_frame[t[1]], in_frame[t[2]]});
    area += std::sqrt(dot(n, n));
  }
  for (const double a : areas) {
    const double share = area > 0 ? a / area : a;
    inside.share_of_openings += share;
    share_of_largest = (std::max)(share_of_largest, share);
  }
  Judge_inside judge;
  for (std::size_t c = 0; c < m; ++c) {
    const std::array<Vector_3d, 4> p = cells(c);
    const double volume = dot(minus(p[1], p[0]), cross(minus(p[2], p[0]), minus(p[3], p[0])));
    judge.add(inside.winding_numbers[c], std::abs(volume), inside);
  }
  inside.doubtful_volume = judge.doubtful_volume();
  if (!judge.has_inside(inside.share_of_openings, share_of_largest))
    throw Surface_input_error(
        "the surface has no inside: by its winding numbers too much is in doubt, and its openings "
        "have " +
        std::to_string(std::lround(100 * inside.share_of_openings)) +
        " % of its area, the largest " + std::to_string(std::lround(100 * share_of_largest)) +
        " %");
  return inside;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_FIND_INSIDE_H
