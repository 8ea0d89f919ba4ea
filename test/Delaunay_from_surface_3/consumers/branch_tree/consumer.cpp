#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/insert_surface_vertices_3.h>

#include <cstdlib>
#include <iostream>

int main()
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Mesh = CGAL::Polyhedron_3<Kernel>;
  using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;

  Mesh mesh;
  CGAL::make_icosahedron(mesh, Kernel::Point_3(0, 0, 0));

  Triangulation from_surface;
  CGAL::insert_surface_vertices_3(from_surface, mesh);

  const Triangulation from_points(mesh.points_begin(), mesh.points_end());
  if (from_surface.number_of_vertices() != mesh.size_of_vertices() ||
      !(from_surface == from_points)) {
    std::cerr << "The triangulation of the surface is not that of its points.\n";
    return EXIT_FAILURE;
  }
  std::cout << from_surface.number_of_vertices() << " vertices, equal: yes\n";
  return EXIT_SUCCESS;
}
