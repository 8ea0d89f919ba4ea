// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_UNIFORM_HILBERT_SORTED_NETS_H
#define DELAUNAY_FROM_SURFACE_3_UNIFORM_HILBERT_SORTED_NETS_H

// The sets of points of Surface_net_rounds, in the order in which uniform samples come.

#include <CGAL/Delaunay_from_surface_3/paper/Surface_net_rounds.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>

#include <vector>

namespace uniform {

// A model of InsertionPlan. The starting places of the nets belong to their order, and are dropped.
class Hilbert_sorted_nets
{
public:
  explicit Hilbert_sorted_nets(unsigned int seed = 0)
    : m_plan(seed)
  {
  }

  template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
  CGAL::Delaunay_from_surface_3::Insertion_order
  operator()(const std::vector<Point>& points, const GeomTraits& gt, const Graph& graph,
             VertexIndexMap index_map) const
  {
    auto plan = m_plan(points, gt, graph, index_map);
    CGAL::Delaunay_from_surface_3::internal::hilbert_sort_rounds(points, gt, plan,
                                                                 plan.round_ends.size());
    plan.starting_places.clear();
    return plan;
  }

private:
  CGAL::Delaunay_from_surface_3::Surface_net_rounds m_plan;
};

} // namespace uniform

#endif // DELAUNAY_FROM_SURFACE_3_UNIFORM_HILBERT_SORTED_NETS_H
