// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bounds on the degree are tight: on bouquets with pockets they are attained, for every kind of
// surface and for the tree as well. And the loop that peels a disc gives what the recursion of Choi
// 2002, Fig. 3, gives.

#define BOOST_TEST_MODULE bounded_degree_attained
#include <boost/test/included/unit_test.hpp>

#include <Delaunay_from_surface_3_triangle_lists/Surface_recipe.h>
#include <Delaunay_from_surface_3_triangle_lists/Triangle_list.h>
#include <Delaunay_from_surface_3_triangle_lists/bouquet.h>

#include <CGAL/Delaunay_from_surface_3/surface/Embedding_reader.h>
#include <CGAL/Delaunay_from_surface_3/surface/Open_along_cut.h>
#include <CGAL/Delaunay_from_surface_3/surface/Peel_discs.h>
#include <CGAL/Delaunay_from_surface_3/surface/surface_topology.h>
#include <CGAL/bounded_degree_spanning_subgraph.h>
#include <CGAL/certify_spanning_subgraph.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;

using namespace triangle_lists;

namespace {

using Edges = std::vector<Embedded_graph::Edge>;

struct Degrees
{
  std::size_t subgraph, tree, bound;
};

Degrees certified_degrees(const Embedded_graph& g)
{
  Edges subgraph, tree;
  CGAL::bounded_degree_spanning_subgraph(g.surface(), std::back_inserter(subgraph));
  CGAL::bounded_degree_spanning_tree(g.surface(), std::back_inserter(tree));
  const auto of_subgraph = CGAL::certify_spanning_subgraph(g.surface(), subgraph);
  const auto of_tree = CGAL::certify_spanning_subgraph(g.surface(), tree);
  BOOST_TEST(of_subgraph.is_valid_subgraph());
  BOOST_TEST(of_tree.is_valid_tree());
  return {of_subgraph.maximum_degree, of_tree.maximum_degree, of_subgraph.largest_degree_bound};
}

// The largest degrees found in some orders of the vertices, each time by turning around the lists
// of those that lead to the corner, one after the other: where the search has to choose between two
// middle edges the direction decides, and the sides of the polygon are to be the cut.
Degrees largest_degrees(const Bouquet& bouquet)
{
  std::mt19937 random(1);
  Degrees largest = {0, 0, 1};
  for (int order = 0; order < 40 && largest.subgraph < largest.bound; ++order) {
    int corner = 1;
    Embedded_graph g = embed(renumbered(triangulated(bouquet), corner, random), random);
    Degrees best = certified_degrees(g);
    for (auto [u, end] = adjacent_vertices(std::size_t(corner), g.graph); u != end; ++u) {
      std::reverse(g.lists[*u].begin(), g.lists[*u].end());
      const Degrees d = certified_degrees(g);
      if (d.subgraph > best.subgraph)
        best = d;
      else
        std::reverse(g.lists[*u].begin(), g.lists[*u].end());
    }
    if (best.subgraph > largest.subgraph)
      largest = best;
  }
  return largest;
}

} // namespace

// Each copy of the one vertex has to lead to its pocket: that is an edge for each on top of the
// cut's.
BOOST_AUTO_TEST_CASE(bounds_are_attained_on_closed_surfaces)
{
  for (int h = 2; h <= 8; ++h) // on the projective plane the two pockets would have the same edge
    for (const bool is_orientable : {true, false}) {
      if (is_orientable && h % 2 == 1)
        continue;
      Bouquet bouquet = is_orientable ? orientable_bouquet(h / 2) : non_orientable_bouquet(h);
      std::mt19937 random(1);
      const Degrees plain = certified_degrees(embed(triangulated(bouquet), random));
      bouquet.has_pockets = true;
      const Degrees d = largest_degrees(bouquet);
      BOOST_TEST_MESSAGE("h = " << h << (is_orientable ? ", orientable" : "") << ": "
                                << plain.subgraph << " and tree " << plain.tree << "; with pockets "
                                << d.subgraph << " and " << d.tree);
      BOOST_TEST(d.bound == std::size_t(4 * h));
      BOOST_TEST(d.subgraph == std::size_t(4 * h));
      BOOST_TEST(d.tree == std::size_t(3 * h));
    }
}

