// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_IO_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_IO_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/refine.h>

#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>

#include <fstream>
#include <stdexcept>
#include <string>

namespace surfaces {

/// Reads a triangle mesh in any format that CGAL knows; a soup is oriented and repaired on the way.
/// Throws `std::runtime_error` when there is no file or no mesh in it.
inline Mesh read_mesh(const std::string& file_name)
{
  if (!std::ifstream(file_name)) // said here, as CGAL would print a line of its own
    throw std::runtime_error("cannot open '" + file_name + "'");
  Mesh mesh;
  if (!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file_name, mesh) || is_empty(mesh))
    throw std::runtime_error("cannot read a mesh from '" + file_name + "'");
  return mesh;
}

/// Writes a surface; the end of the name says how: `.off` (text, all digits) or `.ply` (binary,
/// exact and much faster). Throws `std::runtime_error` when the file cannot be written.
inline void write_surface(const Indexed_surface& surface, const std::string& file_name)
{
  const auto ends_with = [&file_name](const std::string& end) {
    return file_name.size() > end.size() && file_name.substr(file_name.size() - end.size()) == end;
  };
  bool written = false;
  if (ends_with(".off"))
    written = CGAL::IO::write_OFF(file_name, surface.points, surface.faces,
                                  CGAL::parameters::stream_precision(17));
  else if (ends_with(".ply"))
    written = CGAL::IO::write_PLY(file_name, surface.points, surface.faces,
                                  CGAL::parameters::use_binary_mode(true));
  else
    throw std::runtime_error("'" + file_name + "' must end in .off or .ply");
  if (!written)
    throw std::runtime_error("cannot write '" + file_name + "'");
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_IO_H
