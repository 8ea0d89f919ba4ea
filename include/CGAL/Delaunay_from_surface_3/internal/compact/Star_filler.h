// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_STAR_FILLER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_STAR_FILLER_H

// Fills a hole with the star of a vertex (Choi 2002, Fig. 1, line 2c: "update"): one cell for each
// facet of the hole's boundary.
//
// Two new cells are neighbours if their facets share an edge. Each facet writes its links to a
// table under its three directed edges; the neighbour across an edge stands under its reverse. The
// boundary is a sphere of B facets, so it has B/2 + 2 vertices; they are labelled 0, 1, … on the
// way. The table is small, never cleared, and stays in the cache. Large holes sort their edges
// instead.
//
// Cost: O(B); O(B log B) for large holes.

#include <CGAL/Delaunay_from_surface_3/internal/compact/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/internal/compact/Explore_neighbors.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

template <class Id>
class Star_filler
{
  using Complex = Compact_complex<Id>;
  using Facet = Hole_facet<Id>;

public:
  static constexpr std::size_t small_side = 32, side = 64;
  // So many facets can have `side` vertices.
  static constexpr std::size_t max_table_facets = 2 * side - 4;

  Star_filler()
    : m_table(side * side)
  {
  }

  // Makes cells[f] the cell of p and of facets[f], 0 <= f < n. The facets' corners become labels.
  void operator()(Complex& complex, Id p, Facet* facets, const Id* cells, std::size_t n)
  {
    if (std::size_t((std::numeric_limits<Id>::max)() - m_base) < complex.number_of_vertices())
      forget_labels(complex);
    if (n <= 2 * small_side - 4) {
      fill<small_side>(complex, p, facets, cells, n);
    } else if (n <= max_table_facets) {
      fill<side>(complex, p, facets, cells, n);
    } else {
      make_cells(complex, p, facets, cells, n, [](Id, Id, Id, Id) {});
      link_sorted(complex, facets, cells, n);
    }
    complex.vertex(p).cell = cells[0];
  }

private:
  template <std::size_t Side>
  void fill(Complex& complex, Id p, Facet* facets, const Id* cells, std::size_t n)
  {
    Id* const table = m_table.data();
    make_cells(complex, p, facets, cells, n, [table](Id a, Id b, Id d, Id c) {
      table[b * Side + d] = Complex::link(c, 1);
      table[d * Side + a] = Complex::link(c, 2);
      table[a * Side + b] = Complex::link(c, 3);
    });
    typename Complex::Cell* const pool = complex.cells();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t a = facets[i].corners[0], b = facets[i].corners[1],
                        d = facets[i].corners[2];
      Id* const links = pool[cells[i]].links;
      links[1] = table[d * Side + b];
      links[2] = table[a * Side + d];
      links[3] = table[b * Side + a];
    }
  }

  // Vertices and outer links of the cells. Corners are replaced by their labels. `then` is given
  // these and the cell.
  template <class Then>
  void make_cells(Complex& complex, Id p, Facet* facets, const Id* cells, std::size_t n,
                  const Then& then)
  {
    typename Complex::Cell* const pool = complex.cells();
    typename Complex::Vertex* const vertices = complex.vertices();
    const Id base = m_base;
    Id count = 0;
    for (std::size_t i = 0; i < n; ++i) {
      Facet& f = facets[i];
      const Id c = cells[i];
      const Id outside = f.outside;
      typename Complex::Cell& cell = pool[c];
      static_assert(sizeof(cell.v) == sizeof(f), "a facet is a cell without its first vertex");
      std::memcpy(cell.v, &f, sizeof(f));
      cell.v[0] = p;
      cell.links[0] = outside;
      pool[outside >> 2].links[outside & 3] = Complex::link(c, 0);
      for (Id& corner : f.corners) {
        typename Complex::Vertex& vertex = vertices[corner];
        vertex.cell = c;
        corner = label(vertex.label, base, count);
      }
      then(f.corners[0], f.corners[1], f.corners[2], c);
    }
    m_base = Id(base + count);
  }

  // Labels 0, 1, … are kept as m_base + 0, m_base + 1, …: what is left from earlier holes is less
  // than m_base, and so beyond every label after the subtraction. No branch: it would not be
  // predicted.
  static Id label(Id& kept, Id base, Id& count)
  {
    Id l = Id(kept - base);
    const bool is_new = l >= count;
    l = is_new ? count : l;
    count = Id(count + is_new);
    kept = Id(base + l);
    return l;
  }

  void forget_labels(Complex& complex)
  {
    for (std::size_t v = 0; v < complex.number_of_vertices(); ++v)
      complex.vertex(v).label = 0;
    m_base = 1;
  }

  void link_sorted(Complex& complex, const Facet* facets, const Id* cells, std::size_t n)
  {
    m_edges.clear();
    for (std::size_t i = 0; i < n; ++i)
      for (unsigned k = 0; k < 3; ++k) {
        const std::uint64_t a = facets[i].corners[(k + 1) % 3], b = facets[i].corners[(k + 2) % 3];
        m_edges.emplace_back((std::min)(a, b) << 32 | (std::max)(a, b),
                             Complex::link(cells[i], k + 1));
      }
    std::sort(m_edges.begin(), m_edges.end());
    for (std::size_t e = 0; e + 1 < m_edges.size(); e += 2) {
      const Id s = m_edges[e].second, t = m_edges[e + 1].second;
      complex.cell(s >> 2).links[s & 3] = t;
      complex.cell(t >> 2).links[t & 3] = s;
    }
  }

  std::vector<Id> m_table;
  Id m_base = 1;
  std::vector<std::pair<std::uint64_t, Id>> m_edges;
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_STAR_FILLER_H
