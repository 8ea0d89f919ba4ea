// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The forms for halfedge graphs: Surface_mesh, Polyhedron_3, Linear_cell_complex; what they refuse,
// and how.

#define BOOST_TEST_MODULE bounded_degree_halfedge_graphs
#include <boost/test/included/unit_test.hpp>

#include "include/halfedge_mesh.h"
#include <Delaunay_from_surface_3_meters/system_of_loops.h>
#include <Delaunay_from_surface_3_triangle_lists/Surface_recipe.h>
#include <Delaunay_from_surface_3_triangle_lists/Triangle_list.h>

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/surface/Bounded_degree_subgraph.h>
#include <CGAL/Delaunay_from_surface_3/surface/Minimum_spanning_forest.h>
#include <CGAL/Delaunay_from_surface_3/surface/No_subgraph.h>
#include <CGAL/bounded_degree_spanning_subgraph.h>
#include <CGAL/certify_spanning_subgraph.h>
#include <CGAL/surface_of.h>
#include <CGAL/Delaunay_from_surface_3/surface/cut_graph.h>
#include <CGAL/Delaunay_from_surface_3/surface/surface_topology.h>

#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>

#include <boost/graph/connected_components.hpp>
#include <boost/graph/filtered_graph.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;

using namespace triangle_lists;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Cell_complex = CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<
    2, 3, CGAL::Linear_cell_complex_traits<3, Kernel>>::type;

template <class Mesh>
using Edges = std::vector<typename boost::graph_traits<Mesh>::edge_descriptor>;

template <class Mesh>
Edges<Mesh> subgraph_of(const Mesh& mesh)
{
  Edges<Mesh> edges;
  CGAL::bounded_degree_spanning_subgraph(CGAL::surface_of(mesh), std::back_inserter(edges));
  return edges;
}

template <class Mesh>
std::string check_mesh(const Mesh& mesh)
{
  Edges<Mesh> tree, cut;
  if (!CGAL::certify_spanning_subgraph(CGAL::surface_of(mesh), subgraph_of(mesh))
           .is_valid_subgraph())
    return "the subgraph is not certified";
  CGAL::bounded_degree_spanning_tree(CGAL::surface_of(mesh), std::back_inserter(tree));
  if (!CGAL::certify_spanning_subgraph(CGAL::surface_of(mesh), tree).is_valid_tree())
    return "the tree is not certified";
  DFS::cut_graph(CGAL::surface_of(mesh), std::back_inserter(cut));
  for (const auto& e : cut)
    if (is_border(e, mesh))
      return "a boundary edge is in the cut";
  return "";
}

template <class Mesh>
std::string check_surface(const Surface_recipe& recipe)
{
  try {
    return check_mesh(to_halfedge_mesh<Mesh>(cook(recipe)));
  } catch (const std::exception& e) {
    return std::string("an exception: ") + e.what();
  }
}

template <class Mesh>
void check_many(int first, int last)
{
  for (int seed = first; seed < last; ++seed) {
    const std::string complaint = check_and_shrink(random_recipe(seed, true), check_surface<Mesh>);
    BOOST_REQUIRE_MESSAGE(complaint.empty(), complaint);
  }
}

// What the message of the exception must say.
template <class Mesh>
void check_refused(const Mesh& mesh, const std::vector<std::string>& words)
{
  Edges<Mesh> edges;
  std::string message;
  try {
    CGAL::bounded_degree_spanning_subgraph(CGAL::surface_of(mesh), std::back_inserter(edges));
  } catch (const CGAL::Surface_input_error& e) {
    message = e.what();
  }
  BOOST_TEST(edges.empty());
  for (const std::string& word : words)
    BOOST_TEST(message.find(word) != std::string::npos,
               "\"" << message << "\" does not say \"" << word << "\"");
}

Surface_mesh mesh_of(int n, const std::vector<std::vector<int>>& faces)
{
  Surface_mesh mesh;
  std::vector<Surface_mesh::Vertex_index> v;
  for (int i = 0; i < n; ++i)
    v.push_back(mesh.add_vertex(Kernel::Point_3(i, 0, 0)));
  for (const auto& face : faces) {
    std::vector<Surface_mesh::Vertex_index> corners;
    for (int i : face)
      corners.push_back(v[i]);
    BOOST_REQUIRE(mesh.add_face(corners) != Surface_mesh::null_face());
  }
  return mesh;
}

} // namespace

