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


def show(mesh, picture):
    import pyvista

    mesh = mesh.triangulate()
    triangulation = dfs.delaunay3(mesh.points, mesh.faces.reshape(-1, 4)[:, 1:])
    grid = triangulation.to_pyvista()
    grid.cell_data["circumradius"] = triangulation.circumradii
    plotter = pyvista.Plotter(off_screen=picture is not None)
    plotter.add_mesh(grid.clip("x", crinkle=True), show_edges=True, log_scale=True)
    plotter.show(screenshot=picture)


def main():
    try:
        import pyvista
    except ImportError:
        print("PyVista was not found: no picture")
        points = np.random.default_rng(0).normal(size=(10000, 3))
        triangulation = dfs.delaunay3(points / np.linalg.norm(points, axis=1)[:, None])
        print(f"{triangulation.nsimplex} tetrahedra, median radius {np.median(triangulation.circumradii):.3f}")
        return
    mesh = pyvista.read(sys.argv[1]) if len(sys.argv) > 1 else pyvista.Sphere(radius=1, theta_resolution=60)
    show(mesh, sys.argv[2] if len(sys.argv) > 2 else None)


if __name__ == "__main__":
    main()
