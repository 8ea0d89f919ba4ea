// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_INSERTION_TRAITS_3_H
#define CGAL_SURFACE_INSERTION_TRAITS_3_H

#include <CGAL/Delaunay_from_surface_3/paper/Planned_hints_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/Surface_net_rounds.h>
#include <CGAL/Delaunay_from_surface_3/surface/No_subgraph.h>
#include <CGAL/Surface_insertion_policies_3.h>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Traits

is the default, which was the fastest in measurements. Rounds and starting points come from nets of
the surface. The points are inserted into a compact triangulation, which is copied into the user's
at the end. If that is not possible, CGAL's own insertion takes over. Nothing is traced.

<b>Complexity</b>: expected \f$O((n + m) \log n)\f$ for the order of n points along m edges, and
\f$O(n)\f$ on surfaces like those measured (`Delaunay_from_surface_3::Surface_net_rounds`), plus the
insertions.

\cgalModels{SurfaceInsertionTraits_3}
*/
struct Surface_insertion_traits_3
  : Surface_insertion_policies_3<Delaunay_from_surface_3::No_subgraph,
                                 Delaunay_from_surface_3::Surface_net_rounds,
                                 Delaunay_from_surface_3::Planned_hints_3>
{
};

} // namespace CGAL

#endif // CGAL_SURFACE_INSERTION_TRAITS_3_H
