// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_FORGET_FOLDER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_FORGET_FOLDER_H

// A folder that goes at once: who is killed while its files are removed leaves none under its name.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Records.h>
#include <CGAL/Delaunay_from_surface_3/tiles/files_of_tiles.h>

#include <filesystem>
#include <random>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// It is renamed first, to what ends like all that is not complete.
inline void forget_folder(const std::filesystem::path& place)
{
  std::random_device random;
  std::filesystem::path aside = place;
  aside += "-" + std::to_string(random()) + unfinished;
  std::error_code error;
  std::filesystem::rename(place, aside, error);
  if (error && std::filesystem::exists(place))
    fail_to_write(place, error.value());
  std::filesystem::remove_all(aside, error);
}

// What processes left that were killed while they forgot it.
inline void remove_forgotten(const std::filesystem::path& place)
{
  std::error_code ignored; // it may be another's, or gone
  for (const std::string& name : names_in(place.parent_path()))
    if (name_when_finished(name) == place.filename().string())
      std::filesystem::remove_all(place.parent_path() / name, ignored);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_FORGET_FOLDER_H
