// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_DELAUNAY_TILE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_DELAUNAY_TILE_H

// One tile of a Delaunay triangulation that is larger than a machine: the stars of its own points.
//
// It triangulates them, and then *tells*: of each edge between points of two tiles the owner of each end
// is told of the other. What it is told it *offers* to its triangulation, where a point that would get no
// neighbour of the tile's own is refused. When nobody has anything to tell, the star of each own point is
// that in the triangulation of all points (Brédif et al. 2020 tell without refusal);
// Tile_certificate.h asks whether it is so.
//
// Refusal is for ever: an edge of the triangulation of all points is one in that of any subset that has
// both ends, so who gets no own neighbour now never does.
//
// Cost: that of the insertions; each telling looks at the cells made since the one before.

#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Inserter.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Power_of_scale.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Sort_by_halves.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Split_mix.h>
#include <CGAL/Delaunay_from_surface_3/core/order/geometric_rounds.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_certificate.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_point.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_tree.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// What all tiles know.
struct Tiling
{
  Tile_tree tree;
  std::array<Tile_point, 4> start; // positively oriented; every tile keeps these
  double largest, least; // coordinates, in absolute value; the least of those that are not 0
};

class Delaunay_tile
{
  using Id = std::uint32_t;
  using Complex = Compact_complex<Id>;

public:
  static constexpr std::uint64_t infinite_id = std::uint64_t(-1);
  using Cell = std::array<std::uint64_t, 4>; // ids of vertices

  // Of the points that are the tile's own. Keeps a reference to what all know.
  Delaunay_tile(const Tiling& tiling, std::uint32_t number, const std::vector<Tile_point>& own)
    : m_tiling(tiling)
    , m_number(number)
    , m_scaled(tiling.largest, tiling.least)
    , m_complex(4, [&](std::size_t i) { return m_scaled(tiling.start[i].coordinates); })
    , m_inserter(m_complex)
  {
    m_points.push_back({infinite_id, {0, 0, 0}});
    m_owners.push_back(nobody);
    for (const Tile_point& p : tiling.start)
      note_vertex(p);
    if (!m_scaled.is_exact())
      for (const Tile_point& p : tiling.start)
        m_complex.add_own_coordinates({p.coordinates[0], p.coordinates[1], p.coordinates[2]});
    m_complex.start({1, 2, 3, 4});
    insert_own(own);
  }
  Delaunay_tile(const Delaunay_tile&) = delete;

  std::uint32_t number() const { return m_number; }

  // Offers what others have told, or a sample of all points, and returns what there is to tell now.
  std::vector<Tile_message> absorb(const std::vector<Tile_point>& told)
  {
    for (const std::size_t i : order_of(told))
      offer(told[i]);
    return tell();
  }

  // When nobody has anything to tell.
  Tile_certificate certificate(std::uint64_t seed) const
  {
    Tile_certificate result{m_number, {}, 0, 0};
    std::vector<char> is_on_hull(m_points.size());
    for_each_cell([&](const Compact_cell<Id>& cell) {
      const Cell ids = ids_of(cell);
      std::array<std::uint32_t, 4> owners;
      for (unsigned k = 0; k < 4; ++k) {
        owners[k] = m_owners[cell.v[k]];
        if (Complex::is_infinite(cell) && owners[k] == m_number && is_on_hull[cell.v[k]] == 0) {
          is_on_hull[cell.v[k]] = 1;
          ++result.hull_vertices;
        }
      }
      if (std::find(owners.begin(), owners.end(), m_number) == owners.end())
        return;
      result.hull_facets += Complex::is_infinite(cell) && is_owned(cell);
      std::sort(owners.begin(), owners.end());
      Cell sorted = ids;
      std::sort(sorted.begin(), sorted.end());
      for (unsigned k = 0; k < 4; ++k)
        if (owners[k] != m_number && owners[k] != nobody && (k == 0 || owners[k] != owners[k - 1]))
          add_cell(result.common[owners[k]], sorted, seed);
    });
    return result;
  }

  // Calls visit(cell) for each cell whose smallest vertex is the tile's own, as ids in positive
  // orientation, infinite_id last.
  template <class Visit>
  void for_each_owned_cell(const Visit& visit) const
  {
    for_each_cell([&](const Compact_cell<Id>& cell) {
      if (is_owned(cell))
        visit(ids_of(cell));
    });
  }

  std::size_t number_of_points_kept() const { return m_points.size() - 1; }

private:
  static constexpr std::uint32_t nobody = std::uint32_t(-1);

  // Own points in random rounds, each sorted by halves; each is inserted from the one before.
  void insert_own(const std::vector<Tile_point>& own)
  {
    const std::vector<double> coordinates = coordinates_of(own);
    for (const std::size_t i :
         geometric_rounds(Point_array(coordinates.data(), own.size()), m_number, 0.125, 64).order)
      insert_if(own[i], [](Id) { return true; });
  }

  void offer(const Tile_point& p)
  {
    if (m_known.insert(p.id).second)
      insert_if(p, [&](Id) { return gets_own_neighbor(); });
  }

