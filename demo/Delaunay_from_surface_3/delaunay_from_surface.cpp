// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program delaunay_from_surface: from a surface in a file to the Delaunay triangulation of its
// vertices in another. --help says what it can do.

#include "Options.h"
#include "Progress_visitor.h"
#include "Stopwatch.h"
#include "Surface.h"
#include "compare_with_plain.h"
#include "insertion_statistics.h"
#include "read_surface.h"
#include "report.h"
#include "surface_statistics.h"
#include "write_simplices.h"

#include <Delaunay_from_surface_3_files/Output_file.h>
#include <Delaunay_from_surface_3_files/file_extension.h>
#include <Delaunay_from_surface_3_files/one_line.h>

#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Plain_insertion_traits_3.h>
#include <CGAL/Tracing_traits_3.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

using files::file_extension;
using files::Output_file;

const int exit_different = 2;

std::string kind_of(const Surface& surface)
{
  if (surface.is_manifold)
    return CGAL::is_triangle_mesh(surface.mesh) ? "triangle mesh" : "polygon mesh";
  return surface.faces.empty() ? "points without faces" : "polygon soup";
}

void report_input(const Options& options, const Surface& surface)
{
  report("input", options.input);
  report("surface", kind_of(surface));
  report("surface vertices", surface.points.size());
  report("surface faces", surface.faces.size());
  report("traits", options.traits);
  report("seed", options.seed);
}

// What is good to know and no error.
void note_what_is_odd(const Options& options, const Surface& surface)
{
  if (surface.faces.empty())
    std::cerr << "note: " << options.input << ": there are no faces, its points are taken alone\n";
  else if (!surface.is_manifold)
    std::cerr << "note: " << options.input
              << ": not a consistently oriented manifold mesh, taken as a polygon soup\n";
}

void report_result(const Surface& surface, const Triangulation& tr)
{
  report("dimension", tr.dimension());
  report("vertices", tr.number_of_vertices());
  report("duplicates", surface.points.size() - tr.number_of_vertices());
  report("finite cells", tr.number_of_finite_cells());
  report("cells", tr.number_of_cells());
}

void write(Output_file& output, const Options& options, const Simplices& simplices)
{
  if (file_extension(options.output) == "vtu")
    write_vtu(output.stream(), simplices);
  else
    write_medit(output.stream(), simplices);
  output.finish();
  static const char* const names[] = {"vertices", "edges", "triangles", "tetrahedra"};
  report("written", std::to_string(simplices.size()) + " " + names[simplices.dimension] + " to " +
                        options.output);
}

template <class Traits>
int run(const Options& options, const Surface& surface, std::optional<Output_file>& output,
        const Traits& traits)
{
  Triangulation tr;
  std::vector<Triangulation::Vertex_handle> vertices;
  Seconds seconds;
  try {
    seconds = time_of([&] {
      Progress_visitor visitor(surface.points.size());
      vertices = insert_and_watch(tr, surface, traits, options.seed, visitor);
    });
  } catch (const CGAL::Surface_input_error& error) {
    throw std::runtime_error(options.input + ": " + error.what());
  }
  note_what_is_odd(options, surface);
  report("CPU seconds", decimals(seconds.cpu, 6));
  report_result(surface, tr);
  if (output)
    write(*output, options, simplices_of(tr, vertices));

  bool is_equal = true;
  if (options.compare)
    is_equal = compare_with_plain(surface, traits, options.seed, options.repetitions, tr);
  if (options.stats) {
    report_surface(surface, tr, vertices);
    report_seconds(surface, traits, options.seed);
    report_predicates(surface, traits, options.seed);
  }
  return is_equal ? EXIT_SUCCESS : exit_different;
}

int run(const Options& options)
{
  std::optional<Output_file> output;
  if (!options.output.empty()) {
    const std::string extension = file_extension(options.output);
    if (extension != "vtu" && extension != "mesh")
      throw std::runtime_error(options.output + ": unknown extension; .vtu and .mesh are written");
    output.emplace(options.output);
  }
  const Surface surface = read_surface(options.input);
  report_input(options, surface);
  if (options.traits == "tracing")
    return run(options, surface, output, CGAL::Tracing_traits_3());
  if (options.traits == "plain")
    return run(options, surface, output, CGAL::Plain_insertion_traits_3());
  return run(options, surface, output, CGAL::Surface_insertion_traits_3());
}

// One clear line, whatever went wrong.
int fail(const std::string& message)
{
  std::cout.flush();
  std::cerr << "error: " << files::one_line(message) << '\n';
  return EXIT_FAILURE;
}

int main(int argc, char* argv[])
{
  try {
    std::optional<Options> options;
    try {
      options = parse_command_line(argc, argv);
    } catch (const std::exception& error) {
      return fail(std::string(error.what()) + " (--help explains all options)");
    }
    const int exit_code = options ? run(*options) : EXIT_SUCCESS;
    if (!std::cout.flush())
      return fail("the results cannot be written to the standard output");
    return exit_code;
  } catch (const std::bad_alloc&) {
    return fail("there is not enough memory");
  } catch (const std::runtime_error& error) {
    return fail(error.what());
  } catch (const std::exception& error) {
    return fail(std::string("this should not happen, please report it: ") + error.what());
  }
}
