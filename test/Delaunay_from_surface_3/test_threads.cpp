// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Parallel_tag: any triangulation filled by many threads is the one that plain CGAL makes; and what
// callers do with threads, stops and exceptions.

#define BOOST_TEST_MODULE test_threads
#include <boost/test/included/unit_test.hpp>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Tracing_traits_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/insert_points_3.h>
#include <CGAL/insert_surface_points_3.h>

#ifdef CGAL_LINKED_WITH_TBB

#include <Delaunay_from_surface_3_surfaces/adversarial.h>
#include <Delaunay_from_surface_3_surfaces/degenerate.h>
#include <Delaunay_from_surface_3_surfaces/genus_surface.h>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cfenv>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Epick::Point_3;
using Triangulation = CGAL::Delaunay_triangulation_3<Epick>;
using surfaces::Indexed_surface;

struct Counting_visitor : CGAL::Default_surface_insertion_visitor_3
{
  std::size_t threads = 0, stops_at = std::size_t(-1), asked = 0;
  std::size_t asked_before_replaced = 0;
  bool throws = false;

  void order_is_replaced(const std::string&) { asked_before_replaced = asked; }

  void insertion_begins(std::size_t number) { threads = number; }
  bool go_further()
  {
    if (asked++ != stops_at)
      return true;
    if (throws)
      throw std::runtime_error("the visitor's own");
    return false;
  }
};

// In an arena of eight threads, on whatever cores there are.
template <class F>
void with_eight_threads(const F& f)
{
  tbb::global_control eight(tbb::global_control::max_allowed_parallelism, 8);
  tbb::task_arena(8).execute(f);
}

std::vector<std::pair<const char*, Indexed_surface>> cases()
{
  Indexed_surface doubled = surfaces::genus_surface(0, 6000, 0.1);
  surfaces::duplicate_points(doubled, 3000, 5);
  return {{"genus 3 with noise", surfaces::genus_surface(3, 12000, 0.1)},
          {"plate without noise", surfaces::plate_surface(2, 9000)},
          {"duplicates", doubled},
          {"star", surfaces::star(9000, 1)},
          {"faces at random", surfaces::faces_at_random(6000, 1)},
          {"two lines", surfaces::two_lines(3000)},
          {"nearly flat", surfaces::nearly_flat(6000, 1e-12, 1)}};
}

