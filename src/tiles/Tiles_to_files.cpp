// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED
#define CGAL_DELAUNAY_FROM_SURFACE_3_LIBRARY

// Writes tiles as files that other programs read, with the neighbors of their cells, and joins them
// in one file; and does runs in a folder, in one call or task by task.

#include "Records.h"
#include "Tile_folder.h"
#include "Tiles_stages.h"

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Split_mix.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Thread_executor.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_in_files.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_in_memory.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {
namespace {

// Each tile is written as files that other programs read: arrays of NumPy and, if asked for, a
// piece for ParaView. Each file appears when it is complete.

std::filesystem::path file_of_tile(const std::filesystem::path& folder, const char* kind,
                                   std::uint32_t tile, const char* extension)
{
  char number[16];
  std::snprintf(number, sizeof(number), "-%05u.", unsigned(tile));
  return folder / (std::string(kind) + number + extension);
}

// Returns the head of an array with so many rows and columns; one column makes a flat array.
std::string head_of_npy(const std::string& type, std::uint64_t rows, std::size_t columns)
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

// Writes the finite cells that the tile owns, by ids; a few at a time.
void write_cells(const std::filesystem::path& file, const Delaunay_3_tile& tile)
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

// Writes ids-T.npy and points-T.npy, with the vertices of the stars of own points, and cells-T.npy
// last, with the finite cells that the tile owns, by ids.
void write_tile_as_arrays(const std::filesystem::path& folder, const Delaunay_3_tile& tile)
{
  write_npy(file_of_tile(folder, "ids", tile.number, "npy"), "i8", 1, tile.ids);
  write_npy(file_of_tile(folder, "points", tile.number, "npy"), "f8", 3, tile.points);
  write_cells(file_of_tile(folder, "cells", tile.number, "npy"), tile);
}

// Writes tile-T.vtu: the same cells, for VTK and ParaView.
void write_tile_as_vtu(const std::filesystem::path& folder, const Delaunay_3_tile& tile)
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

void write_text(const std::filesystem::path& file, const std::string& text)
{
  Bytes_writer to(file);
  to.write(text.data(), text.size());
  to.finish();
}

// Writes tiles.pvtu, which refers to all of these.
void write_pvtu(const std::filesystem::path& folder, std::uint32_t number_of_tiles)
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

// Writes tiles.json, the report. If this file exists, all is done.
void write_report(const std::filesystem::path& folder, const Tiles_report& report)
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

// The arrays of all tiles are joined in one.

// The array of a tile, to be read from its first row on.
class Npy_reader : public Bytes_reader
{
public:
  explicit Npy_reader(const std::filesystem::path& file,
                      std::size_t bytes_of_row = sizeof(Global_cell))
    : Bytes_reader(file)
    , m_bytes_of_row(bytes_of_row)
  {
    const Npy_head head = read_head_of_npy(*this);
    m_first = head.end;
    m_rows = std::strtoull(value_of_key(head.text, "shape", ",").c_str(), nullptr, 10);
    if (size_of_file(file) != m_first + m_rows * bytes_of_row)
      refuse_file(file, "has another size than its head says");
  }

  std::uint64_t rows() const { return m_rows; }
  void read_row(std::uint64_t k, void* row)
  {
    seek(m_first + k * m_bytes_of_row);
    read(row, m_bytes_of_row);
  }

private:
  const std::size_t m_bytes_of_row;
  std::uint64_t m_first, m_rows;
};

// Returns a number from the report of a run that has ended.
std::uint64_t value_in_report(const std::filesystem::path& folder, const std::string& name)
{
  const auto place = folder / "tiles.json";
  if (!std::filesystem::exists(place))
    throw Tile_files_error(folder.string() + ": has no tiles.json: no run has ended there");
  std::string text(std::size_t(size_of_file(place)), ' ');
  Bytes_reader(place).read(text.data(), text.size());
  const std::string key = "\"" + name + "\": ";
  const std::size_t at = text.find(key);
  if (at == std::string::npos)
    refuse_file(place, "does not say how many " + name + " there are");
  return std::strtoull(text.c_str() + at + key.size(), nullptr, 10);
}

// Writes the cells of so many tiles, or their neighbors, in the order of the tiles, as one .npy.
// Returns how many cells there are.
std::uint64_t join_tiles(const std::filesystem::path& folder, std::uint32_t tiles, const char* kind,
                         Bytes_writer& to)
{
  std::uint64_t rows = 0;
  for (std::uint32_t t = 0; t < tiles; ++t)
    rows += Npy_reader(file_of_tile(folder, kind, t, "npy")).rows();
  const std::string head = head_of_npy("i8", rows, 4);
  to.write(head.data(), head.size());
  std::vector<Global_cell> some(65536);
  for (std::uint32_t t = 0; t < tiles; ++t) {
    Npy_reader from(file_of_tile(folder, kind, t, "npy"));
    for (std::uint64_t left = from.rows(); left > 0;) {
      const std::size_t n = std::size_t((std::min)(left, std::uint64_t(some.size())));
      from.read(some.data(), n * sizeof(Global_cell));
      to.write(some.data(), n * sizeof(Global_cell));
      left -= n;
    }
  }
  to.finish();
  return rows;
}

// The neighbours of the cells of all tiles, by global numbers: cells are numbered consecutively, in
// the order of the tiles. The neighbour of a cell may belong to another tile, and neither tile need
// know the other cell; so facets with only one cell in a tile are matched by the hash of their
// vertices, in as many parts as there are tiles. Linear, except for sorting.
//
// Tasks are done in three stages. Those of one stage may be done in any order, and repeated.

class Tile_neighbors
{
public:
  // Refers to the tiles in `folder`. Intermediate files go to a folder inside of `state`.
  Tile_neighbors(std::filesystem::path folder, const std::filesystem::path& state,
                 std::uint32_t number_of_tiles)
    : m_folder(std::move(folder))
    , m_state(state / "neighbors")
    , m_tiles(number_of_tiles)
  {
    m_first.push_back(0);
    for (std::uint32_t t = 0; t < m_tiles; ++t)
      m_first.push_back(m_first.back() +
                        Npy_reader(file_of_tile(m_folder, "cells", t, "npy")).rows());
  }

  // Writes neighbors-T.npy of all tiles: the numbers of the cells opposite to the vertices, or -1.
  void run(const Executor& executor) const
  {
    std::uint32_t done = 0;
    while (done < m_tiles && is_done(done))
      ++done;
    if (done == m_tiles) {
      std::filesystem::remove_all(m_state.place());
      return;
    }
    std::filesystem::create_directories(m_state.place());
    const auto run_stage = [&](void (Tile_neighbors::*task)(std::uint32_t) const) {
      run_tasks(executor, m_tiles, [&](std::size_t t) { (this->*task)(std::uint32_t(t)); });
    };
    run_stage(&Tile_neighbors::match_inside);
    run_stage(&Tile_neighbors::match_between);
    run_stage(&Tile_neighbors::write);
    std::filesystem::remove_all(m_state.place());
  }

private:
  static constexpr std::int64_t none = -1;

  // The facet of cell slot / 4 opposite to vertex slot % 4; vertices are in ascending order.
  struct Facet
  {
    std::array<std::int64_t, 3> vertices;
    std::uint64_t slot;

    friend bool operator<(const Facet& f, const Facet& g) { return f.vertices < g.vertices; }
  };
  struct Neighbor
  {
    std::uint64_t slot;
    std::int64_t cell;
  };

  bool is_done(std::uint32_t t) const
  {
    return std::filesystem::exists(file_of_tile(m_folder, "neighbors", t, "npy"));
  }

  std::vector<Facet> sorted_facets(std::uint32_t t) const
  {
    Npy_reader from(file_of_tile(m_folder, "cells", t, "npy"));
    std::vector<Global_cell> cells(std::size_t(from.rows()));
    from.read(cells.data(), cells.size() * sizeof(Global_cell));
    std::vector<Facet> facets;
    facets.reserve(4 * cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c)
      for (unsigned k = 0; k < 4; ++k) {
        facets.push_back({{cells[c][k ^ 1], cells[c][k ^ 2], cells[c][k ^ 3]}, 4 * c + k});
        std::sort(facets.back().vertices.begin(), facets.back().vertices.end());
      }
    std::sort(facets.begin(), facets.end());
    return facets;
  }

  // Calls two(f, g) for each two equal ones of sorted facets, and one(f) for the others.
  template <class Two, class One>
  static void match(const std::vector<Facet>& facets, const Two& two, const One& one)
  {
    for (std::size_t i = 0; i < facets.size(); ++i)
      if (i + 1 < facets.size() && facets[i].vertices == facets[i + 1].vertices) {
        two(facets[i], facets[i + 1]);
        ++i;
      } else {
        one(facets[i]);
      }
  }

  std::uint32_t part_of(const Facet& facet) const
  {
    std::uint64_t h = 0;
    for (const std::int64_t v : facet.vertices)
      h = Split_mix(h ^ std::uint64_t(v))();
    return std::uint32_t(h % m_tiles);
  }
  std::uint32_t tile_of(std::uint64_t slot) const
  {
    return std::uint32_t(std::upper_bound(m_first.begin(), m_first.end(), slot / 4) -
                         m_first.begin() - 1);
  }

  void match_inside(std::uint32_t t) const
  {
    if (std::filesystem::exists(m_state.file("inside", t)))
      return;
    std::vector<Facet> open;
    std::vector<std::int64_t> neighbors(std::size_t(4 * (m_first[t + 1] - m_first[t])), none);
    match(
        sorted_facets(t),
        [&](const Facet& f, const Facet& g) {
          neighbors[std::size_t(f.slot)] = std::int64_t(m_first[t] + g.slot / 4);
          neighbors[std::size_t(g.slot)] = std::int64_t(m_first[t] + f.slot / 4);
        },
        [&](const Facet& f) {
          open.push_back({f.vertices, f.slot + 4 * m_first[t]});
        });
    m_state.write_parts(
        open, m_tiles, [&](const Facet& f) { return part_of(f); }, "open", t);
    m_state.write(neighbors, "inside", t);
  }

  void match_between(std::uint32_t part) const
  {
    if (std::filesystem::exists(m_state.file("between", part)))
      return;
    std::vector<Facet> facets;
    for (std::uint32_t t = 0; t < m_tiles; ++t)
      m_state.append_part("open", t, part, facets);
    std::sort(facets.begin(), facets.end());
    std::vector<Neighbor> pairs;
    match(
        facets,
        [&](const Facet& f, const Facet& g) {
          pairs.push_back({f.slot, std::int64_t(g.slot / 4)});
          pairs.push_back({g.slot, std::int64_t(f.slot / 4)});
        },
        [](const Facet&) {}); // facets of the convex hull
    m_state.write_parts(
        pairs, m_tiles, [&](const Neighbor& n) { return tile_of(n.slot); }, "between", part);
  }

  void write(std::uint32_t t) const
  {
    if (is_done(t))
      return;
    auto neighbors = m_state.read<std::vector<std::int64_t>>("inside", t);
    std::vector<Neighbor> pairs;
    for (std::uint32_t part = 0; part < m_tiles; ++part)
      m_state.append_part("between", part, t, pairs);
    for (const Neighbor& n : pairs)
      neighbors[std::size_t(n.slot - 4 * m_first[t])] = n.cell;
    std::vector<Global_cell> rows(neighbors.size() / 4);
    for (std::size_t i = 0; i < neighbors.size(); ++i)
      rows[i / 4][i % 4] = neighbors[i];
    write_npy(file_of_tile(m_folder, "neighbors", t, "npy"), "i8", 4, rows);
  }

  const std::filesystem::path m_folder;
  const Tile_folder m_state;
  const std::uint32_t m_tiles;
  std::vector<std::uint64_t> m_first; // by tile: the number of its first cell
};

// The work of one call in a folder.
class Folder_work
{
public:
  explicit Folder_work(const Tiles_to_files::Options& options)
    : m_folder(options.folder)
    , m_engine(m_folder, options.number_of_threads)
    , m_with_vtu(options.with_vtu)
    , m_with_neighbors(options.with_neighbors)
  {
  }

  // Begins or continues a run, and completes it.
  Tiles_report run(const Tile_source_3& source, const Tiles_options& options)
  {
    const Folder_lock lock(m_folder, Folder_lock::ALONE);
    refuse_other_tiles(source);
    const auto write = [&](const Tiles_report& report) {
      write_all(options);
      if (m_with_neighbors)
        Tile_neighbors(m_folder, m_folder / "state", report.tiles).run(m_engine.executor());
      return finish();
    };
    return run_until_certified(m_engine, source, options, write);
  }

  Tiles_to_files::Tasks next(const Tile_source_3& source, const Tiles_options& options)
  {
    const Folder_lock lock(m_folder, Folder_lock::SHARED);
    refuse_other_tiles(source);
    const Folder_lock turn(m_folder / "state", Folder_lock::IN_TURN); // others close stages, too
    try {
      const std::size_t n = close_and_count(source, options);
      return {n, name(), m_engine.number_of_tiles()};
    } catch (const Surface_input_error&) {
      m_engine.forget(); // the next input is another
      throw;
    }
  }

  void do_task(const Tile_source_3& source, const Tiles_options& options, std::size_t k)
  {
    const Folder_lock lock(m_folder, Folder_lock::SHARED);
    refuse_other_tiles(source);
    {
      // Whoever begins the state has it alone.
      const auto is_there = [&] { return std::filesystem::exists(m_folder / "state" / "input"); };
      std::optional<Folder_lock> turn(std::in_place, m_folder / "state",
                                      Folder_lock::SHARED_IN_TURN);
      if (!is_there()) {
        turn.reset();
        turn.emplace(m_folder / "state", Folder_lock::IN_TURN);
      }
      m_engine.find(source, options, 1);
    }
    const bool writes = m_engine.stage() == Tiles_in_files::DONE;
    const std::size_t n = writes ? m_engine.number_of_tiles() : m_engine.number_of_tasks();
    if (k >= n)
      throw Tile_files_error(m_folder.string() + ": there are tasks 0 to " + std::to_string(n - 1) +
                             " only");
    if (writes)
      write(std::uint32_t(k));
    else
      m_engine.do_task(k, threads_of_task(0, 1, m_engine.executor().number_of_workers()));
  }

private:
  std::string name()
  {
    return m_engine.stage() == Tiles_in_files::DONE ? "writing" : m_engine.name();
  }

  // For single tasks: one of them is in memory, and has all threads.
  std::size_t close_and_count(const Tile_source_3& source, const Tiles_options& options)
  {
    m_engine.find(source, options, 1);
    if (m_engine.stage() != Tiles_in_files::DONE && m_engine.is_all_done()) {
      const bool was_pieces = m_engine.stage() == Tiles_in_files::PIECES;
      m_engine.close();
      if (was_pieces && m_engine.stage() == Tiles_in_files::PIECES)
        repair();
    }
    if (m_engine.stage() != Tiles_in_files::DONE)
      return m_engine.number_of_tasks();
    for (std::uint32_t t = 0; t < m_engine.number_of_tiles(); ++t)
      if (!is_written(t))
        return m_engine.number_of_tiles();
    m_engine.clean(); // the process that closed the last stage may have been killed before
    finish();
    return 0;
  }

  void repair()
  {
    const Tile_pairs differing = tiles_that_differ(m_engine.certificates());
    if (differing.empty())
      throw std::runtime_error(tiles_do_not_fit);
    m_engine.show(differing);
  }

  // Throws if tiles are there without a state: they are of another run, but would be taken for
  // tiles that this one has written.
  void refuse_other_tiles(const Tile_source_3& source) const
  {
    refuse_to_overwrite(source, m_folder);
    if (std::filesystem::exists(m_folder / "state" / "input"))
      return;
    if (std::filesystem::exists(m_folder / "tiles.json"))
      refuse_file_of_others(m_folder / "tiles.json");
    const auto others = files_in(m_folder, [](const std::string& name) {
      return name != "tiles.begun" && may_be_file_of_run(name);
    });
    if (!others.empty())
      refuse_file_of_others(others.front());
  }

  bool is_written(std::uint32_t t) const
  {
    return std::filesystem::exists(file_of_tile(m_folder, "cells", t, "npy")) &&
           (!m_with_vtu || std::filesystem::exists(file_of_tile(m_folder, "tile", t, "vtu")));
  }

  void write(std::uint32_t t)
  {
    const std::filesystem::path piece = m_engine.folder().file("piece", t);
    if (!is_written(t)) {
      if (std::filesystem::exists(piece))
        write_tile(m_folder, m_engine.folder().read_piece(t), m_with_vtu);
      else if (!is_written(t)) // another process may have written it, and removed the piece
        throw Tile_files_error(m_folder.string() +
                               ": a tile has been removed, or tiles are written "
                               "without .vtu: remove it, or name another folder");
    }
    std::error_code ignored; // it will not be asked for again
    std::filesystem::remove(piece, ignored);
  }

  void write_all(const Tiles_options& options)
  {
    const std::size_t n = m_engine.number_of_tiles();
    const Stage_progress progress(options.progress, "writing", n);
    run_tasks(m_engine.executor(), n, [&](std::size_t t) {
      write(std::uint32_t(t));
      progress.tell_next();
    });
  }

  Tiles_report finish() const
  {
    Tiles_report report;
    report.points = m_engine.number_of_points();
    report.tiles = m_engine.number_of_tiles();
    report.rounds = m_engine.rounds();
    report.told = m_engine.told();
    report_certificates(m_engine.certificates(), report);
    if (m_with_vtu)
      write_pvtu(m_folder, report.tiles);
    remove_left();
    write_report(m_folder, report);
    return report;
  }

  // Removes the files that killed processes left; the state is this run's own.
  void remove_left() const
  {
    const auto is_left = [](const std::string& name) { return !name_when_finished(name).empty(); };
    std::error_code ignored; // such files do no harm
    for (const auto& left :
         {files_in(m_folder, is_left_by_run), files_in(m_folder / "state", is_left)})
      for (const auto& path : left)
        std::filesystem::remove(path, ignored);
  }

  const std::filesystem::path m_folder;
  Tiles_in_files m_engine;
  const bool m_with_vtu, m_with_neighbors;
};

// Returns the file that marks a folder without a state as long as a run has not ended there.
std::filesystem::path mark_of_run(const std::filesystem::path& folder)
{
  return folder / "tiles.begun";
}

} // namespace
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM

inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FILES {

Tiles_report Tiles_to_files::run(const Tile_source_3& source, const Tiles_options& options) const
{
  return Folder_work(m_options).run(source, options);
}

Tiles_to_files::Tasks Tiles_to_files::next(const Tile_source_3& source,
                                           const Tiles_options& options) const
{
  return Folder_work(m_options).next(source, options);
}

void Tiles_to_files::do_task(const Tile_source_3& source, const Tiles_options& options,
                             std::size_t k) const
{
  Folder_work(m_options).do_task(source, options, k);
}

void Tiles_to_files::forget() const
{
  forget_folder(m_options.folder / "state");
}

std::shared_ptr<void> begin_tiles(const std::filesystem::path& folder, const Tile_source_3& source)
{
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    fail_to_write(folder, error.value());
  auto lock = std::make_shared<Folder_lock>(folder, Folder_lock::ALONE);
  for (const auto& file : {folder / "tiles.json", folder / "state" / "input"})
    if (std::filesystem::exists(file))
      throw Tile_files_error(file.string() +
                             ": is of another run: remove it, or name another folder");
  refuse_to_overwrite(source, folder);
  const std::vector<std::filesystem::path> files =
      files_in(folder, [](const std::string& name) { // of an earlier run
        return is_file_of_tiles(name) || is_left_by_run(name);
      });
  if (!files.empty() && !std::filesystem::exists(mark_of_run(folder)))
    throw Tile_files_error(files.front().string() +
                           ": is not of a run that was stopped here: remove all files of "
                           "tiles, or name another folder");
  for (const auto& file : files)
    if (!std::filesystem::remove(file, error) && error)
      fail_to_write(file, error.value());
  errno = 0;
  std::FILE* const mark =
      std::fopen(mark_of_run(folder).string().c_str(), "wbx"); // no link to others
  if (mark != nullptr)
    std::fclose(mark);
  else if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(mark_of_run(folder))))
    fail_to_write(mark_of_run(folder), errno);
  return lock;
}

