// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The stages of the compact kernel's predicates against exact arithmetic: they may leave a sign
// open, and must never give a wrong one; and its perturbation against CGAL's. Also built with the
// machine's own instructions and contraction to fma.

#define BOOST_TEST_MODULE test_filters
#include <boost/test/included/unit_test.hpp>

#include "Perturbed_predicates.h"
#include "check_signs.h"
#include "hostile_points.h"

#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_predicates.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Double_double.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Ordered_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/exact_signs.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

using namespace CGAL::Delaunay_from_surface_3;
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

// What the exact stages decided.
struct Exact_tally
{
  std::size_t tests = 0, wrong = 0, perturbed = 0;
  std::size_t stages[NUMBER_OF_EXACT_STAGES] = {};

  // truth: not perturbed; it is asked for the perturbed sign if that is needed.
  template <class Perturbed_sign>
  void count(const Exact_sign& sign, int truth, const Perturbed_sign& perturbed_sign)
  {
    ++tests;
    ++stages[sign.stage];
    perturbed += sign.is_perturbed;
    wrong += sign.is_perturbed != (truth == 0);
    wrong += sign.sign != (truth != 0 ? truth : perturbed_sign());
  }
};

struct Tallies
{
  Tally first, facets, second;
  Exact_tally exact, lattice;
};

// The doubles that round nothing, where the points are near each other on a lattice; the last one is p.
template <class Determinant, std::size_t N, class Perturbed_sign>
void count_lattice(const std::array<Record, N>& f, int truth, const Perturbed_sign& perturbed_sign,
                   Exact_tally& tally)
{
  std::vector<double> coordinates;
  for (const Record& r : f)
    coordinates.insert(coordinates.end(), r.begin(), r.begin() + 3);
  const Power_of_scale scaled(Point_array(coordinates.data(), N), nullptr);
  std::array<std::array<double, 3>, N> points;
  std::array<const double*, N> v;
  for (std::size_t k = 0; k < N; ++k) {
    points[k] = scaled(f[k].data());
    v[k] = points[k].data();
  }
  const Exact_sign sign = lattice_sign<Determinant>(v.data(), v[N - 1], scaled.exact_size());
  if (sign.sign != 0)
    tally.count(sign, truth, perturbed_sign);
}

int inside_or_outside(bool is_inside)
{
  return is_inside ? 1 : -1;
}

// CGAL's, in exact arithmetic.
int perturbed_sphere(const Five& f)
{
  const Perturbed_predicates<Exact> predicates{Exact()};
  return inside_or_outside(
      predicates.is_in_sphere(f[0].data(), f[1].data(), f[2].data(), f[3].data(), f[4].data()));
}

int perturbed_beyond(const std::array<Record, 4>& f)
{
  const Perturbed_predicates<Exact> predicates{Exact()};
  return inside_or_outside(
      predicates.is_beyond(f[0].data(), f[1].data(), f[2].data(), f[3].data()));
}

// The predicate with two digits, also where one would do; with any number where two do not do.
template <class Determinant>
Exact_sign sign_from_two_digits(const double* const* v, const double* p)
{
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER
  const Exact_differences<Determinant::size> exact_differences(v, p);
  const Integer_differences<Determinant::size> differences(exact_differences);
  Row<Fixed_integer<4>> rows[Determinant::size];
  if (differences.can_be_scaled() && differences.set_rows(rows))
    return Determinant::sign(rows, TWO_DIGITS, v, p);
#endif
  return wide_sign<Determinant>(v, p);
}

template <class Filter>
void check_view(const Five& f, int sphere, Tallies& tallies)
{
  const double* const v[4] = {f[0].data(), f[1].data(), f[2].data(), f[3].data()};
  const Cell_view view = Filter::view(v, f[4].data());
  tallies.first.count(view.sphere, sphere);
  for (unsigned k = 0; k < 4; ++k) {
    tallies.facets.count(certified_sign(view.facets[k], view.facet_bound),
                         exact_orientation(f[4], f[k ^ 1], f[k ^ 2], f[k ^ 3]));
    const double w = row(v[k], f[4].data()).w, push = view.facets[k] * w * w;
    if (std::abs(view.pushes[k] - push) > 1e-12 * std::abs(push) + Filter_bounds::tiny)
      BOOST_ERROR("a push is not its facet times a fourth power");
  }
}

