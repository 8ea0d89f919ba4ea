# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The tables of the manual's page on the paper, from what location_costs, measure_subgraphs, measure_uniform_samples,
compare_with_plain, count_instructions.py and measure_single_calls.py wrote."""

import statistics

from manual_tables import cell, measured, range_of, table
from speed_tables import gain, surface_of, two

EMST = "Euclidean minimum spanning tree"
PARTS = {  # what the calls are for: colour, and what is counted beside them
    "location": ("#0072b2", "nodes"), "traces": ("#e69f00", "cells"), "records": ("#d00000", "nodes"),
    "updates": ("#9a9a9a", "cells_created")}


def percent(share):
    return "100 %" if share == 1 else f"{100 * share:.1f} %"


# --- the theory ---

def by_seed(report):
    """{(surface, T): {size: the records of all seeds}}"""
    found = {}
    for r in report["work"]:
        found.setdefault((r["surface"], r["T"]), {}).setdefault(r["size"], []).append(r)
    return dict(sorted(found.items(), key=lambda item: (item[0][0] == "genus-50", item[0])))


def work(report):
    """Calls per point, the mean of all seeds, and how far the farthest is from it."""
    found = {surface: records for (surface, T), records in by_seed(report).items() if T == EMST}
    sizes = sorted({size for records in found.values() for size in records})
    rows = []
    for surface, records in found.items():
        cells = []
        for size in sizes:
            calls = [r["calls"] for r in records.get(size, [])]
            middle = statistics.mean(calls) if calls else 0
            cells.append(f"{middle:.0f}±{max(abs(c - middle) for c in calls):.0f}" if calls else "–")
        rows.append([surface, *cells])
    return table(["surface", *(rf"\f$2^{{{size.bit_length() - 1}}}\f$" for size in sizes)], rows)


def mean(records, part, key):
    return statistics.mean(r[part][key] for r in records)


def work_parts(report):
    """The same by parts, at the largest size: nodes or cells, and calls."""
    rows = []
    for (surface, T), records in by_seed(report).items():
        if T != EMST:
            continue
        of_largest = records[max(records)]
        parts = [(part, key) for part, (_, key) in PARTS.items()] + [("location_from_root", "nodes")]
        rows.append([surface] +
                    [f'{mean(of_largest, part, key):.0f}/{mean(of_largest, part, "calls"):.0f}' for part, key in parts])
    return table(["surface", "location: nodes/calls", "traces: cells/calls", "records: nodes/calls",
                  "updates: made/calls", "location from the root"], rows)


def largest_by_surface(report):
    """The largest result of location_costs on each surface, and those from 2^14 points on."""
    found = {}
    for r in sorted(report["results"], key=lambda r: r["size"]):
        found.setdefault(r["surface"], []).append(r)
    return [(results[-1], [r for r in results if r["size"] >= 2**14]) for results in found.values()]


def surfaces(report):
    """How far the assumptions hold, what the traces cross and enter, and what walks cost; all per point."""
    rows = []
    for r, _ in largest_by_surface(report):
        found, ways = r["assumptions"], r["locations"]
        walk = ways["walk-trace"]
        rows.append([
            r["surface"], str(r["points"]), percent(found["subgraph_edges_delaunay"]),
            f'{found["delaunay_cells_per_point"]:.1f}', f'{sum(t["crossings_per_point"] for t in r["traces"]):.1f}',
            f'{ways["plain"]["cells_entered"]:.0f}/{ways["plain"]["calls"]:.0f}',
            f'{walk["cells_entered"]:.0f}+{walk["trace_cells_entered"]:.0f}/'
            f'{walk["calls"] + walk["trace_calls"]:.0f}'])
    return table(["surface", "points", "T in D(S)", "cells of D(S)", "crossings", "plain %CGAL",
                  "from the trace"], rows)


def crossings(report):
    """The largest value of a trace from 2^14 points on over the smallest."""
    factor = {}
    for r, results in largest_by_surface(report):
        series = [[s["traces"][h]["crossings_per_point"] for s in results] for h in range(3)]
        if min(map(min, series)) > 0:
            factor[r["surface"]] = max(max(s) / min(s) for s in series)
    most = max(factor, key=factor.get)
    return (f'By a factor of at most {factor["delaunay-genus-3"]:.2f} on delaunay-genus-3, '
            f'{factor["delaunay-round-genus-3"]:.2f} on the round tubes, and {factor[most]:.2f} on {most}, the largest.')


ORDERS = {"tracing": "the paper's, from the trace",
          "tracing-hilbert": "the same in sorted rounds, from the trace",
          "geometric-traced": "coherent rounds, from the trace",
          "geometric-neighbor": "coherent rounds, from a neighbour on F",
          "plain-order": "plain %CGAL's, from the point before",
          "nets": "nets, from the point they name"}


def genus_50(small, large, calls):
    """Cells entered by traces and walks at three sizes; calls and times at the largest. All with CGAL's insertion."""
    reports = [r for report in (small, large) for r in report["results"] if r["surface"] == "genus-50"]
    reports.sort(key=lambda r: r["points"])
    methods = [{m["method"]: m for m in r["methods"]} for r in reports]
    rows = []
    for name, title in ORDERS.items():
        found = [m[name] for m in methods]
        cells = [sum(m["predicates"][phase]["cells_entered"] for phase in ("trace", "location")) for m in found]
        seconds = found[-1]["phases"]["seconds"]
        rows.append([title, *(f"{c:.0f}" for c in cells), f'{found[-1]["predicates"]["all_calls_per_point"]:.0f}',
                     f'{seconds["trace"] + seconds["location"]:.1f}+{seconds["update"]:.1f}'])
    of_update = {name: [m["phases"]["seconds"]["update"] for report in (small, large) for r in report["results"]
                        for m in r["methods"] if m["method"] == name] for name in ("tracing", "plain-order")}
    longer = [random / plain for random, plain in zip(of_update["tracing"], of_update["plain-order"])]
    whole = next(r for r in calls["results"] if surface_of(r) == "genus-50")
    return (table(["order and start", *(f'cells, {r["points"]}' for r in reports), "calls", "seconds"], rows) +
            f'\n\nThe default is {two(gain(whole, "default"))} times as fast as plain %CGAL here (`{calls["name"]}.json`). In the '
            f'paper\'s random order the same updates take {range_of(longer, "{:.1f}")} times as long as in plain %CGAL\'s, on all '
            "surfaces of these files, since successive points lie far apart in memory.")


