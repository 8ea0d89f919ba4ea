# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The tables of the manual's page on the theory, in Markdown, from what location_costs measured."""

from manual_tables import cell, commands_of, machine_of, table

WAYS = {  # colour and label; the order is that of the legends and tables
    "history-root": ("#7a3b00", "history by containment, from the root"),
    "history-trace": ("#d00000", "history by containment, from the last trace"),
    "walk-trace": ("#e69f00", "walk, from the last trace"),
    "walk-neighbor": ("#56b4e9", "walk, from the nearest surface neighbour"),
    "fast-location": ("#009e73", "Fast_location, random order"),
    "plain": ("#000000", "plain CGAL: spatial sort, previous point"),
    "walk-random": ("#8a8a8a", "walk, from a random point"),
}
LARGE = 2**14  # from this size on the constants of Theorem 3 are looked at


def by_surface(report):
    """{surface: its results from the smallest size to the largest}"""
    results = sorted(report["results"], key=lambda r: r["size"])
    found = {name: [r for r in results if r["surface"] == name] for name in report["surfaces"]}
    return {name: results for name, results in found.items() if results}


def all_crossings(result):
    """Of all traces, per point."""
    return sum(t["crossings_per_point"] for t in result["traces"])


def mean_crossings(result):
    """Per trace and point."""
    return all_crossings(result) / len(result["traces"])


def cells_of_traces(result):
    """Cells that the traces enter for a point that they locate."""
    return (sum(t["cells_entered"] * t["located"] for t in result["traces"])
            / sum(t["located"] for t in result["traces"]))


def percent(share):
    return "100 %" if share == 1 else f"{100 * share:.1f} %"


def names(result):
    return [result["surface"], str(result["points"])]


def ends(report):
    """The smallest and the largest result of each surface."""
    return [r for results in by_surface(report).values() for r in (results[0], results[-1])]


def largest(report):
    return [results[-1] for results in by_surface(report).values()]


def surfaces(report):
    rows = [[name, report["surfaces"][name], str(results[0]["points"]), str(results[-1]["points"])]
            for name, results in by_surface(report).items()]
    return table(["surface", "what it is", "points, least", "most"], rows, 2)


def assumptions(report):
    shares = {"subgraph_edges_delaunay": "T in D(S)", "surface_triangles_delaunay": "triangles of F in D(S)",
              "emst_edges_in_surface": "EMST in F", "emst_edges_in_subgraph": "EMST in T"}
    rows = []
    for r in ends(report):
        found = r["assumptions"]
        rows.append(names(r) + [percent(found[key]) for key in shares] +
                    [f'{found["delaunay_cells_per_point"]:.2f}', f'{found["cells_created_per_point"]:.1f}'])
    return table(["surface", "points", *shares.values(), "cells of D(S) per point", "cells created per point"], rows)


def lemma_4(report):
    """Round by round, at the largest size."""
    rows = []
    for r in largest(report):
        for h, row in enumerate(r["rounds"]):
            rows.append((names(r) if h == 0 else ["", ""]) + [
                str(h + 1), str(row["points"]), f'{row["iterated_log"]:.2f}', f'{row["lemma_4"]:.2f}',
                f'{row["history-trace"]:.2f}', f'{row["history-root"]:.1f}'])
    return table(["surface", "points", "round h", "points in it", r"\f$\log^{(h)} n\f$", r"\f$4 \ln(i/k)\f$, mean",
                  "from the last trace", "from the root"], rows)


def locations(report):
    rows = [names(r) + [f'{r["locations"][way]["cells_entered"]:.1f}' for way in WAYS] for r in ends(report)]
    return table(["surface", "points", *WAYS], rows)


def calls(report):
    """Without those of the traces."""
    rows = [names(r) + [f'{r["locations"][way]["calls"]:.0f}' for way in WAYS] for r in largest(report)]
    return table(["surface", "points", *WAYS], rows)


def slopes(report):
    """Of the surfaces with two sizes or more."""
    rows = []
    for name in by_surface(report):
        if name not in report["fits"]:
            continue
        fits = report["fits"][name]
        root, trace, walk = (fits[way] for way in ("history-root", "history-trace", "walk-trace"))
        values = [trace["b"], trace["b"] / root["b"], trace["with_traces"]["b"], walk["b"], walk["with_traces"]["b"]]
        rows.append([name, f'{root["b"]:.2f}'] + [f"{v:.3f}" for v in values] + [f'{fits["plain"]["b"]:.2f}'])
    return table(["surface", "history-root", "history-trace", "ratio", "history-trace with traces", "walk-trace",
                  "walk-trace with traces", "plain"], rows)


