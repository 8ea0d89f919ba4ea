#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Counts the instructions that each of many threads executes, on a machine with fewer cores, and writes them as JSON.

For each part of each phase, the largest number that any thread executes, summed up, is the critical path: what as many cores
would have to wait for, if nothing but instructions took time. The sum over the threads is the work. Valgrind runs one thread
at a time, in turns of 100,000 basic blocks, about two hundred insertions: so threads share the work of large chunks as if all
ran at once, but that of small ones less evenly. Needs valgrind, and arrays_by_threads, the program beside this script, whose
CPU time without valgrind stands beside the counts.

  critical_path.py elephant_1M.off --threads 1 2 4 8 16 32 --program ./arrays_by_threads --output critical_path.json"""

import argparse
import json
import re
import shlex
import subprocess
import sys
import tempfile
from collections import defaultdict
from pathlib import Path

from one_record_per_line import text_of

PHASES = ["order", "permute", "insertion", "export"]


def counted(program, mesh, threads):
    """The largest number of instructions of a thread, and the sum, by phase and part."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "out"
        command = ["valgrind", "--tool=callgrind", "--separate-threads=yes", "--fair-sched=yes",
                   f"--callgrind-out-file={out}", program, mesh, str(threads)]
        subprocess.run(command, capture_output=True, check=True)
        of_threads = defaultdict(lambda: defaultdict(int))  # by phase, part, and number of the part, those of each thread
        for file in Path(folder).glob("out.*-*"):
            text = file.read_text(errors="replace")
            if found := re.search(r"^desc: Trigger: Client Request: (\w+) (\w+) (\d+)$", text, re.MULTILINE):
                thread = re.search(r"^thread: (\d+)$", text, re.MULTILINE)[1]
                of_threads[found.groups()][thread] += int(re.search(r"^totals: (\d+)$", text, re.MULTILINE)[1])
    if not of_threads:
        sys.exit(f"{program} tells valgrind nothing: it was built without valgrind/callgrind.h")
    longest, work = defaultdict(int), defaultdict(int)
    for (phase, part, _), counts in of_threads.items():
        longest[phase, part] += max(counts.values())
        work[phase, part] += sum(counts.values())
    return longest, work


def measured(program, mesh, threads):
    longest, work = counted(program, mesh, threads)
    plain = json.loads(subprocess.run([program, mesh, str(threads)], capture_output=True, check=True).stdout)
    seconds = {(p["phase"], p["part"]): p["cpu_seconds"] for p in plain["parts"]}
    names = [(phase, part) for phase in PHASES for part in ("alone", "shared") if work[phase, part]]
    per_point = lambda n: round(n / plain["points"], 1)
    return {"mesh": Path(mesh).stem, "points": plain["points"], "threads": threads,
            "critical_path": per_point(sum(longest[n] for n in names)), "work": per_point(sum(work[n] for n in names)),
            "cpu_seconds": round(sum(seconds[n] for n in names), 3),
            "parts": {f"{phase}, {part}": [per_point(longest[phase, part]), per_point(work[phase, part])] for phase, part in names}}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("meshes", metavar="MESH", nargs="+")
    parser.add_argument("--threads", type=int, nargs="+", default=[1, 2, 4, 8, 16, 32], metavar="N")
    parser.add_argument("--program", default="./arrays_by_threads", help="arrays_by_threads")
    parser.add_argument("--output", type=Path, default=Path("critical_path.json"), metavar="FILE")
    options = parser.parse_args()
    report = {"command": " ".join(["critical_path.py", *map(shlex.quote, sys.argv[1:])]), "results": []}
    for mesh in options.meshes:
        for threads in options.threads:
            report["results"].append(measured(options.program, mesh, threads))
            print(report["results"][-1], flush=True)
    options.output.write_text(text_of(report))


if __name__ == "__main__":
    main()
