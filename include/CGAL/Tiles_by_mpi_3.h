// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_TILES_BY_MPI_3_H
#define CGAL_TILES_BY_MPI_3_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_by_mpi.h>
#include <CGAL/delaunay_3_tiles.h>

#if defined(MPI_VERSION) || defined(DOXYGEN_RUNNING) // MPI is there

namespace CGAL {
/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {
/// \endcond

/*!
\ingroup PkgDelaunayFromSurface3Tiles

is an engine of `delaunay_3_tiles()` for the processes of an MPI communicator, its *ranks*: each has
some of the tiles in memory, and reads one part of the points
(`Tile_source_3::first_of_part()`). It is constructed, between
`MPI_Init()` and `MPI_Finalize()` and by all ranks, from an `MPI_Comm`, of which it makes a copy,
and the number of threads of a rank. With more than one, MPI is initialized with
`MPI_THREAD_FUNNELED` at least: MPI is called by the thread that calls `delaunay_3_tiles()`.

All ranks call `delaunay_3_tiles()` with the same points and the same options, but for
`Tiles_options::progress`, which is told of the rank's own part. That they do is checked, and that
each point is read by one rank; of the points only the number can be compared. The sink of a rank is
given the rank's tiles. All ranks get the same report, or throw the same: whatever a rank throws,
also its sink, is thrown by all when the step has ended, with the number of the rank before the
message, unless all throw the same. An exception that no engine knows becomes a
`std::runtime_error`. A rank that ends otherwise ends all, as `mpirun` does it.

`together(f)` calls `f()` on each rank, with the same care: for what may throw on one of them, as
opening a file. `rank()` and `number_of_ranks()` return what they say, `bytes_sent()` the number of
bytes that this rank sent to others, `seconds_of_exchange()` how long it sent, and waited for
others.

The header is empty where the compiler does not find `mpi.h`. CMake's target
`Delaunay_from_surface_3::mpi` knows where it is.

<b>Memory</b>: about 300 bytes for each point that a tile keeps, and half as much again for the tile
that `sink` is given. <b>Messages</b>: per rank and round at most one to each other rank, of less
than 1 GB, or several of 512 MB; 32 bytes for each point that is told.
*/
using Tiles_by_mpi_3 = Delaunay_from_surface_3::internal::Tiles_by_mpi;

/// \cond SKIP_IN_MANUAL
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond
} // namespace CGAL

#endif // MPI is there

#endif // CGAL_TILES_BY_MPI_3_H
