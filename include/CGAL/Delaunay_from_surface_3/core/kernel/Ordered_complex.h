// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_ORDERED_COMPLEX_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_ORDERED_COMPLEX_H

// A complex whose vertices come in a given order, and its first four points.
//
// One vertex, one number: the point at place k of the order is vertex k + 1.

#include <CGAL/Delaunay_from_surface_3/core/interface/Order_view.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Power_of_scale.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Starting_cells.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/first_accepted_points.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/starting_simplex.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/assertions.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Id>
struct Ordered_complex
{
  using Complex = Compact_complex<Id>;

  Ordered_complex() = default;

  // Of these points, in an order that is kept elsewhere; if there is an apex, of that one too, at the
  // place behind the last. Four of them that do not lie in one plane are inserted. The watcher is
  // asked about the first ones if it leaves points out.
  Ordered_complex(const Point_array& points, const Order_view& by, const double* apex,
                  Watcher& watcher, const Executor& executor = Alone())
    : order(by)
    , vertex_of(order.size + (apex != nullptr), 0)
  {
    const Power_of_scale scaled(points, apex);
    const auto point = [&](std::size_t k) {
      return k < order.size ? points[order.order[k]] : apex;
    };
    complex = Complex(
        vertex_of.size(), [&](std::size_t k) { return scaled(point(k)); }, executor);
    CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT_EXPENSIVE(std::all_of(
        complex.vertices() + 1, complex.vertices() + complex.vertices_end(), [](const auto& v) {
          return std::all_of(v.coordinates, v.coordinates + 3,
                             [](double x) { return std::abs(x) <= 0x1p58; });
        }));
    if (!scaled.is_exact()) {
      std::vector<std::array<double, 3>> own;
      own.reserve(vertex_of.size());
      for (std::size_t k = 0; k < vertex_of.size(); ++k)
        own.push_back({point(k)[0], point(k)[1], point(k)[2]});
      complex.keep_own_coordinates(std::move(own));
    }
    const Starting_simplex simplex = watcher.leaves_points_out()
                                         ? first_accepted_points(order, point, watcher, is_accepted)
                                         : starting_simplex(vertex_of.size(), point);
    any_vertex = start_complex(simplex, complex, vertex_of);
  }

  // Whether there are four points that do not lie in one plane.
  bool has_started() const { return any_vertex != 0; }

  // The first points may be left out before their turn.
  bool has_left_out(std::size_t k) const { return k < is_accepted.size() && !is_accepted[k]; }
  bool is_known(std::size_t k) const { return k < is_accepted.size(); }

  Starting_cells<Id> starting_cells() const { return starting_cells(vertex_of); }

  // From these vertices, by place.
  Starting_cells<Id> starting_cells(const std::vector<Id>& vertices) const
  {
    return Starting_cells<Id>(complex, vertices, order.starting_places, any_vertex);
  }

  Order_view order = {nullptr, 0, nullptr, 0, nullptr};
  Complex complex;
  std::vector<Id> vertex_of;     // by place: 0 as long as there is none
  std::vector<char> is_accepted; // by place, of the first points, if the watcher was asked
  Id any_vertex = 0;             // any vertex of the complex
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_ORDERED_COMPLEX_H
