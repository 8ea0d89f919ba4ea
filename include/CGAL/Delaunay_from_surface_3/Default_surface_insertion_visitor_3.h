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

names the phases of the insertion of a surface. `PLAN` and `SUBGRAPH` occur once, and again if the
work begins anew in another order. `LOCATION` and `UPDATE` alternate, point by point. `TRACE`
occurs, if CGAL inserts, at the end of each round but the last. `FINISH` occurs once, but not after
a stop. `DONE` marks the end.
*/
enum class Surface_insertion_phase {
  PLAN,     ///< the order of the points and the rounds are made.
  SUBGRAPH, ///< the spanning subgraph T is made; in the core, the first four points are inserted.
  LOCATION, ///< a point is located (Choi 2002, Fig.\ 1, line 2b).
  UPDATE,   ///< a point is inserted (line 2c).
  TRACE,    ///< T is traced through the triangulation (line 2a).
  FINISH,   ///< the triangulation is handed over.
  DONE      ///< the work is done.
};

/*!
\ingroup PkgDelaunayFromSurface3Progress

observes nothing, never stops the work and leaves no point out. It serves as a base class: a
function in the derived class replaces the one of the same name here, at compile time. Calls of the
functions here cost nothing.

\cgalModels{SurfaceInsertionVisitor_3}
*/
struct Default_surface_insertion_visitor_3
{
  /// is called before the first phase if the surface is not a manifold mesh of triangles.
  void surface_is_irregular(const std::string& /* reason */) {}

  /// is called if CGAL's own insertion replaces the core: before the first round, or when 32 bits
  /// are too few for the cells.
  void target_is_replaced(const std::string& /* reason */) {}

  /// is called in the phase `SUBGRAPH` if the subgraph of the traits refuses the surface and a
  /// spanning forest takes its place.
  void subgraph_is_replaced(const std::string& /* reason */) {}

  /// is called if the order of the plan makes the insertions too costly; they begin anew in another
  /// order.
  void order_is_replaced(const std::string& /* reason */) {}

  /// is called before the first round, with the number of threads that may insert. If there is more
  /// than one, the phases `LOCATION` and `UPDATE` are not reported. The calling thread calls all
  /// functions.
  void insertion_begins(std::size_t /* number_of_threads */) {}

  /// is called when a phase begins.
  void phase_begins(Surface_insertion_phase) {}

  /// is called before the first point of each round; rounds are counted from 0.
  void round_begins(std::size_t /* round */, std::size_t /* number_of_points */) {}

  /// is called after the trace that ends a round, if CGAL inserts.
  void trace_ends(std::size_t /* number_of_located_points */) {}

  /// is called after the last insertion, before the triangulation is handed over.
  template <class Target, class Hints>
  void insertion_ends(const Target&, const Hints&)
  {
  }

  /// is called every 256 points, or, with many threads, whenever the calling thread takes a portion
  /// of points; before each point if CGAL inserts. Returning `false` stops the work.
  bool go_further() { return true; }
};

} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEFAULT_SURFACE_INSERTION_VISITOR_3_H
