#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Counts the instructions that plain CGAL and the default take for the small meshes of a folder, whose times are too
short to be measured, and writes them as JSON. Needs valgrind and insert_once, the program beside this script.

Valgrind rounds to nearest always. CGAL's interval arithmetic asks for other modes, and without them plain CGAL may not
end where points are degenerate: a mesh that takes longer than the time limit is said not to be counted.

  count_instructions.py DIR --program ./insert_once --most-vertices 2999 --output small_meshes.json

Of one mesh, --phases counts those of the package's phases, per point. The program is then one with symbols (-g), which
tell of what header an inlined function is:

  count_instructions.py refined_elephant.off --phases --program ./insert_once --output phases.json

Of one mesh or several, --parts counts those of plan, location and update, point by point through CGAL's own insertion, in
the orders of ORDERS, and those of Tracing_traits_3: what hints could gain at most.

  count_instructions.py elephant_64k.off genus-50_64k.off --parts --program ./insert_once --output insertion_parts.json"""

import argparse
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

from one_record_per_line import text_of

EXTENSIONS = {".off", ".ply", ".obj", ".stl"}
FUNCTIONS = ["insert_once_by_plain_cgal", "insert_once_by_default"]
PHASES = {  # a phase is all that is called from lines of the first within the second, by regular expressions
    "read": ("", "::Read_soup<"),  # the points are read where they are
    "plan": ("core/(build_impl|order/\\w+).h", "::(order_of_points|spaced_rounds)"),
    "permute": ("core/kernel/Ordered_complex.h", "Ordered_complex<.*::start"),
    "walk": ("core/kernel/Walk_to_conflict.h", ""),
    "dig": ("core/kernel/Inserter.h", "::dig_in_vectors"),
    "fill": ("core/kernel/Fill_star.h", "Fill_star<.*operator"),
    "export": ("adapters/export_complex.h", "::export_built"),
}
ORDERS = ["spatial-sort", "nets", "paper"]
PARTS = {"plan": "insert_once_plan", "location": "insert_once_locate", "update": "insert_once_update"}
MOST_BYTES = 150  # of a file, for each of the vertices that it may have: larger ones are not tried


def instructions(program, mesh, time_limit):
    """Those of both functions, and the number of vertices; None if the program fails or takes too long."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "out"
        options = [f"--toggle-collect={name}" for name in FUNCTIONS] + ["--dump-before=insert_once_between"]
        command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", *options, program, mesh]
        try:
            run = subprocess.run(command, capture_output=True, text=True, timeout=time_limit)
        except subprocess.TimeoutExpired:
            return None
        if run.returncode != 0:
            return None
        total = lambda file: int(re.search(r"^totals: (\d+)", file.read_text(), re.MULTILINE)[1])
        return {"vertices": int(run.stdout), "plain": total(Path(f"{out}.1")), "package": total(out)}


def phases(program, mesh):
    """The instructions of each phase per point, and of all."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "out"
        run = subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", f"--toggle-collect={FUNCTIONS[1]}",
                              program, mesh], capture_output=True, text=True, check=True)
        lines = subprocess.run(["callgrind_annotate", "--inclusive=yes", "--threshold=100", "--show-percs=no", "--auto=no", out],
                               capture_output=True, text=True, check=True).stdout
    counts = [(int(m[1].replace(",", "")), m[2]) for m in re.finditer(r"^ *([\d,]+) +(\S*:.*)$", lines, re.MULTILINE)]
    most = lambda file, function: max((n for n, name in counts if re.search(f"{file}:.*{function}", name)), default=0)
    found = {phase: most(*where) for phase, where in PHASES.items()}
    whole = most("", FUNCTIONS[1])
    found["rest"] = whole - sum(found.values())
    points = int(run.stdout)
    return points, [{"phase": name, "instructions": round(n / points, 1), "share": round(n / whole, 3)}
                    for name, n in [*found.items(), ("all", whole)]]


def inclusive(out, function):
    """The instructions of a function and all that it calls, in the file that callgrind wrote."""
    lines = subprocess.run(["callgrind_annotate", "--inclusive=yes", "--threshold=100", "--show-percs=no", "--auto=no", out],
                           capture_output=True, text=True, check=True).stdout
    return max(int(m[1].replace(",", "")) for m in re.finditer(rf"^ *([\d,]+) +\S*:{function}( |$)", lines, re.MULTILINE))


def counted(program, mesh, order, functions):
    """The instructions of each of these functions in an insertion in an order, or by one call, per point; and the points."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "out"
        run = subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", program, mesh, "--order", order],
                             capture_output=True, text=True, check=True)
        points = int(run.stdout)
        counts = {name: round(inclusive(out, function) / points, 1) for name, function in functions.items()}
    print(mesh.name, order, counts, flush=True)
    return counts, points


def parts(program, mesh):
    calls, points = counted(program, mesh, "plain", {"plain": FUNCTIONS[0]})
    calls |= counted(program, mesh, "traces", {"traces": "insert_once_by_traces"})[0]
    return {"mesh": mesh.name, "points": points, **calls, "orders": {o: counted(program, mesh, o, PARTS)[0] for o in ORDERS}}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path, metavar="DIR", nargs="+")
    parser.add_argument("--phases", action="store_true", help="of one mesh, in place of a folder")
    parser.add_argument("--parts", action="store_true", help="of meshes, in place of a folder")
    parser.add_argument("--program", default="./insert_once", help="insert_once")
    parser.add_argument("--most-vertices", type=int, default=2999, metavar="N", help="larger meshes are left out")
    parser.add_argument("--time-limit", type=float, default=60, metavar="SECONDS", help="for each (default 60)")
    parser.add_argument("--output", type=Path, default=Path("small_meshes.json"), metavar="FILE")
    options = parser.parse_args()
    command = " ".join(["count_instructions.py", *map(shlex.quote, sys.argv[1:])])
    if options.parts:
        found = [parts(options.program, mesh) for mesh in options.folder]
        options.output.write_text(text_of({"command": command, "insertion_parts": found}))
        return
    if options.phases:
        points, counts = phases(options.program, options.folder[0])
        options.output.write_text(text_of({"command": command, "points": points, "phases": counts}))
        print(*(f"{c['phase']}: {c['instructions']}" for c in counts), sep="\n")
        return
    results, not_counted = [], []
    for mesh in sorted(p for p in options.folder[0].rglob("*") if p.suffix.lower() in EXTENSIONS and p.is_file()):
        if os.path.getsize(mesh) > MOST_BYTES * options.most_vertices:
            continue
        counts = instructions(options.program, mesh, options.time_limit)
        if counts is None:
            not_counted.append(str(mesh.relative_to(options.folder[0])))
            print(f"{mesh.name}: not counted", flush=True)
        elif counts["vertices"] <= options.most_vertices:
            results.append({"mesh": str(mesh.relative_to(options.folder[0])), **counts})
            print(f"{mesh.name}: {counts['vertices']} vertices, {counts['plain'] / counts['package']:.2f}", flush=True)
    report = {"command": command, "instructions": results, "not_counted": not_counted}
    options.output.write_text(json.dumps(report, indent=1) + "\n")


if __name__ == "__main__":
    main()
