# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The table of the benchmark's README: what each file of results shows, and the command that made it."""

import re

from manual_tables import cpu_of, table

SHOWS = {
    "calls_256k": "single calls: time, user and system time, page faults, peak; `before`: the revision before points alone had "
                  "spaced rounds",
    "calls_1M": "the same for a million points",
    "single_calls": "the same for small meshes, also after a rest, in which the host takes memory back",
    "demo_meshes": "the 143 meshes of `libcgal-demo`, one by one",
    "small_meshes": "instructions for those of less than 3,000 vertices",
    "threads_64k": "one and two threads, plain CGAL, `Parallel_tag`",
    "threads_256k": "the same",
    "threads_1M": "the same",
    "threads_4M": "the same",
    "threads_parts": "the parts of a call, by one thread and by two",
    "threads_memory": "peak memory with 1, 2 and 16 threads",
    "threads_simulated": "insertions withdrawn with 2 to 64 simulated workers",
    "compare_peers": "Geogram, HXT and TetGen against one thread and two",
    "compare_clusters": "the same for a million points alone that cluster",
    "compare_64k": "all methods: times, phases, counts, memory, the yardstick",
    "compare_256k": "times only",
    "compare_1M": "times, counts, memory",
    "compare_4M": "times only",
    "paper_64k": "from plain CGAL's order to the paper's, by phases",
    "paper_256k": "the same",
    "paper_1M": "the same",
    "orders": "CAD solids and surfaces that are hard for an order, 3,000 and 20,000 points",
    "orders_200k": "the same, 200,000 points",
    "orders_walks": "tori, tubes, boxes: where walks can go astray",
    "nets_200k": "cells destroyed by nets of the surface, under three rules, and by spaced rounds",
    "nets_256k": "times of both: `default` and `compact-nets`",
    "nets_4M": "the same for four million points, each call in a process of its own, by the last revision (9e2d602) whose `default` "
               "was nets, with faces: `points` had spaced rounds",
    "flat_and_far": "points on thin sheets, far away, in a plane or on a line; which stage of the arithmetic decides",
    "consumers": "uses, from the points to the end; built with CGAL 6.0.1, which COLMAP's advancing front requires",
    "sources": "surfaces of CGAL's packages: how much is Delaunay, EMST, cells, times",
    "python": "the Python module against SciPy and VTK",
    "python_threads": "its times on one and two threads, by the number of points; import, wheel",
    "python_peers": "the same against bindings of other libraries; rebuilds of points that move",
    "python_faults": "tetrahedra that these, a function of Open3D, SciPy and VTK miss, or that overlap",
    "python_gaussians": "`triangulate()` of points of Gaussians",
    "gaussians_2M": "points of Gaussians, against the loop of Tetra-NeRF",
    "gaussians_5M": "the same",
    "gaussians_10M": "the same",
    "moved": "rebuilds of points that move a little, against plain CGAL and Geogram",
    "history": "instructions, page faults and bytes of a call, revision by revision",
    "phases": "the instructions of a call, phase by phase",
    "compile_time": "a file with one call, by g++ and clang, time and memory",
    "parts": "the parts of openfoam-examples: inside or not, and why not",
    "tiles": "what tiles keep, tell and take",
    "tiles_load": "the messages that tiles would send if each were on a machine of its own",
    "tiles_load_2M": "the same for two million points",
    "out_of_core": "a hundred million points out of core: seconds of CPU, memory, disk",
    "mpi": "tiles by MPI: times and the share of exchange, one rank and two, as many points and more",
    "tiles_peers": "the same against tess2 and MadVoro, also on a grid, duplicates and an exact sphere; whose results are right",
    "tiles_peers_1M": "the same for a million points, against tess2",
    "location_costs": "the paper's theorems: locations, traces, crossings, by sizes",
    "location_costs_genus_50": "the same on genus 50; ended before its largest size",
    "total_work": "the total work of the paper's Q, by parts, sizes and seeds",
    "subgraphs_traced": "which subgraph is traced; histories side by side",
    "subgraphs_traced_4k": "the same, also of marching cubes",
    "uniform_samples": "degrees on samples, thinned samples as rounds",
    "subgraph_bounds": "degrees and their bounds",
    "subgraph_degrees": "degrees by genus",
    "subgraph_near_minimum": "trees of nearly minimum degree",
    "subgraph_meshes": "the same for each mesh of `libcgal-demo`",
    "subgraph_parts": "the same for each part of openfoam-examples",
    "subgraph_times": "times and memory of subgraphs",
}
COMMANDS = {"demo_meshes": "scripts/check_meshes build/data/meshes --repetitions 9 --least-vertices 3000 --json FILE"}


def command_of(name, report):
    """Without the name of the output, and of what it is told of other programs."""
    text = re.sub(r" (--output|-o) \S+", "", COMMANDS.get(name) or report["command"])
    text = re.sub(r" --peers( \S+=\S+)+", "", text)
    text = re.sub(r" --peer ('[^']*'|\S+)", "", text).replace("--data-dir meshes", "").replace("--cache-dir surfaces", "")
    return re.sub(" +", " ", re.sub(r"(\S+\.off )+", "MESHES ", text)).strip()


def machine(report):
    if not isinstance(report.get("machine"), dict):
        return "–"
    return f'{cpu_of(report).split()[1]} {report["machine"].get("date", "")}'.strip()


def list_of_results(*reports):
    found = {report["name"]: report for report in reports}
    return table(["`results/`", "what it shows", "command", "machine"],
                 [[f"[{name}](results/{name}.json)", shows, f"`{command_of(name, found[name])}`", machine(found[name])]
                  for name, shows in SHOWS.items()], 4)
