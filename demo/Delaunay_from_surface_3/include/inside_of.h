// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_INSIDE_OF_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_INSIDE_OF_H

// Which tetrahedra are inside the surface: by CGAL's side of a mesh where that is closed, else by
// winding numbers.

#include "Report.h"
#include "Surface.h"
#include "why_not_closed.h"

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>
#include <CGAL/Delaunay_from_surface_3/Inside_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/inside_of_surface_3.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

using Arrays = CGAL::Delaunay_3_arrays<std::int32_t>;

// What is known of the tetrahedra of the arrays.
struct Inside
{
  std::vector<double> marks;             // 1 inside, 0 outside
  std::optional<CGAL::Inside_3> numbers; // where the surface is not closed
};

inline bool is_closed_mesh(const Surface& surface)
{
  return surface.is_manifold && is_triangle_mesh(surface.mesh) && is_closed(surface.mesh);
}

// The mean of the corners.
inline Point center_of(const Surface& surface, const Arrays& arrays, std::size_t c)
{
  double x[3] = {0, 0, 0};
  for (const std::int32_t v : arrays.vertices(c))
    for (int j = 0; j < 3; ++j)
      x[j] += surface.points[std::size_t(v)][j] / 4;
  return Point(x[0], x[1], x[2]);
}

// The arrays are of tetrahedra. Throws one line if the surface has no inside.
inline Inside inside_of(const Surface& surface, const Arrays& arrays, bool has_threads)
{
  Inside inside;
  if (is_closed_mesh(surface)) {
    const CGAL::Side_of_triangle_mesh<Mesh, Kernel> side_of(surface.mesh);
    for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c)
      inside.marks.push_back(side_of(center_of(surface, arrays, c)) == CGAL::ON_UNBOUNDED_SIDE ? 0
                                                                                               : 1);
    return inside;
  }
#ifdef CGAL_LINKED_WITH_TBB
  using Many = CGAL::Parallel_tag;
#else
  using Many = CGAL::Sequential_tag; // it has been refused that there are more
#endif
  try {
    inside.numbers = has_threads
                         ? CGAL::inside_of_surface_3<Many>(surface.points, surface.faces, arrays)
                         : CGAL::inside_of_surface_3(surface.points, surface.faces, arrays);
  } catch (const CGAL::Surface_input_error& error) {
    throw std::runtime_error(std::string(error.what()) + "; " + why_not_closed(surface, arrays));
  }
  for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c)
    inside.marks.push_back((*inside.numbers)[c] ? 1 : 0);
  return inside;
}

// How sure the winding numbers are, in figures.
inline void report_inside(const Surface& surface, const Arrays& arrays, const Inside& inside,
                          Report& report)
{
  report("inside by", inside.numbers ? "winding numbers" : "closed mesh");
  if (!inside.numbers)
    return;
  const CGAL::Inside_3& numbers = *inside.numbers;
  report("not closed", why_not_closed(surface, arrays));
  report("tetrahedra in doubt",
         fraction(numbers.number_of_doubtful, numbers.winding_numbers.size()));
  report("volume in doubt", decimals(100 * numbers.doubtful_volume, 4) + " % of that inside");
  report("openings", decimals(100 * numbers.share_of_openings, 4) + " % of the surface's area");
  report("in several parts", numbers.number_of_multiple);
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_INSIDE_OF_H
