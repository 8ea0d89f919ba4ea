# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""What compare_with_plain measured, as plot_results.py and its tables look at it."""

import json
import sys

METHODS = {  # colour and label; the order is that of the legends and tables
    "plain": ("#000000", "CGAL's insert(first, last)"),
    "plain-fast": ("#555555", "insert(first, last), Fast_location"),
    "default": ("#d00000", "Surface_insertion_traits_3 (default)"),
    "default-fast": ("#7d0000", "default, Fast_location"),
    "compact-spatial": ("#b8860b", "plain CGAL's order, compact triangulation"),
    "nets": ("#ff9d9d", "nets of the surface, CGAL's insertion"),
    "plain-order": ("#8a8a8a", "Plain_insertion_traits_3 (control)"),
    "plain-sse2-max": ("#b0b0b0", "plain CGAL with CGAL_USE_SSE2_MAX"),
    "tetgen": ("#2e8b57", "TetGen"),
    "hxt": ("#6a3d9a", "HXT"),
    "geogram": ("#1f9e89", "Geogram"),
    "geometric-started": ("#0072b2", "geometric rounds, last neighbour"),
    "geometric-neighbor": ("#56b4e9", "geometric rounds, nearest neighbour"),
    "geometric-previous": ("#009e73", "geometric rounds, previous point"),
    "geometric-traced": ("#e69f00", "geometric rounds, traced"),
    "tracing-hilbert": ("#cc79a7", "the paper's rounds, sorted, traced"),
    "tracing": ("#7a3b00", "Tracing_traits_3 (the paper)"),
}
PAPER = ("geometric-started", "geometric-neighbor", "geometric-previous", "geometric-traced", "tracing-hilbert",
         "tracing")
PHASES = {
    "input_and_output": ("#bdbdbd", "input and output"),
    "plan": ("#f0e442", "plan"),
    "subgraph": ("#e69f00", "subgraph and numbering"),
    "trace": ("#d55e00", "trace"),
    "location": ("#56b4e9", "location"),
    "update": ("#0072b2", "update"),
    "finish": ("#009e73", "export"),
}


def size_name(n):
    """16384 -> 16k, 1048576 -> 1M: the sizes are powers of two."""
    return "as it is" if n == 0 else f"{n / 2**20:g}M" if n >= 2**20 else f"{n / 2**10:g}k"


def read(file_names):
    """The reports, and {surface: {size: result}} of compare_with_plain. Of a method measured twice the first file has
    it."""
    reports, surfaces = [], {}
    for name in file_names:
        with open(name, encoding="utf-8") as file:
            reports.append(json.load(file))
        for result in reports[-1]["results"] if is_of_compare(reports[-1]) else []:
            known = surfaces.setdefault(result["surface"], {}).setdefault(result["size"], result)
            names = {method["method"] for method in known["methods"]}
            known["methods"] += [m for m in result["methods"] if m["method"] not in names]
            if "total" not in known.get("yardstick", {}):
                known["yardstick"] = result.get("yardstick", {})
    if not surfaces:
        sys.exit("plot_results.py: there are no results in the files given")
    return reports, {name: dict(sorted(sizes.items())) for name, sizes in surfaces.items()}


def is_of_compare(report):
    return report["program"] == "compare_with_plain"


def method_of(result, name):
    """None if it was not measured."""
    return next((m for m in result["methods"] if m["method"] == name and "left_out" not in m), None)


def used_methods(surfaces):
    """In the order of METHODS; peers that are not listed there come last."""
    names = {m["method"] for sizes in surfaces.values() for r in sizes.values() for m in r["methods"]}
    return [name for name in METHODS if name in names] + sorted(names - set(METHODS))


def peers(result):
    """Those that ran."""
    return [m for m in result["methods"] if "command" in m and "left_out" not in m]


def label_of(name):
    return METHODS.get(name, ("#999999", name))


def cells_entered(method):
    calls = method["predicates"]
    return calls["location"]["cells_entered"] + calls["trace"]["cells_entered"]


def methods_that_walk(surfaces):
    """Those of CGAL's walks, which are counted; plain CGAL's are those of plain-order."""
    walk = {m["method"] for sizes in surfaces.values() for r in sizes.values() for m in r["methods"]
            if "location" in m.get("predicates", {}) and m["method"] != "default"}
    return [name for name in METHODS if name in walk]


def microseconds(method, points):
    """CPU time per point by phase: the metered run's shares of the unmetered median."""
    if "phases" not in method:
        return {}
    seconds = method["phases"]["seconds"]
    scale = method["median_cpu"] / method["phases"]["wall"] * 1e6 / points
    return {phase: seconds[phase] * scale for phase in PHASES}


def without_export(method):
    return method["stages"]["plan"] + method["stages"]["build"]
