// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PLAIN_INSERTION_TRAITS_3_H
#define CGAL_PLAIN_INSERTION_TRAITS_3_H

#include <CGAL/Delaunay_from_surface_3/paper/Planned_hints_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/surface/No_subgraph.h>
#include <CGAL/Surface_insertion_policies_3.h>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Traits

is the control: exactly the insertions of `Delaunay_triangulation_3::insert(first, last)`, in the
same order and from the same starting cells. The surface is not used. With `Fast_location` this
holds for the lowest level. With `Parallel_tag` that function inserts with many threads, this class
with one.

<b>Complexity</b>: expected \f$O(n \log n)\f$ for the order of n points, plus the insertions.

\cgalModels{SurfaceInsertionTraits_3}
*/
struct Plain_insertion_traits_3
  : Surface_insertion_policies_3<Delaunay_from_surface_3::No_subgraph,
                                 Delaunay_from_surface_3::Spatial_sort_order,
                                 Delaunay_from_surface_3::Previous_hint_3>
{
  /// `false`: CGAL inserts.
  static constexpr bool through_core = false;
};

} // namespace CGAL

#endif // CGAL_PLAIN_INSERTION_TRAITS_3_H
