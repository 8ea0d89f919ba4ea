# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""`TetGen` as PyVista's `tetgen` has it, as far as needed by programs that tetrahedralise points alone: TetWeave
(Binninger, Wiersma, Herholz, Sorkine-Hornung 2025) does so in every step of its optimisation.

Instead of `import tetgen` write

    from delaunay_from_surface import tetgen

and leave `_, tets = tetgen.TetGen(points, no_faces).tetrahedralize(switches="Q")` as it is.
"""

from __future__ import annotations

from typing import Any, Optional, SupportsIndex, Tuple

import numpy as np

from . import _delaunay_from_surface as _core
from . import delaunay3
from ._arguments import index_type
from ._types import Indices, Reals

__all__ = ["TetGen"]


class TetGen:
    """Points to be tetrahedralised: (n, 3), or a tensor on any device, which are copied. There are no faces, or none in
    their array."""

    node: Optional[Reals] = None
    """(n, 3) float64: the points, once they are tetrahedralised."""

    elem: Optional[Indices] = None
    """(m, 4): the tetrahedra, once they are there."""

    def __init__(self, points: Any, faces: Any = None) -> None:
        self._points = np.array(_core.array_of_points(points, "points"), subok=False)
        if faces is not None:
            _refuse(_core.read_alike(faces, "faces"))

    def tetrahedralize(self, switches: str = "Q", *, threads: Optional[SupportsIndex] = 1, dtype: Any = "int32"
                       ) -> Tuple[Reals, Indices]:
        """Return the points, (n, 3) float64, and their Delaunay tetrahedra, (m, 4) int32 or int64.

        In general position they are TetGen's, in another order and with positive orientation, which needs no turning
        round: det(b - a, c - a, d - a) > 0. Of equal points the one with the smallest index stands for all, so none has
        to be moved; cospherical ones are decided exactly, as CGAL does. If all points lie in a plane there are no
        tetrahedra. `threads` as in `delaunay3`.

        Raises ValueError for switches other than Q, V and z, which change nothing: all others are about surfaces,
        weights or further output; and what `delaunay3` raises.
        """
        if not isinstance(switches, str):
            raise TypeError(f"switches: expected a text such as 'Q', got {switches!r}")
        if set(switches) - set("QVz"):
            raise ValueError("switches: expected 'Q', for the Delaunay tetrahedra of points alone, got "
                             f"{switches!r}: others need TetGen")
        kind = index_type(dtype)
        result = delaunay3(self._points, threads=threads)
        cells = result.simplices if result.dimension == 3 else np.zeros((0, 4), dtype=np.int32)
        self.node, self.elem = self._points.astype(np.float64), cells.astype(kind, copy=False)
        return self.node, self.elem


def _refuse(faces: Any) -> None:
    """Refuses faces, unless there are none."""
    shape = getattr(faces, "shape", None)
    try:
        has_none = len(faces) == 0 if shape is None else 0 in shape
    except TypeError:
        raise TypeError("faces: expected None, or an array or sequence with no faces, got "
                        f"{type(faces).__name__}") from None
    if not has_none:
        what = f"{len(faces)} of them" if shape is None else f"an array of shape {tuple(shape)}"
        raise ValueError(f"faces: only points alone are tetrahedralised here, got {what}: leave them out, or take TetGen "
                         "itself")
