// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lists of edges that describe no surface: each must be refused, with the place named, and nothing
// written.

#define BOOST_TEST_MODULE bounded_degree_bad_lists
#include <boost/test/included/unit_test.hpp>

#include <Delaunay_from_surface_3_triangle_lists/Triangle_list.h>

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/bounded_degree_spanning_subgraph.h>
#include <CGAL/certify_spanning_subgraph.h>

#include <iterator>
#include <string>
#include <utility>
#include <vector>

using namespace triangle_lists;

namespace {

Embedded_graph embedded(const Triangle_list& s)
{
  std::mt19937 random(1);
  return embed(s, random);
}

// The message with which a surface is refused; empty if it is not.
std::string refusal(const Embedded_graph& g)
{
  std::vector<Embedded_graph::Edge> edges;
  try {
    CGAL::bounded_degree_spanning_subgraph(g.surface(), std::back_inserter(edges));
  } catch (const CGAL::Surface_input_error& e) {
    BOOST_TEST(edges.empty());
    return e.what();
  }
  return "";
}

void check_says(const std::string& message, const std::vector<std::string>& words)
{
  for (const std::string& word : words)
    BOOST_TEST(message.find(word) != std::string::npos,
               "\"" << message << "\" does not say \"" << word << "\"");
}

} // namespace

BOOST_AUTO_TEST_CASE(a_doubled_edge_is_refused_by_both_names)
{
  Embedded_graph g = embedded(tetrahedron());
  g.lists[0].push_back(add_edge(0, 1, 6, g.graph).first);
  g.lists[1].push_back(g.lists[0].back());
  g.is_boundary.push_back(0);
  check_says(refusal(g), {"not simple", "edge (0, 1)", "2 times", "and 6 of edges(g)"});
}

// The two lists name different twins: every list looks simple, the graph is not.
BOOST_AUTO_TEST_CASE(twins_named_by_one_end_each_are_refused)
{
  Embedded_graph g = embedded(tetrahedron());
  const auto twin = add_edge(0, 1, 6, g.graph).first;
  g.is_boundary.push_back(0);
  for (auto& e : g.lists[0])
    if (target(e, g.graph) + source(e, g.graph) == 1)
      e = twin;
  check_says(refusal(g), {"not simple", "edge (0, 1)", "and 6 of edges(g)"});
}

BOOST_AUTO_TEST_CASE(a_loop_is_refused)
{
  Embedded_graph g = embedded(tetrahedron());
  const auto loop = add_edge(2, 2, 6, g.graph).first;
  g.is_boundary.push_back(0);
  g.lists[2].push_back(loop);
  g.lists[3].push_back(g.lists[3].front());
  BOOST_TEST(!refusal(g).empty());
  g.lists[3].pop_back();
  g.lists[2].push_back(loop);
  check_says(refusal(g), {"(2, 2)"});
}

BOOST_AUTO_TEST_CASE(a_missing_edge_is_refused)
{
  Embedded_graph g = embedded(tetrahedron());
  g.lists[3].pop_back();
  check_says(refusal(g), {"is missing from the list of vertex 3"});
}

BOOST_AUTO_TEST_CASE(an_edge_that_the_graph_has_no_more_is_refused)
{
  const Embedded_graph whole = embedded(tetrahedron());
  Embedded_graph g = whole; // whose lists name edges of `whole`
  remove_edge(2, 3, g.graph);
  check_says(refusal(g), {"the lists have edges that the graph does not have"});
}

// Vertex 3 has neither edges nor a list, but the lists of others lead there. The graph has as many
// edges as before the lists were cleared only because another list is missing too.
BOOST_AUTO_TEST_CASE(an_empty_list_that_others_lead_to_is_refused)
{
  const Embedded_graph whole = embedded(disjoint_union(tetrahedron(), tetrahedron()));
  Embedded_graph g = whole; // whose lists name edges of `whole`
  clear_vertex(3, g.graph);
  g.lists[3].clear();
  g.lists[7].clear();
  check_says(refusal(g), {"inconsistent lists"});
}

// A tip without a mark, whose two triangles would be the same one.
BOOST_AUTO_TEST_CASE(an_inner_vertex_of_two_edges_is_refused)
{
  Embedded_graph g = embedded({4, {{0, 1, 2}, {2, 1, 3}}});
  g.is_boundary.assign(g.is_boundary.size(), 0);
  check_says(refusal(g), {"vertex 0 has two edges and none is marked as boundary"});
}

BOOST_AUTO_TEST_CASE(an_edge_twice_in_a_list_is_refused)
{
  Embedded_graph g = embedded(tetrahedron());
  g.lists[3].back() = g.lists[3].front();
  check_says(refusal(g), {"stands twice in the list of vertex 3"});
}

