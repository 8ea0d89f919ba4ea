#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Draws what compare_with_plain measured as SVG files, which needs Matplotlib, and fills the tables of the manual,
which needs nothing but Python.

  plot_results.py results/compare_*.json --output-dir fig
  plot_results.py results/compare_*.json --tables
  plot_results.py results/compare_*.json --manual Performance.txt Performance_tables.txt [--check]

Of several JSON files the results are put together. Drawn are
  performance_before_and_now.svg  where plain CGAL's time goes, and where the default's
  performance_ratio.svg           time of plain CGAL / time of a method, by the number of points and by surface
  performance_phases.svg          where the time of all methods goes
  performance_cells.svg           cells that walks entered, per point, against the number of points
"""

import argparse
import math
import os

import manual_tables
from result_tables import all_blocks
from results import PHASES, cells_entered, label_of, method_of, methods_that_walk, microseconds, read, \
    size_name, used_methods

MOST = 6  # series of a plot

# Phases as they are drawn: colour, label, and those that are put together.
SHOWN_PHASES = (("#bdbdbd", "input and output", ("input_and_output",)),
                ("#f0e442", "order and subgraph", ("plan", "subgraph")),
                ("#d55e00", "trace", ("trace",)),
                ("#56b4e9", "location", ("location",)),
                ("#0072b2", "update", ("update",)),
                ("#009e73", "export", ("finish",)))


def shown_phases(parts):
    """[(colour, µs)]"""
    return [(color, sum(parts[name] for name in names)) for color, _, names in SHOWN_PHASES]


def stacked_bar(axes, y, parts, height):
    left = 0
    for color, value in parts:
        axes.barh(y, value, height, left, color=color)
        left += value
    # On a ground of its own, so that no line goes through it.
    beside(axes, left, y, f"{left:.1f}", 4, bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.5})


def beside(axes, x, y, text, pixels, **keywords):
    """Text to the right of a place, or to the left if there are less than 0 pixels between."""
    axes.annotate(text, (x, y), (pixels, 0), textcoords="offset points", va="center", annotation_clip=False,
                  ha="left" if pixels > 0 else "right", fontsize=12, **keywords)


def largest_with_phases(by_size, *methods):
    """The result of the largest size at which all these have phases; None without."""
    found = [r for r in by_size.values() if all("phases" in (method_of(r, m) or {}) for m in methods)]
    return found[-1] if found else None


def per_point(result, name):
    """µs of CPU time."""
    return method_of(result, name)["median_cpu"] / result["points"] * 1e6


def draw_before_and_now(surfaces, file_name):
    """Plain CGAL's bar has the shares of plain-order, which makes the same insertions."""
    from plot_style import Sheet, lines_along, patch
    found = {surface: largest_with_phases(by_size, "plain-order", "default") for surface, by_size in surfaces.items()}
    found = {surface: result for surface, result in found.items() if result}
    if not found:
        return
    height, step = 44 * len(found), 44
    sheet = Sheet(height + 110)
    axes = sheet.axes(270, 12, 540, height)
    lines_along(axes, "x")
    for i, (surface, result) in enumerate(found.items()):
        before, now = ((name, microseconds(method_of(result, name), result["points"]))
                       for name in ("plain-order", "default"))
        scale = per_point(result, "plain") / per_point(result, before[0])
        for y, label, parts in ((step * i + 12, "plain CGAL", {p: scale * v for p, v in before[1].items()}),
                                (step * i + 30, "default", now[1])):
            stacked_bar(axes, y, shown_phases(parts), 15)
            beside(axes, 0, y, label, -6)
        beside(axes, 0, step * i + 21, f'{surface}, {size_name(result["size"])}', -90, fontweight="bold")
    axes.set(ylim=(height, 0), yticks=[])
    axes.set_xlabel("microseconds per point")
    axes.spines["left"].set_visible(False)
    sheet.legend([patch(color, label) for color, label, names in SHOWN_PHASES if names != ("trace",)], 270, 12, 3)
    sheet.write(file_name)


def draw_ratio_by_size(axes, surfaces):
    """The default, on surfaces of several sizes."""
    from plot_style import COLORS, MARKERS, lines_along, size_ticks
    curves = {}
    for surface, by_size in surfaces.items():
        curve = [(n, method_of(r, "default")["ratio_plain_to_method"]) for n, r in by_size.items()
                 if n and method_of(r, "default")]
        if len(curve) > 1:
            curves[surface] = curve
    chosen = sorted(curves, key=lambda name: -len(curves[name]))[:MOST]
    for name, color, marker in zip(chosen, COLORS, MARKERS):
        axes.plot(*zip(*curves[name]), color=color, marker=marker, label=name)
    lines_along(axes, "y")
    axes.axhline(1, color="#222222", linewidth=1)
    sizes = sorted({n for name in chosen for n, _ in curves[name]})
    if sizes:
        size_ticks(axes, sizes)
        axes.legend(loc="upper left", bbox_to_anchor=(0, -0.17), ncol=2)
    axes.set_ylim(0, math.ceil(1.04 * max([1] + [r for name in chosen for _, r in curves[name]])))
    axes.set(title="the default, by number of points", xlabel="points (logarithmic)")


RATIO_METHODS = {"default": ("#d00000", "o", "the default: both"),
                 "compact-spatial": ("#0072b2", "s", "compact triangulation alone: any points"),
                 "nets": ("#e69f00", "^", "order of the surface alone, CGAL's insertion"),
                 "tetgen": ("#2e8b57", "D", "TetGen")}


