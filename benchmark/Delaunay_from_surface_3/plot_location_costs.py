#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Draws what location_costs counted as SVG files, which needs Matplotlib, and fills the tables of the manual, which
needs nothing but Python.

  plot_location_costs.py results/location_costs.json --output-dir fig
  plot_location_costs.py results/location_costs.json --tables
  plot_location_costs.py results/location_costs.json --manual Theory.txt [--check]

Drawn are
  theory_locations.svg   cells entered per located point, against the number of points
  theory_crossings.svg   crossings of each trace per point, against the number of points
  theory_rounds.svg      cells entered inside round h, against log^(h) n
  theory_hypothesis.svg  crossings, against the share of Delaunay edges in T
"""

import argparse
import json
import math
import os

import manual_tables
from theory_tables import WAYS, all_blocks, by_surface, mean_crossings

DRAWN_WAYS = ("history-root", "history-trace", "walk-trace", "plain", "walk-random")  # the table has them all


def draw_locations(report, file_name):
    from plot_style import MARKERS, Sheet, enclosing, grid_height, line, lines_along, size_ticks, ticks
    surfaces = {name: results for name, results in by_surface(report).items() if len(results) > 2}
    sheet = Sheet(grid_height(len(surfaces), 3, 3))
    values = [r["locations"][way]["cells_entered"] for results in surfaces.values() for r in results
              for way in DRAWN_WAYS]
    for axes, (surface, results) in zip(sheet.grid(len(surfaces), 3), surfaces.items()):
        sizes = [r["size"] for r in results]
        axes.plot(sizes, [math.log2(n) for n in sizes], color="#8a8a8a", linestyle=":")
        for way, marker in zip(DRAWN_WAYS, MARKERS):
            axes.plot(sizes, [r["locations"][way]["cells_entered"] for r in results], color=WAYS[way][0],
                      marker=marker, markersize=4)
        lines_along(axes, "y")
        size_ticks(axes, sorted({r["size"] for r in report["results"]}))
        ticks(axes.yaxis, enclosing([1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000], values), log=True)
        axes.set(title=surface, xlabel="points (logarithmic)")
    sheet.legend([line(WAYS[way][0], WAYS[way][1], marker) for way, marker in zip(DRAWN_WAYS, MARKERS)] +
                 [line("#8a8a8a", "log₂ n", None, linestyle=":")], columns=2)
    sheet.write(file_name)


def draw_crossings(report, file_name):
    from plot_style import COLORS, MARKERS, Sheet, grid_height, line, lines_along, size_ticks
    surfaces = {name: results for name, results in by_surface(report).items() if len(results) > 2}
    most = max(t["crossings_per_point"] for results in surfaces.values() for r in results for t in r["traces"])
    rounds = max(len(r["traces"]) for results in surfaces.values() for r in results)
    sheet = Sheet(grid_height(len(surfaces), 3, 1))
    for axes, (surface, results) in zip(sheet.grid(len(surfaces), 3), surfaces.items()):
        for h in range(rounds):
            curve = [(r["size"], r["traces"][h]["crossings_per_point"]) for r in results if h < len(r["traces"])]
            axes.plot(*zip(*curve), color=COLORS[h], marker=MARKERS[h], markersize=4)
        lines_along(axes, "y")
        size_ticks(axes, sorted({r["size"] for r in report["results"]}))
        axes.set(title=surface, xlabel="points (logarithmic)", ylim=(0, 1.1 * most))
    sheet.legend([line(COLORS[h], f"trace after round {h + 1}", MARKERS[h]) for h in range(rounds)], columns=rounds)
    sheet.write(file_name)


def draw_rounds(report, file_name):
    """One dot per size and round."""
    from plot_style import COLORS, MARKERS, Sheet, grid_height, line, lines_along
    surfaces = {name: results for name, results in by_surface(report).items() if len(results) > 2}
    rows = [row for results in surfaces.values() for r in results for row in r["rounds"]]
    rounds = max(len(r["rounds"]) for results in surfaces.values() for r in results)
    sheet = Sheet(grid_height(len(surfaces), 3, 1))
    for axes, (surface, results) in zip(sheet.grid(len(surfaces), 3), surfaces.items()):
        for h in range(rounds):
            dots = [(r["rounds"][h]["iterated_log"], r["rounds"][h]["history-trace"]) for r in results
                    if h < len(r["rounds"])]
            axes.plot(*zip(*dots), color=COLORS[h], marker=MARKERS[h], markersize=5, linestyle="")
        lines_along(axes, "both")
        axes.set(title=surface, xlabel="log₂ iterated h times, of n",
                 xlim=(0, 1.05 * max(row["iterated_log"] for row in rows)),
                 ylim=(0, 1.1 * max(row["history-trace"] for row in rows)))
    sheet.legend([line(COLORS[h], f"round h = {h + 1}", MARKERS[h], linestyle="") for h in range(rounds)],
                 columns=rounds)
    sheet.write(file_name)


CHANGES = {"none": "#000000", "jitter": "#0072b2", "decimated": "#d00000",
           "random spanning tree of F": "#009e73", "random edges": "#e69f00"}


def draw_hypothesis(report, file_name):
    """What is below 0.1, as 0 on the sphere, is drawn at 0.1."""
    from plot_style import MARKERS, Sheet, grid_height, line, lines_along, ticks
    surfaces = {}
    for row in report["hypothesis"]:
        surfaces.setdefault(row["surface"], []).append(row)
    drawn = lambda row: max(0.1, mean_crossings(row))
    most = max(drawn(row) for row in report["hypothesis"])
    sheet = Sheet(grid_height(len(surfaces), 2, 2, height=230))
    for axes, (surface, rows) in zip(sheet.grid(len(surfaces), 2, right=30, height=230), surfaces.items()):
        lines_along(axes, "both")
        for (change, color), marker in zip(CHANGES.items(), MARKERS):
            dots = [(100 * row["assumptions"]["subgraph_edges_delaunay"], drawn(row)) for row in rows
                    if row["change"] == change]
            if dots:
                axes.plot(*zip(*dots), color=color, marker=marker, linestyle="", markersize=7, clip_on=False)
        ticks(axes.xaxis, [0, 20, 40, 60, 80, 100], "{:g}".format)
        ticks(axes.yaxis, [t for t in (0.1, 1, 10, 100, 1000) if t < 10 * most], log=True)
        axes.set(title=f'{surface}, {rows[0]["points"]} points', xlabel="% of the edges of T are Delaunay")
    sheet.legend([line(color, change, marker, linestyle="") for (change, color), marker
                  in zip(CHANGES.items(), MARKERS)], columns=3)
    sheet.write(file_name)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", metavar="JSON", help="what location_costs wrote")
    parser.add_argument("--output-dir", metavar="FOLDER", help="draw; where the SVG files go")
    manual_tables.add_options(parser)
    arguments = parser.parse_args()
    with open(arguments.file, encoding="utf-8") as file:
        report = json.load(file)
    manual_tables.serve(arguments, all_blocks(report))
    if arguments.output_dir:
        for name, draw in (("locations", draw_locations), ("crossings", draw_crossings), ("rounds", draw_rounds),
                           ("hypothesis", draw_hypothesis)):
            draw(report, os.path.join(arguments.output_dir, f"theory_{name}.svg"))


if __name__ == "__main__":
    main()
