#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Draws what location_costs counted as SVG files and fills the tables of the manual; needs nothing but Python.

  plot_location_costs.py results/location_costs.json --output-dir fig
  plot_location_costs.py results/location_costs.json --tables
  plot_location_costs.py results/location_costs.json --manual Theory.txt [--check]

Drawn are
  theory_locations.svg   cells entered per located point, against the number of points
  theory_crossings.svg   crossings of each trace per point, against the number of points
  theory_rounds.svg      cells entered inside round h, against log^(h) n
  theory_hypothesis.svg  crossings and cells, against the share of Delaunay edges in T
"""

import argparse
import json
import math
import os
import textwrap

import manual_tables
from plot_svg import Svg
from results import size_name
from theory_tables import WAYS, all_blocks, by_surface, mean_crossings

COLORS = ["#d00000", "#0072b2", "#009e73", "#e69f00", "#7a3b00", "#cc79a7"]
WIDTH, HEIGHT, LEFT, TOP, GAP_X, GAP_Y = 380, 250, 58, 92, 60, 74


class Axes:
    """A panel with its own scales; `log` names the logarithmic ones."""

    def __init__(self, svg, index, columns, title, x_ticks, y_ticks, log="", x_name=size_name):
        self.svg, self.log = svg, log
        self.x0 = LEFT + (index % columns) * (WIDTH + GAP_X)
        self.y0 = TOP + 20 + (index // columns) * (HEIGHT + GAP_Y)
        self.x_range, self.y_range = (x_ticks[0], x_ticks[-1]), (y_ticks[0], y_ticks[-1])
        svg.text(self.x0, self.y0 - 9, title, 13, weight="bold")
        for tick in y_ticks:
            svg.line(self.x0, self.y(tick), self.x0 + WIDTH, self.y(tick), "#e3e3e3")
            svg.text(self.x0 - 6, self.y(tick) + 4, f"{tick:g}", 11, "end")
        for tick in x_ticks:
            svg.line(self.x(tick), self.y0 + HEIGHT, self.x(tick), self.y0 + HEIGHT + 4)
            svg.text(self.x(tick), self.y0 + HEIGHT + 18, x_name(tick), 11, "middle")
        svg.line(self.x0, self.y0 + HEIGHT, self.x0 + WIDTH, self.y0 + HEIGHT)
        svg.line(self.x0, self.y0, self.x0, self.y0 + HEIGHT)

    def share(self, value, value_range, axis):
        scale = math.log if axis in self.log else float
        low, high = (scale(v) for v in value_range)
        return (scale(value) - low) / (high - low)

    def x(self, value):
        return self.x0 + WIDTH * self.share(value, self.x_range, "x")

    def y(self, value):
        return self.y0 + HEIGHT * (1 - self.share(value, self.y_range, "y"))

    def curve(self, points, color, guide=False):
        points = [(self.x(a), self.y(b)) for a, b in points]
        if guide:
            for (x1, y1), (x2, y2) in zip(points, points[1:]):
                self.svg.line(x1, y1, x2, y2, color, 1.2, "4 3")
            return
        self.svg.polyline(points, color, 1.8)
        for x, y in points:
            self.svg.dot(x, y, color)

    def dot(self, a, b, color):
        self.svg.dot(self.x(a), self.y(b), color, 3.2)


def heading(svg, title, subtitle):
    svg.text(20, 28, title, 17, weight="bold")
    svg.text(20, 48, subtitle, 12, color="#444")


def finish(svg, report, entries, panels, columns, x_label, file_name):
    """The label of the x axes, the legend, the command."""
    rows = (panels + columns - 1) // columns
    width = LEFT + columns * (WIDTH + GAP_X)
    y = TOP + 20 + rows * (HEIGHT + GAP_Y) - 26
    svg.text(LEFT, y, x_label, 11, color="#444")
    y += 28
    for i, (color, label, guide) in enumerate(entries):
        x, line = LEFT + (i % columns) * (WIDTH + GAP_X), y + 19 * (i // columns)
        svg.line(x, line - 4, x + 22, line - 4, color, 1.2 if guide else 4, "4 3" if guide else "")
        svg.text(x + 29, line, label, 12)
    y += 19 * ((len(entries) - 1) // columns) + 26
    for line in textwrap.wrap(report["command"], 130, subsequent_indent="    "):
        svg.text(20, y, line, 10.5, color="#666")
        y += 15
    svg.write(file_name, width, y + 6)


def log_star(n):
    """The largest h with log^(h) n >= 1."""
    h = 0
    while n > 1 and math.log2(n) >= 1:
        n, h = math.log2(n), h + 1
    return h


def log_ticks(low, high):
    ticks = [t * 10**e for e in range(-4, 6) for t in (1, 2, 5)]
    first = max(i for i, t in enumerate(ticks) if t <= low)
    last = min(i for i, t in enumerate(ticks) if t >= high)
    return ticks[first:last + 1]


def linear_ticks(high, number=5):
    """From 0 in steps of 1, 2 or 5 times a power of ten."""
    step = next(t for t in log_ticks(1e-3, 1e4) if t * number >= high)
    return [round(step * i, 6) for i in range(math.ceil(high / step - 1e-9) + 1)]


def size_ticks(results):
    """The powers of four, and what there is besides."""
    sizes = sorted({r["size"] for r in results})
    return sizes[::2] if len(sizes) > 6 and len(sizes) % 2 == 1 else sizes


def draw_locations(report, file_name):
    svg, surfaces = Svg(), by_surface(report)
    heading(svg, "Cells entered to locate a point", "per point, traces not counted; paper's random order, except for "
            "plain CGAL; both axes logarithmic")
    values = [w["cells_entered"] for r in report["results"] for w in r["locations"].values()]
    ticks = log_ticks(min(values), max(values))
    for index, (surface, results) in enumerate(surfaces.items()):
        axes = Axes(svg, index, 3, surface, size_ticks(report["results"]), ticks, "xy")
        sizes = [r["size"] for r in results]
        axes.curve([(n, math.log2(n)) for n in sizes], "#666", guide=True)
        axes.curve([(n, log_star(n)) for n in sizes], "#bbb", guide=True)
        for way in reversed(WAYS):
            axes.curve([(r["size"], r["locations"][way]["cells_entered"]) for r in results], WAYS[way][0])
    entries = [(color, label, False) for color, label in WAYS.values()]
    entries += [("#666", "log2 n", True), ("#bbb", "log* n", True)]
    finish(svg, report, entries, len(surfaces), 3, "points", file_name)


def draw_crossings(report, file_name):
    svg, surfaces = Svg(), by_surface(report)
    heading(svg, "Crossings of a trace per point",
            "triangles of D(S_{N_h}) that T goes through / n; Theorem 3: constant")
    most = max(t["crossings_per_point"] for r in report["results"] for t in r["traces"])
    rounds = max(len(r["traces"]) for r in report["results"])
    for index, (surface, results) in enumerate(surfaces.items()):
        axes = Axes(svg, index, 3, surface, size_ticks(report["results"]), linear_ticks(most), "x")
        for h in range(rounds):
            axes.curve([(r["size"], r["traces"][h]["crossings_per_point"]) for r in results if h < len(r["traces"])],
                       COLORS[h])
    finish(svg, report, [(COLORS[h], f"trace at N_{h + 1}", False) for h in range(rounds)], len(surfaces), 3, "points",
           file_name)


def draw_rounds(report, file_name):
    svg, surfaces = Svg(), by_surface(report)
    heading(svg, "Location inside a round",
            "nodes entered per point by a descent from the last trace, from the root in round 1; one dot per size")
    rows = [(row["iterated_log"], row["history-trace"]) for r in report["results"] for row in r["rounds"]]
    x_ticks, y_ticks = linear_ticks(max(x for x, _ in rows)), linear_ticks(max(y for _, y in rows))
    for index, (surface, results) in enumerate(surfaces.items()):
        axes = Axes(svg, index, 3, surface, x_ticks, y_ticks, x_name="{:g}".format)
        for r in results:
            for h, row in enumerate(r["rounds"]):
                axes.dot(row["iterated_log"], row["history-trace"], COLORS[h])
    rounds = max(len(r["rounds"]) for r in report["results"])
    finish(svg, report, [(COLORS[h], f"round {h + 1}", False) for h in range(rounds)], len(surfaces), 3,
           "log2 iterated h times, of n", file_name)


CHANGES = {"none": "#000000", "jitter": "#0072b2", "decimated": "#d00000",
           "random spanning tree of F": "#009e73", "random edges": "#e69f00"}


def draw_hypothesis(report, file_name):
    svg, surfaces = Svg(), {}
    for row in report["hypothesis"]:
        surfaces.setdefault(row["surface"], []).append(row)
    heading(svg, "When T is not Delaunay", "crossings per trace and point, mean of the traces; y logarithmic, what is "
            "below 0.1 (0 on the sphere) drawn at 0.1")
    drawn = lambda row: max(0.1, mean_crossings(row))
    values = [drawn(row) for row in report["hypothesis"]]
    ticks = log_ticks(min(values), max(values))
    for index, (surface, rows) in enumerate(surfaces.items()):
        axes = Axes(svg, index, 2, f'{surface}, {rows[0]["points"]} points', [0, 0.2, 0.4, 0.6, 0.8, 1], ticks, "y",
                    "{:g}".format)
        for row in rows:
            axes.dot(row["assumptions"]["subgraph_edges_delaunay"], drawn(row), CHANGES[row["change"]])
    finish(svg, report, [(color, change, False) for change, color in CHANGES.items()], len(surfaces), 2,
           "share of the edges of T that are Delaunay", file_name)


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
