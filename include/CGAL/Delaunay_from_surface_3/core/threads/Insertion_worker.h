// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_INSERTION_WORKER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_INSERTION_WORKER_H

// Inserts points beside other workers: walks and digs without a lock, announces the zone, checks
// that no other worker interfered, and only then writes.
//
// Two insertions conflict if a cell of one zone is in the other zone or beside it. Both announce
// their zones by their marks, pass a fence, and then read the marks of their zones and of the cells
// beside: at least one sees the other, and gives up with nothing written. If the other has finished
// before, its cleared marks make its writes visible: a first vertex or a neighbour is not the one
// that was read. Insertions whose zones share a cell beside them only write different neighbours of
// it.

#include <CGAL/Delaunay_from_surface_3/core/kernel/Inserter.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Walk_to_conflict.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Explore_announced.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Marks.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Copies cells that others may be writing. It is lost after a number of cells, or at a cell that
// stays busy.
class Read_announced
{
public:
  explicit Read_announced(std::size_t most_cells)
    : m_cells_left(most_cells)
  {
  }

  const Compact_cell& operator()(const Compact_cell& cell)
  {
    m_is_too_far = m_cells_left == 0;
    unsigned tries_left = m_is_too_far ? 0 : 20;
    m_cells_left -= !m_is_too_far;
    while (tries_left > 0 && !read_cell(cell, m_copy))
      --tries_left;
    m_is_lost = tries_left == 0;
    return m_copy;
  }
  bool is_lost() const { return m_is_lost; }
  bool is_too_far() const { return m_is_too_far; } // lost after too many cells
  Id word() const { return m_copy.v[0]; }          // of the cell read last
  Id vertex() const { return m_copy.v[m_copy.v[0] == Compact_numbers::infinite]; }

private:
  std::size_t m_cells_left;
  bool m_is_lost = false, m_is_too_far = false;
  Compact_cell m_copy;
};

enum class Insertion_try {
  DONE,    // the point is a vertex
  PRESENT, // another point was there, or hides it
  CLASH,   // another insertion was in the way; nothing was written
  TOO_FAR, // the walk would have been too long, and came to another point; nothing was written
  NO_CELLS // no fresh cells are left; nothing was written
};

// Says how a worker looks at cells and writes them: it announces its zone.
template <class Vertex_, class Protocol>
struct Announced_to_others
{
  using Vertex = Vertex_;
  using Zone = Announced_zone;
  using Write = Write_announced<Vertex>;
  using Explore = Explore_announced<Vertex, Protocol>;
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS
  using Wide_explore = Wide_explore_announced<Vertex, Protocol>;
#endif

  Write write() const
  {
    return Write(shared.complex().vertices_end());
  }
  template <class Explorer>
  Explorer explore(Zone& zone) const
  {
    return Explorer(zone, shared.marks(), number);
  }

  Shared_complex<Vertex>& shared;
  const unsigned number; // of the worker
};

template <class Vertex, class Protocol = Handshake>
class Insertion_worker
{
  using Complex = Compact_complex<Vertex>;
  using Access = Announced_to_others<Vertex, Protocol>;

public:
  // Makes the worker with this number, which is one of those for which `shared` has marks.
  Insertion_worker(Shared_complex<Vertex>& shared, unsigned number)
    : m_shared(shared)
    , m_number(number)
    , m_inserter(shared.complex(), Access{shared, number})
  {
  }

  // Tries to insert vertex p by a walk of at most `most_cells` cells from `start`, which may be
  // stale. `other` is the vertex that is there already, or to which the walk came.
  Insertion_try insert(Id p, Id start, Id& other,
                       std::size_t most_cells = (std::numeric_limits<std::size_t>::max)())
  {
    const Insertion_try outcome = announce(p, start, other, most_cells);
    return outcome == Insertion_try::DONE ? write(p) : outcome;
  }

  // Does the first half: finds the zone and announces it. DONE says only that this has succeeded.
  Insertion_try announce(Id p, Id start, Id& other, std::size_t most_cells)
  {
    Read_announced read(most_cells);
    const Compact_location location = m_inserter.walk(p, start, read);
    if (read.is_too_far()) {
      other = read.vertex();
      return Insertion_try::TOO_FAR;
    }
    if (read.is_lost())
      return Insertion_try::CLASH;
    if (location.vertex != 0) {
      other = location.vertex;
      if (other == p) // hidden, and for ever, whatever others insert; other walks start there
        store_relaxed(m_shared.complex().vertex(p).cell, location.cell);
      return Insertion_try::PRESENT;
    }
    m_zone.words[0] = read.word();
    if (!m_inserter.dig(p, location.cell))
      return withdraw(Insertion_try::CLASH);
    return has_cells_for_star() ? Insertion_try::DONE : withdraw(Insertion_try::NO_CELLS);
  }

  // Does the second half: writes the star of p if no other worker interfered.
  Insertion_try write(Id p)
  {
    if (Protocol::has_fence)
      full_fence();
    if (!m_inserter.is_zone_still_true())
      return withdraw(Insertion_try::CLASH);
    write_star(p);
    return Insertion_try::DONE;
  }

  const Insertion_counts& counts() const { return m_zone.counts; }

private:
  Insertion_try withdraw(Insertion_try outcome)
  {
    for (std::size_t k = 0; k < m_zone.number_of_cells; ++k)
      release(m_zone.cells[k]);
    return outcome;
  }

  void release(Id c) { store_release(m_shared.marks().mark(c, m_number), std::uint8_t(0)); }

  bool has_cells_for_star()
  {
    if (!m_zone.has_room(m_zone.number_of_facets))
      m_zone.make_room(2 * m_zone.number_of_facets);
    while (m_zone.number_of_cells + m_zone.free_cells.size() < m_zone.number_of_facets)
      if (!m_shared.take_block(m_zone.free_cells))
        return false;
    return true;
  }

  void write_star(Id p)
  {
    Complex& complex = m_shared.complex();
    const std::size_t destroyed = m_zone.number_of_cells, created = m_zone.number_of_facets;
    for (std::size_t k = created; k < destroyed; ++k) {
      Id& word = complex.cell(m_zone.cells[k]).v[0];
      store_relaxed(word, Id(word | Complex::dead));
      release(m_zone.cells[k]);
    }
    m_inserter.fill(p);
    for (std::size_t k = 0; k < (std::min)(destroyed, created); ++k) // their places have new cells
      release(m_zone.cells[k]);
  }

  Shared_complex<Vertex>& m_shared;
  const unsigned m_number;
  Inserter<Access> m_inserter;
  Announced_zone& m_zone = m_inserter.zone;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_INSERTION_WORKER_H
