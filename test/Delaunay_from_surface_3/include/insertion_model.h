// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_INSERTION_MODEL_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_INSERTION_MODEL_H

// The parallel kernel in one dimension: the triangulation is the lower convex hull of points (x,
// height), which is unique, as a Delaunay triangulation is. A cell is an interval with two vertices
// and two neighbours; a point is in conflict with a cell if it lies below its line; the zone is an
// interval; its star has two cells, and what was between is in no cell any more, as vertices that
// heavier ones swallow. So zones of one, two or three cells take a fresh cell, or none, or give one
// back. A point above the hull is hidden when it comes.
//
// What is shared is read and written as in Insertion_worker.h, Explore_announced.h and
// Ordered_complex.h, access by access: each function here has the name of one there. Not modelled:
// the growth of arrays, stores that make a fresh cell dead, before anybody can have it as a
// neighbour, and two zones with a vertex in common that do not clash: on a line there are none.

#include "memory_models.h"
#include "model_case.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace model {

// The parts that can be left out: Handshake's, and the orders of loads and stores.
struct Protocol
{
  bool has_fence = true;
  bool masks_own_mark = true;
  bool compares_neighbors = true;
  bool compares_outside = true;
  bool heeds_busy = true;

  bool acquires_words = true;
  bool acquires_marks = true;
  bool releases_marks = true;
  bool releases_words = true;
  bool releases_outer_neighbors = true;
  bool has_release_fence = true; // after the store that makes a cell busy
  bool has_acquire_fence = true; // before the second reading of the word

  bool replaces_dead_starts = true; // Starting_cells::living_cell()
  bool looks_for_vertex = true;     // is_in_cell(), which tells in the end what is hidden
};

// --- one worker --------------------------------------------------------------------------------

// Between two attempts to insert; the rest is forgotten.
struct Worker_state
{
  std::vector<Byte> tasks_left, clashed; // numbers of tasks
  std::vector<Byte> free_cells;
  bool is_second_try = false;

  std::string key() const
  {
    std::string s;
    for (const auto* list : {&tasks_left, &clashed, &free_cells}) {
      s += char(list->size());
      s.append(list->begin(), list->end());
    }
    return s + char(is_second_try);
  }
};

// Access: load(location, order), store(location, value, order), fence(order), and what is said to
// the checker: takes(…), makes(…), commits(…), has_written().
template <class Access>
class Worker
{
  struct Cell
  {
    Byte v[2], neighbors[2];
  };
  struct Facet
  {
    Byte outside, corner; // the cell, encoded; the vertex
  };

public:
  Worker(const Case& c, const Protocol& protocol, Access& access, unsigned number,
         std::vector<Byte>& free_cells)
    : m_case(c)
    , m_protocol(protocol)
    , m_access(access)
    , m_at(c)
    , m_number(number)
    , m_free_cells(free_cells)
  {
  }

  // Returns false if it clashed, to which a walk of more cells counts too. If the cell of `start`
  // is dead, one that lives is sought among the first `known_cells`.
  bool insert(Byte p, Byte start, unsigned known_cells, unsigned most_cells = 3)
  {
    Cell cell;
    const Walk_end end = walk(p, cell_of_start(start, known_cells), cell, most_cells);
    if (end == Walk_end::LOST)
      return false;
    if (end == Walk_end::HIDDEN) { // for ever, whatever others insert
      m_access.store(m_at.cell_of(p), m_cells[0], Order::RELAXED);
      return true;
    }
    m_words = {cell.v[0]};
    if (!dig(p))
      return withdraw();
    if (m_cells.size() + m_free_cells.size() < m_facets.size())
      return withdraw(); // no cells
    if (m_protocol.has_fence)
      m_access.fence(Order::FULL);
    if (!is_still_true())
      return withdraw();
    tell_commitment();
    write_star(p);
    m_access.has_written();
    return true;
  }

private:
  Order acquire_if(bool b) const { return b ? Order::ACQUIRE : Order::RELAXED; }
  Order release_if(bool b) const { return b ? Order::RELEASE : Order::RELAXED; }

  // --- reading ---------------------------------------------------------------------------------

  // Starting_cells, which would first try the vertex inserted before.
  unsigned cell_of_start(Byte start, unsigned known_cells)
  {
    unsigned c = m_access.load(m_at.cell_of(start), Order::RELAXED);
    for (unsigned left = m_protocol.replaces_dead_starts ? known_cells : 0;
         left > 0 && (m_access.load(m_at.v(c, 0), Order::RELAXED) & busy) != 0; --left)
      c = c + 1 < known_cells ? c + 1 : 0;
    return c;
  }

