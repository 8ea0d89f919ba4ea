// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_GEOMETRIC_ROUNDS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_GEOMETRIC_ROUNDS_H

// The public face of core/order/geometric_rounds.h.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Order_request.h>
#include <CGAL/Delaunay_from_surface_3/core/order/geometric_round_ends.h>
#include <CGAL/Delaunay_from_surface_3/paper/order_by_core.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Plans

draws a random order and cuts it into rounds that grow geometrically. Each round is then sorted by
halves: it is split at the median across its longest extent, the half that is nearer to the
preceding point comes first, and so on. This is a biased randomised insertion order
(\cgalCite{acr-icbr-03}): random enough for the expected size of the conflict zones, and coherent
enough for short walks and good use of caches.

<b>Complexity</b>: expected \f$O(n \log n)\f$ for n points.

\cgalModels{InsertionPlan}
*/
class Geometric_rounds
{
public:
  /*!
  makes the plan.

  \param seed determines the random order
  \param ratio the number of points before a round, divided by the number of points up to its end
  \param first_round the largest number of points of the first round

  \pre 0 < `ratio` < 1
  \pre `first_round` > 0
  */
  explicit Geometric_rounds(unsigned int seed = 0, double ratio = 0.125,
                            std::size_t first_round = 64)
    : m_seed(seed)
    , m_ratio(ratio)
    , m_first_round(first_round)
  {
    CGAL_precondition(0 < ratio && ratio < 1 && first_round > 0);
  }

  /// returns order and rounds of `points`. The graph is not used.
  template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
  Insertion_order operator()(const std::vector<Point>& points, const GeomTraits&, const Graph&,
                             VertexIndexMap) const
  {
    return internal::order_by_core(points, order_request());
  }

  /// returns the round ends …, ⌊ratio ⌊ratio n⌋⌋, ⌊ratio n⌋, n, and none for n = 0.
  std::vector<std::size_t> round_ends(std::size_t n) const
  {
    return internal::geometric_round_ends(n, m_ratio, m_first_round);
  }

  /// \cond
  using Plan_of_core = Geometric_rounds;

  internal::Order_request order_request() const
  {
    internal::Order_request request;
    request.kind = internal::Order_request::GEOMETRIC;
    request.seed = m_seed;
    request.ratio = m_ratio;
    request.first_round = m_first_round;
    return request;
  }
  /// \endcond

private:
  unsigned int m_seed;
  double m_ratio;
  std::size_t m_first_round;
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_GEOMETRIC_ROUNDS_H
