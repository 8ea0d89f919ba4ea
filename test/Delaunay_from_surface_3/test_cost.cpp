// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Choi 2002, Theorem 3: a trace takes O(n) expected time. Hence the cells that its walks enter, per
// point located, do not depend on n.

#define BOOST_TEST_MODULE test_cost
#include <boost/test/included/unit_test.hpp>

#include <Delaunay_from_surface_3_surfaces/genus_surface.h>

#include <Delaunay_from_surface_3_meters/meters.h>
#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Tracing_traits_3.h>
#include <CGAL/insert_points_3.h>

#include <cstddef>
#include <functional>
#include <string>

namespace DFS = CGAL::Delaunay_from_surface_3;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Counting = meters::Predicate_counting_traits_3<Kernel>;
using Phase = CGAL::Surface_insertion_phase;

namespace {

// The figures of one trace, the last: it locates what the last round inserts.
struct Cost
{
  double cells_per_traced_point = 0, cells_per_located_point = 0;
};

template <class Traits>
Cost cost(std::size_t n)
{
  const surfaces::Indexed_surface surface = surfaces::genus_surface(1, n, 0.05);
  CGAL::Delaunay_triangulation_3<Counting> tr;
  const auto meter = [counting = tr.geom_traits()] { return counting.counts(); };
  meters::Metering_visitor_3<decltype(meter)> visitor(meter);
  CGAL::insert_points_3(tr, surface.points, surface.faces, Traits(),
                        CGAL::parameters::visitor(std::ref(visitor)));
  std::string rounds;
  std::size_t traced = 0;
  for (const auto& round : visitor.rounds()) {
    if (round[Phase::TRACE].cells_entered() == 0)
      continue;
    traced += round.number_of_traced_points;
    rounds += " " + std::to_string(double(round[Phase::TRACE].cells_entered()) /
                                   double(round.number_of_traced_points));
  }
  Cost result;
  if (traced > 0)
    result.cells_per_traced_point =
        double(visitor.total(Phase::TRACE).cells_entered()) / double(traced);
  result.cells_per_located_point =
      double(visitor.total(Phase::LOCATION).cells_entered()) / double(surface.points.size());
  BOOST_TEST_MESSAGE(surface.points.size()
                     << " points: cells entered per point: traced " << result.cells_per_traced_point
                     << " (by round" << rounds << "), located " << result.cells_per_located_point);
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(cells_entered_per_traced_point_do_not_grow)
{
  const Cost small = cost<CGAL::Tracing_traits_3>(64000);
  for (const std::size_t n : {250000, 1000000}) {
    const Cost large = cost<CGAL::Tracing_traits_3>(n);
    BOOST_TEST(large.cells_per_traced_point <= 1.2 * small.cells_per_traced_point);
    BOOST_TEST(large.cells_per_traced_point >= 0.8 * small.cells_per_traced_point);
  }
}
