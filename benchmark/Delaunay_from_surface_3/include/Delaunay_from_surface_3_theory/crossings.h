// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_CROSSINGS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_CROSSINGS_H

#include <cstddef>

namespace theory {

// Whether the triangle between two cells is finite and has neither p nor q for a vertex. The
// traverser also steps through others: outside the convex hull, and from a vertex of the hull to
// the outside.
template <class Triangulation>
bool is_crossed(const Triangulation& tr, typename Triangulation::Cell_handle from,
                typename Triangulation::Cell_handle to, const typename Triangulation::Point& p,
                const typename Triangulation::Point& q)
{
  for (int k = 0; k < 4; ++k) {
    const auto v = from->vertex(k);
    if (to->has_vertex(v) && (tr.is_infinite(v) || v->point() == p || v->point() == q))
      return false;
  }
  return true;
}

// How many finite triangles of the triangulation the segment from p to q goes through (Choi 2002,
// Lemma 2). The search for p begins at `hint`.
template <class Triangulation>
std::size_t number_of_crossings(const Triangulation& tr, const typename Triangulation::Point& p,
                                const typename Triangulation::Point& q,
                                typename Triangulation::Cell_handle hint)
{
  if (p == q || tr.dimension() < 3)
    return 0;
  std::size_t crossings = 0;
  auto cell = tr.segment_traverser_cells_begin(p, q, hint);
  const auto end = tr.segment_traverser_cells_end();
  for (auto last = cell.handle(); ++cell != end; last = cell.handle())
    crossings += is_crossed(tr, last, cell.handle(), p, q);
  return crossings;
}

} // namespace theory

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_CROSSINGS_H
