// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Real meshes and large surfaces: every traits class gives what CGAL's own range insertion gives.

#define BOOST_TEST_MODULE test_real_meshes
#include <boost/test/included/unit_test.hpp>

#include "differential.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tracing_traits_3.h>
#include <CGAL/insert_surface_vertices_3.h>

#include <string>
#include <vector>

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Inexact_triangulation = CGAL::Delaunay_triangulation_3<Epick>;
using Exact_triangulation = CGAL::Delaunay_triangulation_3<Epeck>;
using Mesh = CGAL::Surface_mesh<Epick::Point_3>;

namespace {

// Scans, sculptures, parts with planes, several components, boundaries.
const std::vector<std::string> names = {"bunny00.off",    "elephant.off", "fandisk.off",
                                        "blobby_3cc.off", "cheese.off",   "mesh_with_border.off",
                                        "anchor.off",     "armadillo.off"};

template <class Triangulation, class Traits>
void check_mesh(const Mesh& mesh, const Triangulation& plain)
{
  BOOST_TEST_CONTEXT(boost::typeindex::type_id<Traits>().pretty_name())
  {
    Triangulation tr;
    CGAL::insert_surface_vertices_3(tr, mesh, Traits());
    BOOST_TEST((tr == plain));
    BOOST_TEST(tr.is_valid());
  }
}

template <class Triangulation>
void check_real_mesh(const std::string& name, std::size_t most_vertices)
{
  const std::string path = tests::path_of_mesh(name);
  if (path.empty())
    return;
  Mesh mesh;
  BOOST_TEST_REQUIRE(CGAL::IO::read_OFF(path, mesh));
  if (mesh.number_of_vertices() > most_vertices)
    return;
  BOOST_TEST_MESSAGE(name << ": " << mesh.number_of_vertices() << " vertices");
  const auto points = tests::points_of<Triangulation>(
      {std::vector<Epick::Point_3>(mesh.points().begin(), mesh.points().end()), {}});
  const Triangulation plain(points.begin(), points.end());
  check_mesh<Triangulation, CGAL::Surface_insertion_traits_3>(mesh, plain);
  check_mesh<Triangulation, CGAL::Tracing_traits_3>(mesh, plain);
  check_mesh<Triangulation, CGAL::Plain_insertion_traits_3>(mesh, plain);
}

} // namespace

BOOST_AUTO_TEST_CASE(real_meshes_with_inexact_constructions)
{
  for (const std::string& name : names)
    check_real_mesh<Inexact_triangulation>(name, 50000);
}

BOOST_AUTO_TEST_CASE(real_meshes_with_exact_constructions)
{
  for (const std::string& name : names)
    check_real_mesh<Exact_triangulation>(name, 11000);
}

BOOST_AUTO_TEST_CASE(large_surface)
{
  tests::check_surfaces_with_named_traits<Inexact_triangulation>(
      {{"torus", surfaces::genus_surface(1, 300000, 0.05)}});
}

BOOST_AUTO_TEST_CASE(large_lattice)
{
  tests::check_surfaces_with_named_traits<Inexact_triangulation>(
      {{"lattice of genus 4", surfaces::lattice_surface(4, 30000)}});
}
