// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Compiled several times, each time in another form: UNIT is the name of what it defines.

#include <CGAL/delaunay_3_arrays.h>

#include <array>
#include <cstddef>
#include <vector>

std::size_t UNIT(const std::vector<std::array<double, 3>>& points,
                 const std::vector<std::array<int, 3>>& faces)
{
  return CGAL::delaunay_3_arrays(points, faces).number_of_cells();
}