BOOST_AUTO_TEST_CASE(bounds_are_attained_on_surfaces_with_boundary)
{
  for (int h = 0; h <= 4; ++h)
    for (int b = 1; b <= 3; ++b)
      for (const bool has_loop_at_corner : {true, false}) {
        if (h == 0 && (b == 1 || (b == 2 && !has_loop_at_corner)))
          continue; // a disc; and one edge for two pockets
        Bouquet bouquet = h % 2 == 0 ? orientable_bouquet(h / 2) : non_orientable_bouquet(h);
        bouquet.has_loop_at_corner = has_loop_at_corner;
        bouquet.loops_elsewhere = b - has_loop_at_corner;
        bouquet.has_pockets = true;
        const Degrees d = largest_degrees(bouquet);
        BOOST_TEST_MESSAGE("h = " << h << ", b = " << b
                                  << (has_loop_at_corner ? ", one at the corner" : "") << ": "
                                  << d.subgraph << " and tree " << d.tree << ", bound " << d.bound);
        BOOST_TEST(d.bound == std::size_t(4 * h + 2 * b + 1));
        // A vertex on the boundary can have one more than the others.
        BOOST_TEST(d.subgraph + !has_loop_at_corner == d.bound);
        BOOST_TEST(d.tree == std::size_t((std::max)(3, 3 * h + 2 * b)));
      }
}

namespace {

// bsg(G, C) as Fig. 3 has it: recursive, with sets. Of the vertices without chord the one that
// `choose` prefers is taken.
class Literal_recursion
{
public:
  using Edge_set = std::set<std::pair<int, int>>;

  // `second` may say for some z which end of the chain is z2; of z1 and zm the recursion takes the
  // one with the smaller number for z1.
  explicit Literal_recursion(const Triangle_list& disc, std::map<int, int> second = {})
    : m_triangles(disc.triangles.begin(), disc.triangles.end())
    , m_second(std::move(second))
  {
  }

  template <class Choose>
  Edge_set operator()(const Choose& choose)
  {
    return bsg(choose);
  }

private:
  std::map<int, std::set<int>> neighbors() const
  {
    std::map<int, std::set<int>> result;
    for (const Triangle& t : m_triangles)
      for (int k = 0; k < 3; ++k)
        result[t[std::size_t(k)]].insert(
            {t[std::size_t((k + 1) % 3)], t[std::size_t((k + 2) % 3)]});
    return result;
  }

  Edge_set cycle() const
  {
    std::map<std::pair<int, int>, int> uses;
    for (const Triangle& t : m_triangles)
      for (std::size_t k = 0; k < 3; ++k)
        ++uses[ends(t[k], t[(k + 1) % 3])];
    Edge_set result;
    for (const auto& use : uses)
      if (use.second == 1)
        result.insert(use.first);
    return result;
  }

  // The neighbours of z in order, from one on the cycle to the other.
  std::vector<int> fan(int z) const
  {
    std::map<int, std::vector<int>> link;
    for (const Triangle& t : m_triangles)
      for (std::size_t k = 0; k < 3; ++k)
        if (t[k] == z) {
          link[t[(k + 1) % 3]].push_back(t[(k + 2) % 3]);
          link[t[(k + 2) % 3]].push_back(t[(k + 1) % 3]);
        }
    std::vector<int> result;
    for (const auto& l : link)
      if (l.second.size() == 1 && result.empty())
        result.push_back(l.first);
    while (result.size() < link.size())
      for (const int u : link[result.back()])
        if (result.size() == 1 || u != result[result.size() - 2]) {
          result.push_back(u);
          break;
        }
    return result;
  }

