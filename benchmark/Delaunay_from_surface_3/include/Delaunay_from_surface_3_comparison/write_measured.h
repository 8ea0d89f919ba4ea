// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_WRITE_MEASURED_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_WRITE_MEASURED_H

#include <Delaunay_from_surface_3_comparison/machine.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

namespace comparison {

// The whole program: its options by read_options(argc, argv), a report that measure(options, report)
// adds to, and its JSON in options.output. Returns the exit status.
template <class ReadOptions, class Measure>
int write_measured(const std::string& program, int argc, char** argv,
                   const ReadOptions& read_options, const Measure& measure)
try {
  const auto options = read_options(argc, argv);
  auto report = begin_report(program, argc, argv, DELAUNAY_FROM_SURFACE_3_COMPILER_FLAGS);
  measure(options, report);
  write_report(options.output, report);
  return EXIT_SUCCESS;
} catch (const std::exception& e) {
  std::cerr << program << ": " << e.what() << "\n";
  return EXIT_FAILURE;
}

} // namespace comparison

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_WRITE_MEASURED_H
