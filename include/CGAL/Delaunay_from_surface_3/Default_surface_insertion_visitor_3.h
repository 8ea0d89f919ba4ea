// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEFAULT_SURFACE_INSERTION_VISITOR_3_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEFAULT_SURFACE_INSERTION_VISITOR_3_H

#include <cstddef>
#include <string>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Progress

names the phases of the insertion of a surface. A visitor is told of each when it begins, with a
number. `PLAN`, `SUBGRAPH` and `INSERTION` occur once, and again if the work begins anew in another
order. `LOCATION` and `UPDATE` alternate, point by point. `TRACE` occurs, if CGAL inserts, at the end
of each round but the last. `FINISH` occurs once, but not after a stop. `DONE` marks the end.
*/
enum class Surface_insertion_phase {
  PLAN,      ///< the order of the points and the rounds are made.
  SUBGRAPH,  ///< the spanning subgraph T is made; in the core, the first four points are inserted.
  INSERTION, ///< the points are inserted, by at most `number` threads.
  ROUND,     ///< `number` points are inserted in a round, at least 1 (Choi 2002, Fig.\ 1).
  LOCATION,  ///< a point is located (line 2b).
  UPDATE,    ///< a point is inserted (line 2c).
  TRACE,     ///< T is traced (line 2a); the next round has `number` points; 0 if no T is used.
  FINISH,    ///< the triangulation is handed over.
  DONE       ///< the work is done.
};

/*!
\ingroup PkgDelaunayFromSurface3Progress

names what a visitor is told with a reason. None of these is an error: the result is the same.
*/
enum class Surface_insertion_notice {
  /// The surface is not a manifold mesh of triangles. This comes before the first phase; the reason
  /// says how many faces are not triangles, and how many edges have more than two faces.
  SURFACE_IS_IRREGULAR,
  /// The subgraph of the traits refuses the surface, or needs more than a plain graph, and a spanning
  /// forest takes its place. This comes in the phase `SUBGRAPH`; the reason says which vertex or edge
  /// is refused, or what is lacking.
  SUBGRAPH_IS_REPLACED,
  /// CGAL's own insertion takes the place of the core, before the first round, or when 32 bits are
  /// too few for the cells and the rounds begin anew.
  CORE_IS_REPLACED,
  /// The order of the plan makes the insertions too costly; they begin anew in another order, with
  /// the phase `PLAN`.
  ORDER_IS_REPLACED
};

/*!
\ingroup PkgDelaunayFromSurface3Progress

observes nothing and never stops the work. It serves as a base class: a function in the derived class
replaces the one of the same name here, at compile time. Calls of the functions here cost nothing.

\cgalModels{SurfaceInsertionVisitor_3}
*/
struct Default_surface_insertion_visitor_3
{
  /// says whether the phases `LOCATION` and `UPDATE` of every point are reported. With more than one
  /// thread they never are.
  static constexpr bool follows_points = false;

  /// is called when something other than what was asked for is done, with the reason.
  void notice(Surface_insertion_notice, const std::string& /* reason */) {}

  /// is called when a phase begins, with a number that `Surface_insertion_phase` explains, and 0 for
  /// phases without one. The calling thread calls all functions.
  void phase_begins(Surface_insertion_phase, std::size_t /* number */) {}

  /// is called every 256 points, or, with many threads, whenever the calling thread takes a portion
  /// of points; before each point if CGAL inserts. Returning `false` stops the work.
  bool go_further(std::size_t /* inserted */) { return true; }

  /// is called after the last insertion, before the triangulation is handed over.
  template <class Target, class Hints>
  void insertion_ends(const Target&, const Hints&)
  {
  }
};

} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEFAULT_SURFACE_INSERTION_VISITOR_3_H
