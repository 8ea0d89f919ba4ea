// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Many workers in the compact kernel: eight threads on whatever cores there are, in batches of
// eight points, from the thirtieth point on, make what one thread makes, with weights and without.
// Meant for ThreadSanitizer, too.

#define BOOST_TEST_MODULE test_workers
#include <boost/test/included/unit_test.hpp>

#include "Owning_worker.h"
#include "parallel_case.h"

#include <CGAL/Delaunay_from_surface_3/core/kernel/Ordered_complex.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

const char* const kinds[] = {"cube", "sphere", "lattice", "duplicates", "moment curve", "hub"};

template <class Vertex>
void check(const char* kind, unsigned seed,
           const std::vector<tests::Coordinates_of<Vertex>>& points)
{
  const auto one = tests::cells_by_one<Vertex>(points);
  const auto many = tests::insert_by_many<Vertex>(points);
  BOOST_TEST_CONTEXT(kind << (Vertex::has_weight ? " with weights" : "") << ", seed " << seed
                          << ", clashes " << many.clashes << ", put off " << many.put_off)
  {
    BOOST_TEST(many.is_valid);
    BOOST_TEST((many.cells == one));
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(many_workers_make_what_one_makes)
{
  // ThreadSanitizer takes twenty times as long.
  constexpr bool is_watched = CGAL::Delaunay_from_surface_3::internal::is_watched;
  for (const char* kind : kinds)
    for (unsigned seed = 1; seed <= (is_watched ? 1 : 4); ++seed) {
      const std::size_t n = std::string(kind) == "moment curve" ? 300 : is_watched ? 1000 : 3000;
      check<tests::Compact_vertex>(kind, seed, tests::points_of(kind, n, seed));
      check<tests::Weighted_vertex>(kind, seed, tests::balls_of(kind, n, seed));
    }
}

BOOST_AUTO_TEST_CASE(workers_one_after_the_other_make_the_same)
{
  for (const char* kind : kinds) {
    const auto points = tests::points_of(kind, 600, 7);
    const auto many = tests::insert_by_many(points, tests::One_after_the_other(8));
    BOOST_TEST_CONTEXT(kind)
    {
      BOOST_TEST(many.is_valid);
      BOOST_TEST((many.cells == tests::cells_by_one(points)));
      BOOST_TEST(many.clashes == 0u);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_worker_left_out_is_noticed)
{
  const auto points = tests::points_of("cube", 600, 7);
  BOOST_CHECK_THROW(tests::insert_by_many(points, tests::Forgetful_executor(8)), std::logic_error);
}

// Each worker's first walk in a round leads along a bar, through more cells than one walk may see: it is
// taken up where it was left, and not begun again for each of the points behind.
BOOST_AUTO_TEST_CASE(walks_from_afar_come_near)
{
  constexpr std::size_t n = 40000, first_round = 2000;
  auto points = tests::points_of("cube", n, 5);
  for (auto& p : points)
    p[0] *= 5000;
  const auto along_bar = [](const auto& p, const auto& q) { return p[0] < q[0]; };
  std::sort(points.begin(), points.begin() + first_round, along_bar);
  std::sort(points.begin() + first_round, points.end(), along_bar);
  tests::Subject<> subject(points);
  const tests::Thread_executor executor(8);
  CGAL::Delaunay_from_surface_3::internal::Parallel_triangulation<tests::Compact_vertex>
      triangulation(subject.complex, executor);
  const CGAL::Delaunay_from_surface_3::internal::Starting_cells<tests::Compact_vertex> hints(
      subject.complex, subject.vertex_of, nullptr, subject.any_vertex);
  triangulation.insert_chunk(0, first_round, subject.vertex_of, hints, tests::Never_stop());
  triangulation.insert_chunk(first_round, n, subject.vertex_of, hints, tests::Never_stop());
  triangulation.finish();
  BOOST_TEST(triangulation.counts().cells_tested_to_start < 100 * n);
  BOOST_TEST(subject.complex.is_valid());
  BOOST_TEST(CGAL::Delaunay_from_surface_3::internal::is_delaunay(subject.complex));
}

// What the handshake promises, by another protocol: if this fails, too, the error is elsewhere.
BOOST_AUTO_TEST_CASE(workers_that_own_cells_make_the_same)
{
  using Worker = tests::Owning_worker<tests::Compact_vertex>;
  for (const char* kind : kinds) {
    const auto points = tests::points_of(kind, std::string(kind) == "moment curve" ? 200 : 1000, 5);
    const auto many = tests::insert_by_many<tests::Compact_vertex, Worker>(points);
    BOOST_TEST_CONTEXT(kind << ", clashes " << many.clashes << ", put off " << many.put_off)
    {
      BOOST_TEST(many.is_valid);
      BOOST_TEST((many.cells == tests::cells_by_one(points)));
    }
  }
}

// 2, 4, 8, 16, 32 and 64 marks have different words.
BOOST_AUTO_TEST_CASE(any_number_of_workers)
{
  const auto points = tests::points_of("cube", 2000, 11);
  const auto one = tests::cells_by_one(points);
  for (const std::size_t number : {1, 2, 3, 5, 12, 20, 64}) {
    const auto many = tests::insert_by_many(points, tests::Thread_executor(number));
    BOOST_TEST_CONTEXT(number)
    {
      BOOST_TEST(many.is_valid);
      BOOST_TEST((many.cells == one));
    }
  }
}

namespace {

// There is no visitor here: go_further() ends the chunk, before whatever batch the caller's worker
// would take. Others may leave it none.
template <class Executor>
void check_stops(const Executor& executor, bool caller_has_its_chunks)
{
  const auto points = tests::points_of("sphere", 2000, 3);
  for (const int stops_at : {0, 1, 5}) {
    tests::Subject<> subject(points);
    CGAL::Delaunay_from_surface_3::internal::Parallel_triangulation<tests::Compact_vertex>
        triangulation(subject.complex, executor, {30, 8, 8});
    const tests::Start_at_half<tests::Compact_vertex> hints(subject);
    int asked = 0;
    const auto go_further = [&](std::size_t) { return asked++ < stops_at; };
    triangulation.insert_chunk(0, 30, subject.vertex_of, hints, tests::Never_stop());
    const bool is_stopped =
        !triangulation.insert_chunk(30, 2000, subject.vertex_of, hints, go_further);
    BOOST_TEST(is_stopped == (asked > stops_at));
    BOOST_TEST(asked <= stops_at + 1); // a no is final
    BOOST_TEST((is_stopped || !caller_has_its_chunks));
    triangulation.finish();
    BOOST_TEST(subject.complex.is_valid());
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(stop_leaves_a_triangulation)
{
  check_stops(tests::Caller_first(4), true);
  check_stops(tests::Thread_executor(4), false);
}
