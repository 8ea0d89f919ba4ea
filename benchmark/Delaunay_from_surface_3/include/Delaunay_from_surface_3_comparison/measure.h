// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_MEASURE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_MEASURE_H

// Times and medians, and what must be known of a machine and a build to judge times measured there.

#include <CGAL/Delaunay_from_surface_3/Insertion_counts.h>
#include <CGAL/version.h>

#include <boost/config.hpp>
#include <boost/version.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace comparison {

using Json = nlohmann::ordered_json;

inline double rounded(double x, double per_unit = 1e6)
{
  return std::round(x * per_unit) / per_unit;
}

// The share of one of n.
template <class Count, class Number>
double per_point(Count count, Number n, double per_unit = 1e4)
{
  return rounded(double(count) / double(n), per_unit);
}

// How many of n tests each of the package's exact stages decided, which come in their order.
template <class Decided>
Json by_exact_stage(const Decided& decided, std::size_t n, double per_unit = 1e4)
{
  static const char* const names[] = {"lattice",       "half_digit", "one_digit", "balanced",
                                      "double_double", "two_digits", "any_width"};
  static_assert(std::size(names) == CGAL::Delaunay_from_surface_3::NUMBER_OF_EXACT_STAGES,
                "each stage has a name");
  Json result;
  for (std::size_t stage = 0; stage < std::size(names); ++stage)
    result[names[stage]] = per_point(decided[stage], n, per_unit);
  return result;
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

// The value of the first line "key : value" of a file such as /proc/cpuinfo; "unknown" without.
inline std::string value_in_file(const std::string& file_name, const std::string& key)
{
  std::ifstream file(file_name);
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(':');
    if (line.compare(0, key.size(), key) == 0 && colon != std::string::npos) {
      const std::size_t first = line.find_first_not_of(" \t", colon + 1);
      return first == std::string::npos ? "" : line.substr(first);
    }
  }
  return "unknown";
}

inline std::string date_today()
{
  const std::time_t now = std::time(nullptr);
  char text[16] = {};
  std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
  return text;
}

// Processes that want to run, averaged over the last minute; negative where it cannot be told.
inline double load_average()
{
  double load = -1;
  return getloadavg(&load, 1) == 1 ? load : -1;
}

// As a shell would take it, but for the folder of the program.
inline std::string command_line(const std::string& program, int argc, char** argv)
{
  std::string text = program;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    text += word.find(' ') == std::string::npos ? " " + word : " '" + word + "'";
  }
  return text;
}

inline nlohmann::ordered_json describe_machine(const std::string& compiler_flags)
{
  return {{"cpu", value_in_file("/proc/cpuinfo", "model name")},
          {"cpu_cache", value_in_file("/proc/cpuinfo", "cache size")},
          {"cores", std::thread::hardware_concurrency()},
          {"memory", value_in_file("/proc/meminfo", "MemTotal")},
          {"compiler", BOOST_COMPILER},
          {"flags", compiler_flags},
          {"cgal", CGAL_VERSION_STR},
          {"boost", BOOST_LIB_VERSION},
          {"date", date_today()}};
}

// What the report of a program begins with: its name, machine, load and command line.
inline nlohmann::ordered_json begin_report(const std::string& program, int argc, char** argv,
                                           const std::string& compiler_flags)
{
  nlohmann::ordered_json report = {{"program", program},
                                   {"machine", describe_machine(compiler_flags)},
                                   {"command", command_line(program, argc, argv)}};
  report["machine"]["load_before"] = load_average();
  return report;
}

// One line for each value, and a message where it cannot be written.
inline void write_report(const std::string& file_name, const nlohmann::ordered_json& report)
{
  std::ofstream file(file_name);
  file << std::setw(1) << report << '\n';
  if (!file.flush())
    throw std::runtime_error("cannot write " + file_name);
}

} // namespace comparison

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_MEASURE_H
