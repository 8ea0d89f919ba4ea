// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_COMPACT_PREDICATES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_COMPACT_PREDICATES_H

// Decides whether a cell is in conflict with a point. The stages are asked in this order, and each
// leaves open what it cannot decide. The costs are for a sphere test, in ns (measure_predicates), to
// the end of the stage:
//
//   stage           what it decides                                  cost  header
//   first filter    signs farther from 0 than doubles err              15  Sphere_filter.h
//   flat circle     infinite cells in planes across an axis             -  flat_beyond_sign()
//   LATTICE         points close together on a lattice, 0 included     -  exact_signs.h
//   HALF_DIGIT      differences as integers of 30 bits, 0 included     80  exact_signs.h
//   ONE_DIGIT       the same of 60 bits                               135  exact_signs.h
//   BALANCED        doubles, of points in a flat box,                   -  Sphere_filter.h
//                   or at very different distances                      -  balanced_signs.h
//   DOUBLE_DOUBLE   farther from 0 than sums of two doubles err       240  Double_double.h
//   TWO_DIGITS      integers of 120 bits, 0 included                  440  exact_signs.h
//   ANY_WIDTH       all that is left                                    -  Big_integer.h
//
// Where the sign is 0, the stage goes on with CGAL's perturbation. Sheets are flat all over: where
// the last test was decided in a flat box, the columns are asked before the integers.

#include <CGAL/Delaunay_from_surface_3/Insertion_counts.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/exact_signs.h>
#include <CGAL/Delaunay_from_surface_3/support/assertions.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The flat sides of parts are parallel to the axes more often than not, and have a great many
// points. There the test against an infinite cell is that against a circle in a plane, in two
// coordinates.
//
// A determinant of rows (s, t, w) is a sum of 6 products s t w; each goes through at most 11
// roundings, 1 + 1 + 4 of them in its factors. Where m bounds all w the products sum up to at most
// 3 m^2 in absolute value, so the error is at most 33 u m^2, and a bit: less than 40 u m^2 with
// u = 2^-53 (44 u m^2 with weights, where m bounds sizes). In the same way that of the area is less
// than 20 u m.
//
// Where that leaves something open in a thin box, there are the bounds by columns: with S, T and W
// their largest, 66 u S T W and a bit, less than 80 u S T W; the area has 6 products of 6
// roundings, less than 40 u S T. Underflow: as in Sphere_filter.h.

// The axis to which the plane of p and three vertices is orthogonal; 3 if there is none.
template <class Place>
int axis_across(const Place* vertices, Place p)
{
  int axis = 0;
  while (axis < 3 && !(vertices[0][axis] == p[axis] && vertices[1][axis] == p[axis] &&
                       vertices[2][axis] == p[axis]))
    ++axis;
  return axis;
}

inline constexpr double Row<double>::*columns_of_row[3] = {&Row<double>::x, &Row<double>::y,
                                                           &Row<double>::z};

// Where the points lie in a long and thin box. `m` is the largest size of the rows.
CGAL_DELAUNAY_FROM_SURFACE_3_APART int circle_sign_by_columns(const Row<double>* rows, double m,
                                                              int axis)
{
  const Column_sizes sizes(rows[0], rows[1], rows[2]);
  const double edges[3] = {sizes.x, sizes.y, sizes.z};
  const double box = edges[(axis + 1) % 3] * edges[(axis + 2) % 3];
  if (box > 0x1p-10 * m)
    return 0;
  const Circle_cofactors<double> cofactors(rows, columns_of_row[(axis + 1) % 3],
                                           columns_of_row[(axis + 2) % 3]);
  return certified_sign(cofactors.area, 40 * Filter_bounds::unit * box + Column_sizes::tiny) *
         certified_sign(cofactors.lifted(rows),
                        80 * Filter_bounds::unit * box * m + Column_sizes::tiny);
}

