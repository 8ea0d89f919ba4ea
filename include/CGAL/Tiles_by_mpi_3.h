// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_TILES_BY_MPI_3_H
#define CGAL_TILES_BY_MPI_3_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Ranks_of_mpi.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_in_memory.h>
#include <CGAL/delaunay_3_tiles.h>

#include <cstddef>
#include <cstdint>

#if defined(MPI_VERSION) || defined(DOXYGEN_RUNNING) // MPI is there

namespace CGAL {
/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {
/// \endcond

/*!
\ingroup PkgDelaunayFromSurface3Tiles

is an engine of `delaunay_3_tiles()` for the processes of an MPI communicator, its *ranks*. Each
rank has some of the tiles in memory, and reads one part of the points
(`Tile_source_3::first_of_part()`).

All ranks call `delaunay_3_tiles()` with the same points and the same options, except
`Tiles_options::progress`, which reports the rank's own part. It is checked that they do, and that each
point is read by exactly one rank; of the points only the number can be compared. The sink of a rank
receives the rank's tiles.

All ranks get the same report, or throw the same exception. If a rank or its sink throws, all ranks
throw at the end of the step, with the number of that rank before the message, unless all throw the
same. An exception of a type unknown to the engines becomes a `std::runtime_error`. If a rank ends
in another way, `mpirun` ends all ranks.

The header is empty if the compiler does not find `mpi.h`. CMake's target
`Delaunay_from_surface_3::mpi` provides its location; for `Point_files_3` link
`Delaunay_from_surface_3::compiled` as well.

<b>Memory</b>: about 300 bytes for each point that a tile keeps, and half as much again for the tile
passed to `sink`.

<b>Messages</b>: per rank and round at most one to each other rank, or several if it is longer than
512 MB; 32 bytes for each point that is told.
*/
class Tiles_by_mpi_3 : public Delaunay_from_surface_3::core::Tiles_in_memory<
                           Delaunay_from_surface_3::core::Ranks_of_mpi>
{
public:
  /// duplicates the communicator. All ranks construct the engine between `MPI_Init()` and
  /// `MPI_Finalize()`, with the number of threads per rank. For more than one thread, MPI must be
  /// initialized with at least `MPI_THREAD_FUNNELED`: the thread that calls `delaunay_3_tiles()`
  /// calls MPI.
  explicit Tiles_by_mpi_3(MPI_Comm communicator, std::size_t number_of_threads = 1)
    : Tiles_in_memory(number_of_threads, communicator)
  {
  }

  /// calls `f()` on each rank. If it throws on some, all ranks throw, as above; use it for what may
  /// throw on one rank, such as opening a file.
  template <class F>
  void together(const F& f) const
  {
    ranks().together(f);
  }

  /// returns the number of this rank.
  int rank() const { return ranks().rank(); }

  /// returns the number of all ranks.
  int number_of_ranks() const { return ranks().size(); }

  /// returns the number of bytes that this rank sent to others.
  std::uint64_t bytes_sent() const { return ranks().bytes_sent(); }

  /// returns the time in seconds that this rank spent sending and waiting for others.
  double seconds_of_exchange() const { return ranks().seconds(); }
};

/// \cond SKIP_IN_MANUAL
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond
} // namespace CGAL

#endif // MPI is there

#endif // CGAL_TILES_BY_MPI_3_H
