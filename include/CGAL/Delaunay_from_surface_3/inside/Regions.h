// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_REGIONS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_REGIONS_H

// Finds the winding numbers of a closed surface at the centres of tetrahedra. They are integers, 0
// outside the hull, and change from one tetrahedron to the next by the triangles that the path
// between the centres crosses. Most triangles of a dense sample are facets; paths cross them there.
// A search finds the crossings with the others.
//
// A region that no known path reaches remains without a number, so the number of one of its
// tetrahedra is computed: the one with the largest inscribed sphere, as the centre of a flat one
// may lie on the wrong side. Expected linear, apart from triangles that are no facets.

#include <CGAL/Delaunay_from_surface_3/inside/Winding_field.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Calls visit(c) for c = 0, …, n-1, by several threads if there are many.
template <class Visit>
void for_each_cell(std::size_t n, const Executor& executor, const Visit& visit)
{
  for_each_block(executor, n, number_of_blocks(executor, n, 1024),
                 [&](std::size_t first, std::size_t last, std::size_t) {
                   Steps step(executor);
                   for (std::size_t c = first; c < last; ++c, step())
                     visit(c);
                 });
}

// Box_tree stores triangles in a hierarchy of boxes, with the invariant of Winding_tree.

// Holds a triangle that counts `number` times. The length of the normal is twice the area.
struct Cutting_triangle
{
  Triangle_3d corners;
  Vector_3d normal;
  int number;

  Cutting_triangle(const Triangle_3d& t, int times)
    : corners(t)
    , normal(cross(minus(t[1], t[0]), minus(t[2], t[0])))
    , number(times)
  {
  }
};

class Box_tree
{
  static constexpr std::size_t leaf = 4; // the largest number of triangles in a leaf

  struct Node
  {
    Box_3d box;
    std::uint32_t first = 0, last = 0, next = 0;
  };

public:
  explicit Box_tree(std::vector<Cutting_triangle>&& triangles)
    : m_triangles(std::move(triangles))
  {
    if (!m_triangles.empty())
      build(0, m_triangles.size());
  }

  // Calls visit(t) for each triangle in a leaf whose box meets the given one.
  template <class Visit>
  void visit(const Box_3d& box, const Visit& visit) const
  {
    for (std::size_t k = 0; k < m_nodes.size();) {
      const Node& node = m_nodes[k];
      if (!node.box.meets(box))
        k = node.next;
      else if (node.next == ++k)
        for (std::size_t t = node.first; t < node.last; ++t)
          visit(m_triangles[t]);
    }
  }

private:
  void build(std::size_t first, std::size_t last)
  {
    const std::size_t k = m_nodes.size();
    m_nodes.emplace_back();
    Box_3d box;
    for (std::size_t t = first; t < last; ++t)
      for (const Vector_3d& p : m_triangles[t].corners)
        box.add(p);
    if (last - first > leaf) {
      const std::size_t longest = box.longest_side();
      const std::size_t middle = first + (last - first) / 2;
      const auto at = [&](std::size_t t) { return m_triangles.begin() + std::ptrdiff_t(t); };
      std::nth_element(at(first), at(middle), at(last), [&](const auto& s, const auto& t) {
        return s.corners[0][longest] < t.corners[0][longest];
      });
      build(first, middle);
      build(middle, last);
    }
    m_nodes[k] = {box, std::uint32_t(first), std::uint32_t(last), std::uint32_t(m_nodes.size())};
  }

  std::vector<Cutting_triangle> m_triangles;
  std::vector<Node> m_nodes;
};

// Triangle_table finds the triangles of a surface by their vertices, and counts how often each is
// there, minus how often it is there with the opposite orientation. Most facets of a triangulation
// are not in the table, as one word per vertex usually tells.

using Corners = std::array<std::uint32_t, 3>;

// Sorts three vertices without branches, which would be unpredictable.
inline Corners ascending(const Corners& t)
{
  const std::uint32_t low = (std::min)(t[0], t[1]), high = (std::max)(t[0], t[1]);
  return {(std::min)(low, t[2]), (std::max)(low, (std::min)(high, t[2])), (std::max)(high, t[2])};
}

// Returns whether sorting three different vertices reverses their orientation.
inline bool is_turned(const Corners& t)
{
  return ((t[0] > t[1]) != (t[1] > t[2])) != (t[0] > t[2]);
}

class Triangle_table
{
public:
  struct Row
  {
    std::uint32_t middle, greatest;
    int number; // counts least, middle, greatest in this order, minus the opposite orientation
  };

  static constexpr std::uint32_t none = std::uint32_t(-1);

