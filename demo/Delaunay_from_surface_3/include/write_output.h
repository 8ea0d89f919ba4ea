// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_WRITE_OUTPUT_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_WRITE_OUTPUT_H

#include "Options.h"
#include "Report.h"
#include "Surface.h"

#include <Delaunay_from_surface_3_files/Output_file.h>
#include <Delaunay_from_surface_3_files/write_simplices.h>

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>
#include <CGAL/Delaunay_from_surface_3/Inside_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/support/Disjoint_sets.h>
#include <CGAL/IO/io.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/inside_of_surface_3.h>

#include <boost/unordered_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <list>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Writes the triangulation, or what of it is inside the surface.

// Changes the order of a cell's entries such that entry k of d + 1 comes last, but the orientation
// stays.
template <class Entry>
void rotate_to_end(std::array<Entry, 4>& entries, int k, int dimension)
{
  if (k == dimension)
    return;
  std::swap(entries[std::size_t(k)], entries[std::size_t(dimension)]);
  if (dimension > 1) { // two before it, too, so that the permutation is even
    const std::size_t i = k == 0 ? 1 : 0,
                      j = dimension == 2 ? std::size_t(k) : 3 - std::size_t(k) - i;
    std::swap(entries[i], entries[j]);
  }
}

// Calls f with every cell of a triangulation of any dimension, infinite ones included. Below
// dimension 3 its iterator of cells is empty: there cells are facets, edges, or vertices.
template <class Triangulation, class F>
void for_each_cell(const Triangulation& tr, const F& f)
{
  if (tr.dimension() == 3)
    for (auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c)
      f(typename Triangulation::Cell_handle(c));
  else if (tr.dimension() == 2)
    for (auto facet = tr.all_facets_begin(); facet != tr.all_facets_end(); ++facet)
      f(facet->first);
  else if (tr.dimension() == 1)
    for (auto edge = tr.all_edges_begin(); edge != tr.all_edges_end(); ++edge)
      f(edge->first);
  else
    for (auto v = tr.all_vertices_begin(); v != tr.all_vertices_end(); ++v)
      f(v->cell());
}

// The numbers of a triangulation's vertices and cells.
template <class Triangulation, class Index>
class Numbered_triangulation
{
  using Vertex_handle = typename Triangulation::Vertex_handle;
  using Cell_handle = typename Triangulation::Cell_handle;
  using Arrays = CGAL::Delaunay_3_arrays<Index>;

public:
  // `vertices` has the vertices of all points, Vertex_handle() for those without.
  Numbered_triangulation(const Triangulation& tr, const std::vector<Vertex_handle>& vertices,
                         bool has_neighbors)
    : m_tr(tr)
    , m_vertices(vertices)
  {
    m_vertex_numbers.reserve(tr.number_of_vertices() + 1);
    m_vertex_numbers.emplace(tr.infinite_vertex(), Arrays::none);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      if (vertices[i] != Vertex_handle())
        m_vertex_numbers.emplace(vertices[i], Index(i)); // unless an equal point has one
    for (const bool is_infinite : {false, true}) {
      for_each_cell(tr, [&](Cell_handle c) {
        if (has_infinite_vertex(c) == is_infinite)
          m_cells.push_back(c);
      });
      m_number_of_simplices = is_infinite ? m_number_of_simplices : m_cells.size();
    }
    m_cell_numbers.reserve(has_neighbors ? m_cells.size() : 0);
    for (std::size_t c = 0; has_neighbors && c < m_cells.size(); ++c)
      m_cell_numbers.emplace(m_cells[c], Index(c));
  }

