// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INSERT_SURFACE_POINTS_3_H
#define CGAL_INSERT_SURFACE_POINTS_3_H

#include <CGAL/Delaunay_from_surface_3/internal/insert_with_parameters.h>
#include <CGAL/Delaunay_from_surface_3/internal/soup_graph.h>
#include <CGAL/Delaunay_from_surface_3/internal/surface_input.h>
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
faces. Result, guarantees and named parameters are those of `insert_surface_vertices_3()` but these:

\tparam PointRange a range of points of `tr`, or of items that `point_map` turns into such
\tparam FaceRange a range of ranges of indices into `points`

\param points the points, those in no face included
\param faces the faces: for each the indices of its points in order

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{the points of the items of `points`}
    \cgalParamDefault{`CGAL::Identity_property_map`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_to_vertex_output_iterator}
    \cgalParamDescription{receives pairs of the index of a point and its handle in `tr`}
    \cgalParamType{a model of `OutputIterator` accepting `std::pair<std::size_t, Vertex_handle>`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws Surface_input_error if a coordinate is not a finite number or a face has an index out of
range; `tr` is then unchanged
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
  return insert_with_parameters(tr, converted, soup.irregularity, soup.graph,
                                get(boost::vertex_index, soup.graph), traits, np,
                                [](std::size_t i) { return i; });
}

/// \ingroup PkgDelaunayFromSurface3Ref
/// does the same with the default traits, `Surface_insertion_traits_3`.
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
