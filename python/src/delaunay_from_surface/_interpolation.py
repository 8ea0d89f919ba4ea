# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""Interpolation between scattered points."""

from __future__ import annotations

import contextlib
import numbers
from typing import Any, Callable, Optional, SupportsIndex, Tuple, Union

import numpy as np

from . import _delaunay_from_surface as _core
from ._arguments import number_of_threads
from ._periodic import Periodic3, SimplexCopies
from ._regular import Regular3
from ._result import Delaunay3
from ._types import ArrayLike, Coordinates, Lists, Points, Reals, Values


class _Interpolator:
    """What linear interpolation and that between natural neighbours have in common."""

    triangulation: Delaunay3
    """The triangulation that was given, or made."""

    values: Values
    """(n, …) float64 or complex128: the array that was given, which should not be changed, or a copy."""

    fill_value: complex
    """The value outside the hull."""

    outside: str
    """"fill" or "nearest"."""

    def __init__(self, points: Union[Delaunay3, Points], values: ArrayLike, fill_value: complex = np.nan, *,
                 outside: str = "fill", threads: Optional[SupportsIndex] = 1) -> None:
        if outside not in ("fill", "nearest"):
            raise ValueError(f'outside: expected "fill" or "nearest", got {outside!r}')
        self._threads = number_of_threads("threads", threads)
        self.triangulation = points if isinstance(points, Delaunay3) else _triangulated(points, self._threads)
        self.values = _values_of(values, self.triangulation.npoints)
        self.fill_value = _number("fill_value", fill_value, is_real=self.values.dtype.kind == "f")
        self.outside = outside
        if self.triangulation.dimension < 3:
            raise ValueError(f"{type(self).__name__}: there are no tetrahedra, the points have dimension "
                             f"{self.triangulation.dimension}")
        if outside == "nearest" and isinstance(self.triangulation, (Periodic3, Regular3)):
            raise ValueError('outside: "nearest" is not there for periodic boxes and points with weights: leave it out')

    def __call__(self, *xi: Any) -> Values:
        """Return the values at the points `xi`: an array of shape (…, 3), or three arrays x, y and z that are
        broadcast.

        The result has the shape (…) and that of one value; float64 or complex128. Three numbers in one list are an
        array of one point, as in SciPy. The points are sorted by space, and each is looked for from the one before.
        """
        queries, shape = _queries_of(xi)
        return self._values_at(queries).view(self.values.dtype).reshape(shape + self.values.shape[1:])

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self.values.dtype} {self.values.shape} on {self.triangulation!r}>"

    def _values_at(self, queries: Coordinates) -> Reals:
        raise NotImplementedError

    def _interpolated(self, interpolate: Callable[..., Reals], queries: Coordinates) -> Reals:
        of = self.triangulation
        lists: Optional[Lists] = of.vertex_neighbor_vertices if self.outside == "nearest" else None
        return interpolate(of.points, of.simplices, of.neighbors, self._rows, self._fill, lists, queries, self._threads)

    @property
    def _rows(self) -> Reals:
        """(n, k): those of real numbers."""
        return self.values.reshape(len(self.values), -1).view(np.float64)

    @property
    def _fill(self) -> Reals:
        """(k,): the same of the fill value."""
        return np.full(self.values[0].size, self.fill_value, dtype=self.values.dtype).view(np.float64)


