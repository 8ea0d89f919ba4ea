// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_FILES_WRITE_GMSH_H
#define DELAUNAY_FROM_SURFACE_3_FILES_WRITE_GMSH_H

#include <Delaunay_from_surface_3_files/Simplices_3.h>

#include <cstddef>
#include <ostream>

namespace files {

// writes simplices in Gmsh's text format, `.msh`, version 2.2, which every reader of such files knows.
// All elements are of entity 1, without a physical group; data are written as `ElementData`.
inline void write_gmsh(std::ostream& out, const Simplices_3& s)
{
  static const int gmsh_types[] = {15, 1, 2, 4}; // point, line, triangle, tetrahedron
  const internal::Full_precision precision(out);
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << s.points.size() << '\n';
  internal::write_points(
      out, s, [&](std::size_t i) { out << i + 1 << ' '; }, "\n");
  out << "$EndNodes\n$Elements\n" << s.size() << '\n';
  internal::write_rows(
      out, s, s.simplices, 1,
      [&](std::size_t c) { out << c + 1 << ' ' << gmsh_types[s.dimension] << " 2 0 1 "; }, "\n");
  out << "$EndElements\n";
  for (const Simplices_3::Data& data : s.data) {
    out << "$ElementData\n1\n\"" << data.name << "\"\n1\n0\n3\n0\n1\n" << s.size() << '\n';
    for (std::size_t c = 0; c < s.size(); ++c)
      out << c + 1 << ' ' << data.values[c] << '\n';
    out << "$EndElementData\n";
  }
}

} // namespace files

#endif // DELAUNAY_FROM_SURFACE_3_FILES_WRITE_GMSH_H
