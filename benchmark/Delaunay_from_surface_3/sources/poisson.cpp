// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Poisson reconstruction, which needs Eigen.

#include <Delaunay_from_surface_3_sources/Source.h>

#ifdef CGAL_EIGEN3_ENABLED
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/poisson_surface_reconstruction.h>
#include <CGAL/property_map.h>
#endif

#include <utility>

namespace sources {

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

} // namespace sources
