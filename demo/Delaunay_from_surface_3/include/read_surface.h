// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_READ_SURFACE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_READ_SURFACE_H

#include "Surface.h"

#include <Delaunay_from_surface_3_files/read_polygon_soup.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <string>
#include <utility>

// Reads a surface in this format, first as a polygon soup, and also as a mesh if its faces are a
// manifold. The package checks the coordinates.
inline Surface read_surface(const std::string& file_name, const std::string& format)
{
  files::Polygon_soup soup = files::read_polygon_soup(file_name, format);
  Surface surface;
  surface.points = std::move(soup.points);
  surface.faces = std::move(soup.faces);
  surface.collapsed_triangles = soup.collapsed_triangles;
  surface.announced_points = soup.announced_points;
  namespace PMP = CGAL::Polygon_mesh_processing;
  surface.is_manifold =
      !surface.faces.empty() && PMP::is_polygon_soup_a_polygon_mesh(surface.faces);
  if (surface.is_manifold)
    PMP::polygon_soup_to_polygon_mesh(surface.points, surface.faces, surface.mesh);
  return surface;
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_READ_SURFACE_H
