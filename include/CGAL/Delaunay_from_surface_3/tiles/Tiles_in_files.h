// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_IN_FILES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_IN_FILES_H

// The file side of tiles, which is compiled (src/tiles): points in files, the engine out of core,
// and the work of the programs and of Python on a folder of tiles.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FILES {
/// \endcond

/*!
\ingroup PkgDelaunayFromSurface3Tiles

is a source of the points of one or several files, one after the other, which are read by ranges.
The extension determines the format: `.npy` is NumPy's, with n × 3 numbers of type `float64` or
`float32`, row by row; `.ply` is binary, with `x`, `y` and `z` of any type; `.raw`, `.bin` and
`.f64` contain only little-endian floating-point numbers of 64 bits.

It is part of the compiled library: link `Delaunay_from_surface_3::compiled`.
*/
class Point_files_3 : public Tile_source_3
{
public:
  /// reads the headers of the files.
  ///
  /// \throws Tile_files_error if a file cannot be read, has none of these formats, or does not have
  /// the size that its header says
#if defined(CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED) || defined(DOXYGEN_RUNNING)
  explicit Point_files_3(const std::vector<std::filesystem::path>& files);
#else
  template <class Files = void>
  explicit Point_files_3(const std::vector<std::filesystem::path>&)
  {
    static_assert(!std::is_void<Files>::value,
                  "CGAL::Point_files_3 is compiled: link Delaunay_from_surface_3::compiled");
  }
#endif

  /// returns the number of points of all files.
  std::uint64_t size() const override;

  /// reads a range of points, which may extend over several files.
  void read(std::uint64_t first, std::size_t n, double* coordinates) const override;

  /// returns a number derived from the sizes of the files and their times of last modification. A
  /// file that has been changed and has both as before is only recognized if one of 64 points,
  /// which are compared as well, has changed.
  std::uint64_t stamp() const override;

  /// returns the files.
  std::vector<std::filesystem::path> files() const override;

  /// returns the file of point `i`, and its position in this file.
  std::string name_of(std::uint64_t i) const override;

private:
  struct File;
  const File& file_of(std::uint64_t i) const;

  std::shared_ptr<const std::vector<File>> m_files;
  std::uint64_t m_size = 0;
};

/*!
\ingroup PkgDelaunayFromSurface3Tiles

is an engine of `delaunay_3_tiles()` that works out of core: the points that tiles keep are in
files, and only one tile per thread is in memory. The process may be killed at any moment; the next
call continues where it was. Threads share tiles like those of `Tiles_here_3`.

It is part of the compiled library: link `Delaunay_from_surface_3::compiled`.
*/
class Tiles_in_files_3
{
public:
  /// keeps the name of the folder, which `delaunay_3_tiles()` creates if necessary, and the number
  /// of threads.
#if defined(CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED) || defined(DOXYGEN_RUNNING)
  explicit Tiles_in_files_3(std::filesystem::path folder, std::size_t number_of_threads = 1);
#else
  template <class Folder = void>
  explicit Tiles_in_files_3(const std::filesystem::path&, std::size_t = 1)
  {
    static_assert(!std::is_void<Folder>::value,
                  "CGAL::Tiles_in_files_3 is compiled: link Delaunay_from_surface_3::compiled");
  }
#endif

  /// \cond SKIP_IN_MANUAL
  // Does all the work of delaunay_3_tiles().
  Tiles_report run(const Tile_source_3& source, const Tiles_options& options,
                   const std::function<void(Delaunay_3_tile&&)>& sink) const;
  /// \endcond

private:
  std::filesystem::path m_folder;
  std::size_t m_number_of_threads;
};

/// \cond SKIP_IN_MANUAL
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FILES
/// \endcond

namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FILES {

// Makes files of tiles from files of points, in one call or task by task. The folder contains
// state/, which Tiles_in_files_3 makes as well, and the results beside it.
class Tiles_to_files
{
public:
  struct Options
  {
    std::filesystem::path folder;
    std::size_t number_of_threads;
    bool with_vtu, with_neighbors;
  };

  Tiles_to_files(std::filesystem::path folder, std::size_t number_of_threads, bool with_vtu,
                 bool with_neighbors = false)
    : m_options{std::move(folder), number_of_threads, with_vtu, with_neighbors}
  {
  }

  // Begins or continues a run, and completes it.
  Tiles_report run(const Tile_source_3& source, const Tiles_options& options) const;

  // Tasks that any processes may do in any order; if the number is 0, all is done but neighbors.
  struct Tasks
  {
    std::size_t number;
    std::string stage; // what they are for
    std::uint32_t tiles;
  };

  // Begins, or closes what is done, and returns the tasks that can be done now.
  Tasks next(const Tile_source_3& source, const Tiles_options& options) const;

  // Does one of the tasks that next() has counted, with all threads.
  void do_task(const Tile_source_3& source, const Tiles_options& options, std::size_t k) const;

  // Removes the state, so that the work can begin again with other options.
  void forget() const;

private:
  Options m_options;
};

// A folder of tiles without a state, made by a run of several processes. One process calls
// begin_tiles(), all write tiles, and one calls finish_tiles(). The file tiles.begun in the folder
// marks a run that has not ended.

// Makes the folder, or refuses one with tiles of another run. If the mark is there, the files of
// the run that did not end are removed, as it may have had more tiles; without it, they are
// somebody else's. No other run can begin there as long as somebody keeps the result.
[[nodiscard]] std::shared_ptr<void> begin_tiles(const std::filesystem::path& folder,
                                                const Tile_source_3& source);
void write_tile(const std::filesystem::path& folder, const Delaunay_3_tile& tile, bool with_vtu);
void finish_tiles(const std::filesystem::path& folder, const Tiles_report& report, bool with_vtu);

// Returns whether a run of these points has ended there, judging by eight vertices of each tile.
bool tiles_have_ended(const std::filesystem::path& folder, const Tile_source_3& source);

// Returns the number of tiles of a run that has ended.
std::uint32_t number_of_tiles_in(const std::filesystem::path& folder);

// A file in which the cells of all tiles, or their neighbors, are joined. It is opened before there
// is any work to lose, and written at the end. The run must neither read nor write it otherwise.
class Joined_tiles
{
public:
  Joined_tiles(const Tile_source_3& source, const std::filesystem::path& folder,
               const std::filesystem::path& file);
  ~Joined_tiles();

  // Returns the name of the incomplete file, which a program may remove when it is interrupted.
  std::string unfinished() const;

  // Writes "cells" or "neighbors" in the order of the tiles, as one .npy, once; returns their number.
  std::uint64_t write(const char* kind = "cells");

private:
  class File;
  std::filesystem::path m_folder;
  std::unique_ptr<File> m_file;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FILES
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_IN_FILES_H
