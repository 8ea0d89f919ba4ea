#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Puts the few numbers that the first page shows into README.md, from the results; needs nothing but Python.

  cd results
  ../readme_tables.py {compare_peers,threads_256k,orders_200k,demo_meshes,python}.json --tables
  ../readme_tables.py {compare_peers,threads_256k,orders_200k,demo_meshes,python}.json --manual README.md [--check]

Blocks: times, seconds on one and two threads beside plain CGAL and others; collections, the gain over many meshes;
python, the gain over SciPy.
"""

import manual_tables
from manual_tables import cell, machine_of, table
from order_tables import geometric_mean, is_cad

SURFACES = {  # what the first page shows, and what it says they are
    "bunny": "bunny",
    "elephant": "elephant",
    "genus-50": "folded surface of genus 50",
    "plate": "flat plate with holes",
}
OURS = [("this package", 1, "threads_1"), ("this package", 2, "threads_2"), ("plain CGAL", 1, "plain"),
        ("CGAL with `Parallel_tag`", 2, "plain_parallel")]
PEERS = [("Geogram", 1, "geogram-1"), ("Geogram", 2, "geogram-2"), ("HXT", 1, "hxt-1"), ("HXT", 2, "hxt-2"),
         ("TetGen", 1, "tetgen")]


def seconds(row, method):
    if method in row["times"]:
        return row["times"][method]["median_wall"]
    return next(peer["median_wall"] for peer in row["peers"] if peer["method"] == method)


def times_block(peers, threads):
    rows = {row["surface"]: row for row in peers["results"]}
    lines = [[name, count, *(f"{seconds(rows[surface], method):.2f}" for surface in SURFACES)]
             for name, count, method in OURS + PEERS]
    gains = [geometric_mean([seconds(row, "plain") / seconds(row, method) for row in threads["results"]])
             for method in ("threads_1", "threads_2")]
    text = [f'Points: {", ".join(f"""{rows[surface]["points"]:,}""" for surface in SURFACES)}. Geogram, HXT and TetGen '
            "make tetrahedra of their own, which takes less time than filling a triangulation of CGAL's.",
            f'Time of plain CGAL / time of this package, geometric mean of {len(threads["results"])} surfaces of '
            f'{round(threads["results"][0]["points"], -3):,} points: {gains[0]:.2f} with one thread, {gains[1]:.2f} with two.',
            f'{machine_of(peers).replace("%", "")}; {peers["machine"]["date"]}.']
    return table(["", "threads", *SURFACES.values()], [[cell(v) for v in line] for line in lines]) + "\n\n" + "\n".join(text)


def collections_block(orders, meshes, least_vertices=3000):
    kinds = [
        ("meshes of CGAL's demos, of 3,000 vertices and more",
         [m["ratio"] for m in meshes["meshes"] if m.get("ratio") and m["vertices"] >= least_vertices]),
        ("solids as CAD makes them, 200,000 points", [r["median_ratio"] for r in orders["results"] if is_cad(r)]),
        ("other surfaces, made to be hard, 200,000 points",
         [r["median_ratio"] for r in orders["results"] if not is_cad(r)]),
    ]
    rows = [[name, str(len(ratios)), f"{geometric_mean(ratios):.2f}", f"{min(ratios):.2f}", f"{max(ratios):.2f}"]
            for name, ratios in kinds]
    return table(["", "how many", "geometric mean", "least", "most"], rows)


def python_block(report):
    ratios = [r["median_ratio"] for r in report["results"]]
    points = max(r["points"] for r in report["results"])
    times = " to ".join(sorted({f"{ratio:.0f}" for ratio in (min(ratios), max(ratios))}, key=int))
    return (f"On {points:,} points, with tetrahedra and neighbours, it is {times} times as "
            f'fast as `scipy.spatial.Delaunay` (SciPy {report["scipy"]}).')


def all_blocks(reports):
    """{name: text} of all that the first page shows; a report is known by what it has."""
    def report_with(has):
        return next(report for report in reports if has(report))

    peers = report_with(lambda r: "results" in r and "peers" in r["results"][0])
    threads = report_with(lambda r: "results" in r and "times" in r["results"][0] and r is not peers)
    orders = report_with(lambda r: "results" in r and "family" in r["results"][0])
    return {"times": times_block(peers, threads),
            "collections": collections_block(orders, report_with(lambda r: "meshes" in r)),
            "python": python_block(report_with(lambda r: "scipy" in r))}


if __name__ == "__main__":
    manual_tables.fill_from_results(__doc__, all_blocks, "measure_threads and the others")
