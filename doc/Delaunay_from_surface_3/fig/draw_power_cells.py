#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Draws power_cells.svg: the balls of a chain of atoms in the plane, their power cells, and a ball that is hidden;
and periodic_cells.svg: the cells of points in a periodic box, with copies around."""

import math
from pathlib import Path

WIDTH, HEIGHT, SCALE = 560, 310, 54
STYLE = (".cell{stroke:#6d8fb0;stroke-width:1.2;stroke-linejoin:round}.ball{fill:none;stroke:#1d3557;stroke-width:1.6}"
         ".hidden{fill:none;stroke:#c1272d;stroke-width:1.8;stroke-dasharray:4 3}.bond{fill:none;stroke:#222;stroke-width:1}"
         ".atom{fill:#1d3557}.lost{fill:#c1272d}")
COLOURS = ("#dbe9f6", "#e9f3e4", "#fdf0d8")
RADII = (1.7, 1.55, 1.52)  # of carbon, nitrogen and oxygen, in angstroms
TURNS = (0, 62, -58, 55, -70, -64, 60, 58)  # of the chain, in degrees


def chain():
    """(x, y, radius) of atoms, and of a small one between two of them."""
    x, y, heading, balls = 2.1, 3.8, 10, []
    for k, turn in enumerate(TURNS):
        balls.append((x, y, RADII[k % 3] * .8))
        heading += turn
        x, y = x + 1.0 * math.cos(math.radians(heading)), y - 1.0 * math.sin(math.radians(heading))
    a, b = balls[2], balls[3]
    return [*balls, ((a[0] + b[0]) / 2 + .1, (a[1] + b[1]) / 2 - .35, .35)]


def clipped(polygon, nx, ny, most):
    """The part of a convex polygon in which nx x + ny y <= most."""
    result = []
    for (x, y), (u, v) in zip(polygon, polygon[1:] + polygon[:1]):
        here, there = most - nx * x - ny * y, most - nx * u - ny * v
        if here >= 0:
            result.append((x, y))
        if here * there < 0:
            share = here / (here - there)
            result.append((x + share * (u - x), y + share * (v - y)))
    return result


def rectangle(low_x, low_y, high_x, high_y):
    return [(low_x, low_y), (high_x, low_y), (high_x, high_y), (low_x, high_y)]


def cell(balls, i, polygon):
    """Where no other ball has less power in the polygon: squared distance less squared radius."""
    x, y, r = balls[i]
    for j, (u, v, s) in enumerate(balls):
        if j != i and polygon:
            most = u * u + v * v - s * s - (x * x + y * y - r * r)
            polygon = clipped(polygon, 2 * (u - x), 2 * (v - y), most)
    return polygon


def path(polygon, attributes):
    return f'<path {attributes} d="M{"L".join(f"{SCALE * x:.1f} {SCALE * y:.1f}" for x, y in polygon)}z"/>'


def write(name, lines):
    head = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}">',
            f"<style>{STYLE}</style>"]
    Path(__file__).with_name(name).write_text("\n".join([*head, *lines, "</svg>", ""]), encoding="utf-8")


def main():
    draw_power_cells()
    draw_periodic_cells()


def draw_periodic_cells():
    window = rectangle(0, 0, WIDTH / SCALE, HEIGHT / SCALE)
    width, height, low_x, low_y = 4.6, 3.2, 2.9, 1.27
    shares = [(k * .618034 % 1, (k + .5) / 11) for k in range(11)]
    home = [(low_x + width * x, low_y + height * y) for x, y in shares]
    shifts = sorted(((i, j) for i in (-1, 0, 1) for j in (-1, 0, 1)), key=lambda s: s != (0, 0))
    balls = [(x + i * width, y + j * height, 0) for i, j in shifts for x, y in home]
    lines = []
    for k in range(len(balls)):
        polygon = cell(balls, k, window)
        if polygon:
            fade = "" if k < len(home) else ' fill-opacity=".35" stroke-opacity=".4"'
            lines.append(path(polygon, f'class="cell" fill="{COLOURS[k % len(home) % 3]}"{fade}'))
    lines.append(path(rectangle(low_x, low_y, low_x + width, low_y + height), 'class="ball"'))
    for k, (x, y, _) in enumerate(balls):
        atom = 'class="atom"' if k < len(home) else 'class="atom" fill-opacity=".35"'
        lines.append(f'<circle {atom} cx="{SCALE * x:.1f}" cy="{SCALE * y:.1f}" r="3"/>')
    write("periodic_cells.svg", lines)


def draw_power_cells():
    balls = chain()
    cells = [cell(balls, i, rectangle(0, 0, WIDTH / SCALE, HEIGHT / SCALE)) for i in range(len(balls))]
    lines = [path(polygon, f'class="cell" fill="{COLOURS[i % 3]}"') for i, polygon in enumerate(cells) if polygon]
    bonds = "L".join(f"{SCALE * x:.1f} {SCALE * y:.1f}" for x, y, _ in balls[:-1])
    lines.append(f'<path class="bond" d="M{bonds}"/>')
    for (x, y, r), polygon in zip(balls, cells):
        ball, atom = ("ball", "atom") if polygon else ("hidden", "lost")
        lines.append(f'<circle class="{ball}" cx="{SCALE * x:.1f}" cy="{SCALE * y:.1f}" r="{SCALE * r:.1f}"/>')
        lines.append(f'<circle class="{atom}" cx="{SCALE * x:.1f}" cy="{SCALE * y:.1f}" r="3"/>')
    write("power_cells.svg", lines)


if __name__ == "__main__":
    main()
