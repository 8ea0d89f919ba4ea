# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""What goes in and out, for type checkers: at run time the names stand for less, and cost no import."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable, Iterable, Optional, SupportsIndex, Tuple, Union

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import ArrayLike as ArrayLike, NDArray
    Points = Union[ArrayLike, Iterable[Any]]
    """Numbers of shape (n, 3)."""
    Faces = Union[NDArray[np.integer[Any]], Iterable[Iterable[SupportsIndex]]]
    """Indices of points, of shape (m, k), or sequences of any lengths."""
    Box = Union[Iterable[Optional[float]], NDArray[np.floating[Any]], NDArray[np.integer[Any]]]
    """Three periods, None or infinite along axes that have none."""
    Progress = Union[Callable[[float], object], bool, np.bool_, None]
    """What is called with the share that is done; True for a bar."""
    Coordinates = Union[NDArray[np.float64], NDArray[np.float32]]
    Indices = NDArray[np.int32]
    Offsets = NDArray[np.int16]
    Places = NDArray[np.int64]
    Reals = NDArray[np.float64]
    Truths = NDArray[np.bool_]
    Values = NDArray[Any]
    Radius = Union[float, np.floating[Any], np.integer[Any]]
else:
    ArrayLike = Box = Points = Faces = Progress = Any
    Coordinates = Indices = Offsets = Places = Reals = Truths = Values = np.ndarray
    Radius = float

Lists = Tuple[Places, Indices]
Spheres = Tuple[Reals, Reals]
InBox = Optional[Tuple[Reals, Offsets]]
