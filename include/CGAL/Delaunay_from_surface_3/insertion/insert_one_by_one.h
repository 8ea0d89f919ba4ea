// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSERTION_INSERT_ONE_BY_ONE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSERTION_INSERT_ONE_BY_ONE_H

// Choi 2002, Fig. 1, lines 2b and 2c, for the points between two traces.

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>

#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Insertion

inserts the points `first`, …, `last - 1` into `target`, one after the other: each is located from
where the hints say, and inserted there. It is what `InsertionTarget_3::insert_round()` does where a
target has no better way.

\tparam Target a model of `InsertionTarget_3`; `insert_round()` is not called
\tparam Hints a model of `InsertionHints_3`
\tparam Visitor a model of `SurfaceInsertionVisitor_3`

\return `false` if the visitor stopped it
*/
template <class Target, class Hints, class Visitor>
bool insert_one_by_one(Target& target, std::size_t first, std::size_t last, Hints& hints,
                       Visitor& visitor)
{
  using Phase = Surface_insertion_phase;
  for (std::size_t i = first; i < last; ++i) {
    if (!visitor.go_further())
      return false;
    visitor.phase_begins(Phase::LOCATION);
    const typename Target::Location d_i = target.locate(i, hints.start(i)); // 2b
    visitor.phase_begins(Phase::UPDATE);
    target.insert(i, d_i, hints); // 2c
  }
  return true;
}

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSERTION_INSERT_ONE_BY_ONE_H
