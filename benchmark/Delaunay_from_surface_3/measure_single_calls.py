#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Measures calls that are the only one of their process, as most programs make them, and writes what each took as JSON:
wall time, user and system time and their sum (of a few milliseconds the system knows only the sum), page faults, and peak
memory beyond what was there before the call, the mesh included. On a busy machine the wall time says nothing.

Plain CGAL and the package take turns. Other programs can take part: insert_once built from another revision, and peers, which
take a file of points and print what they took (see README.md). Before
the calls for a mesh a process touches as much memory as the largest of them needs, so that a virtual machine has it from
its host; the times of these touches are in the JSON, too. Then come the calls, first one after the other, then each after
a rest, in which the host may take free memory back.

  measure_single_calls.py MESH... --program ./insert_once --rest 0 4 --output single_calls.json"""

import argparse
import array
import json
import os
import platform
import re
import resource
import shlex
import statistics
import struct
import subprocess
import sys
import tempfile
import time
from datetime import date
from functools import partial
from pathlib import Path

KEYS = ("wall", "cpu", "user", "system", "faults", "bytes_above")


def output_of(*command):
    return subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True).stdout


def call(program, mesh, method):
    """`method` may end with a colon and a number of threads."""
    result = json.loads(output_of(program, str(mesh), *method.split(":")))
    result["cpu"] = result["user"] + result["system"]
    result["bytes_above"] = result["bytes_at_peak"] - result["bytes_before"]
    return result


def call_peer(command, points):
    words = dict(line.split(" ", 1) for line in output_of(*shlex.split(command), points).splitlines() if " " in line)
    result = {key: float(words[f"{key}_seconds"]) for key in ("wall", "cpu", "user", "system")}
    return {**result, "tetrahedra": int(words["tetrahedra"]), "threads": int(words["threads"]), "library": words.get("library", "CGAL")}


def write_points(mesh, file):
    """The vertices of a mesh in OFF, as peers read them."""
    words = re.sub("#.*", "", mesh.read_text(errors="replace")).split()
    if words[:1] != ["OFF"]:
        sys.exit(f"{mesh}: peers need a mesh in OFF")
    points = array.array("d", map(float, words[4:4 + 3 * int(words[1])]))
    file.write(struct.pack("<Q", int(words[1])))
    points.tofile(file)
    file.flush()


def measured(mesh, calls, options):
    """One entry for each length of rest: what each call took."""
    once = {name: run(mesh) for name, run in calls.items()}
    ours = {name: result for name, result in once.items() if "library" not in result}
    if len({result["tetrahedra"] for result in ours.values() if "tetrahedra" in result}) != 1:  # old revisions do not tell
        sys.exit(f"{mesh}: the numbers of tetrahedra differ")
    peak = 1024 * resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss  # of all calls until now, peers too
    for rest in options.rest:
        touched = json.loads(output_of(options.program, "--touch", str(peak)))
        runs = {name: [] for name in calls}
        for repetition in range(options.repetitions):
            names = list(calls) if repetition % 2 == 0 else list(calls)[::-1]
            for name in names:
                time.sleep(rest)
                runs[name].append(calls[name](mesh))
        first = once["plain"]
        result = {"mesh": mesh.name, "points": first["points"], "tetrahedra": first["tetrahedra"], "rest": rest, "touched": touched}
        result["calls"] = {name: summary(of_name) for name, of_name in runs.items()}
        yield result


def summary(runs):
    result = {f"median_{key}": round(statistics.median(run[key] for run in runs), 6) for key in KEYS if key in runs[0]}
    if "library" in runs[0]:
        result.update((key, runs[0][key]) for key in ("library", "threads", "tetrahedra"))
    return {**result, "cpu": [round(run["cpu"], 6) for run in runs]}


def cpu():
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        return next((line.split(":", 1)[1].strip() for line in file if line.startswith("model name")), "unknown")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("meshes", type=Path, nargs="+", metavar="MESH")
    parser.add_argument("--program", default="./insert_once", help="insert_once")
    parser.add_argument("--other", default=[], nargs="+", metavar="NAME=PROGRAM", help="insert_once of other revisions")
    parser.add_argument("--methods", default=["default"], nargs="+", help="beside plain: default, points, arrays, default:2 by two threads, …, parallel:2")
    parser.add_argument("--peer", default=[], nargs="+", action="extend", metavar="NAME=COMMAND", help="programs that take a file of points; then meshes are OFF")
    parser.add_argument("--repetitions", type=int, default=21, metavar="N")
    parser.add_argument("--rest", type=float, default=[0, 4], nargs="+", metavar="SECONDS", help="before each call")
    parser.add_argument("--output", type=Path, default=Path("single_calls.json"), metavar="FILE")
    options = parser.parse_args()
    calls = {}
    for method in ["plain", *options.methods]:
        calls[method] = partial(call, options.program, method=method)
        for name, program in (other.split("=", 1) for other in options.other if method != "plain"):
            calls[f"{method}, {name}"] = partial(call, program, method=method)
    points = tempfile.NamedTemporaryFile()
    for name, command in (peer.split("=", 1) for peer in options.peer):
        calls[name] = lambda _, command=command: call_peer(command, points.name)
    report = {
        "program": "measure_single_calls.py",
        "command": shlex.join(["measure_single_calls.py", *sys.argv[1:]]),
        "machine": {"cpu": cpu(), "date": date.today().isoformat(), "cores": os.cpu_count(), "system": platform.release(),
                    "load_before": round(os.getloadavg()[0], 2)},
        "results": [],
    }
    for mesh in options.meshes:
        if options.peer:
            points.seek(0)
            points.truncate()
            write_points(mesh, points)
        for result in measured(mesh, calls, options):
            report["results"].append(result)
            options.output.write_text(json.dumps(report, indent=1) + "\n")  # should a later call fail
            plain = result["calls"]["plain"]
            for name, of_name in result["calls"].items():
                print(f"{mesh.name}, rest {result['rest']:g}: {name}: " + ", ".join(
                    f"{key} {of_name[f'median_{key}']:g}" for key in KEYS if f"median_{key}" in of_name)
                    + f"; plain / this {plain['median_wall'] / of_name['median_wall']:.2f} by wall, "
                    f"{plain['median_cpu'] / of_name['median_cpu']:.2f} by cpu", flush=True)
    report["machine"]["load_after"] = round(os.getloadavg()[0], 2)
    options.output.write_text(json.dumps(report, indent=1) + "\n")


if __name__ == "__main__":
    main()
