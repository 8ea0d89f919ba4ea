// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_REPORT_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_REPORT_H

#include <Delaunay_from_surface_3_files/one_line.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <limits>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

// Returns a number in [lowest, highest]; Boost alone would take -1 for 4294967295.
inline unsigned int checked_number(const std::string& option, long long value, long long lowest,
                                   long long highest = (std::numeric_limits<unsigned int>::max)())
{
  if (value < lowest || value > highest)
    throw std::runtime_error("option '--" + option + "' needs a whole number from " +
                             std::to_string(lowest) + " to " + std::to_string(highest));
  return static_cast<unsigned int>(value);
}

// More threads would not insert, and TBB does not bear any number.
constexpr long long most_threads = 64;

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

#if defined(_WIN32)
#include <io.h>
#else
#include <unistd.h>
#endif

inline bool standard_error_is_terminal()
{
#if defined(_WIN32)
  return _isatty(_fileno(stderr)) != 0;
#else
  return isatty(STDERR_FILENO) != 0;
#endif
}

// Writes messages beside the results to the standard error: notes, and the work that is being done.
// The latter is a line that is overwritten again and again on a terminal, and separate lines with
// --verbose.
class Messages
{
public:
  enum class Volume { QUIET, NORMAL, VERBOSE };

  explicit Messages(Volume volume)
    : m_volume(volume)
  {
  }
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;
  ~Messages() { clear(); }

  // Notes something odd that is no error.
  void note(const std::string& text)
  {
    clear();
    if (m_volume != Volume::QUIET)
      std::cerr << "note: " << files::one_line(text) << '\n';
  }

  // Warns that the result may not be as wanted, even with --quiet.
  void warn(const std::string& text)
  {
    clear();
    std::cerr << "warning: " << files::one_line(text) << '\n';
  }

  // Says that something begins that may take a while.
  void step(const std::string& text)
  {
    show(text);
    if (m_volume == Volume::VERBOSE)
      std::cerr << files::one_line(text) << '\n';
  }

  // Shows how far the work is.
  void show(const std::string& text)
  {
    if (!m_has_line)
      return;
    std::cerr << "\r\033[K" << files::one_line(text) << std::flush;
    m_is_empty = false;
  }

  // Clears the line. To be called before anything else is printed.
  void clear()
  {
    if (!m_is_empty)
      std::cerr << "\r\033[K" << std::flush;
    m_is_empty = true;
  }

private:
  const Volume m_volume;
  const bool m_has_line = m_volume == Volume::NORMAL && standard_error_is_terminal();
  bool m_is_empty = true;
};

inline std::string decimals(double value, int digits)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

// Returns a text such as "12 of 2000 (0.6000 %)".
inline std::string fraction(std::size_t part, std::size_t whole)
{
  const double percent = whole == 0 ? 0. : 100. * double(part) / double(whole);
  return std::to_string(part) + " of " + std::to_string(whole) + " (" + decimals(percent, 4) +
         " %)";
}

// Returns text in quotes; bytes above 127 are passed on.
inline std::string json_string(const std::string& text)
{
  std::ostringstream quoted;
  quoted << '"';
  for (const char c : text) {
    if (c == '"' || c == '\\')
      quoted << '\\' << c;
    else if ((unsigned char)(c) < 32)
      quoted << "\\u" << std::hex << std::setw(4) << std::setfill('0') << int(c);
    else
      quoted << c;
  }
  quoted << '"';
  return quoted.str();
}

// Returns a key of JSON, in which blanks are replaced.
inline std::string json_key(std::string text)
{
  std::replace(text.begin(), text.end(), ' ', '_');
  return json_string(text);
}

// Prints results: as lines "key: value" and tables, as one JSON object, or not at all.
class Report
{
public:
  enum class Style { TEXT, JSON, NONE };

  Report(std::ostream& out, Style style)
    : m_out(out)
    , m_style(style)
  {
  }

