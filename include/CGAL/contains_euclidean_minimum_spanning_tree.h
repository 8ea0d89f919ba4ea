// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CONTAINS_EUCLIDEAN_MINIMUM_SPANNING_TREE_H
#define CGAL_CONTAINS_EUCLIDEAN_MINIMUM_SPANNING_TREE_H

// Choi 2002, §3.1: "It is not of course guaranteed that a given surface triangulation F contains
// EMST(S)". It does exactly if its own minimum spanning tree has edges of the same lengths.

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/adapters/check_named_parameters.h>
#include <CGAL/Delaunay_from_surface_3/adapters/surface_input.h>
#include <CGAL/Delaunay_from_surface_3/support/Disjoint_sets.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/euclidean_minimum_spanning_tree_3.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Iterator_range.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The graph's own map is asked for only where no other is given: it need not have one.
template <class Graph, class NamedParameters>
auto vertex_point_map(const Graph& graph, const NamedParameters& np)
{
  if constexpr (parameters::is_default_parameter<NamedParameters,
                                                 internal_np::vertex_point_t>::value)
    return get_const_property_map(vertex_point, graph);
  else
    return parameters::get_parameter(np, internal_np::vertex_point);
}

// Different numbers for the vertices. CGAL's helper only serves graphs with ranges of its own.
template <class Graph>
auto numbering_of_vertices(const Graph& graph)
{
  if constexpr (graph_has_property<Graph, boost::vertex_index_t>::value)
    return get_initialized_vertex_index_map(graph);
  else {
    const auto numbering = get(dynamic_vertex_property_t<std::size_t>(), graph);
    std::size_t number = 0;
    for (const auto v : make_range(vertices(graph)))
      put(numbering, v, number++);
    return numbering;
  }
}

// The number of the vertex of the triangulation at each point.
template <class Triangulation, class Point>
std::vector<std::uint32_t> numbers_of_points(const Numbered_vertices<Triangulation>& vertices,
                                             const std::vector<Point>& points)
{
  std::vector<std::pair<Point, std::size_t>> sorted;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    sorted.emplace_back(vertices.point(i), i);
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::uint32_t> numbers;
  std::vector<bool> is_met(vertices.size(), false);
  for (const Point& p : points) {
    const auto found = std::lower_bound(sorted.begin(), sorted.end(), std::pair(p, std::size_t(0)));
    if (found == sorted.end() || found->first != p)
      throw Surface_input_error("vertex " + std::to_string(numbers.size()) +
                                " of the surface is no vertex of the triangulation");
    numbers.push_back(std::uint32_t(found->second));
    is_met[found->second] = true;
  }
  if (std::find(is_met.begin(), is_met.end(), false) != is_met.end())
    throw Surface_input_error("a vertex of the triangulation is no vertex of the surface");
  return numbers;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3

/*!
\ingroup PkgDelaunayFromSurface3Trees

returns whether the edges of a surface contain a Euclidean minimum spanning tree of its vertices. If
they do, and no two vertices have the same point, `Delaunay_from_surface_3::Minimum_spanning_forest`
finds one without the triangulation (\cgalCite{choi-dtsm-02}, §3.1).

The function compares the edge lengths of two trees exactly: those of the minimum spanning forest of the
surface, and those of `euclidean_minimum_spanning_tree_3()`. Vertices at the same point count as one
here; in the forest they do not.

<b>Complexity</b>: \f$O(m \log m)\f$ for m edges of the surface and the triangulation.

\tparam Graph a model of `VertexListGraph` and `EdgeListGraph` whose vertices have points, such as a
mesh
\tparam Gt,Tds,Lp,Slds the parameters of `Delaunay_triangulation_3`; `Gt` as in
`euclidean_minimum_spanning_tree_3()`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh the surface
\param tr the triangulation of its vertices
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
below; any other does not compile

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{maps the vertices of `mesh` to points}
    \cgalParamType{as in `insert_surface_vertices_3()`}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws Surface_input_error if the points of `mesh` are not those of `tr`
*/
template <class Graph, class Gt, class Tds, class Lp, class Slds,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
bool contains_euclidean_minimum_spanning_tree(
    const Graph& mesh, const Delaunay_triangulation_3<Gt, Tds, Lp, Slds>& tr,
    const CGAL_NP_CLASS& np = parameters::default_values())
{
  using namespace Delaunay_from_surface_3::internal;
  check_named_parameters<internal_np::vertex_point_t>(np);
  using Triangulation = Delaunay_triangulation_3<Gt, Tds, Lp, Slds>;
  using Point = typename Triangulation::Point;

  const auto point_map = vertex_point_map(mesh, np);
  const auto index_map = numbering_of_vertices(mesh);
  const auto all_vertices = make_range(vertices(mesh));
  const std::vector<typename boost::graph_traits<Graph>::vertex_descriptor> descriptors(
      all_vertices.begin(), all_vertices.end());
  const Numbered_vertices<Triangulation> numbered(tr);
  const std::vector<std::uint32_t> numbers =
      numbers_of_points(numbered, read_points<Point>(descriptors, point_map));
  const std::vector<std::size_t> dense =
      dense_indices(descriptors, index_map, std::vector<std::size_t>().max_size());
  const Dense_index_map<std::decay_t<decltype(index_map)>> dense_map(index_map, dense);
  const auto number = [&](auto v) { return numbers[index_of_end(dense_map, v, numbers.size())]; };

  std::vector<Measured_edge<std::uint32_t>> forest;
  for (const auto e : make_range(edges(mesh)))
    if (const auto s = number(source(e, mesh)), t = number(target(e, mesh)); s != t)
      forest.push_back({{s, t}, 0, 0});
  return numbered.with_lengths([&](const auto& lengths) {
    const auto tree = numbered.minimum_spanning_tree(lengths);
    keep_minimum_spanning_forest(forest, numbered.size(), lengths, Alone(), std::cref(numbered));
    return std::equal(tree.begin(), tree.end(), forest.begin(), forest.end(),
                      [&](const auto& a, const auto& b) { return lengths.compare(a, b) == 0; });
  });
}

} // namespace CGAL

#endif // CGAL_CONTAINS_EUCLIDEAN_MINIMUM_SPANNING_TREE_H
