// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_WHY_NOT_CLOSED_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_WHY_NOT_CLOSED_H

#include "Surface.h"

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

// Edges with something wrong: their number, and the first of them.
struct Bad_edges
{
  const char* name;
  std::size_t number = 0, ends[2] = {0, 0};

  void add(std::size_t a, std::size_t b)
  {
    if (number++ == 0) {
      ends[0] = a;
      ends[1] = b;
    }
  }
};

// Returns "open edges: 3, first 17-42 at (0.5, 0, 1)": numbers of points, and the midpoint.
inline std::string in_words(const Bad_edges& edges, const Surface& surface)
{
  std::ostringstream text;
  text << std::setprecision(10); // as precise as millimetres on a map
  const Point &p = surface.points[edges.ends[0]], &q = surface.points[edges.ends[1]];
  text << edges.name << ": " << edges.number << ", first " << edges.ends[0] << '-' << edges.ends[1]
       << " at (" << p.x() / 2 + q.x() / 2 << ", " << p.y() / 2 + q.y() / 2 << ", "
       << p.z() / 2 + q.z() / 2 << ')';
  return text.str();
}

// Says why faces are not a closed mesh of triangles, in words, numbers and places; equal points are
// one. To be called only if the faces are not such a mesh.
inline std::string why_not_closed(const Surface& surface,
                                  const CGAL::Delaunay_3_arrays<std::int32_t>& arrays)
{
  // The sides of all faces, sorted by edge: its ends, and whether the side leads to the larger.
  std::vector<std::tuple<std::size_t, std::size_t, bool>> sides;
  std::size_t other_faces = 0;
  for (const std::vector<std::size_t>& face : surface.faces) {
    bool has_repeated = false;
    for (std::size_t k = 0; k < face.size(); ++k) {
      const auto a = std::size_t(arrays.vertex_of_point(face[k]));
      const auto b = std::size_t(arrays.vertex_of_point(face[(k + 1) % face.size()]));
      has_repeated = has_repeated || a == b;
      sides.emplace_back((std::min)(a, b), (std::max)(a, b), a < b);
    }
    other_faces += std::size_t(face.size() != 3 || has_repeated);
  }
  std::sort(sides.begin(), sides.end());

  Bad_edges open{"open edges"}, same{"edges with two faces in the same direction"},
      many{"edges with more than two faces"};
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    const auto [a, b, leads_up] = sides[first];
    while (last < sides.size() && std::get<0>(sides[last]) == a && std::get<1>(sides[last]) == b)
      ++last;
    if (a == b)
      continue;
    if (last - first == 1)
      open.add(a, b);
    else if (last - first == 2 && std::get<2>(sides[first + 1]) == leads_up)
      same.add(a, b);
    else if (last - first > 2)
      many.add(a, b);
  }

  std::string result;
  const auto add = [&](const std::string& text) { result += (result.empty() ? "" : "; ") + text; };
  for (const Bad_edges& edges : {open, same, many})
    if (edges.number > 0)
      add(in_words(edges, surface));
  if (other_faces > 0)
    add("faces that are no triangles: " + std::to_string(other_faces));
  if (result.empty())
    return surface.faces.empty() ? "no faces"
                                 : "sheets that touch in a vertex, or points given twice";
  return result;
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_WHY_NOT_CLOSED_H
