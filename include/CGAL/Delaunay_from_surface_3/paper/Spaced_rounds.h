// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_SPACED_ROUNDS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_SPACED_ROUNDS_H

// The public face of core/order/spaced_rounds.h.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Order_request.h>
#include <CGAL/Delaunay_from_surface_3/paper/Geometric_rounds.h>
#include <CGAL/Delaunay_from_surface_3/paper/order_by_core.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Plans

makes rounds of well-spaced points without using a surface. The points are sorted once by halves, as
`Geometric_rounds` sorts a round. Along that order a point becomes a centre unless one of the last
six centres is nearer than .35 of the diagonal of a box of eight successive points: the root mean
square over the point's own box and the two beside it. The points that are not centres form the last
round. The same is done with the centres to get the round before, and so on, until at most 64 are
left. If fewer than an eighth of the points are near a centre, only every second centre is kept.
Each point starts at its centre (`Insertion_order::starting_places`).

Points that come late are crowded, and so destroy few cells. This was measured on surfaces and in
volumes. No bound is proved, so there is a budget.

<b>Complexity</b>: \f$O(n \log n)\f$ for n points.

\cgalModels{InsertionPlan}
*/
class Spaced_rounds
{
public:
  /// the budget (`InsertionPlan::cells_per_point`).
  static constexpr std::size_t cells_per_point = internal::cells_per_point_of_nets;

  /// makes the plan. Only `fallback_plan()` uses the seed: this order has no random numbers.
  explicit Spaced_rounds(unsigned int seed = 0)
    : m_seed(seed)
  {
  }

  /// returns order, rounds and starting places of `points`. The graph is not used.
  template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
  Insertion_order operator()(const std::vector<Point>& points, const GeomTraits&, const Graph&,
                             VertexIndexMap) const
  {
    return internal::order_by_core(points, order_request());
  }

  /// returns the plan that is used when the budget is exceeded; the bound of \cgalCite{acr-icbr-03}
  /// holds for it.
  Geometric_rounds fallback_plan() const { return Geometric_rounds(m_seed); }

  /// \cond
  using Plan_of_core = Spaced_rounds;

  internal::Order_request order_request() const
  {
    internal::Order_request request;
    request.kind = internal::Order_request::SPACED;
    request.seed = m_seed;
    return request;
  }
  /// \endcond

private:
  unsigned int m_seed;
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_SPACED_ROUNDS_H
