#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Draws what location_costs counted as SVG files; needs nothing but Python.

  plot_location_costs.py results/location_costs.json --output-dir fig

Written are
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

from plot_svg import Svg
from results import size_name

WAYS = {  # colour and label; the order is that of the legends
    "history-root": ("#7a3b00", "history DAG, from the root"),
    "history-trace": ("#d00000", "history DAG, from the last trace (the paper)"),
    "walk-trace": ("#e69f00", "walk, from the last trace"),
    "walk-neighbor": ("#56b4e9", "walk, from the nearest surface neighbour"),
    "fast-location": ("#009e73", "Fast_location, random order"),
    "stock": ("#000000", "stock: spatial sort, previous point"),
    "walk-random": ("#8a8a8a", "walk, from a random point"),
}
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


def by_surface(results):
    surfaces = {}
    for result in sorted(results, key=lambda r: r["size"]):
        surfaces.setdefault(result["surface"], []).append(result)
    return {name: surfaces[name] for name in sorted(surfaces, key=lambda s: -len(surfaces[s]))}


def size_ticks(results):
    """The powers of four, and what there is besides."""
    sizes = sorted({r["size"] for r in results})
    return sizes[::2] if len(sizes) > 6 and len(sizes) % 2 == 1 else sizes


def draw_locations(report, file_name):
    svg, surfaces = Svg(), by_surface(report["results"])
    heading(svg, "Cells entered to locate a point", "per point, traces not counted; paper's random order, except for "
            "stock; both axes logarithmic")
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
    svg, surfaces = Svg(), by_surface(report["results"])
    heading(svg, "Crossings of a trace per point", "triangles of D(S_{N_h}) that T goes through / n; Theorem 3: constant")
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
    svg, surfaces = Svg(), by_surface(report["results"])
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
    mean = lambda row: max(0.1, sum(t["crossings_per_point"] for t in row["traces"]) / len(row["traces"]))
    values = [mean(row) for row in report["hypothesis"]]
    ticks = log_ticks(min(values), max(values))
    for index, (surface, rows) in enumerate(surfaces.items()):
        axes = Axes(svg, index, 2, f'{surface}, {rows[0]["points"]} points', [0, 0.2, 0.4, 0.6, 0.8, 1], ticks, "y",
                    "{:g}".format)
        for row in rows:
            axes.dot(row["assumptions"]["subgraph_edges_delaunay"], mean(row), CHANGES[row["change"]])
    finish(svg, report, [(color, change, False) for change, color in CHANGES.items()], len(surfaces), 2,
           "share of the edges of T that are Delaunay", file_name)


def table(header, rows):
    print("\n| " + " | ".join(header) + " |\n|---|" + "--:|" * (len(header) - 1))
    for row in rows:
        print("| " + " | ".join(f"{v:.2f}" if isinstance(v, float) else str(v) for v in row) + " |")


def print_tables(report):
    """The figures as the tables of the manual."""
    surfaces, ways = by_surface(report["results"]), list(WAYS)
    table(["surface", "points"] + ways, [
        [name, r["points"]] + [round(r["locations"][way]["cells_entered"], 1) for way in ways]
        for name, results in surfaces.items() for r in (results[0], results[-1])])
    table(["calls: surface", "points"] + ways, [
        [name, r["points"]] + [round(r["locations"][way]["calls"]) for way in ways]
        for name, results in surfaces.items() for r in results[-1:]])
    fits = report["fits"]
    table(["b of the fit", "from the root", "from the trace", "ratio", "from the trace, with traces", "walk from the trace"],
          [[name, f["history-root"]["b"], f["history-trace"]["b"],
            round(f["history-trace"]["b"] / f["history-root"]["b"], 3), f["history-trace"]["with_traces"]["b"],
            f["walk-trace"]["b"]] for name, f in ((name, fits[name]) for name in surfaces)])
    table(["surface", "points", "N_1", "N_2", "N_3", "N_4", "all"], [
        [name, r["points"]] + [float(t["crossings_per_point"]) for t in r["traces"]]
        + ["–"] * (4 - len(r["traces"])) + [sum(t["crossings_per_point"] for t in r["traces"])]
        for name, results in surfaces.items() for r in results if r["size"] >= 2**14])
    table(["surface", "points", "round", "log^(h) n", "points in it", "Lemma 4", "from the trace", "from the root"], [
        [name, r["points"], h + 1, row["iterated_log"], row["points"], row["lemma_4"], row["history-trace"],
         row["history-root"]]
        for name, results in surfaces.items() for r in results[-1:] for h, row in enumerate(r["rounds"])])
    keys = ["subgraph_edges_delaunay", "surface_triangles_delaunay", "emst_edges_in_surface", "emst_edges_in_subgraph",
            "delaunay_cells_per_point", "cells_created_per_point"]
    table(["surface", "points"] + keys, [
        [name, r["points"]] + [f'{r["assumptions"][key]:.4g}' for key in keys]
        for name, results in surfaces.items() for r in (results[0], results[-1])])
    table(["change", "surface", "amount", "Delaunay edges of T", "crossings per trace", "cells per traced point",
           "from the trace"], [
        [h["change"], h["surface"], f'{h["amount"]:g}', f'{h["assumptions"]["subgraph_edges_delaunay"]:.3f}',
         sum(t["crossings_per_point"] for t in h["traces"]) / len(h["traces"]),
         sum(t["cells_entered"] * t["located"] for t in h["traces"]) / sum(t["located"] for t in h["traces"]),
         h["locations"]["history-trace"]["cells_entered"]] for h in report["hypothesis"]])
    table(["seconds: surface", "points", "load"] + ways, [
        [t["surface"], t["points"], t["load_average"]]
        + [f'{t["seconds"][way]["location"] + t["seconds"][way]["trace"]:.2f} + {t["seconds"][way]["update"]:.2f}'
           for way in ways] for t in report["times"]])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", metavar="JSON", help="what location_costs wrote")
    parser.add_argument("--output-dir", default=".", metavar="FOLDER", help="where the SVG files go")
    parser.add_argument("--tables", action="store_true", help="print tables, draw nothing")
    arguments = parser.parse_args()
    with open(arguments.file, encoding="utf-8") as file:
        report = json.load(file)
    if arguments.tables:
        print_tables(report)
        return
    for name, draw in (("locations", draw_locations), ("crossings", draw_crossings), ("rounds", draw_rounds),
                       ("hypothesis", draw_hypothesis)):
        draw(report, os.path.join(arguments.output_dir, f"theory_{name}.svg"))


if __name__ == "__main__":
    main()
