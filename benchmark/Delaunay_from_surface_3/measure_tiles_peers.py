#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Tiles by MPI beside other programs that work by MPI, in turns, on the same points: uniform in a cube, of a surface, a grid,
with duplicates, and exactly on a sphere. Writes JSON: medians of time, CPU time of all ranks, the most memory of a rank, bytes
that ranks sent to each other, points that all parts hold; and whether each has the tetrahedra of this package, or, of Voronoi
diagrams, faces that have edges of these, and cells that fill the box. Coordinates are rounded to floats, as some know no
others.

  measure_tiles_peers.py --peers ours=./tiles_peer tess2=./tess2_peer madvoro=./madvoro_peer --surface elephant.off

The first program is tiles_peer; the others are built where CMake finds their libraries. --many runs those that can once more
with so many tiles a rank. A program that fails or takes too long is not run again with these points and ranks."""

import argparse
import itertools
import json
import os
import platform
import shlex
import signal
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy
from measure_single_calls import cpu

ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_rmaps_base_oversubscribe": "1"}


def points_of_mesh(path):
    """Of an OFF file, as generate_surface writes it."""
    with open(path, encoding="ascii") as file:
        lines = (line for line in file if line.strip() and not line.startswith(("#", "OFF")))
        n = int(next(lines).split()[0])
        return numpy.loadtxt(itertools.islice(lines, n), usecols=(0, 1, 2))


def grid(n):
    k = round(n ** (1 / 3))
    return numpy.stack(numpy.meshgrid(*3 * [numpy.arange(float(k))]), axis=-1).reshape(-1, 3)


def with_duplicates(n):
    """One point of a hundred is there twice, far from the first in the file."""
    points = numpy.random.default_rng(7).random((n, 3))
    points[n // 2:n // 2 + n // 100] = points[:n // 100]
    return points


def sphere(n):
    """The points with whole coordinates on a sphere that has at least n of them, all on it exactly."""
    best = numpy.empty((0, 3))
    square = int((n / 6.3) ** 2) | 1
    while len(best) < n:
        square += 2
        k = numpy.arange(-int(square ** .5), int(square ** .5) + 1)
        rest = square - k[:, None] ** 2 - k[None, :] ** 2
        z = numpy.round(numpy.sqrt(numpy.maximum(rest, 0))).astype(int)
        i, j = numpy.nonzero((z * z == rest) & (rest >= 0))
        half = numpy.stack([k[i], k[j], z[i, j]], axis=1)
        best = numpy.unique(numpy.concatenate([half, half * [1, 1, -1]]), axis=0)
    return numpy.random.default_rng(7).permutation(best.astype(float))


def inputs(options):
    """As floats have them."""
    n, surface = options.points, Path(options.surface)
    makers = {"cube": lambda: numpy.random.default_rng(2024).random((n, 3)), surface.stem: lambda: points_of_mesh(surface),
              "grid": lambda: grid(n), "duplicates": lambda: with_duplicates(n), "sphere": lambda: sphere(n // 4)}
    for name, make in makers.items():
        if not options.only or name in options.only:
            yield name, numpy.ascontiguousarray(make(), numpy.float32).astype(float)


def write_points(path, points):
    """As points_file.h has them."""
    with open(path, "wb") as file:
        numpy.uint64(len(points)).tofile(file)
        points.tofile(file)


def run(peers, way, arguments, limit):
    """What one prints, or why it has no result. All ranks end with their mpirun."""
    peer, ranks, tiles = way
    command = ["mpirun", "-n", str(ranks), os.path.abspath(peers[peer]), str(arguments[0]), str(tiles), *map(str, arguments[1:])]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, env=ENVIRONMENT,
                          preexec_fn=os.setpgrp) as process:
        try:
            text, _ = process.communicate(timeout=limit)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGTERM)  # which mpirun hands on
            process.wait()
            return {"left_out": f"stopped after {limit} s"}
    if process.returncode != 0:
        return {"left_out": f"exit code {process.returncode}"}
    lines = [line.split(" ", 1) for line in text.splitlines() if " " in line]
    return {key: value if key == "library" else float(value) for key, value in lines
            if key in ("library", "wall_seconds", "cpu_seconds", "peak_bytes_of_a_rank", "bytes_sent", "tetrahedra",
                       "points_held", "faces", "volume_by_box", "rounds")}


def keys_of(rows):
    """A number for each row of whole numbers of 8 bytes."""
    key = numpy.zeros(len(rows), numpy.uint64)
    for column in rows.T:
        key = (key ^ column.astype(numpy.uint64)) * numpy.uint64(0x9E3779B97F4A7C15)
        key ^= key >> numpy.uint64(29)
    return key


def elements(prefix, ranks, size):
    """Tetrahedra, or pairs of points, that a program wrote: keys of their vertices' keys, which ascend, each once; and these."""
    corners = numpy.concatenate([numpy.fromfile(f"{prefix}.{rank}") for rank in range(ranks)])
    corners += 0.  # -0 is 0
    vertices = numpy.sort(keys_of(corners.view(numpy.uint64).reshape(-1, 3)).reshape(-1, size), axis=1)
    return numpy.sort(keys_of(vertices)), vertices


