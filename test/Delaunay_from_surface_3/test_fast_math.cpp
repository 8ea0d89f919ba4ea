// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Where the compiler may change operations on doubles, CGAL's own insertion is used, and the visitor
// is told why; arrays are refused, and so are coordinates that are no finite numbers. Compiled with
// -ffast-math, as a user's program may be.

#define BOOST_TEST_MODULE test_fast_math
#include <boost/test/included/unit_test.hpp>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/delaunay_3_arrays.h>
#include <CGAL/insert_points_3.h>

#include <Delaunay_from_surface_3_surfaces/adversarial.h>
#include <Delaunay_from_surface_3_surfaces/genus_surface.h>

#include <cstddef>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using Triangulation =
    CGAL::Delaunay_triangulation_3<CGAL::Exact_predicates_inexact_constructions_kernel>;
using surfaces::Indexed_surface;

const std::string reason = "the compiler may change operations on doubles (-ffast-math, -Ofast)";

struct Counting_visitor : CGAL::Default_surface_insertion_visitor_3
{
  std::size_t told = 0;

  void notice(CGAL::Surface_insertion_notice, const std::string& why) { told += why == reason; }
};

} // namespace

BOOST_AUTO_TEST_CASE(cgal_inserts)
{
  const std::pair<const char*, Indexed_surface> cases[] = {
      {"noise", surfaces::genus_surface(1, 1000, 0.1)},
      {"smooth", surfaces::genus_surface(1, 1000, 0)},
      {"plate", surfaces::plate_surface(1, 1000)},
      {"star", surfaces::star(1000, 1)},
      {"two lines", surfaces::two_lines(300)},
      {"nearly flat", surfaces::nearly_flat(1000, 1e-12, 1)}};
  for (const auto& [name, surface] : cases)
    BOOST_TEST_CONTEXT(name)
    {
      Counting_visitor visitor;
      const auto np = CGAL::parameters::visitor(std::ref(visitor));
      Triangulation tr;
      CGAL::insert_points_3(tr, surface.points, surface.faces, np);
      BOOST_TEST(visitor.told == 1u);
      BOOST_TEST((tr == Triangulation(surface.points.begin(), surface.points.end())));
    }
}

BOOST_AUTO_TEST_CASE(arrays_are_refused)
{
  const Indexed_surface surface = surfaces::genus_surface(1, 1000, 0.1);
  const auto is_said = [](const std::runtime_error& error) {
    return std::string(error.what()).find("not exact: " + reason) != std::string::npos;
  };
  BOOST_CHECK_EXCEPTION(CGAL::delaunay_3_arrays(surface.points), std::runtime_error, is_said);
  BOOST_CHECK_EXCEPTION(CGAL::delaunay_3_arrays(surface.points, surface.faces), std::runtime_error,
                        is_said);
}

BOOST_AUTO_TEST_CASE(what_is_no_finite_number_is_refused)
{
  for (const char* const text : {"nan", "inf", "-inf"}) {
    Indexed_surface surface = surfaces::genus_surface(1, 1000, 0.1);
    surface.points[7] = {0, std::strtod(text, nullptr), 0};
    Triangulation tr;
    BOOST_CHECK_THROW(CGAL::insert_points_3(tr, surface.points), CGAL::Surface_input_error);
    BOOST_CHECK_THROW(CGAL::delaunay_3_arrays(surface.points), CGAL::Surface_input_error);
    BOOST_TEST(tr.number_of_vertices() == 0u);
  }
}

BOOST_AUTO_TEST_CASE(an_order_of_vertices_is_refused)
{
  const Indexed_surface surface = surfaces::genus_surface(1, 1000, 0.1);
  Triangulation tr;
  BOOST_CHECK_EXCEPTION(CGAL::insert_points_3(tr, surface.points, surface.faces,
                                              CGAL::parameters::preserve_order(true)),
                        CGAL::Surface_input_error, [](const CGAL::Surface_input_error& error) {
                          return std::string(error.what()).find(reason) != std::string::npos;
                        });
}
