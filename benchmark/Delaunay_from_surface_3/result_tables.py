# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The tables of the manual's page on performance, in Markdown, from what compare_with_plain measured."""

from manual_tables import cell, commands_of, machine_of, table
from peer_tables import peers_block
from results import (PAPER, cells_entered, is_of_compare, method_of, methods_that_walk, microseconds, peers, size_name,
                     used_methods, without_export)


def results_of(surfaces):
    for surface, by_size in surfaces.items():
        for n, result in by_size.items():
            yield [surface, size_name(n)], result


def get(method, *keys):
    """method[keys[0]][keys[1]]…, None where something is missing."""
    for key in keys:
        if method is None or key not in method:
            return None
        method = method[key]
    return method


def over(a, b):
    return None if a is None or not b else a / b


def ratios(surfaces, methods):
    rows = []
    for names, result in results_of(surfaces):
        values = [get(method_of(result, m), "ratio_plain_to_method") for m in methods]
        if any(v is not None for v in values):
            plain = get(method_of(result, "plain"), "median_cpu")
            rows.append(names + [f"{plain:.3f}"] + [cell(v, "{:.2f}") for v in values])
    return table(["surface", "points", "plain CGAL, CPU s"] + methods, rows)


def main_ratios(surfaces):
    left_out = PAPER + ("plain", "plain-fast", "default-fast")
    return ratios(surfaces, [m for m in used_methods(surfaces) if m not in left_out])


def paper_ratios(surfaces):
    return ratios(surfaces, [m for m in used_methods(surfaces) if m in PAPER])


def gains(surfaces):
    """What the compact triangulation, the order and starts of the surface, and both of them gain."""
    rows = []
    for names, result in results_of(surfaces):
        values = [get(method_of(result, m), "ratio_plain_to_method") for m in ("compact-spatial", "nets", "default")]
        if None not in values:
            rows.append(names + [f"{v:.2f}" for v in values])
    return table(["surface", "points", "compact triangulation alone", "surface alone", "both: the default"], rows)


def fast_location(surfaces):
    rows = []
    for names, result in results_of(surfaces):
        plain, ours = (get(method_of(result, m), "median_cpu") for m in ("plain-fast", "default-fast"))
        if plain and ours:
            rows.append(names + [f"{plain:.3f}", f"{ours:.3f}", f"{plain / ours:.2f}"])
    return table(["surface", "points", "plain-fast, CPU s", "default-fast, CPU s", "ratio"], rows)


def stages(surfaces):
    """Microseconds per point, and what that means beside plain CGAL and the peers."""
    names_of_peers = [m for m in used_methods(surfaces)
                      if any(p["method"] == m for _, r in results_of(surfaces) for p in peers(r))]
    rows = []
    for names, result in results_of(surfaces):
        ours, plain = method_of(result, "default"), method_of(result, "plain")
        if get(ours, "stages") is None:
            continue
        micro = [ours["stages"][s] * 1e6 / result["points"] for s in ("plan", "build", "export")]
        others = [over(get(method_of(result, p), "median_cpu"), without_export(ours)) for p in names_of_peers]
        rows.append(names + [f"{v:.2f}" for v in micro] +
                    [f'{100 * ours["stages"]["plan"] / plain["median_cpu"]:.1f} %'] +
                    [f'{plain["median_cpu"] / without_export(ours):.2f}'] + [cell(v, "{:.2f}") for v in others])
    return table(["surface", "points", "plan, µs", "build, µs", "export, µs", "plan / plain CGAL",
                  "plain CGAL / (plan + build)"] + [f"{p} / (plan + build)" for p in names_of_peers], rows)


def yardstick(surfaces):
    rows = []
    for names, result in results_of(surfaces):
        known = result.get("yardstick", {})
        if "total" not in known:
            continue
        values = [get(method_of(result, m), "ratio_method_to_yardstick")
                  for m in ("plain", "compact-spatial", "default")]
        rows.append(names + [f'{known["verification"]:.3f}', f'{known["export"]:.3f}'] +
                    [cell(v, "{:.2f}") for v in values])
    return table(["surface", "points", "verification, s", "export, s", "plain", "compact-spatial", "default"], rows)


def work(surfaces):
    """Per insertion."""
    rows = []
    for names, result in results_of(surfaces):
        order, ours, nets = (method_of(result, m) for m in ("plain-order", "default", "nets"))
        if get(ours, "kernel") is None:
            continue
        values = [get(order, "cells", "destroyed"), get(ours, "cells", "destroyed"), get(ours, "cells", "created"),
                  get(order, "predicates", "update", "in_sphere"), get(nets, "predicates", "update", "in_sphere"),
                  get(ours, "kernel", "sphere_tests"), get(ours, "kernel", "cells_tested_to_start")]
        failures = [get(ours, "kernel", f"{stage}_filter_failures") for stage in ("first", "second")]
        rows.append(names + [cell(v, "{:.1f}") for v in values] + [cell(v, "{:.4f}") for v in failures])
    return table(["surface", "points", "cells destroyed, plain-order", "default", "cells created, default",
                  "in-sphere tests, plain-order", "nets", "cells tested, default", "to start",
                  "left open by the first filter", "by the second"], rows)


