// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Winding numbers: against exact solid angles, against sums without a hierarchy, and by the volumes
// of what they call inside, on surfaces that are closed, hurt, nested, and none at all.

#define BOOST_TEST_MODULE test_inside
#include <boost/test/included/unit_test.hpp>

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/inside/Regions.h>
#include <CGAL/Delaunay_from_surface_3/inside/Winding_field.h>
#include <CGAL/Random.h>
#include <CGAL/Winding_number_3.h>
#include <CGAL/delaunay_3_arrays.h>
#include <CGAL/inside_of_surface_3.h>
#include <CGAL/regular_3_arrays.h>

#include <Delaunay_from_surface_3_surfaces/edit.h>
#include <Delaunay_from_surface_3_surfaces/genus_surface.h>
#include <Delaunay_from_surface_3_surfaces/parametric.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace {

namespace internal = CGAL::Delaunay_from_surface_3::internal;
using Coordinates = std::array<double, 3>;
using Face = std::array<std::size_t, 3>;
const double pi = std::acos(-1.);

struct Soup
{
  std::vector<Coordinates> points;
  std::vector<Face> faces;

  std::size_t add_point(double x, double y, double z)
  {
    points.push_back({x, y, z});
    return points.size() - 1;
  }
};

Soup soup_of(const surfaces::Indexed_surface& surface)
{
  Soup soup;
  for (const auto& p : surface.points)
    soup.add_point(p.x(), p.y(), p.z());
  soup.faces = surface.faces;
  return soup;
}

// A box whose sides are n × n squares: all its triangles are Delaunay, whatever is around.
Soup box(std::size_t n, double size = 1, double x = 0)
{
  Soup soup;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool is_far : {false, true}) {
      const std::size_t first = soup.points.size();
      for (std::size_t i = 0; i <= n; ++i)
        for (std::size_t j = 0; j <= n; ++j) {
          Coordinates p;
          p[axis] = is_far ? size : 0;
          p[(axis + 1) % 3] = size * double(i) / double(n);
          p[(axis + 2) % 3] = size * double(j) / double(n);
          for (double& c : p)
            c += x;
          soup.points.push_back(p);
        }
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
          const std::size_t a = first + (n + 1) * i + j, b = a + n + 1;
          for (const Face& face : {Face{a, b, b + 1}, Face{a, b + 1, a + 1}})
            soup.faces.push_back(is_far ? face : Face{face[0], face[2], face[1]});
        }
    }
  return soup;
}

// Two cones with a wavy rim in common: few of their long triangles are Delaunay.
Soup cones(std::size_t n)
{
  Soup soup;
  soup.points = {{0, 0, 2}, {0, 0, -1}};
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 2 * pi * double(i) / double(n);
    soup.add_point(std::cos(t), std::sin(t), .3 * std::sin(7 * t));
    const std::size_t a = 2 + i, b = 2 + (i + 1) % n;
    soup.faces.push_back({0, a, b});
    soup.faces.push_back({1, b, a});
  }
  return soup;
}

// Their points are numbered one after the other.
Soup both(Soup first, const Soup& second)
{
  const std::size_t n = first.points.size();
  first.points.insert(first.points.end(), second.points.begin(), second.points.end());
  for (const Face& face : second.faces)
    first.faces.push_back({face[0] + n, face[1] + n, face[2] + n});
  return first;
}

Soup turned(Soup soup)
{
  for (Face& face : soup.faces)
    std::swap(face[1], face[2]);
  return soup;
}

double volume_of(const std::array<Coordinates, 4>& p)
{
  using internal::minus;
  return internal::dot(minus(p[1], p[0]), internal::cross(minus(p[2], p[0]), minus(p[3], p[0]))) /
         6;
}

// Six times the volume of the tetrahedron of a face and the origin, over all faces: that of what is
// inside.
double volume_of(const Soup& soup)
{
  double sum = 0;
  for (const Face& f : soup.faces)
    sum += internal::dot(soup.points[f[0]], internal::cross(soup.points[f[1]], soup.points[f[2]]));
  return sum / 6;
}

struct Found
{
  CGAL::Inside_3 inside;
  double volume = 0;
};

// With two points far away, between which there is much that is outside.
Found find(Soup soup, double far = 5)
{
  soup.add_point(far, far, far);
  soup.add_point(-far, -far, far);
  const auto arrays = CGAL::delaunay_3_arrays(soup.points);
  Found found = {CGAL::inside_of_surface_3(soup.points, soup.faces, arrays)};
  for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c)
    if (found.inside[c]) {
      const auto v = arrays.vertices(c);
      const auto at = [&](std::size_t k) { return soup.points[std::size_t(v[k])]; };
      found.volume += volume_of({at(0), at(1), at(2), at(3)});
    }
  return found;
}