BOOST_AUTO_TEST_CASE(surface_mesh)
{
  check_many<Surface_mesh>(0, 1500);
}

BOOST_AUTO_TEST_CASE(polyhedron)
{
  for (int seed = 0; seed < 300; ++seed) {
    Surface_recipe recipe = random_recipe(seed, true);
    recipe.field[Surface_recipe::ISOLATED] = 0;
    const std::string complaint = check_and_shrink(recipe, check_surface<Polyhedron>);
    BOOST_REQUIRE_MESSAGE(complaint.empty(), complaint);
  }
}

BOOST_AUTO_TEST_CASE(linear_cell_complex)
{
  for (int seed = 0; seed < 50; ++seed) {
    Surface_recipe recipe = random_recipe(seed, true);
    recipe.field[Surface_recipe::ISOLATED] = 0;
    const std::string complaint = check_and_shrink(recipe, check_surface<Cell_complex>);
    BOOST_REQUIRE_MESSAGE(complaint.empty(), complaint);
  }
}

// Scans and parts, with and without boundary, of one component and of several.
BOOST_AUTO_TEST_CASE(real_meshes)
{
  for (const std::string name :
       {"bunny00.off", "elephant.off", "fandisk.off", "blobby_3cc.off", "cheese.off",
        "mesh_with_border.off", "anchor.off", "knot1.off", "head.off"}) {
    const std::string path = std::string(DELAUNAY_FROM_SURFACE_3_DATA_DIR) + "/" + name;
    Surface_mesh mesh;
    if (!std::ifstream(path)) {
      BOOST_TEST_MESSAGE("skipped: the mesh " << name << " is not there");
      continue;
    }
    BOOST_REQUIRE(CGAL::IO::read_OFF(path, mesh));
    if (!CGAL::is_triangle_mesh(mesh))
      check_refused(mesh, {"not a triangle"});
    else
      BOOST_TEST(check_mesh(mesh) == "", name);
  }
}

// Both forms feed one core: the same lists give the same subgraph.
BOOST_AUTO_TEST_CASE(both_forms_agree)
{
  for (int seed = 0; seed < 200; ++seed) {
    const Surface_mesh mesh = to_halfedge_mesh<Surface_mesh>(cook(random_recipe(seed, true)));
    Embedded_graph g;
    g.graph = Embedded_graph::Graph(num_vertices(mesh));
    std::map<Surface_mesh::Edge_index, Embedded_graph::Edge> twin;
    for (auto e : edges(mesh)) {
      twin[e] = add_edge(source(e, mesh), target(e, mesh), int(twin.size()), g.graph).first;
      g.is_boundary.push_back(is_border(e, mesh));
    }
    g.lists.resize(num_vertices(mesh));
    for (auto v : vertices(mesh)) {
      auto h = halfedge(v, mesh);
      if (h == Surface_mesh::null_halfedge())
        continue;
      for (auto i : halfedges_around_target(h, mesh))
        if (is_border(i, mesh))
          h = opposite(next(i, mesh), mesh);
      for (auto i : halfedges_around_target(h, mesh))
        g.lists[v].push_back(twin[edge(i, mesh)]);
    }
    std::vector<Embedded_graph::Edge> expected, found;
    CGAL::bounded_degree_spanning_subgraph(g.surface(), std::back_inserter(expected));
    for (auto e : subgraph_of(mesh))
      found.push_back(twin[e]);
    std::sort(found.begin(), found.end());
    std::sort(expected.begin(), expected.end());
    BOOST_REQUIRE(found == expected);
  }
}

BOOST_AUTO_TEST_CASE(functors_are_surface_subgraphs)
{
  const Surface_mesh mesh = to_halfedge_mesh<Surface_mesh>(grid_torus(7, 9));
  const auto index = get(boost::vertex_index, mesh);
  Edges<Surface_mesh> subgraph, tree;
  DFS::Bounded_degree_subgraph()(mesh, index, std::back_inserter(subgraph));
  const DFS::Bounded_degree_subgraph find_tree(DFS::Bounded_degree_subgraph::TREE);
  find_tree(mesh, index, std::back_inserter(tree));
  BOOST_TEST((subgraph == subgraph_of(mesh)));
  BOOST_TEST(CGAL::certify_spanning_subgraph(CGAL::surface_of(mesh), tree).is_valid_tree());
}

