// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_OPENINGS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_OPENINGS_H

// The orientation of triangles, and where they are not closed.
//
// turn_alike() turns triangles of a surface whose parts were put together carelessly, so that
// neighbours agree.
//
// open_edges() finds the edges that triangles pass more often in one direction than in the other. The
// winding number jumps nowhere else but at triangles, and it is a whole number if there is no such
// edge. How large the openings are is estimated: each connected set of these edges is joined with its
// middle by triangles, which would close it. Linear, but for what is open.

#include <CGAL/Delaunay_from_surface_3/inside/Multipole.h>
#include <CGAL/Delaunay_from_surface_3/inside/Triangle_table.h>
#include <CGAL/Delaunay_from_surface_3/inside/solid_angle.h>
#include <CGAL/Delaunay_from_surface_3/support/Disjoint_sets.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The sides of triangles, those of an edge together. Side 3 t + k of triangle t leads from its
// corner k to the next one, or back if the triangle has been turned.
class Sides
{
public:
  // Of triangles on n vertices, none of which has one twice. Keeps a reference to them.
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
  void turn(std::size_t t) { m_is_turned[t] = 1 - m_is_turned[t]; }

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
    std::vector<std::pair<std::size_t, std::uint32_t>> others; // at a vertex: other end, and side
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

// For each side the other one of its edge; `none` if there is none, or more than one.
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

  // Whether all edges of two triangles are passed once in each direction.
  bool do_agree() const { return m_do_agree; }

private:
  std::vector<std::uint32_t> m_others;
  bool m_do_agree = true;
};

// Turns triangles so that those agree that are joined by edges with two triangles: in a component that
// is not coherent, those that disagree with most of its area. Where both sides have the same area, as
// halves of a sphere, those are turned by which it has a positive volume. A component that is coherent
// stays: if it looks inwards, it is the wall of a cavity. So does what is not orientable; returns how many
// components are not. point_of(v) are coordinates that need no care. Linear.
template <class PointOf>
std::size_t turn_alike(Sides& sides, const PointOf& point_of)
{
  std::size_t not_orientable = 0;
  const Other_sides others(sides);
  if (others.do_agree())
    return not_orientable;
  const std::vector<Corners>& triangles = sides.triangles();
  // Whether each disagrees with the first of its component; -1 if it has not been seen yet.
  std::vector<signed char> kind(triangles.size(), -1);
  std::vector<std::uint32_t> component;
  for (std::size_t first = 0; first < triangles.size(); ++first) {
    if (kind[first] >= 0)
      continue;
    bool is_orientable = true;
    double areas[2] = {0, 0}, volume = 0; // volume: if those of kind 1 are turned
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
  std::size_t ends[2]; // in the direction in which they pass it more often
  std::size_t times;   // how much more often
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

// Numbers the connected sets of the edges: that of each edge, and how many there are.
inline std::pair<std::vector<std::size_t>, std::size_t>
connected_sets(const std::vector<Open_edge>& edges)
{
  std::vector<std::size_t> vertices;
  for (const Open_edge& e : edges)
    vertices.insert(vertices.end(), e.ends, e.ends + 2);
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const auto place = [&](std::size_t v) {
    return std::size_t(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin());
  };
  Disjoint_sets<std::size_t> joined(vertices.size());
  for (const Open_edge& e : edges)
    joined.unite(place(e.ends[0]), place(e.ends[1]));
  std::vector<std::size_t> number(vertices.size(), vertices.size()), sets;
  std::size_t count = 0;
  for (const Open_edge& e : edges) {
    std::size_t& n = number[joined.root(place(e.ends[0]))];
    if (n == vertices.size())
      n = count++;
    sets.push_back(n);
  }
  return {std::move(sets), count};
}

// The triangles that would close them, and the area of those of each connected set; point_of(v) are
// coordinates that need no care.
template <class PointOf>
std::pair<std::vector<Triangle_3d>, std::vector<double>>
closing_triangles(const std::vector<Open_edge>& edges, const PointOf& point_of)
{
  const auto [sets, number] = connected_sets(edges);
  std::vector<Vector_3d> middles(number, Vector_3d{0, 0, 0});
  std::vector<double> ends(number, 0);
  for (std::size_t k = 0; k < edges.size(); ++k)
    for (const std::size_t v : edges[k].ends) {
      const Vector_3d p = point_of(v);
      for (std::size_t j = 0; j < 3; ++j)
        middles[sets[k]][j] += p[j];
      ++ends[sets[k]];
    }
  std::vector<Triangle_3d> triangles;
  std::vector<double> areas(number, 0);
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

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_OPENINGS_H
