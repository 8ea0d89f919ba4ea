// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Points in periodic boxes, with weights or without, next to CGAL's triangulation of many copies with
// exact numbers, and larger sets next to CGAL's Periodic_3_Delaunay_triangulation_3; by one thread and
// by more. Slabs and wires lack periods. See fuzz_campaign.h for the options.

#include "Thread_executor.h"
#include "check_copy_signs.h"
#include "fuzz_campaign.h"
#include "hostile_points.h"
#include "hostile_weights.h"
#include "insertion_case.h" // to_string()
#include "periodic_cells.h"

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/arrays/arrays_of_periodic.h>
#include <CGAL/Delaunay_from_surface_3/core/build_periodic.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/is_valid.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/periodic_delaunay_3_arrays.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_traits_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace fuzz;
namespace core = CGAL::Delaunay_from_surface_3::core;
using tests::periodic::Arrays;
using tests::periodic::Box;
using tests::periodic::Outcome;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Set
{
  std::string kind;
  Points points;
  Weights weights; // none if empty
  Box box;
};

double finite(double period)
{
  return std::isfinite(period) ? period : 1;
}

// --- boxes ---------------------------------------------------------------------------------------

double period(Random& r)
{
  const double periods[] = {1, 1, 10, 6.283185307179586, 1. / 3, .1, 8};
  return r.one_in(4) ? .5 + r.unit() : periods[r.below(std::size(periods))];
}

Box box(Random& r, bool is_cube)
{
  const double L = period(r);
  Box box = {L, L, L};
  if (is_cube)
    return box;
  if (r.one_in(3)) // of few, or all, bits
    for (double& edge : box)
      edge = r.one_in(2) ? L * double(r.between(1, 4)) : L * (1 + 2 * r.unit());
  if (r.one_in(12))
    box[r.below(3)] *= double(r.between(4, 9));
  if (r.one_in(3))
    box[r.below(3)] = infinity;
  if (r.one_in(6))
    box[r.below(3)] = infinity;
  if (r.one_in(40))
    box = {infinity, infinity, infinity};
  return box;
}

// --- points: as shares of the box, at first ------------------------------------------------------

Points shares(Random& r, std::size_t n, std::string& kind)
{
  const int side = r.between(1, 5);
  const auto on_lattice = [&] {
    return by_coordinate(n, [&] { return double(r.between(0, side)) / double(side); });
  };
  switch (r.below(11)) {
  case 0:
    kind = "lattice";
    return on_lattice();
  case 1: {
    kind = "noisy lattice";
    const int e = r.between(-130, -20);
    Points points = on_lattice();
    for (Coordinates& p : points)
      for (double& x : p)
        x += std::ldexp(r.signed_unit(), e);
    return points;
  }
  case 2: {
    kind = "cluster";
    const double size = std::ldexp(1., -r.between(1, r.one_in(4) ? 500 : 30));
    const bool is_at_corner = r.one_in(2);
    return by_coordinate(n, [&] { return size * r.signed_unit() + (is_at_corner ? 0 : .5); });
  }
  case 3: {
    kind = "plane";
    const std::size_t axis = r.below(3);
    Points points = r.one_in(2) ? on_lattice() : by_coordinate(n, [&] { return r.unit(); });
    const int e = r.between(-60, -1);
    const bool is_flat = r.one_in(2);
    for (Coordinates& p : points)
      p[axis] = is_flat ? .25 : std::ldexp(r.unit(), e);
    return points;
  }
  case 4: {
    kind = "line";
    const Coordinates along = {double(r.between(-1, 1)), double(r.between(-1, 1)), 1};
    return repeated(n, [&] {
      const double t = r.one_in(2) ? r.unit() : r.between(0, 8) / 8.;
      return Coordinates{t * along[0], t * along[1], t * along[2]};
    });
  }
  case 5:
    kind = "walls";
    return by_coordinate(n, [&] { return r.one_in(2) ? double(r.below(2)) : r.unit(); });
  case 6:
    kind = "ulps";
    return by_coordinate(n, [&] {
      double x = double(r.between(0, side)) / double(side);
      for (int steps = r.between(0, 2); steps > 0; --steps)
        x = std::nextafter(x, r.one_in(2) ? 9 : -9);
      return x;
    });
  case 7:
    kind = "all sizes";
    return by_coordinate(n, [&] {
      return r.one_in(3) ? r.unit()
                         : std::ldexp(r.signed_unit(), -r.between(0, r.one_in(3) ? 1074 : 70));
    });
  case 8: {
    kind = "dyadic";
    const int bits = r.between(1, 30);
    return by_coordinate(
        n, [&] { return std::ldexp(double(r.below(std::size_t(1) << bits)), -bits); });
  }
  default:
    kind = "random";
    return by_coordinate(n, [&] { return r.unit(); });
  }
}

