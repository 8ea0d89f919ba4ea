#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Puts what measure_sources wrote as tables on the manual's page on where surfaces come from; needs nothing but Python.

  source_tables.py results/sources*.json --tables
  source_tables.py results/sources*.json --manual Sources.txt [--check]

Blocks: sources and source_times, with machine and command.
"""

import math

import manual_tables
from manual_tables import commands_of, machine_of, table


def percent(share, whole):
    """A share of what is not whole must not be rounded to 100 %."""
    if whole:
        return "100 %"
    return f"{math.floor(share * 1000) / 10:.1f} %" if share > 0.999 else f"{share * 100:.1f} %"


def thousands(number):
    return f"{number:,}".replace(",", " ")


def held_by(result):
    """The vertices of the triangulation that is left at the end, and how many of them have weights."""
    held = result.get("held")
    return [thousands(held["vertices"]), thousands(held["weighted"])] if held else ["–", "–"]


def sources(results):
    rows = []
    for r in results:
        names = [r["consumer"], r.get("made_from", "skipped")]
        if "skipped" in r:
            rows.append(names + ["–"] * 7)
            continue
        rows.append(names + [thousands(r["vertices"]), percent(r["triangles_delaunay"], r["other_triangles"] == 0),
                             percent(r["edges_delaunay"], r["edges_delaunay"] == 1), str(r["largest_degree"]),
                             "yes" if r["contains_emst"] else "no, " + percent(r["emst_edges_in_surface"], False),
                             *held_by(r)])
    return table(["source", "made of", "points", "triangles Delaunay", "edges Delaunay", "largest degree", "EMST in F",
                  "held", "weighted"], rows, 2)


def times(results):
    rows = [[r["consumer"], r["made_from"], f'{r["median_plain_cpu"]:.3f}', f'{r["median_ours_cpu"]:.3f}',
             f'{r["median_ratio"]:.2f}', f'{r["plain_destroyed"]:.1f}',
             f'{r["ours_destroyed"]:.1f}', f'{r["cells"] / r["vertices"]:.1f}']
            for r in results if "skipped" not in r]
    return table(["source", "made of", "plain CGAL, CPU s", "this package, CPU s", "gain",
                  "cells destroyed, plain CGAL", "this package", "cells of D(S)"], rows, 2)


def all_blocks(reports):
    """{name: text} of all that the manual shows."""
    results = [result for report in reports for result in report["results"]]
    loads = [report["machine"]["load_before"] for report in reports]
    return {"sources": sources(results),
            "source_times": times(results),
            "sources_machine": f"{machine_of(reports[0])}. Load average before the runs: {min(loads):.1f} to "
                               f"{max(loads):.1f}.",
            "sources_command": commands_of(*reports)}


if __name__ == "__main__":
    manual_tables.fill_from_results(__doc__, all_blocks, "measure_sources")
