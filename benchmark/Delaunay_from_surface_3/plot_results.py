#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Draws what compare_with_stock measured as SVG files; needs nothing but Python.

  plot_results.py results/compare_with_stock.json --output-dir fig

Of several JSON files the results are put together. Written are
  performance_ratio.svg   time of stock / time of a method, against the number of points
  performance_phases.svg  where the time goes, at the largest size of every surface
  performance_cells.svg   cells that walks entered, per point, against the number of points
"""

import argparse
import html
import json
import math
import os
import sys
import textwrap

METHODS = {  # colour and label; the order is that of the legends
    "stock": ("#000000", "CGAL's insert(first, last)"),
    "default": ("#d00000", "Surface_insertion_traits_3 (default)"),
    "nets": ("#ff9d9d", "nets of the surface, CGAL's insertion"),
    "stock-order": ("#8a8a8a", "Stock_order_traits_3 (control)"),
    "geometric-started": ("#0072b2", "geometric rounds, last neighbour"),
    "geometric-neighbor": ("#56b4e9", "geometric rounds, nearest neighbour"),
    "geometric-previous": ("#009e73", "geometric rounds, previous point"),
    "geometric-traced": ("#e69f00", "geometric rounds, traced"),
    "tracing-hilbert": ("#cc79a7", "the paper's rounds, sorted, traced"),
    "tracing": ("#7a3b00", "Tracing_traits_3 (the paper)"),
}
PHASES = {
    "input_and_output": ("#bdbdbd", "input and output"),
    "plan": ("#f0e442", "plan"),
    "subgraph": ("#e69f00", "subgraph and numbering"),
    "trace": ("#d55e00", "trace"),
    "location": ("#56b4e9", "location"),
    "update": ("#0072b2", "update"),
    "finish": ("#009e73", "finish, export"),
}
PANEL_WIDTH, PANEL_HEIGHT, COLUMNS = 300, 210, 3
LEFT, TOP, GAP_X, GAP_Y = 58, 92, 50, 66


class Svg:
    """Collects the elements of a drawing."""

    def __init__(self):
        self.parts = []

    def line(self, x1, y1, x2, y2, color="#333", width=1.0, dash=""):
        dash = f' stroke-dasharray="{dash}"' if dash else ""
        self.parts.append(f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" '
                          f'stroke="{color}" stroke-width="{width}"{dash}/>')

    def polyline(self, points, color, width):
        text = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        self.parts.append(f'<polyline points="{text}" fill="none" stroke="{color}" '
                          f'stroke-width="{width}" stroke-linejoin="round"/>')

    def dot(self, x, y, color, radius=2.8):
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" fill="{color}"/>')

    def rect(self, x, y, width, height, color):
        self.parts.append(f'<rect x="{x:.1f}" y="{y:.1f}" width="{max(width, 0):.1f}" '
                          f'height="{height:.1f}" fill="{color}"/>')

    def text(self, x, y, text, size=12, anchor="start", weight="normal", color="#222", turn=False):
        turned = f' transform="rotate(-90 {x:.1f} {y:.1f})"' if turn else ""
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" text-anchor="{anchor}" '
                          f'font-weight="{weight}" fill="{color}"{turned}>{html.escape(text)}</text>')

    def write(self, file_name, width, height):
        with open(file_name, "w", encoding="utf-8") as file:
            file.write(f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
                       f'viewBox="0 0 {width} {height}" font-family="DejaVu Sans, Helvetica, sans-serif">\n')
            file.write('<rect width="100%" height="100%" fill="#fff"/>\n')
            file.write("\n".join(self.parts) + "\n</svg>\n")


def size_name(n):
    """16384 -> 16k, 1048576 -> 1M: the sizes are powers of two."""
    return f"{n / 2**20:g}M" if n >= 2**20 else f"{n / 2**10:g}k"


def read(file_names):
    """The reports, and {surface: {size: result}} over all of them."""
    reports, surfaces = [], {}
    for name in file_names:
        with open(name, encoding="utf-8") as file:
            reports.append(json.load(file))
        for result in reports[-1]["results"]:
            surfaces.setdefault(result["surface"], {})[result["size"]] = result
    if not surfaces:
        sys.exit("plot_results.py: there are no results in the files given")
    return reports, {name: dict(sorted(sizes.items())) for name, sizes in surfaces.items()}


def method_of(result, name):
    return next((m for m in result["methods"] if m["method"] == name), None)


def used_methods(surfaces):
    names = {m["method"] for sizes in surfaces.values() for r in sizes.values() for m in r["methods"]}
    return [name for name in METHODS if name in names]


def methods_that_walk(surfaces):
    """Those whose walks are counted: stock's are those of stock-order, and the default's own kernel has none."""
    return [name for name in used_methods(surfaces) if name not in ("stock", "default")]


def heading(svg, title, subtitle, reports):
    machine = reports[0]["machine"]
    svg.text(20, 28, title, 17, weight="bold")
    svg.text(20, 48, subtitle, 12, color="#444")
    flags = " ".join(machine["flags"].split())
    svg.text(20, 66, f'CGAL {machine["cgal"]}, {machine["compiler"]}, {flags}; '
             f'{machine["cpu"]}, {machine["cores"]} cores, shared; {machine["date"]}', 11, color="#666")


def legend_and_commands(svg, entries, reports, y):
    """Three entries to a line, then the commands; returns where the drawing ends."""
    for i, (color, label) in enumerate(entries):
        x = LEFT + (i % COLUMNS) * (PANEL_WIDTH + GAP_X)
        svg.rect(x, y - 9 + 19 * (i // COLUMNS), 22, 10, color)
        svg.text(x + 29, y + 19 * (i // COLUMNS), label, 12)
    y += 19 * ((len(entries) - 1) // COLUMNS) + 28
    for report in reports:
        for line in textwrap.wrap(report["command"], 170, subsequent_indent="    "):
            svg.text(20, y, line, 10.5, color="#666")
            y += 15
    return y


class Panel:
    """The axes of one surface: sizes along x (logarithmic), values along y."""

    def __init__(self, svg, index, sizes, y_range, y_ticks, y_log=False):
        self.svg, self.sizes, self.y_log = svg, sizes, y_log
        self.x0 = LEFT + (index % COLUMNS) * (PANEL_WIDTH + GAP_X)
        self.y0 = TOP + 20 + (index // COLUMNS) * (PANEL_HEIGHT + GAP_Y)
        self.low, self.high = (math.log(v) for v in y_range) if y_log else y_range
        for tick in y_ticks:
            stock = tick == 1 and not y_log
            svg.line(self.x0, self.y(tick), self.x0 + PANEL_WIDTH, self.y(tick), "#555" if stock else "#e3e3e3",
                     dash="5 3" if stock else "")
            svg.text(self.x0 - 6, self.y(tick) + 4, f"{tick:g}", 11, "end")
        for n in sizes:
            svg.line(self.x(n), self.y0 + PANEL_HEIGHT, self.x(n), self.y0 + PANEL_HEIGHT + 4)
            svg.text(self.x(n), self.y0 + PANEL_HEIGHT + 18, size_name(n), 11, "middle")
        svg.line(self.x0, self.y0 + PANEL_HEIGHT, self.x0 + PANEL_WIDTH, self.y0 + PANEL_HEIGHT)
        svg.line(self.x0, self.y0, self.x0, self.y0 + PANEL_HEIGHT)

    def x(self, n):
        first, last = math.log(self.sizes[0]), math.log(self.sizes[-1])
        share = (math.log(n) - first) / (last - first) if last > first else 0.5
        return self.x0 + 12 + share * (PANEL_WIDTH - 24)

    def y(self, value):
        value = math.log(value) if self.y_log else value
        return self.y0 + PANEL_HEIGHT * (1 - (value - self.low) / (self.high - self.low))

    def title(self, text):
        self.svg.text(self.x0, self.y0 - 9, text, 13, weight="bold")

    def curve(self, points, color):
        points = [(self.x(n), self.y(v)) for n, v in points]
        self.svg.polyline(points, color, 1.8)
        for x, y in points:
            self.svg.dot(x, y, color)


def curves(reports, surfaces, value_of, title, subtitle, y_range, y_ticks, y_log, methods, file_name):
    """One panel per surface, one curve per method."""
    svg = Svg()
    heading(svg, title, subtitle, reports)
    sizes = sorted({n for by_size in surfaces.values() for n in by_size})
    for index, (surface, by_size) in enumerate(surfaces.items()):
        panel = Panel(svg, index, sizes, y_range, y_ticks, y_log)
        panel.title(surface)
        for name in reversed(methods):
            points = [(n, value_of(method_of(r, name))) for n, r in by_size.items() if method_of(r, name)]
            panel.curve(points, METHODS[name][0])
    rows = (len(surfaces) + COLUMNS - 1) // COLUMNS
    y = TOP + 20 + rows * (PANEL_HEIGHT + GAP_Y)
    svg.text(LEFT, y - 26, "points (logarithmic)", 11, color="#444")
    y = legend_and_commands(svg, [METHODS[m] for m in methods], reports, y + 8)
    svg.write(file_name, LEFT + COLUMNS * (PANEL_WIDTH + GAP_X), y + 6)


def cells_entered(method):
    calls = method["predicates"]
    return calls["location"]["cells_entered"] + calls["trace"]["cells_entered"]


def values(surfaces, methods, value_of):
    return [value_of(method_of(r, name)) for by_size in surfaces.values() for r in by_size.values()
            for name in methods if method_of(r, name)]


def draw_ratio(reports, surfaces, file_name):
    methods = [m for m in used_methods(surfaces) if m != "stock"]
    ratio = lambda method: method["ratio_stock_to_method"]
    top = math.ceil(10 * max([1.1] + values(surfaces, methods, ratio))) / 10
    step = 0.2 if top < 1.6 else 0.5
    ticks = [round(step * i, 1) for i in range(int(top / step + 1e-9) + 1)]
    curves(reports, surfaces, ratio, "How fast, compared with CGAL's insert(first, last)",
           f'median CPU time of stock / median CPU time of the method, {reports[0]["repetitions"]} alternating '
           "repetitions; above 1: faster than stock", (0, top), ticks, False, methods, file_name)


def draw_cells(reports, surfaces, file_name):
    methods = methods_that_walk(surfaces)
    found = values(surfaces, methods, cells_entered)
    ticks = [t for e in range(-1, 5) for t in (10**e, 2 * 10**e, 5 * 10**e)]
    ticks = ticks[max(i for i, t in enumerate(ticks) if t <= min(found)):]
    ticks = ticks[:1 + min(i for i, t in enumerate(ticks) if t >= max(found))]
    curves(reports, surfaces, cells_entered, "Cells that walks entered per point, traces included",
           "exact walks, counted with Predicate_counting_traits_3; logarithmic", (ticks[0], ticks[-1]), ticks,
           True, methods, file_name)


def microseconds(method, n):
    """CPU time per point by phase: the metered run's shares of the unmetered median."""
    if "phases" not in method:
        return {}
    seconds = method["phases"]["seconds"]
    scale = method["median_cpu"] / method["phases"]["wall"] * 1e6 / n
    return {phase: seconds[phase] * scale for phase in PHASES}


