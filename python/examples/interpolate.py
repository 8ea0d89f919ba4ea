# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""Interpolation between scattered points: linear in tetrahedra, and between natural neighbours.

    python interpolate.py [picture.png | values.txt queries.txt]

With a picture, which needs Matplotlib, a slice of the linear interpolant is drawn beside the function itself. With files of x, y, z
and a value, and of x, y, z, the values at the queries are printed: linear, and between natural neighbours.
"""

import sys

import numpy as np

import delaunay_from_surface as dfs


def function(x):
    return np.sin(6 * x[..., 0]) * np.cos(5 * x[..., 1]) + x[..., 2]


def print_values(values, queries):
    tables = []
    for name, columns in (values, 4), (queries, 3):
        try:
            table = np.loadtxt(name, ndmin=2)
        except ValueError as error:
            sys.exit(f"{name}: {error}")
        if table.shape[1] != columns:
            sys.exit(f"{name}: expected {columns} numbers in each line")
        tables.append(table)
    known, xi = tables
    triangulation = dfs.delaunay3(known[:, :3])
    found = [interpolator(triangulation, known[:, 3])(xi)
             for interpolator in (dfs.LinearInterpolator, dfs.NaturalNeighborInterpolator)]
    np.savetxt(sys.stdout, np.column_stack([xi, *found]), "%.17g")


def main():
    if len(sys.argv) > 1 and not sys.argv[1].endswith((".png", ".svg", ".pdf")):
        sys.exit(f"{sys.argv[1]}: expected the name of a picture, such as picture.png, or a second file, of queries")
    points = np.random.default_rng(0).random((2000, 3))
    u, v = np.meshgrid(np.linspace(0, 1, 400), np.linspace(0, 1, 400))
    xi = np.stack([u, v, np.full_like(u, .5)], axis=-1)
    # [interpolate]
    triangulation = dfs.delaunay3(points)
    found = dfs.LinearInterpolator(triangulation, function(points))(xi)
    smooth = dfs.NaturalNeighborInterpolator(triangulation, function(points))(xi[::10, ::10])
    # [interpolate]
    print(f"mean error inside the hull: {np.nanmean(abs(found - function(xi))):.4f}; "
          f"{np.isnan(found).sum()} of {found.size} points are outside")
    few = xi[::10, ::10]
    print(f"at {smooth.size} of them: {np.nanmean(abs(found[::10, ::10] - function(few))):.4f}, "
          f"and {np.nanmean(abs(smooth - function(few))):.4f} between natural neighbours")
    everywhere = dfs.LinearInterpolator(triangulation, function(points), outside="nearest")(xi)
    print(f"with the nearest vertex outside, everywhere: {abs(everywhere - function(xi)).mean():.4f}")
    if len(sys.argv) > 1:
        import matplotlib
        matplotlib.use("Agg")
        import matplotlib.pyplot as plt
        figure, axes = plt.subplots(1, 2, figsize=(9, 4), layout="constrained")
        for axis, values, title in zip(axes, (function(xi), found), ("function", "interpolated")):
            shown = axis.imshow(values, origin="lower", extent=(0, 1, 0, 1), vmin=-.6, vmax=1.6)
            axis.set_title(title)
        figure.colorbar(shown, ax=axes)
        figure.savefig(sys.argv[1])


if __name__ == "__main__":
    if len(sys.argv) > 2:
        print_values(*sys.argv[1:3])
    else:
        main()
