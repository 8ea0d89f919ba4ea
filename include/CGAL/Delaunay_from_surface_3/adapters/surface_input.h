// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_SURFACE_INPUT_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_SURFACE_INPUT_H

// Converts and checks the input before the triangulation is touched.

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/Cartesian_converter.h>
#include <CGAL/Iterator_range.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Coordinates of any number type become doubles where they equal doubles.

using Coordinate_intervals = std::array<std::pair<double, double>, 3>;

// True if a point holds intervals around its coordinates, as points of lazy kernels do; asking
// these for a coordinate would make a number of it first.
template <class Point>
using Interval_of_x = decltype(std::declval<const Point&>().approx().x().pair());

template <class Point>
constexpr bool has_intervals = is_detected<Interval_of_x, Point>;

// True if every number of the type is a double.
template <class FT>
constexpr bool is_at_most_double = std::is_floating_point<FT>::value &&
                                   sizeof(FT) <= sizeof(double);

// Returns intervals that contain the coordinates.
template <class Point>
Coordinate_intervals coordinate_intervals(const Point& p)
{
  if constexpr (has_intervals<Point>) {
    const auto q = p.approx();
    return {q.x().pair(), q.y().pair(), q.z().pair()};
  } else {
    return {CGAL::to_interval(p.x()), CGAL::to_interval(p.y()), CGAL::to_interval(p.z())};
  }
}

// Returns the double that equals x, if there is one. Comparing makes the interval of a lazy number
// the narrowest.
template <class FT>
std::optional<double> equal_double(const FT& x)
{
  if (const double d = CGAL::to_double(x); is_finite_number(d) && FT(d) == x)
    return d;
  const std::pair<double, double> interval = CGAL::to_interval(x);
  if (interval.first == interval.second)
    return interval.first;
  return std::nullopt;
}

// Returns the coordinates of p if they are all doubles.
template <class Point>
std::optional<std::array<double, 3>> double_coordinates(const Point& p)
{
  using FT = std::decay_t<decltype(p.x())>;
  if constexpr (is_at_most_double<FT>) {
    return {{double(p.x()), double(p.y()), double(p.z())}};
  } else {
    const Coordinate_intervals intervals = coordinate_intervals(p);
    std::array<double, 3> coordinates;
    for (std::size_t c = 0; c < 3; ++c) {
      coordinates[c] = intervals[c].first;
      if (intervals[c].first == intervals[c].second)
        continue;
      const std::optional<double> d = equal_double(c == 0 ? p.x() : c == 1 ? p.y() : p.z());
      if (!d)
        return std::nullopt;
      coordinates[c] = *d;
    }
    return coordinates;
  }
}

// True if the type is the point with a weight of its kernel.
template <class Point>
using Weighted_point_of_kernel_of = typename Point::R::Weighted_point_3;

template <class Point>
constexpr bool has_weight =
    std::is_same<Point, detected_or_t<void, Weighted_point_of_kernel_of, Point>>::value;

// True if the type is arithmetic and has more than one byte: bool and char are not numbers.
template <class Number>
constexpr bool is_number = std::is_arithmetic<Number>::value && sizeof(Number) > 1;

// The number of coordinates is in the type, or else 3 is assumed.
template <class Item>
using Size_of_tuple = std::integral_constant<std::size_t, std::tuple_size<Item>::value>;

template <class Item>
constexpr std::size_t number_of_coordinates =
    detected_or_t<std::integral_constant<std::size_t, 3>, Size_of_tuple, Item>::value;
template <class Number, std::size_t n>
inline constexpr std::size_t number_of_coordinates<Number[n]> = n;

template <class Item>
using Kernel_of_item = typename Item::R;
template <class Item>
using Point_of_kernel_of = typename Item::R::Point_3;
template <class Item>
using First_coordinate = std::decay_t<decltype(std::declval<const Item&>()[0])>;

