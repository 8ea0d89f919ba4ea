// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_3_TILES_H
#define CGAL_DELAUNAY_3_TILES_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_in_files.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_in_memory.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>

#include <type_traits>
#include <utility>

namespace CGAL {
/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {
/// \endcond

/*!
\ingroup PkgDelaunayFromSurface3Tiles

is an engine of `delaunay_3_tiles()` with all tiles in memory. Its constructor takes the number of
threads, by default 1. If there are fewer tiles to make than threads, several threads insert the
points of one tile; the order of its cells then depends on chance.
*/
using Tiles_here_3 = Delaunay_from_surface_3::core::Tiles_here;

/*!
\ingroup PkgDelaunayFromSurface3Tiles

builds the Delaunay triangulation of more points than fit into memory, in tiles, and passes one tile
after the other to `sink`. The cells that the tiles own are together those of `delaunay_3_arrays()`,
with the same perturbation. A certificate of this is checked before the first tile is passed.

<b>Complexity</b>: on surfaces a tile keeps 1.1 to 2.5 times its own points and is told up to five
points for each, in about six rounds. The worst tile measured kept four times its own points, and
twenty times where two planes met. A vertex with n neighbors is kept with all of these by one tile.

<b>Memory</b> with `Tiles_in_files_3`: for each thread, about 300 bytes per point that a tile keeps.

<b>Disk</b>: 32 bytes per point, twice 32 bytes per point that is kept, and 16 bytes per cell of a
tile.

\tparam Engine `Tiles_here_3`, `Tiles_in_files_3` or `Tiles_by_mpi_3`
\tparam Sink a callable that takes a `Delaunay_3_tile`

\param engine determines where the tiles are kept, and by which threads or processes they are made
\param source the points
\param sink is called for each tile, in their order; by MPI, for the tiles of the rank
\param options the number of tiles, limits, and progress

\return counts of points, tiles, rounds and cells

\throws Surface_input_error if a coordinate is not finite, or all points lie in one plane
\throws Tile_files_error if a file cannot be read or written, the folder contains the state of another
input or number of tiles, or foreign files in `state`, or another run is at work there
\throws std::runtime_error if a tile needs more memory than it may have, and beginning again with
more tiles does not help; the message names a point
\throws Tiles_stopped if `options.progress` returned `false`
\throws std::runtime_error if the certificate does not hold in the end; this was never observed

Example: \ref Delaunay_from_surface_3/filter_tiles.cpp

\sa `delaunay_3_arrays()`
*/
template <class Engine, class Sink>
Tiles_report delaunay_3_tiles(Engine& engine, const Tile_source_3& source, Sink&& sink,
                              const Tiles_options& options = Tiles_options())
{
  using namespace Delaunay_from_surface_3::core;
  if constexpr (std::is_same<std::remove_const_t<Engine>, Tiles_in_files_3>::value) {
    return engine.run(source, options, [&](Delaunay_3_tile&& tile) { sink(std::move(tile)); });
  } else {
    return run_until_certified(engine, source, options, [&](const Tiles_report& report) {
      engine.give(sink);
      return report;
    });
  }
}

/// \cond SKIP_IN_MANUAL
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond

} // namespace CGAL

#endif // CGAL_DELAUNAY_3_TILES_H
