// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_TILES_FOLDER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_TILES_FOLDER_H

// The folder of a run that keeps no state in it.

#include <CGAL/Delaunay_from_surface_3/tiles/Point_files_3.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_folder.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_to_files.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

namespace core = CGAL::Delaunay_from_surface_3::internal;

// Returns the file that stands in a folder as long as a run has not ended there.
inline std::filesystem::path mark_of_run(const std::filesystem::path& folder)
{
  return folder / "tiles.begun";
}

// Makes the folder, or refuses one with tiles of another run. With its mark, what a run has left that did
// not end is removed, as it may have had more tiles; without it, the files are somebody else's.
inline void make_folder(const std::filesystem::path& folder, const std::vector<std::string>& inputs)
{
  for (const auto& file : {folder / "tiles.json", folder / "state" / "input"})
    if (std::filesystem::exists(file))
      throw CGAL::Tile_files_error(file.string() +
                                   ": is of another run: remove it, or name another folder");
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    core::fail_to_write(folder, error.value());
  std::vector<std::filesystem::path> files = core::files_of_tiles(folder);
  const std::vector<std::filesystem::path> left = core::left_files(folder);
  files.insert(files.end(), left.begin(), left.end());
  for (const auto& file : files)
    for (const std::string& input : inputs)
      if (std::filesystem::equivalent(file, input, error))
        throw CGAL::Tile_files_error(file.string() +
                                     ": would be overwritten: name another folder for the tiles");
  if (!files.empty() && !std::filesystem::exists(mark_of_run(folder)))
    throw CGAL::Tile_files_error(files.front().string() +
                                 ": is not of a run that was stopped here: remove all files of "
                                 "tiles, or name another folder");
  for (const auto& file : files)
    if (!std::filesystem::remove(file, error) && error)
      core::fail_to_write(file, error.value());
  errno = 0;
  if (!std::ofstream(mark_of_run(folder)).flush())
    core::fail_to_write(mark_of_run(folder), errno);
}

// Whether a run of these points has ended there, as eight vertices of each tile tell.
inline bool has_ended_with(const std::filesystem::path& folder, const CGAL::Tile_source_3& source)
{
  if (!std::filesystem::exists(folder / "tiles.json"))
    return false;
  const std::uint32_t tiles = core::number_of_tiles_in(folder);
  for (std::uint32_t t = 0; t < tiles; ++t) {
    const auto file_of_ids = core::file_of_tile(folder, "ids", t, "npy");
    const auto file_of_points = core::file_of_tile(folder, "points", t, "npy");
    const core::Rows_of_npy ids(file_of_ids, 8), points(file_of_points, 24);
    core::Bytes_reader from_ids(file_of_ids), from_points(file_of_points);
    for (std::uint64_t k = 0; k < 8 && ids.number > 0; ++k) {
      const std::uint64_t row = (ids.number - 1) * k / 7;
      std::int64_t id = 0;
      std::array<double, 3> point, expected;
      from_ids.seek(ids.first + 8 * row);
      from_ids.read(&id, 8);
      from_points.seek(points.first + 24 * row);
      from_points.read(point.data(), 24);
      if (std::uint64_t(id) >= source.size())
        return false;
      source.read(std::uint64_t(id), 1, expected.data());
      if (point != expected)
        return false;
    }
  }
  return core::value_in_report(folder, "points") == source.size();
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_TILES_FOLDER_H
