// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls from eight threads at once for some minutes, each with its own triangulation: small and
// large, into triangulations and arrays, stopped, refused, short of memory, with threads of their
// own, in groups of tasks that are cancelled. Every result is looked at; and the process must not
// grow: bytes allocated, open files.
//
//   fuzz_calls [--minutes M] [--callers N]      else FUZZ_MINUTES, or one; 8

#include "cancelled_tasks.h"
#include "failing_allocations.h"
#include "fixed_inputs.h"
#include "random_bits.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/delaunay_3_arrays.h>
#include <CGAL/insert_points_3.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <mutex>
#include <new>
#include <string>
#include <thread>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#else
#define __GLIBC_PREREQ(major, minor) 0
#endif

// CGAL's Compact_container loses a block when its list of blocks cannot grow.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions()
{
  return "leak:allocate_new_block\n";
}

namespace {

using Triangulation =
    CGAL::Delaunay_triangulation_3<CGAL::Exact_predicates_inexact_constructions_kernel>;
using Point = Triangulation::Point;
using Clock = std::chrono::steady_clock;

// What is asked for, and what must come.
struct Input
{
  tests::Fixed_points coordinates;
  std::vector<Point> points;
  std::uint64_t hash = 0;
  Triangulation plain;
};

std::deque<Input> make_inputs()
{
  std::deque<Input> inputs;
  for (const tests::Fixed_input& fixed : tests::fixed_inputs) {
    Input& input = inputs.emplace_back();
    input.coordinates = tests::points_of(fixed);
    input.hash = fixed.hash;
  }
  Input& large = inputs.emplace_back(); // 27 cubes beside each other
  const tests::Fixed_points cube = inputs.front().coordinates;
  for (int k = 0; k < 27; ++k)
    for (const auto& p : cube)
      large.coordinates.push_back({p[0] + k % 3, p[1] + k / 3 % 3, p[2] + k / 9});
  large.hash = tests::hash_of(CGAL::delaunay_3_arrays(large.coordinates));
  for (Input& input : inputs) {
    for (const auto& p : input.coordinates)
      input.points.emplace_back(p[0], p[1], p[2]);
    input.plain.insert(input.points.begin(), input.points.end());
  }
  return inputs;
}

// One kind of call; returns whether all is as it must be.
using Call = std::function<bool(const Input&, fuzz::Random&)>;

// CGAL's comparison marks cells of the second one for a while, so that must be the caller's own.
bool is_equal(const Input& input, const Triangulation& tr)
{
  return input.plain == tr;
}

bool is_untouched(const Triangulation& tr)
{
  return tr.number_of_vertices() == 0 && tr.dimension() == -1;
}

bool insert_all(const Input& input, fuzz::Random&)
{
  Triangulation tr;
  CGAL::insert_points_3(tr, input.points);
  return is_equal(input, tr);
}

bool make_arrays(const Input& input, fuzz::Random&)
{
  return tests::hash_of(CGAL::delaunay_3_arrays(input.coordinates)) == input.hash;
}

// To stop when all is done is too late.
bool stop(const Input& input, fuzz::Random& random)
{
  const double share = random.unit();
  double stopped_at = 1;
  Triangulation tr;
  CGAL::insert_points_3(tr, input.points, CGAL::parameters::visitor([&](double inserted) {
                          if (inserted >= share)
                            stopped_at = (std::min)(stopped_at, inserted);
                          return stopped_at == 1 && inserted < share;
                        }));
  return stopped_at < 1 ? is_untouched(tr) : is_equal(input, tr);
}

bool refuse(const Input& input, fuzz::Random& random)
{
  tests::Fixed_points points = input.coordinates;
  points[random.below(points.size())][random.below(3)] = std::numeric_limits<double>::quiet_NaN();
  Triangulation tr;
  try {
    CGAL::insert_points_3(tr, points);
  } catch (const CGAL::Surface_input_error&) {
    return is_untouched(tr);
  }
  return false;
}

// Not where CGAL's own insertion takes over, whose table stays damaged.
bool run_short_of_memory(const Input& input, fuzz::Random& random)
{
  if (input.plain.dimension() < 3)
    return true;
  static std::mutex one_at_a_time;
  const std::unique_lock<std::mutex> lock(one_at_a_time, std::try_to_lock);
  if (!lock)
    return true;
  Triangulation tr;
  try {
    const tests::Failing_allocation failing(tests::Allocating::CALLER, 1 + long(random.below(40)));
    CGAL::insert_points_3(tr, input.points);
  } catch (const std::bad_alloc&) {
    return is_untouched(tr);
  }
  return is_equal(input, tr);
}

#ifdef CGAL_LINKED_WITH_TBB
bool insert_by_threads(const Input& input, fuzz::Random& random)
{
  Triangulation tr;
  tbb::task_arena(2 + int(random.below(3))).execute([&] {
    CGAL::insert_points_3<CGAL::Parallel_tag>(tr, input.points);
  });
  return is_equal(input, tr);
}

bool insert_in_cancelled_group(const Input& input, fuzz::Random& random)
{
  const double share = random.unit();
  Triangulation tr;
  tests::call_in_group([&](const auto& cancel) {
    CGAL::insert_points_3<CGAL::Parallel_tag>(tr, input.points,
                                              CGAL::parameters::visitor([&](double done) {
                                                if (done >= share)
                                                  cancel();
                                                return true;
                                              }));
  });
  return is_equal(input, tr);
}
#endif

const struct
{
  const char* name;
  Call call;
} calls[] = {
    // [4] is short of memory
    {"all", insert_all},
    {"arrays", make_arrays},
    {"stopped", stop},
    {"refused", refuse},
    {"short of memory", run_short_of_memory},
#ifdef CGAL_LINKED_WITH_TBB
    {"threads of its own", insert_by_threads},
    {"in a cancelled group", insert_in_cancelled_group},
#endif
};

std::array<std::atomic<std::size_t>, std::size(calls)> done = {}, wrong = {};

void call_until(Clock::time_point end, const std::deque<Input>& inputs, unsigned seed)
{
  fuzz::Random random(seed);
  while (Clock::now() < end) {
    const bool is_large = random.below(100) == 0;
    const Input& input = is_large ? inputs.back() : inputs[random.below(inputs.size() - 1)];
    const std::size_t k = random.below(std::size(calls));
    if (!calls[k].call(input, random)) {
      ++wrong[k];
      std::printf("wrong: %s, %zu points\n", calls[k].name, input.points.size());
    }
    ++done[k];
  }
}

// What the process holds while nobody calls: bytes that are allocated; those that are resident lie
// between much that is free, and are printed alone. Linux with glibc only; elsewhere nothing.
struct Holdings
{
  std::size_t bytes = 0, resident = 0, files = 0, threads = 0;
};

Holdings holdings()
{
  Holdings h;
#if __GLIBC_PREREQ(2, 33)
  malloc_trim(0);
  const auto allocated = mallinfo2();
  h.bytes = allocated.uordblks + allocated.hblkhd;
#endif
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == "VmRSS:")
      status >> h.resident;
    else if (word == "Threads:")
      status >> h.threads;
  std::error_code none;
  for (auto it = std::filesystem::directory_iterator("/proc/self/fd", none);
       it != std::filesystem::directory_iterator(); ++it)
    ++h.files;
  std::printf("held: %.2f MB (resident %.0f), %zu files, %zu threads\n", double(h.bytes) / 1e6,
              double(h.resident) / 1e3, h.files, h.threads);
  return h;
}

