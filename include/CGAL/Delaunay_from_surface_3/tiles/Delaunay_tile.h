// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_DELAUNAY_TILE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_DELAUNAY_TILE_H

// One tile of a Delaunay triangulation that is larger than a machine: the stars of its own points.
//
// A tile triangulates its own points, and then *tells*: for each edge between points of two tiles,
// the owner of each end is told of the other end. The tile *offers* the points that it is told of
// to its triangulation, which refuses a point that would get no neighbour of the tile's own. A tile
// that is told of a point of its own is asked a question: the answer is the neighbours of this
// point. When no tile has anything to tell, the star of each own point equals its star in the
// triangulation of all points (Brédif et al. 2020 tell without refusal); Tile_certificate.h checks
// that it does.
//
// Refusal is for ever: an edge of the triangulation of all points is an edge in that of any subset
// with both ends, so a point that gets no own neighbour now never gets one.
//
// The cost is that of the insertions; each telling also scans all cells for new ones.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Inserter.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Ordered_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/order/spaced_rounds.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Parallel_triangulation.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/shared_words.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiling.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Equal points share one vertex, so they count only once towards the limit of a tile.

// Returns whether at most `limit` points are left. If there are more, of equal points only the one
// with the smallest id stays, and the ids of the others are noted in `equal` beside it. Points that
// are vertices already stay, too: they are noted when they are inserted.
inline bool fit_when_merged(std::vector<Tile_point>& points, std::size_t limit,
                            const std::array<Tile_point, 4>& vertices,
                            std::vector<std::array<std::uint64_t, 2>>& equal)
{
  if (points.size() <= limit)
    return true;
  const auto is_before = [](const Tile_point& p, const Tile_point& q) {
    return std::lexicographical_compare(p.coordinates, p.coordinates + 3, q.coordinates,
                                        q.coordinates + 3);
  };
  const auto is_vertex = [&](const Tile_point& p) {
    return std::any_of(vertices.begin(), vertices.end(),
                       [&](const Tile_point& v) { return v.id == p.id; });
  };
  std::sort(points.begin(), points.end(), [&](const Tile_point& p, const Tile_point& q) {
    return is_before(p, q) || (!is_before(q, p) && p.id < q.id);
  });
  std::size_t end = 0;
  std::uint64_t smallest = 0; // id, among the points equal to this one
  for (const Tile_point& p : points) {
    const bool is_first = end == 0 || is_before(points[end - 1], p);
    smallest = is_first ? p.id : smallest;
    if (is_first || is_vertex(p))
      points[end++] = p;
    else
      equal.push_back({p.id, smallest});
  }
  points.resize(end);
  return end <= limit;
}

// The new part of what a tile was told.

struct Tile_news
{
  std::vector<Tile_point> offers;      // ascending by id, each once
  std::vector<Tile_message> questions; // about points of the tile's own

  bool empty() const { return offers.empty() && questions.empty(); }
};

// Returns the news for tile t, which knows the ids in `known`, in ascending order. The sample comes
// from the tile itself, and asks nothing.
inline Tile_news news_of(std::vector<Tile_message> messages, const Tiling& tiling, std::uint32_t t,
                         const std::vector<std::uint64_t>& known)
{
  Tile_news news;
  std::size_t number = 0;
  for (const Tile_message& message : messages)
    number += message.points.size();
  news.offers.reserve(number);
  for (Tile_message& message : messages) {
    Tile_message question{message.from, t, {}};
    for (const Tile_point& p : message.points)
      if (tiling.tree.owner(p.coordinates) == t)
        question.points.push_back(p);
      else
        news.offers.push_back(p);
    if (message.from != t && !question.points.empty())
      news.questions.push_back(std::move(question));
    std::vector<Tile_point>().swap(message.points);
  }
  std::sort(news.offers.begin(), news.offers.end(),
            [](const Tile_point& p, const Tile_point& q) { return p.id < q.id; });
  auto k = known.begin();
  std::uint64_t last = std::uint64_t(-1);
  const auto is_old = [&](const Tile_point& p) {
    while (k != known.end() && *k < p.id)
      ++k;
    const bool is_known = (k != known.end() && *k == p.id) || p.id == last;
    last = p.id;
    return is_known;
  };
  news.offers.erase(std::remove_if(news.offers.begin(), news.offers.end(), is_old),
                    news.offers.end());
  return news;
}

