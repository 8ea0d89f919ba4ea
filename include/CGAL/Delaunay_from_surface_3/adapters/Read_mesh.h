// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_READ_MESH_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_READ_MESH_H

// A range of points may consist of points, of pairs of points and infos, or of items that a
// point_map turns into points.

#include <CGAL/Delaunay_from_surface_3/adapters/Read_coordinates.h>
#include <CGAL/Delaunay_from_surface_3/adapters/check_named_parameters.h>
#include <CGAL/Delaunay_from_surface_3/adapters/give_to_vertices.h>
#include <CGAL/Delaunay_from_surface_3/adapters/surface_input.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/Page_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/soup_edges.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/tuple/tuple.hpp>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Holds the input that a public function hands over: the checked points; a graph on them; their
// names for the caller, as a function of their indices; and the infos that came with them.
template <class Point, class Graph, class VertexIndexMap, class NameOf, class Infos>
struct Insertion_input
{
  const std::vector<Point>& points;
  const Graph& graph;
  VertexIndexMap index_map;
  std::optional<std::string> irregularity; // empty if points need not be a surface
  NameOf name_of;
  Infos infos;
};

template <class Point, class Graph, class VertexIndexMap, class NameOf, class Infos>
Insertion_input(const std::vector<Point>&, const Graph&, VertexIndexMap, std::optional<std::string>,
                NameOf, Infos) -> Insertion_input<Point, Graph, VertexIndexMap, NameOf, Infos>;

// Recognizes items that bring an info with their point, as CGAL's own insertion allows: pairs, and
// tuples of two, which boost::zip_iterator makes.
template <class Item>
struct Point_and_info : std::false_type
{
};
template <class Point, class Info_>
struct Point_and_info<std::pair<Point, Info_>> : std::true_type
{
  using Info = std::decay_t<Info_>;
  static const auto& point(const std::pair<Point, Info_>& pair) { return pair.first; }
  static const auto& info(const std::pair<Point, Info_>& pair) { return pair.second; }
};
template <class Point, class Info_>
using Cons = boost::tuples::cons<Point, boost::tuples::cons<Info_, boost::tuples::null_type>>;
template <class Point, class Info_>
struct Point_and_info<Cons<Point, Info_>> : std::true_type
{
  using Info = std::decay_t<Info_>;
  static const auto& point(const Cons<Point, Info_>& tuple) { return boost::tuples::get<0>(tuple); }
  static const auto& info(const Cons<Point, Info_>& tuple) { return boost::tuples::get<1>(tuple); }
};
template <class Point, class Info_>
struct Point_and_info<boost::tuples::tuple<Point, Info_>> : Point_and_info<Cons<Point, Info_>>
{
};

template <class Iterator>
using Category_of_iterator = typename std::iterator_traits<Iterator>::iterator_category;

template <class Iterator>
constexpr bool is_iterator = is_detected<Category_of_iterator, Iterator>;

// Reads the points of a range, checked, and the infos that came with them. A range is read once.
template <class Triangulation, class Range, class NamedParameters>
class Read_items
{
  using Point = typename Triangulation::Point;
  using Item =
      typename std::iterator_traits<decltype(std::begin(std::declval<const Range&>()))>::value_type;
  static constexpr bool has_infos =
      Point_and_info<Item>::value && !is_given<NamedParameters, internal_np::point_t>;
  struct No_info
  {
    using Info = char;
  };
  using Read = std::conditional_t<has_infos, Point_and_info<Item>, No_info>;

public:
  Read_items(const Range& items, const NamedParameters& np)
  {
    if constexpr (has_infos)
      read_pairs(items);
    else
      m_points = read_points<Point>(
          items, parameters::choose_parameter(parameters::get_parameter(np, internal_np::point_map),
                                              Identity_property_map<const Item>()));
  }

  const std::vector<Point>& points() const { return m_points; }

