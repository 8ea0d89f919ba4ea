// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_READ_ITEMS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_READ_ITEMS_H

// What a range of points may be made of: points, pairs of points and infos, or what a point_map
// turns into points.

#include <CGAL/Delaunay_from_surface_3/door/check_named_parameters.h>
#include <CGAL/Delaunay_from_surface_3/door/give_to_vertices.h>
#include <CGAL/Delaunay_from_surface_3/door/surface_input.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/is_detected.h>

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
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

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

template <class Iterator>
using Category_of_iterator = typename std::iterator_traits<Iterator>::iterator_category;

template <class Iterator>
constexpr bool is_iterator = is_detected<Category_of_iterator, Iterator>;

// The points of a range, checked, and the infos that came with them. A range is read once.
template <class Triangulation, class Range, class NamedParameters>
class Read_items
{
  using Point = typename Triangulation::Point;
  using Item =
      typename std::iterator_traits<decltype(std::begin(std::declval<const Range&>()))>::value_type;
  static constexpr bool has_infos =
      Point_and_info<Item>::value && !is_given<NamedParameters, internal_np::point_t>;
  struct No_info
  {
    using Info = char;
  };
  using Read = std::conditional_t<has_infos, Point_and_info<Item>, No_info>;

public:
  Read_items(const Range& items, const NamedParameters& np)
  {
    if constexpr (has_infos)
      read_pairs(items);
    else
      m_points = read_points<Point>(
          items, parameters::choose_parameter(parameters::get_parameter(np, internal_np::point_map),
                                              Identity_property_map<const Item>()));
  }

  const std::vector<Point>& points() const { return m_points; }

  // By the index of the point.
  auto infos() const
  {
    if constexpr (has_infos)
      return Infos{m_infos.cbegin()};
    else
      return No_infos();
  }

private:
  using Infos = Infos_in_order<typename std::vector<typename Read::Info>::const_iterator>;

  void read_pairs(const Range& items)
  {
    if constexpr (check_infos<typename Triangulation::Vertex, Infos>()) {
      reserve_for(items, m_points);
      reserve_for(items, m_infos);
      for (auto&& item : items) {
        append_checked(Read::point(item), m_points);
        m_infos.push_back(Read::info(item));
      }
    }
  }

  std::vector<Point> m_points;
  std::vector<typename Read::Info> m_infos;
};

// The name of a point of a range is its index.
struct Identity_name
{
  std::size_t operator()(std::size_t i) const { return i; }
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_READ_ITEMS_H
