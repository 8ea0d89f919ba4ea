// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_PARALLEL_CASE_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_PARALLEL_CASE_H

// Points, with or without weights, inserted by many workers into the compact kernel, next to the
// same points inserted by one.

#include "Thread_executor.h"

#include <CGAL/Delaunay_from_surface_3/core/kernel/Insert_alone.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Ordered_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/is_valid.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Parallel_triangulation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace tests {

namespace DFS = CGAL::Delaunay_from_surface_3;
using Coordinates = std::array<double, 3>;
using DFS::internal::Compact_vertex;
using DFS::internal::Id;
using DFS::internal::Weighted_vertex;
using Complex = DFS::internal::Compact_complex<Compact_vertex>;
template <class Vertex>
using Coordinates_of = typename DFS::internal::Compact_complex<Vertex>::Coordinates_of_point;
using Ball = Coordinates_of<Weighted_vertex>;

// --- points ------------------------------------------------------------------------------------

inline std::vector<Coordinates> points_of(const char* kind, std::size_t n, unsigned seed)
{
  std::mt19937 random(seed);
  const auto real = [&] { return std::uniform_real_distribution<>(-1, 1)(random); };
  const auto integer = [&](int m) {
    return double(std::uniform_int_distribution<>(-m, m)(random));
  };
  const std::string name = kind;
  std::vector<Coordinates> points;
  while (points.size() < n) {
    const double t = double(points.size()) / double(n);
    if (name == "cube")
      points.push_back({real(), real(), real()});
    else if (name == "duplicates")
      points.push_back({integer(4), integer(4), integer(4)});
    else if (name == "sphere") {
      const double x = real(), y = real(), z = real(), r = std::hypot(x, y, z);
      points.push_back({x / r, y / r, z / r});
    } else if (name == "lattice")
      points.push_back({integer(9), integer(9), integer(9)});
    else if (name == "moment curve")
      points.push_back({t, t * t, t * t * t});
    else // a hub in the middle of a cylinder
      points.push_back(points.size() == 5
                           ? Coordinates{0, 0, 5}
                           : Coordinates{std::cos(700 * t), std::sin(700 * t), 10 * t});
  }
  std::shuffle(points.begin(), points.end(), random);
  return points;
}

// Every sixteenth point is heavy, the heavier the later it comes. In a cube they swallow or hide
// three of four points, and one walk of fifteen is to start at a dead cell.
inline std::vector<Ball> balls_of(const char* kind, std::size_t n, unsigned seed)
{
  const bool are_integers = std::string(kind) == "lattice" || std::string(kind) == "duplicates";
  std::vector<Ball> balls;
  for (const Coordinates& p : points_of(kind, n, seed)) {
    const double t = balls.size() % 16 == 0 ? double(balls.size()) / double(n) : 0;
    balls.push_back({p[0], p[1], p[2], are_integers ? std::floor(27 * t * t) : .3 * t * t});
  }
  return balls;
}

// --- one triangulation -------------------------------------------------------------------------

template <class Vertex = Compact_vertex>
struct Subject
{
  DFS::internal::Compact_complex<Vertex> complex;
  std::vector<Id> vertex_of;
  std::vector<std::size_t> halves;
  Id any_vertex = 0;