void write_tile(const std::filesystem::path& folder, const Delaunay_3_tile& tile, bool with_vtu)
{
  if (with_vtu)
    write_tile_as_vtu(folder, tile);
  write_tile_as_arrays(folder, tile);
}

void finish_tiles(const std::filesystem::path& folder, const Tiles_report& report, bool with_vtu)
{
  if (with_vtu)
    write_pvtu(folder, report.tiles);
  write_report(folder, report);
  std::error_code ignored; // a superfluous mark does no harm
  std::filesystem::remove(mark_of_run(folder), ignored);
}

bool tiles_have_ended(const std::filesystem::path& folder, const Tile_source_3& source)
{
  if (!std::filesystem::exists(folder / "tiles.json"))
    return false;
  const std::uint32_t tiles = number_of_tiles_in(folder);
  for (std::uint32_t t = 0; t < tiles; ++t) {
    Npy_reader ids(file_of_tile(folder, "ids", t, "npy"), 8);
    Npy_reader points(file_of_tile(folder, "points", t, "npy"), 24);
    for (std::uint64_t k = 0; k < 8 && ids.rows() > 0; ++k) {
      const std::uint64_t row = (ids.rows() - 1) * k / 7;
      std::int64_t id = 0;
      std::array<double, 3> point, expected;
      ids.read_row(row, &id);
      points.read_row(row, point.data());
      if (std::uint64_t(id) >= source.size())
        return false;
      source.read(std::uint64_t(id), 1, expected.data());
      if (point != expected)
        return false;
    }
  }
  return value_in_report(folder, "points") == source.size();
}