CONTROL = {  # method: order, start; all but the last by CGAL's insertion
    "random-last": ("random", "the point inserted last"),
    "random-insert": ("random", "`insert(p)` without a hint"),
    "random-hilbert": ("random", "the nearest inserted point along a Hilbert curve"),
    "random-fast": ("random", "%CGAL's hierarchy, `Fast_location`"),
    "tracing": ("the paper's", "the trace"),
    "tracing-hilbert": ("the paper's sorted rounds", "the trace"),
    "nets": ("nets of the surface", "the point they name"),
    "default": ("the default", "the point it names, in the core")}


def times_of_plain(report):
    """{surface: {method: its CPU time / plain CGAL's}}"""
    found = {}
    for result in report["results"]:
        times = {m["method"]: m["median_cpu"] for m in result["methods"] if "left_out" not in m}
        found[result["surface"]] = {method: time / times["plain"] for method, time in times.items()}
    return found


def control(small, large):
    """What orders and starts cost beside plain CGAL."""
    of_small, of_large = list(times_of_plain(small).values()), times_of_plain(large)
    rows = []
    for method, (order, start) in CONTROL.items():
        shares = [times[method] for times in of_small]
        rows.append([order, start, two(statistics.geometric_mean(shares)), f"{two(min(shares))} to {two(max(shares))}",
                     *(two(times[method]) for times in of_large.values())])
    return measured(small, large) + "\n\n" + table(
        ["order", "start", f"{len(of_small)} surfaces of 64k", "range", *(f"{surface}, 256k" for surface in of_large)], rows, 2)


def control_of_readme(small, large):
    """One sentence."""
    of_large = times_of_plain(large).values()

    def shares(method, other="plain"):
        return range_of([times[method] / times[other] for times in of_large], "{:.1f}")

    return (f"In a random order, traces make %CGAL's insertion {shares('random-last', 'tracing')} times as fast as walks from the last "
            f"point, and {shares('random-fast', 'tracing')} times as fast as %CGAL's hierarchy (`{large['name']}.json`), as the "
            f"paper claims. In plain %CGAL's own order walks are short without a surface; in the paper's, the insertion takes "
            f"{shares('tracing')} times as long, and {shares('tracing-hilbert')} times with sorted rounds.").replace("%CGAL", "CGAL")


def tracing(small, large):
    """One sentence, at the table of traits."""
    found = [times["tracing-hilbert"] for times in times_of_plain(small).values()]
    of_large = [times["tracing-hilbert"] for times in times_of_plain(large).values()]
    return (f"`CGAL::Tracing_traits_3` takes {range_of(found, '{:.1f}')} times as long as plain %CGAL on {len(found)} surfaces of 64k, "
            f"{range_of(of_large, '{:.2f}')} times on {len(of_large)} of 256k (\\ref dfs_paper_control).")


