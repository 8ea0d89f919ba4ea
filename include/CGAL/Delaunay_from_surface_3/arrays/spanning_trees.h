// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_SPANNING_TREES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_SPANNING_TREES_H

// Minimum spanning trees of numbered points, by Kruskal's algorithm, among the edges of a Delaunay
// triangulation (Choi 2002, §3.1).
//
// An edge of a triangle that is longer than both others is in no minimum spanning tree, as it is the
// longest of a cycle. Such edges are left out before the others are sorted.

#include <CGAL/Delaunay_from_surface_3/core/kernel/exact_signs.h>
#include <CGAL/Delaunay_from_surface_3/support/Disjoint_sets.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Compares the lengths of segments (p, q) and (r, s), given by q, r, s and p: the difference of their
// squares is a polynomial in the differences from p.
struct Exact_lengths
{
  static constexpr int size = 3;

  template <class Number, class Place>
  static Exact_sign sign(const Row<Number>* d, Exact_stage stage, const Place*, Place)
  {
    const auto product = [d](int i, int j) {
      return d[i].x * d[j].x + d[i].y * d[j].y + d[i].z * d[j].z;
    };
    const auto rs = product(1, 2);
    return {sign_of((product(0, 0) + (rs + rs)) - (product(1, 1) + product(2, 2))), false, stage};
  }
  static Exact_sign rounded(const Exact_differences<3>&, const double* const*, const double*)
  {
    return {0, false, DOUBLE_DOUBLE};
  }
};

// The lengths of edges between points whose coordinates are any finite numbers. Rounded ones are scaled
// by a power of 2, so that few squares underflow or overflow.
class Lengths_between
{
public:
  explicit Lengths_between(const Point_array& points)
    : m_points(points)
  {
    double largest = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      for (int k = 0; k < 3; ++k)
        largest = (std::max)(largest, std::abs(points[i][k]));
    int exponent = 0;
    std::frexp(largest, &exponent);
    m_factor = std::ldexp(1., (std::min)(400 - exponent, 1000));
  }

  double squared_length(std::size_t i, std::size_t j) const
  {
    double square = 0;
    for (int k = 0; k < 3; ++k) {
      const double d = m_points[i][k] * m_factor - m_points[j][k] * m_factor;
      square += d * d;
    }
    return square;
  }

  int compare(const Measured_edge& a, const Measured_edge& b) const
  {
    const double* const v[3] = {m_points[a.ends[1]], m_points[b.ends[0]], m_points[b.ends[1]]};
    return exact_sign_of_any<Exact_lengths>(v, m_points[a.ends[0]]);
  }

private:
  Point_array m_points;
  double m_factor;
};

// The edges of a simplex, and the triangles that they form.
inline constexpr unsigned char ends_of_edge[6][2] = {{0, 1}, {0, 2}, {1, 2},
                                                     {0, 3}, {1, 3}, {2, 3}};
inline constexpr unsigned char edges_of_triangle[4][3] = {
    {0, 1, 2}, {0, 3, 4}, {1, 3, 5}, {2, 4, 5}};

// Returns a bit for each edge of a tetrahedron, or of a triangle, that is clearly longer than two others
// with which it forms a triangle.
template <class Lengths>
unsigned longest_edges(const std::array<std::size_t, 4>& v, std::size_t corners,
                       const Lengths& lengths)
{
  double length[6];
  for (std::size_t e = 0; e < corners * (corners - 1) / 2; ++e)
    length[e] = lengths.squared_length(v[ends_of_edge[e][0]], v[ends_of_edge[e][1]]);
  unsigned found = 0;
  for (std::size_t t = 0; t < (corners == 4 ? 4 : corners - 2); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const unsigned char* const e = edges_of_triangle[t];
      const double one = length[e[(k + 1) % 3]], other = length[e[(k + 2) % 3]];
      if (is_clearly_less(one, length[e[k]]) && is_clearly_less(other, length[e[k]]))
        found |= 1u << e[k];
    }
  return found;
}