def draw_phases(reports, surfaces, file_name):
    largest = {name: list(by_size.values())[-1] for name, by_size in surfaces.items()}
    svg = Svg()
    heading(svg, "Where the time goes", "CPU time per point in microseconds, by phase, at the largest size measured; "
            "the phases of stock cannot be seen from outside", reports)
    bar, label_width, y = 15, 250, TOP
    width = 2 * (PANEL_WIDTH + GAP_X) + 20
    longest = max(m["median_cpu"] / r["points"] * 1e6 for r in largest.values() for m in r["methods"])
    for surface, result in largest.items():
        methods = [name for name in used_methods(surfaces) if method_of(result, name)]
        svg.text(20, y + 8, f'{surface}, {size_name(result["size"])} points', 13, weight="bold")
        step = 2 if longest > 8 else 1
        for tick in range(0, int(longest) + step, step):
            x = label_width + tick / longest * width
            if tick <= longest:
                svg.line(x, y + 16, x, y + 20 + 20 * len(methods), "#e3e3e3")
                svg.text(x, y + 34 + 20 * len(methods), f"{tick}", 11, "middle")
        for i, name in enumerate(methods):
            method = method_of(result, name)
            x, y_bar = label_width, y + 20 + 20 * i
            svg.text(label_width - 8, y_bar + 12, METHODS[name][1].split(" (")[0], 11, "end")
            total = method["median_cpu"] / result["points"] * 1e6
            parts = microseconds(method, result["points"])
            if not parts:
                svg.rect(x, y_bar, total / longest * width, bar, "#666")
            for phase, value in parts.items():
                svg.rect(x, y_bar, value / longest * width, bar, PHASES[phase][0])
                x += value / longest * width
            svg.text(label_width + total / longest * width + 6, y_bar + 12, f"{total:.2f}", 11)
        y += 20 * len(methods) + 62
    entries = [("#666", "stock, all phases")] + list(PHASES.values())
    y = legend_and_commands(svg, entries, reports, y + 16)
    svg.write(file_name, LEFT + COLUMNS * (PANEL_WIDTH + GAP_X), y + 6)


