# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""Cells of Voronoi and power diagrams, which the results of all kinds have under names of their own."""

from __future__ import annotations

import numbers
from functools import cached_property
from typing import TYPE_CHECKING, Any, List, NamedTuple, NoReturn, Optional, SupportsIndex, Tuple

import numpy as np

from . import _delaunay_from_surface as _core
from ._arguments import whole_number
from ._types import Coordinates, InBox, Indices, Places, Radius, Reals


def _read_only(array: Any) -> Any:
    """The array, of which later answers are made."""
    array.flags.writeable = False
    return array


class PowerFacets(NamedTuple):
    """The facets of the power diagram, or of the Voronoi diagram, each between the cells of two points."""

    points: Indices
    """(k, 2) int32: the two points, ascending; in lexicographical order."""

    areas: Reals
    """(k,) float64: their areas; -1 where they are unbounded."""


class PeriodicPowerFacets(NamedTuple):
    """The same in a box, where each facet is between the cells of two copies of points, or of one point."""

    pairs: Indices
    """(e, 2) int32: the ends of the edges of the triangulation: indices of points, ascending."""

    areas: Reals
    """(e,) float64: the areas of the facets; -1 where they are unbounded, as on the hull if some period is missing."""

    offsets: Indices
    """(e, 3) int32: by how many periods the second end is moved, if the first is not. Positive, in lexicographical
    order, where both are the same point."""


class CellPolyhedron(NamedTuple):
    """The cell of one point: a convex polyhedron, as `voronoi_cell()` and `power_cell()` return it."""

    vertices: Reals
    """(k, 3) float64: its corners. Those where more than four cells meet are there once."""

    faces: List[Indices]
    """For each of f faces, its corners: int32, counterclockwise as seen from outside."""

    neighbors: Indices
    """(f,) int32: the points beyond the faces, ascending."""

    offsets: Indices
    """(f, 3) int32: by how many periods these are moved; 0 without a box."""


