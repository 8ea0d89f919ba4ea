// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Tiles out of core: from files to files, so nothing but names and numbers crosses.

#include "functions.h"

#include <CGAL/Delaunay_from_surface_3/tiles/Point_files_3.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_too_large.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_to_files.h>

#include <pybind11/stl.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <new>
#include <string>
#include <vector>

namespace py = pybind11;
namespace core = CGAL::Delaunay_from_surface_3::internal;

namespace {

// With progress: it and signals are asked after each task; what they raise goes through as an exception.
CGAL::Tiles_report run(const std::vector<std::string>& files, const std::string& output,
                       std::uint32_t tiles, std::uint64_t memory, std::size_t workers, bool vtu,
                       const py::object& progress)
{
  const CGAL::Point_files_3 points(std::vector<std::filesystem::path>(files.begin(), files.end()));
  CGAL::Tiles_options options;
  options.number_of_tiles = tiles;
  options.starts_again = tiles == 0;
  options.memory = memory;
  options.points_at_once =
      std::size_t((std::min)(std::uint64_t(4000000), memory / workers / 100 + 1));
  options.progress = [&](const char* what, std::size_t done, std::size_t all) {
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0)
      throw py::error_already_set();
    return progress.is_none() || !progress(what, done, all).is(py::bool_(false));
  };
  const py::gil_scoped_release unlocked;
  return core::Tiles_to_files(output, workers, vtu).run(points, options);
}

py::dict delaunay3_tiles(const std::vector<std::string>& files, const std::string& output,
                         std::uint32_t tiles, std::uint64_t memory, std::size_t workers, bool vtu,
                         const py::object& progress)
{
  try {
    const CGAL::Tiles_report report = run(files, output, tiles, memory, workers, vtu, progress);
    py::dict result;
    result["points"] = report.points;
    result["tiles"] = report.tiles;
    result["rounds"] = report.rounds;
    result["told"] = report.told;
    result["kept"] = report.kept;
    result["most_kept"] = report.most_kept;
    result["cells"] = report.cells;
    result["hash"] = report.hash;
    return result;
  } catch (const CGAL::Tiles_stopped&) {
    PyErr_SetString(py::module_::import("delaunay_from_surface").attr("Stopped").ptr(),
                    "progress returned False");
  } catch (const CGAL::Tile_files_error& error) {
    PyErr_SetString(PyExc_OSError, error.what());
  } catch (const core::Tile_too_large& error) {
    PyErr_SetString(PyExc_MemoryError, error.what());
  } catch (const std::bad_alloc&) {
    PyErr_SetString(PyExc_MemoryError, "there is not enough memory for a tile");
  }
  throw py::error_already_set();
}

} // namespace

void python::define_tiles(py::module_& m)
{
  m.def("delaunay3_tiles", &delaunay3_tiles);
}