template <class Tr>
void check(Tr& tr, const Indexed_surface& surface, const Tr& plain)
{
  std::vector<std::pair<std::size_t, typename Tr::Vertex_handle>> map;
  Counting_visitor visitor;
  const std::ptrdiff_t gained = CGAL::insert_surface_points_3<CGAL::Parallel_tag>(
      tr, surface.points, surface.faces,
      CGAL::parameters::visitor(std::ref(visitor))
          .vertex_to_vertex_output_iterator(std::back_inserter(map)));
  BOOST_TEST(visitor.threads == 8u);
  BOOST_TEST((tr == plain));
  BOOST_TEST(tr.tds().is_valid());
  BOOST_TEST(std::size_t(gained) == plain.number_of_vertices());
  BOOST_TEST(map.size() == surface.points.size());
  for (const auto& [i, v] : map)
    if (v->point() != surface.points[i]) {
      BOOST_ERROR("a vertex is not that of its point");
      break;
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(surfaces_by_many_threads)
{
  for (const auto& [name, surface] : cases()) {
    const Triangulation plain(surface.points.begin(), surface.points.end());
    BOOST_TEST_CONTEXT(name)
    with_eight_threads([&, &surface = surface] {
      Triangulation tr;
      check(tr, surface, plain);
    });
  }
}

BOOST_AUTO_TEST_CASE(a_triangulation_for_many_threads)
{
  using Tds = CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_3<Epick>,
                                                   CGAL::Delaunay_triangulation_cell_base_3<Epick>,
                                                   CGAL::Parallel_tag>;
  using Parallel = CGAL::Delaunay_triangulation_3<Epick, Tds>;
  const Indexed_surface surface = surfaces::genus_surface(1, 12000, 0.1);
  const Parallel plain(surface.points.begin(), surface.points.end());
  with_eight_threads([&] {
    Parallel tr;
    check(tr, surface, plain);
    Counting_visitor by_default;
    Parallel other;
    insert_surface_points_3(other, surface.points, surface.faces,
                            CGAL::parameters::visitor(std::ref(by_default)));
    BOOST_TEST(by_default.threads == 8u);
    BOOST_TEST((other == plain));
    other.clear();
    CGAL::insert_points_3<CGAL::Sequential_tag>(other, surface.points,
                                                CGAL::parameters::visitor(std::ref(by_default)));
    BOOST_TEST(by_default.threads == 1u);
    BOOST_TEST((other == plain));
  });
}

BOOST_AUTO_TEST_CASE(points_alone)
{
  for (const auto& [name, surface] : cases()) {
    const Triangulation plain(surface.points.begin(), surface.points.end());
    BOOST_TEST_CONTEXT(name)
    with_eight_threads([&, &surface = surface] {
      Triangulation tr;
      Counting_visitor visitor;
      CGAL::insert_points_3<CGAL::Parallel_tag>(tr, surface.points,
                                                CGAL::parameters::visitor(std::ref(visitor)));
      BOOST_TEST(visitor.threads == 8u);
      BOOST_TEST((tr == plain));
    });
  }
}

// The hubs come first, and two thousand of them have a million cells.
BOOST_AUTO_TEST_CASE(an_order_over_its_budget_is_found_early)
{
  const Indexed_surface surface = surfaces::skew_stars(36000, 1);
  const Triangulation plain(surface.points.begin(), surface.points.end());
  with_eight_threads([&] {
    Triangulation tr;
    Counting_visitor visitor;
    CGAL::insert_surface_points_3<CGAL::Parallel_tag>(tr, surface.points, surface.faces,
                                                      CGAL::parameters::visitor(std::ref(visitor)));
    BOOST_TEST((tr == plain));
    BOOST_TEST(visitor.asked_before_replaced > 0u);
    BOOST_TEST(visitor.asked_before_replaced < 1500u);
  });
}

// Of equal points the one with the smallest index gives the info, whichever thread came first.
BOOST_AUTO_TEST_CASE(infos_of_duplicates)
{
  using Vb = CGAL::Triangulation_vertex_base_with_info_3<std::size_t, Epick>;
  using Tds =
      CGAL::Triangulation_data_structure_3<Vb, CGAL::Delaunay_triangulation_cell_base_3<Epick>>;
  Indexed_surface surface = surfaces::genus_surface(0, 4000, 0.1);
  surfaces::duplicate_points(surface, 4000, 3);
  std::vector<std::pair<Point, std::size_t>> pairs;
  for (const Point& p : surface.points)
    pairs.push_back({p, pairs.size()});
  with_eight_threads([&] {
    CGAL::Delaunay_triangulation_3<Epick, Tds> one, many;
    CGAL::insert_points_3<CGAL::Sequential_tag>(one, pairs);
    CGAL::insert_points_3<CGAL::Parallel_tag>(many, pairs);
    BOOST_TEST((one == many));
    std::map<Point, std::size_t> infos;
    for (const auto v : one.finite_vertex_handles())
      infos[v->point()] = v->info();
    for (const auto v : many.finite_vertex_handles())
      if (infos.at(v->point()) != v->info()) {
        BOOST_ERROR("another info");
        break;
      }
  });
}

// Traces follow one insertion after the other.
BOOST_AUTO_TEST_CASE(hints_that_are_not_concurrent)
{
  const Indexed_surface surface = surfaces::genus_surface(1, 4000, 0.1);
  const Triangulation plain(surface.points.begin(), surface.points.end());
  with_eight_threads([&] {
    Triangulation tr;
    Counting_visitor visitor;
    CGAL::insert_surface_points_3<CGAL::Parallel_tag>(tr, surface.points, surface.faces,
                                                      CGAL::Tracing_traits_3(),
                                                      CGAL::parameters::visitor(std::ref(visitor)));
    BOOST_TEST(visitor.threads == 1u);
    BOOST_TEST((tr == plain));
  });
}

// What is left out depends on the order: one thread inserts, and what comes out is what comes out
// of one thread.
BOOST_AUTO_TEST_CASE(points_left_out)
{
  const Indexed_surface surface = surfaces::genus_surface(1, 12000, 0.1);
  struct Thinning_visitor : Counting_visitor
  {
    const std::vector<Point>* points;
    bool accept(std::size_t i, std::size_t, const Point& nearest) const
    {
      return CGAL::squared_distance((*points)[i], nearest) >= .01;
    }
  } visitor;
  visitor.points = &surface.points;
  const auto np = CGAL::parameters::visitor(std::ref(visitor));
  Triangulation alone, tr;
  CGAL::insert_surface_points_3(alone, surface.points, surface.faces, np);
  visitor.threads = 0;
  with_eight_threads([&] {
    CGAL::insert_surface_points_3<CGAL::Parallel_tag>(tr, surface.points, surface.faces, np);
  });
  BOOST_TEST(visitor.threads == 1u);
  BOOST_TEST(tr.number_of_vertices() < surface.points.size());
  BOOST_TEST((tr == alone));
}

BOOST_AUTO_TEST_CASE(stops_and_exceptions_leave_an_empty_triangulation)
{
  const Indexed_surface surface = surfaces::genus_surface(1, 12000, 0.1);
  const Triangulation plain(surface.points.begin(), surface.points.end());
  with_eight_threads([&] {
    Triangulation tr;
    for (const std::size_t stops_at : {0, 100, 2100, 2500})
      for (const bool throws : {false, true}) {
        Counting_visitor visitor;
        visitor.stops_at = stops_at;
        visitor.throws = throws;
        const auto insert = [&] {
          return CGAL::insert_surface_points_3<CGAL::Parallel_tag>(
              tr, surface.points, surface.faces, CGAL::parameters::visitor(std::ref(visitor)));
        };
        if (throws)
          BOOST_CHECK_THROW(insert(), std::runtime_error);
        else
          BOOST_TEST(insert() == 0);
        BOOST_TEST(tr.number_of_vertices() == 0u);
        BOOST_TEST(tr.dimension() == -1);
      }
    check(tr, surface, plain);
  });
}

// The limit of a caller is kept. That workers may run one after the other is for test_workers.
BOOST_AUTO_TEST_CASE(a_limit_of_one_thread)
{
  const Indexed_surface surface = surfaces::genus_surface(1, 12000, 0.1);
  const Triangulation plain(surface.points.begin(), surface.points.end());
  tbb::task_arena(8).execute([&] {
    Triangulation tr;
    tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    CGAL::insert_surface_points_3<CGAL::Parallel_tag>(tr, surface.points, surface.faces);
    BOOST_TEST((tr == plain));
  });
}

BOOST_AUTO_TEST_CASE(in_the_loop_of_a_caller)
{
  const Indexed_surface surface = surfaces::genus_surface(2, 6000, 0.1);
  const Triangulation plain(surface.points.begin(), surface.points.end());
  std::vector<Triangulation> triangulations(6);
  with_eight_threads([&] {
    tbb::parallel_for(std::size_t(0), triangulations.size(), [&](std::size_t k) {
      CGAL::insert_surface_points_3<CGAL::Parallel_tag>(triangulations[k], surface.points,
                                                        surface.faces);
    });
  });
  for (const Triangulation& tr : triangulations)
    BOOST_TEST((tr == plain));
}

BOOST_AUTO_TEST_CASE(several_callers_at_once)
{
  const Indexed_surface surface = surfaces::genus_surface(2, 6000, 0.1);
  const Triangulation plain(surface.points.begin(), surface.points.end());
  const tbb::global_control eight(tbb::global_control::max_allowed_parallelism, 8);
  std::vector<Triangulation> triangulations(4);
  std::vector<std::thread> callers;
  for (Triangulation& tr : triangulations)
    callers.emplace_back([&] {
      CGAL::insert_surface_points_3<CGAL::Parallel_tag>(tr, surface.points, surface.faces);
    });
  for (std::thread& caller : callers)
    caller.join();
  for (const Triangulation& tr : triangulations)
    BOOST_TEST((tr == plain));
}

BOOST_AUTO_TEST_CASE(rounding_modes)
{
  const Indexed_surface surface = surfaces::plate_surface(1, 6000);
  const Triangulation plain(surface.points.begin(), surface.points.end());
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    Triangulation tr;
    std::fesetround(mode);
    with_eight_threads([&] {
      CGAL::insert_surface_points_3<CGAL::Parallel_tag>(tr, surface.points, surface.faces);
    });
    const int mode_after = std::fegetround();
    std::fesetround(FE_TONEAREST);
    BOOST_TEST((tr == plain));
    BOOST_TEST(mode_after == mode);
  }
}

#else

BOOST_AUTO_TEST_CASE(skipped)
{
  BOOST_TEST_MESSAGE("skipped: Parallel_tag, as TBB was not found");
  BOOST_TEST(true);
}

#endif
