// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_SURFACES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_SURFACES_H

// The surfaces on which the theory is measured, by name.

#include <Delaunay_from_surface_3_surfaces/adversarial.h>
#include <Delaunay_from_surface_3_surfaces/genus_surface.h>
#include <Delaunay_from_surface_3_surfaces/io.h>
#include <Delaunay_from_surface_3_surfaces/random.h>
#include <Delaunay_from_surface_3_surfaces/restricted_delaunay.h>
#include <Delaunay_from_surface_3_surfaces/simplify.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace theory {

struct Theory_surface
{
  std::string name;
  std::string description;
  bool meets_assumptions;   // all triangles Delaunay, and D(S) of linear size as far as can be seen
  std::size_t largest_size; // up to which it is measured
  std::function<surfaces::Indexed_surface(std::size_t n)> make;
  std::size_t least_size = 0;
};

// `data_dir` holds bunny00.off and armadillo.off. What takes Mesh_3 minutes to make is kept in
// `cache_dir`, unless that is empty.
inline std::vector<Theory_surface> theory_surfaces(const std::string& data_dir,
                                                   const std::string& cache_dir, std::uint64_t seed)
{
  using surfaces::Indexed_surface;
  const auto cached = [cache_dir](const std::string& name, Indexed_surface (*make)(std::size_t)) {
    return [=](std::size_t n) {
      const std::string file = cache_dir + "/" + name + "_" + std::to_string(n) + ".ply";
      if (!cache_dir.empty() && std::ifstream(file))
        return surfaces::from_mesh(surfaces::read_mesh(file));
      Indexed_surface surface = make(n);
      if (!cache_dir.empty())
        surfaces::write_surface(surface, file);
      return surface;
    };
  };
  const auto scan = [data_dir, seed](const std::string& file, double (*jitter)(std::size_t)) {
    return [=](std::size_t n) {
      return surfaces::resized(
          surfaces::read_mesh((data_dir.empty() ? "." : data_dir) + "/" + file), n, jitter(n),
          seed);
    };
  };
  const auto same_jitter = [](std::size_t) { return 0.05; };
  // The bend of a surface over an edge goes with the square of the length of the edge.
  const auto jitter_as_bend = [](std::size_t n) { return 0.05 * std::sqrt(16384. / double(n)); };
  const std::size_t any = std::size_t(1) << 30;
  return {
      {"delaunay-sphere", "restricted Delaunay triangulation of the unit sphere", true, any,
       cached("delaunay-sphere", surfaces::delaunay_sphere)},
      {"delaunay-genus-3", "restricted Delaunay triangulation of three joined tori with oval tubes",
       true, any, cached("delaunay-genus-3", surfaces::delaunay_genus_3)},
      {"bunny", "bunny00.off, simplified or densified, then with jitter of 5 % of the edge length",
       false, any, scan("bunny00.off", same_jitter)},
      {"armadillo",
       "armadillo.off, simplified or densified, then with jitter of 5 % of the edge length", false,
       any, scan("armadillo.off", same_jitter)},
      {"bunny-alike",
       "bunny00.off, simplified or densified, then with jitter in proportion to the square of the "
       "edge length, "
       "5 % of the edge length at 16384 points",
       false, any, scan("bunny00.off", jitter_as_bend)},
      {"delaunay-round-genus-3",
       "restricted Delaunay triangulation of three joined tori with round tubes: D(S) is larger",
       false, 131072, cached("delaunay-round-genus-3", surfaces::delaunay_round_genus_3)},
      {"genus-50", "a chain of fifty tori", false, any,
       [seed](std::size_t n) { return surfaces::genus_surface(50, n, 0, seed); }, 12000}};
}

// Those on which the total work is counted, other points for every seed.
inline std::vector<Theory_surface> work_surfaces(std::uint64_t seed)
{
  using surfaces::Indexed_surface;
  const std::size_t any = std::size_t(1) << 30;
  const auto cube = [seed](std::size_t n) {
    surfaces::Random random(seed);
    Indexed_surface points;
    for (std::size_t i = 0; i < n; ++i) {
      const double x = random.uniform(0, 1), y = random.uniform(0, 1);
      points.points.emplace_back(x, y, random.uniform(0, 1));
    }
    return points;
  };
  return {{"cube", "random points in a cube, without a surface", true, any, cube},
          {"torus", "a torus, jitter of 5 % of the edge length", true, any,
           [seed](std::size_t n) { return surfaces::genus_surface(1, n, 0.05, seed); }},
          {"hub", "six walls that bulge inwards, and a point in the middle, in no face", true, any,
           [seed](std::size_t n) { return surfaces::room(n, seed); }},
          {"genus-50", "a chain of fifty tori", false, any,
           [seed](std::size_t n) { return surfaces::genus_surface(50, n, 0, seed); }, 12000}};
}

} // namespace theory

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_SURFACES_H
