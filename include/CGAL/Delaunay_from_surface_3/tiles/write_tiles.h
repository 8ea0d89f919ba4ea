// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_WRITE_TILES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_WRITE_TILES_H

// The tiles as files that other programs read: for each NumPy's arrays and, if asked for, a piece
// for ParaView. Each appears when it is complete.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Delaunay_3_tile.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Point_file_layout.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Records.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

inline std::filesystem::path file_of_tile(const std::filesystem::path& folder, const char* kind,
                                          std::uint32_t tile, const char* extension)
{
  char number[16];
  std::snprintf(number, sizeof(number), "-%05u.", unsigned(tile));
  return folder / (std::string(kind) + number + extension);
}

// The head of an array with so many rows, of so many columns if there is more than one.
inline std::string head_of_npy(const std::string& type, std::uint64_t rows, std::size_t columns)
{
  std::string head = "{'descr': '" + std::string(machine_is_little_endian() ? "<" : ">") + type +
                     "', 'fortran_order': False, 'shape': (" + std::to_string(rows) + "," +
                     (columns > 1 ? " " + std::to_string(columns) : "") + "), }";
  head.append(63 - (head.size() + 10) % 64, ' ');
  head += '\n';
  const char start[] = {
      '\x93', 'N', 'U', 'M', 'P', 'Y', 1, 0, char(head.size() & 255), char(head.size() >> 8)};
  return std::string(start, sizeof(start)) + head;
}

template <class T>
void write_npy(const std::filesystem::path& file, const std::string& type, std::size_t columns,
               const std::vector<T>& rows)
{
  static_assert(std::is_trivially_copyable<T>::value, "rows are written as bytes");
  Bytes_writer to(file);
  const std::string head = head_of_npy(type, rows.size(), columns);
  to.write(head.data(), head.size());
  to.write(rows.data(), rows.size() * sizeof(T));
  to.finish();
}

using Global_cell = std::array<std::int64_t, 4>;

// The finite cells that the tile owns, by ids; a few at a time.
inline void write_cells(const std::filesystem::path& file, const Delaunay_3_tile& tile)
{
  const std::size_t n = tile.number_of_owned_finite_cells;
  Bytes_writer to(file);
  const std::string head = head_of_npy("i8", n, 4);
  to.write(head.data(), head.size());
  std::vector<Global_cell> cells((std::min)(n, std::size_t(4096)));
  for (std::size_t first = 0; first < n; first += cells.size()) {
    cells.resize((std::min)(cells.size(), n - first));
    for (std::size_t c = 0; c < cells.size(); ++c)
      for (std::size_t k = 0; k < 4; ++k)
        cells[c][k] = std::int64_t(tile.ids[std::size_t(tile.cells[first + c][k])]);
    to.write(cells.data(), cells.size() * sizeof(Global_cell));
  }
  to.finish();
}

// cells-T.npy: the finite cells that the tile owns, by ids; ids-T.npy and points-T.npy: of the
// vertices of these cells, and of its own; cells last.
inline void write_tile_as_arrays(const std::filesystem::path& folder, const Delaunay_3_tile& tile)
{
  write_npy(file_of_tile(folder, "ids", tile.number, "npy"), "i8", 1, tile.ids);
  write_npy(file_of_tile(folder, "points", tile.number, "npy"), "f8", 3, tile.points);
  write_cells(file_of_tile(folder, "cells", tile.number, "npy"), tile);
}

