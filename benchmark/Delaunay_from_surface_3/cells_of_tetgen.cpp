// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// TetGen's tetrahedra, to which the Python module's are compared by python/test_learning.py. Reads
// the number of points and their coordinates, and writes the corners.

#define TETLIBRARY // as its library is built
#include <tetgen.h>

#include <cstddef>
#include <cstdio>

int main()
{
  int n;
  if (std::fread(&n, sizeof(n), 1, stdin) != 1)
    return 1;
  tetgenio in, out;
  in.numberofpoints = n;
  in.pointlist = new REAL[3 * n]; // tetgenio deletes it
  if (std::fread(in.pointlist, sizeof(REAL), 3 * n, stdin) != std::size_t(3 * n))
    return 1;
  char switches[] = "Q";
  tetrahedralize(switches, &in, &out);
  std::fwrite(out.tetrahedronlist, sizeof(int), 4 * out.numberoftetrahedra, stdout);
}
