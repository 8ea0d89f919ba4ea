// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Finds the tetrahedra inside a closed surface. If the triangulation contains all triangles of the
// surface, as it does for dense samples, these tetrahedra fill the surface. Otherwise the centroids
// decide, and the volumes differ. For a surface with gaps use inside_of_surface_3(), which computes
// winding numbers.

#include <CGAL/insert_surface_vertices_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Timer.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<K::Point_3>;
using Triangulation = CGAL::Delaunay_triangulation_3<K>;

struct Inside
{
  std::size_t tetrahedra = 0;
  double volume = 0;
};

Inside inside(const Triangulation& tr, const Mesh& mesh)
{
  const CGAL::Side_of_triangle_mesh<Mesh, K> side_of(mesh);
  Inside result;
  for (auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c) {
    const K::Tetrahedron_3 tetrahedron = tr.tetrahedron(c);
    if (side_of(CGAL::centroid(tetrahedron)) == CGAL::ON_BOUNDED_SIDE) {
      ++result.tetrahedra;
      result.volume += tetrahedron.volume();
    }
  }
  return result;
}

int main(int argc, char* argv[])
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("torus.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(file_name, mesh)) {
    std::cerr << "Cannot read " << file_name << '\n';
    return EXIT_FAILURE;
  }
  if (!CGAL::is_triangle_mesh(mesh) || !CGAL::is_closed(mesh)) {
    std::cerr << file_name << " is no closed surface of triangles: it has no inside\n";
    return EXIT_FAILURE;
  }

  CGAL::Timer ours;
  ours.start();
  Triangulation tr;
  try {
    CGAL::insert_surface_vertices_3(tr, mesh);
  } catch (const CGAL::Surface_input_error& error) {
    std::cerr << file_name << ": " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  const Inside found = inside(tr, mesh);
  ours.stop();

  CGAL::Timer plain;
  plain.start();
  const Triangulation plain_tr(mesh.points().begin(), mesh.points().end());
  const Inside plain_found = inside(plain_tr, mesh);
  plain.stop();

  const double volume = std::abs(CGAL::Polygon_mesh_processing::volume(mesh));
  std::cout << found.tetrahedra << " tetrahedra inside in " << ours.time()
            << " s, plain CGAL: " << plain.time() << " s; their volume is "
            << 100 * found.volume / volume << " % of the surface's\n";
  return found.tetrahedra == plain_found.tetrahedra ? EXIT_SUCCESS : EXIT_FAILURE;
}