def size_of_most_methods(surfaces):
    """At which most is known of the methods of RATIO_METHODS."""
    known = {}
    for by_size in surfaces.values():
        for n, result in by_size.items():
            known[n] = known.get(n, 0) + sum(method_of(result, m) is not None for m in RATIO_METHODS)
    return max(known, key=lambda n: (known[n], n))


def draw_ratio_by_surface(axes, surfaces):
    from plot_style import lines_along
    size = size_of_most_methods(surfaces)
    found = {surface: by_size[size] for surface, by_size in surfaces.items() if size in by_size}
    for name, (color, marker, label) in RATIO_METHODS.items():
        dots = [(method_of(result, name)["ratio_plain_to_method"], i) for i, result in enumerate(found.values())
                if method_of(result, name)]
        if dots:
            axes.plot(*zip(*dots), color=color, marker=marker, linestyle="", markersize=7, label=label)
    lines_along(axes, "both")
    axes.axvline(1, color="#222222", linewidth=1)
    axes.set(ylim=(len(found) - 0.4, -0.6), yticks=range(len(found)), yticklabels=list(found),
             title=f"by surface, {size_name(size)} points", xlabel="time of plain CGAL / time of the method")
    axes.set_xlim(0, None)
    axes.legend(loc="upper left", bbox_to_anchor=(-0.3, -0.17), ncol=1)


def draw_ratio(surfaces, file_name):
    from plot_style import Sheet
    sheet = Sheet(470)
    draw_ratio_by_size(sheet.axes(46, 32, 330, 290), surfaces)
    draw_ratio_by_surface(sheet.axes(532, 32, 312, 290), surfaces)
    sheet.write(file_name)


def draw_phases(surfaces, file_name):
    """At the largest size of up to three surfaces of which both the default and the paper's order are known."""
    from plot_style import Sheet, lines_along, patch
    wanted = {surface: largest_with_phases(by_size, "default", "tracing", "nets")
              for surface, by_size in surfaces.items()}
    found = list({surface: r for surface, r in wanted.items() if r}.items())[:3]
    if not found:
        return
    names = [m for m in used_methods(surfaces) if any("phases" in (method_of(r, m) or {}) for _, r in found)]
    height = 24 * max(len(names), 4)
    sheet = Sheet(height + 118)
    for i, (surface, result) in enumerate(found):
        axes = sheet.axes(176 + 230 * i, 32, 198, height)
        lines_along(axes, "x")
        for y, name in enumerate(names):
            method = method_of(result, name)
            if "phases" in (method or {}):
                stacked_bar(axes, y, shown_phases(microseconds(method, result["points"])), 0.7)
        axes.axvline(per_point(result, "plain"), color="#222222", linewidth=1.5)
        if i == 0:
            beside(axes, per_point(result, "plain"), 1, "plain CGAL", 5)
        axes.set(ylim=(len(names) - 0.4, -0.6), yticks=range(len(names)),
                 yticklabels=names if i == 0 else [], title=f'{surface}, {size_name(result["size"])} points',
                 xlim=(0, 1.18 * max(per_point(result, m) for m in names if method_of(result, m))))
        axes.set_xlabel("microseconds per point")
    sheet.legend([patch(color, label) for color, label, _ in SHOWN_PHASES], 176, 12, 3)
    sheet.write(file_name)


def draw_cells(surfaces, file_name):
    """On surfaces of three sizes or more."""
    from plot_style import MARKERS, Sheet, enclosing, grid_height, line, lines_along, size_ticks, ticks
    left_out = ("plain-fast", "geometric-neighbor", "geometric-previous")
    methods = [m for m in methods_that_walk(surfaces) if m not in left_out][:MOST]
    curves = {}
    for surface, by_size in surfaces.items():
        found = {m: [(n, cells_entered(method_of(r, m))) for n, r in by_size.items()
                     if n and "location" in (method_of(r, m) or {}).get("predicates", {})] for m in methods}
        if max((len(curve) for curve in found.values()), default=0) > 2:
            curves[surface] = found
    if not curves:
        return
    known = [value for found in curves.values() for curve in found.values() for _, value in curve]
    y_ticks = enclosing([digit * 10**e for e in range(-1, 5) for digit in (1, 2, 5)], known)
    columns = min(len(curves), 2)
    sheet = Sheet(grid_height(columns, columns, 3, height=212))
    for axes, (surface, found) in zip(sheet.grid(columns, columns, height=212), curves.items()):
        for name, marker in zip(methods, MARKERS):
            if found[name]:
                axes.plot(*zip(*found[name]), color=label_of(name)[0], marker=marker)
        lines_along(axes, "y")
        size_ticks(axes, sorted({n for curve in found.values() for n, _ in curve}))
        ticks(axes.yaxis, y_ticks, log=True)
        axes.set(title=surface, xlabel="points (logarithmic)", ylim=(y_ticks[0] / 1.2, y_ticks[-1]))
    sheet.legend([line(label_of(m)[0], label_of(m)[1], k) for m, k in zip(methods, MARKERS)], 52, 12, 2)
    sheet.write(file_name)


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
            draw(surfaces, os.path.join(arguments.output_dir, f"performance_{name}.svg"))


if __name__ == "__main__":
    main()
