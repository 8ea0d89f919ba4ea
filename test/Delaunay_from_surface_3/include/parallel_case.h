// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_PARALLEL_CASE_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_PARALLEL_CASE_H

// Points inserted by many workers into the compact kernel, next to the same points inserted by one.

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
using Complex = DFS::internal::Compact_complex<Compact_vertex>;

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

// --- one triangulation -------------------------------------------------------------------------

// Starts where the point in half the place is; a copy for each worker.
struct Start_at_half
{
  const Complex* complex;
  const std::vector<Id>* vertex_of;
  Id any_vertex;

  Id start(std::size_t i) const
  {
    while (i > 0 && DFS::internal::load_relaxed((*vertex_of)[i]) == 0)
      i /= 2;
    const Id v = DFS::internal::load_relaxed((*vertex_of)[i]);
    return DFS::internal::load_relaxed(complex->vertex(v != 0 ? v : any_vertex).cell);
  }
  void after_update(std::size_t, Id) const {}
};

template <class Vertex = Compact_vertex>
struct Subject
{
  DFS::internal::Compact_complex<Vertex> complex;
  std::vector<Id> vertex_of;
  Id any_vertex = 0;

  explicit Subject(const std::vector<Coordinates>& points)
    : complex(points.size(), [&](std::size_t i) { return points[i]; })
    , vertex_of(points.size(), 0)
  {
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
};

inline std::vector<std::array<Id, 4>> cells_by_one(const std::vector<Coordinates>& points)
{
  Subject<> subject(points);
  DFS::internal::Inserter<DFS::internal::Alone_with_complex<Compact_vertex>> inserter(
      subject.complex);
  const Start_at_half hints{&subject.complex, &subject.vertex_of, subject.any_vertex};
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (subject.vertex_of[i] != 0)
      continue;
    const Id p = Complex::vertex_of_point(i);
    const auto location = inserter.walk(p, hints.start(i), DFS::internal::Read_alone());
    subject.vertex_of[i] = location.vertex != 0 ? location.vertex : p;
    if (location.vertex == 0) {
      inserter.dig(p, location.cell);
      inserter.fill(p);
    }
  }
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
template <class Worker = DFS::internal::Insertion_worker<Compact_vertex>,
          class Executor = Thread_executor, class GoFurther = Never_stop>
Parallel_outcome insert_by_many(const std::vector<Coordinates>& points,
                                const Executor& executor = Executor(),
                                const DFS::internal::Parallel_rules& rules = {30, 8, 8},
                                const GoFurther& go_further = GoFurther())
{
  Subject<> subject(points);
  DFS::internal::Parallel_triangulation<Compact_vertex, Worker> triangulation(subject.complex,
                                                                              executor, rules);
  const Start_at_half hints{&subject.complex, &subject.vertex_of, subject.any_vertex};
  for (std::size_t first = 0, last = 30; first < points.size(); first = last, last *= 2) {
    last = (std::min)(last, points.size());
    triangulation.insert_chunk(first, last, subject.vertex_of, hints, go_further);
  }
  triangulation.finish();
  return {subject.complex.is_valid() && DFS::internal::is_delaunay(subject.complex),
          subject.cells(), triangulation.counts().clashes, triangulation.counts().put_off};
}

} // namespace tests

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_PARALLEL_CASE_H
