// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What each kind of user gains, from the points to the end of what they do with the triangulation:
// plain CGAL and this package in turn. Writes JSON.

#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_comparison/run_program.h>
#include <Delaunay_from_surface_3_comparison/surfaces.h>
#include <Delaunay_from_surface_3_surfaces/genus_surface.h>
#include <Delaunay_from_surface_3_surfaces/parametric.h>

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Alpha_shape_3.h>
#include <CGAL/Alpha_shape_cell_base_3.h>
#include <CGAL/Alpha_shape_vertex_base_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_with_circumcenter_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Filtered_kernel.h>
#include <CGAL/Fixed_alpha_shape_3.h>
#include <CGAL/Fixed_alpha_shape_cell_base_3.h>
#include <CGAL/Fixed_alpha_shape_vertex_base_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/delaunay_3_arrays.h>
#include <CGAL/insert_points_3.h>
#include <CGAL/insert_surface_vertices_3.h>
#include <CGAL/version.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace {

using comparison::Gains;
using surfaces::Indexed_surface;

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_3;
using Numbered = std::vector<std::pair<Point, std::size_t>>;
template <class Vb, class Cb = CGAL::Delaunay_triangulation_cell_base_3<K>>
using Triangulation_of =
    CGAL::Delaunay_triangulation_3<K, CGAL::Triangulation_data_structure_3<Vb, Cb>>;
using Triangulation = CGAL::Delaunay_triangulation_3<K>;
using With_levels = CGAL::Delaunay_triangulation_3<K, CGAL::Fast_location>;
using With_info = Triangulation_of<CGAL::Triangulation_vertex_base_with_info_3<std::size_t, K>>;
using With_circumcenters =
    Triangulation_of<CGAL::Triangulation_vertex_base_3<K>,
                     CGAL::Delaunay_triangulation_cell_base_with_circumcenter_3<K>>;
using For_front = Triangulation_of<CGAL::Advancing_front_surface_reconstruction_vertex_base_3<K>,
                                   CGAL::Advancing_front_surface_reconstruction_cell_base_3<K>>;
using For_fixed_alpha = Triangulation_of<CGAL::Fixed_alpha_shape_vertex_base_3<K>,
                                         CGAL::Fixed_alpha_shape_cell_base_3<K>>;
using For_alpha =
    Triangulation_of<CGAL::Alpha_shape_vertex_base_3<K>, CGAL::Alpha_shape_cell_base_3<K>>;
using Mesh = CGAL::Surface_mesh<Point>;

Numbered with_numbers(const std::vector<Point>& points)
{
  Numbered numbered;
  for (const Point& p : points)
    numbered.emplace_back(p, numbered.size());
  return numbered;
}

template <class Tr>
std::size_t cells(const Tr& tr)
{
  return tr.number_of_cells();
}

template <class Tr, class Input>
Tr by_package(const Input& input)
{
  Tr tr;
  CGAL::insert_points_3(tr, input);
  return tr;
}

template <class Tr>
void measure_points(Gains& table, const std::string& consumer,
                    const std::vector<typename Tr::Point>& points)
{
  table.line(
      consumer, points.size(), [&] { return cells(Tr(points.begin(), points.end())); },
      [&] { return cells(by_package<Tr>(points)); });
}

template <class Kernel>
void measure_kernel(Gains& table, const std::string& consumer, const std::vector<Point>& points)
{
  using FT = typename Kernel::FT;
  std::vector<typename Kernel::Point_3> converted;
  for (const Point& p : points)
    converted.emplace_back(FT(float(p.x())), FT(float(p.y())), FT(float(p.z())));
  measure_points<CGAL::Delaunay_triangulation_3<Kernel>>(table, consumer, converted);
}

void measure_input(Gains& table, const Indexed_surface& surface)
{
  const std::vector<Point>& points = surface.points;
  const std::size_t n = points.size();
  const auto plain = [&] { return cells(Triangulation(points.begin(), points.end())); };
  const Mesh mesh = surfaces::to_mesh<Mesh>(surface);
  table.line("surface: mesh", n, plain, [&] {
    Triangulation tr;
    CGAL::insert_surface_vertices_3(tr, mesh);
    return cells(tr);
  });
  table.line("surface: soup", n, plain, [&] {
    Triangulation tr;
    CGAL::insert_points_3(tr, points, surface.faces);
    return cells(tr);
  });
  table.line("surface: points alone, in the order of the input", n, plain, [&] {
    Triangulation tr;
    CGAL::insert_points_3(tr, points, CGAL::parameters::preserve_order(true));
    return cells(tr);
  });
  const Numbered numbered = with_numbers(points);
  table.line(
      "surface: pairs of points and infos", n,
      [&] { return cells(With_info(numbered.begin(), numbered.end())); },
      [&] { return cells(by_package<With_info>(numbered)); });
}

// Plain CGAL: a triangulation whose vertices know their index, and a loop over its cells.
void measure_arrays(Gains& table, const Indexed_surface& surface)
{
  const std::vector<Point>& points = surface.points;
  const Numbered numbered = with_numbers(points);
  const auto plain = [&] {
    const With_info tr(numbered.begin(), numbered.end());
    std::vector<std::array<std::int32_t, 4>> tetrahedra;
    for (const auto c : tr.finite_cell_handles())
      tetrahedra.push_back({std::int32_t(c->vertex(0)->info()), std::int32_t(c->vertex(1)->info()),
                            std::int32_t(c->vertex(2)->info()),
                            std::int32_t(c->vertex(3)->info())});
    return tetrahedra.size();
  };
  table.line("surface: index arrays, points alone", points.size(), plain,
             [&] { return CGAL::delaunay_3_arrays(points).number_of_simplices(); });
  table.line("surface: index arrays, soup", points.size(), plain,
             [&] { return CGAL::delaunay_3_arrays(points, surface.faces).number_of_simplices(); });
}

