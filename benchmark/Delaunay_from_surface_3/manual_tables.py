# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""What all tables of README and manual need, which are in Markdown."""

import json
import math
import re
from pathlib import Path


def cell(value, form="{}"):
    return "–" if value is None else form.format(value)


def table(titles, rows, left=1):
    """The first columns are aligned to the left, the others, numbers, to the right."""
    lines = ["| " + " | ".join(titles) + " |", "|" + "---|" * left + "--:|" * (len(titles) - left)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def marked(rows, *columns):
    """The rows, in which the largest figure of these columns is bold, and the smallest italic."""
    marked_rows = [list(row) for row in rows]
    for column in columns:
        values = {i: float(row[column]) for i, row in enumerate(rows) if re.fullmatch(r"[\d.]+", row[column])}
        for i, value in values.items():
            if min(values.values()) < max(values.values()):
                mark = "**" if value == max(values.values()) else "*" if value == min(values.values()) else ""
                marked_rows[i][column] = f"{mark}{rows[i][column]}{mark}"
    return marked_rows


def thousands(number):
    """1000000: 1,000,000"""
    return f"{number:,}"


def geometric_mean(values):
    return math.exp(sum(map(math.log, values)) / len(values))


def range_of(values, form):
    low, high = form.format(min(values)), form.format(max(values))
    return low if low == high else f"{low} to {high}"


def loads_of(report):
    """The load averages of the machine that a report gives, before and after."""
    machine = report["machine"] if isinstance(report.get("machine"), dict) else {}
    named = [machine.get("load_before"), machine.get("load_after"), report.get("load_average_at_start"),
             report.get("load_average_at_end")]
    return [load for load in named if load is not None]


def cpu_of(report):
    return report["machine"]["cpu"].replace("(R)", "").replace(" Processor", "")


def measured(*reports):
    """On which of the two machines, under which load, and where the figures are."""
    texts = [f'{cpu_of(r).split()[1]}, load {range_of(loads_of(r), "{:.1f}")}, `{r["name"]}`' for r in reports]
    return f'<small>{"; ".join(texts)}.</small>'


def with_caption_below(text):
    """The text of a table, in which what measured() has said comes last."""
    found = re.fullmatch(r"([^|]*?)\s*(<small>.*?</small>)\s*(\|.*)", text, re.S)
    return "\n\n".join(filter(None, (found[1], found[3], found[2]))) if found else text


def read(file_name):
    with open(file_name, encoding="utf-8") as file:
        return {"name": Path(file_name).stem, **json.load(file)}
