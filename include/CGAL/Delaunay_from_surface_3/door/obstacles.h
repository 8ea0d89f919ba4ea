// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_OBSTACLES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_OBSTACLES_H

// What keeps a call from going through the core, so that CGAL's own insertion takes its place.

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/Too_few_ids.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/obstacle_of_compiler.h>
#include <CGAL/Delaunay_from_surface_3/door/Doubles_of_points.h>
#include <CGAL/Delaunay_from_surface_3/door/has_predicates_of_kernel.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/Kernel_traits.h>

#include <limits>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

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
  if (obstacle_of_compiler() != nullptr)
    return obstacle_of_compiler();
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
