// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures the stages of the compact kernel's sphere test, each on points that it decides, next to
// CGAL's predicates and to integers of Boost.Multiprecision. Writes JSON.

#include <Delaunay_from_surface_3_comparison/run_program.h>

#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/exact_signs.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <functional>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace CGAL::Delaunay_from_surface_3;
using namespace CGAL::Delaunay_from_surface_3::internal;
using nlohmann::ordered_json;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Random = std::mt19937_64;
using Coordinates = std::array<double, 3>;

// A positively oriented cell, and p.
struct Test
{
  std::array<Coordinates, 5> points;
  std::array<const double*, 4> vertices() const
  {
    return {points[0].data(), points[1].data(), points[2].data(), points[3].data()};
  }
  const double* p() const { return points[4].data(); }
};

struct Family
{
  std::string name;
  std::function<Coordinates(Random&)> make_point;
};

double unit(Random& r)
{
  return std::ldexp(double(r() >> 11), -53);
}

double either_sign(Random& r, double d)
{
  return (r() & 1) != 0 ? d : -d;
}

Coordinates on_sphere(Random& r)
{
  const double z = 2 * unit(r) - 1, a = 6.283185307179586 * unit(r), s = std::sqrt(1 - z * z);
  return {.5 * s * std::cos(a), .5 * s * std::sin(a), .5 * z};
}

// What decides them: in that order, the stages behind the first filter.
const Family families[] = {
    {"cube",
     [](Random& r) {
       return Coordinates{unit(r), unit(r), unit(r)};
     }},
    {"small integers, corners of a box",
     [](Random& r) {
       return Coordinates{either_sign(r, .5), either_sign(r, .25), either_sign(r, .125)};
     }},
    {"doubles, corners of a box",
     [](Random& r) {
       return Coordinates{either_sign(r, .1), either_sign(r, .3), either_sign(r, .7)};
     }},
    {"doubles on a sphere", on_sphere},
    {"doubles on a sphere, and residues",
     [](Random& r) {
       Coordinates p = on_sphere(r);
       p[r() % 3] = 1e-12 * unit(r);
       return p;
     }},
    {"a box, wide numbers",
     [](Random& r) {
       return Coordinates{either_sign(r, .1), either_sign(r, .3), either_sign(r, .7e-15)};
     }},
};

Kernel::Point_3 point(const Coordinates& c)
{
  return {c[0], c[1], c[2]};
}

std::vector<Test> make_tests(const Family& family, std::size_t n)
{
  Random random(1);
  std::vector<Test> tests;
  for (std::size_t tries = 0; tests.size() < n && tries < 1000 * n; ++tries) {
    Test t;
    for (Coordinates& c : t.points)
      c = family.make_point(random);
    const auto orientation = CGAL::orientation(point(t.points[0]), point(t.points[1]),
                                               point(t.points[2]), point(t.points[3]));
    if (orientation == CGAL::COPLANAR ||
        std::find(t.points.begin(), t.points.begin() + 4, t.points[4]) != t.points.begin() + 4)
      continue;
    if (orientation == CGAL::NEGATIVE)
      std::swap(t.points[0], t.points[1]);
    tests.push_back(t);
  }
  if (tests.size() < n)
    throw std::runtime_error("no tests of " + family.name);
  return tests;
}

