// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Visitors that leave points out.

#define BOOST_TEST_MODULE test_accept
#include <boost/test/included/unit_test.hpp>

#include "core_traits.h"
#include "input.h"

#include <CGAL/Delaunay_from_surface_3/paper/Conflict_history_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/Planned_hints_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/surface/No_subgraph.h>
#include <CGAL/Delaunay_from_surface_3/vertex_info.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Tracing_traits_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/insert_points_3.h>

#include <cstring>
#include <numeric>
#include <random>

namespace DFS = CGAL::Delaunay_from_surface_3;
using namespace tests::input;

namespace {

const std::size_t none = std::size_t(-1);
using Points = std::vector<Point>;

// A point is far enough if its distance is at least `distance`.
struct Far
{
  double distance;
  bool operator()(const Point& p, const Point& nearest) const
  {
    return CGAL::squared_distance(p, nearest) >= distance * distance;
  }
};

bool is_nearer(const Point& p, const Point& a, const Point& b)
{
  const auto c = CGAL::compare_distance_to_point(p, a, b);
  return c != CGAL::EQUAL ? c == CGAL::SMALLER : CGAL::compare_xyz(a, b) == CGAL::SMALLER;
}

// Looks up each nearest vertex that it is told among all points accepted before.
template <class Rule>
struct Checking_visitor : CGAL::Default_surface_insertion_visitor_3
{
  const Points& points;
  Rule rule;
  Points old; // what the triangulation had
  std::vector<std::size_t> accepted;
  std::set<std::size_t> asked;
  std::size_t wrong = 0, threads = 0, replaced = 0;

  Checking_visitor(const Points& p, Rule r, const Triangulation& tr = Triangulation())
    : points(p)
    , rule(r)
  {
    for (const auto v : tr.finite_vertex_handles())
      old.push_back(v->point());
  }

  void insertion_begins(std::size_t number_of_threads) { threads = number_of_threads; }
  void target_is_replaced(const std::string&) { ++replaced; }

  bool accept(std::size_t i, std::size_t nearest, const Point& point)
  {
    if (old.empty() && accepted.empty()) // nobody asked about the first
      accepted.push_back(nearest);
    Points all = old;
    for (const std::size_t j : accepted)
      all.push_back(points[j]);
    const Point expected = *std::min_element(
        all.begin(), all.end(), [&](auto& a, auto& b) { return is_nearer(points[i], a, b); });
    const bool is_new = asked.insert(i).second;
    const bool is_old = std::find(old.begin(), old.end(), point) != old.end();
    wrong += !is_new || point != expected || point == points[i] ||
             (nearest == none ? !is_old : points.at(nearest) != point);
    if (!rule(points[i], point))
      return false;
    accepted.push_back(i);
    return true;
  }

