// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_PLY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_PLY_H

#include <Delaunay_from_surface_3_files/parse_text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace files {

enum class Ply_format { ASCII, LITTLE_ENDIAN_BINARY, BIG_ENDIAN_BINARY };

enum class Ply_type { INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT32, FLOAT64 };

inline std::size_t size_of(Ply_type type)
{
  return std::array<std::size_t, 8>{1, 1, 2, 2, 4, 4, 4, 8}[std::size_t(type)];
}

struct Ply_property
{
  std::string name;
  Ply_type type;
  bool is_list = false;
  Ply_type type_of_count = Ply_type::UINT8; // of a list
};

struct Ply_element
{
  std::string name;
  std::size_t count;
  std::vector<Ply_property> properties;
};

// The header of a file in the format PLY, line by line. Lines end with a line feed or, if the first
// one does, with a carriage return alone, as Rhinoceros writes them before binary content.
class Ply_header
{
public:
  // Takes the header off the front of `text`.
  explicit Ply_header(std::string_view& text)
    : m_text(text)
    , m_end(text.substr(0, 4) == "ply\r" && text.substr(4, 1) != "\n" ? '\r' : '\n')
  {
    try {
      if (next_line() != "ply")
        throw Bad_content("the keyword ply is missing");
      do
        m_rest = next_line();
      while (read_line(next_word(m_rest)));
    } catch (const Bad_content& error) {
      throw Bad_content("line " + std::to_string(m_number) + ": " + error.what());
    }
    text = m_text;
  }

  Ply_format format() const { return m_format; }
  const std::vector<Ply_element>& elements() const { return m_elements; }

private:
  std::string_view next_line()
  {
    const std::size_t end = m_text.find(m_end);
    ++m_number;
    if (end == std::string_view::npos)
      throw Bad_content("the header has no end");
    std::string_view line = m_text.substr(0, end);
    m_text.remove_prefix(end + 1);
    if (!line.empty() && line.back() == '\r')
      line.remove_suffix(1);
    return line;
  }

  // Returns whether the header goes on.
  bool read_line(std::string_view keyword)
  {
    if (keyword == "end_header")
      return false;
    if (keyword == "format")
      m_format = format_of(next_word(m_rest));
    else if (keyword == "element")
      read_element();
    else if (keyword == "property")
      read_property();
    else if (keyword != "comment" && keyword != "obj_info")
      throw Bad_content(excerpt(keyword) + " is no keyword of a header");
    return true;
  }

  static Ply_format format_of(std::string_view word)
  {
    if (word == "ascii")
      return Ply_format::ASCII;
    if (word == "binary_little_endian")
      return Ply_format::LITTLE_ENDIAN_BINARY;
    if (word == "binary_big_endian")
      return Ply_format::BIG_ENDIAN_BINARY;
    throw Bad_content(excerpt(word) + " is no format");
  }

  void read_element()
  {
    const std::string name(next_word(m_rest));
    const std::size_t count =
        parse_count(next_word(m_rest), (std::numeric_limits<std::size_t>::max)(), name);
    m_elements.push_back({name, count, {}});
  }

  void read_property()
  {
    if (m_elements.empty())
      throw Bad_content("a property comes before the first element");
    Ply_property property;
    std::string_view word = next_word(m_rest);
    if (word == "list") {
      property.is_list = true;
      property.type_of_count = type_of(next_word(m_rest));
      if (property.type_of_count >= Ply_type::FLOAT32)
        throw Bad_content("the number of entries of a list is not an integer");
      word = next_word(m_rest);
    }
    property.type = type_of(word);
    property.name = next_word(m_rest);
    m_elements.back().properties.push_back(property);
  }

  static Ply_type type_of(std::string_view word)
  {
    static const std::array<const char*, 16> names = {
        // two for each type
        "char", "int8",  "uchar", "uint8",  "short", "int16",   "ushort", "uint16",
        "int",  "int32", "uint",  "uint32", "float", "float32", "double", "float64"};
    const auto found = std::find(names.begin(), names.end(), word);
    if (found != names.end())
      return Ply_type((found - names.begin()) / 2);
    throw Bad_content(excerpt(word) + " is no type");
  }

