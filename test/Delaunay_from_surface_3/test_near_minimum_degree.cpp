// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Spanning trees of nearly minimum degree: on graphs made to need a large one, on the bouquets on
// which the tree of bounded degree is as bad as can be, on random surfaces of every kind, and from
// bad trees. Every witness is counted anew, from the triangles. The sharper bound of triangulations
// that are 4- or 5-connected, with the connectivity found by trying all sets of vertices.

#define BOOST_TEST_MODULE near_minimum_degree
#include <boost/test/included/unit_test.hpp>

#include "include/halfedge_mesh.h"
#include <Delaunay_from_surface_3_triangle_lists/Surface_recipe.h>
#include <Delaunay_from_surface_3_triangle_lists/Triangle_list.h>
#include <Delaunay_from_surface_3_triangle_lists/bouquet.h>

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/surface/Reduce_degrees.h>
#include <CGAL/Delaunay_from_surface_3/surface/surface_topology.h>
#include <CGAL/bounded_degree_spanning_subgraph.h>
#include <CGAL/certify_spanning_subgraph.h>
#include <CGAL/near_minimum_degree_spanning_tree.h>
#include <CGAL/surface_of.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;

using namespace triangle_lists;

namespace {

using Edges = std::vector<Embedded_graph::Edge>;
using Witnesses = std::vector<DFS::Minimum_degree_witness>;
using Surface_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// The components of the triangles' edges without X, but for those that X does not touch: of several
// surfaces, X lies in one.
std::size_t components_without(const Triangle_list& s, const std::vector<std::size_t>& x)
{
  const std::set<std::size_t> in_x(x.begin(), x.end());
  std::vector<int> whole(std::size_t(s.n)), part(std::size_t(s.n));
  std::iota(whole.begin(), whole.end(), 0);
  std::iota(part.begin(), part.end(), 0);
  const auto find = [](const std::vector<int>& parent, int v) {
    while (parent[std::size_t(v)] != v)
      v = parent[std::size_t(v)];
    return v;
  };
  for (const Triangle& t : s.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      whole[std::size_t(find(whole, a))] = find(whole, b);
      if (!in_x.count(std::size_t(a)) && !in_x.count(std::size_t(b)))
        part[std::size_t(find(part, a))] = find(part, b);
    }
  std::size_t count = 0;
  for (int v = 0; v < s.n; ++v)
    count += part[std::size_t(v)] == v && !in_x.count(std::size_t(v)) &&
                     find(whole, v) == find(whole, int(x.front()))
                 ? 1
                 : 0;
  return count;
}

std::string check_witnesses(const Triangle_list& s, const Witnesses& witnesses,
                            std::size_t degree_of_tree)
{
  std::size_t largest = 3;
  for (const DFS::Minimum_degree_witness& w : witnesses) {
    largest = (std::max)(largest, w.tree_degree);
    if (w.vertices.empty() || w.number_of_components != components_without(s, w.vertices))
      return "a witness is miscounted";
    const std::size_t x = w.vertices.size(), at_x = w.number_of_components + x - 1;
    if (w.least_degree() != (at_x + x - 1) / x || !w.is_within_one() ||
        w.least_degree() > w.tree_degree)
      return "a witness shows nothing";
  }
  if (degree_of_tree > 3 ? largest != degree_of_tree : !witnesses.empty())
    return "the witnesses are not those of the tree";
  return "";
}

struct Found
{
  std::size_t subgraph = 0, tree = 0, near_minimum = 0, bound = 0, least = 0;
  std::string complaint;
};

Found find_trees(const Triangle_list& s)
{
  std::mt19937 random(1);
  const Embedded_graph g = embed(s, random);
  const auto topology = DFS::surface_topology(g.surface());
  const auto certify = [&](const Edges& edges) {
    return CGAL::certify_spanning_subgraph(g.surface(), edges);
  };
  Edges subgraph, tree, near_minimum;
  Witnesses witnesses;
  CGAL::bounded_degree_spanning_subgraph(g.surface(), std::back_inserter(subgraph));
  CGAL::bounded_degree_spanning_tree(g.surface(), std::back_inserter(tree));
  CGAL::near_minimum_degree_spanning_tree(g.surface(), std::back_inserter(near_minimum),
                                          std::back_inserter(witnesses));
  const auto certificate = certify(near_minimum);
  Found result{certify(subgraph).maximum_degree,
               certify(tree).maximum_degree,
               certificate.maximum_degree,
               0,
               0,
               ""};
  for (const auto& component : topology.components)
    result.bound = (std::max)(result.bound, component.near_minimum_tree_degree_bound());
  for (const auto& w : witnesses)
    result.least = (std::max)(result.least, w.least_degree());
  result.complaint = check_witnesses(s, witnesses, result.near_minimum);
  if (!certificate.is_valid_near_minimum_tree())
    result.complaint = "the tree is not certified";
  if (result.near_minimum > result.tree)
    result.complaint = "the tree has become heavier";
  return result;
}

// The tree of a search from vertex 0, depth-first or breadth-first: bad trees to start from.
DFS::internal::Dart_marks search_tree(const DFS::internal::Rotation_system<std::uint32_t>& surface,
                                      bool is_breadth_first)
{
  DFS::internal::Dart_marks marks(surface.number_of_darts(), false);
  std::vector<bool> is_met(surface.number_of_vertices(), false);
  for (std::uint32_t root = 0; root < surface.number_of_vertices(); ++root) {
    if (is_met[root])
      continue;
    is_met[root] = true;
    std::vector<std::uint32_t> front(1, root);
    for (std::size_t i = 0; i < front.size();) {
      const std::uint32_t v = is_breadth_first ? front[i++] : front.back();
      if (!is_breadth_first)
        front.pop_back();
      for (std::uint32_t dart = surface.first[v]; dart < surface.first[v + 1]; ++dart)
        if (!is_met[surface.neighbor[dart]]) {
          is_met[surface.neighbor[dart]] = true;
          marks[dart] = true;
          front.push_back(surface.neighbor[dart]);
        }
    }
  }
  return marks;
}

struct Reduced
{
  std::string complaint;
  DFS::internal::Reduction_counts counts;
  std::size_t before = 0, after = 0;
};

Reduced reduce_search_tree(const Triangle_list& s, bool is_breadth_first)
{
  using namespace DFS::internal;
  std::mt19937 random(1);
  const Embedded_graph g = embed(s, random);
  Rotation_system<std::uint32_t> surface;
  Embedding_reader(g.graph, g.embedding(), g.index_map(), g.boundary_map()).read(surface);
  Dart_marks marks = search_tree(surface, is_breadth_first);
  const auto degrees = [&] {
    std::vector<std::size_t> degree(surface.number_of_vertices(), 0);
    for (std::uint32_t v = 0; v < surface.number_of_vertices(); ++v)
      for (std::uint32_t dart = surface.first[v]; dart < surface.first[v + 1]; ++dart)
        if (marks[dart]) {
          ++degree[v];
          ++degree[surface.neighbor[dart]];
        }
    return degree;
  };
  const auto largest_of = [](const auto& d) { return *std::max_element(d.begin(), d.end()); };
  const std::size_t before = largest_of(degrees());
  Witnesses witnesses;
  Reduced result{"", Reduce_degrees<std::uint32_t>(surface, marks)(witnesses)};
  result.before = before;
  result.after = largest_of(degrees());
  Disjoint_sets<std::uint32_t> sets(surface.number_of_vertices());
  std::size_t edges = 0;
  for (std::uint32_t v = 0; v < surface.number_of_vertices(); ++v)
    for (std::uint32_t dart = surface.first[v]; dart < surface.first[v + 1]; ++dart)
      if (marks[dart] && (++edges, !sets.unite(v, surface.neighbor[dart])))
        result.complaint = "a cycle";
  const auto topology = DFS::surface_topology(g.surface());
  if (edges + topology.components.size() + topology.number_of_isolated_vertices != std::size_t(s.n))
    result.complaint = "the tree does not span the surface";
  const std::string of_witnesses = check_witnesses(s, witnesses, result.after);
  return of_witnesses.empty() ? result : Reduced{of_witnesses, result.counts};
}

// The graph of one component with at most 64 vertices, each the set of its neighbours.
std::vector<std::uint64_t> neighbor_sets(const Triangle_list& s)
{
  std::vector<std::uint64_t> result(std::size_t(s.n), 0);
  for (const Triangle& t : s.triangles)
    for (const int a : t)
      for (const int b : t)
        if (a != b)
          result[std::size_t(a)] |= std::uint64_t(1) << b;
  return result;
}

std::size_t components_without(const std::vector<std::uint64_t>& graph, std::uint64_t x)
{
  std::size_t count = 0;
  std::uint64_t met = x;
  for (std::size_t root = 0; root < graph.size(); ++root) {
    if ((met >> root & 1) != 0)
      continue;
    ++count;
    std::vector<std::size_t> stack(1, root);
    met |= std::uint64_t(1) << root;
    while (!stack.empty()) {
      const std::uint64_t found = graph[stack.back()] & ~met;
      stack.pop_back();
      met |= found;
      for (std::size_t v = 0; v < graph.size(); ++v)
        if ((found >> v & 1) != 0)
          stack.push_back(v);
    }
  }
  return count;
}

// The least number of vertices that separate the others, or 5 if it takes more than four.
std::size_t connectivity_by_trial(const std::vector<std::uint64_t>& graph)
{
  std::size_t least = 5;
  const auto extend = [&](const auto& self, std::uint64_t x, std::size_t size, std::size_t from) {
    if (size >= least)
      return;
    if (components_without(graph, x) > 1) {
      least = size;
      return;
    }
    for (std::size_t v = from; v < graph.size(); ++v)
      self(self, x | std::uint64_t(1) << v, size + 1, v + 1);
  };
  extend(extend, 0, 0, 0);
  return least;
}

Triangle_list icosahedron()
{
  Triangle_list s{12, {}};
  for (int i = 0; i < 5; ++i) {
    const int j = (i + 1) % 5;
    s.triangles.push_back({10, i, j});
    s.triangles.push_back({i, j, 5 + i});
    s.triangles.push_back({j, 5 + i, 5 + j});
    s.triangles.push_back({11, 5 + i, 5 + j});
  }
  return s;
}

// Each triangle cut into four, at the middles of its edges.
Triangle_list subdivided(const Triangle_list& s)
{
  Triangle_list result{s.n, {}};
  std::map<std::pair<int, int>, int> middle;
  for (const Triangle& t : s.triangles) {
    Triangle m;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [it, is_new] = middle.emplace(ends(t[k], t[(k + 1) % 3]), result.n);
      result.n += is_new ? 1 : 0;
      m[k] = it->second;
    }
    result.triangles.push_back(m);
    for (std::size_t k = 0; k < 3; ++k)
      result.triangles.push_back({t[k], m[k], m[(k + 2) % 3]});
  }
  return result;
}

