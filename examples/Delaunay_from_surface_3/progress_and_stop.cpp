// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A visitor that follows the work and stops it before it is complete.

#include <CGAL/insert_surface_vertices_3.h>

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<K::Point_3>;
using Triangulation = CGAL::Delaunay_triangulation_3<K>;

// The base class does nothing; only the functions of interest are redefined.
struct My_visitor : CGAL::Default_surface_insertion_visitor_3
{
  std::size_t inserted = 0, limit = 0;

  void phase_begins(CGAL::Surface_insertion_phase phase, std::size_t number)
  {
    if (phase == CGAL::Surface_insertion_phase::ROUND)
      std::cout << "a round of " << number << " points\n";
  }

  // Called in each round, every 256 points. A real program would check a clock or a button here.
  bool go_further(std::size_t so_far)
  {
    inserted = so_far;
    return inserted < limit;
  }
};

int main(int argc, char* argv[])
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("torus.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(file_name, mesh)) {
    std::cerr << "Cannot read " << file_name << '\n';
    return EXIT_FAILURE;
  }
  Triangulation tr;

  // Visitors are copied. With std::ref() this one is used, and can be queried afterwards.
  My_visitor visitor;
  visitor.limit = mesh.number_of_vertices() / 8;
  try {
    CGAL::insert_surface_vertices_3(tr, mesh, CGAL::parameters::visitor(std::ref(visitor)));
  } catch (const CGAL::Surface_input_error& error) {
    std::cerr << file_name << ": " << error.what() << '\n';
    return EXIT_FAILURE;
  }

  // A triangulation that was empty is empty again after a stop.
  std::cout << "stopped after " << visitor.inserted << " points; the triangulation has "
            << tr.number_of_vertices() << " vertices\n";
  return EXIT_SUCCESS;
}
