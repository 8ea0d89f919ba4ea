#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Draws the bar chart of times for the readme, from what compare_with_plain and measure_threads wrote. Needs
Matplotlib.

  plot_times.py results/compare_1M.json results/threads_1M.json --surface elephant --output times.svg

Shown are seconds per million points of one surface of about a million points, as both programs have sizes of their
own. The last file is what counts. What only another file has is shown by its ratio to plain CGAL there, as no two runs
find a machine equally quiet. What was measured on another machine is left out, and said on the standard error.
"""

import argparse
import json
import sys

METHODS = {  # from the slowest to the fastest, as a rule
    "tetgen": "TetGen",
    "geogram": "Geogram",
    "hxt": "HXT",
    "plain": "CGAL",
    "plain_parallel": "CGAL, Parallel_tag, {threads} threads",
    "default": "this package",
    "threads": "this package, {threads} threads"}
OURS = ("default", "threads")
THREADS = 2


def of_comparison(result):
    """Methods that use one thread: {method: seconds of CPU time}"""
    return {m["method"]: m["median_cpu"] for m in result["methods"] if "left_out" not in m}


def of_threads(result):
    """{method: seconds that passed}"""
    times = result["times"]
    names = {"plain": "plain", "plain_parallel": "plain_parallel", "default": "threads_1",
             "threads": f"threads_{THREADS}"}
    peers = [peer for peer in result.get("peers", []) if "left_out" not in peer]
    return {**{name: times[key]["median_wall"] for name, key in names.items() if key in times},
            **{peer["method"]: peer.get("median_wall", peer["median_cpu"]) for peer in peers}}


def machine_of(report):
    return report["machine"]["cpu"], report["machine"]["cores"], report["machine"]["cgal"]


def seconds_per_million(reports, surface):
    """{method: seconds}, and those of another file than the last"""
    found, scaled = {}, []
    for report in reports:
        if machine_of(report) != machine_of(reports[-1]):
            print(f"plot_times.py: left out, as it is of another machine or CGAL: {report['command'][:60]} ...",
                  file=sys.stderr)
            continue
        for result in report["results"]:
            if result["surface"] == surface and 9e5 < result["points"] < 1.2e6:
                times = of_threads(result) if "times" in result else of_comparison(result)
                times = {name: time / result["points"] * 1e6 for name, time in times.items()}
                scale = times["plain"] / found["plain"] if found else 1
                found = {**{name: scale * time for name, time in found.items()}, **times}
                scaled = [name for name in METHODS if name in found and name not in times]
    if not found:
        sys.exit(f"plot_times.py: there is no {surface} of about a million points")
    return {name: found[name] for name in METHODS if name in found}, scaled


def draw(reports, surface, file_name):
    """Readable where a page is 420 pixels wide: so it is drawn for."""
    from plot_style import Sheet
    times, scaled = seconds_per_million(reports, surface)
    sheet = Sheet(62 + 46 * len(times) + (60 if scaled else 42), 420)
    sheet.text(14, 12, f"{surface.capitalize()}, a million points: seconds", fontweight="bold", fontsize=15)
    axes = sheet.axes(14, 44, 352, 46 * len(times))
    most = max(times.values())
    for y, (name, seconds) in enumerate(times.items()):
        axes.barh(y + 0.2, seconds, 0.42, color="#e07b00" if name in OURS else "#8b9bb0")
        axes.text(0, y - 0.23, METHODS[name].format(threads=THREADS), va="center", fontsize=14)
        axes.text(seconds + 0.012 * most, y + 0.2, f"{seconds:.2f}", va="center", fontsize=14, fontweight="bold")
    axes.set(xlim=(0, most), ylim=(len(times) - 0.5, -0.5))
    axes.set_axis_off()
    machine = reports[-1]["machine"]
    compiler = machine["compiler"].replace("GNU C++ version", "g++")
    notes = [f'CGAL {machine["cgal"]}, {compiler}, -O3', f'{machine["cpu"]}, {machine["cores"]} cores']
    if scaled:
        notes.append(f'{", ".join(METHODS[name] for name in scaled)}: of another run, by the ratio to CGAL')
    sheet.text(14, sheet.height - 8 - 18 * len(notes), "\n".join(notes), fontsize=12, color="#555555", linespacing=1.4)
    sheet.write(file_name)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", metavar="JSON", help="what was measured")
    parser.add_argument("--surface", default="elephant", help="which one to show")
    parser.add_argument("--output", required=True, metavar="FILE", help="the SVG file")
    arguments = parser.parse_args()
    reports = []
    for name in arguments.files:
        with open(name, encoding="utf-8") as file:
            reports.append(json.load(file))
    draw(reports, arguments.surface, arguments.output)


if __name__ == "__main__":
    main()
