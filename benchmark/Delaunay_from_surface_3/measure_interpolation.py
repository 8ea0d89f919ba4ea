# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Compares the interpolators of the Python module with SciPy's LinearNDInterpolator, in turns, and writes JSON.

    python3 measure_interpolation.py [--points N] [--queries N] [--repetitions N] [--limit SECONDS] [--output FILE]

Each way triangulates N points and interpolates at the queries, in a process of its own, by the clock on the wall:
points in a cube, with queries in a random order and on a grid; and in UTM's coordinates a surface that is scanned, and
a tenth of the points in a lattice that is turned, with queries at its points and halfway between them, none of which
is outside. The numbers of results that are NaN, and the largest error for a linear function, come with the times.
"""

import argparse
import json
import statistics

import numpy as np
import scipy.interpolate

import delaunay_from_surface as dfs
from measure_python import begun, bumpy_sphere, run_apart, write


def ways_of(points, values, xi):
    ways = {"SciPy, linear": lambda: scipy.interpolate.LinearNDInterpolator(points, values)(xi)}
    for name, kind in (("linear", dfs.LinearInterpolator), ("natural neighbours", dfs.NaturalNeighborInterpolator)):
        for threads in (1, 2):
            ways[f"{name}, {threads}"] = lambda kind=kind, threads=threads: kind(points, values, threads=threads)(xi)
    everywhere = {"outside": "nearest", "threads": 2}
    ways["linear, nearest outside, 2"] = lambda: dfs.LinearInterpolator(points, values, **everywhere)(xi)
    return ways


def line(name, points, xi, options):
    """Medians of time and memory, and what is wrong with the last result."""
    values, expected = ((x - points.mean(axis=0)) @ [1., -2., 3.] for x in (points, xi))
    runs = {}
    for _ in range(options.repetitions):
        for way, work in ways_of(points, values, xi).items():
            if not any("left_out" in run for run in runs.setdefault(way, [])):
                runs[way].append(run_apart(work, options.limit))
    results = {}
    for way, of_way in runs.items():
        last = of_way[-1]
        if "left_out" in last:
            results[way] = last
            continue
        errors = abs(last["cells"] - expected)
        results[way] = {"median_wall": round(statistics.median(run["wall"] for run in of_way), 4),
                        "peak_megabytes": round(statistics.median(run["peak"] for run in of_way) / 1e6),
                        "nan": int(np.isnan(errors).sum())}
        if "nearest" not in way:
            results[way]["largest_error"] = float(np.nanmax(errors))
    return {"what": name, "points": len(points), "queries": len(xi), "ways": results}


def sets(n, queries):
    rng = np.random.default_rng(2024)
    cube, k = rng.random((n, 3)), round(queries ** (1 / 3))
    grid = np.stack(np.meshgrid(*3 * [np.linspace(0, 1, k)], indexing="ij"), axis=-1).reshape(-1, 3)
    yield "points in a cube, queries in a random order", cube, rng.random((queries, 3))
    yield "points in a cube, queries on a grid", cube, grid
    origin, turn, side = [5e5, 4.6e6, 100], np.linalg.qr(rng.normal(size=(3, 3)))[0], round((n / 10) ** (1 / 3))
    lattice, halves = (np.stack(np.meshgrid(*3 * [steps], indexing="ij"), axis=-1).reshape(-1, 3)
                       for steps in (np.arange(float(side)), np.arange(1, side - 1.5, .5)))
    points = lattice @ turn + origin
    yield "a lattice that is turned, far away", points, np.vstack([points, halves @ turn + origin])
    scan = 100 * bumpy_sphere(n)
    yield ("a scanned surface, far away", scan + origin,
           scan[rng.integers(0, n, queries)] * rng.random((queries, 1)) + origin)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--points", type=int, default=100000)
    parser.add_argument("--queries", type=int, default=1000000)
    parser.add_argument("--repetitions", type=int, default=3)
    parser.add_argument("--limit", type=int, default=300)
    parser.add_argument("--output", default="python_interpolation.json")
    options = parser.parse_args()
    report = {**begun(options), "results": []}
    for name, points, xi in sets(options.points, options.queries):
        report["results"].append(line(name, points, xi, options))
        print(json.dumps(report["results"][-1]))
    write(report, options.output)


if __name__ == "__main__":
    main()
