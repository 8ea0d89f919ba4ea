// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_POINT_FILE_LAYOUT_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_POINT_FILE_LAYOUT_H

// Where the coordinates of points are in a file that is read by ranges.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Records.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_files_error.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <ios>
#include <string>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

enum class Number_type { INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT32, FLOAT64 };

constexpr std::size_t size_of(Number_type type)
{
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[std::size_t(type)];
}

inline bool machine_is_little_endian()
{
  const std::uint16_t one = 1;
  char first;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

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

struct Point_file_layout
{
  std::uint64_t number_of_points = 0, first = 0; // the second: of the first point, in bytes
  std::size_t stride = 24;                       // from a point to the next
  std::array<std::size_t, 3> offsets = {0, 8, 16};
  std::array<Number_type, 3> types = {Number_type::FLOAT64, Number_type::FLOAT64,
                                      Number_type::FLOAT64};
  bool is_swapped = !machine_is_little_endian();

  // Coordinate k of a point.
  double number(const char* point, std::size_t k) const
  {
    const char* const bytes = point + offsets[k];
    switch (types[k]) {
    case Number_type::INT8:
      return number_at<std::int8_t>(bytes, is_swapped);
    case Number_type::UINT8:
      return number_at<std::uint8_t>(bytes, is_swapped);
    case Number_type::INT16:
      return number_at<std::int16_t>(bytes, is_swapped);
    case Number_type::UINT16:
      return number_at<std::uint16_t>(bytes, is_swapped);
    case Number_type::INT32:
      return number_at<std::int32_t>(bytes, is_swapped);
    case Number_type::UINT32:
      return number_at<std::uint32_t>(bytes, is_swapped);
    case Number_type::FLOAT32:
      return number_at<float>(bytes, is_swapped);
    default:
      return number_at<double>(bytes, is_swapped);
    }
  }
};

[[noreturn]] inline void refuse_file(const std::filesystem::path& file, const std::string& why)
{
  throw Tile_files_error(file.string() + ": " + why);
}

inline std::uint64_t size_of_file(const std::filesystem::path& file)
{
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error)
    refuse_file(file, "cannot be read: " + error.message());
  return size;
}

// The value of a key in the head of a .npy, which is a dictionary of Python's.
inline std::string value_of_key(const std::string& head, const std::string& key,
                                const std::string& end)
{
  const std::size_t at = head.find("'" + key + "'");
  const std::size_t colon = at == std::string::npos ? at : head.find(':', at);
  if (colon == std::string::npos)
    return "";
  const std::size_t last = head.find_first_of(end, head.find_first_not_of(" ('", colon + 1));
  std::string value = head.substr(colon + 1, last - colon - 1);
  value.erase(std::remove_if(value.begin(), value.end(),
                             [](char c) { return c == ' ' || c == '\'' || c == '('; }),
              value.end());
  return value;
}

inline Point_file_layout layout_of_npy(const std::filesystem::path& file)
{
  Bytes_reader from(file);
  unsigned char start[12] = {};
  from.read(start, 10);
  if (std::memcmp(start, "\x93NUMPY", 6) != 0 || start[6] < 1 || start[6] > 3)
    refuse_file(file, "no file of NumPy's");
  std::size_t length = start[8] + 256u * start[9], first = 10;
  if (start[6] > 1) {
    from.read(start + 10, 2);
    length += (std::size_t(start[10]) << 16) + (std::size_t(start[11]) << 24);
    first = 12;
  }
  if (length > (1u << 20))
    refuse_file(file, "its head has no end");
  std::string head(length, ' ');
  from.read(head.data(), length);
  Point_file_layout layout;
  const std::string type = value_of_key(head, "descr", ",}");
  const bool is_float = type == "<f4" || type == ">f4";
  if (!is_float && type != "<f8" && type != ">f8")
    refuse_file(file, "numbers of type '" + type + "': float64 and float32 are read");
  if (value_of_key(head, "fortran_order", ",}") != "False")
    refuse_file(file, "its array is stored column by column: store it row by row (order='C')");
  const std::string shape = value_of_key(head, "shape", ")");
  char* comma = nullptr; // no stream: those of a library in a wheel may know no numbers
  layout.number_of_points = std::strtoull(shape.c_str(), &comma, 10);
  if (comma == shape.c_str() || std::string(comma) != ",3")
    refuse_file(file, "an array of shape (" + shape + "): n × 3 numbers are needed");
  layout.first = first + length;
  layout.stride = is_float ? 12 : 24;
  layout.offsets = {0, layout.stride / 3, layout.stride / 3 * 2};
  layout.types.fill(is_float ? Number_type::FLOAT32 : Number_type::FLOAT64);
  layout.is_swapped = (type[0] == '<') != machine_is_little_endian();
  return layout;
}

// The head of a .ply, line by line.
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

  // What comes before the vertices is skipped, and what comes after them is not looked at.
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
    const Number_type t = type_of(type);
    const std::size_t k = name == "x" ? 0 : name == "y" ? 1 : name == "z" ? 2 : 3;
    if (m_is_vertex && k < 3) {
      m_has[k] = true;
      m_layout.offsets[k] = m_stride;
      m_layout.types[k] = t;
    }
    m_stride += size_of(t);
    if (m_is_vertex) {
      m_has_vertices = true;
      m_layout.stride = m_stride;
      m_layout.number_of_points = m_count;
    }
  }

  Number_type type_of(const std::string& name) const
  {
    static const char* const names[][2] = {
        {"char", "int8"}, {"uchar", "uint8"}, {"short", "int16"},   {"ushort", "uint16"},
        {"int", "int32"}, {"uint", "uint32"}, {"float", "float32"}, {"double", "float64"}};
    for (std::size_t i = 0; i < 8; ++i)
      if (name == names[i][0] || name == names[i][1])
        return Number_type(i);
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
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_POINT_FILE_LAYOUT_H
