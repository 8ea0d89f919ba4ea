// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Whole insertions of hostile points next to plain CGAL's: by all traits, into all triangulations
// and arrays, along wrong surfaces, in every rounding mode, stopped at any moment, with insertions and removals
// after. See fuzz_campaign.h for the options.

#include "fuzz_campaign.h"
#include "insertion_case.h"
#include "insertion_ways.h"

#include <CGAL/assertions.h>
#include <CGAL/assertions_behaviour.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

namespace {

using namespace fuzz;

class Insertions : public Subject
{
public:
  std::size_t number_of_parts(Seed seed) const override
  {
    return fuzz::number_of_parts(whole_case(seed));
  }

  std::string check(Seed seed, const Indices& parts, Tally& tally) const override
  {
    const Insertion_case c = make_case(seed, parts);
    tally.count(std::string("category: ") + c.category->name);
    tally.count(std::string("rounding: ") + c.rounding->name);
    tally.count(std::string("surface: ") + c.faces_name);
    tally.count(std::string("way: ") + way(c).name);
    return way(c).check(c, tally);
  }

  std::string description(Seed seed, const Indices& parts) const override
  {
    const Insertion_case c = make_case(seed, parts);
    return std::string("way: ") + way(c).name + "; " + to_string(c);
  }

private:
  static std::vector<Insertion_way> all_ways()
  {
    std::vector<Insertion_way> ways = ways_by_traits();
    for (const auto& more : {ways_by_triangulation(), ways_into_arrays()})
      ways.insert(ways.end(), more.begin(), more.end());
    return ways;
  }

  const Insertion_way& way(const Insertion_case& c) const { return m_ways[c.way % m_ways.size()]; }

  const std::vector<Insertion_way> m_ways = all_ways();
};

} // namespace

int main(int argc, char** argv)
{
  // What -Ofast has g++ link into a program would make plain CGAL wrong.
  fuzz::take_denormals_for_zero(false);
  // What CGAL would print is in its exceptions; while a case is made smaller there are hundreds.
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
  CGAL::set_warning_handler([](const char*, const char*, const char*, int, const char*) {});
  try {
    const Insertions insertions;
    return Campaign(insertions, argc, argv).run();
  } catch (const std::exception& e) {
    std::fprintf(stderr, "fuzz_insertions: %s\n", e.what());
    return EXIT_FAILURE;
  }
}
