// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_FILES_POLYGON_SOUP_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_FILES_POLYGON_SOUP_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

/// Reading and writing of files that may be damaged, hostile, or on a full disk.
namespace files {

// What a file with a surface holds, in its order.
struct Polygon_soup
{
  std::vector<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  std::size_t collapsed_triangles = 0; // of .stl, which are left out
  std::size_t announced_points = 0;    // by .xyz and .pts; there may be fewer
};

// What is wrong with the content of a file; who catches it adds the name.
class Bad_content : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

} // namespace files

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_FILES_POLYGON_SOUP_H
