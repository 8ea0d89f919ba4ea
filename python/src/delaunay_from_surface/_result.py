# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""The result of delaunay3()."""

from __future__ import annotations

import numbers
from functools import cached_property
from typing import Any, List, NamedTuple, Optional, SupportsIndex, Tuple

import numpy as np

from . import _delaunay_from_surface as _core
from ._arguments import number_of_threads
from ._cells import CellPolyhedron, Cells, PowerFacets
from ._types import ArrayLike, Coordinates, InBox, Indices, Lists, Points, Radius, Reals, Spheres, Truths

LEVELS = ("links", "euler", "orientation", "delaunay")
NAMES = {3: "tetrahedra", 2: "triangles", 1: "segments", 0: "vertices", -1: "simplices"}


class AlphaComplex(NamedTuple):
    """The simplices of `Delaunay3.alpha_complex()` or `Regular3.alpha_complex()`."""

    simplices: Indices
    """(j,) int32: numbers of tetrahedra, ascending."""

    triangles: Indices
    """(k, 3) int32: indices of points, ascending; those of the tetrahedra included."""

    edges: Indices
    """(e, 2) int32: the same."""

    vertices: Indices
    """(v,) int32: the same."""


class InsideFigures(NamedTuple):
    """How sure it is which tetrahedra are inside. Where more than a tenth of the volume may be wrong, or a twentieth is
    in doubt, `delaunay3(…, inside=True)` warns as well."""

    number_of_turned: int
    """How many faces have been turned round, to agree with their neighbours."""

    number_of_doubtful: int
    """How many tetrahedra have winding numbers that differ by more than 0.1 from every whole one."""

    number_of_multiple: int
    """How many tetrahedra lie in more than one part."""

    doubtful_volume: float
    """The volume of the tetrahedra in doubt, divided by that of those inside."""

    share_of_openings: float
    """The area of triangles that would close the openings, divided by that of the faces."""

    missing_area: float
    """The area of the faces that are no facets of the triangulation, divided by that of all."""

    crossed_volume: float
    """A bound on the volume that may be wrong, since such faces cut tetrahedra in parts, divided by that of the
    tetrahedra inside and of what may be missing there."""


def _numbers_of(name: str, array: Indices) -> Indices:
    """Return the array itself, or an equal one of int32."""
    if array.dtype == np.int32:
        return array
    narrow = array.astype(np.int32) if array.dtype.kind in "iu" else None
    if narrow is None or not np.array_equal(narrow, array):
        raise ValueError(f"{name}: expected numbers of 32 bits, got entries of type {array.dtype}")
    return narrow


