# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""The 3D Delaunay triangulation of the vertices of a surface mesh, or of any points, in NumPy arrays.

    >>> import numpy as np, delaunay_from_surface as dfs
    >>> points = np.random.default_rng(0).random((1000, 3))
    >>> dfs.delaunay3(points).simplices.shape[1]
    4

The result is exact, and the same as that of CGAL's Delaunay_triangulation_3. Faces of a surface on the
points tell what is inside it; they never change the triangulation.
"""

from __future__ import annotations

import warnings
from typing import Callable, Iterable, List, NamedTuple, Optional, SupportsIndex, Tuple, overload

import numpy as np

from . import _delaunay_from_surface as _core
from ._arguments import number_of_threads, whole_number
from ._batch import delaunay3_batch
from ._cells import CellPolyhedron, PeriodicPowerFacets, PowerFacets
from ._dask import DaskTiles, delaunay3_dask
from ._delaunay_from_surface import InsertionOrder, Stopped, __version__ as __version__
from ._filtration import Filtration, filtration
from ._interpolation import LinearInterpolator, NaturalNeighborInterpolator
from ._moving import Changes, Moving
from ._periodic import Periodic3, PeriodicAlphaComplex, PeriodicNeighbors, PeriodicRegular3, SimplexCopies, periods_of
from ._progress import Bar, shown
from ._regular import Regular3
from ._result import AlphaComplex, Delaunay3, InsideFigures
from ._tiles import Tile, Tiles, delaunay3_tiles
from ._types import ArrayLike, Box, Faces, Indices, Points, Progress, Reals

__all__ = ["AlphaComplex", "CellPolyhedron", "Changes", "DaskTiles", "Delaunay3", "Filtration",
           "InsertionOrder", "InsideFigures", "LinearInterpolator", "Moving", "NaturalNeighborInterpolator",
           "Periodic3", "PeriodicAlphaComplex", "PeriodicNeighbors", "PeriodicPowerFacets", "PeriodicRegular3",
           "PowerFacets", "Regular3", "SimplexCopies", "Stopped", "SurfaceComponent", "Tile", "Tiles",
           "delaunay3", "delaunay3_batch", "delaunay3_dask", "delaunay3_tiles",
           "filtration", "subgraph", "surface_topology"]


class SurfaceComponent(NamedTuple):
    """A connected component of a triangulated surface."""

    number_of_vertices: int
    number_of_edges: int
    number_of_triangles: int
    number_of_boundary_loops: int
    euler_characteristic: int
    genus: int
    """The number of handles."""
    subgraph_degree_bound: int
    """The largest degree that `subgraph` can give a vertex here."""
    is_orientable: bool
    """Whether its triangles can be turned alike; else `genus` is the number of cross-caps."""


@overload
def delaunay3(points: Points, faces: Optional[Faces] = None, *, weights: None = None, box: None = None,
              neighbors: bool = False, inside: bool = False, seed: SupportsIndex = 0,
              progress: Progress = None, threads: Optional[SupportsIndex] = 1,
              order: Optional[InsertionOrder] = None) -> Delaunay3: ...


@overload
def delaunay3(points: Points, faces: Optional[Faces] = None, *, weights: ArrayLike, box: None = None,
              neighbors: bool = False, inside: bool = False, seed: SupportsIndex = 0,
              progress: Progress = None, threads: Optional[SupportsIndex] = 1,
              order: Optional[InsertionOrder] = None) -> Regular3: ...


@overload
def delaunay3(points: Points, faces: None = None, *, weights: None = None, box: Box, neighbors: bool = False,
              inside: bool = False, seed: SupportsIndex = 0, progress: Progress = None,
              threads: Optional[SupportsIndex] = 1, order: None = None) -> Periodic3: ...


@overload
def delaunay3(points: Points, faces: None = None, *, weights: ArrayLike, box: Box, neighbors: bool = False,
              inside: bool = False, seed: SupportsIndex = 0, progress: Progress = None,
              threads: Optional[SupportsIndex] = 1, order: None = None) -> PeriodicRegular3: ...


def delaunay3(points: Points, faces: Optional[Faces] = None, *, weights: Optional[ArrayLike] = None,
              box: Optional[Box] = None, neighbors: bool = False, inside: bool = False, seed: SupportsIndex = 0,
              progress: Progress = None, threads: Optional[SupportsIndex] = 1,
              order: Optional[InsertionOrder] = None) -> Delaunay3:
    """Return the Delaunay triangulation of points in space or in a periodic box, or the regular triangulation of points
    with weights.

    Parameters
    ----------
    points
        Array of shape (n, 3) with finite numbers. float64 and float32 are read where they are, and the result refers
        to them; other integers and reals are rounded to float64 first, so integers beyond 2**53 may coincide. They
        are copied while the order is made, so another thread may change them. Here and wherever numbers are asked
        for, a tensor of PyTorch may be on any device, and require a gradient, and an array of CuPy is read as well.
    faces
        Indices of points: an integer array of shape (m, k), or a sequence of sequences of any lengths.
        They need not be a manifold. They are checked, and used by `inside`; the simplices do not depend on them.
    weights
        The weight of each point, a squared radius: (n,) finite numbers, converted to float64. The result is then a
        `Regular3`, in which points may be hidden. It has no `inside`.
    box
        The period along each of the three axes, None or infinite along one that has none: `box=(1, 1, None)` is a slab.
        The result is then a `Periodic3` or, with weights, a `PeriodicRegular3`: the triangulation of all copies of the
        points, which may lie anywhere. It is exact, and copies are never rounded. It has no faces, no `inside` and no `order`;
        neighbours are always kept.
    neighbors
        Whether the neighbours are kept: they and the simplices are then views of one array, 16 bytes apart.
        Otherwise they are found when they are first asked for.
    inside
        Whether `winding_numbers` and `inside` of the result say which tetrahedra lie inside the faces, and
        `inside_figures` how sure that is. The surface may have gaps, and parts that overlap; faces that disagree with
        those around them are turned. If much of the volume may be wrong, a `UserWarning` says so.
    seed
        Seed of the random order of insertion, which takes over if the usual order, which is not random, turns out to
        be bad. Only the order of the simplices can depend on it.
    progress
        Is called about every 50 ms with the share of the points that are inserted, and at last with 1. If it
        returns False, the work stops and `Stopped` is raised; what it raises is passed on. The calls, and the response to
        Ctrl-C, begin once the order of the points is made. The interpreter lock is released in between. True shows a
        bar of tqdm on stderr, or a line of text where there is no tqdm.
    threads
        How many threads work, at most 64; None: as many as there are processors. With more than one the simplices are the
        same, but their order may differ from call to call. Few points take longer with two than with one: the README has
        the figures.
    order
        The order of insertion of the last call, for points that move a little from call to call: make an
        `InsertionOrder()` and pass it to all of them. It is filled anew if the number of points has changed, or if it
        has become too costly. The simplices are the same, in another order. 16 bytes per point.

    Raises
    ------
    ValueError
        If an array is masked or has the wrong shape, a coordinate or weight is not a finite number, or an index, the
        seed or the number of threads is out of range. If `inside` is asked of a surface that has none: less volume is
        surely inside (its winding number is near an integer other than 0) than in doubt, and its openings have more
        than 3/10 of its area, or several are wide. Examples are patches, sheets and short tubes. Nor does it have one
        if a part of it is not orientable, or its faces cancel each other. If a period is not positive, is less than 1/10000
        of the box's diagonal, or so small that points are 2**29 of them away or corners of a tetrahedron more than 32767
        of them apart, or if there are points, but all in a plane or on a line parallel to the axes that have periods.
    TypeError
        If an array does not hold numbers of the right kind.
    OverflowError
        If there are more than 2**30 cells: beyond 150 million points.
    MemoryError
        If there is not enough memory.

    Memory: about 270 bytes per point at the peak, the result included, where points have 6.8 cells each; more with `inside`,
    and 24 bytes per point more with `weights`.
    """
    if box is not None:
        return _in_box(points, faces, weights, periods_of(box), inside, seed, progress, threads, order)
    chosen = whole_number("seed", seed, 0, 2 ** 32 - 1)
    number = number_of_threads("threads", threads)
    array = np.asarray(_core.array_of_points(points, "points"))  # not one of a derived class
    array_of_weights = None if weights is None else _core.array_of_weights(weights, len(array))
    if inside:
        faces = _core.read_alike(faces, "faces")
        if weights is not None:
            raise ValueError("inside: the points have weights, which may hide vertices of the faces")
        if faces is None:
            raise ValueError("inside: there are no faces")
        if not isinstance(faces, np.ndarray):
            faces = _kept(faces)
    if order is not None and not isinstance(order, InsertionOrder):
        raise TypeError(f"order: expected an InsertionOrder, got {type(order).__name__}")
    with shown(progress, _show_share) as called:
        simplices, across, vertices, dimension = _core.delaunay3(array, faces, neighbors, chosen, called, number, order,
                                                                 array_of_weights)
    if array_of_weights is not None:
        return Regular3(array_of_weights, array, simplices, across, vertices, dimension, number)
    if faces is None or not inside:
        return Delaunay3(array, simplices, across, vertices, dimension, number)
    neighbors_of = _core.neighbors(simplices, len(array), number) if across is None else across
    winding_numbers, figures, warning = _core.winding_numbers(array, simplices, neighbors_of, vertices, faces, number)
    if warning:
        warnings.warn(f"inside: {warning}", stacklevel=2)
    return Delaunay3(array, simplices, across, vertices, dimension, number, winding_numbers, InsideFigures(*figures))


def _in_box(points: Points, faces: Optional[Faces], weights: Optional[ArrayLike], box: Reals, inside: bool,
            seed: SupportsIndex, progress: Progress, threads: Optional[SupportsIndex],
            order: Optional[InsertionOrder]) -> Periodic3:
    """What `delaunay3` returns for a box."""
    if faces is not None or inside:
        raise ValueError("faces: there are none in a periodic box: leave them out")
    if order is not None:
        raise ValueError("order: it is not kept for a periodic box, whose copies change from call to call: leave it out")
    chosen = whole_number("seed", seed, 0, 2 ** 32 - 1)
    number = number_of_threads("threads", threads)
    array = np.asarray(_core.array_of_points(points, "points"))
    array_of_weights = None if weights is None else _core.array_of_weights(weights, len(array))
    with shown(progress, _show_share) as called:
        views, offsets, is_simplicial_complex = _core.periodic3(array, box, chosen, called, number, array_of_weights)
    simplices, across, vertices, dimension = views
    arguments = (array, simplices, across, vertices, dimension, number)
    if array_of_weights is None:
        return Periodic3(box, offsets, is_simplicial_complex, *arguments)
    return PeriodicRegular3(box, offsets, is_simplicial_complex, array_of_weights, *arguments)


def _show_share(bar: Bar) -> Callable[[float], object]:
    return lambda share: bar.show("percent of the points", round(100 * share), 100)


def _kept(faces: Iterable[Iterable[SupportsIndex]]) -> List[Tuple[SupportsIndex, ...]]:
    """What may be read once, to be read twice."""
    try:
        return [tuple(face) for face in faces]
    except TypeError as error:
        raise TypeError("faces: expected sequences of integers") from error


def subgraph(faces: Faces, number_of_vertices: Optional[SupportsIndex] = None, *, tree: bool = False) -> Indices:
    """Return a spanning subgraph of small degree of a triangulated surface: its edges, (e, 2) int32.

    Parameters
    ----------
    faces
        Triangles, as in `delaunay3`: a manifold, closed or with boundary. How they are oriented does not matter.
    number_of_vertices
        One more than the largest index if left out.
    tree
        Whether cycles are left out: a spanning tree of each component.

    Raises ValueError, naming a face or a vertex, if the faces are not such a surface. Linear time.
    The degree of every vertex is at most 3 on spheres and discs, and at most 8 g + 2 b + 1 on an orientable
    component of genus g with b boundary loops (Choi, SoCG 2002).
    """
    return _core.subgraph(faces, _number_or_none(number_of_vertices), tree)


def surface_topology(faces: Faces, number_of_vertices: Optional[SupportsIndex] = None) -> List[SurfaceComponent]:
    """Return the connected components of a triangulated surface, in the order of their smallest vertex.

    `faces` and `number_of_vertices` are as in `subgraph`, and so are the exceptions. Vertices in no face are left out.
    Linear time.
    """
    components = _core.surface_topology(faces, _number_or_none(number_of_vertices))
    return [SurfaceComponent(*component) for component in components]


def _number_or_none(number_of_vertices: Optional[SupportsIndex]) -> Optional[int]:
    if number_of_vertices is None:
        return None
    return whole_number("number_of_vertices", number_of_vertices, 0, 2 ** 31 - 1)
