// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_JOIN_TILES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_JOIN_TILES_H

// One array from those of all tiles.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Point_file_layout.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Records.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_files_error.h>
#include <CGAL/Delaunay_from_surface_3/tiles/write_tiles.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// How many rows the array of a tile has; they begin at byte 128 of the file, or where its head
// says.
struct Rows_of_npy
{
  std::uint64_t number = 0, first = 0;

  explicit Rows_of_npy(const std::filesystem::path& file,
                       std::size_t bytes_of_row = sizeof(Global_cell))
  {
    Bytes_reader from(file);
    unsigned char start[10] = {};
    from.read(start, 10);
    std::string head(start[8] + 256u * start[9], ' ');
    from.read(head.data(), head.size());
    first = 10 + head.size();
    number = std::strtoull(value_of_key(head, "shape", ",").c_str(), nullptr, 10);
    if (size_of_file(file) != first + number * bytes_of_row)
      refuse_file(file, "has another size than its head says");
  }
};

// A number of the report of a run that has ended.
inline std::uint64_t value_in_report(const std::filesystem::path& folder, const std::string& name)
{
  const auto place = folder / "tiles.json";
  if (!std::filesystem::exists(place))
    throw Tile_files_error(folder.string() + ": has no tiles.json: no run has ended there");
  std::string text(std::size_t(size_of_file(place)), ' ');
  Bytes_reader(place).read(text.data(), text.size());
  const std::string key = "\"" + name + "\": ";
  const std::size_t at = text.find(key);
  if (at == std::string::npos)
    refuse_file(place, "does not say how many " + name + " there are");
  return std::strtoull(text.c_str() + at + key.size(), nullptr, 10);
}

inline std::uint32_t number_of_tiles_in(const std::filesystem::path& folder)
{
  return std::uint32_t(value_in_report(folder, "tiles"));
}

// Writes the cells of so many tiles, or their neighbors, in the order of the tiles, as one .npy.
// Returns how many cells there are.
inline std::uint64_t join_tiles(const std::filesystem::path& folder, std::uint32_t tiles,
                                Bytes_writer& to, const char* kind = "cells")
{
  std::uint64_t rows = 0;
  for (std::uint32_t t = 0; t < tiles; ++t)
    rows += Rows_of_npy(file_of_tile(folder, kind, t, "npy")).number;
  const std::string head = head_of_npy("i8", rows, 4);
  to.write(head.data(), head.size());
  std::vector<Global_cell> some(65536);
  for (std::uint32_t t = 0; t < tiles; ++t) {
    const auto file = file_of_tile(folder, kind, t, "npy");
    const Rows_of_npy of_tile(file);
    Bytes_reader from(file);
    from.seek(of_tile.first);
    for (std::uint64_t left = of_tile.number; left > 0;) {
      const std::size_t n = std::size_t((std::min)(left, std::uint64_t(some.size())));
      from.read(some.data(), n * sizeof(Global_cell));
      to.write(some.data(), n * sizeof(Global_cell));
      left -= n;
    }
  }
  to.finish();
  return rows;
}

// Of a run that has ended.
inline std::uint64_t join_tiles(const std::filesystem::path& folder,
                                const std::filesystem::path& output, const char* kind = "cells")
{
  const std::uint32_t tiles = number_of_tiles_in(folder);
  Bytes_writer to(output);
  return join_tiles(folder, tiles, to, kind);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_JOIN_TILES_H
