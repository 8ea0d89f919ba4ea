// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Named regressions: inputs on which a plausible bookkeeping of the cycle deadlocks. Each is first
// run through that bookkeeping, to show that it still is such an input.

#define BOOST_TEST_MODULE bounded_degree_regressions
#include <boost/test/included/unit_test.hpp>

#include <Delaunay_from_surface_3_triangle_lists/Triangle_list.h>

#include <CGAL/Delaunay_from_surface_3/surface/surface_topology.h>
#include <CGAL/bounded_degree_spanning_subgraph.h>
#include <CGAL/certify_spanning_subgraph.h>

#include <iterator>
#include <set>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;

using namespace triangle_lists;

namespace {

enum class Bookkeeping { ONE_WAY_MARKS, ALL_AT_ONCE, ONE_AT_A_TIME };

// Peels a disc by textbook means (sets of neighbours, O(n^2)); returns whether every vertex is
// reached. What a vertex without chord is, is up to the bookkeeping.
class Textbook_peeling
{
public:
  Textbook_peeling(const Triangle_list& disc, Bookkeeping bookkeeping)
    : m_bookkeeping(bookkeeping)
    , m_neighbors(disc.n)
    , m_on_cycle(disc.n, false)
    , m_is_peeled(disc.n, false)
    , m_has_chord(disc.n, false)
    , m_count(disc.n, 0)
    , m_triangles(disc.triangles)
  {
    std::map<std::pair<int, int>, int> uses;
    for (const Triangle& t : disc.triangles)
      for (int k = 0; k < 3; ++k) {
        m_neighbors[t[k]].insert({t[(k + 1) % 3], t[(k + 2) % 3]});
        ++uses[ends(t[k], t[(k + 1) % 3])];
      }
    std::set<int> rim;
    for (const auto& use : uses)
      if (use.second == 1) {
        m_cycle_edges.insert(use.first);
        rim.insert({use.first.first, use.first.second});
      }
    m_inside = disc.n - int(rim.size());
    join(std::vector<int>(rim.begin(), rim.end()));
  }

  bool reaches_every_vertex()
  {
    for (bool moves = true; moves && m_inside > 0;) {
      moves = false;
      for (int z = 0; z < int(m_neighbors.size()) && !moves; ++z)
        if (m_on_cycle[z] && is_free(z)) {
          peel(z);
          moves = true;
        }
    }
    return m_inside == 0;
  }

private:
  bool is_free(int v) const
  {
    return m_bookkeeping == Bookkeeping::ONE_WAY_MARKS ? !m_has_chord[v] : m_count[v] == 2;
  }

  void peel(int z)
  {
    std::vector<int> fan;
    std::vector<int> live;
    m_is_peeled[z] = true;
    m_on_cycle[z] = false;
    for (int u : m_neighbors[z]) {
      if (m_is_peeled[u])
        continue;
      live.push_back(u);
      if (m_on_cycle[u])
        --m_count[u];
      else
        fan.push_back(u);
      m_cycle_edges.erase(ends(z, u));
    }
    for (const Triangle& t : m_triangles)
      for (int k = 0; k < 3; ++k)
        if (t[k] == z && !m_is_peeled[t[(k + 1) % 3]] && !m_is_peeled[t[(k + 2) % 3]])
          m_cycle_edges.insert(ends(t[(k + 1) % 3], t[(k + 2) % 3]));
    m_inside -= int(fan.size());
    join(fan);
  }

  void join(const std::vector<int>& fan)
  {
    if (m_bookkeeping == Bookkeeping::ALL_AT_ONCE)
      for (int w : fan)
        m_on_cycle[w] = true;
    for (int w : fan) {
      for (int u : m_neighbors[w])
        if (m_on_cycle[u] && !m_is_peeled[u]) {
          ++m_count[u];
          ++m_count[w];
        }
      m_on_cycle[w] = true;
    }
    for (int w : fan) // marks: set where a chord appears, never taken back
      for (int u : m_neighbors[w])
        if (m_on_cycle[u] && !m_cycle_edges.count(ends(u, w)))
          m_has_chord[u] = m_has_chord[w] = true;
  }

