// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_FILES_WRITE_SIMPLICES_H
#define DELAUNAY_FROM_SURFACE_3_FILES_WRITE_SIMPLICES_H

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>
#include <CGAL/Delaunay_from_surface_3/arrays/measures_of_simplices.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace files {

// is what the functions that write files take: points, and the simplices on them that are to be
// written. `simplices_of()` makes it; anybody may change it, or fill it from elsewhere.
struct Simplices_3
{
  // one number for each simplex.
  struct Data
  {
    std::string name;           // letters, digits and underscores.
    std::vector<double> values; // by simplex.
  };

  int dimension = 3;                         // 3: tetrahedra, 2: triangles, 1: edges, 0: points.
  std::vector<std::array<double, 3>> points; // their coordinates.
  std::vector<std::int64_t> input_indices;   // of each point: where it was in the input.
  std::vector<std::int64_t> simplices;       // `dimension + 1` indices of points for each.
  std::vector<std::int64_t> neighbors;       // as many: simplices, or -1. Empty: not known.
  std::vector<Data> data;                    // what else is known of the simplices.

  // returns how many points a simplex has.
  std::size_t corners() const { return std::size_t(dimension) + 1; }

  // returns the number of simplices.
  std::size_t size() const { return simplices.size() / corners(); }
};

// returns those finite cells `c` of a triangulation for which `is_wanted(c)` holds, and all its
// different points, in the order of the input. The neighbours are left out if the arrays have none.
// Linear.
//
// points: the points of which `arrays` was made: a range of points of any kernel, of
// `std::array<double, 3>`, or of anything with coordinates `p[0]`, `p[1]`, `p[2]`
// arrays: what `delaunay_3_arrays()` returned
// is_wanted: a function from cell numbers to `bool`
template <class PointRange, class Index, class IsWanted>
Simplices_3 simplices_of(const PointRange& points, const CGAL::Delaunay_3_arrays<Index>& arrays,
                         const IsWanted& is_wanted)
{
  Simplices_3 result;
  result.dimension = arrays.dimension() < 0 ? 0 : arrays.dimension();
  std::vector<std::int64_t> point_numbers(arrays.number_of_points(), -1);
  auto p = std::begin(points);
  for (std::size_t i = 0; i < point_numbers.size(); ++i, ++p)
    if (std::size_t(arrays.vertex_of_point(i)) == i) {
      point_numbers[i] = std::int64_t(result.points.size());
      result.points.push_back(
          {CGAL::to_double((*p)[0]), CGAL::to_double((*p)[1]), CGAL::to_double((*p)[2])});
      result.input_indices.push_back(std::int64_t(i));
    }

  std::vector<std::int64_t> cell_numbers(arrays.number_of_simplices(), -1);
  std::int64_t count = 0;
  for (std::size_t c = 0; c < cell_numbers.size(); ++c)
    if (is_wanted(c))
      cell_numbers[c] = count++;
  for (std::size_t c = 0; c < cell_numbers.size(); ++c)
    for (std::size_t k = 0; cell_numbers[c] >= 0 && k < result.corners(); ++k) {
      result.simplices.push_back(point_numbers[std::size_t(arrays.vertices(c)[k])]);
      if (arrays.neighbors_data() != nullptr) {
        const Index n = arrays.neighbors(c)[k];
        result.neighbors.push_back(arrays.is_infinite(n) ? -1 : cell_numbers[std::size_t(n)]);
      }
    }
  return result;
}

// does the same for all finite cells.
template <class PointRange, class Index>
Simplices_3 simplices_of(const PointRange& points, const CGAL::Delaunay_3_arrays<Index>& arrays)
{
  return simplices_of(points, arrays, [](std::size_t) { return true; });
}

// returns the radii of the spheres through the points of tetrahedra, up to rounding, however flat they
// are; infinity where a radius is no finite double. \pre the dimension is 3
inline Simplices_3::Data circumradii(const Simplices_3& s)
{
  Simplices_3::Data data = {"circumradius", {}};
  data.values.reserve(s.size());
  for (std::size_t c = 0; c < s.size(); ++c) {
    std::array<double, 3> corners[4];
    for (std::size_t k = 0; k < 4; ++k)
      corners[k] = s.points[std::size_t(s.simplices[4 * c + k])];
    data.values.push_back(
        CGAL::Delaunay_from_surface_3::internal::circumsphere_of(corners).radius());
  }
  return data;
}

