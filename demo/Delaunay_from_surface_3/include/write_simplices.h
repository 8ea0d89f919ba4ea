// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_WRITE_SIMPLICES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_WRITE_SIMPLICES_H

#include "Surface.h"

#include <boost/unordered_map.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

// A triangulation as two arrays. `simplices` holds d + 1 indices into `points` for each finite
// d-simplex, where d is the dimension of the triangulation: tetrahedra, unless all points lie in
// a plane (triangles) or on a line (segments). Tetrahedra have positive orientation.
struct Simplices
{
  int dimension;
  std::vector<Point> points;
  std::vector<std::int64_t> simplices;

  std::size_t corners() const { return std::size_t(dimension) + 1; }
  std::size_t size() const { return simplices.size() / corners(); }
};

// The points come in the order of the surface's vertices `vertices`, each once.
inline Simplices simplices_of(const Triangulation& tr,
                              const std::vector<Triangulation::Vertex_handle>& vertices)
{
  Simplices result = {tr.dimension(), {}, {}};
  boost::unordered_map<Triangulation::Vertex_handle, std::int64_t> numbers;
  for (const auto v : vertices)
    if (numbers.emplace(v, std::int64_t(result.points.size())).second)
      result.points.push_back(v->point());

  const auto add = [&](auto... corners) { (result.simplices.push_back(numbers.at(corners)), ...); };
  if (tr.dimension() == 3)
    for (const auto c : tr.finite_cell_handles())
      add(c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3));
  else if (tr.dimension() == 2)
    for (const auto& f : tr.finite_facets())
      add(f.first->vertex(0), f.first->vertex(1), f.first->vertex(2));
  else if (tr.dimension() == 1)
    for (const auto& e : tr.finite_edges())
      add(e.first->vertex(0), e.first->vertex(1));
  else
    add(vertices.front());
  return result;
}

// Medit's text format. The last number of each line is a label that means nothing here.
inline void write_medit(std::ostream& out, const Simplices& s)
{
  static const char* const keywords[] = {nullptr, "Edges", "Triangles", "Tetrahedra"};
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "MeshVersionFormatted 2\nDimension 3\n\nVertices\n" << s.points.size() << '\n';
  for (const Point& p : s.points)
    out << p << " 0\n";
  if (s.dimension > 0) {
    out << '\n' << keywords[s.dimension] << '\n' << s.size() << '\n';
    for (std::size_t i = 0; i < s.simplices.size(); ++i)
      out << s.simplices[i] + 1 << ((i + 1) % s.corners() == 0 ? " 0\n" : " ");
  }
  out << "\nEnd\n";
}

// One array at the end of a .vtu file: its size in bytes and then its bytes.
template <class T>
void write_block(std::ostream& out, const std::vector<T>& data)
{
  const std::uint64_t size = data.size() * sizeof(T);
  out.write(reinterpret_cast<const char*>(&size), sizeof(size));
  out.write(reinterpret_cast<const char*>(data.data()), std::streamsize(size));
}

inline const char* byte_order()
{
  const std::uint16_t one = 1;
  return *reinterpret_cast<const unsigned char*>(&one) == 1 ? "LittleEndian" : "BigEndian";
}

// VTK's XML format for unstructured grids, with the arrays appended as they are.
inline void write_vtu(std::ostream& out, const Simplices& s)
{
  static const std::uint8_t vtk_types[] = {1, 3, 5, 10}; // vertex, line, triangle, tetrahedron
  std::vector<double> coordinates;
  for (const Point& p : s.points)
    coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
  std::vector<std::int64_t> ends(s.size());
  for (std::size_t i = 0; i < ends.size(); ++i)
    ends[i] = std::int64_t((i + 1) * s.corners());
  const std::vector<std::uint8_t> types(s.size(), vtk_types[s.dimension]);

  std::uint64_t offset = 0;
  const auto announce = [&](const std::string& attributes, std::uint64_t size) {
    out << "        <DataArray " << attributes << " format=\"appended\" offset=\"" << offset
        << "\"/>\n";
    offset += sizeof(std::uint64_t) + size;
  };
  out << "<?xml version=\"1.0\"?>\n"
      << "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"" << byte_order()
      << "\" header_type=\"UInt64\">\n  <UnstructuredGrid>\n    <Piece NumberOfPoints=\""
      << s.points.size() << "\" NumberOfCells=\"" << s.size() << "\">\n      <Points>\n";
  announce("type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", 8 * coordinates.size());
  out << "      </Points>\n      <Cells>\n";
  announce("type=\"Int64\" Name=\"connectivity\"", 8 * s.simplices.size());
  announce("type=\"Int64\" Name=\"offsets\"", 8 * ends.size());
  announce("type=\"UInt8\" Name=\"types\"", types.size());
  out << "      </Cells>\n    </Piece>\n  </UnstructuredGrid>\n  <AppendedData encoding=\"raw\">_";
  write_block(out, coordinates);
  write_block(out, s.simplices);
  write_block(out, ends);
  write_block(out, types);
  out << "\n  </AppendedData>\n</VTKFile>\n";
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_WRITE_SIMPLICES_H
