# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""Shows the Delaunay tetrahedra of a mesh, cut by a plane, colored by the radius of their spheres.

    python show_tetrahedra.py mesh.ply [picture.png]

Any file that PyVista reads will do. Without PyVista only figures are printed, for points on a sphere.
"""

import sys

import numpy as np

import delaunay_from_surface as dfs


def circumradii(points, simplices):
    """The radii of the spheres through the corners, up to rounding."""
    a = points[simplices[:, 0]]
    edges = np.stack([points[simplices[:, k]] - a for k in (1, 2, 3)], axis=1)
    squares = np.einsum("ijk,ijk->ij", edges, edges)
    centers = np.linalg.solve(2 * edges, squares[..., None])[..., 0]
    return np.linalg.norm(centers, axis=1)


def show(mesh, picture):
    import pyvista

    mesh = mesh.triangulate()
    points = np.asarray(mesh.points, dtype=float)
    faces = mesh.faces.reshape(-1, 4)[:, 1:]
    tetrahedra = dfs.delaunay3(points, faces).simplices
    grid = pyvista.UnstructuredGrid({pyvista.CellType.TETRA: tetrahedra}, points)
    grid.cell_data["circumradius"] = circumradii(points, tetrahedra)
    plotter = pyvista.Plotter(off_screen=picture is not None)
    plotter.add_mesh(grid.clip("x", crinkle=True), show_edges=True, log_scale=True)
    plotter.show(screenshot=picture)


def main():
    try:
        import pyvista
    except ImportError:
        print("PyVista was not found: no picture")
        points = np.random.default_rng(0).normal(size=(10000, 3))
        points /= np.linalg.norm(points, axis=1)[:, None]
        tetrahedra = dfs.delaunay3(points).simplices
        print(f"{len(tetrahedra)} tetrahedra, median radius {np.median(circumradii(points, tetrahedra)):.3f}")
        return
    mesh = pyvista.read(sys.argv[1]) if len(sys.argv) > 1 else pyvista.Sphere(radius=1, theta_resolution=60)
    show(mesh, sys.argv[2] if len(sys.argv) > 2 else None)


if __name__ == "__main__":
    main()