BOOST_AUTO_TEST_CASE(a_user_s_index_map_is_used)
{
  const Surface_mesh mesh = to_halfedge_mesh<Surface_mesh>(nested_triangles(20));
  const std::size_t n = num_vertices(mesh);
  std::vector<std::size_t> reversed(n);
  for (std::size_t i = 0; i < n; ++i)
    reversed[i] = n - 1 - i;
  const auto map =
      boost::make_iterator_property_map(reversed.begin(), get(boost::vertex_index, mesh));
  Edges<Surface_mesh> edges;
  const auto surface = CGAL::surface_of(mesh, CGAL::parameters::vertex_index_map(map));
  CGAL::bounded_degree_spanning_subgraph(surface, std::back_inserter(edges));
  BOOST_TEST(CGAL::certify_spanning_subgraph(surface, edges).is_valid_subgraph());
  reversed[3] = reversed[4];
  BOOST_CHECK_THROW(DFS::Bounded_degree_subgraph()(mesh, map, std::back_inserter(edges)),
                    CGAL::Surface_input_error);
  reversed[3] = n;
  BOOST_CHECK_THROW(DFS::Bounded_degree_subgraph()(mesh, map, std::back_inserter(edges)),
                    CGAL::Surface_input_error);
}

BOOST_AUTO_TEST_CASE(edges_filter_the_graph)
{
  Surface_mesh mesh = to_halfedge_mesh<Surface_mesh>(grid_torus(10, 10));
  auto is_in =
      mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:is_in_subgraph", false).first;
  for (auto e : subgraph_of(mesh))
    put(is_in, e, true);
  struct Filter
  {
    Surface_mesh::Property_map<Surface_mesh::Edge_index, bool> is_in;
    bool operator()(Surface_mesh::Edge_index e) const { return get(is_in, e); }
  };
  const boost::filtered_graph<Surface_mesh, Filter> filtered(mesh, Filter{is_in});
  std::vector<int> component(num_vertices(mesh));
  BOOST_TEST(boost::connected_components(
                 filtered, boost::make_iterator_property_map(component.begin(),
                                                             get(boost::vertex_index, mesh))) == 1);
}

BOOST_AUTO_TEST_CASE(topology_of_known_surfaces)
{
  std::mt19937 random(1);
  for (std::size_t genus = 0; genus <= 10; ++genus) {
    Surface_recipe recipe;
    recipe.field = {0, 0, int(genus), 0, 80, 100, 0, 0, 2, 1};
    Triangle_list s = cook(recipe);
    std::size_t loops = 0;
    while (loops < 5 && puncture(s, random))
      ++loops;
    const auto topology =
        DFS::surface_topology(CGAL::surface_of(to_halfedge_mesh<Surface_mesh>(s)));
    BOOST_REQUIRE(topology.components.size() == 1);
    BOOST_TEST(topology.components[0].genus() == genus);
    BOOST_TEST(topology.components[0].number_of_boundary_loops == loops);
    BOOST_TEST(topology.components[0].is_orientable);
    BOOST_TEST(topology.number_of_isolated_vertices == 2u);
  }
}