def memory(surfaces):
    names_of_peers = [m for m in used_methods(surfaces)
                      if any(p["method"] == m for _, r in results_of(surfaces) for p in peers(r))]
    rows = []
    for names, result in results_of(surfaces):
        plain, ours = (get(method_of(result, m), "memory") for m in ("plain", "default"))
        if plain is None or ours is None:
            continue
        above = [m[f"{what}_above_input_per_point"] for what in ("result", "peak") for m in (plain, ours)]
        others = [over(get(method_of(result, p), "memory", "peak_bytes"), plain["peak_bytes"])
                  for p in names_of_peers]
        rows.append(names + [f"{v:.0f}" for v in above] + [f'{ours["peak_bytes"] / plain["peak_bytes"]:.2f}'] +
                    [cell(v, "{:.2f}") for v in others])
    return table(["surface", "points", "result, plain CGAL", "default", "peak, plain CGAL", "default",
                  "whole process, default / plain CGAL"] + [f"{p} / plain CGAL" for p in names_of_peers], rows)


def growth(surfaces):
    """Time per point over that at the smallest size, where there are three sizes or more."""
    rows, sizes = [], sorted({n for by_size in surfaces.values() for n in by_size if n})
    for surface, by_size in surfaces.items():
        measured = {n: r for n, r in by_size.items() if n and get(method_of(r, "default"), "stages")}
        for name, time in (("plain", lambda m: m["median_cpu"]), ("default", without_export)):
            times = {n: time(method_of(r, name)) / r["points"] for n, r in measured.items()}
            if len(times) > 2:
                rows.append([surface, name] + [cell(over(times.get(n), times[min(times)]), "{:.2f}") for n in sizes])
    return table(["surface", "method"] + [size_name(n) for n in sizes], rows, 2)


def traces(surfaces):
    """What the paper's traces do and what its order costs."""
    rows = []
    for names, result in results_of(surfaces):
        order, sorted_rounds, ours = (method_of(result, m) for m in ("plain-order", "tracing-hilbert", "tracing"))
        located = over(get(ours, "predicates", "traced_points"), result["points"])
        if located is None:
            continue
        calls = [get(m, "predicates", "update", "in_sphere") for m in (order, ours)]
        updates = [m and microseconds(m, result["points"]).get("update") for m in (order, sorted_rounds, ours)]
        rows.append(names + [f"{located:.1f}", cell(get(ours, "predicates", "cells_entered_per_traced_point"), "{:.1f}")] +
                    [cell(v, "{:.1f}") for v in calls + updates])
    return table(["surface", "points", "located by traces, per point", "cells entered for each",
                  "in-sphere tests, plain-order", "tracing", "update, µs, plain-order", "tracing-hilbert", "tracing"],
                 rows)


def cells(surfaces):
    methods = methods_that_walk(surfaces)
    rows = []
    for names, result in results_of(surfaces):
        found = [method_of(result, m) for m in methods]
        if any(m and "location" in m.get("predicates", {}) for m in found):
            rows.append(names + [cell(m and cells_entered(m), "{:.1f}") for m in found])
    return table(["surface", "points"] + methods, rows)


KINDS = {  # by the descriptions that compare_with_plain gives
    "densified meshes": lambda name, text: "densified" in text and "random order" not in text,
    "the same in random order": lambda name, text: "densified" in text and "random order" in text,
    "smooth implicit surfaces and the noisy sphere": lambda name, text: "implicit" in text or name == "sphere",
    "near-degenerate and degenerate surfaces": lambda name, text: name.split("-shuffled")[0] in
        ("sphere-exact", "plate", "thin-plate", "lattice"),
}


def summary(surfaces):
    """Time of plain CGAL over that of the default, by kind of surface, from the least to the most."""
    rows = []
    for kind, is_one in KINDS.items():
        known = {}
        for surface, by_size in surfaces.items():
            for n, result in by_size.items():
                ratio = get(method_of(result, "default"), "ratio_plain_to_method")
                if ratio is not None and n and is_one(surface, result["description"]):
                    known.setdefault(n, []).append(ratio)
        for n, found in sorted(known.items()):
            rows.append([kind, size_name(n), str(len(found)), f"{min(found):.2f}", f"{max(found):.2f}"])
    return table(["surfaces", "points", "how many", "least", "most"], rows)


def surfaces_measured(surfaces):
    rows = [[name, next(iter(by_size.values()))["description"]] for name, by_size in surfaces.items()]
    return table(["surface", "what it is"], rows, 2)


TABLES = {"summary": summary, "gains": gains, "surfaces": surfaces_measured, "ratios": main_ratios,
          "paper": paper_ratios, "fast": fast_location, "stages": stages, "yardstick": yardstick, "work": work,
          "memory": memory, "growth": growth, "traces": traces, "cells": cells}


def machine(reports):
    loads = [load for r in reports for load in (r["load_average_at_start"], r.get("load_average_at_end")) if load]
    texts = dict.fromkeys(f"{machine_of(r)}, `Exact_predicates_inexact_constructions_kernel`, one thread."
                          for r in reports)
    return "\n".join(texts) + f"\nLoad average of the machine at start and end of the runs: {min(loads)} to {max(loads)}."


def all_blocks(reports, surfaces):
    """{name: text} of all that the manual shows."""
    blocks = {name: make(surfaces) for name, make in TABLES.items()}
    others = [report for report in reports if not is_of_compare(report)]
    if others:
        blocks["peers"] = peers_block(others)
    return {"machine": machine([report for report in reports if is_of_compare(report)]), **blocks,
            "commands": commands_of(*reports)}