  // Takes triangles on n vertices.
  Triangle_table(const std::vector<Corners>& triangles, std::size_t n)
    : m_first(n + 1, 0)
    , m_words(n, 0)
  {
    for (const Corners& t : triangles)
      ++m_first[ascending(t)[0] + 1];
    for (std::size_t v = 0; v < n; ++v)
      m_first[v + 1] += m_first[v];
    m_rows.resize(triangles.size());
    std::vector<std::uint32_t> next(m_first.begin(), m_first.end() - 1);
    for (const Corners& triangle : triangles) {
      const Corners t = ascending(triangle);
      m_rows[next[t[0]]++] = {t[1], t[2], is_turned(triangle) ? -1 : 1};
      m_words[t[0]] |= bit(t[1], t[2]);
    }
    unite_equal_ones();
  }

  std::size_t size() const { return m_rows.size(); }
  const Row& operator[](std::size_t r) const { return m_rows[r]; }

  // Returns the row of three vertices in ascending order, or `none`.
  std::uint32_t find(const Corners& t) const
  {
    if ((m_words[t[0]] & bit(t[1], t[2])) == 0)
      return none;
    const auto first = m_rows.begin() + std::ptrdiff_t(m_first[t[0]]),
               last = m_rows.begin() + std::ptrdiff_t(m_first[t[0] + 1]);
    const Row row = {t[1], t[2], 0};
    const auto found = std::lower_bound(first, last, row, is_less);
    return found != last && !is_less(row, *found) ? std::uint32_t(found - m_rows.begin()) : none;
  }

  // Calls visit(least vertex, number of the row) for all rows.
  template <class Visit>
  void for_each(const Visit& visit) const
  {
    for (std::size_t v = 0; v + 1 < m_first.size(); ++v)
      for (std::uint32_t r = m_first[v]; r < m_first[v + 1]; ++r)
        visit(std::uint32_t(v), r);
  }

private:
  static std::uint64_t bit(std::uint32_t middle, std::uint32_t greatest)
  {
    return std::uint64_t(1) << ((middle * 0x9e3779b1u ^ greatest * 0x85ebca6bu) >> 26);
  }
  static bool is_less(const Row& r, const Row& s)
  {
    return std::tie(r.middle, r.greatest) < std::tie(s.middle, s.greatest);
  }

  void unite_equal_ones()
  {
    std::uint32_t end = 0;
    for (std::size_t v = 0; v < m_words.size(); ++v) {
      const std::uint32_t first = std::exchange(m_first[v], end), last = m_first[v + 1];
      std::sort(m_rows.begin() + std::ptrdiff_t(first), m_rows.begin() + std::ptrdiff_t(last),
                is_less);
      for (std::uint32_t r = first; r < last; ++r)
        if (end > m_first[v] && !is_less(m_rows[end - 1], m_rows[r]))
          m_rows[end - 1].number += m_rows[r].number;
        else
          m_rows[end++] = m_rows[r];
    }
    m_first.back() = end;
    m_rows.resize(end);
  }

  std::vector<std::uint32_t> m_first; // the first row of each vertex
  std::vector<Row> m_rows;
  std::vector<std::uint64_t> m_words; // the bits of the rows of each vertex
};

// Crossings finds by how much the winding number changes on the paths from the centre of a
// tetrahedron to the centres of its facets, where these paths cross triangles. If a path comes so
// near the border of a triangle, or ends so near its plane, that rounding might decide, the change
// is unknown: another path will do.

// Holds the change for each facet of a tetrahedron, indexed by the corner opposite to it.
using Jumps = std::array<std::int8_t, 4>;
constexpr int unknown_jump = -128;

inline std::int8_t as_jump(int j)
{
  return std::int8_t(std::abs(j) < -unknown_jump ? j : unknown_jump);
}

// A distance that exceeds rounding errors, in a frame of size 1.
constexpr double no_rounding = 1e-10;

