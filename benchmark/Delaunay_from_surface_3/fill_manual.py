#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Fills what README and manual show of the measured results: the text between <!-- MARKER --> and <!-- end -->, and brings
new results into the form of one_record_per_line.py. Needs nothing but Python. TABLES says which page has which marker, of
which results/*.json, and who writes it.

  fill_manual.py                       fills all pages
  fill_manual.py --check               only says whether they are filled with these results
  fill_manual.py --print MARKER...     prints blocks, of all pages that have them
"""

import argparse
import re
import sys
from pathlib import Path

import kit_tables
import paper_tables
import speed_tables
import use_tables
from manual_tables import cpu_of, read, table, with_caption_below
from one_record_per_line import rewrite

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
README = "README.md"
MAIN_PAGE = "doc/Delaunay_from_surface_3/Delaunay_from_surface_3.txt"
BENCHMARK = "benchmark/Delaunay_from_surface_3/README.md"
PAPER = "doc/Delaunay_from_surface_3/The_paper.txt"
PYTHON = "python/README.md"
NPM = "npm/README.md"
HOW_FAST = "doc/Delaunay_from_surface_3/How_fast.txt"

SHOWS = {  # in the table of the benchmark's README
    "calls_256k": "single calls: time, user and system time, page faults, peak; `before`: the revision before points alone had "
                  "spaced rounds",
    "calls_1M": "the same for a million points",
    "calls_sizes": "the same for one surface in three sizes",
    "calls_digging": "the same before and after digging counted cells where it writes them",
    "calls_pages": "the same before and after small pages are taken many at a time",
    "single_calls": "the same for small meshes, also after a rest, in which the host takes memory back",
    "demo_meshes": "the 143 meshes of `libcgal-demo`, one by one",
    "small_meshes": "instructions for those of less than 3,000 vertices",
    "threads_64k": "one and two threads, plain CGAL, `Parallel_tag`",
    "threads_256k": "the same",
    "threads_1M": "the same",
    "threads_4M": "the same",
    "threads_memory": "peak memory with 1, 2 and 16 threads",
    "threads_simulated": "insertions withdrawn with 2 to 64 simulated workers",
    "critical_path": "instructions of the busiest of 16 threads, and of all, by phases",
    "critical_path_256k": "the same for 1 to 32 threads",
    "threads_16_cores": "one and 16 threads on 16 cores, arrays, HXT and Geogram; before all threads made the order",
    "compare_peers": "single calls of Geogram, HXT, TetGen and plain CGAL by two threads, too",
    "compare_clusters": "the same for a million points alone that cluster",
    "compare_64k": "all methods: times, phases, counts, memory, the yardstick",
    "compare_256k": "times only",
    "compare_1M": "times, counts, memory",
    "compare_4M": "times only",
    "control_64k": "the paper's order and controls, through CGAL's insertion: times",
    "control_256k": "the same",
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
    "weights": "points with weights: filled triangulations, arrays, two threads, beside `Regular_triangulation_3` and Geogram",
    "periodic": "points in a periodic box, beside `Periodic_3_Delaunay_triangulation_3` and Geogram; copies, memory, two threads",
    "consumers": "uses, from the points to the end; built with CGAL 6.0.1, which COLMAP's advancing front requires",
    "spanning_trees": "Euclidean minimum spanning trees beside the triangulation, and beside Kruskal's algorithm over CGAL's edges",
    "sources": "surfaces of CGAL's packages: how much is Delaunay, EMST, cells, times",
    "python": "the Python module against SciPy and VTK",
    "python_threads": "its times on one and two threads, by the number of points; import, wheel",
    "python_peers": "the same against bindings of other libraries; rebuilds of points that move",
    "python_faults": "tetrahedra that these, a function of Open3D, SciPy and VTK miss, or that overlap",
    "python_topology": "filtrations of alpha complexes beside GUDHI's",
    "python_interpolation": "interpolators beside SciPy's",
    "npm": "the npm package beside the same C++ compiled natively: times, sizes",
    "npm_peers": "the same beside other packages: times, wrong tetrahedra",
    "python_learning": "points that move in every step, what changes, and batches, beside SciPy and TetGen",
    "python_materials": "Voronoi cells in a periodic box beside Voro++ and SciPy",
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
    "total_work": "the total work of the paper's Q, by parts, sizes and seeds",
    "sorted_rounds": "the total work of walks and traces, with the paper's rounds in random order and sorted, and of plain CGAL's "
                     "order",
    "insertion_parts": "instructions of plan, location and update through CGAL's insertion: what hints could gain at most",
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
    text = re.sub(r" --peers?( '[^']*'| \S+=\S+)+", "", text).replace("--data-dir meshes", "").replace("--cache-dir surfaces", "")
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


TABLES = [  # page, marker, names of results, and the function that makes the text of them
    (README, "times", ["calls_256k", "calls_sizes"], speed_tables.times_of_readme),
    (README, "peers", ["compare_peers"], speed_tables.peers_of_readme),
    (README, "control", ["control_64k", "control_256k"], paper_tables.control_of_readme),
    (README, "python", ["python"], use_tables.python_of_readme),
    (PYTHON, "threads", ["python_threads"], use_tables.python_threads),
    (PYTHON, "topology", ["python_topology"], kit_tables.topology),
    (PYTHON, "interpolation", ["python_interpolation"], kit_tables.interpolation),
    (NPM, "npm", ["npm", "npm_peers"], kit_tables.npm),
    (PYTHON, "learning", ["python_learning"], kit_tables.learning),
    (PYTHON, "materials", ["python_materials"], kit_tables.materials),
    (PYTHON, "gaussians", ["python_gaussians", "gaussians_2M", "gaussians_5M", "gaussians_10M"], use_tables.gaussians),
    (BENCHMARK, "results", list(SHOWS), list_of_results),
    (MAIN_PAGE, "parts_counts", ["parts"], use_tables.counts_of_parts),
    (HOW_FAST, "one_thread", ["calls_256k"], speed_tables.one_thread),
    (HOW_FAST, "two_threads", ["calls_256k", "threads_256k"], speed_tables.two_threads),
    (HOW_FAST, "more_threads", ["threads_simulated"], speed_tables.more_threads),
    (HOW_FAST, "critical_path", ["critical_path_256k", "critical_path"], speed_tables.critical_path),
    (HOW_FAST, "sixteen_cores", ["threads_16_cores"], speed_tables.sixteen_cores),
    (HOW_FAST, "sizes", ["small_meshes", "demo_meshes", "threads_64k", "calls_256k", "calls_1M", "calls_sizes"],
     speed_tables.sizes),
    (HOW_FAST, "collections", ["orders", "orders_200k", "demo_meshes"], speed_tables.collections),
    (HOW_FAST, "gains", ["compare_64k"], speed_tables.gains),
    (HOW_FAST, "hard", ["orders", "orders_200k", "orders_walks", "flat_and_far"], speed_tables.hard),
    (HOW_FAST, "boxes", ["orders_walks"], speed_tables.boxes),
    (HOW_FAST, "weights", ["weights"], speed_tables.weights),
    (HOW_FAST, "periodic", ["periodic"], speed_tables.periodic),
    (HOW_FAST, "uses", ["consumers"], use_tables.uses),
    (HOW_FAST, "spanning_trees", ["spanning_trees"], use_tables.spanning_trees),
    (HOW_FAST, "sources", ["sources"], use_tables.sources),
    (HOW_FAST, "memory", ["calls_256k", "calls_1M", "single_calls", "threads_memory"], speed_tables.memory),
    (HOW_FAST, "compile_time", ["compile_time"], use_tables.compile_time),
    (HOW_FAST, "python", ["python"], use_tables.python),
    (HOW_FAST, "moved", ["moved", "python_peers"], use_tables.moved),
    (HOW_FAST, "python_peers", ["python_peers"], use_tables.python_peers),
    (HOW_FAST, "python_faults", ["python_faults"], use_tables.faults),
    (HOW_FAST, "tiles", ["tiles"], speed_tables.tiles),
    (HOW_FAST, "mpi", ["mpi", "tiles_load", "tiles_load_2M"], use_tables.mpi),
    (HOW_FAST, "tiles_peers", ["tiles_peers", "tiles_peers_1M"], use_tables.tiles_peers),
    (HOW_FAST, "peers", ["compare_peers"], speed_tables.peers),
    (HOW_FAST, "clusters", ["compare_clusters"], speed_tables.peers),
    (MAIN_PAGE, "cluster", ["tiles_load_2M", "tiles_load"], use_tables.cluster),
    (PAPER, "work", ["total_work"], paper_tables.work),
    (PAPER, "work_parts", ["total_work"], paper_tables.work_parts),
    (PAPER, "surfaces", ["location_costs"], paper_tables.surfaces),
    (PAPER, "crossings", ["location_costs"], paper_tables.crossings),
    (PAPER, "rounds", ["sorted_rounds"], paper_tables.rounds),
    (PAPER, "control", ["control_64k", "control_256k"], paper_tables.control),
    (MAIN_PAGE, "tracing", ["control_64k", "control_256k"], paper_tables.tracing),
    (PAPER, "floor", ["insertion_parts"], paper_tables.floor),
    (PAPER, "genus_50", ["paper_64k", "paper_256k", "calls_256k"], paper_tables.genus_50),
    (PAPER, "hypothesis", ["location_costs"], paper_tables.hypothesis),
    (PAPER, "traced", ["subgraphs_traced"], paper_tables.traced),
    (PAPER, "iso_surfaces", ["subgraphs_traced_4k"], paper_tables.iso_surfaces),
    (PAPER, "uniform_samples", ["uniform_samples"], paper_tables.uniform_samples),
    (PAPER, "bounds", ["subgraph_bounds", "subgraph_degrees"], paper_tables.bounds),
    (PAPER, "times", ["subgraph_times"], paper_tables.times),
    (PAPER, "near_minimum", ["subgraph_near_minimum"], paper_tables.near_minimum),
    (PAPER, "near_minimum_times", ["subgraph_near_minimum"], paper_tables.near_minimum_times),
    (PAPER, "near_minimum_files", ["subgraph_meshes", "subgraph_parts"], paper_tables.near_minimum_files),
]

BLOCK = re.compile(r"<!-- (\w+) -->\n.*?<!-- end -->", re.S)


def blocks_of(page):
    """{marker: text}"""
    return {marker: with_caption_below(write(*(read(HERE / f"results/{name}.json") for name in names)))
            for of_page, marker, names, write in TABLES if of_page == page}


def filled(text, blocks):
    """Every block has one place, or it would go stale unseen."""
    places = [match[1] for match in BLOCK.finditer(text)]
    wrong = sorted({name for name in [*places, *blocks] if name not in blocks or places.count(name) != 1})
    if wrong:
        raise ValueError(f"needs one place, and one row of TABLES, for each of: {', '.join(wrong)}")
    return BLOCK.sub(lambda match: f"<!-- {match[1]} -->\n\n{blocks[match[1]]}\n\n<!-- end -->", text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="write nothing")
    parser.add_argument("--print", nargs="+", metavar="MARKER", help="print these blocks, and fill nothing")
    parser.add_argument("--root", type=Path, default=ROOT, metavar="FOLDER", help="the project; default: that of this script")
    arguments = parser.parse_args()
    wrong = []
    if not arguments.check and not arguments.print:
        for path in (HERE / "results").glob("*.json"):
            rewrite(path)
    for page in dict.fromkeys(page for page, *_ in TABLES):
        blocks = blocks_of(page)
        if arguments.print:
            print("\n\n".join(f"<!-- {name} -->\n\n{blocks[name]}" for name in arguments.print if name in blocks))
            continue
        before = (arguments.root / page).read_text(encoding="utf-8")
        try:
            after = filled(before, blocks)
        except ValueError as error:
            sys.exit(f"fill_manual.py: {page}: {error}")
        if after != before:
            wrong.append(page)
            if not arguments.check:
                (arguments.root / page).write_text(after, encoding="utf-8")
    if arguments.check and wrong:
        sys.exit(f"fill_manual.py: not filled with these results: {', '.join(wrong)}")


if __name__ == "__main__":
    main()