  std::string_view m_text, m_rest;
  const char m_end; // of a line
  std::size_t m_number = 0;
  Ply_format m_format = Ply_format::ASCII;
  std::vector<Ply_element> m_elements;
};

// Reads points and faces from a file in the format PLY, weights if they are asked for, and passes
// over all else. CGAL's reader believes the header and the numbers of entries: it needs all memory
// for a list that claims to be long, and crashes where a property comes before all elements or has
// another type than expected.
class Ply_reader
{
public:
  explicit Ply_reader(std::string_view text, bool with_weights = false)
    : m_header(text)
    , m_rest(text)
    , m_with_weights(with_weights)
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
    soup.has_more = !next_word(m_rest).empty();
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

  // Numbers that the header does not announce would be taken for those of the next vertices.
  void check_first_line(const Ply_element& element) const
  {
    const auto is_list = [](const Ply_property& p) { return p.is_list; };
    const auto& properties = element.properties;
    if (!is_ascii() || element.count == 0 ||
        std::any_of(properties.begin(), properties.end(), is_list))
      return;
    std::string_view rest = m_rest;
    const std::string_view first = next_word(rest);
    std::string_view line = rest.substr(0, end_of_line(rest));
    std::size_t number = first.empty() ? 0 : 1;
    while (!next_word(line).empty())
      ++number;
    if (number > properties.size())
      throw Bad_content("the first vertex has " + std::to_string(number) +
                        " numbers in its line, and the header announces " +
                        std::to_string(properties.size()));
  }

  static std::size_t find(const Ply_element& element, const std::string& name, bool is_list)
  {
    const auto found =
        std::find_if(element.properties.begin(), element.properties.end(),
                     [&](const Ply_property& p) { return p.name == name && p.is_list == is_list; });
    return std::size_t(found - element.properties.begin());
  }

  // Where a vertex has its weight, or the square root of it.
  static std::size_t find_weight(const Ply_element& element)
  {
    for (const char* const name : {"weight", "radius"})
      if (const std::size_t place = find(element, name, false); place < element.properties.size())
        return place;
    throw Bad_content("the vertices have no weights; remedy: a property weight or radius");
  }

  void read_vertices(const Ply_element& element, Polygon_soup& soup)
  {
    const std::array<std::size_t, 3> place = {find(element, "x", false), find(element, "y", false),
                                              find(element, "z", false)};
    if (*std::max_element(place.begin(), place.end()) == element.properties.size())
      throw Bad_content("the vertices do not have the properties x, y and z");
    check_first_line(element);
    const std::size_t place_of_weight = m_with_weights ? find_weight(element) : no_index;
    const bool is_radius = m_with_weights && element.properties[place_of_weight].name == "radius";
    soup.points.reserve(soup.points.size() + element.count);
    for (std::size_t i = 0; i < element.count; ++i) {
      std::array<double, 3> x = {};
      read_item(element, [&](std::size_t property, double value) {
        for (std::size_t k = 0; k < 3; ++k)
          if (property == place[k])
            x[k] = value;
        if (property == place_of_weight) {
          if (is_radius && value < 0)
            throw Bad_content("the radius of vertex " + std::to_string(i) + " is negative");
          soup.weights.push_back(is_radius ? value * value : value);
        }
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

  template <class Number>
  static double number_at(const char* bytes)
  {
    Number number;
    std::memcpy(&number, bytes, sizeof(number));
    return double(number);
  }

  static double number_in(const std::array<char, 8>& bytes, Ply_type type)
  {
    static constexpr double (*readers[])(const char*) = {
        number_at<std::int8_t>,   number_at<std::uint8_t>, number_at<std::int16_t>,
        number_at<std::uint16_t>, number_at<std::int32_t>, number_at<std::uint32_t>,
        number_at<float>,         number_at<double>};
    return readers[std::size_t(type)](bytes.data());
  }

  Ply_header m_header; // first: it takes the header off the text
  std::string_view m_rest;
  bool m_with_weights;
};

} // namespace files

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_PLY_H
