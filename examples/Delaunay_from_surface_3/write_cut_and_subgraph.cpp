// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes a surface with its cut graph and its subgraph of bounded degree to one file in VTK's text
// format, which ParaView reads. The file has triangles and lines, each with a number `part` to
// colour by: 0 for the surface, 1 for the subgraph, 2 for the cut graph.

#include <CGAL/bounded_degree_spanning_subgraph.h>
#include <CGAL/surface_of.h>
#include <CGAL/Delaunay_from_surface_3/surface/cut_graph.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <system_error>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<K::Point_3>;
using Edges = std::vector<Mesh::Edge_index>;

void write_edges(std::ostream& out, const Mesh& mesh, const Edges& edges)
{
  for (auto e : edges)
    out << "2 " << std::size_t(mesh.vertex(e, 0)) << ' ' << std::size_t(mesh.vertex(e, 1)) << '\n';
}

void write_parts(std::ostream& out, int part, std::size_t number)
{
  for (std::size_t i = 0; i < number; ++i)
    out << part << '\n';
}

bool write_vtk(const std::string& file_name, const Mesh& mesh, const Edges& subgraph,
               const Edges& cut)
{
  std::ofstream out(file_name);
  out.precision(17);
  out << "# vtk DataFile Version 3.0\ncut graph and subgraph\nASCII\nDATASET POLYDATA\nPOINTS "
      << mesh.number_of_vertices() << " double\n";
  for (auto v : mesh.vertices())
    out << mesh.point(v) << '\n';

  // VTK wants the lines before the triangles.
  const std::size_t lines = subgraph.size() + cut.size(), faces = mesh.number_of_faces();
  out << "LINES " << lines << ' ' << 3 * lines << '\n';
  write_edges(out, mesh, subgraph);
  write_edges(out, mesh, cut);
  out << "POLYGONS " << faces << ' ' << 4 * faces << '\n';
  for (auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    out << "3 " << std::size_t(mesh.source(h)) << ' ' << std::size_t(mesh.target(h)) << ' '
        << std::size_t(mesh.target(mesh.next(h))) << '\n';
  }
  out << "CELL_DATA " << lines + faces << "\nSCALARS part int\nLOOKUP_TABLE default\n";
  write_parts(out, 1, subgraph.size());
  write_parts(out, 2, cut.size());
  write_parts(out, 0, faces);
  return bool(out.flush());
}

int main(int argc, char** argv)
{
  const std::string surface = argc > 1 ? argv[1] : CGAL::data_file_path("torus.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(surface, mesh)) {
    std::cerr << "Cannot read " << surface << '\n';
    return EXIT_FAILURE;
  }

  Edges cut, subgraph;
  try {
    const auto triangles = CGAL::surface_of(mesh);
    CGAL::Delaunay_from_surface_3::cut_graph(triangles, std::back_inserter(cut));
    CGAL::bounded_degree_spanning_subgraph(triangles, std::back_inserter(subgraph));
  } catch (const CGAL::Surface_input_error& error) {
    std::cerr << surface << ": " << error.what() << '\n';
    return EXIT_FAILURE; // for example, a face is not a triangle
  }

  const std::string file_name = argc > 2 ? argv[2] : "cut_and_subgraph.vtk";
  std::error_code is_not_there;
  if (std::filesystem::equivalent(surface, file_name, is_not_there)) {
    std::cerr << file_name << " is the surface, and would be overwritten\n";
    return EXIT_FAILURE;
  }
  if (!write_vtk(file_name, mesh, subgraph, cut)) {
    std::cerr << "Cannot write " << file_name << '\n';
    return EXIT_FAILURE;
  }
  std::cout << file_name << ": " << cut.size() << " edges of the cut, " << subgraph.size()
            << " of the subgraph\n";
  return EXIT_SUCCESS;
}
