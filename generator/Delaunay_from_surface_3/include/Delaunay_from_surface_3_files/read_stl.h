// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_STL_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_STL_H

#include <Delaunay_from_surface_3_files/parse_text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace files {

// Reads .stl, as text and binary. Points that are equal become one. CGAL's reader takes a text that
// does not begin with "solid" and a blank for binary, keeps the points that it has found so, and
// reads it as a text after that; it unites NaN with any other point, too.
class Stl_reader
{
public:
  explicit Stl_reader(std::string_view content)
    : m_content(content)
  {
  }

  Polygon_soup read()
  {
    if (m_content.size() >= binary_head && is_binary())
      read_binary();
    else
      read_text();
    leave_out_collapsed();
    return std::move(m_soup);
  }

private:
  using Corner = std::array<double, 3>;

  struct Hash
  {
    std::size_t operator()(const Corner& corner) const
    {
      std::uint64_t hash = 0;
      for (const double x : corner) {
        std::uint64_t bits;
        std::memcpy(&bits, &x, sizeof(bits));
        hash = (hash ^ bits) * 0x9e3779b97f4a7c15;
        hash ^= hash >> 29;
      }
      return std::size_t(hash);
    }
  };

  static constexpr std::size_t binary_head = 84, binary_triangle = 50;

  // 80 bytes of any content, the number of triangles, and 50 for each. A text has no byte below 9,
  // so that what stands in the place of the number is more than such a text could hold.
  bool is_binary() const
  {
    const std::size_t size = binary_head + binary_triangle * number_in_head();
    return size == m_content.size() || (size < m_content.size() && number_in_head() < 0x09090909);
  }

  // The bytes are in the order of most machines, the least first.
  std::size_t number_in_head() const
  {
    std::size_t number = 0;
    for (std::size_t k = 4; k > 0; --k)
      number = number << 8 | static_cast<unsigned char>(m_content[79 + k]);
    return number;
  }

  double float_at(std::size_t place) const
  {
    std::uint32_t bits = 0;
    for (std::size_t k = 4; k > 0; --k)
      bits = bits << 8 | static_cast<unsigned char>(m_content[place + k - 1]);
    float value;
    std::memcpy(&value, &bits, sizeof(value));
    return double(value);
  }

  // Of each triangle a normal vector, which often is NaN and not used, and three corners.
  void read_binary()
  {
    for (std::size_t t = 0; t < number_in_head(); ++t)
      for (std::size_t k = 1; k <= 3; ++k) {
        const std::size_t place = binary_head + binary_triangle * t + 12 * k;
        add_corner({float_at(place), float_at(place + 4), float_at(place + 8)});
      }
    const std::size_t size = binary_head + binary_triangle * number_in_head();
    m_soup.has_more = m_content.size() - size >= binary_triangle;
  }

  // "solid" and any name; facets of a normal, which is not looked at, and a loop; "endsolid" and the
  // name again. There may be many solids.
  void read_text()
  {
    Lines lines(m_content);
    bool is_solid = false, is_open = true; // until "endsolid"
    std::string_view before;
    try {
      for (;;) {
        const bool begins_line = is_at_end_of_line(lines);
        const std::string_view w = word(lines);
        if (w.empty())
          break;
        is_solid = is_solid || is(w, "solid");
        if (is(w, "endsolid"))
          is_open = false;
        else if (begins_line && is(w, "solid")) // else it may be a name
          is_open = true;
        if (is(before, "outer") && is(w, "loop"))
          read_loop(lines);
        before = w;
      }
    } catch (const Bad_content& error) {
      throw Bad_content(lines.place() + error.what());
    }
    if (is_open)
      throw Bad_content(is_solid ? "it is cut short: the keyword endsolid is missing"
                                 : "it is damaged, cut short or in another format");
  }

  // From behind "outer loop".
  void read_loop(Lines& lines)
  {
    for (int i = 0; i < 3; ++i) {
      expect(lines, "vertex");
      Corner corner;
      for (double& x : corner)
        x = parse_coordinate(word(lines));
      add_corner(corner);
    }
    expect(lines, "endloop");
    expect(lines, "endfacet");
  }

  // The next word, on whatever line it stands; empty at the end.
  static std::string_view word(Lines& lines)
  {
    std::string_view word = lines.word();
    while (word.empty() && lines.next())
      word = lines.word();
    return word;
  }

  static bool is_at_end_of_line(const Lines& lines)
  {
    std::string_view rest = lines.line();
    return next_word(rest).empty();
  }

  // In capital letters, too.
  static bool is(std::string_view word, std::string_view keyword)
  {
    return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(), [](char a, char b) {
      return a == b || (a >= 'A' && a <= 'Z' && a + 32 == b);
    });
  }

  static void expect(Lines& lines, const std::string& keyword)
  {
    const std::string_view found = word(lines);
    if (!is(found, keyword))
      throw Bad_content(found.empty() ? "the file ends too early"
                                      : excerpt(found) + " stands where " + keyword + " should");
  }

  void add_corner(const Corner& corner)
  {
    const std::size_t triangle = m_number_of_corners++ / 3;
    if (!std::all_of(corner.begin(), corner.end(), [](double x) { return std::isfinite(x); }))
      throw Bad_content("triangle " + std::to_string(triangle) +
                        ": a coordinate is not a finite number");
    const Corner key = {corner[0] + 0., corner[1] + 0., corner[2] + 0.}; // -0 equals 0
    const auto [place, is_new] = m_indices.emplace(key, m_soup.points.size());
    if (is_new)
      m_soup.points.emplace_back(corner[0], corner[1], corner[2]);
    if (m_soup.faces.size() == triangle)
      m_soup.faces.emplace_back();
    m_soup.faces.back().push_back(place->second);
  }

  // A triangle that the rounding to float has made a segment or a point, as it does with small ones
  // far from the origin, bounds nothing: without it a closed surface is closed again.
  void leave_out_collapsed()
  {
    const auto first = std::remove_if(m_soup.faces.begin(), m_soup.faces.end(), [](const auto& f) {
      return f[0] == f[1] || f[1] == f[2] || f[2] == f[0];
    });
    m_soup.collapsed_triangles = std::size_t(m_soup.faces.end() - first);
    m_soup.faces.erase(first, m_soup.faces.end());
  }

  std::string_view m_content;
  Polygon_soup m_soup;
  std::unordered_map<Corner, std::size_t, Hash> m_indices;
  std::size_t m_number_of_corners = 0;
};

} // namespace files

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_STL_H
