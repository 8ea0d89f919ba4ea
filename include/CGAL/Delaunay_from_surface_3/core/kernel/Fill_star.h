// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_FILL_STAR_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_FILL_STAR_H

// Fills the conflict zone with the star of the new vertex, the second half of Choi 2002, Fig. 1,
// line 2c: makes one cell for each facet of the zone's boundary (Bowyer 1981; Watson 1981).
//
// Two new cells are neighbours if their facets share an edge. Each new cell is written to a table
// under the three directed edges of its facet; its neighbour across an edge stands under the
// reverse edge. The boundary is a sphere of B facets, so it has B/2 + 2 vertices, which are
// labelled 0, 1, … as they are met. The table is small, is never cleared, and stays in the cache,
// an idea of HXT (Marot, Pellerin, Remacle 2019). Large zones sort their edges instead.
//
// Cost: O(B).

#include <CGAL/Delaunay_from_surface_3/core/kernel/Dig_conflict_zone.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Writes cells that no other thread reads.
template <class Vertex>
struct Write_alone
{
  using Cell = Compact_cell;
  using Label = decltype(Vertex::label);

  // Returns the label that an earlier zone has left, 0 at first.
  static Label& label(Vertex* vertices, Id v) { return vertices[v].label; }
  static void forget_labels(Compact_complex<Vertex>& complex)
  {
    for (std::size_t v = 0; v < complex.vertices_end(); ++v)
      complex.vertex(v).label = 0;
  }

  // Writes the cell of p and the facet, except for its neighbours across the facets at p.
  static void open(Cell& cell, Id p, const Zone_facet& facet)
  {
    static_assert(sizeof(cell.v) == sizeof(facet), "a facet is a cell without its first vertex");
    const Id outside = facet.outside;
    std::memcpy(cell.v, &facet, sizeof(facet));
    cell.v[0] = p;
    cell.neighbors[0] = outside;
  }
  static void set_outer_neighbor(Id& neighbor, Id to) { neighbor = to; }
  static void set_neighbor(Id& neighbor, Id to) { neighbor = to; }
  static void set_cell(Vertex* vertices, Id v, Id c) { vertices[v].cell = c; }
  static void set_cell_of_corners(Vertex* vertices, const Id* corners, Id c)
  {
    for (unsigned k = 0; k < 3; ++k)
      vertices[corners[k]].cell = c;
  }
  static void close(Cell&, Id) {} // the cell is complete
};

// Write says how shared data are written, alone or beside others that read (Explore_announced.h).
template <class Vertex, class Write = Write_alone<Vertex>>
class Fill_star
{
  using Complex = Compact_complex<Vertex>;
  using Zone = Conflict_zone;
  using Label = decltype(Vertex::label);

public:
  static constexpr std::size_t small_side = 32, side = 64;
  // A sphere with `side` vertices has this many facets.
  static constexpr std::size_t max_table_facets = 2 * side - 4;

  explicit Fill_star(Write write = Write())
    : m_table(new Id[side * side]) // entries that are read were written for the same star
    , m_write(std::move(write))
  {
  }

  // Makes the star of p from the zone's facets, whose corners are replaced by labels. The zone then
  // has the cells of the star.
  void operator()(Complex& complex, Zone& zone, Id p)
  {
    zone.take_cells_of_star(complex);
    const std::size_t n = zone.number_of_facets;
    if (std::size_t((std::numeric_limits<Label>::max)() - m_base) < complex.vertices_end())
      forget_labels(complex);
    m_write.set_cell(complex.vertices(), p, zone.cells[0]);
    if (n <= 2 * small_side - 4) {
      fill_by_table<small_side>(complex, zone, p);
    } else if (n <= max_table_facets) {
      fill_by_table<side>(complex, zone, p);
    } else {
      const Label first_label = m_base;
      make_cells(complex, zone, p, [](Id, Id, Id, Id) {});
      join_by_sorting(complex, zone, Label(m_base - first_label));
      for (std::size_t i = 0; i < n; ++i)
        m_write.close(complex.cell(zone.cells[i]), p);
    }
  }

private:
  template <std::size_t Side>
  void fill_by_table(Complex& complex, Zone& zone, Id p)
  {
    Id* const table = m_table.get();
    make_cells(complex, zone, p, [table](Id a, Id b, Id d, Id c) {
      table[b * Side + d] = Complex::encode(c, 1);
      table[d * Side + a] = Complex::encode(c, 2);
      table[a * Side + b] = Complex::encode(c, 3);
    });
    typename Complex::Cell* const cells = complex.cells();
    const Zone_facet* const facets = zone.facets.data();
    const Id* const of_star = zone.cells.data();
    for (std::size_t i = 0, n = zone.number_of_facets; i < n; ++i) {
      const Id* const corners = facets[i].corners;
      const std::size_t a = corners[0], b = corners[1], d = corners[2];
      typename Complex::Cell& cell = cells[of_star[i]];
      m_write.set_neighbor(cell.neighbors[1], table[d * Side + b]);
      m_write.set_neighbor(cell.neighbors[2], table[a * Side + d]);
      m_write.set_neighbor(cell.neighbors[3], table[b * Side + a]);
      m_write.close(cell, p);
    }
  }

