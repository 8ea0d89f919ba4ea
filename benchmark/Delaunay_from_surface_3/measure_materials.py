# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Compares Voronoi cells of the Python module with those of Voro++ and SciPy, in turns, and writes JSON.

    python3 measure_materials.py [--atoms N...] [--repetitions N] [--output FILE]

For atoms at random, in a crystal that is shaken, and in one that is not, in a periodic box: CPU seconds until all
have volumes, surface areas, and facets with areas, by one thread. The module's time is also given in parts, and that
of solid angles apart. Voro++ is asked by a program that is compiled here with -O3 -DNDEBUG, keeps the same in memory
and prints sums; its grid has six atoms for each block. SciPy has no boxes: it takes the atoms alone, and gives
volumes by a ConvexHull of each bounded cell. Only so many cells as --hulls says are measured, and their time is
multiplied.

Each call is in a process of its own, whose peak of memory is given, too. Voro++ is left out where it is not found.
"""

import argparse
import json
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import scipy.spatial

import delaunay_from_surface as dfs
from measure_python import begun, seconds, write

VORO = r"""
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>
#include <sys/resource.h>
#include <voro++/voro++.hh>

int main(int, char** arguments)
{
  const double box = std::atof(arguments[1]);
  const std::size_t n = std::strtoul(arguments[2], nullptr, 10);
  std::vector<double> points(3 * n);
  if (std::fread(points.data(), 24, n, stdin) != n)
    return 1;
  const double begin = double(std::clock()) / CLOCKS_PER_SEC;
  const int blocks = int(std::cbrt(double(n) / 6)) + 1;
  voro::container cells(0, box, 0, box, 0, box, blocks, blocks, blocks, true, true, true, 8);
  for (std::size_t i = 0; i < n; ++i)
    cells.put(int(i), points[3 * i], points[3 * i + 1], points[3 * i + 2]);
  std::vector<double> volumes(n), surfaces(n), areas, of_facets;
  std::vector<int> neighbors, of_cell;
  voro::c_loop_all loop(cells);
  voro::voronoicell_neighbor cell;
  if (loop.start())
    do
      if (cells.compute_cell(cell, loop)) {
        volumes[loop.pid()] = cell.volume();
        surfaces[loop.pid()] = cell.surface_area();
        cell.neighbors(of_cell);
        cell.face_areas(areas);
        neighbors.insert(neighbors.end(), of_cell.begin(), of_cell.end());
        of_facets.insert(of_facets.end(), areas.begin(), areas.end());
      }
    while (loop.inc());
  const double end = double(std::clock()) / CLOCKS_PER_SEC;
  double volume = 0, surface = 0;
  for (std::size_t i = 0; i < n; ++i) {
    volume += volumes[i];
    surface += surfaces[i];
  }
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  std::printf("{\"cpu\": %.4f, \"volume\": %.17g, \"surface\": %.17g, \"peak\": %ld}", end - begin, volume, surface,
              usage.ru_maxrss * 1024);
}
"""


def atoms_of(kind, n):
    """About n atoms, in a box with edges of the same length."""
    random = np.random.default_rng(1)
    if kind == "random":
        return random.random((n, 3)), 1.
    edge = round((n / 4) ** (1 / 3))
    cubes = np.stack(np.meshgrid(*3 * [np.arange(edge)], indexing="ij"), axis=-1).reshape(-1, 1, 3)
    atoms = (cubes + [[0, 0, 0], [0, .5, .5], [.5, 0, .5], [.5, .5, 0]]).reshape(-1, 3)
    shaken = atoms + .05 * random.random(atoms.shape) if kind == "shaken crystal" else atoms
    return shaken % edge, float(edge)


def by_this_module(kind, n):
    atoms, box = atoms_of(kind, n)
    triangulation, diagram = seconds(lambda: dfs.delaunay3(atoms, box=(box, box, box)))
    facets, _ = seconds(lambda: diagram.voronoi_facets)
    sums, (volumes, areas) = seconds(lambda: (diagram.voronoi_volumes, diagram.voronoi_areas))
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
    return {"cpu": triangulation + facets + sums, "triangulation": triangulation, "facets": facets,
            "volumes_and_areas": sums, "solid_angles": seconds(lambda: diagram.solid_angles)[0],
            "volume": volumes.sum(), "surface": areas.sum(), "peak": peak}


def by_scipy(kind, n, hulls):
    atoms, _ = atoms_of(kind, n)
    diagram_time, voronoi = seconds(lambda: scipy.spatial.Voronoi(atoms))
    regions = [region for region in (voronoi.regions[i] for i in voronoi.point_region) if region and -1 not in region]
    some = regions[:hulls]
    hull_time, _ = seconds(lambda: [scipy.spatial.ConvexHull(voronoi.vertices[region]).volume for region in some])
    return {"cpu": diagram_time + hull_time * len(regions) / max(len(some), 1), "diagram": diagram_time,
            "peak": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024}


def by_voro(program, kind, n):
    atoms, box = atoms_of(kind, n)
    done = subprocess.run([program, repr(box), str(len(atoms))], input=atoms.tobytes(), check=True, capture_output=True)
    return json.loads(done.stdout)


def compiled(folder):
    """Voro++'s program, if it can be made."""
    if shutil.which("c++") is None or not Path("/usr/include/voro++/voro++.hh").exists():
        print("skipped: Voro++ or a compiler was not found")
        return None
    source, program = Path(folder) / "cells.cpp", Path(folder) / "cells"
    source.write_text(VORO, encoding="ascii")
    subprocess.run(["c++", "-O3", "-DNDEBUG", source, "-lvoro++", "-o", program], check=True)
    return program


def alone(*arguments):
    """What this program prints when it is called for one of the above."""
    command = [sys.executable, __file__, "--alone", *map(str, arguments)]
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    return json.loads(done.stdout)


def line(kind, n, repetitions, hulls, program):
    rounds = []
    for _ in range(repetitions):
        results = {"ours": alone("ours", kind, n, hulls), "scipy": alone("scipy", kind, n, hulls)}
        if program is not None:
            results["voro"] = by_voro(program, kind, n)
            for name in ("volume", "surface"):
                if abs(results["voro"][name] / results["ours"][name] - 1) > 1e-9:
                    raise RuntimeError(f"{kind}: the sums of {name}s differ: {results}")
        rounds.append(results)
    medians = {who: {name: round(statistics.median(results[who][name] for results in rounds), 4)
                     for name in rounds[0][who]} for who in rounds[0]}
    ratios = {f"{who}_over_ours": round(medians[who]["cpu"] / medians["ours"]["cpu"], 2)
              for who in medians if who != "ours"}
    return {"atoms": kind, "number": len(atoms_of(kind, n)[0]), **ratios, **medians}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--atoms", nargs="+", type=int, metavar="N", default=[100000])
    parser.add_argument("--repetitions", type=int, default=3)
    parser.add_argument("--hulls", type=int, default=2000)
    parser.add_argument("--output", default="python_materials.json")
    parser.add_argument("--alone", nargs=4, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.alone is not None:
        who, kind, n, hulls = options.alone
        result = by_this_module(kind, int(n)) if who == "ours" else by_scipy(kind, int(n), int(hulls))
        print(json.dumps(result))
        return
    report = {**begun(options), "results": []}
    with tempfile.TemporaryDirectory() as folder:
        program = compiled(folder)
        for n in options.atoms:
            for kind in ("random", "shaken crystal", "crystal"):
                report["results"].append(line(kind, n, options.repetitions, options.hulls, program))
                print(json.dumps(report["results"][-1]))
    write(report, options.output)


if __name__ == "__main__":
    main()