// Returns whether a triangle passes through the interior of a tetrahedron, and not only along its
// boundary: no direction separates them, neither a normal of one of them nor the cross product of
// an edge of each.
inline bool passes_inside(const Cutting_triangle& t, const std::array<Vector_3d, 4>& p,
                          const Box_3d& box_of_p)
{
  for (std::size_t j = 0; j < 3; ++j) // most triangles are not even near
    if ((std::max)({t.corners[0][j], t.corners[1][j], t.corners[2][j]}) <= box_of_p.low[j] ||
        (std::min)({t.corners[0][j], t.corners[1][j], t.corners[2][j]}) >= box_of_p.high[j])
      return false;
  const Vector_3d& origin = t.corners[0]; // unlike corners of tetrahedra, it is never far from 0
  const auto ends_of = [&](const auto& corners, const Vector_3d& direction) {
    std::array<double, 2> ends = {dot(direction, minus(corners[0], origin)), 0};
    ends[1] = ends[0];
    for (std::size_t k = 1; k < corners.size(); ++k) {
      const double x = dot(direction, minus(corners[k], origin));
      ends = {(std::min)(ends[0], x), (std::max)(ends[1], x)};
    }
    return ends;
  };
  const auto separates = [&](const Vector_3d& direction) {
    const std::array<double, 2> a = ends_of(t.corners, direction), b = ends_of(p, direction);
    const double length = std::sqrt(dot(direction, direction));
    return length > 0 && (std::min)(a[1] - b[0], b[1] - a[0]) <= no_rounding * length;
  };
  if (separates(t.normal))
    return false;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vector_3d& corner = p[(k + 1) % 4];
    if (separates(cross(minus(p[(k + 2) % 4], corner), minus(p[(k + 3) % 4], corner))))
      return false;
  }
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        if (separates(cross(minus(t.corners[(k + 1) % 3], t.corners[k]), minus(p[j], p[i]))))
          return false;
  return true;
}

// Returns the share of a tetrahedron that lies beyond the plane of a triangle, seen from its centre.
inline double share_beyond(const Cutting_triangle& t, const std::array<Vector_3d, 4>& p)
{
  std::array<double, 4> d;
  for (std::size_t k = 0; k < 4; ++k)
    d[k] = dot(t.normal, minus(p[k], t.corners[0]));
  if (d[0] + d[1] + d[2] + d[3] < 0)
    d = {-d[0], -d[1], -d[2], -d[3]};
  std::sort(d.begin(), d.end()); // those beyond come first
  const auto cut = [&d](std::size_t i, std::size_t k) { return d[i] / (d[i] - d[k]); };
  if (!(d[0] < 0))
    return 0;
  if (!(d[1] < 0))
    return cut(0, 1) * cut(0, 2) * cut(0, 3);
  if (d[2] < 0)
    return 1 - cut(3, 0) * cut(3, 1) * cut(3, 2);
  return cut(0, 2) * cut(0, 3) + (1 - cut(0, 2)) * cut(0, 3) * cut(1, 2) +
         (1 - cut(0, 3)) * cut(1, 2) * cut(1, 3); // three tetrahedra
}

class Crossings
{
public:
  // Returns the changes on the paths from the centre of tetrahedron c.
  template <class Cells>
  static Jumps of(const Box_tree& tree, const Cells& cells, std::size_t c)
  {
    Jumps jumps = {0, 0, 0, 0};
    Crossings crossings;
    bool is_ready = false;
    tree.visit(box_of_ways(cells(c)), [&](const Cutting_triangle& t) {
      if (!std::exchange(is_ready, true))
        crossings.set(cells, c);
      crossings.add(t, jumps);
    });
    return jumps;
  }

private:
  // Returns a bound on the rounding errors of the centres and of differences from them. Corners may
  // lie far from the surface.
  static double tolerance_for(const std::array<Vector_3d, 4>& p)
  {
    double largest = 0;
    for (const Vector_3d& corner : p)
      for (const double x : corner)
        largest = (std::max)(largest, std::abs(x));
    return no_rounding + 1e-14 * largest;
  }

  // Returns the box of the centres of the facets, slightly enlarged; it contains the paths.
  static Box_3d box_of_ways(const std::array<Vector_3d, 4>& p)
  {
    Box_3d box;
    const double tolerance = tolerance_for(p);
    for (std::size_t j = 0; j < 3; ++j) {
      const double sum = p[0][j] + p[1][j] + p[2][j] + p[3][j];
      const auto ends = std::minmax({p[0][j], p[1][j], p[2][j], p[3][j]});
      box.low[j] = (sum - ends.second) / 3 - tolerance;
      box.high[j] = (sum - ends.first) / 3 + tolerance;
    }
    return box;
  }

