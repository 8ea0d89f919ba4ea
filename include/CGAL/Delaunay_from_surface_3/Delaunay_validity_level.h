// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DELAUNAY_VALIDITY_LEVEL_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DELAUNAY_VALIDITY_LEVEL_H

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Arrays

says how much is checked of a triangulation. Each level includes those before it. The last one is
Delaunay's lemma: where no vertex across a facet contradicts a cell, no other vertex does. The lemma
needs a triangulation; that it is one, the levels before say as far as `is_valid_delaunay_3_arrays()`
says.
*/
enum class Delaunay_validity_level {
  LINKS,       ///< neighbours lead back, share a facet, and are oriented alike.
  EULER,       ///< around each vertex there is a sphere of cells, as Euler's formula counts them.
  ORIENTATION, ///< finite cells are positively oriented, by exact predicates.
  DELAUNAY ///< no cell is in conflict with the vertex across a facet, perturbed as CGAL does it.
};

} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DELAUNAY_VALIDITY_LEVEL_H