class LinearInterpolator(_Interpolator):
    """Linear interpolation in the tetrahedra of a triangulation, as SciPy's `LinearNDInterpolator` does it.

        >>> import numpy as np, delaunay_from_surface as dfs
        >>> points = np.random.default_rng(0).random((1000, 3))
        >>> interpolator = dfs.LinearInterpolator(points, points @ [1, 2, 3])
        >>> interpolator(.5, .5, [.25, .5, .75]).round(12).tolist()
        [2.25, 3.0, 3.75]

    Tetrahedra are found exactly, and in flat ones weights are computed with as many digits as it takes. So the result
    is never NaN inside the hull or on it unless a value is; at a vertex it is the value, to the last digit; and linear
    functions are reproduced. Otherwise it differs from SciPy's as follows: where a query is not a finite number the
    result is NaN, not the fill value; and there is no `rescale`: if the axes have different units, scale points and
    queries.

    Parameters
    ----------
    points
        A triangulation, or points (n, 3) as `delaunay3` takes them, which are triangulated. In a periodic box all
        copies of a point have its value, and queries may be anywhere less than 2**29 periods away. If points have
        weights, hidden points do not count.
    values
        The value of each point: (n, …) real or complex numbers, converted to float64 or complex128. Of equal points the
        first one counts, or with weights the heaviest. Values need not be finite: one that is not matters
        only where its weight is not 0, which is decided exactly.
    fill_value
        The value outside the hull.
    outside
        "fill", or "nearest": outside the hull queries get the value of the nearest vertex, exactly; of several that
        with the smallest index. The search goes from the last one found to nearer and nearer neighbours, so a query nearest to
        a vertex with very many neighbours takes correspondingly long. Not available for periodic boxes and points with
        weights.
    threads
        How many threads work, at most 64; None: as many as there are processors. The results are the same.

    Raises
    ------
    ValueError
        If the points lie in a plane, there are not as many values as points, an array is masked, the fill value is too
        large for a float64, `outside` or `threads` is none of those above, or a query in a box is 2**29 or more periods
        away.
    TypeError
        If values or queries are no numbers, or the fill value is none of that kind.
    """

    def gradients(self, *xi: Any) -> Values:
        """Return the gradients at the points `xi`, given as in a call: those of the linear functions in their
        tetrahedra.

        The result has the shape (…), that of one value, and 3. Outside the hull it is NaN. On a facet it is the
        gradient in the tetrahedron with the smaller number. Differences of values are rounded; the error carries over to the
        gradient, and may be large in a flat tetrahedron. Differences and gradients of weights beyond the range
        of float64 make it infinite or NaN.
        """
        queries, shape = _queries_of(xi)
        of = self.triangulation
        finite, queries = _replaced(queries, of)
        found = np.where(finite, of.find_simplex(queries, threads=self._threads), np.int32(-1))
        in_box = of._in_box if isinstance(of, Periodic3) else None
        gradients = _core.linear_gradients(of.points, of.simplices, in_box, self._rows, found, self._threads)  # (q, 3, k)
        components = gradients.view(self.values.dtype).reshape(shape + (3,) + self.values.shape[1:])
        return np.moveaxis(components, len(shape), -1)

    def _values_at(self, queries: Coordinates) -> Reals:
        if not isinstance(self.triangulation, Periodic3):
            return self._interpolated(_core.interpolate_linearly, queries)
        of = self.triangulation
        finite, queries = _replaced(queries, of)
        found = of.find_copies(queries, threads=self._threads)
        results = np.full((len(queries), self._rows.shape[1]), -0.)  # to which 0 and -0 may be added
        are_zeros_decided = not np.isfinite(self.values).all()
        size = max(_GROUP, of.npoints)  # all points are copied for each group
        for first in range(0, len(queries), size):
            group = slice(first, first + size)
            self._add_values(of, queries[group], SimplexCopies(*(array[group] for array in found)), results[group],
                             are_zeros_decided)
        results[found.simplices < 0] = self._fill
        results[~finite] = np.nan
        return results

    def _add_values(self, of: Periodic3, queries: Coordinates, found: SimplexCopies, results: Reals,
                    are_zeros_decided: bool) -> None:
        rows = self._rows
        weights = _core.barycentric_in_box(of.points, of.simplices, of._in_box, queries, found.simplices.astype(np.int64),
                                           found.offsets.astype(np.int64), self._threads, are_zeros_decided)
        with np.errstate(invalid="ignore", over="ignore"):
            for k in range(4):
                weight = weights[:, k, None]
                np.add(results, weight * rows[of.simplices[found.simplices, k]], out=results, where=weight != 0)


