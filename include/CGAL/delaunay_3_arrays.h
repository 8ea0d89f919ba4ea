// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_3_ARRAYS_H
#define CGAL_DELAUNAY_3_ARRAYS_H

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/arrays/arrays_of_built.h>
#include <CGAL/Delaunay_from_surface_3/core/build.h>
#include <CGAL/Delaunay_from_surface_3/adapters/Executor_by_tag.h>
#include <CGAL/Delaunay_from_surface_3/adapters/Read_coordinates.h>
#include <CGAL/Delaunay_from_surface_3/adapters/Visitor_observer.h>
#include <CGAL/Delaunay_from_surface_3/adapters/check_named_parameters.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/soup_edges.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// What arrays ask of the core for n points: options, and an observer that tells the caller's visitor.
template <class NamedParameters>
class Call_of_core
{
  static decltype(auto) visitor_in(const NamedParameters& np, std::size_t n)
  {
    check_named_parameters<internal_np::point_t, internal_np::random_seed_t,
                           internal_np::visitor_t>(np);
    return visitor_of_caller(parameters::choose_parameter<Default_surface_insertion_visitor_3>(
                                 parameters::get_parameter(np, internal_np::visitor)),
                             n);
  }

  using Kept_visitor = decltype(visitor_in(std::declval<const NamedParameters&>(), 0));
  Kept_visitor m_visitor;
  const Rounding_to_nearest m_rounding;

public:
  Call_of_core(std::size_t n, const Build_options& chosen,
               const std::optional<std::string>& irregularity, const NamedParameters& np)
    : m_visitor(visitor_in(np, n))
    , options(chosen)
    , observer(m_visitor, m_rounding)
  {
    if (const char* const obstacle = obstacle_of_core())
      throw std::runtime_error(std::string("arrays would be slow to make, or not exact: ") +
                               obstacle);
    if (irregularity)
      observer.notice(Surface_insertion_notice::SURFACE_IS_IRREGULAR, *irregularity);
    options.seed = static_cast<unsigned int>(
        parameters::choose_parameter(parameters::get_parameter(np, internal_np::random_seed), 0));
  }

  Build_options options;
  Visitor_observer<std::remove_reference_t<Kept_visitor>> observer;
};