  // Computes the centres. A facet's centre has the same bits in both tetrahedra: its vertices are
  // added in ascending order.
  template <class Cells>
  void set(const Cells& cells, std::size_t c)
  {
    m_center = cells.center(c);
    m_tolerance = tolerance_for(cells(c));
    const auto v = cells.vertices_of(c);
    std::array<std::size_t, 4> order = {0, 1, 2, 3};
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return v[i] < v[j]; });
    for (std::size_t k = 0; k < 4; ++k) {
      Vector_3d sum = {0, 0, 0};
      for (const std::size_t i : order)
        for (std::size_t j = 0; i != k && j < 3; ++j)
          sum[j] += cells.points[std::size_t(v[i])][j];
      m_ends[k] = {sum[0] / 3, sum[1] / 3, sum[2] / 3};
    }
  }

  static int sign(double x, double tolerance) { return int(x > tolerance) - int(x < -tolerance); }

  void add(const Cutting_triangle& t, Jumps& jumps) const
  {
    const double length = std::sqrt(dot(t.normal, t.normal));
    const auto side = [&](const Vector_3d& p) {
      return sign(dot(t.normal, minus(p, t.corners[0])), length * m_tolerance);
    };
    const int side_of_center = side(m_center);
    for (std::size_t k = 0; k < 4; ++k) {
      const int side_of_end = side(m_ends[k]);
      if ((side_of_center == side_of_end && side_of_end != 0) || jumps[k] == unknown_jump)
        continue;
      const int passes = passes_through(t.corners, m_ends[k]);
      if (passes < 0 || (passes > 0 && side_of_center * side_of_end == 0))
        jumps[k] = unknown_jump;
      else if (passes > 0)
        jumps[k] = as_jump(jumps[k] + side_of_center * t.number);
    }
  }

  // Returns 1 if the line to q passes through a triangle, 0 if not, -1 if this is unknown.
  int passes_through(const Triangle_3d& corners, const Vector_3d& q) const
  {
    const Vector_3d way = minus(q, m_center);
    int signs[3] = {0, 0, 0}; // negative, small, positive
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector_3d &a = corners[i], &b = corners[(i + 1) % 3];
      const Vector_3d n = cross(way, minus(b, a));
      const double lengths = std::sqrt(dot(way, way) * dot(minus(b, a), minus(b, a)));
      ++signs[1 + sign(dot(n, minus(a, m_center)), lengths * m_tolerance)];
    }
    return signs[0] > 0 && signs[2] > 0 ? 0 : signs[1] > 0 ? -1 : 1;
  }

  Vector_3d m_center;
  double m_tolerance = 0;
  std::array<Vector_3d, 4> m_ends;
};

template <class Cells>
class Regions
{
public:
  // Takes positively oriented cells: neighbors_of(c) are numbers of cells, or at the hull numbers
  // that are out of range.
  Regions(const Cells& cells, const std::vector<Corners>& triangles, const Executor& executor)
    : m_cells(cells)
    , m_executor(executor)
    , m_jumps(cells.number, Jumps{0, 0, 0, 0})
  {
    cross_facets(Triangle_table(triangles, cells.points.size()));
  }

  // Returns the triangles that are no facets, each once, with its number, which is not 0.
  const std::vector<Cutting_triangle>& no_facets() const { return m_no_facets; }

  // Returns the winding numbers of the triangles, minus those of the triangles that close them.
  // ask(c) returns this number for tetrahedron c, before rounding.
  template <class Ask>
  std::vector<std::int32_t> numbers(const std::vector<Triangle_3d>& closing, const Ask& ask)
  {
    std::vector<Cutting_triangle> cutting = m_no_facets;
    for (const Triangle_3d& t : closing)
      cutting.emplace_back(t, -1);
    if (!cutting.empty())
      cross_others(Box_tree(std::move(cutting)));
    join();
    const std::size_t m = m_cells.number;
    std::vector<std::int32_t> numbers(m);
    const Place outside = place(std::uint32_t(m));
    std::map<std::uint32_t, std::uint32_t> roundest; // by the root of each region not reached
    for (std::uint32_t c = 0; c < m; ++c) {
      const Place p = place(c);
      numbers[c] = p.number - outside.number;
      if (p.root == outside.root)
        continue;
      std::uint32_t& best = roundest.emplace(p.root, c).first->second;
      if (inradius(m_cells(c)) > inradius(m_cells(best)))
        best = c;
    }
    if (roundest.empty())
      return numbers;
    std::map<std::uint32_t, std::int32_t> shifts;
    for (const auto& [root, c] : roundest)
      shifts[root] = std::int32_t(std::lround(ask(c))) - numbers[c];
    for (std::uint32_t c = 0; c < m; ++c) {
      const auto shift = shifts.find(place(c).root);
      if (shift != shifts.end())
        numbers[c] += shift->second;
    }
    return numbers;
  }

private:
  // Counts facets that are triangles, in the first one of two tetrahedra; keeps the triangles that
  // are no facets.
  void cross_facets(const Triangle_table& table)
  {
    std::vector<char> is_facet(table.size(), 0);
    for_each_cell(m_cells.number, m_executor,
                  [&](std::size_t c) { cross_facets_of(c, table, is_facet); });
    table.for_each([&](std::uint32_t v, std::uint32_t r) {
      if (!is_facet[r] && table[r].number != 0)
        m_no_facets.emplace_back(Triangle_3d{m_cells.points[v], m_cells.points[table[r].middle],
                                             m_cells.points[table[r].greatest]},
                                 table[r].number);
    });
  }

