// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_ACCEPTS_POINTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_ACCEPTS_POINTS_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Visitor, class Point, class = void>
struct Has_accept : std::false_type
{
};
template <class Visitor, class Point>
struct Has_accept<Visitor, Point,
                  std::void_t<decltype(std::declval<Visitor&>().accept(
                      std::size_t(), std::size_t(), std::declval<const Point&>()))>>
  : std::true_type
{
};

// Is there one that looks at the corners, too?
template <class Visitor, class Point, class = void>
struct Has_accept_with_corners : std::false_type
{
};
template <class Visitor, class Point>
struct Has_accept_with_corners<Visitor, Point,
                               std::void_t<decltype(std::declval<Visitor&>().accept(
                                   std::size_t(), std::size_t(), std::declval<const Point&>(),
                                   std::declval<const std::array<std::size_t, 4>&>()))>>
  : std::true_type
{
};

// Is there one with any arguments, that is no template and the only one?
template <class Visitor, class = void>
struct Names_accept : std::false_type
{
};
template <class Visitor>
struct Names_accept<Visitor, std::void_t<decltype(&Visitor::accept)>> : std::true_type
{
};

// Does a visitor leave points out? One that has accept() is asked, in the order of insertion, what it
// says of a point and the vertex nearest to it.
template <class Visitor, class Point>
constexpr bool accepts_points()
{
  constexpr bool has_accept =
      Has_accept<Visitor, Point>::value || Has_accept_with_corners<Visitor, Point>::value;
  static_assert(has_accept || !Names_accept<Visitor>::value,
                "the accept() of a visitor takes the numbers of two points and a point");
  return has_accept;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_ACCEPTS_POINTS_H
