# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""Points that move from step to step, and what that changes."""

from __future__ import annotations

import threading
from functools import cached_property
from typing import Any, Dict, Optional, SupportsIndex, Tuple

import numpy as np

from . import _delaunay_from_surface as _core
from ._arguments import index_type, number_of_threads
from ._delaunay_from_surface import InsertionOrder
from ._periodic import Periodic3, periods_of
from ._result import Delaunay3
from ._types import ArrayLike, Box, Indices, Points, Reals

Corners = Tuple[Indices, Optional[Any]]


class Changes:
    """What a step has changed. Simplices and edges are compared when they are first asked for, in linear time.

    A simplex is identified by the set of its corners, and an edge by its ends, wherever these have moved. Both are indices of
    points; among equal points the smallest index counts. In a periodic box, the offsets between them count as well; so points
    there should not be wrapped between steps.
    """

    before: Optional[Delaunay3]
    """The triangulation before the step; None before the first."""

    after: Delaunay3
    """The triangulation after it."""

    is_compared: bool
    """Whether there were as many points before the step. Else nothing is known of what became of which: all points
    count as moved, by an infinite distance, and all simplices and edges as gone or new."""

    moved: int
    """How many points have another place."""

    distance: float
    """The largest distance that a point has moved by; in a box, as the points were given."""

    def __init__(self, before: Optional[Delaunay3], after: Delaunay3, threads: int, dtype: Any) -> None:
        self.before, self.after = before, after
        self._threads, self._type = threads, dtype
        self.is_compared = before is not None and before.npoints == after.npoints
        self.moved, self.distance = after.npoints, float("inf")
        if before is not None and self.is_compared:
            self.moved, self.distance = _motion(before.points, after.points)

    def __repr__(self) -> str:
        return f"<Changes: {self.moved} of {self.after.npoints} points moved by up to {self.distance:g}>"

    @property
    def simplices_gone(self) -> Indices:
        """(g,): which of `before.simplices` are not in `after.simplices`, ascending."""
        return self._of_simplices[0]

    @property
    def simplices_new(self) -> Indices:
        """(k,): which of `after.simplices` are not in `before.simplices`, ascending."""
        return self._of_simplices[1]

    @property
    def edges_gone(self) -> Indices:
        """(g,): which of `before.edges` are not in `after.edges`, ascending."""
        return self._of_edges[0]

    @property
    def edges_new(self) -> Indices:
        """(k,): which of `after.edges` are not in `before.edges`, ascending."""
        return self._of_edges[1]

    @cached_property
    def _of_simplices(self) -> Tuple[Indices, Indices]:
        return self._compared(None if self.before is None else _simplices_of(self.before), _simplices_of(self.after))

    @cached_property
    def _of_edges(self) -> Tuple[Indices, Indices]:
        return self._compared(None if self.before is None else _edges_of(self.before), _edges_of(self.after))

    def _compared(self, before: Optional[Corners], after: Corners) -> Tuple[Indices, Indices]:
        if before is None or not self.is_compared:
            gone, new = np.arange(0 if before is None else len(before[0])), np.arange(len(after[0]))
        else:
            gone, new = _core.changed_simplices(*before, *after, self.after.npoints, self._threads)
        return gone.astype(self._type, copy=False), new.astype(self._type, copy=False)