void check_that_there_is_none(const Soup& soup, const std::string& message)
{
  BOOST_CHECK_EXCEPTION(find(soup), CGAL::Surface_input_error, [&](const auto& error) {
    return std::string(error.what()).find(message) != std::string::npos;
  });
}

BOOST_AUTO_TEST_CASE(test_exact_solid_angles)
{
  // A corner of a cube, the sides of a cube from its middle, a face of a regular tetrahedron.
  const Coordinates zero = {0, 0, 0};
  const Coordinates axes[] = {{2, 0, 0}, {0, 3, 0}, {0, 0, 5}};
  BOOST_CHECK_SMALL(internal::half_solid_angle(axes, zero) - pi / 4, 1e-15);
  const Coordinates side[] = {{1, 1, 1}, {-1, 1, 1}, {-1, -1, 1}}; // half of one
  BOOST_CHECK_SMALL(internal::half_solid_angle(side, zero) - pi / 6, 1e-15);
  const Coordinates face[] = {{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}};
  BOOST_CHECK_SMALL(std::abs(internal::half_solid_angle(face, zero)) - pi / 2, 1e-15);
  const Coordinates turned[] = {axes[0], axes[2], axes[1]};
  BOOST_CHECK_SMALL(internal::half_solid_angle(turned, zero) + pi / 4, 1e-15);
  // A rectangle above its corner at height h: Ω = atan(a b / (h sqrt(a² + b² + h²))).
  for (const double h : {1e-3, .1, 1., 7., 40., 1e4}) {
    const Coordinates first[] = {{0, 0, h}, {2, 0, h}, {2, 3, h}},
                      second[] = {{0, 0, h}, {2, 3, h}, {0, 3, h}};
    const double angle =
        2 * (internal::half_solid_angle(first, zero) + internal::half_solid_angle(second, zero));
    BOOST_CHECK_CLOSE(angle, std::atan(6 / (h * std::sqrt(13 + h * h))), 1e-9);
  }
  // In the plane of the triangle beside it, on it, at a corner.
  const Coordinates flat[] = {{1, 0, 0}, {0, 1, 0}, {-1, -1, 0}};
  BOOST_CHECK_EQUAL(internal::half_solid_angle(flat, {5, 5, 0}), 0);
  BOOST_CHECK_CLOSE(std::abs(internal::half_solid_angle(flat, zero)), pi, 1e-9);
  BOOST_CHECK_EQUAL(internal::half_solid_angle(flat, flat[0]), 0);
}

BOOST_AUTO_TEST_CASE(test_hierarchy)
{
  // What is far counts as a whole: the error is small, near and far, on closed surfaces and open
  // ones.
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.5, 1.5);
  surfaces::Indexed_surface open = surfaces::sphere(2000);
  open.faces.resize(open.faces.size() / 2);
  for (const Soup& soup :
       {soup_of(surfaces::sphere(3000, .05, 1)), soup_of(surfaces::grid_torus(3000)),
        soup_of(surfaces::genus_surface(3, 3000, 0.05, 1)), soup_of(open)}) {
    const CGAL::Winding_number_3 number(soup.points, soup.faces);
    for (int k = 0; k < 300; ++k) {
      const Coordinates q = {uniform(random), uniform(random), uniform(random)};
      double sum = 0;
      for (const Face& f : soup.faces) {
        const Coordinates corners[] = {soup.points[f[0]], soup.points[f[1]], soup.points[f[2]]};
        sum += internal::half_solid_angle(corners, q) / (2 * pi);
      }
      BOOST_CHECK_SMALL(number(q) - sum, 0.01);
    }
  }
}

