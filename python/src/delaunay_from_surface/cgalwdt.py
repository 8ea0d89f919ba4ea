# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""`CGALWDTStruct` as DMesh (Son, Gadelha, Zhou, Xu, Lin, Zhou 2024) has it: its weighted Delaunay triangulation.

In DMesh's `diffdt/__init__.py` write, instead of `from diffdt.cgalwdt import CGALWDTStruct`,

    from delaunay_from_surface.cgalwdt import CGALWDTStruct

and leave `DiffDT.CGAL_WDT(points, weighted, parallelize)` as it is.
"""

from __future__ import annotations

import time
from typing import Any

import numpy as np

from . import _delaunay_from_surface as _core
from . import delaunay3
from ._arguments import as_given, index_type

__all__ = ["CGALWDTStruct"]


class CGALWDTStruct:
    """A weighted Delaunay triangulation, as `forward` makes it."""

    def __init__(self) -> None:
        self.points: Any = None
        """The weighted points that were given."""
        self.tets_point_id: Any = None
        """(m, 4) int32: indices of points, on their device."""
        self.tets_cc: Any = None
        """(m, 3) float32: the tetrahedra's power centres, on the same device; (0,) if they have not been asked for."""
        self.time_sec: float = -1.
        """How many seconds the triangulation took."""

    @staticmethod
    def forward(points: Any, weighted: bool = True, parallelize: bool = False, p_lock_grid_size: int = 50,
                compute_cc: bool = False, *, dtype: Any = "int32") -> CGALWDTStruct:
        """Return the triangulation of weighted points, as CGAL's `Regular_triangulation_3` has it, including its decisions
        where points are not in general position.

        Parameters
        ----------
        points
            An object with `positions` (n, 3) and `weights` (n,) or (n, 1): tensors on any device, or arrays; then the
            result has arrays.
        weighted, p_lock_grid_size
            Not used: the original's weights always count, too, and there is no grid of locks.
        parallelize
            Whether all processors work, else one thread.
        compute_cc
            Whether the power centres are wanted.
        dtype
            The type of the indices: int32 or int64.

        Raises
        ------
        ValueError, TypeError
            As `delaunay3`: for NaN, too. If all points lie in a plane there are no tetrahedra.
        """
        kind = index_type(dtype)
        weights = _core.read_alike(points.weights, "weights")
        if getattr(weights, "shape", ())[1:] == (1,):
            weights = weights[:, 0]
        begin = time.perf_counter()
        made = delaunay3(points.positions, weights=_core.array_of_weights(weights, None),
                         threads=None if parallelize else 1)
        result = CGALWDTStruct()
        result.time_sec = time.perf_counter() - begin
        has_tetrahedra = made.dimension == 3
        cells = made.simplices if has_tetrahedra else np.zeros((0, 4), dtype=np.int32)
        centers = np.zeros(0) if not compute_cc else made.power_centers if has_tetrahedra else np.zeros((0, 3))
        result.points = points
        result.tets_point_id = as_given(points.positions, cells.astype(kind, copy=False))
        with np.errstate(all="ignore"):  # far ones are infinite
            result.tets_cc = as_given(points.positions, centers.astype(np.float32))
        return result