// CGAL's Compact_container loses a block if there is no memory for the list of its blocks.
bool has_grown(const Holdings& before, const Holdings& after, std::size_t calls_short_of_memory)
{
  const std::size_t slack = (1 << 20) + 200 * calls_short_of_memory; // TBB's, for each thread
  return after.bytes > before.bytes + slack || after.files > before.files;
}

double number_after(const std::vector<std::string>& words, const char* name, double otherwise)
{
  const auto at = std::find(words.begin(), words.end(), name);
  return at == words.end() || at + 1 == words.end() ? otherwise : std::stod(*(at + 1));
}

} // namespace

int main(int argc, char** argv)
{
  const std::vector<std::string> words(argv + 1, argv + argc);
  const char* const wanted = std::getenv("FUZZ_MINUTES");
  const double minutes = number_after(words, "--minutes", wanted ? std::stod(wanted) : 1);
  const auto number = unsigned(number_after(words, "--callers", 8));

#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control more_than_cores(tbb::global_control::max_allowed_parallelism, 8);
#endif
  const std::deque<Input> inputs = make_inputs();
  std::vector<Holdings> held;
  std::vector<std::size_t> short_of_memory;
  for (unsigned quarter = 0; quarter < 4; ++quarter) {
    const Clock::time_point end =
        Clock::now() + std::chrono::milliseconds(std::int64_t(15000 * minutes));
    std::vector<std::thread> callers;
    for (unsigned i = 0; i < number; ++i)
      callers.emplace_back(call_until, end, std::cref(inputs), 1 + i + number * quarter);
    for (std::thread& caller : callers)
      caller.join();
    held.push_back(holdings());
    short_of_memory.push_back(done[4]);
  }

  bool is_right = !has_grown(held[1], held[3], short_of_memory[3] - short_of_memory[1]);
  for (std::size_t k = 0; k < std::size(calls); ++k) {
    std::printf("%s: %zu calls, %zu wrong\n", calls[k].name, done[k].load(), wrong[k].load());
    is_right = is_right && done[k] > 0 && wrong[k] == 0;
  }
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
