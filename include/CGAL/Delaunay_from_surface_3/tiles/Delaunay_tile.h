// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_DELAUNAY_TILE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_DELAUNAY_TILE_H

// One tile of a Delaunay triangulation that is larger than a machine: the stars of its own points.
//
// It triangulates them, and then *tells*: of each edge between points of two tiles the owner of
// each end is told of the other. What it is told it *offers* to its triangulation, where a point
// that would get no neighbour of the tile's own is refused. To be told of one's own point is a
// question: the answer are its neighbours. When nobody has anything to tell, the star of each own
// point is that in the triangulation of all points (Brédif et al. 2020 tell without refusal);
// Tile_certificate.h asks whether it is so.
//
// Refusal is for ever: an edge of the triangulation of all points is one in that of any subset that
// has both ends, so who gets no own neighbour now never does.
//
// Cost: that of the insertions; each telling looks at the cells made since the one before.

#include <CGAL/Delaunay_from_surface_3/Too_few_ids.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_news.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_point.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_too_large.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_triangulation.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiling.h>
#include <CGAL/Delaunay_from_surface_3/tiles/fit_when_merged.h>
#include <CGAL/Delaunay_from_surface_3/tiles/number_of_tiles.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

class Delaunay_tile
{
public:
  using Id = Tile_triangulation::Id;
  using Cell = Tile_triangulation::Cell;

  // Of the points that are the tile's own, as it was in a state; all workers insert them. Keeps a
  // reference to what all know. If more than `limit` points are kept, Tile_too_large is thrown.
  Delaunay_tile(const Tiling& tiling, std::uint32_t number, std::vector<Tile_point> own,
                Tile_state state, std::size_t limit, const Executor& executor)
    : m_tiling(tiling)
    , m_number(number)
    , m_limit(limit)
    , m_known(std::move(state.known))
    , m_told(std::move(state.told))
    , m_triangulation(tiling, (std::min)(limit, own.size() + state.kept.size()))
  {
    for (const Tile_point& p : own)
      m_number_of_own_points += tiling.tree.owner(p.coordinates) == number;
    own.insert(own.end(), state.kept.begin(), state.kept.end());
    if (!fit_when_merged(own, limit, tiling.start, m_equal))
      throw too_large(limit);
    const bool is_new = state.kept.empty() && m_known.empty();
    state = {};
    const auto note_equal = [&](Id, std::uint64_t p, std::uint64_t q) {
      if (p != q)
        m_equal.push_back({(std::max)(p, q), (std::min)(p, q)});
      return true;
    };
    or_too_large([&] {
      m_triangulation.insert_first(
          std::move(own), number, executor, [&] { check_bytes(); }, note_equal);
    });
    m_first_untold = is_new ? 0 : m_triangulation.vertices_end();
  }

  std::uint32_t number() const { return m_number; }
  std::size_t number_of_own_points() const { return m_number_of_own_points; }
  std::size_t number_of_points_kept() const { return m_triangulation.vertices_end() - 1; }
  const Tile_triangulation& triangulation() const { return m_triangulation; }
  const std::vector<std::uint64_t>& known() const { return m_known; }
  bool is_own(Id v) const { return m_triangulation.owner(v) == m_number; }

  // Own points that have the place of others: the id, and that of one of them with a smaller id.
  const std::vector<std::array<std::uint64_t, 2>>& equal_points() const { return m_equal; }

  // Offers what is new to the tile, answers questions, and returns what there is to tell now.
  std::vector<Tile_message> absorb(Tile_news news)
  {
    offer(std::move(news.offers));
    return tell_and_answer(news.questions);
  }

  // The same in two steps, of which the first may be taken again and again. No more points wait at once
  // than an eighth of those that may be kept.
  void offer(std::vector<Tile_point> points)
  {
    note_known(points);
    const std::size_t most = (std::max)(m_limit / 8, std::size_t(1024));
    const auto insert = [&](std::vector<Tile_point> some) {
      or_too_large([&] {
        m_triangulation.insert(
            std::move(some), m_number, [&] { return wants(); }, [](auto...) { return true; });
      });
    };
    while (points.size() > most && number_of_points_kept() + points.size() > m_limit) {
      insert({points.end() - std::ptrdiff_t(most), points.end()});
      points.resize(points.size() - most);
    }
    insert(std::move(points));
  }
  std::vector<Tile_message> tell_and_answer(const std::vector<Tile_message>& questions)
  {
    std::vector<Tile_message> messages = tell(m_first_untold == 0);
    answer(questions, messages);
    return messages;
  }

