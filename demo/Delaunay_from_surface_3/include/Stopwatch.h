// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_STOPWATCH_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_STOPWATCH_H

#include <chrono>
#include <ctime>

// Seconds of the process on all processors, and seconds of wall-clock time.
struct Seconds
{
  double cpu, wall;
};

// Returns how long `work` takes.
template <class Work>
Seconds time_of(const Work& work)
{
  const auto wall = std::chrono::steady_clock::now();
  const std::clock_t cpu = std::clock();
  work();
  return {double(std::clock() - cpu) / CLOCKS_PER_SEC,
          std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count()};
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_STOPWATCH_H