def trace_name(h):
    """The number of points that the trace after round h + 1 goes through."""
    return rf"\f$N_{h + 1}\f$"


def crossings(report):
    """At powers of four, and at the largest size."""
    found = [r for results in by_surface(report).values() for r in results
             if r["size"] >= LARGE and (r["size"].bit_length() % 2 == 1 or r is results[-1])]
    rounds = max((len(r["traces"]) for r in found), default=0)
    rows = []
    for r in found:
        values = [t["crossings_per_point"] for t in r["traces"]] + [None] * (rounds - len(r["traces"]))
        rows.append(names(r) + [cell(v, "{:.3f}") for v in values] +
                    [f"{all_crossings(r):.2f}", f"{mean_crossings(r):.2f}", f"{cells_of_traces(r):.2f}"])
    return table(["surface", "points"] + [trace_name(h) for h in range(rounds)] +
                 ["all traces", "per trace", "cells entered per traced point"], rows)


def spread(values):
    return f"{max(values) / min(values):.2f}" if values and min(values) > 0 else "–"


def crossings_spread(report):
    """The largest value over the smallest."""
    rows = []
    for name, results in by_surface(report).items():
        found = [r for r in results if r["size"] >= LARGE]
        series = [[r["traces"][h]["crossings_per_point"] for r in found] for h in range(3)]
        series += [[all_crossings(r) for r in found], [mean_crossings(r) for r in found]]
        rows.append([name] + [spread(values) for values in series])
    return table(["surface", *map(trace_name, range(3)), "all traces", "per trace"], rows)


def theorem_5(report):
    """Round by round, all surfaces and sizes together."""
    rows = []
    for h in range(max((len(r["rounds"]) for r in report["results"]), default=0)):
        found = [r["rounds"][h] for r in report["results"] if h < len(r["rounds"])]
        logs, cells = ([row[key] for row in found] for key in ("iterated_log", "history-trace"))
        ratio = max(c / max(log, 1) for c, log in zip(cells, logs))
        rows.append([str(h + 1)] + [f"{v:.2f}" for v in (min(logs), max(logs), min(cells), max(cells), ratio)])
    return table(["round h", r"\f$\log^{(h)} n\f$, least", "most", "nodes entered, least", "most",
                  r"nodes \f$/ \max(\log^{(h)} n, 1)\f$, most"], rows)


def hypothesis(report):
    has_amount = ("jitter", "decimated", "random edges")
    rows = [[r["surface"], r["change"], f'{r["amount"]:g}' if r["change"] in has_amount else "",
             percent(r["assumptions"]["subgraph_edges_delaunay"]), f"{mean_crossings(r):.2f}",
             f"{cells_of_traces(r):.2f}", f'{r["locations"]["history-trace"]["cells_entered"]:.2f}']
            for r in report["hypothesis"]]
    return table(["surface", "change", "amount", "T in D(S)", "crossings per trace and point",
                  "cells entered per traced point", "history-trace"], rows, 2)


def times(report):
    """Location and traces + update, in seconds."""
    rows = []
    for t in report["times"]:
        seconds = [t["seconds"][way] for way in WAYS]
        rows.append(names(t) + [f'{s["location"] + s["trace"]:.2f} + {s["update"]:.2f}' for s in seconds])
    return table(["surface", "points", *WAYS], rows)


def machine(report):
    loads = [t["load_average"] for t in report["times"]] or [None]
    return f"{machine_of(report)}. Load average while times were measured: {cell(min(loads))} to {cell(max(loads))}."


TABLES = {"surfaces": surfaces, "assumptions": assumptions, "lemma_4": lemma_4, "locations": locations,
          "calls": calls, "slopes": slopes, "crossings": crossings, "crossings_spread": crossings_spread,
          "theorem_5": theorem_5, "hypothesis": hypothesis, "machine": machine, "times": times,
          "command": commands_of}


def all_blocks(report):
    """{name: text} of all that the manual shows."""
    return {name: make(report) for name, make in TABLES.items()}