  Bookkeeping m_bookkeeping;
  std::vector<std::set<int>> m_neighbors;
  std::vector<bool> m_on_cycle, m_is_peeled, m_has_chord;
  std::vector<int> m_count;
  std::vector<Triangle> m_triangles;
  std::set<std::pair<int, int>> m_cycle_edges;
  int m_inside = 0;
};

bool deadlocks(const Triangle_list& disc, Bookkeeping bookkeeping)
{
  return !Textbook_peeling(disc, bookkeeping).reaches_every_vertex();
}

DFS::Spanning_subgraph_certificate certified_subgraph(const Triangle_list& s)
{
  std::mt19937 random(1);
  const Embedded_graph g = embed(s, random);
  std::vector<Embedded_graph::Edge> subgraph;
  CGAL::bounded_degree_spanning_subgraph(g.surface(), std::back_inserter(subgraph));
  return CGAL::certify_spanning_subgraph(g.surface(), subgraph);
}

// Only the ears 1, 3 and 5 have no chord; peeling an ear makes a chord an edge of the cycle, which
// must free its ends.
Triangle_list disc_with_chords()
{
  // A hexagon 0..5 with the chords 0-2, 2-4, 4-0 and the vertex 6 inside the middle triangle: only
  // the ears 1, 3 and 5 are free.
  return {7, {{0, 1, 2}, {2, 3, 4}, {4, 5, 0}, {0, 2, 6}, {2, 4, 6}, {4, 0, 6}}};
}

// Any fan of two new vertices does: each is a neighbour of the other.
Triangle_list disc_with_two_inside()
{
  return {5, {{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {2, 0, 4}, {0, 3, 4}}};
}

} // namespace

BOOST_AUTO_TEST_CASE(chord_marks_that_are_never_taken_back_deadlock)
{
  const Triangle_list disc = disc_with_chords();
  BOOST_TEST(deadlocks(disc, Bookkeeping::ONE_WAY_MARKS));
  BOOST_TEST(!deadlocks(disc, Bookkeeping::ONE_AT_A_TIME));
  BOOST_TEST(certified_subgraph(disc).is_valid_subgraph());
}

BOOST_AUTO_TEST_CASE(counting_new_cycle_vertices_all_at_once_deadlocks)
{
  const Triangle_list disc = disc_with_two_inside();
  BOOST_TEST(deadlocks(disc, Bookkeeping::ALL_AT_ONCE));
  BOOST_TEST(!deadlocks(disc, Bookkeeping::ONE_AT_A_TIME));
  BOOST_TEST(certified_subgraph(disc).is_valid_subgraph());
}

// How often the two deadlocks happen on random discs, and that counts one at a time never do.
BOOST_AUTO_TEST_CASE(deadlocks_on_random_discs)
{
  int marks = 0, all_at_once = 0, ours = 0;
  for (int seed = 0; seed < 300; ++seed) {
    std::mt19937 random{unsigned(seed)};
    Triangle_list disc = polygon_with_chords(12 + seed % 20, random);
    insert_vertices(disc, 10, random);
    flip_edges(disc, 20, random);
    marks += deadlocks(disc, Bookkeeping::ONE_WAY_MARKS) ? 1 : 0;
    all_at_once += deadlocks(disc, Bookkeeping::ALL_AT_ONCE) ? 1 : 0;
    ours += deadlocks(disc, Bookkeeping::ONE_AT_A_TIME) ? 1 : 0;
    BOOST_REQUIRE(certified_subgraph(disc).is_valid_subgraph());
  }
  BOOST_TEST_MESSAGE("deadlocks on 300 random discs: one-way marks " << marks << ", all at once "
                                                                     << all_at_once);
  BOOST_TEST(marks > 150);
  BOOST_TEST(all_at_once > 150);
  BOOST_TEST(ours == 0);
}

// The counts of two discs are those of a sphere, and of a disc beside an annulus those of a disc.
BOOST_AUTO_TEST_CASE(several_components_with_the_counts_of_one)
{
  const Triangle_list annulus = grid_band(3, 6, false);
  for (const Triangle_list& s :
       {disjoint_union(fan(5), fan(3)), disjoint_union(fan(5), annulus),
        disjoint_union(annulus, fan(5)), disjoint_union(tetrahedron(), grid_torus(4, 4)),
        disjoint_union(grid_torus(4, 4), tetrahedron()), disjoint_union(fan(3), grid_torus(4, 4)),
        disjoint_union(projective_plane(), fan(1)),
        disjoint_union(projective_plane(), projective_plane())})
    BOOST_TEST(certified_subgraph(s).is_valid_subgraph());
}

BOOST_AUTO_TEST_CASE(a_million_triangles_around_one_vertex)
{
  for (const Triangle_list& s : {fan(1000000), double_wheel(1000000)}) {
    const auto certificate = certified_subgraph(s);
    BOOST_TEST(certificate.is_valid_subgraph());
    BOOST_TEST(certificate.maximum_degree <= 3u);
  }
}

// Two triangles on the same three vertices are the smallest simple sphere.
BOOST_AUTO_TEST_CASE(smallest_surfaces)
{
  for (const Triangle_list& s : {Triangle_list{3, {{0, 1, 2}}}, tetrahedron(), projective_plane(),
                                 Triangle_list{0, {}}, Triangle_list{5, {}}})
    BOOST_TEST(certified_subgraph(s).is_valid_subgraph());

  Embedded_graph::Graph g(3);
  for (int i = 0; i < 3; ++i)
    add_edge(i, (i + 1) % 3, i, g);
  std::vector<std::vector<Embedded_graph::Edge>> lists(3);
  for (int v = 0; v < 3; ++v)
    lists[v].assign(out_edges(v, g).first, out_edges(v, g).second);
  const auto embedding =
      boost::make_iterator_property_map(lists.begin(), get(boost::vertex_index, g));
  const auto never = boost::make_static_property_map<Embedded_graph::Edge>(false);
  std::vector<Embedded_graph::Edge> subgraph;
  const auto surface = CGAL::surface_of(g, embedding, get(boost::vertex_index, g), never);
  CGAL::bounded_degree_spanning_subgraph(surface, std::back_inserter(subgraph));
  BOOST_TEST(subgraph.size() == 3u);
  BOOST_TEST(DFS::surface_topology(surface).euler_characteristic() == 2);
}

// Few faces may be those of many vertices.
BOOST_AUTO_TEST_CASE(many_isolated_vertices_need_wide_indices)
{
  namespace internal = CGAL::Delaunay_from_surface_3::internal;
  struct Reader // one that does not read, as billions of vertices would not fit into memory
  {
    std::size_t darts, vertices;
    std::size_t number_of_darts() const { return darts; }
    std::size_t number_of_vertices() const { return vertices; }
    void read(internal::Rotation_system<std::uint32_t>&) const {}
    void read(internal::Rotation_system<std::uint64_t>&) const {}
  };
  const auto bytes_of_index = [](std::size_t darts, std::size_t vertices) {
    return internal::with_rotation_system(Reader{darts, vertices}, [](const auto& surface) {
      return sizeof(typename std::decay_t<decltype(surface)>::Index);
    });
  };
  const std::size_t many = (std::size_t(1) << 32) + 5;
  BOOST_TEST(bytes_of_index(6, 4) == 4u);
  BOOST_TEST(bytes_of_index(many, 4) == 8u);
  BOOST_TEST(bytes_of_index(6, many) == 8u);
  const std::vector<Triangle> faces = {{0, 1, 2}};
  BOOST_TEST(CGAL::surface_of(many, faces).reader().number_of_vertices() == many);
}

// The index type for more edges than 32 bits can number, on a surface that has far fewer.
BOOST_AUTO_TEST_CASE(wide_indices_give_the_same_subgraph)
{
  std::mt19937 random(3);
  Triangle_list s = connected_sum(grid_torus(5, 5), projective_plane(), random);
  insert_vertices(s, 50, random);
  const Embedded_graph g = embed(s, random);
  namespace internal = CGAL::Delaunay_from_surface_3::internal;
  const auto embedding = g.embedding();
  const auto index = g.index_map();
  const auto boundary = g.boundary_map();
  using Reader =
      internal::Embedding_reader<Embedded_graph::Graph, std::decay_t<decltype(embedding)>,
                                 std::decay_t<decltype(index)>, std::decay_t<decltype(boundary)>>;
  const Reader reader(g.graph, embedding, index, boundary);
  internal::Rotation_system<std::uint32_t> narrow;
  internal::Rotation_system<std::uint64_t> wide;
  reader.read(narrow);
  reader.read(wide);
  BOOST_TEST(
      (internal::Bounded_degree_marks<std::uint32_t>(narrow, internal::Subgraph_kind::TREE)() ==
       internal::Bounded_degree_marks<std::uint64_t>(wide, internal::Subgraph_kind::TREE)()));
}
