// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_READ_COORDINATES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_READ_COORDINATES_H

#include <CGAL/Delaunay_from_surface_3/adapters/check_named_parameters.h>
#include <CGAL/Delaunay_from_surface_3/adapters/surface_input.h>
#include <CGAL/Delaunay_from_surface_3/support/Page_array.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

using Point_of_doubles = Exact_predicates_inexact_constructions_kernel::Point_3;

// The coordinates of a range of points, checked, as doubles; those of a
// std::vector<std::array<double, 3>> stay where they are.
template <class PointRange, class NamedParameters = parameters::Default_named_parameters>
class Read_coordinates final : public Point_source
{
  using Item = typename std::iterator_traits<decltype(std::begin(
      std::declval<const PointRange&>()))>::value_type;
  using Point_map =
      typename internal_np::Lookup_named_param_def<internal_np::point_t, NamedParameters,
                                                   Identity_property_map<const Item>>::type;
  static constexpr bool stays =
      std::is_same<PointRange, std::vector<std::array<double, 3>>>::value &&
      !is_given<NamedParameters, internal_np::point_t>;

public:
  // Keeps a reference to the points.
  explicit Read_coordinates(const PointRange& points,
                            const NamedParameters& np = parameters::default_values())
    : m_points(points)
    , m_point_map(
          parameters::choose_parameter(parameters::get_parameter(np, internal_np::point_map),
                                       Identity_property_map<const Item>()))
    , m_size(std::size_t(std::distance(std::begin(points), std::end(points))))
  {
    read();
  }

  std::size_t size() const { return m_size; }

  Point_array points() override
  {
    if constexpr (stays) {
      return Point_array(m_size == 0 ? nullptr : m_points.front().data(), m_size);
    } else {
      if (m_copy.empty())
        read();
      return Point_array(m_copy.data(), m_size);
    }
  }
  void give_up() override { Large_vector<double>().swap(m_copy); }

private:
  void read()
  {
    const Rounding_to_nearest rounding; // reading twice gives the same numbers
    m_copy.reserve(stays ? 0 : 3 * m_size);
    std::size_t i = 0;
    for (const auto& item : m_points) {
      const auto p = converted_point<Point_of_doubles>(get(m_point_map, item));
      check_point(p, i++);
      if constexpr (!stays)
        m_copy.insert(m_copy.end(), {p.x(), p.y(), p.z()});
    }
  }

  const PointRange& m_points;
  const Point_map m_point_map;
  const std::size_t m_size;
  Large_vector<double> m_copy;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_READ_COORDINATES_H
