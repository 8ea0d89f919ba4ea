# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Compares the Python module with scipy.spatial.Delaunay and vtkDelaunay3D, in turns, and writes JSON.

    python3 measure_python.py [--points N] [--queries N] [--repetitions N] [--output FILE]
    python3 measure_python.py --peers MODULE... [--points N] [--repetitions N] [--faults] [--output FILE]
    python3 measure_python.py --gaussians N... [--repetitions N] [--output FILE]
    python3 measure_python.py --sizes N... [--wheel FILE] [--repetitions N] [--output FILE]

Triangulations, with neighbours, of N points; and with --queries so many searches in as many points. With --peers only
what follows, by the clock on the wall, each triangulation in a process of its own: modules that have
`delaunay(points, threads)`, bindings of other libraries, beside this one, and rebuilds of points that move; with --faults
what they, SciPy and VTK make of a grid and of a plane that is added to other points. With --gaussians only tetrahedra of
N points as of boxes of Gaussians. With --sizes one and two threads on N points in a cube, what an import takes, and how
large a wheel is.

Run it with a Python into which the module is installed. Times are of the process, on all processors; those of one
and two threads of the module by the clock on the wall. VTK is left out where it is not found.
"""

import argparse
import importlib
import json
import os
import platform
import resource
import signal
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np
import scipy.spatial

import delaunay_from_surface as dfs
import delaunay_from_surface.cpp
from measure_single_calls import cpu


def machine():
    return {"cpu": cpu(), "date": time.strftime("%Y-%m-%d"), "load_before": os.getloadavg()[0]}


def begun(options, words=None):
    """The report of a program before it has results: its command, and where and with what it runs."""
    return {"command": " ".join([os.path.basename(sys.argv[0]), *(sys.argv[1:] if words is None else words)]),
            "machine": machine(), "python": platform.python_version(), "numpy": np.__version__, "scipy": scipy.__version__,
            "repetitions": options.repetitions}


def write(report, file_name):
    with open(file_name, "w", encoding="utf-8") as file:
        json.dump(report, file, indent=1)
        file.write("\n")


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


def by_threads(points, faces, repetitions, kind="median", of_many=statistics.median):
    """Medians by the clock on the wall, or what else is asked for; one and two threads in turns."""
    times = {1: [], 2: []}
    for _ in range(repetitions):
        for threads, of_threads in times.items():
            begin = time.perf_counter()
            dfs.delaunay3(points, faces, neighbors=True, threads=threads)
            of_threads.append(time.perf_counter() - begin)
    one, two = (of_many(of_threads) for of_threads in times.values())
    return {f"{kind}_wall_1_thread": round(one, 5), f"{kind}_wall_2_threads": round(two, 5),
            f"{kind}_speedup": round(one / two, 3)}


def bumpy_sphere(n):
    directions = np.random.default_rng(3).normal(size=(n, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, np.newaxis]
    return directions * (1 + .1 * np.sin(9 * directions[:, :1]) * np.sin(7 * directions[:, 1:2]))


def has_vtk():
    try:
        importlib.import_module("vtkmodules.vtkFiltersCore")
        return True
    except ImportError:
        print("skipped: VTK was not found")
        return False


def by_vtk(points):
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkPolyData
    from vtkmodules.vtkFiltersCore import vtkDelaunay3D
    data, of_vtk, triangulation = vtkPolyData(), vtkPoints(), vtkDelaunay3D()
    of_vtk.SetData(numpy_to_vtk(points, deep=True))
    data.SetPoints(of_vtk)
    triangulation.SetInputData(data)
    triangulation.Update()
    cells = triangulation.GetOutput().GetCells()
    return vtk_to_numpy(cells.GetConnectivityArray()).reshape(-1, 4)


def lines_of_vtk(repetitions):
    """Times and tetrahedra of vtkDelaunay3D, on points of which it loses some tetrahedra."""
    if not has_vtk():
        return []
    points = bumpy_sphere(20000)
    times, our_times = [], []
    for _ in range(repetitions):
        time_of_vtk, cells = seconds(lambda: by_vtk(points))
        our_time, found = seconds(lambda: dfs.delaunay3(points))
        times.append(time_of_vtk)
        our_times.append(our_time)
    return [{"points": len(points), "median_vtk_cpu": round(statistics.median(times), 4),
             "median_ours_cpu": round(statistics.median(our_times), 4), "tetrahedra_of_vtk": len(cells),
             "tetrahedra": len(found.simplices)}]


def plate(points):
    """A plane of points, a lattice, added to those in a cube."""
    k = int(np.sqrt(len(points) / 20))
    lattice = np.stack(np.meshgrid(np.linspace(0, 1, k), np.linspace(0, 1, k), [.5]), axis=-1).reshape(-1, 3)
    return np.vstack([points[:len(points) - len(lattice)], lattice])


def run_apart(work, limit=120):
    """Seconds and peak memory, beyond what was there, of work() in a process of its own, and the array it returns."""
    with tempfile.TemporaryDirectory() as folder:
        file = f"{folder}/result.npz"
        child = os.fork()
        if child == 0:
            signal.alarm(limit)
            with open("/proc/self/statm", encoding="ascii") as numbers:
                pages = int(numbers.read().split()[1])
            begin = time.perf_counter()
            result = work()
            wall = time.perf_counter() - begin
            np.savez(file, wall=wall, pages=pages, result=result)
            os._exit(0)
        _, status, usage = os.wait4(child, 0)
        if status != 0:
            return {"left_out": f"stopped after {limit} s" if os.WTERMSIG(status) == signal.SIGALRM else f"status {status}"}
        with np.load(file) as found:
            return {"wall": float(found["wall"]), "cells": found["result"],
                    "peak": 1024 * usage.ru_maxrss - int(found["pages"]) * resource.getpagesize()}


def in_turns(ways, repetitions, count=len):
    """For each of ways, {name: work}: medians of time and memory, and what count says of the last result."""
    runs = {name: [] for name in ways}
    for _ in range(repetitions):
        for name, work in ways.items():
            if not any("left_out" in run for run in runs[name]):
                runs[name].append(run_apart(work))
    return {name: of_name[-1] if "left_out" in of_name[-1] else
            {"median_wall": round(statistics.median(run["wall"] for run in of_name), 4),
             "peak_megabytes": round(statistics.median(run["peak"] for run in of_name) / 1e6),
             "tetrahedra": count(of_name[-1]["cells"])} for name, of_name in runs.items()}


def ways_of(points, peers, others=()):
    """Each on one thread and on two, where it knows threads; the others on one."""
    ways = {f"ours, {threads}": lambda threads=threads: dfs.delaunay3(points, threads=threads).simplices for threads in (1, 2)}
    for peer in peers:
        ways.update({f"{peer.__name__}, {threads}": lambda peer=peer, threads=threads: peer.delaunay(points, threads)
                     for threads in ((1, 2) if getattr(peer, "threads", True) else (1,))})
    return {**ways, **{f"{name}, 1": lambda work=work: work(points) for name, work in others}}


def by_scipy(points):
    return scipy.spatial.Delaunay(points).simplices


def faults(points, cells):
    """What is wrong with tetrahedra: flat ones; facets with two tetrahedra on one side, or with more than two, as these
    overlap; and facets within the hull with one, as others are missing."""
    p = points[cells]
    volumes = np.einsum("ij,ij->i", p[:, 1] - p[:, 0], np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 0]))
    facets = np.concatenate([cells.astype(np.int64)[:, [j for j in range(4) if j != k]] for k in range(4)])
    order = np.argsort(facets, axis=1)
    parity = np.linalg.det(np.eye(3)[order]) * np.repeat([1, -1, 1, -1], len(cells))
    sides = np.round(parity * np.tile(np.sign(volumes), 4)).astype(int)
    keys = np.take_along_axis(facets, order, 1) @ np.array([len(points) ** 2, len(points), 1])
    _, first, which, counts = np.unique(keys, return_index=True, return_inverse=True, return_counts=True)
    sums = np.bincount(which, weights=sides)
    planes = scipy.spatial.ConvexHull(points).equations
    alone = points[facets[first[counts == 1]]].mean(axis=1)
    within = [(planes[:, :3] @ q + planes[:, 3] < -1e-9).all() for q in alone]
    return {"number": len(cells), "flat": int((volumes == 0).sum()),
            "facets_of_overlapping": int(((counts > 2) | ((counts == 2) & (sums != 0))).sum()),
            "facets_without_neighbor": int(sum(within))}


def rebuilds(points, length, peers, repetitions):
    """Medians of rebuilds of points that move by so much on average."""
    rng, order = np.random.default_rng(7), dfs.InsertionOrder()
    ways = {"new_order": lambda: dfs.delaunay3(points), "kept_order": lambda: dfs.delaunay3(points, order=order),
            **{peer.__name__: lambda peer=peer: peer.delaunay(points, 1) for peer in peers}}
    times = {name: [] for name in ways}
    for _ in range(repetitions + 1):
        for name, work in ways.items():
            begin = time.perf_counter()
            work()
            times[name].append(time.perf_counter() - begin)
        points = points + rng.normal(0, length / np.sqrt(3), points.shape)
    return {name: round(statistics.median(of_way[1:]), 4) for name, of_way in times.items()}


def report_on_faults(peers, report):
    few = np.random.default_rng(2024).random((200000, 3))
    k = 100
    plane = np.stack(np.meshgrid(np.linspace(0, 1, k), np.linspace(0, 1, k), [.5]), axis=-1).reshape(-1, 3)
    grid = np.stack(np.meshgrid(*3 * [np.arange(40.)]), axis=-1).reshape(-1, 3)
    others = [("SciPy", by_scipy), *([("VTK", by_vtk)] if has_vtk() else [])]
    report["faults"] = [{"points": len(points), "what": what, "ways": in_turns(
        ways_of(points, peers, others), 1, lambda cells, points=points: faults(points, cells))}
        for what, points in (("points in a cube", few), ("the same and a lattice on a plane", np.vstack([few, plane])),
                             ("a grid", grid))]


def report_on_peers(options, report):
    peers = [importlib.import_module(name) for name in options.peers]
    surface, _ = torus(options.points)
    rng = np.random.default_rng(2024)
    cube = rng.random((options.points, 3))
    report["peers"] = {peer.__name__: peer.__doc__ for peer in peers}
    if options.faults:
        report_on_faults(peers, report)
        return
    report["results"] = [{"points": len(points), "what": what, "ways": in_turns(ways_of(points, peers), options.repetitions)}
                         for what, points in (("points in a cube", cube), ("points of a surface", surface))]
    few, threaded = rng.random((200000, 3)), [peer for peer in peers if getattr(peer, "threads", True)]
    report["rebuilds"] = [{"points": len(points), "what": what, "median_wall": rebuilds(points, length, threaded, 20)}
                          for what, points, length in (("points in a cube", few, .01 / len(few) ** (1 / 3)),
                                                       ("points of a surface", torus(200000)[0], .01 / len(few) ** .5))]


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


def boxes_of_gaussians(n):
    """As measure_gaussians makes them: centres and corners of rotated boxes near a surface, over three decades."""
    rng = np.random.default_rng(2024)
    centers = torus(n // 9)[0] + rng.normal(0, .01, (len(torus(n // 9)[0]), 3))
    rotations = scipy.spatial.transform.Rotation.random(len(centers), random_state=7).as_matrix()
    halves = 10 ** rng.uniform(-4, -1, (len(centers), 1)) * rng.uniform(.1, 1, centers.shape)
    signs = np.vstack([np.zeros((1, 3)), np.stack(np.meshgrid(*3 * [[-1, 1]]), axis=-1).reshape(-1, 3)])
    boxes = np.einsum("nij,knj->nki", rotations, signs[:, np.newaxis] * halves) + centers[:, np.newaxis]
    return boxes.reshape(-1, 3).astype(np.float32)


def report_on_gaussians(options, report):
    report["results"] = []
    for number in options.gaussians:
        points = boxes_of_gaussians(number)
        ways = {f"triangulate, {t}": lambda t=t: dfs.cpp.triangulate(points, threads=t) for t in (1, 2)}
        report["results"].append({"points": len(points), "ways": in_turns(ways, options.repetitions)})


def cpu_of_import(repetitions):
    """Median of the seconds beyond NumPy's, each in a process of its own whose files have been read before."""
    program = ("import numpy, time; begin = time.process_time(); import delaunay_from_surface; "
               "print(time.process_time() - begin)")
    times = [float(subprocess.run([sys.executable, "-c", program], capture_output=True, check=True).stdout)
             for _ in range(repetitions + 1)]
    return round(statistics.median(times[1:]), 5)