// True if the type has coordinates [0], [1] and [2] of arithmetic type, as arrays, pointers, and
// vectors of other libraries have. A type of a kernel must be its point type; others are refused.
template <class Item>
constexpr bool has_coordinates =
    is_number<detected_or_t<char, First_coordinate, Item>>&& number_of_coordinates<Item> == 3 &&
    !is_detected<Kernel_of_item, Item>;

// True if the type is a point of a kernel.
template <class Item>
constexpr bool is_point_of_kernel =
    std::is_convertible<const Item&, detected_or_t<void, Point_of_kernel_of, Item>>::value;

// Returns the double that equals a number of an arithmetic type, or throws.
template <class Number>
double double_of(Number x, const char* what = "coordinate",
                 const char* remedy = "subtract an origin that is near the points")
{
  const double d = double(x);
  bool is_equal = true;
  if constexpr (std::is_floating_point<Number>::value)
    is_equal =
        Number(d) == x || !(x == x) || !is_finite_number(d); // these are refused with their place
  else if constexpr (std::numeric_limits<Number>::digits > 53)
    is_equal = d < double((std::numeric_limits<Number>::max)()) && Number(d) == x;
  if (!is_equal)
    throw Surface_input_error(std::string("a ") + what + " is not a double: " + std::to_string(x) +
                              "; remedy: " + remedy);
  return d;
}

// Converts a point if kernels differ. A point of the same or a convertible type is taken as it is.
// Any other goes through Cartesian_converter, exactly if the target's numbers can hold it, and
// otherwise by to_double(). Coordinates without a point are doubles, or refused. A point gets no
// weight that it does not bring.
template <class Point, class SourcePoint>
Point converted_point(const SourcePoint& p)
{
  constexpr bool needs_weight = has_weight<Point>;
  constexpr bool is_convertible = std::is_convertible<const SourcePoint&, Point>::value;
  constexpr bool is_served = is_convertible || (needs_weight ? has_weight<SourcePoint>
                                                             : is_point_of_kernel<SourcePoint> ||
                                                                   has_coordinates<SourcePoint>);
  static_assert(is_served || !needs_weight,
                "points with weights are the Weighted_point_3 of a kernel; other items need a "
                "point_map");
  static_assert(is_served || needs_weight,
                "points are those of a kernel, or have coordinates p[0], p[1] and p[2]; "
                "other items need a point_map, those of a Point_set_3 its own");
  if constexpr (is_convertible)
    return p;
  else if constexpr (has_coordinates<SourcePoint> && !needs_weight)
    return Point(double_of(p[0]), double_of(p[1]), double_of(p[2]));
  else if constexpr (is_served)
    return Cartesian_converter<typename Kernel_traits<SourcePoint>::Kernel,
                               typename Kernel_traits<Point>::Kernel>()(p);
  else
    return Point(ORIGIN);
}

// Works for exact numbers too: an interval around a finite number has a finite end, and no NaN.
inline bool holds_finite_number(const std::pair<double, double>& interval)
{
  return interval.first <= (std::numeric_limits<double>::max)() &&
         interval.second >= std::numeric_limits<double>::lowest();
}

template <class Point>
void check_point(const Point& p, std::size_t i)
{
  const Coordinate_intervals intervals = coordinate_intervals(p);
  for (std::size_t c = 0; c < 3; ++c)
    if (!holds_finite_number(intervals[c]))
      throw Surface_input_error("vertex " + std::to_string(i) + ": its " + "xyz"[c] +
                                " coordinate is not a finite number");
  if constexpr (has_weight<Point>)
    if (const auto weight = CGAL::to_interval(p.weight()); !holds_finite_number(weight))
      throw Surface_input_error("vertex " + std::to_string(i) + ": its weight is " +
                                std::to_string(weight.first) + ", not a finite number");
}

// Returns the weight of point i as a double, or throws. Other than arithmetic types are rounded.
template <class Weight>
double double_of_weight(const Weight& weight, std::size_t i)
{
  double w;
  if constexpr (std::is_arithmetic<Weight>::value)
    w = double_of(weight, "weight", "subtract the same number from all");
  else
    w = equal_double(weight).value_or(CGAL::to_double(weight));
  if (!is_finite_number(w))
    throw Surface_input_error("vertex " + std::to_string(i) + ": its weight is " +
                              std::to_string(w) + ", not a finite number");
  return w;
}