  template <class Choose>
  Edge_set bsg(const Choose& choose)
  {
    const auto all = neighbors();
    const Edge_set rim = cycle();
    if (all.size() == 3) // line 1
      return rim;
    std::set<int> on_cycle;
    for (const auto& e : rim)
      on_cycle.insert({e.first, e.second});
    std::vector<int> candidates; // line 2
    for (const int v : on_cycle) {
      const bool has_chord = std::any_of(all.at(v).begin(), all.at(v).end(), [&](int u) {
        return on_cycle.count(u) && !rim.count(ends(u, v));
      });
      if (on_cycle.size() == 3 ? all.at(v).size() > 2 : !has_chord)
        candidates.push_back(v);
    }
    BOOST_TEST_REQUIRE(!candidates.empty());
    const int z = choose(candidates);
    std::vector<int> f = fan(z); // line 3
    if (m_second.count(z) && m_second[z] != f[1])
      std::reverse(f.begin(), f.end());
    const std::size_t m = f.size();
    std::vector<Triangle> others;
    for (const Triangle& t : m_triangles)
      if (std::find(t.begin(), t.end(), z) == t.end())
        others.push_back(t);
    m_triangles = others;
    Edge_set h = bsg(choose);
    BOOST_TEST(h.count(ends(f[0], f[1])) == 1u);
    h.erase(ends(f[0], f[1]));
    h.erase(ends(f[m - 1], f[m - 2]));
    h.insert({ends(f[0], z), ends(f[1], z), ends(f[m - 1], z)});
    return h;
  }

  std::vector<Triangle> m_triangles;
  std::map<int, int> m_second;
};

// Lets Peel_discs peel a disc step by step, and notes what it does.
struct Watched_peeling
{
  std::vector<int> order;    // every z
  std::map<int, int> second; // z2 of each, if it has one
  Literal_recursion::Edge_set h;

  explicit Watched_peeling(const Embedded_graph& g)
  {
    using namespace DFS::internal;
    using Index = std::uint32_t;
    Rotation_system<Index> surface;
    Embedding_reader(g.graph, g.embedding(), g.index_map(), g.boundary_map()).read(surface);
    Opened_surface<Index> opened(surface);
    Dart_marks marks(surface.number_of_darts(), false);
    std::set<Index> on_cycle;
    for (Index v = 0; v < surface.number_of_vertices(); ++v)
      if (surface.on_boundary[v]) {
        opened.rim.push_back(v);
        on_cycle.insert(v);
        const Star<Index> star = surface.star(v);
        for (const Index u : {star[0], star[star.size() - 1]})
          h.insert(ends(int(v), int(u)));
      }
    Peel_discs<Index> peel(opened, marks);
    peel.start(surface.number_of_vertices() - opened.rim.size());
    while (peel.peel_next())
      for (const Index v : std::set<Index>(on_cycle))
        if (!peel.is_on_cycle(v)) {
          order.push_back(int(v));
          on_cycle.erase(v);
          const Star<Index> star = surface.star(v);
          for (Index i = 0; i < star.size(); ++i) {
            if (marks[surface.first[v] + i] && !on_cycle.count(star[i]) &&
                peel.is_on_cycle(star[i]))
              second[int(v)] = int(star[i]);
            if (peel.is_on_cycle(star[i]))
              on_cycle.insert(star[i]);
          }
        }
    for (Index v = 0; v < surface.number_of_vertices(); ++v)
      for (Index dart = surface.first[v]; dart < surface.first[v + 1]; ++dart)
        if (marks[dart])
          h.insert(ends(int(v), int(surface.neighbor[dart])));
  }
};

// The loop of Peel_discs, by the same sets: C first, then for each z a chain that hangs on it.
Literal_recursion::Edge_set peeled(const Triangle_list& disc, std::vector<int> order);

} // namespace

// What Peel_discs does, edge by edge, for the order in which it takes the vertices.
BOOST_AUTO_TEST_CASE(peel_discs_does_what_the_recursion_does)
{
  for (unsigned int seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    Triangle_list disc = polygon_with_chords(3 + int(seed) % 9, random);
    insert_vertices(disc, 3 + int(seed) % 7, random);
    flip_edges(disc, int(seed) % 15, random);
    const Watched_peeling watched(embed(disc, random));
    std::size_t step = 0;
    const auto choose = [&](const std::vector<int>& candidates) {
      if (step == watched.order.size()) // no vertex is inside any more
        return candidates.front();
      const int z = watched.order[step++];
      BOOST_TEST_REQUIRE(std::count(candidates.begin(), candidates.end(), z) == 1);
      return z;
    };
    BOOST_TEST((Literal_recursion(disc, watched.second)(choose) == watched.h));
    BOOST_TEST(step == watched.order.size());
  }
}

