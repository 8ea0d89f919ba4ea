// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What visitors are told; stops; exceptions.

#define BOOST_TEST_MODULE test_visitors
#include <boost/test/included/unit_test.hpp>

#include "Watching_visitor.h"

#include <array>

namespace DFS = CGAL::Delaunay_from_surface_3;
using namespace tests::input;

namespace {

template <class Traits>
void check_stop_in_empty_triangulation(std::size_t stop_before)
{
  Triangulation tr;
  const auto infinite = tr.infinite_vertex();
  Watching_visitor stop;
  stop.stop_before = stop_before;
  Index_map map;
  const Watching_visitor visitor = watch<Traits>(tr, stop, &map);
  BOOST_TEST(visitor.asked == stop_before + 1);
  BOOST_TEST(tr.number_of_vertices() == 0u);
  BOOST_TEST((tr.infinite_vertex() == infinite));
  BOOST_TEST(tr.is_valid());
  BOOST_TEST(map.empty());
  BOOST_TEST((visitor.phase == CGAL::Surface_insertion_phase::DONE));
}

template <class Traits>
void check_stop_in_other_triangulation(std::size_t stop_before)
{
  const Triangulation old = cube_of_points();
  Triangulation tr(old), expected(old);
  Watching_visitor stop;
  stop.stop_before = stop_before;
  Index_map map;
  watch<Traits>(tr, stop, &map);
  BOOST_TEST(map.size() == stop_before);
  for (const auto& [i, v] : map) {
    BOOST_TEST_REQUIRE(tr.tds().is_vertex(v));
    BOOST_TEST((v->point() == torus().points[i]));
    expected.insert(torus().points[i]);
  }
  BOOST_TEST(tr.is_valid());
  BOOST_TEST((tr == expected));
}

template <class Traits>
void check_stops()
{
  Triangulation whole;
  const std::size_t asked = watch<Traits>(whole).asked, n = torus().points.size();
  if (Traits::through_core) { // once in each round, and in each of more than 256 points again
    BOOST_TEST(asked >= n / 256);
    BOOST_TEST(asked < n / 256 + 12);
  } else {
    BOOST_TEST(asked == n);
  }
  for (const std::size_t stop_before : {std::size_t(0), std::size_t(1), asked / 2, asked - 1})
    check_stop_in_empty_triangulation<Traits>(stop_before);
  for (const std::size_t stop_before : {std::size_t(0), std::size_t(3), n / 2, n - 1})
    check_stop_in_other_triangulation<Traits>(stop_before);
}

// Not derived from the default visitor.
struct Logging
{
  std::string log;
  static constexpr bool follows_points = true;
  void notice(CGAL::Surface_insertion_notice what, const std::string&)
  {
    log += std::array<const char*, 4>{"irregular ", "replaced ", "by CGAL ", "anew "}[int(what)];
  }
  void phase_begins(CGAL::Surface_insertion_phase phase, std::size_t number)
  {
    log += "PSIRLUTFD"[int(phase)] + (number > 0 ? std::to_string(number) : "");
  }
  bool go_further(std::size_t inserted) { return log += " go" + std::to_string(inserted), true; }
  template <class Target, class Hints>
  void insertion_ends(const Target&, const Hints&)
  {
    log += "E";
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(visitor_is_told_everything)
{
  using Phase = CGAL::Surface_insertion_phase;
  const std::size_t n = torus().points.size();
  Triangulation tr;
  Watching_visitor visitor = watch<CGAL::Tracing_traits_3>(tr);
  const auto ends = DFS::Log_star_rounds::round_ends(n);
  BOOST_TEST(visitor.asked == n);
  BOOST_TEST(visitor.points_in_rounds == n);
  BOOST_TEST(visitor.phases[Phase::ROUND] == ends.size());
  BOOST_TEST(visitor.located_by_traces == n - ends[0]);
  BOOST_TEST(visitor.phases[Phase::PLAN] == 1u);
  BOOST_TEST(visitor.phases[Phase::SUBGRAPH] == 1u);
  BOOST_TEST(visitor.phases[Phase::LOCATION] == n);
  BOOST_TEST(visitor.phases[Phase::UPDATE] == n);
  BOOST_TEST(visitor.phases[Phase::TRACE] == ends.size() - 1);
  BOOST_TEST(visitor.phases[Phase::FINISH] == 1u);
  BOOST_TEST(visitor.phases[Phase::DONE] == 1u);
  BOOST_TEST(visitor.reasons.empty());
  BOOST_TEST(visitor.reasons_of_subgraph.empty());
}

// Three triangles at one edge are no surface: T is a spanning forest.
BOOST_AUTO_TEST_CASE(visitor_is_told_of_another_subgraph)
{
  const std::vector<Triangulation::Point> points = {
      {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, -1}};
  const std::vector<std::vector<std::size_t>> faces = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  Triangulation tr;
  Watching_visitor visitor;
  CGAL::insert_points_3(tr, points, faces, CGAL::Tracing_traits_3(),
                        CGAL::parameters::visitor(std::ref(visitor)));
  BOOST_TEST(visitor.reasons_of_subgraph.size() == 1u);
}

BOOST_AUTO_TEST_CASE(visitor_is_told_in_the_order_documented)
{
  Logging visitor;
  Triangulation tr;
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  CGAL::insert_points_3(tr, points, Faces{{0, 1}}, CGAL::Tracing_traits_3(),
                        parameters::visitor(std::ref(visitor)));
  BOOST_TEST(visitor.log == "irregular PSreplaced I1R2 go0LU go1LUT1R1 go2LUEFD");
}

BOOST_AUTO_TEST_CASE(visitor_by_value)
{
  struct Stopping : CGAL::Default_surface_insertion_visitor_3
  {
    std::size_t* insertions;
    explicit Stopping(std::size_t* n)
      : insertions(n)
    {
    }
    bool go_further(std::size_t) const { return ++*insertions <= 10; }
  };
  std::size_t insertions = 0;
  Triangulation tr = cube_of_points();
  const std::size_t before = tr.number_of_vertices();
  const auto gained = CGAL::insert_points_3(tr, torus().points, torus().surface.faces,
                                            parameters::visitor(Stopping(&insertions)));
  BOOST_TEST(gained == 10);
  BOOST_TEST(insertions == 11u);
  BOOST_TEST(tr.number_of_vertices() == before + 10);

  Triangulation whole;
  CGAL::insert_points_3(whole, torus().points, torus().surface.faces,
                        parameters::visitor(CGAL::Default_surface_insertion_visitor_3()));
  BOOST_TEST((whole == torus().plain));
}

BOOST_AUTO_TEST_CASE(visitor_that_is_not_copied_may_have_a_state_of_its_own)
{
  Triangulation tr;
  BOOST_TEST(watch<CGAL::Plain_insertion_traits_3>(tr).asked == torus().points.size());
}

BOOST_AUTO_TEST_CASE(stops)
{
  check_stops<CGAL::Surface_insertion_traits_3>();
  check_stops<CGAL::Tracing_traits_3>();
  check_stops<CGAL::Plain_insertion_traits_3>();
}

BOOST_AUTO_TEST_CASE(exception_of_the_visitor)
{
  for (const std::size_t when : {std::size_t(0), std::size_t(1), torus().points.size() - 1}) {
    Watching_visitor visitor;
    visitor.throw_before = when;
    Triangulation empty, tr = cube_of_points();
    const std::size_t before = tr.number_of_vertices();
    BOOST_CHECK_THROW(watch<CGAL::Tracing_traits_3>(empty, visitor), std::runtime_error);
    BOOST_TEST(empty.number_of_vertices() == 0u);
    BOOST_TEST(empty.is_valid());
    BOOST_CHECK_THROW(watch<CGAL::Tracing_traits_3>(tr, visitor), std::runtime_error);
    BOOST_TEST(tr.number_of_vertices() == before + when);
    BOOST_TEST(tr.is_valid());
    watch<CGAL::Tracing_traits_3>(empty); // and may be used again
    BOOST_TEST((empty == torus().plain));
  }
}

BOOST_AUTO_TEST_CASE(exception_of_the_output_iterator)
{
  std::size_t written = 0;
  const auto throwing = boost::make_function_output_iterator([&](const auto&) {
    if (++written == 100)
      throw std::runtime_error("the output throws");
  });
  Triangulation tr;
  BOOST_CHECK_THROW(CGAL::insert_points_3(tr, torus().points, torus().surface.faces,
                                          parameters::vertex_to_vertex_output_iterator(throwing)),
                    std::runtime_error);
  BOOST_TEST(written == 100u);
  BOOST_TEST(tr.number_of_vertices() == 0u);
  BOOST_TEST(tr.is_valid());
}