def edges_of(tetrahedra):
    return numpy.unique(numpy.concatenate([keys_of(tetrahedra[:, pair]) for pair in itertools.combinations(range(4), 2)]))


def verdict(found, prefix, ranks, reference):
    """Beside the tetrahedra of this package: how many are missing, how many are others."""
    if "tetrahedra" in found:
        keys, _ = elements(prefix, ranks, 4)
        expected = reference["tetrahedra"]
        missing = len(numpy.setdiff1d(expected, keys))
        others = len(keys) - len(numpy.intersect1d(expected, keys))  # with those that are there twice
        return {"missing": missing, "others": others}
    keys, _ = elements(prefix, ranks, 2)
    return {"others": len(numpy.setdiff1d(keys, reference["edges"])), "volume_by_box": found["volume_by_box"]}


def looked_at(peers, ways, points, folder, limit):
    """A first run of each way, which shows whether it is right. The first way is this package's."""
    reference, results = {}, {}
    for way in ways:
        cells, ranks = folder / f"cells-{len(results)}", way[1]
        found = run(peers, way, [points, cells], limit)
        if not reference:
            keys, tetrahedra = elements(cells, ranks, 4)
            reference = {"tetrahedra": keys, "edges": edges_of(tetrahedra)}
        if "left_out" not in found:
            found["verdict"] = verdict(found, cells, ranks, reference)
        for written in folder.glob(f"{cells.name}.*"):
            written.unlink()
        results[way] = found
        print(points.name, *way, found, flush=True)
    return results


def record(name, n, way, first, runs):
    peer, ranks, tiles = way
    head = {"input": name, "points": n, "peer": peer, "ranks": ranks, "tiles_of_a_rank": tiles}
    failed = [found for found in [first, *runs] if "left_out" in found]
    if failed:
        return {**head, "left_out": failed[0]["left_out"]}

    def median(key):
        return statistics.median(found[key] for found in runs)
    counts = {key: int(first[key]) for key in ("points_held", "tetrahedra", "faces", "rounds") if key in first}
    return {**head, "median_wall": round(median("wall_seconds"), 4), "median_cpu": round(median("cpu_seconds"), 4),
            "peak_bytes_of_a_rank": int(median("peak_bytes_of_a_rank")), "bytes_sent": int(median("bytes_sent")), **counts,
            **first["verdict"]}


def measured(options, libraries):
    peers = dict(peer.split("=", 1) for peer in options.peers)
    ways = [(peer, ranks, tiles) for ranks in options.ranks for peer in peers
            for tiles in sorted({1, options.many}) if tiles == 1 or (ranks > 1 and peer != "madvoro")]
    with tempfile.TemporaryDirectory(dir=options.folder) as folder:
        for name, points in inputs(options):
            path = Path(folder) / name
            write_points(path, points)
            first = looked_at(peers, ways, path, Path(folder), options.limit)
            libraries.update({way[0]: found["library"] for way, found in first.items() if "library" in found})
            runs = {way: [] for way in ways}
            for _ in range(options.repetitions):
                for way in ways:
                    if not any("left_out" in found for found in [first[way], *runs[way]]):
                        runs[way].append(run(peers, way, [path], options.limit))
            yield from (record(name, len(points), way, first[way], runs[way]) for way in ways)


def version_of_mpi():
    return subprocess.run(["mpirun", "--version"], stdout=subprocess.PIPE, text=True, check=True).stdout.splitlines()[0]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--peers", nargs="+", required=True, metavar="NAME=PROGRAM")
    parser.add_argument("--surface", required=True, metavar="FILE.off")
    parser.add_argument("--points", type=int, default=200000, help="how many the others have; the sphere a quarter at least")
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--many", type=int, default=16, help="tiles of a rank (16)")
    parser.add_argument("--only", nargs="+", help="names of inputs")
    parser.add_argument("--repetitions", type=int, default=3)
    parser.add_argument("--limit", type=int, default=120, help="seconds of a run (120)")
    parser.add_argument("--folder", help="for points and cells")
    parser.add_argument("--output", type=Path, default=Path("tiles_peers.json"))
    options = parser.parse_args()
    report = {"command": shlex.join(["measure_tiles_peers.py", *sys.argv[1:]]),
              "machine": {"cpu": cpu(), "cores": os.cpu_count(), "system": platform.platform(), "mpi": version_of_mpi(),
                          "date": time.strftime("%Y-%m-%d"), "load_before": os.getloadavg()[0]},
              "repetitions": options.repetitions, "libraries": {}}
    report["results"] = list(measured(options, report["libraries"]))
    report["machine"]["load_after"] = os.getloadavg()[0]
    options.output.write_text(json.dumps(report, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
