# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""filtration(): all simplices of a triangulation, in the order in which alpha complexes grow."""

from __future__ import annotations

from typing import Any, NamedTuple, Optional, SupportsIndex, Tuple, Union

import numpy as np

from . import _delaunay_from_surface as _core
from ._arguments import number_of_threads
from ._periodic import Periodic3
from ._result import Delaunay3
from ._types import Indices, Places, Reals

KINDS = ("alpha", "delaunay")


class Filtration(NamedTuple):
    """The simplices of all dimensions, and the values at which they enter a growing complex.

    No face has a larger value than what it bounds, so for any number the simplices with at most that value form a complex.
    """

    simplices: Tuple[Indices, ...]
    """simplices[d]: (n_d, d + 1) int32: indices of points, ascending in each row; rows in lexicographical order, in a box that
    of `offsets`."""

    values: Tuple[Reals, ...]
    """values[d]: (n_d,) float64. In alpha complexes *squared* radii, as in GUDHI's; with weights they may be negative."""

    order: Places
    """(n_0 + n_1 + …,) int64: the places of the simplices, in the order in which they enter, if those of all dimensions stand
    one after the other, vertices first. Of equal values those of smaller dimension come first, then those of smaller
    place: all faces come before what they bound."""

    offsets: Optional[Tuple[Indices, ...]]
    """In a periodic box offsets[d]: (n_d, d + 1, 3) int32: by how many periods corners are moved; the first is not. Corners of
    a row, and rows, are ordered by point and offset, corner by corner; with few points a row may have a point twice. None
    without a box."""

    def to_gudhi(self) -> Any:
        """Return a gudhi.SimplexTree, for persistent homology: the same as GUDHI's own, but for the last digits of the values.

        Raises ValueError if vertices alone do not determine each simplex, as in a periodic box with few points.
        """
        import gudhi
        tree = gudhi.SimplexTree()
        if self.offsets is not None and self._has_repeated_rows():
            raise ValueError("to_gudhi: some simplices have the same vertices: there are too few points for the box")
        for simplices, values in zip(self.simplices, self.values):
            if hasattr(tree, "insert_batch"):
                tree.insert_batch(np.ascontiguousarray(simplices.T), values)
            else:
                for simplex, value in zip(simplices.tolist(), values.tolist()):
                    tree.insert(simplex, value)
        return tree

    def _has_repeated_rows(self) -> bool:
        """Whether two simplices have the same vertices, or one has a vertex twice."""
        return any((rows[:, 1:] == rows[:, :-1]).any() or (rows[1:] == rows[:-1]).all(axis=1).any() for rows in self.simplices)


def filtration(points: Any, *, weights: Any = None, box: Any = None, kind: str = "alpha",
               threads: Optional[SupportsIndex] = 1) -> Filtration:
    """Return the simplices of the Delaunay triangulation, or the regular one if there are weights, in the order in which
    alpha complexes grow.

    Parameters
    ----------
    points
        A triangulation that `delaunay3` has made, or points, as it takes them.
    weights, box
        Those of the points, as `delaunay3` takes them.
    kind
        "alpha": a simplex enters with the squared radius of the smallest ball that has its corners on its boundary and no
        other point inside; with weights, of the smallest sphere that is orthogonal to those of its corners, and to which no
        other point has less power. All vertices enter at 0, or with weights at no less than minus their weight.
        "delaunay": all values are 0, to be replaced by one's own.
    threads
        How many threads work, as in `delaunay3`. The result is the same for any number.

    Which ball is empty is decided exactly, and values are accurate to one unit in their last digit. They are squares: those of
    lengths below 1e-162 are 0, and beyond 1e154 infinite. Points in a plane or on a line have simplices of fewer dimensions.
    Hidden points and those that equal others are in none.

    Raises what `delaunay3` raises, and ValueError if there is no such kind, or there are more than 2**32 simplices.

    Expected time: linear, apart from sorting the faces of each vertex. Memory: about 1,400 bytes per point at the peak, and 800 for
    the result, where points have 6.8 tetrahedra each. Edelsbrunner, Mücke, ACM Trans. Graph. 13, 1994.
    """
    from . import delaunay3
    if kind not in KINDS:
        raise ValueError(f"kind: expected one of {', '.join(KINDS)}, got {kind!r}")
    number = number_of_threads("threads", threads)
    if not isinstance(points, Delaunay3):
        triangulation = delaunay3(points, weights=weights, box=box, threads=threads)
    elif weights is not None or box is not None:
        raise ValueError(f"{'box' if weights is None else 'weights'}: those of a triangulation cannot be changed: give points")
    else:
        triangulation = points
    faces = [] if triangulation.dimension < 0 else triangulation._faces(None, 0, number, kind == "alpha")
    simplices, offsets, values = (tuple(of_dimension[k] for of_dimension in faces) for k in range(3))
    order = _core.sorted_places(np.concatenate([*values, np.zeros(0)]))
    return Filtration(simplices, values, order, offsets if isinstance(triangulation, Periodic3) else None)
