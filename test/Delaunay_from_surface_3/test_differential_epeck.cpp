// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Generated surfaces: every traits class gives what CGAL's own range insertion gives.

#define BOOST_TEST_MODULE test_differential_epeck
#include <boost/test/included/unit_test.hpp>

#include "differential.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Filtered_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/insert_points_3.h>

#include <boost/type_index.hpp>

#include <functional>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;

BOOST_AUTO_TEST_CASE(ordinary_surfaces)
{
  tests::check_surfaces_with_named_traits<Triangulation>(tests::ordinary_surfaces(1200));
}

BOOST_AUTO_TEST_CASE(degenerate_surfaces)
{
  tests::check_surfaces_with_named_traits<Triangulation>(tests::degenerate_surfaces(500));
}

BOOST_AUTO_TEST_CASE(tiny_and_flat_surfaces)
{
  tests::check_surfaces_with_named_traits<Triangulation>(tests::tiny_and_flat_surfaces());
}

BOOST_AUTO_TEST_CASE(all_combinations_of_policies)
{
  const tests::Named_surface torus = {"torus", surfaces::genus_surface(1, 200, 0.05)};
  const tests::Named_surface lattice = {"lattice of genus 2", surfaces::lattice_surface(2, 200)};
  tests::check_surfaces_with_all_combinations<Triangulation>({torus, lattice});
  tests::check_surfaces_with_all_combinations<Triangulation>(tests::tiny_and_flat_surfaces());
}

BOOST_AUTO_TEST_CASE(many_seeds_on_cospherical_points)
{
  tests::check_seeds<Triangulation>({"cube", surfaces::lattice_surface(0, 100)}, 20);
  tests::check_seeds<Triangulation>({"integer sphere", surfaces::integer_sphere(100)}, 20);
}

namespace {

struct Target_visitor : CGAL::Default_surface_insertion_visitor_3
{
  std::string reason;
  void notice(CGAL::Surface_insertion_notice what, const std::string& r)
  {
    if (what == CGAL::Surface_insertion_notice::CORE_IS_REPLACED)
      reason = r;
  }
};

// Inserts the points and compares with plain CGAL. Returns why the compact triangulation could not
// serve.
template <class Tr>
std::string check_exact_numbers(const std::vector<typename Tr::Point>& points)
{
  Target_visitor visitor;
  Tr tr;
  CGAL::insert_points_3(tr, points, CGAL::parameters::visitor(std::ref(visitor)));
  BOOST_TEST((tr == Tr(points.begin(), points.end())));
  BOOST_TEST(tr.is_valid());
  return visitor.reason;
}

template <class K>
std::vector<typename K::Point_3> points_on(const surfaces::Indexed_surface& surface)
{
  std::vector<typename K::Point_3> points;
  for (const auto& p : surface.points)
    points.emplace_back(typename K::FT(float(p.x())), typename K::FT(float(p.y())),
                        typename K::FT(float(p.z())));
  return points;
}

template <class K>
void check_served()
{
  BOOST_TEST_CONTEXT(boost::typeindex::type_id<K>().pretty_name())
  {
    using Tr = CGAL::Delaunay_triangulation_3<K>;
    for (const auto& surface : {surfaces::genus_surface(1, 300, 0.05),
                                surfaces::lattice_surface(2, 200), surfaces::integer_sphere(100)})
      BOOST_TEST(check_exact_numbers<Tr>(points_on<K>(surface)) == "");
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(exact_numbers_that_are_doubles_are_served)
{
  check_served<Kernel>();
  check_served<CGAL::Filtered_kernel<CGAL::Simple_cartesian<float>>>();
  check_served<CGAL::Simple_cartesian<CGAL::Exact_rational>>();
}

BOOST_AUTO_TEST_CASE(exact_numbers_that_are_no_doubles_are_not_served)
{
  auto points = points_on<Kernel>(surfaces::genus_surface(1, 300, 0.05));
  // A double that is known as an interval only, until it is computed.
  points[9] = Kernel::Point_3(points[9].x() / 3 * 3, points[9].y(), points[9].z());
  BOOST_TEST(check_exact_numbers<Triangulation>(points) == "");
  points[17] = Kernel::Point_3(points[17].x(), Kernel::FT(1) / 3, points[17].z());
  BOOST_TEST(check_exact_numbers<Triangulation>(points) ==
             "a coordinate of point 17 is not a double");

  Triangulation tr;
  const std::vector<Kernel::Point_3> old(points.begin(), points.begin() + 10);
  tr.insert(old.begin(), old.end());
  const Triangulation before(tr);
  BOOST_CHECK_THROW(CGAL::insert_points_3(tr, points, CGAL::parameters::preserve_order(true)),
                    CGAL::Surface_input_error);
  BOOST_TEST((tr == before));
}
