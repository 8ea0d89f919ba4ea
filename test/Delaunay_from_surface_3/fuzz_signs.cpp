// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Every stage of the compact kernel's predicates next to exact rational numbers and, where a
// determinant is 0, to CGAL's perturbation over these: of points, and of the same with weights. A
// stage may leave a sign open, and must never say a wrong one. See fuzz_campaign.h for the options.

#include "check_signs.h"
#include "fuzz_campaign.h"
#include "hostile_points.h"
#include "hostile_weights.h"
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

// As the kernel does it: a power of 2 that makes all coordinates, and the square roots of weights,
// less than 2^58 in absolute value. Returns whether that is exact.
bool scale(Points& points, Weights& weights)
{
  double largest = 0;
  for (const double w : weights)
    largest = (std::max)(largest, std::sqrt(std::abs(w)));
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
  for (double& w : weights) {
    const double scaled = std::ldexp(w, 2 * (58 - exponent));
    is_exact = is_exact && std::ldexp(scaled, 2 * (exponent - 58)) == w;
    w = scaled;
  }
  return is_exact;
}

class Signs : public Subject
{
  static constexpr std::size_t quintuples_per_case = 40;

  // Points, with weights or without, before they were scaled, if that rounds any, and after it.
  struct Scaled
  {
    Points own_points, points;
    Weights own_weights, weights;
    bool is_exact = false;

    Scaled() = default;
    Scaled(const Points& p, const Weights& w)
      : own_points(p)
      , points(p)
      , own_weights(w)
      , weights(w)
    {
      is_exact = scale(points, weights);
      if (is_exact) {
        own_points = points;
        own_weights = weights;
      }
    }
  };

  struct Case
  {
    const Category* category;
    const Weighting* weighting;
    Scaled plain, weighted;
    std::vector<std::array<std::size_t, 9>> quintuples; // cell, point, four opposite vertices
  };

  static Case make_case(Seed seed)
  {
    Random r(seed);
    Case c;
    c.category = &categories[r.below(number_of_categories)];
    Points points = hostile_points(*c.category, r, 5 + r.below(r.one_in(2) ? 5 : 60));
    c.plain = Scaled(points, {});
    c.quintuples.resize(quintuples_per_case);
    for (auto& quintuple : c.quintuples)
      for (std::size_t& i : quintuple)
        i = r.below(points.size());
    c.weighting = &weightings[r.below(number_of_weightings)];
    if (r.one_in(2))
      points = c.plain.points;
    const Weights weights = hostile_weights(*c.weighting, r, points);
    c.weighted = Scaled(points, weights);
    return c;
  }

  template <class Item>
  static std::vector<Item> nine(const std::vector<Item>& items, const Case& c, std::size_t i)
  {
    std::vector<Item> some;
    for (const std::size_t k : c.quintuples[i])
      if (!items.empty())
        some.push_back(items[k]);
    return some;
  }

  // Where scaling rounds, the kernel asks only the first filters, and integers of any width.
  template <class Place>
  static void check_signs(const Scaled& s, const Case& c, std::size_t i, Checked_signs& signs,
                          Checked_signs& rounded_signs)
  {
    const Quintuple quintuple = quintuple_of(nine(s.points, c, i), nine(s.weights, c, i));
    if (s.is_exact) {
      check_cell<Place>(quintuple, signs);
      check_infinite_cell<Place>(quintuple, signs);
    } else
      check_rounded_cell<Place>(quintuple,
                                quintuple_of(nine(s.own_points, c, i), nine(s.own_weights, c, i)),
                                rounded_signs);
  }

public:
  std::size_t number_of_parts(Seed) const override { return quintuples_per_case; }

  std::string check(Seed seed, const Indices& parts, Tally& tally) const override
  {
    const Case c = make_case(seed);
    tally.count(std::string("category: ") + c.category->name);
    tally.count(std::string("weights: ") + c.weighting->name);
    tally.count("rounded", !c.plain.is_exact);
    tally.count("rounded with weights", !c.weighted.is_exact);
    Checked_signs signs(tally), rounded(tally, "rounded "), weighted(tally, "weighted "),
        rounded_weighted(tally, "rounded weighted ");
    for (const std::size_t i : parts) {
      check_signs<const double*>(c.plain, c, i, signs, rounded);
      check_signs<Weighted_place>(c.weighted, c, i, weighted, rounded_weighted);
    }
    return "";
  }

  std::string description(Seed seed, const Indices& parts) const override
  {
    const Case c = make_case(seed);
    std::string text = std::string("category: ") + c.category->name;
    for (const std::size_t i : parts) {
      text += "\ncell, point, opposite vertices:" + to_string(nine(c.plain.own_points, c, i));
      text += std::string("\nwith weights (") + c.weighting->name +
              "):" + to_string(nine(c.weighted.own_points, c, i));
      char number[40];
      for (const double w : nine(c.weighted.own_weights, c, i)) {
        std::snprintf(number, sizeof(number), "\n  %a,", w);
        text += number;
      }
    }
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