// Makes arrays of the points, by the core: in the order `kept`, if one is given, and else in its own.
// A source with weights calls for build_regular.h.
template <class Index, class Source, class Executor, class NamedParameters>
Delaunay_3_arrays<Index> insert_into_arrays(Source& points, Insertion_order* kept,
                                            const std::optional<std::string>& irregularity,
                                            const Executor& executor, const NamedParameters& np,
                                            Build_options options = Build_options())
{
  using Phase = Surface_insertion_phase;
  static_assert(std::is_same<Index, std::int32_t>::value,
                "indices are std::int32_t: for more points use delaunay_3_tiles()");
  options.adds_apex = true;
  Call_of_core<NamedParameters> call(points.points().size(), options, irregularity, np);
  auto& observer = call.observer;
  const auto built = kept == nullptr ? build(points, call.options, observer, executor)
                                     : build_again(*kept, points, call.options, observer, executor);
  if (built->outcome == Insertion_outcome::FLAT) { // on one line: they are sorted at once
    observer.phase_begins(Phase::INSERTION, 1);
    if (points.points().size() > 0 && !observer.go_further(0)) {
      built->outcome = Insertion_outcome::STOPPED;
    } else {
      observer.insertion_ends(static_cast<const Insertion_counts&>(built->counts));
      observer.phase_begins(Phase::FINISH);
    }
  }
  auto arrays = arrays_of_built<Index>(*built, points, executor);
  observer.phase_begins(Phase::DONE);
  return arrays;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3

/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {
/// \endcond

/*!
\ingroup PkgDelaunayFromSurface3Arrays

returns the Delaunay triangulation of points as arrays of numbers. Its cells are those of a
`Delaunay_triangulation_3<Exact_predicates_inexact_constructions_kernel>` after `insert(first,
last)`. No %CGAL triangulation is built, even if the points lie in a plane or on a line.

<b>Complexity</b>: expected \f$O(n \log n)\f$ for the order of n points, plus the insertions.

<b>Memory</b>: about 270 bytes per point at the peak, including the arrays but not `points`, if there
are 6.8 cells per point, as for random points in space.

\tparam Index `std::int32_t`: up to \f$2^{30}\f$ cells, or 150 million points
\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`. With
`Parallel_tag`, which requires TBB, many threads insert, as with `insert_points_3()`; the numbers of
the cells then differ from run to run.
\tparam PointRange a range of points of any kernel, of `std::array<double, 3>`, pointers to three
numbers, or anything with coordinates `p[0]`, `p[1]`, `p[2]`; or of items that `point_map` maps
to points. It is traversed more than once.
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the points
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
below; any other does not compile

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{maps the items of `points` to points}
    \cgalParamType{a model of `ReadablePropertyMap` from the items to points of any kernel;
      coordinates that are not of type `double` are converted as in `insert_surface_vertices_3()`}
    \cgalParamDefault{the items themselves}
  \cgalParamNEnd
  \cgalParamNBegin{random_seed}
    \cgalParamDescription{the seed of the insertion order, which also determines the numbers of the
      cells. It has an effect only if the budget of the order is exceeded.}
    \cgalParamType{unsigned int}
    \cgalParamDefault{0}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is told about the progress, and can stop the work; the arrays are then
      empty. It is copied unless it is passed by `std::ref()`.}
    \cgalParamType{a model of `SurfaceInsertionVisitor_3`, or a callable as for
      `insert_points_3()`}
    \cgalParamDefault{`Default_surface_insertion_visitor_3`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the triangulation; after a stop, one without points and cells

\throws Surface_input_error if a coordinate is not a finite number
\throws std::length_error if there are more than \f$2^{30}\f$ cells
\throws std::runtime_error if the core is compiled with `-ffast-math`, `-Ofast` or parts of them, or
if denormal numbers are flushed to zero in a mode that cannot be switched off

Example: \ref Delaunay_from_surface_3/arrays_and_inside.cpp

\sa `insert_points_3()`
*/
template <class Index = std::int32_t, class ConcurrencyTag = Sequential_tag, class PointRange,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Delaunay_3_arrays<Index> delaunay_3_arrays(const PointRange& points,
                                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  using namespace Delaunay_from_surface_3::internal;
  Read_coordinates<PointRange, CGAL_NP_CLASS> read(points, np);
  return insert_into_arrays<Index>(read, nullptr, std::nullopt,
                                   typename Executor_of_tag<ConcurrencyTag>::type(), np);
}

/*!
\ingroup PkgDelaunayFromSurface3Arrays

does the same for the points of a polygon soup. The faces are checked, and the visitor is told what
they are like; they have no effect on the order.

\param points the points, including those in no face
\param faces a range of ranges of integers: for each face the indices of its points, in order
\param np as above

\throws Surface_input_error also if a face has an index out of range

\sa `insert_points_3()`
*/
template <class Index = std::int32_t, class ConcurrencyTag = Sequential_tag, class PointRange,
          class FaceRange, typename CGAL_NP_TEMPLATE_PARAMETERS>
Delaunay_3_arrays<Index> delaunay_3_arrays(const PointRange& points, const FaceRange& faces,
                                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  using namespace Delaunay_from_surface_3::internal;
  const typename Executor_of_tag<ConcurrencyTag>::type executor{};
  Read_coordinates<PointRange, CGAL_NP_CLASS> read(points, np);
  std::optional<std::string> irregularity;
  if constexpr (is_given<CGAL_NP_CLASS, internal_np::visitor_t>)
    irregularity = soup_edges(faces, read.size(), executor).irregularity;
  else
    check_faces(faces, read.size());
  return insert_into_arrays<Index>(read, nullptr, irregularity, executor, np);
}

/*!
\ingroup PkgDelaunayFromSurface3Arrays

does the same for points that move a little from call to call, in the order of insertion of the
last call.

\code{.cpp}
CGAL::Delaunay_from_surface_3::Insertion_order order; // empty at first
for (int step = 0; step < 20; ++step) {
  move(points);
  const auto arrays = CGAL::delaunay_3_arrays(points, order);
}
\endcode

\param points the points
\param order the order of the last call, and after this call the order that it used. If it has another
number of points (as an empty one has), or has become too costly, a new order is made and stored; it is
empty if an exception is thrown meanwhile, or if the points lie on a line. The order affects only the
numbering of the cells and the running time. It takes 16 bytes per point.
\param np as above

\throws Surface_input_error also if `order` is not a valid order
*/
template <class Index = std::int32_t, class ConcurrencyTag = Sequential_tag, class PointRange,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Delaunay_3_arrays<Index> delaunay_3_arrays(const PointRange& points,
                                           Delaunay_from_surface_3::Insertion_order& order,
                                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  using namespace Delaunay_from_surface_3::internal;
  Read_coordinates<PointRange, CGAL_NP_CLASS> read(points, np);
  return insert_into_arrays<Index>(read, &order, std::nullopt,
                                   typename Executor_of_tag<ConcurrencyTag>::type(), np);
}

/// \cond SKIP_IN_MANUAL
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond

} // namespace CGAL

#endif // CGAL_DELAUNAY_3_ARRAYS_H
