// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED
#define CGAL_DELAUNAY_FROM_SURFACE_3_LIBRARY

// Points in files: finds the coordinates in a .npy, .ply or raw file, and reads ranges of them.

#include "Records.h"

#include <CGAL/Delaunay_from_surface_3/core/order/Split_mix.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_in_files.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class T>
double number_at(const char* bytes, bool is_swapped)
{
  char copy[sizeof(T)];
  std::memcpy(copy, bytes, sizeof(T));
  if (is_swapped)
    std::reverse(copy, copy + sizeof(T));
  T number;
  std::memcpy(&number, copy, sizeof(T));
  return double(number);
}

// The types of numbers, by their names in a .ply.
struct Number_type
{
  const char *name, *other_name;
  std::size_t size;
  double (*at)(const char* bytes, bool is_swapped);
};
constexpr Number_type number_types[] = {{"char", "int8", 1, number_at<std::int8_t>},
                                        {"uchar", "uint8", 1, number_at<std::uint8_t>},
                                        {"short", "int16", 2, number_at<std::int16_t>},
                                        {"ushort", "uint16", 2, number_at<std::uint16_t>},
                                        {"int", "int32", 4, number_at<std::int32_t>},
                                        {"uint", "uint32", 4, number_at<std::uint32_t>},
                                        {"float", "float32", 4, number_at<float>},
                                        {"double", "float64", 8, number_at<double>}};
constexpr const Number_type *float32 = number_types + 6, *float64 = number_types + 7;

struct Point_file_layout
{
  std::uint64_t number_of_points = 0, first = 0; // the latter: offset of the first point, in bytes
  std::size_t stride = 24;                       // bytes from a point to the next
  std::array<std::size_t, 3> offsets = {0, 8, 16};
  std::array<const Number_type*, 3> types = {float64, float64, float64};
  bool is_swapped = !machine_is_little_endian();

  // Returns coordinate k of a point.
  double number(const char* point, std::size_t k) const
  {
    return types[k]->at(point + offsets[k], is_swapped);
  }
};

inline Point_file_layout layout_of_npy(const std::filesystem::path& file)
{
  Bytes_reader from(file);
  const auto [head, first] = read_head_of_npy(from);
  Point_file_layout layout;
  const std::string type = value_of_key(head, "descr", ",}");
  const bool is_float = type == "<f4" || type == ">f4";
  if (!is_float && type != "<f8" && type != ">f8")
    refuse_file(file, "numbers of type '" + type + "': float64 and float32 are read");
  if (value_of_key(head, "fortran_order", ",}") != "False")
    refuse_file(file, "its array is stored column by column: store it row by row (order='C')");
  const std::string shape = value_of_key(head, "shape", ")");
  char* comma = nullptr; // not by a stream: in a library of a wheel these may know no numbers
  layout.number_of_points = std::strtoull(shape.c_str(), &comma, 10);
  if (comma == shape.c_str() || std::string(comma) != ",3")
    refuse_file(file, "an array of shape (" + shape + "): n × 3 numbers are needed");
  layout.first = first;
  layout.stride = is_float ? 12 : 24;
  layout.offsets = {0, layout.stride / 3, layout.stride / 3 * 2};
  layout.types.fill(is_float ? float32 : float64);
  layout.is_swapped = (type[0] == '<') != machine_is_little_endian();
  return layout;
}

// Reads the head of a .ply, line by line.
class Ply_head
{
public:
  explicit Ply_head(const std::filesystem::path& file)
    : m_file(file)
    , m_stream(file, std::ios::binary)
  {
    if (next_line() != "ply")
      refuse_file(file, "no .ply: the first line is another");
    while (next_line() != "end_header")
      read_line();
    if (!m_is_binary)
      refuse_file(file, "a .ply in text: binary ones are read");
    if (!m_has_vertices)
      refuse_file(file, "it has no vertices");
    if (!m_has[0] || !m_has[1] || !m_has[2])
      refuse_file(file, "its vertices have no x, y, z");
    m_layout.first = std::uint64_t(m_stream.tellg()) + m_before;
  }

  const Point_file_layout& layout() const { return m_layout; }

private:
  const std::string& next_line()
  {
    if (!std::getline(m_stream, m_line) || m_line.size() > 4096)
      refuse_file(m_file, "its head has no end");
    if (!m_line.empty() && m_line.back() == '\r')
      m_line.pop_back();
    return m_line;
  }

  void read_line()
  {
    std::size_t at = 0;
    const auto take_word = [&] {
      const std::size_t first = (std::min)(m_line.find_first_not_of(" \t", at), m_line.size());
      at = (std::min)(m_line.find_first_of(" \t", first), m_line.size());
      return m_line.substr(first, at - first);
    };
    const std::string keyword = take_word(), word = take_word(), name = take_word();
    if (keyword == "format") {
      m_is_binary = word != "ascii";
      m_layout.is_swapped = (word == "binary_little_endian") != machine_is_little_endian();
    } else if (keyword == "element") {
      end_element();
      ++m_elements;
      m_is_vertex = word == "vertex";
      m_count = std::strtoull(name.c_str(), nullptr, 10);
      m_stride = 0;
    } else if (keyword == "property" && !m_is_over) {
      read_property(word, name);
    }
  }

  // Elements before the vertices are skipped, and elements after them are ignored.
  void end_element()
  {
    m_is_over = m_is_over || m_is_vertex;
    if (m_elements > 0 && !m_is_over)
      m_before += (std::min)(m_count, std::uint64_t(1) << 48) * m_stride; // no file is longer
  }

