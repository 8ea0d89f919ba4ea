// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_RUN_TILES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_RUN_TILES_H

// The driver: tiles tell each other until nobody has anything to tell, and then compare what they
// have. If that is not the same, those that differ show each other why, and go on.
//
// An engine has four verbs: exchange() has every tile hear what it was told, and tell, and returns
// how many points were told; gather(seed) returns the certificates of all tiles; show(pairs) has
// each tile of a pair tell the other what is around the cells that both see
// (Delaunay_tile::witnesses()); give(sink) hands out the tiles. Where several processes run the
// driver, each of these is done by all of them, and returns the same, or throws.

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_certificate.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_source_3.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_too_large.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>
#include <CGAL/Delaunay_from_surface_3/tiles/number_of_tiles.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The certificates' part of the report, and whether they hold.
inline void report_certificates(const std::vector<Tile_certificate>& certificates,
                                Tiles_report& report)
{
  report.kept = report.most_kept = report.cells = report.hash = 0;
  for (const Tile_certificate& c : certificates) {
    report.kept += c.points_kept;
    report.most_kept = (std::max)(report.most_kept, c.points_kept);
    report.cells += c.owned_cells;
    report.hash += c.hash;
  }
  report.is_certified = is_certified(certificates, report.tiles, report.points);
}

// With many processes one of them draws it for all, by another overload.
template <class Engine, class Draw>
std::uint64_t draw_seed(const Engine&, const Draw& draw)
{
  return draw();
}

constexpr int most_repairs = 64; // none was needed where tiles had a thousand points and more

// `draw` draws a seed, when no cell changes any more.
template <class Engine, class Draw>
Tiles_report run_tiles(Engine& engine, const Draw& draw)
{
  Tiles_report report;
  report.points = engine.number_of_points();
  report.tiles = engine.number_of_tiles();
  for (int repairs = 0;; ++repairs) {
    while (engine.exchange() > 0)
      ;
    const auto certificates = engine.gather(draw_seed(engine, draw));
    report.rounds = engine.rounds();
    report.told = engine.told();
    Tile_pairs differing;
    engine.together([&] { // it may throw on one of many processes
      report_certificates(certificates, report);
      differing = tiles_that_differ(certificates);
    });
    if (report.is_certified || differing.empty() || repairs == most_repairs)
      return report;
    engine.show(differing);
  }
}

constexpr const char* tiles_do_not_fit =
    "the tiles do not fit together: the certificate does not hold";

// Of a refused input nothing is left: the next one is another.
template <class Engine>
void begin_or_forget(Engine& engine, const Tile_source_3& source, const Tiles_options& options)
{
  try {
    engine.begin(source, options);
  } catch (const Surface_input_error&) {
    engine.forget();
    throw;
  }
}

// Begins, and again with more tiles if one becomes too large, until the certificate holds; returns
// finish(report).
template <class Engine, class Draw, class Finish>
Tiles_report run_until_certified(Engine& engine, const Tile_source_3& source, Tiles_options options,
                                 const Draw& draw, const Finish& finish)
{
  for (;;) {
    try {
      begin_or_forget(engine, source, options);
      const Tiles_report report = run_tiles(engine, draw);
      if (!report.is_certified)
        throw std::runtime_error(tiles_do_not_fit);
      return finish(report);
    } catch (const Tile_too_large& error) {
      if (!ask_for_more_tiles(options, error, engine.number_of_points(), engine.number_of_tiles()))
        throw;
      engine.forget();
    }
  }
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_RUN_TILES_H
