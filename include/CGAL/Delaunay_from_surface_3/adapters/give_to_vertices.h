// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_GIVE_TO_VERTICES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_GIVE_TO_VERTICES_H

// Sets the infos of the vertices in the triangulation, and writes the caller's output.
//
// Here `vertices` are handles by input index, null for a point that is not inserted. Of equal
// points, the one with the smallest index decides: it overwrites what larger ones gave.

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/adapters/check_named_parameters.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/vertex_info.h>

#include <boost/property_map/property_map.hpp>

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

// Infos are functions from the index of a point to its info, or there are no infos.
struct No_infos
{
};

template <class Iterator>
struct Infos_in_order
{
  Iterator first;
  decltype(auto) operator()(std::size_t i) const
  {
    return first[typename std::iterator_traits<Iterator>::difference_type(i)];
  }
};

// Returns infos by value: a map may return a reference to its key, as Identity_property_map does,
// and the key does not outlive the call.
template <class InfoMap, class NameOf>
struct Infos_of_map
{
  InfoMap map;
  const NameOf& name_of;
  auto operator()(std::size_t i) const
  {
    using boost::get; // of a pointer
    return get(map, name_of(i));
  }
};

template <class InfoRange>
void check_number_of_infos(const InfoRange& infos, std::size_t number_of_points)
{
  const auto count = std::size_t(std::distance(std::begin(infos), std::end(infos)));
  if (count != number_of_points)
    throw Surface_input_error("there are " + std::to_string(count) + " infos for " +
                              std::to_string(number_of_points) + " points");
}

// Returns the infos of the named parameters, or else the ones that came with the points.
template <class NamedParameters, class NameOf, class Infos>
auto infos_of_caller(const NamedParameters& np, const NameOf& name_of, const Infos& of_points,
                     std::size_t number_of_points)
{
  constexpr bool has_map = is_given<NamedParameters, Vertex_info_map_tag>;
  constexpr bool has_range = is_given<NamedParameters, Vertex_info_range_tag>;
  static_assert(int(has_map) + int(has_range) + int(!std::is_same<Infos, No_infos>::value) <= 1,
                "infos are given twice");
  if constexpr (has_map) {
    auto map = parameters::get_parameter(np, vertex_info_map_tag);
    return Infos_of_map<decltype(map), NameOf>{map, name_of};
  } else if constexpr (has_range) {
    const auto* const range = parameters::get_parameter(np, vertex_info_range_tag);
    check_number_of_infos(*range, number_of_points);
    return Infos_in_order<decltype(std::begin(*range))>{std::begin(*range)};
  } else {
    (void)name_of, (void)number_of_points;
    return of_points;
  }
}

template <class Vertex>
using Info_of = decltype(std::declval<Vertex&>().info());

template <class Vertex>
constexpr bool has_info = is_detected<Info_of, Vertex>;

// Returns true if vertices can get these infos. If not, that is one error.
template <class Vertex, class Infos>
constexpr bool check_infos()
{
  if constexpr (std::is_same<Infos, No_infos>::value) {
    return false;
  } else if constexpr (!has_info<Vertex>) {
    static_assert(
        has_info<Vertex>,
        "infos need a vertex base with info, as Triangulation_vertex_base_with_info_3; for pairs "
        "whose second item is no info, give a point_map");
    return false;
  } else {
    using Info = decltype(std::declval<Vertex&>().info());
    using Given = decltype(std::declval<const Infos&>()(std::size_t()));
    static_assert(std::is_assignable<Info, Given>::value,
                  "these infos cannot be assigned to the info of the vertex base");
    return std::is_assignable<Info, Given>::value;
  }
}

template <class Vertex_handle, class Infos>
void give_infos(const std::vector<Vertex_handle>& vertices, const Infos& infos)
{
  using Vertex = std::decay_t<decltype(*std::declval<Vertex_handle>())>;
  if constexpr (check_infos<Vertex, Infos>())
    for (std::size_t i = vertices.size(); i-- > 0;)
      if (vertices[i] != Vertex_handle())
        vertices[i]->info() = infos(i);
}

// Sets the points, since equal ones may still differ, as 0 and -0 do.
template <class Vertex_handle, class Point>
void give_points(const std::vector<Vertex_handle>& vertices, const std::vector<Point>& points)
{
  for (std::size_t i = vertices.size(); i-- > 0;)
    if (vertices[i] != Vertex_handle())
      vertices[i]->set_point(points[i]);
}

// Writes the pairs of names and handles to an output iterator, or calls a callable with each: as
// two arguments, or as one pair. Null handles are written if `writes_null`.
template <bool writes_null, class Vertex_handle, class NameOf, class Output>
void write_vertices(const std::vector<Vertex_handle>& vertices, const NameOf& name_of, Output out)
{
  using Name = std::decay_t<decltype(name_of(std::size_t()))>;
  using Pair = std::pair<Name, Vertex_handle>;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (writes_null || vertices[i] != Vertex_handle()) {
      if constexpr (std::is_invocable<Output&, Name, Vertex_handle>::value)
        out(name_of(i), vertices[i]);
      else if constexpr (std::is_invocable<Output&, Pair>::value)
        out(Pair(name_of(i), vertices[i]));
      else
        *out++ = Pair(name_of(i), vertices[i]);
    }
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_GIVE_TO_VERTICES_H
