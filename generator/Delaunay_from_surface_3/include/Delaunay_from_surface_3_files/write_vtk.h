// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_FILES_WRITE_VTK_H
#define DELAUNAY_FROM_SURFACE_3_FILES_WRITE_VTK_H

#include <Delaunay_from_surface_3_files/Simplices_3.h>

#include <cstddef>
#include <ostream>

namespace files {

// writes simplices in VTK's legacy text format for unstructured grids, `.vtk`, with the same data as
// `write_vtu()`. Those files are smaller, and read faster.
inline void write_vtk(std::ostream& out, const Simplices_3& s)
{
  static const int vtk_types[] = {1, 3, 5, 10}; // vertex, line, triangle, tetrahedron
  const internal::Full_precision precision(out);
  out << "# vtk DataFile Version 3.0\nDelaunay triangulation\nASCII\nDATASET UNSTRUCTURED_GRID\n"
      << "POINTS " << s.points.size() << " double\n";
  internal::write_points(
      out, s, [](std::size_t) {}, "\n");
  out << "CELLS " << s.size() << ' ' << s.size() * (s.corners() + 1) << '\n';
  internal::write_rows(
      out, s, s.simplices, 0, [&](std::size_t) { out << s.corners() << ' '; }, "\n");
  out << "CELL_TYPES " << s.size() << '\n';
  for (std::size_t c = 0; c < s.size(); ++c)
    out << vtk_types[s.dimension] << '\n';
  out << "POINT_DATA " << s.points.size() << "\nSCALARS input_index long 1\nLOOKUP_TABLE default\n";
  for (const auto i : s.input_indices)
    out << i << '\n';
  if (!s.data.empty())
    out << "CELL_DATA " << s.size() << '\n';
  for (const Simplices_3::Data& data : s.data) {
    out << "SCALARS " << data.name << " double 1\nLOOKUP_TABLE default\n";
    for (const double value : data.values)
      out << value << '\n';
  }
}

} // namespace files

#endif // DELAUNAY_FROM_SURFACE_3_FILES_WRITE_VTK_H
