// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_BY_MPI_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_BY_MPI_H

// An engine for the processes of a communicator: each has consecutive tiles in memory, which lie
// side by side, and reads one range of the input. Messages between tiles are packed by rank. All
// ranks run the same driver, whose decisions depend only on what all ranks know. A rank that throws
// does so between two exchanges, inside Ranks_of_mpi::together(), which ends the run on all ranks.

#include <CGAL/Delaunay_from_surface_3/tiles/Ranks_of_mpi.h>

#ifdef MPI_VERSION // MPI is there

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_certificate.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_in_memory.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiling.h>

#include <algorithm>
#include <array>
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

struct Input_of_rank
{
  std::uint64_t points, first, last; // it reads the points first, …, last - 1
  std::uint32_t tiles;
  std::array<std::uint64_t, 4> options;
};

inline Input_of_rank input_of_rank(const Ranks_of_mpi& ranks, const Tile_source_3& source,
                                   const Tiles_options& options)
{
  const auto part = std::uint64_t(ranks.rank()), parts = std::uint64_t(ranks.size());
  const std::uint64_t n = source.size();
  return {n,
          source.first_of_part(part, parts),
          source.first_of_part(part + 1, parts),
          number_of_tiles(options, n, 1),
          {options.sample_share, options.least_points, options.memory,
           std::uint64_t(options.starts_again)}};
}

