// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_IN_MEMORY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_IN_MEMORY_H

// Consecutive tiles that are in the memory of this process, all or some, and what they were told.

#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/support/Thread_executor.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Delaunay_3_tile.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Delaunay_tile.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_certificate.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_news.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_point.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiling.h>
#include <CGAL/Delaunay_from_surface_3/tiles/piece_of_tile.h>
#include <CGAL/Delaunay_from_surface_3/tiles/run_tasks.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

class Tiles_in_memory
{
public:
  explicit Tiles_in_memory(std::size_t number_of_threads)
    : m_executor(number_of_threads)
  {
  }

  // Makes tiles first, first + 1, … of their own points. Keeps a reference. done(k) is called by
  // any thread when one more is made.
  template <class Done>
  void begin(const Tiling& tiling, std::uint32_t first, std::vector<std::vector<Tile_point>> own,
             std::size_t limit, const Done& done)
  {
    m_tiling = &tiling;
    m_first = first;
    m_tiles.clear();
    m_tiles.resize(own.size());
    m_inboxes.assign(own.size(), {});
    for (std::size_t k = 0; k < own.size(); ++k)
      m_inboxes[k].push_back({number(k), number(k), tiling.sample});
    for_each([&](std::size_t k) {
      const Thread_executor executor(
          threads_of_task(k, own.size(), m_executor.number_of_workers()));
      m_tiles[k] = std::make_unique<Delaunay_tile>(tiling, number(k), std::move(own[k]),
                                                   Tile_state(), limit, executor);
      done(k);
    });
  }

  void clear()
  {
    m_tiles.clear();
    m_inboxes.clear();
  }

  const std::vector<std::unique_ptr<Delaunay_tile>>& tiles() const { return m_tiles; }
  bool has(std::uint32_t t) const { return t >= m_first && t - m_first < m_tiles.size(); }

  // Every tile hears what it was told, and tells: the messages by tile.
  template <class Done>
  std::vector<std::vector<Tile_message>> exchange(const Done& done)
  {
    std::vector<std::vector<Tile_message>> messages(m_tiles.size());
    for_each([&](std::size_t k) {
      messages[k] = m_tiles[k]->absorb(
          news_of(std::move(m_inboxes[k]), *m_tiling, number(k), m_tiles[k]->known()));
      done(k);
    });
    m_inboxes.assign(m_tiles.size(), {});
    return messages;
  }

  // What one of the tiles is told: it hears it when it is its turn.
  void deliver(Tile_message message)
  {
    m_inboxes[message.to - m_first].push_back(std::move(message));
  }

  template <class Done>
  std::vector<Tile_certificate> certificates(std::uint64_t seed, bool with_cells,
                                             const Done& done) const
  {
    std::vector<Tile_certificate> certificates(m_tiles.size());
    for_each([&](std::size_t k) {
      certificates[k] = certificate_of(*m_tiles[k], seed, with_cells);
      done(k);
    });
    return certificates;
  }

  // What those of these tiles that differ from another show it.
  std::vector<Tile_message> witnesses(const Tile_pairs& pairs) const
  {
    std::vector<Tile_message> messages;
    for (const auto& [a, b] : pairs)
      for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)})
        if (has(from))
          for (Tile_message& message : m_tiles[from - m_first]->witnesses({to}))
            messages.push_back(std::move(message));
    return messages;
  }

  // What tile t has.
  Delaunay_3_tile tile(std::uint32_t t) const { return piece_of(*m_tiles[t - m_first]); }

private:
  std::uint32_t number(std::size_t k) const { return m_first + std::uint32_t(k); }

  template <class Function>
  void for_each(const Function& f) const
  {
    run_tasks(m_executor, m_tiles.size(), [&](std::size_t k) {
      const Rounding_to_nearest rounding;
      f(k);
    });
  }

  Thread_executor m_executor;
  const Tiling* m_tiling = nullptr;
  std::uint32_t m_first = 0;
  std::vector<std::unique_ptr<Delaunay_tile>> m_tiles;
  std::vector<std::vector<Tile_message>> m_inboxes; // by tile
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_IN_MEMORY_H
