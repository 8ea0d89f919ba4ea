# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Compares the npm package delaunay-3 with the same core natively, and with what npm has for tetrahedra, and writes JSON.

    scripts/wasm && npm install --prefix build/npm_peers delaunay-triangulate @derschmale/tympanum
    python3 measure_npm.py [--package FOLDER] [--no-peers | --peers FOLDER] [--repetitions N] [--limit SECONDS] [--output FILE]

Each way triangulates points in a process of its own, in turns; the times are those of its first call, on the wall and of
all threads of the process, with simplices and, here and natively, neighbours: WebAssembly is still being compiled. What is
wrong with tetrahedra comes with the times. Who was stopped at one size is not tried with more points.
"""

import argparse
import gzip
import json
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from measure_python import begun, bumpy_sphere, faults, write

ROOT = Path(__file__).resolve().parents[2]
PEERS = ["delaunay-triangulate", "@derschmale/tympanum"]

# Reads points from a file and writes simplices into another.
PROGRAM = """
import {readFileSync, writeFileSync} from "node:fs";
import {createRequire} from "node:module";
import {runInThisContext} from "node:vm";
const [way, folder, input, output] = process.argv.slice(2);
const points = new Float64Array(readFileSync(input).buffer.slice(0));
const rows = () => Array.from({length: points.length / 3}, (_, i) => Array.from(points.subarray(3 * i, 3 * i + 3)));
const ways = {
  "delaunay-3": async () => {
    const {init, delaunay3Sync} = await import(`${folder}/index.mjs`);
    await init();
    return () => {
      const d = delaunay3Sync(points);
      return [d.simplices, d.neighbors];
    };
  },
  "delaunay-triangulate": () => {
    const given = rows(), triangulate = createRequire(`${folder}/`)("delaunay-triangulate");
    return () => [triangulate(given).flat()];
  },
  "@derschmale/tympanum": () => {
    runInThisContext(readFileSync(`${folder}/node_modules/@derschmale/tympanum/build/tympanum.js`, "utf8"));
    const given = rows();
    return () => [TYMP.delaunay(given).map((simplex) => simplex.verts).flat()];
  },
};
const work = await ways[way](), cpu = process.cpuUsage(), begin = performance.now(), [simplices] = work();
const wall = (performance.now() - begin) / 1000, {user, system} = process.cpuUsage(cpu);
writeFileSync(output, Int32Array.from(simplices));
console.log(JSON.stringify({wall, cpu: (user + system) / 1e6}));
"""

# The same file of C++, compiled for this machine, and the same copies of what it returns.
NATIVE = """
import ctypes, json, sys, time
import numpy as np
c, points = ctypes.CDLL(sys.argv[1]), np.fromfile(sys.argv[2])
d, cells = ctypes.c_void_p(), (ctypes.c_size_t * 8)()
wall, cpu = time.perf_counter(), time.process_time()
status = c.delaunay_3_build(points.ctypes.data_as(ctypes.c_void_p), ctypes.c_size_t(points.size // 3), None, ctypes.c_size_t(0), 1,
                            ctypes.byref(d), None)
assert status == 0
c.delaunay_3_get(d, ctypes.byref(cells))
_, number, _, stride, vertices, neighbors, *_ = cells
def copied(address):
    of_all = (ctypes.c_int32 * ((number - 1) * stride + 4)).from_address(address)
    return np.lib.stride_tricks.as_strided(np.ctypeslib.as_array(of_all), (number, 4), (4 * stride, 4)).copy()
simplices, across = copied(vertices), copied(neighbors)
across[across >= number] = -1
wall, cpu = time.perf_counter() - wall, time.process_time() - cpu
simplices.tofile(sys.argv[3])
print(json.dumps({"wall": wall, "cpu": cpu}))
"""


def compiled(package):
    """The library of the file that scripts/wasm has compiled."""
    library = package / "native.so"
    subprocess.run(["c++", "-std=c++17", "-O3", "-DNDEBUG", "-shared", "-fPIC", package / "source/delaunay_3.cpp", "-o", library,
                    "-pthread"], check=True)
    return library.resolve()


def run(points, limit, *command):
    """Runs it with files for points and simplices, in a process of its own."""
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        (folder / "program.mjs").write_text(PROGRAM, encoding="utf-8")
        (folder / "program.py").write_text(NATIVE, encoding="utf-8")
        points.tofile(folder / "points")
        try:
            done = subprocess.run([*command, "points", "simplices"], cwd=folder, timeout=limit, capture_output=True, text=True,
                                  check=False)
        except subprocess.TimeoutExpired:
            return {"left_out": f"stopped after {limit} s"}
        if done.returncode != 0:
            return {"left_out": next((line for line in done.stderr.splitlines() if "Error" in line), "failed")}
        return {**json.loads(done.stdout), "cells": np.fromfile(folder / "simplices", np.int32).reshape(-1, 4)}


def sets():
    rng = np.random.default_rng(2026)
    for n, k in ((1000, 10), (10000, 20)):
        yield "points in a cube", rng.random((n, 3))
        yield "a grid", np.stack(np.meshgrid(*3 * [np.arange(float(k))], indexing="ij"), axis=-1).reshape(-1, 3)
    for n in (100000, 1000000):
        yield "points in a cube", rng.random((n, 3))
        yield "a bumpy sphere", bumpy_sphere(n)


def same(*both):
    """Whether they are the same tetrahedra: how they are numbered depends on the C++ library."""
    ordered = [np.sort(cells, axis=1) for cells in both]
    return np.array_equal(*(cells[np.lexsort(cells.T)] for cells in ordered))


def line(name, points, options, stopped):
    """Medians of times, and what is wrong with the last tetrahedra."""
    ways = {"native": [sys.executable, "-B", "program.py", options.native],
            "delaunay-3": ["node", "program.mjs", "delaunay-3", options.package.resolve() / "package"],
            **{peer: ["node", "program.mjs", peer, options.peers.resolve()] for peer in PEERS if peer not in stopped}}
    runs = {way: [] for way in ways}
    for _ in range(options.repetitions):
        for way, command in ways.items():
            if not any("left_out" in run for run in runs[way]):
                runs[way].append(run(points, options.limit, *command))
    results = {}
    for way, of_way in runs.items():
        last = of_way[-1]
        if "left_out" in last:
            results[way] = {"left_out": last["left_out"]}
            stopped.update([way] if "stopped" in last["left_out"] else [])
            continue
        results[way] = {"median_wall": round(statistics.median(run["wall"] for run in of_way), 4),
                        "median_cpu": round(statistics.median(run["cpu"] for run in of_way), 4),
                        "least_cpu": round(min(run["cpu"] for run in of_way), 4)}
        if way == "delaunay-3":
            results[way]["same_as_native"] = same(last["cells"], runs["native"][-1]["cells"])
        if len(points) <= 10000:
            results[way]["tetrahedra"] = faults(points, last["cells"])
    return {"what": name, "points": len(points), "ways": results}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--package", type=Path, default=ROOT / "build/npm")
    parser.add_argument("--peers", type=Path, default=ROOT / "build/npm_peers")
    parser.add_argument("--no-peers", action="store_true")
    parser.add_argument("--repetitions", type=int, default=3)
    parser.add_argument("--limit", type=int, default=120)
    parser.add_argument("--output", default="npm.json")
    options = parser.parse_args()
    wasm = (options.package / "package/delaunay_3.wasm").read_bytes()
    (tarball,) = options.package.glob("*.tgz")
    versions = {peer: json.loads((options.peers / "node_modules" / peer / "package.json").read_text(encoding="utf-8"))["version"]
                for peer in PEERS if not options.no_peers}
    report = {**begun(options), "node": subprocess.check_output(["node", "--version"], text=True).strip(), "peers": versions,
              "bytes": {"wasm": len(wasm), "wasm_gzip": len(gzip.compress(wasm, 9)), "tarball": tarball.stat().st_size},
              "results": []}
    options.native = compiled(options.package)
    stopped = set(PEERS) if options.no_peers else set()
    for name, points in sets():
        report["results"].append(line(name, points, options, stopped))
        print(json.dumps(report["results"][-1]), flush=True)
    write(report, options.output)


if __name__ == "__main__":
    main()
