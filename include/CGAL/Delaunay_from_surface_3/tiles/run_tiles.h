// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_RUN_TILES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_RUN_TILES_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_certificate.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// What a run of tiles was like.
struct Tiles_report
{
  std::size_t rounds = 0;
  std::size_t told = 0; // points, of all tiles
  bool is_certified = false;
};

// Tiles tell each other until nobody has anything to tell, and then compare what they have.
template <class Engine>
Tiles_report run_tiles(Engine& engine, std::uint64_t seed)
{
  Tiles_report report;
  for (std::size_t told = 1; told > 0; ++report.rounds) {
    told = engine.exchange();
    report.told += told;
  }
  report.is_certified = is_certified(engine.gather(seed));
  return report;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_RUN_TILES_H
