// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The medial axis inside a surface, approximated by poles (Amenta, Bern: Surface reconstruction by
// Voronoi filtering, 1999). The pole of a sample is the farthest Voronoi vertex of its cell that
// lies inwards. It is the centre of an inner ball that touches the surface at the sample. The
// medial axis of a solid torus is a circle.

#include <CGAL/insert_surface_vertices_3.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_with_circumcenter_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Timer.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <utility>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_3;
using Vector = K::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex_base = CGAL::Triangulation_vertex_base_with_info_3<Vector, K>; // the normal
using Cell_base = CGAL::Delaunay_triangulation_cell_base_with_circumcenter_3<K>;
using Tds = CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base>;
using Triangulation = CGAL::Delaunay_triangulation_3<K, Tds>;

const double large_radius = 2, small_radius = 0.5;

// A torus of n by n vertices, slightly perturbed so that it is not a grid; and the normals of the
// vertices.
Mesh make_torus(unsigned n, std::vector<Vector>& normals)
{
  Mesh mesh;
  for (unsigned i = 0; i < n; ++i)
    for (unsigned j = 0; j < n; ++j) {
      const double u = 2 * CGAL_PI * (i + 0.3 * std::sin(7. * j)) / n;
      const double v = 2 * CGAL_PI * (j + 0.3 * std::sin(5. * i)) / n;
      const Vector normal(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
      const Point center(large_radius * std::cos(u), large_radius * std::sin(u), 0);
      mesh.add_vertex(center + small_radius * normal);
      normals.push_back(normal);
    }
  const auto at = [&](unsigned i, unsigned j) { return Mesh::Vertex_index(i % n * n + j % n); };
  for (unsigned i = 0; i < n; ++i)
    for (unsigned j = 0; j < n; ++j) {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return mesh;
}

struct Ball
{
  Point center;
  double radius;
};

// For each sample the ball around its inner pole. The cells around a vertex are the Voronoi
// vertices of its cell; those of the convex hull have none.
std::vector<Ball> inner_balls(const Triangulation& tr)
{
  std::vector<Ball> balls;
  std::vector<Triangulation::Cell_handle> cells;
  for (auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v) {
    cells.clear();
    tr.finite_incident_cells(v, std::back_inserter(cells));
    Ball ball = {v->point(), 0};
    for (const auto& c : cells) {
      const Point& voronoi_vertex = c->circumcenter(tr.geom_traits());
      const double radius = std::sqrt(CGAL::squared_distance(v->point(), voronoi_vertex));
      if ((voronoi_vertex - v->point()) * v->info() < 0 && radius > ball.radius)
        ball = {voronoi_vertex, radius};
    }
    balls.push_back(ball);
  }
  return balls;
}

double distance_to_medial_axis(const Point& p)
{
  const double to_axis = std::sqrt(p.x() * p.x() + p.y() * p.y()) - large_radius;
  return std::sqrt(to_axis * to_axis + p.z() * p.z());
}

// Up to the rounding of circumcentres, which depends on where a cell begins.
bool is_same(const std::vector<Ball>& balls, const std::vector<Ball>& others)
{
  const auto sorted_radii = [](const std::vector<Ball>& some) {
    std::vector<double> radii;
    for (const Ball& ball : some)
      radii.push_back(ball.radius);
    std::sort(radii.begin(), radii.end());
    return radii;
  };
  const std::vector<double> a = sorted_radii(balls), b = sorted_radii(others);
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double x, double y) { return std::abs(x - y) < 1e-6; });
}

int main(int argc, char* argv[])
{
  std::vector<Vector> normals;
  const Mesh mesh = make_torus(argc > 1 ? unsigned(std::atoi(argv[1])) : 60, normals);

  CGAL::Timer ours;
  ours.start();
  Triangulation tr;
  CGAL::insert_surface_vertices_3(tr, mesh,
                                  CGAL::Delaunay_from_surface_3::vertex_info_range(normals));
  const std::vector<Ball> balls = inner_balls(tr);
  ours.stop();

  CGAL::Timer plain;
  plain.start();
  std::vector<std::pair<Point, Vector>> with_normals;
  for (const auto v : mesh.vertices())
    with_normals.emplace_back(mesh.point(v), normals[std::size_t(v)]);
  const Triangulation plain_tr(with_normals.begin(), with_normals.end());
  const std::vector<Ball> plain_balls = inner_balls(plain_tr);
  plain.stop();

  double farthest = 0, largest_error = 0;
  for (const Ball& ball : balls) {
    farthest = (std::max)(farthest, distance_to_medial_axis(ball.center));
    largest_error = (std::max)(largest_error, std::abs(ball.radius - small_radius));
  }
  std::cout << balls.size() << " balls in " << ours.time() << " s, plain CGAL: " << plain.time()
            << " s\nfarthest centre from the medial axis: " << farthest
            << ", largest error of a radius: " << largest_error << '\n';
  const bool is_near = farthest < 0.1 && largest_error < 0.1;
  return is_near && is_same(balls, plain_balls) ? EXIT_SUCCESS : EXIT_FAILURE;
}
