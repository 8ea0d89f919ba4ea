// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_POINTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_POINTS_H

#include <Delaunay_from_surface_3_files/Lines.h>
#include <Delaunay_from_surface_3_files/Polygon_soup.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string_view>

namespace files {

inline bool begins_with_number(std::string_view line)
{
  try {
    parse_coordinate(next_word(line));
  } catch (const Bad_content&) {
    return false;
  }
  return true;
}

// Whether this is a molecule, as chemistry writes .xyz: a line with the number of atoms, one with a
// comment, and then in each an element, or its number, and three numbers.
inline bool is_molecule(std::string_view text)
{
  std::string_view lines[3];
  for (std::string_view& line : lines) {
    const std::size_t end = text.find('\n');
    line = text.substr(0, end);
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
  }
  const std::size_t number = parse_index(next_word(lines[0]));
  const std::string_view element = next_word(lines[2]);
  const std::size_t of_atom = parse_index(element);
  const bool has_name = !element.empty() && element.size() <= 3 &&
                        std::isalpha(static_cast<unsigned char>(element[0])) != 0;
  // A point behind a blank line or a comment has no whole number for its x and three more behind it.
  const bool has_number = of_atom >= 1 && of_atom <= 118 && !begins_with_number(lines[1]);
  const bool is_element = has_name || has_number;
  if (number == no_index || !next_word(lines[0]).empty() || !is_element)
    return false;
  try {
    for (int k = 0; k < 3; ++k)
      parse_coordinate(next_word(lines[2]));
  } catch (const Bad_content&) {
    return false;
  }
  return true;
}

// Whether a line names columns: CloudCompare's begins with "//", others are "x y z …".
inline bool is_line_of_names(std::string_view line)
{
  const std::string_view first = next_word(line);
  const auto is = [](std::string_view word, char lower) {
    return word.size() == 1 && (word[0] == lower || word[0] == lower - 'a' + 'A');
  };
  if (first.substr(0, 2) == "//")
    return true;
  const std::string_view second = next_word(line), third = next_word(line);
  return is(first, 'x') && is(second, 'y') && is(third, 'z');
}

// Reads .xyz and .pts: a point in each line, three numbers. What stands behind them, normals,
// intensities or colors, is passed over, and so are names of columns. A line with one word alone is the
// number of points that follow, which Leica's .pts has; it is not believed, but kept.
inline Polygon_soup read_points(std::string_view text)
{
  if (is_molecule(text))
    throw Bad_content("it is a molecule, with an element in each line; remedy: leave out the first "
                      "two lines and the first column: tail -n +3 FILE | awk '{print $2, $3, $4}' "
                      "| delaunay_from_surface - --from xyz");
  Polygon_soup soup;
  Lines lines(text);
  try {
    while (lines.next()) {
      std::string_view line = lines.line();
      if (is_line_of_names(line))
        continue;
      const std::string_view first = next_word(line);
      const std::size_t number = next_word(line).empty() ? parse_index(first) : no_index;
      if (number != no_index) {
        soup.announced_points += (std::min)(number, no_index - soup.announced_points);
        continue;
      }
      const auto x = read_coordinates(lines);
      soup.points.emplace_back(x[0], x[1], x[2]);
    }
  } catch (const Bad_content& error) {
    throw Bad_content(lines.place() + error.what());
  }
  return soup;
}

} // namespace files

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_POINTS_H
