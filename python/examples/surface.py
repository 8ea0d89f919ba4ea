# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""A closed surface from points on it: the facets between tetrahedra inside and outside.

    python surface.py [cloud.xyz [surface.off]]

The spheres of two neighbours intersect deeply if both are inside or both outside, and shallowly if the surface passes between them.
A minimum spanning tree joins all cells by the clearest of these relations, and labels go along it, from beyond the
hull. Power crusts are labelled in a similar way (Amenta, Choi, Kolluri 2001). Without a file, the points are on a torus.
Needs SciPy.
"""

import os
import sys

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import breadth_first_order, minimum_spanning_tree

import delaunay_from_surface as dfs

FACETS = np.array([[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]])  # opposite to each corner, seen from outside


def relations(t):
    """Pairs of cells, and the cosines of the angles between their spheres. Cells from t.nsimplex on are half-spaces: each
    is beyond a facet of the hull, and is joined to the next one."""
    cell, corner = np.nonzero(t.neighbors > np.arange(t.nsimplex)[:, None])
    other = t.neighbors[cell, corner]
    radii, squares = t.circumradii, ((t.circumcenters[cell] - t.circumcenters[other]) ** 2).sum(axis=1)
    inner = (radii[cell] ** 2 + radii[other] ** 2 - squares) / (2 * radii[cell] * radii[other])
    last, corner = np.nonzero(t.neighbors < 0)
    a, b, c = t.points[t.simplices[last[:, None], FACETS[corner]]].transpose(1, 0, 2)
    normals = np.cross(b - a, c - a)
    depths = np.einsum("ij,ij->i", t.circumcenters[last] - a, normals) / np.linalg.norm(normals, axis=1)
    beyond = t.nsimplex + np.arange(len(last))
    cosines = np.concatenate([inner, depths / radii[last], np.ones(len(last) - 1)])
    return np.concatenate([cell, last, beyond[1:]]), np.concatenate([other, beyond, beyond[:-1]]), np.nan_to_num(cosines)


# [surface]
def surface(points):
    t = dfs.delaunay3(points, neighbors=True, threads=None)
    cells, others, cosines = relations(t)
    size = cells.max() + 1
    costs = coo_matrix((1 + 1e-9 - np.minimum(abs(cosines), 1), (cells, others)), (size, size))
    signs = coo_matrix((np.where(cosines < 0, -1, 1), (cells, others)), (size, size)).tocsr()
    order, before = breadth_first_order(minimum_spanning_tree(costs), size - 1, directed=False)
    pairs = order[1:], before[order[1:]]
    outside = np.ones(size, dtype=int)
    for i, j, sign in zip(*pairs, np.asarray((signs + signs.T)[pairs]).ravel()):
        outside[i] = sign * outside[j]
    # The last one is outside, and a neighbour -1 is the last one.
    inner, corner = np.nonzero((outside[:t.nsimplex, None] < 0) & (outside[t.neighbors] > 0))
    return t.simplices[inner[:, None], FACETS[corner]]
# [surface]


if __name__ == "__main__":
    u, v = 2 * np.pi * np.random.default_rng(1).random((2, 5000))
    torus = np.stack([(2 + np.cos(v)) * np.cos(u), (2 + np.cos(v)) * np.sin(u), np.sin(v)], axis=1)
    try:
        points = np.loadtxt(sys.argv[1], usecols=(0, 1, 2), ndmin=2) if len(sys.argv) > 1 else torus
    except ValueError as error:
        sys.exit(f"{sys.argv[1]}: expected x, y, z in each line: {error}")
    if len(sys.argv) > 2 and os.path.exists(sys.argv[2]) and os.path.samefile(*sys.argv[1:3]):
        sys.exit(f"{sys.argv[2]} is the input: name another file")
    try:
        triangles = surface(points)
    except ValueError as error:  # for example, all points lie in a plane
        sys.exit(f"{sys.argv[1]}: {error}")
    a, b, c = points[triangles].transpose(1, 0, 2)
    print(f"{len(points)} points, {len(np.unique(triangles))} of them in {len(triangles)} triangles; "
          f"the volume within is {np.einsum('ij,ij->', a, np.cross(b, c)) / 6:.6g}")
    if len(sys.argv) > 2:
        with open(sys.argv[2], "w", encoding="ascii") as file:
            file.write(f"OFF\n{len(points)} {len(triangles)} 0\n")
            np.savetxt(file, points, "%.17g")
            np.savetxt(file, np.insert(triangles, 0, 3, axis=1), "%d")
