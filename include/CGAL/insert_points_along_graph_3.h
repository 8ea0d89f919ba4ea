// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INSERT_POINTS_ALONG_GRAPH_3_H
#define CGAL_INSERT_POINTS_ALONG_GRAPH_3_H

#include <CGAL/Delaunay_from_surface_3/door/Executor_by_tag.h>
#include <CGAL/Delaunay_from_surface_3/door/insert_surface.h>
#include <CGAL/Delaunay_from_surface_3/door/read_items.h>
#include <CGAL/Delaunay_from_surface_3/door/refuse_triangulation.h>
#include <CGAL/Delaunay_from_surface_3/door/surface_input.h>
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

inserts points that are joined by any graph: the edges of a soup, curves, nearest neighbours. This
is the mesh-free core of `insert_surface_vertices_3()`. The result, and what holds after a stop or
an exception, are the same; the visitor is not told that the surface is irregular, since there is
none.

<b>Complexity</b>: expected \f$O((n + m) \log n)\f$ for the order of n points along m edges, plus the
insertions.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; by default that
of the triangulation. Any of them serves any triangulation: many threads can fill one that is made
for a single thread. `Parallel_tag` needs TBB.
\tparam Gt,Tds,Lp,Slds the parameters of `Delaunay_triangulation_3`; any are served. `Gt` must have
exact predicates.
\tparam PointRange as that of `insert_points_3()`: points, pairs of points and infos, or items that
`point_map` turns into points
\tparam Graph a model of `boost::VertexListGraph` and `boost::EdgeListGraph`; the direction of its
edges does not matter, nor do loops and multiple edges
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tr the triangulation into which the points are inserted
\param points the points
\param graph its vertex with index i stands for the i-th point. A wrong graph costs time, never the
result.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": those of
`insert_points_3()` with faces, and the one below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{the indices of the vertices of `graph`: 0, …, n-1}
    \cgalParamType{a model of `ReadablePropertyMap` from
      `boost::graph_traits<Graph>::%vertex_descriptor` to an integer type}
    \cgalParamDefault{`boost::get(boost::vertex_index, graph)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the number of vertices that `tr` has gained; 0 after a stop if it was empty

\throws Surface_input_error if a coordinate is not a finite number, the numbers of points and
vertices or infos differ, the indices are not 0, …, n-1, or `preserve_order` cannot be had; `tr` is
then unchanged

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

does the same in another way, with traits, a model of `SurfaceInsertionTraits_3`: they say in which
order points are inserted, from which cells, and along which subgraph the surface is traced.

The other parameters, what is returned and what is thrown are as above; `preserve_order` needs traits
that go through the core (`through_core`). <b>Complexity</b>: that of the parts of the traits, plus
\f$O(n)\f$.

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
