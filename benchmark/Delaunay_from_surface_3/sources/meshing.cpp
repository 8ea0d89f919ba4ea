// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces by Delaunay refinement: Mesh_3. And wraps, whose triangles are taken from a Delaunay
// triangulation too.

#include <Delaunay_from_surface_3_sources/Source.h>
#include <Delaunay_from_surface_3_surfaces/restricted_delaunay.h>

#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_3.h>
#include <CGAL/alpha_wrap_3.h>
#include <CGAL/make_mesh_3.h>

namespace sources {
namespace {

using Domain = CGAL::Polyhedral_mesh_domain_3<Mesh, Kernel>;
using Meshed = CGAL::Mesh_triangulation_3<Domain>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Meshed>;

Made made_of(const Complex& complex)
{
  Held held;
  held.vertices = complex.triangulation().number_of_vertices();
  for (const auto v : complex.triangulation().finite_vertex_handles())
    held.weighted += complex.triangulation().point(v).weight() != 0;
  return {surfaces::internal::boundary_of_complex(complex), held};
}

// A circle about a triangle of even edges has 1/sqrt(3) of their length as radius; the largest one
// of a surface that is refined is about half as large again.
double facet_size(const Mesh& mesh, const Task& task)
{
  return 0.87 * even_edge_length(mesh, task.points);
}

Made mesh_surface(const Task& task)
{
  namespace parameters = CGAL::parameters;
  const Mesh mesh = task.model();
  const Domain domain(mesh);
  const CGAL::Mesh_criteria_3<Meshed> criteria(parameters::facet_angle = 25,
                                               parameters::facet_size = facet_size(mesh, task));
  return made_of(CGAL::make_mesh_3<Complex>(domain, criteria, parameters::no_perturb(),
                                            parameters::no_exude(), parameters::manifold()));
}

// With Steiner points inside, moved and weighted: what a mesh for finite elements is.
Made mesh_volume(const Task& task)
{
  namespace parameters = CGAL::parameters;
  const Mesh mesh = task.model();
  const Domain domain(mesh);
  const CGAL::Mesh_criteria_3<Meshed> criteria(parameters::facet_angle = 25,
                                               parameters::facet_size = facet_size(mesh, task),
                                               parameters::cell_radius_edge_ratio = 2);
  return made_of(CGAL::make_mesh_3<Complex>(domain, criteria, parameters::perturb(60),
                                            parameters::exude(60), parameters::manifold()));
}

Made wrap(const Task& task)
{
  const Mesh mesh = task.model();
  const double alpha = 1.2 * even_edge_length(mesh, task.points);
  Mesh result;
  CGAL::alpha_wrap_3(mesh, alpha, alpha / 30, result);
  return {surfaces::from_mesh(result), std::nullopt};
}

} // namespace

std::vector<Source> meshing(const Task& task)
{
  return {{"Mesh_3, surface alone", "implicit function, genus 3",
           [task] {
             return Made{surfaces::delaunay_genus_3(task.points), std::nullopt};
           }},
          {"Mesh_3, surface alone", "armadillo", [task] { return mesh_surface(task); }},
          {"Mesh_3, boundary of a volume mesh, optimized", "armadillo",
           [task] { return mesh_volume(task); }},
          {"alpha wrap", "armadillo", [task] { return wrap(task); }}};
}

} // namespace sources
