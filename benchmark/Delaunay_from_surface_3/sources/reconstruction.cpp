// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces from points: advancing front, scale space, Poisson.

#include <Delaunay_from_surface_3_sources/Source.h>

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Scale_space_surface_reconstruction_3.h>

#ifdef CGAL_EIGEN3_ENABLED
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/poisson_surface_reconstruction.h>
#include <CGAL/property_map.h>
#endif

#include <iterator>
#include <utility>

namespace sources {

namespace {

using Front = CGAL::Advancing_front_surface_reconstruction<>;
using Front_triangulation = Front::Triangulation_3;
using Scale_space = CGAL::Scale_space_surface_reconstruction_3<Kernel>;

Made advancing_front(const Task& task)
{
  Made made;
  made.surface = surfaces::from_mesh(task.model());
  std::vector<std::pair<Kernel::Point_3, std::size_t>> numbered;
  for (const Kernel::Point_3& p : made.surface.points)
    numbered.emplace_back(p, numbered.size());
  Front_triangulation tr(numbered.begin(), numbered.end());
  Front front(tr);
  front.run();
  made.surface.faces.clear();
  CGAL::write_triple_indices(std::back_inserter(made.surface.faces), front);
  made.held = Held{tr.number_of_vertices(), 0};
  return made;
}

// The triangles are of the points as they were moved, the points are those of the input.
Made scale_space(const Task& task)
{
  Made made;
  made.surface.points = surfaces::from_mesh(task.model()).points;
  Scale_space reconstruction(made.surface.points.begin(), made.surface.points.end());
  reconstruction.increase_scale(4);
  reconstruction.reconstruct_surface();
  for (auto f = reconstruction.facets_begin(); f != reconstruction.facets_end(); ++f)
    made.surface.faces.push_back({(*f)[0], (*f)[1], (*f)[2]});
  return made;
}

// Needs Eigen.
#ifdef CGAL_EIGEN3_ENABLED
Made poisson(const Task& task)
{
  using Oriented = std::pair<Kernel::Point_3, Kernel::Vector_3>;
  const Mesh mesh = task.model();
  std::vector<Oriented> points;
  for (const auto v : mesh.vertices())
    points.emplace_back(mesh.point(v),
                        CGAL::Polygon_mesh_processing::compute_vertex_normal(v, mesh));
  Mesh result;
  const double spacing = even_edge_length(mesh, task.points);
  if (!CGAL::poisson_surface_reconstruction_delaunay(
          points.begin(), points.end(), CGAL::First_of_pair_property_map<Oriented>(),
          CGAL::Second_of_pair_property_map<Oriented>(), result, spacing, 25, 0.87))
    throw std::runtime_error("Poisson reconstruction failed");
  return {surfaces::from_mesh(result), std::nullopt};
}
#else
Made poisson(const Task&)
{
  throw Missing("Eigen (Debian: libeigen3-dev) was not found");
}
#endif

} // namespace

std::vector<Source> reconstruction(const Task& task)
{
  return {
      {"advancing front", "points of armadillo", [task] { return advancing_front(task); }},
      {"scale space", "points of armadillo", [task] { return scale_space(task); }},
      {"Poisson", "points of armadillo, with normals", [task] { return poisson(task); }},
  };
}

} // namespace sources