  // If the certificate does not hold: for each of these partners, all vertices of cells that have a
  // vertex of both. Those of the partner are questions. If the two see different common cells, one
  // of them learns something: of a cell that the partner does not have it either takes a vertex
  // that it lacked, or its answer has a point in conflict with the cell; that gets all vertices of
  // the cell as neighbours, so it is not refused (witnesses, as in star splaying).
  std::vector<Tile_message> witnesses(const std::vector<std::uint32_t>& partners) const
  {
    std::vector<Tile_message> messages;
    for (const std::uint32_t to : partners)
      messages.push_back({m_number, to, points_around([&](const Cell& cell) {
                            return has_vertex_of(cell, m_number) && has_vertex_of(cell, to);
                          })});
    return messages;
  }

  // At the end.
  Tile_state state() &&
  {
    Tile_state state{{}, std::move(m_known), std::move(m_told)};
    for (std::size_t v = 5; v < m_triangulation.vertices_end(); ++v) // after those all tiles keep
      if (!is_own(Id(v)))
        state.kept.push_back(m_triangulation.point(Id(v)));
    return state;
  }

private:
  template <class Insert>
  void or_too_large(const Insert& insert)
  {
    try {
      insert();
    } catch (const Too_few_ids&) { // for cells: a hub has many
      throw too_large((std::min)(m_limit, number_of_points_kept()));
    }
  }

  bool wants() const
  {
    const bool is_wanted = m_triangulation.find_neighbor([&](Id v) { return is_own(v); });
    if (is_wanted && number_of_points_kept() >= m_limit)
      throw too_large(m_limit);
    check_bytes();
    return is_wanted;
  }

  // A point may have many cells.
  void check_bytes() const
  {
    if (m_triangulation.bytes() > m_bytes)
      throw too_large((std::min)(m_limit, number_of_points_kept()));
  }

  void note_known(const std::vector<Tile_point>& told)
  {
    const std::size_t before = m_known.size();
    for (const Tile_point& p : told)
      m_known.push_back(p.id);
    std::inplace_merge(m_known.begin(), m_known.begin() + std::ptrdiff_t(before), m_known.end());
  }

  // Calls visit(v, to) for each edge of a new cell from a finite vertex v to one of the tile `to`,
  // which is another than the owner of v and than this one; edges again and again. If it asks, for
  // each edge to an own vertex, too, `to` being the owner of v.
  template <class Visit>
  void for_each_new_edge(bool asks, const Visit& visit) const
  {
    m_triangulation.for_each_cell([&](const Cell& cell) { // new edges are in cells of new vertices
      if (*std::max_element(cell.v, cell.v + 4) < m_first_untold)
        return;
      std::uint32_t owners[4];
      for (unsigned k = 0; k < 4; ++k)
        owners[k] = m_triangulation.owner(cell.v[k]);
      if (owners[0] == owners[1] && owners[1] == owners[2] && owners[2] == owners[3])
        return;
      const bool asks_here = asks && std::find(owners, owners + 4, m_number) != owners + 4;
      for (unsigned i = 0; i < 4; ++i)
        for (const std::uint32_t to : owners)
          if ((to != owners[i] || asks_here) && to != m_number &&
              to != Tile_triangulation::nobody && owners[i] != Tile_triangulation::nobody)
            visit(cell.v[i], to);
    });
  }

