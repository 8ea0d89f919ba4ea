// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A peer of compare_with_plain: TetGen's Delaunay tetrahedralization of points.

#include <Delaunay_from_surface_3_comparison/points_file.h>

#define TETLIBRARY // as its library is built
#include <tetgen.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

int main(int argc, char** argv)
{
  return comparison::run_peer(
      "tetgen_peer", false, argc, argv, [](unsigned, const std::vector<double>& coordinates) {
        tetgenio in, out;
        in.numberofpoints = static_cast<int>(coordinates.size() / 3);
        in.pointlist = new REAL[coordinates.size()]; // tetgenio deletes it
        std::copy(coordinates.begin(), coordinates.end(), in.pointlist);
        char switches[] = "Q"; // quiet, and nothing but the points' tetrahedralization
        comparison::Stopwatch watch;
        try {
          tetrahedralize(switches, &in, &out);
        } catch (int code) {
          throw std::runtime_error("TetGen gave up with code " + std::to_string(code));
        }
        watch.stop();
        comparison::print_answer(watch, static_cast<std::size_t>(out.numberoftetrahedra), 1,
                                 "TetGen", DELAUNAY_FROM_SURFACE_3_BUILT_AS);
      });
}
