// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_FILES_LINES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_FILES_LINES_H

#include <Delaunay_from_surface_3_files/parse_number.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace files {

// The lines of a text that hold more than blanks and a comment, which begins with '#'. They end
// with a line feed or, in a text without any, with a carriage return.
class Lines
{
public:
  // Whether a line without a comment goes on in the next one if a backslash ends it.
  enum class Backslash { IS_NOTHING, CONTINUES };

  explicit Lines(std::string_view text, Backslash backslash = Backslash::IS_NOTHING)
    : m_rest(text)
    , m_end(text.find('\n') == text.npos ? '\r' : '\n')
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
      std::size_t end = end_of_line(0);
      for (std::size_t begin = 0; goes_on(begin, end); end = end_of_line(begin)) {
        begin = end + 1;
        ++m_passed;
      }
      m_line = m_rest.substr(0, end);
      m_rest.remove_prefix((std::min)(m_line.size() + 1, m_rest.size()));
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
  std::size_t end_of_line(std::size_t begin) const
  {
    return (std::min)(m_rest.find(m_end, begin), m_rest.size());
  }

  bool goes_on(std::size_t begin, std::size_t end) const
  {
    if (m_backslash != Backslash::CONTINUES || end == m_rest.size())
      return false;
    const std::string_view line = m_rest.substr(begin, end - begin);
    const std::size_t last = line.find_last_not_of('\r');
    return last != line.npos && line[last] == '\\' && line.find('#') == line.npos;
  }

  // Does the word just read end with a backslash, and a line or the text behind that?
  bool is_joint(std::string_view word) const
  {
    if (m_backslash != Backslash::CONTINUES || word.empty() || word.back() != '\\')
      return false;
    const std::size_t next = m_line.find_first_not_of('\r');
    return next == m_line.npos || m_line[next] == m_end;
  }

  std::string_view m_rest, m_line;
  char m_end;
  Backslash m_backslash;
  std::size_t m_number = 0, m_passed = 0; // where the line begins, and ends
};

// The three coordinates of a vertex that the line goes on with.
inline std::array<double, 3> read_coordinates(Lines& lines)
{
  std::array<double, 3> x;
  for (double& coordinate : x) {
    const std::string_view word = lines.word();
    if (word.empty())
      throw Bad_content("a vertex has too few coordinates");
    coordinate = parse_coordinate(word);
  }
  return x;
}

} // namespace files

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_FILES_LINES_H
