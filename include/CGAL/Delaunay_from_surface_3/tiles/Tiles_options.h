// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_OPTIONS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_OPTIONS_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>

namespace CGAL {
/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {
/// \endcond

/*!
\ingroup PkgDelaunayFromSurface3Tiles

is what can be asked of `delaunay_3_tiles()`.
*/
struct Tiles_options
{
  /// How many tiles; 0: as many as `memory` asks for.
  std::uint32_t number_of_tiles = 0;

  /// There are no more tiles than one for so many points: smaller ones come to rest too early, and
  /// are told the rest one after the other. That takes many rounds with fewer than a thousand.
  std::uint32_t least_points = 64;

  /// How many bytes the tiles that are in memory at once may have, roughly; 0: any number. A tile
  /// has 300 bytes for each point that it keeps, and the worst one keeps up to five times its own.
  /// Where all tiles are in memory, it is one that may have so much.
  std::uint64_t memory = 0;

  /// The sample that all tiles are offered has about as many points as this part of one tile: 1 of
  /// `sample_share`, but no more than 16384.
  std::size_t sample_share = 8;

  /// How many points are read at once.
  std::size_t points_at_once = 4000000;

  /// Whether the certificate compares cells, and not sums of their hashes.
  bool compares_cells = false;

  /// Whether the work begins again with more tiles if one becomes larger than `memory` allows.
  bool starts_again = true;

  /// Is called, by any thread but by one at a time, with a word for what is done ("reading", "round
  /// 0", …), how much of it is done and how much there is; if it returns `false`, the work stops.
  std::function<bool(const char*, std::size_t, std::size_t)> progress;
};

/*!
\ingroup PkgDelaunayFromSurface3Tiles

is thrown by `delaunay_3_tiles()` when `Tiles_options::progress` returns `false`.
*/
class Tiles_stopped : public std::runtime_error
{
public:
  /// is constructed with a message of its own.
  Tiles_stopped()
    : std::runtime_error("stopped before all was done")
  {
  }
};

/*!
\ingroup PkgDelaunayFromSurface3Tiles

tells what `delaunay_3_tiles()` did.
*/
struct Tiles_report
{
  std::uint64_t points = 0;    ///< How many there are.
  std::uint32_t tiles = 0;     ///< How many there are.
  std::size_t rounds = 0;      ///< In how many rounds tiles told each other of points,
  std::uint64_t told = 0;      ///< how many points they told,
  std::uint64_t kept = 0;      ///< how many they keep, their own included,
  std::uint64_t most_kept = 0; ///< and how many the largest of them keeps.
  std::uint64_t cells = 0;     ///< How many cells there are, infinite ones included.
  std::uint64_t hash = 0;      ///< The sum of hashes of all cells, as ids.
  bool is_certified = false;   ///< Whether the certificate holds.
};

/// \cond SKIP_IN_MANUAL
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_OPTIONS_H
