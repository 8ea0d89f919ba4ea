#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Draws what compare_with_plain measured as SVG files and fills the tables of the manual; needs nothing
but Python.

  plot_results.py results/compare_*.json --output-dir fig
  plot_results.py results/compare_*.json --tables
  plot_results.py results/compare_*.json --manual Performance.txt Performance_tables.txt [--check]

Of several JSON files the results are put together. Drawn are
  performance_before_and_now.svg  where plain CGAL's time goes, and where the default's
  performance_ratio.svg           time of plain CGAL / time of a method, against the number of points
  performance_phases.svg          where the time of all methods goes
  performance_cells.svg           cells that walks entered, per point, against the number of points
The bars are those of the largest size of every surface at which phases were measured.
"""

import argparse
import math
import os

import manual_tables
from plot_svg import COLUMNS, GAP_X, GAP_Y, LEFT, PANEL_HEIGHT, PANEL_WIDTH, TOP, Panel, Svg, heading, \
    legend_and_commands
from result_tables import all_blocks
from results import PHASES, cells_entered, label_of, method_of, methods_that_walk, microseconds, read, \
    size_name, used_methods


def curves(reports, surfaces, value_of, title, subtitle, y_range, y_ticks, y_log, methods, file_name):
    """One panel per surface, one curve per method; value_of() may give None."""
    svg = Svg()
    heading(svg, title, subtitle, reports)
    sizes = sorted({n for by_size in surfaces.values() for n in by_size if n})
    for index, (surface, by_size) in enumerate(surfaces.items()):
        panel = Panel(svg, index, sizes, y_range, y_ticks, y_log)
        panel.title(surface)
        for name in reversed(methods):
            points = [(n, value_of(method_of(r, name))) for n, r in by_size.items() if n and method_of(r, name)]
            panel.curve([p for p in points if p[1] is not None], label_of(name)[0])
    rows = (len(surfaces) + COLUMNS - 1) // COLUMNS
    y = TOP + 20 + rows * (PANEL_HEIGHT + GAP_Y)
    svg.text(LEFT, y - 26, "points (logarithmic)", 11, color="#444")
    y = legend_and_commands(svg, [label_of(m) for m in methods], reports, y + 8)
    svg.write(file_name, LEFT + COLUMNS * (PANEL_WIDTH + GAP_X), y + 6)


def values(surfaces, methods, value_of):
    found = [value_of(method_of(r, name)) for by_size in surfaces.values() for r in by_size.values()
             for name in methods if method_of(r, name)]
    return [value for value in found if value is not None]


def draw_ratio(reports, surfaces, file_name):
    methods = [m for m in used_methods(surfaces) if m != "plain"]
    ratio = lambda method: method["ratio_plain_to_method"]
    top = math.ceil(2 * max([1.1] + values(surfaces, methods, ratio))) / 2
    ticks = [0.5 * i for i in range(int(2 * top) + 1)]
    curves(reports, surfaces, ratio, "How fast, compared with CGAL's insert(first, last)",
           f'median CPU time of plain CGAL / median CPU time of the method, {reports[0]["repetitions"]} alternating '
           "repetitions; above 1: faster than plain CGAL", (0, top), ticks, False, methods, file_name)


def draw_cells(reports, surfaces, file_name):
    methods = methods_that_walk(surfaces)
    entered = lambda method: cells_entered(method) if "location" in method.get("predicates", {}) else None
    found = values(surfaces, methods, entered)
    if not found:
        return
    ticks = [t for e in range(-1, 5) for t in (10**e, 2 * 10**e, 5 * 10**e)]
    ticks = ticks[max(i for i, t in enumerate(ticks) if t <= min(found)):]
    ticks = ticks[:1 + min(i for i, t in enumerate(ticks) if t >= max(found))]
    curves(reports, surfaces, entered, "Cells that walks entered per point, traces included",
           "exact walks, counted with Predicate_counting_traits_3; logarithmic", (ticks[0], ticks[-1]), ticks,
           True, methods, file_name)


def draw_bars(reports, groups, title, subtitle, entries, file_name):
    """groups: (title, [(label, {phase: µs}, µs in total)]); what has no phases is drawn in one colour."""
    svg = Svg()
    heading(svg, title, subtitle, reports)
    bar, label_width, y = 15, 250, TOP
    width = 2 * (PANEL_WIDTH + GAP_X) + 20
    longest = max((total for _, bars in groups for _, _, total in bars), default=1)
    for name, bars in groups:
        svg.text(20, y + 8, name, 13, weight="bold")
        step = 2 if longest > 8 else 1
        for tick in range(0, int(longest) + 1, step):
            x = label_width + tick / longest * width
            svg.line(x, y + 16, x, y + 20 + 20 * len(bars), "#e3e3e3")
            svg.text(x, y + 34 + 20 * len(bars), f"{tick}", 11, "middle")
        for i, (label, parts, total) in enumerate(bars):
            x, y_bar = label_width, y + 20 + 20 * i
            svg.text(label_width - 8, y_bar + 12, label, 11, "end")
            for phase, value in (parts or {None: total}).items():
                svg.rect(x, y_bar, value / longest * width, bar, PHASES[phase][0] if phase else "#666")
                x += value / longest * width
            svg.text(label_width + total / longest * width + 6, y_bar + 12, f"{total:.2f}", 11)
        y += 20 * len(bars) + 62
    y = legend_and_commands(svg, entries, reports, y + 16)
    svg.write(file_name, LEFT + COLUMNS * (PANEL_WIDTH + GAP_X), y + 6)


def largest_with_phases(by_size, *methods):
    """The result of the largest size at which these (or any) have phases; None without."""
    found = [r for r in by_size.values()
             if all("phases" in (method_of(r, m) or {}) for m in methods)
             and any("phases" in m for m in r["methods"])]
    return found[-1] if found else None


def title_of(surface, result):
    return f'{surface}, {size_name(result["size"])} points'


def draw_phases(reports, surfaces, file_name):
    groups = []
    for surface, by_size in surfaces.items():
        result = largest_with_phases(by_size)
        if result is None:
            continue
        bars = []
        for name in used_methods(surfaces):
            method = method_of(result, name)
            if method and ("phases" in method or name == "plain"):
                bars.append((label_of(name)[1].split(" (")[0], microseconds(method, result["points"]),
                             method["median_cpu"] / result["points"] * 1e6))
        groups.append((title_of(surface, result), bars))
    draw_bars(reports, groups, "Where the time goes", "CPU time per point in microseconds, by phase, at the largest "
              "size measured; the phases of plain CGAL cannot be seen from outside",
              [("#666", "plain CGAL, all phases")] + list(PHASES.values()), file_name)


def draw_before_and_now(reports, surfaces, file_name):
    """Plain CGAL's bar has the shares of plain-order, which makes the same insertions."""
    groups = []
    for surface, by_size in surfaces.items():
        result = largest_with_phases(by_size, "plain-order", "default")
        if result is None:
            continue
        plain, order, ours = (method_of(result, m) for m in ("plain", "plain-order", "default"))
        scale = plain["median_cpu"] / order["median_cpu"]
        before = {phase: scale * value for phase, value in microseconds(order, result["points"]).items()}
        groups.append((title_of(surface, result),
                       [(name, parts, method["median_cpu"] / result["points"] * 1e6)
                        for name, parts, method in (("before: CGAL's insert(first, last)", before, plain),
                                                    ("now: the default", microseconds(ours, result["points"]), ours))]))
    phases = {**PHASES, "plan": (PHASES["plan"][0], "plan: spatial sort before, nets now")}
    draw_bars(reports, groups, "Where the time went before, and where it goes now",
              "CPU time per point in microseconds; plain CGAL's shares are those of the control, which makes the same "
              "insertions", [phases[p] for p in phases if p not in ("trace",)], file_name)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", metavar="JSON", help="what compare_with_plain wrote")
    parser.add_argument("--output-dir", metavar="FOLDER", help="draw; where the SVG files go")
    manual_tables.add_options(parser)
    arguments = parser.parse_args()
    reports, surfaces = read(arguments.files)
    manual_tables.serve(arguments, all_blocks(reports, surfaces))
    if arguments.output_dir:
        for name, draw in (("before_and_now", draw_before_and_now), ("ratio", draw_ratio), ("phases", draw_phases),
                           ("cells", draw_cells)):
            draw(reports, surfaces, os.path.join(arguments.output_dir, f"performance_{name}.svg"))


if __name__ == "__main__":
    main()
