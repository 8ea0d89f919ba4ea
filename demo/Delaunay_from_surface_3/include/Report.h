// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_REPORT_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_REPORT_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

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

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_REPORT_H
