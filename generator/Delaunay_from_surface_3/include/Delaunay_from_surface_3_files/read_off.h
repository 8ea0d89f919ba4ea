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

namespace files {

// Reads text in the format OFF: Geomview's, a line for each vertex and each face. Colors, normals
// and textures are passed over. CGAL's reader believes the numbers that it finds: it makes room
// for as many vertices as the header and for as many corners as a face claims, and looks up colors
// where a line has none.
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
    read_keyword(std::string(m_lines.word()));
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
    throw Bad_content(m_lines.place() + error.what());
  }

private:
  void next_line()
  {
    if (!m_lines.next())
      throw Bad_content("the file ends too early");
  }

  // [ST][C][N][4][n]OFF, where 4 stands for homogeneous coordinates.
  void read_keyword(std::string keyword)
  {
    const auto skip = [&](const std::string& prefix) {
      const bool found = keyword.compare(0, prefix.size(), prefix) == 0;
      keyword.erase(0, found ? prefix.size() : 0);
      return found;
    };
    skip("ST");
    skip("C");
    skip("N");
    m_is_homogeneous = skip("4");
    const bool has_dimension = skip("n");
    if (keyword != "OFF")
      throw Bad_content("the keyword OFF is missing");
    if (std::string_view rest = m_lines.line(); next_word(rest) == "BINARY")
      throw Bad_content("binary OFF is not read");
    if (has_dimension && word_of_header() != "3")
      throw Bad_content("the vertices do not have three coordinates");
  }

  std::string_view word_of_header()
  {
    std::string_view word = m_lines.word();
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
    const std::size_t room = m_lines.line().size() / 2;
    soup.faces.emplace_back(parse_count(m_lines.word(), room, "vertices of a face"));
    for (std::size_t& vertex : soup.faces.back()) {
      const std::string_view word = m_lines.word();
      if (word.empty())
        throw Bad_content("a face has too few vertices");
      vertex = parse_index(word);
    }
  }

  Lines m_lines;
  bool m_is_homogeneous = false;
};

} // namespace files

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_OFF_H
