// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_STARTING_CELLS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_STARTING_CELLS_H

// Choi 2002, Fig. 1, line 2b: where the walk to a point starts. The order names a point for it, which
// is near; or it is the point inserted before.

#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/shared_words.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Each of many threads has a copy, and follows the points that it inserted itself.
template <class Id>
class Starting_cells
{
public:
  // `places`: as Order_view::starting_places. vertex_of: by place, 0 if there is none yet. Keeps
  // references to all. `vertex` is any that is there.
  Starting_cells(const Compact_complex<Id>& complex, const std::vector<Id>& vertex_of,
                 const std::size_t* places, Id vertex)
    : m_complex(complex)
    , m_vertex_of(vertex_of)
    , m_places(places)
    , m_previous(vertex)
  {
  }

  // A cell of the vertex of the point that the order names for that at place i.
  Id start(std::size_t i) const
  {
    if (i == 0 || m_places == nullptr)
      return cell(m_previous);
    std::size_t place = m_places[i];
    Id v = load_relaxed(m_vertex_of[place]);
    while (v == 0 && place != 0) // left out; or, with many threads, not inserted yet
      v = load_relaxed(m_vertex_of[place = m_places[place]]);
    return cell(v == 0 ? m_previous : v);
  }

  void after_update(std::size_t /* i */, Id v) { m_previous = v; }

private:
  Id cell(Id v) const { return load_relaxed(m_complex.vertex(v).cell); }

  const Compact_complex<Id>& m_complex;
  const std::vector<Id>& m_vertex_of;
  const std::size_t* const m_places;
  Id m_previous;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_STARTING_CELLS_H
