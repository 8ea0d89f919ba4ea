// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PLAN_GEOMETRIC_ROUNDS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PLAN_GEOMETRIC_ROUNDS_H

// A biased randomised insertion order (Amenta, Choi, Rote 2003): rounds that grow
// geometrically, each in a spatially coherent order.

#include <CGAL/Delaunay_from_surface_3/core/order/Sort_by_halves.h>
#include <CGAL/Delaunay_from_surface_3/internal/plan/order_of_indices.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Plans

draws a random order and cuts it into rounds that grow geometrically; each round is then sorted by
halves: across the longest extent at the median, the half that is nearer to the point before comes
first, and so on. This is a biased randomised insertion order (\cgalCite{acr-icbr-03}): random
enough for the expected size of the conflict zones, coherent enough for short walks and warm caches.

Expected \f$O(n \log n)\f$ for n points.

\cgalModels{InsertionPlan}
*/
class Geometric_rounds
{
public:
  /*!
  makes the plan.

  \param seed draws the random order
  \param ratio the size of everything before a round, divided by the size of everything up to its
  end
  \param first_round rounds are cut off until at most so many points are left for the first

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

  /// returns order and rounds of `points`. The graph is not looked at.
  template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
  Insertion_order operator()(const std::vector<Point>& points, const GeomTraits&, const Graph&,
                             VertexIndexMap) const
  {
    using namespace Delaunay_from_surface_3::internal;
    Insertion_order plan;
    plan.order = random_order(points.size(), m_seed);
    plan.round_ends = round_ends(points.size());
    const auto coordinates = [&](std::size_t i) {
      const Point& p = points[i];
      return std::array<double, 3>{to_double(p.x()), to_double(p.y()), to_double(p.z())};
    };
    Sort_by_halves sort;
    auto first = plan.order.begin();
    for (const std::size_t end : plan.round_ends) {
      const auto last = plan.order.begin() + std::ptrdiff_t(end);
      sort(coordinates, first, last);
      first = last;
    }
    return plan;
  }

  /// returns …, ⌊ratio ⌊ratio n⌋⌋, ⌊ratio n⌋, n; nothing for n = 0.
  std::vector<std::size_t> round_ends(std::size_t n) const
  {
    std::vector<std::size_t> ends;
    for (std::size_t end = n; end > 0;) {
      ends.push_back(end);
      end = end <= m_first_round ? 0 : static_cast<std::size_t>(std::floor(double(end) * m_ratio));
    }
    std::reverse(ends.begin(), ends.end());
    return ends;
  }

private:
  unsigned int m_seed;
  double m_ratio;
  std::size_t m_first_round;
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PLAN_GEOMETRIC_ROUNDS_H
