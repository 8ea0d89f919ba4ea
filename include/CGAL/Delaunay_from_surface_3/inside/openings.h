// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_OPENINGS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_OPENINGS_H

// Where oriented faces are not closed: edges that they pass more often in one direction than in the
// other. The winding number jumps nowhere else but at faces, and it is a whole number if there is
// no such edge. How large the openings are is estimated: each connected set of these edges is
// joined with its middle by triangles, which would close it. Linear, but for what is open.

#include <CGAL/Delaunay_from_surface_3/inside/Multipole.h>
#include <CGAL/Delaunay_from_surface_3/inside/solid_angle.h>
#include <CGAL/Delaunay_from_surface_3/support/Disjoint_sets.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

struct Open_edge
{
  std::size_t ends[2]; // in the direction in which they pass it more often
  std::size_t times;   // how much more often
};

// Of n points, of which those are one that have the same vertex_of(i).
template <class FaceRange, class VertexOf>
std::vector<Open_edge> open_edges(const FaceRange& faces, std::size_t n, const VertexOf& vertex_of)
{
  std::vector<std::uint32_t> lower, upper; // of each side; an upper end twice, and its direction
  for (const auto& face : faces) {
    std::size_t first = 0, last = 0;
    bool has_begun = false;
    const auto add_side = [&](std::size_t a, std::size_t b) {
      if (a != b) {
        lower.push_back(std::uint32_t((std::min)(a, b)));
        upper.push_back(std::uint32_t(2 * (std::max)(a, b) + (a < b)));
      }
    };
    for (const auto& index : face) {
      const auto v = std::size_t(vertex_of(std::size_t(index)));
      if (has_begun)
        add_side(last, v);
      else
        first = v;
      last = v;
      has_begun = true;
    }
    if (has_begun)
      add_side(last, first);
  }
  Lists<std::uint32_t> lists = in_lists<std::uint32_t>(
      n, Listed_items(
             lower.size(), [&](std::size_t k) { return std::size_t(lower[k]); },
             [&](std::size_t k) { return upper[k]; }));
  std::vector<Open_edge> open;
  for (std::size_t a = 0; a < n; ++a) {
    std::uint32_t* const end = lists.items.data() + lists.first[a + 1];
    std::uint32_t* side = lists.items.data() + lists.first[a];
    std::sort(side, end);
    while (side != end) {
      const std::uint32_t b = *side / 2;
      int sum = 0;
      for (; side != end && *side / 2 == b; ++side)
        sum += *side % 2 == 0 ? -1 : 1;
      if (sum != 0)
        open.push_back({{sum > 0 ? a : b, sum > 0 ? b : a}, std::size_t(std::abs(sum))});
    }
  }
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

// The triangles that would close them; point_of(v) are coordinates that need no care.
template <class PointOf>
std::vector<Triangle_3d> closing_triangles(const std::vector<Open_edge>& edges,
                                           const PointOf& point_of)
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
  for (std::size_t k = 0; k < edges.size(); ++k) {
    Vector_3d middle = middles[sets[k]];
    for (double& x : middle)
      x /= ends[sets[k]];
    triangles.insert(triangles.end(), edges[k].times,
                     {point_of(edges[k].ends[0]), point_of(edges[k].ends[1]), middle});
  }
  return triangles;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_OPENINGS_H
