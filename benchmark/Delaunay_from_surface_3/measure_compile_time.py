#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Measures what a user's file takes a compiler that inserts the vertices of a Surface_mesh: by plain CGAL, by the
default of the package, and by the same with the core compiled. They are compiled in turn; written as JSON are the user
times, their medians, the largest memory of the compiler, and how much more the package takes.

  measure_compile_time.py --compiler g++ clang++ --output compile_time.json"""

import argparse
import json
import os
import platform
import shlex
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

COMMON = """
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Surface_mesh.h>
{include}
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

int main()
{{
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  CGAL::Delaunay_triangulation_3<Kernel> tr;
  {insert};
  return int(tr.number_of_vertices());
}}
"""
SOURCES = {
    "plain": COMMON.format(include="", insert="tr.insert(mesh.points().begin(), mesh.points().end())"),
    "package": COMMON.format(
        include="#include <CGAL/insert_surface_vertices_3.h>\n", insert="CGAL::insert_surface_vertices_3(tr, mesh)"
    ),
}
SOURCES["compiled"] = "#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED\n" + SOURCES["package"]
INCLUDE = Path(__file__).resolve().parents[2] / "include"


def compile_once(command):
    """User seconds, and the most memory that the compiler had, in MB."""
    process = subprocess.Popen(command)
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit(f"{shlex.join(command)} failed")
    return usage.ru_utime, usage.ru_maxrss / 1024


def measured(compiler, options, folder):
    runs = {name: [] for name in SOURCES}
    for _ in range(options.repetitions):
        for name in SOURCES:
            command = [compiler, "-std=c++17", *shlex.split(options.flags), f"-I{options.include}", "-c"]
            runs[name].append(compile_once([*command, str(folder / f"{name}.cpp"), "-o", str(folder / "out.o")]))
    result = {"compiler": subprocess.run([compiler, "--version"], capture_output=True, text=True).stdout.split("\n")[0]}
    for name, values in runs.items():
        times, memory = zip(*values)
        result[name] = {
            "median_user": round(statistics.median(times), 2),
            "user": [round(t, 2) for t in times],
            "megabytes": round(max(memory)),
        }
    for name in ("package", "compiled"):
        for what, key in [("more_time", "median_user"), ("more_memory", "megabytes")]:
            result[name][what] = round(result[name][key] / result["plain"][key] - 1, 3)
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--compiler", nargs="+", default=["c++"], metavar="PROGRAM")
    parser.add_argument("--flags", default="-O3 -DNDEBUG -frounding-math", help="(default: those of a release)")
    parser.add_argument("--include", default=str(INCLUDE), metavar="DIR", help="headers of the package")
    parser.add_argument("-r", "--repetitions", type=int, default=5, metavar="N")
    parser.add_argument("--output", type=Path, metavar="FILE")
    options = parser.parse_args()
    report = {
        "command": " ".join(["measure_compile_time.py", *map(shlex.quote, sys.argv[1:])]),
        "machine": platform.processor() or platform.machine(),
        "load": [round(x, 1) for x in os.getloadavg()],
        "flags": options.flags,
    }
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for source, text in SOURCES.items():
            (folder / f"{source}.cpp").write_text(text)
        report["compilers"] = [measured(compiler, options, folder) for compiler in options.compiler]
    text = json.dumps(report, indent=1) + "\n"
    if options.output:
        options.output.write_text(text)
    for r in report["compilers"]:
        print(f'{r["compiler"]}: plain CGAL {r["plain"]["median_user"]} s, {r["plain"]["megabytes"]} MB')
        for name in ("package", "compiled"):
            print(f'  {name} {r[name]["median_user"]} s, {r[name]["megabytes"]} MB: '
                  f'{r[name]["more_time"]:+.1%} time, {r[name]["more_memory"]:+.1%} memory', flush=True)


if __name__ == "__main__":
    main()
