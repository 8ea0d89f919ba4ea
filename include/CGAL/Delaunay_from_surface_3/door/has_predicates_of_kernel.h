// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_HAS_PREDICATES_OF_KERNEL_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_HAS_PREDICATES_OF_KERNEL_H

// What the filters of the compact kernel rely on at compile time.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/is_detected.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/tags.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Whether all predicates that the filters decide without asking are those of the kernel. What
// counts is what the triangulation calls: the objects.
template <class GeomTraits, class Kernel>
constexpr bool has_predicates_of_kernel()
{
  using Gt = const GeomTraits&;
  using K = const Kernel&;
  return std::is_same<decltype(std::declval<Gt>().orientation_3_object()),
                      decltype(std::declval<K>().orientation_3_object())>::value &&
         std::is_same<decltype(std::declval<Gt>().side_of_oriented_sphere_3_object()),
                      decltype(std::declval<K>().side_of_oriented_sphere_3_object())>::value &&
         std::is_same<
             decltype(std::declval<Gt>().coplanar_side_of_bounded_circle_3_object()),
             decltype(std::declval<K>().coplanar_side_of_bounded_circle_3_object())>::value &&
         std::is_same<decltype(std::declval<Gt>().coplanar_orientation_3_object()),
                      decltype(std::declval<K>().coplanar_orientation_3_object())>::value &&
         std::is_same<decltype(std::declval<Gt>().compare_xyz_3_object()),
                      decltype(std::declval<K>().compare_xyz_3_object())>::value;
}

// Whether the predicates are exact: filtered, or on exact numbers.
template <class GeomTraits>
using Says_of_filters = typename GeomTraits::Has_filtered_predicates_tag;

template <class GeomTraits>
constexpr bool has_filtered_predicates =
    detected_or_t<std::false_type, Says_of_filters, GeomTraits>::value;

template <class GeomTraits>
constexpr bool has_exact_predicates()
{
  using Is_exact = typename Algebraic_structure_traits<typename GeomTraits::FT>::Is_exact;
  return has_filtered_predicates<GeomTraits> || std::is_same<Is_exact, Tag_true>::value;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_HAS_PREDICATES_OF_KERNEL_H
