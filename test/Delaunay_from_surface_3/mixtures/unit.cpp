// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Compiled several times, each time in another form: UNIT is the name of what it defines.

#include <CGAL/delaunay_3_arrays.h>
#if defined(CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED)
#include <CGAL/delaunay_3_tiles.h>
#endif

#include <array>
#include <cstddef>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace {

using Points = std::vector<std::array<double, 3>>;

// Of two tiles in files, by the library; a unit without it has nothing to add.
#if defined(CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED)
std::size_t cells_of_tiles(const Points& points)
{
  const auto folder = std::filesystem::temp_directory_path() /
                      ("mixtures-" + std::to_string(std::random_device()()));
  CGAL::Tiles_in_files_3 engine(folder);
  CGAL::Tiles_options options;
  options.number_of_tiles = 2;
  const auto report = CGAL::delaunay_3_tiles(
      engine, CGAL::Tile_array_source_3(points.front().data(), points.size()),
      [](const CGAL::Delaunay_3_tile&) {}, options);
  std::filesystem::remove_all(folder);
  return report.cells;
}
#else
std::size_t cells_of_tiles(const Points& points)
{
  return CGAL::delaunay_3_arrays(points).number_of_cells();
}
#endif

} // namespace

std::size_t UNIT(const Points& points, const std::vector<std::array<int, 3>>& faces)
{
  const std::size_t cells = CGAL::delaunay_3_arrays(points, faces).number_of_cells();
  return cells_of_tiles(points) == cells ? cells : 0;
}
