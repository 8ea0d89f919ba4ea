// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_FILES_PARSE_NUMBER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_FILES_PARSE_NUMBER_H

#include <Delaunay_from_surface_3_files/Polygon_soup.h>
#include <Delaunay_from_surface_3_files/one_line.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>

namespace files {

constexpr std::size_t no_index = std::size_t(-1);

// For messages: what a file holds may be long, and a zero byte would end them.
inline std::string excerpt(std::string_view word)
{
  return "'" + one_line(std::string(word.substr(0, 30))) + (word.size() > 30 ? "…'" : "'");
}

// The next word of `text`, which is cut off there; empty at the end.
inline std::string_view next_word(std::string_view& text)
{
  static const char* const blanks = " \t\r\n\v\f";
  text.remove_prefix((std::min)(text.find_first_not_of(blanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}

// A word as a whole number that is not negative and not above `largest`.
inline std::size_t parse_count(std::string_view word, std::size_t largest, const std::string& what)
{
  std::uint64_t value = 0;
  const char* const end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, value);
  if (rest != end || error == std::errc::invalid_argument)
    throw Bad_content(excerpt(word) + " is not the number of " + what);
  if (error != std::errc() || value > largest)
    throw Bad_content("there is no room for " + excerpt(word) + " " + what + " in the file");
  return std::size_t(value);
}

// A word as the index of a vertex; what is none becomes one that no vertex has.
inline std::size_t parse_index(std::string_view word)
{
  std::uint64_t value = 0;
  const char* const end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, value);
  return rest == end && error == std::errc() ? std::size_t(value) : no_index;
}

// A word as a coordinate. One that is too large for a double becomes infinite, as in `strtod()`.
inline double parse_coordinate(std::string_view word)
{
  double value = 0;
  std::string_view digits = word;
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-')
    digits.remove_prefix(1);
  const char* const end = digits.data() + digits.size();
  const auto [rest, error] = std::from_chars(digits.data(), end, value);
  if (rest != end || error == std::errc::invalid_argument)
    throw Bad_content(excerpt(word) + " is not a number" +
                      (word.find_first_of(",;") == word.npos
                           ? ""
                           : ": blanks separate numbers, and a point their decimals"));
  return error == std::errc() ? value : std::strtod(std::string(digits).c_str(), nullptr);
}

} // namespace files

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_FILES_PARSE_NUMBER_H
