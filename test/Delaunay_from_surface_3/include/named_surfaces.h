// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_NAMED_SURFACES_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_NAMED_SURFACES_H

// The surfaces of the tests: small ones from the generator, and real meshes where they are at hand.

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/adversarial.h>
#include <Delaunay_from_surface_3_surfaces/edit.h>
#include <Delaunay_from_surface_3_surfaces/genus_surface.h>
#include <Delaunay_from_surface_3_surfaces/lattice_surface.h>
#include <Delaunay_from_surface_3_surfaces/parametric.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

namespace tests {

using surfaces::Indexed_surface;

struct Named_surface
{
  std::string name;
  Indexed_surface surface;
};

// Surfaces of about n points that a user may have: any genus, boundary, components.
inline std::vector<Named_surface> ordinary_surfaces(std::size_t n)
{
  std::vector<Named_surface> all;
  for (const std::size_t genus : {0, 1, 2, 3, 5})
    all.push_back(
        {"genus " + std::to_string(genus), surfaces::genus_surface(genus, n, 0.05, genus)});
  all.push_back({"noisy sphere", surfaces::sphere(n, 0.01)});
  all.push_back({"terrain with boundary", surfaces::terrain(n)});
  Indexed_surface holed = surfaces::genus_surface(1, n, 0.1, 7);
  surfaces::puncture(holed, 5, 1);
  surfaces::shuffle(holed, 2);
  all.push_back({"torus with five holes, shuffled", holed});
  all.push_back({"four spheres", surfaces::copies(surfaces::sphere(n / 4, 0.02), 4)});
  return all;
}

// Surfaces of about n points that are in no general position.
inline std::vector<Named_surface> degenerate_surfaces(std::size_t n)
{
  std::vector<Named_surface> all;
  for (const std::size_t genus : {0, 1, 2, 3})
    all.push_back(
        {"lattice of genus " + std::to_string(genus), surfaces::lattice_surface(genus, n)});
  all.push_back({"plate of genus 1", surfaces::plate_surface(1, (std::max)(n, std::size_t(1000)))});
  all.push_back({"thin plate", surfaces::thin_plate(n, 1e-9)});
  all.push_back({"plate of another thickness than its lattice", surfaces::thin_plate(n, 0.3)});
  all.push_back({"sphere in rings", surfaces::sphere(n)});
  all.push_back({"integer points on a sphere", surfaces::integer_sphere(n / 2)});
  all.push_back({"grid torus", surfaces::grid_torus(n)});
  Indexed_surface torn = surfaces::sphere(n / 2, 0.01);
  surfaces::duplicate_points(torn, n / 4, 3);
  all.push_back({"sphere with duplicates", torn});
  Indexed_surface separate = surfaces::lattice_surface(1, n / 6);
  surfaces::separate_faces(separate);
  all.push_back({"lattice of separate faces", separate});
  return all;
}

// Surfaces whose triangulation stays flat, or nearly so.
inline std::vector<Named_surface> tiny_and_flat_surfaces()
{
  std::vector<Named_surface> all;
  for (const std::size_t n : {0, 1, 2, 3})
    all.push_back({std::to_string(n) + " points", surfaces::few_points(n)});
  Indexed_surface same;
  same.points.assign(7, Indexed_surface::Point_3(1, 2, 3));
  same.faces = {{0, 1, 2}, {3, 4, 5}};
  all.push_back({"seven times the same point", same});
  Indexed_surface isolated;
  isolated.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}, {2, 3, 4}};
  all.push_back({"six points in no face", isolated});
  all.push_back({"tetrahedron",
                 {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                  {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}}});
  all.push_back({"collinear", surfaces::collinear(50)});
  Indexed_surface line = surfaces::collinear(40);
  surfaces::duplicate_points(line, 20, 1);
  all.push_back({"collinear with duplicates", line});
  all.push_back({"coplanar", surfaces::coplanar(400)});
  Indexed_surface plane = surfaces::coplanar(100);
  surfaces::duplicate_points(plane, 40, 1);
  plane.points.push_back({0, 0, 5});
  all.push_back({"coplanar with duplicates, and one point above", plane});
  return all;
}

// The path of a real mesh; empty, and said so, where it is not at hand.
inline std::string path_of_mesh(const std::string& name)
{
  const std::string path = std::string(DELAUNAY_FROM_SURFACE_3_DATA_DIR) + "/" + name;
  if (std::ifstream(path))
    return path;
  BOOST_TEST_MESSAGE("skipped: the mesh " << name
                                          << " is not in '" DELAUNAY_FROM_SURFACE_3_DATA_DIR "'");
  return "";
}

} // namespace tests

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_NAMED_SURFACES_H
