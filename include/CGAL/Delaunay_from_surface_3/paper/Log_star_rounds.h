// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_LOG_STAR_ROUNDS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_LOG_STAR_ROUNDS_H

// The plan of the paper for points that are located by walking.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/Random_log_star_rounds.h>
#include <CGAL/Delaunay_from_surface_3/paper/order_of_indices.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Plans

is the plan of the paper (\cgalCite{choi-dtsm-02}, §2 and Fig.\ 1), `Random_log_star_rounds`, with
one difference: the first round follows a Hilbert curve. It has no trace before it to start from,
and a walk from one random point to the next would be long. The set of its points is random all the
same, and only the set enters the analysis of the later rounds.

Expected \f$O(n + N_1 \log N_1) = O(n)\f$ for n points.

\cgalModels{InsertionPlan}
*/
class Log_star_rounds
{
public:
  /// draws the random order from `seed`.
  explicit Log_star_rounds(unsigned int seed = 0)
    : m_seed(seed)
  {
  }

  /// returns order and rounds of `points`. The graph is not looked at.
  template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
  Insertion_order operator()(const std::vector<Point>& points, const GeomTraits& gt,
                             const Graph& graph, VertexIndexMap index_map) const
  {
    Insertion_order plan = Random_log_star_rounds(m_seed)(points, gt, graph, index_map);
    internal::hilbert_sort_rounds(points, gt, plan,
                                  (std::min)(std::size_t(1), plan.round_ends.size()));
    return plan;
  }

  /// returns N_1 < N_2 < … < n, those of `Random_log_star_rounds`.
  static std::vector<std::size_t> round_ends(std::size_t n)
  {
    return Random_log_star_rounds::round_ends(n);
  }

private:
  unsigned int m_seed;
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_LOG_STAR_ROUNDS_H
