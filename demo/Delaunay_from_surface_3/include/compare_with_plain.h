// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_COMPARE_WITH_PLAIN_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_COMPARE_WITH_PLAIN_H

#include "Messages.h"
#include "Report.h"
#include "Stopwatch.h"
#include "Surface.h"

#include <algorithm>
#include <string>
#include <vector>

// Times the package on the surface, from nothing; destruction is not timed.
template <class Traits>
Seconds time_package(const Surface& surface, const Traits& traits, unsigned int seed)
{
  Triangulation tr;
  return time_of([&] { insert_surface(tr, surface, traits, CGAL::parameters::random_seed(seed)); });
}

// Times CGAL's own insertion of the points in the order of the file, from nothing into `tr`.
inline Seconds time_plain(const Surface& surface, Triangulation& tr)
{
  return time_of([&] { tr.insert(surface.points.begin(), surface.points.end()); });
}

inline double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

struct Timings
{
  std::vector<double> cpu, wall;

  void add(const Seconds& seconds)
  {
    cpu.push_back(seconds.cpu);
    wall.push_back(seconds.wall);
  }
};

inline void report_timings(Report& report, const Timings& package, const Timings& plain)
{
  const double package_cpu = median(package.cpu), package_wall = median(package.wall);
  const double plain_cpu = median(plain.cpu), plain_wall = median(plain.wall);
  report("repetitions", package.cpu.size());
  report("package CPU seconds", package_cpu, 6);
  report("plain CPU seconds", plain_cpu, 6);
  report("package wall seconds", package_wall, 6);
  report("plain wall seconds", plain_wall, 6);
  report("CPU ratio", plain_cpu / package_cpu, 3);
  report("wall ratio", plain_wall / package_wall, 3);
}

// Runs the package and plain CGAL alternately, beginning now with one, now with the other. Prints
// the medians and returns whether plain CGAL's triangulation equals `result`.
template <class Traits>
bool compare_with_plain(const Surface& surface, const Traits& traits, unsigned int seed,
                        unsigned int repetitions, const Triangulation& result, Report& report,
                        Messages& messages)
{
  report.title("Comparison with CGAL's own insert(first, last)"
               "\n(medians; ratio = plain CGAL / package, above 1 the package is faster)");
  Timings package, plain;
  bool is_equal = true;
  for (unsigned int r = 0; r < repetitions; ++r) {
    messages.step("comparing: repetition " + std::to_string(r + 1) + " of " +
                  std::to_string(repetitions));
    if (r % 2 == 0)
      package.add(time_package(surface, traits, seed));
    {
      Triangulation tr;
      plain.add(time_plain(surface, tr));
      if (r + 1 == repetitions)
        is_equal = result == tr;
    }
    if (r % 2 == 1)
      package.add(time_package(surface, traits, seed));
  }
  messages.clear();
  report_timings(report, package, plain);
  report("equal", is_equal ? "yes" : "no");
  return is_equal;
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_COMPARE_WITH_PLAIN_H
