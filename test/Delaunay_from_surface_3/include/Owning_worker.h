// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_OWNING_WORKER_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_OWNING_WORKER_H

// Stands in for Insertion_worker: the same promises, kept in another way, that of Geogram. Whoever
// looks at a cell owns it until the star is written: it is got by one compare-and-swap, and if
// somebody else has it the insertion clashes. Nothing is announced, nothing validated, no fence.
// What a triangulation made by this worker does, too, is not the handshake's fault.

#include <CGAL/Delaunay_from_surface_3/core/threads/Insertion_worker.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace tests {

namespace DFS = CGAL::Delaunay_from_surface_3;

template <class Vertex>
class Owning_worker
{
  using Complex = DFS::internal::Compact_complex<Vertex>;
  using Id = DFS::internal::Id;
  using Cell = typename Complex::Cell;
  using Predicates = DFS::internal::Compact_predicates<Vertex>;
  using Read = DFS::internal::Read_announced;
  using Write = DFS::internal::Write_announced<Vertex>;
  using Insertion_try = DFS::internal::Insertion_try;

public:
  Owning_worker(DFS::internal::Shared_complex<Vertex>& shared, unsigned number)
    : m_shared(shared)
    , m_own(std::uint8_t(number + 1))
    , m_fill_star(Write(shared.complex().vertices_end()))
  {
  }

  Insertion_try insert(Id p, Id start, Id& present,
                       std::size_t most_cells = (std::numeric_limits<std::size_t>::max)())
  {
    const Insertion_try outcome = try_to_insert(p, start, present, most_cells);
    for (const Id c : m_owned)
      DFS::internal::store_release(owner(c), std::uint8_t(0));
    m_owned.clear();
    return outcome;
  }

  const DFS::Insertion_counts& counts() const { return m_zone.counts; }

private:
  static constexpr std::uint8_t in_zone = 0x80;

  Insertion_try try_to_insert(Id p, Id start, Id& present, std::size_t most_cells)
  {
    Predicates predicates(m_shared.complex(), m_zone.counts);
    Read read(most_cells);
    const auto location = DFS::internal::Walk_to_conflict<DFS::internal::Sphere_filter, Read&>()(
        m_shared.complex(), predicates, p, start, read);
    if (read.is_lost())
      return Insertion_try::CLASH;
    if (location.vertex != 0) {
      present = location.vertex;
      return Insertion_try::PRESENT;
    }
    // Nobody had it for a moment: is it still the cell that was read?
    if (!own(location.cell) || m_shared.complex().cell(location.cell).v[0] != read.word() ||
        !dig(predicates, p, location.cell))
      return Insertion_try::CLASH;
    if (!own_cells_of_star())
      return Insertion_try::NO_CELLS;
    for (std::size_t k = m_zone.number_of_facets; k < m_zone.number_of_cells; ++k) {
      Id& word = m_shared.complex().cell(m_zone.cells[k]).v[0];
      DFS::internal::store_relaxed(word, Id(word | Complex::dead));
    }
    m_fill_star(m_shared.complex(), m_zone, p);
    return Insertion_try::DONE;
  }

  bool dig(Predicates& predicates, Id p, Id first)
  {
    const Complex& complex = m_shared.complex();
    m_zone.number_of_cells = m_zone.number_of_facets = 0;
    join(first);
    for (std::size_t k = 0; k < m_zone.number_of_cells; ++k) {
      const Cell& cell = complex.cell(m_zone.cells[k]);
      for (unsigned i = 0; i < 4; ++i) {
        const Id neighbor = cell.neighbors[i] >> 2;
        if (!own(neighbor))
          return false;
        if (is_in_zone(neighbor))
          continue;
        if (predicates.is_in_conflict(complex.cell(neighbor), p))
          join(neighbor);
        else
          append_facet(cell, i);
      }
    }
    m_zone.counts.cells_destroyed += m_zone.number_of_cells;
    m_zone.counts.cells_created += m_zone.number_of_facets;
    return true;
  }

  void join(Id c)
  {
    make_room();
    DFS::internal::store_relaxed(owner(c), std::uint8_t(m_own | in_zone));
    m_zone.cells[m_zone.number_of_cells++] = c;
  }

  void append_facet(const Cell& cell, unsigned i)
  {
    make_room();
    const auto& corners = DFS::internal::facet_corners[i];
    m_zone.facets[m_zone.number_of_facets++] = {
        cell.neighbors[i], {cell.v[corners[0]], cell.v[corners[1]], cell.v[corners[2]]}};
  }

  void make_room()
  {
    if (!m_zone.has_room((std::max)(m_zone.number_of_cells, m_zone.number_of_facets) + 1))
      m_zone.make_room(2 * m_zone.room());
  }

  // Free cells, too: they can be seen from the part of the star that is written.
  bool own_cells_of_star()
  {
    while (m_zone.number_of_cells + m_zone.free_cells.size() < m_zone.number_of_facets)
      if (!m_shared.take_block(m_zone.free_cells))
        return false;
    for (std::size_t k = m_zone.number_of_cells; k < m_zone.number_of_facets; ++k)
      while (!own(m_zone.free_cells[m_zone.free_cells.size() - 1 - (k - m_zone.number_of_cells)])) {
        // somebody looks whether it is a cell that he read before, and gives it back
      }
    return true;
  }

  std::uint8_t& owner(Id c) { return m_shared.marks().mark(c, 0); }
  bool is_in_zone(Id c) { return (DFS::internal::load_relaxed(owner(c)) & in_zone) != 0; }

  bool own(Id c)
  {
    std::uint8_t expected = 0;
    if (__atomic_compare_exchange_n(&owner(c), &expected, m_own, false, __ATOMIC_ACQ_REL,
                                    __ATOMIC_RELAXED)) {
      m_owned.push_back(c);
      return true;
    }
    return (expected & ~in_zone) == m_own;
  }

  DFS::internal::Shared_complex<Vertex>& m_shared;
  const std::uint8_t m_own;
  DFS::internal::Conflict_zone m_zone;
  std::vector<Id> m_owned;
  DFS::internal::Fill_star<Vertex, Write> m_fill_star;
};

} // namespace tests

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_OWNING_WORKER_H