  // The triangulation of what was accepted, and the pairs of indices and vertices.
  void check(const Triangulation& tr, const Index_map& map) const
  {
    Triangulation expected(old.begin(), old.end());
    std::set<std::size_t> indices(accepted.begin(), accepted.end());
    for (const std::size_t i : accepted)
      expected.insert(points[i]);
    BOOST_TEST(wrong == 0u);
    BOOST_TEST(tr.is_valid());
    BOOST_TEST((tr == expected));
    std::map<std::size_t, Vertex_handle> vertices(map.begin(), map.end());
    BOOST_TEST(vertices.size() == map.size());
    BOOST_TEST(
        std::is_sorted(map.begin(), map.end(), [](auto& a, auto& b) { return a.first < b.first; }));
    for (const auto& [i, v] : vertices) {
      BOOST_TEST_REQUIRE((tr.tds().is_vertex(v) && !tr.is_infinite(v)));
      BOOST_TEST((v->point() == points[i]));
      indices.erase(i);
    }
    BOOST_TEST(indices.empty());
    for (const std::size_t i : asked) // those left out have no vertex
      BOOST_TEST(vertices.count(i) == std::size_t(std::count(accepted.begin(), accepted.end(), i)));
  }
};

// The order of the input, with places to start from.
class Input_order
{
public:
  explicit Input_order(unsigned int = 0) {}
  template <class P, class GeomTraits, class AnyGraph, class VertexIndexMap>
  DFS::Insertion_order operator()(const std::vector<P>& points, const GeomTraits&, const AnyGraph&,
                                  VertexIndexMap) const
  {
    DFS::Insertion_order plan;
    plan.order.resize(points.size());
    std::iota(plan.order.begin(), plan.order.end(), std::size_t(0));
    for (std::size_t i = 0; i < points.size(); ++i)
      plan.starting_places.push_back(i / 2);
    for (std::size_t end = 2; end < points.size(); end *= 2)
      plan.round_ends.push_back(end);
    if (!points.empty())
      plan.round_ends.push_back(points.size());
    return plan;
  }
};
template <template <class, class> class Hints>
using In_order = CGAL::Surface_insertion_policies_3<DFS::Full_graph, Input_order, Hints>;
using Round_the_core = tests::Round_the_core<In_order<DFS::Planned_hints_3>>;

// Gives way to another after its first insertions.
struct Dear_order : Input_order
{
  using Input_order::Input_order;
  static constexpr std::size_t cells_per_point = 0;
  Input_order fallback_plan() const { return Input_order(); }
};

// Inserts by the form whose function is `insert(tr, np)`.
template <class Rule, class Insert>
void check(const Points& points, const Rule& rule, const Insert& insert,
           Triangulation tr = Triangulation())
{
  Checking_visitor<Rule> visitor(points, rule, tr);
  Index_map map;
  const auto before = std::ptrdiff_t(tr.number_of_vertices());
  const auto gained = insert(tr, parameters::visitor(std::ref(visitor))
                                     .vertex_to_vertex_output_iterator(std::back_inserter(map)));
  if (visitor.accepted.empty() && before == 0)
    for (const auto& [i, v] : map)
      visitor.accepted.push_back(i); // nothing was asked
  visitor.check(tr, map);
  BOOST_TEST(gained == std::ptrdiff_t(tr.number_of_vertices()) - before);
  BOOST_TEST((visitor.threads == 1 || points.empty()));
}

// By all hints, in the core and by CGAL's insertion, and the order of the input.
template <class Rule>
void check_everywhere(const Points& points, const Rule& rule,
                      const Triangulation& tr = Triangulation())
{
  Graph graph(points.size());
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (std::size_t i = 1; i < points.size(); ++i)
    edges.emplace_back(i - 1, i);
  graph = Graph(edges.begin(), edges.end(), points.size());
  const auto along = [&](const auto& traits) {
    BOOST_TEST_CONTEXT(boost::typeindex::type_id<decltype(traits)>().pretty_name())
    check(
        points, rule,
        [&](Triangulation& into, const auto& np) {
          return CGAL::insert_points_along_graph_3(into, points, graph, traits, np);
        },
        tr);
  };
  along(In_order<DFS::Previous_hint_3>());
  along(In_order<DFS::Planned_hints_3>());
  along(In_order<DFS::Traced_hints_3>());
  along(In_order<DFS::Neighbor_hints_3>());
  along(Round_the_core());
  along(In_order<DFS::Conflict_history_hints_3>());
  along(CGAL::Surface_insertion_traits_3());
  along(CGAL::Tracing_traits_3());
  along(CGAL::History_tracing_traits_3());
  check(
      points, rule,
      [&](Triangulation& into, const auto& np) { return CGAL::insert_points_3(into, points, np); },
      tr);
}

Points random_points(std::size_t n, unsigned int seed, double height = 1)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(0, 1);
  Points points;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    points.emplace_back(x, y, height * z);
  }
  return points;
}

// A shuffled lattice: many points are equally far from many vertices.
Points lattice(int side, int height, unsigned int seed)
{
  Points points;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < height; ++z)
        points.emplace_back(x, y, z);
  std::shuffle(points.begin(), points.end(), std::mt19937(seed));
  return points;
}

// CGAL's own functions, in the order given.
Triangulation by_cgal(const Points& points, const Far& rule)
{
  Triangulation tr;
  for (const Point& p : points)
    if (tr.number_of_vertices() == 0 || rule(p, tr.nearest_vertex(p)->point()))
      tr.insert(p);
  return tr;
}

