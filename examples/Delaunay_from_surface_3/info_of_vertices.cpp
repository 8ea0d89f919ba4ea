// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Every vertex of the triangulation stores which vertex of the mesh it comes from.

#include <CGAL/insert_surface_vertices_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<K::Point_3>;
using Vertex_base = CGAL::Triangulation_vertex_base_with_info_3<Mesh::Vertex_index, K>;
using Cell_base = CGAL::Delaunay_triangulation_cell_base_3<K>;
using Tds = CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base>;
using Triangulation = CGAL::Delaunay_triangulation_3<K, Tds>;

int main(int argc, char* argv[])
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("torus.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(file_name, mesh)) {
    std::cerr << "Cannot read " << file_name << '\n';
    return EXIT_FAILURE;
  }

  // The info of a vertex is the vertex of the mesh; of several at the same point, the first.
  Triangulation tr;
  try {
    CGAL::insert_surface_vertices_3(tr, mesh,
                                    CGAL::Delaunay_from_surface_3::vertex_info_map(
                                        CGAL::Identity_property_map<Mesh::Vertex_index>()));
  } catch (const CGAL::Surface_input_error& error) {
    std::cerr << file_name << ": " << error.what() << '\n';
    return EXIT_FAILURE;
  }

  // Which edges of the triangulation run along the surface?
  std::size_t on_surface = 0, through_space = 0;
  for (const Triangulation::Edge& e : tr.finite_edges()) {
    const Mesh::Vertex_index u = e.first->vertex(e.second)->info();
    const Mesh::Vertex_index v = e.first->vertex(e.third)->info();
    ++(mesh.halfedge(u, v) != Mesh::null_halfedge() ? on_surface : through_space);
  }
  std::cout << on_surface << " edges on the surface, " << through_space << " through space\n";
  return EXIT_SUCCESS;
}