class Cells:
    """What the results of all kinds have in common about cells."""

    if TYPE_CHECKING:
        points: Coordinates
        simplices: Indices
        vertices: Indices
        _threads: int

        @property
        def npoints(self) -> int: ...
        @property
        def neighbors(self) -> Indices: ...
        @property
        def convex_hull(self) -> Indices: ...
        @property
        def vertex_to_simplex(self) -> Indices: ...
        @property
        def _in_box(self) -> InBox: ...
        def _needs_space(self, name: str) -> None: ...

    @property
    def _tetrahedra(self) -> Tuple[Coordinates, Optional[Reals], Indices, Indices, InBox]:
        """As the extension takes them."""
        return self.points, self.__dict__.get("_weights"), self.simplices, self.neighbors, self._in_box

    @cached_property
    def _diagram(self) -> Tuple[Reals, Indices, Indices, Reals, Indices, Places, int]:
        """Volumes; of each facet the points, offset in a box, area, number of corners, and place; and the exponent of the
        power of 2 that is the unit of the areas."""
        diagram = _core.cell_facets(*self._tetrahedra, self._threads)
        for array in diagram[:-1]:
            _read_only(array)
        return diagram

    @cached_property
    def _volumes_of_cells(self) -> Reals:
        if "_diagram" in self.__dict__:  # they are there, too
            return _read_only(self._of_cells(self._diagram[0]))
        return _read_only(self._of_cells(_core.cell_volumes(*self._tetrahedra, self._threads)))

    @cached_property
    def _scaled_areas_of_cells(self) -> Reals:
        """In the unit of the facets."""
        _, ends, _, areas, *_ = self._diagram
        sums = np.bincount(ends.reshape(-1), np.repeat(areas, 2), self.npoints)
        sums[self.convex_hull] = -1
        return _read_only(self._of_cells(sums))

    @cached_property
    def _areas_of_cells(self) -> Reals:
        return self._unscaled(self._scaled_areas_of_cells)

    def _unscaled(self, areas: Reals) -> Reals:
        exponent = self._diagram[-1]
        if exponent == 0:  # as it nearly always is
            return areas
        with np.errstate(over="ignore", under="ignore"):
            return _read_only(np.where(areas < 0, areas, np.ldexp(areas, exponent)))

    def _of_cells(self, values: Any) -> Any:
        """For each point the value of its vertex; 0 for points that are hidden."""
        return np.where(self.vertices < 0, 0, values[self.vertices])

    @property
    def _facets_of_cells(self) -> Any:
        """PowerFacets, or PeriodicPowerFacets in a box."""
        _, ends, offsets, areas, *_ = self._diagram
        areas = self._unscaled(areas)
        return PowerFacets(ends, areas) if self._in_box is None else PeriodicPowerFacets(ends, areas, offsets)

    @property
    def facet_corners(self) -> Indices:
        """(k,) int32: how many corners the facets of the Voronoi diagram have, or with weights those of the power
        diagram; -1 where they are unbounded. 0 if there are fewer than three; the area is then 0, too. This happens
        in lattices, where tetrahedra around an edge have the same sphere, and is decided by exact arithmetic."""
        self._needs_space("facet_corners")
        return self._diagram[4]

    @cached_property
    def solid_angles(self) -> Reals:
        """(k, 2) float64: the solid angles of these facets as seen from the first and from the second point; -1 where
        the facets are unbounded. Those of a bounded Voronoi cell add up to 4 pi. With weights a point may lie beyond a
        facet of its cell, whose angle is negative then, and for points outside of their cells they add up to 0. From a point
        in the plane of a facet, which is decided exactly, its angle is 0. (Van Oosterom, Strackee 1983)"""
        self._needs_space("solid_angles")
        _, _, _, _, corners, places, _ = self._diagram
        angles = _core.solid_angles(*self._tetrahedra, places, self._threads)
        angles[corners == 0] = 0
        return _read_only(angles)

    def coordination(self, *, min_area: Radius = 0, min_solid_angle: Radius = 0) -> Indices:
        """Return the coordination number of each point: how many facets its cell has that are large enough. (n,) int32;
        -1 where the cell is unbounded, and 0 for hidden points. Facets towards a point's own copies count.

        Parameters
        ----------
        min_area
            The least area of a facet that counts, as a share of the cell's surface area.
        min_solid_angle
            The least solid angle of a facet that counts, as seen from the point, as a share of the cell's largest
            (O'Keeffe 1979).

        By default all facets count, however small. Coordinates of crystals are mostly rounded, and then there are
        facets with shares of 1e-16 where edges or corners of cells should be: a share of 0.01, say, leaves them out.

        Raises ValueError if a share is not a number from 0 to 1, or all points lie in a plane.
        """
        self._needs_space("coordination")
        for name, share in (("min_area", min_area), ("min_solid_angle", min_solid_angle)):
            if not isinstance(share, numbers.Real) or not 0 <= share <= 1:
                raise ValueError(f"coordination: {name}: expected a share from 0 to 1, got {share!r}")
        _, ends, _, areas, corners, *_ = self._diagram
        counts = np.repeat(corners > 0, 2).reshape(-1, 2)
        if min_area > 0:
            counts &= areas[:, None] >= min_area * self._scaled_areas_of_cells[ends]
        if min_solid_angle > 0:
            largest = np.zeros(self.npoints)
            np.fmax.at(largest, ends, self.solid_angles)
            counts &= self.solid_angles >= min_solid_angle * largest[ends]
        sums = np.bincount(ends[counts], minlength=self.npoints).astype(np.int32)
        sums[self.convex_hull] = -1
        return self._of_cells(sums)

    def _cell(self, name: str, i: SupportsIndex) -> CellPolyhedron:
        """The cell around point i as it was given."""
        self._needs_space(name)
        point = whole_number(f"{name}: i", i, 0, self.npoints - 1)
        vertex = self.vertices[point]
        if vertex < 0:
            self._has_no_cell(name, f"point {point} is hidden")
        simplex = self.vertex_to_simplex[vertex]
        corner = int(np.flatnonzero(self.simplices[simplex] == vertex)[0])
        try:
            vertices, faces, neighbors, offsets = _core.cell_polyhedron(*self._tetrahedra, simplex, corner)
        except ValueError as error:
            self._has_no_cell(name, f"point {point}: {error}")
        place = np.asarray(self.points[point], dtype=float)
        if self._in_box is not None:
            periods = np.where(np.isinf(self._in_box[0]), 1, self._in_box[0])
            offsets += np.rint((place - self.points[vertex]) / periods).astype(np.int32)
        return CellPolyhedron(vertices + place, faces, neighbors, offsets)

    @staticmethod
    def _has_no_cell(name: str, reason: str) -> NoReturn:
        raise ValueError(f"{name}: {reason}")
