# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""Numbers that are given by name, and refused by name."""

from __future__ import annotations

import operator
import os
from typing import Optional, SupportsIndex


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
