# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""What uses gain, from what measure_consumers, measure_spanning_trees, measure_sources, measure_gaussians, measure_moved,
measure_python.py, measure_tiles_peers.py and measure_compile_time.py wrote; and which parts have an inside, by
inside_of_parts.py."""

from manual_tables import cell, marked, measured, range_of, table, thousands
from speed_tables import two

USES = {  # as measure_consumers calls them, and as the page does
    "points in a cube": "points in a cube",
    "surface: pairs of points and infos": "points with infos",
    "surface: points alone, in the order of the input": "vertices in the order of the points",
    "surface: points alone, Fast_location": "`Fast_location`",
    "surface: points alone, exact constructions": "exact constructions",
    "surface: points alone, numbers of type float": "coordinates of type float",
    "advancing front": "advancing front",
    "alpha shape, one alpha": "alpha shape, one alpha",
    "alpha shapes, all alphas": "alpha shapes, all alphas",
    "Voronoi vertices": "Voronoi vertices",
    "advancing front of COLMAP": "advancing front of COLMAP, coordinates of type float"}


def uses(report):
    found = {r["consumer"]: r for r in report["results"]}
    rows = [[title, two(found[name]["median_plain_cpu"]), f'{found[name]["median_ratio"]:.2f}']
            for name, title in USES.items() if name in found]
    return "\n\n".join([measured(report), table(["use", "plain %CGAL, s", "gain"], marked(rows, 2))])


def spanning_trees(report):
    """What trees cost beside the triangulation of this package, which is 1."""
    rows = []
    for r in report["results"]:
        whole = r["median_triangulation_cpu"]
        rows.append([r["surface"], thousands(r["points"]), two(whole), two(r["median_finite_edges_cpu"]),
                     *(two(r[f"median_{name}_cpu"]) for name in ("tree", "tree_of_arrays", "contains")),
                     f'{r["median_tree_cpu"] / whole:.2f}'])
    return "\n\n".join([measured(report), table(["surface", "points", "triangulation, s", "loop and Boost, s", "tree, s",
                                                  "tree of arrays, s", "surface contains it, s", "tree / triangulation"], rows, 2)])


def sources(report):
    """Of surfaces made as users make them."""
    results, worst = report["results"], {}
    for r in results:
        worst[r["consumer"]] = min(r["triangles_delaunay"], worst.get(r["consumer"], 1))
    least = ", ".join(f"{100 * share:.0f} % ({name})" for name, share in sorted(worst.items(), key=lambda item: item[1])
                      if share < 0.999)
    return (f"The gain on {len(results)} surfaces is {range_of([r['median_ratio'] for r in results], '{:.2f}')}. On most of them "
            f"99.9 % of the triangles or more are Delaunay; on the others it is {least}. {measured(report)}")


def cluster(large, small):
    """What tiles of an elephant would send if each were on a machine of its own."""
    counts, others = ({c["tiles"]: c for c in next(r for r in report["results"] if r["input"] == "elephant")["counts"]}
                      for report in (large, small))

    def sent(count):
        return [f'{count["load"]["bytes_sent_per_own_point"][which]:.0f}' for which in ("mean", "worst")]

    many, few, crowded = counts[1024], counts[64], others[1024]
    if many["pairs_that_differed"] or not crowded["pairs_that_differed"]:
        raise ValueError("other tiles had to be shown where they differ than the text says")
    (mean, worst), (mean_64, worst_64) = sent(many), sent(few)
    return (f"With two million points of an elephant in 1024 tiles, each on a machine of its own, a tile sends {mean} bytes for "
            f"each of its points, and the worst tile {worst}, in {many['rounds']} rounds. With 64 tiles these are {mean_64} and "
            f"{worst_64} bytes. Tiles should have at least a thousand points: with three hundred, {crowded['rounds']} rounds were "
            f"needed (`{large['name']}.json`, `{small['name']}.json`).")


def mpi(report, *loads):
    """Times of tiles by MPI; and those calculated for more ranks from what their tiles of an elephant keep and send."""
    rows, alone = [], next(r for r in report["results"] if r.get("ranks") == 1)
    for r in report["results"]:
        rows.append([r["points"], f'{r["ranks"]} by MPI' if "ranks" in r else "arrays", f'{r["seconds"]:.2f}',
                     f'{100 * r["share_of_exchange"]:.0f}' if "ranks" in r else "–"])
    counted = [(r["points"], c) for load in loads for r in load["results"] if r["input"] == "elephant" for c in r["counts"]]
    for points, c in counted:
        if not c["pairs_that_differed"]:
            own = points / c["tiles"]
            work = own * c["kept"]["worst"] * alone["seconds"] / alone["kept"]
            exchange = (own * (32 + c["load"]["bytes_received_per_own_point"]["worst"]) / 1e9
                        + c["load"]["most_messages_of_a_tile"] * 1e-5)
            rows.append([points, f'{c["tiles"]}, calculated', f"{work + exchange:.3f}", f"{100 * exchange / (work + exchange):.0f}"])
    of = {}
    for n, ranks, *others in sorted(rows, key=lambda row: row[0]):
        of.setdefault((n, ranks), [thousands(n), ranks, *others])  # as many, and as many for each, may be the same
    rows = list(of.values())
    return "\n\n".join([f"Points of an elephant in memory, one tile per rank (`{report['name']}`). Calculated rows take the worst "
                        "tile of `tiles_load` and `tiles_load_2M`, the time per point kept of a single rank, a billion bytes a "
                        "second, and 10 µs per message.",
                        table(["points", "ranks", "s", "exchange, %"], rows, 2)])


MPI_PEERS = {"ours": "this package", "tess2": "tess2", "madvoro": "MadVoro", "tess2-qhull": "tess2 by Qhull"}


def held_in_many(of):
    """Points that all tiles hold for each point, where a rank has many."""
    many = sorted({key[2:] for key in of if key[3] > 1})[-1]
    shares = {(name, peer): f'{r["points_held"] / r["points"]:.1f}' for (name, peer, *way), r in of.items()
              if tuple(way) == many and peer in ("ours", "tess2")}
    texts = [f'{name} {shares[name, "ours"]} and {shares[name, "tess2"]}' for name in dict.fromkeys(name for name, _ in shares)]
    return f"Points that {many[0] * many[1]} tiles hold for each point, by this package and by tess2: {', '.join(texts)}."


def is_wrong(r):
    return bool(r.get("missing") or r.get("others") or abs(r.get("volume_by_box", 1) - 1) > 1e-9)


def who_is_wrong(*results):
    """The first of its results that is."""
    wrong = {}
    for of in results:
        for (name, peer, ranks, _), r in of.items():
            if is_wrong(r):
                right = of[name, "ours", ranks, 1]["tetrahedra"]
                found = f'{thousands(r["tetrahedra"])} tetrahedra, not {thousands(right)}' if "tetrahedra" in r else "other faces"
                wrong.setdefault(f"{name}, {MPI_PEERS[peer]}", found)
    return "Wrong: " + ("; ".join(f"{key} ({found})" for key, found in wrong.items()) or "none that ended") + "."


def row_of_peers(name, ranks, of):
    """Seconds of all; megabytes of a rank and sent, without those by Qhull."""
    found = {peer: of.get((name, peer, ranks, 1), {}) for peer in MPI_PEERS}
    few = [found[peer] for peer in list(MPI_PEERS)[:3]]
    return [f'{name}, {thousands(found["ours"]["points"])}', str(ranks),
            *(cell(r.get("median_wall"), "{:.2f}") for r in found.values()),
            *(cell(r.get("peak_bytes_of_a_rank", 0) / 1e6 or None, "{:.0f}") for r in few),
            *(cell(r.get("bytes_sent", 0) / 1e6 or None, "{:.1f}") for r in few)]


def tiles_peers(report, large):
    """Of Voronoi diagrams only what they have is compared. Of many points there are only some programs."""
    of, of_large = ({(r["input"], r["peer"], r["ranks"], r["tiles_of_a_rank"]): r for r in some["results"]}
                    for some in (report, large))
    rows = [row_of_peers(*which, found) for found in (of, of_large)
            for which in dict.fromkeys((name, ranks) for name, _, ranks, _ in found)]
    names = list(MPI_PEERS.values())
    titles = ["points", "ranks", *(f"{name}, s" for name in names),
              *(f"{name}, MB{what}" for what in (" of a rank", " sent") for name in names[:3])]
    reasons = sorted({r["left_out"] for r in report["results"] if "left_out" in r})
    libraries = "; ".join(library for peer, library in report["libraries"].items() if peer != "ours")
    return "\n\n".join([f"{libraries}. {measured(report, large)}", table(titles, rows, 2),
                        f"–: nothing sent, {', '.join(reasons)}, or not tried. {who_is_wrong(of, of_large)} {held_in_many(of)}"])


def python(report):
    rows = [[f'{r["consumer"]}, {thousands(r["points"])}', "SciPy", two(r["median_scipy_cpu"]), two(r["median_ours_cpu"]),
             f'{r["median_ratio"]:.0f}', cell(r.get("median_speedup"), "{:.2f}")]
            for r in report["results"] + report["queries"]]
    rows += [[f'a bumpy sphere, {thousands(r["points"])}', "VTK", two(r["median_vtk_cpu"]),
              two(r["median_ours_cpu"]), f'{r["median_vtk_cpu"] / r["median_ours_cpu"]:.0f}', "–"]
             for r in report["vtk"]]
    lost = ", ".join(f'{r["tetrahedra"] - r["tetrahedra_of_vtk"]:,} of {r["tetrahedra"]:,}' for r in report["vtk"])
    return "\n\n".join([f'Python {report["python"]}, NumPy {report["numpy"]}, SciPy {report["scipy"]}: `{report["name"]}`.',
                        table(["what, points", "compared with", "its CPU s", "ours", "gain", "one thread / two"], rows, 2),
                        f"VTK loses {lost} tetrahedra to rounding."])


def gaussians(in_python, *reports):
    """The loop of Tetra-NeRF beside this package in C++, and triangulate() in Python on points made in the same way."""
    of_python = {round(r["points"], -6): r["ways"] for r in in_python["results"]}
    rows = []
    for report in reports:
        plain, *checked = report["results"]
        ways = of_python.get(round(plain["points"], -6))
        rows.append([thousands(plain["points"]), thousands(plain["tetrahedra"]), f'{plain["median_plain_cpu"]:.1f}',
                     cell(checked[0]["median_plain_cpu"] if checked else None, "{:.1f}"), f'{plain["median_ours_cpu"]:.1f}',
                     f'{plain["median_ratio"]:.1f}',
                     *(cell(ways and ways[f"triangulate, {threads}"]["median_wall"], "{:.1f}") for threads in (1, 2))])
    return "\n\n".join([measured(in_python, *reports),
                        table(["points", "tetrahedra", "loop with plain CGAL, s", "with `is_valid()`", "this package", "gain",
                               "`cpp.triangulate()`, one thread", "two"], rows)])


def moved(report, in_python):
    rows = [[f'{r["consumer"]}, C++', two(r["median_plain_cpu"]), two(r["peers"][0]["median_cpu"]),
             two(r["median_new_order_cpu"]), two(r["median_kept_order_cpu"])] for r in report["results"]]
    names = ("geogram_binding", "new_order", "kept_order")
    rows += [[f'{r["what"]}, Python', "–", *(two(r["median_wall"][name]) for name in names)]
             for r in in_python["rebuilds"]]
    titles = ["one rebuild, s", "plain %CGAL", "Geogram", "new order", "order kept"]
    return "\n\n".join([measured(report, in_python), table(titles, rows)])


NAMES = {"ours": "this module", "geogram_binding": "Geogram", "tetgen_binding": "TetGen", "open3d_binding": "Open3D"}


def named(way):
    name, threads = way.rsplit(", ", 1)
    return [NAMES.get(name, name), threads]


def python_peers(report):
    """The same rows for all inputs."""
    cube, surface = (r["ways"] for r in report["results"])
    rows = [named(way) + [text for ways in (cube, surface) for text in
                          ((ways[way]["left_out"], "") if "left_out" in ways[way] else
                           (two(ways[way]["median_wall"]), f'{ways[way]["peak_megabytes"]:,}'))] for way in cube]
    points = thousands(max(r["points"] for r in report["results"]))
    return "\n\n".join([f"{points} points, wall-clock seconds and peak megabytes. {measured(report)}",
                        table(["", "threads", "in a cube, s", "MB", "of a surface, s", "MB"], rows)])


def faults(report):
    """On one thread."""
    def texts(result):
        found = result.get("tetrahedra")
        return [result["left_out"], ""] if found is None else [
            two(result["median_wall"]),
            " / ".join(f'{found[key]:,}' for key in ("flat", "facets_of_overlapping", "facets_without_neighbor"))]

    rows = [[named(way)[0]] + [text for r in report["faults"] for text in texts(r["ways"][way])]
            for way in report["faults"][0]["ways"] if way.endswith(", 1")]
    titles = [title for r in report["faults"] for title in (f'{r["what"]}, {thousands(r["points"])}: s', "faults")]
    return "\n\n".join([f"One thread, wall-clock. {measured(report)}", table(["", *titles], rows)])


def python_of_readme(report):
    ratios = [r["median_ratio"] for r in report["results"]]
    points = max(r["points"] for r in report["results"])
    vtk = "".join(f', and on {r["points"]:,} points {r["median_vtk_cpu"] / r["median_ours_cpu"]:.0f} times as fast as '
                  "`vtkDelaunay3D`" for r in report["vtk"])
    return (f"On {points:,} points, with tetrahedra and neighbours, the module is {range_of(ratios, '{:.0f}')} times as fast as "
            f'`scipy.spatial.Delaunay` (SciPy {report["scipy"]}){vtk}.')


def python_threads(report):
    """From how many points on two threads pay; what an import and a wheel cost."""
    gains = {r["points"]: r["least_speedup"] for r in report["results"]}
    first = min(n for n in gains if all(gain >= 1 for m, gain in gains.items() if m >= n))
    pays = ", ".join(f"{gain:.2f} times at {n:,}" for n, gain in gains.items() if n > first)
    wheel = f', a wheel has {report["wheel_bytes"] / 1e6:.1f} MB' if "wheel_bytes" in report else ""
    return (f"Two threads are faster than one from about {first:,} points on ({pays}). With fewer they take up to "
            f'{1 / min(gains.values()):.2f} times as long (least times of {report["repetitions"]} runs). An import takes '
            f"{1000 * report['import_cpu']:.0f} ms of CPU beyond NumPy's{wheel}. {measured(report)}")


def compile_time(report):
    rows = [[c["compiler"].replace("(Debian 12.2.0-14+deb12u1) ", "").replace("Debian ", ""),
             *(f'{c[form]["median_user"]:.1f}' for form in ("plain", "package", "compiled")),
             *(str(c[form]["megabytes"]) for form in ("plain", "package", "compiled"))] for c in report["compilers"]]
    return "\n\n".join([f'`{report["flags"]}`, load {range_of(report["load"], "{:.1f}")}: `{report["name"]}`.',
                        table(["compiler", "plain %CGAL, s", "headers", "core compiled", "plain %CGAL, MB", "headers",
                               "core compiled"], rows)])


def counts_of_parts(report):
    of = {kind: [r for r in report["results"] if r["inside"] == kind] for kind in ("closed mesh", "winding numbers", "none")}
    return (f'Of {len(report["results"])} files, {len(of["closed mesh"])} are closed, {len(of["winding numbers"])} have an '
            f'inside by winding numbers, and {len(of["none"])} are open patches and have none.')
