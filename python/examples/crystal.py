# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""A crystal of copper with a vacancy: volumes and coordination numbers of its atoms, and two of their cells.

    python crystal.py [picture.png]
    python crystal.py atoms.txt 36.15 36.15 36.15 cells.txt

Each atom is displaced a little, as by heat, and one is missing. The cells of its twelve neighbours have become
larger, and miss a facet. Where atoms are displaced, facets appear at the corners of cells: only those with 3/10 of
the largest solid angle count. The picture, which needs Matplotlib, is of a neighbour's cell and of another one.
The second form reads x, y, z from each line, takes the three lengths of the box, and writes volume and coordination number
of each atom.
"""

import itertools
import os
import sys

import numpy as np

import delaunay_from_surface as dfs

EDGE = 3.615  # of the cube with four atoms, in ångström


def copper(n, heat, random):
    """n * n * n cubes, and the box."""
    cubes = np.array(list(itertools.product(range(n), repeat=3)))
    atoms = cubes[:, None] + [[0, 0, 0], [0, .5, .5], [.5, 0, .5], [.5, .5, 0]]
    return EDGE * atoms.reshape(-1, 3) + heat * random.normal(size=(4 * n ** 3, 3)), np.full(3, n * EDGE)


def draw(cells, titles, file):
    try:
        import matplotlib
    except ImportError:
        print("Matplotlib was not found: there is no picture")
        return
    matplotlib.use("Agg")
    from matplotlib import pyplot
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection
    figure = pyplot.figure(figsize=(4 * len(cells), 4))
    for k, (cell, title) in enumerate(zip(cells, titles)):
        axes = figure.add_subplot(1, len(cells), k + 1, projection="3d")
        faces = [cell.vertices[face] for face in cell.faces]
        axes.add_collection3d(Poly3DCollection(faces, facecolor="tab:orange", edgecolor="black", alpha=.6))
        center, radius = cell.vertices.mean(axis=0), np.ptp(cell.vertices, axis=0).max() / 2
        axes.set(xlim=center[0] + np.array([-radius, radius]), ylim=center[1] + np.array([-radius, radius]),
                 zlim=center[2] + np.array([-radius, radius]), title=title)
        axes.set_axis_off()
    figure.savefig(file, dpi=100)
    print(f"{file} was written")


def cells_of(atoms, box):
    # [cells]
    diagram = dfs.delaunay3(atoms, box=box, threads=None)
    volumes, coordination = diagram.voronoi_volumes, diagram.coordination(min_solid_angle=.3)
    # [cells]
    return diagram, volumes, coordination


def write_cells(name, box, output):
    if os.path.exists(output) and os.path.samefile(name, output):
        sys.exit(f"{output} is the input: name another file")
    try:
        atoms = np.loadtxt(name, usecols=(0, 1, 2), ndmin=2)
        _, volumes, coordination = cells_of(atoms, np.array(box, float))
    except (OSError, ValueError) as error:
        sys.exit(f"{name}, box {' '.join(box)}: {error}")
    np.savetxt(output, np.column_stack([volumes, coordination]), "%.17g %d")
    print(f"{len(atoms)} cells with volumes from {volumes.min():.6g} to {volumes.max():.6g} were written to {output}")


if __name__ == "__main__":
    if len(sys.argv) == 6:
        sys.exit(write_cells(sys.argv[1], sys.argv[2:5], sys.argv[5]))
    if len(sys.argv) > 2:
        sys.exit(__doc__)
    atoms, box = copper(8, .05, np.random.default_rng(1))
    vacancy, atoms = atoms[1000], np.delete(atoms, 1000, axis=0)
    diagram, volumes, coordination = cells_of(atoms, box)
    difference = atoms - vacancy
    distances = np.linalg.norm(difference - box * np.rint(difference / box), axis=1)
    is_near = np.isin(np.arange(len(atoms)), np.argsort(distances)[:12])
    print(f"{len(atoms)} atoms in {volumes.sum():.6f} of {box.prod():.6f} cubic ångström")
    for name, which in (("neighbours of the vacancy", is_near), ("all other atoms", ~is_near)):
        numbers, counts = np.unique(coordination[which], return_counts=True)
        print(f"{name}: {volumes[which].mean():.2f} cubic ångström each; coordination numbers "
              + ", ".join(f"{number} for {count} of them" for number, count in zip(numbers, counts)))
    chosen = [np.flatnonzero(is_near)[0], np.flatnonzero(~is_near)[0]]
    if len(sys.argv) > 1:
        draw([diagram.voronoi_cell(i) for i in chosen], ["beside the vacancy", "elsewhere"], sys.argv[1])
