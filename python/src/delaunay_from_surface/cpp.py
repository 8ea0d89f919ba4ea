# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""`triangulate()` as the extension of Tetra-NeRF has it, for programs that were written for that.

Instead of `from tetranerf.utils.extension import cpp` write

    from delaunay_from_surface import cpp

and leave `cells = cpp.triangulate(points)` as it is. PyTorch is not needed, but is used if the points are its tensors.
"""

from __future__ import annotations

from typing import Any, Optional, SupportsIndex

import numpy as np

from . import delaunay3
from ._arguments import as_given, index_type

__all__ = ["triangulate"]


def triangulate(points: Any, threads: Optional[SupportsIndex] = 1, dtype: Any = "int32") -> Any:
    """Return the Delaunay tetrahedra of points as indices: (m, 4) int32, or int64 if `dtype` says so.

    A tensor of PyTorch of shape (n, 3), on any device, gives one on the same device. Anything else that a NumPy array
    can be made of, by DLPack too, gives an array. The tetrahedra are positively oriented; where points coincide, the
    one with the smallest index stands for all. If all points lie in a plane there are none. `threads` as in
    `delaunay3`, whose exceptions are raised: for NaN, too.
    """
    kind = index_type(dtype)
    result = delaunay3(points, threads=threads)
    cells = result.simplices if result.dimension == 3 else np.zeros((0, 4), dtype=np.int32)
    return as_given(points, cells.astype(kind, copy=False))
