# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""clang finds nothing that narrows, loses digits or hides a name: in all headers, the C interface and the file side of
tiles, on 64 bits and on 32, where a size has as many as an int."""

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
INCLUDE = ROOT / "include"
MPI = ("Tiles_by_mpi_3.h", "Ranks_of_mpi.h")  # which needs its library
OPTIONS = ["-std=c++17", "-fsyntax-only", "-Werror", "-Wall", "-Wextra", "-Wc++11-narrowing", "-Wshorten-64-to-32", "-Wshadow",
           "-DCGAL_DISABLE_GMP=1"]


@unittest.skipUnless("CI" in os.environ or shutil.which("clang++"), "clang was not found")
class Clang_warnings(unittest.TestCase):
    def check(self, target):
        """The system's headers of CGAL and Boost serve every target, the others do not."""
        with tempfile.TemporaryDirectory() as folder:
            for name in ("boost", "CGAL"):
                (Path(folder) / name).symlink_to(Path("/usr/include") / name)
            for lines in ([f"#include <{path.relative_to(INCLUDE)}>" for path in sorted(INCLUDE.rglob("*.h")) if path.name not in MPI]
                          + ['#include "delaunay_3.cpp"'], ['#include "tiles/Tiles_to_files.cpp"', '#include "tiles/Point_files_3.cpp"']):
                done = subprocess.run(["clang++", f"--target={target}", *OPTIONS, f"-I{INCLUDE}", f"-I{ROOT / 'src'}", f"-I{ROOT}",
                                       "-isystem", folder, "-x", "c++", "-"], input="\n".join(lines) + "\n",
                                      capture_output=True, text=True, check=False)
                self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_64_bits(self):
        self.check(subprocess.run(["clang++", "-dumpmachine"], capture_output=True, text=True, check=True).stdout.strip())

    @unittest.skipUnless("CI" in os.environ or os.path.isdir("/usr/i686-linux-gnu/include"), "g++-i686-linux-gnu was not found")
    def test_32_bits(self):
        self.check("i686-linux-gnu")

    def test_they_are_seen(self):
        for line in ("int f(long long n) { return n; }", "int f(int n) { { int n = 1; return n; } return n; }", "int a[] = {1ull << 40};"):
            done = subprocess.run(["clang++", *OPTIONS, "-x", "c++", "-"], input=line, capture_output=True, text=True, check=False)
            self.assertNotEqual(done.returncode, 0, line)


if __name__ == "__main__":
    unittest.main()
