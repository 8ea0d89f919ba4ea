#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Puts what measure_threads wrote as tables on the manual's page on threads; needs nothing but Python.

  thread_tables.py results/threads*.json --tables
  thread_tables.py results/threads*.json --manual Threads.txt [--check]

Blocks: times, phases, rollbacks, machine, and commands; parts of calls, what they let more threads gain, and memory if
they were measured.
"""

import manual_tables
from manual_tables import cell, commands_of, machine_of, table
from order_tables import geometric_mean


def numbers_of(row, prefix):
    return [key for key in row if key.startswith(prefix)]


def time_blocks(reports):
    times, phases, means = [], [], []
    for rows in reports:
        gains = {}
        for row in rows:
            measured = row["times"]
            for key in numbers_of(measured, "threads_"):
                ours, parts = measured[key]["median_wall"], measured[key]["phases"]
                ratios = [measured[other]["median_wall"] / ours for other in ("threads_1", "plain", "plain_parallel")]
                gains.setdefault(key, []).append(ratios)
                times.append([row["surface"], row["points"], key.split("_")[1], f"{ours:.3f}",
                              *(f"{ratio:.2f}" for ratio in ratios), parts["clashes"]])
                phases.append([row["surface"], row["points"], key.split("_")[1]] +
                              [f"{parts[name]:.3f}" for name in ("plan", "insertion", "finish")])
        if len(rows) > 1:
            means += [[f"geometric mean of {len(rows)}", round(rows[0]["points"], -3), key.split("_")[1], "",
                       *(f"{geometric_mean(column):.2f}" for column in zip(*ratios)), ""]
                      for key, ratios in gains.items()]
    titles = ["surface", "points", "threads", "seconds", "one thread / this", "plain CGAL / this",
              "Parallel_tag of CGAL / this", "clashes"]
    return {"thread_times": table(titles, [[cell(v) for v in r] for r in times + means], 1),
            "thread_phases": table(["surface", "points", "threads", "plan", "insertion", "export and rest"],
                                   [[cell(v) for v in r] for r in phases], 1)}


def rollback_block(rows):
    keys = numbers_of(rows[0]["rolled_back"], "workers_")
    lines = [[row["surface"], row["points"]] +
             [f'{1000 * sum(row["rolled_back"][key]) / row["points"]:.2f}' for key in keys] for row in rows]
    titles = ["surface", "points"] + [key.split("_")[1] + " workers" for key in keys]
    return {"rollbacks": table(titles, [[cell(v) for v in line] for line in lines], 1)}


PARTS = ["read", "plan", "permute", "insertion", "vertices", "cells", "links", "rest"]
DIVIDED = {"insertion": ["insertion"], "export": ["vertices", "cells", "links"]}  # what threads share evenly
OTHERS = {"read and plan": ["read", "plan"], "rest": ["permute", "rest"]}


def part_blocks(rows):
    lines, shares = [], []
    for row in rows:
        measured = {int(key.split("_")[1]): row["parts"][key] for key in numbers_of(row["parts"], "threads_")}
        for threads, parts in measured.items():
            lines.append([row["surface"], row["points"], threads] +
                         [f"{parts.get(part, 0):.3f}" for part in PARTS] + [f"{sum(parts.values()):.3f}"])
        for threads in (1, 2, 4, 8, 16):
            parts = seconds_of_groups(measured, threads)
            together = sum(parts.values())
            shares.append([row["surface"], threads, "measured" if threads in measured else "calculated",
                           *(f"{100 * part / together:.0f}" for part in parts.values()), f"{together:.3f}",
                           f"{sum(measured[1].values()) / together:.2f}"])
    return {"thread_parts": table(["surface", "points", "threads", *PARTS, "together"],
                                  [[cell(v) for v in line] for line in lines], 1),
            "thread_shares": table(["surface", "threads", "", *(f"{name} %" for name in {**DIVIDED, **OTHERS}),
                                    "seconds", "one thread / this"], [[cell(v) for v in line] for line in shares], 1)}


def seconds_of_groups(measured, threads):
    """Measured; or by Amdahl's law from two threads: what they share goes on being divided, the others stay."""
    parts, less = (measured[threads], 1) if threads in measured else (measured[2], 2 / threads)
    return {name: sum(parts.get(part, 0) for part in members) * (less if name in DIVIDED else 1)
            for name, members in {**DIVIDED, **OTHERS}.items()}


def memory_block(rows):
    lines = []
    for row in rows:
        memory = row["memory"]
        for key in numbers_of(memory, "threads_"):
            peak = memory[key]["peak_bytes"]
            lines.append([row["surface"], row["points"], key.split("_")[1], f"{peak / 2**20:.0f}",
                          f'{memory[key]["peak_above_input_per_point"]:.0f}',
                          f'{peak / memory["threads_1"]["peak_bytes"]:.2f}'])
    titles = ["surface", "points", "threads", "peak in MiB", "bytes per point above the input",
              "this / one thread"]
    return {"thread_memory": table(titles, [[cell(v) for v in line] for line in lines], 1)}


def all_blocks(reports):
    """{name: text} of all that the manual shows."""
    rows = [row for report in reports for row in report["results"]]

    def rows_with(what):
        return [row for row in rows if row.get(what)]

    loads = ", ".join(f'{report["machine"]["load_before"]:.1f}' for report in reports)
    times = [[row for row in report["results"] if row.get("times")] for report in reports]
    return {**time_blocks(sorted((rows for rows in times if rows), key=lambda rows: rows[0]["points"])),
            **(part_blocks(rows_with("parts")) if rows_with("parts") else {}),
            **(memory_block(rows_with("memory")) if rows_with("memory") else {}),
            **rollback_block(rows_with("rolled_back")),
            "machine": f"{machine_of(reports[0])}. Load average before the runs: {loads}.",
            "command": commands_of(*reports)}


if __name__ == "__main__":
    manual_tables.fill_from_results(__doc__, all_blocks, "measure_threads")
