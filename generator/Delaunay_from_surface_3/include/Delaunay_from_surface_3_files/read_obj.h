// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_OBJ_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_OBJ_H

#include <Delaunay_from_surface_3_files/Lines.h>
#include <Delaunay_from_surface_3_files/Polygon_soup.h>

#include <cstddef>
#include <string_view>

namespace files {

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

} // namespace files

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_OBJ_H
