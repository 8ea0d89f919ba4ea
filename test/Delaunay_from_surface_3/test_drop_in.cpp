// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Delaunay_from_points_3 and Regular_from_points_3 in the place of CGAL's classes: in those of a
// user, and in those of CGAL's algorithms that stand on them.

#define BOOST_TEST_MODULE test_drop_in
#include <boost/test/included/unit_test.hpp>

#include <Delaunay_from_surface_3_surfaces/parametric.h>

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Alpha_shape_3.h>
#include <CGAL/Alpha_shape_cell_base_3.h>
#include <CGAL/Alpha_shape_vertex_base_3.h>
#include <CGAL/Delaunay_from_points_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Fixed_alpha_shape_3.h>
#include <CGAL/Fixed_alpha_shape_cell_base_3.h>
#include <CGAL/Fixed_alpha_shape_vertex_base_3.h>
#include <CGAL/Random.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/insert_weighted_points_3.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
template <class Vb, class Cb>
using Tds = CGAL::Triangulation_data_structure_3<Vb, Cb>;

namespace {

std::vector<Point> points_of_sphere()
{
  return surfaces::sphere(600, 0.05).points;
}

// The facets of a shape by their points.
template <class Shape>
auto facets_of(const Shape& shape)
{
  using Point = typename Shape::Point;
  std::set<std::set<Point>> facets;
  for (auto f = shape.finite_facets_begin(); f != shape.finite_facets_end(); ++f)
    if (shape.classify(*f) == Shape::REGULAR || shape.classify(*f) == Shape::SINGULAR) {
      std::set<Point> corners;
      for (int k = 1; k < 4; ++k)
        corners.insert(f->first->vertex((f->second + k) & 3)->point());
      facets.insert(corners);
    }
  return facets;
}

template <class Plain, class Ours, template <class> class Shape_of>
void check_shapes()
{
  const std::vector<Point> points = points_of_sphere();
  for (const double alpha : {0.001, 0.03, 0.3}) {
    const Shape_of<Plain> plain(points.begin(), points.end(), alpha);
    const Shape_of<Ours> ours(points.begin(), points.end(), alpha);
    BOOST_TEST((facets_of(ours) == facets_of(plain)));
    BOOST_TEST((static_cast<const Plain&>(ours) == static_cast<const Plain&>(plain)));
  }
}

template <class Dt>
using Alpha_shape = CGAL::Alpha_shape_3<Dt>;
template <class Dt>
using Fixed_alpha_shape = CGAL::Fixed_alpha_shape_3<Dt>;

} // namespace

BOOST_AUTO_TEST_CASE(constructors_and_ranges)
{
  using Plain = CGAL::Delaunay_triangulation_3<Kernel>;
  using Ours = CGAL::Delaunay_from_points_3<Kernel>;
  const std::vector<Point> points = points_of_sphere();
  const Plain plain(points.begin(), points.end());
  Ours ours(points.begin(), points.end());
  BOOST_TEST((ours == plain));
  BOOST_TEST((Ours(points.begin(), points.end(), Kernel(), nullptr) == plain));
  BOOST_TEST((Ours(points.data(), points.data() + points.size(), Kernel()) == plain));
  BOOST_TEST(Ours().insert(points.begin(), points.end()) == std::ptrdiff_t(points.size()));

  // One by one, with hints, and into what has vertices already.
  const Point center(0, 0, 0), other(0.1, 0, 0), third(0, 0.1, 0);
  const Ours::Vertex_handle v = ours.insert(center);
  BOOST_TEST((v->point() == center));
  BOOST_TEST((ours.insert(other, v)->point() == other));
  BOOST_TEST((ours.insert(third, v->cell())->point() == third));
  BOOST_TEST((ours.insert({0., 0.1, 0.})->point() == third));
  const std::array<Point, 2> more = {Point(3, 0, 0), center};
  BOOST_TEST(ours.insert(more.begin(), more.end()) == 1);
  Plain expected = plain;
  for (const Point& p : {center, other, third, more[0]})
    expected.insert(p);
  BOOST_TEST((ours == expected));
  ours.remove(v);
  BOOST_TEST(ours.is_valid());

  const Ours copied = ours;
  BOOST_TEST((copied == ours));
  Ours emptied;
  emptied.swap(ours);
  BOOST_TEST(ours.number_of_vertices() == 0u);
  BOOST_TEST((emptied == copied));
}

