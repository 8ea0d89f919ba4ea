// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_FIRST_ACCEPTED_POINTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_FIRST_ACCEPTED_POINTS_H

// A complex begins with four points at once, and cannot ask about them in their turn. So the first
// points are asked about before there is one, until those accepted do not lie in one plane.

#include <CGAL/Delaunay_from_surface_3/core/interface/Order_view.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Watcher.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/exact_predicates.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/nearest_vertex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/starting_simplex.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Takes point `next` into a simplex if it does not lie in the span of those that are there.
template <class PointOf>
void extend_simplex(Starting_simplex& simplex, const PointOf& point, std::size_t next)
{
  auto& p = simplex.points;
  const int d = simplex.dimension;
  const double* const q = point(next);
  if (d == -1 || (d == 0 && !std::equal(q, q + 3, point(p[0]))) ||
      (d == 1 && !are_collinear(point(p[0]), point(p[1]), q)))
    p[std::size_t(++simplex.dimension)] = next;
  else if (d == 2)
    if (const int o = orientation(point(p[0]), point(p[1]), point(p[2]), q); o != 0) {
      p[3] = next;
      simplex.dimension = 3;
      if (o < 0)
        std::swap(p[0], p[1]);
    }
}

// point(k) is the point at place k, and order[k] the caller's number of it. Says of each point that
// was asked about, in is_accepted, whether it is to be inserted. It gives up if a thousand of them
// lie in one plane, since the points accepted are compared with each other.
template <class PointOf>
Starting_simplex first_accepted_points(const Order_view& order, const PointOf& point,
                                       Watcher& watcher, std::vector<char>& is_accepted)
{
  constexpr std::size_t most = 1000;
  const Watcher::Corners no_corners = {Watcher::none, Watcher::none, Watcher::none, Watcher::none};
  Starting_simplex simplex = {{}, -1};
  std::vector<std::size_t> places; // of the vertices
  for (std::size_t k = 0; k < (std::min)(order.size, most) && simplex.dimension < 3; ++k) {
    const double* const p = point(k);
    const auto nearest =
        std::min_element(places.begin(), places.end(), [&](std::size_t i, std::size_t j) {
          return is_nearer_exactly(p, point(i), point(j));
        });
    const bool is_vertex = nearest != places.end() && std::equal(p, p + 3, point(*nearest));
    is_accepted.push_back(is_vertex || nearest == places.end() ||
                          watcher.accepts(order.order[k], order.order[*nearest], no_corners));
    if (is_accepted.back() && !is_vertex) {
      places.push_back(k);
      extend_simplex(simplex, point, k);
    }
  }
  return simplex;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_FIRST_ACCEPTED_POINTS_H
