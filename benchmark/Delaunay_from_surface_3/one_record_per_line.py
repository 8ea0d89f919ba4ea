#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Rewrites files of results so that each record of a list stands on a line of its own, and all else on one line per
key: what a new measurement changes is then seen line by line. Repetitions beside their median become their range.

  one_record_per_line.py results/*.json"""

import json
import sys
from pathlib import Path


def line(value):
    return json.dumps(value, ensure_ascii=False)


def without_repetitions(value):
    """Where NAME is a list beside median_NAME, the least and the largest are left."""
    if isinstance(value, list):
        return [without_repetitions(item) for item in value]
    if not isinstance(value, dict):
        return value
    kept = {}
    for key, item in value.items():
        if isinstance(item, list) and item and f"median_{key}" in value:
            kept[f"{key}_range"] = [round(min(item), 6), round(max(item), 6)]
        else:
            kept[key] = without_repetitions(item)
    return kept


def text_of(report):
    parts = []
    for key, value in without_repetitions(report).items():
        if isinstance(value, list) and any(isinstance(record, (dict, list)) for record in value):
            records = ",\n".join(f"  {line(record)}" for record in value)
            parts.append(f" {line(key)}: [\n{records}\n ]")
        else:
            parts.append(f" {line(key)}: {line(value)}")
    return "{\n" + ",\n".join(parts) + "\n}\n"


def rewrite(path):
    before = path.read_text(encoding="utf-8")
    text = text_of(json.loads(before))
    if text != before:
        aside = path.with_suffix(".new")
        aside.write_text(text, encoding="utf-8")
        aside.replace(path)


def main():
    for name in sys.argv[1:]:
        rewrite(Path(name))


if __name__ == "__main__":
    main()
