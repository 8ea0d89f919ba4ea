// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGULAR_3_ARRAYS_H
#define CGAL_REGULAR_3_ARRAYS_H

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/adapters/Executor_by_tag.h>
#include <CGAL/Delaunay_from_surface_3/adapters/Read_coordinates.h>
#include <CGAL/Delaunay_from_surface_3/core/build_regular.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/delaunay_3_arrays.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <boost/iterator/transform_iterator.hpp>

#include <cstdint>
#include <iterator>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Item>
using Point_in_item = decltype(std::declval<const Item&>().point());
template <class Item>
using Weight_of_item = decltype(std::declval<const Item&>().weight());

// True if the type has a point and a weight, as weighted points of a kernel have.
template <class Item>
constexpr bool is_weighted_point =
    is_detected<Point_in_item, Item>&& is_detected<Weight_of_item, Item>;

// Makes arrays as delaunay_3_arrays() does, with weights.
template <class Index, class ConcurrencyTag, class PointRange, class WeightRange,
          class NamedParameters>
Delaunay_3_arrays<Index> insert_weighted(const PointRange& points, const WeightRange& weights,
                                         Insertion_order* kept, const NamedParameters& np)
{
  Read_weighted_points<PointRange, WeightRange, NamedParameters> read(points, weights, np);
  const typename Executor_of_tag<ConcurrencyTag>::type executor{};
  return insert_into_arrays<Index>(read, kept, std::nullopt, executor, np);
}

// Does the same with the weights that the points have.
template <class Index, class ConcurrencyTag, class PointRange, class NamedParameters>
Delaunay_3_arrays<Index> insert_weighted(const PointRange& points, Insertion_order* kept,
                                         const NamedParameters& np)
{
  using Item = std::decay_t<decltype(*std::begin(points))>;
  const auto map = parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::point_map), Identity_property_map<const Item>());
  constexpr bool is_served =
      is_weighted_point<std::decay_t<decltype(get(map, *std::begin(points)))>>;
  static_assert(is_served, "weighted points have point() and weight(); points without weights need "
                           "a range of these as second argument");
  if constexpr (is_served) {
    const auto weight = [&map](const Item& item) { return get(map, item).weight(); };
    const auto weights = make_range(boost::make_transform_iterator(std::begin(points), weight),
                                    boost::make_transform_iterator(std::end(points), weight));
    return insert_weighted<Index, ConcurrencyTag>(
        points, weights, kept, np.point_map(Bare_point_map<std::decay_t<decltype(map)>>{map}));
  } else {
    return {};
  }
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3

/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {
/// \endcond

/*!
\ingroup PkgDelaunayFromSurface3Arrays

returns the regular triangulation of points with weights, which is also called weighted Delaunay
triangulation, as arrays of numbers. Its cells are those of a
`Regular_triangulation_3<Exact_predicates_inexact_constructions_kernel>` after `insert(first,
last)`. No %CGAL triangulation is built, even if the points lie in a plane or on a line.

A weight is the square of a ball's radius; only differences of weights matter, so they may be negative.
A point is <em>hidden</em> if the power cells of the others leave nothing of its own. Its vertex,
`Delaunay_3_arrays::vertex_of_point()`, is then `Delaunay_3_arrays::none`. Of several points at one
place, the one with the largest weight counts; if there are several of these, they share the vertex of
the one with the smallest index.

<b>Complexity</b>: as for `delaunay_3_arrays()`

<b>Memory</b>: 8 bytes per point more than `delaunay_3_arrays()`

\tparam Index,ConcurrencyTag,PointRange as for `delaunay_3_arrays()`
\tparam WeightRange a range of numbers. It is traversed more than once.
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the points
\param weights the weight of each point, in the order of the points. Those that equal no `double` are
rounded by `to_double()`, or refused if their type is arithmetic.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": those of
`delaunay_3_arrays()`

\return the triangulation; after a stop, one without points and cells

\throws Surface_input_error if a coordinate or a weight is not a finite number, or if there are not
as many weights as points
\throws std::length_error if there are more than \f$2^{30}\f$ cells
\throws std::runtime_error as `delaunay_3_arrays()`

Example: \ref Delaunay_from_surface_3/weighted_alpha_shape.cpp

\sa `delaunay_3_arrays()`
*/
template <class Index = std::int32_t, class ConcurrencyTag = Sequential_tag, class PointRange,
          class WeightRange, typename CGAL_NP_TEMPLATE_PARAMETERS>
Delaunay_3_arrays<Index> regular_3_arrays(const PointRange& points, const WeightRange& weights,
                                          const CGAL_NP_CLASS& np = parameters::default_values())
{
  using namespace Delaunay_from_surface_3::internal;
  return insert_weighted<Index, ConcurrencyTag>(points, weights, nullptr, np);
}

/// \ingroup PkgDelaunayFromSurface3Arrays
/// does the same for points that move, or weights that change, a little from call to call, in the
/// order of insertion of the last call, which is kept as by `delaunay_3_arrays()`.
template <class Index = std::int32_t, class ConcurrencyTag = Sequential_tag, class PointRange,
          class WeightRange, typename CGAL_NP_TEMPLATE_PARAMETERS>
Delaunay_3_arrays<Index> regular_3_arrays(const PointRange& points, const WeightRange& weights,
                                          Delaunay_from_surface_3::Insertion_order& order,
                                          const CGAL_NP_CLASS& np = parameters::default_values())
{
  using namespace Delaunay_from_surface_3::internal;
  return insert_weighted<Index, ConcurrencyTag>(points, weights, &order, np);
}

/// \ingroup PkgDelaunayFromSurface3Arrays
/// does the same for weighted points: of any kernel, other items with `point()` and `weight()`, or
/// items that `point_map` maps to such.
template <class Index = std::int32_t, class ConcurrencyTag = Sequential_tag, class PointRange,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Delaunay_3_arrays<Index> regular_3_arrays(const PointRange& points,
                                          const CGAL_NP_CLASS& np = parameters::default_values())
{
  using namespace Delaunay_from_surface_3::internal;
  return insert_weighted<Index, ConcurrencyTag>(points, nullptr, np);
}

/// \ingroup PkgDelaunayFromSurface3Arrays
/// does the same for weighted points that change a little from call to call.
template <class Index = std::int32_t, class ConcurrencyTag = Sequential_tag, class PointRange,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Delaunay_3_arrays<Index> regular_3_arrays(const PointRange& points,
                                          Delaunay_from_surface_3::Insertion_order& order,
                                          const CGAL_NP_CLASS& np = parameters::default_values())
{
  using namespace Delaunay_from_surface_3::internal;
  return insert_weighted<Index, ConcurrencyTag>(points, &order, np);
}

/// \cond SKIP_IN_MANUAL
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond

} // namespace CGAL

#endif // CGAL_REGULAR_3_ARRAYS_H
