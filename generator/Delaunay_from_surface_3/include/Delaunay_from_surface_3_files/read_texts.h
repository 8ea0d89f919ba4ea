// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_TEXTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_TEXTS_H

#include <Delaunay_from_surface_3_files/parse_text.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace files {

// Reads text in the format OFF: Geomview's, a line for each vertex and each face. Colors, normals
// and textures are passed over. The vertices of a face may go on in the next lines, and the keyword
// may have no blank behind it, as in files of ModelNet. CGAL's reader believes the numbers that it
// finds: it makes room for as many vertices as the header and for as many corners as a face claims,
// and looks up colors where a line has none.
class Off_reader
{
public:
  explicit Off_reader(std::string_view text)
    : m_lines(text)
  {
  }

  Polygon_soup read()
  try {
    const std::size_t room = m_lines.rest().size() / 2; // a number and a separator
    next_line();
    read_keyword(m_lines.word());
    const std::size_t vertices = parse_count(word_of_header(), room / 3 + 1, "vertices");
    const std::size_t faces = parse_count(word_of_header(), room + 1, "faces");
    Polygon_soup soup;
    soup.points.reserve(vertices);
    for (std::size_t i = 0; i < vertices; ++i)
      read_vertex(soup);
    soup.faces.reserve(faces);
    for (std::size_t i = 0; i < faces; ++i)
      read_face(soup);
    soup.has_more = m_lines.next();
    return soup;
  } catch (const Bad_content& error) {
    throw Bad_content(m_first_break.empty()
                          ? m_lines.place() + error.what()
                          : m_first_break + "a face has too few vertices, also with what follows");
  }

private:
  void next_line()
  {
    if (!m_lines.next())
      throw Bad_content("the file ends too early");
  }

  // [ST][C][N][4][n]OFF, where 4 stands for homogeneous coordinates.
  void read_keyword(std::string_view keyword)
  {
    const auto skip = [&](std::string_view prefix) {
      const bool found = keyword.substr(0, prefix.size()) == prefix;
      keyword.remove_prefix(found ? prefix.size() : 0);
      return found;
    };
    while (skip("ST") || skip("C") || skip("N")) {
    } // some programs write them in another order
    m_is_homogeneous = skip("4");
    const bool has_dimension = skip("n");
    if (!skip("OFF") || (!keyword.empty() && !(keyword[0] >= '0' && keyword[0] <= '9')))
      throw Bad_content("the keyword OFF is missing");
    m_behind_keyword = keyword;
    if (std::string_view rest = m_lines.line(); next_word(rest) == "BINARY")
      throw Bad_content("binary OFF is not read");
    if (has_dimension && word_of_header() != "3")
      throw Bad_content("the vertices do not have three coordinates");
  }

  std::string_view word_of_header()
  {
    std::string_view word;
    std::swap(word, m_behind_keyword);
    if (word.empty())
      word = m_lines.word();
    if (word.empty()) {
      next_line();
      word = m_lines.word();
    }
    return word;
  }

  void read_vertex(Polygon_soup& soup)
  {
    next_line();
    const auto x = read_coordinates(m_lines, m_is_homogeneous);
    soup.points.emplace_back(x[0] / x[3], x[1] / x[3], x[2] / x[3]);
  }

  void read_face(Polygon_soup& soup)
  {
    next_line();
    const std::size_t room = (m_lines.line().size() + m_lines.rest().size()) / 2;
    soup.faces.emplace_back(parse_count(m_lines.word(), room, "vertices of a face"));
    for (std::size_t& vertex : soup.faces.back())
      vertex = parse_index(word_of_face());
  }

  // Where a line is too short because something is missing, the file ends too early.
  std::string_view word_of_face()
  {
    std::string_view word = m_lines.word();
    if (word.empty()) {
      if (m_first_break.empty())
        m_first_break = m_lines.place();
      next_line();
      word = m_lines.word();
    }
    return word;
  }

  Lines m_lines;
  std::string_view m_behind_keyword; // if no blank separates them
  std::string m_first_break;         // where the first face is that goes on in the next line
  bool m_is_homogeneous = false;
};

// An index of a face: counted from 1, or from the last vertex backwards if it is negative; "7/1/3"
// is 7.
inline std::size_t parse_obj_index(std::string_view word, std::size_t number_of_vertices)
{
  word = word.substr(0, word.find('/'));
  const bool is_backwards = !word.empty() && word[0] == '-';
  word.remove_prefix(is_backwards ? 1 : 0);
  const std::size_t index = parse_index(word);
  if (index == 0 || index == no_index)
    return no_index;
  return is_backwards ? (index <= number_of_vertices ? number_of_vertices - index : no_index)
                      : index - 1;
}

// Reads vertices and faces of Wavefront's format OBJ and passes over all else. CGAL's reader takes
// a file without faces for damaged.
inline Polygon_soup read_obj(std::string_view text)
{
  Polygon_soup soup;
  Lines lines(text, Lines::Backslash::CONTINUES);
  try {
    while (lines.next()) {
      const std::string_view keyword = lines.word();
      if (keyword == "v") {
        const auto x = read_coordinates(lines);
        soup.points.emplace_back(x[0], x[1], x[2]);
      } else if (keyword == "f") {
        soup.faces.emplace_back();
        for (std::string_view word = lines.word(); !word.empty(); word = lines.word())
          soup.faces.back().push_back(parse_obj_index(word, soup.points.size()));
      }
    }
  } catch (const Bad_content& error) {
    throw Bad_content(lines.place() + error.what());
  }
  return soup;
}

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

// The weight of a point, which the line goes on with.
inline double read_weight(Lines& lines, std::size_t point)
{
  const std::string_view word = lines.word();
  if (word.empty())
    throw Bad_content("vertex " + std::to_string(point) +
                      " has no weight; remedy: a fourth number in each line");
  return parse_coordinate(word);
}

// Reads .xyz and .pts: a point in each line, three numbers, and its weight if that is asked for.
// What stands behind them, normals, intensities or colors, is passed over, and so are names of
// columns. A line with one word alone is the number of points that follow, which Leica's .pts has;
// it is not believed, but kept.
inline Polygon_soup read_points(std::string_view text, bool with_weights = false)
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
      if (with_weights)
        soup.weights.push_back(read_weight(lines, soup.points.size()));
      soup.points.emplace_back(x[0], x[1], x[2]);
    }
  } catch (const Bad_content& error) {
    throw Bad_content(lines.place() + error.what());
  }
  return soup;
}

} // namespace files

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_TEXTS_H
