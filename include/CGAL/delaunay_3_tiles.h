// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_3_TILES_H
#define CGAL_DELAUNAY_3_TILES_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Delaunay_3_tile.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Point_files_3.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_files_error.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_source_3.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_here.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_in_files.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>
#include <CGAL/Delaunay_from_surface_3/tiles/run_tiles.h>

#include <cstdint>
#include <random>

namespace CGAL {
/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {
/// \endcond

/*!
\ingroup PkgDelaunayFromSurface3Tiles

is an engine of `delaunay_3_tiles()`: all tiles are in memory. It is constructed from the number of
its threads. Where there are fewer tiles to make than threads, several insert the points of one;
then the order of its cells depends on chance.
*/
using Tiles_here_3 = Delaunay_from_surface_3::internal::Tiles_here;

/*!
\ingroup PkgDelaunayFromSurface3Tiles

is an engine of `delaunay_3_tiles()`, out of core: what tiles keep is in files, and one tile for
each thread in memory. It is constructed from a folder and the number of its threads, which share
tiles as those of `Tiles_here_3` do. A process may be killed at any moment; the next call goes on
where it was. The folder is made if need be.
*/
using Tiles_in_files_3 = Delaunay_from_surface_3::internal::Tiles_in_files;

/*!
\ingroup PkgDelaunayFromSurface3Tiles

builds the Delaunay triangulation of more points than fit into memory, in tiles, and gives `sink`
one tile after the other. The union of the cells that tiles own is that which `delaunay_3_arrays()`
has, with the same perturbation. This is checked: nothing is given before a certificate holds.

<b>Complexity</b>: on surfaces a tile keeps 1.1 to 2.5 times its own points and is told up to five
points for each, in about six rounds; the worst tile measured kept four times its own, and
twenty times where two planes met. One vertex with n neighbors is kept with all of these by one
tile.

<b>Memory</b>, with `Tiles_in_files_3`: about 300 bytes for each point that a tile keeps, for each
thread.
<b>Disk</b>: the points (32 bytes each), 32 bytes for each that is kept, twice, and 16 for each cell
of a tile.

\tparam Engine `Tiles_here_3`, `Tiles_in_files_3` or `Tiles_by_mpi_3`
\tparam Sink a callable with an argument `Delaunay_3_tile`

\param engine where the work is done
\param source the points
\param sink is called for each tile, in their order; by MPI, for those of the rank
\param options what else there is to say

\throws Surface_input_error if a coordinate is not finite, or all points lie in one plane
\throws Tile_files_error if a file cannot be read or written, or the folder holds the state of
another input or another number of tiles
\throws std::runtime_error that names a point if a tile needs more memory than it may have, and
beginning again with more tiles does not help
\throws Tiles_stopped if `options.progress` returned `false`
\throws std::runtime_error if the certificate does not hold in the end; this was never seen

Example: \ref Delaunay_from_surface_3/filter_tiles.cpp

\sa `delaunay_3_arrays()`
*/
template <class Engine, class Sink>
Tiles_report delaunay_3_tiles(Engine& engine, const Tile_source_3& source, Sink&& sink,
                              const Tiles_options& options = Tiles_options())
{
  using namespace Delaunay_from_surface_3::internal;
  const auto draw = [] {
    std::random_device random;
    return std::uint64_t(random()) << 32 | random();
  };
  return run_until_certified(engine, source, options, draw, [&](const Tiles_report& report) {
    engine.give(sink);
    return report;
  });
}

/// \cond SKIP_IN_MANUAL
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond

} // namespace CGAL

#endif // CGAL_DELAUNAY_3_TILES_H
