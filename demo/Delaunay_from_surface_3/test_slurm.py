# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Runs the examples for Slurm by a stand-in for `sbatch`, which runs the same lines on this machine."""

import json
import os
import subprocess
import unittest
from pathlib import Path

from program_case import ROOT, ProgramCase
from test_tiles_program import write_points

PROGRAM, BY_MPI = os.environ["DELAUNAY_FROM_SURFACE"], os.environ.get("DELAUNAY_FROM_SURFACE_MPI")
SCRIPTS = ROOT / "examples/Delaunay_from_surface_3/slurm"

# Copies the script, as Slurm does, and runs it: by itself, or as the jobs of an array, two at a time.
SBATCH = r"""#!/usr/bin/env bash
set -euo pipefail
array=
while [[ $1 == --* ]]; do
  case $1 in
    --array=0-*) array=${1#--array=0-} ;;
    --wait) ;;
    *) echo "sbatch: unrecognized option '$1'" >&2; exit 1 ;;
  esac
  shift
done
grep -q '^#SBATCH ' "$1"
copy=$(mktemp -p "$(dirname "$STAND_IN_LOG")")
cp "$1" "$copy" && chmod +x "$copy"
shift
echo "${array:-one}" >> "$STAND_IN_LOG"
if [ -z "$array" ]; then SLURM_NTASKS=2 exec "$copy" "$@"; fi
export SLURM_ARRAY_TASK_COUNT=$((array + 1))
seq 0 "$array" | xargs -P 2 -I {} env SLURM_ARRAY_TASK_ID={} "$copy" "$@"
"""


class Slurm(ProgramCase):
    def setUp(self):
        super().setUp()
        self.points, self.log = self.folder / "points.raw", self.folder / "log"
        write_points(self.points, 3000)
        programs = self.folder / "bin"
        programs.mkdir()
        (programs / "sbatch").write_text(SBATCH, encoding="utf-8")
        (programs / "sbatch").chmod(0o755)
        for program in filter(None, (PROGRAM, BY_MPI)):
            (programs / Path(program).name).symlink_to(Path(program).resolve())
        self.environment = {**os.environ, "PATH": f"{programs}:{os.environ['PATH']}", "STAND_IN_LOG": str(self.log)}

    def run_script(self, *command):
        return subprocess.run([*map(str, command)], cwd=self.folder, env=self.environment, capture_output=True, text=True,
                              check=False, timeout=200)

    def report(self, name):
        report = json.loads((self.folder / name / "tiles.json").read_text())
        self.assertTrue(report["certified"])
        return report["hash"]

    def test_array_and_mpi(self):
        done = self.run_script(SCRIPTS / "tiles_out_of_core.sh", "array", 4, self.points)
        self.assertEqual((done.stderr, done.returncode), ("", 0))
        arrays = self.log.read_text().split()
        self.assertGreater(len(arrays), 5)
        self.assertEqual((arrays[:2], arrays[-1]), (["0", "0"], "3"))
        if BY_MPI:
            done = self.run_script("sbatch", SCRIPTS / "tiles_by_mpi.sh", "mpi", self.points)
            self.assertEqual((done.stderr, done.returncode), ("", 0))
            self.assertEqual(self.report("mpi"), self.report("array"))

    def test_errors_end_it(self):
        done = self.run_script(SCRIPTS / "tiles_out_of_core.sh", "array", 4, "missing.npy")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("missing.npy: cannot be read", done.stderr)
        self.assertFalse(self.log.exists())

    def test_more_tasks_than_an_array_may_have(self):
        script = self.folder / "script.sh"
        script.write_text((SCRIPTS / "tiles_out_of_core.sh").read_text().replace("most_jobs=1000", "most_jobs=3"))
        script.chmod(0o755)
        done = self.run_script(script, "array", 7, self.points)
        self.assertEqual((done.stderr, done.returncode), ("", 0))
        self.assertIn("2", self.log.read_text().split())
        self.report("array")


if __name__ == "__main__":
    unittest.main()
