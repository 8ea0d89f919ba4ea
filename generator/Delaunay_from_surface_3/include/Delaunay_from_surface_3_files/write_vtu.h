// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_FILES_WRITE_VTU_H
#define DELAUNAY_FROM_SURFACE_3_FILES_WRITE_VTU_H

#include <Delaunay_from_surface_3_files/Simplices_3.h>

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace files {
namespace internal {

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

// Says in the XML part where in the appended part an array stands.
class Announce_array
{
public:
  explicit Announce_array(std::ostream& out)
    : m_out(out)
  {
  }
  void operator()(const std::string& attributes, std::uint64_t size)
  {
    m_out << "        <DataArray " << attributes << R"( format="appended" offset=")" << m_offset
          << "\"/>\n";
    m_offset += sizeof(std::uint64_t) + size;
  }

private:
  std::ostream& m_out;
  std::uint64_t m_offset = 0;
};

} // namespace internal

// writes simplices in VTK's XML format for unstructured grids, `.vtu`, with the arrays appended as
// they are in memory; with the points' indices in the input as `input_index`, and all data of the
// simplices. The stream must be binary.
inline void write_vtu(std::ostream& out, const Simplices_3& s)
{
  static const std::uint8_t vtk_types[] = {1, 3, 5, 10}; // vertex, line, triangle, tetrahedron
  std::vector<double> coordinates;
  coordinates.reserve(3 * s.points.size());
  for (const auto& p : s.points)
    coordinates.insert(coordinates.end(), p.begin(), p.end());
  std::vector<std::int64_t> ends(s.size());
  for (std::size_t i = 0; i < ends.size(); ++i)
    ends[i] = std::int64_t((i + 1) * s.corners());
  const std::vector<std::uint8_t> types(s.size(), vtk_types[s.dimension]);

  out << R"(<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="1.0" byte_order=")"
      << internal::byte_order() << R"(" header_type="UInt64">
  <UnstructuredGrid>
    <Piece NumberOfPoints=")"
      << s.points.size() << R"(" NumberOfCells=")" << s.size() << R"(">
      <Points>
)";
  internal::Announce_array announce(out);
  announce(R"(type="Float64" Name="Points" NumberOfComponents="3")", 8 * coordinates.size());
  out << "      </Points>\n      <Cells>\n";
  announce(R"(type="Int64" Name="connectivity")", 8 * s.simplices.size());
  announce(R"(type="Int64" Name="offsets")", 8 * ends.size());
  announce(R"(type="UInt8" Name="types")", types.size());
  out << "      </Cells>\n      <PointData>\n";
  announce(R"(type="Int64" Name="input_index")", 8 * s.input_indices.size());
  out << "      </PointData>\n      <CellData>\n";
  for (const Simplices_3::Data& data : s.data)
    announce(R"(type="Float64" Name=")" + data.name + "\"", 8 * data.values.size());
  out << "      </CellData>\n    </Piece>\n  </UnstructuredGrid>\n"
      << R"(  <AppendedData encoding="raw">_)";
  internal::write_block(out, coordinates);
  internal::write_block(out, s.simplices);
  internal::write_block(out, ends);
  internal::write_block(out, types);
  internal::write_block(out, s.input_indices);
  for (const Simplices_3::Data& data : s.data)
    internal::write_block(out, data.values);
  out << "\n  </AppendedData>\n</VTKFile>\n";
}

} // namespace files

#endif // DELAUNAY_FROM_SURFACE_3_FILES_WRITE_VTU_H
