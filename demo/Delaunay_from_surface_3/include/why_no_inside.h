// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_WHY_NO_INSIDE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_WHY_NO_INSIDE_H

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

// Why faces are not a closed mesh of triangles, in words and numbers. To be asked only if they are
// not one.
inline std::string why_no_inside(const std::vector<std::vector<std::size_t>>& faces)
{
  // The sides of all faces, those of an edge together: its ends, and whether it leads to the
  // larger.
  std::vector<std::tuple<std::size_t, std::size_t, bool>> sides;
  std::size_t other_faces = 0;
  for (const std::vector<std::size_t>& face : faces) {
    bool has_repeated = false;
    for (std::size_t k = 0; k < face.size(); ++k) {
      const std::size_t a = face[k], b = face[(k + 1) % face.size()];
      has_repeated = has_repeated || a == b;
      sides.emplace_back((std::min)(a, b), (std::max)(a, b), a < b);
    }
    other_faces += std::size_t(face.size() != 3 || has_repeated);
  }
  std::sort(sides.begin(), sides.end());

  std::size_t open = 0, same_direction = 0, many_faces = 0;
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    const auto [a, b, leads_up] = sides[first];
    while (last < sides.size() && std::get<0>(sides[last]) == a && std::get<1>(sides[last]) == b)
      ++last;
    if (a == b)
      continue;
    open += std::size_t(last - first == 1);
    same_direction += std::size_t(last - first == 2 && std::get<2>(sides[first + 1]) == leads_up);
    many_faces += std::size_t(last - first > 2);
  }

  std::string result;
  for (const auto& [name, number] : std::initializer_list<std::pair<const char*, std::size_t>>{
           {"open edges", open},
           {"edges with two faces in the same direction", same_direction},
           {"edges with more than two faces", many_faces},
           {"faces that are no triangles", other_faces}})
    if (number > 0)
      result += (result.empty() ? "" : ", ") + std::string(name) + ": " + std::to_string(number);
  if (result.empty())
    return faces.empty() ? "no faces" : "sheets that touch in a vertex";
  return result;
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_WHY_NO_INSIDE_H