  void read_property(const std::string& type, const std::string& name)
  {
    if (type == "list")
      refuse_file(m_file, "lists in its vertices, or before them, are not read");
    const Number_type& t = type_of(type);
    const std::size_t k = name == "x" ? 0 : name == "y" ? 1 : name == "z" ? 2 : 3;
    if (m_is_vertex && k < 3) {
      m_has[k] = true;
      m_layout.offsets[k] = m_stride;
      m_layout.types[k] = &t;
    }
    m_stride += t.size;
    if (m_is_vertex) {
      m_has_vertices = true;
      m_layout.stride = m_stride;
      m_layout.number_of_points = m_count;
    }
  }

  const Number_type& type_of(const std::string& name) const
  {
    for (const Number_type& type : number_types)
      if (name == type.name || name == type.other_name)
        return type;
    refuse_file(m_file, "'" + name + "' is no type of a .ply");
  }

  const std::filesystem::path m_file;
  std::ifstream m_stream;
  std::string m_line;
  Point_file_layout m_layout;
  bool m_is_binary = false, m_is_vertex = false, m_is_over = false, m_has_vertices = false;
  std::array<bool, 3> m_has = {};
  std::size_t m_elements = 0, m_stride = 0;
  std::uint64_t m_count = 0, m_before = 0;
};

inline Point_file_layout layout_of_points(const std::filesystem::path& file)
{
  const std::uint64_t size = size_of_file(file);
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  Point_file_layout layout;
  if (extension == ".npy") {
    layout = layout_of_npy(file);
  } else if (extension == ".ply") {
    layout = Ply_head(file).layout();
  } else if (extension == ".raw" || extension == ".bin" || extension == ".f64") {
    if (size % 24 != 0)
      refuse_file(file, "its size is no multiple of 24 bytes, three numbers of 64 bits");
    layout.number_of_points = size / 24;
  } else {
    refuse_file(file, "unknown extension; .npy, .ply, .raw, .bin and .f64 are read");
  }
  const std::uint64_t most = size < layout.first ? 0 : (size - layout.first) / layout.stride;
  if (layout.number_of_points > most)
    refuse_file(file, "ends early: it should have " + std::to_string(layout.number_of_points) +
                          " points, and has room for " + std::to_string(most));
  const std::uint64_t end = layout.first + layout.number_of_points * layout.stride;
  if (extension == ".npy" && size != end)
    refuse_file(file, "has " + std::to_string(size) + " bytes, where its head says " +
                          std::to_string(end));
  return layout;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3

inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FILES {

struct Point_files_3::File
{
  std::filesystem::path path;
  Delaunay_from_surface_3::core::Point_file_layout layout;
  std::uint64_t first; // id of its first point

  void read(std::uint64_t begin, std::size_t n, double* coordinates) const
  {
    Delaunay_from_surface_3::core::Bytes_reader bytes(path);
    std::vector<char> items;
    const std::size_t at_once = (std::max)(std::size_t(1), (std::size_t(1) << 20) / layout.stride);
    for (std::size_t done = 0; done < n;) {
      const std::size_t part = (std::min)(n - done, at_once);
      items.resize(part * layout.stride);
      bytes.seek(layout.first + (begin + done) * layout.stride);
      bytes.read(items.data(), items.size());
      for (std::size_t i = 0; i < part; ++i)
        for (std::size_t k = 0; k < 3; ++k)
          *coordinates++ = layout.number(items.data() + i * layout.stride, k);
      done += part;
    }
  }
};

Point_files_3::Point_files_3(const std::vector<std::filesystem::path>& files)
{
  std::vector<File> all;
  for (const std::filesystem::path& file : files) {
    all.push_back({file, Delaunay_from_surface_3::core::layout_of_points(file), m_size});
    m_size += all.back().layout.number_of_points;
  }
  m_files = std::make_shared<const std::vector<File>>(std::move(all));
}

std::uint64_t Point_files_3::size() const
{
  return m_size;
}

void Point_files_3::read(std::uint64_t first, std::size_t n, double* coordinates) const
{
  while (n > 0) {
    const File& file = file_of(first);
    const std::uint64_t i = first - file.first;
    const auto part = std::size_t((std::min)(std::uint64_t(n), file.layout.number_of_points - i));
    file.read(i, part, coordinates);
    first += part;
    coordinates += 3 * part;
    n -= part;
  }
}

std::uint64_t Point_files_3::stamp() const
{
  std::uint64_t stamp = 0;
  for (const File& file : *m_files) {
    std::error_code ignored;
    const auto time = std::filesystem::last_write_time(file.path, ignored).time_since_epoch();
    for (const std::uint64_t part : {std::uint64_t(time.count()),
                                     std::uint64_t(std::filesystem::file_size(file.path, ignored))})
      stamp = Delaunay_from_surface_3::core::Split_mix(stamp ^ part)();
  }
  return stamp;
}

std::vector<std::filesystem::path> Point_files_3::files() const
{
  std::vector<std::filesystem::path> paths;
  for (const File& file : *m_files)
    paths.push_back(file.path);
  return paths;
}

std::string Point_files_3::name_of(std::uint64_t i) const
{
  const File& file = file_of(i);
  return file.path.string() + ": point " + std::to_string(i - file.first);
}

const Point_files_3::File& Point_files_3::file_of(std::uint64_t i) const
{
  return *std::prev(
      std::upper_bound(m_files->begin(), m_files->end(), i,
                       [](std::uint64_t point, const File& file) { return point < file.first; }));
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FILES
} // namespace CGAL
