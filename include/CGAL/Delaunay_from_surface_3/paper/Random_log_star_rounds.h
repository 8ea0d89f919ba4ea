// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_RANDOM_LOG_STAR_ROUNDS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_RANDOM_LOG_STAR_ROUNDS_H

// Choi 2002, §2: "Let s_1, s_2, …, s_n be a random ordering", and Fig. 1, line 2a: the traces come
// after s_i with i = N_h = ⌈n / log^(h) n⌉, 1 <= h <= log* n.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/order_of_indices.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Plans

is the plan of the paper (\cgalCite{choi-dtsm-02}, §2 and Fig.\ 1): a uniformly random
order, and rounds that end at \f$N_h = \lceil n / \log^{(h)} n \rceil\f$ (log to base 2, iterated h
times) for all h with \f$\log^{(h)} n \ge 1\f$, of which the largest is \f$\log^* n\f$, and at n.
Where two round ends coincide, or one is not less than n, the empty round is dropped.

It is the plan for `Conflict_history_hints_3`, whose bounds need every order to be random, that of
the first round too. `Log_star_rounds` is the same for points that are located by walking.

\f$O(n)\f$ for n points.

\cgalModels{InsertionPlan}
*/
class Random_log_star_rounds
{
public:
  /// draws the random order from `seed`.
  explicit Random_log_star_rounds(unsigned int seed = 0)
    : m_seed(seed)
  {
  }

  /// returns order and rounds of `points`. Nothing is looked at but their number.
  template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
  Insertion_order operator()(const std::vector<Point>& points, const GeomTraits&, const Graph&,
                             VertexIndexMap) const
  {
    Insertion_order plan;
    plan.order = internal::random_order(points.size(), m_seed);
    plan.round_ends = round_ends(points.size());
    return plan;
  }

  /// returns N_1 < N_2 < … < n, n included; nothing for n = 0.
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
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_RANDOM_LOG_STAR_ROUNDS_H