// The forward loop on the same discs: what the package gives is connected, spanning, of degree 3,
// contains the rim and has as many edges as the recursion, which is what Fig. 3 promises; and for
// the same choice of z the two agree edge by edge.
BOOST_AUTO_TEST_CASE(the_loop_does_what_the_recursion_does)
{
  for (unsigned int seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    Triangle_list disc = polygon_with_chords(3 + int(seed) % 9, random);
    insert_vertices(disc, 3 + int(seed) % 7, random);
    flip_edges(disc, int(seed) % 15, random);
    std::vector<int> order;
    const auto choose = [&](const std::vector<int>& candidates) {
      order.push_back(candidates[random() % candidates.size()]);
      return order.back();
    };
    const auto by_recursion = Literal_recursion(disc)(choose);
    std::map<int, int> degree;
    for (const auto& e : by_recursion)
      ++degree[e.first], ++degree[e.second];
    for (const auto& d : degree)
      BOOST_TEST(d.second <= 3);
    BOOST_TEST(degree.size() == std::size_t(disc.n));
    BOOST_TEST((by_recursion == peeled(disc, order)));

    const Embedded_graph g = embed(disc, random);
    Edges subgraph;
    CGAL::bounded_degree_spanning_subgraph(g.surface(), std::back_inserter(subgraph));
    BOOST_TEST(subgraph.size() == by_recursion.size());
    for (const auto& e : subgraph) // both contain the rim
      if (g.is_boundary[get(boost::edge_index, g.graph, e)])
        BOOST_TEST(by_recursion.count(ends(int(source(e, g.graph)), int(target(e, g.graph)))) ==
                   1u);
  }
}

namespace {

Literal_recursion::Edge_set peeled(const Triangle_list& disc, std::vector<int> order)
{
  std::map<std::pair<int, int>, int> uses;
  std::set<int> on_cycle, gone;
  Literal_recursion::Edge_set h;
  for (const Triangle& t : disc.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      ++uses[ends(t[k], t[(k + 1) % 3])];
  for (const auto& use : uses)
    if (use.second == 1) {
      h.insert(use.first);
      on_cycle.insert({use.first.first, use.first.second});
    }
  for (const int z : order) {
    std::map<int, std::set<int>> link; // of z, in what is left
    for (const Triangle& t : disc.triangles) {
      if (std::find(t.begin(), t.end(), z) == t.end() ||
          std::any_of(t.begin(), t.end(), [&](int v) { return gone.count(v) > 0; }))
        continue;
      for (std::size_t k = 0; k < 3; ++k)
        if (t[k] == z) {
          link[t[(k + 1) % 3]].insert(t[(k + 2) % 3]);
          link[t[(k + 2) % 3]].insert(t[(k + 1) % 3]);
        }
    }
    // From the smaller of the two on C: as the recursion's fan.
    int last = link.begin()->first;
    for (auto l = link.rbegin(); l != link.rend(); ++l)
      if (l->second.size() == 1)
        last = l->first;
    std::vector<int> fan = {last};
    while (fan.size() < link.size())
      for (const int u : link[fan.back()])
        if (fan.size() == 1 || u != fan[fan.size() - 2]) {
          fan.push_back(u);
          break;
        }
    // The recursion hangs z on z2, and z(m-1) on nothing but its chain.
    for (std::size_t k = 1; k + 1 < fan.size(); ++k) {
      h.insert(k == 1 ? ends(z, fan[1]) : ends(fan[k - 1], fan[k]));
      on_cycle.insert(fan[k]);
    }
    on_cycle.erase(z);
    gone.insert(z);
  }
  return h;
}

} // namespace
