// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The filters of the compact kernel against exact arithmetic: they may leave a sign open, and must
// never certify a wrong one. Also built with the machine's own instructions and contraction to fma.

#define BOOST_TEST_MODULE test_filters
#include <boost/test/included/unit_test.hpp>

#include <CGAL/Delaunay_from_surface_3/internal/compact/Double_double.h>
#include <CGAL/Delaunay_from_surface_3/internal/compact/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/internal/compact/Wide_sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/internal/compact/flat_beyond_sign.h>
#include <CGAL/Delaunay_from_surface_3/internal/compact/integer_sphere_sign.h>
#include <CGAL/Delaunay_from_surface_3/internal/compact/lattice_sphere_sign.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

using namespace CGAL::Delaunay_from_surface_3::internal;
using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
using Record = std::array<double, 4>; // as wide as what the kernel loads
using Five = std::array<Record, 5>;   // a cell, and the point p

namespace {

Exact::Point_3 exact(const Record& r)
{
  return {r[0], r[1], r[2]};
}

int exact_orientation(const Record& a, const Record& b, const Record& c, const Record& d)
{
  return int(CGAL::orientation(exact(a), exact(b), exact(c), exact(d)));
}

int exact_sphere(const Five& f)
{
  return int(CGAL::side_of_oriented_sphere(exact(f[0]), exact(f[1]), exact(f[2]), exact(f[3]),
                                           exact(f[4])));
}

struct Tally
{
  std::size_t tests = 0, wrong = 0, open = 0;
  void count(int certified, int truth)
  {
    ++tests;
    open += certified == 0;
    wrong += certified != 0 && certified != truth;
  }
};

struct Tallies
{
  Tally first, facets, second;
  std::size_t cells = 0, integers = 0, lattices = 0, wrong_integers = 0;
};

template <class Filter>
void check_view(const Five& f, int sphere, Tallies& tallies)
{
  const double* const v[4] = {f[0].data(), f[1].data(), f[2].data(), f[3].data()};
  const Cell_view view = Filter::view(v, f[4].data());
  tallies.first.count(view.sphere, sphere);
  for (unsigned k = 0; k < 4; ++k)
    tallies.facets.count(certified_sign(view.facets[k], view.facet_bound),
                         exact_orientation(f[4], f[k ^ 1], f[k ^ 2], f[k ^ 3]));
}

Sphere_signs signs_of(Sphere_filter, const double* const* v, const double* const* opposite,
                      const double* p)
{
  return Sphere_filter::neighbors(v, opposite, p, 15);
}

#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS
__attribute__((target("avx2"))) Sphere_signs
signs_of(Wide_sphere_filter, const double* const* v, const double* const* opposite, const double* p)
{
  return Wide_sphere_filter::signs(v, opposite, p);
}
#endif

// The cell's neighbours as the kernel sees them: here beyond facet k lies `apex`, and the neighbour's
// sphere is that of (apex, facet).
template <class Filter>
void check_neighbors(const Five& f, const Record& apex, Tallies& tallies)
{
  const double* const v[4] = {f[0].data(), f[1].data(), f[2].data(), f[3].data()};
  const double* const opposite[4] = {apex.data(), apex.data(), apex.data(), apex.data()};
  const Sphere_signs signs = signs_of(Filter(), v, opposite, f[4].data());
  for (unsigned k = 0; k < 4; ++k) {
    const int certified = int(signs.inside >> k & 1) - int(signs.outside >> k & 1);
    tallies.first.count(certified, -exact_sphere({apex, f[k ^ 1], f[k ^ 2], f[k ^ 3], f[4]}));
  }
}

void check(Five f, const Record& apex, Tallies& tallies)
{
  const int orientation = exact_orientation(f[0], f[1], f[2], f[3]);
  if (orientation == 0)
    return;
  if (orientation < 0)
    std::swap(f[0], f[1]);
  const int sphere = exact_sphere(f);
  const double* const v[4] = {f[0].data(), f[1].data(), f[2].data(), f[3].data()};
  tallies.second.count(close_sphere_sign(v, f[4].data()), sphere);
  if (has_fused_products())
    tallies.second.count(fused_close_sphere_sign(v, f[4].data()), sphere);
  const Integer_sign integer = integer_sphere_sign(v, f[4].data());
  ++tallies.cells;
  tallies.integers += integer.is_known;
  tallies.wrong_integers += integer.is_known && integer.sign != sphere;
  const Integer_sign lattice = lattice_sphere_sign(v, f[4].data());
  tallies.lattices += lattice.is_known;
  tallies.wrong_integers += lattice.is_known && lattice.sign != sphere;
  check_view<Sphere_filter>(f, sphere, tallies);
  check_neighbors<Sphere_filter>(f, apex, tallies);
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS
  if (machine_has_vectors()) {
    check_view<Wide_sphere_filter>(f, sphere, tallies);
    check_neighbors<Wide_sphere_filter>(f, apex, tallies);
  }
#endif
}

using Make_point = std::function<Record(CGAL::Random&)>;

Tallies check_all(const std::string& name, const Make_point& make, std::size_t n)
{
  CGAL::Random random(7);
  Tallies tallies;
  for (std::size_t i = 0; i < n; ++i) {
    Five f;
    for (Record& r : f)
      r = make(random);
    check(f, make(random), tallies);
  }
  BOOST_TEST_MESSAGE(name << ": " << tallies.first.tests
                          << " sphere tests, open after the first filter " << tallies.first.open
                          << "; second filter " << tallies.second.tests << " tests, open "
                          << tallies.second.open);
  BOOST_TEST_CONTEXT(name)
  {
    BOOST_TEST(tallies.first.wrong == 0u);
    BOOST_TEST(tallies.facets.wrong == 0u);
    BOOST_TEST(tallies.second.wrong == 0u);
    BOOST_TEST(tallies.wrong_integers == 0u);
    BOOST_TEST(tallies.first.tests > n);
  }
  return tallies;
}

// Beyond the facet of the convex hull, or in its plane and inside its circle?
int exact_beyond(const Record& a, const Record& b, const Record& c, const Record& p)
{
  const int orientation = exact_orientation(a, b, c, p);
  return orientation != 0
             ? orientation
             : int(CGAL::coplanar_side_of_bounded_circle(exact(a), exact(b), exact(c), exact(p)));
}

struct Beyond_tallies
{
  Tally flat;
  std::size_t facets = 0, on_circle = 0, integers = 0, lattices = 0, wrong = 0;
};

Beyond_tallies check_beyond(const std::function<Record(CGAL::Random&)>& make, std::size_t n)
{
  CGAL::Random random(3);
  Beyond_tallies tallies;
  for (std::size_t i = 0; i < n; ++i) {
    const Record a = make(random), b = make(random), c = make(random), p = make(random);
    if (CGAL::collinear(exact(a), exact(b), exact(c)))
      continue;
    const double* const v[3] = {a.data(), b.data(), c.data()};
    const int truth = exact_beyond(a, b, c, p);
    const Integer_sign integer = integer_beyond_sign(v, p.data()),
                       lattice = lattice_beyond_sign(v, p.data());
    ++tallies.facets;
    tallies.on_circle += truth == 0;
    tallies.flat.count(flat_beyond_sign(v, p.data()), truth);
    tallies.integers += integer.is_known;
    tallies.lattices += lattice.is_known;
    tallies.wrong += integer.is_known && integer.sign != truth;
    tallies.wrong += lattice.is_known && lattice.sign != truth;
  }
  BOOST_TEST(tallies.flat.wrong == 0u);
  BOOST_TEST(tallies.wrong == 0u);
  return tallies;
}

// What lies in the unused lane must not matter.
const double unused = std::numeric_limits<double>::quiet_NaN();

Record on_sphere(CGAL::Random& r, double radius)
{
  const double z = r.get_double(-1, 1), a = r.get_double(0, 6.283185307179586);
  const double s = std::sqrt(1 - z * z);
  return {radius * s * std::cos(a), radius * s * std::sin(a), radius * z, unused};
}

double times_power(CGAL::Random& r, int lowest)
{
  return std::ldexp(r.get_double(-1, 1), r.get_int(lowest, 0));
}

} // namespace