  // Of a point whose conflict zone is dug: its neighbours are the corners of the zone.
  bool gets_own_neighbor() const
  {
    const auto& zone = m_inserter.zone;
    for (std::size_t f = 0; f < zone.number_of_facets; ++f)
      for (const Id v : zone.facets[f].corners)
        if (m_owners[v] == m_number)
          return true;
    return false;
  }

  template <class Wants>
  void insert_if(const Tile_point& point, const Wants& wants)
  {
    const double* const c = point.coordinates;
    const Id p = m_complex.add_vertex(m_scaled(c));
    if (!m_scaled.is_exact())
      m_complex.add_own_coordinates({c[0], c[1], c[2]});
    const auto location = m_inserter.walk(p, m_complex.vertex(m_previous).cell, Read_alone());
    if (location.vertex != 0) { // of equal points the smallest number stands for all
      m_complex.drop_last_vertex();
      std::uint64_t& id = m_points[location.vertex].id;
      id = (std::min)(id, point.id);
      m_previous = location.vertex;
      return;
    }
    m_inserter.dig(p, location.cell);
    if (!wants(p)) {
      m_inserter.zone.revive(m_complex);
      m_complex.drop_last_vertex();
      m_previous = Complex::first_vertex(m_complex.cell(location.cell)); // the infinite one is last
      return;
    }
    m_inserter.fill(p);
    note_vertex(point);
    m_previous = p;
  }

  void note_vertex(const Tile_point& p)
  {
    m_points.push_back(p);
    m_owners.push_back(m_tiling.tree.owner(p.coordinates));
  }

  // Of each edge between points of two tiles the owner of each end is told of the other, once.
  std::vector<Tile_message> tell()
  {
    std::map<std::uint32_t, std::vector<Tile_point>> told;
    for_each_cell([&](const Compact_cell<Id>& cell) { // new edges are those of new vertices
      if (*std::max_element(cell.v, cell.v + 4) < m_first_untold)
        return;
      for (const Id v : cell.v)
        for (const Id w : cell.v)
          if (const std::uint32_t to = m_owners[w]; to != m_owners[v] && to != m_number &&
                                                    to != nobody && v != Complex::infinite &&
                                                    m_told.insert({m_points[v].id, to}).second)
            told[to].push_back(m_points[v]);
    });
    m_first_untold = m_points.size();
    std::vector<Tile_message> messages;
    messages.reserve(told.size());
    for (auto& [to, points] : told)
      messages.push_back({m_number, to, std::move(points)});
    return messages;
  }

  Cell ids_of(const Compact_cell<Id>& cell) const
  {
    return {m_points[cell.v[0]].id, m_points[cell.v[1]].id, m_points[cell.v[2]].id,
            m_points[cell.v[3]].id};
  }

  // Is the vertex with the smallest id the tile's own?
  bool is_owned(const Compact_cell<Id>& cell) const
  {
    const Id* const first = std::min_element(
        cell.v, cell.v + 4, [&](Id v, Id w) { return m_points[v].id < m_points[w].id; });
    return m_owners[*first] == m_number;
  }

  template <class Visit>
  void for_each_cell(const Visit& visit) const
  {
    for (std::size_t c = 0; c < m_complex.cells_end(); ++c)
      if (!Complex::is_dead(m_complex.cell(c)))
        visit(m_complex.cell(c));
  }

  static std::vector<double> coordinates_of(const std::vector<Tile_point>& points)
  {
    std::vector<double> coordinates;
    coordinates.reserve(3 * points.size());
    for (const Tile_point& p : points)
      coordinates.insert(coordinates.end(), p.coordinates, p.coordinates + 3);
    return coordinates;
  }

  // Points that follow each other are near each other.
  static std::vector<std::size_t> order_of(const std::vector<Tile_point>& points)
  {
    const std::vector<double> coordinates = coordinates_of(points);
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    Sort_by_halves()(Point_array(coordinates.data(), points.size()), order.data(),
                     order.data() + order.size());
    return order;
  }

  // Of which point whom.
  struct Told
  {
    std::uint64_t id;
    std::uint32_t to;
    friend bool operator==(const Told& s, const Told& t) { return s.id == t.id && s.to == t.to; }
  };
  struct Hash_of_told
  {
    std::size_t operator()(const Told& t) const
    {
      return std::size_t(Split_mix(t.id ^ std::uint64_t(t.to) << 40)());
    }
  };

  const Tiling& m_tiling;
  const std::uint32_t m_number;
  const Power_of_scale m_scaled;
  Complex m_complex;
  Inserter<Alone_with_complex<Id>> m_inserter;
  Id m_previous = 1;
  std::vector<Tile_point> m_points;    // by vertex, with the id that stands for all that are equal
  std::vector<std::uint32_t> m_owners; // by vertex
  std::size_t m_first_untold = 0;      // vertex
  std::unordered_set<std::uint64_t> m_known; // ids that were offered
  std::unordered_set<Told, Hash_of_told> m_told;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_DELAUNAY_TILE_H
