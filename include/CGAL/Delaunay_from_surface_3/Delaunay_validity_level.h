// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DELAUNAY_VALIDITY_LEVEL_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DELAUNAY_VALIDITY_LEVEL_H

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Arrays

says how much is checked of a triangulation. Each level includes those before it; together they prove
that it is the Delaunay triangulation of its points: one that is oriented like space, whose vertices
have spheres around them, and that no vertex across a facet contradicts, has no cell that any other
vertex contradicts (Delaunay's lemma).
*/
enum class Delaunay_validity_level {
  LINKS,       ///< neighbours lead back, share a facet, and are oriented alike.
  EULER,       ///< around each vertex there is a sphere of cells, as Euler's formula counts them.
  ORIENTATION, ///< finite cells are positively oriented, by exact predicates.
  DELAUNAY ///< no cell is in conflict with the vertex across a facet, perturbed as CGAL does it.
};

} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DELAUNAY_VALIDITY_LEVEL_H