BOOST_AUTO_TEST_CASE(infos_and_fast_location)
{
  using Vb = CGAL::Triangulation_vertex_base_with_info_3<std::size_t, Kernel>;
  using Cb = CGAL::Delaunay_triangulation_cell_base_3<Kernel>;
  CGAL::Delaunay_from_points_3<Kernel, Tds<Vb, Cb>> tr;
  std::vector<std::pair<Point, std::size_t>> pairs;
  for (const Point& p : points_of_sphere())
    pairs.emplace_back(p, pairs.size());
  BOOST_TEST(tr.insert(pairs.begin(), pairs.end()) == std::ptrdiff_t(pairs.size()));
  for (const auto v : tr.finite_vertex_handles())
    BOOST_TEST((pairs[v->info()].first == v->point()));

  using Hierarchy = CGAL::Delaunay_from_points_3<Kernel, CGAL::Fast_location>;
  const std::vector<Point> points = points_of_sphere();
  const Hierarchy hierarchy(points.begin(), points.end());
  const CGAL::Delaunay_triangulation_3<Kernel, CGAL::Fast_location> plain(points.begin(),
                                                                          points.end());
  BOOST_TEST((hierarchy == plain));
  BOOST_TEST((hierarchy.locate(Point(0, 0, 0)) != Hierarchy::Cell_handle()));
}

BOOST_AUTO_TEST_CASE(alpha_shapes)
{
  using Vertex = CGAL::Alpha_shape_vertex_base_3<Kernel>;
  using Cell = CGAL::Alpha_shape_cell_base_3<Kernel>;
  check_shapes<CGAL::Delaunay_triangulation_3<Kernel, Tds<Vertex, Cell>>,
               CGAL::Delaunay_from_points_3<Kernel, Tds<Vertex, Cell>>, Alpha_shape>();
  using Fixed_vertex = CGAL::Fixed_alpha_shape_vertex_base_3<Kernel>;
  using Fixed_cell = CGAL::Fixed_alpha_shape_cell_base_3<Kernel>;
  check_shapes<CGAL::Delaunay_triangulation_3<Kernel, Tds<Fixed_vertex, Fixed_cell>>,
               CGAL::Delaunay_from_points_3<Kernel, Tds<Fixed_vertex, Fixed_cell>>,
               Fixed_alpha_shape>();
}

template <class T, template <class> class Shape_of>
void check_weighted_shapes()
{
  using Plain = CGAL::Regular_triangulation_3<Kernel, T>;
  using Ours = CGAL::Regular_from_points_3<Kernel, T>;
  CGAL::Random random(2);
  std::vector<Kernel::Weighted_point_3> balls;
  for (const Point& p : points_of_sphere())
    balls.emplace_back(p, random.get_double(0, 0.05));
  for (const double alpha : {-0.01, 0., 0.03}) {
    const Shape_of<Plain> plain(balls.begin(), balls.end(), alpha);
    const Shape_of<Ours> ours(balls.begin(), balls.end(), alpha);
    BOOST_TEST(!facets_of(ours).empty());
    BOOST_TEST((facets_of(ours) == facets_of(plain)));
    BOOST_TEST((static_cast<const Plain&>(ours) == static_cast<const Plain&>(plain)));
    Ours tr(balls.begin(), balls.end());
    BOOST_TEST((facets_of(Shape_of<Ours>(tr, alpha)) == facets_of(plain)));
  }
}

BOOST_AUTO_TEST_CASE(weighted_alpha_shapes)
{
  using Vb = CGAL::Regular_triangulation_vertex_base_3<Kernel>;
  using Cb = CGAL::Regular_triangulation_cell_base_3<Kernel>;
  check_weighted_shapes<
      Tds<CGAL::Alpha_shape_vertex_base_3<Kernel, Vb>, CGAL::Alpha_shape_cell_base_3<Kernel, Cb>>,
      Alpha_shape>();
  check_weighted_shapes<Tds<CGAL::Fixed_alpha_shape_vertex_base_3<Kernel, Vb>,
                            CGAL::Fixed_alpha_shape_cell_base_3<Kernel, Cb>>,
                        Fixed_alpha_shape>();
}

BOOST_AUTO_TEST_CASE(advancing_front)
{
  using Vertex = CGAL::Advancing_front_surface_reconstruction_vertex_base_3<Kernel>;
  using Cell = CGAL::Advancing_front_surface_reconstruction_cell_base_3<Kernel>;
  using Plain = CGAL::Delaunay_triangulation_3<Kernel, Tds<Vertex, Cell>>;
  using Ours = CGAL::Delaunay_from_points_3<Kernel, Tds<Vertex, Cell>>;
  const std::vector<Point> points = points_of_sphere();
  const auto facets = [&](auto& tr) {
    CGAL::Advancing_front_surface_reconstruction<std::decay_t<decltype(tr)>> front(tr);
    front.run();
    std::set<std::set<Point>> result;
    const auto& tds = front.triangulation_data_structure_2();
    for (auto f = tds.faces_begin(); f != tds.faces_end(); ++f)
      if (f->is_on_surface())
        result.insert({f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point()});
    return result;
  };
  Plain plain(points.begin(), points.end());
  Ours ours(points.begin(), points.end());
  const auto expected = facets(plain);
  BOOST_TEST(expected.size() > points.size());
  BOOST_TEST((facets(ours) == expected));
}
