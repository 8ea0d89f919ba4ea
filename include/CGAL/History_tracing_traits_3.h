// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HISTORY_TRACING_TRAITS_3_H
#define CGAL_HISTORY_TRACING_TRAITS_3_H

#include <CGAL/Delaunay_from_surface_3/plan/Random_log_star_rounds.h>
#include <CGAL/Delaunay_from_surface_3/subgraph/Bounded_degree_subgraph.h>
#include <CGAL/Delaunay_from_surface_3/trace/History_hints_3.h>
#include <CGAL/Surface_insertion_policies_3.h>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Traits

is the algorithm of the paper (\cgalCite{choi-dtsm-02}, Fig.\ 1): random order, rounds
that end at N_h, traces of a spanning subgraph of bounded degree, and the history DAG for Q. It is
here to study the theorem, not to save time: it takes several times the memory of the others, and is
slower.

Not with `Fast_location`.

\cgalModels{SurfaceInsertionTraits_3}
*/
struct History_tracing_traits_3
  : Surface_insertion_policies_3<Delaunay_from_surface_3::Bounded_degree_subgraph,
                                 Delaunay_from_surface_3::Random_log_star_rounds,
                                 Delaunay_from_surface_3::History_hints_3>
{
};

} // namespace CGAL

#endif // CGAL_HISTORY_TRACING_TRAITS_3_H