template <class Tr, class Shape>
void measure_alpha_shape(Gains& table, const std::string& consumer,
                         const std::vector<Point>& points, double alpha)
{
  const auto interior = [](const Shape& shape) {
    std::vector<typename Shape::Cell_handle> inside;
    shape.get_alpha_shape_cells(std::back_inserter(inside), Shape::INTERIOR);
    return inside.size();
  };
  table.line(
      consumer, points.size(), [&] { return interior(Shape(points.begin(), points.end(), alpha)); },
      [&] {
        Tr tr = by_package<Tr>(points);
        return interior(Shape(tr, alpha));
      });
}

std::size_t voronoi_vertices(const With_circumcenters& tr)
{
  std::size_t inside = 0;
  for (auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c)
    inside += CGAL::to_double(c->circumcenter(tr.geom_traits()).x()) < 1e6;
  return inside;
}

#if CGAL_VERSION_NR >= 1060000000 // from 6.0 on its class compiles with numbers of type float
// What COLMAP (src/colmap/mvs/advancing_front_meshing.cc) makes of a block of points that no ray filters.
void measure_front_of_colmap(Gains& table, const std::vector<Point>& points)
{
  using Kernel = CGAL::Filtered_kernel<CGAL::Simple_cartesian<float>>;
  using Tds = CGAL::Triangulation_data_structure_3<
      CGAL::Advancing_front_surface_reconstruction_vertex_base_3<Kernel>,
      CGAL::Advancing_front_surface_reconstruction_cell_base_3<Kernel>>;
  using Tr = CGAL::Delaunay_triangulation_3<Kernel, Tds, CGAL::Fast_location>;
  std::vector<std::pair<Kernel::Point_3, std::size_t>> numbered;
  for (const Point& p : points)
    numbered.emplace_back(Kernel::Point_3(float(p.x()), float(p.y()), float(p.z())),
                          numbered.size());
  const auto facets_of = [](Tr& tr) {
    CGAL::Advancing_front_surface_reconstruction<Tr> front(tr);
    front.run();
    std::vector<std::array<std::size_t, 3>> facets;
    CGAL::write_triple_indices(std::back_inserter(facets), front);
    return facets.size();
  };
  table.line(
      "advancing front of COLMAP", points.size(),
      [&] {
        Tr tr(numbered.begin(), numbered.end());
        return facets_of(tr);
      },
      [&] {
        Tr tr = by_package<Tr>(numbered);
        return facets_of(tr);
      });
}
#else
void measure_front_of_colmap(Gains&, const std::vector<Point>&) {}
#endif

void measure_on_top(Gains& table, const std::vector<Point>& points, double alpha)
{
  const std::size_t n = points.size();
  using Facets = std::vector<std::array<std::size_t, 3>>;
  table.line(
      "advancing front", n,
      [&] {
        Facets facets;
        CGAL::advancing_front_surface_reconstruction(points.begin(), points.end(),
                                                     std::back_inserter(facets));
        return facets.size();
      },
      [&] {
        For_front tr = by_package<For_front>(with_numbers(points));
        CGAL::Advancing_front_surface_reconstruction<For_front> front(tr);
        front.run();
        Facets facets;
        CGAL::write_triple_indices(std::back_inserter(facets), front);
        return facets.size();
      });
  measure_alpha_shape<For_fixed_alpha, CGAL::Fixed_alpha_shape_3<For_fixed_alpha>>(
      table, "alpha shape, one alpha", points, alpha);
  measure_alpha_shape<For_alpha, CGAL::Alpha_shape_3<For_alpha>>(table, "alpha shapes, all alphas",
                                                                 points, alpha);
  table.line(
      "Voronoi vertices", n,
      [&] { return voronoi_vertices(With_circumcenters(points.begin(), points.end())); },
      [&] { return voronoi_vertices(by_package<With_circumcenters>(points)); });
}

void measure(std::size_t n, Gains& table)
{
  const Indexed_surface surface = surfaces::genus_surface(3, n, 0.05, 2024);
  measure_points<Triangulation>(table, "points in a cube",
                                surfaces::points_in_box(n, 1, 1, 1, 2024).points);
  measure_points<Triangulation>(table, "points on a height field", surfaces::terrain(n).points);
  measure_points<Triangulation>(table, "surface: points alone", surface.points);
  measure_input(table, surface);
  measure_arrays(table, surface);
  measure_points<With_levels>(table, "surface: points alone, Fast_location", surface.points);
  measure_kernel<CGAL::Exact_predicates_exact_constructions_kernel>(
      table, "surface: points alone, exact constructions", surface.points);
  measure_kernel<CGAL::Filtered_kernel<CGAL::Simple_cartesian<float>>>(
      table, "surface: points alone, numbers of type float", surface.points);
  const double alpha = 40. / double(n); // the square of a few edges' length
  measure_on_top(table, surface.points, alpha);
  measure_front_of_colmap(table, surface.points);
}

} // namespace

int main(int argc, char** argv)
{
  comparison::Program program("measure_consumers", "Measures what each kind of user gains.");
  return comparison::run_gains(program, argc, argv, measure);
}
