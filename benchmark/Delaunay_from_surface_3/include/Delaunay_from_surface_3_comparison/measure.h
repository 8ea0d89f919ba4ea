// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_MEASURE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_MEASURE_H

// Times and medians.

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <vector>

namespace comparison {

using Json = nlohmann::ordered_json;

inline double rounded(double x, double per_unit = 1e6)
{
  return std::round(x * per_unit) / per_unit;
}

inline double median(std::vector<double> values)
{
  const std::size_t half = values.size() / 2;
  std::sort(values.begin(), values.end());
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

struct Steady_seconds
{
  double operator()() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
  }
};

// CPU time of the process.
inline double cpu_seconds()
{
  return double(std::clock()) / CLOCKS_PER_SEC;
}

struct Time
{
  double cpu, wall; // of the process, and on the clock; seconds
};

template <class Work>
Time time_of(const Work& work)
{
  const double wall = Steady_seconds()();
  const double cpu = cpu_seconds();
  work();
  return {cpu_seconds() - cpu, Steady_seconds()() - wall};
}

// {"median_NAME": …, "NAME": […]}, in microseconds' precision.
inline Json with_median(const std::string& name, std::vector<double> values)
{
  for (double& value : values)
    value = rounded(value);
  return {{"median_" + name, median(values)}, {name, values}};
}

} // namespace comparison

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_MEASURE_H
