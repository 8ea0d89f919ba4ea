#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""What a call takes, revision by revision, in counts that no other program disturbs: instructions (valgrind), page faults
and bytes, per point, beside those of plain CGAL. Adds the record of one revision, which replaces an older one of the same,
to a file, and says where the package takes 2 % more instructions than in any revision before; then it ends with 1.

  history_of_counts.py meshes/refined_elephant.off --program ./insert_once --revision $(git rev-parse --short HEAD)
      --output history.json"""

import argparse
import json
import subprocess
import sys
from pathlib import Path

from count_instructions import instructions
from one_record_per_line import text_of

LOSS = 1.02


def counts(program, mesh):
    """Of one call with faces."""
    found = instructions(program, mesh, time_limit=600)
    if found is None:
        sys.exit(f"history_of_counts.py: {program} fails on {mesh}, or takes more than ten minutes")
    record = {"points": found["vertices"]}
    for name, method in (("plain", "plain"), ("package", "default")):
        run = subprocess.run([program, mesh, method], capture_output=True, text=True, check=True)
        took = json.loads(run.stdout)
        record[name] = {"instructions": round(found[name] / found["vertices"], 1), "faults": took["faults"],
                        "bytes": round((took["bytes_at_peak"] - took["bytes_before"]) / found["vertices"], 1)}
    return record


def loss(history):
    """What is lost by the last revision against the best before, as text; empty if it is less than 2 %."""
    now = history[-1]["package"]["instructions"]
    before = [r["package"]["instructions"] for r in history[:-1] if r["mesh"] == history[-1]["mesh"]]
    if not before or now <= LOSS * min(before):
        return ""
    return f"{now} instructions per point, {100 * (now / min(before) - 1):.1f} % more than the least before"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh", metavar="MESH")
    parser.add_argument("--program", required=True, help="insert_once of that revision")
    parser.add_argument("--revision", required=True)
    parser.add_argument("--date", default="", help="of the revision")
    parser.add_argument("--output", type=Path, default=Path("history.json"), metavar="FILE")
    options = parser.parse_args()
    history = json.loads(options.output.read_text())["history"] if options.output.exists() else []
    mesh = Path(options.mesh).name
    record = {"revision": options.revision, "date": options.date, "mesh": mesh, **counts(options.program, options.mesh)}
    same = [i for i, r in enumerate(history) if (r["revision"], r["mesh"]) == (options.revision, mesh)]
    at = same[0] if same else len(history)
    history[at:at + 1] = [record]
    report = {"command": "history_of_counts.py refined_elephant.off --program ./insert_once --revision REVISION",
              "history": history}
    options.output.write_text(text_of(report))
    lost = loss(history[:at + 1])
    print(lost or f"{record['package']['instructions']} instructions per point")
    return 1 if lost else 0


if __name__ == "__main__":
    sys.exit(main())
