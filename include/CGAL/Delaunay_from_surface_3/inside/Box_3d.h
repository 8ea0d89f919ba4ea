// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_BOX_3D_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_BOX_3D_H

#include <CGAL/Delaunay_from_surface_3/inside/solid_angle.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// A box around points; of none at first.
struct Box_3d
{
  Vector_3d low = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
                   std::numeric_limits<double>::infinity()};
  Vector_3d high = {-low[0], -low[0], -low[0]};

  void add(const Vector_3d& p)
  {
    for (std::size_t j = 0; j < 3; ++j) {
      low[j] = (std::min)(low[j], p[j]);
      high[j] = (std::max)(high[j], p[j]);
    }
  }
  bool meets(const Box_3d& other) const
  {
    for (std::size_t j = 0; j < 3; ++j)
      if (low[j] > other.high[j] || high[j] < other.low[j])
        return false;
    return true;
  }
  // Along which axis it is longest.
  std::size_t longest_side() const
  {
    std::size_t longest = 0;
    for (std::size_t j = 1; j < 3; ++j)
      if (high[j] - low[j] > high[longest] - low[longest])
        longest = j;
    return longest;
  }
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_BOX_3D_H