  explicit Subject(const std::vector<Coordinates_of<Vertex>>& points)
    : complex(points.size(), [&](std::size_t i) { return points[i]; })
    , vertex_of(points.size(), 0)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
      halves.push_back(i / 2);
    any_vertex = DFS::internal::start_complex(
        DFS::internal::starting_simplex(points.size(),
                                        [&](std::size_t i) { return points[i].data(); }),
        complex, vertex_of);
  }

  // The finite and infinite cells, each point by the smallest number of its duplicates.
  std::vector<std::array<Id, 4>> cells() const
  {
    std::map<Id, Id> smallest{{0, 0}};
    for (std::size_t i = vertex_of.size(); i-- > 0;)
      smallest[vertex_of[i]] = Id(i + 1);
    std::vector<std::array<Id, 4>> result;
    for (std::size_t c = 0; c < complex.cells_end(); ++c)
      if (const auto& cell = complex.cell(c); !Complex::is_dead(cell)) {
        std::array<Id, 4> v;
        for (unsigned k = 0; k < 4; ++k)
          v[k] = smallest[cell.v[k]];
        std::sort(v.begin(), v.end());
        result.push_back(v);
      }
    std::sort(result.begin(), result.end());
    return result;
  }

  // Whether is_there(v) tells which vertices cells have: others are hidden.
  template <class IsThere>
  bool knows_hidden_vertices(const IsThere& is_there) const
  {
    std::vector<bool> has_cell(complex.vertices_end(), false);
    for (std::size_t c = 0; c < complex.cells_end(); ++c)
      for (unsigned k = 0; !Complex::is_dead(complex.cell(c)) && k < 4; ++k)
        has_cell[complex.cell(c).v[k]] = true;
    return std::all_of(vertex_of.begin(), vertex_of.end(),
                       [&](Id v) { return v == 0 || is_there(v) == has_cell[v]; });
  }
  bool knows_hidden_vertices() const
  {
    return knows_hidden_vertices([this](Id v) { return complex.is_in_cell(v); });
  }
};

// Starts where the point in half the place is; a copy for each worker.
template <class Vertex>
struct Start_at_half : DFS::internal::Starting_cells<Vertex>
{
  explicit Start_at_half(const Subject<Vertex>& subject)
    : DFS::internal::Starting_cells<Vertex>(subject.complex, subject.vertex_of,
                                            subject.halves.data(), subject.any_vertex)
  {
  }
};

template <class Vertex>
void insert_by_one(Subject<Vertex>& subject)
{
  DFS::internal::Inserter<DFS::internal::Alone_with_complex<Vertex>> inserter(subject.complex);
  Start_at_half<Vertex> hints(subject);
  for (std::size_t i = 0; i < subject.vertex_of.size(); ++i) {
    if (subject.vertex_of[i] != 0)
      continue;
    const Id p = Complex::vertex_of_point(i);
    const auto location = inserter.walk(p, hints.start(i), DFS::internal::Read_alone());
    subject.vertex_of[i] = location.vertex != 0 ? location.vertex : p;
    if (location.vertex == 0) {
      inserter.dig(p, location.cell);
      inserter.fill(p);
    } else if (location.vertex == p) // hidden
      subject.complex.vertex(p).cell = location.cell;
    hints.after_update(i, subject.vertex_of[i]);
  }
}

template <class Vertex = Compact_vertex>
std::vector<std::array<Id, 4>> cells_by_one(const std::vector<Coordinates_of<Vertex>>& points)
{
  Subject<Vertex> subject(points);
  insert_by_one(subject);
  return subject.cells();
}

struct Parallel_outcome
{
  bool is_valid;
  std::vector<std::array<Id, 4>> cells;
  std::size_t clashes, put_off;
};

struct Never_stop
{
  bool operator()(std::size_t) const { return true; }
};

// In rounds that double. `go_further` returns true.
template <class Vertex = Compact_vertex, class Worker = DFS::internal::Insertion_worker<Vertex>,
          class Hints = Start_at_half<Vertex>, class Executor = Thread_executor,
          class GoFurther = Never_stop>
Parallel_outcome insert_by_many(const std::vector<Coordinates_of<Vertex>>& points,
                                const Executor& executor = Executor(),
                                const DFS::internal::Parallel_rules& rules = {30, 8, 8},
                                const GoFurther& go_further = GoFurther())
{
  Subject<Vertex> subject(points);
  DFS::internal::Parallel_triangulation<Vertex, Worker> triangulation(subject.complex, executor,
                                                                      rules);
  const Hints hints(subject);
  for (std::size_t first = 0, last = 30; first < points.size(); first = last, last *= 2) {
    last = (std::min)(last, points.size());
    triangulation.insert_chunk(first, last, subject.vertex_of, hints, go_further);
  }
  triangulation.finish();
  return {subject.complex.is_valid() && DFS::internal::is_delaunay(subject.complex) &&
              subject.knows_hidden_vertices(),
          subject.cells(), triangulation.counts().clashes, triangulation.counts().put_off};
}

} // namespace tests

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_PARALLEL_CASE_H
