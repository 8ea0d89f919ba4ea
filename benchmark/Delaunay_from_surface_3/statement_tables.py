#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Puts what location_costs --subgraph-sizes, measure_uniform_samples and compare_with_plain measured on the manual's page
of the paper's statements.

  statement_tables.py results/subgraphs_traced*.json results/{uniform_samples,paper_256k}.json --manual Statements.txt
"""

import argparse
import statistics

import manual_tables
from manual_tables import cell, commands_of, machine_of, table
from theory_tables import cells_of_traces, mean_crossings, percent

ORDER = ["subgraph of bounded degree", "minimum spanning forest of F", "a spanning forest of F",
         "Euclidean minimum spanning tree", "all of F"]


def measured(reports):
    """(names, result) for every surface, size and subgraph."""
    for r in sorted((r for report in reports for r in report["subgraphs"]), key=lambda r: (r["surface"], r["size"])):
        for k, name in enumerate(ORDER):
            yield ([r["surface"], str(r["points"])] if k == 0 else ["", ""]) + [name], r["subgraphs"][name]


def traced(reports):
    rows = []
    for names, r in measured(reports):
        found = r["assumptions"]
        rows.append(names + [str(found["subgraph_degree"]), percent(found["subgraph_edges_delaunay"]),
                             percent(found["emst_edges_in_subgraph"]), f"{mean_crossings(r):.2f}",
                             f"{cells_of_traces(r):.2f}"])
    return table(["surface", "points", "T", "degree", "T in D(S)", "EMST in T", "crossings per trace and point",
                  "cells entered per traced point"], rows, 3)


def iso_surfaces(reports):
    """Ordinary marching cubes beside those with Delaunay triangles."""
    results = {(r["surface"], r["size"]): r for report in reports for r in report["subgraphs"]}
    rows = []
    for (name, size), r in sorted(results.items()):
        if "iso_surface" not in r:
            continue
        made = r["iso_surface"]
        chosen = f'{made["loops"]}: {made["other_loops"]} otherwise, {made["failed_loops"]} not Delaunay'
        ordinary = results[name.removeprefix("delaunay-"), size]
        for result, loops, time in ((ordinary, "as the table says", None),
                                    (r, chosen, made["seconds"] / made["plain_seconds"])):
            found = result["subgraphs"]["all of F"]["assumptions"]
            rows.append([result["surface"], str(result["points"]), loops, cell(time, "{:.1f}"),
                         percent(found["surface_triangles_delaunay"]), percent(found["surface_edges_delaunay"]),
                         percent(found["emst_edges_in_surface"]), str(found["subgraph_degree"])]
                        + [f'{mean_crossings(result["subgraphs"][T]):.2f}' for T in ORDER[:3]])
    return table(["surface", "points", "loops", "time, by that of D(S)", "triangles Delaunay", "edges Delaunay", "EMST in F", "degree",
                  "crossings per trace and point: subgraph of bounded degree", "minimum spanning forest",
                  "a spanning forest"], rows, 3)


def located(reports):
    rows = []
    for names, r in measured(reports):
        if names[2] not in ("subgraph of bounded degree", "Euclidean minimum spanning tree"):
            continue
        cells = []
        for way in ("conflicts-trace", "history-trace", "conflicts-root", "history-root"):
            cost = r["locations"][way]
            cells += [f'{cost["cells_entered"]:.1f}', f'{cost["calls"]:.0f}']
        cells += [f'{r["locations"][way]["trace_calls"]:.0f}' for way in ("conflicts-trace", "history-trace")]
        rows.append(names + cells)
    return table(["surface", "points", "T", "conflicts, from the trace: nodes", "calls",
                  "containment, from the trace: nodes", "calls", "conflicts, from the root: nodes", "calls",
                  "containment, from the root: nodes", "calls", "traces with conflict sets: calls", "traces: calls"],
                 rows, 3)


def uniform_samples(report):
    rows = []
    for r in report["samples"]:
        for k, found in enumerate([r["all"], *r["subsets"]]):
            ratio = found["largest_ratio_of_edges"]
            rows.append([r["sample"] if k == 0 else "",
                         "all points" if k == 0 else f'thinned, factor {found["factor"]:g}', str(found["points"]),
                         str(found["surface_largest_degree"]), f'{ratio:.{1 if ratio < 100 else 0}f}',
                         str(found["euler_characteristic"]), str(found["delaunay_largest_degree"]),
                         f'{found["delaunay_mean_degree"]:.1f}'])
    return table(["sample", "", "points", "largest degree on the surface", "longest edge / shortest", "Euler characteristic",
                  "largest degree in D(S)", "mean"], rows, 2)


WAYS = ("nets", "sorted_nets", "uniform", "random_rounds")


def uniform_rounds(report):
    rows = [[r["surface"], str(r["points"]), str(r["rounds"])] +
            [f'{r[way]["cells_destroyed"]:.1f}' + (" *" if r[way]["order_was_replaced"] else "") for way in WAYS]
            for r in report["levels"]]
    means = [statistics.geometric_mean([r[way]["cells_destroyed"] for r in report["levels"]]) for way in WAYS]
    rows.append(["geometric mean", "", ""] + [f"{mean:.1f}" for mean in means])
    return table(["surface", "points", "rounds", "nets", "nets, along Hilbert curves", "uniform subsets",
                  "random rounds"], rows)


ORDERS = {"tracing": ["random, in rounds (the paper)", "trace"],
          "tracing-hilbert": ["the same rounds, each along a Hilbert curve", "trace"],
          "geometric-traced": ["rounds that grow by 8, each in a coherent order (BRIO)", "trace"],
          "geometric-neighbor": ["rounds that grow by 8, each in a coherent order (BRIO)", "nearest neighbour on F"],
          "plain-order": ["BRIO, as %CGAL has it", "point inserted before"],
          "nets": ["nets of the surface", "point named by the nets"]}


def location_and_update(report):
    """What share of the time of CGAL's insertion location is, in the orders of the paper and later."""
    rows = []
    for r in report["results"]:
        methods = {method["method"]: method for method in r["methods"]}
        for k, (name, title) in enumerate(ORDERS.items()):
            phases = methods[name]["phases"]
            trace, location, update = (phases["seconds"][phase] * phases["scale_to_cpu"]
                                       for phase in ("trace", "location", "update"))
            rows.append(([r["surface"], str(r["points"])] if k == 0 else ["", ""]) + title
                        + [f"{trace:.2f}", f"{location:.2f}", f"{update:.2f}",
                           f"{100 * (trace + location) / (trace + location + update):.0f} %"])
    return table(["surface", "points", "order", "start", "traces, CPU s", "location", "update",
                  "share of traces and location"], rows, 4)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", nargs="+",
                        help="what location_costs, measure_uniform_samples and compare_with_plain wrote")
    manual_tables.add_options(parser)
    arguments = parser.parse_args()
    read = [manual_tables.read(name) for name in sorted(arguments.results)]
    reports = [report for report in read if "subgraphs" in report]
    uniform = next(report for report in read if "samples" in report)
    phases = next(report for report in read if "results" in report)
    manual_tables.serve(arguments, {"traced": traced(reports), "located": located(reports),
                                    "iso_surfaces": iso_surfaces(reports),
                                    "command_of_subgraphs": commands_of(*reports),
                                    "uniform_samples": uniform_samples(uniform),
                                    "uniform_rounds": uniform_rounds(uniform),
                                    "command_of_uniform_samples": commands_of(uniform),
                                    "location_and_update": location_and_update(phases),
                                    "machine_of_phases": machine_of(phases) + ".",
                                    "command_of_phases": commands_of(phases)})


if __name__ == "__main__":
    main()