Sphere_signs signs_of(Sphere_filter, const double* const* v, const double* const* opposite,
                      const double* p)
{
  return Sphere_filter::neighbors(v, opposite, p, 15);
}

#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS
CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS Sphere_signs signs_of(Wide_sphere_filter,
                                                              const double* const* v,
                                                              const double* const* opposite,
                                                              const double* p)
{
  return Wide_sphere_filter::signs(v, opposite, p);
}
#endif

// The cell's neighbours as the kernel sees them: here beyond facet k lies `apex`, and the
// neighbour's sphere is that of (apex, facet).
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

// The kernel knows the vertices at a point's place before it tests spheres.
bool is_same_place(const double* a, const double* b)
{
  return std::equal(a, a + 3, b);
}

void check(Five f, const Record& apex, Tallies& tallies)
{
  const int orientation = exact_orientation(f[0], f[1], f[2], f[3]);
  if (orientation == 0)
    return;
  if (orientation < 0)
    std::swap(f[0], f[1]);
  const int sphere = exact_sphere(f);
  const double *const v[4] = {f[0].data(), f[1].data(), f[2].data(), f[3].data()}, *const p =
                                                                                       f[4].data();
  const Exact_differences<4> differences(v, p);
  tallies.second.count(close_sphere_sign_with<Portable_products>(differences), sphere);
  tallies.second.count(close_sphere_sign(differences), sphere);
  if (std::none_of(v, v + 4, [&](const double* q) { return is_same_place(q, p); })) {
    const auto perturbed = [&] { return perturbed_sphere(f); };
    tallies.exact.count(exact_sign<Exact_sphere>(v, p), sphere, perturbed);
    Exact_tally two_digits;
    two_digits.count(sign_from_two_digits<Exact_sphere>(v, p), sphere, perturbed);
    tallies.exact.wrong += two_digits.wrong;
    count_lattice<Exact_sphere>(f, sphere, perturbed, tallies.lattice);
  }
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
    BOOST_TEST(tallies.exact.wrong == 0u);
    BOOST_TEST(tallies.lattice.wrong == 0u);
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
  Tally first, flat;
  Exact_tally exact, lattice;
};

void check_beyond(const std::array<Record, 4>& f, Beyond_tallies& tallies)
{
  const double *const v[3] = {f[0].data(), f[1].data(), f[2].data()}, *const p = f[3].data();
  if (CGAL::collinear(exact(f[0]), exact(f[1]), exact(f[2])) ||
      std::any_of(v, v + 3, [&](const double* q) { return is_same_place(q, p); }))
    return;
  const int truth = exact_beyond(f[0], f[1], f[2], f[3]);
  tallies.first.count(beyond_sign(row(v[0], p), row(v[1], p), row(v[2], p)), truth);
  tallies.flat.count(flat_beyond_sign(v, p), truth);
  const auto perturbed = [&] { return perturbed_beyond(f); };
  tallies.exact.count(exact_sign<Exact_beyond>(v, p), truth, perturbed);
  Exact_tally two_digits;
  two_digits.count(sign_from_two_digits<Exact_beyond>(v, p), truth, perturbed);
  tallies.exact.wrong += two_digits.wrong;
  count_lattice<Exact_beyond>(f, truth, perturbed, tallies.lattice);
}

