// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_GEOMETRIC_ROUND_ENDS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_GEOMETRIC_ROUND_ENDS_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// …, ⌊ratio ⌊ratio n⌋⌋, ⌊ratio n⌋, n; rounds are cut off until at most `first_round` points are left.
inline std::vector<std::size_t> geometric_round_ends(std::size_t n, double ratio,
                                                     std::size_t first_round)
{
  std::vector<std::size_t> ends;
  for (std::size_t end = n; end > 0;) {
    ends.push_back(end);
    end = end <= first_round ? 0 : static_cast<std::size_t>(std::floor(double(end) * ratio));
  }
  std::reverse(ends.begin(), ends.end());
  return ends;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_GEOMETRIC_ROUND_ENDS_H