DFS::Surface_component_topology topology_of(const Triangle_list& s)
{
  std::mt19937 random(1);
  const Embedded_graph g = embed(s, random);
  const auto topology = DFS::surface_topology(g.surface());
  BOOST_TEST_REQUIRE(topology.components.size() == 1u);
  return topology.components[0];
}

// Checks that no set X of vertices leaves more components than the bound's proof allows.
void check_all_sets(const std::vector<std::uint64_t>& graph, std::size_t connectivity,
                    std::ptrdiff_t chi)
{
  const std::ptrdiff_t k = std::ptrdiff_t(connectivity);
  for (std::uint64_t x = 0; x < std::uint64_t(1) << graph.size(); ++x) {
    std::ptrdiff_t size = 0;
    for (std::uint64_t rest = x; rest != 0; rest &= rest - 1)
      ++size;
    const auto c = std::ptrdiff_t(components_without(graph, x));
    BOOST_TEST_REQUIRE((c < 2 || (k * c <= size * (size - 1) && (k - 2) * c <= 2 * (size - chi))));
  }
}

// The trees from a bad start obey the bound for the connectivity that is there, known or not.
void check_search_trees(const Triangle_list& s, DFS::Surface_component_topology topology,
                        std::size_t connectivity)
{
  topology.connectivity = connectivity;
  for (const bool is_breadth_first : {true, false}) {
    const Reduced r = reduce_search_tree(s, is_breadth_first);
    BOOST_TEST(r.complaint == "");
    BOOST_TEST(r.after <= topology.near_minimum_tree_degree_bound());
  }
}

} // namespace

