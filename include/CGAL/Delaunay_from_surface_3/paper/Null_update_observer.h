// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_NULL_UPDATE_OBSERVER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_NULL_UPDATE_OBSERVER_H

#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Insertion

observes nothing and costs nothing; it serves as a base class.

\cgalModels{UpdateObserver_3}
*/
struct Null_update_observer
{
  /// `false`: the conflict zone is not needed, and the target may insert in the fastest way.
  static constexpr bool observes_conflict_zone = false;

  /// does nothing.
  template <class CellIterator>
  void before_update(std::size_t, CellIterator, CellIterator)
  {
  }

  /// does nothing.
  template <class Vertex>
  void after_update(std::size_t, Vertex)
  {
  }
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_NULL_UPDATE_OBSERVER_H
