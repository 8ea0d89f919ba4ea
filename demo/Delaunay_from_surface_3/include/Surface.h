// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_SURFACE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_SURFACE_H

#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/insert_points_3.h>
#include <CGAL/insert_surface_vertices_3.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/tags.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
using Mesh = CGAL::Surface_mesh<Point>;

// The contents of a file. The points are in the order of the file, also as vertices of the mesh.
struct Surface
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> faces;
  Mesh mesh; // the same points and faces again, if they are a manifold
  bool is_manifold = false;
  std::size_t collapsed_triangles = 0; // they were in the file, and are left out
  std::size_t announced_points = 0;    // by the file; there may be fewer
};

// The default traits with many threads.
struct Parallel_traits : CGAL::Surface_insertion_traits_3
{
};

template <class Traits>
using Concurrency_of = std::conditional_t<std::is_same<Traits, Parallel_traits>::value,
                                          CGAL::Parallel_tag, CGAL::Sequential_tag>;

// Inserts the surface by the function of the package that fits it; `np` are its named parameters.
template <class Tr, class Traits, class NamedParameters>
void insert_surface(Tr& tr, const Surface& surface, const Traits& traits, const NamedParameters& np)
{
  using Tag = Concurrency_of<Traits>;
  if (surface.is_manifold)
    CGAL::insert_surface_vertices_3<Tag>(tr, surface.mesh, traits, np);
  else
    CGAL::insert_points_3<Tag>(tr, surface.points, surface.faces, traits, np);
}

// Does the same, watched by `visitor`; returns the vertex of each point.
template <class Tr, class Traits, class Visitor>
std::vector<typename Tr::Vertex_handle> insert_and_watch(Tr& tr, const Surface& surface,
                                                         const Traits& traits, unsigned int seed,
                                                         Visitor& visitor)
{
  std::vector<typename Tr::Vertex_handle> vertices(surface.points.size());
  const auto keep = [&](const auto& pair) { vertices[std::size_t(pair.first)] = pair.second; };
  insert_surface(tr, surface, traits,
                 CGAL::parameters::random_seed(seed)
                     .visitor(std::ref(visitor))
                     .vertex_to_vertex_output_iterator(boost::make_function_output_iterator(keep)));
  return vertices;
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_SURFACE_H