BOOST_AUTO_TEST_CASE(a_system_of_loops_cuts_as_well)
{
  for (int genus = 0; genus <= 6; ++genus)
    for (int seed = 0; seed < 20; ++seed) {
      Surface_recipe recipe;
      recipe.field = {0, 0, genus, 0, 60, 100, 0, 0, 0, seed};
      const Surface_mesh mesh = to_halfedge_mesh<Surface_mesh>(cook(recipe));
      std::vector<Edges<Surface_mesh>> loops;
      meters::system_of_loops(CGAL::surface_of(mesh), std::back_inserter(loops));
      BOOST_REQUIRE(loops.size() == std::size_t(2 * genus));
      std::set<Surface_mesh::Edge_index> cut;
      for (const auto& loop : loops) {
        cut.insert(loop.begin(), loop.end());
        // Consecutive edges share a vertex, around to the base.
        for (std::size_t i = 0; i < loop.size(); ++i) {
          const auto e = loop[i], f = loop[(i + 1) % loop.size()];
          BOOST_REQUIRE((source(e, mesh) == source(f, mesh) || source(e, mesh) == target(f, mesh) ||
                         target(e, mesh) == source(f, mesh) || target(e, mesh) == target(f, mesh)));
        }
      }
      // Faces - inner edges + inner vertices of what is left: an open disc has 1.
      std::set<Surface_mesh::Vertex_index> on_cut;
      for (auto e : cut)
        on_cut.insert({source(e, mesh), target(e, mesh)});
      const std::ptrdiff_t characteristic = std::ptrdiff_t(num_faces(mesh)) -
                                            std::ptrdiff_t(num_edges(mesh) - cut.size()) +
                                            std::ptrdiff_t(num_vertices(mesh) - on_cut.size());
      BOOST_TEST(characteristic == (genus == 0 ? 2 : 1));
    }
  BOOST_CHECK_THROW(
      meters::system_of_loops(CGAL::surface_of(to_halfedge_mesh<Surface_mesh>(fan(4))),
                              CGAL::Emptyset_iterator()),
      CGAL::Surface_input_error);
}

BOOST_AUTO_TEST_CASE(empty_and_isolated)
{
  BOOST_TEST(subgraph_of(Surface_mesh()).empty());
  Surface_mesh mesh;
  mesh.add_vertex();
  mesh.add_vertex();
  BOOST_TEST(subgraph_of(mesh).empty());
  const auto certificate =
      CGAL::certify_spanning_subgraph(CGAL::surface_of(mesh), Edges<Surface_mesh>());
  BOOST_TEST(certificate.is_valid_tree());
  BOOST_TEST(certificate.number_of_graph_components == 2u);
}

// The index map of a mesh with removed vertices has gaps.
BOOST_AUTO_TEST_CASE(removed_vertices_are_refused_until_garbage_is_collected)
{
  Surface_mesh mesh = mesh_of(5, {{1, 2, 3}, {2, 1, 4}});
  mesh.remove_vertex(Surface_mesh::Vertex_index(0));
  check_refused(mesh, {"the vertex index map is no bijection", "4 is too large"});
  mesh.collect_garbage();
  BOOST_TEST(check_mesh(mesh) == "");
}

// Regression: such edges were written beside the list of degrees.
BOOST_AUTO_TEST_CASE(edges_of_removed_vertices_are_refused)
{
  const auto tetrahedron = [] { return mesh_of(4, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}); };
  for (int number : {1, 2, 3}) {
    Surface_mesh mesh = tetrahedron();
    for (int i = 4 - number; i < 4; ++i)
      mesh.remove_vertex(Surface_mesh::Vertex_index(i));
    check_refused(mesh, {"an edge leads to a vertex that was removed"});
    const auto index = get(boost::vertex_index, mesh);
    const std::vector<Kernel::Point_3> points(std::size_t(4 - number));
    Edges<Surface_mesh> edges;
    BOOST_CHECK_THROW(DFS::Spanning_forest()(mesh, index, std::back_inserter(edges)),
                      CGAL::Surface_input_error);
    const DFS::Minimum_spanning_forest shortest(points);
    BOOST_CHECK_THROW(shortest(mesh, index, std::back_inserter(edges)), CGAL::Surface_input_error);
  }

  // Halfedges that were removed are met only by walking around a vertex.
  Surface_mesh mesh = tetrahedron();
  const auto end = mesh.add_vertex();
  const Surface_mesh::Vertex_index v(2);
  const auto h = mesh.halfedge(v), spoke = mesh.opposite(mesh.add_edge(v, end));
  mesh.set_face(spoke, mesh.face(h));
  mesh.set_next(spoke, mesh.next(mesh.opposite(mesh.next(h))));
  mesh.set_next(h, mesh.opposite(spoke));
  mesh.remove_edge(mesh.edge(spoke));
  mesh.remove_vertex(end);
  check_refused(mesh, {"vertex 2 has a halfedge that was removed"});
}

