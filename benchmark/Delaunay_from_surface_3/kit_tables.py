# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""What the kits of the Python module and the npm package gain, from what measure_learning.py, measure_topology.py,
measure_materials.py, measure_interpolation.py and measure_npm.py wrote."""

from manual_tables import cell, measured, table, thousands
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


def wrong_of(way):
    """What is wrong with tetrahedra: flat, facets of those that overlap, facets within the hull where there is a gap."""
    found = way.get("tetrahedra", {})
    names = {"flat": "flat", "facets_of_overlapping": "overlaps", "facets_without_neighbor": "gaps"}
    faults = [f"{found[key]:,} {name}" for key, name in names.items() if found.get(key)]
    return f' ({", ".join(faults)})' if faults else ""


def npm(report, peers_report):
    """A call beside the native core and other packages, and sizes."""
    peers = peers_report["peers"]
    of_peers = {(r["what"], r["points"]): r["ways"] for r in peers_report["results"]}
    limits = sorted({way["left_out"] for ways in of_peers.values() for way in ways.values() if "left_out" in way})
    rows, size = [], report["bytes"]
    for r in report["results"]:
        ways, others = r["ways"], of_peers[r["what"], r["points"]]
        if not ways["delaunay-3"]["same_as_native"]:
            raise ValueError(f"{r['what']}: WebAssembly has other tetrahedra")
        ours, native = (ways[name]["least_cpu"] for name in ("delaunay-3", "native"))
        rows.append([r["what"], thousands(r["points"]), f"{ours:.3f}", f"{native:.3f}",
                     *(cell(others.get(peer, {}).get("median_cpu"), "{:.2f}") + wrong_of(others.get(peer, {})) for peer in peers)])
    return "\n\n".join([
        f"CPU seconds of the first call in a process, in which WebAssembly is still being compiled. Node.js {report['node']}; "
        f"{', '.join(f'`{peer}` {version}' for peer, version in peers.items())}. In parentheses what is wrong: flat tetrahedra, "
        "facets of tetrahedra that overlap, and facets within the hull with one tetrahedron, as another is missing. "
        f"{measured(report, peers_report)}",
        table(["", "points", "`delaunay-3`", "the same C++ natively", *(f"`{peer}`" for peer in peers)], rows),
        f"–: {', '.join(limits)}, or not tried. `delaunay_3.wasm` has {size['wasm'] / 1e3:.0f} kB, by gzip "
        f"{size['wasm_gzip'] / 1e3:.0f} kB; the tarball of the package {size['tarball'] / 1e3:.0f} kB."])
