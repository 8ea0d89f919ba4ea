// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_HERE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_HERE_H

// An engine for tiles that are all in this process: for tests, and the one that others are compared
// with.

#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Delaunay_3_tile.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Delaunay_tile.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_certificate.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_source_3.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_in_memory.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiling.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

class Tiles_here
{
public:
  explicit Tiles_here(std::size_t number_of_threads = 1)
    : m_tiles(number_of_threads)
  {
  }
  Tiles_here(const Tiles_here&) = delete; // tiles refer to what all know

  // Makes the tiles, each of its own points.
  void begin(const Tile_source_3& source, const Tiles_options& options)
  {
    begin(source, options, [](std::vector<std::vector<Tile_point>>&) {});
  }

  // The same if points may get lost on their way home, as tests have it.
  template <class Home>
  void begin(const Tile_source_3& source, const Tiles_options& options, const Home& home)
  {
    const Rounding_to_nearest rounding;
    const std::uint64_t n = source.size();
    const std::uint32_t tiles = internal::number_of_tiles(options, n, 1);
    const Sampling sampling(n, tiles, options.sample_share);
    m_tiles.clear();
    m_rounds = 0;
    m_told = 0;
    m_with_cells = options.compares_cells;
    m_progress = options.progress;
    std::vector<std::vector<Tile_point>> own(tiles);
    const std::vector<double> coordinates = read_range(source, 0, n);
    m_tiling.emplace(tiling_of({summary_of(coordinates, 0, sampling)}, n, tiles, sampling));
    for (std::size_t i = 0; i < n; ++i)
      own[m_tiling->tree.owner(&coordinates[3 * i])].push_back(tile_point(i, &coordinates[3 * i]));
    home(own);
    const Stage_progress progress(m_progress, "own points", tiles);
    m_tiles.begin(*m_tiling, 0, std::move(own), most_points_kept(options, 1),
                  [&](std::size_t) { progress.tell_next(); });
  }

  std::uint64_t number_of_points() const { return m_tiling->number_of_points; }
  std::uint32_t number_of_tiles() const { return m_tiling->tree.number_of_tiles(); }
  std::size_t rounds() const { return m_rounds; }
  std::uint64_t told() const { return m_told; }

  // Every tile hears what was told, and tells. Returns how many points were told.
  std::uint64_t exchange()
  {
    return exchange([](Tile_message&) {});
  }

  // The same by a post that may lose or change messages, as tests have it.
  template <class Post>
  std::uint64_t exchange(const Post& post)
  {
    std::uint64_t told = 0;
    const Stage_progress progress(m_progress, "round " + std::to_string(m_rounds),
                                  number_of_tiles());
    for (auto& from : m_tiles.exchange([&](std::size_t) { progress.tell_next(); }))
      for (Tile_message& message : from) {
        told += message.points.size();
        post(message);
        m_tiles.deliver(std::move(message));
      }
    ++m_rounds;
    m_told += told;
    return told;
  }

  std::vector<Tile_certificate> gather(std::uint64_t seed) const
  {
    const Stage_progress progress(m_progress, "certificate", number_of_tiles());
    return m_tiles.certificates(seed, m_with_cells, [&](std::size_t) { progress.tell_next(); });
  }

  void show(const Tile_pairs& pairs)
  {
    for (Tile_message& message : m_tiles.witnesses(pairs))
      m_tiles.deliver(std::move(message));
  }

  // What tile t has; and sink(tile) of all.
  Delaunay_3_tile tile(std::uint32_t t) const { return m_tiles.tile(t); }
  template <class Sink>
  void give(Sink& sink) const
  {
    for (std::uint32_t t = 0; t < number_of_tiles(); ++t)
      sink(tile(t));
  }

  void forget() { m_tiles.clear(); }

  template <class F>
  void together(const F& f) const
  {
    f();
  }

  const std::vector<std::unique_ptr<Delaunay_tile>>& tiles() const { return m_tiles.tiles(); }

private:
  std::optional<Tiling> m_tiling;
  bool m_with_cells = false;
  std::size_t m_rounds = 0;
  std::uint64_t m_told = 0;
  Tiles_in_memory m_tiles;
  Stage_progress::Function m_progress;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_HERE_H