// A tile with fewer points than these is triangulated by one thread.
constexpr std::size_t least_points_for_threads = 10000;

// Inserts all vertices after the `first` ones, which are in cells already, in rounds that end at
// `first` + round_ends; each worker starts from the vertex that it inserted before. Returns the
// vertex at each place, which is the number of the point's own vertex less 1; equal points have the
// vertex of one of them. check() is called now and then, and may throw.
template <class Check>
std::vector<Id> insert_by_threads(Compact_complex<Compact_vertex>& complex, std::size_t first,
                                  const std::vector<std::size_t>& round_ends,
                                  const Executor& executor, const Check& check)
{
  std::vector<Id> vertex_of(complex.vertices_end() - 1, 0);
  std::iota(vertex_of.begin(), vertex_of.begin() + std::ptrdiff_t(first), Id(1));
  Parallel_triangulation<Compact_vertex> workers(complex, executor);
  std::size_t place = first;
  for (const std::size_t end : round_ends)
    while (place < first + end) {
      const std::size_t next = (std::min)(first + end, place + workers.size_of_chunk(place));
      workers.insert_chunk(place, next, vertex_of,
                           Starting_cells<Compact_vertex>(complex, vertex_of, nullptr, 1),
                           [](std::size_t) { return true; });
      place = next;
      workers.note_cells();
      check();
    }
  workers.finish();
  return vertex_of;
}

// The triangulation of a tile, with its own points and those of others that it keeps. Beside the
// complex, which has the coordinates, it takes 12 bytes per vertex.

class Tile_triangulation
{
public:
  using Id = core::Id;
  using Complex = Compact_complex<Compact_vertex>;
  using Cell = Compact_cell;

  static constexpr std::uint64_t infinite_id = std::uint64_t(-1);
  static constexpr std::uint32_t nobody = std::uint32_t(-1); // the owner of the infinite vertex

  // Triangulates the four points that all tiles keep, with room for others. Keeps a reference.
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
  // insert() does. Both make the same vertices, and the same cells in different orders. check() is
  // called now and then, and may throw.
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

  // Inserts the points for which wants() holds when the conflict zone is dug, in random rounds,
  // each sorted by halves; each walk starts from the point before. If p has the place of vertex v,
  // equal(v, id of p, id of v) says whether v takes the smaller of the two ids.
  template <class Wants, class Equal>
  void insert(std::vector<Tile_point> points, unsigned int seed, const Wants& wants,
              const Equal& equal)
  {
    add_vertices(points, order_of(points, seed).order);
    std::vector<Tile_point>().swap(points);
    const std::size_t end = m_ids.size();
    for (std::size_t v = m_vertices_end; v < end; ++v) {
      const auto p = Id(m_vertices_end); // the vertices before it are in cells
      renumber_vertex(Id(v), p);
      m_vertices_end += insert(p, wants, equal);
    }
    drop_vertices(m_vertices_end);
  }

  // For wants(): returns whether the point would get a neighbor that this tile owns.
  bool would_touch(std::uint32_t tile) const
  {
    const auto& zone = m_inserter.zone;
    for (std::size_t f = 0; f < zone.number_of_facets; ++f)
      for (const Id v : zone.facets[f].corners)
        if (m_owners[v] == tile)
          return true;
    return false;
  }

  // Returns how many bytes the cells and vertices take.
  std::uint64_t bytes() const
  {
    return m_complex.cells_end() * sizeof(Cell) +
           m_ids.size() * (sizeof(Complex::Vertex) + sizeof(std::uint64_t) + sizeof(std::uint32_t));
  }

  // The number of vertices, including the infinite one, which is vertex 0.
  std::size_t vertices_end() const { return m_vertices_end; }
  std::uint64_t id(Id v) const { return m_ids[v]; }
  std::uint32_t owner(Id v) const { return m_owners[v]; }
  Tile_point point(Id v) const
  {
    const auto c = m_complex.is_rounded() ? m_complex.own_coordinates(v)
                                          : m_scaled.before(m_complex.vertex(v).coordinates);
    return {m_ids[v], {c[0], c[1], c[2]}};
  }

