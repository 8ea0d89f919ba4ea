// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Points with weights next to CGAL's Regular_triangulation_3: cells, and the set of hidden points, of
// usual and hostile sets, by one thread and by many whose portions are so small that they meet all
// the time. See fuzz_campaign.h for the options.

#include "fuzz_campaign.h"
#include "hostile_points.h"
#include "hostile_weights.h"
#include "insertion_case.h" // to_string()

#include <CGAL/Delaunay_from_surface_3/arrays/arrays_of_built.h>
#include <CGAL/Delaunay_from_surface_3/core/build_regular.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Ordered_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Parallel_triangulation.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Thread_executor.h>
#include <CGAL/delaunay_3_arrays.h>
#include <CGAL/is_valid_delaunay_3_arrays.h>
#include <CGAL/regular_3_arrays.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace fuzz;
namespace core = CGAL::Delaunay_from_surface_3::core;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Regular = CGAL::Regular_triangulation_3<Kernel>;
using Arrays = CGAL::Delaunay_3_arrays<std::int32_t>;

// A point with its weight: equal ones cannot be told apart.
using Ball = std::array<double, 4>;
struct Outcome
{
  std::multiset<std::vector<Ball>> cells; // finite, of the highest dimension
  std::set<Ball> hidden;
};
bool operator==(const Outcome& a, const Outcome& b)
{
  return a.cells == b.cells && a.hidden == b.hidden;
}

Ball ball(const Coordinates& p, double w)
{
  return {p[0] + 0., p[1] + 0., p[2] + 0., w + 0.}; // no -0
}

Outcome outcome_of(const Regular& rt)
{
  Outcome outcome;
  const auto numbers = [](const Regular::Weighted_point& p) {
    return ball({p.x(), p.y(), p.z()}, p.weight());
  };
  const int d = rt.dimension();
  const auto& cells = rt.tds().cells(); // of any dimension
  for (auto c = cells.begin(); c != cells.end(); ++c) {
    std::vector<Ball> corners;
    for (int k = 0; k <= d; ++k)
      if (!rt.is_infinite(c->vertex(k)))
        corners.push_back(numbers(c->vertex(k)->point()));
    std::sort(corners.begin(), corners.end());
    if (int(corners.size()) == d + 1)
      outcome.cells.insert(corners);
    for (auto h = c->hidden_points_begin(); h != c->hidden_points_end(); ++h)
      outcome.hidden.insert(numbers(*h));
  }
  return outcome;
}

Outcome outcome_of(const Arrays& arrays, const Points& points, const Weights& weights)
{
  Outcome outcome;
  for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c) {
    std::vector<Ball> corners;
    for (int k = 0; k <= arrays.dimension(); ++k) {
      const auto v = std::size_t(arrays.vertices(c)[k]);
      corners.push_back(ball(points[v], weights[v]));
    }
    std::sort(corners.begin(), corners.end());
    outcome.cells.insert(corners);
  }
  for (std::size_t i = 0; i < points.size(); ++i)
    if (arrays.vertices_of_points()[i] < 0)
      outcome.hidden.insert(ball(points[i], weights[i]));
  return outcome;
}

class Source final : public core::Weighted_point_source
{
public:
  Source(const Points& points, const Weights& weights)
    : m_points(points)
    , m_weights(weights)
  {
  }
  core::Point_array points() override
  {
    return {m_points.empty() ? nullptr : m_points[0].data(), m_points.size()};
  }
  const double* weights() override { return m_weights.data(); }

private:
  const Points& m_points;
  const Weights& m_weights;
};

// By threads, in their own portions. The points span space.
Arrays by_threads(const Points& points, const Weights& weights, std::size_t threads,
                  const core::Parallel_rules& rules)
{
  Source source(points, weights);
  const core::Thread_executor executor(threads);
  core::Observer nobody;
  core::Ordered_complex<core::Weighted_vertex> built;
  core::begin_to_build(built, source, core::Build_options(), nobody, executor);
  core::Parallel_triangulation<core::Weighted_vertex> triangulation(built.complex, executor, rules);
  for (std::size_t first = 0; first < points.size();) {
    const std::size_t last = (std::min)(points.size(), first + triangulation.size_of_chunk(first));
    triangulation.insert_chunk(first, last, built.vertices, built.starting_cells(),
                               [](std::size_t) { return true; });
    first = last;
  }
  triangulation.finish();
  core::leave_out_hidden_vertices(built, true);
  built.outcome = core::Insertion_outcome::COMPLETE;
  built.show();
  return core::arrays_of_built<std::int32_t>(built, source, core::Alone());
}