def report_on_sizes(options, report):
    """The least times, which other programs on the second core spoil less than medians."""
    rng = np.random.default_rng(2024)
    report["results"] = [{"points": n, **by_threads(rng.random((n, 3)), None, options.repetitions, "least", min)}
                         for n in options.sizes]
    report["import_cpu"] = cpu_of_import(options.repetitions)
    if options.wheel:
        report["wheel_bytes"] = os.path.getsize(options.wheel)


def report_beside_scipy(options, report):
    surface, faces = torus(options.points)
    cube = np.random.default_rng(2024).random((options.points, 3))
    report["results"] = [line("points in a cube", cube, None, options.repetitions),
                         line("surface: points alone", surface, None, options.repetitions),
                         line("surface: faces", surface, faces, options.repetitions)]
    if options.queries:
        report["results"].insert(1, line("some of them in a lattice on a plane", plate(cube), None, options.repetitions))
        report["queries"] = [line_of_queries(options.queries, options.repetitions)]
    report["vtk"] = lines_of_vtk(options.repetitions)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--points", type=int, default=100000)
    parser.add_argument("--queries", type=int, default=0)
    parser.add_argument("--peers", nargs="+", metavar="MODULE", default=[])
    parser.add_argument("--faults", action="store_true")
    parser.add_argument("--gaussians", nargs="+", type=int, metavar="N", default=[])
    parser.add_argument("--sizes", nargs="+", type=int, metavar="N", default=[])
    parser.add_argument("--wheel", metavar="FILE")
    parser.add_argument("--repetitions", type=int, default=3)
    parser.add_argument("--output", default="python.json")
    options = parser.parse_args()
    words = [os.path.basename(word) if word == options.wheel else word for word in sys.argv[1:]]
    report = begun(options, words)
    (report_on_peers if options.peers else report_on_gaussians if options.gaussians else
     report_on_sizes if options.sizes else report_beside_scipy)(options, report)
    write(report, options.output)
    for result in [result for key in ("results", "queries", "vtk", "faults", "rebuilds") for result in report.get(key, [])]:
        print(json.dumps(result))


if __name__ == "__main__":
    main()
