// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_REFUSE_TRIANGULATION_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_REFUSE_TRIANGULATION_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/Delaunay_triangulation_3.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {

template <class Gt, class Tds, class Lds>
class Regular_triangulation_3;

namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// A type that is not derived from a Delaunay_triangulation_3 gets a message of one line.
template <class Gt, class Tds, class Lp, class Slds>
std::true_type is_delaunay_triangulation(const Delaunay_triangulation_3<Gt, Tds, Lp, Slds>*);
std::false_type is_delaunay_triangulation(const void*);

template <class Gt, class Tds, class Lds>
std::true_type is_regular_triangulation(const Regular_triangulation_3<Gt, Tds, Lds>*);
std::false_type is_regular_triangulation(const void*);

template <class Triangulation>
constexpr bool is_regular =
    decltype(is_regular_triangulation(std::declval<Triangulation*>()))::value;

template <class Triangulation>
using If_refused =
    std::enable_if_t<!decltype(is_delaunay_triangulation(std::declval<Triangulation*>()))::value,
                     std::ptrdiff_t>;

template <class Triangulation>
std::ptrdiff_t refuse_triangulation()
{
  static_assert(!is_regular<Triangulation>,
                "points with weights are inserted by insert_points_3() of "
                "CGAL/insert_weighted_points_3.h, without faces, graph or mesh");
  static_assert(is_regular<Triangulation> ||
                    decltype(is_delaunay_triangulation(std::declval<Triangulation*>()))::value,
                "the triangulation is a CGAL::Delaunay_triangulation_3: periodic points are not "
                "served");
  return 0;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_REFUSE_TRIANGULATION_H
