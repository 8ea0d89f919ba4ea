// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A peer of compare_with_plain: TetGen's Delaunay tetrahedralization of points.

#include <Delaunay_from_surface_3_comparison/points_file.h>

#include <tetgen.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <vector>

int main(int argc, char** argv)
{
  if (argc != 2) {
    std::cerr << "usage: tetgen_peer FILE-OF-POINTS\n";
    return EXIT_FAILURE;
  }
  try {
    const std::vector<double> coordinates = comparison::read_points_file(argv[1]);
    tetgenio in, out;
    in.numberofpoints = static_cast<int>(coordinates.size() / 3);
    in.pointlist = new REAL[coordinates.size()]; // tetgenio deletes it
    std::copy(coordinates.begin(), coordinates.end(), in.pointlist);
    char switches[] = "Q"; // quiet, and nothing but the points' tetrahedralization
    comparison::Stopwatch watch;
    tetrahedralize(switches, &in, &out);
    watch.stop();
    comparison::print_answer(watch, static_cast<std::size_t>(out.numberoftetrahedra), 1, "TetGen",
                             DELAUNAY_FROM_SURFACE_3_BUILT_AS);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << "tetgen_peer: " << error.what() << '\n';
  } catch (int code) { // what TetGen throws
    std::cerr << "tetgen_peer: TetGen gave up with code " << code << '\n';
  }
  return EXIT_FAILURE;
}