// Regression: a disc whose three boundary edges are doubled by chords. All its counts are 4, so
// that counting edges finds no vertex to peel; simple is a precondition and the message names both
// edges.
BOOST_AUTO_TEST_CASE(doubled_boundary_edges_are_refused_by_name)
{
  // The triangle 0 1 2 with an ear on each side, and outside every ear a second edge between its
  // two feet.
  Surface_mesh mesh = mesh_of(6, {{0, 1, 2}, {1, 0, 3}, {2, 1, 4}, {0, 2, 5}});
  for (int tip : {3, 4, 5}) {
    auto h = mesh.halfedge(Surface_mesh::Vertex_index(tip));
    while (!mesh.is_border(h))
      h = mesh.opposite(mesh.next(h));
    CGAL::Euler::add_face_to_border(mesh.prev(h), mesh.next(h), mesh);
  }
  BOOST_REQUIRE(mesh.is_valid());
  BOOST_REQUIRE(CGAL::is_triangle_mesh(mesh));
  check_refused(mesh, {"not simple", "is there 2 times", " and "});
}

BOOST_AUTO_TEST_CASE(other_faces_are_refused_by_name)
{
  check_refused(mesh_of(5, {{0, 1, 2, 3}, {0, 3, 4}}), {"face at edge (", "not a triangle"});
}

BOOST_AUTO_TEST_CASE(halfedges_of_a_face_that_was_removed_are_refused)
{
  Surface_mesh mesh = mesh_of(4, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}});
  mesh.remove_face(Surface_mesh::Face_index(1)); // leaves its halfedges as they were
  check_refused(mesh, {"the faces of the graph do not match its halfedges"});
}

BOOST_AUTO_TEST_CASE(pinched_vertices_are_refused_by_name)
{
  check_refused(mesh_of(5, {{0, 1, 2}, {0, 3, 4}}), {"vertex 0 is pinched"});
  // Two tetrahedra that share a vertex: two fans without boundary.
  Surface_mesh mesh = mesh_of(
      8, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}, {4, 5, 6}, {4, 6, 7}, {4, 7, 5}, {5, 7, 6}});
  for (auto h : CGAL::halfedges_around_target(mesh.halfedge(Surface_mesh::Vertex_index(4)), mesh))
    mesh.set_target(h, Surface_mesh::Vertex_index(0));
  mesh.set_halfedge(Surface_mesh::Vertex_index(4), Surface_mesh::null_halfedge());
  check_refused(mesh, {"vertex 0 is pinched", "more than one fan"});
}

BOOST_AUTO_TEST_CASE(edges_without_triangles_are_refused_by_name)
{
  Surface_mesh mesh;
  const auto a = mesh.add_vertex(), b = mesh.add_vertex();
  const auto h = mesh.add_edge(a, b);
  mesh.set_next(h, mesh.opposite(h));
  mesh.set_next(mesh.opposite(h), h);
  mesh.set_halfedge(a, mesh.opposite(h));
  mesh.set_halfedge(b, h);
  check_refused(mesh, {"edge (0, 1) lies in no triangle"});
}

// The two vertices have equally many edges: the walk around the other one would close as well.
BOOST_AUTO_TEST_CASE(stored_halfedges_that_lead_elsewhere_are_refused_by_name)
{
  const auto tetrahedron = [] { return mesh_of(4, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}); };
  const Surface_mesh::Vertex_index v(2);
  Surface_mesh astray = tetrahedron();
  astray.set_halfedge(v, astray.opposite(astray.halfedge(v)));
  check_refused(astray, {"vertex 2 has a halfedge that does not lead to it"});

  Surface_mesh without = tetrahedron();
  without.set_halfedge(v, Surface_mesh::null_halfedge());
  check_refused(without, {"vertex 2 has edges, but no halfedge of its own"});

  Surface_mesh isolated = tetrahedron();
  const auto lonely = isolated.add_vertex();
  isolated.set_halfedge(lonely, isolated.halfedge(v));
  check_refused(isolated, {"vertex 4 has a halfedge that does not lead to it"});

  Surface_mesh removed = tetrahedron();
  const auto end = removed.add_vertex();
  const auto h = removed.add_edge(v, end);
  removed.set_halfedge(end, h);
  removed.remove_edge(removed.edge(h));
  check_refused(removed, {"vertex 4 has a halfedge that does not lead to it"});
}
