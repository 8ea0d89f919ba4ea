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

import hard_tables
import list_of_results
import paper_tables
import speed_tables
import use_tables
from manual_tables import read
from one_record_per_line import rewrite

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
README = "README.md"
MAIN_PAGE = "doc/Delaunay_from_surface_3/Delaunay_from_surface_3.txt"
BENCHMARK = "benchmark/Delaunay_from_surface_3/README.md"
PAPER = "doc/Delaunay_from_surface_3/The_paper.txt"
PYTHON = "python/README.md"
HOW_FAST = "doc/Delaunay_from_surface_3/How_fast.txt"

TABLES = [  # page, marker, names of results, and the function that makes the text of them
    (README, "times", ["calls_256k"], speed_tables.times_of_readme),
    (README, "collections", ["orders_200k", "demo_meshes"], speed_tables.collections),
    (README, "peers", ["compare_peers"], hard_tables.peers_of_readme),
    (README, "python", ["python"], use_tables.python_of_readme),
    (PYTHON, "threads", ["python_threads"], use_tables.python_threads),
    (PYTHON, "gaussians", ["python_gaussians", "gaussians_2M", "gaussians_5M", "gaussians_10M"], use_tables.gaussians),
    (BENCHMARK, "results", list(list_of_results.SHOWS), list_of_results.list_of_results),
    (MAIN_PAGE, "parts_counts", ["parts"], use_tables.counts_of_parts),
    (HOW_FAST, "one_thread", ["calls_256k"], speed_tables.one_thread),
    (HOW_FAST, "two_threads", ["calls_256k", "threads_256k"], speed_tables.two_threads),
    (HOW_FAST, "more_threads", ["threads_simulated"], speed_tables.more_threads),
    (HOW_FAST, "sizes", ["small_meshes", "demo_meshes", "threads_64k", "calls_256k", "calls_1M", "threads_4M"],
     speed_tables.sizes),
    (HOW_FAST, "gains", ["compare_64k"], speed_tables.gains),
    (HOW_FAST, "hard", ["orders", "orders_200k", "orders_walks", "flat_and_far"], hard_tables.hard),
    (HOW_FAST, "boxes", ["orders_walks"], hard_tables.boxes),
    (HOW_FAST, "uses", ["consumers"], use_tables.uses),
    (HOW_FAST, "sources", ["sources"], use_tables.sources),
    (HOW_FAST, "memory", ["calls_256k", "calls_1M", "single_calls", "threads_memory"], speed_tables.memory),
    (HOW_FAST, "compile_time", ["compile_time"], use_tables.compile_time),
    (HOW_FAST, "python", ["python"], use_tables.python),
    (HOW_FAST, "moved", ["moved", "python_peers"], use_tables.moved),
    (HOW_FAST, "python_peers", ["python_peers"], use_tables.python_peers),
    (HOW_FAST, "python_faults", ["python_faults"], use_tables.faults),
    (HOW_FAST, "tiles", ["tiles"], hard_tables.tiles),
    (HOW_FAST, "mpi", ["mpi", "tiles_load", "tiles_load_2M"], use_tables.mpi),
    (HOW_FAST, "tiles_peers", ["tiles_peers", "tiles_peers_1M"], use_tables.tiles_peers),
    (HOW_FAST, "peers", ["compare_peers"], hard_tables.peers),
    (HOW_FAST, "clusters", ["compare_clusters"], hard_tables.peers),
    (MAIN_PAGE, "cluster", ["tiles_load_2M", "tiles_load"], use_tables.cluster),
    (PAPER, "work", ["total_work"], paper_tables.work),
    (PAPER, "work_parts", ["total_work"], paper_tables.work_parts),
    (PAPER, "surfaces", ["location_costs", "location_costs_genus_50"], paper_tables.surfaces),
    (PAPER, "crossings", ["location_costs", "location_costs_genus_50"], paper_tables.crossings),
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
    return {marker: write(*(read(HERE / f"results/{name}.json") for name in names))
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
