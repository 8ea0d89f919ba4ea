# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""The tetrahedra inside a mesh, in a file for ParaView.

    python inside.py [part.off [part.vtk]]

The mesh may have gaps: winding numbers decide. It is a text in the format OFF, of triangles; PyVista and meshio read
other formats. Without a file, it is the hull of points on an ellipsoid.
"""

import os
import sys

import numpy as np

import delaunay_from_surface as dfs


def read_off(name):
    """Points and triangles."""
    with open(name, encoding="utf-8", errors="replace") as file:
        words = " ".join(line.split("#")[0] for line in file).split()
    if words[:1] != ["OFF"]:
        sys.exit(f"{name}: expected an OFF file")
    points, faces = int(words[1]), int(words[2])
    corners = np.array(words[4 + 3 * points:4 + 3 * points + 4 * faces], int).reshape(-1, 4)
    if len(corners) < faces:
        sys.exit(f"{name}: ends before all faces are there")
    if (corners[:, 0] != 3).any():
        sys.exit(f"{name}: expected triangles alone")
    return np.array(words[4:4 + 3 * points], float).reshape(-1, 3), corners[:, 1:]


def write_vtk(name, points, tetrahedra):
    with open(name, "w", encoding="ascii") as file:
        file.write(f"# vtk DataFile Version 3.0\ntetrahedra\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {len(points)} double\n")
        np.savetxt(file, points, "%.17g")
        file.write(f"CELLS {len(tetrahedra)} {5 * len(tetrahedra)}\n")
        np.savetxt(file, np.insert(tetrahedra, 0, 4, axis=1), "%d")
        file.write(f"CELL_TYPES {len(tetrahedra)}\n" + "10\n" * len(tetrahedra))


if __name__ == "__main__":
    if len(sys.argv) > 1:
        points, faces = read_off(sys.argv[1])
    else:
        points = np.random.default_rng(1).normal(size=(5000, 3))
        points *= [3, 2, 1] / np.linalg.norm(points, axis=1, keepdims=True)
        faces = dfs.delaunay3(points).convex_hull
    if len(sys.argv) > 2 and os.path.exists(sys.argv[2]) and os.path.samefile(*sys.argv[1:3]):
        sys.exit(f"{sys.argv[2]} is the input: name another file")
    # [inside]
    triangulation = dfs.delaunay3(points, faces, inside=True, threads=None)
    tetrahedra = triangulation.simplices[triangulation.inside]
    volume = triangulation.volumes[triangulation.inside].sum()
    # [inside]
    a, b, c = points[faces].transpose(1, 0, 2)
    enclosed = abs(np.einsum("ij,ij->", a, np.cross(b, c))) / 6
    print(f"{len(tetrahedra)} of {triangulation.nsimplex} tetrahedra are inside; their volume is {volume:.6g}, "
          f"and that of the surface {enclosed:.6g}, if it is closed and consistently oriented")
    if len(sys.argv) > 2:
        write_vtk(sys.argv[2], points, tetrahedra)
