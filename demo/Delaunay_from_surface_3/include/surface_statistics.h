// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_SURFACE_STATISTICS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_SURFACE_STATISTICS_H

// Reports how much of the surface is in the triangulation.

#include "Report.h"
#include "Surface.h"

#include <Delaunay_from_surface_3_meters/delaunay_share.h>

#include <string>
#include <vector>

inline void report_surface(const Surface& surface, const Triangulation& tr,
                           const std::vector<Triangulation::Vertex_handle>& vertices,
                           Report& report)
{
  report.title("The surface in the triangulation");
  if (tr.dimension() < 2) {
    report("Delaunay edges", "not counted in dimension " + std::to_string(tr.dimension()));
    return;
  }
  const auto share = meters::delaunay_share(tr, vertices, surface.faces);
  report("Delaunay edges", fraction(share.delaunay_edges, share.edges));
  report("other edges", fraction(share.edges - share.delaunay_edges, share.edges));
  report("Delaunay triangles", fraction(share.delaunay_triangles, share.triangles));
  report("other triangles", fraction(share.triangles - share.delaunay_triangles, share.triangles));
  if (share.polygons > 0)
    report("polygons", std::to_string(share.polygons) + " (not counted as triangles)");
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_SURFACE_STATISTICS_H