// Every spanning tree has a degree of 3, 7 and 11 at least; the tree of bounded degree has more
// than the bound.
BOOST_AUTO_TEST_CASE(stacked_complete_graphs)
{
  struct Expected
  {
    int n;
    std::size_t genus, bound, least;
  };
  for (const Expected e :
       {Expected{7, 1, 4, 3}, Expected{19, 20, 8, 7}, Expected{31, 63, 12, 11}}) {
    const Triangle_list s = stacked_complete_graph(e.n);
    const auto topology =
        DFS::surface_topology(CGAL::surface_of(to_halfedge_mesh<Surface_mesh>(s)));
    BOOST_TEST_REQUIRE(topology.components.size() == 1u);
    BOOST_TEST(topology.components[0].genus() == e.genus);
    std::vector<std::size_t> x(std::size_t(e.n));
    std::iota(x.begin(), x.end(), std::size_t(0));
    const DFS::Minimum_degree_witness by_hand{x, components_without(s, x), 0};
    BOOST_TEST(by_hand.number_of_components == std::size_t(e.n * (e.n - 1) / 3));
    BOOST_TEST(by_hand.least_degree() == e.least);
    const Found found = find_trees(s);
    BOOST_TEST_MESSAGE("K_" << e.n << ": " << found.subgraph << ", " << found.tree << ", now "
                            << found.near_minimum);
    BOOST_TEST(found.complaint == "");
    BOOST_TEST(found.bound == e.bound);
    BOOST_TEST(found.near_minimum <= e.bound);
    BOOST_TEST(found.near_minimum <= e.least + 1);
    if (found.near_minimum > 3)
      BOOST_TEST(found.least == e.least);
    if (e.n > 7)
      BOOST_TEST(found.tree > e.bound);
  }
}