class Moving:
    """Points that move a little from step to step, as in an optimisation: `update()` triangulates them anew.

    What helps the next step is kept: the order of insertion (see `InsertionOrder`; there is none in a periodic box),
    the weights and the box. The last triangulation is kept, too, and `changes` says how it differs from the one before.
    While a step is made, there are thus three triangulations: these two and the new one. Copies, and what is unpickled, find
    an order of their own.

    Parameters
    ----------
    points
        The first ones, as `update` takes them; or None.
    weights
        The weight of each point, as in `delaunay3`. They are copied, and count until others are given.
    box
        The periods of a periodic box, as in `delaunay3`.
    threads
        How many threads work; None: as many as there are processors.
    dtype
        The type of `simplices`, `neighbors`, `edges` and what `changes` has: int32, or int64, which some functions of
        PyTorch ask for. The triangulation itself has int32.

    Raises
    ------
    ValueError, TypeError
        As `delaunay3`; and TypeError for another `dtype`.
    """

    def __init__(self, points: Optional[Points] = None, *, weights: Optional[ArrayLike] = None,
                 box: Optional[Box] = None, threads: Optional[SupportsIndex] = 1, dtype: Any = "int32") -> None:
        self._weights = None if weights is None else _core.array_of_weights(weights, None)
        self._box = None if box is None else periods_of(box)
        self._threads = number_of_threads("threads", threads)
        self._type = index_type(dtype)
        self._order = InsertionOrder()
        self._at_work = threading.Lock()
        self._changes: Optional[Changes] = None
        if points is not None:
            self.update(points)

    def __repr__(self) -> str:
        return f"<Moving: {'nothing yet' if self._changes is None else repr(self.triangulation)[1:-1]}>"

    def __getstate__(self) -> Dict[str, Any]:
        return {name: value for name, value in vars(self).items() if name not in ("_order", "_at_work")}

    def __setstate__(self, state: Dict[str, Any]) -> None:
        vars(self).update(state, _order=InsertionOrder(), _at_work=threading.Lock())

    def update(self, points: Points, weights: Optional[ArrayLike] = None) -> Delaunay3:
        """Triangulate the points at their places now, and return the triangulation: what `delaunay3` would return.

        `points` is an array of shape (n, 3), or a tensor on any device. It is copied, so it may be changed in place
        afterwards, as optimisers do. `weights` are new ones; if they are left out, the last ones count. There may be
        more or fewer points than before. What is refused changes nothing. Raises what `delaunay3` does, and ValueError
        while another call is at work.
        """
        if self._at_work.locked():
            raise ValueError("update: another call is at work on this Moving")
        with self._at_work:  # whole whenever Ctrl-C comes; a call that begins at the same time waits
            return self._updated(points, weights)

    def _updated(self, points: Points, weights: Optional[ArrayLike]) -> Delaunay3:
        from . import delaunay3
        array = np.array(_core.array_of_points(points, "points"), subok=False)
        of_points = self._weights if weights is None else weights
        settings: Any = {"order": self._order} if self._box is None else {"box": self._box}
        made: Any = delaunay3(array, weights=of_points, neighbors=True, threads=self._threads, **settings)
        changes = Changes(None if self._changes is None else self._changes.after, made, self._threads, self._type)
        self._weights, self._changes = None if of_points is None else made.weights, changes
        return made

    @property
    def changes(self) -> Changes:
        """What the last step has changed."""
        if self._changes is None:
            raise ValueError("there is no triangulation yet: call update(points)")
        return self._changes

    @property
    def triangulation(self) -> Delaunay3:
        """What the last `update` returned."""
        return self.changes.after

    @property
    def simplices(self) -> Indices:
        """(m, d + 1): those of the triangulation. With int32 this and the next two are its own arrays, which the next
        step is compared with: they should not be written into."""
        return self.triangulation.simplices.astype(self._type, copy=False)

    @property
    def neighbors(self) -> Indices:
        """(m, d + 1): those of the triangulation."""
        return self.triangulation.neighbors.astype(self._type, copy=False)

    @property
    def edges(self) -> Indices:
        """(e, 2): those of the triangulation."""
        return self.triangulation.edges.astype(self._type, copy=False)


def _motion(before: Any, after: Any) -> Tuple[int, float]:
    """How many points have moved, and the largest distance."""
    with np.errstate(all="ignore"):
        step = after.astype(np.float64) - before
        lengths = np.hypot(np.hypot(step[:, 0], step[:, 1]), step[:, 2])
    return int(np.count_nonzero((after != before).any(axis=1))), float(lengths.max(initial=0))


def _simplices_of(triangulation: Delaunay3) -> Corners:
    return triangulation.simplices, triangulation.offsets if isinstance(triangulation, Periodic3) else None


def _edges_of(triangulation: Delaunay3) -> Corners:
    """Edges as simplices of two corners, the first of which is not moved."""
    if not isinstance(triangulation, Periodic3):
        return triangulation.edges, None
    offsets = triangulation.edge_offsets
    return triangulation.edges, np.stack([np.zeros_like(offsets), offsets], axis=1)
