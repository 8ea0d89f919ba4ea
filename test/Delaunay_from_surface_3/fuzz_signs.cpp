// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Every stage of the compact kernel's predicates next to exact rational numbers and, where a
// determinant is 0, to CGAL's perturbation over these. A stage may leave a sign open, and must
// never say a wrong one. See fuzz_campaign.h for the options.

#include "check_signs.h"
#include "fuzz_campaign.h"
#include "hostile_points.h"
#include "insertion_case.h" // to_string()

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

namespace {

using namespace fuzz;

// As the kernel does it: a power of 2 that makes all coordinates less than 2^58 in absolute value.
// Returns whether that is exact; where it is not, the kernel does not serve.
bool scale(Points& points)
{
  double largest = 0;
  for (const Coordinates& p : points)
    for (const double c : p)
      largest = (std::max)(largest, std::abs(c));
  int exponent = 0;
  std::frexp(largest, &exponent);
  bool is_exact = true;
  for (Coordinates& p : points)
    for (double& c : p) {
      const double scaled = std::ldexp(c, 58 - exponent);
      is_exact = is_exact && std::ldexp(scaled, exponent - 58) == c;
      c = scaled;
    }
  return is_exact;
}

class Signs : public Subject
{
  static constexpr std::size_t quintuples_per_case = 40;

  struct Case
  {
    const Category* category;
    Points points;
    bool is_served;
    std::vector<std::array<std::size_t, 9>> quintuples; // cell, point, four opposite vertices
  };

  static Case make_case(Seed seed)
  {
    Random r(seed);
    Case c;
    c.category = &categories[r.below(number_of_categories)];
    c.points = hostile_points(*c.category, r, 5 + r.below(r.one_in(2) ? 5 : 60));
    c.is_served = scale(c.points);
    c.quintuples.resize(quintuples_per_case);
    for (auto& quintuple : c.quintuples)
      for (std::size_t& i : quintuple)
        i = r.below(c.points.size());
    return c;
  }

  static Points nine_points(const Case& c, std::size_t i)
  {
    Points points;
    for (const std::size_t k : c.quintuples[i])
      points.push_back(c.points[k]);
    return points;
  }

public:
  std::size_t number_of_parts(Seed) const override { return quintuples_per_case; }

  std::string check(Seed seed, const Indices& parts, Tally& tally) const override
  {
    const Case c = make_case(seed);
    tally.count(std::string("category: ") + c.category->name);
    if (!c.is_served)
      tally.count("not served");
    else {
      Checked_signs signs(tally);
      for (const std::size_t i : parts) {
        const Quintuple quintuple = quintuple_of(nine_points(c, i));
        check_cell(quintuple, signs);
        check_infinite_cell(quintuple, signs);
      }
    }
    return "";
  }

  std::string description(Seed seed, const Indices& parts) const override
  {
    const Case c = make_case(seed);
    std::string text = std::string("category: ") + c.category->name;
    for (const std::size_t i : parts)
      text += "\ncell, point, opposite vertices:" + to_string(nine_points(c, i));
    return text;
  }
};

} // namespace

int main(int argc, char** argv)
{
  try {
    const Signs signs;
    return Campaign(signs, argc, argv).run();
  } catch (const std::exception& e) {
    std::fprintf(stderr, "fuzz_signs: %s\n", e.what());
    return EXIT_FAILURE;
  }
}
