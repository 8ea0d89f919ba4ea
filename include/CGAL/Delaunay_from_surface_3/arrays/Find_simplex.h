// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_FIND_SIMPLEX_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_FIND_SIMPLEX_H

// Finds the tetrahedron that contains a point, by a walk from one to the next through facets that
// separate them from the point; orientations are exact. In a Delaunay triangulation, even if it is
// perturbed, the walk never returns to a tetrahedron (Devillers, Pion, Teillaud 2002).

#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/exact_signs.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/obstacle_of_compiler.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Sort_by_halves.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Refers to tetrahedra as rows of arrays that it does not own: entry k of simplex c is at
// c * stride + k.
// The neighbour beyond the hull is -1 or an infinite cell, numbered from `number` on. Entries out
// of range are refused when they are read.
template <class Index>
struct Simplices_view
{
  const Index* vertices;
  std::size_t stride_of_vertices;
  const Index* neighbors;
  std::size_t stride_of_neighbors;
  std::size_t number, number_of_cells;
  std::size_t number_of_points;

  std::size_t vertex(std::size_t c, std::size_t k) const
  {
    const auto v = std::size_t(vertices[c * stride_of_vertices + k]);
    if (v >= number_of_points)
      refuse("a vertex of simplex ", c, vertices[c * stride_of_vertices + k], number_of_points,
             " points");
    return v;
  }
  Index neighbor(std::size_t c, std::size_t k) const
  {
    const Index d = neighbors[c * stride_of_neighbors + k];
    if (d < -1 || (d >= 0 && std::size_t(d) >= number_of_cells))
      refuse("a neighbour of simplex ", c, d, number_of_cells, " cells");
    return d >= 0 && std::size_t(d) >= number ? Index(-1) : d;
  }

private:
  [[noreturn]] static void refuse(const char* entry, std::size_t c, Index is, std::size_t number,
                                  const char* of)
  {
    throw std::out_of_range(entry + std::to_string(c) + " is " + std::to_string(is) +
                            ", but there are " + std::to_string(number) + of);
  }
};

// A set of numbers in the order in which they came, which is mostly small.
template <class Index>
class Short_set
{
public:
  const std::vector<Index>& items() const { return m_items; }

  bool has(Index i) const
  {
    return m_items.size() < many ? std::find(m_items.begin(), m_items.end(), i) != m_items.end()
                                 : m_hashed.count(i) > 0;
  }
  void add(Index i)
  {
    if (has(i))
      return;
    m_items.push_back(i);
    if (m_items.size() == many)
      m_hashed.insert(m_items.begin(), m_items.end());
    else if (m_items.size() > many)
      m_hashed.insert(i);
  }
  void clear()
  {
    m_items.clear();
    if (!m_hashed.empty()) // else clearing would take as long as the largest set has taken
      std::unordered_set<Index>().swap(m_hashed);
  }

  static constexpr std::size_t many = 64;

private:
  std::vector<Index> m_items;
  std::unordered_set<Index> m_hashed;
};

// Finds simplices for one thread. point_of(i) returns the coordinates of point i, as a
// std::array<double, 3>.
template <class Index, class PointOf>
class Find_simplex
{
  using Point = std::array<double, 3>;
  using Face = std::array<Index, 2>; // a vertex and -1, or two vertices

public:
  // Keeps copies of both arguments.
  Find_simplex(const Simplices_view<Index>& simplices, const PointOf& point_of)
    : m_simplices(simplices)
    , m_point_of(point_of)
  {
  }

  // Returns the simplex with the smallest number that contains q, its facets included, or -1.
  // Starts at the last simplex found. Takes expected constant time for points near the last one;
  // all points at the same vertex or on the same edge together cost one turn around it.
  Index operator()(const Point& q)
  {
    if (m_simplices.number == 0)
      return -1;
    Index from = -1;
    for (std::size_t steps = 0; steps <= m_simplices.number; ++steps) {
      const int k = look(m_last, q, from);
      if (k < 0)
        return m_facets == 0 ? m_last : least_around(q);
      const Index next = m_simplices.neighbor(std::size_t(m_last), std::size_t(k));
      if (next < 0)
        return -1; // beyond the hull
      from = m_last;
      m_last = next;
    }
    throw std::invalid_argument("the simplices are not a triangulation of the points");
  }

private:
  // Returns the first facet with q beyond it, or -1: then bit k of m_facets tells whether q lies in
  // facet k. The facet that leads back to `from` is not tested: q is on its inner side.
  int look(Index c, const Point& q, Index from)
  {
    Point corners[4];
    for (std::size_t k = 0; k < 4; ++k)
      corners[k] = m_point_of(m_simplices.vertex(std::size_t(c), k));
    const Row<double> rows[4] = {row(corners[0].data(), q.data()), row(corners[1].data(), q.data()),
                                 row(corners[2].data(), q.data()),
                                 row(corners[3].data(), q.data())};
    m_facets = 0;
    for (unsigned k = 0; k < 4; ++k)
      if (rows[k].x == 0 && rows[k].y == 0 && rows[k].z == 0) {
        m_facets = 15u & ~(1u << k);
        return -1;
      }
    for (unsigned k = 0; k < 4; ++k) {
      if (from >= 0 && m_simplices.neighbor(std::size_t(c), k) == from)
        continue;
      const int side = sign(corners, rows, facet_corners[k], q);
      if (side < 0)
        return int(k);
      m_facets |= unsigned(side == 0) << k;
    }
    return -1;
  }

