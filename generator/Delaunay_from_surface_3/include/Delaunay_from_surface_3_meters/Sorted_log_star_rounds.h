// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_METERS_SORTED_LOG_STAR_ROUNDS_H
#define DELAUNAY_FROM_SURFACE_3_METERS_SORTED_LOG_STAR_ROUNDS_H

// Log_star_rounds that are a type for each way to sort them, as Surface_insertion_policies_3 asks.

#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>

namespace meters {

template <CGAL::Delaunay_from_surface_3::Log_star_rounds::Sorted_rounds sorted>
struct Sorted_log_star_rounds : CGAL::Delaunay_from_surface_3::Log_star_rounds
{
  explicit Sorted_log_star_rounds(unsigned int seed = 0)
    : Log_star_rounds(seed, sorted)
  {
  }
};

using Random_log_star_rounds =
    Sorted_log_star_rounds<CGAL::Delaunay_from_surface_3::Log_star_rounds::NO_ROUND>;
using Hilbert_log_star_rounds =
    Sorted_log_star_rounds<CGAL::Delaunay_from_surface_3::Log_star_rounds::ALL_ROUNDS>;

} // namespace meters

#endif // DELAUNAY_FROM_SURFACE_3_METERS_SORTED_LOG_STAR_ROUNDS_H
