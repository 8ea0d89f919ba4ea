#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Puts the few numbers that the first page shows into README.md, from the results; needs nothing but Python.

  readme_tables.py results/{threads_256k,orders_200k,demo_meshes,python}.json --tables
  readme_tables.py results/{threads_256k,orders_200k,demo_meshes,python}.json --manual README.md [--check]

Blocks: times, seconds on one and two threads beside plain CGAL; collections, the gain over many meshes; python, the
gain over SciPy.
"""

import argparse
import json

import manual_tables
from manual_tables import cell, machine_of, table
from order_tables import geometric_mean, is_cad

SURFACES = {  # what the first page shows, and what it says they are
    "bunny": "Stanford's bunny, densified",
    "elephant": "an elephant, densified",
    "sphere": "a noisy sphere",
    "genus-50": "a folded surface of genus 50",
    "plate": "a flat plate with holes",
}


def seconds(row, method):
    return row["times"][method]["median_wall"]


def times_block(report):
    rows = {row["surface"]: row for row in report["results"]}
    lines = [[text, f'{rows[name]["points"]:,}'.replace(",", " "), *(f"{seconds(rows[name], m):.2f}" for m in METHODS)]
             for name, text in SURFACES.items()]
    gains = [[seconds(row, "plain") / seconds(row, m) for row in rows.values()] for m in METHODS]
    lines.append([f"plain CGAL / this, geometric mean of {len(rows)} surfaces", "",
                  *(f"{geometric_mean(g):.2f}" for g in gains)])
    titles = ["surface", "points", *METHODS.values()]
    return (table(titles, [[cell(v) for v in line] for line in lines]) +
            f'\n\n{machine_of(report).replace("%", "")}; {report["machine"]["date"]}.')


METHODS = {"plain": "plain CGAL", "plain_parallel": "its `Parallel_tag`, two threads", "threads_1": "this package",
           "threads_2": "two threads"}


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

    threads = report_with(lambda r: "results" in r and "times" in r["results"][0])
    orders = report_with(lambda r: "results" in r and "family" in r["results"][0])
    return {"times": times_block(threads),
            "collections": collections_block(orders, report_with(lambda r: "meshes" in r)),
            "python": python_block(report_with(lambda r: "scipy" in r))}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", metavar="JSON", help="what measure_threads and the others wrote")
    manual_tables.add_options(parser)
    arguments = parser.parse_args()
    reports = []
    for name in arguments.files:
        with open(name, encoding="utf-8") as file:
            reports.append(json.load(file))
    manual_tables.serve(arguments, all_blocks(reports))


if __name__ == "__main__":
    main()