// If p and the facet (a, b, c) of the convex hull lie in a plane orthogonal to an axis: 1 if p is
// inside the facet's circle, -1 if it is outside. 0: not decided.
template <class Place>
int flat_beyond_sign(const Place* vertices, Place p)
{
  using R = Row_of<Place>;
  const int axis = axis_across(vertices, p);
  if (axis == 3)
    return 0;
  const R sized[3] = {row(vertices[0], p), row(vertices[1], p), row(vertices[2], p)};
  const Row<double> rows[3] = {sized[0], sized[1], sized[2]};
  const Circle_cofactors<double> cofactors(rows, columns_of_row[(axis + 1) % 3],
                                           columns_of_row[(axis + 2) % 3]);
  const double m = largest_size(sized[0], sized[1], sized[2]), value = cofactors.lifted(rows);
  const int sign =
      certified_sign(cofactors.area, 20 * Filter_bounds::unit * m + Filter_bounds::tiny) *
      certified_sign(value,
                     Bound_factors<R>::circle * Filter_bounds::unit * m * m + Filter_bounds::tiny);
  return sign != 0 || value == 0 ? sign : circle_sign_by_columns(rows, m, axis);
}

// By columns, in vectors where the machine has them.
template <class Place>
int flat_sphere_sign(const Place* vertices, Place p)
{
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS
  if (machine_has_vectors())
    return wide_sphere_sign_by_columns(vertices, p);
#endif
  return sphere_sign_by_columns(vertices, p);
}

// The predicates of insertions, one after another. The new point is a vertex p, in no cell yet.
template <class Vertex>
class Compact_predicates
{
  using Complex = Compact_complex<Vertex>;
  using Cell = Compact_cell;
  using Place = typename Vertex::Place;
  using Exact_place = typename Vertex::Exact_place;

public:
  // Keeps references to both.
  Compact_predicates(const Complex& complex, Insertion_counts& counts)
    : m_complex(complex)
    , m_counts(counts)
  {
  }

  void count_cell_tested_to_start() { ++m_counts.cells_tested_to_start; }

  // The vertex of the cell that has the coordinates of p, and its weight, or 0.
  Id vertex_at(const Cell& cell, Id p) const
  {
    const auto q = m_complex.exact_place(p);
    for (const Id v : cell.v)
      if (v != Complex::infinite && are_equal(q, m_complex.exact_place(v)))
        return v;
    return 0;
  }

  // A facet of the finite cell that p lies beyond: one opposite to a vertex far from p. A walk that
  // drops far vertices first turns around a near one, and stays where cells are small; where p is
  // far from all, it goes where p is farthest beyond. (The fourth power was measured.) 4 if the cell
  // contains p, which is then hidden, as it is not in conflict.
  unsigned facet_towards(const Cell& cell, const Cell_view& view, Id p) const
  {
    unsigned farthest = 0;
    for (unsigned k = 1; k < 4; ++k)
      if (view.pushes[k] < view.pushes[farthest])
        farthest = k;
    return view.facets[farthest] < -view.facet_bound ? farthest : close_facet(cell, view, p);
  }

  // Returns for an infinite cell 1 if p is beyond its finite facet, -1 if before, 0 if undecided.
  int beyond_sign(const Cell& cell, Place p) const
  {
    return core::beyond_sign(row(place(Complex::first_vertex(cell)), p), row(place(cell.v[1]), p),
                             row(place(cell.v[2]), p));
  }

  bool is_beyond_exactly(const Cell& cell, Id p)
  {
    const auto at = [this](Id v) { return m_complex.exact_place(v); };
    const Exact_place v[3] = {at(Complex::first_vertex(cell)), at(cell.v[1]), at(cell.v[2])};
    const Exact_place q = at(p);
    if constexpr (!is_rounded<Place>) {
      if (!m_complex.is_rounded())
        if (const int flat = flat_beyond_sign(v, q))
          return flat > 0;
      if (m_is_flat)
        if (const int sign = beyond_sign_by_columns(v, q))
          return sign > 0;
    }
    const Exact_sign exact = exact_sign_of<Exact_beyond>(v, q);
    ++m_counts.facet_tests_by_stage[exact.stage];
    m_counts.perturbed += exact.is_perturbed;
    return exact.sign > 0;
  }

  // Decides what the first filter left open.
  bool is_in_close_sphere(const Cell& cell, Id p)
  {
    return m_is_flat ? is_in_flat_sphere(cell, p) : is_in_sphere_exactly(cell, p);
  }

