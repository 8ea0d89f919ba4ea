# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""The result of delaunay3(points, box=…)."""

from __future__ import annotations

import math
from functools import cached_property
from typing import Any, NamedTuple, NoReturn, Optional, SupportsIndex, Tuple

import numpy as np

from . import _delaunay_from_surface as _core
from ._arguments import number_of_threads
from ._cells import PeriodicPowerFacets
from ._regular import Regular3
from ._result import Delaunay3
from ._types import ArrayLike, Box, Indices, Offsets, Places, Points, Radius, Reals, Truths

CORNERS_OF_FACETS = np.array([[1, 2, 3], [2, 0, 3], [0, 1, 3], [2, 1, 0]])


class SimplexCopies(NamedTuple):
    """What `Periodic3.find_copies()` finds."""

    simplices: Indices
    """(…,) int32: numbers of tetrahedra; -1 outside."""

    offsets: Indices
    """(…, 3) int32: by how many periods the copy that contains the point is moved: its corners are
    `corners[simplices] + offsets * box`, along the axes that have a period."""


class PeriodicNeighbors(NamedTuple):
    """The vertices that share an edge with each point: `indices[indptr[i]:indptr[i + 1]]` and their `offsets` are those of
    point i."""

    indptr: Places
    """(n + 1,) int64."""

    indices: Indices
    """(2 e,) int32 for e edges: indices of points, ascending; those of a point's own copies are among them."""

    offsets: Indices
    """(2 e, 3) int32: by how many periods they are moved, if point i is not; in lexicographical order for each point."""


class PeriodicAlphaComplex(NamedTuple):
    """The simplices of `Periodic3.alpha_complex()`: each stands for all its copies."""

    simplices: Indices
    """(j,) int32: numbers of tetrahedra, ascending."""

    triangles: Indices
    """(k, 3) int32: indices of points, ascending; those of the tetrahedra included."""

    triangle_offsets: Indices
    """(k, 3, 3) int32: by how many periods these are moved; the first is not."""

    edges: Indices
    """(e, 2) int32: as triangles."""

    edge_offsets: Indices
    """(e, 2, 3) int32: the same."""

    vertices: Indices
    """(v,) int32: indices of points. Without weights all vertices of the triangulation, whose balls have the radius 0."""


def periods_of(box: Box) -> Reals:
    """(3,) float64: the periods, infinite along axes that have none."""
    if isinstance(box, np.ma.MaskedArray):
        raise ValueError("box: a masked array is not read; None stands for no period")
    try:
        given = list(_core.read_alike(box, "box"))
    except TypeError:
        raise TypeError(f"box: expected three periods, got {box!r}") from None
    if len(given) != 3:
        raise ValueError(f"box: expected three periods, one along each axis, got {len(given)}")
    periods = np.full(3, np.inf)
    for axis, period in enumerate(given):
        name = f"box: the period along {'xyz'[axis]}"
        if period is None:
            continue
        try:
            if isinstance(period, (str, bytes, bool, np.bool_)):
                raise TypeError
            periods[axis] = float(period)
        except (TypeError, ValueError, OverflowError):
            raise TypeError(f"{name}: expected a number, or None if there is no period, got {period!r}") from None
        if not periods[axis] > 0:
            raise ValueError(f"{name} is not positive: got {period!r}")
    periods.flags.writeable = False
    return periods


def _numbered(rows: Indices) -> Tuple[Places, Places]:
    """Of equal rows the first one, in lexicographical order, and for each row which of these it equals. Faster where rows fit into
    numbers of 64 bits."""
    if len(rows) == 0:
        return np.zeros(0, dtype=np.int64), np.zeros(0, dtype=np.int64)
    least = rows.min(axis=0).astype(np.int64)
    sizes = rows.max(axis=0).astype(np.int64) - least + 1
    if math.prod(sizes.tolist()) < 2 ** 63:
        key = np.zeros(len(rows), dtype=np.int64)
        for column, low, size in zip(rows.T, least, sizes):
            key = key * size + (column - low)
        order = np.argsort(key, kind="stable")
        is_new = np.append(True, np.diff(key[order]) != 0)
    else:
        order = np.lexsort(rows.T[::-1])
        is_new = np.append(True, (rows[order[1:]] != rows[order[:-1]]).any(axis=1))
    number = np.empty(len(rows), dtype=np.int64)
    number[order] = np.cumsum(is_new) - 1
    return order[is_new], number


