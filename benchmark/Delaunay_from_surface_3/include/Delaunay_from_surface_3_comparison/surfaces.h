// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_SURFACES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_SURFACES_H

// The surfaces that are compared on, by name.

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/edit.h>
#include <Delaunay_from_surface_3_surfaces/genus_surface.h>
#include <Delaunay_from_surface_3_surfaces/io.h>
#include <Delaunay_from_surface_3_surfaces/refine.h>
#include <Delaunay_from_surface_3_surfaces/sphere.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace comparison {

using surfaces::Indexed_surface;

struct Named_surface
{
  std::string name;
  std::string description;
  std::size_t least_size; // what the surface needs to be what it is called
  std::function<Indexed_surface(std::size_t n, std::uint64_t seed)> make;
};

// `data_dir` holds bunny00.off and refined_elephant.off.
inline std::vector<Named_surface> named_surfaces(const std::string& data_dir)
{
  const auto mesh = [data_dir](const std::string& file) {
    return surfaces::read_mesh((data_dir.empty() ? "." : data_dir) + "/" + file);
  };
  const double jitter = 0.05;
  return {
      {"bunny", "bunny00.off, densified, jitter 5 % of the edge length", 40000,
       [=](std::size_t n, std::uint64_t seed) {
         return surfaces::densified(mesh("bunny00.off"), n, jitter, seed);
       }},
      {"elephant", "refined_elephant.off, densified, jitter 5 % of the edge length", 50000,
       [=](std::size_t n, std::uint64_t seed) {
         return surfaces::densified(mesh("refined_elephant.off"), n, jitter, seed);
       }},
      {"elephant-shuffled", "the same with vertices and faces in random order", 50000,
       [=](std::size_t n, std::uint64_t seed) {
         Indexed_surface s = surfaces::densified(mesh("refined_elephant.off"), n, jitter, seed);
         surfaces::shuffle(s, seed);
         return s;
       }},
      {"genus-3", "implicit surface of genus 3, no jitter", 2000,
       [](std::size_t n, std::uint64_t seed) { return surfaces::genus_surface(3, n, 0, seed); }},
      {"genus-50", "implicit surface of genus 50, no jitter", 12000,
       [](std::size_t n, std::uint64_t seed) { return surfaces::genus_surface(50, n, 0, seed); }},
      {"sphere", "unit sphere, normal noise of 0.01 along the radius", 100,
       [](std::size_t n, std::uint64_t seed) { return surfaces::sphere(n, 0.01, seed); }},
  };
}

} // namespace comparison

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_SURFACES_H
