// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A peer of measure_periodic: Geogram's triangulation of points in the unit box with periods of 1.

#include <Delaunay_from_surface_3_comparison/points_file.h>

#if __has_include(<geogram/delaunay/periodic_delaunay_3d.h>)
#include <geogram/basic/command_line_args.h>
#include <geogram/basic/common.h>
#include <geogram/basic/environment.h>
#include <geogram/basic/logger.h>
#include <geogram/basic/process.h>
#include <geogram/delaunay/periodic_delaunay_3d.h>
#else // the part of Geogram that its authors give out by itself
#include <Delaunay_psm.h>
#endif

#include <string>
#include <vector>

int main(int argc, char** argv)
{
  return comparison::run_peer(
      "geogram_periodic_peer", true, argc, argv,
      [](unsigned threads, const std::vector<double>& coordinates) {
        GEO::initialize();
        GEO::Logger::instance()->set_quiet(true);
        GEO::CmdLine::import_arg_group("standard");
        GEO::CmdLine::import_arg_group("algo");
        GEO::Process::enable_multithreading(threads > 1);
        GEO::Process::set_max_threads(threads);
        GEO::SmartPointer<GEO::PeriodicDelaunay3d> delaunay = new GEO::PeriodicDelaunay3d(true, 1);
        comparison::Stopwatch watch;
        delaunay->set_vertices(static_cast<GEO::index_t>(coordinates.size() / 3),
                               coordinates.data());
        delaunay->compute();
        watch.stop();
        std::string version; // which that part does not tell
        GEO::Environment::instance()->get_value("version", version);
        comparison::print_answer(
            watch, delaunay->nb_cells(), GEO::Process::maximum_concurrent_threads(),
            version.empty() ? "Geogram" : "Geogram " + version, DELAUNAY_FROM_SURFACE_3_BUILT_AS);
      });
}
