// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_READ_SURFACE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_READ_SURFACE_H

#include "Surface.h"
#include "file_extension.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

// Says which of the many reasons it is, before a reader can only say that it failed.
inline void check_input_file(const std::string& file_name)
{
  const std::string extension = file_extension(file_name);
  if (extension != "off" && extension != "ply" && extension != "obj" && extension != "stl")
    throw std::runtime_error(file_name + ": unknown extension; .off, .ply, .obj and .stl are read");
  if (std::filesystem::is_directory(file_name))
    throw std::runtime_error(file_name + ": is a directory");
  errno = 0;
  if (!std::ifstream(file_name))
    throw std::runtime_error(file_name + ": " + std::generic_category().message(errno));
  if (std::filesystem::is_regular_file(file_name) && std::filesystem::file_size(file_name) == 0)
    throw std::runtime_error(file_name + ": the file is empty");
}

// CGAL's reader of .stl unites equal points, and takes one with NaN for equal to any other: NaN
// would be gone after it. In text the reader refuses NaN, so only a binary file is looked at: 84
// bytes of which the last four are the number of triangles, and 50 bytes for each triangle.
inline void check_numbers_of_binary_stl(const std::string& file_name)
{
  std::ifstream file(file_name, std::ios::binary);
  std::uint32_t size = 0;
  file.seekg(80).read(reinterpret_cast<char*>(&size), sizeof(size));
  if (!file || std::filesystem::file_size(file_name) != 84 + 50 * std::uintmax_t(size))
    return;
  std::array<char, 50> triangle;
  std::array<float, 9> coordinates; // after a normal vector, which often is NaN and not used
  for (std::uint32_t t = 0; t < size && file.read(triangle.data(), triangle.size()); ++t) {
    std::memcpy(coordinates.data(), triangle.data() + 12, sizeof(coordinates));
    if (!std::all_of(coordinates.begin(), coordinates.end(),
                     [](float x) { return std::isfinite(x); }))
      throw std::runtime_error(file_name + ": triangle " + std::to_string(t) +
                               ": a coordinate is not a finite number");
  }
}

inline void check_indices(const std::string& file_name, const Surface& surface)
{
  for (std::size_t f = 0; f < surface.faces.size(); ++f)
    for (const std::size_t i : surface.faces[f])
      if (i >= surface.points.size())
        throw std::runtime_error(file_name + ": face " + std::to_string(f) +
                                 ": it has a vertex that is not one of the " +
                                 std::to_string(surface.points.size()));
}

// Reads a surface in any of the formats that CGAL reads. It is a polygon soup first, and also a
// mesh if its faces are a manifold. The coordinates are left to be checked by the package.
inline Surface read_surface(const std::string& file_name)
{
  check_input_file(file_name);
  const std::string extension = file_extension(file_name);
  if (extension == "stl")
    check_numbers_of_binary_stl(file_name);
  Surface surface;
  if (!CGAL::IO::read_polygon_soup(file_name, surface.points, surface.faces))
    throw std::runtime_error(file_name + ": cannot be read as ." + extension +
                             "; it is damaged, cut short or in another format");
  if (surface.points.empty())
    throw std::runtime_error(file_name + ": there are no vertices in it");
  check_indices(file_name, surface);

  namespace PMP = CGAL::Polygon_mesh_processing;
  surface.is_manifold =
      !surface.faces.empty() && PMP::is_polygon_soup_a_polygon_mesh(surface.faces);
  if (surface.is_manifold)
    PMP::polygon_soup_to_polygon_mesh(surface.points, surface.faces, surface.mesh);
  return surface;
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_READ_SURFACE_H
