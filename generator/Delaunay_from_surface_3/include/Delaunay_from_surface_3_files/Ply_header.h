// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_FILES_PLY_HEADER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_FILES_PLY_HEADER_H

#include <Delaunay_from_surface_3_files/Polygon_soup.h>
#include <Delaunay_from_surface_3_files/parse_number.h>

#include <algorithm>
#include <array>
#include <cstddef>
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
    static const std::array<std::array<const char*, 2>, 8> names = {{{"char", "int8"},
                                                                     {"uchar", "uint8"},
                                                                     {"short", "int16"},
                                                                     {"ushort", "uint16"},
                                                                     {"int", "int32"},
                                                                     {"uint", "uint32"},
                                                                     {"float", "float32"},
                                                                     {"double", "float64"}}};
    for (std::size_t i = 0; i < names.size(); ++i)
      if (word == names[i][0] || word == names[i][1])
        return Ply_type(i);
    throw Bad_content(excerpt(word) + " is no type");
  }

  std::string_view m_text, m_rest;
  const char m_end; // of a line
  std::size_t m_number = 0;
  Ply_format m_format = Ply_format::ASCII;
  std::vector<Ply_element> m_elements;
};

} // namespace files

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_FILES_PLY_HEADER_H
