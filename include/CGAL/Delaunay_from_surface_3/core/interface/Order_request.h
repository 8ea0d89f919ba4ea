// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_ORDER_REQUEST_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_ORDER_REQUEST_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/inlining.h>

#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE {

// What Surface_net_rounds says of its constants holds for these.
constexpr double net_stall = 0.9;
constexpr std::size_t coarsest_net = 64;
constexpr std::size_t cells_per_point_of_nets = 64;
constexpr std::size_t large_cluster = 32;

// The order in which points are to be inserted.
struct Order_request
{
  // The default: nets.
  // Not "= default", which may be a function of its own.
  // NOLINTNEXTLINE(modernize-use-equals-default)
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE Order_request() {}

  // By nets of their graph, as Surface_net_rounds; without a graph, as Spaced_rounds; or by random
  // rounds, as Geometric_rounds, which take the place of the others when a budget is exceeded.
  enum Kind { NETS, SPACED, GEOMETRIC } kind = NETS;

  unsigned int seed = 0;

  // Of random rounds: 0 < ratio < 1, first_round > 0.
  double ratio = 0.125;
  std::size_t first_round = 64;

  // Of nets: so many successive vertices of very many are a block. See Random_blocks.
  std::size_t block = 1024;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_ORDER_REQUEST_H
