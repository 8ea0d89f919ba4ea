// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_INSERTION_TRAITS_3_H
#define CGAL_SURFACE_INSERTION_TRAITS_3_H

#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/surface/No_subgraph.h>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Traits

combines a subgraph, a plan and a hint policy into a traits class. Your own combination takes one
line:

\code{.cpp}
namespace DFS = CGAL::Delaunay_from_surface_3;
using My_traits =
    CGAL::Surface_insertion_policies_3<DFS::Full_graph, DFS::Geometric_rounds, DFS::Traced_hints_3>;
\endcode

\tparam SurfaceSubgraph a model of `SurfaceSubgraph` and `DefaultConstructible`
\tparam InsertionPlan a model of `InsertionPlan`, constructible from a seed
\tparam InsertionHints a template whose instances with
`Delaunay_from_surface_3::Triangulation_target_3` and a subgraph are models of `InsertionHints_3`

\cgalModels{SurfaceInsertionTraits_3}
*/
template <class SurfaceSubgraph, class InsertionPlan,
          template <class Target, class Subgraph> class InsertionHints>
struct Surface_insertion_policies_3
{
  /// the function object that makes T.
  using Surface_subgraph = SurfaceSubgraph;

  /// the function object that makes order and rounds.
  using Insertion_plan = InsertionPlan;

  /// the policy that gives each point its starting cell.
  template <class Target, class Subgraph>
  using Insertion_hints_3 = InsertionHints<Target, Subgraph>;

  /// `true` with `Planned_hints_3` and `Previous_hint_3`: the points go through the core, in which
  /// nothing is traced. Any other policy traces or queries the user's triangulation.
  static constexpr bool through_core =
      Delaunay_from_surface_3::internal::Starts_in_core<InsertionHints>::value;

  /// \cond
  static constexpr bool uses_starting_places =
      Delaunay_from_surface_3::internal::Starts_in_core<InsertionHints>::uses_starting_places;
  /// \endcond

  /// returns the function object that makes T.
  Surface_subgraph surface_subgraph_object() const { return Surface_subgraph(); }

  /// returns the function object that makes order and rounds from `seed`.
  Insertion_plan insertion_plan_object(unsigned int seed) const { return Insertion_plan(seed); }
};

/*!
\ingroup PkgDelaunayFromSurface3Traits

is the default, which was the fastest in measurements. The points come in rounds of well-spaced points,
and the location of each starts at a nearby point of an earlier round. The points are inserted into a
compact triangulation, which is copied into the user's at the end. If that is not possible, CGAL's own
insertion takes over. The surface is not used, because rounds made from its edges destroy just as many
cells (`nets_200k.json`) and take just as long (`nets_256k.json`).

<b>Complexity</b>: expected \f$O(n \log n)\f$ for the order of n points, plus the insertions.

\cgalModels{SurfaceInsertionTraits_3}
*/
struct Surface_insertion_traits_3
  : Surface_insertion_policies_3<Delaunay_from_surface_3::No_subgraph,
                                 Delaunay_from_surface_3::Spaced_rounds,
                                 Delaunay_from_surface_3::Planned_hints_3>
{
};

/*!
\ingroup PkgDelaunayFromSurface3Traits

is the control: exactly the insertions of `Delaunay_triangulation_3::insert(first, last)`, in the
same order and from the same starting cells. The surface is not used. With `Fast_location` this
holds for the lowest level. With `Parallel_tag` that function uses many threads, this class one.

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

#endif // CGAL_SURFACE_INSERTION_TRAITS_3_H
