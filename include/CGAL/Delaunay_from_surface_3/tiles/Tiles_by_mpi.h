// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_BY_MPI_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_BY_MPI_H

// An engine for the processes of a communicator: each has consecutive tiles in memory, which lie
// side by side, and reads one range of the input. What tiles tell each other is packed by rank. All
// ranks run the same driver, and each of its decisions is made of what all know. A rank that throws
// does so between two exchanges, inside Ranks_of_mpi::together(), where all ends for all.

#include <CGAL/Delaunay_from_surface_3/tiles/Ranks_of_mpi.h>

#ifdef MPI_VERSION // MPI is there

#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Delaunay_3_tile.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Packed_bytes.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Range_summary.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Stage_progress.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_certificate.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_point.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_source_3.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_in_memory.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiling.h>
#include <CGAL/Delaunay_from_surface_3/tiles/compare_cells_by_mpi.h>
#include <CGAL/Delaunay_from_surface_3/tiles/number_of_tiles.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

class Tiles_by_mpi
{
public:
  explicit Tiles_by_mpi(MPI_Comm communicator, std::size_t number_of_threads = 1)
    : m_ranks(communicator)
    , m_tiles(number_of_threads)
  {
  }

  int rank() const { return m_ranks.rank(); }
  int number_of_ranks() const { return m_ranks.size(); }
  std::uint64_t bytes_sent() const { return m_ranks.bytes_sent(); }
  double seconds_of_exchange() const { return m_ranks.seconds(); }

  // f() on each rank; if it throws on one, so it does on all.
  template <class F>
  void together(const F& f) const
  {
    m_ranks.together(f);
  }

  void begin(const Tile_source_3& source, const Tiles_options& options)
  {
    m_tiles.clear();
    m_rounds = 0;
    m_told = 0;
    m_progress = options.progress;
    const auto tiles = agree_on_input(source, options);
    const auto part = std::uint64_t(rank()), parts = std::uint64_t(number_of_ranks());
    const std::uint64_t n = source.size(), first = source.first_of_part(part, parts);
    const Sampling sampling(n, tiles, options.sample_share);
    std::vector<double> coordinates;
    Packed_bytes summary;
    together([&] {
      const Rounding_to_nearest rounding;
      const Stage_progress progress(m_progress, "reading", 1);
      coordinates = read_range(source, first, source.first_of_part(part + 1, parts));
      pack(summary, summary_of(coordinates, first, sampling));
      progress.tell_next();
    });
    make_tiling(m_ranks.all_gather(summary), n, tiles, sampling);
    bring_home(std::move(coordinates), first, most_points_kept(options, 1));
  }

  std::uint64_t number_of_points() const { return m_number_of_points; }
  std::uint32_t number_of_tiles() const { return m_number_of_tiles; }
  std::size_t rounds() const { return m_rounds; }
  std::uint64_t told() const { return m_told; }

  std::uint64_t exchange()
  {
    std::uint64_t told = 0;
    auto to = m_ranks.empty_by_rank();
    together([&] {
      const Stage_progress progress(m_progress, "round " + std::to_string(m_rounds),
                                    end() - begin());
      const auto messages = m_tiles.exchange([&](std::size_t) { progress.tell_next(); });
      for (const auto& of_tile : messages)
        told += pack_by_rank(of_tile, to);
    });
    deliver(std::move(to));
    told = m_ranks.sum(told);
    ++m_rounds;
    m_told += told;
    return told;
  }

  // Of all tiles, on each rank. Cells, if they are compared, are so by the ranks that have them.
  std::vector<Tile_certificate> gather(std::uint64_t seed)
  {
    seed = m_ranks.of_first({seed}).front();
    std::vector<Tile_certificate> mine, all;
    Packed_bytes bytes;
    together([&] {
      const Stage_progress progress(m_progress, "certificate", end() - begin());
      mine = m_tiles.certificates(seed, m_with_cells, [&](std::size_t) { progress.tell_next(); });
    });
    if (m_with_cells)
      compare_cells_by_mpi(m_ranks, mine, [&](std::uint32_t t) { return rank_of(t); });
    together([&] {
      for (const Tile_certificate& certificate : mine)
        pack(bytes, certificate);
    });
    const auto gathered = m_ranks.all_gather(bytes);
    together([&] {
      for (const Packed_bytes& of_rank : gathered)
        for (Unpack from(of_rank); !from.is_at_end();)
          all.push_back(unpack_certificate(from));
    });
    return all;
  }

  void show(const Tile_pairs& pairs)
  {
    auto to = m_ranks.empty_by_rank();
    together([&] { pack_by_rank(m_tiles.witnesses(pairs), to); });
    deliver(std::move(to));
  }

