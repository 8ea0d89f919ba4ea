// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Whichever allocation fails, in whichever thread, an empty triangulation stays empty and usable.
// Not with `Fast_location`: its upper levels are filled by CGAL's own insertion, which keeps a
// table per thread. An exception leaves entries there, and a later insertion into any triangulation
// of that type stumbles on them.

#define BOOST_TEST_MODULE test_allocation
#include <boost/test/included/unit_test.hpp>

#include "failing_allocations.h"

#include <Delaunay_from_surface_3_surfaces/parametric.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/insert_points_3.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <tbb/task_scheduler_observer.h>
#endif

#include <atomic>
#include <chrono>
#include <cstddef>
#include <thread>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
using surfaces::Indexed_surface;
using tests::Allocating;

enum class Outcome { FAILED, PASSED_OVER, NOTHING_TO_FAIL };

// Inserts while the k-th allocation fails.
template <class ConcurrencyTag>
Outcome insert_and_fail(Triangulation& tr, const Indexed_surface& surface, Allocating whose, long k)
{
  const tests::Failing_allocation failing(whose, k);
  try {
    CGAL::insert_points_3<ConcurrencyTag>(tr, surface.points, surface.faces);
  } catch (const std::bad_alloc&) {
    return Outcome::FAILED;
  }
  return failing.has_failed() ? Outcome::PASSED_OVER : Outcome::NOTHING_TO_FAIL;
}

// One after the other, of many not each, until there is none left to fail. Threads do not allocate
// the same in every call: so `last_calls` in turn must have had none. Returns how many failed.
template <class ConcurrencyTag>
std::size_t check_failures(const Indexed_surface& surface, Allocating whose, int last_calls)
{
  const Triangulation plain(surface.points.begin(), surface.points.end());
  std::size_t failures = 0;
  int without = 0;
  for (long k = 1; without < last_calls; k += 1 + k / 64) {
    Triangulation tr;
    const Outcome outcome = insert_and_fail<ConcurrencyTag>(tr, surface, whose, k);
    BOOST_TEST_REQUIRE((outcome != Outcome::PASSED_OVER));
    without = outcome == Outcome::FAILED ? 0 : without + 1;
    if (outcome == Outcome::FAILED) {
      BOOST_TEST_REQUIRE(tr.number_of_vertices() == 0u);
      BOOST_TEST_REQUIRE(tr.is_valid());
      if (failures++ % 16 == 0)
        CGAL::insert_points_3<ConcurrencyTag>(tr, surface.points, surface.faces);
    }
    if (tr.number_of_vertices() > 0)
      BOOST_TEST_REQUIRE((tr == plain));
  }
  return failures;
}

} // namespace

BOOST_AUTO_TEST_CASE(each_allocation_fails_once)
{
  const std::size_t failures =
      check_failures<CGAL::Sequential_tag>(surfaces::sphere(400, 0.05), Allocating::CALLER, 1);
  BOOST_TEST_MESSAGE(failures << " allocations");
  BOOST_TEST(failures > 20u);
}

#ifdef CGAL_LINKED_WITH_TBB

namespace {

// The threads in an arena, its caller's too.
class Threads_in_arena : public tbb::task_scheduler_observer
{
public:
  explicit Threads_in_arena(tbb::task_arena& arena)
    : tbb::task_scheduler_observer(arena)
  {
    observe(true);
  }
  ~Threads_in_arena() override { observe(false); }
  void on_scheduler_entry(bool) override { ++m_number; }
  void on_scheduler_exit(bool) override { --m_number; }

  // Threads without work leave.
  bool have_left() const
  {
    for (int tries = 0; tries < 5000 && m_number > 0; ++tries)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return m_number == 0;
  }

private:
  std::atomic<int> m_number{0};
};

} // namespace

BOOST_AUTO_TEST_CASE(each_allocation_of_each_thread_fails_once)
{
  const Indexed_surface surface = surfaces::sphere(5000, 0.05);
  tbb::global_control eight(tbb::global_control::max_allowed_parallelism, 8);
  for (const Allocating whose : {Allocating::CALLER, Allocating::OTHERS}) {
    tbb::task_arena arena(8);
    const Threads_in_arena threads(arena);
    std::size_t failures = 0;
    arena.execute([&] { failures = check_failures<CGAL::Parallel_tag>(surface, whose, 4); });
    BOOST_TEST(threads.have_left());
    BOOST_TEST_MESSAGE(failures << " allocations");
    BOOST_TEST(failures > (whose == Allocating::CALLER ? 100u : 0u));
  }
}

#endif
