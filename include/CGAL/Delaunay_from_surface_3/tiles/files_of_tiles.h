// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_FILES_OF_TILES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_FILES_OF_TILES_H

// The files that a run writes into its folder (write_tiles.h), known by their names.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
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

// Those that are in a folder, by name; none if there is no folder.
inline std::vector<std::filesystem::path> files_of_tiles(const std::filesystem::path& folder)
{
  std::vector<std::filesystem::path> files;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
    if (is_file_of_tiles(entry.path().filename().string()))
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// A file that points are read from must not be one that a run in this folder writes.
inline void refuse_to_overwrite(const Tile_source_3& source, const std::filesystem::path& folder)
{
  std::error_code error; // what is not there is not overwritten
  for (const std::filesystem::path& file : source.files())
    for (const auto& place :
         {std::filesystem::absolute(file, error), std::filesystem::canonical(file, error)})
      if (is_file_of_tiles(place.filename().string()) &&
          std::filesystem::equivalent(place.parent_path(), folder, error))
        throw Tile_files_error(file.string() +
                               ": would be overwritten: name another folder for the tiles");
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_FILES_OF_TILES_H
