// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_ZONE_BOUNDARY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_ZONE_BOUNDARY_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The facets of the boundary of a conflict zone, each with its two cells: finds, by the cell
// across, which survives, the cell behind, which does not.
template <class Node>
class Zone_boundary
{
public:
  void clear() { m_facets.clear(); }

  // Adds facet `index` of the cell `across`.
  void add(Node across, int index, Node behind) { m_facets.push_back({across, index, behind}); }

  // To be called when all are added. O(m log m) for m facets.
  void sort() { std::sort(m_facets.begin(), m_facets.end()); }

  // O(log m).
  Node behind(Node across, int index) const
  {
    const auto facet =
        std::lower_bound(m_facets.begin(), m_facets.end(), Facet{across, index, Node()});
    CGAL_assertion(facet != m_facets.end() && facet->across == across && facet->index == index);
    return facet->behind;
  }

private:
  struct Facet
  {
    Node across;
    int index;
    Node behind;

    bool operator<(const Facet& other) const
    {
      return std::tie(across, index) < std::tie(other.across, other.index);
    }
  };

  std::vector<Facet> m_facets;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_ZONE_BOUNDARY_H
