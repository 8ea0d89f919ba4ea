// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Models that can do no more than their concepts ask for compile, and give the right triangulation.

#define BOOST_TEST_MODULE test_concepts
#include <boost/test/included/unit_test.hpp>

#include "archetypes.h"

#include <Delaunay_from_surface_3_meters/meters.h>
#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/surface/No_subgraph.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/Tracing_traits_3.h>
#include <CGAL/insert_points_3.h>
#include <CGAL/insert_points_along_graph_3.h>

#include <Delaunay_from_surface_3_surfaces/parametric.h>

#include <boost/concept/assert.hpp>
#include <boost/graph/graph_concepts.hpp>

#include <cstddef>
#include <forward_list>
#include <functional>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
namespace parameters = CGAL::parameters;

BOOST_CONCEPT_ASSERT((boost::concepts::VertexListGraph<tests::Graph_archetype>));
BOOST_CONCEPT_ASSERT((boost::concepts::EdgeListGraph<tests::Graph_archetype>));

namespace {

const surfaces::Indexed_surface& surface()
{
  static const surfaces::Indexed_surface instance = surfaces::terrain(200);
  return instance;
}

Triangulation plain()
{
  return Triangulation(surface().points.begin(), surface().points.end());
}

void join_faces(tests::Graph_archetype& graph)
{
  for (const auto& face : surface().faces)
    for (std::size_t k = 0; k < 3; ++k)
      graph.join(face[k], face[(k + 1) % 3]);
}

template <class Traits>
void check_graph_archetype(const Traits& traits)
{
  tests::Graph_archetype graph(surface().points.size());
  join_faces(graph);
  Triangulation tr;
  CGAL::insert_points_along_graph_3(
      tr, surface().points, graph, traits,
      parameters::vertex_index_map(tests::Graph_archetype::Index_map()));
  BOOST_TEST((tr == plain()));
}

// One archetype at a time, the rest from the package.
struct With_plan_archetype : CGAL::Tracing_traits_3
{
  using Insertion_plan = tests::Plan_archetype;
  Insertion_plan insertion_plan_object(unsigned int) const { return Insertion_plan(""); }
};

struct With_subgraph_archetype : CGAL::Tracing_traits_3
{
  using Surface_subgraph = tests::Subgraph_archetype;
  Surface_subgraph surface_subgraph_object() const { return Surface_subgraph(""); }
};

// The core takes any order, and starts where it says.
struct Through_core : With_plan_archetype
{
  static constexpr bool through_core = true;
};

} // namespace

BOOST_AUTO_TEST_CASE(graph_archetype)
{
  check_graph_archetype(CGAL::Tracing_traits_3());
  check_graph_archetype(CGAL::Surface_insertion_traits_3());
  check_graph_archetype(CGAL::Plain_insertion_traits_3());
}

BOOST_AUTO_TEST_CASE(traits_archetypes)
{
  check_graph_archetype(tests::Traits_archetype("all archetypes at once"));
  check_graph_archetype(With_plan_archetype());
  check_graph_archetype(With_subgraph_archetype());
  check_graph_archetype(Through_core());
}

BOOST_AUTO_TEST_CASE(visitor_archetype)
{
  std::size_t insertions = 0;
  Triangulation tr;
  CGAL::insert_points_3(tr, surface().points, surface().faces,
                        parameters::visitor(tests::Visitor_archetype(&insertions)));
  BOOST_TEST(insertions > 0u);
  const std::size_t in_core = insertions; // CGAL's insertion, which comes next, asks at each point
  tests::Visitor_archetype visitor(&insertions);
  CGAL::insert_points_3(tr, surface().points, surface().faces,
                        parameters::visitor(std::ref(visitor)));
  BOOST_TEST(insertions == in_core + surface().points.size());
  BOOST_TEST((tr == plain()));
}

// Ranges may be read once only, from the front.
BOOST_AUTO_TEST_CASE(forward_ranges)
{
  const std::forward_list<Kernel::Point_3> points(surface().points.begin(), surface().points.end());
  std::forward_list<std::forward_list<short>> faces;
  for (const auto& face : surface().faces)
    faces.push_front({short(face[0]), short(face[1]), short(face[2])});
  Triangulation tr;
  CGAL::insert_points_3(tr, points, faces);
  BOOST_TEST((tr == plain()));
}

BOOST_AUTO_TEST_CASE(metering_visitor_adds_up_what_the_traits_count)
{
  using Counting = meters::Predicate_counting_traits_3<Kernel>;
  using Phase = CGAL::Surface_insertion_phase;
  CGAL::Delaunay_triangulation_3<Counting> tr;
  const auto meter = [&] { return tr.geom_traits().counts(); };
  meters::Metering_visitor_3<decltype(meter)> visitor(meter);
  CGAL::insert_points_3(tr, surface().points, surface().faces, CGAL::Tracing_traits_3(),
                        parameters::visitor(std::ref(visitor)));
  const std::size_t n = surface().points.size();
  const auto ends = DFS::Log_star_rounds::round_ends(n);
  BOOST_TEST_REQUIRE(visitor.rounds().size() == ends.size() + 1);
  std::size_t begin = 0;
  for (std::size_t h = 0; h < ends.size(); ++h) {
    BOOST_TEST(visitor.rounds()[h + 1].number_of_points == ends[h] - begin);
    BOOST_TEST(visitor.rounds()[h + 1].number_of_traced_points ==
               (ends[h] < n ? ends[h + 1] - ends[h] : 0));
    BOOST_TEST((visitor.rounds()[h + 1][Phase::TRACE].all() > 0) == (ends[h] < n));
    begin = ends[h];
  }
  std::size_t all = 0, orientations = 0;
  for (std::size_t phase = 0; phase <= std::size_t(Phase::DONE); ++phase) {
    all += visitor.total(Phase(phase)).all();
    orientations += visitor.total(Phase(phase)).orientation;
  }
  BOOST_TEST(all == tr.geom_traits().counts().all());
  BOOST_TEST(orientations == tr.geom_traits().counts().orientation);
  BOOST_TEST(visitor.total(Phase::PLAN).all() == 0u);
  BOOST_TEST(visitor.total(Phase::LOCATION).in_sphere == 0u);
  BOOST_TEST(visitor.total(Phase::TRACE).in_sphere == 0u);
  BOOST_TEST(visitor.total(Phase::UPDATE).in_sphere > n);
  BOOST_TEST(visitor.total(Phase::TRACE).cells_entered() > 0u);
}