// Throws on all ranks unless all see the same number of points and have the same options, on which
// the driver's decisions depend, and each point is read by one of them. Whether they see the same
// points is unknown, since no two ranks read the same point.
inline Input_of_rank agree_on_input(Ranks_of_mpi& ranks, const Tile_source_3& source,
                                    const Tiles_options& options)
{
  Input_of_rank mine{};
  Packed_bytes bytes;
  ranks.together([&] {
    mine = input_of_rank(ranks, source, options);
    pack(bytes, mine);
  });
  const std::vector<Packed_bytes> all = ranks.all_gather(bytes);
  ranks.together([&] {
    const auto of = [&](int rank) { return Unpack(all[std::size_t(rank)]).get<Input_of_rank>(); };
    const Input_of_rank theirs = of(0);
    if (mine.points != theirs.points)
      throw std::runtime_error("sees " + std::to_string(mine.points) + " points, and rank 0 " +
                               std::to_string(theirs.points));
    if (mine.tiles != theirs.tiles || mine.options != theirs.options)
      throw std::runtime_error("was given other options than rank 0");
    const std::uint64_t before = ranks.rank() == 0 ? 0 : of(ranks.rank() - 1).last;
    const bool is_last = ranks.rank() == ranks.size() - 1;
    if (mine.first != before || mine.last < mine.first || (is_last && mine.last != mine.points))
      throw Surface_input_error("reads the points from " + std::to_string(mine.first) +
                                " to before " + std::to_string(mine.last) + " of " +
                                std::to_string(mine.points) + ", where it should begin with " +
                                std::to_string(before) + ": the parts do not join");
  });
  return mine;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

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

  // Calls f() on each rank; if it throws on one, all throw.
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
    together([&] { m_progress = options.progress; });
    const Input_of_rank input = agree_on_input(m_ranks, source, options);
    assign_tiles(input);
    const Sampling sampling(input.points, input.tiles, options.sample_share);
    std::vector<double> coordinates;
    Packed_bytes summary;
    together([&] {
      const Rounding_to_nearest rounding;
      const Stage_progress progress(m_progress, "reading", 1);
      coordinates = read_range(source, input.first, input.last);
      pack(summary, summary_of(coordinates, input.first, sampling));
      progress.tell_next();
    });
    make_tiling(m_ranks.all_gather(summary), sampling);
    bring_home(std::move(coordinates), input.first, most_points_kept(options, 1));
  }

  std::uint64_t number_of_points() const { return m_number_of_points; }
  std::uint32_t number_of_tiles() const { return m_number_of_tiles; }
  std::size_t rounds() const { return m_rounds; }
  std::uint64_t told() const { return m_told; }

  std::uint64_t exchange()
  {
    std::uint64_t told = 0;
    std::vector<Packed_bytes> to;
    together([&] {
      to = m_ranks.empty_by_rank();
      const Stage_progress progress(m_progress, "round " + std::to_string(m_rounds),
                                    last_tile() - first_tile());
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

  // Returns the seed that the first rank draws for all.
  template <class Draw>
  friend std::uint64_t draw_seed(const Tiles_by_mpi& engine, const Draw& draw)
  {
    std::uint64_t seed = 0;
    engine.together([&] { seed = engine.rank() == 0 ? draw() : 0; });
    return engine.m_ranks.of_first(seed);
  }

  // Returns the certificates of all tiles, on each rank; the seed is the same on all.
  std::vector<Tile_certificate> gather(std::uint64_t seed)
  {
    std::vector<Tile_certificate> mine, all;
    Packed_bytes bytes;
    together([&] {
      const Stage_progress progress(m_progress, "certificate", last_tile() - first_tile());
      mine = m_tiles.certificates(seed, [&](std::size_t) { progress.tell_next(); });
    });
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
    std::vector<Packed_bytes> to;
    together([&] {
      to = m_ranks.empty_by_rank();
      pack_by_rank(m_tiles.witnesses(pairs), to);
    });
    deliver(std::move(to));
  }

  // Calls sink(tile) for each tile of this rank.
  template <class Sink>
  void give(Sink& sink) const
  {
    together([&] {
      const Stage_progress progress(m_progress, "writing", last_tile() - first_tile());
      for (std::uint32_t t = first_tile(); t < last_tile(); ++t) {
        sink(m_tiles.tile(t));
        progress.tell_next();
      }
    });
  }

  void forget() { m_tiles.clear(); }

private:
  std::uint32_t first_tile_of(int rank) const
  {
    return std::uint32_t(std::uint64_t(m_number_of_tiles) * std::uint64_t(rank) /
                         std::uint64_t(number_of_ranks()));
  }
  // The tiles of this rank are first_tile(), …, last_tile() - 1.
  std::uint32_t first_tile() const { return first_tile_of(rank()); }
  std::uint32_t last_tile() const { return first_tile_of(rank() + 1); }
  std::size_t rank_of(std::uint32_t tile) const { return m_rank_of_tile[tile]; }

  void assign_tiles(const Input_of_rank& input)
  {
    m_number_of_points = input.points;
    m_number_of_tiles = input.tiles;
    together([&] {
      m_rank_of_tile.assign(m_number_of_tiles, 0);
      for (int r = 0; r < number_of_ranks(); ++r)
        std::fill(m_rank_of_tile.begin() + first_tile_of(r),
                  m_rank_of_tile.begin() + first_tile_of(r + 1), std::uint32_t(r));
    });
  }

  void make_tiling(const std::vector<Packed_bytes>& summaries, const Sampling& sampling)
  {
    together([&] {
      const Rounding_to_nearest rounding;
      std::vector<Range_summary> ranges;
      for (const Packed_bytes& bytes : summaries) {
        Unpack from(bytes);
        ranges.push_back(unpack_summary(from));
      }
      m_tiling.emplace(
          tiling_of(ranges, m_number_of_points, m_number_of_tiles, sampling)); // the same on all
    });
  }

  // Sends each point to the rank that has its tile. The points of a tile are in the order of their
  // ids.
  void bring_home(std::vector<double> coordinates, std::uint64_t first, std::size_t limit)
  {
    std::vector<Packed_bytes> to;
    together([&] {
      to = m_ranks.empty_by_rank();
      for (std::size_t i = 0; i < coordinates.size() / 3; ++i) {
        const Tile_point point = tile_point(first + i, &coordinates[3 * i]);
        pack(to[rank_of(m_tiling->tree.owner(point.coordinates))], point);
      }
      coordinates = {};
    });
    auto from = m_ranks.exchange(std::move(to));
    together([&] {
      std::vector<std::vector<Tile_point>> own(last_tile() - first_tile());
      for (Packed_bytes& bytes : from) {
        for (Unpack points(bytes); !points.is_at_end();) {
          const auto point = points.get<Tile_point>();
          own[m_tiling->tree.owner(point.coordinates) - first_tile()].push_back(point);
        }
        bytes = {};
      }
      const Stage_progress progress(m_progress, "own points", own.size());
      m_tiles.begin(*m_tiling, first_tile(), std::move(own), limit,
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
