# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The bar chart of the readme, from what measure_single_calls.py wrote, and where the time goes, by compare_with_plain."""

from plot_style import Sheet, lines_along, patch
from speed_tables import CALLS, surface_of

CHART = "elephant"


def draw_times(calls, file_name):
    """Readable where a page is 420 pixels wide: so it is drawn for."""
    result = next(r for r in calls["results"] if surface_of(r) == CHART)
    times = {f"{what}, {threads} thread{'s' * (threads > 1)}": result["calls"][name]["median_wall"]
             for (what, threads), name in CALLS.items()}
    sheet = Sheet(84 + 46 * len(times), 420)
    sheet.text(14, 12, f"{CHART.capitalize()}, {result['points']:,} points: seconds", fontweight="bold", fontsize=15)
    axes = sheet.axes(14, 44, 352, 46 * len(times))
    most = max(times.values())
    for y, (name, seconds) in enumerate(times.items()):
        axes.barh(y + 0.2, seconds, 0.42, color="#8b9bb0" if name.startswith("plain") else "#e07b00")
        axes.text(0, y - 0.23, name, va="center", fontsize=14)
        axes.text(seconds + 0.012 * most, y + 0.2, f"{seconds:.2f}", va="center", fontsize=14, fontweight="bold")
    axes.set(xlim=(0, most), ylim=(len(times) - 0.5, -0.5))
    axes.set_axis_off()
    machine = calls["machine"]
    sheet.text(14, sheet.height - 26, f'{machine["cpu"]}, {machine["cores"]} cores; medians of one run', fontsize=12,
               color="#555555")
    sheet.write(file_name)


PHASES = (("#f0e442", "input and order", ("input_and_output", "plan", "subgraph", "trace")),  # colour, label, parts
          ("#56b4e9", "location", ("location",)),
          ("#0072b2", "update", ("update",)),
          ("#009e73", "export", ("finish",)))
SURFACES = ("elephant", "genus-50", "sphere", "plate", "lattice")


def microseconds(method, total, points):
    """[(colour, CPU time per point)]: the shares of the run with phases, of this total in seconds."""
    seconds = method["phases"]["seconds"]
    scale = total / sum(seconds.values()) * 1e6 / points
    return [(color, scale * sum(seconds[name] for name in names)) for color, _, names in PHASES]


def draw_where_time_goes(report, file_name):
    """Plain CGAL's bars have the shares of plain-order, which makes the same insertions."""
    found = {r["surface"]: r for r in report["results"]}
    step = 44
    sheet = Sheet(step * len(SURFACES) + 90)
    axes = sheet.axes(230, 12, 580, step * len(SURFACES))
    lines_along(axes, "x")
    for i, surface in enumerate(SURFACES):
        methods = {m["method"]: m for m in found[surface]["methods"]}
        for y, label, shares, total in ((step * i + 12, "plain CGAL", "plain-order", "plain"),
                                        (step * i + 30, "this package", "default", "default")):
            left = 0
            for color, width in microseconds(methods[shares], methods[total]["median_cpu"], found[surface]["points"]):
                axes.barh(y, width, 15, left, color=color)
                left += width
            axes.annotate(label, (0, y), (-6, 0), textcoords="offset points", va="center", ha="right", fontsize=12)
        axes.annotate(surface, (0, step * i + 21), (-104, 0), textcoords="offset points", va="center", ha="right",
                      fontweight="bold")
    axes.set(ylim=(step * len(SURFACES), 0), yticks=[], xlabel="microseconds per point")
    sheet.legend([patch(color, label) for color, label, _ in PHASES], 230, 8, 5)
    sheet.write(file_name)