Beyond_tallies check_beyond(const std::function<Record(CGAL::Random&)>& make, std::size_t n)
{
  CGAL::Random random(3);
  Beyond_tallies tallies;
  for (std::size_t i = 0; i < n; ++i) {
    std::array<Record, 4> f;
    for (Record& r : f)
      r = make(random);
    check_beyond(f, tallies);
  }
  BOOST_TEST(tallies.first.wrong == 0u);
  BOOST_TEST(tallies.flat.wrong == 0u);
  BOOST_TEST(tallies.exact.wrong == 0u);
  BOOST_TEST(tallies.lattice.wrong == 0u);
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
  for (const int side : {1, 2, 3, 10, 209, 4095, 1000000, 8388607, 8388609, 1 << 29}) {
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
    if (side <= 209) // no two are farther apart than 2 sqrt(3) side < sqrt(2^19)
      BOOST_TEST(t.lattice.tests == t.exact.tests);
    if (side > 1000000)
      BOOST_TEST(t.lattice.tests == 0u);
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER
    BOOST_TEST((side > 3 || t.exact.perturbed > 0u));
    BOOST_TEST(t.exact.stages[HALF_DIGIT] + t.exact.stages[ONE_DIGIT] == t.exact.tests);
    if (side < 1 << 29) // differences are at most 2 side
      BOOST_TEST(t.exact.stages[HALF_DIGIT] == t.exact.tests);
    else
      BOOST_TEST(t.exact.stages[ONE_DIGIT] > 0u);
#endif
  }
}