// --- kinds of sets -------------------------------------------------------------------------------

struct Set
{
  Points points;
  Weights weights;
};

template <class Make>
Set set_of(std::size_t n, const Make& make)
{
  Set set;
  for (std::size_t i = 0; i < n; ++i) {
    const Ball b = make();
    set.points.push_back({b[0], b[1], b[2]});
    set.weights.push_back(b[3]);
  }
  return set;
}

// Weights up to `factor` times the square of the points' distance.
Set cube_with_weights(Random& r, std::size_t n, double factor)
{
  const double h = 1 / std::cbrt(double(n));
  return set_of(n, [&]() -> Ball {
    return {r.unit(), r.unit(), r.unit(), factor * h * h * r.unit()};
  });
}

// Balls along a random walk, with the three decimals that files of molecules have.
Set chain(Random& r, std::size_t n)
{
  Ball at = {};
  const double half = std::cbrt(double(n)) * 1.4;
  return set_of(n, [&]() -> Ball {
    for (std::size_t c = 0; c < 3; ++c)
      at[c] = std::round(1000 * std::clamp(at[c] + 1.5 * r.signed_unit(), -half, half)) / 1000;
    const double radius = std::array<double, 3>{{1.7, 1.55, 1.52}}[r.below(3)];
    at[3] = radius * radius;
    return at;
  });
}

// On a lattice of `side` points, most of them several times if there are few.
Set lattice_with_weights(Random& r, std::size_t n, int side, int most)
{
  return set_of(n, [&]() -> Ball {
    const int x = r.between(1, side), y = r.between(1, side), z = r.between(1, side);
    return {double(x), double(y), double(z), double(r.between(0, most))};
  });
}

// Lifted to a hyperplane, all or nearly all.
Set orthogonal_set(Random& r, std::size_t n)
{
  const std::size_t share = 1 + r.below(10);
  Set set = lattice_with_weights(r, n, 9, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const Coordinates& p = set.points[i];
    set.weights[i] = p[0] * p[0] + p[1] * p[1] + p[2] * p[2] + double(r.one_in(share + 1));
  }
  return set;
}

// Copies of one point with growing weights, among others.
Set growing_copies(Random& r, std::size_t n)
{
  Set set = cube_with_weights(r, n, .5);
  for (std::size_t i = n / 2; i < n; ++i) {
    set.points[i] = set.points[0];
    set.weights[i] = 1e-3 * double(i);
  }
  return set;
}

// Four points far around, with weights that hide all others.
Set hidden_but_four(Random& r, std::size_t n)
{
  Set set = cube_with_weights(r, n, 1);
  for (std::size_t c = 0; c < 4 && c < n; ++c) {
    set.points[n - 1 - c] = {c == 1 ? 9. : -1., c == 2 ? 9. : -1., c == 3 ? 9. : -1.};
    set.weights[n - 1 - c] = 1000;
  }
  return set;
}

Set heaviest_last(Random& r, std::size_t n)
{
  Set set = cube_with_weights(r, n, 1);
  set.weights.back() = r.unit();
  return set;
}

Set hostile(Random& r, std::size_t n)
{
  Set set;
  set.points = hostile_points(categories[r.below(std::size(categories))], r, n);
  const Weighting& weighting = weightings[r.below(number_of_weightings)];
  set.weights = hostile_weights(weighting, r, set.points);
  return set;
}

struct Kind
{
  const char* name;
  Set (*make)(Random&, std::size_t);
};
const Kind kinds[] = {
    {"weights 0", [](Random& r, std::size_t n) { return cube_with_weights(r, n, 0); }},
    {"small weights", [](Random& r, std::size_t n) { return cube_with_weights(r, n, .5); }},
    {"large weights", [](Random& r, std::size_t n) { return cube_with_weights(r, n, 9); }},
    {"chain", chain},
    {"equal lattice", [](Random& r, std::size_t n) { return lattice_with_weights(r, n, 12, 0); }},
    {"lattice", [](Random& r, std::size_t n) { return lattice_with_weights(r, n, 12, 5); }},
    {"copies", [](Random& r, std::size_t n) { return lattice_with_weights(r, n, 4, 3); }},
    {"orthogonal", orthogonal_set},
    {"growing copies", growing_copies},
    {"hidden but four", hidden_but_four},
    {"heaviest last", heaviest_last},
    {"hostile", hostile},
    {"hostile", hostile},
};