Weights weights(Random& r, const Points& points, const Box& box, std::string& kind)
{
  const double L = (std::min)({finite(box[0]), finite(box[1]), finite(box[2])});
  Weights w;
  switch (r.below(7)) {
  case 0:
    kind += ", equal weights";
    return Weights(points.size(), L);
  case 1: {
    kind += ", few weights";
    const double unit = L * L / double(r.between(1, 64));
    return by_point(points, [&](const auto&) { return unit * double(r.between(0, 3)); });
  }
  case 2: {
    kind += ", lifted";
    return by_point(points, [&](const auto& p) {
      return p[0] * p[0] + p[1] * p[1] + p[2] * p[2] + (r.one_in(3) ? L * L / 64 * r.unit() : 0);
    });
  }
  case 3: {
    kind += ", one heavy";
    w = Weights(points.size(), 0.);
    w[r.below(w.size())] = L * L * std::ldexp(r.unit(), r.between(-6, 3));
    return w;
  }
  case 4: {
    kind += ", weights of all sizes";
    return by_point(points, [&](const auto&) {
      return L * L * std::ldexp(r.signed_unit(), r.between(-80, 10));
    });
  }
  default: {
    kind += ", weights";
    const double most = L * L * std::ldexp(1., -r.between(0, 14));
    return by_point(points, [&](const auto&) { return most * r.unit(); });
  }
  }
}

std::size_t copies_that_may_matter(const Box& box)
{
  double diagonal = 0, copies = 1;
  for (const double L : box)
    diagonal = std::isfinite(L) ? std::hypot(diagonal, L) : diagonal;
  for (const double L : box)
    copies *= std::isfinite(L) ? 2 * std::ceil(diagonal / L + 1e-9) + 1 : 1;
  return std::size_t(copies);
}

Set make_set(Seed seed, bool& by_cgal)
{
  Random r(seed);
  Set set;
  by_cgal = r.one_in(5);
  set.box = box(r, by_cgal);
  const std::size_t most =
      by_cgal ? (r.one_in(5) ? 400 : 30) : 1 + 1200 / copies_that_may_matter(set.box);
  const std::size_t n = 1 + r.below((std::min)(most, std::size_t(r.one_in(4) ? 400 : 20)));
  set.points = shares(r, n, set.kind);
  const bool is_shuffled = r.one_in(2);
  for (std::size_t i = 0; is_shuffled && n > 1 && i < n; ++i)
    if (r.one_in(4))
      set.points[i] = set.points[r.below(n)]; // a duplicate, perhaps of another place
  const bool is_centered = !by_cgal && r.one_in(3), is_far = !by_cgal && r.one_in(4);
  for (Coordinates& p : set.points)
    for (std::size_t a = 0; a < 3; ++a) {
      const double L = finite(set.box[a]);
      p[a] *= L;
      if (by_cgal) {
        p[a] = p[a] < 0 ? p[a] + L : p[a];
        p[a] = p[a] >= L ? 0. : p[a];
      }
      if (is_centered && r.one_in(8))
        p[a] = -p[a];
      if (is_far && r.one_in(3) && std::isfinite(set.box[a]))
        p[a] += L * r.between(-3000, 3000);
    }
  if (is_centered)
    for (Coordinates& p : set.points)
      for (std::size_t a = 0; a < 3; ++a)
        p[a] -= finite(set.box[a]) / 2;
  if (!by_cgal && r.one_in(2))
    set.weights = weights(r, set.points, set.box, set.kind);
  if (!by_cgal && set.weights.empty() && r.one_in(10)) { // of another size
    const double factor =
        std::ldexp(1., r.one_in(2) ? r.between(-1000, -100) : r.between(100, 1000));
    set.points = times(set.points, factor);
    for (double& L : set.box)
      L *= factor;
  }
  return set;
}

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Periodic_3_Delaunay_triangulation_traits_3<Kernel>;
using Periodic = CGAL::Periodic_3_Delaunay_triangulation_3<Traits>;

Outcome outcome_by_cgal(const Set& set)
{
  std::vector<Kernel::Point_3> points;
  for (const Coordinates& p : set.points)
    points.emplace_back(p[0], p[1], p[2]);
  const Periodic tr(points.begin(), points.end(),
                    Traits::Iso_cuboid_3(0, 0, 0, set.box[0], set.box[1], set.box[2]));
  return tests::periodic::outcome_of_periodic(tr, set.points);
}

