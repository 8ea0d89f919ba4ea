// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_GAINS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_GAINS_H

// What a program does that measures what kinds of users gain: work with plain CGAL and with the
// package in turn, a line of JSON for each kind.

#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_comparison/read_command_line.h>
#include <Delaunay_from_surface_3_comparison/write_measured.h>

#include <boost/program_options.hpp>

#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

namespace comparison {

class Gains
{
public:
  explicit Gains(std::size_t repetitions)
    : m_repetitions(repetitions)
  {
  }

  // see(line, expected, found) is given what plain() and ours() have returned, and may add to the
  // line.
  template <class Plain, class Ours, class See>
  void line(const std::string& consumer, std::size_t n, const Plain& plain, const Ours& ours,
            const See& see)
  {
    Json line = {{"consumer", consumer}, {"points", n}};
    std::vector<double> plain_cpu, ours_cpu, ratios;
    for (std::size_t r = 0; r < m_repetitions; ++r) {
      decltype(plain()) expected, found;
      plain_cpu.push_back(time_of([&] { expected = plain(); }).cpu);
      ours_cpu.push_back(time_of([&] { found = ours(); }).cpu);
      ratios.push_back(plain_cpu.back() / ours_cpu.back());
      see(line, expected, found);
    }
    line["median_plain_cpu"] = rounded(median(plain_cpu));
    line["median_ours_cpu"] = rounded(median(ours_cpu));
    line["median_ratio"] = rounded(median(ratios), 1e3);
    add(line);
  }

  void add(const Json& line)
  {
    std::cerr << line.dump() << "\n";
    m_lines.push_back(line);
  }

  // A line that says why there are no figures.
  void skip(const std::string& consumer, const std::string& why)
  {
    m_lines.push_back({{"consumer", consumer}, {"skipped", why}});
    std::cerr << "skipped: " << consumer << ", as " << why << "\n";
  }

  const Json& lines() const { return m_lines; }
  std::size_t repetitions() const { return m_repetitions; }

private:
  std::size_t m_repetitions;
  Json m_lines = Json::array();
};

// The whole program: its options, with its own among them, measure(n, gains), its JSON. Returns the
// exit status.
template <class Measure>
int write_gains(const std::string& program, const std::string& purpose, int argc, char** argv,
                const Measure& measure,
                const boost::program_options::options_description& own_options = {})
{
  struct Options
  {
    std::size_t n = 200000, repetitions = 5;
    std::string output;
  };
  const auto read_options = [&](int count, char** words) {
    namespace po = boost::program_options;
    Options o;
    o.output = program.substr(program.find('_') + 1) + ".json";
    po::options_description options(purpose + "\n\nOptions");
    auto add = options.add_options();
    add("help,h", "say this and stop");
    add("points,n", po::value(&o.n)->value_name("N"), "number of points");
    add("repetitions,r", po::value(&o.repetitions)->value_name("N"), "of each, in turn");
    add("output,o", po::value(&o.output)->value_name("FILE"), "where the JSON goes");
    options.add(own_options);
    read_command_line(count, words, options);
    return o;
  };
  return write_measured(program, argc, argv, read_options, [&](const Options& o, Json& report) {
    report["repetitions"] = o.repetitions;
    Gains gains(o.repetitions);
    measure(o.n, gains);
    report["results"] = gains.lines();
  });
}

} // namespace comparison

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_GAINS_H
