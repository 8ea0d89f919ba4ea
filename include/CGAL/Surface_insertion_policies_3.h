// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_INSERTION_POLICIES_3_H
#define CGAL_SURFACE_INSERTION_POLICIES_3_H

#include <CGAL/Delaunay_from_surface_3/insertion/Triangulation_target_3.h>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Traits

binds one model of each concept of the package to a traits class. A user's own mixture is one line:

\code{.cpp}
namespace DFS = CGAL::Delaunay_from_surface_3;
using My_traits =
    CGAL::Surface_insertion_policies_3<DFS::Full_graph, DFS::Geometric_rounds, DFS::Traced_hints_3>;
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
          template <class Triangulation> class InsertionTarget =
              Delaunay_from_surface_3::Triangulation_target_3>
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

} // namespace CGAL

#endif // CGAL_SURFACE_INSERTION_POLICIES_3_H