// Appends p, converted and checked.
template <class Point, class SourcePoint>
void append_checked(const SourcePoint& p, std::vector<Point>& points)
{
  points.push_back(converted_point<Point>(p));
  check_point(points.back(), points.size() - 1);
}

// Reserves room for all items, if their number is known.
template <class T, class Range>
void reserve_for(const Range& items, std::vector<T>& into)
{
  using Iterator = decltype(std::begin(items));
  using Category = typename std::iterator_traits<Iterator>::iterator_category;
  if constexpr (std::is_convertible<Category, std::forward_iterator_tag>::value)
    into.reserve(std::size_t(std::distance(std::begin(items), std::end(items))));
}

// Returns the points of `items`, converted and checked. A range is read once.
template <class Point, class Range, class PointMap>
std::vector<Point> read_points(const Range& items, const PointMap& point_map)
{
  std::vector<Point> points;
  reserve_for(items, points);
  for (auto&& item : items)
    append_checked(get(point_map, item), points);
  return points;
}

constexpr std::size_t no_index = std::size_t(-1);

// Maps the vertices of a graph to the numbers 0, …, n - 1. The user's index map must tell them
// apart, but need not be dense, as it is not for a mesh with removed vertices. These have no number.
template <class VertexIndexMap>
class Dense_index_map
{
public:
  using key_type = typename boost::property_traits<VertexIndexMap>::key_type;
  using value_type = std::size_t;
  using reference = std::size_t;
  using category = boost::readable_property_map_tag;

  Dense_index_map(VertexIndexMap sparse, const std::vector<std::size_t>& dense)
    : m_sparse(sparse)
    , m_dense(&dense)
  {
  }

  friend std::size_t get(const Dense_index_map& map, const key_type& v)
  {
    const auto index = std::size_t(get(map.m_sparse, v));
    return index < map.m_dense->size() ? (*map.m_dense)[index] : no_index;
  }

private:
  VertexIndexMap m_sparse;
  const std::vector<std::size_t>* m_dense;
};

// Returns the position of v in `vertices` by the index of v, which must be less than `bound`.
template <class VertexRange, class VertexIndexMap>
std::vector<std::size_t> dense_indices(const VertexRange& vertices, VertexIndexMap index_map,
                                       std::size_t bound)
{
  std::vector<std::size_t> dense(
      std::size_t(std::distance(std::begin(vertices), std::end(vertices))), no_index);
  std::size_t position = 0;
  for (const auto& v : vertices) {
    const auto index = get(index_map, v);
    if (index < decltype(index)(0))
      throw Surface_input_error("vertex " + std::to_string(position) + ": its index is negative");
    if (std::size_t(index) >= bound)
      throw Surface_input_error("vertex " + std::to_string(position) + ": its index " +
                                std::to_string(index) + " is too large");
    if (std::size_t(index) >= dense.size())
      dense.resize((std::max)(std::size_t(index) + 1, 2 * dense.size()), no_index);
    std::size_t& number = dense[std::size_t(index)];
    if (number != no_index)
      throw Surface_input_error("vertices " + std::to_string(number) + " and " +
                                std::to_string(position) + " have the same index " +
                                std::to_string(index));
    number = position++;
  }
  return dense;
}

// Throws unless the vertices of `graph` have the indices 0, …, n - 1.
template <class Graph, class VertexIndexMap>
void check_indices(const Graph& graph, VertexIndexMap index_map, std::size_t n)
{
  const auto range = vertices(graph);
  const auto count = std::size_t(std::distance(range.first, range.second));
  if (count != n)
    throw Surface_input_error("the graph has " + std::to_string(count) +
                              " vertices, but there are " + std::to_string(n) + " points");
  // n different indices less than n are all of them.
  dense_indices(make_range(range.first, range.second), index_map, n);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_SURFACE_INPUT_H
