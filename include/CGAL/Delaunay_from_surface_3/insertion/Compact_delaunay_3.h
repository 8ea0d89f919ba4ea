// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSERTION_COMPACT_DELAUNAY_3_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSERTION_COMPACT_DELAUNAY_3_H

#include <CGAL/Delaunay_from_surface_3/insertion/Compact_delaunay_with_ids_3.h>

#include <cstdint>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Insertion

is `Compact_delaunay_with_ids_3` with ids of 32 bits: \f$2^{30}\f$ cells, some 150 million points.

\cgalModels{InsertionTarget_3}
*/
template <class Triangulation>
class Compact_delaunay_3 : public Compact_delaunay_with_ids_3<Triangulation, std::uint32_t>
{
public:
  using Compact_delaunay_with_ids_3<Triangulation, std::uint32_t>::Compact_delaunay_with_ids_3;
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSERTION_COMPACT_DELAUNAY_3_H
