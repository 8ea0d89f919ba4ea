// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_POINTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_POINTS_H

#include <Delaunay_from_surface_3_files/Lines.h>
#include <Delaunay_from_surface_3_files/Polygon_soup.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace files {

// Reads the first words of a line, `most` at most, as numbers. Returns how many there are, or 0 if one is
// not a number.
inline std::size_t read_numbers(std::string_view line, double* numbers, std::size_t most)
{
  std::size_t k = 0;
  try {
    for (std::string_view word; k < most && !(word = next_word(line)).empty(); ++k)
      numbers[k] = parse_coordinate(word);
  } catch (const Bad_content&) {
    return 0;
  }
  return k;
}

// Takes a line off a text.
inline std::string_view take_line(std::string_view& text)
{
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == text.npos ? text.size() : end + 1);
  return line;
}

// Returns whether each of so many lines holds the number of an element and three coordinates, not all of
// which are whole: on a lattice, the fourth number may be an intensity.
inline bool are_numbered_atoms(std::string_view text, std::size_t number)
{
  bool are_whole = true;
  for (std::size_t i = 0; i < number; ++i) {
    double x[5];
    if (text.empty() || read_numbers(take_line(text), x, 5) != 4 || !(x[0] >= 1 && x[0] <= 118) ||
        x[0] != std::floor(x[0]))
      return false;
    for (const double y : {x[1], x[2], x[3]})
      are_whole = are_whole && y == std::floor(y);
  }
  return !are_whole;
}

// Returns whether this is a molecule, as chemistry writes .xyz: a line with the number of atoms, one with
// a comment, and then in each an element, or its number, and three numbers.
inline bool is_molecule(std::string_view text)
{
  std::string_view first = take_line(text);
  const std::string_view comment = take_line(text);
  const std::size_t number = parse_index(next_word(first));
  if (number == no_index || number == 0 || !next_word(first).empty())
    return false;
  double x[3];
  if (read_numbers(comment, x, 1) == 0 && are_numbered_atoms(text, number))
    return true;
  std::string_view atom = take_line(text);
  const std::string_view element = next_word(atom);
  return !element.empty() && element.size() <= 3 &&
         std::isalpha(static_cast<unsigned char>(element[0])) != 0 && read_numbers(atom, x, 3) == 3;
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
