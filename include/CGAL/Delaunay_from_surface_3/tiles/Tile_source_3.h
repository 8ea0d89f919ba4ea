// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_SOURCE_3_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_SOURCE_3_H

#include <CGAL/Delaunay_from_surface_3/core/order/Split_mix.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

namespace CGAL {
/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {
/// \endcond

/*!
\ingroup PkgDelaunayFromSurface3Tiles

is the base class of the sources of points for `delaunay_3_tiles()`, which reads any range of points
at any time, by any thread. The id of a point is its position, from 0 on.
*/
class Tile_source_3
{
public:
  virtual ~Tile_source_3() = default;

  /// returns the number of points.
  virtual std::uint64_t size() const = 0;

  /// writes the coordinates of the points `first`, …, `first + n - 1` to `coordinates`, three of
  /// each.
  virtual void read(std::uint64_t first, std::size_t n, double* coordinates) const = 0;

  /// returns the first point of part `part` of `parts` consecutive parts; part `parts` begins at
  /// `size()`. Processes that share the work read one part each, and nothing else. If the points
  /// are distributed over the memories of several processes, redefine this function accordingly.
  virtual std::uint64_t first_of_part(std::uint64_t part, std::uint64_t parts) const
  {
    return size() / parts * part + size() % parts * part / parts;
  }

  /// returns a number that differs if the points may have changed, for example by the times of
  /// files. An interrupted run continues only with the points with which it began.
  virtual std::uint64_t stamp() const { return 0; }

  /// returns the files that the points are read from, if any. A run that would overwrite one of them
  /// is refused.
  virtual std::vector<std::filesystem::path> files() const { return {}; }

  /// returns a name of point `i`, for messages.
  virtual std::string name_of(std::uint64_t i) const { return "point " + std::to_string(i); }
};

/*!
\ingroup PkgDelaunayFromSurface3Tiles

is a source of `n` points in memory, stored as `3 n` numbers that the caller owns.
*/
class Tile_array_source_3 : public Tile_source_3
{
public:
  /// keeps the pointer, not a copy of the numbers.
  Tile_array_source_3(const double* coordinates, std::uint64_t n)
    : m_coordinates(coordinates)
    , m_size(n)
  {
  }

  /// returns `n`.
  std::uint64_t size() const override { return m_size; }

  /// copies the coordinates.
  void read(std::uint64_t first, std::size_t n, double* coordinates) const override
  {
    std::copy(m_coordinates + 3 * first, m_coordinates + 3 * (first + n), coordinates);
  }

  /// returns a hash of all coordinates. Linear: they are read once more when work in a folder begins
  /// or continues.
  std::uint64_t stamp() const override
  {
    std::uint64_t stamp = 0;
    for (const double* x = m_coordinates; x != m_coordinates + 3 * m_size; ++x) {
      std::uint64_t bits;
      std::memcpy(&bits, x, sizeof(bits));
      stamp = Delaunay_from_surface_3::internal::Split_mix(stamp ^ bits)();
    }
    return stamp;
  }

private:
  const double* m_coordinates;
  std::uint64_t m_size;
};

/// \cond SKIP_IN_MANUAL
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_SOURCE_3_H