  Arrays arrays() const
  {
    typename Arrays::Entries cells;
    cells.allocate(8 * m_cells.size());
    for (std::size_t c = 0; c < m_cells.size(); ++c)
      write_cell(m_cells[c], cells.data() + 8 * c);
    std::vector<Index> vertices_of_points(m_vertices.size(), Arrays::none);
    for (std::size_t i = 0; i < m_vertices.size(); ++i)
      if (m_vertices[i] != Vertex_handle())
        vertices_of_points[i] = m_vertex_numbers.at(m_vertices[i]);
    return Arrays(m_tr.dimension(), m_number_of_simplices, m_cells.size(), std::move(cells),
                  std::move(vertices_of_points));
  }

private:
  bool has_infinite_vertex(Cell_handle c) const
  {
    for (int i = 0; i <= m_tr.dimension(); ++i)
      if (m_tr.is_infinite(c->vertex(i)))
        return true;
    return false;
  }

  void write_cell(Cell_handle c, Index* out) const
  {
    const int d = m_tr.dimension();
    std::array<std::pair<Index, Index>, 4> entries; // a vertex and the neighbour opposite to it
    entries.fill({Arrays::none, Arrays::none});
    for (int i = 0; i <= d; ++i)
      entries[std::size_t(i)] = {m_vertex_numbers.at(c->vertex(i)),
                                 m_cell_numbers.empty() ? Arrays::none
                                                        : m_cell_numbers.at(c->neighbor(i))};
    if (has_infinite_vertex(c))
      rotate_to_end(entries, c->index(m_tr.infinite_vertex()), d);
    for (std::size_t i = 0; i < 4; ++i) {
      out[i] = entries[i].first;
      out[4 + i] = entries[i].second;
    }
  }

  const Triangulation& m_tr;
  const std::vector<Vertex_handle>& m_vertices;
  boost::unordered_map<Vertex_handle, Index> m_vertex_numbers;
  std::vector<Cell_handle> m_cells;
  std::size_t m_number_of_simplices = 0;
  boost::unordered_map<Cell_handle, Index> m_cell_numbers;
};

// Returns the arrays of a triangulation of any dimension; vertices[i] is the vertex of point i.
// Neighbours take most of the time, and can be left out. Expected linear time: handles are hashed.
template <class Index, class Triangulation>
CGAL::Delaunay_3_arrays<Index>
arrays_of_triangulation(const Triangulation& tr,
                        const std::vector<typename Triangulation::Vertex_handle>& vertices,
                        bool has_neighbors = true)
{
  CGAL::Delaunay_3_arrays<Index> arrays;
  if (!vertices.empty())
    arrays = Numbered_triangulation<Triangulation, Index>(tr, vertices, has_neighbors).arrays();
  if (!has_neighbors)
    arrays.drop_neighbors();
  return arrays;
}

// Finds which tetrahedra are inside the surface, and how sure that is.

namespace DFS = CGAL::Delaunay_from_surface_3;
using Arrays = CGAL::Delaunay_3_arrays<std::int32_t>;

inline bool is_closed_mesh(const Surface& surface)
{
  return surface.is_manifold && is_closed(surface.mesh);
}

// The arrays must have tetrahedra. Throws one line if the surface has no inside.
inline CGAL::Inside_3 inside_of(const Surface& surface, const Arrays& arrays, bool has_threads)
{
#ifdef CGAL_LINKED_WITH_TBB
  using Many = CGAL::Parallel_tag;
#else
  using Many = CGAL::Sequential_tag; // more threads have been refused
#endif
  try {
    return has_threads ? CGAL::inside_of_surface_3<Many>(surface.points, surface.faces, arrays)
                       : CGAL::inside_of_surface_3(surface.points, surface.faces, arrays);
  } catch (const CGAL::Surface_input_error& error) {
    throw std::runtime_error(error.what() + (is_closed_mesh(surface)
                                                 ? std::string()
                                                 : "; " + why_not_closed(surface, arrays)));
  }
}

// Returns the volume of the tetrahedra that are inside.
inline double volume_inside(const Surface& surface, const Arrays& arrays,
                            const CGAL::Inside_3& inside)
{
  double volume = 0;
  for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c)
    if (inside[c]) {
      std::array<double, 3> corners[4];
      for (std::size_t k = 0; k < 4; ++k) {
        const auto& p = surface.points[std::size_t(arrays.vertices(c)[k])];
        corners[k] = {p.x(), p.y(), p.z()};
      }
      volume += DFS::internal::volume_of(corners);
    }
  return volume;
}

