// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_RUN_PROGRAM_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_RUN_PROGRAM_H

// What programs that measure have in common: options, report, JSON, failure. And what those do that
// measure what kinds of users gain.

#include <Delaunay_from_surface_3_comparison/measure.h>

#include <boost/program_options.hpp>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace comparison {

template <class T>
struct Is_list : std::false_type
{
};
template <class T>
struct Is_list<std::vector<T>> : std::true_type
{
};

// The options of a program, --help and --output among them, and its report, which goes into the file
// that --output names: by default that of the program without "measure_".
class Program
{
public:
  Program(std::string name, const std::string& purpose)
    : m_name(std::move(name))
    , m_output(m_name.substr(m_name.find("measure_") == 0 ? 8 : 0) + ".json")
    , m_options(purpose + "\n\nOptions")
  {
    m_options.add_options()("help,h", "say this and stop");
  }

  // Sets `value` to what the option gives, or, if it is a vector, to the list of them. What it is before
  // is the default.
  template <class T>
  auto* option(const char* name, T& value, const char* value_name, const char* meaning)
  {
    auto* const semantic = boost::program_options::value(&value)->value_name(value_name);
    if constexpr (Is_list<T>::value)
      semantic->multitoken();
    else if (value != T())
      semantic->default_value(value);
    m_options.add_options()(name, semantic, meaning);
    return semantic;
  }
  void option(const char* name, bool& value, const char* meaning)
  {
    m_options.add_options()(name, boost::program_options::bool_switch(&value), meaning);
  }

  // Reads the options, of which a stray word is none. With --help the program prints them and ends.
  Json begin(int argc, char** argv)
  {
    namespace po = boost::program_options;
    option("output,o", m_output, "FILE", "where the JSON goes");
    po::variables_map given;
    po::store(po::command_line_parser(argc, argv).options(m_options).positional({}).run(), given);
    po::notify(given);
    if (given.count("help") != 0) {
      std::cout << m_options;
      std::exit(EXIT_SUCCESS);
    }
    return begin_report(m_name, argc, argv, DELAUNAY_FROM_SURFACE_3_COMPILER_FLAGS);
  }

  // Can be called again when there is more, so that what is there is kept should the rest be interrupted.
  void write(const Json& report) const { write_report(m_output, report); }

  // The whole program; measure(report) adds to the report. Returns the exit status.
  template <class Measure>
  int run(int argc, char** argv, const Measure& measure)
  try {
    Json report = begin(argc, argv);
    measure(report);
    write(report);
    return EXIT_SUCCESS;
  } catch (const std::exception& e) {
    std::cerr << m_name << ": " << e.what() << "\n";
    return EXIT_FAILURE;
  }

private:
  std::string m_name, m_output;
  boost::program_options::options_description m_options;
};

// CPU times of work with plain CGAL and with the package, in turn.
struct Turns
{
  std::vector<double> plain, ours, ratios;

  template <class Plain, class Ours>
  void add(const Plain& plain_work, const Ours& our_work)
  {
    plain.push_back(time_of(plain_work).cpu);
    ours.push_back(time_of(our_work).cpu);
    ratios.push_back(plain.back() / ours.back());
  }
  // Adds the medians to a line; `name` is what the package is called there.
  void add_to(Json& line, const std::string& name) const
  {
    line["median_plain_cpu"] = rounded(median(plain));
    line["median_" + name + "_cpu"] = rounded(median(ours));
    line["median_ratio"] = rounded(median(ratios), 1e3);
  }
};

// A line of JSON for each kind of such work.
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
    Turns turns;
    for (std::size_t r = 0; r < m_repetitions; ++r) {
      decltype(plain()) expected, found;
      turns.add([&] { expected = plain(); }, [&] { found = ours(); });
      see(line, expected, found);
    }
    turns.add_to(line, "ours");
    add(line);
  }
  // Both return something that must be equal.
  template <class Plain, class Ours>
  void line(const std::string& consumer, std::size_t n, const Plain& plain, const Ours& ours)
  {
    line(consumer, n, plain, ours, [&](const Json&, const auto& expected, const auto& found) {
      if (expected != found)
        throw std::runtime_error(consumer + ": not equal to plain CGAL");
    });
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

// The whole program, with measure(n, gains). Returns the exit status.
template <class Measure>
int run_gains(Program& program, int argc, char** argv, const Measure& measure)
{
  std::size_t n = 200000, repetitions = 5;
  program.option("points,n", n, "N", "number of points");
  program.option("repetitions,r", repetitions, "N", "of each, in turn");
  return program.run(argc, argv, [&](Json& report) {
    report["repetitions"] = repetitions;
    Gains gains(repetitions);
    measure(n, gains);
    report["results"] = gains.lines();
  });
}

} // namespace comparison

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_RUN_PROGRAM_H
