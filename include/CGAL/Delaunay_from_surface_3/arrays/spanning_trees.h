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
#include <CGAL/Delaunay_from_surface_3/support/shared_words.h>

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

  void prefetch_point(std::size_t i) const { prefetch(m_points[i]); }

  template <class Edge>
  int compare(const Edge& a, const Edge& b) const
  {
    const double* const v[3] = {m_points[a.ends[1]], m_points[b.ends[0]], m_points[b.ends[1]]};
    return exact_sign_of_any<Exact_lengths>(v, m_points[a.ends[0]]);
  }

private:
  Point_array m_points;
  double m_factor;
};

// Returns a bit for each edge 01, 02, 12, 03, 13, 23 of a simplex that is clearly longer than two others
// with which it forms a triangle. Which edge that is cannot be predicted, so there is no branch.
template <std::size_t corners, class Lengths>
unsigned longest_edges(const std::array<std::uint32_t, corners>& v, const Lengths& lengths)
{
  constexpr unsigned char others[6][4] = {{1, 2, 3, 4}, {0, 2, 3, 5}, {0, 1, 4, 5},
                                          {0, 4, 1, 5}, {0, 3, 2, 5}, {1, 3, 2, 4}};
  constexpr double none = std::numeric_limits<double>::infinity();
  double length[6] = {none, none, none, none, none, none};
  for (std::size_t l = 1; l < corners; ++l)
    for (std::size_t k = 0; k < l; ++k)
      length[l * (l - 1) / 2 + k] = lengths.squared_length(v[k], v[l]);
  unsigned found = 0;
  for (unsigned e = 0; e < 6; ++e) {
    const unsigned char* const o = others[e];
    const double a = length[o[0]], b = length[o[1]], c = length[o[2]], d = length[o[3]];
    const double ab = a < b ? b : a, cd = c < d ? d : c; // std::max() would return a reference
    found |= unsigned(is_clearly_less(ab < cd ? ab : cd, length[e])) << e;
  }
  return found;
}

constexpr std::uint32_t is_long = std::uint32_t(1) << 31;

// Returns the larger ends of the edges of simplices, listed by the smaller: once for each simplex, with a
// mark `is_long` if the edge is clearly the longest of one of its triangles.
template <std::size_t corners, class CornerOf, class Lengths>
Lists<std::uint32_t> larger_ends(std::size_t number, std::size_t n, const CornerOf& corner_of,
                                 const Lengths& lengths, const Executor& executor)
{
  const std::size_t blocks = number_of_blocks(executor, number, many_items);
  // Calls visit(simplex, one some steps ahead) for a part of the simplices.
  const auto visit_simplices = [&](std::size_t block, const auto& visit) {
    Steps step(executor);
    const std::size_t last = number * (block + 1) / blocks;
    for (std::size_t c = number * block / blocks; c < last; ++c, step())
      visit(c, (std::min)(c + prefetch_distance, last - 1));
  };
  Sort_into_lists<std::uint32_t> sort(n, blocks, executor);
  sort.count([&](std::size_t b, std::uint32_t* numbers) {
    visit_simplices(b, [&](std::size_t c, std::size_t) {
      for (std::size_t k = 0; k < corners; ++k)
        for (std::size_t l = k + 1; l < corners; ++l)
          ++numbers[(std::min)(corner_of(c, k), corner_of(c, l))];
    });
  });
  return sort.place([&](std::size_t b, std::uint32_t* places, std::uint32_t* items) {
    visit_simplices(b, [&](std::size_t c, std::size_t ahead) {
      std::array<std::uint32_t, corners> v;
      for (std::size_t k = 0; k < corners; ++k) {
        v[k] = std::uint32_t(corner_of(c, k));
        lengths.prefetch_point(std::size_t(corner_of(ahead, k)));
        prefetch(items + places[corner_of(ahead, k)]);
      }
      const unsigned longest = longest_edges(v, lengths);
      for (std::size_t l = 1; l < corners; ++l)
        for (std::size_t k = 0; k < l; ++k)
          items[places[(std::min)(v[k], v[l])]++] =
              (std::max)(v[k], v[l]) | (longest >> (l * (l - 1) / 2 + k)) << 31;
    });
  });
}

// The edges of simplices, each once, but for those that are clearly the longest of a triangle. There are
// `number` simplices of 2 to 4 corners, and n < 2^31 vertices; corner_of(c, k) is corner k of simplex c.
// Cost: linear.
template <class CornerOf, class Lengths>
std::vector<Measured_edge<std::uint32_t>>
edges_of_simplices(std::size_t number, std::size_t corners, std::size_t n,
                   const CornerOf& corner_of, const Lengths& lengths, const Executor& executor)
{
  if (n >= is_long ||
      corners * (corners - 1) / 2 * number >= (std::numeric_limits<std::uint32_t>::max)())
    throw std::length_error("edges can be found for at most 700 million tetrahedra");
  const auto list_ends = corners == 4   ? larger_ends<4, CornerOf, Lengths>
                         : corners == 3 ? larger_ends<3, CornerOf, Lengths>
                                        : larger_ends<2, CornerOf, Lengths>;
  Lists<std::uint32_t> ends = list_ends(number, n, corner_of, lengths, executor);
  std::vector<Measured_edge<std::uint32_t>> found;
  found.reserve(2 * n);                   // of points on surfaces, some 1.7 n are found
  std::vector<std::uint32_t> state(n, 0); // 2 s + 2 if met in list s, 2 s + 3 if with a mark there
  Steps step(executor);
  for (std::uint32_t s = 0; s < n; ++s) {
    const std::uint32_t met = 2 * s + 2;
    std::uint32_t *const begin = ends.items.data() + ends.first[s], *to = begin;
    step(std::size_t(ends.end(s) - begin) + 1);
    for (const std::uint32_t* t = begin; t != ends.end(s); ++t) {
      const std::uint32_t other = *t & ~is_long, before = state[other];
      state[other] = (std::max)(before, met + (*t != other));
      *to = other;
      to += before < met;
    }
    for (const std::uint32_t* t = begin; t != to; ++t)
      if (state[*t] == met)
        found.push_back({{s, *t}, 0, 0});
  }
  return found;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_SPANNING_TREES_H
