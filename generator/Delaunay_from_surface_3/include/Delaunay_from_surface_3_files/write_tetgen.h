// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_FILES_WRITE_TETGEN_H
#define DELAUNAY_FROM_SURFACE_3_FILES_WRITE_TETGEN_H

#include <Delaunay_from_surface_3_files/Simplices_3.h>

#include <cstddef>
#include <ostream>

namespace files {

// writes the points in TetGen's format `.node`, counted from 0.
inline void write_tetgen_node(std::ostream& out, const Simplices_3& s)
{
  const internal::Full_precision precision(out);
  out << s.points.size() << " 3 0 0\n";
  internal::write_points(
      out, s, [&](std::size_t i) { out << i << ' '; }, "\n");
}

// writes tetrahedra in TetGen's format `.ele`, counted from 0. TetGen's own have the same
// orientation.
// \pre the dimension is 3
inline void write_tetgen_ele(std::ostream& out, const Simplices_3& s)
{
  out << s.size() << " 4 0\n";
  internal::write_rows(
      out, s, s.simplices, 0, [&](std::size_t c) { out << c << ' '; }, "\n");
}

// writes the neighbours in TetGen's format `.neigh`: the i-th is opposite to the i-th corner, -1
// for none.
// \pre the dimension is 3, and the neighbours are known
inline void write_tetgen_neigh(std::ostream& out, const Simplices_3& s)
{
  out << s.size() << " 4\n";
  internal::write_rows(
      out, s, s.neighbors, 0, [&](std::size_t c) { out << c << ' '; }, "\n");
}

} // namespace files

#endif // DELAUNAY_FROM_SURFACE_3_FILES_WRITE_TETGEN_H
