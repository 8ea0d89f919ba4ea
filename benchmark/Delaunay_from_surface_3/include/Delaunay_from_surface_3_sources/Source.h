// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SOURCES_SOURCE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SOURCES_SOURCE_H

// Where surfaces come from: packages of CGAL's, and files.

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/io.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace sources {

using surfaces::Indexed_surface;
using surfaces::Mesh;
using Kernel = Indexed_surface::Kernel;

/// Why a source gives no surface here: a library or a file that is missing.
struct Missing : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// The triangulation that an algorithm still has when it ends, where it can be asked for it.
struct Held
{
  std::size_t vertices = 0;
  std::size_t weighted = 0; // vertices with another weight than 0: it need not be Delaunay
};

struct Made
{
  Indexed_surface surface;
  std::optional<Held> held;
};

struct Source
{
  std::string name;
  std::string made_from;
  std::function<Made()> make;
};

/// What all are asked for.
struct Task
{
  std::size_t points; // about so many
  std::string data_dir;

  /// \throws Missing
  Mesh read(const std::string& file) const;
  /// A scan without holes.
  Mesh model() const { return read("armadillo.off"); }
};

/// The length of the edges of `n` vertices that are spread evenly over the surface.
double even_edge_length(const Mesh& mesh, std::size_t n);

/// One function for each room of CGAL's, in several units, as their headers are heavy.
std::vector<Source> scans(const Task& task);
std::vector<Source> meshing(const Task& task);
std::vector<Source> reconstruction(const Task& task);
std::vector<Source> iso_surfaces(const Task& task);
std::vector<Source> processing(const Task& task);

} // namespace sources

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SOURCES_SOURCE_H
