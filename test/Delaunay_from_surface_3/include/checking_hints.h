// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_CHECKING_HINTS_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_CHECKING_HINTS_H

// Hint policies that check, while the package runs them, what the concepts promise.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/Triangulation_target_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <vector>

namespace tests {

// Whether the point is in the closed cell, or beyond the facet of an infinite one.
template <class Triangulation>
bool contains(const Triangulation& tr, typename Triangulation::Cell_handle cell,
              const typename Triangulation::Point& p)
{
  const auto orientation_with_p_at = [&](int i) {
    std::array<const typename Triangulation::Point*, 4> q;
    for (int j = 0; j < 4; ++j)
      q[std::size_t(j)] = i == j ? &p : &cell->vertex(j)->point();
    return tr.geom_traits().orientation_3_object()(*q[0], *q[1], *q[2], *q[3]);
  };
  if (tr.is_infinite(cell))
    return orientation_with_p_at(cell->index(tr.infinite_vertex())) == CGAL::POSITIVE;
  for (int i = 0; i < 4; ++i)
    if (orientation_with_p_at(i) == CGAL::NEGATIVE)
      return false;
  return true;
}

// Whether v is a vertex of a cell in which p lies. A point on a facet lies in two.
template <class Triangulation>
bool is_vertex_at(const Triangulation& tr, typename Triangulation::Vertex_handle v,
                  const typename Triangulation::Point& p)
{
  if (tr.dimension() < 3) {
    int li, lj;
    typename Triangulation::Locate_type type;
    const auto cell = tr.locate(p, type, li, lj);
    if (type == Triangulation::VERTEX)
      return v == cell->vertex(li);
    return type != Triangulation::FACET || cell->has_vertex(v);
  }
  std::vector<typename Triangulation::Cell_handle> cells;
  tr.incident_cells(v, std::back_inserter(cells));
  return std::any_of(cells.begin(), cells.end(), [&](auto c) { return contains(tr, c, p); });
}

template <class Target, class Subgraph>
class Checking_traced_hints : public CGAL::Delaunay_from_surface_3::Traced_hints_3<Target, Subgraph>
{
  using Base = CGAL::Delaunay_from_surface_3::Traced_hints_3<Target, Subgraph>;
  using Vertex = typename Target::Vertex;

public:
  static inline std::size_t number_of_starts = 0;
  static inline std::size_t number_of_traced_points = 0;

  Checking_traced_hints(const Target& target, const Subgraph& subgraph,
                        const CGAL::Delaunay_from_surface_3::Insertion_order& plan)
    : Base(target, subgraph, plan)
    , m_target(target)
    , m_plan(plan)
  {
  }

  typename Target::Cell start(std::size_t i) const
  {
    const Vertex v = Base::recorded_vertex(i);
    if (v != Vertex()) {
      BOOST_TEST_REQUIRE(m_target.triangulation().tds().is_vertex(v));
      BOOST_TEST(!m_target.triangulation().is_infinite(v));
    }
    const auto cell = Base::start(i);
    BOOST_TEST_REQUIRE(m_target.triangulation().tds().is_simplex(cell));
    ++number_of_starts;
    return cell;
  }

