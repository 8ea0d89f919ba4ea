// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_3_ARRAYS_H
#define CGAL_DELAUNAY_3_ARRAYS_H

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/check_named_parameters.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/insert_into_arrays.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/insert_surface.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/soup_graph.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/surface_input.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/visitor_of_caller.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/with_concurrency.h>
#include <CGAL/Delaunay_from_surface_3/internal/plan/Lower_neighbor_graph.h>
#include <CGAL/Point_insertion_traits_3.h>
#include <CGAL/Surface_insertion_traits_3.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// From anything with coordinates [0], [1] and [2] that are numbers of C++, or a point of any
// kernel.
template <class Item>
struct Coordinates_map
{
  using key_type = Item;
  using value_type = Array_point;
  using reference = Array_point;
  using category = boost::readable_property_map_tag;

  friend Array_point get(const Coordinates_map&, const Item& item)
  {
    if constexpr (std::is_convertible<const Item&, Array_point>::value)
      return item;
    else if constexpr (std::is_arithmetic<std::decay_t<decltype(item[0])>>::value)
      return Array_point(double(item[0]), double(item[1]), double(item[2]));
    else
      return converted_point<Array_point>(item);
  }
};

// The named parameters of both forms.
template <class Traits, class ConcurrencyTag, class Index, class PointRange, class MakeOrder,
          class NamedParameters>
Delaunay_3_arrays<Index> arrays_of_points(const PointRange& points, const MakeOrder& make_order,
                                          const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Item = typename std::iterator_traits<decltype(std::begin(points))>::value_type;

  const auto point_map =
      choose_parameter(get_parameter(np, internal_np::point_map), Coordinates_map<Item>());
  const auto seed =
      static_cast<unsigned int>(choose_parameter(get_parameter(np, internal_np::random_seed), 0));
  check_named_parameters<internal_np::point_t, internal_np::random_seed_t, internal_np::visitor_t>(
      np);
  auto&& visitor =
      visitor_of_caller(choose_parameter<Default_surface_insertion_visitor_3>(
                            get_parameter(np, internal_np::visitor)),
                        std::size_t(std::distance(std::begin(points), std::end(points))));
  using Visitor = std::remove_reference_t<decltype(visitor)>;
  static_assert(!accepts_points<Visitor, Array_point>(),
                "delaunay_3_arrays() leaves no point out: its visitor has no accept()");

  const Rounding_to_nearest rounding;
  Visitor_in_mode_of_caller<Visitor> observer(visitor, rounding);
  return arrays_by_plan<Traits, typename Executor_of_tag<ConcurrencyTag>::type, Index>(
      [&] { return read_points<Array_point>(points, point_map); },
      Traits().insertion_plan_object(seed),
      [&](const auto& read, const auto& plan) { return make_order(read, plan, observer); },
      observer);
}

} // namespace internal
} // namespace Delaunay_from_surface_3

/*!
\ingroup PkgDelaunayFromSurface3Arrays

returns the Delaunay triangulation of points as arrays of numbers: its cells are those of a
`Delaunay_triangulation_3<Exact_predicates_inexact_constructions_kernel>` after `insert(first,
last)`. No triangulation of CGAL's is made, also where the points lie in a plane or on a line.

<b>Complexity</b>: expected \f$O(n \log n)\f$ for the order of n points, plus the insertions.

<b>Memory</b>, at the peak and beyond `points`: about 270 bytes per point where a point has 6.8
cells, as points in space have; those of the arrays included.

\tparam Index `std::int32_t`: up to \f$2^{30}\f$ cells, or 150 million points; `std::int64_t`: any
\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`. With
`Parallel_tag`, which needs TBB, many threads insert, as with `insert_points_3()`; the numbers of
the cells then differ from run to run.
\tparam PointRange a range of points of any kernel, of `std::array<double, 3>`, pointers to three
numbers, or anything with coordinates `p[0]`, `p[1]`, `p[2]`; or of items that `point_map` turns
into points. It is passed through more than once.
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the points
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
below

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{the points of the items of `points`}
    \cgalParamType{a model of `ReadablePropertyMap` from the items to points of any kernel; what is
      no `double` is converted as `insert_surface_vertices_3()` does it}
    \cgalParamDefault{the items themselves}
  \cgalParamNEnd
  \cgalParamNBegin{random_seed}
    \cgalParamDescription{the seed of the insertion order; it decides the numbers of the cells, too}
    \cgalParamType{unsigned int}
    \cgalParamDefault{0}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is told what is going on, and can stop it: the arrays are then empty. It
      is copied unless it is passed by `std::ref()`}
    \cgalParamType{a model of `SurfaceInsertionVisitor_3` without `accept()`, or a callable as that
      of `insert_points_3()`}
    \cgalParamDefault{`Default_surface_insertion_visitor_3`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws Surface_input_error if a coordinate is not a finite number
\throws std::length_error if there are more cells than `Index` can number

\sa `insert_points_3()`
*/
template <class Index = std::int32_t, class ConcurrencyTag = Sequential_tag, class PointRange,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Delaunay_3_arrays<Index> delaunay_3_arrays(const PointRange& points,
                                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  using Traits = Point_insertion_traits_3;
  return Delaunay_from_surface_3::internal::arrays_of_points<Traits, ConcurrencyTag, Index>(
      points,
      [](const auto& read, const auto& plan, const auto&) {
        using Triangulation = Delaunay_from_surface_3::internal::Array_triangulation;
        const Delaunay_from_surface_3::internal::Lower_neighbor_graph
            no_graph; // nor is one looked at
        return plan(read, Triangulation::Geom_traits(), no_graph,
                    Delaunay_from_surface_3::internal::Identity_index_map());
      },
      np);
}

/*!
\ingroup PkgDelaunayFromSurface3Arrays

does the same for the points of a polygon soup, whose faces show which points are near each other.
The order is that of `insert_surface_points_3()` with its default traits.

\param points the points, those in no face included
\param faces the faces: a range of ranges of integers, for each the indices of its points in order
\param np as above

\throws Surface_input_error also if a face has an index out of range

\sa `insert_surface_points_3()`
*/
template <class Index = std::int32_t, class ConcurrencyTag = Sequential_tag, class PointRange,
          class FaceRange, typename CGAL_NP_TEMPLATE_PARAMETERS>
Delaunay_3_arrays<Index> delaunay_3_arrays(const PointRange& points, const FaceRange& faces,
                                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  using Traits = Surface_insertion_traits_3;
  if (std::begin(faces) == std::end(faces))
    return delaunay_3_arrays<Index, ConcurrencyTag>(points, np);
  return Delaunay_from_surface_3::internal::arrays_of_points<Traits, ConcurrencyTag, Index>(
      points,
      [&](const auto& read, const auto& plan, auto& visitor) {
        using namespace Delaunay_from_surface_3::internal;
        const typename Executor_of_tag<ConcurrencyTag>::type executor{};
        const Soup_graph soup = soup_graph(faces, read.size(), executor);
        if (soup.irregularity)
          visitor.surface_is_irregular(*soup.irregularity);
        return make_order(executor, plan, read, Array_triangulation::Geom_traits(), soup.graph,
                          Identity_index_map());
      },
      np);
}

} // namespace CGAL

#endif // CGAL_DELAUNAY_3_ARRAYS_H