std::uint32_t number_of_tiles_in(const std::filesystem::path& folder)
{
  return std::uint32_t(value_in_report(folder, "tiles"));
}

class Joined_tiles::File : public Bytes_writer
{
public:
  using Bytes_writer::Bytes_writer;
};

Joined_tiles::Joined_tiles(const Tile_source_3& source, const std::filesystem::path& folder,
                           const std::filesystem::path& file)
  : m_folder(folder)
{
  refuse_output(source, folder, file);
  std::error_code ignored; // it may hold the file, whose opening reports what is wrong
  std::filesystem::create_directories(folder, ignored);
  m_file = std::make_unique<File>(file);
}

Joined_tiles::~Joined_tiles() = default;

std::string Joined_tiles::unfinished() const
{
  return m_file->unfinished_place().string();
}

std::uint64_t Joined_tiles::write(const char* kind)
{
  return join_tiles(m_folder, number_of_tiles_in(m_folder), kind, *m_file);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FILES
} // namespace core
} // namespace Delaunay_from_surface_3

inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FILES {

Tiles_in_files_3::Tiles_in_files_3(std::filesystem::path folder, std::size_t number_of_threads)
  : m_folder(std::move(folder))
  , m_number_of_threads(number_of_threads)
{
}

Tiles_report Tiles_in_files_3::run(const Tile_source_3& source, const Tiles_options& options,
                                   const std::function<void(Delaunay_3_tile&&)>& sink) const
{
  using namespace Delaunay_from_surface_3::core;
  const Folder_lock lock(m_folder, Folder_lock::ALONE);
  Tiles_in_files engine(m_folder, m_number_of_threads);
  return run_until_certified(engine, source, options, [&](const Tiles_report& report) {
    for (std::uint32_t t = 0; t < report.tiles; ++t)
      sink(engine.folder().read_piece(t));
    return report;
  });
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FILES
} // namespace CGAL