class Delaunay3(Cells):
    """A Delaunay triangulation in NumPy arrays. The names are those of scipy.spatial.Delaunay.

    Points, simplices and vertices are there; the rest is computed when it is first asked for, and kept. Differences
    from SciPy's class:

    ===================  ===========================================  =============================================
    .                    scipy.spatial.Delaunay                       here
    ===================  ===========================================  =============================================
    arithmetic           rounded; options of Qhull                    exact; there are no options
    orientation          as it comes                                  positive: det(b - a, c - a, d - a) > 0
    ties                 of cospherical points some tetrahedra may    one triangulation, that of CGAL, which depends
                         overlap or be missing                        on the points alone
    equal points         in `coplanar`                                in `coplanar`; `vertices` names the first one
    points in a plane    QhullError                                   triangles, segments or a point: `dimension`
    find_simplex         rounded, with a tolerance; any simplex       exact; of several the one with the smallest
                         where several contain a point                number; NaN is refused
    convex_hull          facets oriented as they come                 seen from outside counterclockwise
    coplanar             near a facet by rounding, too                only points equal to another
    dimensions           two and more                                 three
    simplices            int32, in one piece                          the same; with neighbors=True rows of 32 bytes
    incremental          yes                                          no: all points at once
    ===================  ===========================================  =============================================

    There are no `add_points`, `close`, `equations`, `good`, `lift_points`, `paraboloid_scale`, `plane_distance`, and
    SciPy's interpolators take only its own class: `LinearInterpolator` is there in place of `LinearNDInterpolator`.
    """

    points: Coordinates
    """(n, 3): the array that was given, which should not be changed as long as this is asked; or a copy in float64,
    if it was neither float64 nor float32."""

    simplices: Indices
    """(m, d + 1) int32: indices of points; tetrahedra with positive orientation if d is 3."""

    vertices: Indices
    """(n,) int32: for each point the smallest index of a point equal to it, which stands in `simplices`."""

    dimension: int
    """d: 3; less if all points lie in a plane, on a line or in one place; -1 if there are none."""

    winding_numbers: Optional[Reals]
    """(m,) float64: how often the faces go around the centre of each tetrahedron, up to about 0.01 (Jacobson, Kavan,
    Sorkine-Hornung 2013); None unless `delaunay3(…, inside=True)` was called. Near 1 or another whole number inside a
    surface that is nearly closed, near 0 outside; in between near its gaps."""

    inside_figures: Optional[InsideFigures]
    """How sure `winding_numbers` and `inside` are; None if these have not been asked for."""

    def __init__(self, points: Coordinates, simplices: Indices, neighbors: Optional[Indices], vertices: Indices,
                 dimension: int, threads: int = 1, winding_numbers: Optional[Reals] = None,
                 inside_figures: Optional[InsideFigures] = None) -> None:
        self.points = points
        self.simplices = _numbers_of("simplices", simplices)
        self.vertices = _numbers_of("vertices", vertices)
        self.dimension = dimension
        self.winding_numbers = winding_numbers
        self.inside_figures = inside_figures
        self._threads = threads
        if neighbors is not None:
            self.__dict__["neighbors"] = _numbers_of("neighbors", neighbors)  # it need not be computed

    def __setattr__(self, name: str, value: object) -> None:
        """Each once: what is computed from one is kept, and would not be that of another."""
        if name in self.__dict__ or hasattr(type(self), name):
            raise AttributeError(f"{name}: a triangulation does not change: make another one")
        super().__setattr__(name, value)

    def __repr__(self) -> str:
        return f"<Delaunay3: {self.npoints} points, {self.nsimplex} {NAMES[self.dimension]}>"

    def __reduce__(self) -> Tuple[Any, ...]:
        return (type(self), (self.points, self.simplices, self.__dict__.get("neighbors"), self.vertices,
                             self.dimension, self._threads, self.winding_numbers, self.inside_figures))

    @property
    def _in_box(self) -> InBox:
        """The periods, and the offsets of the corners, of a triangulation in a periodic box."""
        return None

    @property
    def ndim(self) -> int:
        """3: that of the space."""
        return 3

    @property
    def npoints(self) -> int:
        """How many points were given."""
        return len(self.points)

    @property
    def nsimplex(self) -> int:
        """How many simplices there are."""
        return len(self.simplices)

    @property
    def inside(self) -> Truths:
        """(m,) bool: which tetrahedra are inside the faces: their winding numbers are 1/2 or more, or -1/2 or less."""
        if self.winding_numbers is None:
            raise ValueError("inside: it has not been asked for: delaunay3(…, inside=True)")
        return np.abs(self.winding_numbers) >= 0.5

    @property
    def min_bound(self) -> Coordinates:
        """(3,): the least coordinates."""
        return self.points.min(axis=0)

    @property
    def max_bound(self) -> Coordinates:
        """(3,): the greatest coordinates."""
        return self.points.max(axis=0)

    @cached_property
    def neighbors(self) -> Indices:
        """(m, d + 1) int32: the simplex opposite to each vertex, -1 outside the convex hull.

        With `delaunay3(…, neighbors=True)` they are there at once; else they are found when they are first asked for,
        which takes more memory on the way.
        """
        return _core.neighbors(self.simplices, self.npoints, self._threads)

    @cached_property
    def convex_hull(self) -> Indices:
        """(k, d) int32: the facets of the convex hull; triangles counterclockwise as seen from outside."""
        simplex, corner = np.nonzero(self.neighbors < 0)
        facets = {3: [[1, 2, 3], [2, 0, 3], [0, 1, 3], [2, 1, 0]], 2: [[1, 2], [2, 0], [0, 1]],
                  1: [[1], [0]]}.get(self.dimension)
        if facets is None:
            return np.zeros((0, max(self.dimension, 0)), dtype=np.int32)
        return self.simplices[simplex[:, None], np.array(facets)[corner]]

    @cached_property
    def vertex_to_simplex(self) -> Indices:
        """(n,) int32: a simplex of each point; -1 for one that equals another with a smaller index."""
        simplex = np.full(self.npoints, -1, dtype=np.int32)
        for corner in self.simplices.T:
            simplex[corner] = np.arange(self.nsimplex, dtype=np.int32)
        return simplex

    @cached_property
    def coplanar(self) -> Indices:
        """(k, 3) int32: points that are no vertices, with a simplex and the vertex in the same place."""
        point = np.flatnonzero((self.vertices != np.arange(self.npoints)) & (self.vertices >= 0)).astype(np.int32)
        vertex = self.vertices[point]
        return np.stack([point, self.vertex_to_simplex[vertex], vertex], axis=1)

    @cached_property
    def vertex_neighbor_vertices(self) -> Lists:
        """(indptr, indices), (n + 1,) int64 and (2 e,) int32 for e edges: the vertices that share an edge with point i,
        ascending, are indices[indptr[i]:indptr[i + 1]]."""
        return _core.adjacent_vertices(self.simplices, self.npoints, self._threads)

    @cached_property
    def edges(self) -> Indices:
        """(e, 2) int32: the edges, the smaller index first, in lexicographical order."""
        indptr, indices = self.vertex_neighbor_vertices
        first = np.repeat(np.arange(self.npoints, dtype=np.int32), np.diff(indptr))
        once = first < indices
        return np.stack([first[once], indices[once]], axis=1)

    def find_simplex(self, xi: Points, bruteforce: bool = False, tol: Optional[float] = None, *,
                     threads: Optional[SupportsIndex] = 1) -> Indices:
        """Return the numbers of the tetrahedra that contain the points `xi`, of shape (…, 3); -1 outside. (…,) int32.

        Exact: facets and edges belong to a tetrahedron, and of several the one with the smallest number is meant.
        `bruteforce` and `tol` are there for SciPy's callers, and change nothing. The points are sorted by space, and
        each is looked for from the one before.

        Raises ValueError if a coordinate is not a finite number, or the points of the triangulation lie in a plane.
        """
        self._needs_space("find_simplex")
        queries, shape = self._rows_of(xi)
        number = number_of_threads("threads", threads)
        return _core.find_simplex(self.points, self.simplices, self.neighbors, queries, number).reshape(shape)

    @cached_property
    def transform(self) -> Reals:
        """(m, 4, 3) float64, as SciPy has it: transform[i, :3] @ (x - transform[i, 3]) are the first three
        barycentric coordinates of x in simplex i, up to 1e-9 for x in it. As in SciPy transform[i, :3] is NaN for flat
        simplices, where rounding x - transform[i, 3] alone could change them by more. `barycentric` is right in these,
        too, and does not need 96 bytes for each simplex."""
        self._needs_space("transform")
        return _core.transform(self.points, self.simplices, self._threads)

    def barycentric(self, xi: Points, simplex: Optional[ArrayLike] = None, *,
                    threads: Optional[SupportsIndex] = 1) -> Reals:
        """Return the barycentric coordinates of the points `xi`, of shape (…, 3), in their simplices: (…, 4) float64.

        `simplex` is what `find_simplex(xi)` returns, which is called if it is left out. Outside they are NaN. In flat
        simplices they are computed with as many digits as it takes: at the data points they are exact, and
        in a simplex that contains the query they are between 0 and 1, up to 1e-13.

        Raises ValueError if there are not as many simplices as points, or the points of the triangulation lie in a
        plane; IndexError for a simplex that does not exist; TypeError if simplices are no integers.
        """
        self._needs_space("barycentric")
        given = self.find_simplex(xi, threads=threads) if simplex is None else simplex
        numbers_of = self._integers("simplex", given).reshape(-1)
        queries, shape = self._rows_of(xi)
        if len(numbers_of) != len(queries):
            raise ValueError(f"barycentric: {len(numbers_of)} simplices for {len(queries)} points")
        number = number_of_threads("threads", threads)
        return _core.barycentric(self.points, self.simplices, queries, numbers_of, number).reshape(*shape, 4)

    @cached_property
    def volumes(self) -> Reals:
        """(m,) float64: the volumes of the tetrahedra."""
        self._needs_space("volumes")
        return _core.volumes(self.points, self.simplices, self._in_box, self._threads)

    @cached_property
    def _circumspheres(self) -> Spheres:
        return _core.circumspheres(self.points, self.simplices, self._in_box, self._threads)

    @property
    def circumcenters(self) -> Reals:
        """(m, 3) float64: the centres of the spheres through the corners, Voronoi's vertices."""
        self._needs_space("circumcenters")
        return self._circumspheres[0]

    @property
    def circumradii(self) -> Reals:
        """(m,) float64: the radii of these spheres."""
        self._needs_space("circumradii")
        return self._circumspheres[1]

    @property
    def voronoi_volumes(self) -> Reals:
        """(n,) float64: the volume of each point's Voronoi cell; -1 where it is unbounded, as on the convex hull.
        Equal points have the cell of their vertex."""
        self._needs_space("voronoi_volumes")
        return self._volumes_of_cells

    @property
    def voronoi_areas(self) -> Reals:
        """(n,) float64: the surface area of each point's Voronoi cell; -1 where it is unbounded."""
        self._needs_space("voronoi_areas")
        return self._areas_of_cells

    @property
    def voronoi_facets(self) -> PowerFacets:
        """The facets of the Voronoi diagram: one crosses each edge of the triangulation, at right angles, perhaps beyond
        its ends. `facet_corners` and `solid_angles` have a row for each. Linear; at the peak 1.2 kB for each point. Arrays of
        cells and facets, of which later answers are made, cannot be written to."""
        self._needs_space("voronoi_facets")
        return self._facets_of_cells

    def voronoi_cell(self, i: SupportsIndex) -> CellPolyhedron:
        """Return the Voronoi cell of point `i` as a polyhedron, to be drawn, for example. Corners where more than four cells
        meet are merged, and facets that are only an edge or a corner are left out, by exact arithmetic.

        Raises ValueError if the cell is unbounded, or if all points lie in a plane, or if there is no such point.
        """
        return self._cell("voronoi_cell", i)

    def alpha_complex(self, alpha: Radius) -> AlphaComplex:
        """Return the simplices that have an empty ball of radius `alpha` or less through their corners, with all
        their faces: a complex for any `alpha`. Which ball is empty is decided exactly; radii are rounded, but no face has a
        larger one than what it bounds.

        Its tetrahedra are those with a circumradius of at most `alpha`. `alpha` is a radius, not a square. For all radii at
        once see `filtration`.
        """
        simplices, ((vertices, _), (edges, _), (triangles, _)) = self._faces_up_to(alpha)
        return AlphaComplex(simplices, triangles, edges, vertices[:, 0])

    def minimum_spanning_tree(self) -> Indices:
        """Return a Euclidean minimum spanning tree of the vertices: (k, 2) int32, from the shortest edge to the longest.

        Lengths are compared exactly; among equal ones smaller indices come first.
        """
        return _core.minimum_spanning_tree(self.points, self.simplices, self._threads)

    def check(self, level: str = "delaunay") -> bool:
        """Return whether this is the Delaunay triangulation of its points, or the regular one if they have weights, as
        far as the level goes.

        Each level includes those before it: "links" (simplices share facets in pairs, oriented alike), "euler" (around
        each vertex there is a sphere), "orientation" (all are positive), "delaunay" (no sphere contains the vertex
        across a facet; ties are decided as CGAL does; and no point is in two simplices). The last two by exact
        arithmetic. Linear.
        """
        if level not in LEVELS:
            raise ValueError(f"check: expected one of {', '.join(LEVELS)}, got {level!r}")
        return _core.is_valid(self.points, self.simplices, self.vertices, self.dimension, LEVELS.index(level),
                              self._threads, self.__dict__.get("_weights"))

    def to_vtk(self) -> Any:
        """Return a vtkUnstructuredGrid of the simplices, with copies of points and indices."""
        from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
        from vtkmodules.vtkCommonCore import vtkPoints
        from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkUnstructuredGrid
        points, cells = self._mesh()
        places, rows, grid = vtkPoints(), vtkCellArray(), vtkUnstructuredGrid()
        places.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
        ends = np.arange(0, cells.size + 1, max(cells.shape[1], 1), dtype=np.int64)
        rows.SetData(*(numpy_to_vtkIdTypeArray(array, deep=True) for array in (ends, cells.reshape(-1).astype(np.int64))))
        grid.SetPoints(places)
        grid.SetCells({3: 10, 2: 5, 1: 3}.get(self.dimension, 1), rows)  # VTK_TETRA, VTK_TRIANGLE, VTK_LINE, VTK_VERTEX
        return grid

    def to_pyvista(self) -> Any:
        """Return a pyvista.UnstructuredGrid of the simplices, with copies of points and indices."""
        import pyvista
        points, cells = self._mesh()
        if len(cells) == 0:
            return pyvista.UnstructuredGrid()
        kind = getattr(pyvista.CellType, {3: "TETRA", 2: "TRIANGLE", 1: "LINE", 0: "VERTEX"}[self.dimension])
        return pyvista.UnstructuredGrid({kind: cells.copy()}, points.copy())

    def plot(self, **options: Any) -> Any:
        """Show the simplices by PyVista, in a notebook, too: what `to_pyvista().plot(show_edges=True, **options)` does and
        returns."""
        return self.to_pyvista().plot(**{"show_edges": True, **options})

    def to_meshio(self) -> Any:
        """Return a meshio.Mesh of the simplices, with copies of points and indices."""
        import meshio
        points, cells = self._mesh()
        kind = {3: "tetra", 2: "triangle", 1: "line"}.get(self.dimension, "vertex")
        return meshio.Mesh(points.copy(), [(kind, cells.copy())])

    def _mesh(self) -> Tuple[Coordinates, Indices]:
        """Points and cells in one piece, as programs for meshes take them."""
        return self.points, np.ascontiguousarray(self.simplices)

    @staticmethod
    def _integers(name: str, given: ArrayLike) -> Any:
        array = np.asarray(_core.read_alike(given, name))
        if array.dtype.kind not in "iu":
            raise TypeError(f"barycentric: {name}: expected integers, got entries of type {array.dtype}")
        return array if array.dtype.kind == "i" else np.minimum(array.astype(np.uint64), 2 ** 63 - 1)  # none becomes -1

    def _needs_space(self, name: str) -> None:
        if self.dimension < 3:
            raise ValueError(f"{name}: there are no tetrahedra, the points have dimension {self.dimension}")

    @staticmethod
    def _rows_of(given: Any) -> Tuple[Coordinates, Tuple[int, ...]]:
        xi = _core.read_alike(given, "xi")
        shape = np.shape(xi)
        if len(shape) == 0 or shape[-1] != 3:
            return _core.array_of_points(xi, "xi"), (0,)
        is_refused = isinstance(xi, np.ma.MaskedArray)
        array = xi if len(shape) == 2 or is_refused else np.reshape(xi, (-1, 3))
        return _core.array_of_points(array, "xi"), shape[:-1]

    def _faces_up_to(self, alpha: Radius) -> Tuple[Indices, List[Tuple[Indices, Indices]]]:
        """The tetrahedra whose spheres have at most this radius; and vertices, edges and triangles, each with offsets."""
        self._needs_space("alpha_complex")
        alpha = _core.read_alike(alpha, "alpha")
        if isinstance(alpha, np.ndarray) and alpha.ndim == 0:
            alpha = alpha[()]
        if not isinstance(alpha, numbers.Real) or not alpha >= 0:
            raise ValueError(f"alpha_complex: expected a radius, got {alpha!r}")
        # In units of alpha: what is too small or too large for a square is much smaller or larger.
        exponent = int(np.frexp(float(alpha))[1]) if 0 < alpha < np.inf else -1000 if alpha == 0 else 0
        with np.errstate(over="ignore", under="ignore"):
            most = np.square(np.ldexp(float(alpha), -exponent))
            *faces, (_, _, squares, simplices) = self._faces(self._squared_radii(exponent), exponent)
        return np.sort(simplices[squares <= most]), [
            (rows[values <= most], rows if offsets is None else offsets[values <= most]) for rows, offsets, values, _ in faces]

    def _squared_radii(self, exponent: int) -> Optional[Reals]:
        """Those of the tetrahedra, over 4 to the power, in the alpha complex: of `circumradii`, so that they agree."""
        return np.square(np.ldexp(self.circumradii, -exponent))

    def _faces(self, values: Optional[Reals], exponent: int, threads: Optional[int] = None, has_values: bool = True) -> Any:
        """The simplices of each dimension with offsets, values over 4 to the power, and numbers of those of the largest."""
        return _core.filtration(self.points, self.__dict__.get("_weights"), self.simplices, self._in_box, values, has_values,
                                exponent, self._threads if threads is None else threads)
