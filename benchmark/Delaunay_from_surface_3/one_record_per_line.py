#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Rewrites files of results so that each record of a list stands on a line of its own, and all else on one line per
key: what a new measurement changes is then seen line by line.

  one_record_per_line.py results/*.json"""

import json
import sys
from pathlib import Path


def line(value):
    return json.dumps(value, ensure_ascii=False)


def text_of(report):
    parts = []
    for key, value in report.items():
        if isinstance(value, list) and any(isinstance(record, (dict, list)) for record in value):
            records = ",\n".join(f"  {line(record)}" for record in value)
            parts.append(f" {line(key)}: [\n{records}\n ]")
        else:
            parts.append(f" {line(key)}: {line(value)}")
    return "{\n" + ",\n".join(parts) + "\n}\n"


def main():
    for name in sys.argv[1:]:
        path = Path(name)
        text = text_of(json.loads(path.read_text(encoding="utf-8")))
        aside = path.with_suffix(".new")
        aside.write_text(text, encoding="utf-8")
        aside.replace(path)


if __name__ == "__main__":
    main()
