// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Generated surfaces: every traits class gives what CGAL's own range insertion gives.

#define BOOST_TEST_MODULE test_differential_epeck
#include <boost/test/included/unit_test.hpp>

#include "differential.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

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