// One tetrahedron is asked for a region; all others must have what they would say if they were
// asked.
BOOST_AUTO_TEST_CASE(test_regions)
{
  surfaces::Indexed_surface holes = surfaces::genus_surface(3, 3000, 0.05, 1),
                            noise = surfaces::sphere(2000, 0.1, 5);
  surfaces::puncture(holes, 7, 1);
  surfaces::puncture(noise, 3, 1);
  std::vector<Soup> soups = {soup_of(holes),
                             soup_of(noise),
                             soup_of(surfaces::grid_torus(2000)),
                             box(9),
                             both(turned(box(4)), box(8, 3, -1)),
                             both(box(8, 2), box(8, 2, 1)),
                             both(box(3), box(3)),
                             cones(300)};
  soups.push_back(box(12));
  soups.back().faces.erase(soups.back().faces.begin() + 100, soups.back().faces.begin() + 120);
  soups.back().faces.push_back(soups.back().faces[900]);
  std::swap(soups.back().faces[900][0],
            soups.back().faces[900][1]);      // and nobody can tell which one
  for (unsigned seed = 0; seed < 8; ++seed) { // which flat one comes first must not matter
    surfaces::Indexed_surface torus = surfaces::grid_torus(500);
    surfaces::shuffle(torus, seed);
    soups.push_back(soup_of(torus));
  }
  for (Soup& soup : soups) {
    soup.add_point(5, 5, 5);
    soup.add_point(-5, -5, 5);
    const auto arrays = CGAL::delaunay_3_arrays(soup.points);
    const auto inside = CGAL::inside_of_surface_3(soup.points, soup.faces, arrays);
    const CGAL::Winding_number_3 number(soup.points, soup.faces);
    auto alone = arrays;
    alone.drop_neighbors();
    BOOST_TEST(CGAL::inside_of_surface_3(soup.points, soup.faces, alone).winding_numbers ==
                   inside.winding_numbers,
               boost::test_tools::per_element());
    for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c) {
      std::array<Coordinates, 4> corners;
      Coordinates center = {0, 0, 0};
      for (std::size_t k = 0; k < 4; ++k) {
        corners[k] = soup.points[std::size_t(arrays.vertices(c)[k])];
        for (std::size_t j = 0; j < 3; ++j)
          center[j] += corners[k][j] / 4;
      }
      if (volume_of(corners) < 1e-12) // so flat that its centre may come to lie outside
        continue;
      BOOST_REQUIRE_SMALL(inside.winding_numbers[c] - number(center), 0.03);
    }
  }
}

BOOST_AUTO_TEST_CASE(test_kinds_of_input)
{
  // Polygons, points of a kernel, faces of any integers, and no faces.
  std::vector<surfaces::Indexed_surface::Point_3> points;
  for (int k = 0; k < 8; ++k)
    points.emplace_back(k & 1, k >> 1 & 1, k >> 2);
  const std::vector<std::vector<int>> sides = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                               {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  const CGAL::Winding_number_3 number(points, sides);
  BOOST_CHECK_CLOSE(number(surfaces::Indexed_surface::Point_3(.5, .3, .8)), 1, 1e-9);
  BOOST_CHECK_SMALL(number(Coordinates{1.5, .3, .8}), 1e-9);
  BOOST_CHECK_CLOSE(number(Coordinates{1, .5, .5}), .5, 1e-9);
  const CGAL::Winding_number_3 nothing(points, std::vector<std::vector<int>>());
  BOOST_CHECK_EQUAL(nothing(points[0]), 0);
  CGAL::Winding_number_3 other = nothing;
  other = number;
  BOOST_CHECK_EQUAL(other(Coordinates{.5, .3, .8}), number(Coordinates{.5, .3, .8}));
  BOOST_CHECK_THROW(CGAL::Winding_number_3(points, std::vector<std::vector<int>>{{0, 1, 8}}),
                    CGAL::Surface_input_error);
  BOOST_CHECK_THROW(CGAL::Winding_number_3(std::vector<Coordinates>{{0, 0, NAN}}, sides),
                    CGAL::Surface_input_error);
}

// Triangles of a polygon have its sides as their only open edges, and none is at many others.
BOOST_AUTO_TEST_CASE(test_polygons)
{
  for (std::size_t n = 0; n < 70; ++n) {
    std::vector<std::vector<std::size_t>> face(1);
    for (std::size_t i = 0; i < n; ++i)
      face[0].push_back(i);
    std::multiset<std::array<std::size_t, 2>> sides;
    std::vector<std::size_t> triangles_at(n, 0);
    const auto add = [&](std::size_t i, std::size_t j) {
      const auto other = sides.find({j, i});
      if (other == sides.end())
        sides.insert({i, j});
      else
        sides.erase(other);
    };
    std::size_t number = 0;
    internal::for_each_triangle(face, n,
                                [&](std::size_t i, std::size_t j, std::size_t k, std::size_t) {
                                  ++number;
                                  add(i, j), add(j, k), add(k, i);
                                  ++triangles_at[i], ++triangles_at[j], ++triangles_at[k];
                                });
    BOOST_TEST(number == (n < 3 ? 0 : n - 2));
    BOOST_TEST(sides.size() == (n < 3 ? 0 : n));
    for (std::size_t i = 0; i < n; ++i) {
      BOOST_TEST((n < 3 || sides.count({i, (i + 1) % n}) == 1));
      BOOST_TEST(triangles_at[i] < 13u);
    }
  }
  // A prism with 3000 sides.
  std::vector<Coordinates> points;
  std::vector<std::vector<std::size_t>> faces(2);
  const std::size_t n = 3000;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 2 * pi * double(i) / double(n);
    points.insert(points.end(), {{std::cos(t), std::sin(t), 0}, {std::cos(t), std::sin(t), 1}});
    const std::size_t a = 2 * i, b = 2 * ((i + 1) % n);
    faces.push_back({a, b, b + 1, a + 1});
    faces[0].push_back(2 * (n - 1 - i));
    faces[1].push_back(a + 1);
  }
  const auto arrays = CGAL::delaunay_3_arrays(points);
  const CGAL::Inside_3 inside = CGAL::inside_of_surface_3(points, faces, arrays);
  double volume = 0;
  for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c) {
    const auto v = arrays.vertices(c);
    const auto at = [&](std::size_t k) { return points[std::size_t(v[k])]; };
    volume += inside[c] ? volume_of({at(0), at(1), at(2), at(3)}) : 0;
  }
  BOOST_CHECK_CLOSE(volume, .5 * double(n) * std::sin(2 * pi / double(n)), 1e-6);
  BOOST_CHECK_EQUAL(inside.share_of_openings, 0);
}

