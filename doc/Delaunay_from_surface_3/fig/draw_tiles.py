#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Draws tiles.svg: two tiles of a triangulation in the plane, with what each keeps of the other. Needs SciPy."""

from pathlib import Path

import numpy as np
from scipy.spatial import Delaunay

WIDTH, HEIGHT, CUT = 410, 270, .5
STYLE = (".owned{fill:#dbe9f6;stroke:#6d8fb0;stroke-width:1;stroke-linejoin:round}"
         ".star{fill:#f7f7f7;stroke:#9aa7b5;stroke-width:1;stroke-linejoin:round}.own{fill:#1d3557}"
         ".kept{fill:#fff;stroke:#c1272d;stroke-width:1.8}.refused{fill:#bbb}"
         ".cut{fill:none;stroke:#222;stroke-width:1.2;stroke-dasharray:6 4}text{font:14px sans-serif;fill:#222}")


def panel(points, is_own, left):
    """One tile: its own points, those of the other that it keeps, and the others."""
    triangles = Delaunay(points).simplices
    at = np.column_stack([left + 20 + points[:, 0] * (WIDTH - 40), 40 + (1 - points[:, 1]) * (HEIGHT - 60)])
    lines, kept = [], set()
    for t in sorted(triangles.tolist(), key=lambda t: bool(is_own[min(t)])):
        if is_own[t].any():
            kept.update(t)
            corners = "L".join(f"{x:.1f} {y:.1f}" for x, y in at[t])
            lines.append(f'<path class="{"owned" if is_own[min(t)] else "star"}" d="M{corners}z"/>')
    x = left + 20 + CUT * (WIDTH - 40)
    lines.append(f'<path class="cut" d="M{x} 34V{HEIGHT - 12}"/>')
    for i, (x, y) in enumerate(at):
        kind, radius = ("own", 4) if is_own[i] else ("kept", 4) if i in kept else ("refused", 2.5)
        lines.append(f'<circle class="{kind}" cx="{x:.1f}" cy="{y:.1f}" r="{radius}"/>')
    return lines


def main():
    points = np.random.default_rng(5).random((44, 2))
    is_left = points[:, 0] < CUT
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {2 * WIDTH} {HEIGHT}" width="{2 * WIDTH}" '
             f'height="{HEIGHT}">', f"<style>{STYLE}</style>", f'<rect width="{2 * WIDTH}" height="{HEIGHT}" fill="#fff"/>']
    for is_own, left, name in ((is_left, 0, "tile 0 keeps"), (~is_left, WIDTH, "tile 1 keeps")):
        lines += panel(points, is_own, left)
        lines.append(f'<text x="{left + 20}" y="22">{name}</text>')
    Path(__file__).with_name("tiles.svg").write_text("\n".join([*lines, "</svg>", ""]), encoding="utf-8")


if __name__ == "__main__":
    main()
