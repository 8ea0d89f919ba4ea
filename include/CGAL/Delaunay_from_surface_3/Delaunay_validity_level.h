// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DELAUNAY_VALIDITY_LEVEL_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DELAUNAY_VALIDITY_LEVEL_H

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Arrays

says how much of a triangulation is checked. Each level includes the previous ones. The last one
uses Delaunay's lemma: if no cell is in conflict with the vertex across a facet, no cell is in
conflict with any vertex. The lemma requires a triangulation; the other levels check that it is one,
as far as described for `is_valid_delaunay_3_arrays()`.
*/
enum class Delaunay_validity_level {
  LINKS,       ///< neighbours lead back, share a facet, and are oriented alike.
  EULER,       ///< around each vertex there is a sphere of cells, as Euler's formula counts them.
  ORIENTATION, ///< finite cells are positively oriented, by exact predicates.
  DELAUNAY ///< no cell is in conflict with the vertex across a facet, perturbed as CGAL does it, and
           ///< no point is in two cells.
};

} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DELAUNAY_VALIDITY_LEVEL_H