BOOST_AUTO_TEST_CASE(bounds_by_connectivity)
{
  struct Expected
  {
    std::size_t genus, bounds[3];
  };
  for (const Expected& e : {Expected{0, {3, 3, 3}}, Expected{1, {4, 3, 3}}, Expected{2, {5, 3, 3}},
                            Expected{3, {5, 4, 3}}, Expected{14, {7, 5, 4}},
                            Expected{20, {8, 6, 5}}, Expected{133, {16, 11, 9}}}) {
    DFS::Surface_component_topology topology;
    topology.number_of_vertices = 1000;
    topology.number_of_edges = 3 * (1000 + 2 * e.genus - 2);
    topology.number_of_triangles = 2 * (1000 + 2 * e.genus - 2);
    BOOST_TEST_REQUIRE(topology.genus() == e.genus);
    for (std::size_t k = 3; k <= 5; ++k) {
      topology.connectivity = k;
      BOOST_TEST(topology.near_minimum_tree_degree_bound() == e.bounds[k - 3]);
    }
  }
}

// Against all sets of up to four vertices: what is claimed is true, and on spheres nothing is
// missed, since every cycle separates them.
BOOST_AUTO_TEST_CASE(connectivity_of_small_surfaces)
{
  std::vector<Triangle_list> all = {tetrahedron(),
                                    double_wheel(3),
                                    double_wheel(4),
                                    double_wheel(7),
                                    icosahedron(),
                                    nested_triangles(4),
                                    grid_torus(5, 5),
                                    grid_torus(4, 6),
                                    grid_torus(3, 5),
                                    projective_plane(),
                                    complete_graph(7),
                                    complete_graph(19),
                                    subdivided(tetrahedron()),
                                    subdivided(double_wheel(4)),
                                    subdivided(projective_plane()),
                                    subdivided(complete_graph(7))};
  for (int seed = 0; seed < 400; ++seed) {
    std::mt19937 random(static_cast<unsigned>(seed));
    Triangle_list s = seed % 4 == 0   ? icosahedron()
                      : seed % 4 == 1 ? double_wheel(6)
                      : seed % 4 == 2 ? grid_torus(4, 5)
                                      : connected_sum(complete_graph(7), grid_torus(3, 3), random);
    flip_edges(s, seed / 4 % 8, random);
    shuffle_names(s, random);
    all.push_back(s);
  }
  for (int seed = 0; seed < 1000; ++seed)
    all.push_back(cook(random_recipe(seed, false)));
  std::map<std::pair<bool, std::size_t>, int> found; // by whether it is a sphere
  int missed = 0, with_boundary = 0;
  for (const Triangle_list& s : all) {
    std::mt19937 random(1);
    const Embedded_graph g = embed(s, random);
    const auto components = DFS::surface_topology(g.surface()).components;
    for (const auto& component : components)
      if (component.number_of_boundary_loops > 0 && ++with_boundary > 0)
        BOOST_TEST(component.connectivity == 3u);
    if (s.n > 34 || components.size() != 1 || components[0].number_of_boundary_loops > 0 ||
        components[0].number_of_vertices != std::size_t(s.n))
      continue;
    const auto graph = neighbor_sets(s);
    const std::size_t claimed = components[0].connectivity, is = connectivity_by_trial(graph);
    BOOST_TEST_REQUIRE(claimed <= is);
    if (components[0].euler_genus() == 0 && s.n > 4)
      BOOST_TEST_REQUIRE(claimed == is);
    missed += claimed < is ? 1 : 0;
    ++found[{components[0].euler_genus() == 0, claimed}];
    if (s.n <= 12)
      check_all_sets(graph, is, components[0].euler_characteristic());
    check_search_trees(s, components[0], is);
  }
  for (const bool is_sphere : {true, false})
    for (std::size_t k = 3; k <= 5; ++k) {
      const int count = found[std::make_pair(is_sphere, k)];
      BOOST_TEST_MESSAGE((is_sphere ? "spheres" : "others") << " with " << k << ": " << count);
      BOOST_TEST(count > 0);
    }
  BOOST_TEST_MESSAGE(missed << " more are better connected than was found");
  BOOST_TEST(with_boundary > 0);
}

