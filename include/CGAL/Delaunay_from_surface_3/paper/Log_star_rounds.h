// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_LOG_STAR_ROUNDS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_LOG_STAR_ROUNDS_H

// Choi 2002, §2: "Let s_1, s_2, …, s_n be a random ordering", and Fig. 1, line 2a: the traces come
// after s_i with i = N_h = ⌈n / log^(h) n⌉, 1 <= h <= log* n.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/order_of_indices.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Plans

is the plan of the paper (\cgalCite{choi-dtsm-02}, §2 and Fig.\ 1): a uniformly random order, and
rounds that end at \f$N_h = \lceil n / \log^{(h)} n \rceil\f$ (log to base 2, iterated h times) for
all h with \f$\log^{(h)} n \ge 1\f$, of which the largest is \f$\log^* n\f$, and at n. Where two
round ends coincide, or one is not less than n, the empty round is dropped.

Rounds may be sorted. The set of points inserted by the end of each round is still random, and walks
from one point to the next are short.

<b>Complexity</b>: \f$O(n)\f$ for n points, plus expected \f$O(k \log k)\f$ for the k points of
sorted rounds, which is \f$O(n)\f$ for the first round.

\cgalModels{InsertionPlan}
*/
class Log_star_rounds
{
public:
  /// the rounds that follow a Hilbert curve.
  enum Sorted_rounds {
    NO_ROUND,    ///< the paper's order, required by the bounds of `Conflict_history_hints_3`
    FIRST_ROUND, ///< for location by walking: in this round there is no trace to start from
    ALL_ROUNDS   ///< for speed on a machine with caches
  };

  /// makes the plan. `seed` determines the random order.
  explicit Log_star_rounds(unsigned int seed = 0, Sorted_rounds sorted = FIRST_ROUND)
    : m_seed(seed)
    , m_sorted(sorted)
  {
  }

  /// returns order and rounds of `points`. The graph is not used.
  template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
  Insertion_order operator()(const std::vector<Point>& points, const GeomTraits& gt, const Graph&,
                             VertexIndexMap) const
  {
    Insertion_order plan;
    plan.order = internal::random_order(points.size(), m_seed);
    plan.round_ends = round_ends(points.size());
    const std::size_t rounds = plan.round_ends.size();
    internal::hilbert_sort_rounds(points, gt, plan,
                                  m_sorted == NO_ROUND      ? 0
                                  : m_sorted == FIRST_ROUND ? (std::min)(std::size_t(1), rounds)
                                                            : rounds);
    return plan;
  }

  /// returns the round ends N_1 < N_2 < … < n, including n; none for n = 0.
  static std::vector<std::size_t> round_ends(std::size_t n)
  {
    std::vector<std::size_t> ends;
    // log* n is the largest h with log^(h) n >= 1: the loop runs for exactly these h.
    double log_h = n > 1 ? std::log2(double(n)) : 0.;
    while (log_h >= 1.) {
      const auto end = static_cast<std::size_t>(std::ceil(double(n) / log_h));
      if (end < n && (ends.empty() || end > ends.back()))
        ends.push_back(end);
      log_h = std::log2(log_h);
    }
    if (n > 0)
      ends.push_back(n);
    return ends;
  }

private:
  unsigned int m_seed;
  Sorted_rounds m_sorted;
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_LOG_STAR_ROUNDS_H