BOOST_AUTO_TEST_CASE(general_position)
{
  const Tallies t = check_all(
      "cube",
      [](CGAL::Random& r) {
        return Record{r.get_double(-1, 1), r.get_double(-1, 1), r.get_double(-1, 1), unused};
      },
      2000);
  BOOST_TEST(t.first.open == 0u); // a filter that decides nothing would be of no use
}

BOOST_AUTO_TEST_CASE(near_spheres_and_planes)
{
  const Tallies sphere = check_all(
      "rounded sphere", [](CGAL::Random& r) { return on_sphere(r, 1); }, 2000);
  BOOST_TEST(sphere.first.open > sphere.first.tests / 4);
  BOOST_TEST(sphere.second.open < sphere.second.tests / 100);
  for (int e = -50; e <= -5; e += 5)
    check_all(
        "sphere with noise 2^" + std::to_string(e),
        [e](CGAL::Random& r) { return on_sphere(r, 1 - std::ldexp(r.get_double(), e)); }, 300);
  for (int e = -60; e <= -5; e += 5)
    check_all(
        "tilted plane with noise 2^" + std::to_string(e),
        [e](CGAL::Random& r) {
          const double x = r.get_double(-.3, .3), y = r.get_double(-.3, .3);
          return Record{x, y, .3 * x + .7 * y + std::ldexp(r.get_double(), e), unused};
        },
        300);
}