// As large as doubles round nothing, and ten times as large: whole numbers on a sphere, or next to it.
BOOST_AUTO_TEST_CASE(large_spheres_on_lattices)
{
  for (const int radius : {361, 3625}) {
    std::vector<Record> points;
    for (int x = -radius; x <= radius; ++x)
      for (int y = -radius; y <= radius; ++y) {
        const int rest = radius * radius - x * x - y * y, z = int(std::sqrt((std::max)(rest, 0)));
        if (z * z == rest)
          for (const int sign : {-1, 1})
            points.push_back({double(x), double(y), double(sign * z), unused});
      }
    const Tallies t = check_all(
        "whole numbers on a sphere of radius " + std::to_string(radius),
        [&points](CGAL::Random& r) {
          Record p = points[std::size_t(r.get_int(0, int(points.size())))];
          p[0] += r.get_int(0, 8) == 0;
          return p;
        },
        5000);
    BOOST_TEST((t.lattice.perturbed > 0) == (radius == 361));
    BOOST_TEST((t.lattice.tests == t.exact.tests) == (radius == 361));
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
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER
    if (thin > 1e-3)
      BOOST_TEST(t.exact.stages[ONE_DIGIT] == t.exact.tests);
    else if (thin > 1e-10)
      BOOST_TEST(t.exact.stages[DOUBLE_DOUBLE] > 0u);
    else
      BOOST_TEST(t.exact.stages[ANY_WIDTH] > 0u);
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
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER
    BOOST_TEST(lattice.exact.perturbed > 0u);
    BOOST_TEST(lattice.exact.stages[ONE_DIGIT] > lattice.exact.tests / 2);
#endif
  }
  const Beyond_tallies box = check_beyond(
      [](CGAL::Random& r) {
        return Record{std::ldexp(r.get_int(-2, 3), -3), std::ldexp(r.get_int(-2, 3), -3),
                      std::ldexp(r.get_int(-2, 3), -3), unused};
      },
      2000);
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER
  BOOST_TEST(box.exact.perturbed > 0u);
  BOOST_TEST(box.exact.stages[HALF_DIGIT] == box.exact.tests);
  BOOST_TEST(box.lattice.tests == box.exact.tests);
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

// What the kernel sees of hostile points: scaled to less than 2^58 in absolute value.
std::vector<Record> scaled(const fuzz::Points& points)
{
  double largest = 0;
  for (const fuzz::Coordinates& p : points)
    for (const double c : p)
      largest = (std::max)(largest, std::abs(c));
  int exponent = 0;
  std::frexp(largest, &exponent);
  std::vector<Record> records;
  for (const fuzz::Coordinates& p : points)
    records.push_back({std::ldexp(p[0], 58 - exponent), std::ldexp(p[1], 58 - exponent),
                       std::ldexp(p[2], 58 - exponent), unused});
  return records;
}

BOOST_AUTO_TEST_CASE(hostile_categories)
{
  fuzz::Random random(11);
  Tallies all;
  Beyond_tallies all_beyond;
  for (const fuzz::Category& category : fuzz::categories) {
    BOOST_TEST_INFO_SCOPE(category.name);
    Tallies tallies;
    Beyond_tallies beyond;
    for (int i = 0; i < 150; ++i) {
      const std::vector<Record> p = scaled(hostile_points(category, random, 12));
      if (p.size() < 6)
        continue;
      check({p[0], p[1], p[2], p[3], p[4]}, p[5], tallies);
      check_beyond({p[0], p[1], p[2], p[3]}, beyond);
    }
    BOOST_TEST(tallies.first.wrong + tallies.facets.wrong + tallies.second.wrong == 0u);
    BOOST_TEST(tallies.exact.wrong + tallies.lattice.wrong + beyond.lattice.wrong == 0u);
    BOOST_TEST(beyond.first.wrong + beyond.flat.wrong + beyond.exact.wrong == 0u);
    for (int stage = 0; stage < NUMBER_OF_EXACT_STAGES; ++stage) {
      all.exact.stages[stage] += tallies.exact.stages[stage] + tallies.lattice.stages[stage];
      all_beyond.exact.stages[stage] += beyond.exact.stages[stage] + beyond.lattice.stages[stage];
    }
    all.exact.perturbed += tallies.exact.perturbed;
    all_beyond.exact.perturbed += beyond.exact.perturbed;
  }
  BOOST_TEST(all.exact.perturbed > 0u);
  BOOST_TEST(all_beyond.exact.perturbed > 0u);
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER
  for (int stage = 0; stage < NUMBER_OF_EXACT_STAGES; ++stage) {
    BOOST_TEST(all.exact.stages[stage] > 0u, "no sphere test reached stage " << stage);
    if (stage != DOUBLE_DOUBLE)
      BOOST_TEST(all_beyond.exact.stages[stage] > 0u, "no facet test reached stage " << stage);
  }
#endif
}

// Weights, by all stages. Points that are lifted into a hyperplane are many.
BOOST_AUTO_TEST_CASE(weights)
{
  fuzz::Random random(14);
  fuzz::Tally tally;
  fuzz::Checked_signs signs(tally);
  for (const fuzz::Category& category : fuzz::categories)
    for (const fuzz::Weighting& weighting : fuzz::weightings) {
      BOOST_TEST_INFO_SCOPE(category.name << ", weights: " << weighting.name);
      fuzz::Points points;
      for (const Record& p : scaled(hostile_points(category, random, 12)))
        points.push_back({p[0], p[1], p[2]});
      fuzz::Weights weights = hostile_weights(weighting, random, points);
      for (double& w : weights) // as large as the kernel has them
        w = std::abs(w) < 0x1p116 ? w : 0;
      for (int i = 0; i < 4; ++i) {
        fuzz::Points nine;
        fuzz::Weights their_weights;
        for (int k = 0; k < 9; ++k) {
          const std::size_t j = random.below(points.size());
          nine.push_back(points[j]);
          their_weights.push_back(weights[j]);
        }
        const fuzz::Quintuple quintuple = fuzz::quintuple_of(nine, their_weights);
        BOOST_CHECK_NO_THROW(fuzz::check_cell<Weighted_place>(quintuple, signs));
        BOOST_CHECK_NO_THROW(fuzz::check_infinite_cell<Weighted_place>(quintuple, signs));
      }
    }
}

// What the kernel asks of points that no power of 2 scales exactly: any doubles.
BOOST_AUTO_TEST_CASE(any_width)
{
  fuzz::Random random(12);
  std::size_t zeros = 0, perturbed = 0;
  for (const fuzz::Category& category : fuzz::categories) {
    BOOST_TEST_INFO_SCOPE(category.name);
    std::size_t wrong = 0;
    for (int i = 0; i < 40; ++i) {
      const fuzz::Points points = hostile_points(category, random, 12);
      if (points.size() < 5)
        continue;
      Five f;
      for (std::size_t k = 0; k < 5; ++k) {
        const double z = random.one_in(4) ? std::ldexp(points[k][2], -900) : points[k][2];
        f[k] = {points[k][0], points[k][1], z, unused};
      }
      const double *a = f[0].data(), *b = f[1].data(), *c = f[2].data(), *d = f[3].data(),
                   *p = f[4].data();
      const double* v[4] = {a, b, c, d};
      const int side = exact_orientation(f[0], f[1], f[2], f[3]);
      wrong += orientation(a, b, c, d) != side;
      zeros += side == 0;
      wrong += are_collinear(a, b, c) != CGAL::collinear(exact(f[0]), exact(f[1]), exact(f[2]));
      const auto is_vertex = [&](int n) {
        return std::any_of(v, v + n, [&](const double* q) { return is_same_place(q, p); });
      };
      if (!are_collinear(a, b, c) && !is_vertex(3)) {
        const Exact_sign said = wide_sign<Exact_beyond>(v, p);
        wrong += said.sign != perturbed_beyond({f[0], f[1], f[2], f[4]});
        perturbed += said.is_perturbed;
      }
      if (side < 0)
        std::swap(f[0], f[1]); // to which v leads
      if (side != 0 && !is_vertex(4)) {
        const Exact_sign said = wide_sign<Exact_sphere>(v, p);
        wrong += said.sign != perturbed_sphere(f);
        perturbed += said.is_perturbed;
      }
    }
    BOOST_TEST(wrong == 0u);
  }
  BOOST_TEST(zeros > 0u);
  BOOST_TEST(perturbed > 0u);
}

BOOST_AUTO_TEST_CASE(perturbation_in_all_orders)
{
  CGAL::Random random(5);
  std::size_t spheres = 0, circles = 0;
  for (int i = 0; i < 300; ++i) { // corners of a box with steps of .1, many in one plane
    Five f;
    for (Record& r : f)
      r = {.1 * random.get_int(0, 2), .3 * random.get_int(0, 2), .1 * random.get_int(0, 2), unused};
    if (exact_sphere(f) != 0)
      continue;
    std::sort(f.begin(), f.end());
    do {
      Tallies tallies;
      check(f, f[0], tallies);
      BOOST_TEST(tallies.exact.wrong == 0u);
      spheres += tallies.exact.perturbed;
      Beyond_tallies beyond;
      check_beyond({f[0], f[1], f[2], f[3]}, beyond);
      BOOST_TEST(beyond.exact.wrong == 0u);
      circles += beyond.exact.perturbed;
    } while (std::next_permutation(f.begin(), f.end()));
  }
  BOOST_TEST(spheres > 1000u);
  BOOST_TEST(circles > 1000u);
}

#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER

using Plain_big = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                                boost::multiprecision::et_off>;

// In columns, not carried.
template <int Halves, int Size>
Uncarried_integer<Halves, Size> in_columns(const Plain_big& n)
{
  Uncarried_integer<Halves, Size> sum = {};
  Plain_big rest = abs(n);
  for (auto& column : sum.columns) {
    const auto digit = static_cast<std::int64_t>(Plain_big(rest & ((Plain_big(1) << 60) - 1)));
    rest >>= 60;
    if (&column == std::end(sum.columns) - 1)
      column = static_cast<Double_digit>(Plain_big((rest << 60) + digit));
    else
      column = digit;
    column = n < 0 ? -column : column;
  }
  return sum;
}

template <int Halves>
Fixed_integer<Halves> fixed(const Plain_big& n)
{
  return carried(in_columns<Halves, Fixed_integer<Halves>::size>(n));
}

// Coordinates and differences of weights as large as the width allows, of all signs, and
// determinants near 0.
template <int Halves>
void check_width()
{
  fuzz::Random random(Halves);
  const Plain_big largest = Plain_big(1) << (30 * Halves);
  const auto coordinate = [&]() -> Plain_big {
    Plain_big n = largest;
    if (random.one_in(3))
      n -= random.below(3);
    else if (random.one_in(2))
      for (Plain_big m = n = 0; n < largest / 3; n = (n << 40) + (random.bits() >> 24))
        ;
    n %= largest + 1;
    return random.one_in(2) ? n : Plain_big(-n);
  };
  std::size_t zeros = 0;
  for (int i = 0; i < 4000; ++i) {
    Row<Plain_big> big[4];
    Row<Fixed_integer<Halves>> rows[4];
    const bool is_weighted = i >= 2000, is_equal = random.one_in(2);
    const auto weight = [&]() -> Plain_big {
      return random.one_in(3) ? 0 : coordinate() * largest;
    };
    const Plain_big one_weight = weight();
    for (int k = 0; k < 4; ++k) {
      big[k] = {coordinate(), coordinate(), coordinate()};
      if (k > 0 && random.one_in(4))
        big[k] = big[k - 1];
      if (k > 0 && random.one_in(4))
        big[k] = {big[k - 1].y, big[k - 1].x, Plain_big(-big[k - 1].z)};
      const Fixed_integer<Halves> x = fixed<Halves>(big[k].x), y = fixed<Halves>(big[k].y),
                                  z = fixed<Halves>(big[k].z);
      rows[k] = {x, y, z};
      if (is_weighted) {
        const Plain_big dw = is_equal ? one_weight : weight();
        big[k] = {big[k].x, big[k].y, big[k].z, dw};
        rows[k] = {x, y, z, in_columns<2 * Halves, 2 * Fixed_integer<Halves>::size - 1>(dw)};
      }
    }
    const Sphere_cofactors<Plain_big> expected(big[0], big[1], big[2], big[3]);
    const Sphere_cofactors<Fixed_integer<Halves>> cofactors(rows[0], rows[1], rows[2], rows[3]);
    const int sign = expected.lifted(big[0], big[1], big[2], big[3]).sign();
    BOOST_TEST(sign_of(cofactors.lifted(rows[0], rows[1], rows[2], rows[3])) == sign);
    zeros += sign == 0;
    for (int k = 0; k < 4; ++k)
      BOOST_TEST(sign_of(cofactors.of[k]) == expected.of[k].sign());
    using R = Row<Fixed_integer<Halves>>;
    using B = Row<Plain_big>;
    const Circle_cofactors<Fixed_integer<Halves>> circle(rows, &R::y, &R::z);
    const Circle_cofactors<Plain_big> expected_circle(big, &B::y, &B::z);
    BOOST_TEST(sign_of(circle.area) == expected_circle.area.sign());
    BOOST_TEST(sign_of(circle.lifted(rows)) == expected_circle.lifted(big).sign());
  }
  BOOST_TEST(zeros > 0u);
}

// Of doubles of all exponents, a few of which are the same.
BOOST_AUTO_TEST_CASE(integers_of_any_width)
{
  fuzz::Random random(13);
  const auto number = [&]() -> double {
    const double sign = random.one_in(2) ? 1 : -1;
    const auto bits = double(random.bits() >> (11 + random.below(53)));
    return sign * std::ldexp(bits, int(random.below(random.one_in(2) ? 60 : 2040)) - 1074);
  };
  const auto big = [](double d) -> Plain_big { // times 2^1074
    int exponent = 0;
    const double fraction = std::frexp(d, &exponent);
    const Plain_big bits = static_cast<std::int64_t>(std::ldexp(fraction, 53));
    const int shift = exponent - 53 + 1074;
    return shift >= 0 ? Plain_big(bits << shift) : Plain_big(bits / (Plain_big(1) << -shift));
  };
  std::size_t zeros = 0, wrong = 0;
  for (int i = 0; i < 3000; ++i) {
    double d[4] = {number(), number(), number(), number()};
    for (double& x : d)
      x = random.one_in(3) ? d[random.below(4)] : x;
    Big_integer w[4];
    Plain_big b[4];
    for (int k = 0; k < 4; ++k)
      w[k] = Big_integer(d[k], -1074), b[k] = big(d[k]);
    const Plain_big minor = b[0] * b[1] - b[2] * b[3];
    zeros += minor.sign() == 0;
    wrong += sign_of(w[0] * w[1] - w[2] * w[3]) != minor.sign();
    wrong += sign_of((w[0] + w[1]) * (w[2] - w[3]) + w[0]) !=
             Plain_big((b[0] + b[1]) * (b[2] - b[3]) + b[0]).sign();
  }
  BOOST_TEST(wrong == 0u);
  BOOST_TEST(zeros > 0u);
}

BOOST_AUTO_TEST_CASE(integers_of_fixed_width)
{
  check_width<1>();
  check_width<2>();
  check_width<4>();
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER
