// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INSERT_POINTS_ALONG_GRAPH_3_H
#define CGAL_INSERT_POINTS_ALONG_GRAPH_3_H

#include <CGAL/Delaunay_from_surface_3/adapters/Executor_by_tag.h>
#include <CGAL/Delaunay_from_surface_3/adapters/Read_mesh.h>
#include <CGAL/Delaunay_from_surface_3/adapters/insert_surface.h>
#include <CGAL/Delaunay_from_surface_3/adapters/surface_input.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Surface_insertion_traits_3.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Named_function_parameters.h>

#include <boost/graph/properties.hpp>

#include <cstddef>
#include <optional>

namespace CGAL {

namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The graph's own map is asked for only where no other is given: it need not have one.
template <class Graph, class NamedParameters>
auto vertex_index_map(const Graph& graph, const NamedParameters& np)
{
  if constexpr (parameters::is_default_parameter<NamedParameters,
                                                 internal_np::vertex_index_t>::value)
    return get(boost::vertex_index, graph);
  else
    return parameters::get_parameter(np, internal_np::vertex_index);
}

// Refers to what was read and to the graph, whose indices are checked.
template <class Items, class Graph, class NamedParameters>
auto input_along_graph(const Items& read, const Graph& graph, const NamedParameters& np)
{
  const auto index_map = vertex_index_map(graph, np);
  check_indices(graph, index_map, read.points().size());
  return Insertion_input{read.points(), graph,           index_map,
                         std::nullopt,  Identity_name(), read.infos()};
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3

/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {
/// \endcond

/*!
\ingroup PkgDelaunayFromSurface3Graph

inserts points that are the vertices of any graph: the edges of a soup, curves, nearest neighbours. By
default the edges are not looked at; other traits trace them, or make the order from them. The result,
and the state after a stop or an exception, are those of `insert_surface_vertices_3()`. As there is no
surface, the visitor is never told of irregularities.

<b>Complexity</b>: \f$O(n \log n)\f$ for the order of n points, plus the insertions.

\tparam ConcurrencyTag,Gt,Tds,Lp,Slds as in `insert_points_3()`
\tparam PointRange as in `insert_points_3()`: points, pairs of points and infos, or items that
`point_map` maps to points
\tparam Graph a model of `boost::VertexListGraph` and `boost::EdgeListGraph`, directed or not; loops
and multiple edges are allowed
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tr the triangulation into which the points are inserted
\param points the points
\param graph the graph, whose vertex with index i represents the i-th point. The graph does not affect
the result.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": those of
`insert_points_3()` with faces, and the one below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{maps the n vertices of `graph` onto 0, …, n-1, one to one}
    \cgalParamType{a model of `ReadablePropertyMap` from
      `boost::graph_traits<Graph>::%vertex_descriptor` to an integer type}
    \cgalParamDefault{`boost::get(boost::vertex_index, graph)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the number of vertices that `tr` has gained; 0 after a stop if it was empty

\throws Surface_input_error if a coordinate is not a finite number, the numbers of points and
vertices or infos differ, the indices are not 0, …, n-1, or the input order cannot be preserved as
requested; `tr` is then unchanged

Example: \ref Delaunay_from_surface_3/insert_along_graph.cpp

\sa `insert_surface_vertices_3()`
*/
template <class ConcurrencyTag = Default, class Gt, class Tds, class Lp, class Slds,
          class PointRange, class Graph, typename CGAL_NP_TEMPLATE_PARAMETERS>
std::ptrdiff_t insert_points_along_graph_3(Delaunay_triangulation_3<Gt, Tds, Lp, Slds>& tr,
                                           const PointRange& points, const Graph& graph,
                                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  return insert_points_along_graph_3<ConcurrencyTag>(tr, points, graph,
                                                     Surface_insertion_traits_3(), np);
}

/*!
\ingroup PkgDelaunayFromSurface3Graph

does the same with other traits, a model of `SurfaceInsertionTraits_3`. The traits determine the
order in which points are inserted, from which cells their location starts, and along which subgraph
the surface is traced.

The other parameters, the return value and the exceptions are as above; `preserve_order` requires
traits that go through the core (`through_core`). <b>Complexity</b>: that of the parts of the
traits, plus \f$O(n)\f$.

Example: \ref Delaunay_from_surface_3/own_plan.cpp
*/
template <class ConcurrencyTag = Default, class Gt, class Tds, class Lp, class Slds,
          class PointRange, class Graph, class SurfaceInsertionTraits,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
std::ptrdiff_t insert_points_along_graph_3(Delaunay_triangulation_3<Gt, Tds, Lp, Slds>& tr,
                                           const PointRange& points, const Graph& graph,
                                           const SurfaceInsertionTraits& traits,
                                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  using namespace Delaunay_from_surface_3::internal;
  using Triangulation = Delaunay_triangulation_3<Gt, Tds, Lp, Slds>;
  const Read_items<Triangulation, PointRange, CGAL_NP_CLASS> read(points, np);
  return insert_surface<Executor_by_tag<ConcurrencyTag, Triangulation>, internal_np::point_t,
                        internal_np::vertex_index_t>(tr, input_along_graph(read, graph, np), traits,
                                                     np);
}

/// \cond SKIP_IN_MANUAL
template <class ConcurrencyTag = Default, class Triangulation, class... Arguments>
Delaunay_from_surface_3::internal::If_refused<Triangulation>
insert_points_along_graph_3(Triangulation&, const Arguments&...)
{
  return Delaunay_from_surface_3::internal::refuse_triangulation<Triangulation>();
}
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond

} // namespace CGAL

#endif // CGAL_INSERT_POINTS_ALONG_GRAPH_3_H
