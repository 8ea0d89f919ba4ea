// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_GEOGRAM_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_GEOGRAM_H

// What the peers that call Geogram share.

#include <Delaunay_from_surface_3_comparison/points_file.h>

#if __has_include(<geogram/delaunay/delaunay.h>)
#include <geogram/basic/command_line_args.h>
#include <geogram/basic/common.h>
#include <geogram/basic/environment.h>
#include <geogram/basic/logger.h>
#include <geogram/basic/process.h>
#include <geogram/delaunay/delaunay.h>
#include <geogram/delaunay/periodic_delaunay_3d.h>
#else // the part of Geogram that its authors give out by itself
#include <Delaunay_psm.h>
#endif

#include <cstddef>
#include <string>

namespace comparison {

inline void start_geogram(unsigned threads)
{
  GEO::initialize();
  GEO::Logger::instance()->set_quiet(true);
  GEO::CmdLine::import_arg_group("standard");
  GEO::CmdLine::import_arg_group("algo");
  GEO::Process::enable_multithreading(threads > 1);
  GEO::Process::set_max_threads(threads);
}

inline void print_answer_of_geogram(const Stopwatch& watch, std::size_t tetrahedra)
{
  std::string version; // which that part does not tell
  GEO::Environment::instance()->get_value("version", version);
  print_answer(watch, tetrahedra, GEO::Process::maximum_concurrent_threads(),
               version.empty() ? "Geogram" : "Geogram " + version,
               DELAUNAY_FROM_SURFACE_3_BUILT_AS);
}

} // namespace comparison

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_GEOGRAM_H
