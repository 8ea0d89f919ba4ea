# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Inputs that are hard for some order or for arithmetic, from what measure_orders and measure_flat_and_far wrote; and
other programs, by measure_threads --peer."""

import math

from manual_tables import cpu_of, geometric_mean, measured, range_of, table, thousands
from speed_tables import is_cad, two

SIZES = (3000, 20000, 200000)


def size_of(row, sizes):
    return min(sizes, key=lambda n: abs(math.log(n / row["points"])))


def name_of(row):
    parts = [row["family"], row["kind"] if is_cad(row) or row["family"] == "sheet" else "",
             "points alone" if row.get("inserted") == "points" else ""]
    return ", ".join(filter(None, parts))


def line(title, rows):
    ratios = [r["median_ratio"] for r in rows]
    least = min(rows, key=lambda r: r["median_ratio"])
    return [title, name_of(least), str(len(rows)), two(geometric_mean(ratios)), two(min(ratios))]


def hard(orders, orders_200k, walks, flat):
    rows = [r for report in (orders, orders_200k) for r in report["results"]]
    lines = [line(f"{title}, {thousands(n)}", [r for r in rows if size_of(r, SIZES) == n and is_cad(r) == cad])
             for title, cad in (("CAD solids", True), ("other surfaces", False)) for n in SIZES]
    tori = [r for r in walks["results"] if r["family"] == "smooth torus"]
    lines.append(line("smooth tori, 300,000 to 800,000", tori))
    large = [r for r in flat["results"] if r["points"] > 50000]
    for title, families in (("thin sheets, a thin tube, 100,000", ("sheet", "tube")),
                            ("points far away, 100,000", ("every tenth point far away", "sentinels")),
                            ("all equal, or on a line, 100,000", ("all points equal", "collinear")),
                            ("in one plane, 100,000", ("coplanar",))):
        lines.append(line(title, [r for r in large if r["family"] in families]))
    return f"{measured(orders, orders_200k, walks, flat)}\n\n" + table(
        ["surfaces, points", "the hardest", "how many", "geometric mean", "least"], lines, 2)


def boxes(walks):
    """Points at random in boxes that are long, or flat."""
    found = {r["kind"]: r["median_ratio"] for r in walks["results"] if r["family"] == "points alone"}
    rows = [[f"1/{a}", two(found[f"box 1 : 1/{a} : 1/{a}"]), two(found[f"slab 1 : 1 : 1/{a}"])]
            for a in (100, 1000, 10000)]
    return f"{measured(walks)}\n\n" + table(["a", "box 1 : a : a", "slab 1 : 1 : a"], rows)


def library_of(peer):
    """TetGen 1.5: TetGen"""
    return peer.get("library", peer["method"]).split(",")[0].split()[0]


def peers_of(result):
    """Those that ran."""
    return [peer for peer in result.get("peers", []) if "left_out" not in peer and "median_wall" in peer]


def ratios_of_peers(report):
    """{(threads, program): {surface: its time / that of this package until it has all tetrahedra}}"""
    ratios = {}
    for result in report["results"]:
        for peer in peers_of(result):
            threads = peer.get("threads", 1)
            ours = result["times"][f"threads_{threads}"]["median_until_export"]
            ratios.setdefault((threads, library_of(peer)), {})[result["surface"]] = peer["median_wall"] / ours
    return dict(sorted(ratios.items()))


def plain_beside(report):
    """Rows as those of peers(): whole calls of plain CGAL / of this package."""
    times = [(result["surface"], result["times"]) for result in report["results"]]
    for threads, plain in ((1, "plain"), (2, "plain_parallel")):
        of = [t[plain]["median_wall"] / t[f"threads_{threads}"]["median_wall"] for _, t in times]
        yield ["plain %CGAL, whole calls", str(threads), *map(two, of), two(geometric_mean(of))]


def peers(report):
    surfaces = [result["surface"] for result in report["results"]]
    rows = list(plain_beside(report))
    rows += [[program, str(threads), *(two(of.get(surface)) for surface in surfaces), two(geometric_mean(of.values()))]
            for (threads, program), of in ratios_of_peers(report).items()]
    return "\n\n".join([measured(report), table(["program", "threads", *surfaces, "geometric mean"], rows),
                        differences(report["results"])])


def differences(results):
    names = {result["surface"]: sorted({library_of(p) for p in peers_of(result) if not p["has_as_many_tetrahedra"]})
             for result in results}
    found = "; ".join(f"on {surface}: {', '.join(libraries)}" for surface, libraries in names.items() if libraries)
    return f"Numbers of tetrahedra that differ from plain %CGAL's: {found or 'none'}."


def peers_of_readme(report):
    """One sentence, of one thread."""
    found = {}
    for (threads, program), of in ratios_of_peers(report).items():
        if threads == 1:
            found[program] = range_of(of.values(), "{:.1f}")
    times = ", ".join(f"{name} {times}" for name, times in found.items())
    return (f"Time of other programs until all tetrahedra are computed / that of this package, on {len(report['results'])} "
            f"surfaces and one thread: {times} ({cpu_of(report)}, {report['machine']['date']}).")


def tiles(report, number=64):
    """What tiles keep and are told, for each point of their own."""
    rows = []
    for result in report["results"]:
        c = next(c for c in result["counts"] if c["tiles"] == number)
        rows.append([result["input"], f'{c["kept"]["mean"]:.1f}', f'{c["kept"]["worst"]:.1f}',
                     f'{c["told"]["mean"]:.1f}'])
    points = thousands(max(result["points"] for result in report["results"]))
    return "\n\n".join([f"{points} points, {number} tiles: `{report['name']}`.",
                        table(["points", "kept", "kept by the worst", "told"], rows)])
