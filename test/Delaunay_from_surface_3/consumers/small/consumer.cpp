// What a project that uses the package compiles at least: cospherical points, as plain CGAL inserts them.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/delaunay_3_arrays.h>
#include <CGAL/insert_points_3.h>

#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;

int main()
{
  std::vector<K::Point_3> points;
  for (int i = 0; i < 60; ++i)
    points.emplace_back(i % 3, i % 4, i % 5);
  CGAL::Delaunay_triangulation_3<K> tr;
  CGAL::insert_points_3(tr, points);
  const CGAL::Delaunay_triangulation_3<K> plain(points.begin(), points.end());
  const auto arrays = CGAL::delaunay_3_arrays(points);
  return tr.number_of_vertices() == 60 && tr == plain &&
                 arrays.number_of_simplices() == plain.number_of_finite_cells()
             ? 0
             : 1;
}
