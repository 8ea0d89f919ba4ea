// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_TRIANGULATION_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_TRIANGULATION_H

// The triangulation that a tile has: its own points, and those of others that it keeps. Beside the
// complex there are 12 bytes for a vertex, since coordinates are those of the complex.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Inserter.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Power_of_scale.h>
#include <CGAL/Delaunay_from_surface_3/core/order/geometric_rounds.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/prefetch.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_point.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiling.h>
#include <CGAL/Delaunay_from_surface_3/tiles/insert_by_threads.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

class Tile_triangulation
{
public:
  using Id = std::uint32_t;
  using Complex = Compact_complex<Id>;
  using Cell = Compact_cell<Id>;

  static constexpr std::uint64_t infinite_id = std::uint64_t(-1);
  static constexpr std::uint32_t nobody = std::uint32_t(-1); // who owns the infinite vertex

  // Of the four points that all tiles keep, with room for others. Keeps a reference.
  Tile_triangulation(const Tiling& tiling, std::size_t number_of_points)
    : m_tiling(tiling)
    , m_scaled(tiling.largest, tiling.least)
    , m_complex(4, [&](std::size_t i) { return m_scaled(tiling.start[i].coordinates); })
    , m_inserter(m_complex)
  {
    m_ids.reserve(number_of_points + 5);
    m_owners.reserve(number_of_points + 5);
    m_ids.push_back(infinite_id);
    m_owners.push_back(nobody);
    for (const Tile_point& p : tiling.start)
      note_vertex(p);
    m_complex.start({1, 2, 3, 4});
    m_complex.make_room_for_vertices(number_of_points + 5);
    m_complex.make_room(8 * number_of_points + 64);
  }
  Tile_triangulation(const Tile_triangulation&) = delete;

  // Inserts points that are wanted whatever they touch, before any others: by all workers, or as
  // insert() does. The vertices are the same then, and the cells, but in another order. check() is called
  // now and then, and may throw.
  template <class Check, class Equal>
  void insert_first(std::vector<Tile_point> points, unsigned int seed, const Executor& executor,
                    const Check& check, const Equal& equal)
  {
    if (executor.number_of_workers() == 1 || points.size() < least_points_for_threads)
      return insert(
          std::move(points), seed, [&] { return check(), true; }, equal);
    Insertion_order order = order_of(points, seed);
    add_vertices(points, order.order);
    const std::size_t before = std::exchange(m_vertices_end, m_ids.size()) - 1;
    std::vector<Tile_point>().swap(points);
    std::vector<std::size_t>().swap(order.order);
    merge_equal_points(insert_by_threads(m_complex, before, order.round_ends, executor, check),
                       equal);
  }

  // Inserts those that wants() when the zone of conflict is dug, in random rounds, each sorted by
  // halves, and each point from the one before. If p has the place of vertex v, equal(v, id of p,
  // id of v) says whether the smaller id is that of v then.
  template <class Wants, class Equal>
  void insert(std::vector<Tile_point> points, unsigned int seed, const Wants& wants,
              const Equal& equal)
  {
    add_vertices(points, order_of(points, seed).order);
    std::vector<Tile_point>().swap(points);
    const std::size_t end = m_ids.size();
    for (std::size_t v = m_vertices_end; v < end; ++v) {
      const auto p = Id(m_vertices_end); // those before are in cells
      renumber_vertex(Id(v), p);
      m_vertices_end += insert(p, wants, equal);
    }
    drop_vertices(m_vertices_end);
  }

  // While wants() is asked: the corners of the zone, each more than once, until visit(v) is true.
  template <class Visit>
  bool find_neighbor(const Visit& visit) const
  {
    const auto& zone = m_inserter.zone;
    for (std::size_t f = 0; f < zone.number_of_facets; ++f)
      for (const Id v : zone.facets[f].corners)
        if (visit(v))
          return true;
    return false;
  }

  // That are taken by what there is.
  std::uint64_t bytes() const
  {
    return m_complex.cells_end() * sizeof(Cell) +
           m_ids.size() * (sizeof(Complex::Vertex) + sizeof(std::uint64_t) + sizeof(std::uint32_t));
  }

  // The number of vertices, the infinite one, which is 0, included.
  std::size_t vertices_end() const { return m_vertices_end; }
  std::uint64_t id(Id v) const { return m_ids[v]; }
  std::uint32_t owner(Id v) const { return m_owners[v]; }
  Tile_point point(Id v) const
  {
    const auto c = m_complex.is_rounded() ? m_complex.own_coordinates(v)
                                          : m_scaled.before(m_complex.vertex(v).coordinates);
    return {m_ids[v], {c[0], c[1], c[2]}};
  }

  std::array<std::uint64_t, 4> ids_of(const Cell& cell) const
  {
    return {m_ids[cell.v[0]], m_ids[cell.v[1]], m_ids[cell.v[2]], m_ids[cell.v[3]]};
  }

