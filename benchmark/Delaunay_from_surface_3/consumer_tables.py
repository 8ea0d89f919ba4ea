#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Puts what measure_consumers and measure_python.py wrote as tables on the manual's page on gains by use; needs nothing
but Python.

  consumer_tables.py results/{consumers,python}.json --tables
  consumer_tables.py results/{consumers,python}.json --manual Consumers.txt [--check]

Blocks: consumers and python, each with its machine and command.
"""

import manual_tables
from manual_tables import cell, commands_of, machine_of, table


def gains(report, other, title):
    rows = [[r["consumer"], f'{r["points"]:,}'.replace(",", " "), f'{r[f"median_{other}_cpu"]:.3f}',
             f'{r["median_ours_cpu"]:.3f}', f'{r["median_ratio"]:.2f}'] for r in report["results"]]
    return table(["what is done", "points", f"{title}, CPU s", "this package, CPU s", "gain"],
                 [[cell(v) for v in row] for row in rows])


def all_blocks(reports):
    """{name: text} of all that the manual shows."""
    consumers = next(report for report in reports if "machine" in report)
    python = next(report for report in reports if "scipy" in report)
    return {"consumers": gains(consumers, "plain", "plain CGAL"),
            "consumers_machine": f'{machine_of(consumers)}. Load average before the run: '
                                 f'{consumers["machine"]["load_before"]:.1f}.',
            "consumers_command": commands_of(consumers),
            "python": gains(python, "scipy", "SciPy"),
            "python_versions": f'Python {python["python"]}, NumPy {python["numpy"]}, SciPy {python["scipy"]}.',
            "python_command": commands_of(python)}


if __name__ == "__main__":
    manual_tables.fill_from_results(__doc__, all_blocks, "measure_consumers and measure_python.py")
