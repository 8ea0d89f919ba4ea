// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_UNIFORM_UNIFORM_ROUNDS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_UNIFORM_UNIFORM_ROUNDS_H

// Nested locally uniform subsets as rounds: a model of InsertionPlan to be compared with nets.

#include "locally_uniform_subset.h"

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace uniform {

/// A round is what the next subset leaves out of the one before. The factor of the spacing doubles
/// from subset to subset, down to a few dozen points. Each round follows a Hilbert curve. Points of
/// the same size come in random order, lest the subsets be as regular as the numbering.
class Uniform_rounds
{
public:
  explicit Uniform_rounds(unsigned int seed = 0)
    : m_seed(seed)
  {
  }

  template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
  CGAL::Delaunay_from_surface_3::Insertion_order operator()(const std::vector<Point>& points,
                                                            const GeomTraits& gt, const Graph&,
                                                            VertexIndexMap) const
  {
    using namespace CGAL::Delaunay_from_surface_3;
    const std::vector<double> spacing = neighbor_spacing(points);
    std::vector<std::size_t> left = internal::random_order(points.size(), m_seed);
    std::vector<std::vector<std::size_t>> rounds; // from the last to the first
    for (double factor = 1; left.size() > 64; factor *= 2) {
      auto [kept, left_out] = split(points, left, spacing, factor);
      if (!left_out.empty())
        rounds.push_back(std::move(left_out));
      left = std::move(kept);
    }
    if (!left.empty())
      rounds.push_back(std::move(left));

    Insertion_order plan;
    for (auto round = rounds.rbegin(); round != rounds.rend(); ++round) {
      plan.order.insert(plan.order.end(), round->begin(), round->end());
      plan.round_ends.push_back(plan.order.size());
    }
    internal::hilbert_sort_rounds(points, gt, plan, plan.round_ends.size());
    return plan;
  }

private:
  using Indices = std::vector<std::size_t>;

  // Those of `from` in the subset, and the others.
  template <class Point>
  static std::pair<Indices, Indices> split(const std::vector<Point>& points, const Indices& from,
                                           const std::vector<double>& spacing, double factor)
  {
    std::vector<Point> here;
    for (const std::size_t i : from)
      here.push_back(points[i]);
    std::vector<double> sizes;
    for (const std::size_t i : from)
      sizes.push_back(factor * spacing[i]);
    Indices kept, left_out;
    const Indices places = locally_uniform_subset(here, std::move(sizes));
    auto next = places.begin();
    for (std::size_t k = 0; k < from.size(); ++k) {
      const bool is_kept = next != places.end() && *next == k;
      (is_kept ? kept : left_out).push_back(from[k]);
      next += is_kept;
    }
    return {kept, left_out};
  }

  unsigned int m_seed;
};

} // namespace uniform

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_UNIFORM_UNIFORM_ROUNDS_H
