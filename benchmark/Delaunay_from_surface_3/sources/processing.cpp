// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces from files, from values on a lattice, from other surfaces, and from balls.

#include <Delaunay_from_surface_3_sources/Source.h>
#include <Delaunay_from_surface_3_surfaces/delaunay_marching_cubes.h>
#include <Delaunay_from_surface_3_surfaces/marching_cubes.h>
#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/refine.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Skin_surface_3.h>
#include <CGAL/make_skin_surface_mesh_3.h>

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

Made remeshed(const Task& task)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  Mesh mesh = task.model();
  PMP::isotropic_remeshing(mesh.faces(), even_edge_length(mesh, task.points), mesh,
                           CGAL::parameters::number_of_iterations(5));
  mesh.collect_garbage();
  return {surfaces::from_mesh(mesh), std::nullopt};
}

// Until one more round would make it too large.
Made subdivided(const Task& task)
{
  Mesh mesh = task.read("elephant.off");
  while (4 * mesh.number_of_vertices() < 2 * task.points)
    surfaces::internal::loop_rounds(mesh, 1);
  return {surfaces::from_mesh(mesh), std::nullopt};
}

// Balls of about one size in a ball, each near another: a molecule.
std::vector<Kernel::Weighted_point_3> molecule(std::size_t n)
{
  surfaces::Random random(2024);
  std::vector<Kernel::Weighted_point_3> balls = {{Kernel::Point_3(0, 0, 0), 1}};
  while (balls.size() < n) {
    const Kernel::Point_3& near = balls[random.below(balls.size())].point();
    const Kernel::Point_3 p = near + 1.6 * random.in_ball();
    const double radius = random.uniform(0.8, 1.2);
    if (CGAL::squared_distance(near, p) > 1)
      balls.emplace_back(p, radius * radius);
  }
  return balls;
}

Made skin(const Task& task)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  const std::vector<Kernel::Weighted_point_3> balls = molecule(task.points / 40);
  Polyhedron surface;
  CGAL::make_skin_surface_mesh_3(surface, balls.begin(), balls.end(), 0.5, 0);
  return {surfaces::from_mesh(surface), std::nullopt};
}

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

std::vector<Source> processing(const Task& task)
{
  return {
      {"skin surface", "balls, placed as the atoms of a molecule", [task] { return skin(task); }},
      {"isotropic remeshing", "armadillo", [task] { return remeshed(task); }},
      {"Loop subdivision", "elephant.off", [task] { return subdivided(task); }}};
}

} // namespace sources
