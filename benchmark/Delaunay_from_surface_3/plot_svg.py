# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Drawing for plot_results.py: SVG, axes, legends."""

import html
import math
import textwrap

from results import size_name

PANEL_WIDTH, PANEL_HEIGHT, COLUMNS = 300, 210, 3
LEFT, TOP, GAP_X, GAP_Y = 58, 92, 50, 66


class Svg:
    """Collects the elements of a drawing."""

    def __init__(self):
        self.parts = []

    def line(self, x1, y1, x2, y2, color="#333", width=1.0, dash=""):
        dash = f' stroke-dasharray="{dash}"' if dash else ""
        self.parts.append(f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" '
                          f'stroke="{color}" stroke-width="{width}"{dash}/>')

    def polyline(self, points, color, width):
        text = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        self.parts.append(f'<polyline points="{text}" fill="none" stroke="{color}" '
                          f'stroke-width="{width}" stroke-linejoin="round"/>')

    def dot(self, x, y, color, radius=2.8):
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" fill="{color}"/>')

    def rect(self, x, y, width, height, color):
        self.parts.append(f'<rect x="{x:.1f}" y="{y:.1f}" width="{max(width, 0):.1f}" '
                          f'height="{height:.1f}" fill="{color}"/>')

    def text(self, x, y, text, size=12, anchor="start", weight="normal", color="#222", turn=False):
        turned = f' transform="rotate(-90 {x:.1f} {y:.1f})"' if turn else ""
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" text-anchor="{anchor}" '
                          f'font-weight="{weight}" fill="{color}"{turned}>{html.escape(text)}</text>')

    def write(self, file_name, width, height):
        with open(file_name, "w", encoding="utf-8") as file:
            file.write(f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
                       f'viewBox="0 0 {width} {height}" font-family="DejaVu Sans, Helvetica, sans-serif">\n')
            file.write('<rect width="100%" height="100%" fill="#fff"/>\n')
            file.write("\n".join(self.parts) + "\n</svg>\n")


def heading(svg, title, subtitle, reports):
    machine = reports[0]["machine"]
    svg.text(20, 28, title, 17, weight="bold")
    svg.text(20, 48, subtitle, 12, color="#444")
    flags = " ".join(machine["flags"].split())
    svg.text(20, 66, f'CGAL {machine["cgal"]}, {machine["compiler"]}, {flags}; '
             f'{machine["cpu"]}, {machine["cores"]} cores, shared; {machine["date"]}', 11, color="#666")


def legend_and_commands(svg, entries, reports, y):
    """Three entries to a line, then the commands; returns where the drawing ends."""
    for i, (color, label) in enumerate(entries):
        x = LEFT + (i % COLUMNS) * (PANEL_WIDTH + GAP_X)
        svg.rect(x, y - 9 + 19 * (i // COLUMNS), 22, 10, color)
        svg.text(x + 29, y + 19 * (i // COLUMNS), label, 12)
    y += 19 * ((len(entries) - 1) // COLUMNS) + 28
    for report in reports:
        for line in textwrap.wrap(report["command"], 170, subsequent_indent="    "):
            svg.text(20, y, line, 10.5, color="#666")
            y += 15
    return y


class Panel:
    """The axes of one surface: sizes along x (logarithmic), values along y."""

    def __init__(self, svg, index, sizes, y_range, y_ticks, y_log=False):
        self.svg, self.sizes, self.y_log = svg, sizes, y_log
        self.x0 = LEFT + (index % COLUMNS) * (PANEL_WIDTH + GAP_X)
        self.y0 = TOP + 20 + (index // COLUMNS) * (PANEL_HEIGHT + GAP_Y)
        self.low, self.high = (math.log(v) for v in y_range) if y_log else y_range
        for tick in y_ticks:
            plain = tick == 1 and not y_log
            svg.line(self.x0, self.y(tick), self.x0 + PANEL_WIDTH, self.y(tick), "#555" if plain else "#e3e3e3",
                     dash="5 3" if plain else "")
            svg.text(self.x0 - 6, self.y(tick) + 4, f"{tick:g}", 11, "end")
        for n in sizes:
            svg.line(self.x(n), self.y0 + PANEL_HEIGHT, self.x(n), self.y0 + PANEL_HEIGHT + 4)
            svg.text(self.x(n), self.y0 + PANEL_HEIGHT + 18, size_name(n), 11, "middle")
        svg.line(self.x0, self.y0 + PANEL_HEIGHT, self.x0 + PANEL_WIDTH, self.y0 + PANEL_HEIGHT)
        svg.line(self.x0, self.y0, self.x0, self.y0 + PANEL_HEIGHT)

    def x(self, n):
        first, last = math.log(self.sizes[0]), math.log(self.sizes[-1])
        share = (math.log(n) - first) / (last - first) if last > first else 0.5
        return self.x0 + 12 + share * (PANEL_WIDTH - 24)

    def y(self, value):
        value = math.log(value) if self.y_log else value
        return self.y0 + PANEL_HEIGHT * (1 - (value - self.low) / (self.high - self.low))

    def title(self, text):
        self.svg.text(self.x0, self.y0 - 9, text, 13, weight="bold")

    def curve(self, points, color):
        points = [(self.x(n), self.y(v)) for n, v in points]
        self.svg.polyline(points, color, 1.8)
        for x, y in points:
            self.svg.dot(x, y, color)
