// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_INSIDE_OF_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_INSIDE_OF_H

// Finds which tetrahedra are inside the surface, and how sure that is.

#include "Messages.h"
#include "Report.h"
#include "Surface.h"
#include "why_not_closed.h"

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>
#include <CGAL/Delaunay_from_surface_3/Inside_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/inside_of_surface_3.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

using Arrays = CGAL::Delaunay_3_arrays<std::int32_t>;

inline bool is_closed_mesh(const Surface& surface)
{
  return surface.is_manifold && is_triangle_mesh(surface.mesh) && is_closed(surface.mesh);
}

// The arrays must have tetrahedra. Throws one line if the surface has no inside.
inline CGAL::Inside_3 inside_of(const Surface& surface, const Arrays& arrays, bool has_threads)
{
#ifdef CGAL_LINKED_WITH_TBB
  using Many = CGAL::Parallel_tag;
#else
  using Many = CGAL::Sequential_tag; // more threads have been refused
#endif
  try {
    return has_threads ? CGAL::inside_of_surface_3<Many>(surface.points, surface.faces, arrays)
                       : CGAL::inside_of_surface_3(surface.points, surface.faces, arrays);
  } catch (const CGAL::Surface_input_error& error) {
    throw std::runtime_error(error.what() + (is_closed_mesh(surface)
                                                 ? std::string()
                                                 : "; " + why_not_closed(surface, arrays)));
  }
}

// Reports in figures how sure the winding numbers are, and warns if they are not.
inline void report_inside(const std::string& input, const Surface& surface, const Arrays& arrays,
                          const CGAL::Inside_3& inside, Report& report, Messages& messages)
{
  if (!is_closed_mesh(surface))
    report("not closed", why_not_closed(surface, arrays));
  report("faces turned", inside.number_of_turned);
  report("tetrahedra in doubt", fraction(inside.number_of_doubtful, inside.winding_numbers.size()));
  report("volume in doubt", decimals(100 * inside.doubtful_volume, 4) + " % of that inside");
  report("openings", decimals(100 * inside.share_of_openings, 4) + " % of the surface's area");
  report("faces not in it", decimals(100 * inside.missing_area, 4) + " % of the surface's area");
  report("volume they cross",
         decimals(100 * inside.crossed_volume, 4) + " % of that crossed or inside");
  report("in several parts", inside.number_of_multiple);
  const std::string warning = CGAL::Delaunay_from_surface_3::internal::warning_of(inside);
  if (!warning.empty())
    messages.warn(input + ": " + warning);
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_INSIDE_OF_H
