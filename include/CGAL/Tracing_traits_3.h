// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TRACING_TRAITS_3_H
#define CGAL_TRACING_TRAITS_3_H

#include <CGAL/Delaunay_from_surface_3/paper/Conflict_history_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/surface/Bounded_degree_subgraph.h>
#include <CGAL/Surface_insertion_traits_3.h>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Traits

is the algorithm of the paper (\cgalCite{choi-dtsm-02}, Fig.\ 1), with a walk instead of its location
structure Q: random rounds that end at \f$N_h\f$, and a trace of a spanning subgraph T of bounded degree
at the end of each round but the last. Its purpose is to study the paper: it takes 1.1 to 1.5 times as
long as plain %CGAL on the surfaces measured (\ref dfs_paper_control). For speed use the default,
`Surface_insertion_traits_3`.

Each round is sorted along a Hilbert curve, so that successive points are near each other in memory.
The sets of points inserted by the ends of the rounds stay random, and with them what the paper says
of the sizes of the triangulations traced. Its bounds on location and on the cells created need a
random order inside the rounds, too; with
`Tracing_traits_3(Delaunay_from_surface_3::Log_star_rounds::FIRST_ROUND)` the order is random from
the second round on, and the insertion takes longer.
\ref delaunay_from_surface_3_the_paper "The page on the paper" counts the work of both.

T is that of `Bounded_degree_subgraph`, for meshes and soups. For a surface that this refuses, and
for a graph without faces, T is a `Spanning_forest`, whose degree is not bounded, and the visitor is
told.

The bound of \f$O(n \log^* n)\f$ expected time holds for the paper's Q; it is not claimed for walks.

\cgalModels{SurfaceInsertionTraits_3}
*/
class Tracing_traits_3
  : public Surface_insertion_policies_3<Delaunay_from_surface_3::Bounded_degree_subgraph,
                                        Delaunay_from_surface_3::Log_star_rounds,
                                        Delaunay_from_surface_3::Traced_hints_3>
{
public:
  /// chooses the rounds that are sorted.
  explicit Tracing_traits_3(Insertion_plan::Sorted_rounds sorted = Insertion_plan::ALL_ROUNDS)
    : m_sorted(sorted)
  {
  }

  /// returns the paper's rounds, sorted as chosen.
  Insertion_plan insertion_plan_object(unsigned int seed) const
  {
    return Insertion_plan(seed, m_sorted);
  }

private:
  Insertion_plan::Sorted_rounds m_sorted;
};

/*!
\ingroup PkgDelaunayFromSurface3Traits

is the algorithm of the paper (\cgalCite{choi-dtsm-02}, Fig.\ 1): random order, rounds that end at
\f$N_h\f$, traces of a spanning subgraph T of bounded degree, and the history of all conflicts. Its
purpose is to study the theorem, not to save time: it is slower than the other traits, and takes
several times their memory. It cannot be used with `Fast_location`.

T is that of `Bounded_degree_subgraph`, for meshes and soups. For a surface that this refuses, and
for a graph without faces, T is a `Spanning_forest`, whose degree is not bounded, and the visitor is
told.

<b>Complexity</b>: expected \f$O(n \log^* n)\f$ time under the assumptions of the paper: T has
bounded degree and consists of Delaunay edges, and the triangulations of the points inserted so far
have linear expected size. \ref delaunay_from_surface_3_the_paper "The page on the paper" compares
this with measurements. If `tr` already has many vertices, or many points come before the first that
is not in the plane of those before, points are located by walks up to the next trace, for which
nothing is claimed (`Conflict_history_hints_3`).

\cgalModels{SurfaceInsertionTraits_3}
*/
struct History_tracing_traits_3
  : Surface_insertion_policies_3<Delaunay_from_surface_3::Bounded_degree_subgraph,
                                 Delaunay_from_surface_3::Log_star_rounds,
                                 Delaunay_from_surface_3::Conflict_history_hints_3>
{
  /// returns the paper's own plan: no round is sorted.
  Insertion_plan insertion_plan_object(unsigned int seed) const
  {
    return Insertion_plan(seed, Insertion_plan::NO_ROUND);
  }
};

} // namespace CGAL

#endif // CGAL_TRACING_TRAITS_3_H
