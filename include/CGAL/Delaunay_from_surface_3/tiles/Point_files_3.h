// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_POINT_FILES_3_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_POINT_FILES_3_H

#include <CGAL/Delaunay_from_surface_3/core/order/Split_mix.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Point_file_layout.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Records.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_files_error.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_source_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL {
/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {
/// \endcond

/*!
\ingroup PkgDelaunayFromSurface3Tiles

is a source of the points of one or several files, one after the other, which are read by ranges.
The extension determines the format: `.npy` is NumPy's, with n × 3 numbers of type `float64` or
`float32`, row by row; `.ply` is binary, with `x`, `y` and `z` of any type; `.raw`, `.bin` and
`.f64` contain only little-endian floating-point numbers of 64 bits.
*/
class Point_files_3 : public Tile_source_3
{
public:
  /// reads the headers of the files.
  ///
  /// \throws Tile_files_error if a file cannot be read, has none of these formats, or does not have
  /// the size that its header says
  explicit Point_files_3(const std::vector<std::filesystem::path>& files)
  {
    for (const std::filesystem::path& file : files) {
      m_files.push_back({file, Delaunay_from_surface_3::internal::layout_of_points(file), m_size});
      m_size += m_files.back().layout.number_of_points;
    }
  }

  /// returns the number of points of all files.
  std::uint64_t size() const override { return m_size; }

  /// reads a range of points, which may extend over several files.
  void read(std::uint64_t first, std::size_t n, double* coordinates) const override
  {
    while (n > 0) {
      const File& file = file_of(first);
      const std::uint64_t i = first - file.first;
      const auto part = std::size_t((std::min)(std::uint64_t(n), file.layout.number_of_points - i));
      read(file, i, part, coordinates);
      first += part;
      coordinates += 3 * part;
      n -= part;
    }
  }

  /// returns a number derived from the sizes of the files and their times of last modification. A file
  /// that has been changed and has both as before is only recognized if one of 64 points, which are
  /// compared as well, has changed.
  std::uint64_t stamp() const override
  {
    std::uint64_t stamp = 0;
    for (const File& file : m_files) {
      std::error_code ignored;
      const auto time = std::filesystem::last_write_time(file.path, ignored).time_since_epoch();
      for (const std::uint64_t part :
           {std::uint64_t(time.count()),
            std::uint64_t(std::filesystem::file_size(file.path, ignored))})
        stamp = Delaunay_from_surface_3::internal::Split_mix(stamp ^ part)();
    }
    return stamp;
  }

  /// returns the files.
  std::vector<std::filesystem::path> files() const override
  {
    std::vector<std::filesystem::path> paths;
    for (const File& file : m_files)
      paths.push_back(file.path);
    return paths;
  }

  /// returns the file of point `i`, and its position in this file.
  std::string name_of(std::uint64_t i) const override
  {
    const File& file = file_of(i);
    return file.path.string() + ": point " + std::to_string(i - file.first);
  }

private:
  struct File
  {
    std::filesystem::path path;
    Delaunay_from_surface_3::internal::Point_file_layout layout;
    std::uint64_t first; // its first point
  };

  const File& file_of(std::uint64_t i) const
  {
    return *std::prev(
        std::upper_bound(m_files.begin(), m_files.end(), i,
                         [](std::uint64_t point, const File& file) { return point < file.first; }));
  }

  static void read(const File& file, std::uint64_t first, std::size_t n, double* coordinates)
  {
    const auto& layout = file.layout;
    Delaunay_from_surface_3::internal::Bytes_reader bytes(file.path);
    std::vector<char> items;
    const std::size_t at_once = (std::max)(std::size_t(1), (std::size_t(1) << 20) / layout.stride);
    for (std::size_t done = 0; done < n;) {
      const std::size_t part = (std::min)(n - done, at_once);
      items.resize(part * layout.stride);
      bytes.seek(layout.first + (first + done) * layout.stride);
      bytes.read(items.data(), items.size());
      for (std::size_t i = 0; i < part; ++i)
        for (std::size_t k = 0; k < 3; ++k)
          *coordinates++ = layout.number(items.data() + i * layout.stride, k);
      done += part;
    }
  }

  std::vector<File> m_files;
  std::uint64_t m_size = 0;
};

/// \cond SKIP_IN_MANUAL
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_POINT_FILES_3_H