class Periodic3(Delaunay3):
    """A Delaunay triangulation of points in a periodic box: that of all their copies, which are moved by any whole numbers
    of periods. Each tetrahedron here stands for all its copies.

    Corner k of tetrahedron c is `points[simplices[c, k]] + offsets[c, k] * box`, along the axes that have a period; `corners`
    are these. Otherwise it has what `Delaunay3` has, with these differences:

    - Without a period along some axis there is a hull, as in slabs and wires; else all neighbours are there, all Voronoi cells
      are bounded, and the volumes of either add up to that of the box.
    - Points that are equal but for whole periods are one vertex.
    - Points may be looked for anywhere. `find_copies()` says, beside the numbers of `find_simplex()`, by how many periods the
      tetrahedron must be moved.
    - Measures are those of the corners as they are, which rounding does not move; only the results are rounded.
    - Facets, edges and neighbours are copies, with offsets of their own.

    Refused, as they are not made for boxes: `inside`, `transform`, `minimum_spanning_tree`, and `check`.
    """

    offsets: Offsets
    """(m, 4, 3) int16: by how many periods the corners are moved from the points as they were given. The first corner that has
    the smallest index of the four is not moved."""

    is_simplicial_complex: bool
    """Whether indices alone determine each edge, and so each tetrahedron: no edge joins a point to its own copy, and no two have
    the same ends. So it is unless points are few, or far apart."""

    def __init__(self, box: Reals, offsets: Offsets, is_simplicial_complex: bool, *arguments: Any) -> None:
        super().__init__(*arguments)
        if "neighbors" not in self.__dict__:
            raise ValueError("neighbors: a triangulation in a periodic box is made with them")
        self._box = box
        box.flags.writeable = False  # as it is not in a copy or pickle, either
        self.offsets = offsets
        self.is_simplicial_complex = is_simplicial_complex

    def __repr__(self) -> str:
        periods = " x ".join("none" if np.isinf(period) else f"{period:g}" for period in self._box)
        return f"{super().__repr__()[:-1]}, box {periods}>".replace("<Delaunay3", "<Periodic3").replace(
            "<Regular3", "<PeriodicRegular3")

    def __reduce__(self) -> Tuple[Any, ...]:
        kind, arguments = super().__reduce__()
        return (kind, (self._box, self.offsets, self.is_simplicial_complex, *arguments))

    @property
    def box(self) -> Reals:
        """(3,) float64: the periods, infinite along axes that have none."""
        return self._box

    @property
    def _in_box(self) -> Tuple[Reals, Offsets]:
        return self._box, self.offsets

    @cached_property
    def corners(self) -> Reals:
        """(m, 4, 3) float64: the coordinates of the corners of each tetrahedron, in one piece."""
        return self._moved(self.simplices, self.offsets)

    @cached_property
    def convex_hull(self) -> Indices:
        """(k, 3) int32: the facets of the hull, where axes lack a period: triangles, counterclockwise as seen from outside.
        None in a box with three periods."""
        simplex, corner = self._hull
        return self.simplices[simplex[:, None], CORNERS_OF_FACETS[corner]]

    @cached_property
    def convex_hull_offsets(self) -> Offsets:
        """(k, 3, 3) int16: by how many periods their corners are moved."""
        simplex, corner = self._hull
        return self.offsets[simplex[:, None], CORNERS_OF_FACETS[corner]]

    @cached_property
    def vertex_neighbor_vertices(self) -> PeriodicNeighbors:  # type: ignore[override]
        """(indptr, indices, offsets), (n + 1,) int64, (2 e,) int32 and (2 e, 3) int32 for e edges: the vertices that share an
        edge with point i are points[indices[j]] + offsets[j] * box for j from indptr[i] to indptr[i + 1] - 1."""
        self._needs_space("vertex_neighbor_vertices")
        ends, offsets = self._edges
        ends, offsets = np.concatenate([ends, ends[:, ::-1]]), np.concatenate([offsets, -offsets])
        order, _ = _numbered(np.concatenate([ends, offsets], axis=1))
        counts = np.bincount(ends[:, 0], minlength=self.npoints)
        return PeriodicNeighbors(np.append(0, np.cumsum(counts)).astype(np.int64), ends[order, 1], offsets[order])

    @cached_property
    def _edges(self) -> Tuple[Indices, Indices]:
        """The edges and their offsets, without what the Voronoi diagram has beside them."""
        if self.nsimplex == 0:
            return np.zeros((0, 2), dtype=np.int32), np.zeros((0, 3), dtype=np.int32)
        return _core.edges_in_box(self.simplices, self.offsets, self.npoints, self._threads)

    @property
    def edges(self) -> Indices:
        """(e, 2) int32: the edges, the smaller index first, in lexicographical order; those with the same ends by their offsets."""
        return self._edges[0]

    @property
    def edge_offsets(self) -> Indices:
        """(e, 3) int32: by how many periods the second end of each edge is moved, if the first is not. Positive, in
        lexicographical order, where both are the same point."""
        return self._edges[1]

    def find_simplex(self, xi: Points, bruteforce: bool = False, tol: Optional[float] = None, *,
                     threads: Optional[SupportsIndex] = 1) -> Indices:
        """Return the numbers of the tetrahedra that have a copy that contains the points `xi`, of shape (…, 3); -1 outside the
        hull of a box without some period. (…,) int32.

        Exact: neither points nor copies are rounded. Facets and edges belong to a tetrahedron, and of several the one with the
        smallest number is meant. `find_copies` says which copy it is. `bruteforce` and `tol` are there for SciPy's callers, and
        change nothing.

        Raises ValueError if a coordinate is not a finite number, or a point is 2**29 or more periods away.
        """
        return self.find_copies(xi, threads=threads).simplices

    def find_copies(self, xi: Points, *, threads: Optional[SupportsIndex] = 1) -> SimplexCopies:
        """Return what `find_simplex` does, and by how many periods the copies that contain the points are moved: (…,) and
        (…, 3) int32. If several copies of a tetrahedron contain a point, the one with the lexicographically smallest offset
        counts. Outside the hull the offset is 0.
        """
        self._needs_space("find_simplex")
        queries, shape = self._rows_of(xi)
        found, offsets = _core.find_copies(self.points, self.simplices, self.neighbors, self._in_box, queries,
                                           number_of_threads("threads", threads))
        return SimplexCopies(found.reshape(shape), offsets.reshape(*shape, 3))

    def barycentric(self, xi: Points, simplex: Optional[ArrayLike] = None, offset: Optional[ArrayLike] = None, *,
                    threads: Optional[SupportsIndex] = 1) -> Reals:
        """Return the barycentric coordinates of the points `xi`, of shape (…, 3), in copies of tetrahedra: (…, 4) float64.

        `simplex` and `offset` are what `find_copies(xi)` returns, which is called if `offset` is left out. Outside the coordinates
        are NaN. In flat tetrahedra they are computed with as many digits as it takes.

        Raises ValueError if there are not as many simplices or offsets as points, or if `simplex` is given without `offset`, and
        is not what is found; IndexError for a simplex that does not exist; TypeError if simplices or offsets are no integers.
        """
        self._needs_space("barycentric")
        queries, shape = self._rows_of(xi)
        if offset is None:
            found = self.find_copies(xi, threads=threads)
            given = found.simplices if simplex is None else _core.read_alike(simplex, "simplex")
            if not np.array_equal(np.reshape(given, -1), found.simplices.reshape(-1)):
                raise ValueError("barycentric: other simplices than those of find_copies() need an offset for each")
            simplex, offset = found
        elif simplex is None:
            raise ValueError("barycentric: there are offsets, but no simplices")
        numbers_of, offsets = self._integers("simplex", simplex).reshape(-1), self._integers("offset", offset)
        if len(numbers_of) != len(queries) or offsets.size != 3 * len(queries):
            raise ValueError(f"barycentric: {len(numbers_of)} simplices and {offsets.size} numbers of offsets for "
                             f"{len(queries)} points")
        return _core.barycentric_in_box(self.points, self.simplices, self._in_box, queries, numbers_of,
                                        offsets.reshape(-1, 3), number_of_threads("threads", threads), False).reshape(*shape, 4)

    def _mesh(self) -> Tuple[Reals, Indices]:
        """Each tetrahedron has four points of its own, its `corners`."""
        return self.corners.reshape(-1, 3), np.arange(self.simplices.size, dtype=np.int32).reshape(self.simplices.shape)

    @property
    def voronoi_facets(self) -> PeriodicPowerFacets:  # type: ignore[override]
        """The facets of the Voronoi diagram: one crosses each edge of the triangulation. Two points may have several, at copies
        that lie on different sides, and a point some with its own copies."""
        self._needs_space("voronoi_facets")
        return self._facets_of_cells

    @property
    def inside(self) -> Truths:
        """Refused: no surface is given in a box."""
        self._not_in_box("inside", "give a surface without a box")

    @property
    def transform(self) -> Reals:
        """Refused: what it is multiplied with would have to be moved, and rounded."""
        self._not_in_box("transform", "use barycentric")

    def alpha_complex(self, alpha: Radius) -> PeriodicAlphaComplex:  # type: ignore[override]
        """Return the simplices that have an empty ball of radius `alpha` or less through their corners, with all their faces, or
        with weights those that the weighted alpha complex has: as without a box, each once, with the offsets of its corners."""
        simplices, ((vertices, _), (edges, of_edges), (triangles, of_triangles)) = self._faces_up_to(alpha)
        return PeriodicAlphaComplex(simplices, triangles, of_triangles, edges, of_edges, vertices[:, 0])

    def minimum_spanning_tree(self) -> Indices:
        """Refused: edges are not determined by indices of points here."""
        self._not_in_box("minimum_spanning_tree", "find one of the edges of vertex_neighbor_vertices")

    def check(self, level: str = "delaunay") -> bool:
        """Refused: what it checks is not known of boxes yet."""
        self._not_in_box("check", "compare it with that of the copies around")

    def _not_in_box(self, name: str, instead: str) -> NoReturn:
        raise ValueError(f"{name}: the points are in a periodic box: {instead}")

    @property
    def _hull(self) -> Tuple[Any, Any]:
        """Simplices with no neighbour, and the corners opposite."""
        simplex, corner = np.nonzero(self.neighbors < 0)
        return simplex, corner

    def _moved(self, points: Indices, offsets: Any) -> Reals:
        moved = np.asarray(self.points, dtype=float)[points]
        for axis in np.flatnonzero(np.isfinite(self._box)):
            moved[..., axis] += offsets[..., axis] * self._box[axis]
        return moved

class PeriodicRegular3(Periodic3, Regular3):  # type: ignore[misc]
    """A regular triangulation of points with weights in a periodic box: that of all copies, which have the weights of their
    points. It has what `Periodic3` and `Regular3` have; `power_facets` have offsets."""

    voronoi_facets = Regular3.voronoi_facets  # type: ignore[assignment]  # refused

    @property
    def power_facets(self) -> PeriodicPowerFacets:  # type: ignore[override]
        """The facets of the power diagram, as those of `Regular3`: one crosses each edge of the triangulation. Two points may
        have several, at copies that lie on different sides. A facet's area over twice the length of the edge is the derivative of
        one point's volume by the other's weight, with a minus sign; where both are one point, that is none."""
        self._needs_space("power_facets")
        return self._facets_of_cells