  std::size_t trace()
  {
    const std::size_t located = Base::trace();
    const std::size_t begin = m_plan.round_ends[m_round++], end = m_plan.round_ends[m_round];
    for (std::size_t i = begin; i < end; ++i) {
      BOOST_TEST((m_target.vertex(i) == Vertex()));
      const Vertex v = Base::recorded_vertex(i);
      BOOST_TEST_REQUIRE(m_target.triangulation().tds().is_vertex(v));
      BOOST_TEST(!m_target.triangulation().is_infinite(v));
      BOOST_TEST(is_vertex_at(m_target.triangulation(), v, m_target.point(i)));
    }
    BOOST_TEST(located == end - begin);
    number_of_traced_points += located;
    return located;
  }

private:
  const Target& m_target;
  const CGAL::Delaunay_from_surface_3::Insertion_order& m_plan;
  std::size_t m_round = 0;
};

// For a plan by Neighbor_started_rounds: what is planned must be what the graph tells by then.
template <class Target, class Subgraph>
class Checking_planned_hints
  : public CGAL::Delaunay_from_surface_3::Planned_hints_3<Target, Subgraph>
{
  using Base = CGAL::Delaunay_from_surface_3::Planned_hints_3<Target, Subgraph>;

public:
  static constexpr bool uses_subgraph = true;
  static inline std::size_t number_of_neighbors = 0;
  static inline std::size_t number_of_starts = 0;

  Checking_planned_hints(const Target& target, const Subgraph& subgraph,
                         const CGAL::Delaunay_from_surface_3::Insertion_order& plan)
    : Base(target, subgraph, plan)
    , m_target(target)
    , m_subgraph(subgraph)
  {
  }

  typename Target::Cell start(std::size_t i) const
  {
    const typename Target::Cell cell = Base::start(i);
    if (i == 0)
      return cell;
    std::size_t expected = i - 1;
    bool is_neighbor = false;
    for (auto [u, end] = adjacent_vertices(i, m_subgraph); u != end; ++u)
      if (*u < i && (!is_neighbor || *u > expected)) {
        expected = *u;
        is_neighbor = true;
      }
    BOOST_TEST_REQUIRE((m_target.vertex(expected) != typename Target::Vertex()));
    BOOST_TEST((cell == m_target.cell(m_target.vertex(expected))));
    number_of_neighbors += is_neighbor;
    ++number_of_starts;
    return cell;
  }

private:
  const Target& m_target;
  const Subgraph& m_subgraph;
};

// Sees every conflict zone, and compares it with all cells in conflict and all cells destroyed.
template <class Target, class Subgraph>
class Zone_checking_hints : public CGAL::Delaunay_from_surface_3::Previous_hint_3<Target, Subgraph>
{
  using Base = CGAL::Delaunay_from_surface_3::Previous_hint_3<Target, Subgraph>;
  using Vertex = typename Target::Vertex;
  using Vertices_of_cell = std::array<Vertex, 4>;

public:
  static constexpr bool observes_conflict_zone = true;
  static inline std::size_t number_of_zones = 0;
  static inline std::size_t number_of_updates_in_space = 0;
  static inline std::size_t number_of_updates = 0;

  Zone_checking_hints(const Target& target, const Subgraph& subgraph,
                      const CGAL::Delaunay_from_surface_3::Insertion_order& plan)
    : Base(target, subgraph, plan)
    , m_target(target)
  {
  }

  typename Target::Cell start(std::size_t i)
  {
    m_is_observed = false;
    m_dimension_before = m_target.triangulation().dimension();
    m_vertices_before = m_target.triangulation().number_of_vertices();
    return Base::start(i);
  }

  template <class CellIterator>
  void before_update(std::size_t i, CellIterator first, CellIterator last)
  {
    const auto& tr = m_target.triangulation();
    ++number_of_zones;
    m_is_observed = true;
    m_spared_cells.clear();
    const std::set<typename Target::Cell> zone(first, last);
    BOOST_TEST(zone.size() == std::size_t(std::distance(first, last)));
    std::size_t in_conflict = 0;
    for (auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c) {
      const bool conflicts = tr.side_of_sphere(c, m_target.point(i), true) == CGAL::ON_BOUNDED_SIDE;
      in_conflict += conflicts;
      BOOST_TEST(conflicts == (zone.count(c) == 1));
      if (!conflicts)
        m_spared_cells.insert(vertices_of(c));
    }
    BOOST_TEST(in_conflict == zone.size());
  }

  void after_update(std::size_t i, Vertex v)
  {
    const auto& tr = m_target.triangulation();
    Base::after_update(i, v);
    ++number_of_updates;
    BOOST_TEST(v->point() == m_target.point(i));
    const bool is_new = tr.number_of_vertices() > m_vertices_before;
    number_of_updates_in_space += m_dimension_before == 3 && is_new;
    if (!m_is_observed)
      return;
    std::set<Vertices_of_cell> old_cells;
    for (auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c)
      if (!c->has_vertex(v))
        old_cells.insert(vertices_of(c));
    BOOST_TEST((old_cells == m_spared_cells));
  }

private:
  template <class Cell>
  static Vertices_of_cell vertices_of(const Cell& c)
  {
    Vertices_of_cell vertices = {c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3)};
    std::sort(vertices.begin(), vertices.end());
    return vertices;
  }

  const Target& m_target;
  bool m_is_observed = false;
  int m_dimension_before = -1;
  std::size_t m_vertices_before = 0;
  std::set<Vertices_of_cell> m_spared_cells;
};

} // namespace tests

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_CHECKING_HINTS_H