  // Returns the owner of the vertex with the smallest id. Branches would be predicted badly.
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

  // Adds vertices for the points in this order; they are in no cell yet.
  void add_vertices(const std::vector<Tile_point>& points, const std::vector<std::size_t>& order)
  {
    for (std::size_t k = 0; k < order.size(); ++k) {
      prefetch(&points[order[(std::min)(k + 8, order.size() - 1)]]);
      const double* const c = points[order[k]].coordinates;
      m_complex.add_vertex(m_scaled(c));
      note_vertex(points[order[k]]);
    }
  }

  // Notes the data of a vertex that the complex has, at the same position as there.
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

  // Inserts vertex p if it is wanted and its place is free; returns whether it is in cells now.
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

  // Notes that p has the place of v: the smallest id stands for all equal points.
  template <class Equal>
  void note_equal(Id v, Id p, const Equal& equal)
  {
    if (equal(v, m_ids[p], m_ids[v]))
      m_ids[v] = (std::min)(m_ids[v], m_ids[p]);
  }

  // Equal points have one vertex, which may be that of any of them; the vertices of the others are
  // in no cell. So vertices are renumbered by their first places, as if one thread had inserted
  // them.
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
  Inserter<Alone_with_complex<Compact_vertex>> m_inserter;
  Id m_previous = 1;
  std::size_t m_vertices_end = 5;   // the vertices from here on are in no cell yet
  std::vector<std::uint64_t> m_ids; // by vertex; the smallest id of equal points
  std::vector<std::uint32_t> m_owners;
};

class Delaunay_tile
{
public:
  using Id = Tile_triangulation::Id;
  using Cell = Tile_triangulation::Cell;

  // Makes a tile of the points that are its own, as it was in a state; all workers insert them. A new
  // one has told nothing yet. Keeps a reference to the tiling. Throws Tile_too_large if more than
  // `limit` points are kept.
  Delaunay_tile(const Tiling& tiling, std::uint32_t number, std::vector<Tile_point> own,
                Tile_state state, bool is_new, std::size_t limit, const Executor& executor)
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

  // Pairs of the id of an own point and a smaller id of a point that is equal to it.
  const std::vector<std::array<std::uint64_t, 2>>& equal_points() const { return m_equal; }

  // Offers new points to the tile. If not all might fit, they are inserted in portions of an eighth
  // of the points that may be kept.
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

  // Returns what there is to tell now, and the answers to questions.
  std::vector<Tile_message> tell_and_answer(const std::vector<Tile_message>& questions)
  {
    std::vector<Tile_message> messages = tell(m_first_untold == 0);
    answer(questions, messages);
    return messages;
  }

  // To be called if the certificate does not hold: tells each of these partners of all vertices of
  // the cells that have a vertex of both. The partner's own ones are questions. If the two tiles
  // see different common cells, one of them learns something: from a cell that the partner lacks,
  // it either takes a vertex that it lacked, or its answer has a point in conflict with the cell;
  // this point gets all vertices of the cell as neighbours, so it is not refused (witnesses, as in
  // star splaying).
  std::vector<Tile_message> witnesses(const std::vector<std::uint32_t>& partners) const
  {
    std::vector<Tile_message> messages;
    messages.reserve(partners.size());
    for (const std::uint32_t to : partners)
      messages.push_back({m_number, to, points_around(to)});
    return messages;
  }

