// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_COMPARE_CELLS_BY_MPI_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_COMPARE_CELLS_BY_MPI_H

#include <CGAL/Delaunay_from_surface_3/tiles/Ranks_of_mpi.h>

#ifdef MPI_VERSION // MPI is there

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Packed_bytes.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_certificate.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The larger of two tiles shows its common cells to the smaller, which compares them: nobody has
// those of all. If they are the same, neither keeps its list; else one alone has one, which
// tiles_that_differ() sees. Those of this rank are consecutive; rank_of(tile) has the others.
template <class Rank_of>
void compare_cells_by_mpi(Ranks_of_mpi& ranks, std::vector<Tile_certificate>& mine,
                          const Rank_of& rank_of)
{
  std::vector<Packed_bytes> to;
  ranks.together([&] {
    to = ranks.empty_by_rank();
    for (Tile_certificate& certificate : mine)
      for (auto pair = certificate.cells.begin(); pair != certificate.cells.end();)
        if (pair->first < certificate.tile) {
          Packed_bytes& bytes = to[rank_of(pair->first)];
          pack(bytes, pair->first);
          pack(bytes, certificate.tile);
          pack(bytes, pair->second);
          pair = certificate.cells.erase(pair);
        } else {
          ++pair;
        }
  });
  const auto from = ranks.exchange(std::move(to));
  ranks.together([&] {
    for (const Packed_bytes& bytes : from)
      for (Unpack cells(bytes); !cells.is_at_end();) {
        auto& ours = mine[cells.get<std::uint32_t>() - mine.front().tile].cells;
        const auto partner = cells.get<std::uint32_t>();
        std::vector<Sorted_cell> theirs;
        cells.get(theirs);
        const auto found = ours.find(partner);
        if (found != ours.end() && found->second == theirs)
          ours.erase(found);
        else
          ours[partner].clear();
      }
  });
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // MPI_VERSION

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_COMPARE_CELLS_BY_MPI_H
