# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""What the plots of the manual share: the width of its pages, text, colours, and files that come out the same each
time. One unit is a pixel of a page that is PAGE wide. Needs Matplotlib (Debian: python3-matplotlib)."""

import io
import re

import matplotlib
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator

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
