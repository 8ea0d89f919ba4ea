// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_REPORT_TILES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_REPORT_TILES_H

#include "Report.h"

#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>

#include <string>

inline void report_tiles(const std::string& output, const CGAL::Tiles_report& result,
                         Report& report)
{
  report("output", output);
  report("points", result.points);
  report("tiles", result.tiles);
  report("rounds", result.rounds);
  report("points told", result.told);
  report("points kept", result.kept);
  report("most points kept by a tile", result.most_kept);
  report("cells", result.cells);
  report("certificate", "holds: the tiles are the Delaunay triangulation of all points, up to a "
                        "collision of hashes of 128 bits");
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_REPORT_TILES_H
