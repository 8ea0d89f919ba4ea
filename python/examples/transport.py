# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""Cells of prescribed volumes in a periodic box: semi-discrete optimal transport.

For any points and volumes that add up to that of the box there are weights, unique up to a constant, for which the power cells
have these volumes; and of all maps that send so much of the box to each point, that which sends each cell to its own moves the
box by the least mean square. Newton's method finds the weights, if steps are halved until no cell has become too small: then it
converges globally, and in the end quadratically (Kitagawa, Mérigot, Thibert 2019). The derivatives are areas of facets.
"""

import numpy as np
import scipy.sparse
import scipy.sparse.linalg

import delaunay_from_surface as dfs


def derivatives(points, diagram):
    """Those of the volumes by the weights: a sparse symmetric matrix, whose rows add up to 0."""
    n = len(points)
    pairs, areas, offsets = diagram.power_facets
    between = pairs[:, 0] != pairs[:, 1]  # a facet between copies of one point does not move with its weight
    i, j = pairs[between].T
    lengths = np.linalg.norm(points[j] + offsets[between] * diagram.box - points[i], axis=1)
    change = scipy.sparse.coo_matrix((areas[between] / (2 * lengths), (i, j)), (n, n)).tocsr()  # sums over copies
    change = change + change.T
    return scipy.sparse.diags(np.asarray(change.sum(axis=1)).ravel()) - change


def step_of(matrix, missing):
    """The weights are known up to a constant, so the first one is kept."""
    step = np.zeros(len(missing))
    inner = matrix[1:, 1:].tocsr()
    conditioner = scipy.sparse.diags(1 / inner.diagonal())
    step[1:], failure = scipy.sparse.linalg.cg(inner, missing[1:], atol=0, M=conditioner)  # to a share of 1e-5
    if failure:
        raise RuntimeError("the linear system was not solved")
    return step


def weights_for(points, box, volumes, tolerance=1e-10):
    """The weights for which the power cells have these volumes, up to a share of them; and the number of Newton steps."""
    weights = np.zeros(len(points))
    diagram = dfs.delaunay3(points, weights=weights, box=box, threads=None)
    least = min(diagram.power_volumes.min(), volumes.min()) / 2
    steps = 0
    while True:
        missing = volumes - diagram.power_volumes
        error = np.abs(missing / volumes).max()
        print(f"after {steps} steps: largest error {error:.1e}")
        if error < tolerance:
            return weights, steps
        step = step_of(derivatives(points, diagram), missing)
        share = 1.
        while True:
            moved = weights + share * step
            diagram = dfs.delaunay3(points, weights=moved, box=box, threads=None)
            left = np.linalg.norm(volumes - diagram.power_volumes)
            if diagram.power_volumes.min() >= least and left <= (1 - share / 2) * np.linalg.norm(missing):
                break
            share /= 2
        weights = moved
        steps += 1


if __name__ == "__main__":
    random = np.random.default_rng(1)
    box = np.array([1., 1, 2])
    points = random.random((2000, 3)) * box
    volumes = 1 + random.random(2000)
    volumes *= box.prod() / volumes.sum()
    weights, steps = weights_for(points, box, volumes)
    print(f"{len(points)} cells have the volumes that were asked for, to 1e-10, after {steps} steps")
