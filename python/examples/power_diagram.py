# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""The power diagram of balls: volumes of cells, and how they change with the weights.

The cells are those of balls in a box, whose walls are mirrors: each ball has an image beyond each of the six walls, so that
the cells of the balls themselves end at the walls. The derivatives of volumes by weights are a sparse symmetric matrix,
the Hessian of optimal transport between the box and the balls' centres.
"""

import numpy as np
import scipy.sparse

import delaunay_from_surface as dfs


def cells_in_box(centers, weights):
    """The volumes of the cells in the unit cube, and their derivatives by the weights."""
    n = len(centers)
    images = [centers]
    for axis in range(3):
        for wall in (0, 1):
            image = centers.copy()
            image[:, axis] = 2 * wall - image[:, axis]
            images.append(image)
    diagram = dfs.delaunay3(np.concatenate(images), weights=np.tile(weights, 7), threads=None)
    pairs, areas = diagram.power_facets
    inner = (pairs < n).all(axis=1) & (areas > 0)
    i, j = pairs[inner].T
    change = areas[inner] / (2 * np.linalg.norm(centers[i] - centers[j], axis=1))
    change = scipy.sparse.coo_matrix((change, (i, j)), (n, n)).tocsr()
    change = change + change.T
    return diagram.power_volumes[:n], scipy.sparse.diags(np.asarray(change.sum(axis=1)).ravel()) - change


if __name__ == "__main__":
    random = np.random.default_rng(2)
    centers, weights = random.random((2000, 3)), random.random(2000) * .004
    volumes, hessian = cells_in_box(centers, weights)
    print(f"{np.count_nonzero(volumes == 0)} of {len(volumes)} balls are hidden; the volumes add up to {volumes.sum():.12f}")
    step = 1e-9 * random.random(2000)
    expected, found = hessian @ step, cells_in_box(centers, weights + step)[0] - volumes
    print(f"largest error of the derivatives: {np.abs(found - expected).max() / np.abs(expected).max():.1e}")
