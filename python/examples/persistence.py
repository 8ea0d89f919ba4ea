# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""Persistent homology of points on two linked tori: two components, two loops on each, and the void within each.

This module makes the filtration, and GUDHI finds what persists in it.
"""

import numpy as np

import delaunay_from_surface as dfs


def linked_tori(n, seed=1):
    """Points of two tori, with radii 1 and 0.3, each of which passes through the hole of the other."""
    u, v = 2 * np.pi * np.random.default_rng(seed).random((2, 2, n))
    ring = np.stack([(1 + .3 * np.cos(v)) * np.cos(u), (1 + .3 * np.cos(v)) * np.sin(u), .3 * np.sin(v)], axis=-1)
    return np.concatenate([ring[0], ring[1][:, [0, 2, 1]] + [1, 0, 0]])


if __name__ == "__main__":
    filtration = dfs.filtration(linked_tori(3000), threads=None)
    tree = filtration.to_gudhi()
    tree.compute_persistence()
    for dimension, name in enumerate(("components", "loops", "voids")):
        born, dead = np.sqrt(tree.persistence_intervals_in_dimension(dimension)).T  # values are squared radii
        lasts = dead - born > .1
        print(f"{np.count_nonzero(lasts)} {name} last; they live from "
              + ", ".join(f"{b:.2f} to {d:.2f}" for b, d in zip(born[lasts], dead[lasts])))
