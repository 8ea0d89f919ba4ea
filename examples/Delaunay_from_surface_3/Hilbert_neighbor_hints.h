// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef HILBERT_NEIGHBOR_HINTS_H
#define HILBERT_NEIGHBOR_HINTS_H

#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <numeric>
#include <type_traits>
#include <vector>

// An InsertionHints_3, which needs no surface: a point starts at one of the inserted points that
// precede and follow it on a closed Hilbert curve, the nearer one. Points are numbered in the order
// of their insertion, so taking them off the curve, the last first, leaves those inserted before.
template <class Target, class Subgraph>
struct Hilbert_neighbor_hints : CGAL::Delaunay_from_surface_3::Previous_hint_3<Target, Subgraph>
{
  using Base = CGAL::Delaunay_from_surface_3::Previous_hint_3<Target, Subgraph>;

  Hilbert_neighbor_hints(const Target& target, const Subgraph& subgraph,
                         const CGAL::Delaunay_from_surface_3::Insertion_order&)
    : Base(target, subgraph)
    , before(target.size())
    , after(target.size())
  {
    std::vector<std::size_t> curve(target.size());
    std::iota(curve.begin(), curve.end(), std::size_t(0));
    const auto points = CGAL::make_property_map(target.points().data());
    using Geom_traits = std::decay_t<decltype(target.triangulation().geom_traits())>;
    using Sort_traits = CGAL::Spatial_sort_traits_adapter_3<Geom_traits, decltype(points)>;
    CGAL::hilbert_sort(curve.begin(), curve.end(), Sort_traits(points));

    for (std::size_t k = 0; k < curve.size(); ++k)
      join(curve[k], curve[(k + 1) % curve.size()]);
    for (std::size_t i = target.size(); i-- > 0;)
      join(before[i], after[i]);
  }

  typename Target::Cell start(std::size_t i) const
  {
    if (i == 0)
      return Base::start(i);
    const auto v = Base::m_target.vertex(before[i]), w = Base::m_target.vertex(after[i]);
    return Base::m_target.cell(Base::m_target.is_closer(i, v, w) ? v : w);
  }

  void join(std::size_t i, std::size_t j) { before[after[i] = j] = i; }

  std::vector<std::size_t> before, after;
};

#endif // HILBERT_NEIGHBOR_HINTS_H