namespace internal {

// Writes numbers with as many digits as a double needs, and leaves the stream as it was.
class Full_precision
{
public:
  explicit Full_precision(std::ostream& out)
    : m_out(out)
    , m_precision(out.precision(std::numeric_limits<double>::max_digits10))
  {
  }
  Full_precision(const Full_precision&) = delete;
  Full_precision& operator=(const Full_precision&) = delete;
  ~Full_precision() { m_out.precision(m_precision); }

private:
  std::ostream& m_out;
  std::streamsize m_precision;
};

// "x y z" for each point, with `begin(i)` before it and `end` after it.
template <class Begin>
void write_points(std::ostream& out, const Simplices_3& s, const Begin& begin, const char* end)
{
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    begin(i);
    out << s.points[i][0] << ' ' << s.points[i][1] << ' ' << s.points[i][2] << end;
  }
}

// The same for the indices of each simplex, which `first` is added to.
template <class Begin>
void write_rows(std::ostream& out, const Simplices_3& s, const std::vector<std::int64_t>& entries,
                std::int64_t first, const Begin& begin, const char* end)
{
  for (std::size_t c = 0; c < s.size(); ++c) {
    begin(c);
    for (std::size_t k = 0; k < s.corners(); ++k)
      out << entries[c * s.corners() + k] + first << (k + 1 < s.corners() ? " " : end);
  }
}

constexpr int vtk_types[] = {1, 3, 5, 10}; // vertex, line, triangle, tetrahedron

} // namespace internal

// writes simplices in Gmsh's text format, `.msh`, version 2.2, which every reader of such files knows.
// All elements are of entity 1, without a physical group; data are written as `ElementData`.
inline void write_gmsh(std::ostream& out, const Simplices_3& s)
{
  static const int gmsh_types[] = {15, 1, 2, 4}; // point, line, triangle, tetrahedron
  const internal::Full_precision precision(out);
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << s.points.size() << '\n';
  internal::write_points(
      out, s, [&](std::size_t i) { out << i + 1 << ' '; }, "\n");
  out << "$EndNodes\n$Elements\n" << s.size() << '\n';
  internal::write_rows(
      out, s, s.simplices, 1,
      [&](std::size_t c) { out << c + 1 << ' ' << gmsh_types[s.dimension] << " 2 0 1 "; }, "\n");
  out << "$EndElements\n";
  for (const Simplices_3::Data& data : s.data) {
    out << "$ElementData\n1\n\"" << data.name << "\"\n1\n0\n3\n0\n1\n" << s.size() << '\n';
    for (std::size_t c = 0; c < s.size(); ++c)
      out << c + 1 << ' ' << data.values[c] << '\n';
    out << "$EndElementData\n";
  }
}

// writes simplices in Medit's text format, `.mesh`. The last number of each line is a label that means
// nothing here; data are not written.
inline void write_medit(std::ostream& out, const Simplices_3& s)
{
  static const char* const keywords[] = {nullptr, "Edges", "Triangles", "Tetrahedra"};
  const internal::Full_precision precision(out);
  out << "MeshVersionFormatted 2\nDimension 3\n\nVertices\n" << s.points.size() << '\n';
  internal::write_points(
      out, s, [](std::size_t) {}, " 0\n");
  if (s.dimension > 0) {
    out << '\n' << keywords[s.dimension] << '\n' << s.size() << '\n';
    internal::write_rows(
        out, s, s.simplices, 1, [](std::size_t) {}, " 0\n");
  }
  out << "\nEnd\n";
}

// writes the points in TetGen's format `.node`, counted from 0.
inline void write_tetgen_node(std::ostream& out, const Simplices_3& s)
{
  const internal::Full_precision precision(out);
  out << s.points.size() << " 3 0 0\n";
  internal::write_points(
      out, s, [&](std::size_t i) { out << i << ' '; }, "\n");
}

// writes tetrahedra in TetGen's format `.ele`, counted from 0. TetGen's own have the same
// orientation.
// \pre the dimension is 3
inline void write_tetgen_ele(std::ostream& out, const Simplices_3& s)
{
  out << s.size() << " 4 0\n";
  internal::write_rows(
      out, s, s.simplices, 0, [&](std::size_t c) { out << c << ' '; }, "\n");
}

// writes the neighbours in TetGen's format `.neigh`: the i-th is opposite to the i-th corner, -1
// for none.
// \pre the dimension is 3, and the neighbours are known
inline void write_tetgen_neigh(std::ostream& out, const Simplices_3& s)
{
  out << s.size() << " 4\n";
  internal::write_rows(
      out, s, s.neighbors, 0, [&](std::size_t c) { out << c << ' '; }, "\n");
}