// What is asked is all that a visitor needs.
struct Thinning_visitor : CGAL::Default_surface_insertion_visitor_3
{
  const Points& points;
  Far rule;
  explicit Thinning_visitor(const Points& p, const Far& r)
    : points(p)
    , rule(r)
  {
  }
  bool accept(std::size_t i, std::size_t, const Point& nearest) const
  {
    return rule(points[i], nearest);
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(equals_a_loop_over_cgal)
{
  for (const double distance : {0., .05, .3, 1., 5.}) {
    for (const Points& points : {torus().points, random_points(300, 1), lattice(5, 5, 2),
                                 lattice(12, 1, 3), random_points(100, 4, 1e-9)}) {
      const Triangulation expected = by_cgal(points, Far{distance});
      const auto insert = [&](const auto& traits) {
        Triangulation tr;
        CGAL::insert_points_along_graph_3(
            tr, points, Graph(points.size()), traits,
            parameters::visitor(Thinning_visitor(points, {distance})));
        BOOST_TEST((tr == expected));
      };
      insert(In_order<DFS::Previous_hint_3>());
      insert(In_order<DFS::Planned_hints_3>());
      insert(Round_the_core());
    }
  }
}

// Looks up the corners that it is told in the triangulation of what was accepted before.
struct Corner_visitor : CGAL::Default_surface_insertion_visitor_3
{
  const Points& points;
  Far rule;
  Triangulation tr;
  std::map<std::size_t, Vertex_handle> vertices;
  std::size_t wrong = 0, finite = 0, infinite = 0, none_yet = 0;

  Corner_visitor(const Points& p, const Far& r)
    : points(p)
    , rule(r)
  {
  }

  bool accept(std::size_t i, std::size_t nearest, const Point& point,
              const std::array<std::size_t, 4>& corners)
  {
    if (vertices.empty()) // nobody asked about the first
      vertices[nearest] = tr.insert(point);
    wrong += !is_right(points[i], corners);
    if (!rule(points[i], point))
      return false;
    vertices[i] = tr.insert(points[i]);
    return true;
  }

  bool is_right(const Point& p, const std::array<std::size_t, 4>& corners)
  {
    const auto nones = std::count(corners.begin(), corners.end(), none);
    if (tr.dimension() < 3) {
      ++none_yet;
      return nones == 4;
    }
    std::array<Vertex_handle, 4> v;
    for (std::size_t k = 0; k < 4; ++k)
      v[k] = corners[k] == none ? tr.infinite_vertex() : vertices.at(corners[k]);
    Triangulation::Cell_handle cell;
    if (nones > 1 || !tr.is_cell(v[0], v[1], v[2], v[3], cell))
      return false;
    ++(nones == 0 ? finite : infinite);
    return nones == 0 ? tr.side_of_cell(p, cell, locate_type, li, lj) != CGAL::ON_UNBOUNDED_SIDE
                      : tr.side_of_cell(p, cell, locate_type, li, lj) == CGAL::ON_BOUNDED_SIDE;
  }

  Triangulation::Locate_type locate_type;
  int li, lj;
};

BOOST_AUTO_TEST_CASE(corners_of_the_cell_that_contains_a_point)
{
  for (const double distance : {0., .2, 1.5})
    for (const Points& points : {random_points(300, 2), lattice(5, 4, 1), torus().points}) {
      std::size_t in_core = 0;
      const auto check = [&](const auto& traits) {
        Corner_visitor visitor(points, Far{distance});
        Triangulation tr;
        CGAL::insert_points_along_graph_3(tr, points, Graph(points.size()), traits,
                                          parameters::visitor(std::ref(visitor)));
        BOOST_TEST((tr == visitor.tr));
        BOOST_TEST(visitor.wrong == 0u);
        BOOST_TEST(visitor.none_yet >= 3u);
        if (distance < 1)
          BOOST_TEST(visitor.infinite > 0u);
        BOOST_TEST((in_core == 0 || in_core == visitor.finite + visitor.infinite));
        in_core = visitor.finite + visitor.infinite;
      };
      check(In_order<DFS::Planned_hints_3>());
      check(Round_the_core());
    }
}

BOOST_AUTO_TEST_CASE(nearest_vertices)
{
  for (const double distance : {0., .1, .4})
    check_everywhere(random_points(100, 5), Far{distance});
  for (const double distance : {1., 1.2, 2., 4.})
    check_everywhere(lattice(4, 4, 6), Far{distance});
}

// Answers that have nothing to do with distances.
BOOST_AUTO_TEST_CASE(any_answers)
{
  const auto by_last_digit = [](unsigned share) {
    return [share](const Point& p, const Point&) {
      std::uint64_t bits;
      const double x = p.x() + p.y() + p.z();
      std::memcpy(&bits, &x, sizeof(bits));
      return std::mt19937(unsigned(bits ^ (bits >> 32)))() % 16 < share;
    };
  };
  for (const unsigned share : {0u, 1u, 8u, 15u, 16u}) {
    check_everywhere(random_points(100, 7), by_last_digit(share));
    check_everywhere(lattice(4, 4, 8), by_last_digit(share));
  }
}

BOOST_AUTO_TEST_CASE(points_that_span_no_space)
{
  for (const Points& points : {Points(), Points{{1, 2, 3}}, Points(7, Point(1, 2, 3)),
                               lattice(10, 1, 1), lattice(1, 20, 2), lattice(1, 2, 3)})
    for (const double distance : {0., 1.5, 100.})
      check_everywhere(points, Far{distance});
}

BOOST_AUTO_TEST_CASE(into_a_triangulation_that_is_not_empty)
{
  const Triangulation old = cube_of_points();
  const Points line{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}},
      square{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  for (const Triangulation& tr :
       {old, Triangulation(line.begin(), line.end()), Triangulation(square.begin(), square.end())})
    for (const double distance : {0., .2, 100.}) {
      check_everywhere(random_points(40, 11), Far{distance}, tr);
      check_everywhere(random_points(40, 12, 0), Far{distance}, tr);
    }
  // A new point at an old vertex is not asked about; it is then the point there.
  Points points = line;
  points.emplace_back(1.1, 0, 0);
  Triangulation tr(line.begin(), line.end());
  Checking_visitor<Far> visitor(points, Far{.5}, tr);
  Index_map map;
  const auto np = parameters::visitor(std::ref(visitor))
                      .vertex_to_vertex_output_iterator(std::back_inserter(map));
  BOOST_TEST(CGAL::insert_points_3(tr, points, np) == 0);
  BOOST_TEST(visitor.asked.size() == 1u);
  BOOST_TEST(map.size() == 3u);
}

// The compact triangulation stays where the first accepted points span space.
BOOST_AUTO_TEST_CASE(target_stays)
{
  const Points points = random_points(2000, 13);
  Checking_visitor<Far> visitor(points, Far{.2});
  Triangulation tr;
  CGAL::insert_points_3(tr, points, parameters::visitor(std::ref(visitor)));
  BOOST_TEST(visitor.replaced == 0u);
  BOOST_TEST(tr.number_of_vertices() > 50u);
  BOOST_TEST(tr.number_of_vertices() < 500u);
}

// The first points lie in one plane, and most of them are left out.
BOOST_AUTO_TEST_CASE(first_points_in_one_plane)
{
  for (const std::size_t in_plane : {std::size_t(50), std::size_t(1100)}) {
    Points points = random_points(in_plane, 14, 0);
    for (const Point& p : random_points(50, 15))
      points.push_back(p);
    for (const double distance : {0., .3}) {
      Checking_visitor<Far> visitor(points, Far{distance});
      Triangulation tr;
      Index_map map;
      CGAL::insert_points_along_graph_3(
          tr, points, Graph(points.size()), In_order<DFS::Planned_hints_3>(),
          parameters::visitor(std::ref(visitor))
              .vertex_to_vertex_output_iterator(std::back_inserter(map)));
      visitor.check(tr, map);
      BOOST_TEST(visitor.replaced == (in_plane > 1000));
    }
  }
}

BOOST_AUTO_TEST_CASE(duplicates)
{
  Points points = random_points(80, 16);
  for (std::size_t i = 0; i < 80; i += 3)
    points.push_back(points[i]);
  std::shuffle(points.begin(), points.end(), std::mt19937(17));
  for (const double distance : {0., .2})
    check_everywhere(points, Far{distance});
}

BOOST_AUTO_TEST_CASE(all_forms)
{
  const Points& points = torus().points;
  const auto insert = [&](const auto& form) { check(points, Far{.2}, form); };
  insert([&](Triangulation& tr, const auto& np) { return CGAL::insert_points_3(tr, points, np); });
  insert([&](Triangulation& tr, const auto& np) {
    return CGAL::insert_points_3(tr, points, torus().surface.faces, np);
  });
  insert([&](Triangulation& tr, const auto& np) {
    return CGAL::insert_points_along_graph_3(tr, points, graph_of_torus(), np);
  });
  insert([&](Triangulation& tr, const auto& np) {
    return CGAL::insert_surface_vertices_3(tr, surfaces::to_mesh<Mesh>(torus().surface), np);
  });
}

BOOST_AUTO_TEST_CASE(infos_and_order_of_the_input)
{
  using Base = CGAL::Triangulation_vertex_base_with_info_3<std::size_t, Kernel>;
  using Tds =
      CGAL::Triangulation_data_structure_3<Base, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
  const Points& points = torus().points;
  const Mesh mesh = surfaces::to_mesh<Mesh>(torus().surface);
  std::vector<std::size_t> infos(points.size());
  std::iota(infos.begin(), infos.end(), std::size_t(0));
  CGAL::Delaunay_triangulation_3<Kernel, Tds> tr;
  CGAL::insert_surface_vertices_3(tr, mesh,
                                  DFS::vertex_info_range(infos)
                                      .visitor(Thinning_visitor(points, Far{.2}))
                                      .preserve_order(true));
  BOOST_TEST(tr.number_of_vertices() > 10u);
  BOOST_TEST(tr.number_of_vertices() < points.size());
  BOOST_TEST(tr.is_valid());
  std::vector<std::size_t> in_order;
  for (const auto v : tr.finite_vertex_handles()) {
    BOOST_TEST((v->point() == points[v->info()]));
    in_order.push_back(v->info());
  }
  BOOST_TEST(std::is_sorted(in_order.begin(), in_order.end()));
}

BOOST_AUTO_TEST_CASE(other_kernels)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  const auto insert = [](auto tr, const std::size_t vertices) {
    using Tr = decltype(tr);
    std::vector<typename Tr::Point> points;
    for (const Point& p : random_points(200, 18))
      points.emplace_back(p.x(), p.y(), p.z());
    struct Visitor : CGAL::Default_surface_insertion_visitor_3
    {
      const std::vector<typename Tr::Point>* points;
      bool accept(std::size_t i, std::size_t nearest, const typename Tr::Point& point) const
      {
        return (*points)[nearest] == point &&
               CGAL::squared_distance((*points)[i], point) >= typename Tr::Geom_traits::FT(.04);
      }
    } visitor;
    visitor.points = &points;
    CGAL::insert_points_3(tr, points, parameters::visitor(visitor));
    BOOST_TEST(tr.is_valid());
    BOOST_TEST((vertices == 0 || tr.number_of_vertices() == vertices));
    return std::size_t(tr.number_of_vertices());
  };
  const std::size_t n = insert(Triangulation(), 0);
  insert(CGAL::Delaunay_triangulation_3<Exact>(), n);
  insert(CGAL::Delaunay_triangulation_3<Kernel, CGAL::Fast_location>(), n);
}

BOOST_AUTO_TEST_CASE(stops_and_exceptions)
{
  struct Ending : Checking_visitor<Far>
  {
    std::size_t stop_at = none, throw_at = none;
    using Checking_visitor::Checking_visitor;
    bool go_further() const { return asked.size() < stop_at; }
    bool accept(std::size_t i, std::size_t nearest, const Point& point)
    {
      if (asked.size() == throw_at)
        throw std::runtime_error("accept() throws");
      return Checking_visitor::accept(i, nearest, point);
    }
  };
  const Points& points = torus().points;
  for (const std::size_t when : {std::size_t(0), std::size_t(1), std::size_t(200)})
    for (const Triangulation& old : {Triangulation(), cube_of_points()})
      for (const bool throws : {false, true}) {
        Triangulation tr(old);
        Ending visitor(points, Far{.2}, old);
        (throws ? visitor.throw_at : visitor.stop_at) = when;
        Index_map map;
        const auto np = parameters::visitor(std::ref(visitor))
                            .vertex_to_vertex_output_iterator(std::back_inserter(map));
        if (throws)
          BOOST_CHECK_THROW(CGAL::insert_points_3(tr, points, np), std::runtime_error);
        else
          CGAL::insert_points_3(tr, points, np);
        if (old.number_of_vertices() == 0) {
          BOOST_TEST((tr == old));
          BOOST_TEST(map.empty());
        } else if (throws) {
          Triangulation expected(old);
          for (const std::size_t i : visitor.accepted)
            expected.insert(points[i]);
          BOOST_TEST((tr == expected));
        } else {
          visitor.check(tr, map);
        }
      }
}

// The work begins anew, and so do the questions.
BOOST_AUTO_TEST_CASE(order_that_is_too_dear)
{
  using Traits =
      CGAL::Surface_insertion_policies_3<DFS::Full_graph, Dear_order, DFS::Planned_hints_3>;
  struct Beginning : Checking_visitor<Far>
  {
    using Checking_visitor::Checking_visitor;
    std::size_t plans = 0;
    void phase_begins(CGAL::Surface_insertion_phase phase)
    {
      if (phase != CGAL::Surface_insertion_phase::PLAN)
        return;
      ++plans;
      asked.clear();
      accepted.clear();
    }
  };
  Beginning visitor(torus().points, Far{.1});
  Triangulation tr;
  Index_map map;
  CGAL::insert_points_along_graph_3(tr, torus().points, Graph(torus().points.size()), Traits(),
                                    parameters::visitor(std::ref(visitor))
                                        .vertex_to_vertex_output_iterator(std::back_inserter(map)));
  visitor.check(tr, map);
  BOOST_TEST(visitor.plans == 2u);
}