BOOST_AUTO_TEST_CASE(test_volumes)
{
  const Found cube = find(box(7));
  BOOST_CHECK_CLOSE(cube.volume, 1, 1e-9);
  BOOST_CHECK_EQUAL(cube.inside.number_of_doubtful, 0u);
  BOOST_CHECK_EQUAL(cube.inside.number_of_multiple, 0u);
  BOOST_CHECK_EQUAL(cube.inside.doubtful_volume, 0);
  for (const Soup& soup : {soup_of(surfaces::sphere(4000)), soup_of(surfaces::grid_torus(4000)),
                           soup_of(surfaces::genus_surface(5, 4000, 0.05, 3))}) {
    const Found found = find(soup);
    BOOST_CHECK_CLOSE(found.volume, std::abs(volume_of(soup)),
                      0.1); // percent: not all triangles are Delaunay
    BOOST_CHECK_LT(found.inside.doubtful_share(), 1e-3);
  }
}

BOOST_AUTO_TEST_CASE(test_far_away)
{
  surfaces::Indexed_surface open = surfaces::sphere(200);
  open.faces.resize(open.faces.size() / 2);
  for (const Soup& soup : {soup_of(open), box(1)}) {
    const CGAL::Winding_number_3 number(soup.points, soup.faces);
    for (int exponent = 4; exponent < 309; ++exponent) {
      const double far = std::pow(10., exponent);
      for (const Coordinates& q : {Coordinates{far, 0, 0}, Coordinates{far, -far, far / 3}})
        BOOST_TEST(std::abs(number(q)) < 1e-6, "at a distance of " << far);
    }
  }
}

BOOST_AUTO_TEST_CASE(test_sizes)
{
  for (const double size : {1e-300, 1e-150, 1e150, 1e300}) {
    Soup soup = box(3, size);
    soup.add_point(-size, 2 * size, 3 * size);
    const auto arrays = CGAL::delaunay_3_arrays(soup.points);
    const auto inside = CGAL::inside_of_surface_3(soup.points, soup.faces, arrays);
    double volume = 0;
    for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c) {
      std::array<Coordinates, 4> corners;
      for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t j = 0; j < 3; ++j)
          corners[k][j] = soup.points[std::size_t(arrays.vertices(c)[k])][j] / size;
      volume += inside[c] ? volume_of(corners) : 0;
    }
    BOOST_CHECK_CLOSE(volume, 1, 1e-9);
  }
  const Found far = find(box(4, 1, 1e7), 1e7 + 5); // far from the origin
  BOOST_CHECK_CLOSE(far.volume, 1, 1e-5);
}

// Holes, flips and faces that come twice, in a surface whose volume is known.
BOOST_AUTO_TEST_CASE(test_hurt_surfaces)
{
  std::mt19937 random(3);
  for (const std::size_t damages : {1, 10, 100}) {
    Soup holes = box(20), flips = box(20), doubles = box(20), all = box(20);
    for (std::size_t k = 0; k < damages; ++k) {
      const std::size_t f = random() % holes.faces.size(), g = random() % 4000, h = random() % 4000;
      holes.faces.erase(holes.faces.begin() + std::ptrdiff_t(f));
      std::swap(flips.faces[g][0], flips.faces[g][1]);
      doubles.faces.push_back(doubles.faces[h]);
      std::swap(all.faces[g][0], all.faces[g][1]);
      all.faces.push_back(all.faces[h]);
      all.faces.erase(all.faces.begin() + std::ptrdiff_t(f));
    }
    for (const Soup& soup : {holes, flips, doubles, all}) {
      const Found found = find(soup);
      BOOST_CHECK_CLOSE(found.volume, 1, 0.01 * double(damages)); // percent
      BOOST_CHECK_LT(found.inside.doubtful_volume, 0.003 * double(damages));
    }
    BOOST_CHECK_EQUAL(find(holes).inside.number_of_doubtful > 0, damages > 1);
  }
  surfaces::Indexed_surface punctured = surfaces::sphere(3000);
  surfaces::puncture(punctured, 5, 1);
  BOOST_CHECK_CLOSE(find(soup_of(punctured)).volume, volume_of(soup_of(surfaces::sphere(3000))),
                    0.5);
}

