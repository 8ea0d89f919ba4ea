// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_ADJACENT_VERTICES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_ADJACENT_VERTICES_H

// Which vertices are joined by an edge.

#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/blocks.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Lists: that of v is items[first[v]], …, items[first[v+1] - 1], ascending.
template <class Index>
struct Adjacent_vertices
{
  std::vector<std::int64_t> first;
  std::vector<Index> items;
};

// Of n vertices and `number` simplices with corners vertex_of(c, k), k < corners. Linear, but for
// sorting the lists.
template <class Index, class VertexOf>
Adjacent_vertices<Index> adjacent_vertices(std::size_t number, std::size_t corners, std::size_t n,
                                           const VertexOf& vertex_of, const Executor& executor)
{
  const Lists<std::uint32_t> simplices = in_lists<std::uint32_t>(
      n,
      Listed_items(
          corners * number,
          [&](std::size_t i) { return std::size_t(vertex_of(i / corners, i % corners)); },
          [=](std::size_t i) { return std::uint32_t(i / corners); }),
      executor);
  const std::size_t blocks = number_of_blocks(executor, n, 4096);
  std::vector<std::vector<Index>> items(blocks);
  Adjacent_vertices<Index> adjacent;
  adjacent.first.assign(n + 1, 0);
  for_each_block(executor, n, blocks, [&](std::size_t first, std::size_t last, std::size_t b) {
    std::vector<Index> met_by(n, Index(-1));
    Steps step(executor);
    for (std::size_t v = first; v < last; ++v) {
      const std::size_t begin = items[b].size();
      met_by[v] = Index(v);
      step(corners * std::size_t(simplices.end(v) - simplices.begin(v)));
      for (const std::uint32_t* c = simplices.begin(v); c != simplices.end(v); ++c)
        for (std::size_t k = 0; k < corners; ++k) {
          const Index w = vertex_of(*c, k);
          if (met_by[std::size_t(w)] != Index(v)) {
            met_by[std::size_t(w)] = Index(v);
            items[b].push_back(w);
          }
        }
      std::sort(items[b].begin() + std::ptrdiff_t(begin), items[b].end());
      adjacent.first[v + 1] = std::int64_t(items[b].size() - begin);
    }
  });
  for (std::size_t v = 0; v < n; ++v)
    adjacent.first[v + 1] += adjacent.first[v];
  executor.interruption_point();
  adjacent.items.reserve(std::size_t(adjacent.first[n]));
  for (const std::vector<Index>& part : items)
    adjacent.items.insert(adjacent.items.end(), part.begin(), part.end());
  return adjacent;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_ADJACENT_VERTICES_H