  // Whose vertex has the smallest id. Branches would be foreseen badly.
  std::uint32_t owner_of(const Cell& cell) const
  {
    Id first = cell.v[0];
    for (unsigned k = 1; k < 4; ++k)
      first = m_ids[cell.v[k]] < m_ids[first] ? cell.v[k] : first;
    return m_owners[first];
  }

  template <class Visit>
  void for_each_cell(const Visit& visit) const
  {
    for (std::size_t c = 0; c < m_complex.cells_end(); ++c)
      if (!Complex::is_dead(m_complex.cell(c)))
        visit(m_complex.cell(c));
  }

private:
  static Insertion_order order_of(const std::vector<Tile_point>& points, unsigned int seed)
  {
    std::vector<double> coordinates;
    coordinates.reserve(3 * points.size());
    for (const Tile_point& p : points)
      coordinates.insert(coordinates.end(), p.coordinates, p.coordinates + 3);
    return geometric_rounds(Point_array(coordinates.data(), points.size()), seed, 0.125, 64);
  }

  // In this order; they are in no cell yet.
  void add_vertices(const std::vector<Tile_point>& points, const std::vector<std::size_t>& order)
  {
    for (std::size_t k = 0; k < order.size(); ++k) {
      prefetch(&points[order[(std::min)(k + 8, order.size() - 1)]]);
      const double* const c = points[order[k]].coordinates;
      m_complex.add_vertex(m_scaled(c));
      note_vertex(points[order[k]]);
    }
  }

  // Of a point that the complex has; beside its place there.
  void note_vertex(const Tile_point& p)
  {
    if (!m_scaled.is_exact())
      m_complex.add_own_coordinates({p.coordinates[0], p.coordinates[1], p.coordinates[2]});
    m_ids.push_back(p.id);
    m_owners.push_back(m_tiling.tree.owner(p.coordinates));
  }

  void renumber_vertex(Id v, Id number)
  {
    m_complex.renumber_vertex(v, number);
    m_ids[number] = m_ids[v];
    m_owners[number] = m_owners[v];
  }

  // Whether p is in cells now.
  template <class Wants, class Equal>
  bool insert(Id p, const Wants& wants, const Equal& equal)
  {
    const auto location = m_inserter.walk(p, m_complex.vertex(m_previous).cell, Read_alone());
    if (location.vertex != 0) {
      m_previous = location.vertex;
      note_equal(location.vertex, p, equal);
      return false;
    }
    m_inserter.dig(p, location.cell);
    if (!wants()) {
      m_inserter.zone.revive(m_complex);
      m_previous = Complex::first_vertex(m_complex.cell(location.cell)); // the infinite one is last
      return false;
    }
    m_inserter.fill(p);
    m_previous = p;
    return true;
  }

  // Of equal points the smallest number stands for all: p has the place of v.
  template <class Equal>
  void note_equal(Id v, Id p, const Equal& equal)
  {
    if (equal(v, m_ids[p], m_ids[v]))
      m_ids[v] = (std::min)(m_ids[v], m_ids[p]);
  }

  // Equal points have one vertex, of any of them, and the numbers of the others are in no cell. So
  // vertices are numbered anew, by the first place of each: as if one thread had inserted them.
  template <class Equal>
  void merge_equal_points(const std::vector<Id>& vertex_of, const Equal& equal)
  {
    bool are_any = false;
    for (std::size_t k = 0; k < vertex_of.size(); ++k)
      if (const Id p = Complex::vertex_of_point(k); vertex_of[k] != p) {
        note_equal(vertex_of[k], p, equal);
        are_any = true;
      }
    if (!are_any)
      return;
    std::vector<Id> numbers(m_vertices_end, 0);
    std::size_t end = 1;
    for (const Id v : vertex_of)
      if (numbers[v] == 0)
        renumber_vertex(v, numbers[v] = Id(end++));
    for (std::size_t c = 0; c < m_complex.cells_end(); ++c)
      if (!Complex::is_dead(m_complex.cell(c)))
        for (Id& v : m_complex.cell(c).v)
          v = numbers[v];
    drop_vertices(end);
  }

  void drop_vertices(std::size_t end)
  {
    m_vertices_end = end;
    m_complex.drop_vertices(end);
    m_ids.resize(end);
    m_owners.resize(end);
  }

  const Tiling& m_tiling;
  const Power_of_scale m_scaled;
  Complex m_complex;
  Inserter<Alone_with_complex<Id>> m_inserter;
  Id m_previous = 1;
  std::size_t m_vertices_end = 5;   // those from here on are in no cell yet
  std::vector<std::uint64_t> m_ids; // by vertex; the smallest of those of equal points
  std::vector<std::uint32_t> m_owners;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_TRIANGULATION_H
