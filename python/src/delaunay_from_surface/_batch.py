# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""Many sets of points at once."""

from __future__ import annotations

from typing import Any, Iterable, List, Optional, SupportsIndex

from . import _delaunay_from_surface as _core
from ._arguments import number_of_threads
from ._periodic import periods_of
from ._result import Delaunay3
from ._types import ArrayLike, Box, Points


def delaunay3_batch(points: Iterable[Points], weights: Optional[Iterable[Optional[ArrayLike]]] = None, *,
                    box: Optional[Box] = None, neighbors: bool = False, threads: Optional[SupportsIndex] = None
                    ) -> List[Delaunay3]:
    """Return the triangulations of many sets of points: for each what `delaunay3` would return.

    Each is made by one thread, so all arrays are the same at every call, whatever the number of threads.

    Parameters
    ----------
    points
        A sequence of sets as `delaunay3` takes them: arrays or tensors of shape (n, 3), of any lengths. Or one array or tensor
        of shape (b, n, 3) with b sets.
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
        As `delaunay3`, with the number of the set: of several the first. And ValueError if there are not as many weights as sets.

    Ctrl-C ends all threads.
    """
    from concurrent.futures import ThreadPoolExecutor  # slower to import than the whole module

    from . import delaunay3
    number = number_of_threads("threads", threads, most=None)
    sets = _sets_of("points", points, 3)
    of_sets: List[Any] = [None] * len(sets) if weights is None else _sets_of("weights", weights, 2)
    if len(of_sets) != len(sets):
        raise ValueError(f"weights: expected those of {len(sets)} sets, one array for each or None, got {len(of_sets)}")
    settings: Any = {"box": None if box is None else periods_of(box), "neighbors": neighbors}
    is_ended = False

    def triangulated(k: int) -> Delaunay3:
        try:
            return delaunay3(sets[k], weights=of_sets[k], progress=lambda _: not is_ended, **settings)
        except (ValueError, TypeError, OverflowError, MemoryError) as error:
            raise type(error)(f"set {k}: {error}") from error
    with ThreadPoolExecutor(number) as pool:
        futures = [pool.submit(triangulated, k) for k in range(len(sets))]
        try:
            return [future.result() for future in futures]
        except BaseException:
            is_ended = True
            for future in futures:
                future.cancel()
            raise


def _sets_of(name: str, given: Any, dimensions: int) -> List[Any]:
    """One for each set: of an array with so many dimensions its parts, which are not copied."""
    array = _core.read_alike(given, name)
    shape = getattr(array, "shape", None)
    if shape is not None and len(shape) != dimensions:
        expected = "(b, n, 3)" if dimensions == 3 else "(b, n)"
        raise ValueError(f"{name}: expected an array of shape {expected}, or a sequence with one for each set, got {tuple(shape)}")
    try:
        return list(array)
    except TypeError:
        raise TypeError(f"{name}: expected a sequence with one array for each set, got {type(given).__name__}") from None
