// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_COMPACT_PREDICATES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_COMPACT_PREDICATES_H

// Is a cell in conflict with a point? Signs come from the first filter; else, on a lattice,
// from integers, elsewhere from the close filter; else exact and perturbed.

#include <CGAL/Delaunay_from_surface_3/internal/compact/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/internal/compact/Double_double.h>
#include <CGAL/Delaunay_from_surface_3/internal/compact/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/internal/compact/flat_beyond_sign.h>
#include <CGAL/Delaunay_from_surface_3/internal/compact/integer_sphere_sign.h>
#include <CGAL/Delaunay_from_surface_3/internal/compact/lattice_sphere_sign.h>

#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// What the insertions did.
struct Compact_counts
{
  std::size_t cells_tested_to_start = 0; // until one in conflict was found
  std::size_t cells_destroyed = 0;
  std::size_t cells_created = 0;
  std::size_t sphere_tests = 0;    // of neighbours of cells in conflict
  std::size_t first_failures = 0;  // sphere tests that the first filter left open
  std::size_t second_failures = 0; // and the second too
};

// Exact: as Perturbed_predicates, on indices of points. The new point is given by its index i and
// its coordinates p.
template <class Id, class Exact>
class Compact_predicates
{
  using Complex = Compact_complex<Id>;
  using Cell = Compact_cell<Id>;

public:
  // Keeps references to both.
  Compact_predicates(const Exact& exact, const Complex& complex)
    : m_exact(exact)
    , m_complex(complex)
    , m_point_of(1, 0)
  {
  }

  // The next vertex is at point i.
  void add_vertex(std::size_t i) { m_point_of.push_back(i); }
  void reserve(std::size_t n) { m_point_of.reserve(n + 1); }

  // The index of the point at vertex v, finite.
  std::size_t point_of(std::size_t v) const { return m_point_of[v]; }

  const double* coordinates(Id v) const { return m_complex.vertex(v).coordinates; }

  Compact_counts& counts() const { return m_counts; }

  // The vertex of the cell at the place of point i, or 0.
  Id vertex_at(const Cell& cell, std::size_t i) const
  {
    for (const Id v : cell.v)
      if (v != Complex::infinite && m_exact.are_equal(m_point_of[v], i))
        return v;
    return 0;
  }

  // A facet of the finite cell that point i lies beyond: the one it seems farthest from.
  unsigned facet_towards(const Cell& cell, const Cell_view& view, std::size_t i) const
  {
    unsigned farthest = 0;
    for (unsigned k = 1; k < 4; ++k)
      if (view.facets[k] < view.facets[farthest])
        farthest = k;
    if (view.facets[farthest] < -view.facet_bound)
      return farthest;
    for (unsigned k = 0; k < 4; ++k)
      if (view.facets[k] <= view.facet_bound && orientation(cell, k, i) == NEGATIVE)
        return k;
    CGAL_error_msg("a cell that contains a point must be in conflict with it");
  }

  Orientation orientation(const Cell& cell, unsigned k, std::size_t i) const
  {
    return m_exact.orientation(i, m_point_of[cell.v[k ^ 1]], m_point_of[cell.v[k ^ 2]],
                               m_point_of[cell.v[k ^ 3]]);
  }

  // Of an infinite cell: 1 if p is beyond its finite facet, -1 if before, 0 if not decided.
  int beyond_sign(const Cell& cell, const double* p) const
  {
    return -orientation_sign(Row(coordinates(Complex::first_vertex(cell)), p),
                             Row(coordinates(cell.v[1]), p), Row(coordinates(cell.v[2]), p));
  }

  bool is_beyond_exactly(const Cell& cell, std::size_t i, const double* p) const
  {
    const Id v0 = Complex::first_vertex(cell);
    const double* const v[3] = {coordinates(v0), coordinates(cell.v[1]), coordinates(cell.v[2])};
    if (const int flat = flat_beyond_sign(v, p))
      return flat > 0;
    const std::size_t q[3] = {m_point_of[v0], m_point_of[cell.v[1]], m_point_of[cell.v[2]]};
    Integer_sign integer = integer_beyond_sign(v, p);
    if (!integer.is_known)
      integer = lattice_beyond_sign(v, p);
    if (!integer.is_known)
      return m_exact.is_beyond(q[0], q[1], q[2], i);
    if (integer.sign != 0)
      return integer.sign > 0;
    return m_exact.is_perturbed_into_circle(q[0], q[1], q[2], i);
  }

  // What the first filter left open.
  bool is_in_close_sphere(const Cell& cell, std::size_t i, const double* p) const
  {
    ++m_counts.first_failures;
    const Id v0 = Complex::first_vertex(cell);
    const double* const v[4] = {coordinates(v0), coordinates(cell.v[1]), coordinates(cell.v[2]),
                                coordinates(cell.v[3])};
    Integer_sign integer = integer_sphere_sign(v, p);
    if (!integer.is_known) {
      const int close = m_is_fused ? fused_close_sphere_sign(v, p) : close_sphere_sign(v, p);
      if (close != 0)
        return close > 0;
      integer = lattice_sphere_sign(v, p);
    }
    if (integer.is_known && integer.sign != 0)
      return integer.sign > 0;
    ++m_counts.second_failures;
    const std::size_t q[4] = {m_point_of[v0], m_point_of[cell.v[1]], m_point_of[cell.v[2]],
                              m_point_of[cell.v[3]]};
    return integer.is_known ? m_exact.is_perturbed_into_sphere(q[0], q[1], q[2], q[3], i)
                            : m_exact.is_in_sphere(q[0], q[1], q[2], q[3], i);
  }

  // The same for any cell, with all filters.
  bool is_in_conflict(const Cell& cell, std::size_t i, const double* p) const
  {
    if (Complex::is_infinite(cell)) {
      const int sign = beyond_sign(cell, p);
      return sign != 0 ? sign > 0 : is_beyond_exactly(cell, i, p);
    }
    const int sign = sphere_sign(Row(coordinates(cell.v[0]), p), Row(coordinates(cell.v[1]), p),
                                 Row(coordinates(cell.v[3]), p), Row(coordinates(cell.v[2]), p));
    return sign != 0 ? sign > 0 : is_in_close_sphere(cell, i, p);
  }

private:
  const Exact& m_exact;
  const bool m_is_fused = has_fused_products();
  const Complex& m_complex;
  std::vector<std::size_t> m_point_of;
  mutable Compact_counts m_counts;
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_COMPACT_COMPACT_PREDICATES_H
