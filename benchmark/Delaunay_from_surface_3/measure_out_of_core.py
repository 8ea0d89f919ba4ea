#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Measures whole runs of `delaunay_from_surface tiles` on points near a sphere with bumps, whose distance from it is random,
a ten thousandth of its size: time, memory, and the most disk that state and tiles have. Writes JSON.

  measure_out_of_core.py 100000000 --program ./delaunay_from_surface --output out_of_core.json -- --memory 4G --threads 2"""

import argparse
import json
import os
import platform
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy
from measure_single_calls import cpu


def write_points(path, n):
    """As raw doubles."""
    source = numpy.random.default_rng(1)
    with open(path, "wb") as file:
        for first in range(0, n, 1000000):
            p = source.standard_normal((min(1000000, n - first), 3))
            p /= numpy.linalg.norm(p, axis=1)[:, None]
            bumps = numpy.sin(5 * p).prod(axis=1)
            p *= (1 + bumps / 4 + source.uniform(-1e-4, 1e-4, len(p)))[:, None]
            p.tofile(file)


def run_watched(command, folder):
    """What it reports, and what it took: seconds, and bytes of disk in a folder."""
    begin, most = time.monotonic(), 0
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        while os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOWAIT | os.WNOHANG) is None:
            blocks, looked = 0, time.monotonic()
            for place in folder.glob("**/*"):
                try:
                    blocks += place.stat().st_blocks
                except FileNotFoundError:  # written or removed meanwhile
                    pass
            most = max(most, 512 * blocks)
            time.sleep(.1 + 20 * (time.monotonic() - looked))
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        text = process.stdout.read()
    if process.returncode != 0:
        sys.exit(f"{shlex.join(command)} has failed")
    report = json.loads(text)
    report.pop("output")
    return {**report, "wall": round(time.monotonic() - begin, 2), "user": round(used.ru_utime, 2),
            "system": round(used.ru_stime, 2), "peak_megabytes": used.ru_maxrss // 1024, "most_bytes_of_disk": most}


def measured(options, folder):
    for n in options.points:
        points, output = folder / "points.raw", folder / "tiles"
        write_points(points, n)
        yield run_watched([options.program, "tiles", str(points), "--json", "--output", str(output), *options.arguments], output)
        shutil.rmtree(output)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("points", type=int, nargs="+", help="how many")
    parser.add_argument("--program", required=True)
    parser.add_argument("--folder", type=Path, help="for points and tiles")
    parser.add_argument("--output", type=Path, required=True, metavar="FILE")
    own, arguments = sys.argv[1:], []
    if "--" in own:
        own, arguments = own[:own.index("--")], own[own.index("--") + 1:]
    options = parser.parse_args(own)
    options.arguments = arguments
    report = {
        "program": "measure_out_of_core.py",
        "command": shlex.join(["measure_out_of_core.py", *sys.argv[1:]]),
        "machine": {"cpu": cpu(), "cores": os.cpu_count(), "system": platform.platform(), "date": time.strftime("%Y-%m-%d"),
                    "load_before": os.getloadavg()[0]}}
    with tempfile.TemporaryDirectory(dir=options.folder) as folder:
        report["results"] = list(measured(options, Path(folder)))
    options.output.write_text(json.dumps(report, indent=1) + "\n", encoding="utf-8")
    print(json.dumps(report["results"], indent=1))


if __name__ == "__main__":
    main()
