# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""Arguments that are refused by name, and what is given back as they were given."""

from __future__ import annotations

import operator
import os
import sys
from typing import Any, Optional, SupportsIndex

import numpy as np


def whole_number(name: str, value: SupportsIndex, least: int, most: Optional[int], besides: str = "") -> int:
    """The number, if it is one from `least` to `most`."""
    which = f"from {least} on" if most is None else f"from {least} to {most}"
    expected = f"{name}: expected a whole number {which}{besides}, got {value!r}"
    if isinstance(value, bool):
        raise TypeError(expected)
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(expected) from None
    if number < least or (most is not None and number > most):
        raise ValueError(expected)
    return number


def number_of_threads(name: str, threads: Optional[SupportsIndex], most: Optional[int] = 64) -> int:
    """As many as there are processors, if it is None, but at most `most`; else a number up to that. By default that is
    what one insertion can use, and others need memory for each."""
    if threads is not None:
        return whole_number(name, threads, 1, most, ", or None for all")
    number = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return number if most is None else min(number, most)


OF_TORCH = {"torch.int32": np.int32, "torch.int": np.int32, "torch.int64": np.int64, "torch.long": np.int64}


def index_type(dtype: Any) -> Any:
    """The type of indices: int32 or int64, by NumPy's name for it or by PyTorch's."""
    try:
        kind = np.dtype(OF_TORCH.get(str(dtype), dtype))
    except Exception:  # NumPy reads texts in many ways
        kind = None
    if kind not in (np.dtype(np.int32), np.dtype(np.int64)):
        raise TypeError(f"dtype: expected int32 or int64, got {dtype!r}")
    return kind


def as_given(points: Any, array: Any) -> Any:
    """The array as a tensor on the points' device, if these are a tensor of PyTorch; else the array itself.
    PyTorch is not imported here, so it must have been."""
    torch = sys.modules.get("torch")
    if torch is None or not isinstance(points, torch.Tensor):
        return array
    return torch.from_numpy(array).to(points.device)
