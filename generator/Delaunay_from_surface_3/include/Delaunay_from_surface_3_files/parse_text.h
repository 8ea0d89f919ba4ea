// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_FILES_PARSE_TEXT_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_FILES_PARSE_TEXT_H

#include <Delaunay_from_surface_3_files/one_line.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

// What the readers share: what they read, and the numbers and lines of texts.

/// Reading and writing of files that may be damaged, hostile, or on a full disk.
namespace files {

// What a file with a surface holds, in its order.
struct Polygon_soup
{
  std::vector<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  std::vector<double> weights;         // of all points, or empty if they were not asked for
  std::size_t collapsed_triangles = 0; // of .stl, which are left out
  std::size_t announced_points = 0;    // by .xyz and .pts; there may be fewer
  bool has_more = false;               // in the file than its header announces
};

// What is wrong with the content of a file; who catches it adds the name.
class Bad_content : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

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

// Where the line at `begin` ends: at a line feed or a carriage return.
inline std::size_t end_of_line(std::string_view text, std::size_t begin = 0)
{
  while (begin < text.size() && text[begin] != '\n' && text[begin] != '\r')
    ++begin;
  return begin;
}

// Where the next line begins. Both together end one line; a text that was converted for Windows twice
// has two carriage returns.
inline std::size_t behind_end_of_line(std::string_view text, std::size_t end)
{
  for (const std::string_view both : {"\r\n", "\r\r\n"})
    if (text.substr(end, both.size()) == both)
      return end + both.size();
  return (std::min)(end + 1, text.size());
}

// Takes a line off a text.
inline std::string_view take_line(std::string_view& text)
{
  const std::size_t end = end_of_line(text);
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(behind_end_of_line(text, end));
  return line;
}

// The lines of a text that hold more than blanks and a comment, which begins with '#'.
class Lines
{
public:
  // Whether a line without a comment goes on in the next one if a backslash ends it.
  enum class Backslash { IS_NOTHING, CONTINUES };

  explicit Lines(std::string_view text, Backslash backslash = Backslash::IS_NOTHING)
    : m_rest(text)
    , m_backslash(backslash)
  {
    if (m_rest.substr(0, 3) == "\xEF\xBB\xBF") // some editors put this before a text in UTF-8
      m_rest.remove_prefix(3);
    if (m_rest.substr(0, 2) == "\xFF\xFE" || m_rest.substr(0, 2) == "\xFE\xFF")
      throw Bad_content("it is in UTF-16, and only text in UTF-8 or ASCII is read");
  }

  // Goes to the next such line; returns whether there is one.
  bool next()
  {
    std::string_view content;
    do {
      if (m_rest.empty())
        return false;
      m_number = ++m_passed;
      std::size_t end = end_of_line(m_rest);
      for (std::size_t begin = 0; goes_on(begin, end); end = end_of_line(m_rest, begin)) {
        begin = behind_end_of_line(m_rest, end);
        ++m_passed;
      }
      m_line = m_rest.substr(0, end);
      m_rest.remove_prefix(behind_end_of_line(m_rest, end));
      m_line = m_line.substr(0, m_line.find('#'));
      content = m_line;
    } while (next_word(content).empty());
    return true;
  }

  // The next word of the line; empty at its end.
  std::string_view word()
  {
    std::string_view word = next_word(m_line);
    while (is_joint(word)) {
      word.remove_suffix(1);
      if (!word.empty())
        break;
      word = next_word(m_line);
    }
    return word;
  }

  // What is left of the line, and of the text behind it.
  std::string_view line() const { return m_line; }
  std::string_view rest() const { return m_rest; }

  // For messages: where the line begins.
  std::string place() const { return "line " + std::to_string(m_number) + ": "; }

private:
  bool goes_on(std::size_t begin, std::size_t end) const
  {
    if (m_backslash != Backslash::CONTINUES || end == m_rest.size())
      return false;
    const std::string_view line = m_rest.substr(begin, end - begin);
    return !line.empty() && line.back() == '\\' && line.find('#') == line.npos;
  }

  // Does the word just read end with a backslash, and a line or the text behind that?
  bool is_joint(std::string_view word) const
  {
    if (m_backslash != Backslash::CONTINUES || word.empty() || word.back() != '\\')
      return false;
    return end_of_line(m_line) == 0;
  }

  std::string_view m_rest, m_line;
  Backslash m_backslash;
  std::size_t m_number = 0, m_passed = 0; // where the line begins, and ends
};

// The coordinates of a vertex that the line goes on with; the fourth, a divisor, if they are homogeneous.
inline std::array<double, 4> read_coordinates(Lines& lines, bool are_homogeneous = false)
{
  std::array<double, 4> x = {0, 0, 0, 1};
  for (std::size_t i = 0; i < (are_homogeneous ? 4u : 3u); ++i) {
    const std::string_view word = lines.word();
    if (word.empty())
      throw Bad_content("a vertex has too few coordinates");
    x[i] = parse_coordinate(word);
  }
  return x;
}

} // namespace files

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_FILES_PARSE_TEXT_H
