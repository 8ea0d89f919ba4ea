# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""The alpha shape of a cloud, and the weighted one of a molecule.

    python molecule.py [balls.txt | cloud.xyz [shape.off [RADIUS ...]]]

The file has x, y, z and a radius in each line, or no radius: then there are no balls. Without it, they are those of a chain in a box. With alpha 0 the weighted
alpha complex is dual to the union of the balls: a ball, pair or triple is in it if it has a common place that is in no other
power cell. So the complex says which balls meet, and which are buried: all tetrahedra around these are in it.
The boundary of this complex is written to shape.off, or, of a cloud, that of the alpha shape of the last RADIUS.
"""

import os
import sys

import numpy as np

import delaunay_from_surface as dfs


def chain(n, random):
    """A random walk in a box, of steps as long as bonds, with radii of atoms, each enlarged by that of water (Å)."""
    half, steps = 1.2 * np.cbrt(n), random.normal(size=(8 * n, 3))
    centers = [np.zeros(3)]
    for step in 1.5 * steps / np.linalg.norm(steps, axis=1, keepdims=True):
        if (abs(centers[-1] + step) < half).all() and len(centers) < n:
            centers.append(centers[-1] + step)
    return np.array(centers), np.resize([1.7, 1.55, 1.52], len(centers)) + 1.4


def boundary(triangulation, complex_):
    """The triangles of the complex that have at most one of its tetrahedra."""
    cells = np.sort(triangulation.simplices[complex_.simplices], axis=1)
    facets = cells[:, [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]].reshape(-1, 3)
    both, counts = np.unique(np.concatenate([facets, complex_.triangles]), axis=0, return_counts=True)
    return both[counts < 3]


def write_off(name, points, triangles):
    with open(name, "w", encoding="ascii") as file:
        file.write(f"OFF\n{len(points)} {len(triangles)} 0\n")
        np.savetxt(file, points, "%.17g")
        np.savetxt(file, np.insert(triangles, 0, 3, axis=1), "%d")


if __name__ == "__main__":
    centers, radii = chain(5000, np.random.default_rng(1))
    if len(sys.argv) > 1:
        try:
            numbers = np.loadtxt(sys.argv[1], ndmin=2)
        except ValueError as error:
            sys.exit(f"{sys.argv[1]}: expected x, y, z, and a radius or none, in each line: {error}")
        if numbers.shape[1] not in (3, 4) or not np.isfinite(numbers).all():
            sys.exit(f"{sys.argv[1]}: expected x, y, z, and a radius or none, in each line")
        if (numbers[:, 3:] < 0).any():
            sys.exit(f"{sys.argv[1]}: a radius is negative")
        centers, radii = numbers[:, :3], numbers[:, 3:].ravel()
    if len(sys.argv) > 2 and os.path.exists(sys.argv[2]) and os.path.samefile(*sys.argv[1:3]):
        sys.exit(f"{sys.argv[2]} is the input: name another file")

    alphas = [float(word) for word in sys.argv[3:]] or [1.5, 2, 3]
    if sys.argv[3:] and len(radii) == len(centers):
        print("The fourth numbers are radii, so the boundary written is that of the balls; leave them out for an alpha shape")
    # [cloud]
    cloud = dfs.delaunay3(centers, threads=None)
    for radius in alphas:
        shape = cloud.alpha_complex(radius)
        skin = boundary(cloud, shape)
        print(f"alpha {radius}: {len(shape.simplices)} tetrahedra, {len(skin)} triangles on the boundary")
    # [cloud]

    if len(radii) != len(centers):
        print("There are no radii, so there are no balls")
        if len(sys.argv) > 2:
            write_off(sys.argv[2], centers, skin)
        sys.exit()

    # [balls]
    balls = dfs.delaunay3(centers, weights=radii ** 2, threads=None)
    dual = balls.alpha_complex(0)
    around = np.bincount(balls.simplices.ravel(), minlength=len(centers))
    filled = np.bincount(balls.simplices[dual.simplices].ravel(), minlength=len(centers))
    buried = np.setdiff1d(np.flatnonzero((around > 0) & (around == filled)), balls.convex_hull)
    # [balls]
    if len(sys.argv) > 2:
        write_off(sys.argv[2], centers, boundary(balls, dual))
    print(f"{len(centers)} balls: {len(dual.vertices) - len(buried)} at the surface, {len(buried)} inside, "
          f"{len(centers) - len(dual.vertices)} covered by others; {len(dual.edges)} pairs and {len(dual.triangles)} triples meet")