BOOST_AUTO_TEST_CASE(exactly_degenerate)
{
  for (const int side : {1, 2, 3, 10, 4095, 1000000, 8388607, 8388609, 1 << 29}) {
    const Tallies t = check_all(
        "lattice of side " + std::to_string(side),
        [side](CGAL::Random& r) {
          Record p = {0, 0, 0, unused};
          for (std::size_t c = 0; c < 3; ++c) // corners often: extreme
            p[c] = std::ldexp(r.get_int(0, 3) == 0 ? (r.get_bool() ? side : -side)
                                                   : double(r.get_int(-side, side + 1)),
                              -30);
          return p;
        },
        600);
#ifdef __SIZEOF_INT128__
    if (side < 8388608)
      BOOST_TEST(t.integers == t.cells);
#endif
    if (side == 1 << 29)
      BOOST_TEST(t.integers < t.cells);
  }
}

// A box of plates: on each axis the lattice has another step, no power of 2.
BOOST_AUTO_TEST_CASE(lattices_with_other_steps_on_each_axis)
{
  for (const double thin : {.3, .01, 1e-9, 1e-40, 1e-150, 1e-300}) {
    const Tallies t = check_all(
        "lattice of thickness " + std::to_string(thin),
        [thin](CGAL::Random& r) {
          const double multiples[] = {-2, -1, 0, 1, 2}; // of which differences are exact
          return Record{std::ldexp(r.get_int(-4, 5), -4), .1 * multiples[r.get_int(0, 5)],
                        thin * multiples[r.get_int(1, 4)], unused};
        },
        2000);
#ifdef __SIZEOF_INT128__
    if (thin > 1e-90)
      BOOST_TEST(t.lattices > t.cells / 2);
    else
      BOOST_TEST(t.lattices == 0u);
#endif
  }
}

BOOST_AUTO_TEST_CASE(infinite_cells)
{
  for (const std::size_t axis : {0, 1, 2}) {
    const auto in_plane = [axis](double height, double u, double v) {
      Record r = {0, 0, 0, unused};
      r[axis] = height;
      r[(axis + 1) % 3] = u;
      r[(axis + 2) % 3] = v;
      return r;
    };
    const Beyond_tallies disc = check_beyond(
        [&](CGAL::Random& r) { return in_plane(.1, r.get_double(-1, 1), r.get_double(-1, 1)); },
        2000);
    BOOST_TEST(disc.flat.open == 0u);
    for (int e = -60; e <= -10; e += 10) {
      const Beyond_tallies circle = check_beyond(
          [&](CGAL::Random& r) {
            const double radius = 1 - std::ldexp(r.get_double(), e), a = r.get_double(0, 6.28);
            return in_plane(.1, .5 * radius * std::cos(a), .5 * radius * std::sin(a));
          },
          500);
      BOOST_TEST((e < -10 || circle.flat.open < circle.flat.tests / 10));
    }
    const Beyond_tallies lattice = check_beyond(
        [&](CGAL::Random& r) {
          return in_plane(.1, std::ldexp(r.get_int(-3, 4), -3), .1 * r.get_int(-1, 2));
        },
        1000);
    BOOST_TEST(lattice.on_circle > 0u);
#ifdef __SIZEOF_INT128__
    BOOST_TEST(lattice.lattices > lattice.facets / 2);
#endif
  }
  const Beyond_tallies box = check_beyond(
      [](CGAL::Random& r) {
        return Record{std::ldexp(r.get_int(-2, 3), -3), std::ldexp(r.get_int(-2, 3), -3),
                      std::ldexp(r.get_int(-2, 3), -3), unused};
      },
      2000);
  BOOST_TEST(box.on_circle > 0u);
#ifdef __SIZEOF_INT128__
  BOOST_TEST(box.integers == box.facets);
#endif
}

BOOST_AUTO_TEST_CASE(far_from_the_origin_and_mixed_scales)
{
  check_all(
      "far away",
      [](CGAL::Random& r) {
        const double h = std::ldexp(1., -27);
        return Record{.75 + h * r.get_double(), .6 + h * r.get_double(), -.9 + h * r.get_double(),
                      unused};
      },
      1000);
  for (const int lowest : {-20, -60, -150, -300, -600, -1000, -1074})
    check_all(
        "powers down to 2^" + std::to_string(lowest),
        [lowest](CGAL::Random& r) {
          return Record{times_power(r, lowest), times_power(r, lowest),
                        r.get_bool() ? -0. : times_power(r, lowest), unused};
        },
        600);
  for (const int e : {-100, -180, -230, -300, -500, -1060})
    check_all(
        "all near 2^" + std::to_string(e),
        [e](CGAL::Random& r) {
          Record p = on_sphere(r, .9);
          for (std::size_t c = 0; c < 3; ++c)
            p[c] = std::ldexp(p[c], e);
          return p;
        },
        300);
}