  // Writes the vertices of the cells and their neighbours outside, and replaces corners by their
  // labels. Calls `then` with the labels and the cell.
  template <class Then>
  void make_cells(Complex& complex, Zone& zone, Id p, const Then& then)
  {
    typename Complex::Cell* const cells = complex.cells();
    typename Complex::Vertex* const vertices = complex.vertices();
    const Label base = m_base;
    Label count = 0;
    Zone_facet* const facets = zone.facets.data();
    const Id* const of_star = zone.cells.data();
    for (std::size_t i = 0, n = zone.number_of_facets; i < n; ++i) {
      const Zone_facet f = facets[i]; // a copy, which no store can change
      const Id c = of_star[i];
      m_write.open(cells[c], p, facets[i]);
      m_write.set_outer_neighbor(
          Complex::cell_of_neighbor(cells, f.outside).neighbors[f.outside & 3],
          Complex::encode(c, 0));
      m_write.set_cell_of_corners(vertices, f.corners, c);
      const Id a = label(m_write.label(vertices, f.corners[0]), base, count);
      const Id b = label(m_write.label(vertices, f.corners[1]), base, count);
      const Id d = label(m_write.label(vertices, f.corners[2]), base, count);
      facets[i].corners[0] = a, facets[i].corners[1] = b, facets[i].corners[2] = d;
      then(a, b, d, c);
    }
    m_base = Label(base + count);
  }

  // Labels 0, 1, … are kept as base + 0, base + 1, …. What is left from earlier zones is less than
  // base, so the subtraction makes it larger than every label. There is no branch, which could not
  // be predicted.
  static Label label(Label& kept, Label base, Label& count)
  {
    const Label old = Label(kept - base), l = old < count ? old : count;
    count = Label(count + 1 - (old < count));
    kept = Label(base + l);
    return l;
  }

  void forget_labels(Complex& complex)
  {
    m_write.forget_labels(complex);
    m_base = 1;
  }

  // Sorts the edges lexicographically, by counting, so that the two cells at an edge follow each
  // other.
  void join_by_sorting(Complex& complex, const Zone& zone, std::size_t number_of_labels)
  {
    m_edges.clear();
    for (std::size_t i = 0; i < zone.number_of_facets; ++i)
      for (unsigned k = 0; k < 3; ++k) {
        const Id* const corners = zone.facets[i].corners;
        const auto [lower, upper] = std::minmax(corners[(k + 1) % 3], corners[(k + 2) % 3]);
        m_edges.push_back({lower, upper, Complex::encode(zone.cells[i], k + 1)});
      }
    sort_edges(&Edge::upper, number_of_labels);
    sort_edges(&Edge::lower, number_of_labels);
    for (std::size_t e = 0; e + 1 < m_edges.size(); e += 2) {
      const Id s = m_edges[e].facet, t = m_edges[e + 1].facet;
      m_write.set_neighbor(complex.cell(s >> 2).neighbors[s & 3], t);
      m_write.set_neighbor(complex.cell(t >> 2).neighbors[t & 3], s);
    }
  }

  // Describes an edge of the zone's boundary: its ends, as labels, and the facet of a new cell that
  // contains it, encoded as a neighbour.
  struct Edge
  {
    Id lower, upper, facet;
  };

  // Sorts the edges by one of their ends, stably.
  void sort_edges(Id Edge::*end, std::size_t number_of_labels)
  {
    m_first.assign(number_of_labels + 1, 0);
    for (const Edge& e : m_edges)
      ++m_first[e.*end + 1];
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    m_sorted.resize(m_edges.size());
    for (const Edge& e : m_edges)
      m_sorted[m_first[e.*end]++] = e;
    m_edges.swap(m_sorted);
  }

  std::unique_ptr<Id[]> m_table;
  Write m_write;
  Label m_base = 1;
  std::vector<Edge> m_edges, m_sorted;
  std::vector<std::size_t> m_first;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_FILL_STAR_H