  // Returns the infos by the index of the point.
  auto infos() const
  {
    if constexpr (has_infos)
      return Infos{m_infos.cbegin()};
    else
      return No_infos();
  }

private:
  using Infos = Infos_in_order<typename std::vector<typename Read::Info>::const_iterator>;

  void read_pairs(const Range& items)
  {
    if constexpr (check_infos<typename Triangulation::Vertex, Infos>()) {
      reserve_for(items, m_points);
      reserve_for(items, m_infos);
      for (auto&& item : items) {
        append_checked(Read::point(item), m_points);
        m_infos.push_back(Read::info(item));
      }
    }
  }

  std::vector<Point> m_points;
  std::vector<typename Read::Info> m_infos;
};

// The name of a point of a range is its index.
struct Identity_name
{
  std::size_t operator()(std::size_t i) const { return i; }
};

// True if these are ranges of integers, which number points.
template <class FaceRange>
using Index_in_face =
    decltype(std::size_t(*std::begin(*std::begin(std::declval<const FaceRange&>()))));

template <class FaceRange>
constexpr bool are_faces = is_detected<Index_in_face, FaceRange>;

// Represents the edges of a polygon soup as a graph on the indices of its points: models
// boost::VertexListGraph and boost::EdgeListGraph. It refers to the faces, for subgraphs that need
// more than edges.
template <class FaceRange>
class Graph_of_faces
{
public:
  using vertex_descriptor = std::size_t;
  using edge_descriptor = std::pair<std::size_t, std::size_t>; // the larger number, and the smaller
  using directed_category = boost::directed_tag;
  using edge_parallel_category = boost::disallow_parallel_edge_tag;
  struct traversal_category : boost::vertex_list_graph_tag, boost::edge_list_graph_tag
  {
  };
  using vertices_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using vertex_iterator = boost::counting_iterator<std::size_t>;
  struct Descriptor_of_edge
  {
    edge_descriptor operator()(const Numbered_edge& e) const { return {e.upper, e.lower}; }
  };
  using edge_iterator = boost::transform_iterator<Descriptor_of_edge, const Numbered_edge*>;

  // Makes a graph without edges.
  Graph_of_faces(std::size_t number_of_vertices, const FaceRange& faces)
    : m_number_of_vertices(number_of_vertices)
    , m_faces(&faces)
  {
  }

  // Makes a graph whose edges `lower` lists: for each vertex its neighbours with smaller numbers.
  Graph_of_faces(const Lists<std::uint32_t>& lower, const FaceRange& faces)
    : Graph_of_faces(lower.size(), faces)
  {
    m_edges.reserve(lower.items.size());
    for (std::size_t v = 0; v < lower.size(); ++v)
      for (const std::uint32_t *u = lower.begin(v), *end = lower.end(v); u != end; ++u)
        m_edges.emplace_back(std::uint32_t(v), *u);
  }

  std::size_t number_of_vertices() const { return m_number_of_vertices; }
  const FaceRange& faces_of_soup() const { return *m_faces; }

  friend auto vertices(const Graph_of_faces& graph)
  {
    return std::pair(vertex_iterator(0), vertex_iterator(graph.m_number_of_vertices));
  }
  friend auto edges(const Graph_of_faces& graph)
  {
    const Numbered_edge* const first = graph.m_edges.data();
    return std::pair(edge_iterator(first), edge_iterator(first + graph.m_edges.size()));
  }
  friend std::size_t num_vertices(const Graph_of_faces& graph)
  {
    return graph.m_number_of_vertices;
  }
  friend std::size_t num_edges(const Graph_of_faces& graph) { return graph.m_edges.size(); }
  friend std::size_t source(const edge_descriptor& e, const Graph_of_faces&) { return e.first; }
  friend std::size_t target(const edge_descriptor& e, const Graph_of_faces&) { return e.second; }

private:
  std::size_t m_number_of_vertices;
  const FaceRange* m_faces;
  Large_vector<Numbered_edge> m_edges;
};

