# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Compares the filtration of alpha complexes with GUDHI's, in turns, each in a process of its own, and writes JSON.

    python3 measure_topology.py [--points N...] [--repetitions N] [--output FILE]

GUDHI's simplex trees are made with exact values, which this module's are, too, and with its usual ones, "safe". Times are by
the clock on the wall; memory is the peak beyond what was there before.
"""

import argparse
import json

import gudhi
import numpy as np

import delaunay_from_surface as dfs
from measure_python import begun, in_turns, torus, write


def of_gudhi(points, precision, weights=None):
    weights = None if weights is None else weights.tolist()
    tree = gudhi.AlphaComplex(points=points, weights=weights, precision=precision).create_simplex_tree()
    return np.array([tree.num_simplices()])


def ours(points, threads, weights=None):
    return np.array([len(dfs.filtration(points, weights=weights, threads=threads).order)])


def ways_of(points, weights=None):
    return {"delaunay3, 1": lambda: np.array([dfs.delaunay3(points, weights=weights).nsimplex]),
            **{f"filtration, {threads}": lambda threads=threads: ours(points, threads, weights) for threads in (1, 2)},
            **{f"GUDHI, {precision}": lambda precision=precision: of_gudhi(points, precision, weights)
               for precision in ("exact", "safe")}}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--points", type=int, nargs="+", default=[10000, 100000])
    parser.add_argument("--repetitions", type=int, default=3)
    parser.add_argument("--output", default="python_topology.json")
    options = parser.parse_args()
    report = {**begun(options), "gudhi": gudhi.__version__, "results": []}
    for n in options.points:
        random = np.random.default_rng(2024)
        cube, weights = random.random((n, 3)), random.random(n) * n ** (-2 / 3) / 10
        for what, points, of_points in (("points in a cube", cube, None), ("points of a surface", torus(n)[0], None),
                                        ("points with weights", cube, weights)):
            ways = in_turns(ways_of(points, of_points), options.repetitions, lambda result: int(result[0]))
            numbers = {way["tetrahedra"] for name, way in ways.items() if "delaunay3" not in name and "left_out" not in way}
            if len(numbers) > 1:
                raise RuntimeError(f"{what}: complexes of {numbers} simplices")
            report["results"].append({"points": len(points), "what": what, "simplices": numbers.pop(), "ways": {
                name: {key: value for key, value in way.items() if key != "tetrahedra"} for name, way in ways.items()}})
            print(json.dumps(report["results"][-1]))
    write(report, options.output)


if __name__ == "__main__":
    main()
