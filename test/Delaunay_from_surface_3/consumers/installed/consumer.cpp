// Links with second_unit.cpp, which includes the same headers.
#include "all_headers.h"

#include "second_unit.h"

#include <CGAL/boost/graph/generators.h>

#include <cstdlib>
#include <iostream>

int main()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Kernel::Point_3(0, 0, 0));

  Triangulation from_surface;
  CGAL::insert_surface_vertices_3(from_surface, mesh);

  const Triangulation from_points = triangulation_of_points(mesh);
  if (from_surface.number_of_vertices() != num_vertices(mesh) || !(from_surface == from_points)) {
    std::cerr << "The triangulation of the surface is not that of its points.\n";
    return EXIT_FAILURE;
  }
  std::cout << from_surface.number_of_vertices() << " vertices, equal: yes\n";
  return EXIT_SUCCESS;
}
