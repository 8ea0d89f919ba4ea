// A project to begin with: copy this folder. Triangulates random points, and finds the nearest one to a place.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/insert_points_3.h>

#include <iostream>
#include <random>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;

int main()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate;
  std::vector<K::Point_3> points;
  for (int i = 0; i < 10000; ++i)
    points.emplace_back(coordinate(random), coordinate(random), coordinate(random));

  CGAL::Delaunay_triangulation_3<K> tr;
  CGAL::insert_points_3(tr, points); // instead of tr.insert(points.begin(), points.end())

  std::cout << tr.number_of_vertices() << " vertices, " << tr.number_of_finite_cells()
            << " tetrahedra, " << tr.nearest_vertex({.5, .5, .5})->point()
            << " is nearest to the middle\n";
}
