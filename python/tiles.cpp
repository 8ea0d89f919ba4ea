// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Makes tiles out of core, from files to files, so only names and numbers are passed.

#include "Unlocked.h"
#include "interruptible.h"
#include "functions.h"

#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_in_files.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiling.h>

#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <new>
#include <string>
#include <vector>

namespace py = pybind11;
namespace core = CGAL::Delaunay_from_surface_3::core;

namespace {

// The input and the options of a call.
struct Run
{
  CGAL::Point_files_3 points;
  CGAL::Tiles_options options;

  Run(const std::vector<std::string>& files, std::uint32_t tiles, std::uint64_t memory)
    : points(std::vector<std::filesystem::path>(files.begin(), files.end()))
  {
    options.number_of_tiles = tiles;
    options.starts_again = tiles == 0;
    options.memory = memory;
  }
};

// Sets an error. The text may contain the name of a file, which is not always UTF-8.
void set_error(PyObject* type, const char* what)
{
  PyErr_SetObject(type, py::reinterpret_steal<py::object>(PyUnicode_DecodeFSDefault(what)).ptr());
}

// Calls f() without the interpreter lock, and turns its exceptions into Python's.
template <class F>
auto without_lock(const F& f)
{
  try {
    const python::Unlocked unlocked;
    return f();
  } catch (const CGAL::Tiles_stopped&) {
    PyErr_SetString(py::module_::import("delaunay_from_surface").attr("Stopped").ptr(),
                    "progress returned False");
  } catch (const CGAL::Tile_files_error& error) {
    set_error(PyExc_OSError, error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    set_error(PyExc_OSError, error.what());
  } catch (const core::Tile_too_large& error) {
    PyErr_SetString(PyExc_MemoryError, error.what());
  } catch (const std::bad_alloc&) {
    PyErr_SetString(PyExc_MemoryError, "there is not enough memory for a tile");
  }
  throw py::error_already_set();
}

// After each task, signals are checked and `progress` is called; their exceptions are passed on.
void delaunay3_tiles(const std::vector<std::string>& files, const std::string& output,
                     std::uint32_t tiles, std::uint64_t memory, std::size_t workers, bool vtu,
                     const py::object& progress)
{
  without_lock([&] {
    Run run(files, tiles, memory);
    run.options.progress = [&](const char* what, std::size_t done, std::size_t all) {
      const python::Locked lock;
      python::see_signals();
      return progress.is_none() ||
             !python::says_no(python::called(progress, py::make_tuple(what, done, all)));
    };
    return core::Tiles_to_files(output, workers, vtu).run(run.points, run.options);
  });
}

// Closes what is done; returns the number of tasks now, their stage, and the number of tiles.
py::tuple next_of_tiles(const std::vector<std::string>& files, const std::string& output,
                        std::uint32_t tiles, std::uint64_t memory, bool vtu)
{
  const core::Tiles_to_files::Tasks next = without_lock([&] {
    const Run run(files, tiles, memory);
    return core::Tiles_to_files(output, 1, vtu).next(run.points, run.options);
  });
  return py::make_tuple(next.number, next.stage, next.tiles);
}

// Does one of these tasks. Returns 0 if it is done, or, if the caller would begin again with more
// tiles, their number.
std::uint32_t do_task_of_tiles(const std::vector<std::string>& files, const std::string& output,
                               std::uint32_t tiles, std::uint64_t memory, bool vtu,
                               std::size_t task, bool starts_again)
{
  return without_lock([&]() -> std::uint32_t {
    Run run(files, tiles, memory);
    run.options.starts_again = starts_again;
    const core::Tiles_to_files work(output, 1, vtu);
    try {
      work.do_task(run.points, run.options, task);
      return 0;
    } catch (const core::Tile_too_large& error) {
      const std::uint64_t n = run.points.size();
      if (!core::ask_for_more_tiles(run.options, error, n, error.number_of_tiles_now()))
        throw;
      return core::number_of_tiles(run.options, n, 1);
    }
  });
}

void forget_tiles(const std::string& output)
{
  without_lock([&] {
    core::Tiles_to_files(output, 1, false).forget();
    return 0;
  });
}

} // namespace

void python::define_tiles(py::module_& m)
{
  m.def("delaunay3_tiles", &delaunay3_tiles);
  m.def("next_of_tiles", &next_of_tiles);
  m.def("do_task_of_tiles", &do_task_of_tiles);
  m.def("forget_tiles", &forget_tiles);
}
