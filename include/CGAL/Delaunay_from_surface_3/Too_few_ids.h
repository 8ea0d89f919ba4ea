// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TOO_FEW_IDS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TOO_FEW_IDS_H

#include <stdexcept>
#include <string>

namespace CGAL {
namespace Delaunay_from_surface_3 {

// Thrown where there are more cells than ids can number. Users know it as a std::length_error.
struct Too_few_ids : std::length_error
{
  explicit Too_few_ids(int bits)
    : std::length_error("ids of " + std::to_string(bits) + " bits are too few for its cells")
  {
  }
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TOO_FEW_IDS_H