// The least processor time of all repetitions. `sign` is called with each test.
template <class Sign>
double nanoseconds(const std::vector<Test>& tests, std::size_t repetitions, const Sign& sign)
{
  volatile int sum = 0;
  double best = 1e300;
  for (std::size_t r = 0; r < repetitions; ++r) {
    const std::clock_t start = std::clock();
    for (int k = 0; k < 20; ++k)
      for (const Test& t : tests)
        sum = sum + sign(t);
    best = (std::min)(best, double(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return std::round(1e10 * best / (20. * double(tests.size()))) / 10;
}

#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER

// As wide as the determinant of integers of one digit.
using Boost_integer = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<320, 320, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked, void>,
    boost::multiprecision::et_off>;

int sign_by_boost(const Test& t)
{
  const auto vertices = t.vertices();
  const Exact_differences<4> exact_differences(vertices.data(), t.p());
  const Integer_differences<4> differences(exact_differences);
  if (!differences.has_one_digit())
    return 0;
  Row<Fixed_integer<2>> digits[4];
  differences.set_rows(digits);
  std::array<Row<Boost_integer>, 4> r;
  for (std::size_t k = 0; k < 4; ++k)
    r[k] = {digits[k].x.digits[0], digits[k].y.digits[0], digits[k].z.digits[0]};
  return Sphere_cofactors<Boost_integer>(r[0], r[1], r[2], r[3])
      .lifted(r[0], r[1], r[2], r[3])
      .sign();
}

#endif

// CGAL's perturbed predicates are protected.
struct Perturbing_triangulation : CGAL::Delaunay_triangulation_3<Kernel>
{
  using CGAL::Delaunay_triangulation_3<Kernel>::side_of_oriented_sphere;
};

ordered_json measure(const Family& family, std::size_t repetitions)
{
  const std::vector<Test> tests = make_tests(family, 1000);
  std::array<std::size_t, NUMBER_OF_EXACT_STAGES> stages = {};
  std::size_t first = 0, perturbed = 0;
  const auto first_sign = [](const Test& t) {
    return sphere_sign(row(t.points[0].data(), t.p()), row(t.points[1].data(), t.p()),
                       row(t.points[2].data(), t.p()), row(t.points[3].data(), t.p()));
  };
  const auto exact = [](const Test& t) {
    return exact_sign<Exact_sphere>(t.vertices().data(), t.p());
  };
  for (const Test& t : tests) {
    first += first_sign(t) != 0;
    ++stages[exact(t).stage];
    perturbed += exact(t).is_perturbed;
  }
  const Perturbing_triangulation cgal;
  ordered_json json = {
      {"points", family.name},
      {"decided_by_first_filter", double(first) / 1000},
      {"decided_by_stages_behind", comparison::by_exact_stage(stages, tests.size())},
      {"perturbed", double(perturbed) / 1000},
      {"ns_first_filter", nanoseconds(tests, repetitions, first_sign)},
      {"ns_double_double", nanoseconds(tests, repetitions,
                                       [](const Test& t) {
                                         return close_sphere_sign(
                                             Exact_differences<4>(t.vertices().data(), t.p()));
                                       })},
      {"ns_double_double_without_fma",
       nanoseconds(tests, repetitions,
                   [](const Test& t) {
                     return close_sphere_sign_with<Portable_products>(
                         Exact_differences<4>(t.vertices().data(), t.p()));
                   })},
      {"ns_stages_behind",
       nanoseconds(tests, repetitions, [&](const Test& t) { return exact(t).sign; })},
      {"ns_any_width",
       nanoseconds(
           tests, repetitions,
           [](const Test& t) { return wide_sign<Exact_sphere>(t.vertices().data(), t.p()).sign; })},
      {"ns_cgal_perturbed", nanoseconds(tests, repetitions, [&](const Test& t) {
         const auto point = [](const double* p) { return Kernel::Point_3(p[0], p[1], p[2]); };
         const auto v = t.vertices();
         return int(cgal.side_of_oriented_sphere(point(v[0]), point(v[1]), point(v[2]), point(v[3]),
                                                 point(t.p()), true));
       })}};
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_FIXED_INTEGER
  if (stages[HALF_DIGIT] + stages[ONE_DIGIT] == tests.size())
    json["ns_boost_integer"] = nanoseconds(tests, repetitions, sign_by_boost);
#endif
  return json;
}

} // namespace

int main(int argc, char** argv)
{
  std::size_t repetitions = 20;
  comparison::Program program("measure_predicates",
                              "Measures the stages of the in-sphere test, against CGAL's.");
  program.option("repetitions,r", repetitions, "N", "of each, of which the fastest counts");
  return program.run(argc, argv, [&](ordered_json& report) {
    for (const Family& family : families) {
      report["sphere_tests"].push_back(measure(family, repetitions));
      std::cerr << report["sphere_tests"].back().dump() << "\n";
    }
  });
}