// One component of several may be better connected than the others.
BOOST_AUTO_TEST_CASE(connectivity_of_each_component)
{
  std::mt19937 random(1);
  const Embedded_graph g = embed(
      disjoint_union(disjoint_union(icosahedron(), nested_triangles(3)), double_wheel(4)), random);
  const auto components = DFS::surface_topology(g.surface()).components;
  BOOST_TEST_REQUIRE(components.size() == 3u);
  BOOST_TEST(components[0].connectivity == 5u);
  BOOST_TEST(components[1].connectivity == 3u);
  BOOST_TEST(components[2].connectivity == 4u);
}

// Of genus 14 and 4-connected: every spanning tree has degree 4 at least, and the search stops at
// 5. The bound that needs no connectivity is 7. Cycles of three edges that separate nothing keep
// the count from telling.
BOOST_AUTO_TEST_CASE(stacked_quadrangles_of_a_complete_graph)
{
  const Triangle_list s = stacked_quadrangles();
  auto topology = topology_of(s);
  BOOST_TEST(topology.genus() == 14u);
  BOOST_TEST(topology.connectivity == 3u);
  BOOST_TEST(topology.near_minimum_tree_degree_bound() == 7u);
  topology.connectivity = connectivity_by_trial(neighbor_sets(s));
  BOOST_TEST(topology.connectivity == 4u);
  BOOST_TEST(topology.near_minimum_tree_degree_bound() == 5u);
  std::vector<std::size_t> x(13);
  std::iota(x.begin(), x.end(), std::size_t(0));
  const DFS::Minimum_degree_witness by_hand{x, components_without(s, x), 0};
  BOOST_TEST(by_hand.number_of_components == 39u);
  BOOST_TEST(by_hand.least_degree() == 4u);
  const Found found = find_trees(s);
  BOOST_TEST(found.complaint == "");
  BOOST_TEST(found.near_minimum >= 4u);
  BOOST_TEST(found.near_minimum <= 5u);
  check_search_trees(s, topology, 4);
}

// High genus and 5-connected, which is found: from trees of degree up to 30.
BOOST_AUTO_TEST_CASE(subdivided_complete_graphs)
{
  for (const int n : {7, 19, 31}) {
    const Triangle_list s = subdivided(complete_graph(n));
    const auto topology = topology_of(s);
    BOOST_TEST(topology.connectivity == 5u);
    check_search_trees(s, topology, 5);
    BOOST_TEST(topology_of(stacked(s)).connectivity == 3u);
  }
}

BOOST_AUTO_TEST_CASE(bouquets_with_pockets)
{
  const std::size_t bounds[] = {0, 4, 5, 5, 5, 5, 6};
  for (const int genus : {1, 2, 3, 6}) {
    Bouquet bouquet = orientable_bouquet(genus);
    bouquet.has_pockets = true;
    const Found found = find_trees(triangulated(bouquet));
    BOOST_TEST(found.complaint == "");
    BOOST_TEST(found.bound == bounds[genus]);
    BOOST_TEST(found.tree > 3u);
    BOOST_TEST(found.near_minimum == 3u);
  }
}

// Hundreds of exchanges near one vertex: each goes on around it where the one before ended.
BOOST_AUTO_TEST_CASE(many_exchanges_near_one_vertex)
{
  using namespace DFS::internal;
  Bouquet bouquet = orientable_bouquet(200);
  bouquet.has_pockets = true;
  std::mt19937 random(1);
  const Embedded_graph g = embed(triangulated(bouquet), random);
  Rotation_system<std::uint32_t> surface;
  Embedding_reader(g.graph, g.embedding(), g.index_map(), g.boundary_map()).read(surface);
  Dart_marks marks;
  {
    Bounded_degree_marks<std::uint32_t> find_tree(surface, Subgraph_kind::TREE);
    marks = find_tree();
    find_tree.close();
  }
  Witnesses witnesses;
  const Reduction_counts counts = Reduce_degrees<std::uint32_t>(surface, marks)(witnesses);
  BOOST_TEST_MESSAGE(counts.exchanges_nearby << " exchanges, " << counts.corners << " corners of "
                                             << surface.number_of_darts());
  BOOST_TEST(counts.exchanges_nearby > 300u);
  BOOST_TEST(counts.corners < surface.number_of_darts());
}

BOOST_AUTO_TEST_CASE(random_surfaces)
{
  const auto check = [](const Surface_recipe& recipe) {
    try {
      return find_trees(cook(recipe)).complaint;
    } catch (const std::exception& e) {
      return std::string("an exception: ") + e.what();
    }
  };
  for (int seed = 0; seed < 3000; ++seed) {
    const std::string complaint = check_and_shrink(random_recipe(seed, seed % 3 == 0), check);
    BOOST_REQUIRE_MESSAGE(complaint.empty(), complaint);
  }
}

// Stacked once or twice, with all their faces or some: surfaces of genus up to 20 on which 3 is out
// of reach, with boundary too.
BOOST_AUTO_TEST_CASE(surfaces_that_need_large_degrees)
{
  std::size_t largest = 0, above_least = 0;
  for (int seed = 0; seed < 60; ++seed) {
    std::mt19937 random(static_cast<unsigned>(seed));
    Triangle_list s = stacked_complete_graph(seed % 2 == 0 ? 19 : 7);
    if (seed % 3 == 1)
      s = connected_sum(s, stacked_complete_graph(7), random);
    if (seed % 4 >= 2)
      s = stacked(s);
    flip_edges(s, 3 * (seed % 5), random);
    for (int hole = 0; hole < seed % 6; ++hole)
      puncture(s, random);
    if (seed % 5 == 0)
      s = disjoint_union(s, stacked_complete_graph(19));
    shuffle_names(s, random);
    const Found found = find_trees(s);
    BOOST_TEST(found.complaint == "");
    largest = (std::max)(largest, found.near_minimum);
    above_least += found.near_minimum > found.least ? 1 : 0;
  }
  BOOST_TEST(largest >= 7u);
  BOOST_TEST_MESSAGE("degrees up to " << largest << ", one above the least in " << above_least);
}

// Trees with vertices of any degree: exchanges near a vertex do not suffice, nor does a search that
// is stopped by every vertex of degree k - 1.
BOOST_AUTO_TEST_CASE(bad_trees)
{
  std::size_t phases = 0, nearby = 0;
  for (int seed = 0; seed < 400; ++seed)
    for (const bool is_breadth_first : {true, false}) {
      const Reduced r = reduce_search_tree(cook(random_recipe(seed, false)), is_breadth_first);
      BOOST_TEST(r.complaint == "");
      phases += r.counts.phases - r.counts.phases_in_vain;
      nearby += r.counts.exchanges_nearby;
    }
  for (const int n : {7, 19, 31})
    for (const bool is_breadth_first : {true, false}) {
      const Reduced r = reduce_search_tree(stacked_complete_graph(n), is_breadth_first);
      BOOST_TEST(r.complaint == "");
      BOOST_TEST(r.before > r.after);
      phases += r.counts.phases - r.counts.phases_in_vain;
      nearby += r.counts.exchanges_nearby;
    }
  BOOST_TEST_MESSAGE(nearby << " exchanges nearby, " << phases << " phases that found one");
  BOOST_TEST(nearby > 0u);
  BOOST_TEST(phases > 0u);
}

// Phases alone, without exchanges nearby: each leaves as many vertices less of the largest degree k
// as it says, and none above, or propagation through vertices of degree k - 1 is wrong.
BOOST_AUTO_TEST_CASE(a_phase_takes_vertices_of_the_largest_degree_away)
{
  using namespace DFS::internal;
  std::size_t phases = 0;
  std::vector<Triangle_list> all = {stacked_complete_graph(7), stacked_complete_graph(19)};
  for (int seed = 0; seed < 100; ++seed)
    all.push_back(cook(random_recipe(seed, false)));
  for (const Triangle_list& s : all) {
    std::mt19937 random(1);
    const Embedded_graph g = embed(s, random);
    Rotation_system<std::uint32_t> surface;
    Embedding_reader(g.graph, g.embedding(), g.index_map(), g.boundary_map()).read(surface);
    Dart_marks marks = search_tree(surface, true);
    Exchange_tree<std::uint32_t> tree(surface, marks);
    Degree_phase<std::uint32_t> phase(tree);
    std::uint32_t root = 0;
    while (surface.degree(root) == 0)
      ++root;
    for (bool succeeds = true; succeeds; ++phases) {
      std::map<std::uint32_t, int> before, after;
      std::vector<bool> is_met(surface.number_of_vertices(), false);
      tree.for_each_from(root, is_met, [&](auto v, auto) { ++before[tree.degree(v)]; });
      const std::uint32_t k = before.rbegin()->first;
      if (k < 4)
        break;
      const std::size_t lighter = phase(root, k);
      succeeds = lighter > 0;
      is_met.assign(surface.number_of_vertices(), false);
      tree.for_each_from(root, is_met, [&](auto v, auto) { ++after[tree.degree(v)]; });
      BOOST_TEST_REQUIRE(after.rbegin()->first <= k);
      BOOST_TEST_REQUIRE(std::size_t(after[k]) + lighter <= std::size_t(before[k]));
    }
  }
  BOOST_TEST(phases > 100u);
}

