// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INSERT_POINTS_3_H
#define CGAL_INSERT_POINTS_3_H

#include <CGAL/Delaunay_from_surface_3/internal/driver/insert_surface.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/surface_input.h>
#include <CGAL/Point_insertion_traits_3.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <boost/graph/adjacency_list.hpp>

#include <cstddef>
#include <iterator>
#include <optional>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Ref

inserts points into a Delaunay triangulation. The result equals what `tr.insert(first, last)` makes of
them. What holds after refused input, a stop or an exception is what `insert_surface_vertices_3()` says.

<b>Complexity</b>: O(n log n) expected for the order of n points, plus what the insertions take.

\tparam Gt,Tds,Lp,Slds the parameters of `Delaunay_triangulation_3`; any are served. `Parallel_tag`
is served sequentially. `Gt` must have exact predicates.
\tparam PointRange a range of points, or of items that `point_map` turns into points
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tr the triangulation into which the points are inserted
\param points the points
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
below

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{the points of the items of `points`}
    \cgalParamType{a model of `ReadablePropertyMap` from the items to the points of `tr`, to a type
      convertible to it, or to the points of another kernel, which are converted as
      `insert_surface_vertices_3()` does it}
    \cgalParamDefault{`CGAL::Identity_property_map`}
  \cgalParamNEnd
  \cgalParamNBegin{random_seed}
    \cgalParamDescription{the seed of the insertion order; the same seed gives the same insertions}
    \cgalParamType{unsigned int}
    \cgalParamDefault{0}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is told what is going on, and can stop it; it is copied unless it is
      passed by `std::ref()`}
    \cgalParamType{a model of `SurfaceInsertionVisitor_3`}
    \cgalParamDefault{`Default_surface_insertion_visitor_3`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_to_vertex_output_iterator}
    \cgalParamDescription{receives a pair for every point inserted: its index and its handle in
      `tr`. It is otherwise that of `insert_surface_vertices_3()`.}
    \cgalParamType{a model of `OutputIterator` accepting `std::pair<std::size_t, Vertex_handle>`}
    \cgalParamDefault{`Emptyset_iterator`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the number of vertices that `tr` has gained; 0 after a stop if it was empty

\throws Surface_input_error if a coordinate is not a finite number; `tr` is then unchanged

\sa `insert_points_along_graph_3()`
\sa `Point_insertion_traits_3`
*/
template <class Gt, class Tds, class Lp, class Slds, class PointRange,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
std::ptrdiff_t insert_points_3(Delaunay_triangulation_3<Gt, Tds, Lp, Slds>& tr,
                               const PointRange& points,
                               const CGAL_NP_CLASS& np = parameters::default_values())
{
  using namespace Delaunay_from_surface_3::internal;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Point = typename Delaunay_triangulation_3<Gt, Tds, Lp, Slds>::Point;
  using Item = typename std::iterator_traits<decltype(std::begin(points))>::value_type;

  const auto point_map = choose_parameter(get_parameter(np, internal_np::point_map),
                                          Identity_property_map<const Item>());
  const boost::adjacency_list<> no_graph; // the traits look at the points alone
  return insert_surface(tr, read_points<Point>(points, point_map), std::nullopt, no_graph,
                        get(boost::vertex_index, no_graph), Point_insertion_traits_3(), np,
                        [](std::size_t i) { return i; });
}

} // namespace CGAL

#endif // CGAL_INSERT_POINTS_3_H
