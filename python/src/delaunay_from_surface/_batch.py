# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""Many sets of points at once."""

from __future__ import annotations

import contextlib
import threading
from collections import deque
from typing import Any, Dict, Iterable, List, Optional, SupportsIndex

import numpy as np

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
        tensor of shape (b, n, 3) with b sets, or NumPy's array of b objects.
    weights
        Those of each set, None for one that has none; or an array or tensor of shape (b, n).
    box
        The periods of a periodic box, the same for all sets.
    neighbors
        As in `delaunay3`.
    threads
        How many sets are triangulated at once, or fewer if not so many threads can be started; None: as many as there
        are processors.

    Raises
    ------
    ValueError, TypeError, OverflowError, MemoryError
        As `delaunay3`, with the number of the first set that failed. Other exceptions are passed on unchanged.
        Also ValueError if there are not as many weights as sets.
    """
    number = number_of_threads("threads", threads, most=None)
    sets = _sets_of("points", points, 3)
    of_sets: List[Any] = [None] * len(sets) if weights is None else _sets_of("weights", weights, 2)
    if len(of_sets) != len(sets):
        raise ValueError(f"weights: expected those of {len(sets)} sets, one array for each or None, got {len(of_sets)}")
    batch = _Batch(sets, of_sets, box=None if box is None else periods_of(box), neighbors=neighbors)
    started: List[threading.Thread] = []
    try:
        with contextlib.suppress(RuntimeError):  # if there can be no more threads, those that work do it all
            for _ in range(min(number, len(sets)) - 1):
                thread = threading.Thread(target=batch.work)
                started.append(thread)
                thread.start()
        batch.work()
        for thread in filter(threading.Thread.is_alive, started):
            thread.join()
    except BaseException:  # such as KeyboardInterrupt, which is raised in this thread
        batch.is_stopped = True
        for thread in filter(threading.Thread.is_alive, started):
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
        self._ended_by: Optional[BaseException] = None
        self.is_stopped = False

    def work(self) -> None:
        """What each thread does. After an error no further set is begun; those before it have been, and are ended."""
        try:
            while not self._errors and not self.is_stopped and self._to_do:
                self._make_next()
        except BaseException as error:  # such as SystemExit: without this thread some sets would be missing
            self._ended_by, self.is_stopped = error, True

    def _make_next(self) -> None:
        from . import delaunay3
        try:
            k = self._to_do.popleft()
        except IndexError:  # another thread was faster
            return
        try:
            self._made[k] = delaunay3(self._sets[k], weights=self._weights[k],
                                      progress=lambda _: not self.is_stopped, **self._settings)
        except Exception as error:
            self._errors[k] = error

    def results(self) -> List[Delaunay3]:
        """One for each set, if there was no error."""
        if self._ended_by is not None:
            raise self._ended_by
        if self._errors:
            k = min(self._errors)
            error = self._errors[k]
            for kind in (ValueError, TypeError, OverflowError, MemoryError):
                if isinstance(error, kind):  # those derived from it may be made of something else than a text
                    raise kind(f"set {k}: {error}") from error
            raise error
        return self._made


def _sets_of(name: str, given: Any, dimensions: int) -> List[Any]:
    """One for each set: of an array with so many dimensions its parts, which are not copied."""
    array = given if isinstance(given, (list, tuple)) else _core.read_alike(given, name)
    shape = getattr(array, "shape", None)
    is_of_objects = isinstance(array, np.ndarray) and array.dtype == object and array.ndim == 1
    if shape is not None and len(shape) != dimensions and not is_of_objects:
        expected = "(b, n, 3)" if dimensions == 3 else "(b, n)"
        raise ValueError(f"{name}: expected an array of shape {expected}, or a sequence with one for each set, "
                         f"got {tuple(shape)}")
    try:
        parts = iter(array)
    except TypeError:
        kind = type(given).__name__
        raise TypeError(f"{name}: expected a sequence with one array for each set, got {kind}") from None
    return list(parts)
