# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""The result of delaunay3(points, weights=…)."""

from __future__ import annotations

from functools import cached_property
from typing import Any, NoReturn, SupportsIndex, Tuple

import numpy as np

from . import _delaunay_from_surface as _core
from ._cells import CellPolyhedron, PowerFacets
from ._result import AlphaComplex, Delaunay3
from ._types import Indices, Radius, Reals, Spheres, Truths


class Regular3(Delaunay3):
    """The regular triangulation of points with weights (weighted Delaunay triangulation), and their power diagram.

    A weight is a squared radius: the power of a place with respect to a point is its squared distance from the point minus the
    weight, and the point's power cell is where no other point has less power. Some points may have no cell: they are hidden,
    and in no simplex. If all weights are equal it is the Delaunay triangulation. Negative weights are fine; adding a number
    to all of them changes neither simplices nor power cells, but squared radii by that number.

    Everything in `Delaunay3` is here, too, but what concerns empty spheres is refused, or has another name. `vertices` and
    `vertex_to_simplex` have -1 for hidden points, which are not in `coplanar`, either; lighter points at the place of a
    heavier one are hidden. `check` also says whether the hidden points are rightly so. `alpha_complex` is the weighted
    one. There is no `inside`.
    """

    def __init__(self, weights: Reals, *of_triangulation: Any) -> None:
        super().__init__(*of_triangulation)
        self._weights = weights
        weights.flags.writeable = False  # as it is not in a copy or pickle, either

    def __repr__(self) -> str:
        return f"{super().__repr__()[:-1]}, {len(self.hidden)} hidden points>".replace("<Delaunay3", "<Regular3")

    def __reduce__(self) -> Tuple[Any, ...]:
        kind, arguments = super().__reduce__()
        return (kind, (self._weights, *arguments))

    @property
    def weights(self) -> Reals:
        """(n,) float64: a copy of the weights that were given, which cannot be changed."""
        return self._weights

    @cached_property
    def hidden(self) -> Indices:
        """(k,) int32: the points that are hidden, ascending: `vertices` has -1 for them."""
        return np.flatnonzero(self.vertices < 0).astype(np.int32)

    @cached_property
    def _power_spheres(self) -> Spheres:
        return _core.power_spheres(self.points, self._weights, self.simplices, self._in_box, self._threads)

    @property
    def power_centers(self) -> Reals:
        """(m, 3) float64: the points of equal power to the corners of each tetrahedron, the power diagram's vertices."""
        self._needs_space("power_centers")
        return self._power_spheres[0]

    @property
    def squared_power_radii(self) -> Reals:
        """(m,) float64: the power of these points to the corners: the squared radius of the sphere orthogonal to theirs.
        It may be negative."""
        self._needs_space("squared_power_radii")
        return self._power_spheres[1]

    @property
    def power_volumes(self) -> Reals:
        """(n,) float64: the volume of each point's power cell; -1 where it is unbounded, as on the convex hull, and 0 for
        hidden points. Equal points have the cell of their vertex."""
        self._needs_space("power_volumes")
        return self._volumes_of_cells

    @property
    def power_areas(self) -> Reals:
        """(n,) float64: the surface area of each point's power cell; -1 where it is unbounded, and 0 for hidden points."""
        self._needs_space("power_areas")
        return self._areas_of_cells

    @property
    def power_facets(self) -> PowerFacets:
        """The facets of the power diagram: one crosses each edge of the triangulation, at right angles, perhaps beyond
        its ends. With their areas and the lengths of the edges they are the derivatives of the volumes: a facet's area
        over twice the length is that of one point's volume by the other's weight, with a minus sign."""
        self._needs_space("power_facets")
        return self._facets_of_cells

    def power_cell(self, i: SupportsIndex) -> CellPolyhedron:
        """Return the power cell of point `i` as a polyhedron, as `Delaunay3.voronoi_cell()` does.

        Raises ValueError if the point is hidden, or its cell unbounded, or as that does.
        """
        return self._cell("power_cell", i)

    def alpha_complex(self, alpha: Radius) -> AlphaComplex:
        """Return the weighted alpha complex: the simplices with an empty orthogonal sphere whose squared radius is at most
        the square of `alpha`, and all their faces. Which sphere is empty is decided exactly; radii are rounded, but no face has a
        larger one than what it bounds.

        It has the shape of the union of balls whose squared radii are the weights plus the square of `alpha`: with
        `alpha=0` that of the balls given by the weights. An empty orthogonal sphere has the same power to all corners, and
        no less to any other point.
        """
        return super().alpha_complex(alpha)

    def _squared_radii(self, exponent: int) -> None:
        """Those of the alpha complex are not `squared_power_radii`, whose digits may have gone in a difference."""

    def _refuse(self, name: str, instead: str) -> NoReturn:
        raise ValueError(f"{name}: the points have weights: {instead}")

    @property
    def inside(self) -> Truths:
        """Refused: weights may hide vertices of the surface."""
        self._refuse("inside", "triangulate them without")

    @property
    def circumcenters(self) -> Reals:
        """Refused: spheres through the corners are not empty here."""
        self._refuse("circumcenters", "use power_centers")

    @property
    def circumradii(self) -> Reals:
        """Refused as well."""
        self._refuse("circumradii", "use squared_power_radii")

    @property
    def voronoi_volumes(self) -> Reals:
        """Refused as well."""
        self._refuse("voronoi_volumes", "use power_volumes")

    @property
    def voronoi_areas(self) -> Reals:
        """Refused as well."""
        self._refuse("voronoi_areas", "use power_areas")

    @property
    def voronoi_facets(self) -> PowerFacets:
        """Refused as well."""
        self._refuse("voronoi_facets", "use power_facets")

    def voronoi_cell(self, i: SupportsIndex) -> CellPolyhedron:
        """Refused as well."""
        self._refuse("voronoi_cell", "use power_cell")

    def minimum_spanning_tree(self) -> Indices:
        """Refused: the edges here need not have one."""
        self._refuse("minimum_spanning_tree", "triangulate them without")