  bool read_cell(unsigned c, Cell& copy)
  {
    const Byte word = m_access.load(m_at.v(c, 0), acquire_if(m_protocol.acquires_words));
    copy.v[0] = word;
    copy.v[1] = m_access.load(m_at.v(c, 1), Order::RELAXED);
    for (unsigned k = 0; k < 2; ++k)
      copy.neighbors[k] = m_access.load(m_at.neighbor(c, k), Order::RELAXED);
    if (m_protocol.has_acquire_fence)
      m_access.fence(Order::ACQUIRE);
    if ((word & busy) != 0 || m_access.load(m_at.v(c, 0), Order::RELAXED) != word)
      return false;
    m_access.takes(c, word, copy.v[1]); // as a whole
    return true;
  }

  enum class Walk_end { IN_CONFLICT, HIDDEN, LOST };

  // One try for each cell instead of 20. No two points are above each other.
  Walk_end walk(Byte p, unsigned c, Cell& cell, unsigned most_cells)
  {
    for (unsigned cells_left = most_cells; cells_left > 0; --cells_left) {
      if (!read_cell(c, cell))
        return Walk_end::LOST;
      m_cells = {Byte(c)};
      if (m_case.is_below(p, cell.v[0], cell.v[1]))
        return Walk_end::IN_CONFLICT;
      const auto is_beyond = [&](unsigned k) {
        const int x = m_case.point(cell.v[k]).x;
        return (m_case.point(p).x > x) == (x > m_case.point(cell.v[1 - k]).x);
      };
      if (!is_beyond(0) && !is_beyond(1))
        return Walk_end::HIDDEN;
      c = cell.neighbors[is_beyond(1) ? 0 : 1] / 2;
    }
    return Walk_end::LOST;
  }

  // Dig_conflict_zone with Explore_announced.
  bool dig(Byte p)
  {
    m_facets.clear();
    m_outside_words.clear();
    m_neighbors.clear();
    m_own_marks.assign(m_case.number_of_cells(), 0); // as stored: nobody else writes them
    set_own_mark(m_cells[0], 1);                     // mark()
    for (std::size_t k = 0; k < m_cells.size(); ++k)
      if (!look_around(p, read(k)))
        return false;
    return true;
  }

  // The word was read when the cell was looked at as a neighbour, or on the walk.
  Cell read(std::size_t k)
  {
    Cell cell;
    cell.v[0] = m_words[k];
    cell.v[1] = m_access.load(m_at.v(m_cells[k], 1), Order::RELAXED);
    for (unsigned i = 0; i < 2; ++i)
      cell.neighbors[i] = m_access.load(m_at.neighbor(m_cells[k], i), Order::RELAXED);
    m_neighbors.push_back({cell.neighbors[0], cell.neighbors[1]});
    return cell;
  }

  // around(), note(). Returns false if something was torn.
  bool look_around(Byte p, const Cell& cell)
  {
    Byte words[2], opposite[2];
    bool is_torn = false, is_open[2];
    for (unsigned k = 0; k < 2; ++k) {
      const Byte neighbor = cell.neighbors[k];
      words[k] = m_access.load(m_at.v(neighbor / 2, 0), acquire_if(m_protocol.acquires_words));
      opposite[k] = m_access.load(m_at.v(neighbor / 2, neighbor % 2), Order::RELAXED) & Byte(~busy);
      is_torn |= m_protocol.heeds_busy && (words[k] & busy) != 0;
      is_open[k] = m_own_marks[neighbor / 2] == 0;
    }
    for (unsigned k = 0; k < 2; ++k) {
      const Byte neighbor = cell.neighbors[k], corner = cell.v[1 - k] & Byte(~busy);
      const bool joins = !is_torn && is_open[k] && m_case.is_below(p, corner, opposite[k]);
      set_own_mark(neighbor / 2, m_own_marks[neighbor / 2] | Byte(joins));
      if (joins) {
        m_cells.push_back(neighbor / 2);
        m_words.push_back(words[k]);
      } else if (is_open[k]) {
        m_facets.push_back({neighbor, corner});
        m_outside_words.push_back(words[k]);
      }
    }
    return !is_torn;
  }

  void set_own_mark(unsigned c, Byte value)
  {
    m_own_marks[c] = value;
    m_access.store(m_at.mark(c, m_number), value, Order::RELAXED);
  }

  // --- validating ------------------------------------------------------------------------------