// The index of a point of a range is the point's number itself.
using Identity_index_map = boost::typed_identity_property_map<std::size_t>;

// Reads and checks the points and faces of a polygon soup. Edges are kept only for a caller who asks
// for the graph.
template <class Triangulation, class PointRange, class FaceRange, class NamedParameters>
class Read_soup
{
public:
  // Keeps a reference to the faces.
  Read_soup(const PointRange& points, const FaceRange& faces, const NamedParameters& np,
            const Executor& executor, bool asks_for_graph)
    : m_items(points, np)
    , m_graph(m_items.points().size(), faces)
  {
    if (!asks_for_graph && !is_given<NamedParameters, internal_np::visitor_t>) {
      check_faces(faces, m_items.points().size());
      return;
    }
    Soup_edges soup = soup_edges(faces, m_items.points().size(), executor);
    m_irregularity = std::move(soup.irregularity);
    if (asks_for_graph && soup.has_lists)
      m_graph = Graph_of_faces<FaceRange>(soup.lower, faces);
  }

  // Refers to this object.
  auto input() const
  {
    return Insertion_input{m_items.points(), m_graph,         Identity_index_map(),
                           m_irregularity,   Identity_name(), m_items.infos()};
  }

private:
  const Read_items<Triangulation, PointRange, NamedParameters> m_items;
  Graph_of_faces<FaceRange> m_graph;
  std::optional<std::string> m_irregularity;
};

template <class FaceGraph>
std::optional<std::string> irregularity_of_mesh(const FaceGraph& mesh)
{
  std::size_t non_triangles = 0;
  for (const auto f : faces(mesh))
    non_triangles += !is_triangle(halfedge(f, mesh), mesh);
  if (non_triangles == 0)
    return std::nullopt;
  return "faces that are not triangles: " + std::to_string(non_triangles);
}

// CGAL's helper is used only where no map is given: it asserts that a map has no gaps.
template <class FaceGraph, class NamedParameters>
auto vertex_index_map_of_mesh(const FaceGraph& mesh, const NamedParameters& np)
{
  if constexpr (parameters::is_default_parameter<NamedParameters,
                                                 internal_np::vertex_index_t>::value)
    return get_initialized_vertex_index_map(mesh);
  else
    return parameters::get_parameter(np, internal_np::vertex_index);
}

// Reads and checks the vertices of a mesh.
template <class Triangulation, class FaceGraph, class NamedParameters>
class Read_mesh
{
  using Vertex = typename boost::graph_traits<FaceGraph>::vertex_descriptor;
  using Sparse_map = std::decay_t<decltype(vertex_index_map_of_mesh(
      std::declval<const FaceGraph&>(), std::declval<const NamedParameters&>()))>;

public:
  // Keeps a reference to the mesh.
  Read_mesh(const FaceGraph& mesh, const NamedParameters& np)
    : m_mesh(mesh)
    , m_sparse_map(vertex_index_map_of_mesh(mesh, np))
    , m_vertices(vertices(mesh).begin(), vertices(mesh).end())
    , m_dense(dense_indices(m_vertices, m_sparse_map, std::vector<std::size_t>().max_size()))
    , m_points(read_points<typename Triangulation::Point>(
          m_vertices,
          parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                       get_const_property_map(vertex_point, mesh))))
  {
  }

  // Refers to this object.
  auto input() const
  {
    return Insertion_input{m_points,
                           m_mesh,
                           Dense_index_map<Sparse_map>(m_sparse_map, m_dense),
                           irregularity_of_mesh(m_mesh),
                           [this](std::size_t i) { return m_vertices[i]; },
                           No_infos()};
  }

private:
  const FaceGraph& m_mesh;
  const Sparse_map m_sparse_map;
  const std::vector<Vertex> m_vertices;
  const std::vector<std::size_t> m_dense;
  const std::vector<typename Triangulation::Point> m_points;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_READ_MESH_H