  int sign(const Point* corners, const Row<double>* rows, const unsigned char* facet,
           const Point& q) const
  {
    const Row<double>&a = rows[facet[0]], &b = rows[facet[1]], &c = rows[facet[2]];
    const double m = largest_square(a, b, c);
    const int side = m_has_filter && m < 1e100
                         ? certified_sign(determinant_of(a, b, c), Filter_bounds::three_rows(m))
                         : 0;
    if (side != 0)
      return side;
    for (unsigned k = 0; k < 3; ++k)
      for (const double x : corners[facet[k]])
        if (!is_finite_number(x))
          throw std::invalid_argument("a coordinate of a point is not a finite number any more");
    return orientation(q.data(), corners[facet[0]].data(), corners[facet[1]].data(),
                       corners[facet[2]].data());
  }

  // Returns the least of all simplices that have q in a facet, as m_last has: they are reached
  // through such facets.
  Index least_around(const Point& q)
  {
    const Face face = face_of_last();
    const auto known = m_least.find(face);
    if (known != m_least.end())
      return known->second;
    Index least = m_last;
    m_met.clear();
    m_met.add(m_last);
    for (std::size_t i = 0; i < m_met.items().size(); ++i) {
      const Index c = m_met.items()[i];
      if (i > 0)
        look(c, q, -1);
      const unsigned facets = m_facets;
      least = (std::min)(least, c);
      for (unsigned k = 0; k < 4; ++k)
        if ((facets >> k & 1u) != 0) {
          const Index d = m_simplices.neighbor(std::size_t(c), k);
          if (d >= 0)
            m_met.add(d);
        }
    }
    if (m_met.items().size() >= Short_set<Index>::many)
      m_least.emplace(face, least);
    return least;
  }

  // Returns the vertex or edge of m_last on which q lies, or twice -1 if it is in a facet, which
  // belongs to at most two simplices.
  Face face_of_last() const
  {
    Face face = {-1, -1};
    std::size_t n = 0;
    for (std::size_t k = 0; k < 4; ++k)
      if ((m_facets >> k & 1u) == 0) {
        if (n == 2)
          return {-1, -1};
        face[n++] = Index(m_simplices.vertex(std::size_t(m_last), k));
      }
    if (face[0] < face[1])
      std::swap(face[0], face[1]);
    return face;
  }

  const Simplices_view<Index> m_simplices;
  const PointOf m_point_of;
  const bool m_has_filter = obstacle_of_compiler() == nullptr;
  Index m_last = 0;
  unsigned m_facets = 0;
  Short_set<Index> m_met;
  std::map<Face, Index> m_least; // around faces with many simplices
};

// Finds the simplices of many points: each thread sorts a part of them in space, and walks from one
// to the next. Writes the simplex that contains queries[i] to found[i].
template <class Index, class PointOf>
void find_simplices(const Simplices_view<Index>& simplices, const PointOf& point_of,
                    const Point_array& queries, Index* found, const Executor& executor)
{
  const std::size_t blocks = number_of_blocks(executor, queries.size(), 1024);
  for_each_block(executor, queries.size(), blocks,
                 [&](std::size_t first, std::size_t last, std::size_t) {
                   std::vector<std::size_t> order(last - first);
                   std::iota(order.begin(), order.end(), first);
                   Sort_by_halves()(queries, order.data(), order.data() + order.size());
                   Find_simplex<Index, PointOf> find(simplices, point_of);
                   Steps step(executor);
                   for (const std::size_t i : order) {
                     step(64); // about as many cells are on the way
                     found[i] = find({queries[i][0], queries[i][1], queries[i][2]});
                   }
                 });
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_FIND_SIMPLEX_H
