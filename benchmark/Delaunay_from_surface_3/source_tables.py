#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Puts what location_costs --subgraph-sizes counted as a table on the manual's page on where surfaces come from; needs nothing but Python.

  source_tables.py results/subgraphs_traced*.json --tables
  source_tables.py results/subgraphs_traced*.json --manual Sources.txt [--check]

Blocks: sources, with commands.
"""

import math

import manual_tables
from manual_tables import commands_of, table


def percent(share, whole):
    """A share of what is not whole must not be rounded to 100 %."""
    if whole:
        return "100 %"
    return f"{math.floor(share * 1000) / 10:.1f} %" if share > 0.999 else f"{share * 100:.1f} %"


def thousands(number):
    return f"{number:,}".replace(",", " ")


NAMES = {"armadillo": ["scan", "armadillo.off, resized, jitter of 5 % of the edge length"],
         "delaunay-genus-3": ["Mesh_3, surface alone", "implicit function, genus 3"],
         "marching-cubes": ["marching cubes", "smooth sum of waves"],
         "delaunay-marching-cubes": ["`delaunay_marching_cubes()`", "smooth sum of waves"],
         "noise": ["marching cubes", "noise"],
         "delaunay-noise": ["`delaunay_marching_cubes()`", "noise"]}


def all_blocks(reports):
    """{name: text} of all that the manual shows."""
    results = {(r["surface"], r["size"]): r["subgraphs"]["all of F"]["assumptions"] | {"points": r["points"]}
               for report in reports for r in report["subgraphs"]}
    rows = []
    for name, titles in NAMES.items():
        for found in (r for (surface, _), r in sorted(results.items()) if surface == name):
            shares = [found[name] for name in ("surface_triangles_delaunay", "surface_edges_delaunay",
                                               "emst_edges_in_surface")]
            rows.append(titles + [thousands(found["points"])] + [percent(share, share == 1) for share in shares]
                        + [str(found["subgraph_degree"])])
    return {"sources": table(["source", "made of", "points", "triangles Delaunay", "edges Delaunay", "EMST in F",
                              "largest degree"], rows, 2),
            "sources_command": commands_of(*reports)}


if __name__ == "__main__":
    manual_tables.fill_from_results(__doc__, all_blocks, "location_costs --subgraph-sizes")
