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

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// A facet of a hole: the link of the cell outside, and the corners, such that (p, corners) is
// positive for p in the hole.
template <class Id>
struct Hole_facet
{
  Id outside;
  Id corners[3];
};

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
    if (m_labelled.size() < 3 * n + 1)
      m_labelled.resize(3 * n + 64);
    if (n <= 2 * small_side - 4) {
      fill<small_side>(complex, p, facets, cells, n);
    } else if (n <= max_table_facets) {
      fill<side>(complex, p, facets, cells, n);
    } else {
      make_cells(complex, p, facets, cells, n, [](const Facet&, Id) {});
      link_sorted(complex, facets, cells, n);
    }
    complex.vertex(p).cell = cells[0];
  }

private:
  template <std::size_t Side>
  void fill(Complex& complex, Id p, Facet* facets, const Id* cells, std::size_t n)
  {
    Id* const table = m_table.data();
    make_cells(complex, p, facets, cells, n, [table](const Facet& f, Id c) {
      const std::size_t a = f.corners[0], b = f.corners[1], d = f.corners[2];
      table[b * Side + d] = Complex::link(c, 1);
      table[d * Side + a] = Complex::link(c, 2);
      table[a * Side + b] = Complex::link(c, 3);
    });
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t a = facets[i].corners[0], b = facets[i].corners[1],
                        d = facets[i].corners[2];
      Id* const links = complex.cell(cells[i]).links;
      links[1] = table[d * Side + b];
      links[2] = table[a * Side + d];
      links[3] = table[b * Side + a];
    }
  }

  // Vertices and outer links of the cells. Corners are replaced by labels: a vertex is labelled if
  // and only if the list of the labelled holds it under its label, whatever is left from before.
  template <class Then>
  void make_cells(Complex& complex, Id p, Facet* facets, const Id* cells, std::size_t n,
                  const Then& then)
  {
    Id* const labelled = m_labelled.data();
    std::size_t count = 0;
    for (std::size_t i = 0; i < n; ++i) {
      Facet& f = facets[i];
      const Id c = cells[i];
      typename Complex::Cell& cell = complex.cell(c);
      cell.v[0] = p;
      cell.links[0] = f.outside;
      complex.cell(f.outside >> 2).links[f.outside & 3] = Complex::link(c, 0);
      for (unsigned k = 0; k < 3; ++k) {
        const Id v = f.corners[k];
        cell.v[k + 1] = v;
        typename Complex::Vertex& vertex = complex.vertex(v);
        std::size_t label = vertex.label;
        const bool is_new = label >= count || labelled[label] != v;
        label = is_new ? count : label;
        labelled[count] = v; // beyond the end, unless it is new
        count += is_new;
        vertex.cell = c;
        vertex.label = Id(label);
        f.corners[k] = Id(label);
      }
      then(f, c);
    }
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
  std::vector<Id> m_labelled;
  std::vector<std::pair<std::uint64_t, Id>> m_edges;
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_STAR_FILLER_H
