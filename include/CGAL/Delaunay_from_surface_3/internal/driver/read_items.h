// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_READ_ITEMS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_READ_ITEMS_H

// What a range of points may be made of: points, pairs of points and infos, or what a point_map
// turns into points.

#include <CGAL/Delaunay_from_surface_3/internal/driver/check_named_parameters.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/give_to_vertices.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/surface_input.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <boost/tuple/tuple.hpp>

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// The items that bring an info with their point, as they may for CGAL's own insertion: pairs, and
// tuples of two, which boost::zip_iterator makes.
template <class Item>
struct Point_and_info : std::false_type
{
};
template <class Point, class Info_>
struct Point_and_info<std::pair<Point, Info_>> : std::true_type
{
  using Info = std::decay_t<Info_>;
  static const auto& point(const std::pair<Point, Info_>& pair) { return pair.first; }
  static const auto& info(const std::pair<Point, Info_>& pair) { return pair.second; }
};
template <class Point, class Info_>
using Cons = boost::tuples::cons<Point, boost::tuples::cons<Info_, boost::tuples::null_type>>;
template <class Point, class Info_>
struct Point_and_info<Cons<Point, Info_>> : std::true_type
{
  using Info = std::decay_t<Info_>;
  static const auto& point(const Cons<Point, Info_>& tuple) { return boost::tuples::get<0>(tuple); }
  static const auto& info(const Cons<Point, Info_>& tuple) { return boost::tuples::get<1>(tuple); }
};
template <class Point, class Info_>
struct Point_and_info<boost::tuples::tuple<Point, Info_>> : Point_and_info<Cons<Point, Info_>>
{
};

// Makes room for all items, if it can be seen how many there are.
template <class T, class Range>
void reserve_for(const Range& items, std::vector<T>& into)
{
  using Iterator = decltype(std::begin(items));
  using Category = typename std::iterator_traits<Iterator>::iterator_category;
  if constexpr (std::is_convertible<Category, std::forward_iterator_tag>::value)
    into.reserve(std::size_t(std::distance(std::begin(items), std::end(items))));
}

// Reads the items once, and calls use(points, infos).
template <class Triangulation, class Range, class NamedParameters, class Use>
std::ptrdiff_t with_points_and_infos(const Triangulation&, const Range& items,
                                     const NamedParameters& np, const Use& use)
{
  using Point = typename Triangulation::Point;
  using Item = typename std::iterator_traits<decltype(std::begin(items))>::value_type;
  std::vector<Point> points;
  reserve_for(items, points);
  if constexpr (is_given<NamedParameters, internal_np::point_t> || !Point_and_info<Item>::value) {
    const auto point_map = parameters::choose_parameter(
        parameters::get_parameter(np, internal_np::point_map), Identity_property_map<const Item>());
    for (auto&& item : items)
      append_checked(get(point_map, item), points);
    return use(points, No_infos());
  } else {
    using Read = Point_and_info<Item>;
    std::vector<typename Read::Info> infos;
    using Infos = Infos_in_order<decltype(infos.cbegin())>;
    if constexpr (check_infos<typename Triangulation::Vertex, Infos>()) {
      reserve_for(items, infos);
      for (auto&& item : items) {
        append_checked(Read::point(item), points);
        infos.push_back(Read::info(item));
      }
      return use(points, Infos{infos.cbegin()});
    } else {
      return 0; // what was said does not compile
    }
  }
}

// The name of a point of a range is its index.
struct Identity_name
{
  std::size_t operator()(std::size_t i) const { return i; }
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_READ_ITEMS_H
