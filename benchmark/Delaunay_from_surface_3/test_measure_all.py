#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Tests that measure_all measures each result once that it shows, with options that the programs have, and fills every
table: its programs are stand-ins that copy the committed results, so readme and manual must stay as they are."""

import json
import shutil
import stat
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
PACKAGE = HERE.parents[1]
MANUAL = Path("doc/Delaunay_from_surface_3")
FOLDER = Path("benchmark/Delaunay_from_surface_3")
PROGRAMS = ["compare_with_plain", "measure_threads", "measure_orders", "measure_flat_and_far", "measure_consumers", "measure_thinning",
            "measure_sources", "measure_uniform_samples", "measure_tiles", "measure_subgraphs", "location_costs"]
OTHERS = {"demo_meshes", "small_meshes", "single_calls", "python", "compile_time"}  # by other programs
STAND_IN = """#!/bin/sh
printf '%s\\n' "$(basename "$0") $*" >> calls
for word; do last=$word; done
cp "{results}/$last" .
"""


class Test(unittest.TestCase):
    def run_in(self, package, folder, programs):
        for name in programs:
            program = folder / name
            program.write_text(STAND_IN.format(results=HERE / "results"))
            program.chmod(program.stat().st_mode | stat.S_IXUSR)
        draw = package / FOLDER / "draw_figures"  # test_figures tests it
        draw.write_text("#!/bin/sh\n")
        (folder / "data").mkdir()
        return subprocess.run([package / FOLDER / "measure_all", folder, folder / "data"], capture_output=True,
                              text=True, check=False)

    def copy_of_package(self, folder):
        package = folder / "package"
        for part in (FOLDER, MANUAL):
            shutil.copytree(PACKAGE / part, package / part)
        shutil.copy(PACKAGE / "README.md", package)
        return package

    def test_all(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            package = self.copy_of_package(folder)
            for page in [package / "README.md", *(package / MANUAL).glob("*.txt")]:
                page.write_text(page.read_text().replace(" |\n\n<!-- end -->", "x |\n\n<!-- end -->"))
            for result in (package / FOLDER / "results").glob("*.json"):
                if result.stem not in OTHERS:
                    result.unlink()
            run = self.run_in(package, folder, PROGRAMS)
            self.assertEqual(run.returncode, 0, run.stderr)
            for page in [Path("README.md"), *(MANUAL / p.name for p in (PACKAGE / MANUAL).glob("*.txt"))]:
                self.assertEqual((package / page).read_text(), (PACKAGE / page).read_text(), page)
            calls = (folder / "calls").read_text().split("\n")[:-1]
            results = {p.stem for p in (HERE / "results").glob("*.json")} - OTHERS
            self.assertEqual(sorted(call.split()[-1] for call in calls), sorted(f"{r}.json" for r in results))
            self.check_surfaces_and_sizes({call.split()[-1]: call.split() for call in calls})

    # What a result says of its own command is what measure_all calls, repetitions and folders apart.
    def check_surfaces_and_sizes(self, calls):
        for name, words in calls.items():
            committed = json.loads((HERE / "results" / name).read_text())["command"].split()
            self.assertEqual(words[0], committed[0], name)
            for option in ("--sizes", "--surfaces", "--methods", "--simulate", "--genera", "--blocks"):
                self.assertEqual(values(words, option), values(committed, option), f"{name}: {option}")

    def test_programs_that_are_absent(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            package = self.copy_of_package(folder)
            run = self.run_in(package, folder, [p for p in PROGRAMS if p != "measure_sources"])
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertIn("skipped: sources, as there is no measure_sources", run.stdout)


def values(words, option):
    """What follows an option; None if it is not there."""
    if option not in words:
        return None
    first = words.index(option) + 1
    return words[first:next((k for k in range(first, len(words)) if words[k].startswith("-")), len(words))]


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    unittest.main()