class Weighted : public Subject
{
  struct Case
  {
    const char* kind;
    Set set;
    std::size_t threads;
    core::Parallel_rules rules;
  };

  static Case make_case(Seed seed)
  {
    Random r(seed);
    const Kind& kind = kinds[r.below(std::size(kinds))];
    const std::size_t n = 1 + r.below(r.one_in(8) ? 2000 : r.one_in(3) ? 12 : 150);
    Case c = {kind.name, kind.make(r, n), 2 + r.below(6), {}};
    c.rules = {4 + r.below(60), 1 + r.below(16), 1 + r.below(16)};
    return c;
  }

  static Set part_of(const Set& set, const Indices& parts)
  {
    Set part;
    for (const std::size_t i : parts) {
      part.points.push_back(set.points[i]);
      part.weights.push_back(set.weights[i]);
    }
    return part;
  }

  static Regular by_cgal(const Set& set)
  {
    std::vector<Regular::Weighted_point> points;
    for (std::size_t i = 0; i < set.points.size(); ++i) {
      const Coordinates& p = set.points[i];
      points.emplace_back(Kernel::Point_3(p[0], p[1], p[2]), set.weights[i]);
    }
    return Regular(points.begin(), points.end());
  }

public:
  std::size_t number_of_parts(Seed seed) const override
  {
    return make_case(seed).set.points.size();
  }

  std::string check(Seed seed, const Indices& parts, Tally& tally) const override
  {
    const Case c = make_case(seed);
    const Set set = part_of(c.set, parts);
    const Regular rt = by_cgal(set);
    const Outcome expected = outcome_of(rt);
    const Arrays arrays = CGAL::regular_3_arrays(set.points, set.weights);
    tally.count(std::string("kind: ") + c.kind);
    tally.count("points", set.points.size());
    tally.count("hidden points", expected.hidden.size());
    if (arrays.dimension() != rt.dimension())
      return "another dimension";
    if (!(outcome_of(arrays, set.points, set.weights) == expected))
      return "not what CGAL makes";
    if (!CGAL::is_valid_delaunay_3_arrays(arrays, set.points, set.weights))
      return "not valid";
    if (arrays.dimension() == 3 &&
        !(outcome_of(by_threads(set.points, set.weights, c.threads, c.rules), set.points,
                     set.weights) == expected))
      return "not what CGAL makes, by threads";
    return seed % 4 != 0 || has_bytes_of_delaunay(set.points) ? "" : "weights that are 0 matter";
  }

  std::string description(Seed seed, const Indices& parts) const override
  {
    const Case c = make_case(seed);
    const Set set = part_of(c.set, parts);
    std::string text = std::string(c.kind) + ", " + std::to_string(c.threads) + " threads" +
                       to_string(set.points) + "\nweights:";
    for (const double w : set.weights) {
      char number[40];
      std::snprintf(number, sizeof(number), " %a", w);
      text += number;
    }
    return text;
  }

private:
  static bool has_bytes_of_delaunay(const Points& points)
  {
    const Arrays plain = CGAL::delaunay_3_arrays(points);
    const Arrays same = CGAL::regular_3_arrays(points, Weights(points.size(), 0.));
    bool is_same = plain.number_of_cells() == same.number_of_cells();
    for (std::size_t c = 0; is_same && c < plain.number_of_cells(); ++c)
      for (int k = 0; k <= plain.dimension(); ++k)
        is_same = is_same && plain.vertices(c)[k] == same.vertices(c)[k] &&
                  plain.neighbors(c)[k] == same.neighbors(c)[k];
    return is_same;
  }
};

} // namespace

int main(int argc, char** argv)
{
  try {
    const Weighted weighted;
    return Campaign(weighted, argc, argv).run();
  } catch (const std::exception& e) {
    std::fprintf(stderr, "fuzz_regular: %s\n", e.what());
    return EXIT_FAILURE;
  }
}
