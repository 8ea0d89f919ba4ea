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

// The lines of a text that hold more than blanks and a comment, which begins with '#'.
class Lines
{
public:
  explicit Lines(std::string_view text)
    : m_rest(text)
  {
    if (m_rest.substr(0, 3) == "\xEF\xBB\xBF") // some editors put this before a text in UTF-8
      m_rest.remove_prefix(3);
  }

  // Goes to the next such line; returns whether there is one.
  bool next()
  {
    std::string_view content;
    do {
      if (m_rest.empty())
        return false;
      m_line = m_rest.substr(0, m_rest.find('\n'));
      m_rest.remove_prefix((std::min)(m_line.size() + 1, m_rest.size()));
      ++m_number;
      m_line = m_line.substr(0, m_line.find('#'));
      content = m_line;
    } while (next_word(content).empty());
    return true;
  }

  // The next word of the line; empty at its end.
  std::string_view word() { return next_word(m_line); }

  // What is left of the line, and of the text behind it.
  std::string_view line() const { return m_line; }
  std::string_view rest() const { return m_rest; }

  // For messages.
  std::string place() const { return "line " + std::to_string(m_number) + ": "; }

private:
  std::string_view m_rest, m_line;
  std::size_t m_number = 0;
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