BOOST_AUTO_TEST_CASE(test_several_parts)
{
  const Soup small = box(4), large = box(8, 3, -1);
  // Inside out; beside each other, one inside out; coincident walls; a part twice.
  BOOST_CHECK_CLOSE(find(turned(small)).volume, 1, 1e-9);
  BOOST_CHECK_CLOSE(find(both(small, turned(box(4, 1, 2)))).volume, 2, 1e-9);
  const Found twice = find(both(small, small));
  BOOST_CHECK_CLOSE(twice.volume, 1, 1e-9);
  BOOST_CHECK_GT(twice.inside.number_of_multiple, 0u);
  // A part in a part, and a cavity: its walls look inwards.
  const Found nested = find(both(small, large));
  BOOST_CHECK_CLOSE(nested.volume, 27, 1e-9);
  BOOST_CHECK_GT(nested.inside.number_of_multiple, 0u);
  const Found cavity = find(both(turned(small), large));
  BOOST_CHECK_CLOSE(cavity.volume, 26, 1e-9);
  BOOST_CHECK_EQUAL(cavity.inside.number_of_multiple, 0u);
  BOOST_CHECK_EQUAL(cavity.inside.number_of_turned, 0u);
  // Parts that overlap.
  BOOST_CHECK_CLOSE(find(both(box(8, 2), box(8, 2, 1))).volume, 15, 1e-9);
}

// Points that no face uses, or only one without area, do not make the surface small.
BOOST_AUTO_TEST_CASE(test_unused_points)
{
  surfaces::Indexed_surface holes = surfaces::sphere(500);
  surfaces::puncture(holes, 2, 1);
  for (const Soup& soup : {box(3), both(turned(box(2)), box(4, 3, -1)), soup_of(holes)}) {
    const double expected = find(soup).volume;
    for (int exponent = 1; exponent <= 300; exponent += 23)
      for (const double x : {1., -.3}) {
        Soup other = soup;
        const double far = std::pow(10., exponent);
        const std::size_t p = other.add_point(x * far, far, -far / 7);
        const std::size_t q = other.add_point(x * far, far, -far / 7);
        other.faces.push_back({0, p, p});
        other.faces.push_back({p, 0, q});
        const Found found = find(other);
        BOOST_CHECK_CLOSE(found.volume, expected, 1e-6);
        BOOST_TEST(found.inside.number_of_turned == 0u);
      }
  }
}

// Nor do they if many faces are no facets, so that it is asked which ways cross them.
BOOST_AUTO_TEST_CASE(test_far_point_and_faces_that_are_no_facets)
{
  const double pi = std::acos(-1.);
  const std::array<std::size_t, 2> sizes[] = {{7, 5}, {9, 6}, {12, 5}, {6, 9}};
  for (const auto& [n, m] : sizes)
    for (unsigned seed = 0; seed < 6; ++seed) {
      std::mt19937 random(seed);
      std::uniform_real_distribution<double> noise(-.007, .007);
      Soup soup;
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < m; ++j) {
          const double u = 2 * pi * double(i) / double(n), v = 2 * pi * double(j) / double(m);
          const double r = 1 + .45 * std::cos(v);
          soup.add_point(r * std::cos(u) + noise(random), r * std::sin(u) + noise(random),
                         .45 * std::sin(v) * (1 + .3 * std::sin(3 * u)) + noise(random));
        }
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < m; ++j) {
          const std::size_t a = i * m + j, b = (i + 1) % n * m + j, d = i * m + (j + 1) % m,
                            c = (i + 1) % n * m + (j + 1) % m;
          soup.faces.push_back({a, b, c});
          soup.faces.push_back({a, c, d});
        }
      const double expected = find(soup).volume;
      for (const double far : {1e8, 1e12, 1e16, 1e20, 1e60, 1e200}) {
        Soup other = soup;
        other.add_point(far, far, -far / 10);
        BOOST_TEST_CONTEXT(n << " × " << m << ", seed " << seed << ", a point at " << far)
        {
          BOOST_CHECK_CLOSE(find(other).volume, expected, 5);
        }
      }
    }
}

