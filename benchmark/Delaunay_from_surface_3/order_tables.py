#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Puts what measure_orders, check_meshes, count_instructions.py and measure_single_calls.py wrote as tables on the manual's
page on orders; needs nothing but Python.

  order_tables.py results/{orders,orders_200k,orders_walks,nets_200k,demo_meshes,small_meshes,single_calls}.json --tables
  order_tables.py results/{orders,orders_200k,orders_walks,nets_200k,demo_meshes,small_meshes,single_calls}.json \
    --manual Orders.txt [--check]

Blocks: one table for each size, a summary of all, machine, and commands; where walks can go astray; the rules for nets;
the meshes of libcgal-demo, by times, and the small ones by instructions; calls that are the only one of their process.
"""

import math

import manual_tables
from manual_tables import cell, commands_of, machine_of, table


def geometric_mean(values):
    return math.exp(sum(map(math.log, values)) / len(values))


def is_cad(row):
    return row["kind"] in ("by profile", "by ring", "shuffled")


def size_of(row, sizes):
    return min(sizes, key=lambda n: abs(math.log(n / row["points"])))


def order_row_names(row):
    return [row["family"], ", ".join(filter(None, [row["kind"], row["coordinates"] if is_cad(row) else ""]))]


def order_row(row):
    return [*order_row_names(row), row["points"], f'{row["median_ratio"]:.2f}', f'{row["lower_limit_of_ratio"]:.2f}',
            f'{row["cells_destroyed"]:.1f}', f'{row["cells_tested_to_start"]:.1f}',
            "yes" if row["order_was_replaced"] else ""]


ORDER_TITLES = ["surface", "numbering and coordinates, or what it is", "points", "ratio", "lower limit", "destroyed",
                "tested to start", "order replaced"]
SUMMARY_TITLES = ["surfaces", "number", "geometric mean", "least", "least lower limit", "share ≥ 1.5"]


def summary_row(name, rows):
    ratios = [row["median_ratio"] for row in rows]
    least = min(row["lower_limit_of_ratio"] for row in rows)
    share = sum(r >= 1.5 for r in ratios) / len(ratios)
    return [name, len(rows), f"{geometric_mean(ratios):.2f}", f"{min(ratios):.2f}", f"{least:.2f}", f"{100 * share:.0f} %"]


def blocks_of_orders(reports, sizes):
    rows = [row for report in reports for row in report["results"]]
    of_size = {n: [row for row in rows if size_of(row, sizes) == n] for n in sizes}
    kinds = [("solids as CAD makes them", True), ("other surfaces", False)]
    summary = [summary_row(f"{name}, {n}", [row for row in of_size[n] if is_cad(row) == cad])
               for n in sizes for name, cad in kinds]
    blocks = {f"orders_{n}": table(ORDER_TITLES, [[cell(v) for v in order_row(row)] for row in of_size[n]], 2)
              for n in sizes}
    blocks["summary"] = table(SUMMARY_TITLES, [[cell(v) for v in row] for row in summary])
    loads = ", ".join(f'{report["machine"]["load_before"]:.1f}' for report in reports)
    blocks["machine"] = f"{machine_of(reports[0])}. Load average before the runs: {loads}."
    blocks["command"] = commands_of(*reports)
    return blocks


def blocks_of_walks(report):
    rows = [[cell(v) for v in order_row(row)] for row in report["results"]]
    machine = f'{machine_of(report)}. Load average before the run: {report["machine"]["load_before"]:.1f}.'
    return {"walks": table(ORDER_TITLES, rows, 2) + "\n\n" + machine, "walks_command": commands_of(report)}


def block_of_meshes(report, least_vertices):
    large = [r for r in report["meshes"] if r.get("ratio") and r["vertices"] >= least_vertices]
    rows = [[r["mesh"], r["vertices"], f'{r["ratio"]:.2f}'] for r in sorted(large, key=lambda r: r["ratio"])]
    ratios = [r["ratio"] for r in large]
    head = (f'{len(report["meshes"])} meshes, {report["summary"]["equal"]} of them equal and '
            f'{report["summary"]["error"]} refused with an error. Of those with {least_vertices} vertices or more: '
            f'{len(ratios)} meshes, geometric mean {geometric_mean(ratios):.2f}, least {min(ratios):.2f}, below 1: '
            f'{sum(r < 1 for r in ratios)}, above 2: {100 * sum(r > 2 for r in ratios) / len(ratios):.0f} %.')
    return head + "\n\n" + table(["mesh", "vertices", "ratio"], [[cell(v) for v in row] for row in rows])


STAGES = ["half_digit", "one_digit", "balanced", "double_double", "two_digits", "any_width"]


def blocks_of_flat_and_far(report):
    rows = []
    for family, kind, inserted in dict.fromkeys((r["family"], r["kind"], r["inserted"]) for r in report["results"]):
        of = [r for r in report["results"] if (r["family"], r["kind"], r["inserted"]) == (family, kind, inserted)]
        rows.append([family, kind, inserted, *(f'{r["median_ratio"]:.2f}' for r in of),
                     *(f'{of[-1]["decided_by"][s] or 0:.2f}' for s in STAGES)])
    sizes = dict.fromkeys(min((5000, 20000, 100000), key=lambda n: abs(n - r["points"])) for r in report["results"])
    titles = ["surface", "what it is", "inserted", *(f"ratio, {n}" for n in sizes),
              "integers of 30 bits", "60 bits", "balanced", "double-double", "120 bits", "any width"]
    return {"flat_and_far": table(titles, [[cell(v) for v in row] for row in rows], 3),
            "flat_and_far_command": commands_of(report)}


def net_name(block, points):
    return "by index" if block == 1 else "random" if block >= points else f"blocks of {block}"


def count_cell(counts):
    return f'{counts["cells_destroyed"]:.1f} / {counts["cells_tested_to_start"]:.1f}' + (
        " *" if counts["order_was_replaced"] else "")


def blocks_of_nets(report):
    rows = report["results"]
    most = max(row["points"] for row in rows)
    titles = ["surface", "numbering and coordinates, or what it is", "points",
              *(net_name(block, most) for block in report["blocks"]), "random rounds"]
    lines = [[cell(v) for v in (*order_row_names(row), row["points"])] +
             [count_cell(c) for c in (*row["nets"], row["random_rounds"])] for row in rows]
    for name, chosen in (("solids as CAD makes them", list(filter(is_cad, rows))),
                         ("other surfaces", [row for row in rows if not is_cad(row)])):
        columns = zip(*((*row["nets"], row["random_rounds"]) for row in chosen))
        lines.append([name, "geometric mean, destroyed", ""] +
                     [f'{geometric_mean([c["cells_destroyed"] for c in column]):.1f}' for column in columns])
    return {"nets": table(titles, lines, 2), "nets_command": commands_of(report)}


SMALL_SIZES = (10, 100, 1000, 3000)


def blocks_of_instructions(report):
    rows, first = [], 4  # points: fewer have no triangulation in space
    for end in SMALL_SIZES:
        ratios = [m["plain"] / m["package"] for m in report["instructions"] if first <= m["vertices"] < end]
        if ratios:
            rows.append([f"{first} to {end - 1}", len(ratios), f"{geometric_mean(ratios):.2f}", f"{min(ratios):.2f}",
                         sum(r < 1 for r in ratios)])
        first = end
    titles = ["vertices", "meshes", "geometric mean", "least", "below 1"]
    return {"small": table(titles, [[cell(v) for v in row] for row in rows]), "small_command": commands_of(report)}


def blocks_of_single_calls(report):
    rows = []
    for result in report["results"]:
        plain, default = result["calls"]["plain"], result["calls"]["default"]
        pairs = [(f'{1e3 * c["median_cpu"]:.1f}', c["median_faults"], f'{c["median_bytes_above"] / 1e6:.1f}')
                 for c in (plain, default)]
        rows.append([result["mesh"], result["points"], f'{result["rest"]:g}', *(v for both in zip(*pairs) for v in both),
                     f'{plain["median_cpu"] / default["median_cpu"]:.2f}'])
    titles = ["mesh", "points", "rest, s", "ms, plain CGAL", "default", "page faults, plain CGAL", "default",
              "peak in MB, plain CGAL", "default", "ratio"]
    return {"single": table(titles, [[cell(v) for v in row] for row in rows]), "single_command": commands_of(report)}


LARGE_CALLS = {"default": "faces", "points": "points alone", "arrays": "arrays", "default:2": "faces, 2 threads",
               "arrays:2": "arrays, 2 threads"}


def blocks_of_large_calls(report):
    """Time of plain CGAL / time of the call, by wall clock."""
    names = [name for name in LARGE_CALLS if name in report["results"][0]["calls"]]
    rows = []
    for result in report["results"]:
        plain = result["calls"]["plain"]
        rows.append([plain["median_wall"] / result["calls"][name]["median_wall"] for name in names] +
                    [result["calls"]["default"]["median_bytes_above"] / plain["median_bytes_above"]])
    lines = [[result["mesh"].split("_")[0], f'{result["calls"]["plain"]["median_wall"]:.2f}', *map("{:.2f}".format, row)]
             for result, row in zip(report["results"], rows)]
    lines.append(["geometric mean", ""] + [f"{geometric_mean(column):.2f}" for column in zip(*rows)])
    size = "1M" if report["results"][0]["points"] > 600000 else "256k"
    titles = ["surface", "s, plain CGAL", *(LARGE_CALLS[name] for name in names), "peak, faces / plain CGAL"]
    return {f"calls_{size}": table(titles, lines), f"calls_{size}_command": commands_of(report)}


def all_blocks(reports):
    """{name: text} of all that the manual shows."""
    blocks = blocks_of_orders([r for r in reports if "repetitions" in r and not r.get("walks")], (3000, 20000, 200000))
    for report in reports:
        if report.get("walks"):
            blocks.update(blocks_of_walks(report))
        if "meshes" in report:
            blocks["meshes"] = block_of_meshes(report, 3000)
        if "flat_and_far_repetitions" in report:
            blocks.update(blocks_of_flat_and_far(report))
        if "blocks" in report:
            blocks.update(blocks_of_nets(report))
        if "instructions" in report:
            blocks.update(blocks_of_instructions(report))
        if report.get("program") == "measure_single_calls.py":
            of_large = "arrays" in report["results"][0]["calls"]
            blocks.update((blocks_of_large_calls if of_large else blocks_of_single_calls)(report))
    return blocks


if __name__ == "__main__":
    manual_tables.fill_from_results(__doc__, all_blocks, "measure_orders and check_meshes")
