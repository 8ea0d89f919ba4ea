// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_IO_WRITE_TETGEN_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_IO_WRITE_TETGEN_H

#include <CGAL/Delaunay_from_surface_3/IO/Simplices_3.h>

#include <cstddef>
#include <ostream>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/// \ingroup PkgDelaunayFromSurface3IO
/// writes the points in TetGen's format `.node`, counted from 0.
inline void write_tetgen_node(std::ostream& out, const Simplices_3& s)
{
  const internal::Full_precision precision(out);
  out << s.points.size() << " 3 0 0\n";
  internal::write_points(
      out, s, [&](std::size_t i) { out << i << ' '; }, "\n");
}

/// \ingroup PkgDelaunayFromSurface3IO
/// writes tetrahedra in TetGen's format `.ele`, counted from 0. TetGen's own have the other
/// orientation: two corners change places. \pre the dimension is 3
inline void write_tetgen_ele(std::ostream& out, const Simplices_3& s)
{
  out << s.size() << " 4 0\n";
  for (std::size_t c = 0; c < s.size(); ++c) {
    const auto* const v = s.simplices.data() + 4 * c;
    out << c << ' ' << v[1] << ' ' << v[0] << ' ' << v[2] << ' ' << v[3] << '\n';
  }
}

/// \ingroup PkgDelaunayFromSurface3IO
/// writes the neighbours in TetGen's format `.neigh`, in the order of the corners that
/// `write_tetgen_ele()` writes; -1 for none. \pre the dimension is 3, and the neighbours are known
inline void write_tetgen_neigh(std::ostream& out, const Simplices_3& s)
{
  out << s.size() << " 4\n";
  for (std::size_t c = 0; c < s.size(); ++c) {
    const auto* const n = s.neighbors.data() + 4 * c;
    out << c << ' ' << n[1] << ' ' << n[0] << ' ' << n[2] << ' ' << n[3] << '\n';
  }
}

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_IO_WRITE_TETGEN_H