// The arrays, made step by step, so that all cells can be looked at, also those far from home.
template <bool has_weight>
Arrays arrays_of(const Set& set, const core::Executor& executor, std::string& mistake)
{
  core::Observer nobody;
  const core::Point_array points(set.points[0].data(), set.points.size());
  core::Built_in_box built =
      core::build_in_box(points, has_weight ? set.weights.data() : nullptr, set.box.data(),
                         core::Build_options(), nobody, executor);
  const auto& complex =
      static_cast<core::Ordered_complex<core::Copy_vertex<has_weight>>&>(*built.built).complex;
  if (built.built->has_started() && set.points.size() < 100) {
    auto unmoved = complex.all_own_coordinates().copies; // they were moved to the result
    auto& own = const_cast<std::vector<core::Periodic_copy>&>(complex.all_own_coordinates().copies);
    own.assign(built.copies, built.copies + built.number_of_copies);
    if (!complex.is_valid())
      mistake = "not valid";
    own = unmoved;
  }
  return core::arrays_of_box<std::int32_t>(built, points, set.box);
}

Arrays arrays_of(const Set& set, const core::Executor& executor, std::string& mistake)
{
  return set.weights.empty() ? arrays_of<false>(set, executor, mistake)
                             : arrays_of<true>(set, executor, mistake);
}

class In_boxes : public Subject
{
  static Set part_of(const Set& set, const Indices& parts)
  {
    Set part = {set.kind, {}, {}, set.box};
    for (const std::size_t i : parts) {
      part.points.push_back(set.points[i]);
      if (!set.weights.empty())
        part.weights.push_back(set.weights[i]);
    }
    return part;
  }

public:
  std::size_t number_of_parts(Seed seed) const override
  {
    bool by_cgal = false;
    return make_set(seed, by_cgal).points.size();
  }

  std::string check(Seed seed, const Indices& parts, Tally& tally) const override
  {
    for (Seed k = 0; k < 20; ++k) {
      const std::string mistake = mistake_in_copies(20 * seed + k, tally);
      if (!mistake.empty())
        return mistake + ", case " + std::to_string(20 * seed + k);
    }
    bool by_cgal = false;
    const Set set = part_of(make_set(seed, by_cgal), parts);
    tally.count("kind: " + set.kind);
    tally.count("points", set.points.size());
    const auto by_many_copies = [&] {
      return tests::periodic::by_many_copies(set.points, set.weights, set.box);
    };
    Outcome expected = by_cgal ? outcome_by_cgal(set) : by_many_copies();
    tally.count("hidden or equal points", set.points.size() - expected.visible.size());
    std::string mistake;
    Arrays arrays;
    try {
      arrays = arrays_of(set, core::Alone(), mistake);
    } catch (const CGAL::Surface_input_error& e) {
      tally.count("refused as flat");
      return expected.cells.empty() ? "" : std::string("refused: ") + e.what();
    }
    tally.count("copies", arrays.number_of_copies());
    if (expected.cells.empty())
      return "it is not refused";
    if (mistake.empty())
      mistake = mistake_in(arrays, expected, set.points, set.weights, set.box);
    if (!mistake.empty() && by_cgal) { // CGAL's may be the one that is wrong
      expected = by_many_copies();
      mistake = mistake_in(arrays, expected, set.points, set.weights, set.box);
      tally.count("CGAL's periodic triangulation is another");
    }
    if (mistake.empty() && seed % 4 == 0) {
      arrays = arrays_of(set, tests::Thread_executor(2 + seed % 3), mistake);
      mistake = mistake_in(arrays, expected, set.points, set.weights, set.box);
      mistake += mistake.empty() ? "" : ", by threads";
    }
    return mistake;
  }

  std::string description(Seed seed, const Indices& parts) const override
  {
    bool by_cgal = false;
    const Set set = part_of(make_set(seed, by_cgal), parts);
    char numbers[200];
    std::snprintf(numbers, sizeof(numbers), ", box %a %a %a", set.box[0], set.box[1], set.box[2]);
    std::string text = set.kind + numbers + to_string(set.points) + "\nweights:";
    for (const double w : set.weights) {
      std::snprintf(numbers, sizeof(numbers), " %a", w);
      text += numbers;
    }
    return text;
  }
};

} // namespace

int main(int argc, char** argv)
{
  try {
    const In_boxes in_boxes;
    return Campaign(in_boxes, argc, argv).run();
  } catch (const std::exception& e) {
    std::fprintf(stderr, "fuzz_periodic: %s\n", e.what());
    return EXIT_FAILURE;
  }
}
