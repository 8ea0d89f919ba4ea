#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Puts what measure_subgraphs wrote as tables on the manual's page on subgraphs, which needs nothing but Python, and
draws the times as subgraph_times.svg, which needs Matplotlib.

  subgraph_tables.py results/subgraph_*.json --output-dir fig
  subgraph_tables.py results/subgraph_*.json --tables
  subgraph_tables.py results/subgraph_*.json --manual bounded_degree_subgraphs.txt [--check]

The tables, as far as the files hold them:
  bounds   degrees beside their bounds, on surfaces of all kinds
  degrees  degrees by genus, with both kinds of cut
  times    times and memory
  near_minimum, near_minimum_times, near_minimum_meshes
           trees of nearly minimum degree
"""

import argparse
import os
import re

import manual_tables
from manual_tables import cell, commands_of, machine_of, table


def bounds_row(row):
    return [row["surface"], row["bound_of_the_paper"], row["bound"], row["maximum_degree"], row["bound_of_tree"],
            row["maximum_degree_of_tree"]]


def degrees_row(row):
    cells = [row["genus"], row["bound_of_the_paper"], row["bound"], row["bound_of_tree"]]
    for cut in ("cut_graph", "loops"):
        found = row.get(cut)
        cells += [found["maximum_degree"], f'{100 * found["share_above_3"]:.4f} %',
                  found["maximum_degree_of_tree"]] if found else [None] * 3
    return cells


def times_row(row):
    n = f'{row["vertices"]:,}'.replace(",", " ")
    cells = [f'{row["surface"]}, {row["order"]}', n]
    cells += [round(row[what]["nanoseconds_per_vertex"]) for what in ("subgraph", "tree", "cut_graph")]
    cells += [f'{row["subgraph"]["bytes_per_vertex"]:.1f}', row["subgraph"]["maximum_degree"]]
    for what in ("minimum_spanning_tree", "depth_first_tree"):
        found = row.get(what)
        cells += [round(found["nanoseconds_per_vertex"]), found["maximum_degree"]] if found else [None] * 2
    return cells


def family_row(row):
    least = max(row["least_degree_by_witness"], row.get("least_degree", 0))
    return [row["surface"], row["genus"], row["bound_of_the_paper"], row["maximum_degree_of_subgraph"],
            row["maximum_degree_of_tree"], row["maximum_degree"], row["bound"], least or None]


def exchanges_row(row):
    n = f'{row["vertices"]:,}'.replace(",", " ")
    return [row["surface"], n, row["vertices_of_degree_4_or_more"], row["maximum_degree_of_tree"], row["maximum_degree"],
            row["exchanges_nearby"], row["phases"], round(row["nanoseconds_per_vertex_of_tree"]),
            round(row["nanoseconds_per_vertex_of_exchanges"])]


def near_minimum_blocks(report):
    found = report["near_minimum"]
    families = table(["surface", "genus", "paper's bound", "subgraph", "tree", "nearly minimum", "bound", "any tree, at least"],
                     [[cell(value) for value in family_row(row)] for row in found["families"]], 1)
    times = table(["surface", "n", "of degree 4 and more", "tree", "nearly minimum", "exchanges nearby", "phases",
                   "tree, ns per vertex", "exchanges, ns per vertex"],
                  [[cell(value) for value in exchanges_row(row)] for row in found["times"]], 1)
    meshes = found["meshes"]
    degrees = range(max(len(meshes["meshes_of_degree_of_tree"]), len(meshes["meshes_of_degree"])))
    rows = [[name, *(str((found["meshes"][key] + [0] * len(degrees))[d]) for d in degrees if d > 1)]
            for name, key in (("tree", "meshes_of_degree_of_tree"), ("nearly minimum", "meshes_of_degree"))]
    return {"near_minimum": families,
            "near_minimum_times": times,
            "near_minimum_meshes": f'Meshes of %CGAL\'s demos by the largest degree of their trees; {meshes["closed"]} are '
                                   f'closed, {meshes["with_boundary"]} have boundary, and {meshes["refused"]} are refused:\n\n'
                                   + table(["degree", *(str(d) for d in degrees if d > 1)], rows, 1),
            "command_of_near_minimum": commands_of(report)}


TABLES = {  # how a row is made, the titles, how many columns are text
    "bounds": (bounds_row, ["surface", "paper's bound", "bound", "observed", "tree's bound", "tree, observed"], 1),
    "degrees": (degrees_row, ["genus", "paper's bound", "bound", "tree's bound", "subgraph", "above 3", "tree",
                              "loops: subgraph", "above 3", "tree"], 0),
    "times": (times_row, ["surface, order of its vertices", "n", "subgraph", "tree", "cut graph", "bytes", "degree",
                          "Kruskal", "degree", "depth-first", "degree"], 1),
}


def machine(report):
    return f'{machine_of(report)}. Load average before the run: {report["machine"]["load_before"]:.1f}.'


def all_blocks(reports):
    """{name: text} of all that the manual shows."""
    blocks = {}
    for report in reports:
        for key, (row_of, titles, texts) in TABLES.items():
            if report.get(key):
                rows = [[cell(value) for value in row_of(row)] for row in report[key]]
                blocks[key] = table(titles, rows, texts)
                blocks[f"command_of_{key}"] = re.sub(r" --plot \S+", "", commands_of(report))  # it drew once
                if key == "times":
                    blocks["machine"] = machine(report)
        if "near_minimum" in report:
            blocks.update(near_minimum_blocks(report))
    return blocks


def draw_times(times, file_name):
    from plot_style import COLORS, MARKERS, Sheet, line, lines_along, ticks
    curves = {}
    for row in times:
        curves.setdefault(f'{row["surface"]}, {row["order"]}', []).append(
            (row["vertices"], row["subgraph"]["nanoseconds_per_vertex"]))
    sheet = Sheet(360)
    axes = sheet.axes(52, 30, 560, 270)
    for curve, color, marker in zip(curves.values(), COLORS, MARKERS):
        axes.plot(*zip(*curve), color=color, marker=marker)
    lines_along(axes, "y")
    sizes = sorted({n for curve in curves.values() for n, _ in curve})
    ticks(axes.xaxis, [10**e for e in range(2, 9) if sizes[0] / 1.5 < 10**e < 1.5 * sizes[-1]],
          lambda n: f"{round(n):,}".replace(",", " "), log=True)
    axes.set_xlim(sizes[0] / 1.2, sizes[-1] * 1.2)
    axes.set_ylim(0, None)
    axes.set(title="nanoseconds per vertex", xlabel="vertices (logarithmic)")
    sheet.legend([line(color, name, marker) for name, color, marker in zip(curves, COLORS, MARKERS)], 640, 200, 1)
    sheet.write(file_name)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", metavar="JSON", help="what measure_subgraphs wrote")
    parser.add_argument("--output-dir", metavar="FOLDER", help="draw; where the SVG file goes")
    manual_tables.add_options(parser)
    arguments = parser.parse_args()
    reports = [manual_tables.read(name) for name in arguments.files]
    manual_tables.serve(arguments, all_blocks(reports))
    times = [row for report in reports for row in report["times"]]
    if arguments.output_dir and times:
        draw_times(times, os.path.join(arguments.output_dir, "subgraph_times.svg"))


if __name__ == "__main__":
    main()