  void cross_facets_of(std::size_t c, const Triangle_table& table, std::vector<char>& is_facet)
  {
    const auto neighbors = m_cells.neighbors_of(c);
    const auto v = m_cells.vertices_of(c);
    for (std::size_t k = 0; k < 4; ++k) {
      if (std::size_t(neighbors[k]) < c)
        continue;
      const auto at = [&](std::size_t i) { return std::uint32_t(v[(k + i) % 4]); };
      const Corners facet = {at(1), at(2), at(3)};
      const std::uint32_t r = table.find(ascending(facet));
      if (r == Triangle_table::none)
        continue;
      is_facet[r] = 1;
      const bool is_inward = is_turned(facet) != (k % 2 == 1); // when its vertices are sorted
      m_jumps[c][k] = as_jump(is_inward ? table[r].number : -table[r].number);
    }
  }

  void cross_others(const Box_tree& tree)
  {
    for_each_cell(m_cells.number, m_executor, [&](std::size_t c) {
      const Jumps crossings = Crossings::of(tree, m_cells, c);
      for (std::size_t k = 0; k < 4; ++k)
        m_jumps[c][k] = crossings[k] == unknown_jump || m_jumps[c][k] == unknown_jump
                            ? std::int8_t(unknown_jump)
                            : as_jump(crossings[k] + m_jumps[c][k]);
    });
  }

  // Places a tetrahedron in a set; `number` is its winding number minus that of the root.
  struct Place
  {
    std::uint32_t root;
    std::int32_t number;
  };

  // Joins tetrahedra between which a path is known, and the outside, which is the last element.
  void join()
  {
    const std::size_t m = m_cells.number;
    m_places.reserve(m + 1);
    for (std::uint32_t c = 0; c <= m; ++c)
      m_places.push_back({c, 0});
    Steps step(m_executor);
    for (std::size_t c = 0; c < m; ++c, step()) {
      const auto neighbors = m_cells.neighbors_of(c);
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t d = (std::min)(std::size_t(neighbors[k]), m);
        if (d < c || m_jumps[c][k] == unknown_jump)
          continue;
        const int back = d < m ? jump_to(d, c) : 0;
        if (back != unknown_jump)
          join(std::uint32_t(c), std::uint32_t(d), m_jumps[c][k] - back);
      }
    }
  }

  // Joins c and d, where the number of d exceeds the number of c by the difference.
  void join(std::uint32_t c, std::uint32_t d, int difference)
  {
    const Place p = place(c), q = place(d);
    if (p.root < q.root) // the smaller root wins, which keeps the trees flat
      m_places[q.root] = {p.root, p.number + difference - q.number};
    else if (p.root > q.root)
      m_places[p.root] = {q.root, q.number - difference - p.number};
  }

  // Finds the root, whose number is 0, and halves the path to it.
  Place place(std::uint32_t c)
  {
    std::int32_t number = 0;
    while (m_places[c].root != c) {
      Place& p = m_places[c];
      const Place& next = m_places[p.root];
      p = {next.root, p.number + next.number};
      number += p.number;
      c = p.root;
    }
    return {c, number};
  }

  int jump_to(std::size_t d, std::size_t c) const
  {
    const Jumps& jumps = m_jumps[d];
    if ((jumps[0] | jumps[1] | jumps[2] | jumps[3]) == 0)
      return 0;
    const auto neighbors = m_cells.neighbors_of(d);
    std::size_t k = 0;
    while (std::size_t(neighbors[k]) != c)
      ++k;
    return jumps[k];
  }

  static double inradius(const std::array<Vector_3d, 4>& p)
  {
    const Vector_3d a = minus(p[1], p[0]), b = minus(p[2], p[0]), c = minus(p[3], p[0]);
    const auto area = [](const Vector_3d& u, const Vector_3d& v) {
      const Vector_3d n = cross(u, v);
      return std::sqrt(dot(n, n));
    };
    const double areas = area(a, b) + area(b, c) + area(c, a) + area(minus(b, a), minus(c, a));
    return areas > 0 ? std::abs(dot(a, cross(b, c))) / areas : 0;
  }

  const Cells& m_cells;
  const Executor& m_executor;
  std::vector<Cutting_triangle> m_no_facets;
  std::vector<Jumps> m_jumps;
  std::vector<Place> m_places;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_REGIONS_H
