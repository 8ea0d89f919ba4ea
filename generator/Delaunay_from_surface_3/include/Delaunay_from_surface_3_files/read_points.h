// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_POINTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_POINTS_H

#include <Delaunay_from_surface_3_files/Lines.h>
#include <Delaunay_from_surface_3_files/Polygon_soup.h>

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace files {

// Reads .xyz and .pts: a point in each line, three numbers. What stands behind them, normals,
// intensities or colors, is passed over. A line with one word alone is the number of points that
// follow, which Leica's .pts has; it is not believed, but kept.
inline Polygon_soup read_points(std::string_view text)
{
  Polygon_soup soup;
  Lines lines(text);
  try {
    while (lines.next()) {
      std::string_view line = lines.line();
      const std::string_view first = next_word(line);
      const std::size_t number = next_word(line).empty() ? parse_index(first) : no_index;
      if (number != no_index) {
        soup.announced_points += (std::min)(number, no_index - soup.announced_points);
        continue;
      }
      const auto x = read_coordinates(lines);
      soup.points.emplace_back(x[0], x[1], x[2]);
    }
  } catch (const Bad_content& error) {
    throw Bad_content(lines.place() + error.what());
  }
  return soup;
}

} // namespace files

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_POINTS_H