// Returns whether the faces are in one piece. Several pieces may overlap, be cavities, or be inside out.
inline bool is_in_one_piece(const Surface& surface)
{
  DFS::internal::Disjoint_sets<std::size_t> pieces(surface.points.size());
  for (const std::vector<std::size_t>& face : surface.faces)
    for (const std::size_t v : face)
      pieces.unite(face[0], v);
  return std::all_of(surface.faces.begin(), surface.faces.end(), [&](const auto& face) {
    return pieces.root(face[0]) == pieces.root(surface.faces[0][0]);
  });
}

// Returns the volume that a closed mesh in one piece encloses.
inline double volume_enclosed(const Surface& surface)
{
  double volume = 0;
  const auto& p = surface.points;
  DFS::internal::for_each_triangle(surface.faces, p.size(),
                                   [&](std::size_t i, std::size_t j, std::size_t k, std::size_t) {
                                     volume += CGAL::volume(p.front(), p[i], p[j], p[k]);
                                   });
  return std::abs(volume);
}

// Reports in figures how sure the winding numbers are, and warns if they are not.
inline void report_inside(const std::string& input, const Surface& surface, const Arrays& arrays,
                          const CGAL::Inside_3& inside, Report& report, Messages& messages)
{
  if (!is_closed_mesh(surface))
    report("not closed", why_not_closed(surface, arrays));
  else if (is_in_one_piece(surface))
    report("volume enclosed", volume_enclosed(surface));
  report("volume inside", volume_inside(surface, arrays, inside));
  report("faces turned", inside.number_of_turned);
  report("tetrahedra in doubt", fraction(inside.number_of_doubtful, inside.winding_numbers.size()));
  report("volume in doubt", decimals(100 * inside.doubtful_volume, 4) + " % of that inside");
  report("openings", decimals(100 * inside.share_of_openings, 4) + " % of the surface's area");
  report("faces not Delaunay", decimals(100 * inside.missing_area, 4) + " % of the surface's area");
  report("volume possibly wrong",
         decimals(100 * inside.crossed_volume, 4) + " %, which such faces cut off");
  report("in several parts", inside.number_of_multiple);
  const std::string warning = DFS::internal::warning_of(inside);
  if (!warning.empty())
    messages.warn(input + ": " + warning);
}

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

// Returns what takes the place of the circumradii of tetrahedra if points have weights.
inline files::Simplices_3::Data squared_power_radii(const files::Simplices_3& s,
                                                    const Surface& surface)
{
  files::Simplices_3::Data data = {"squared_power_radius", {}};
  data.values.reserve(s.size());
  for (std::size_t c = 0; c < s.size(); ++c) {
    std::array<double, 4> corners[4];
    for (std::size_t k = 0; k < 4; ++k) {
      const auto point = std::size_t(s.simplices[4 * c + k]);
      const auto& p = surface.weighted[std::size_t(s.input_indices[point])];
      corners[k] = {p.x(), p.y(), p.z(), p.weight()};
    }
    data.values.push_back(DFS::internal::power_sphere_of(corners).squared_radius);
  }
  return data;
}

// Returns the part of the triangulation that is to be written.
template <class Tr>
files::Simplices_3 chosen_simplices(const Options& options, const Surface& surface, const Tr& tr,
                                    const std::vector<typename Tr::Vertex_handle>& vertices,
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
    simplices.data.push_back(options.weights ? squared_power_radii(simplices, surface)
                                             : files::circumradii(simplices));
  return simplices;
}

template <class Tr>
void write(const Options& options, const Surface& surface, const Tr& tr,
           const std::vector<typename Tr::Vertex_handle>& vertices, Output& output, Report& report,
           Messages& messages)
{
  static const char* const names[] = {"vertices", "edges", "triangles", "tetrahedra"};
  if constexpr (std::is_same<Tr, Triangulation>::value)
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
