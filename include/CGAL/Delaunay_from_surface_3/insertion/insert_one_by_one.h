// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSERTION_INSERT_ONE_BY_ONE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSERTION_INSERT_ONE_BY_ONE_H

// Choi 2002, Fig. 1, lines 2b and 2c, for the points between two traces.

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// Is a visitor asked which points are inserted (internal/driver/Asking_visitor.h)?
template <class Visitor, class = void>
struct Is_asked : std::false_type
{
};
template <class Visitor>
struct Is_asked<Visitor, std::void_t<decltype(Visitor::is_asked)>>
  : std::bool_constant<Visitor::is_asked>
{
};

} // namespace internal

/*!
\ingroup PkgDelaunayFromSurface3Insertion

inserts the points `first`, …, `last - 1` into `target`, one after the other: each is located from
where the hints say, and inserted there. It is what `InsertionTarget_3::insert_round()` does where a
target has no better way. Visitors that leave points out are asked by
`InsertionTarget_3::insert_if()`.

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
    if constexpr (internal::Is_asked<Visitor>::value)
      if (visitor.has_left_out(i))
        continue;
    visitor.phase_begins(Phase::LOCATION);
    const typename Target::Location d_i = target.locate(i, hints.start(i)); // 2b
    visitor.phase_begins(Phase::UPDATE);
    if constexpr (internal::Is_asked<Visitor>::value)
      target.insert_if(i, d_i, hints, [&](std::size_t nearest, const auto& point) {
        return visitor.may_insert(i, nearest, point);
      });
    else
      target.insert(i, d_i, hints); // 2c
  }
  return true;
}

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSERTION_INSERT_ONE_BY_ONE_H