def rounds(report):
    """Cells created and calls per point: random rounds / the same rounds sorted / plain CGAL's order."""
    found = {}
    for r in report["work"]:
        found.setdefault(r["surface"], {}).setdefault(r["size"], []).append(r)
    sizes = sorted({size for of_size in found.values() for size in of_size})
    counted = {"created": ("{:.1f}", lambda r: r["cells"]["created"]),
               "calls": ("{:.0f}", lambda r: r["predicates"]["all_calls_per_point"])}
    rows = []
    for surface in ("torus", "hub", "tube", "genus-50"):
        for what, (form, of) in counted.items():
            rows.append([f"{surface}, {what}", *(
                " / ".join(form.format(statistics.mean(of(r[order]) for r in found[surface][size]))
                           for order in ("random", "sorted", "plain")) if size in found[surface] else "–" for size in sizes)])
    return table(["surface", *(rf"\f$2^{{{size.bit_length() - 1}}}\f$" for size in sizes)], rows)


FREE = {"spatial-sort": "plain %CGAL's", "nets": "nets", "paper": "the paper's sorted rounds, from the trace"}


def floor(report):
    """Instructions of plain CGAL / those of CGAL's insertion in an order, whole, without location, and without the plan, too."""
    meshes = report["insertion_parts"]
    rows = []
    for order, title in FREE.items():
        cells = []
        for mesh in meshes:
            part = mesh["orders"][order]
            whole = mesh["traces"] if order == "paper" else sum(part.values())
            cells += [two(mesh["plain"] / count) for count in (whole, part["plan"] + part["update"], part["update"])]
        rows.append([title, *cells])
    share = [part["update"] / sum(part.values()) for mesh in meshes for order, part in mesh["orders"].items() if order != "paper"]
    names = [mesh["mesh"].split("_")[0] for mesh in meshes]
    return (table(["order", *(f"{name}: {what}" for name in names for what in
                              ("as it is", "location free", "location and plan free"))], rows) +
            f'\n\nUpdates are {100 * min(share):.0f} to {100 * max(share):.0f} % of the instructions in the first two orders.')


CHANGES = [("none", 0), ("jitter", 0.45), ("decimated", 16), ("random edges", 0.01), ("random edges", 1)]


def hypothesis(report):
    rows = []
    for change, amount in CHANGES:
        r = next(r for r in report["hypothesis"]
                 if (r["surface"], r["change"], r["amount"]) == ("delaunay-genus-3", change, amount))
        cells = statistics.mean(t["crossings_per_point"] for t in r["traces"])
        named = f"{change} {amount:g}" if amount else change
        rows.append([named, percent(r["assumptions"]["subgraph_edges_delaunay"]), f"{cells:.2f}",
                     f'{r["locations"]["history-trace"]["cells_entered"]:.2f}'])
    return table(["change of T or of the points", "T in D(S)", "crossings per trace and point", "nodes from the trace"],
                 rows)


def traced(report):
    r = next(r for r in report["subgraphs"] if r["surface"] == "armadillo" and r["size"] == 16384)
    crossed = {T: statistics.mean(t["crossings_per_point"] for t in found["traces"])
               for T, found in r["subgraphs"].items()}
    return ("Minimum spanning trees have the fewest crossings per trace and point: on a scan with noise (armadillo, "
            f'`subgraphs_traced.json`) {crossed[EMST]:.2f}, the subgraph of bounded degree '
            f'{crossed["subgraph of bounded degree"]:.2f}, any spanning forest {crossed["a spanning forest of F"]:.2f}.')


def iso_surfaces(report):
    results = {r["surface"]: r for r in report["subgraphs"]}
    volumes = ("marching-cubes", "noise")
    shares = [results[name]["subgraphs"]["all of F"]["assumptions"]["surface_triangles_delaunay"] for name in volumes]
    made = [results[f"delaunay-{name}"]["iso_surface"] for name in volumes]
    longer = [m["seconds"] / m["plain_seconds"] for m in made]
    return (f'This takes {min(longer):.0f} to {max(longer):.0f} times as long as D(S). With ordinary marching cubes '
            f'{int(100 * min(shares))} % of the triangles or more are Delaunay (`subgraphs_traced_4k.json`).')