  // compare(): there all differences are added up, and one branch is taken; here it ends at the
  // first, since nothing is written either way.
  bool is_still_true()
  {
    for (std::size_t k = 0; k < m_cells.size(); ++k) {
      if (has_other_mark(m_cells[k]) || load_word(m_cells[k]) != m_words[k])
        return false;
      for (unsigned i = 0; m_protocol.compares_neighbors && i < 2; ++i)
        if (m_access.load(m_at.neighbor(m_cells[k], i), Order::RELAXED) != m_neighbors[k][i])
          return false;
    }
    for (std::size_t f = 0; m_protocol.compares_outside && f < m_facets.size(); ++f) {
      const unsigned outside = m_facets[f].outside / 2;
      if (has_other_mark(outside) || load_word(outside) != m_outside_words[f])
        return false;
    }
    return true;
  }

  bool has_other_mark(unsigned c)
  {
    for (unsigned w = 0; w < m_case.number_of_workers(); ++w)
      if ((w != m_number || !m_protocol.masks_own_mark) &&
          m_access.load(m_at.mark(c, w), acquire_if(m_protocol.acquires_marks)) != 0)
        return true;
    return false;
  }

  Byte load_word(unsigned c)
  {
    return m_access.load(m_at.v(c, 0), acquire_if(m_protocol.acquires_words));
  }

  // --- writing ---------------------------------------------------------------------------------

  bool withdraw()
  {
    for (const Byte c : m_cells)
      release(c);
    return false;
  }

  void release(unsigned c)
  {
    m_access.store(m_at.mark(c, m_number), 0, release_if(m_protocol.releases_marks));
  }

  void write_star(Byte p)
  {
    const std::size_t destroyed = m_cells.size(), created = m_facets.size();
    for (std::size_t k = created; k < destroyed; ++k) {
      m_access.store(m_at.v(m_cells[k], 0), m_words[k] | busy, Order::RELAXED);
      release(m_cells[k]);
    }
    const std::vector<Byte> zone = m_cells;
    take_cells_of_star();
    fill_star(p);
    for (std::size_t k = 0; k < (std::min)(destroyed, created); ++k)
      release(zone[k]);
  }

  void take_cells_of_star()
  {
    while (m_cells.size() < m_facets.size()) {
      m_cells.push_back(m_free_cells.back());
      m_free_cells.pop_back();
    }
    while (m_cells.size() > m_facets.size()) {
      m_free_cells.push_back(m_cells.back());
      m_cells.pop_back();
    }
  }

  // Fill_star with Write_announced.
  void fill_star(Byte p)
  {
    m_access.store(m_at.cell_of(p), m_cells[0], Order::RELAXED); // set_cell()
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
      const Byte c = m_cells[i], outside = m_facets[i].outside;
      m_access.makes(c, p, m_facets[i].corner);
      m_access.store(m_at.v(c, 0), p | busy, Order::RELAXED); // open()
      if (m_protocol.has_release_fence)
        m_access.fence(Order::RELEASE);
      m_access.store(m_at.v(c, 1), m_facets[i].corner, Order::RELAXED);
      m_access.store(m_at.neighbor(c, 0), outside, Order::RELAXED);
      m_access.store(m_at.neighbor(outside / 2, outside % 2), encode(c, 0), // set_outer_neighbor()
                     release_if(m_protocol.releases_outer_neighbors));
      m_access.store(m_at.cell_of(m_facets[i].corner), c, Order::RELAXED); // set_cell_of_corners()
    }
    for (std::size_t i = 0; i < m_cells.size();
         ++i) { // the star of a point on a line has two cells
      m_access.store(m_at.neighbor(m_cells[i], 1), encode(m_cells[(i + 1) % m_cells.size()], 1),
                     Order::RELAXED);
      m_access.store(m_at.v(m_cells[i], 0), p, release_if(m_protocol.releases_words)); // close()
    }
  }

  // To the checker: from here on this insertion believes in all that it read.
  void tell_commitment()
  {
    unsigned zone = 0, beside = 0;
    for (const Byte c : m_cells)
      zone |= 1u << c;
    for (const Facet& f : m_facets)
      beside |= 1u << f.outside / 2;
    m_access.commits(zone, beside);
  }

  const Case& m_case;
  const Protocol& m_protocol;
  Access& m_access;
  const Layout m_at;
  const unsigned m_number;
  std::vector<Byte>& m_free_cells;
  std::vector<Byte> m_cells, m_words, m_outside_words, m_own_marks;
  std::vector<Facet> m_facets;
  std::vector<std::array<Byte, 2>> m_neighbors;
};

} // namespace model

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_INSERTION_MODEL_H
