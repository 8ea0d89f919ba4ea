# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""Many sets of points at once."""

from __future__ import annotations

import threading
from collections import deque
from typing import Any, Dict, Iterable, List, Optional, SupportsIndex

from . import _delaunay_from_surface as _core
from ._arguments import number_of_threads
from ._periodic import periods_of
from ._result import Delaunay3
from ._types import ArrayLike, Box, Points


def delaunay3_batch(points: Iterable[Points], weights: Optional[Iterable[Optional[ArrayLike]]] = None, *,
                    box: Optional[Box] = None, neighbors: bool = False, threads: Optional[SupportsIndex] = None
                    ) -> List[Delaunay3]:
    """Return the triangulations of many sets of points: for each what `delaunay3` would return.

    Each is made by one thread, so all arrays are the same at every call, whatever the number of threads. Ctrl-C ends
    them all.

    Parameters
    ----------
    points
        A sequence of sets as `delaunay3` takes them: arrays or tensors of shape (n, 3), of any lengths. Or one array or
        tensor of shape (b, n, 3) with b sets.
    weights
        Those of each set, None for one that has none; or an array or tensor of shape (b, n).
    box
        The periods of a periodic box, the same for all sets.
    neighbors
        As in `delaunay3`.
    threads
        How many sets are triangulated at once; None: as many as there are processors.

    Raises
    ------
    ValueError, TypeError, OverflowError, MemoryError
        As `delaunay3`, with the number of the set: of several the first. And ValueError if there are not as many
        weights as sets.
    """
    number = number_of_threads("threads", threads, most=None)
    sets = _sets_of("points", points, 3)
    of_sets: List[Any] = [None] * len(sets) if weights is None else _sets_of("weights", weights, 2)
    if len(of_sets) != len(sets):
        raise ValueError(f"weights: expected those of {len(sets)} sets, one array for each or None, got {len(of_sets)}")
    batch = _Batch(sets, of_sets, box=None if box is None else periods_of(box), neighbors=neighbors)
    others = [threading.Thread(target=batch.work) for _ in range(min(number, len(sets)) - 1)]
    started: List[threading.Thread] = []
    try:
        for thread in others:
            thread.start()
            started.append(thread)
        batch.work()
        for thread in started:
            thread.join()
    except BaseException:  # such as KeyboardInterrupt, which is raised in this thread
        batch.is_stopped = True
        for thread in started:
            thread.join()
        raise
    return batch.results()


class _Batch:
    """Sets that threads take one by one, in their order."""

    def __init__(self, sets: List[Any], weights: List[Any], **settings: Any) -> None:
        self._sets, self._weights, self._settings = sets, weights, settings
        self._to_do = deque(range(len(sets)))
        self._made: List[Any] = [None] * len(sets)
        self._errors: Dict[int, Exception] = {}
        self.is_stopped = False

    def work(self) -> None:
        """What each thread does. After an error no further set is begun; those before it have been, and are ended."""
        from . import delaunay3
        while not self._errors and not self.is_stopped:
            try:
                k = self._to_do.popleft()
            except IndexError:
                return
            try:
                self._made[k] = delaunay3(self._sets[k], weights=self._weights[k],
                                          progress=lambda _: not self.is_stopped, **self._settings)
            except Exception as error:
                self._errors[k] = error

    def results(self) -> List[Delaunay3]:
        """One for each set, if there was no error."""
        if self._errors:
            k = min(self._errors)
            error = self._errors[k]
            if not isinstance(error, (ValueError, TypeError, OverflowError, MemoryError)):
                raise error
            raise type(error)(f"set {k}: {error}") from error
        return self._made


def _sets_of(name: str, given: Any, dimensions: int) -> List[Any]:
    """One for each set: of an array with so many dimensions its parts, which are not copied."""
    array = _core.read_alike(given, name)
    shape = getattr(array, "shape", None)
    if shape is not None and len(shape) != dimensions:
        expected = "(b, n, 3)" if dimensions == 3 else "(b, n)"
        raise ValueError(f"{name}: expected an array of shape {expected}, or a sequence with one for each set, "
                         f"got {tuple(shape)}")
    try:
        return list(array)
    except TypeError:
        kind = type(given).__name__
        raise TypeError(f"{name}: expected a sequence with one array for each set, got {kind}") from None