  // Prints a line between groups of results, but not in JSON.
  void title(const std::string& text)
  {
    if (m_style == Style::TEXT)
      m_out << '\n' << text << '\n';
  }

  // All keys must be shorter than the column is wide.
  void operator()(const std::string& key, const std::string& value)
  {
    add(key, value, json_string(value));
  }
  void operator()(const std::string& key, const char* value) { (*this)(key, std::string(value)); }
  template <class Number, class = std::enable_if_t<std::is_integral<Number>::value>>
  void operator()(const std::string& key, Number value)
  {
    add(key, std::to_string(value), std::to_string(value));
  }

  // Adds a number with so many decimals; JSON has no infinite ones.
  void operator()(const std::string& key, double value, int digits)
  {
    add(key, decimals(value, digits), std::isfinite(value) ? decimals(value, digits) : "null");
  }

  // Adds a number with nine significant digits.
  void operator()(const std::string& key, double value)
  {
    std::ostringstream digits;
    digits << std::setprecision(9) << value;
    add(key, digits.str(), std::isfinite(value) ? digits.str() : "null");
  }

  // Adds a table of numbers and words; the first `words` columns are words.
  void table(const std::string& key, const std::vector<std::string>& columns, std::size_t words,
             const std::vector<std::vector<std::string>>& rows)
  {
    if (m_style == Style::TEXT) {
      print_row(columns, words);
      for (const auto& row : rows)
        print_row(row, words);
    }
    std::string json;
    for (const auto& row : rows) {
      json += json.empty() ? "[" : ", ";
      for (std::size_t k = 0; k < columns.size(); ++k)
        json += (k == 0 ? "{" : ", ") + json_key(columns[k]) + ": " +
                (k < words       ? json_string(row[k])
                 : row[k] == "-" ? "null"
                                 : row[k]);
      json += "}";
    }
    m_json += (m_json.empty() ? "" : ",\n") + ("  " + json_key(key)) + ": " +
              (json.empty() ? "[" : json) + "]";
  }

  // To be called when all results are known.
  void finish()
  {
    if (m_style == Style::JSON)
      m_out << "{\n" << m_json << "\n}\n";
  }

private:
  void add(const std::string& key, const std::string& text, const std::string& json)
  {
    if (m_style == Style::TEXT)
      m_out << std::left << std::setw(24) << key + ':' << text << '\n';
    m_json += (m_json.empty() ? "" : ",\n") + ("  " + json_key(key)) + ": " + json;
  }

  void print_row(const std::vector<std::string>& row, std::size_t words)
  {
    for (std::size_t k = 0; k < row.size(); ++k)
      m_out << (k < words ? std::left : std::right) << std::setw(k < words ? 8 : 12) << row[k];
    m_out << '\n';
  }

  std::ostream& m_out;
  const Style m_style;
  std::string m_json;
};

// The options of all programs that say what is printed.
struct Printing
{
  bool json = false, quiet = false, verbose = false;

  void add_to(boost::program_options::options_description& all)
  {
    using boost::program_options::bool_switch;
    all.add_options()("json", bool_switch(&json))("quiet", bool_switch(&quiet))(
        "verbose", bool_switch(&verbose));
  }

  Report::Style style() const
  {
    return json ? Report::Style::JSON : quiet ? Report::Style::NONE : Report::Style::TEXT;
  }

  Messages::Volume volume() const
  {
    return quiet     ? Messages::Volume::QUIET
           : verbose ? Messages::Volume::VERBOSE
                     : Messages::Volume::NORMAL;
  }
};

// Reads a command line with at most so many inputs, or any number of them if that is -1.
inline boost::program_options::variables_map
read_command_line(int argc, char* argv[], const boost::program_options::options_description& all,
                  int most_inputs)
{
  namespace po = boost::program_options;
  const auto positional = po::positional_options_description().add("input", most_inputs);
  const int style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
  po::variables_map given;
  po::store(
      po::command_line_parser(argc, argv).options(all).positional(positional).style(style).run(),
      given);
  return given;
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_REPORT_H
