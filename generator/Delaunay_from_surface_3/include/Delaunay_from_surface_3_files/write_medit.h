// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_FILES_WRITE_MEDIT_H
#define DELAUNAY_FROM_SURFACE_3_FILES_WRITE_MEDIT_H

#include <Delaunay_from_surface_3_files/Simplices_3.h>

#include <cstddef>
#include <ostream>

namespace files {

// writes simplices in Medit's text format, `.mesh`. The last number of each line is a label that means
// nothing here; data are not written.
inline void write_medit(std::ostream& out, const Simplices_3& s)
{
  static const char* const keywords[] = {nullptr, "Edges", "Triangles", "Tetrahedra"};
  const internal::Full_precision precision(out);
  out << "MeshVersionFormatted 2\nDimension 3\n\nVertices\n" << s.points.size() << '\n';
  internal::write_points(
      out, s, [](std::size_t) {}, " 0\n");
  if (s.dimension > 0) {
    out << '\n' << keywords[s.dimension] << '\n' << s.size() << '\n';
    internal::write_rows(
        out, s, s.simplices, 1, [](std::size_t) {}, " 0\n");
  }
  out << "\nEnd\n";
}

} // namespace files

#endif // DELAUNAY_FROM_SURFACE_3_FILES_WRITE_MEDIT_H
