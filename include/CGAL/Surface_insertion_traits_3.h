// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_INSERTION_TRAITS_3_H
#define CGAL_SURFACE_INSERTION_TRAITS_3_H

#include <CGAL/Delaunay_from_surface_3/insertion/Compact_delaunay_3.h>
#include <CGAL/Delaunay_from_surface_3/insertion/Triangulation_target_3.h>
#include <CGAL/Delaunay_from_surface_3/plan/Geometric_rounds.h>
#include <CGAL/Delaunay_from_surface_3/plan/Hilbert_sorted_rounds.h>
#include <CGAL/Delaunay_from_surface_3/plan/Log_star_rounds.h>
#include <CGAL/Delaunay_from_surface_3/plan/Neighbor_started_rounds.h>
#include <CGAL/Delaunay_from_surface_3/plan/Random_log_star_rounds.h>
#include <CGAL/Delaunay_from_surface_3/plan/Spatial_sort_order.h>
#include <CGAL/Delaunay_from_surface_3/plan/Surface_net_rounds.h>
#include <CGAL/Delaunay_from_surface_3/subgraph/Bounded_degree_subgraph.h>
#include <CGAL/Delaunay_from_surface_3/subgraph/Full_graph.h>
#include <CGAL/Delaunay_from_surface_3/subgraph/Spanning_forest.h>
#include <CGAL/Delaunay_from_surface_3/trace/History_hints_3.h>
#include <CGAL/Delaunay_from_surface_3/trace/Neighbor_hints_3.h>
#include <CGAL/Delaunay_from_surface_3/trace/Planned_hints_3.h>
#include <CGAL/Delaunay_from_surface_3/trace/Previous_hint_3.h>
#include <CGAL/Delaunay_from_surface_3/trace/Traced_hints_3.h>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Traits

binds one model of each concept of the package to a traits class. A user's own mixture is one line:

\code{.cpp}
using My_traits = CGAL::Surface_insertion_policies_3<CGAL::Full_graph, CGAL::Geometric_rounds,
                                                     CGAL::Traced_hints_3>;
\endcode

\tparam SurfaceSubgraph a model of `SurfaceSubgraph` and `DefaultConstructible`
\tparam InsertionPlan a model of `InsertionPlan`, constructible from a seed
\tparam InsertionHints a template whose instances with a target and a subgraph model
`InsertionHints_3`
\tparam InsertionTarget a template whose instances with a triangulation model `InsertionTarget_3`

\cgalModels{SurfaceInsertionTraits_3}
*/
template <class SurfaceSubgraph, class InsertionPlan,
          template <class Target, class Subgraph> class InsertionHints,
          template <class Triangulation> class InsertionTarget = Triangulation_target_3>
struct Surface_insertion_policies_3
{
  /// the functor that makes T.
  using Surface_subgraph = SurfaceSubgraph;

  /// the functor that makes order and rounds.
  using Insertion_plan = InsertionPlan;

  /// the policy that gives each point its starting cell.
  template <class Target, class Subgraph>
  using Insertion_hints_3 = InsertionHints<Target, Subgraph>;

  /// what the points are inserted into.
  template <class Triangulation>
  using Insertion_target_3 = InsertionTarget<Triangulation>;

  /// returns the functor that makes T.
  Surface_subgraph surface_subgraph_object() const { return Surface_subgraph(); }

  /// returns the functor that makes order and rounds from `seed`.
  Insertion_plan insertion_plan_object(unsigned int seed) const { return Insertion_plan(seed); }
};

/*!
\ingroup PkgDelaunayFromSurface3Traits

is the algorithm of the paper (\cgalCite{choi-dtsm-02}, Fig.\ 1), with a walk in the place of Q:
random order, rounds that end at N_h, and a trace of a spanning subgraph T at the end of each round
but the last. T is a spanning forest here, whose degree has no bound. Round 1 follows a Hilbert
order.

The bound of O(n log* n) expected time is that of the paper's Q and of a T of bounded degree; it is
not claimed for the walk.

\cgalModels{SurfaceInsertionTraits_3}
*/
struct Tracing_traits_3
  : Surface_insertion_policies_3<Bounded_degree_subgraph, Log_star_rounds, Traced_hints_3>
{
};

/*!
\ingroup PkgDelaunayFromSurface3Traits

is the algorithm of the paper to the letter (\cgalCite{choi-dtsm-02}, Fig.\ 1): random order, rounds that end at
N_h, traces of a spanning subgraph of bounded degree, and the history DAG for Q. It is here to study
the theorem, not to save time: it takes several times the memory of the others, and is slower.

O(n log* n) expected time under the assumptions of the paper. Not with `Fast_location`.

\cgalModels{SurfaceInsertionTraits_3}
*/
struct History_tracing_traits_3
  : Surface_insertion_policies_3<Bounded_degree_subgraph, Random_log_star_rounds, History_hints_3>
{
};

/*!
\ingroup PkgDelaunayFromSurface3Traits

is the control: exactly the insertions of `Delaunay_triangulation_3::insert(first, last)`, in that
order and from those starting cells. The surface is not looked at. With `Fast_location` this
is true of the lowest level; with `Parallel_tag` stock insertion is another matter.

O(n log n), plus what the insertions take.

\cgalModels{SurfaceInsertionTraits_3}
*/
struct Stock_order_traits_3
  : Surface_insertion_policies_3<Full_graph, Spatial_sort_order, Previous_hint_3>
{
};

/*!
\ingroup PkgDelaunayFromSurface3Traits

is the default, what measured fastest: rounds and starting points from nets of the surface, inserted
into a compact triangulation that is written into the user's at the end. Where that cannot serve,
CGAL's own insertion does. Nothing is traced.

O(n) for n points on a surface of fixed genus, O(n log n + m) for any graph with m edges, plus what
the insertions take.

\cgalModels{SurfaceInsertionTraits_3}
*/
struct Surface_insertion_traits_3
  : Surface_insertion_policies_3<Full_graph, Surface_net_rounds, Planned_hints_3,
                                 Compact_delaunay_3>
{
};

} // namespace CGAL

#endif // CGAL_SURFACE_INSERTION_TRAITS_3_H
