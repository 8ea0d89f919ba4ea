// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_PLY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_PLY_H

#include <Delaunay_from_surface_3_files/Ply_header.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace files {

// Reads points and faces from a file in the format PLY and passes over all else. CGAL's reader
// believes the header and the numbers of entries: it needs all memory for a list that claims to be
// long, and crashes where a property comes before all elements or has another type than expected.
class Ply_reader
{
public:
  explicit Ply_reader(std::string_view text)
    : m_header(text)
    , m_rest(text)
  {
  }

  Polygon_soup read()
  {
    Polygon_soup soup;
    for (const Ply_element& element : m_header.elements()) {
      check_room(element);
      if (element.name == "vertex" || element.name == "vertices")
        read_vertices(element, soup);
      else if (element.name == "face" || element.name == "faces")
        read_faces(element, soup);
      else if (element.name == "tristrips" && element.count > 0)
        throw Bad_content("its triangles are in strips, which are not read; remedy: export it with "
                          "faces, for instance by MeshLab");
      else if (!element.properties.empty())
        for (std::size_t i = 0; i < element.count; ++i)
          read_item(element, [](std::size_t, double) {});
    }
    return soup;
  }

private:
  bool is_ascii() const { return m_header.format() == Ply_format::ASCII; }

  // The fewest bytes that a number takes; in text one digit and a separator, but for the last.
  std::size_t least_size(Ply_type type) const { return is_ascii() ? 2 : size_of(type); }

  void check_room(const Ply_element& element) const
  {
    std::size_t size = 0;
    for (const Ply_property& p : element.properties)
      size += least_size(p.is_list ? p.type_of_count : p.type);
    if (size != 0 && element.count > (m_rest.size() + 1) / size)
      throw Bad_content("there is no room for " + std::to_string(element.count) + " " +
                        excerpt(element.name) + " in the file");
  }

  static std::size_t find(const Ply_element& element, const std::string& name, bool is_list)
  {
    const auto found =
        std::find_if(element.properties.begin(), element.properties.end(),
                     [&](const Ply_property& p) { return p.name == name && p.is_list == is_list; });
    return std::size_t(found - element.properties.begin());
  }

  void read_vertices(const Ply_element& element, Polygon_soup& soup)
  {
    const std::array<std::size_t, 3> place = {find(element, "x", false), find(element, "y", false),
                                              find(element, "z", false)};
    if (*std::max_element(place.begin(), place.end()) == element.properties.size())
      throw Bad_content("the vertices do not have the properties x, y and z");
    soup.points.reserve(soup.points.size() + element.count);
    for (std::size_t i = 0; i < element.count; ++i) {
      std::array<double, 3> x;
      read_item(element, [&](std::size_t property, double value) {
        for (std::size_t k = 0; k < 3; ++k)
          if (property == place[k])
            x[k] = value;
      });
      soup.points.emplace_back(x[0], x[1], x[2]);
    }
  }

  void read_faces(const Ply_element& element, Polygon_soup& soup)
  {
    std::size_t place = find(element, "vertex_indices", true);
    if (place == element.properties.size())
      place = find(element, "vertex_index", true);
    if (place == element.properties.size() && element.count > 0)
      throw Bad_content("the faces do not have the property vertex_indices");
    soup.faces.reserve(soup.faces.size() + element.count);
    for (std::size_t i = 0; i < element.count; ++i) {
      soup.faces.emplace_back();
      read_item(element, [&](std::size_t property, double value) {
        if (property == place)
          soup.faces.back().push_back(value >= 0 && value <= double(UINT32_MAX) &&
                                              value == std::floor(value)
                                          ? std::size_t(value)
                                          : no_index);
      });
    }
  }

  // Calls `use(number of the property, value)` for all values of the next item of an element.
  template <class Use>
  void read_item(const Ply_element& element, const Use& use)
  {
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const Ply_property& property = element.properties[p];
      double count = property.is_list ? read_number(property.type_of_count) : 1;
      if (count != std::floor(count))
        throw Bad_content("a list claims to have a number of entries that is not whole");
      if (!(count >= 0) || count > double((m_rest.size() + 1) / least_size(property.type)))
        throw Bad_content("a list claims to have more entries than the file has room for");
      for (; count > 0; --count)
        use(p, read_number(property.type));
    }
  }

  double read_number(Ply_type type)
  {
    if (is_ascii()) {
      const std::string_view word = next_word(m_rest);
      if (word.empty())
        throw Bad_content("the file ends too early");
      const double value = parse_coordinate(word);
      return type == Ply_type::FLOAT32 ? double(float(value)) : value;
    }
    std::array<char, 8> bytes;
    const std::size_t size = size_of(type);
    if (m_rest.size() < size)
      throw Bad_content("the file ends too early");
    std::copy_n(m_rest.begin(), size, bytes.begin());
    m_rest.remove_prefix(size);
    if (is_big_endian() != (m_header.format() == Ply_format::BIG_ENDIAN_BINARY))
      std::reverse(bytes.begin(), bytes.begin() + std::ptrdiff_t(size));
    return number_in(bytes, type);
  }

  static bool is_big_endian()
  {
    const std::uint16_t one = 1;
    return *reinterpret_cast<const unsigned char*>(&one) == 0;
  }

  static double number_in(const std::array<char, 8>& bytes, Ply_type type)
  {
    const auto as = [&](auto value) {
      std::memcpy(&value, bytes.data(), sizeof(value));
      return double(value);
    };
    switch (type) {
    case Ply_type::INT8:
      return as(std::int8_t());
    case Ply_type::UINT8:
      return as(std::uint8_t());
    case Ply_type::INT16:
      return as(std::int16_t());
    case Ply_type::UINT16:
      return as(std::uint16_t());
    case Ply_type::INT32:
      return as(std::int32_t());
    case Ply_type::UINT32:
      return as(std::uint32_t());
    case Ply_type::FLOAT32:
      return as(float());
    case Ply_type::FLOAT64:
      break;
    }
    return as(double());
  }

  Ply_header m_header; // first: it takes the header off the text
  std::string_view m_rest;
};

} // namespace files

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_PLY_H
