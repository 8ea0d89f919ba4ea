// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_WALK_TO_CONFLICT_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_WALK_TO_CONFLICT_H

// Choi 2002, Fig. 1, line 2b, says: "Locate s_i in D(S_{i-1})". Instead of the cell that contains
// the point, any cell in conflict with it will do (as in HXT: Marot, Pellerin, Remacle 2019), and
// from a good start the walk reaches one almost at once.
//
// It goes towards the point, through facets that the point lies beyond (Compact_predicates.h says
// which), until a cell is in conflict with the point. The cell that contains the point is in
// conflict with it, unless the point is one of its vertices, or is hidden by them, as with weights
// it may be; in a Delaunay or regular triangulation no such walk runs in a circle, whichever facets
// it takes. Cost: O(1) per cell.

#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Dig_conflict_zone.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/exact_signs.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Says where a point goes: to a cell in conflict with it, or else to the vertex at its place.
struct Compact_location
{
  Id cell;
  Id vertex; // 0 if there is no vertex at this place; the walking one if the cell hides it
};

// Reads cells where they are, since no other thread writes.
struct Read_alone
{
  const Compact_cell& operator()(const Compact_cell& cell) const { return cell; }
  static constexpr bool is_lost() { return false; }
};

// Filter is the first stage of the predicates, scalar or in vectors.
template <class Filter, class Read = Read_alone>
struct Walk_to_conflict
{
  // Walks from cell c to the place of vertex p, which is in no cell. Beside others that write,
  // `read` may get lost; the result is then meaningless.
  template <class Vertex, class Predicates>
  Compact_location operator()(const Compact_complex<Vertex>& complex, Predicates& predicates, Id p,
                              Id c, Read&& read = Read()) const
  {
    using Complex = Compact_complex<Vertex>;
    const auto point = complex.place(p);
    for (;;) {
      predicates.count_cell_tested_to_start();
      const Compact_cell& cell = read(complex.cell(c));
      if (read.is_lost())
        return {c, 0};
      if (Complex::is_infinite(cell)) {
        const int sign = predicates.beyond_sign(cell, point);
        const Id w = sign == 0 ? predicates.vertex_at(cell, p) : Id(0);
        if (w != 0 || sign > 0 || (sign == 0 && predicates.is_beyond_exactly(cell, p)))
          return {c, w};
        c = cell.neighbors[3] >> 2;
        continue;
      }
      const typename Vertex::Place v[4] = {complex.place(cell.v[0]), complex.place(cell.v[1]),
                                           complex.place(cell.v[2]), complex.place(cell.v[3])};
      const Cell_view view = Filter::view(v, point);
      if (view.sphere > 0)
        return {c, 0};
      if (view.sphere == 0) {
        if (const Id w = predicates.vertex_at(cell, p))
          return {c, w};
        if (predicates.is_in_close_sphere(cell, p))
          return {c, 0};
      }
      const unsigned facet = predicates.facet_towards(cell, view, p);
      if (Vertex::has_weight && facet == 4)
        return {c, p};
      c = cell.neighbors[facet] >> 2;
    }
  }
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_WALK_TO_CONFLICT_H
