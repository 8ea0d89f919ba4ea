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
#include <string>
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

// Points, and their weights from another range, checked, as doubles; weights of a
// std::vector<double> stay where they are.
template <class PointRange, class WeightRange,
          class NamedParameters = parameters::Default_named_parameters>
class Read_weighted_points final : public Weighted_point_source
{
  static constexpr bool stays = std::is_same<WeightRange, std::vector<double>>::value;

public:
  // Keeps references to both ranges.
  Read_weighted_points(const PointRange& points, const WeightRange& weights,
                       const NamedParameters& np = parameters::default_values())
    : m_points(points, np)
    , m_weights(weights)
  {
    const auto n = std::size_t(std::distance(std::begin(weights), std::end(weights)));
    if (n != m_points.size())
      throw Surface_input_error("there are " + std::to_string(n) + " weights, but " +
                                std::to_string(m_points.size()) + " points");
    read();
  }

  Point_array points() override { return m_points.points(); }
  const double* weights() override
  {
    if constexpr (stays) {
      return m_weights.data();
    } else {
      if (m_copy.empty())
        read();
      return m_copy.data();
    }
  }
  void give_up() override
  {
    m_points.give_up();
    Large_vector<double>().swap(m_copy);
  }

private:
  void read()
  {
    const Rounding_to_nearest rounding;
    m_copy.reserve(stays ? 0 : m_points.size());
    std::size_t i = 0;
    for (const auto& weight : m_weights) {
      const double w = double_of_weight(weight, i++);
      if constexpr (!stays)
        m_copy.push_back(w);
    }
  }

  Read_coordinates<PointRange, NamedParameters> m_points;
  const WeightRange& m_weights;
  Large_vector<double> m_copy;
};

// Throws unless the arrays, of any index, are of n points.
template <class Arrays>
void check_number_of_points(const Arrays& arrays, std::size_t n)
{
  if (arrays.number_of_points() != n)
    throw Surface_input_error("the arrays are of " + std::to_string(arrays.number_of_points()) +
                              " points, and " + std::to_string(n) + " are given");
}

// Throws if weights hide a point, and says what needs it.
template <class Arrays>
void refuse_hidden_points(const Arrays& arrays, const char* what)
{
  for (std::size_t i = 0; i < arrays.number_of_points(); ++i)
    if (arrays.vertex_of_point(i) == Arrays::none)
      throw Surface_input_error("vertex " + std::to_string(i) + ": its weight hides it, and a " +
                                what);
}

// Maps items to points: to those in the weighted points to which another map leads.
template <class Weighted_point_map>
struct Bare_point_map
{
  Weighted_point_map map;

  template <class Item>
  friend auto get(const Bare_point_map& of, const Item& item)
  {
    return get(of.map, item).point(); // a copy: the weighted point may be temporary
  }
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_READ_COORDINATES_H