// Lists with marks `is_long` of the numbers in them: removes the numbers that have one, and those that
// were in the same list before. Cost: linear.
inline void remove_long_and_repeated(Lists<std::uint32_t>& lists, std::uint32_t is_long,
                                     Steps& step)
{
  const std::size_t n = lists.size();
  std::vector<std::uint32_t> met_by(n, is_long);
  std::uint32_t *const items = lists.items.data(), *to = items, *begin = items;
  for (std::size_t s = 0; s < n; ++s) {
    std::uint32_t* const end = items + lists.first[s + 1];
    step(std::size_t(end - begin) + 1);
    lists.first[s] = std::uint32_t(to - items);
    for (const std::uint32_t* t = begin; t != end; ++t)
      if ((*t & is_long) != 0)
        met_by[*t & ~is_long] = std::uint32_t(s);
    for (const std::uint32_t* t = begin; t != end; ++t)
      if ((*t & is_long) == 0 && met_by[*t] != s) {
        met_by[*t] = std::uint32_t(s);
        *to++ = *t;
      }
    begin = end;
  }
  lists.first[n] = std::uint32_t(to - items);
}

// The edges of simplices, each once, but for those that are clearly the longest of a triangle. There are
// `number` simplices of 2 to 4 corners, and n < 2^31 vertices; corner_of(c, k) is corner k of simplex c.
// Cost: linear.
template <class CornerOf, class Lengths>
std::vector<Measured_edge> edges_of_simplices(std::size_t number, std::size_t corners,
                                              std::size_t n, const CornerOf& corner_of,
                                              const Lengths& lengths, const Executor& executor)
{
  constexpr std::uint32_t is_long = std::uint32_t(1) << 31;
  const std::size_t edges = corners * (corners - 1) / 2;
  if (n >= is_long || edges * number >= (std::numeric_limits<std::uint32_t>::max)())
    throw std::length_error("edges can be found for at most 700 million tetrahedra");
  // Calls visit(list, other end, whether it is the longest) for the edges of a part of the simplices.
  const std::size_t blocks = number_of_blocks(executor, number, many_items);
  const auto visit_edges = [&](std::size_t block, bool measures, const auto& visit) {
    Steps step(executor);
    for (std::size_t c = number * block / blocks; c < number * (block + 1) / blocks; ++c, step()) {
      std::array<std::size_t, 4> v = {};
      for (std::size_t k = 0; k < corners; ++k)
        v[k] = std::size_t(corner_of(c, k));
      const unsigned longest = measures ? longest_edges(v, corners, lengths) : 0;
      for (std::size_t e = 0; e < edges; ++e) {
        const auto [s, t] = std::minmax(v[ends_of_edge[e][0]], v[ends_of_edge[e][1]]);
        visit(s, t, (longest >> e & 1) != 0);
      }
    }
  };
  Sort_into_lists<std::uint32_t> sort(n, blocks, executor); // by the smaller end
  sort.count([&](std::size_t b, std::uint32_t* numbers) {
    visit_edges(b, false, [&](std::size_t s, std::size_t, bool) { ++numbers[s]; });
  });
  Lists<std::uint32_t> others =
      sort.place([&](std::size_t b, std::uint32_t* places, std::uint32_t* items) {
        visit_edges(b, true, [&](std::size_t s, std::size_t t, bool is_longest) {
          items[places[s]++] = std::uint32_t(t) | (is_longest ? is_long : 0);
        });
      });
  Steps step(executor);
  remove_long_and_repeated(others, is_long, step);
  std::vector<Measured_edge> found;
  found.reserve(others.first[n]);
  for (std::size_t s = 0; s < n; ++s)
    for (const std::uint32_t* t = others.begin(s); t != others.end(s); ++t)
      found.push_back(measured_edge(s, *t, 0));
  return found;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_SPANNING_TREES_H
