// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces from files, and from values on a lattice.

#include <Delaunay_from_surface_3_sources/Source.h>
#include <Delaunay_from_surface_3_surfaces/delaunay_marching_cubes.h>
#include <Delaunay_from_surface_3_surfaces/marching_cubes.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <cmath>
#include <fstream>
#include <utility>

namespace sources {

Mesh Task::read(const std::string& file) const
{
  const std::string path = (data_dir.empty() ? "." : data_dir) + "/" + file;
  if (!std::ifstream(path))
    throw Missing(file + " (Debian: libcgal-demo) was not found");
  return surfaces::read_mesh(path);
}

double even_edge_length(const Mesh& mesh, std::size_t n)
{
  // Two triangles for each vertex.
  const double area = CGAL::to_double(CGAL::Polygon_mesh_processing::area(mesh));
  return std::sqrt(area / double(2 * n) * 4 / std::sqrt(3.));
}

namespace {

// As many lattice points on a side as give about `n` vertices.
surfaces::Volume waves(std::size_t n)
{
  return surfaces::random_waves(std::size_t(std::lround(std::sqrt(double(n) / 8.2))), 6, 1);
}

} // namespace

std::vector<Source> scans(const Task& task)
{
  std::vector<Source> sources;
  for (const auto& [kind, file] :
       {std::pair("scan", "armadillo.off"), std::pair("scan", "bunny00.off"),
        std::pair("subdivided model", "refined_elephant.off")})
    sources.push_back({kind, file, [task, name = std::string(file)] {
                         return Made{surfaces::from_mesh(task.read(name)), std::nullopt};
                       }});
  return sources;
}

std::vector<Source> iso_surfaces(const Task& task)
{
  return {
      {"marching cubes", "smooth sum of waves",
       [task] {
         return Made{surfaces::marching_cubes(waves(task.points)), std::nullopt};
       }},
      {"delaunay_marching_cubes()", "smooth sum of waves", [task] {
         return Made{surfaces::delaunay_marching_cubes(waves(task.points)).surface, std::nullopt};
       }}};
}

} // namespace sources
