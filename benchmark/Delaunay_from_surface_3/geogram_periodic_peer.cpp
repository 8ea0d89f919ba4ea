// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A peer of measure_periodic: Geogram's triangulation of points in the unit box with periods of 1.

#include <Delaunay_from_surface_3_comparison/geogram.h>
#include <Delaunay_from_surface_3_comparison/points_file.h>

#include <vector>

int main(int argc, char** argv)
{
  return comparison::run_peer(
      "geogram_periodic_peer", true, argc, argv,
      [](unsigned threads, const std::vector<double>& coordinates) {
        comparison::start_geogram(threads);
        GEO::SmartPointer<GEO::PeriodicDelaunay3d> delaunay = new GEO::PeriodicDelaunay3d(true, 1);
        comparison::Stopwatch watch;
        delaunay->set_vertices(static_cast<GEO::index_t>(coordinates.size() / 3),
                               coordinates.data());
        delaunay->compute();
        watch.stop();
        comparison::print_answer_of_geogram(watch, delaunay->nb_cells());
      });
}