// Some faces turned round, by chance or all for which a condition holds.
template <class Condition>
Soup with_turned(Soup soup, Condition condition)
{
  for (std::size_t f = 0; f < soup.faces.size(); ++f)
    if (condition(f, soup.faces[f]))
      std::swap(soup.faces[f][0], soup.faces[f][2]);
  return soup;
}

BOOST_AUTO_TEST_CASE(test_turned_faces)
{
  std::mt19937 random(5);
  const auto one_in_twelve = [&](std::size_t, const Face&) { return random() % 12 == 0; };
  const Soup ball = soup_of(surfaces::sphere(2000)), torus = soup_of(surfaces::grid_torus(1500));
  Soup small = ball;
  for (Coordinates& p : small.points)
    p = {p[0] / 2, p[1] / 2, p[2] / 2};
  Soup edge = box(3); // and another box, with which it shares an edge
  for (const Coordinates& p : box(3).points)
    edge.add_point(p[0] + 1, p[1] + 1, p[2]);
  for (const Face& f : box(3).faces)
    edge.faces.push_back({f[0] + 96, f[1] + 96, f[2] + 96});
  struct Case
  {
    Soup soup, hurt;
  };
  const Soup hollow = both(ball, turned(small));
  std::vector<Case> cases;
  cases.push_back({box(4), with_turned(box(4), [](std::size_t f, auto&) { return f < 32; })});
  cases.push_back({box(4), with_turned(box(4), [](std::size_t f, auto&) { return f < 96; })});
  cases.push_back({ball, with_turned(ball, [&](std::size_t, const Face& f) {
                     return ball.points[f[0]][2] > 0;
                   })});
  for (const Soup& soup : {ball, torus, edge, box(6), both(box(4), box(8, 3, -1)), hollow})
    cases.push_back({soup, with_turned(soup, one_in_twelve)});
  const std::size_t faces = ball.faces.size();
  cases.push_back({hollow, with_turned(hollow, [&](std::size_t f, auto&) {
                     return f >= faces && f % 12 == 0;
                   })});
  cases.push_back(
      {hollow, with_turned(hollow, [&](std::size_t f, auto&) { return f < faces && f % 9 == 0; })});
  for (const Case& c : cases) {
    const Found whole = find(c.soup), found = find(c.hurt);
    BOOST_CHECK_EQUAL(whole.inside.number_of_turned, 0u);
    BOOST_CHECK_GT(found.inside.number_of_turned, 0u);
    BOOST_CHECK_CLOSE(found.volume, whole.volume, 1e-9);
    BOOST_CHECK_EQUAL(found.inside.number_of_doubtful, 0u);
  }
  // Exactly those that have been turned; one that is coherent stays, and looks inwards.
  BOOST_CHECK_EQUAL(find(cases[0].hurt).inside.number_of_turned, 32u);
  BOOST_CHECK_EQUAL(find(turned(ball)).inside.number_of_turned, 0u);
  BOOST_CHECK_CLOSE(find(hollow).volume, find(ball).volume - find(small).volume, 1e-3);

  // Faces of four points count once.
  std::vector<std::vector<int>> sides = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                         {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  std::reverse(sides[3].begin(), sides[3].end());
  std::vector<Coordinates> corners;
  for (int k = 0; k < 8; ++k)
    corners.push_back({double(k & 1), double(k >> 1 & 1), double(k >> 2)});
  const auto arrays = CGAL::delaunay_3_arrays(corners);
  const CGAL::Inside_3 inside = CGAL::inside_of_surface_3(corners, sides, arrays);
  BOOST_CHECK_EQUAL(inside.number_of_turned, 1u);
  for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c)
    BOOST_TEST(inside[c]);
}

// Klein's bottle, as a figure of eight that turns half round: closed, and it has only one side.
BOOST_AUTO_TEST_CASE(test_what_is_not_orientable)
{
  Soup bottle;
  const std::size_t n = 24;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const double u = 2 * pi * double(i) / n, v = 2 * pi * (double(j) + .5) / n;
      const double r = 2 + std::cos(u / 2) * std::sin(v) - std::sin(u / 2) * std::sin(2 * v);
      bottle.add_point(r * std::cos(u), r * std::sin(u),
                       std::sin(u / 2) * std::sin(v) + std::cos(u / 2) * std::sin(2 * v));
    }
  const auto at = [&](std::size_t i, std::size_t j) {
    return i < n ? n * i + j % n : (2 * n - 1 - j % n) % n;
  };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      bottle.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      bottle.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  const std::string message = "it is not orientable, as a";
  check_that_there_is_none(bottle, message);
  check_that_there_is_none(both(box(4, 3, 9), bottle), message);
  bottle.faces.resize(bottle.faces.size() - 7); // nor is it then
  check_that_there_is_none(bottle, message);
}

