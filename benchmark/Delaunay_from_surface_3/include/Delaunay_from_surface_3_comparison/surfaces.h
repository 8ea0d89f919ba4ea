// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_SURFACES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_SURFACES_H

// The surfaces that are compared on, by name. And where walks or a budget can go wrong: smooth surfaces,
// whose triangulations have huge thin cells beside small ones; points of which the first have a
// triangulation of quadratic size; and points alone in boxes that are long or flat.

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/adversarial.h>
#include <Delaunay_from_surface_3_surfaces/clusters.h>
#include <Delaunay_from_surface_3_surfaces/edit.h>
#include <Delaunay_from_surface_3_surfaces/genus_surface.h>
#include <Delaunay_from_surface_3_surfaces/io.h>
#include <Delaunay_from_surface_3_surfaces/lattice_surface.h>
#include <Delaunay_from_surface_3_surfaces/parametric.h>
#include <Delaunay_from_surface_3_surfaces/refine.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace comparison {

using surfaces::Indexed_surface;

struct Named_surface
{
  std::string name;
  std::string description;
  std::size_t least_size; // what the surface needs to be what it is called
  std::function<Indexed_surface(std::size_t n, std::uint64_t seed)> make;
  bool is_file = false; // and of size 0 as it is
};

inline Named_surface densified_mesh(const std::string& name, std::size_t least_size,
                                    const std::string& file)
{
  const auto make = [file](std::size_t n, std::uint64_t seed) {
    const surfaces::Mesh mesh = surfaces::read_mesh(file);
    return n == 0 ? surfaces::from_mesh(mesh) : surfaces::densified(mesh, n, 0.05, seed);
  };
  return {name,
          std::filesystem::path(file).filename().string() +
              ", densified, jitter 5 % of the edge length",
          least_size, make};
}

// A surface of --mesh.
inline Named_surface surface_of_file(const std::string& file)
{
  Named_surface surface = densified_mesh(std::filesystem::path(file).stem().string(),
                                         surfaces::read_mesh(file).number_of_vertices(), file);
  surface.is_file = true;
  return surface;
}

inline Named_surface shuffled(const Named_surface& surface)
{
  const auto make = [make = surface.make](std::size_t n, std::uint64_t seed) {
    Indexed_surface s = make(n, seed);
    surfaces::shuffle(s, seed);
    return s;
  };
  return {surface.name + "-shuffled", surface.description + "; vertices and faces in random order",
          surface.least_size, make, surface.is_file};
}

// `data_dir` holds bunny00.off and refined_elephant.off.
inline std::vector<Named_surface> named_surfaces(const std::string& data_dir)
{
  const std::string folder = (data_dir.empty() ? "." : data_dir) + "/";
  return {
      densified_mesh("bunny", 40000, folder + "bunny00.off"),
      densified_mesh("elephant", 50000, folder + "refined_elephant.off"),
      {"genus-3", "implicit surface of genus 3, no jitter", 2000,
       [](std::size_t n, std::uint64_t seed) { return surfaces::genus_surface(3, n, 0, seed); }},
      {"genus-50", "implicit surface of genus 50, no jitter", 12000,
       [](std::size_t n, std::uint64_t seed) { return surfaces::genus_surface(50, n, 0, seed); }},
      {"sphere", "unit sphere, normal noise of 0.01 along the radius", 100,
       [](std::size_t n, std::uint64_t seed) { return surfaces::sphere(n, 0.01, seed); }},
      {"sphere-exact", "unit sphere without noise: cospherical up to rounding", 100,
       [](std::size_t n, std::uint64_t seed) { return surfaces::sphere(n, 0, seed); }},
      {"plate", "flat plate with five round holes: most points in two planes up to rounding", 4000,
       [](std::size_t n, std::uint64_t seed) { return surfaces::plate_surface(5, n, 0, seed); }},
      {"thin-plate", "two square lattices, a hundredth of their step apart: exactly coplanar", 100,
       [](std::size_t n, std::uint64_t) { return surfaces::thin_plate(n, 0.01); }},
      {"lattice", "box with four square holes on the integer lattice: coplanar and cospherical",
       1000, [](std::size_t n, std::uint64_t) { return surfaces::lattice_surface(4, n); }},
  };
}

// All, with a shuffled twin for each.
inline std::vector<Named_surface> with_twins(std::vector<Named_surface> all)
{
  const std::size_t n = all.size();
  for (std::size_t i = 0; i < n; ++i)
    all.push_back(shuffled(all[i]));
  return all;
}

// measure(family, kind, surface), one after the other, of about n points; the tori of more, what is
// of quadratic size or takes long to find, of fewer.
template <class Measure>
void for_walk_cases(std::size_t n, std::uint64_t seed, const Measure& measure)
{
  for (const std::size_t m : {3 * n / 2, 7 * n / 2}) {
    measure("smooth torus", "from a grid", surfaces::genus_surface(1, m));
    measure("smooth torus", "winding", surfaces::winding_torus(m));
  }
  measure("round tube", "in rings", surfaces::round_tube(n));
  measure("sphere, exactly", "up to rounding, in rings", surfaces::sphere(n));
  measure("sphere, exactly", "integers",
          surfaces::integer_sphere((std::min)(n, std::size_t(20000))));
  measure("two lines", "quadratic", surfaces::two_lines((std::min)(n, std::size_t(3000))));
  measure("stars", "hubs on two lines", surfaces::skew_stars(n, seed));
  for (const auto& [name, a] : {std::pair("1/100", 1e-2), {"1/1000", 1e-3}, {"1/10000", 1e-4}}) {
    const std::string thin = name;
    measure("points alone", "box 1 : " + thin + " : " + thin,
            surfaces::points_in_box(n, 1, a, a, seed));
    measure("points alone", "slab 1 : 1 : " + thin, surfaces::points_in_box(n, 1, 1, a, seed));
  }
}

} // namespace comparison

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_SURFACES_H