  // The same for any cell, with all filters.
  CGAL_DELAUNAY_FROM_SURFACE_3_APART bool is_in_conflict(const Cell& cell, Id p)
  {
    const Place q = place(p);
    if (Complex::is_infinite(cell)) {
      const int sign = beyond_sign(cell, q);
      return sign != 0 ? sign > 0 : is_beyond_exactly(cell, p);
    }
    const int sign = sphere_sign(row(place(cell.v[0]), q), row(place(cell.v[1]), q),
                                 row(place(cell.v[2]), q), row(place(cell.v[3]), q));
    return sign != 0 ? sign > 0 : is_in_close_sphere(cell, p);
  }

private:
  bool is_in_sphere_exactly(const Cell& cell, Id p)
  {
    const auto at = [this](Id v) { return m_complex.exact_place(v); };
    const Exact_place v[4] = {at(Complex::first_vertex(cell)), at(cell.v[1]), at(cell.v[2]),
                              at(cell.v[3])};
    const Exact_place q = at(p);
    const Exact_sign exact = exact_sign_of<Exact_sphere>(v, q);
    ++m_counts.sphere_tests_by_stage[exact.stage];
    m_counts.perturbed += exact.is_perturbed;
    m_is_flat = exact.is_flat || (!is_rounded<Place> && exact.stage != LATTICE &&
                                  exact.stage <= ONE_DIGIT && !exact.is_perturbed &&
                                  (m_is_flat || ++m_integer_signs % 32 == 0) && is_flat(cell, p));
    return exact.sign > 0;
  }

  template <class Determinant>
  Exact_sign exact_sign_of(const Exact_place* vertices, Exact_place p) const
  {
    if constexpr (!is_rounded<Place>) {
      if (m_complex.is_rounded())
        return wide_sign<Determinant>(vertices, p);
      if (m_complex.exact_size() > 0) {
        const auto exact = lattice_sign<Determinant>(vertices, p, m_complex.exact_size());
        if (exact.sign != 0)
          return exact;
      }
    }
    return exact_sign<Determinant>(vertices, p);
  }

  // Coordinates of few bits are integers before columns are asked, which take less time. (Of sheets
  // and curves such as (t, t^2, t^3); one test in 32 shows whether there are any.)
  CGAL_DELAUNAY_FROM_SURFACE_3_APART bool is_flat(const Cell& cell, Id p) const
  {
    return column_sizes(cell, place(p)).are_flat();
  }

  CGAL_DELAUNAY_FROM_SURFACE_3_APART bool is_in_flat_sphere(const Cell& cell, Id p)
  {
    const Place v[4] = {place(Complex::first_vertex(cell)), place(cell.v[1]), place(cell.v[2]),
                        place(cell.v[3])};
    const int sign = flat_sphere_sign(v, place(p));
    return sign != 0 ? sign > 0 : is_in_sphere_exactly(cell, p);
  }

  // Tiny coordinates make the pushes underflow first; a flat cell makes the bound too large.
  unsigned close_facet(const Cell& cell, const Cell_view& view, Id p) const
  {
    const double bound =
        is_rounded<Place>
            ? view.facet_bound
            : (std::min)(view.facet_bound, column_sizes(cell, place(p)).bound_of_three());
    for (unsigned k = 0; k < 4; ++k)
      if (view.facets[k] < -bound)
        return k;
    for (unsigned k = 0; k < 4; ++k)
      if (view.facets[k] <= bound && is_beyond_facet(cell, k, p))
        return k;
    if constexpr (!Vertex::has_weight)
      fail("a cell that contains a point must be in conflict with it");
    return 4;
  }

  Column_sizes column_sizes(const Cell& cell, Place q) const
  {
    return Column_sizes(row(place(Complex::first_vertex(cell)), q), row(place(cell.v[1]), q),
                        row(place(cell.v[2]), q), row(place(cell.v[3]), q));
  }

  bool is_beyond_facet(const Cell& cell, unsigned k, Id p) const
  {
    const auto at = [this](Id v) { return position_of(m_complex.exact_place(v)); };
    using Position = decltype(at(p));
    const Position v[3] = {at(cell.v[k ^ 1]), at(cell.v[k ^ 2]), at(cell.v[k ^ 3])};
    const Position q = at(p);
    int sign = 0;
    if constexpr (!is_rounded<Place>)
      sign = m_complex.is_rounded() ? 0 : balanced_sign<3>(v, q).sign;
    return (sign != 0 ? sign : orientation(q, v[0], v[1], v[2])) < 0;
  }

  Place place(Id v) const { return m_complex.place(v); }

  const Complex& m_complex;
  Insertion_counts& m_counts;
  bool m_is_flat = false;       // whether columns decided, or might have, the last test left open
  unsigned m_integer_signs = 0; // tests that integers of few bits decided
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_COMPACT_PREDICATES_H
