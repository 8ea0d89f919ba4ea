#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Prints what measure_subgraphs wrote as the tables of the manual's page; needs nothing but Python.

  print_subgraph_tables.py results/subgraph_*.json

Printed are, as far as the files hold them,
  degrees beside their bounds, on surfaces of all kinds
  degrees by genus, with both kinds of cut
  times and memory
"""

import argparse
import json


def print_table(columns, rows):
    print("| " + " | ".join(columns) + " |")
    print("|---|" + "--:|" * (len(columns) - 1))
    for row in rows:
        print("| " + " | ".join("–" if cell is None else str(cell) for cell in row) + " |")
    print()


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


TABLES = {
    "bounds": (bounds_row, ["surface", "paper's bound", "bound", "observed", "tree's bound", "tree, observed"]),
    "degrees": (degrees_row, ["genus", "paper's bound", "bound", "tree's bound", "subgraph", "above 3", "tree",
                              "loops: subgraph", "above 3", "tree"]),
    "times": (times_row, ["surface, order of its vertices", "n", "subgraph", "tree", "cut graph", "bytes", "degree",
                          "Kruskal", "degree", "depth-first", "degree"]),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", metavar="JSON", help="what measure_subgraphs wrote")
    for name in parser.parse_args().files:
        with open(name, encoding="utf-8") as file:
            report = json.load(file)
        for key, (row_of, columns) in TABLES.items():
            if report.get(key):
                print_table(columns, [row_of(row) for row in report[key]])


if __name__ == "__main__":
    main()
