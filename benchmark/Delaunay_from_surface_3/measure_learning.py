# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Measures what programs do that triangulate in every step, in turns with what they use today, and writes JSON.

    python3 measure_learning.py [--points N...] [--sets N] [--set-size N] [--repetitions N] [--tetgen FILE] [--output
    FILE]

Points move a little from step to step: `Moving` in its kept order, `delaunay3` anew, SciPy, and TetGen, the latter two
without anything kept. What a step has changed: `Moving`, and sorting of rows in NumPy. Batches: many small sets by
`delaunay3_batch` with one and with two threads, and SciPy in a loop, as PyTorch Geometric's transform does.

TetGen is the peer that this folder's build makes (tetgen_peer), asked for by its file; without it, it is left out.
Times are by the clock on the wall, so other programs on the machine disturb them; the load before is noted.
"""

import argparse
import json
import os
import re
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np
import scipy.spatial

import delaunay_from_surface as dfs
from measure_python import begun, write


def wall(work):
    begin = time.perf_counter()
    result = work()
    return time.perf_counter() - begin, result


def medians(times):
    return {name: round(statistics.median(of_way), 5) for name, of_way in times.items()}


def tetgen_seconds(program, points):
    """What the peer says of its triangulation alone, without the reading of points."""
    with tempfile.NamedTemporaryFile() as file:  # as points_file.h reads it
        file.write(np.uint64(len(points)).tobytes() + points.tobytes())
        file.flush()
        done = subprocess.run([program, file.name], capture_output=True, text=True, check=True)
    return float(re.search(r"^wall_seconds (\S+)$", done.stdout, re.M).group(1))


def changed_by_sorting(before, after):
    """Which rows are in one array alone: those of both are sorted together, and then have their like beside them."""
    rows = np.sort(np.concatenate([before, after]), axis=1)
    order = np.lexsort(rows.T)
    is_same = (rows[order[1:]] == rows[order[:-1]]).all(axis=1)
    once = order[~(np.append(False, is_same) | np.append(is_same, False))]
    return np.sort(once[once < len(before)]), np.sort(once[once >= len(before)]) - len(before)


def line_of_steps(n, length, options):
    """Steps of points in a cube by `length` times their spacing, on average; and what they have changed."""
    rng = np.random.default_rng(2024)
    points = rng.random((n, 3))
    moving = {threads: dfs.Moving(points, threads=threads) for threads in (1, 2)}
    times, changes = {}, {}
    for _ in range(options.repetitions):
        points = points + rng.normal(0, length * n ** (-1 / 3) / np.sqrt(3), points.shape)
        ways = {"moving, 1": lambda: moving[1].update(points), "moving, 2": lambda: moving[2].update(points),
                "anew, 1": lambda: dfs.delaunay3(points, neighbors=True),
                "anew, 2": lambda: dfs.delaunay3(points, neighbors=True, threads=2),
                "scipy, 1": lambda: scipy.spatial.Delaunay(points)}
        for name, work in ways.items():
            times.setdefault(name, []).append(wall(work)[0])
        if options.tetgen:
            times.setdefault("tetgen, 1", []).append(tetgen_seconds(options.tetgen, points))
        for threads, of_points in moving.items():
            changed = of_points.changes
            of_simplices, found = wall(lambda: (changed.simplices_gone, changed.simplices_new))
            of_edges, _ = wall(lambda: changed.edges_new)  # which are found first
            changes.setdefault(f"simplices, {threads}", []).append(of_simplices)
            changes.setdefault(f"edges, {threads}", []).append(of_edges)
        by_sorting, expected = wall(lambda: changed_by_sorting(changed.before.simplices, changed.after.simplices))
        changes.setdefault("simplices, sorted by NumPy", []).append(by_sorting)
        if not all(np.array_equal(*pair) for pair in zip(found, expected)):
            raise RuntimeError("sorting finds other simplices")
    return {"points": n, "length": length, "tetrahedra": moving[1].triangulation.nsimplex, "new": len(found[1]),
            "median_wall": medians(times), "median_wall_of_changes": medians(changes)}


def line_of_batches(options):
    sets = np.random.default_rng(7).random((options.sets, options.set_size, 3))
    ways = {"batch, 1": lambda: dfs.delaunay3_batch(sets, threads=1),
            "batch, 2": lambda: dfs.delaunay3_batch(sets, threads=2),
            "loop": lambda: [dfs.delaunay3(points) for points in sets],
            "scipy, loop": lambda: [scipy.spatial.Delaunay(points) for points in sets]}
    times = {name: [] for name in ways}
    for _ in range(options.repetitions):
        for name, work in ways.items():
            times[name].append(wall(work)[0])
    return {"sets": options.sets, "set_size": options.set_size, "median_wall": medians(times)}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--points", nargs="+", type=int, metavar="N", default=[10000, 100000, 1000000])
    parser.add_argument("--sets", type=int, default=1000)
    parser.add_argument("--set-size", type=int, default=1000)
    parser.add_argument("--repetitions", type=int, default=5)
    parser.add_argument("--tetgen", metavar="FILE")
    parser.add_argument("--output", default="python_learning.json")
    options = parser.parse_args()
    if not options.tetgen:
        print("skipped: TetGen, for which --tetgen names the peer")
    words = [os.path.basename(word) if word == options.tetgen else word for word in sys.argv[1:]]
    report = begun(options, words)
    report["results"] = [line_of_steps(n, length, options) for n in options.points for length in (.001, .01)]
    report["batches"] = [line_of_batches(options)]
    write(report, options.output)
    for result in report["results"] + report["batches"]:
        print(json.dumps(result))


if __name__ == "__main__":
    main()
