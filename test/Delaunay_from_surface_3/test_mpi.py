# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Tiles by every MPI that is here, on 1, 2 and 4 ranks: Open MPI and MPICH, by their own compilers and launchers."""

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_rmaps_base_oversubscribe": "1"}


class Mpi(unittest.TestCase):
    def check(self, kind):
        compiler, launcher = shutil.which(f"mpicxx.{kind}"), shutil.which(f"mpirun.{kind}")
        if not compiler or not launcher:
            self.skipTest(f"skipped: {kind} was not found")
        with tempfile.TemporaryDirectory() as folder:
            program = Path(folder) / "test"
            subprocess.run([compiler, "-std=c++17", "-O1", "-frounding-math", "-Wall", "-Wextra", "-Werror",
                            "-DOMPI_SKIP_MPICXX", "-DMPICH_SKIP_MPICXX", f"-I{ROOT / 'include'}", f"-I{HERE / 'include'}",
                            HERE / "test_tiles_by_mpi.cpp", "-o", program, "-pthread"], check=True)
            for ranks in (1, 2, 4):
                # Where there are fewer cores, those that wait keep the others from their work.
                most = "!small*" if ranks > 2 else "*"
                subprocess.run([launcher, "-n", str(ranks), program, f"--run_test={most}"], env=ENVIRONMENT, check=True,
                               timeout=200)
            self.check_kill(launcher, program)

    def check_kill(self, launcher, program):
        """Who loses a rank ends."""
        one = ["-n", "1", "sh", "-c", 'exec "$@"', "sh", program]
        victim = ["-n", "1", "sh", "-c", '(sleep .3; kill -9 $$) & exec "$@"', "sh", program]
        done = subprocess.run([launcher, *one, ":", *victim], env=ENVIRONMENT, capture_output=True, check=False,
                              timeout=60)
        self.assertNotEqual(done.returncode, 0)

    def test_open_mpi(self):
        self.check("openmpi")

    def test_mpich(self):
        self.check("mpich")


if __name__ == "__main__":
    unittest.main()
