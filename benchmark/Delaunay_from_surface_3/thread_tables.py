#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Puts what measure_threads wrote as tables on the manual's page on threads; needs nothing but Python.

  thread_tables.py results/threads*.json --tables
  thread_tables.py results/threads*.json --manual Threads.txt [--check]

Blocks: times, phases, rollbacks, machine, and commands; parts of calls and memory if they were measured.
"""

import math

import manual_tables
from manual_tables import cell, commands_of, machine_of, table


def numbers_of(row, prefix):
    return [key for key in row if key.startswith(prefix)]


def time_blocks(rows):
    times, phases, gains = [], [], {}
    for row in rows:
        measured = row["times"]
        one = measured["threads_1"]["median_wall"]
        for key in numbers_of(measured, "threads_"):
            ours, parts = measured[key]["median_wall"], measured[key]["phases"]
            gains.setdefault(key, []).append(one / ours)
            times.append([row["surface"], row["points"], key.split("_")[1], f"{ours:.3f}", f"{one / ours:.2f}",
                          f'{measured["plain"]["median_wall"] / ours:.2f}',
                          f'{measured["plain_parallel"]["median_wall"] / ours:.2f}', parts["clashes"]])
            phases.append([row["surface"], row["points"], key.split("_")[1]] +
                          [f"{parts[name]:.3f}" for name in ("plan", "insertion", "finish")])
    for key, values in gains.items():
        mean = math.exp(sum(map(math.log, values)) / len(values))
        times.append(["geometric mean", "", key.split("_")[1], "", f"{mean:.2f}", "", "", ""])
    titles = ["surface", "points", "threads", "seconds", "one thread / this", "plain CGAL / this",
              "Parallel_tag of CGAL / this", "clashes"]
    return {"thread_times": table(titles, [[cell(v) for v in r] for r in times], 1),
            "thread_phases": table(["surface", "points", "threads", "plan", "insertion", "export and rest"],
                                   [[cell(v) for v in r] for r in phases], 1)}


def rollback_block(rows):
    keys = numbers_of(rows[0]["rolled_back"], "workers_")
    lines = [[row["surface"], row["points"]] +
             [f'{1000 * sum(row["rolled_back"][key]) / row["points"]:.2f}' for key in keys] for row in rows]
    titles = ["surface", "points"] + [key.split("_")[1] + " workers" for key in keys]
    return {"rollbacks": table(titles, [[cell(v) for v in line] for line in lines], 1)}


PARTS = ["read", "plan", "permute", "insertion", "vertices", "cells", "links", "rest"]


def part_block(rows):
    lines = []
    for row in rows:
        for key in numbers_of(row["parts"], "threads_"):
            parts = row["parts"][key]
            lines.append([row["surface"], row["points"], key.split("_")[1]] +
                         [f"{parts.get(part, 0):.3f}" for part in PARTS] + [f"{sum(parts.values()):.3f}"])
    titles = ["surface", "points", "threads", *PARTS, "together"]
    return {"thread_parts": table(titles, [[cell(v) for v in line] for line in lines], 1)}


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
    return {**time_blocks(rows_with("times")),
            **(part_block(rows_with("parts")) if rows_with("parts") else {}),
            **(memory_block(rows_with("memory")) if rows_with("memory") else {}),
            **rollback_block(rows_with("rolled_back")),
            "machine": f"{machine_of(reports[0])}. Load average before the runs: {loads}.",
            "command": commands_of(*reports)}


if __name__ == "__main__":
    manual_tables.fill_from_results(__doc__, all_blocks, "measure_threads")