// Closed or not, of one component or of several. What is no simple triangulated surface is refused
// by name, as it is by the functions for bounded degrees.
BOOST_AUTO_TEST_CASE(meshes_of_the_data_archive)
{
  const std::filesystem::path folder = DELAUNAY_FROM_SURFACE_3_DATA_DIR;
  if (!std::filesystem::exists(folder / "elephant.off")) {
    BOOST_TEST_MESSAGE("skipped: the meshes are not there");
    return;
  }
  std::size_t served = 0, refused = 0, improved = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    Surface_mesh mesh;
    if (entry.path().extension() != ".off" || std::filesystem::file_size(entry.path()) > 2000000 ||
        !CGAL::IO::read_OFF(entry.path().string(), mesh))
      continue;
    std::vector<Surface_mesh::Edge_index> edges, tree;
    Witnesses witnesses;
    try {
      CGAL::near_minimum_degree_spanning_tree(CGAL::surface_of(mesh), std::back_inserter(edges),
                                              std::back_inserter(witnesses));
    } catch (const CGAL::Surface_input_error& e) {
      BOOST_TEST(edges.empty());
      BOOST_CHECK_THROW(
          CGAL::bounded_degree_spanning_tree(CGAL::surface_of(mesh), std::back_inserter(tree)),
          CGAL::Surface_input_error);
      ++refused;
      continue;
    }
    CGAL::bounded_degree_spanning_tree(CGAL::surface_of(mesh), std::back_inserter(tree));
    const auto found = CGAL::certify_spanning_subgraph(CGAL::surface_of(mesh), edges);
    BOOST_TEST(found.is_valid_near_minimum_tree(), entry.path().string());
    for (const auto& witness : witnesses)
      BOOST_TEST(witness.is_within_one());
    improved += found.maximum_degree <
                        CGAL::certify_spanning_subgraph(CGAL::surface_of(mesh), tree).maximum_degree
                    ? 1
                    : 0;
    ++served;
  }
  BOOST_TEST_MESSAGE(served << " meshes, of which " << improved << " are better now; " << refused
                            << " refused");
  BOOST_TEST(improved > 0u);
}

BOOST_AUTO_TEST_CASE(what_needs_nothing_gets_the_tree_of_bounded_degree)
{
  for (const Triangle_list& s : {nested_triangles(50), double_wheel(30), fan(20)}) {
    const Surface_mesh mesh = to_halfedge_mesh<Surface_mesh>(s);
    std::vector<Surface_mesh::Edge_index> edges, tree;
    CGAL::near_minimum_degree_spanning_tree(CGAL::surface_of(mesh), std::back_inserter(edges));
    CGAL::bounded_degree_spanning_tree(CGAL::surface_of(mesh), std::back_inserter(tree));
    BOOST_TEST((edges == tree));
  }
  std::vector<Surface_mesh::Edge_index> edges;
  CGAL::near_minimum_degree_spanning_tree(CGAL::surface_of(Surface_mesh()),
                                          std::back_inserter(edges));
  BOOST_TEST(edges.empty());
}
