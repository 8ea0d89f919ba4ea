// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Many workers in the compact kernel next to one: kinds of points, numbers of threads and sizes of
// their portions at random, all so small that threads meet all the time; with TBB, too, in groups
// of tasks that are cancelled at any moment. See fuzz_campaign.h for the options. A failure that
// hangs on how threads met need not come again when its case is repeated.

#include "cancelled_tasks.h"
#include "fuzz_campaign.h"
#include "insertion_case.h" // to_string()
#include "parallel_case.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <CGAL/Delaunay_from_surface_3/adapters/Executor_by_tag.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iterator>
#include <string>
#include <vector>

namespace {

using namespace fuzz;

// Who runs the workers.
enum class Runner { THREADS, TASKS, TASKS_IN_CANCELLED_GROUP, TASKS_BESIDE_ONE_THAT_THROWS };
const char* const runners[] = {"threads", "tasks", "tasks in a cancelled group",
                               "tasks beside one that throws"};

const char* const kinds[] = {"cube", "sphere", "lattice", "duplicates", "moment curve", "hub"};

class Workers : public Subject
{
  struct Case
  {
    const char* kind;
    std::vector<tests::Coordinates> points;
    std::size_t threads;
    tests::DFS::internal::Parallel_rules rules;
    Runner runner;
    std::size_t cancelled_at; // the question whether to go on
  };

  static Case make_case(Seed seed)
  {
    Random r(seed);
    Case c;
    c.kind = kinds[r.below(std::size(kinds))];
    // On a moment curve every zone is of linear size.
    const std::size_t most = std::string(c.kind) == "moment curve" ? 250 : r.one_in(4) ? 4000 : 400;
    c.points = tests::points_of(c.kind, 5 + r.below(most), unsigned(seed));
    c.threads = 2 + r.below(r.one_in(4) ? 31 : 7);
    c.rules = {4 + r.below(60), 1 + r.below(16), 1 + r.below(16)};
#ifdef CGAL_LINKED_WITH_TBB
    c.runner = Runner(r.below(std::size(runners)));
#else
    c.runner = Runner::THREADS;
#endif
    c.cancelled_at = r.below(c.points.size());
    return c;
  }

  static tests::Parallel_outcome insert(const Case& c,
                                        const std::vector<tests::Coordinates>& points)
  {
#ifdef CGAL_LINKED_WITH_TBB
    if (c.runner != Runner::THREADS)
      return insert_by_tasks(c, points);
#endif
    return tests::insert_by_many(points, tests::Thread_executor(c.threads), c.rules);
  }

#ifdef CGAL_LINKED_WITH_TBB
  static tests::Parallel_outcome insert_by_tasks(const Case& c,
                                                 const std::vector<tests::Coordinates>& points)
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, c.threads);
    return tbb::task_arena(int(c.threads)).execute([&] {
      tests::Parallel_outcome outcome;
      const auto insert_and_cancel = [&](const auto& cancel) {
        std::size_t asked = 0;
        outcome = tests::insert_by_many(points, tests::DFS::internal::Tbb_executor(), c.rules,
                                        [&](std::size_t) {
                                          if (asked++ == c.cancelled_at)
                                            cancel();
                                          return true;
                                        });
      };
      if (c.runner == Runner::TASKS)
        insert_and_cancel([]{});
      else if (c.runner == Runner::TASKS_IN_CANCELLED_GROUP)
        tests::call_in_group(insert_and_cancel);
      else
        tests::call_beside_one_that_throws(insert_and_cancel);
      return outcome;
    });
  }
#endif

public:
  std::size_t number_of_parts(Seed seed) const override
  {
    return make_case(seed).points.size();
  }

  std::string check(Seed seed, const Indices& parts, Tally& tally) const override
  {
    const Case c = make_case(seed);
    std::vector<tests::Coordinates> points;
    for (const std::size_t i : parts)
      points.push_back(c.points[i]);
    tally.count(std::string("kind: ") + c.kind);
    tally.count(std::string("workers: ") + runners[std::size_t(c.runner)]);
    if (tests::Subject(points).any_vertex == 0) {
      tally.count("in one plane");
      return "";
    }
    const auto many = insert(c, points);
    tally.count("points", points.size());
    tally.count("clashes", many.clashes);
    tally.count("points put off", many.put_off);
    if (!many.is_valid)
      return "not a Delaunay triangulation";
    return many.cells == tests::cells_by_one(points) ? "" : "not what one worker makes";
  }

  std::string description(Seed seed, const Indices& parts) const override
  {
    const Case c = make_case(seed);
    Points points;
    for (const std::size_t i : parts)
      points.push_back(c.points[i]);
    return std::string(c.kind) + ", " + std::to_string(c.threads) + " " +
           runners[std::size_t(c.runner)] + ", from point " + std::to_string(c.rules.first_points) +
           " on, in batches of " + std::to_string(c.rules.batch) + to_string(points);
  }
};

} // namespace

int main(int argc, char** argv)
{
  try {
    const Workers workers;
    return Campaign(workers, argc, argv).run();
  } catch (const std::exception& e) {
    std::fprintf(stderr, "fuzz_workers: %s\n", e.what());
    return EXIT_FAILURE;
  }
}