// tile-T.vtu: the same cells, for VTK and ParaView.
inline void write_tile_as_vtu(const std::filesystem::path& folder, const Delaunay_3_tile& tile)
{
  const std::size_t n = tile.ids.size(), m = tile.number_of_owned_finite_cells;
  std::vector<std::int64_t> offsets(m);
  for (std::size_t c = 0; c < m; ++c)
    offsets[c] = std::int64_t(4 * (c + 1));
  const std::vector<std::uint8_t> types(m, 10); // VTK_TETRA
  const std::uint64_t sizes[] = {24 * n, 8 * n, 16 * m, 8 * m, m};
  std::uint64_t begins[6] = {};
  for (int k = 0; k < 5; ++k)
    begins[k + 1] = begins[k] + 8 + sizes[k];
  const auto array = [&](const char* type, const char* attributes, int k) {
    return R"(<DataArray type=")" + std::string(type) + R"(" )" + attributes +
           R"( format="appended" offset=")" + std::to_string(begins[k]) + "\"/>\n";
  };
  const std::string text =
      std::string("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
                  "byte_order=\"") +
      (machine_is_little_endian() ? "LittleEndian" : "BigEndian") +
      "\" header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
      std::to_string(n) + "\" NumberOfCells=\"" + std::to_string(m) +
      "\">\n<PointData GlobalIds=\"id\">\n" + array("Int64", "Name=\"id\"", 1) +
      "</PointData>\n<Points>\n" + array("Float64", "NumberOfComponents=\"3\"", 0) +
      "</Points>\n<Cells>\n" + array("Int32", "Name=\"connectivity\"", 2) +
      array("Int64", "Name=\"offsets\"", 3) + array("UInt8", "Name=\"types\"", 4) +
      "</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
  Bytes_writer to(file_of_tile(folder, "tile", tile.number, "vtu"));
  to.write(text.data(), text.size());
  const void* const data[] = {tile.points.data(), tile.ids.data(), tile.cells.data(),
                              offsets.data(), types.data()};
  for (int k = 0; k < 5; ++k) {
    to.write(&sizes[k], 8);
    to.write(data[k], std::size_t(sizes[k]));
  }
  const std::string end = "\n</AppendedData>\n</VTKFile>\n";
  to.write(end.data(), end.size());
  to.finish();
}

inline void write_text(const std::filesystem::path& file, const std::string& text)
{
  Bytes_writer to(file);
  to.write(text.data(), text.size());
  to.finish();
}

// tiles.pvtu: all of these.
inline void write_pvtu(const std::filesystem::path& folder, std::uint32_t number_of_tiles)
{
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\">\n"
      "<PUnstructuredGrid GhostLevel=\"0\">\n<PPointData GlobalIds=\"id\">\n"
      "<PDataArray type=\"Int64\" Name=\"id\"/>\n</PPointData>\n<PPoints>\n"
      "<PDataArray type=\"Float64\" NumberOfComponents=\"3\"/>\n</PPoints>\n";
  for (std::uint32_t t = 0; t < number_of_tiles; ++t)
    text += "<Piece Source=\"" + file_of_tile("", "tile", t, "vtu").string() + "\"/>\n";
  write_text(folder / "tiles.pvtu", text + "</PUnstructuredGrid>\n</VTKFile>\n");
}

// tiles.json: what was done. That it is there says that all is done.
inline void write_report(const std::filesystem::path& folder, const Tiles_report& report)
{
  char hash[20];
  std::snprintf(hash, sizeof(hash), "%016llx", static_cast<unsigned long long>(report.hash));
  const auto line = [](const char* key, const std::string& value) {
    return "  \"" + std::string(key) + "\": " + value + ",\n";
  };
  write_text(folder / "tiles.json",
             "{\n" + line("points", std::to_string(report.points)) +
                 line("tiles", std::to_string(report.tiles)) +
                 line("rounds", std::to_string(report.rounds)) +
                 line("told", std::to_string(report.told)) +
                 line("kept", std::to_string(report.kept)) +
                 line("most_kept", std::to_string(report.most_kept)) +
                 line("cells", std::to_string(report.cells)) +
                 line("hash", "\"" + std::string(hash) + "\"") +
                 "  \"certified\": " + (report.is_certified ? "true" : "false") + "\n}\n");
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_WRITE_TILES_H
