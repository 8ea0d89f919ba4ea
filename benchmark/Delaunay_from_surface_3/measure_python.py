# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Compares the Python module with scipy.spatial.Delaunay and vtkDelaunay3D, in turns, and writes JSON.

    python3 measure_python.py [--points N] [--queries N] [--repetitions N] [--output FILE]

Triangulations, with neighbours, of N points; and with --queries so many searches in as many points.

Run it with a Python into which the module is installed. Times are of the process, on all processors; those of one
and two threads of the module by the clock on the wall. VTK is left out where it is not found.
"""

import argparse
import json
import platform
import statistics
import time

import numpy as np
import scipy.spatial

import delaunay_from_surface as dfs


def torus(n):
    """A wavy torus: points and triangles."""
    columns, rows = 2 * int(np.sqrt(n / 2)), int(np.sqrt(n / 2))
    u, v = np.meshgrid(np.arange(columns), np.arange(rows), indexing="ij")
    a, b = 2 * np.pi * u / columns, 2 * np.pi * v / rows
    r = 0.4 + 0.05 * np.cos(5 * a + 3 * b) + 0.003 * np.random.default_rng(1).random(a.shape)
    points = np.stack([(1 + r * np.cos(b)) * np.cos(a), (1 + r * np.cos(b)) * np.sin(a), r * np.sin(b)], axis=-1)

    def index(i, j):
        return (i % columns) * rows + j % rows
    faces = np.concatenate([np.stack([index(u, v), index(u + 1, v), index(u + 1, v + 1)], axis=-1).reshape(-1, 3),
                            np.stack([index(u, v), index(u + 1, v + 1), index(u, v + 1)], axis=-1).reshape(-1, 3)])
    return points.reshape(-1, 3), faces.astype(np.int32)


def seconds(work):
    begin = time.process_time()
    result = work()
    return time.process_time() - begin, result


def line(name, points, faces, repetitions):
    scipy_times, our_times = [], []
    for _ in range(repetitions):
        time_of_scipy, expected = seconds(lambda: scipy.spatial.Delaunay(points))
        our_time, found = seconds(lambda: dfs.delaunay3(points, faces, neighbors=True))
        if len(expected.simplices) != len(found.simplices) and "lattice" not in name: # Qhull leaves some of ties out
            raise RuntimeError(f"{name}: {len(expected.simplices)} tetrahedra by SciPy, {len(found.simplices)} by us")
        scipy_times.append(time_of_scipy)
        our_times.append(our_time)
    return {**as_line(name, len(points), scipy_times, our_times), **by_threads(points, faces, repetitions)}


def by_threads(points, faces, repetitions):
    """Medians by the clock on the wall, one and two threads in turns."""
    times = {1: [], 2: []}
    for _ in range(repetitions):
        for threads, of_threads in times.items():
            begin = time.perf_counter()
            dfs.delaunay3(points, faces, neighbors=True, threads=threads)
            of_threads.append(time.perf_counter() - begin)
    one, two = (statistics.median(of_threads) for of_threads in times.values())
    return {"median_wall_1_thread": round(one, 4), "median_wall_2_threads": round(two, 4),
            "median_speedup": round(one / two, 3)}


def bumpy_sphere(n):
    directions = np.random.default_rng(3).normal(size=(n, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, np.newaxis]
    return directions * (1 + .1 * np.sin(9 * directions[:, :1]) * np.sin(7 * directions[:, 1:2]))


def lines_of_vtk(repetitions):
    """Times and tetrahedra of vtkDelaunay3D, on points of which it loses some tetrahedra."""
    try:
        from vtkmodules.util.numpy_support import numpy_to_vtk
        from vtkmodules.vtkCommonCore import vtkPoints
        from vtkmodules.vtkCommonDataModel import vtkPolyData
        from vtkmodules.vtkFiltersCore import vtkDelaunay3D
    except ImportError:
        print("skipped: VTK was not found")
        return []
    points = bumpy_sphere(20000)
    times, our_times = [], []
    for _ in range(repetitions):
        def work():
            data, of_vtk, triangulation = vtkPolyData(), vtkPoints(), vtkDelaunay3D()
            of_vtk.SetData(numpy_to_vtk(points, deep=True))
            data.SetPoints(of_vtk)
            triangulation.SetInputData(data)
            triangulation.Update()
            return triangulation.GetOutput().GetNumberOfCells()
        time_of_vtk, number = seconds(work)
        our_time, found = seconds(lambda: dfs.delaunay3(points))
        times.append(time_of_vtk)
        our_times.append(our_time)
    return [{"points": len(points), "median_vtk_cpu": round(statistics.median(times), 4),
             "median_ours_cpu": round(statistics.median(our_times), 4), "tetrahedra_of_vtk": number,
             "tetrahedra": len(found.simplices)}]


def plate(points):
    """A plane of points, a lattice, added to those in a cube."""
    k = int(np.sqrt(len(points) / 20))
    lattice = np.stack(np.meshgrid(np.linspace(0, 1, k), np.linspace(0, 1, k), [.5]), axis=-1).reshape(-1, 3)
    return np.vstack([points[:len(points) - len(lattice)], lattice])


def line_of_queries(number, repetitions):
    """Each in triangulations that are there, and have found something: SciPy prepares the first search."""
    rng = np.random.default_rng(7)
    points, xi = rng.random((number, 3)), rng.random((number, 3))
    theirs, ours = scipy.spatial.Delaunay(points), dfs.delaunay3(points, neighbors=True)
    theirs.find_simplex(xi[:1])
    scipy_times, our_times = [], []
    for _ in range(repetitions):
        time_of_scipy, expected = seconds(lambda: theirs.find_simplex(xi))
        our_time, found = seconds(lambda: ours.find_simplex(xi))
        if ((expected < 0) != (found < 0)).any():
            raise RuntimeError("not the same points are found")
        scipy_times.append(time_of_scipy)
        our_times.append(our_time)
    return as_line("find_simplex() for as many points", number, scipy_times, our_times)


def as_line(name, points, scipy_times, our_times):
    ratios = [s / o for s, o in zip(scipy_times, our_times)]
    return {"consumer": name, "points": points, "median_scipy_cpu": round(statistics.median(scipy_times), 4),
            "median_ours_cpu": round(statistics.median(our_times), 4),
            "median_ratio": round(statistics.median(ratios), 3)}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--points", type=int, default=100000)
    parser.add_argument("--queries", type=int, default=0)
    parser.add_argument("--repetitions", type=int, default=3)
    parser.add_argument("--output", default="python.json")
    options = parser.parse_args()
    surface, faces = torus(options.points)
    cube = np.random.default_rng(2024).random((options.points, 3))
    queries = f"--queries {options.queries} " if options.queries else ""
    report = {"command": f"measure_python.py --points {options.points} {queries}--repetitions {options.repetitions}",
              "python": platform.python_version(), "numpy": np.__version__, "scipy": scipy.__version__,
              "repetitions": options.repetitions,
              "results": [line("points in a cube", cube, None, options.repetitions),
                          line("surface: points alone", surface, None, options.repetitions),
                          line("surface: faces", surface, faces, options.repetitions)]}
    if options.queries:
        report["results"].insert(1, line("some of them in a lattice on a plane", plate(cube), None, options.repetitions))
        report["queries"] = [line_of_queries(options.queries, options.repetitions)]
    report["vtk"] = lines_of_vtk(options.repetitions)
    with open(options.output, "w", encoding="utf-8") as file:
        json.dump(report, file, indent=1)
        file.write("\n")
    for result in report["results"] + report.get("queries", []) + report["vtk"]:
        print(json.dumps(result))


if __name__ == "__main__":
    main()