BOOST_AUTO_TEST_CASE(a_foreign_edge_is_refused)
{
  Embedded_graph g = embedded(double_wheel(6));
  for (const auto& e : g.lists[6])
    if (source(e, g.graph) != 0 && target(e, g.graph) != 0) {
      g.lists[0].back() = e;
      break;
    }
  check_says(refusal(g), {"vertex 0", "which does not end there"});
}

BOOST_AUTO_TEST_CASE(lists_that_disagree_are_refused)
{
  Embedded_graph g = embedded(grid_torus(5, 5));
  std::swap(g.lists[7][1], g.lists[7][3]);
  check_says(refusal(g), {"inconsistent lists", "vertex 7"});
}

BOOST_AUTO_TEST_CASE(boundary_edges_in_wrong_places_are_refused)
{
  const Embedded_graph disc = embedded(fan(6));
  Embedded_graph g = disc;
  std::rotate(g.lists[0].begin(), g.lists[0].begin() + 2, g.lists[0].end());
  check_says(refusal(g), {"vertex 0", "not at an end"});
  g = disc; // an inner edge called boundary
  g.is_boundary[get(boost::edge_index, g.graph, g.lists[0][3])] = 1;
  BOOST_TEST(!refusal(g).empty());
  g = disc; // a boundary edge called inner
  g.is_boundary[get(boost::edge_index, g.graph, g.lists[0].front())] = 0;
  check_says(refusal(g), {"does not start and end with a boundary edge"});
  g = disc; // nothing called boundary
  g.is_boundary.assign(g.is_boundary.size(), 0);
  check_says(refusal(g), {"inconsistent lists"});
}

BOOST_AUTO_TEST_CASE(a_pinched_vertex_is_refused)
{
  Embedded_graph g = embedded(disjoint_union(fan(3), fan(3)));
  // Two fans around vertex 0, written into one list.
  Embedded_graph pinched;
  pinched.graph = Embedded_graph::Graph(9);
  int edges_made = 0;
  const auto link = [&](int a, int b) {
    pinched.is_boundary.push_back(0);
    return add_edge(a, b, edges_made++, pinched.graph).first;
  };
  pinched.lists.resize(9);
  for (int base : {1, 5}) {
    std::vector<Embedded_graph::Edge> spokes, rim;
    for (int i = 0; i < 4; ++i)
      spokes.push_back(link(0, base + i));
    for (int i = 0; i < 3; ++i)
      rim.push_back(link(base + i, base + i + 1));
    for (int i = 0; i < 4; ++i) {
      if (i > 0)
        pinched.lists[base + i].push_back(rim[i - 1]);
      pinched.lists[base + i].push_back(spokes[i]);
      if (i < 3)
        pinched.lists[base + i].push_back(rim[i]);
      pinched.lists[0].push_back(spokes[i]);
    }
    for (const auto& e : {spokes.front(), spokes.back(), rim[0], rim[1], rim[2]})
      pinched.is_boundary[get(boost::edge_index, pinched.graph, e)] = 1;
  }
  check_says(refusal(pinched), {"vertex 0"});
  BOOST_TEST(refusal(g).empty());
}

BOOST_AUTO_TEST_CASE(an_edge_alone_is_refused)
{
  Embedded_graph g;
  g.graph = Embedded_graph::Graph(2);
  g.lists.assign(2, {add_edge(0, 1, 0, g.graph).first});
  g.is_boundary.assign(1, 0);
  check_says(refusal(g), {"edge (0, 1) lies in no triangle"});
}

// Two random entries of a random list change places: refused, or, where both orders describe a
// surface, served.
BOOST_AUTO_TEST_CASE(random_damage_never_goes_unnoticed)
{
  int refused = 0;
  for (int seed = 0; seed < 3000; ++seed) {
    std::mt19937 random{unsigned(seed)};
    Triangle_list s = seed % 3 == 0   ? grid_torus(3, 4)
                      : seed % 3 == 1 ? projective_plane()
                                      : fan(5);
    insert_vertices(s, 5 + seed % 10, random);
    flip_edges(s, 20, random);
    Embedded_graph g = embed(s, random);
    auto& list = g.lists[std::uniform_int_distribution<std::size_t>(0, g.lists.size() - 1)(random)];
    const auto pick = [&] {
      return std::uniform_int_distribution<std::size_t>(0, list.size() - 1)(random);
    };
    std::swap(list[pick()], list[pick()]);
    const std::string message = refusal(g);
    if (!message.empty()) {
      ++refused;
      continue;
    }
    std::vector<Embedded_graph::Edge> edges;
    CGAL::bounded_degree_spanning_subgraph(g.surface(), std::back_inserter(edges));
    BOOST_REQUIRE(CGAL::certify_spanning_subgraph(g.surface(), edges).is_valid_subgraph());
  }
  BOOST_TEST(refused > 1500);
}
