# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""Points that move in every step of an optimisation, and what that changes in their triangulation.

Each point within the hull goes some way towards the mean of its neighbours, which smooths the mesh. Where points are a
tensor of PyTorch, its optimiser would move them instead. Every step is triangulated in the order of the last one.
"""

import numpy as np

import delaunay_from_surface as dfs


def towards_neighbors(points, edges):
    """From each point to the mean of those that share an edge with it."""
    sums, counts = np.zeros_like(points), np.zeros(len(points))
    for a, b in (edges.T, edges.T[::-1]):
        np.add.at(sums, a, points[b])
        np.add.at(counts, a, 1)
    return sums / counts[:, None] - points


if __name__ == "__main__":
    points = np.random.default_rng(1).random((3000, 3))
    moving = dfs.Moving(points, threads=None)
    inner = np.setdiff1d(np.arange(len(points)), moving.triangulation.convex_hull)
    for step in range(20):
        points[inner] += .02 * towards_neighbors(points, moving.edges)[inner]
        triangulation = moving.update(points)  # the copy is another: points may be changed in place
        changes = moving.changes
        print(f"step {step}: {changes.moved} points moved by up to {changes.distance:.4f}; "
              f"{len(changes.simplices_new)} of {triangulation.nsimplex} tetrahedra are new, "
              f"{len(changes.edges_new)} of {len(moving.edges)} edges")
    anew = dfs.delaunay3(points)
    if {frozenset(cell) for cell in anew.simplices.tolist()} == {frozenset(cell) for cell in moving.simplices.tolist()}:
        print("every step is what is made anew, in another order")
