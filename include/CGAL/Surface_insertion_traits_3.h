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

is the default, what measured fastest: rounds and starting points from nets of the surface, inserted
into a compact triangulation that is written into the user's at the end. Where that cannot serve,
CGAL's own insertion does. Nothing is traced.

Expected \f$O((n + m) \log n)\f$ for n points and m edges, and \f$O(n)\f$ on surfaces like those
measured (`Delaunay_from_surface_3::Surface_net_rounds`), plus what the insertions take.

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
