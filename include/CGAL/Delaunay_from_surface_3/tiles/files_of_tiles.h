// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_FILES_OF_TILES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_FILES_OF_TILES_H

// The files that a run writes into its folder (write_tiles.h), known by their names; others are not
// touched. What is written is never what is read.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Records.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_files_error.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_source_3.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Whether a file of this name is one of a tile, or of all for ParaView.
inline bool is_file_of_tiles(const std::string& name)
{
  if (name == "tiles.pvtu")
    return true;
  const std::size_t dash = name.find('-');
  const std::size_t dot = name.find_first_not_of("0123456789", dash + 1);
  if (dash == std::string::npos || dot == std::string::npos || dot < dash + 6)
    return false;
  const std::string kind = name.substr(0, dash), extension = name.substr(dot);
  if (extension == ".vtu")
    return kind == "tile";
  return extension == ".npy" &&
         (kind == "cells" || kind == "ids" || kind == "points" || kind == "neighbors");
}

// Whether a file of this name is one of a tile, of all, or the report.
inline bool is_file_of_run(const std::string& name)
{
  return is_file_of_tiles(name) || name == "tiles.json";
}

// The names of what is in a folder and not below; none if there is no folder.
inline std::vector<std::string> names_in(const std::filesystem::path& folder)
{
  std::vector<std::string> names;
  std::error_code error;
  std::filesystem::directory_iterator entry(folder, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error))
    names.push_back(entry->path().filename().string());
  if (error && error != std::errc::no_such_file_or_directory && error != std::errc::not_a_directory)
    throw Tile_files_error(folder.string() + ": cannot be read: " + error.message());
  std::sort(names.begin(), names.end());
  return names;
}

// The files of tiles that are in a folder.
inline std::vector<std::filesystem::path> files_of_tiles(const std::filesystem::path& folder)
{
  std::vector<std::filesystem::path> files;
  for (const std::string& name : names_in(folder))
    if (is_file_of_tiles(name))
      files.push_back(folder / name);
  return files;
}

// What processes have left in the folder of a run that were killed while they wrote a file of it.
inline std::vector<std::filesystem::path> left_files(const std::filesystem::path& folder)
{
  std::vector<std::filesystem::path> files;
  for (const std::string& name : names_in(folder))
    if (is_file_of_run(name_when_finished(name)))
      files.push_back(folder / name);
  return files;
}

// The place that a name means, by way of links; it need not be there, and may be one that the
// system cannot follow.
inline std::filesystem::path place_of(const std::filesystem::path& name)
{
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(name);
  const std::filesystem::path place = std::filesystem::weakly_canonical(absolute, error);
  return error ? absolute.lexically_normal() : place;
}

// Whether a run in this folder writes a file of this name, or removes it with its state.
inline bool is_of_run(const std::filesystem::path& file, const std::filesystem::path& folder)
{
  const std::filesystem::path parent = place_of(file.parent_path()),
                              state = place_of(folder / "state");
  return (is_file_of_run(file.filename().string()) && parent == place_of(folder)) ||
         std::mismatch(state.begin(), state.end(), parent.begin(), parent.end()).first ==
             state.end();
}

// A file that points are read from must not be one that a run in this folder writes.
inline void refuse_to_overwrite(const Tile_source_3& source, const std::filesystem::path& folder)
{
  std::error_code error; // what is not there is not overwritten
  for (const std::filesystem::path& file : source.files())
    for (const auto& place : {std::filesystem::absolute(file, error), place_of(file)})
      if (is_of_run(place, folder))
        throw Tile_files_error(file.string() +
                               ": would be overwritten: name another folder for the tiles");
}

// A file that is written beside those of a run in this folder must be none of these, and none that
// points are read from.
inline void refuse_output(const Tile_source_3& source, const std::filesystem::path& folder,
                          const std::filesystem::path& output)
{
  std::error_code error;
  for (const std::filesystem::path& file : source.files())
    if (std::filesystem::equivalent(file, output, error))
      throw Tile_files_error(output.string() + ": would overwrite the points of " + file.string() +
                             ": name another file");
  for (const auto& place : {std::filesystem::absolute(output, error), place_of(output)})
    if (is_of_run(place, folder))
      throw Tile_files_error(output.string() +
                             ": would overwrite a file of the run: name another file");
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_FILES_OF_TILES_H
