# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The table of the manual that has other programs beside this package, from what measure_threads --peer measured."""

from manual_tables import cell, table
from order_tables import geometric_mean
from results import size_name

OURS = ["default", "default until the export"]


def library_of(peer):
    """TetGen 1.5: TetGen"""
    return peer.get("library", peer["method"]).split(",")[0].split()[0]


def peers_of(result):
    """Those that ran."""
    return [peer for peer in result.get("peers", []) if "left_out" not in peer and "median_wall" in peer]


def seconds_of(result, threads):
    """{program: seconds on the clock} of those that use so many threads."""
    times = result["times"]
    ours = times[f"threads_{threads}"]
    cgal = times["plain" if threads == 1 else "plain_parallel"]["median_wall"]
    return {"CGAL": cgal, **dict(zip(OURS, (ours["median_wall"], ours["median_until_export"]))),
            **{library_of(peer): peer["median_wall"] for peer in peers_of(result) if peer.get("threads", 1) == threads}}


def means(lines, programs):
    """The other programs' times over each of ours."""
    for ours in OURS:
        ratios = {p: [found[p] / found[ours] for found in lines if p in found] for p in programs if p not in OURS}
        yield f"geometric mean, / {ours}", [f"{geometric_mean(r):.2f}" if (r := ratios.get(p)) else None
                                            for p in programs]


def differences(results):
    names = {result["surface"]: sorted({library_of(p) for p in peers_of(result) if not p["has_as_many_tetrahedra"]})
             for result in results}
    found = "; ".join(f"on {surface}: {', '.join(libraries)}" for surface, libraries in names.items() if libraries)
    return "Other numbers of tetrahedra than plain %CGAL: " + (found or "none") + "."


def peers_block(reports):
    """Of the reports of measure_threads."""
    results = [result for report in reports for result in report["results"] if "peers" in result]
    numbers = sorted({int(key.split("_")[1]) for result in results for key in result["times"]
                      if key.startswith("threads_")})
    programs = ["CGAL", *OURS, *dict.fromkeys(library_of(p) for result in results for p in peers_of(result))]
    rows = []
    for threads in numbers:
        lines = [seconds_of(result, threads) for result in results]
        rows += [[result["surface"], str(threads)] + [cell(line.get(p), "{:.3f}") for p in programs]
                 for result, line in zip(results, lines)]
        rows += [[title, str(threads)] + [cell(v) for v in values] for title, values in means(lines, programs)]
    libraries = dict.fromkeys(p["library"] for result in results for p in peers_of(result) if "library" in p)
    loads = [r["machine"][key] for r in reports for key in ("load_before", "load_after") if key in r["machine"]]
    return "\n".join([table(["surface", "threads", *programs], rows), "", differences(results), "",
                      *(f"- {library}" for library in libraries), "",
                      f"Points: {', '.join(sorted({str(result['points']) for result in results}))}. Load average "
                      f"before and after: {', '.join(f'{load:.1f}' for load in loads)}."])
