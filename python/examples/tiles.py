# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""More points than fit into memory: the triangulation tile by tile, on one machine or by Dask.

    python tiles.py [cloud.npy folder [memory [address of a Dask scheduler]]]

The file has an array of shape (n, 3). Of each tile the volume of its tetrahedra is added, and their sum is that of the convex hull.
Without a file, there are 200,000 points in a cube, in a folder that is removed. Memory is such as 4G, the default. A scheduler's workers must see the folder,
too; "local" starts them here.
"""

import sys
import tempfile

import numpy as np

import delaunay_from_surface as dfs


def volume(points, cells):
    a, b, c, d = np.asarray(points, float)[cells].transpose(1, 0, 2)
    return np.einsum("ij,ij->i", b - a, np.cross(c - a, d - a)).sum() / 6


def main(cloud, folder, memory="4G"):
    # [tiles]
    number, total = 0, 0.
    tiles = dfs.delaunay3_tiles(cloud, folder, memory=memory, threads=None)
    for points, cells in tiles:
        number += len(cells)
        total += volume(points, cells)
    # [tiles]
    print(f"{number} tetrahedra of volume {total:.6f} in {len(tiles)} tiles in {folder}")


def main_by_dask(cloud, folder, memory, address):
    # [dask]
    import distributed
    client = distributed.Client() if address == "local" else distributed.Client(address)
    tiles = dfs.delaunay3_dask(cloud, client, folder, memory=memory)  # for each tile
    print(f"{len(tiles.cells())} tetrahedra in {len(tiles)} tiles in {folder}")
    # [dask]


if __name__ == "__main__":
    if len(sys.argv) == 5:
        main_by_dask(*sys.argv[1:])
    elif len(sys.argv) in (3, 4):
        main(*sys.argv[1:])
    elif len(sys.argv) > 1:
        sys.exit(__doc__)
    else:
        with tempfile.TemporaryDirectory() as folder:
            np.save(f"{folder}/cloud.npy", np.random.default_rng(1).random((200000, 3)))
            main(f"{folder}/cloud.npy", f"{folder}/tiles", "64M")
