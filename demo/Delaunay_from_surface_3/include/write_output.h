// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_WRITE_OUTPUT_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_WRITE_OUTPUT_H

#include "Options.h"
#include "Report.h"
#include "Surface.h"
#include "arrays_of_triangulation.h"
#include "inside_of.h"

#include <Delaunay_from_surface_3_files/Output_file.h>
#include <Delaunay_from_surface_3_files/same_file.h>

#include <Delaunay_from_surface_3_files/write_gmsh.h>
#include <Delaunay_from_surface_3_files/write_medit.h>
#include <Delaunay_from_surface_3_files/write_tetgen.h>
#include <Delaunay_from_surface_3_files/write_vtk.h>
#include <Delaunay_from_surface_3_files/write_vtu.h>

#include <CGAL/IO/io.h>

#include <cstddef>
#include <filesystem>
#include <iostream>
#include <list>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;
using Vertices = std::vector<Triangulation::Vertex_handle>;

// Returns the files that the tetrahedra go to; the list is empty for the standard output.
inline std::vector<std::string> files_of_output(const Options& options)
{
  if (options.output.empty() || options.output == "-")
    return {};
  if (options.to != "tetgen")
    return {options.output};
  std::filesystem::path stem =
      options.output; // another extension belongs to the name, as in model.1
  const std::string extension = stem.extension().string();
  if (extension == ".node" || extension == ".ele" || extension == ".neigh")
    stem.replace_extension();
  return {stem.string() + ".node", stem.string() + ".ele", stem.string() + ".neigh"};
}

// Throws if a file would be written over another that is read or written, whatever they are called.
inline void check_that_files_differ(const Options& options)
{
  std::vector<std::pair<std::string, std::string>> others; // a description of each, and its name
  if (options.input != "-")
    others.emplace_back("the surface", options.input);
  if (!options.view.empty())
    others.emplace_back("the file of '--three-js'", options.three_js);
  const auto add = [&](const std::string& option, const std::string& name) {
    for (const auto& [what, other] : others)
      if (files::are_same_file(name, other))
        throw std::runtime_error(name + ": '" + option + "' would overwrite " + what);
    others.emplace_back("the file of '" + option + "'", name);
  };
  for (const std::string& name : files_of_output(options))
    add("--output", name);
  if (!options.view.empty())
    add("--view", options.view);
}

// The files that the tetrahedra go to. They are opened before any work is done, in order to know
// whether they can be written.
class Output
{
public:
  explicit Output(const Options& options)
    : m_format(options.to)
  {
    check_that_files_differ(options);
    if (!options.view.empty())
      m_view.emplace(options.view);
    for (const std::string& name : files_of_output(options))
      m_files.emplace_back(name);
  }

  void write(const Triangulation& tr)
  {
    std::ostream& out = stream();
    CGAL::IO::set_binary_mode(out);
    out << tr;
    finish();
  }

  void write(const files::Simplices_3& simplices)
  {
    if (m_format == "tetgen")
      write_tetgen(simplices);
    else if (m_format == "vtu")
      files::write_vtu(stream(), simplices);
    else if (m_format == "vtk")
      files::write_vtk(stream(), simplices);
    else if (m_format == "msh")
      files::write_gmsh(stream(), simplices);
    else
      files::write_medit(stream(), simplices);
    finish();
  }

  // The page of --view, if it was asked for.
  files::Output_file& view() { return *m_view; }

private:
  std::ostream& stream() { return m_files.empty() ? std::cout : m_files.front().stream(); }

  void write_tetgen(const files::Simplices_3& simplices)
  {
    auto file = m_files.begin();
    files::write_tetgen_node((file++)->stream(), simplices);
    files::write_tetgen_ele((file++)->stream(), simplices);
    files::write_tetgen_neigh(file->stream(), simplices);
  }

  void finish()
  {
    for (files::Output_file& file : m_files)
      file.close();
    for (files::Output_file& file : m_files)
      file.finish();
    if (m_files.empty() && !std::cout.flush())
      throw std::runtime_error("the tetrahedra cannot be written to the standard output");
  }

  std::string m_format;
  std::list<files::Output_file> m_files; // empty for the standard output
  std::optional<files::Output_file> m_view;
};

// Checks what can be known before the work is done: points alone have no inside.
inline void check_that_there_are_faces(const Options& options, const Surface& surface)
{
  if ((options.inside || options.mark_inside) && surface.faces.empty())
    throw std::runtime_error(options.input + ": it has no inside: there are no faces");
}

// Returns the part of the triangulation that is to be written.
inline files::Simplices_3 chosen_simplices(const Options& options, const Surface& surface,
                                           const Triangulation& tr, const Vertices& vertices,
                                           Report& report, Messages& messages)
{
  const auto arrays = arrays_of_triangulation<std::int32_t>(tr, vertices, options.to == "tetgen");
  if (options.to == "tetgen" && arrays.dimension() < 3)
    throw std::runtime_error(options.output +
                             ": TetGen's files hold tetrahedra, but there are none");
  CGAL::Inside_3 inside;
  if (options.inside || options.mark_inside) {
    if (arrays.dimension() < 3)
      throw std::runtime_error(options.input + ": it has no inside: its points lie in a plane; " +
                               why_not_closed(surface, arrays));
    try {
      inside = inside_of(surface, arrays, options.threads > 1);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(options.input + ": " + error.what());
    }
    report_inside(options.input, surface, arrays, inside, report, messages);
  }
  files::Simplices_3 simplices = files::simplices_of(
      surface.points, arrays, [&](std::size_t c) { return !options.inside || inside[c]; });
  if (options.mark_inside) {
    std::vector<double> marks; // 1 inside, 0 outside
    for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c)
      marks.push_back(inside[c] ? 1 : 0);
    simplices.data.push_back({"inside", std::move(marks)});
    simplices.data.push_back({"winding_number", std::move(inside.winding_numbers)});
  }
  const bool has_data = options.to == "vtu" || options.to == "vtk" || options.to == "msh";
  if (has_data && simplices.dimension == 3)
    simplices.data.push_back(files::circumradii(simplices));
  return simplices;
}

inline void write(const Options& options, const Surface& surface, const Triangulation& tr,
                  const Vertices& vertices, Output& output, Report& report, Messages& messages)
{
  static const char* const names[] = {"vertices", "edges", "triangles", "tetrahedra"};
  if (options.to == "cgal") {
    output.write(tr);
    report("written", "the triangulation to " + options.output);
    return;
  }
  const files::Simplices_3 simplices =
      chosen_simplices(options, surface, tr, vertices, report, messages);
  output.write(simplices);
  std::string files = options.output;
  if (options.to == "tetgen") {
    const std::vector<std::string> three = files_of_output(options);
    files = three[0] + ", " + three[1] + " and " + three[2];
  }
  report("written",
         std::to_string(simplices.size()) + " " + names[simplices.dimension] + " to " + files);
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_WRITE_OUTPUT_H
