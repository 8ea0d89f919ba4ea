// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_LOWER_NEIGHBORS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_LOWER_NEIGHBORS_H

// A graph as lists: each edge once, at its end with the larger number.

#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Large_page_allocator.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// An edge of a graph whose vertices are numbered: the larger number, and the smaller.
struct Numbered_edge
{
  std::uint32_t upper, lower;

  Numbered_edge(std::uint32_t s, std::uint32_t t)
    : upper((std::max)(s, t))
    , lower((std::min)(s, t))
  {
  }
};

// Edges as items: the list of the upper end gets the lower one.
class Edges_as_items
{
public:
  Edges_as_items(const Large_vector<Numbered_edge>& edges)
    : m_edges(&edges)
  {
  }

  std::size_t size() const { return m_edges->size(); }
  std::size_t list(std::size_t k) const { return (*m_edges)[k].upper; }
  std::uint32_t item(std::size_t k) const { return (*m_edges)[k].lower; }

private:
  const Large_vector<Numbered_edge>* m_edges;
};

// The neighbours of each of n vertices that have smaller numbers; of edges in blocks.
inline Lists<std::uint32_t> lower_neighbors(const std::vector<Large_vector<Numbered_edge>>& edges,
                                            std::size_t n, const Executor& executor = Alone())
{
  return in_lists<std::uint32_t>(n, std::vector<Edges_as_items>(edges.begin(), edges.end()),
                                 executor);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_LOWER_NEIGHBORS_H