// Parts of tetrahedra beyond a plane, by divided differences, which need four different distances.
BOOST_AUTO_TEST_CASE(test_share_beyond)
{
  CGAL::Random random(1);
  unsigned beyond[4] = {0, 0, 0, 0};
  for (int i = 0; i < 2000; ++i) {
    const auto vector = [&] {
      return internal::Vector_3d{random.get_double(-1, 1), random.get_double(-1, 1),
                                 random.get_double(-1, 1)};
    };
    const internal::Cutting_triangle t({vector(), vector(), vector()}, 1);
    const std::array<internal::Vector_3d, 4> p = {vector(), vector(), vector(), vector()};
    double d[4], sum = 0, expected = 0;
    for (int k = 0; k < 4; ++k)
      sum += d[k] = internal::dot(t.normal, internal::minus(p[std::size_t(k)], t.corners[0]));
    unsigned number = 0;
    for (int k = 0; k < 4; ++k)
      if (d[k] * sum < 0) {
        ++number;
        double term = 1;
        for (int j = 0; j < 4; ++j)
          term *= j == k ? 1 : d[k] / (d[k] - d[j]);
        expected += term;
      }
    ++beyond[number];
    BOOST_CHECK_SMALL(internal::share_beyond(t, p) - expected, 1e-6);
  }
  for (const unsigned times : beyond)
    BOOST_CHECK_GT(times, 20u);
}

