// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TRACING_TRAITS_3_H
#define CGAL_TRACING_TRAITS_3_H

#include <CGAL/Delaunay_from_surface_3/paper/Traced_hints_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/surface/Bounded_degree_subgraph.h>
#include <CGAL/Surface_insertion_policies_3.h>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Traits

is the algorithm of the paper (\cgalCite{choi-dtsm-02}, Fig.\ 1), with a walk instead of its
location structure Q: random order, rounds that end at \f$N_h\f$, and a trace of a spanning subgraph
T of bounded degree at the end of each round but the last. Round 1 follows a Hilbert curve.

T is that of `Bounded_degree_subgraph`, for meshes and soups. For a surface that this refuses, and
for a graph without faces, T is a `Spanning_forest`, whose degree is not bounded, and the visitor is
told.

The bound of \f$O(n \log^* n)\f$ expected time holds for the paper's Q; it is not claimed for walks.

\cgalModels{SurfaceInsertionTraits_3}
*/
struct Tracing_traits_3
  : Surface_insertion_policies_3<Delaunay_from_surface_3::Bounded_degree_subgraph,
                                 Delaunay_from_surface_3::Log_star_rounds,
                                 Delaunay_from_surface_3::Traced_hints_3>
{
};

} // namespace CGAL

#endif // CGAL_TRACING_TRAITS_3_H
