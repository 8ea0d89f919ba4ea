// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Numbers that broke the compact kernel once: coordinates of very different size, other rounding
// modes than to nearest, more cells than ids. fuzz_insertions.cpp has what is like them by the
// million.

#define BOOST_TEST_MODULE test_hostile_numbers
#include <boost/test/included/unit_test.hpp>

#include "core_traits.h"
#include "check_insertion.h"
#include "check_signs.h"
#include "kept_inputs.h"
#include "parallel_case.h"

#include <CGAL/Delaunay_from_surface_3/core/kernel/Ordered_complex.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/surface/No_subgraph.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_insertion_traits_3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using fuzz::Insertion_case;
using fuzz::Points;
using Triangulation =
    CGAL::Delaunay_triangulation_3<CGAL::Exact_predicates_inexact_constructions_kernel>;

namespace parts = CGAL::Delaunay_from_surface_3;

namespace {

template <class Traits = CGAL::Surface_insertion_traits_3>
void check(const Insertion_case& c)
{
  fuzz::Tally tally;
  BOOST_TEST_CONTEXT((c.points.size() > 100 ? "many points" : fuzz::to_string(c)))
  {
    std::string mistake;
    BOOST_REQUIRE_NO_THROW(
        (mistake = fuzz::check_insertion<Triangulation, Traits, fuzz::As_graph>(c, tally)));
    BOOST_TEST(mistake == "");
  }
}

} // namespace

// What the fuzzers found once, and all of it together: signs, insertions, and threads that meet.
BOOST_AUTO_TEST_CASE(kept_inputs)
{
  Insertion_case all;
  for (const fuzz::Kept_input& kept : fuzz::kept_inputs) {
    const fuzz::Quintuple quintuple = fuzz::quintuple_of(kept.points, kept.weights);
    fuzz::Tally tally;
    fuzz::Checked_signs signs(tally);
    BOOST_TEST_CONTEXT(kept.constants)
    {
      BOOST_CHECK_NO_THROW(fuzz::check_cell(quintuple, signs));
      BOOST_CHECK_NO_THROW(fuzz::check_infinite_cell(quintuple, signs));
      if (!kept.weights.empty()) {
        BOOST_CHECK_NO_THROW(fuzz::check_cell<fuzz::Weighted_place>(quintuple, signs));
        BOOST_CHECK_NO_THROW(fuzz::check_infinite_cell<fuzz::Weighted_place>(quintuple, signs));
      }
    }
    Insertion_case c;
    c.points = kept.points;
    check(c);
    all.points.insert(all.points.end(), kept.points.begin(), kept.points.end());
  }
  check(all);
  const auto many = tests::insert_by_many(all.points, tests::Thread_executor(8), {4, 1, 1});
  BOOST_TEST(many.is_valid);
  BOOST_TEST((many.cells == tests::cells_by_one(all.points)));
}

// 2^1022 apart and more, a factor that brings the largest to 1 makes denormals of others, or zeros.
BOOST_AUTO_TEST_CASE(coordinates_of_very_different_size)
{
  const std::vector<Points> sets = {
      {{0x1.6d59f4753eb5ap+884, 0x1.39fabecc572e5p+885, 0x1.68d1b5d28d06cp+885},
       {-0x1.a75caef34949ap-422, -0x1.4fc23b0fe93c4p-424, -0x1.136e8e648f892p-422},
       {-0x1.f48a6940c3635p+574, 0x1.58ad5ab744a92p+571, 0x1.8ae70ec78c8dcp+572},
       {-0x1.f163b1fd68848p-425, -0x1.a747df85f5bedp-427, 0x1.dca4e5f15223p-428},
       {-0x1.6433601e92792p-857, -0x1.641e0b22a8104p-857, 0x1.6f98fbf0c89dp-859}},
      {{-0x1.93fff7791ec1ap-306, -0x1.321acfa0ed1a1p-306, 0x1.2138387cdbf98p-308},
       {0x1.878558bc6ecbcp+873, 0x1.ff6933a0231dfp+877, 0x1.020019310cb65p+870},
       {-0x1.735d5f44c717p+651, 0x1.7ab2dcc36beccp+651, 0x1.ee880440c3713p+653},
       {-0x1.ab875a632b20bp-892, -0x1.f9945e299aa24p-894, -0x1.f7899e9bdb47fp-893},
       {-0x1.91722c45febep-498, 0x1.14ce317c0fb03p-498, 0x1.382db7130b76cp-499}},
      {{-0x1.dcd65p+29, 0, 0x1.dcd65000ccccdp+29}, // a least double among large ones
       {-0x1.dcd65p+29, 0x1p-1074, 0x1.dcd65000ccccdp+29},
       {-0x1.dcd64fff33333p+29, 0, 0x1.dcd65000ccccdp+29},
       {-0x1.dcd65000ccccdp+29, -0x1.999999999999ap-4, 0x1.dcd65p+29},
       {-0x1.dcd65p+29, -0x1.999999999999ap-4, 0x1.dcd6500000001p+29}}};
  for (const Points& points : sets) {
    Insertion_case c;
    c.points = points;
    check(c);
  }
}

// The tails of a bell are denormal. Scaling makes them larger, and so not less exact: that own
// coordinates are kept, and all that the filters leave is decided by long integers, is for others.
BOOST_AUTO_TEST_CASE(heights_that_underflow)
{
  Insertion_case c;
  for (int x = -25; x < 25; ++x)
    for (int y = -25; y < 25; ++y)
      c.points.push_back({double(x), double(y), std::exp(-x * x - y * y)});
  const auto is_denormal = [](const auto& p) { return std::fpclassify(p[2]) == FP_SUBNORMAL; };
  BOOST_TEST(std::count_if(c.points.begin(), c.points.end(), is_denormal) > 10);
  fuzz::Random random(1);
  c.faces = fuzz::strip(random, c.points.size());
  check(c);
  constexpr double least = std::numeric_limits<double>::denorm_min();
  BOOST_TEST(parts::internal::Power_of_scale(25, least).is_exact());
  BOOST_TEST(!parts::internal::Power_of_scale(0x1p900, 0x1p-200).is_exact());
}

BOOST_AUTO_TEST_CASE(every_category_in_every_rounding_mode)
{
  for (const fuzz::Category& category : fuzz::categories)
    for (const fuzz::Rounding_mode& rounding : fuzz::rounding_modes)
      for (fuzz::Seed seed = 0; seed < 3; ++seed) {
        fuzz::Random random(seed);
        Insertion_case c;
        c.category = &category;
        c.points = hostile_points(category, random, 40);
        c.faces = fuzz::strip(random, c.points.size());
        c.later_points = fuzz::cube(random, 4);
        c.rounding = &rounding;
        c.stops_at = seed == 2 ? 20 : fuzz::never;
        c.stops_by_exception = true;
        check(c);
      }
}
