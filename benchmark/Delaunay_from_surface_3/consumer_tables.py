#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Puts what measure_consumers, measure_thinning and measure_python.py wrote as tables on the manual's page on gains by
use; needs nothing but Python.

  consumer_tables.py results/{consumers,thinning,python}.json --tables
  consumer_tables.py results/{consumers,thinning,python}.json --manual Consumers.txt [--check]

Blocks: consumers, thinning and python, each with its machine and command.
"""

import manual_tables
from manual_tables import cell, commands_of, machine_of, table


def gains(report, other, title):
    rows = [[r["consumer"], f'{r["points"]:,}'.replace(",", " "), f'{r[f"median_{other}_cpu"]:.3f}',
             f'{r["median_ours_cpu"]:.3f}', f'{r["median_ratio"]:.2f}']
            for r in report["results"] + report.get("queries", [])]
    return table(["what is done", "points", f"{title}, CPU s", "this package, CPU s", "gain"],
                 [[cell(v) for v in row] for row in rows])


def python_table(report):
    rows = [[r["consumer"], f'{r["points"]:,}'.replace(",", " "), f'{r["median_scipy_cpu"]:.3f}',
             f'{r["median_ours_cpu"]:.3f}', f'{r["median_ratio"]:.2f}',
             f'{r["median_speedup"]:.2f}' if "median_speedup" in r else None]
            for r in report["results"] + report.get("queries", [])]
    return table(["what is done", "points", "SciPy, CPU s", "this package, CPU s", "gain",
                  "one thread / two, by the wall clock"], [[cell(v) for v in row] for row in rows])


def vtk_table(report):
    rows = [[f'{r["points"]:,}'.replace(",", " "), f'{r["median_vtk_cpu"]:.3f}', f'{r["median_ours_cpu"]:.3f}',
             r["tetrahedra_of_vtk"], r["tetrahedra"]] for r in report.get("vtk", [])]
    return table(["points", "VTK, CPU s", "this package, CPU s", "tetrahedra, VTK", "this package"],
                 [[cell(v) for v in row] for row in rows], left=0)


def thinning_table(report):
    number = "{:,}".format
    rows = [[r["consumer"], number(r["points"]).replace(",", " "), number(r["plain_vertices"]).replace(",", " "),
             number(r["ours_vertices"]).replace(",", " "), f'{r["median_plain_cpu"]:.3f}',
             f'{r["median_ours_cpu"]:.3f}', f'{r["median_ratio"]:.2f}'] for r in report["results"]]
    return table(["what is left out", "points", "vertices, plain CGAL", "this package", "plain CGAL, CPU s",
                  "this package, CPU s", "gain"], [[cell(v) for v in row] for row in rows])


def all_blocks(reports):
    """{name: text} of all that the manual shows."""
    by_program = {report["command"].split()[0]: report for report in reports}
    consumers, thinning, python = (by_program[name] for name in
                                   ("measure_consumers", "measure_thinning", "measure_python.py"))
    return {"consumers": gains(consumers, "plain", "plain CGAL"),
            "consumers_machine": f'{machine_of(consumers)}. Load average before the run: '
                                 f'{consumers["machine"]["load_before"]:.1f}.',
            "consumers_command": commands_of(consumers),
            "thinning": thinning_table(thinning),
            "thinning_machine": f'{machine_of(thinning)}. Load average before the run: '
                                f'{thinning["machine"]["load_before"]:.1f}.',
            "thinning_command": commands_of(thinning),
            "python": python_table(python),
            "vtk": vtk_table(python),
            "python_versions": f'Python {python["python"]}, NumPy {python["numpy"]}, SciPy {python["scipy"]}.',
            "python_command": commands_of(python)}


if __name__ == "__main__":
    manual_tables.fill_from_results(__doc__, all_blocks, "measure_consumers, measure_thinning and measure_python.py")