// writes simplices in VTK's legacy text format for unstructured grids, `.vtk`, with the same data as
// `write_vtu()`. Those files are smaller, and read faster.
inline void write_vtk(std::ostream& out, const Simplices_3& s)
{
  const internal::Full_precision precision(out);
  out << "# vtk DataFile Version 3.0\nDelaunay triangulation\nASCII\nDATASET UNSTRUCTURED_GRID\n"
      << "POINTS " << s.points.size() << " double\n";
  internal::write_points(
      out, s, [](std::size_t) {}, "\n");
  out << "CELLS " << s.size() << ' ' << s.size() * (s.corners() + 1) << '\n';
  internal::write_rows(
      out, s, s.simplices, 0, [&](std::size_t) { out << s.corners() << ' '; }, "\n");
  out << "CELL_TYPES " << s.size() << '\n';
  for (std::size_t c = 0; c < s.size(); ++c)
    out << internal::vtk_types[s.dimension] << '\n';
  out << "POINT_DATA " << s.points.size() << "\nSCALARS input_index long 1\nLOOKUP_TABLE default\n";
  for (const auto i : s.input_indices)
    out << i << '\n';
  if (!s.data.empty())
    out << "CELL_DATA " << s.size() << '\n';
  for (const Simplices_3::Data& data : s.data) {
    out << "SCALARS " << data.name << " double 1\nLOOKUP_TABLE default\n";
    for (const double value : data.values)
      out << value << '\n';
  }
}

// writes simplices in VTK's XML format for unstructured grids, `.vtu`, with the arrays appended as
// they are in memory; with the points' indices in the input as `input_index`, and all data of the
// simplices. The stream must be binary.
inline void write_vtu(std::ostream& out, const Simplices_3& s)
{
  std::vector<double> coordinates;
  coordinates.reserve(3 * s.points.size());
  for (const auto& p : s.points)
    coordinates.insert(coordinates.end(), p.begin(), p.end());
  std::vector<std::int64_t> ends(s.size());
  for (std::size_t i = 0; i < ends.size(); ++i)
    ends[i] = std::int64_t((i + 1) * s.corners());
  const std::vector<std::uint8_t> types(s.size(), std::uint8_t(internal::vtk_types[s.dimension]));

  // The XML part says where in the appended part an array stands: its size in bytes, then its bytes.
  std::vector<std::pair<const void*, std::uint64_t>> blocks;
  std::uint64_t offset = 0;
  const auto announce = [&](const std::string& attributes, const auto& data) {
    out << "        <DataArray " << attributes << R"( format="appended" offset=")" << offset
        << "\"/>\n";
    blocks.emplace_back(data.data(), data.size() * sizeof(data[0]));
    offset += sizeof(std::uint64_t) + blocks.back().second;
  };
  const std::uint16_t one = 1;
  const bool is_little_endian = *reinterpret_cast<const unsigned char*>(&one) == 1;
  out << R"(<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="1.0" byte_order=")"
      << (is_little_endian ? "LittleEndian" : "BigEndian") << R"(" header_type="UInt64">
  <UnstructuredGrid>
    <Piece NumberOfPoints=")"
      << s.points.size() << R"(" NumberOfCells=")" << s.size() << R"(">
      <Points>
)";
  announce(R"(type="Float64" Name="Points" NumberOfComponents="3")", coordinates);
  out << "      </Points>\n      <Cells>\n";
  announce(R"(type="Int64" Name="connectivity")", s.simplices);
  announce(R"(type="Int64" Name="offsets")", ends);
  announce(R"(type="UInt8" Name="types")", types);
  out << "      </Cells>\n      <PointData>\n";
  announce(R"(type="Int64" Name="input_index")", s.input_indices);
  out << "      </PointData>\n      <CellData>\n";
  for (const Simplices_3::Data& data : s.data)
    announce(R"(type="Float64" Name=")" + data.name + "\"", data.values);
  out << "      </CellData>\n    </Piece>\n  </UnstructuredGrid>\n"
      << R"(  <AppendedData encoding="raw">_)";
  for (const auto& [data, size] : blocks) {
    out.write(reinterpret_cast<const char*>(&size), sizeof(size));
    out.write(static_cast<const char*>(data), std::streamsize(size));
  }
  out << "\n  </AppendedData>\n</VTKFile>\n";
}

} // namespace files

#endif // DELAUNAY_FROM_SURFACE_3_FILES_WRITE_SIMPLICES_H