def uniform_samples(report):
    rows = []
    for r in report["samples"]:
        if r["all"]["points"] < 60000 or r["sample"] == "denser at one end":
            continue
        for found in [r["all"], *(s for s in r["subsets"] if s["factor"] == 1)]:
            ratio = found["largest_ratio_of_edges"]
            rows.append([f'{r["sample"]}, {"thinned" if "factor" in found else "all"}', str(found["points"]),
                         str(found["surface_largest_degree"]), f'{ratio:.{1 if ratio < 100 else 0}f}',
                         str(found["delaunay_largest_degree"])])
    return table(["sample", "points", "largest degree on the surface", "longest edge / shortest",
                  "largest degree in D(S)"], rows)


# --- the subgraphs ---

def bounds(random, regular):
    found = random["bounds"]
    pairs = (("bound", "maximum_degree"), ("bound_of_tree", "maximum_degree_of_tree"))
    reached = [r["surface"] for r in found if all(r[bound] == r[degree] for bound, degree in pairs)]
    high = next(r for r in found if r["surface"] == "genus 10")
    cut = [r["cut_graph"] for r in regular["degrees"]]
    return (f'Random triangulations of many surfaces (`subgraph_bounds.json`) attain both bounds on '
            f'{", ".join(reached[:-1])} and {reached[-1]}. For genus 10 the largest degree is '
            f'{high["maximum_degree"]} in the subgraph and '
            f'{high["maximum_degree_of_tree"]} in the tree.\n\nOn regular surfaces up to genus 50 it is at most '
            f'{max(r["maximum_degree"] for r in cut)} in the subgraph and {max(r["maximum_degree_of_tree"] for r in cut)} in '
            "the tree. A cut along loops through one vertex gives more vertices of degree 4 and more "
            "(`subgraph_degrees.json`).")


def times(report):
    found = {r["order"]: r for r in report["times"]
             if r["surface"] == "sphere" and r["vertices"] == 1000000}
    of = {order: r["subgraph"]["nanoseconds_per_vertex"] for order, r in found.items()}
    kruskal = found["coherent"]["minimum_spanning_tree"]["nanoseconds_per_vertex"]
    return (f'On a sphere of a million vertices the subgraph takes {of["coherent"]:.0f} nanoseconds per vertex, or '
            f'{of["shuffled"]:.0f} if the vertices are shuffled; Boost\'s Kruskal takes {kruskal:.0f}. The tree and the cut '
            "graph take about as long as the subgraph. Besides the mesh, about 40 bytes per vertex are used "
            "(`subgraph_times.json`).")


def published_degree(genus):
    """Every 3-connected graph on a closed orientable surface has a spanning tree of this degree."""
    return 3 if genus <= 1 else -(-(8 - 2 * (2 - 2 * genus)) // 3)


def near_minimum(report):
    rows, families = [], report["near_minimum"]["families"]
    for r in families:
        if r["genus"] in (2, 3):
            continue
        least = max(r["least_degree_by_witness"], r.get("least_degree", 0))
        rows.append([r["surface"], *(str(r[key]) for key in (
            "genus", "bound_of_the_paper", "maximum_degree_of_subgraph", "maximum_degree_of_tree", "maximum_degree",
            "bound")), str(published_degree(r["genus"])), cell(least or None)])
    kept = sum(r["maximum_degree"] <= min(r["bound"], published_degree(r["genus"])) for r in families)
    return (table(["surface", "genus", "paper", "subgraph", "tree", "after exchanges", "B", "published",
                   "every tree has"], rows) +
            f"\n\nThe search keeps the smaller of B and the published degree on {kept} of {len(families)} such surfaces, "
            "bouquets of genus 2 and 3 among them.")


def near_minimum_times(report):
    rows = []
    for r in report["near_minimum"]["times"]:
        rows.append([r["surface"], f'{r["maximum_degree_of_tree"]}→{r["maximum_degree"]}',
                     *(str(r[key]) for key in ("exchanges_nearby", "phases")),
                     *(cell(r.get(f"nanoseconds_per_vertex_of_{what}"), "{:.0f}")
                       for what in ("tree", "exchanges", "witness"))])
    return table(["surface", "degree", "nearby", "phases", "tree, ns", "exchanges, ns", "witness, ns"], rows)


def near_minimum_files(meshes, parts):
    """How many files have a tree of degree 4 and more, before and after."""
    rows = []
    for report, title in ((meshes, "meshes of %CGAL's demos"), (parts, "parts of openfoam-examples")):
        files = report["files"]
        served = [r for r in files if "refused" not in r]
        rows.append([title, str(len(files)), str(len(served)),
                     *(str(sum(r[key] > 3 for r in served)) for key in ("maximum_degree_of_tree", "maximum_degree"))])
    return table(["files", "all", "accepted", "tree of degree 4 or more", "after exchanges"], rows)
