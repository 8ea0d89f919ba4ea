# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""The tetrahedra inside a mesh, in a file for ParaView.

    python inside.py [part.off [part.vtk]]

The mesh may have gaps: winding numbers decide. It is a text in the format OFF, of triangles, perhaps with normals and
colours; PyVista and meshio read other formats. Without a file, it is the hull of points on an ellipsoid.
"""

import os
import re
import sys

import numpy as np

import delaunay_from_surface as dfs


def read_off(name):
    """Points and triangles; normals and colours, which may follow in each line, are passed over."""
    with open(name, encoding="utf-8", errors="replace") as file:
        lines = list(filter(None, (line.split("#")[0].split() for line in file)))
    if not lines or not re.fullmatch("(ST)?C?N?OFF", lines[0].pop(0)) or lines[0] == ["BINARY"]:
        sys.exit(f"{name}: expected a text in the format OFF")
    try:
        (points, faces, *_), *lines = filter(None, lines)  # these numbers may stand in the first line
        points, faces = int(points), int(faces)
        if len(lines) < points + faces:
            sys.exit(f"{name}: expected {points} points and {faces} faces, each in a line of its own")
        corners = lines[points:points + faces]
        if any(len(line) < 3 for line in lines[:points]):
            sys.exit(f"{name}: expected three numbers of each point")
        if any(face[0] != "3" for face in corners):
            sys.exit(f"{name}: expected triangles alone")
        return (np.array([line[:3] for line in lines[:points]], float).reshape(-1, 3),
                np.array([face[1:4] for face in corners], int).reshape(-1, 3))
    except ValueError as error:
        sys.exit(f"{name}: not as in the format OFF: {error}")


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
    try:
        # [inside]
        triangulation = dfs.delaunay3(points, faces, inside=True, threads=None)
        tetrahedra = triangulation.simplices[triangulation.inside]
        volume = triangulation.volumes[triangulation.inside].sum()
        # [inside]
    except ValueError as error:  # for example, an open patch has no inside
        sys.exit(f"{sys.argv[1]}: {error}")
    a, b, c = points[faces].transpose(1, 0, 2)
    enclosed = abs(np.einsum("ij,ij->", a, np.cross(b, c))) / 6
    print(f"{len(tetrahedra)} of {triangulation.nsimplex} tetrahedra are inside; their volume is {volume:.6g}, "
          f"and that of the surface {enclosed:.6g}, if it is closed, in one piece and consistently oriented")
    if len(sys.argv) > 2:
        write_vtk(sys.argv[2], points, tetrahedra)
