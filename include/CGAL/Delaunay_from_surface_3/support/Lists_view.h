// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_LISTS_VIEW_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_LISTS_VIEW_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/inlining.h>

#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE {

// Lists of numbers, one after the other, owned elsewhere: that of i is items[first[i]], …,
// items[first[i+1] - 1].
template <class Index>
struct Lists_view
{
  const Index* first;
  const Index* items;
  std::size_t number_of_lists, number_of_items;

  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE std::size_t size() const { return number_of_lists; }
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE const Index* begin(std::size_t i) const
  {
    return items + first[i];
  }
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE const Index* end(std::size_t i) const
  {
    return items + first[i + 1];
  }
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_LISTS_VIEW_H