  // sink(tile) of each tile that this rank has.
  template <class Sink>
  void give(Sink& sink) const
  {
    together([&] {
      const Stage_progress progress(m_progress, "writing", end() - begin());
      for (std::uint32_t t = begin(); t < end(); ++t) {
        sink(m_tiles.tile(t));
        progress.tell_next();
      }
    });
  }

  void forget() { m_tiles.clear(); }

private:
  // The first tile of a rank.
  std::uint32_t first_tile(int rank) const
  {
    return std::uint32_t(std::uint64_t(m_number_of_tiles) * std::uint64_t(rank) /
                         std::uint64_t(number_of_ranks()));
  }
  std::uint32_t begin() const { return first_tile(rank()); }
  std::uint32_t end() const { return first_tile(rank() + 1); }
  std::size_t rank_of(std::uint32_t tile) const { return m_rank_of_tile[tile]; }

  // All ranks see the same input and have the same options, or none begins.
  std::uint32_t agree_on_input(const Tile_source_3& source, const Tiles_options& options)
  {
    std::vector<std::uint64_t> mine;
    together([&] {
      const std::uint64_t n = source.size();
      mine = {n,
              internal::number_of_tiles(options, n, 1),
              options.sample_share,
              std::uint64_t(options.compares_cells),
              std::uint64_t(options.starts_again),
              options.memory};
    });
    const auto theirs = m_ranks.of_first(mine);
    together([&] {
      if (mine[0] != theirs[0])
        throw std::runtime_error("sees " + std::to_string(mine[0]) + " points, and rank 0 " +
                                 std::to_string(theirs[0]));
      if (mine != theirs)
        throw std::runtime_error("was given other options than rank 0");
    });
    m_number_of_points = mine[0];
    m_number_of_tiles = std::uint32_t(mine[1]);
    m_with_cells = options.compares_cells;
    together([&] {
      m_rank_of_tile.assign(m_number_of_tiles, 0);
      for (int r = 0; r < number_of_ranks(); ++r)
        std::fill(m_rank_of_tile.begin() + first_tile(r),
                  m_rank_of_tile.begin() + first_tile(r + 1), std::uint32_t(r));
    });
    return m_number_of_tiles;
  }

  void make_tiling(const std::vector<Packed_bytes>& summaries, std::uint64_t n, std::uint32_t tiles,
                   const Sampling& sampling)
  {
    together([&] {
      const Rounding_to_nearest rounding;
      std::vector<Range_summary> ranges;
      for (const Packed_bytes& bytes : summaries) {
        Unpack from(bytes);
        ranges.push_back(unpack_summary(from));
      }
      m_tiling.emplace(tiling_of(ranges, n, tiles, sampling)); // the same on all
    });
  }

  // Each point goes to the rank that has its tile. Those of a tile are in the order of their ids.
  void bring_home(std::vector<double> coordinates, std::uint64_t first, std::size_t limit)
  {
    auto to = m_ranks.empty_by_rank();
    together([&] {
      for (std::size_t i = 0; i < coordinates.size() / 3; ++i) {
        const Tile_point point = tile_point(first + i, &coordinates[3 * i]);
        pack(to[rank_of(m_tiling->tree.owner(point.coordinates))], point);
      }
      coordinates = {};
    });
    auto from = m_ranks.exchange(std::move(to));
    together([&] {
      std::vector<std::vector<Tile_point>> own(end() - begin());
      for (Packed_bytes& bytes : from) {
        for (Unpack points(bytes); !points.is_at_end();) {
          const auto point = points.get<Tile_point>();
          own[m_tiling->tree.owner(point.coordinates) - begin()].push_back(point);
        }
        bytes = {};
      }
      const Stage_progress progress(m_progress, "own points", own.size());
      m_tiles.begin(*m_tiling, begin(), std::move(own), limit,
                    [&](std::size_t) { progress.tell_next(); });
    });
  }

  // Returns how many points are told.
  std::uint64_t pack_by_rank(const std::vector<Tile_message>& messages,
                             std::vector<Packed_bytes>& to) const
  {
    std::uint64_t told = 0;
    for (const Tile_message& message : messages) {
      pack(to[rank_of(message.to)], message);
      told += message.points.size();
    }
    return told;
  }

  void deliver(std::vector<Packed_bytes> to)
  {
    const auto from = m_ranks.exchange(std::move(to));
    together([&] {
      for (const Packed_bytes& bytes : from)
        for (Unpack messages(bytes); !messages.is_at_end();)
          m_tiles.deliver(unpack_message(messages));
    });
  }

  Ranks_of_mpi m_ranks;
  std::uint64_t m_number_of_points = 0;
  std::uint32_t m_number_of_tiles = 0;
  std::vector<std::uint32_t> m_rank_of_tile;
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

#endif // MPI_VERSION

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_BY_MPI_H
