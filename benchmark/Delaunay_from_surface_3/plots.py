# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The plots of readme and manual: what they share (the width of pages, text, colours, and files that come out the same each
time; one unit is a pixel of a page that is PAGE wide), the bar chart of the readme, from what measure_single_calls.py wrote,
where the time goes, by compare_with_plain, and the work of the paper's Q, by location_costs. Needs Matplotlib."""

import io
import re

import matplotlib
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator

from paper_tables import EMST, PARTS, by_seed, mean
from speed_tables import CALLS, surface_of

PAGE = 864  # div.figure in manual.css
TEXT, SMALL = 13, 12
matplotlib.rcParams.update({
    "svg.fonttype": "none", "svg.hashsalt": "Delaunay_from_surface_3",
    "font.family": "sans-serif", "font.sans-serif": ["DejaVu Sans", "Verdana"], "font.size": TEXT,
    "axes.titlesize": TEXT, "axes.titleweight": "bold", "axes.titlelocation": "left", "axes.titlepad": 7,
    "axes.labelsize": SMALL, "xtick.labelsize": SMALL, "ytick.labelsize": SMALL, "legend.fontsize": SMALL,
    "axes.spines.top": False, "axes.spines.right": False, "axes.edgecolor": "#666666", "axes.axisbelow": True,
    "xtick.color": "#666666", "ytick.color": "#666666", "xtick.labelcolor": "#222222", "ytick.labelcolor": "#222222",
    "text.color": "#222222", "axes.labelcolor": "#222222", "axes.linewidth": 1, "lines.linewidth": 2,
    "lines.markersize": 6, "legend.frameon": False, "legend.handlelength": 1.8, "legend.columnspacing": 1.8,
    "legend.borderaxespad": 0, "legend.borderpad": 0})


def size_name(n):
    """16384 -> 16k, 1048576 -> 1M: the sizes are powers of two."""
    return f"{n / 2**20:g}M" if n >= 2**20 else f"{n / 2**10:g}k"


class Sheet:
    """A drawing on a white card, which is readable on dark pages too. Places are in pixels from the upper left."""

    def __init__(self, height, width=PAGE):
        self.width, self.height = width, height
        self.figure = Figure(figsize=(width / 72, height / 72), facecolor="white")

    def axes(self, left, top, width, height):
        """With a grid along the values alone; the caller says which these are."""
        axes = self.figure.add_axes([left / self.width, 1 - (top + height) / self.height,
                                     width / self.width, height / self.height])
        axes.tick_params(length=4)
        return axes

    def grid(self, panels, columns, top=30, left=52, right=14, height=190, gap=(46, 62)):
        """Panels in rows."""
        width = (self.width - left - right - (columns - 1) * gap[0]) / columns
        return [self.axes(left + (i % columns) * (width + gap[0]), top + (i // columns) * (height + gap[1]), width,
                          height) for i in range(panels)]

    def text(self, left, top, text, **keywords):
        self.figure.text(left / self.width, 1 - top / self.height, text, va="top", **keywords)

    def legend(self, handles, left=52, bottom=12, columns=3):
        self.figure.legend(handles=handles, loc="lower left", ncol=columns,
                           bbox_to_anchor=(left / self.width, bottom / self.height))

    def write(self, file_name):
        """Without date and version, and with a size in pixels."""
        text = io.StringIO()
        self.figure.savefig(text, format="svg", metadata={"Date": None, "Creator": None, "Format": None, "Type": None})
        svg = re.sub(r'width="[^"]*" height="[^"]*"', f'width="{self.width}" height="{self.height}"', text.getvalue(),
                     count=1)
        svg = re.sub(r"(\d\.\d\d)\d+", r"\1", svg)  # of a pixel
        svg = re.sub(r" *<!--.*?-->\n|^ +", "", svg, flags=re.M)
        with open(file_name, "w", encoding="utf-8") as file:
            file.write(svg)


def grid_height(panels, columns, legend_rows, top=30, height=190, gap=62):
    """Of a sheet with a grid of panels, the label of their x axis, and a legend."""
    rows = (panels + columns - 1) // columns
    return top + rows * height + (rows - 1) * gap + 50 + 19 * legend_rows + 14


def ticks(axis, values, name="{:g}".format, log=False):
    """These, and no others; the axis goes from the first to the last."""
    axis.axes.set(**({"xscale": "log"} if axis.axis_name == "x" else {"yscale": "log"}) if log else {})
    axis.set_major_locator(FixedLocator(values))
    axis.set_minor_locator(NullLocator())
    axis.set_major_formatter(FuncFormatter(lambda value, _: name(value)))
    (axis.axes.set_xlim if axis.axis_name == "x" else axis.axes.set_ylim)(values[0], values[-1])


def size_ticks(axes, sizes):
    """A logarithmic axis of sizes, with room beside the first and the last; no more than five of them named."""
    step = (len(sizes) + 4) // 5
    ticks(axes.xaxis, sizes[(len(sizes) - 1) % step::step], size_name, log=True)
    axes.set_xlim(sizes[0] / 1.2, sizes[-1] * 1.2)


def lines_along(axes, axis):
    axes.grid(axis=axis, color="#e3e3e3", linewidth=1)


def line(color, label, marker="o", **keywords):
    return Line2D([], [], color=color, label=label, marker=marker, **keywords)


def patch(color, label):
    return Patch(color=color, label=label)


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


def draw_work(report, file_name):
    """Calls per point by parts, with T = EMST, and those of location from the root."""
    found = {surface: sizes for (surface, T), sizes in by_seed(report).items() if T == EMST}
    sheet = Sheet(grid_height(len(found), 4, 2, height=170))
    for axes, (surface, records) in zip(sheet.grid(len(found), 4, height=170), found.items()):
        sizes = sorted(records)
        axes.stackplot(sizes, *([mean(records[n], part, "calls") for n in sizes] for part in PARTS),
                       colors=[color for color, _ in PARTS.values()])
        axes.plot(sizes, [mean(records[n], "location_from_root", "calls") + mean(records[n], "updates", "calls")
                          for n in sizes], color="#000000", linestyle=":")
        lines_along(axes, "y")
        size_ticks(axes, sizes)
        ticks(axes.yaxis, [0, 400, 800, 1200])
        axes.set(title=surface, xlabel="points", ylim=(0, 1300))
    sheet.legend([patch(color, part) for part, (color, _) in PARTS.items()] +
                 [line("#000000", "location from the root, and updates", None, linestyle=":")], columns=5)
    sheet.write(file_name)
