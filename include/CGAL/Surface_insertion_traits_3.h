// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_INSERTION_TRAITS_3_H
#define CGAL_SURFACE_INSERTION_TRAITS_3_H

#include <CGAL/Delaunay_from_surface_3/paper/Planned_hints_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/surface/No_subgraph.h>
#include <CGAL/Surface_insertion_policies_3.h>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Traits

is the default, which was the fastest in measurements. The points come in rounds of well-spaced
points, and the location of each starts at a nearby point of an earlier round. The points are
inserted into a compact triangulation, which is copied into the user's at the end. If that is not
possible, CGAL's own insertion takes over. The surface is not looked at: rounds made of its edges
(`Delaunay_from_surface_3::Surface_net_rounds`) destroy as many cells, and take as long
(`nets_200k.json`).

<b>Complexity</b>: expected \f$O(n \log n)\f$ for the order of n points, plus the insertions.

\cgalModels{SurfaceInsertionTraits_3}
*/
struct Surface_insertion_traits_3
  : Surface_insertion_policies_3<Delaunay_from_surface_3::No_subgraph,
                                 Delaunay_from_surface_3::Spaced_rounds,
                                 Delaunay_from_surface_3::Planned_hints_3>
{
};

} // namespace CGAL

#endif // CGAL_SURFACE_INSERTION_TRAITS_3_H
