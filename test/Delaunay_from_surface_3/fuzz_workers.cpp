// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Many workers in the compact kernel next to one: kinds of points, numbers of threads and sizes of
// their portions at random, all so small that threads meet all the time. See fuzz_campaign.h for
// the options. A failure that hangs on how threads met need not come again when its case is
// repeated.

#include "fuzz_campaign.h"
#include "insertion_case.h" // to_string()
#include "parallel_case.h"

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iterator>
#include <string>
#include <vector>

namespace {

using namespace fuzz;

const char* const kinds[] = {"cube", "sphere", "lattice", "duplicates", "moment curve", "hub"};

class Workers : public Subject
{
  struct Case
  {
    const char* kind;
    std::vector<tests::Coordinates> points;
    std::size_t threads;
    tests::DFS::internal::Parallel_rules rules;
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
    return c;
  }

public:
  std::size_t number_of_parts(Seed seed) const override { return make_case(seed).points.size(); }

  std::string check(Seed seed, const Indices& parts, Tally& tally) const override
  {
    const Case c = make_case(seed);
    std::vector<tests::Coordinates> points;
    for (const std::size_t i : parts)
      points.push_back(c.points[i]);
    tally.count(std::string("kind: ") + c.kind);
    if (tests::Subject(points).any_vertex == 0) {
      tally.count("in one plane");
      return "";
    }
    const auto many = tests::insert_by_many(points, tests::Thread_executor(c.threads), c.rules);
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
    return std::string(c.kind) + ", " + std::to_string(c.threads) + " threads, from point " +
           std::to_string(c.rules.first_points) + " on, in chunks of " +
           std::to_string(c.rules.chunk) + to_string(points);
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
