// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_AGREE_ON_INPUT_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_AGREE_ON_INPUT_H

#include <CGAL/Delaunay_from_surface_3/tiles/Ranks_of_mpi.h>

#ifdef MPI_VERSION // MPI is there

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Packed_bytes.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_source_3.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>
#include <CGAL/Delaunay_from_surface_3/tiles/number_of_tiles.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

struct Input_of_rank
{
  std::uint64_t points, first, last; // it reads those from first to before last
  std::uint32_t tiles;
  std::array<std::uint64_t, 5> options;
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
           std::uint64_t(options.compares_cells), std::uint64_t(options.starts_again)}};
}

// All ranks see as many points and have the same options, of which the driver's decisions are made,
// and each point is read by one of them; or none begins. Whether they see the same points is not
// known: what one reads no other does.
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

#endif // MPI_VERSION

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_AGREE_ON_INPUT_H
