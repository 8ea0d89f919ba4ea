// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The Delaunay triangulation of the vertices of a surface mesh, in one call.

#include <CGAL/insert_surface_vertices_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <string>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<K::Point_3>;
using Triangulation = CGAL::Delaunay_triangulation_3<K>;

int main(int argc, char* argv[])
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("torus.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(file_name, mesh)) {
    std::cerr << "Cannot read " << file_name << '\n';
    return EXIT_FAILURE;
  }

  Triangulation tr;
  try {
    CGAL::insert_surface_vertices_3(tr, mesh);
  } catch (const CGAL::Surface_input_error& error) {
    std::cerr << file_name << ": " << error.what() << '\n';
    return EXIT_FAILURE; // for example, a coordinate is not a number
  }

  std::cout << tr.number_of_vertices() << " vertices, " << tr.number_of_finite_cells()
            << " tetrahedra\n";
  return EXIT_SUCCESS;
}
