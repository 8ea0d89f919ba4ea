// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_IO_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_IO_H

#include <Delaunay_from_surface_3_files/Output_file.h>
#include <Delaunay_from_surface_3_files/read_polygon_soup.h>
#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>

#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace surfaces {

inline bool is_finite(const Indexed_surface::Point_3& p)
{
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

/// Reads a triangle mesh; a soup is oriented and repaired on the way, as by
/// `CGAL::Polygon_mesh_processing::IO::read_polygon_mesh()`.
/// Throws `std::runtime_error` when there is no file or no mesh in it.
inline Mesh read_mesh(const std::string& file_name)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  files::Polygon_soup soup = files::read_polygon_soup(file_name);
  if (!std::all_of(soup.points.begin(), soup.points.end(), is_finite))
    throw std::runtime_error(file_name + ": a coordinate is not a finite number");
  PMP::repair_polygon_soup(soup.points, soup.faces);
  PMP::orient_polygon_soup(soup.points, soup.faces);
  Mesh mesh;
  if (PMP::is_polygon_soup_a_polygon_mesh(soup.faces))
    PMP::polygon_soup_to_polygon_mesh(soup.points, soup.faces, mesh);
  if (is_empty(mesh))
    throw std::runtime_error(file_name + ": there is no mesh in it");
  return mesh;
}

/// Writes a surface; the end of the name says how: `.off` (text, all digits) or `.ply` (binary,
/// exact and much faster). The file appears when it is complete.
/// Throws `std::runtime_error` when it cannot be written.
inline void write_surface(const Indexed_surface& surface, const std::string& file_name)
{
  const std::string extension = files::file_extension(file_name);
  if (extension != "off" && extension != "ply")
    throw std::runtime_error(file_name + ": must end in .off or .ply");
  files::Output_file file(file_name);
  if (extension == "off")
    CGAL::IO::write_OFF(file.stream(), surface.points, surface.faces,
                        CGAL::parameters::stream_precision(17));
  else {
    CGAL::IO::set_binary_mode(file.stream());
    CGAL::IO::write_PLY(file.stream(), surface.points, surface.faces);
  }
  file.finish();
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_IO_H
