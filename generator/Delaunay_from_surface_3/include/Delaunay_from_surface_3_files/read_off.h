// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_OFF_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_OFF_H

#include <Delaunay_from_surface_3_files/Lines.h>
#include <Delaunay_from_surface_3_files/Polygon_soup.h>
#include <Delaunay_from_surface_3_files/parse_number.h>

#include <algorithm>
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
    double x[4] = {0, 0, 0, 1};
    for (int i = 0; i < (m_is_homogeneous ? 4 : 3); ++i) {
      const std::string_view word = m_lines.word();
      if (word.empty())
        throw Bad_content("a vertex has too few coordinates");
      x[i] = parse_coordinate(word);
    }
    if (m_is_homogeneous)
      soup.points.emplace_back(x[0] / x[3], x[1] / x[3], x[2] / x[3]);
    else
      soup.points.emplace_back(x[0], x[1], x[2]);
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

} // namespace files

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_OFF_H
