# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""What programs that use PyTorch want of a result. PyTorch is not imported here, and used if it has been."""

from __future__ import annotations

import sys
from typing import Any

import numpy as np


def index_type(dtype: Any) -> Any:
    """The type of indices: int32 or int64, by NumPy's name for it or by PyTorch's."""
    name = str(dtype)
    try:
        kind = np.dtype(name[6:] if name.startswith("torch.") else dtype)
    except TypeError:
        kind = None
    if kind not in (np.dtype(np.int32), np.dtype(np.int64)):
        raise TypeError(f"dtype: expected int32 or int64, got {dtype!r}")
    return kind


def as_given(points: Any, array: Any) -> Any:
    """The array as a tensor on the points' device, if these are a tensor of PyTorch; else the array itself."""
    torch = sys.modules.get("torch")
    if torch is None or not isinstance(points, torch.Tensor):
        return array
    return torch.from_numpy(array).to(points.device)
