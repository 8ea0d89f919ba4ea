#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Puts what inside_of_parts.py wrote as a table into the manual; needs nothing but Python.

  part_tables.py results/parts.json --tables
  part_tables.py results/parts.json --manual Delaunay_from_surface_3.txt [--check]

Blocks: parts_counts and parts.
"""

import manual_tables
from manual_tables import table

KINDS = {"open edges": "open", "edges with two faces in the same direction": "turned",
         "edges with more than two faces": "more than two"}


def short(path):
    """The folder of the case, and the file."""
    parts = path.removesuffix(".gz").split("/")
    case = [p for p in parts[:-1] if p not in ("constant", "triSurface", "geometry", "resources")][-1:]
    return "/".join([*case, parts[-1]])


def numbers(row):
    return [str(row["edges"][kind]["number"]) if kind in row["edges"] else "0" for kind in KINDS]


def where(row):
    return next((row["edges"][kind]["first"].split(" at ")[1] for kind in KINDS if kind in row["edges"]), "–")


def percent(share):
    return f"{100 * share:.2f}"


def all_blocks(reports):
    """{name: text} of all that the manual shows."""
    rows = [row for report in reports for row in report["results"]]
    of = {kind: [row for row in rows if row["inside"] == kind] for kind in ("closed mesh", "winding numbers", "none")}
    # The same part may lie in several cases.
    unique = {}
    for row in of["winding numbers"]:
        unique.setdefault((row["file"].split("/")[-1], row["faces"]), row)
    text = (f'Of {len(rows)} files {len(of["closed mesh"])} are closed, {len(of["winding numbers"])} have an inside by winding '
            f'numbers, and {len(of["none"])} are open patches and have none. Those in the middle, each part once:')
    lines = [[f"`{short(row['file'])}`", str(row["faces"]), *numbers(row), where(row), percent(row["openings"]), percent(row["in_doubt"])]
             for row in unique.values()]
    result = table(["part", "faces", "edges that are open", "turned", "with more faces than two", "the first at",
                    "openings, % of the area", "tetrahedra in doubt, %"], lines, 1)
    return {"parts_counts": text, "parts": result}


if __name__ == "__main__":
    manual_tables.fill_from_results(__doc__, all_blocks, "inside_of_parts.py")
