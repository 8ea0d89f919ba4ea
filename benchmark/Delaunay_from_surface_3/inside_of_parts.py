#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Asks the program delaunay_from_surface for the inside of every part in a folder, and writes JSON: a row for each file.

  inside_of_parts.py [--program PROGRAM] [--output FILE] [FOLDER]

Default: the .stl and .obj files, compressed or not, of Debian's package openfoam-examples, which is fetched into
build/parts, with the program that scripts/run has built.
"""

import argparse
import gzip
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build/program/demo/Delaunay_from_surface_3/delaunay_from_surface"
PARTS = ROOT / "build/parts"
EDGES = re.compile(r"(open edges|edges with two faces in the same direction|edges with more than two faces): (\d+), "
                   r"first (\d+-\d+ at \([^)]*\))")


def fetch():
    """Unpacks the package; nothing is installed."""
    if not PARTS.is_dir():
        script = ". scripts/lib/install.sh; . scripts/lib/fetch.sh; fetch_parts"
        subprocess.run(["bash", "-euc", script], cwd=ROOT, check=True)
    return PARTS


def edges_of(text):
    return {name: {"number": int(number), "first": first} for name, number, first in EDGES.findall(text)}


def share(text):
    """The first number of '12 of 2000 (0.6 %)', over the second."""
    part, whole = map(int, re.match(r"(\d+) of (\d+)", text).groups())
    return round(part / whole, 6)


def row_of(path, name, program):
    with tempfile.TemporaryDirectory() as folder:
        surface = Path(folder) / re.sub(r"\.gz$", "", path.name)
        with (gzip.open if path.suffix == ".gz" else open)(path, "rb") as source, open(surface, "wb") as target:
            shutil.copyfileobj(source, target)
        output = Path(folder) / "inside.vtk"
        done = subprocess.run([program, surface, "--mark-inside", "--output", output, "--json"], capture_output=True,
                              text=True, errors="replace", check=False)
        row = {"file": name}
        if done.returncode != 0:
            message = done.stderr.strip().splitlines()[-1].removeprefix("error: ").removeprefix(f"{surface}: ")
            return {**row, "inside": "none", "message": message.replace(folder + "/", ""), "edges": edges_of(message)}
        values = json.loads(done.stdout)
        row.update(faces=values["surface_faces"], vertices=values["vertices"], inside="winding numbers" if "not_closed" in values else "closed mesh",
                   tetrahedra=values["finite_cells"])
        if "not_closed" in values:
            row.update(in_doubt=share(values["tetrahedra_in_doubt"]), in_several=values["in_several_parts"],
                       volume_in_doubt=round(float(values["volume_in_doubt"].split()[0]) / 100, 6),
                       openings=round(float(values["openings"].split()[0]) / 100, 6), not_closed=values["not_closed"], edges=edges_of(values["not_closed"]))
        return row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, metavar="FOLDER")
    parser.add_argument("--program", type=Path, default=PROGRAM)
    parser.add_argument("--output", type=Path, metavar="FILE")
    options = parser.parse_args()
    folder = options.folder or fetch()
    files = sorted(path for path in folder.rglob("*")
                   if re.search(r"\.(stl|obj)(\.gz)?$", path.name, re.I) and path.is_file() and not path.is_symlink())
    if not files:
        sys.exit(f"{folder}: there is no .stl and no .obj file")
    version = subprocess.run([options.program, "--version"], capture_output=True, text=True, check=True).stdout.strip()
    rows = []
    for path in files:
        rows.append(row_of(path, str(path.relative_to(folder)), options.program.resolve()))
        print(json.dumps(rows[-1]), flush=True)
    package = folder / ".package"
    report = {"command": "inside_of_parts.py --output parts.json", "program": version,
              "parts": package.read_text(encoding="utf-8").strip() if package.exists() else str(folder), "results": rows}
    if options.output:
        options.output.write_text(json.dumps(report, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