def print_tables(surfaces):
    """The ratios and the cells entered at every size, as the tables of the manual."""
    methods = [m for m in used_methods(surfaces) if m != "stock"]
    print("| surface | points | stock, CPU s | " + " | ".join(methods) + " |")
    print("|---|--:|--:|" + "--:|" * len(methods))
    for surface, by_size in surfaces.items():
        for n, result in by_size.items():
            ratios = [f'{method_of(result, m)["ratio_stock_to_method"]:.2f}' if method_of(result, m) else "–"
                      for m in methods]
            print(f'| {surface} | {size_name(n)} | {method_of(result, "stock")["median_cpu"]:.3f} | '
                  + " | ".join(ratios) + " |")
    methods = methods_that_walk(surfaces)
    print("\n| surface | points | " + " | ".join(methods) + " |")
    print("|---|--:|" + "--:|" * len(methods))
    for surface, by_size in surfaces.items():
        for n, result in by_size.items():
            cells = [f"{cells_entered(method_of(result, m)):.1f}" if method_of(result, m) else "–" for m in methods]
            print(f"| {surface} | {size_name(n)} | " + " | ".join(cells) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", metavar="JSON", help="what compare_with_stock wrote")
    parser.add_argument("--output-dir", default=".", metavar="FOLDER", help="where the SVG files go")
    parser.add_argument("--tables", action="store_true", help="print tables, draw nothing")
    arguments = parser.parse_args()
    reports, surfaces = read(arguments.files)
    if arguments.tables:
        print_tables(surfaces)
        return
    for name, draw in (("ratio", draw_ratio), ("phases", draw_phases), ("cells", draw_cells)):
        draw(reports, surfaces, os.path.join(arguments.output_dir, f"performance_{name}.svg"))


if __name__ == "__main__":
    main()
