// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_OBSTACLES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_OBSTACLES_H

// What keeps a call from going through the core, so that CGAL's own insertion takes its place.

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/Too_few_ids.h>
#include <CGAL/Delaunay_from_surface_3/core/build.h>
#include <CGAL/Delaunay_from_surface_3/door/Doubles_of_points.h>
#include <CGAL/Delaunay_from_surface_3/support/is_detected.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/tags.h>

#include <limits>
#include <string>
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

// Whether the core knows the numbers and predicates of the triangulation. Traits that bring
// predicates of their own are not served: its filters would go past them.
template <class Triangulation>
constexpr bool serves_geom_traits()
{
  using Geom_traits = typename Triangulation::Geom_traits;
  using Point = typename Triangulation::Point;
  return std::is_same<typename Geom_traits::Point_3, Point>::value &&
         has_predicates_of_kernel<Geom_traits, typename Kernel_traits<Point>::Kernel>() &&
         has_exact_predicates<Geom_traits>();
}

// What is known before anything is done; empty if nothing is in the way.
template <class Triangulation>
std::string obstacle_to_core(const Triangulation& tr,
                             const Doubles_of_points<typename Triangulation::Point>& points)
{
  if (!serves_geom_traits<Triangulation>())
    return "the predicates of the geometric traits are not the exact ones of a kernel";
  if (const char* const obstacle = obstacle_of_core())
    return obstacle;
  if (tr.number_of_vertices() > 0)
    return "the triangulation is not empty";
  return points.obstacle();
}

// What the core found.
template <class Id>
std::string obstacle_found(const Built<Id>& built)
{
  switch (built.outcome) {
  case Insertion_outcome::FLAT:
    return built.dimension < 3 ? "the points lie in one plane"
                               : "the points that are accepted first lie in one plane";
  case Insertion_outcome::TOO_FEW_IDS:
    return Too_few_ids(std::numeric_limits<Id>::digits).what();
  default:
    return "";
  }
}

[[noreturn]] inline void refuse_input_order(const std::string& obstacle)
{
  throw Surface_input_error("the vertices cannot be created in the order of the input: " +
                            obstacle);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_OBSTACLES_H
