// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INSERT_SURFACE_POINTS_3_H
#define CGAL_INSERT_SURFACE_POINTS_3_H

#include <CGAL/Delaunay_from_surface_3/internal/driver/insert_surface.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/soup_graph.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/surface_input.h>
#include <CGAL/Surface_insertion_traits_3.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Ref

inserts the points of a polygon soup into a Delaunay triangulation. The edges of the faces serve as
the surface; the faces may be polygons, overlap, be oriented at random, or have edges with many
faces. The result, and what holds after a stop or an exception, are those of
`insert_surface_vertices_3()`.

<b>Complexity</b>: that of the parts of the traits, plus O(n + m log m) for n points and m edges.

\tparam Gt,Tds,Lp,Slds the parameters of `Delaunay_triangulation_3`; any are served. `Parallel_tag`
is served sequentially. `Gt` must have exact predicates.
\tparam PointRange a range of points, or of items that `point_map` turns into points
\tparam FaceRange a range of ranges of integers
\tparam SurfaceInsertionTraits a model of `SurfaceInsertionTraits_3`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tr the triangulation into which the points are inserted
\param points the points, those in no face included
\param faces the faces: for each the indices of its points in order
\param traits order, subgraph, starting cells and insertion; `Surface_insertion_traits_3` if left
out
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

\throws Surface_input_error if a coordinate is not a finite number or a face has an index out of
range; `tr` is then unchanged

\sa `insert_surface_vertices_3()`
*/
template <class Gt, class Tds, class Lp, class Slds, class PointRange, class FaceRange,
          class SurfaceInsertionTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
std::ptrdiff_t insert_surface_points_3(Delaunay_triangulation_3<Gt, Tds, Lp, Slds>& tr,
                                       const PointRange& points, const FaceRange& faces,
                                       const SurfaceInsertionTraits& traits,
                                       const CGAL_NP_CLASS& np = parameters::default_values())
{
  using namespace Delaunay_from_surface_3::internal;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Point = typename Delaunay_triangulation_3<Gt, Tds, Lp, Slds>::Point;
  using Item = typename std::iterator_traits<decltype(std::begin(points))>::value_type;

  const auto point_map = choose_parameter(get_parameter(np, internal_np::point_map),
                                          Identity_property_map<const Item>());
  const std::vector<Point> converted = read_points<Point>(points, point_map);
  const Soup_graph soup = soup_graph(faces, converted.size());
  return insert_surface(tr, converted, soup.irregularity, soup.graph,
                        get(boost::vertex_index, soup.graph), traits, np,
                        [](std::size_t i) { return i; });
}

/// \ingroup PkgDelaunayFromSurface3Ref
/// does the same with the default traits, an object of `Surface_insertion_traits_3`.
template <class Gt, class Tds, class Lp, class Slds, class PointRange, class FaceRange,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
std::ptrdiff_t insert_surface_points_3(Delaunay_triangulation_3<Gt, Tds, Lp, Slds>& tr,
                                       const PointRange& points, const FaceRange& faces,
                                       const CGAL_NP_CLASS& np = parameters::default_values())
{
  return insert_surface_points_3(tr, points, faces, Surface_insertion_traits_3(), np);
}

} // namespace CGAL

#endif // CGAL_INSERT_SURFACE_POINTS_3_H
