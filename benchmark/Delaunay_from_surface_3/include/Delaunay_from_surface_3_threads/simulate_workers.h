// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_BENCHMARK_SIMULATE_WORKERS_H
#define DELAUNAY_FROM_SURFACE_3_BENCHMARK_SIMULATE_WORKERS_H

// How often many workers get into each other's way, found by one thread that plays them all: in
// turn each writes the star whose zone it announced before, and announces the next, so that every
// zone stays announced while all others act. Wherever many cores can be had they clash less: their
// insertions overlap for a part of the time only.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Ordered_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Insertion_worker.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Parallel_triangulation.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

namespace threads {

class Simulation
{
  using Id = CGAL::Delaunay_from_surface_3::internal::Id;
  using Vertex = CGAL::Delaunay_from_surface_3::internal::Compact_vertex;
  using Point = CGAL::Epick::Point_3;
  using Complex = CGAL::Delaunay_from_surface_3::internal::Compact_complex<Vertex>;
  using Worker = CGAL::Delaunay_from_surface_3::internal::Insertion_worker<Vertex>;
  using Try = CGAL::Delaunay_from_surface_3::internal::Insertion_try;

public:
  // Of a plan's points; `points` are in its order.
  Simulation(const std::vector<Point>& points,
             const CGAL::Delaunay_from_surface_3::Insertion_order& plan, unsigned workers)
    : m_plan(plan)
    , m_complex(points.size(),
                [&](std::size_t i) {
                  return std::array<double, 3>{points[i].x(), points[i].y(), points[i].z()};
                })
    , m_shared(m_complex, workers)
    , m_vertex_of(points.size(), 0)
  {
    m_any_vertex = CGAL::Delaunay_from_surface_3::internal::start_complex(
        CGAL::Delaunay_from_surface_3::internal::starting_simplex(
            m_vertex_of.size(),
            [&](std::size_t i) {
              return m_complex.exact_coordinates(Complex::vertex_of_point(i));
            }),
        m_complex, m_vertex_of);
    m_shared.make_room(24 * points.size()); // it cannot grow while zones are announced
    for (unsigned t = 0; t < workers; ++t)
      m_workers.push_back(std::make_unique<Worker>(m_shared, t));
  }

  // Inserts all points; returns for each round the number of insertions that were rolled back.
  std::vector<std::size_t> run()
  {
    std::vector<std::size_t> rolled_back;
    std::size_t first = 0;
    for (const std::size_t last : m_plan.round_ends) {
      rolled_back.push_back(round(first, last));
      first = last;
    }
    return rolled_back;
  }

private:
  // Deals out a round as Parallel_triangulation does a chunk.
  std::size_t round(std::size_t first, std::size_t last)
  {
    namespace internal = CGAL::Delaunay_from_surface_3::internal;
    const internal::Parallel_rules rules;
    std::size_t number = (std::min)(m_workers.size(), (last - first) / rules.points_per_worker);
    number = first < rules.first_points || number == 0 ? 1 : number;
    internal::Shares shares(first, last, number);
    std::vector<std::size_t> announced(number, none), put_off;
    std::vector<internal::Shares::Range> batches(number, {0, 0});
    std::size_t rolled_back = 0;
    for (bool is_active = true; is_active;) {
      is_active = false;
      for (std::size_t t = 0; t < number; ++t) {
        const auto clash = [&](std::size_t i) {
          ++rolled_back;
          put_off.push_back(i);
        };
        if (announced[t] != none) {
          if (finish(t, announced[t]) == Try::CLASH)
            clash(announced[t]);
          announced[t] = none;
        }
        if (batches[t].first == batches[t].second)
          batches[t] = shares.take(t, rules.batch);
        if (batches[t].first == batches[t].second)
          continue;
        is_active = true;
        const std::size_t i = batches[t].first++;
        if (const Try outcome = announce(t, i); outcome == Try::CLASH)
          clash(i);
        else if (outcome == Try::DONE)
          announced[t] = i;
      }
    }
    for (const std::size_t i : put_off)
      if (announce(0, i) == Try::DONE)
        finish(0, i);
    return rolled_back;
  }

  Try announce(std::size_t t, std::size_t i)
  {
    if (m_vertex_of[i] != 0)
      return Try::PRESENT;
    Id present = Complex::vertex_of_point(i);
    const Try outcome = m_workers[t]->announce(present, start(i), present,
                                               (std::numeric_limits<std::size_t>::max)());
    if (outcome == Try::PRESENT)
      m_vertex_of[i] = present;
    if (outcome == Try::NO_CELLS)
      throw std::length_error("the simulation has too few cells");
    return outcome;
  }

  Try finish(std::size_t t, std::size_t i)
  {
    const Try outcome = m_workers[t]->write(Complex::vertex_of_point(i));
    if (outcome == Try::DONE)
      m_vertex_of[i] = Complex::vertex_of_point(i);
    return outcome;
  }

  Id start(std::size_t i) const
  {
    std::size_t place = m_plan.starting_places[i];
    while (m_vertex_of[place] == 0 && place != 0)
      place = m_plan.starting_places[place];
    const Id v = m_vertex_of[place];
    return m_complex.vertex(v != 0 ? v : m_any_vertex).cell;
  }

  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  const CGAL::Delaunay_from_surface_3::Insertion_order& m_plan;
  Complex m_complex;
  CGAL::Delaunay_from_surface_3::internal::Shared_complex<Vertex> m_shared;
  std::vector<Id> m_vertex_of;
  Id m_any_vertex = 0;
  std::vector<std::unique_ptr<Worker>> m_workers;
};

} // namespace threads

#endif // DELAUNAY_FROM_SURFACE_3_BENCHMARK_SIMULATE_WORKERS_H
