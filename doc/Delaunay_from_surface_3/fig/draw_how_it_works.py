#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Draws what the page "How it works" shows of one call, one insertion, one cell and two threads: call.svg, insertion.svg,
cell.svg and handshake.svg. What is drawn of triangulations is computed. Needs SciPy."""

from pathlib import Path

import numpy as np
from scipy.spatial import Delaunay

HERE = Path(__file__).resolve().parent
STYLE = (".cell{fill:#f4f7fa;stroke:#9aa7b5;stroke-width:1;stroke-linejoin:round}"
         ".walked{fill:#ffe3ad;stroke:#9aa7b5}.zone{fill:#f6c6c2;stroke:#9aa7b5}"
         ".other{fill:#bcd6ef;stroke:#9aa7b5}.both{fill:#c9a6d6;stroke:#9aa7b5}"
         ".star{fill:#d3ecd6;stroke:#5b8f63;stroke-width:1.2;stroke-linejoin:round}"
         ".circle{fill:none;stroke:#d99a94;stroke-width:.8}.way{fill:none;stroke:#1d3557;stroke-width:1.8}"
         ".in{fill:#1d3557}.out{fill:#fff;stroke:#1d3557;stroke-width:1.2}.now{fill:#c1272d}.now2{fill:#1b5e9b}"
         ".start{fill:none;stroke:#2a8f55;stroke-width:3}"
         ".box{fill:#f4f7fa;stroke:#6d8fb0;stroke-width:1.2}.warm{fill:#fdeccb;stroke:#c39a4a;stroke-width:1.2}"
         ".red{fill:#fbe3e1;stroke:#c1272d;stroke-width:1.2}.green{fill:#e2f2e4;stroke:#5b8f63;stroke-width:1.2}"
         ".arrow{fill:none;stroke:#444;stroke-width:1.5;marker-end:url(#a)}.dashed{stroke-dasharray:5 4}"
         "text{font:14px sans-serif;fill:#222}.middle{text-anchor:middle}.end{text-anchor:end}"
         ".small{font-size:12.5px}.bold{font-weight:bold}.mono{font-family:monospace}")
HEAD = ('<defs><marker id="a" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" orient="auto">'
        '<path d="M0 0L8 4L0 8z" fill="#444"/></marker></defs>')


class Svg:
    def __init__(self, width, height):
        self.lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" '
                      f'height="{height}">', f"<style>{STYLE}</style>", HEAD,
                      f'<rect width="{width}" height="{height}" fill="#fff"/>']

    def polygon(self, kind, corners):
        path = "L".join(f"{x:.1f} {y:.1f}" for x, y in corners)
        self.lines.append(f'<path class="{kind}" d="M{path}z"/>')

    def way(self, kind, places):
        path = "L".join(f"{x:.1f} {y:.1f}" for x, y in places)
        self.lines.append(f'<path class="{kind}" d="M{path}"/>')

    def dot(self, kind, at, radius):
        self.lines.append(f'<circle class="{kind}" cx="{at[0]:.1f}" cy="{at[1]:.1f}" r="{radius:.1f}"/>')

    def box(self, kind, x, y, width, height, *texts):
        self.lines.append(f'<rect class="{kind}" x="{x}" y="{y}" width="{width}" height="{height}" rx="4"/>')
        for k, text in enumerate(texts):
            self.text(x + width / 2, y + height / 2 + 5 + 18 * (k - (len(texts) - 1) / 2), text,
                      "middle" if k == 0 else "middle small")

    def text(self, x, y, text, kind=""):
        self.lines.append(f'<text class="{kind}" x="{x:.0f}" y="{y:.0f}">{text}</text>')

    def write(self, name):
        (HERE / name).write_text("\n".join([*self.lines, "</svg>", ""]), encoding="utf-8")


def area(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


class Plane:
    """A triangulation in the plane, its triangles counterclockwise."""

    def __init__(self, points):
        self.points = points
        self.made = Delaunay(points)
        self.triangles = [list(t) if area(*points[t]) > 0 else [t[0], t[2], t[1]] for t in self.made.simplices]
        self.neighbors = [{frozenset(t) - {v}: n for v, n in zip(t, around)}
                          for t, around in zip(self.made.simplices, self.made.neighbors)]

    def circle(self, t):
        (ax, ay), (bx, by), (cx, cy) = self.points[self.triangles[t]]
        d = 2 * (ax * (by - cy) + bx * (cy - ay) + cx * (ay - by))
        x = ((ax**2 + ay**2) * (by - cy) + (bx**2 + by**2) * (cy - ay) + (cx**2 + cy**2) * (ay - by)) / d
        y = ((ax**2 + ay**2) * (cx - bx) + (bx**2 + by**2) * (ax - cx) + (cx**2 + cy**2) * (bx - ax)) / d
        return np.array([x, y]), float(np.hypot(ax - x, ay - y))

    def is_in_conflict(self, t, p):
        center, radius = self.circle(t)
        return np.hypot(*(p - center)) < radius

    def walk(self, t, p):
        """The triangles from t to the first in conflict with p, by the rule of Walk_to_conflict.h."""
        walked = [t]
        while not self.is_in_conflict(t, p):
            corners = self.triangles[t]
            pushes = []
            for k in range(3):
                a, b = corners[(k + 1) % 3], corners[(k + 2) % 3]
                far = np.hypot(*(self.points[corners[k]] - p))
                pushes.append((area(self.points[a], self.points[b], p) * far**4, frozenset((a, b))))
            t = self.neighbors[t][min(pushes)[1]]
            walked.append(t)
        return walked

    def zone(self, p):
        return {t for t in range(len(self.triangles)) if self.is_in_conflict(t, p)}

    def beside(self, zone):
        return {n for t in zone for n in self.neighbors[t].values() if n >= 0} - zone

    def rim(self, zone):
        """The sides of the zone, counterclockwise: pairs of points."""
        return [(t[k], t[(k + 1) % 3]) for z in zone for t in [self.triangles[z]] for k in range(3)
                if self.neighbors[z][frozenset((t[k], t[(k + 1) % 3]))] not in zone]


def curve(n):
    """Points on a closed curve, bent and thin."""
    t = np.linspace(0, 2 * np.pi, n, endpoint=False)
    x, y = 1.6 * np.cos(t), (.62 + .18 * np.cos(3 * t)) * np.sin(t)
    return np.column_stack([x, y + .28 * x**2 - .3])


def draw_insertion():
    svg = Svg(860, 212)
    every = curve(54)
    is_in = np.zeros(54, dtype=bool)
    is_in[1::3] = True
    new, start = 15, 22
    plane = Plane(every[is_in])
    p = every[new]
    zone = plane.zone(p)
    walked = min((plane.walk(t, p) for t, corners in enumerate(plane.triangles)
                  if t not in zone and any((plane.points[v] == every[start]).all() for v in corners)), key=len)
    for panel, name in enumerate(("walk to a cell in conflict", "dig out all cells in conflict",
                                  "fill the zone with the star")):
        def at(q, panel=panel):
            return 143 + 286 * panel + 82 * q[0], 88 - 90 * q[1]
        for t, corners in enumerate(plane.triangles):
            kind = "cell"
            if panel == 0 and t in walked:
                kind = "walked"
            if t in zone and (panel == 1 or (panel == 0 and t == walked[-1])):
                kind = "zone"
            if panel < 2 or t not in zone:
                svg.polygon(kind, [at(plane.points[v]) for v in corners])
        if panel == 0:
            middles = [plane.points[plane.triangles[t]].mean(axis=0) for t in walked]
            svg.way("arrow", [at(q) for q in [every[start], *middles]])
            svg.dot("start", at(every[start]), 8)
        if panel == 2:
            for a, b in plane.rim(zone):
                svg.polygon("star", [at(p), at(plane.points[a]), at(plane.points[b])])
        for i, q in enumerate(every):
            if i != new:
                svg.dot("in" if is_in[i] else "out", at(q), 3.6 if is_in[i] else 2.4)
        svg.dot("now", at(p), 5)
        svg.text(143 + 286 * panel, 204, name, "middle")
    svg.write("insertion.svg")
    print("insertion.svg: cells walked", len(walked), "in conflict", len(zone), "in the star", len(plane.rim(zone)))


def draw_handshake():
    svg = Svg(860, 340)
    points = np.random.default_rng(4).random((40, 2))
    plane = Plane(points)
    a, b = np.array([.39, .58]), np.array([.67, .49])
    zones = plane.zone(a), plane.zone(b)
    besides = plane.beside(zones[0]), plane.beside(zones[1])
    clash = (zones[0] & (zones[1] | besides[1])) | (zones[1] & besides[0])

    def at(q):
        return 6 + 370 * q[0], 306 - 296 * q[1]
    for t, corners in enumerate(plane.triangles):
        kind = "both" if t in clash else "zone" if t in zones[0] else "other" if t in zones[1] else "cell"
        svg.polygon(kind, [at(plane.points[v]) for v in corners])
    for q in points:
        svg.dot("in", at(q), 2.6)
    svg.dot("now", at(a), 5.5)
    svg.dot("now2", at(b), 5.5)
    svg.text(190, 332, "two conflict zones that meet", "middle")
    for x, kind, name in ((400, "red", "thread A"), (640, "other", "thread B")):
        svg.text(x + 105, 22, name, "middle bold")
        svg.box(kind, x, 34, 210, 44, "walk and dig, without a lock", "note what was read")
        svg.box(kind, x, 90, 210, 44, "announce the zone", "one byte for each cell: my mark")
        svg.box("warm", x, 146, 210, 26, "fence")
        svg.box(kind, x, 184, 210, 44, "look again at what was read", "and at the others' marks")
        for y in (78, 134, 172, 228):
            svg.way("arrow", [(x + 105, y), (x + 105, y + 12)])
    svg.box("green", 400, 240, 210, 44, "nothing has changed:", "write the star, withdraw marks")
    svg.box("box", 640, 240, 210, 44, "A's mark is set: withdraw", "nothing was written; try later")
    svg.text(625, 312, "Both announced before both looked, so at least one sees the other.", "middle small")
    svg.write("handshake.svg")
    print("handshake.svg: zones of", len(zones[0]), "and", len(zones[1]), "cells,", len(clash), "in the way")


def fields(svg, x, y, parts):
    """Boxes side by side: [(bytes, kind, text, note)], 24 pixels for a byte."""
    for size, kind, text, note in parts:
        svg.box(kind, x, y, 24 * size, 38, text)
        svg.text(x + 12 * size, y + 55, note, "middle small")
        x += 24 * size


def draw_cell():
    svg = Svg(860, 262)
    svg.text(10, 22, "a cell: 32 bytes, half a cache line", "bold")
    fields(svg, 46, 32, [(4, "box", "v0", "highest bit: dead"), (4, "box", "v1", ""), (4, "box", "v2", ""),
                         (4, "box", "v3", "0: infinite"), (4, "warm", "n0", ""), (4, "warm", "n1", ""),
                         (4, "warm", "n2", ""), (4, "warm", "n3", "")])
    svg.text(238, 114, "four vertices: places in the order, plus 1", "middle")
    svg.text(622, 114, "four neighbours: 4 · cell + its facet", "middle")
    svg.text(10, 154, "a vertex: 32 bytes", "bold")
    fields(svg, 46, 164, [(8, "green", "x", ""), (8, "green", "y", ""), (8, "green", "z", ""),
                          (4, "warm", "cell", "one of its"), (4, "box", "label", "for a star")])
    svg.text(334, 246, "coordinates, times one power of 2 for all", "middle")
    svg.write("cell.svg")


def draw_call():
    svg = Svg(860, 232)
    svg.box("box", 6, 60, 122, 62, "mesh, soup,", "graph, points")
    svg.box("box", 160, 60, 112, 62, "doubles")
    svg.box("warm", 304, 60, 152, 62, "spaced rounds", "of the points")
    svg.box("red", 496, 60, 140, 62, "rounds of", "walk, dig, fill")
    svg.box("green", 676, 40, 178, 38, "export into tr")
    svg.box("green", 676, 104, 178, 38, "arrays, in place")
    svg.box("warm", 304, 172, 152, 50, "geometric rounds", "random")
    for places in ([(128, 91), (158, 91)], [(272, 91), (302, 91)], [(456, 91), (494, 91)],
                   [(636, 84), (674, 60)], [(636, 98), (674, 122)]):
        svg.way("arrow", places)
    svg.way("arrow dashed", [(548, 122), (548, 188), (458, 188)])
    svg.way("arrow dashed", [(456, 208), (588, 208), (588, 124)])
    svg.text(600, 182, "budget exceeded: what was built", "small")
    svg.text(600, 200, "is dropped, a new order is made", "small")
    svg.text(216, 18, "adapter", "middle small")
    svg.text(470, 18, "core: numbers alone", "middle small")
    svg.text(765, 18, "adapter", "middle small")
    svg.write("call.svg")


if __name__ == "__main__":
    draw_call()
    draw_insertion()
    draw_cell()
    draw_handshake()
