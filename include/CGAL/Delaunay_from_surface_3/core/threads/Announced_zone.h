// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_ANNOUNCED_ZONE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_ANNOUNCED_ZONE_H

#include <CGAL/Delaunay_from_surface_3/core/kernel/Conflict_zone.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Id>
struct Links
{
  Id of[4];
};

// A conflict zone, and what was read when it was dug: others may have written since.
template <class Id>
struct Announced_zone : Conflict_zone<Id>
{
  std::vector<Links<Id>> links; // of the zone's cells
  std::vector<Id> words;        // the first vertices of the zone's cells, which tell their versions
  std::vector<Id> outside_words; // the same of the cells beyond the facets

  Announced_zone() { make_room(64); }

  // Hides that of the base, with the same postcondition.
  void make_room(std::size_t n)
  {
    Conflict_zone<Id>::make_room(n);
    links.resize(this->cells.size());
    words.resize(this->cells.size());
    outside_words.resize(this->facets.size());
  }
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_ANNOUNCED_ZONE_H
