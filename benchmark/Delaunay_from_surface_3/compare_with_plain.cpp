// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Builds the Delaunay triangulations of surfaces by CGAL's own range insertion, by the ways of this
// package and by other programs, in turns, and writes what was measured as JSON.

#include <Delaunay_from_surface_3_comparison/comparison.h>
#include <Delaunay_from_surface_3_comparison/launcher.h>
#include <Delaunay_from_surface_3_comparison/machine.h>
#include <Delaunay_from_surface_3_comparison/options.h>
#include <Delaunay_from_surface_3_comparison/surfaces.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

namespace {

using namespace comparison;

Json description_of(const std::vector<Method>& methods, const Options& options)
{
  Json names = Json::object();
  for (const Method& method : methods)
    names[method.name] = method.description;
  return {{"program", "compare_with_plain"},
          {"command", options.command},
          {"machine", describe_machine(DELAUNAY_FROM_SURFACE_3_COMPILER_FLAGS)},
          {"load_average_at_start", rounded(load_average(), 100)},
          {"repetitions", options.repetitions},
          {"methods", names}};
}

void write(const Json& report, const std::string& file_name)
{
  std::ofstream file(file_name);
  file << report.dump(1) << '\n';
  if (!file.flush())
    throw std::runtime_error("cannot write '" + file_name + "'");
}

// Returns whether all triangulations were equal to plain CGAL's.
bool run(const Options& options)
{
  Launcher launcher; // before anything large is in memory
  Comparison comparison(options, launcher);
  Json report = description_of(comparison.methods(), options);
  report["results"] = Json::array();
  bool all_equal = true;
  for (const Named_surface& surface : chosen_surfaces(options))
    for (const std::size_t size : options.sizes) {
      if (size < surface.least_size && !(surface.is_file && size == 0)) {
        std::cerr << surface.name << ", " << size << " points: left out, it is made from "
                  << surface.least_size << " on\n";
        continue;
      }
      const Mesh mesh = surfaces::to_mesh<Mesh>(surface.make(size, options.seed));
      std::cerr << surface.name << ", " << mesh.number_of_vertices() << " points\n";
      Json result = {{"surface", surface.name},
                     {"description", surface.description},
                     {"size", size},
                     {"points", mesh.number_of_vertices()},
                     {"faces", mesh.number_of_faces()}};
      all_equal = comparison.run(mesh, result) && all_equal;
      report["results"].push_back(std::move(result));
      report["load_average_at_end"] = rounded(load_average(), 100);
      write(report, options.output); // what is measured is kept, should the rest be interrupted
    }
  return all_equal;
}

} // namespace

int main(int argc, char** argv)
{
  try {
    const auto options = parse_command_line(argc, argv);
    if (options && !run(*options))
      throw std::runtime_error("a triangulation differs from CGAL's");
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << "compare_with_plain: " << error.what() << '\n';
  }
  return EXIT_FAILURE;
}
