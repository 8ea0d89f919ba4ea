// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_SOUP_GRAPH_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_SOUP_GRAPH_H

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/internal/plan/Lower_neighbor_graph.h>
#include <CGAL/Delaunay_from_surface_3/internal/plan/Net_hierarchy.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

struct Soup_graph
{
  Lower_neighbor_graph graph;
  // None if all faces are triangles and no edge has more than two.
  std::optional<std::string> irregularity;
};

template <class IndexRange>
void check_face(const IndexRange& face, std::size_t f, std::size_t number_of_points)
{
  for (const auto& index : face)
    if (index < decltype(index + 0)(0) || std::size_t(index) >= number_of_points)
      throw Surface_input_error("face " + std::to_string(f) + ": the index " +
                                std::to_string(index) + " is not one of the " +
                                std::to_string(number_of_points) + " points");
}

// The sides of all faces: every edge as often as there are faces that have it. Returns how many
// faces are not triangles.
template <class Index, class FaceRange>
std::size_t read_sides(const FaceRange& faces, std::size_t number_of_points,
                       Large_vector<Numbered_edge<Index>>& sides)
{
  std::size_t f = 0, non_triangles = 0;
  for (const auto& face : faces) {
    check_face(face, f++, number_of_points);
    const auto k = std::distance(std::begin(face), std::end(face));
    non_triangles += k != 3;
    if (k == 0)
      continue;
    auto s = Index(*std::next(std::begin(face), k - 1));
    for (const auto& index : face) {
      const auto t = Index(index);
      if (s != t)
        sides.emplace_back(s, t);
      s = t;
    }
  }
  return non_triangles;
}

// Keeps one of the equal items of each list. Returns how many items were there more than twice.
template <class Index>
std::size_t keep_one_of_each(Lists<Index>& lists)
{
  const std::size_t n = lists.size();
  Large_vector<Index> place(
      n, 0); // of an item among those kept, and 1; it counts if the list is its own
  std::vector<unsigned char> times;
  std::size_t kept = 0, more_than_twice = 0, first = 0;
  for (std::size_t v = 0; v < n; ++v) {
    const std::size_t begin = kept, end = lists.first[v + 1];
    times.clear();
    for (std::size_t k = first; k < end; ++k) {
      const Index u = lists.items[k];
      if (place[u] > begin) {
        unsigned char& t = times[place[u] - 1 - begin];
        more_than_twice += t == 2;
        t += t < 3;
      } else {
        lists.items[kept] = u;
        place[u] = Index(++kept);
        times.push_back(1);
      }
    }
    first = end;
    lists.first[v + 1] = Index(kept);
  }
  lists.items.resize(kept);
  return more_than_twice;
}

// The edges of the faces as a graph on the points; without edges if there are more sides than
// numbers of 32 bits. Linear: the sides of the faces are sorted by counting.
template <class FaceRange, class Executor = Alone>
Soup_graph soup_graph(const FaceRange& faces, std::size_t number_of_points,
                      const Executor& executor = Executor())
{
  using Index = std::uint32_t;
  std::size_t number_of_sides = 0;
  for (const auto& face : faces)
    number_of_sides += std::size_t(std::distance(std::begin(face), std::end(face)));
  if ((std::max)(number_of_points, number_of_sides) >= (std::numeric_limits<Index>::max)())
    return {Lower_neighbor_graph(number_of_points), std::nullopt};

  Large_vector<Numbered_edge<Index>> sides;
  sides.reserve(number_of_sides);
  const std::size_t non_triangles = read_sides(faces, number_of_points, sides);
  Lists<Index> lists = lower_neighbors(sides, number_of_points, executor);
  const std::size_t non_manifold_edges = keep_one_of_each(lists);

  Soup_graph soup = {Lower_neighbor_graph(std::move(lists)), std::nullopt};
  if (non_triangles + non_manifold_edges > 0)
    soup.irregularity = "faces that are not triangles: " + std::to_string(non_triangles) +
                        ", edges with more than two faces: " + std::to_string(non_manifold_edges);
  return soup;
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_SOUP_GRAPH_H
