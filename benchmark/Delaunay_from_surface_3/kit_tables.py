# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""What the kits of the Python module gain, from what measure_learning.py, measure_topology.py, measure_materials.py and
measure_interpolation.py wrote."""

from manual_tables import measured, table, thousands
from speed_tables import two


def seconds_of(ways, name):
    """A time, or a dash where there is none, and why."""
    way = ways.get(name, {})
    return two(way["median_wall"]) if "median_wall" in way else way.get("left_out", "–")


def topology(report):
    names = ["delaunay3, 1", "filtration, 1", "filtration, 2", "GUDHI, exact", "GUDHI, safe"]
    titles = ["`delaunay3()`", "`filtration()`", "two threads", "GUDHI, exact", "GUDHI, safe"]
    rows = [[r["what"], thousands(r["points"]), *(seconds_of(r["ways"], name) for name in names)] for r in report["results"]]
    return "\n\n".join([f"Seconds by the clock on the wall; GUDHI {report['gudhi']}. {measured(report)}",
                        table(["", "points", *titles], rows)])


def interpolation(report):
    names = ["linear, 1", "linear, 2", "natural neighbours, 1", "natural neighbours, 2", "SciPy, linear"]
    rows = [[r["what"], *(seconds_of(r["ways"], name) for name in names), thousands(r["ways"]["SciPy, linear"].get("nan", 0)),
             thousands(r["ways"]["linear, 1"]["nan"])] for r in report["results"]]
    first = report["results"][0]
    return "\n\n".join([
        f"Seconds by the clock on the wall, for {thousands(first['points'])} points or about as many, and {thousands(first['queries'])} "
        f"queries, the triangulation included; and how many results are NaN. SciPy {report['scipy']}. {measured(report)}",
        table(["", "linear", "two threads", "natural neighbours", "two threads", "SciPy, linear", "its NaNs", "NaNs here"], rows)])


def learning(report):
    rows = [[thousands(r["points"]), f'{r["length"]:g}',
             *(two(r["median_wall"][name]) if name in r["median_wall"] else "–" for name in (
                 "moving, 1", "moving, 2", "anew, 1", "tetgen, 1", "scipy, 1")),
             *(two(r["median_wall_of_changes"][name]) for name in ("simplices, 1", "simplices, sorted by NumPy"))]
            for r in report["results"]]
    batch, = report["batches"]
    times = batch["median_wall"]
    return "\n\n".join([
        f"Seconds by the clock on the wall, for points that move by a share of their spacing. {measured(report)}",
        table(["points", "share", "`Moving`", "two threads", "`delaunay3()`", "TetGen", "SciPy", "what changed", "by NumPy"], rows),
        f"A batch of {thousands(batch['sets'])} sets of {thousands(batch['set_size'])} points takes {times['batch, 1']:.2f} s with one "
        f"thread and {times['batch, 2']:.2f} s with two; SciPy in a loop {times['scipy, loop']:.1f} s."])


def materials(report):
    rows = [[r["atoms"], thousands(r["number"]), two(r["ours"]["cpu"]), two(r["ours"]["solid_angles"]),
             *(two(r[who]["cpu"]) if who in r else "–" for who in ("voro", "scipy")),
             f'{r["ours"]["peak"] / 1e6:.0f}', f'{r["voro"]["peak"] / 1e6:.0f}' if "voro" in r else "–"] for r in report["results"]]
    return "\n\n".join([
        "CPU seconds of one thread until all cells in a periodic box have volumes, surface areas and facets with areas, and what solid "
        "angles take beside them; SciPy's are volumes alone, without a box. And the peak of memory of the whole process. "
        f"{measured(report)}",
        table(["atoms", "number", "this module, s", "solid angles, s", "Voro++, s", "SciPy, s", "this module, MB", "Voro++, MB"], rows)])