// The trapezoids of a mesh by latitude and longitude are flat but for the digits of its file, and
// many are cut along the other diagonals.
BOOST_AUTO_TEST_CASE(test_rounded_trapezoids)
{
  Soup soup;
  const int n = 40;
  soup.points = {{0, 0, 1}, {0, 0, -1}};
  const auto rounded = [](double x) { return std::round(1e6 * x) / 1e6; };
  for (int i = 1; i < n; ++i)
    for (int j = 0; j < 2 * n; ++j) {
      const double u = pi * i / n, v = pi * j / n;
      soup.add_point(rounded(3 * std::sin(u) * std::cos(v)), rounded(2 * std::sin(u) * std::sin(v)),
                     rounded(std::cos(u)));
    }
  const auto at = [&](int i, int j) { return std::size_t(2 + 2 * n * (i - 1) + j % (2 * n)); };
  for (int j = 0; j < 2 * n; ++j) {
    soup.faces.push_back({0, at(1, j), at(1, j + 1)});
    soup.faces.push_back({1, at(n - 1, j + 1), at(n - 1, j)});
    for (int i = 1; i + 1 < n; ++i) {
      soup.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      soup.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  const CGAL::Inside_3 inside = find(soup).inside;
  BOOST_CHECK_GT(inside.missing_area, 0.1);
  BOOST_CHECK_GT(inside.crossed_volume, 0);
  BOOST_CHECK_LT(inside.crossed_volume, 1e-3);
  BOOST_TEST(internal::warning_of(inside).empty());
}

// Faces that are no facets, and how much of the volume they cut off.
BOOST_AUTO_TEST_CASE(test_faces_that_are_no_facets)
{
  const auto is_sure = [](const Soup& soup) {
    const CGAL::Inside_3 inside = find(soup).inside;
    return inside.crossed_volume == 0 && internal::warning_of(inside).empty();
  };
  BOOST_TEST(is_sure(box(1))); // other diagonals cross nothing
  BOOST_TEST(is_sure(box(5)));
  BOOST_TEST(is_sure(both(box(4), box(8, 3, -1))));
  const CGAL::Inside_3 coarse = find(cones(200)).inside;
  BOOST_CHECK_GT(coarse.missing_area, 0.2);
  BOOST_CHECK_GT(coarse.crossed_volume, 0.1);
  BOOST_CHECK_LE(coarse.crossed_volume, 1);
  BOOST_TEST(internal::warning_of(coarse).find("; remedy: refine the surface") !=
             std::string::npos);
  // The volume that is wrong is not more than what is crossed.
  for (const std::size_t n : {8, 20, 60, 150}) {
    const Found found = find(cones(n), 2.5);
    const double right = std::abs(volume_of(cones(n)));
    BOOST_CHECK_LE(std::abs(found.volume - right) / (std::max)(found.volume, right),
                   found.inside.crossed_volume + 1e-9);
  }
  for (const double digit : {0.3, 0.1, 0.03}) {
    Soup coarse_tori = soup_of(surfaces::genus_surface(3, 3000, 0, 1));
    for (Coordinates& p : coarse_tori.points)
      for (double& x : p)
        x = digit * std::round(x / digit);
    const Found found = find(coarse_tori);
    const double right = std::abs(volume_of(coarse_tori));
    BOOST_CHECK_GT(found.inside.crossed_volume, 0);
    BOOST_CHECK_LE(std::abs(found.volume - right) / (std::max)(found.volume, right),
                   found.inside.crossed_volume + found.inside.doubtful_volume + 1e-9);
  }
  Soup open = box(6);
  open.faces.erase(open.faces.begin(), open.faces.begin() + 72);
  const CGAL::Inside_3 deck = find(open).inside;
  BOOST_CHECK_GT(deck.doubtful_volume, 0.05);
  BOOST_TEST(internal::warning_of(deck).find("in doubt, near openings; remedy: ") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(test_no_inside)
{
  check_that_there_is_none(both(box(3), turned(box(3))), "once turned round; remedy: ");
  Soup none = box(1);
  none.faces = {{0, 1, 1}, {2, 2, 2}};
  check_that_there_is_none(none, "there are no faces with an area");
  Soup sheet;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j)
      sheet.add_point(i, j, 0.01 * ((i * i + j * 3) % 7));
  for (std::size_t i = 0; i + 1 < 20; ++i)
    for (std::size_t j = 0; j + 1 < 20; ++j) {
      const std::size_t a = 20 * i + j;
      sheet.faces.push_back({a, a + 20, a + 21});
      sheet.faces.push_back({a, a + 21, a + 1});
    }
  const std::string message = "the surface has no inside: ";
  check_that_there_is_none(sheet, message);

  Soup strip; // Möbius'
  const std::size_t n = 60;
  for (std::size_t i = 0; i < n; ++i)
    for (int k = 0; k < 2; ++k) {
      const double t = 2 * pi * double(i) / double(n), w = k == 0 ? -.4 : .4;
      strip.add_point((1 + w * std::cos(t / 2)) * std::cos(t),
                      (1 + w * std::cos(t / 2)) * std::sin(t), w * std::sin(t / 2));
    }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t a = 2 * i, b = a + 1, c = i + 1 < n ? a + 2 : 1, d = i + 1 < n ? a + 3 : 0;
    strip.faces.push_back({a, c, d});
    strip.faces.push_back({a, d, b});
  }
  check_that_there_is_none(strip, message + "it is not orientable");

  // Without its lid a box has an inside; a tube, of the same share of openings, has none.
  Soup open = box(6), tube = box(6);
  open.faces.erase(open.faces.begin(), open.faces.begin() + 72);
  BOOST_CHECK_CLOSE(find(open).volume, 1, 1e-9);
  tube.faces.erase(tube.faces.begin(), tube.faces.begin() + 144);
  for (Coordinates& p : tube.points)
    p[0] *= 2.5;
  check_that_there_is_none(tube, message);

  surfaces::Indexed_surface half = surfaces::sphere(3000);
  half.faces.erase(std::remove_if(half.faces.begin(), half.faces.end(),
                                  [&](const auto& f) { return half.points[f[0]].z() > 0; }),
                   half.faces.end());
  check_that_there_is_none(soup_of(half), message);

  Soup side = box(6);
  side.faces.resize(72);
  check_that_there_is_none(side, message);
  side.faces.clear();
  check_that_there_is_none(side, message);

  Soup flat;
  flat.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  flat.faces = {{0, 1, 2}};
  BOOST_CHECK_THROW(
      CGAL::inside_of_surface_3(flat.points, flat.faces, CGAL::delaunay_3_arrays(flat.points)),
      CGAL::Surface_input_error);
  BOOST_CHECK_THROW(
      CGAL::inside_of_surface_3(sheet.points, sheet.faces, CGAL::delaunay_3_arrays(box(2).points)),
      CGAL::Surface_input_error);

  // Weights may hide vertices; if they do not, any triangulation will do.
  const Soup solid = box(2);
  std::vector<double> weights(solid.points.size(), 0);
  const auto plain =
      CGAL::inside_of_surface_3(solid.points, solid.faces, CGAL::delaunay_3_arrays(solid.points));
  const auto same = CGAL::inside_of_surface_3(solid.points, solid.faces,
                                              CGAL::regular_3_arrays(solid.points, weights));
  BOOST_TEST(same.winding_numbers == plain.winding_numbers);
  weights[0] = 100;
  BOOST_CHECK_THROW(CGAL::inside_of_surface_3(solid.points, solid.faces,
                                              CGAL::regular_3_arrays(solid.points, weights)),
                    CGAL::Surface_input_error);
}

} // namespace