  // Of each edge between points of two tiles the owner of each end is told of the other, once.
  // Nobody has told of the points that all tiles get: the first time their owners are asked about
  // those that have neighbours of the tile's own. No such edge is made later, and an owner who
  // would refuse the other end has no other reason to say so.
  std::vector<Tile_message> tell(bool asks)
  {
    if (m_first_untold == m_triangulation.vertices_end())
      return {};
    std::vector<std::pair<std::uint32_t, Id>> tells; // to whom of what
    std::vector<std::uint32_t> last(m_triangulation.vertices_end(), Tile_triangulation::nobody);
    for_each_new_edge(asks, [&](Id v, std::uint32_t to) {
      if (last[v] != to) // nearly always the same one
        tells.emplace_back(to, v);
      last[v] = to;
    });
    std::sort(tells.begin(), tells.end());
    tells.erase(std::unique(tells.begin(), tells.end()), tells.end());
    m_first_untold = m_triangulation.vertices_end();

    std::vector<Tile_message> messages;
    const std::size_t before = m_told.size();
    for (const auto& [to, v] : tells) {
      const Told told = {m_triangulation.id(v), to};
      if (std::binary_search(m_told.begin(), m_told.begin() + std::ptrdiff_t(before), told))
        continue;
      m_told.push_back(told);
      if (messages.empty() || messages.back().to != to)
        messages.push_back({m_number, to, {}});
      messages.back().points.push_back(m_triangulation.point(v));
    }
    std::sort(m_told.begin() + std::ptrdiff_t(before), m_told.end());
    std::inplace_merge(m_told.begin(), m_told.begin() + std::ptrdiff_t(before), m_told.end());
    return messages;
  }

  // Who asks about a point of the tile's own is told of its neighbours, but for those of the
  // asker's, which would be questions.
  void answer(const std::vector<Tile_message>& questions, std::vector<Tile_message>& messages)
  {
    std::multimap<Id, std::size_t> asked; // who asks, by vertex
    for (std::size_t a = 0; a < questions.size(); ++a)
      m_triangulation.insert(
          questions[a].points, m_number, [] { return false; },
          [&](Id v, std::uint64_t, std::uint64_t) {
            asked.emplace(v, a);
            return false; // who asks does not know better
          });
    if (asked.empty())
      return;
    std::vector<char> is_asked(m_triangulation.vertices_end());
    for (const auto& [v, a] : asked)
      is_asked[v] = 1;
    std::vector<std::set<Id>> answers(questions.size());
    m_triangulation.for_each_cell([&](const Cell& cell) {
      for (const Id v : cell.v)
        if (is_asked[v])
          for (auto [i, end] = asked.equal_range(v); i != end; ++i)
            answers[i->second].insert(cell.v, cell.v + 4);
    });
    for (std::size_t a = 0; a < questions.size(); ++a) {
      Tile_message message{m_number, questions[a].from, {}};
      for (const Id v : answers[a])
        if (v != 0 && m_triangulation.owner(v) != message.to)
          message.points.push_back(m_triangulation.point(v));
      messages.push_back(std::move(message));
    }
  }

  bool has_vertex_of(const Cell& cell, std::uint32_t tile) const
  {
    return std::any_of(cell.v, cell.v + 4, [&](Id v) { return m_triangulation.owner(v) == tile; });
  }

  // The vertices of certain cells.
  template <class Selects>
  std::vector<Tile_point> points_around(const Selects& selects) const
  {
    std::vector<char> is_around(m_triangulation.vertices_end());
    m_triangulation.for_each_cell([&](const Cell& cell) {
      if (selects(cell))
        for (const Id v : cell.v)
          is_around[v] = 1;
    });
    std::vector<Tile_point> points;
    for (std::size_t v = 1; v < is_around.size(); ++v)
      if (is_around[v])
        points.push_back(m_triangulation.point(Id(v)));
    return points;
  }

  // The vertex with the most neighbours is to blame.
  Tile_too_large too_large(std::size_t limit) const
  {
    std::vector<std::uint32_t> cells(m_triangulation.vertices_end());
    m_triangulation.for_each_cell([&](const Cell& cell) {
      for (const Id v : cell.v)
        ++cells[v];
    });
    const auto hub = Id(std::max_element(cells.begin() + 1, cells.end()) - cells.begin());
    return Tile_too_large(m_number, m_number_of_own_points - m_equal.size(), limit,
                          m_triangulation.id(hub), cells[hub] / 2 + 2,
                          m_tiling.tree.number_of_tiles());
  }

  const Tiling& m_tiling;
  const std::uint32_t m_number;
  const std::size_t m_limit;
  const std::uint64_t m_bytes = std::uint64_t(m_limit) * bytes_per_point_kept;
  std::size_t m_number_of_own_points = 0;
  std::vector<std::uint64_t> m_known; // ids that were offered, ascending
  std::vector<Told> m_told;           // ascending
  std::vector<std::array<std::uint64_t, 2>> m_equal;
  Tile_triangulation m_triangulation;
  std::size_t m_first_untold = 0; // vertex
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_DELAUNAY_TILE_H