  // Returns the state at the end; the tile must not be used after this.
  Tile_state state() &&
  {
    Tile_state state{{}, std::move(m_known), std::move(m_told)};
    for (std::size_t v = 5; v < m_triangulation.vertices_end(); ++v) // after those of all tiles
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
    } catch (const Too_many_cells&) { // for cells: a hub has many
      throw too_large((std::min)(m_limit, number_of_points_kept()));
    }
  }

  bool wants() const
  {
    const bool is_wanted = m_triangulation.would_touch(m_number);
    if (is_wanted && number_of_points_kept() >= m_limit)
      throw too_large(m_limit);
    check_bytes();
    return is_wanted;
  }

  // Throws if few points have so many cells that they take more memory than allowed.
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

  // Calls visit(v, to) for each edge of a new cell from a finite vertex v to a vertex of tile `to`,
  // if `to` is neither the owner of v nor this tile; it visits edges again and again. If `asks` is
  // true, it also calls visit(v, owner of v) for each edge from v to an own vertex.
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

  // For each edge between points of two tiles, tells the owner of each end of the other end, once.
  // No tile has told of the points that all tiles get, so the first time their owners are asked
  // about those that have own neighbours here. No such edge is made later, and an owner that would
  // refuse the other end would not say so unasked.
  std::vector<Tile_message> tell(bool asks)
  {
    if (m_first_untold == m_triangulation.vertices_end())
      return {};
    std::vector<std::pair<std::uint32_t, Id>> tells; // (to, v): tile `to` is told of v
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

  // A tile that asks about an own point is told of its neighbours, except for those that the asker
  // owns, which would be questions.
  void answer(const std::vector<Tile_message>& questions, std::vector<Tile_message>& messages)
  {
    std::multimap<Id, std::size_t> asked; // questions, by vertex
    for (std::size_t a = 0; a < questions.size(); ++a)
      m_triangulation.insert(
          questions[a].points, m_number, [] { return false; },
          [&](Id v, std::uint64_t, std::uint64_t) {
            asked.emplace(v, a);
            return false; // the asker's id is no better
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

  // Returns the finite vertices of the cells that have vertices of both tiles.
  std::vector<Tile_point> points_around(std::uint32_t partner) const
  {
    std::vector<char> is_around(m_triangulation.vertices_end());
    m_triangulation.for_each_cell([&](const Cell& cell) {
      if (has_vertex_of(cell, m_number) && has_vertex_of(cell, partner))
        for (const Id v : cell.v)
          is_around[v] = 1;
    });
    std::vector<Tile_point> points;
    for (std::size_t v = 1; v < is_around.size(); ++v)
      if (is_around[v])
        points.push_back(m_triangulation.point(Id(v)));
    return points;
  }

  // The vertex with the most neighbours is blamed.
  Tile_too_large too_large(std::size_t limit) const
  {
    std::vector<std::uint32_t> cells(m_triangulation.vertices_end());
    m_triangulation.for_each_cell([&](const Cell& cell) {
      for (const Id v : cell.v)
        ++cells[v];
    });
    const auto hub = Id(std::max_element(cells.begin() + 1, cells.end()) - cells.begin());
    return tile_too_large(m_number, m_number_of_own_points - m_equal.size(), limit,
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
  std::size_t m_first_untold = 0; // a vertex
};

// The result of a tile, as a Delaunay_3_tile, but its cells are handed out one after the other: an
// array of them would take half as much memory as the triangulation. Keeps a reference. Takes
// linear time, except for sorting the vertices.
class Piece_of_tile
{
public:
  using Id = Tile_triangulation::Id;

  explicit Piece_of_tile(const Delaunay_tile& tile)
    : m_tile(tile)
  {
    find_kinds();
    sort_vertices();
    note_equal_points();
  }

  std::uint32_t number() const { return m_tile.number(); }
  std::size_t number_of_own_vertices() const { return m_number_of_own_vertices; }
  std::size_t number_of_cells() const
  {
    return number_of_owned_cells() + m_number_of_cells[OF_OTHERS];
  }
  std::size_t number_of_owned_cells() const
  {
    return number_of_owned_finite_cells() + m_number_of_cells[OWNED_INFINITE];
  }
  std::size_t number_of_owned_finite_cells() const { return m_number_of_cells[OWNED_FINITE]; }

  // For each point that is equal to another: its id, and the smallest id, which stands for it.
  const std::vector<std::array<std::uint64_t, 2>>& equal_points() const { return m_equal_points; }

  // The vertices of the stars of own points: first the own ones, then the others, each by id.
  std::size_t number_of_vertices() const { return m_vertices.size(); }
  template <class Visit>
  void for_each_vertex(const Visit& visit) const
  {
    for (const Id v : m_vertices)
      visit(m_tile.triangulation().point(v));
  }

  template <class Visit>
  void for_each_cell(const Visit& visit) const
  {
    std::vector<std::int32_t> places(m_tile.triangulation().vertices_end(), -1);
    for (std::size_t k = 0; k < m_vertices.size(); ++k)
      places[m_vertices[k]] = std::int32_t(k);
    for (const Kind wanted : {OWNED_FINITE, OWNED_INFINITE, OF_OTHERS})
      for_each_cell_and_kind([&](const Cell& cell, Kind kind) {
        if (kind == wanted)
          visit(Delaunay_3_tile::Cell{places[cell.v[0]], places[cell.v[1]], places[cell.v[2]],
                                      places[cell.v[3]]});
      });
  }

private:
  using Cell = Tile_triangulation::Cell;

  // The relation of a cell to a tile; FAR cells have no vertex of its own.
  enum Kind : unsigned char { OWNED_FINITE, OWNED_INFINITE, OF_OTHERS, FAR };

  template <class Visit>
  void for_each_cell_and_kind(const Visit& visit) const
  {
    auto kind = m_kinds.begin();
    m_tile.triangulation().for_each_cell([&](const Cell& cell) { visit(cell, *kind++); });
  }

  void find_kinds()
  {
    const Tile_triangulation& tr = m_tile.triangulation();
    tr.for_each_cell([&](const Cell& cell) {
      const auto own = std::count_if(cell.v, cell.v + 4, [&](Id v) { return m_tile.is_own(v); });
      const bool is_owned = own == 4 || (own > 0 && tr.owner_of(cell) == number());
      m_kinds.push_back(own == 0                                         ? FAR
                        : !is_owned                                      ? OF_OTHERS
                        : Tile_triangulation::Complex::is_infinite(cell) ? OWNED_INFINITE
                                                                         : OWNED_FINITE);
      ++m_number_of_cells[m_kinds.back()];
    });
  }

  void sort_vertices()
  {
    const Tile_triangulation& tr = m_tile.triangulation();
    std::vector<char> is_used(tr.vertices_end());
    for_each_cell_and_kind([&](const Cell& cell, Kind kind) {
      if (kind != FAR)
        for (const Id v : cell.v)
          is_used[v] = 1;
    });
    m_vertices.reserve(std::size_t(std::count(is_used.begin() + 1, is_used.end(), 1)));
    for (const bool of_others : {false, true}) {
      const auto first = std::ptrdiff_t(m_vertices.size());
      for (std::size_t v = 1; v < is_used.size(); ++v)
        if (is_used[v] && m_tile.is_own(Id(v)) != of_others)
          m_vertices.push_back(Id(v));
      std::sort(m_vertices.begin() + first, m_vertices.end(),
                [&](Id v, Id w) { return tr.id(v) < tr.id(w); });
      if (!of_others)
        m_number_of_own_vertices = m_vertices.size();
    }
  }

  void note_equal_points()
  {
    std::map<std::uint64_t, std::uint64_t> smaller;
    for (const auto& [p, q] : m_tile.equal_points())
      smaller.emplace(p, q);
    for (const auto& pair : smaller) {
      auto root = smaller.find(pair.second);
      std::uint64_t id = pair.second;
      for (; root != smaller.end(); root = smaller.find(id))
        id = root->second;
      m_equal_points.push_back({pair.first, id});
    }
  }

  const Delaunay_tile& m_tile;
  std::vector<Kind> m_kinds; // by cell, in their order
  std::array<std::size_t, 4> m_number_of_cells{};
  std::vector<Id> m_vertices;
  std::size_t m_number_of_own_vertices = 0;
  std::vector<std::array<std::uint64_t, 2>> m_equal_points;
};

inline Delaunay_3_tile piece_of(const Delaunay_tile& tile)
{
  const Piece_of_tile from(tile);
  Delaunay_3_tile piece;
  piece.number = from.number();
  piece.ids.reserve(from.number_of_vertices());
  piece.points.reserve(from.number_of_vertices());
  from.for_each_vertex([&](const Tile_point& p) {
    piece.ids.push_back(p.id);
    piece.points.push_back({p.coordinates[0], p.coordinates[1], p.coordinates[2]});
  });
  piece.number_of_own_vertices = from.number_of_own_vertices();
  piece.cells.reserve(from.number_of_cells());
  from.for_each_cell([&](const Delaunay_3_tile::Cell& cell) { piece.cells.push_back(cell); });
  piece.number_of_owned_cells = from.number_of_owned_cells();
  piece.number_of_owned_finite_cells = from.number_of_owned_finite_cells();
  piece.equal_points = from.equal_points();
  return piece;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_DELAUNAY_TILE_H
