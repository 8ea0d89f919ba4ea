// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Prints the table of fixed_inputs.h as this compiler has it: by one thread, or by as many as the
// first argument says. Returns how many lines differ from the header. test_same_bytes.py builds it
// in many ways.

#include "arrays_by_threads.h"
#include "fixed_inputs.h"

#include <CGAL/delaunay_3_arrays.h>

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv)
{
  const std::size_t threads = argc > 1 ? std::size_t(std::atoi(argv[1])) : 1;
  int mistakes = 0;
  for (const tests::Fixed_input& input : tests::fixed_inputs) {
    const auto points = tests::points_of(input);
    const auto line =
        tests::line_of(input.name, threads == 1 ? CGAL::delaunay_3_arrays(points)
                                                : tests::arrays_by_threads(threads, points));
    std::printf("%s,\n", line.c_str());
    mistakes += line != tests::line_of(input);
  }
  return mistakes;
}