class NaturalNeighborInterpolator(_Interpolator):
    """Interpolation between natural neighbours, by Laplace's weights (Belikov, Ivanov, Kontorovich, Korytnik, Semenov
    1997; Hiyoshi, Sugihara 1999; Sukumar, Moran, Semenov, Belikov 2001).

        >>> import numpy as np, delaunay_from_surface as dfs
        >>> points = np.random.default_rng(0).random((1000, 3))
        >>> interpolator = dfs.NaturalNeighborInterpolator(points, points @ [1, 2, 3])
        >>> interpolator(.5, .5, [.25, .5, .75]).round(12).tolist()
        [2.25, 3.0, 3.75]

    If a query were a point, its Voronoi cell would have facets with those of some vertices, its natural neighbours. The
    weight of each is the area of the facet over the distance, divided by the sum of these. The interpolant reproduces
    linear functions, lies between the least and the greatest value of the neighbours, and does not depend on how ties
    are broken; it is continuous, and smooth except at the points and on the spheres through the corners of tetrahedra,
    where its gradient jumps. It is what finite volumes see: the Laplacian over a Voronoi cell is 0.

    Which vertices are neighbours is decided exactly. Areas are computed with as many digits as it takes to know the
    weights up to about 1e-12. On the hull, where cells are unbounded, weights are the limits from inside: only vertices
    in the same plane count, and on edges of the hull weights are linear. A value that is not finite matters where its
    weight is more than 1e-12. The time for a query grows with the number of its neighbours, about 20 among random
    points; but there may be as many as points, as within a hollow surface.

    What is given, and what is refused, is the same as for `LinearInterpolator`, but points with weights and periodic
    boxes are refused as well.
    """

    def __init__(self, points: Union[Delaunay3, Points], values: ArrayLike, fill_value: complex = np.nan, *,
                 outside: str = "fill", threads: Optional[SupportsIndex] = 1) -> None:
        for kind, what in ((Regular3, "points with weights"), (Periodic3, "periodic boxes")):
            if isinstance(points, kind):
                raise ValueError(f"NaturalNeighborInterpolator: it is not made for {what}: use LinearInterpolator")
        super().__init__(points, values, fill_value, outside=outside, threads=threads)

    def _values_at(self, queries: Coordinates) -> Reals:
        return self._interpolated(_core.interpolate_naturally, queries)


# How many queries in a box have their weights in memory at once, or as many as there are points.
_GROUP = 1 << 16


def _number(name: str, value: Any, is_real: bool) -> complex:
    value = _core.read_alike(value, name)
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value[()]
    if not isinstance(value, numbers.Real if is_real else numbers.Complex) or isinstance(value, bool):
        raise TypeError(f"{name}: expected a {'real ' if is_real else ''}number, as the values are, got {value!r}")
    with contextlib.suppress(OverflowError), np.errstate(over="ignore"):
        number = float(value) if is_real else complex(value)  # type: ignore[arg-type]
        if np.isinf(number) == np.isinf(value):  # type: ignore[call-overload]
            return number
    raise ValueError(f"{name}: {value!r} is too large for a float64")


def _triangulated(points: Points, threads: int) -> Delaunay3:
    array = np.asarray(_core.array_of_points(points, "points"))
    return Delaunay3(array, *_core.delaunay3(array, None, True, 0, None, threads, None, None), threads)


def _values_of(values: ArrayLike, n: int) -> Values:
    array = np.asarray(_core.read_alike(values, "values"))
    if array.dtype.kind not in "biufc":
        raise TypeError(f"values: expected numbers, got entries of type {array.dtype}")
    if array.shape[:1] != (n,):
        raise ValueError(f"values: expected an array of shape ({n}, …), one for each point, got {array.shape}")
    return np.ascontiguousarray(array, dtype=np.complex128 if array.dtype.kind == "c" else np.float64)


def _queries_of(xi: Tuple[Any, ...]) -> Tuple[Coordinates, Tuple[int, ...]]:
    """The points (q, 3), and the shape in which they were given."""
    if len(xi) == 1 and isinstance(xi[0], tuple):
        xi = xi[0]
    if len(xi) not in (1, 3):
        raise TypeError(f"xi: expected an array of shape (…, 3), or three arrays x, y and z, got {len(xi)} arguments")
    arrays = [np.asarray(_core.read_alike(argument, "xi")) for argument in xi]
    array = arrays[0] if len(arrays) == 1 else np.stack(np.broadcast_arrays(*arrays), axis=-1)
    if array.shape == (3,) and len(xi) == 1:
        array = array[None]
    if array.shape[-1:] != (3,):
        raise ValueError(f"xi: expected an array of shape (…, 3), or three arrays x, y and z, got {array.shape}")
    return _core.array_of_points(array.reshape(-1, 3), "xi"), array.shape[:-1]


def _replaced(queries: Coordinates, of: Delaunay3) -> Tuple[Any, Coordinates]:
    """Which queries are finite, and others in place of the rest."""
    finite = np.isfinite(queries).all(axis=1)
    return finite, np.where(finite[:, None], queries, of.points[0])
