# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""A program that uses the core, with no header of CGAL, Boost or TBB in reach."""

import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
PACKAGE = HERE.parent.parent / "include" / "CGAL" / "Delaunay_from_surface_3"
SOURCE = HERE / "core_alone" / "core_alone.cpp"


class CoreAlone(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        package = self.folder / "CGAL" / PACKAGE.name
        for room in ("core", "arrays", "support"):
            shutil.copytree(PACKAGE / room, package / room)
        for header in PACKAGE.glob("*.h"):
            shutil.copy(header, package)

    def compiled(self, *options):
        return subprocess.run([os.environ.get("CXX", "c++"), "-std=c++17", "-O1", "-frounding-math", "-Wall", "-Wextra",
                               "-Werror", f"-I{self.folder}", SOURCE, *options],
                              capture_output=True, text=True, check=False)

    @unittest.skipUnless(shutil.which("clang++") and os.path.exists("/usr/include/c++/v1"), "clang or libc++ was not found")
    def test_another_library(self):
        """That of clang, as on macOS."""
        program = self.folder / "core_alone"
        subprocess.run(["clang++", "-stdlib=libc++", "-std=c++17", "-O0", "-Wall", "-Wextra", "-Werror", f"-I{self.folder}", SOURCE, "-o",
                        program], check=True)
        self.assertEqual(subprocess.run([program], capture_output=True, text=True, check=False).stdout, "all is right\n")

    def test_headers(self):
        done = self.compiled("-M")
        self.assertEqual(done.returncode, 0, done.stderr)
        foreign = [path for path in done.stdout.split() if re.search(r"/(CGAL|boost|tbb|oneapi)/", path)
                   and not path.startswith(str(self.folder))]
        self.assertEqual(foreign, [])
        self.assertIn("core/build.h", done.stdout)

    def test_points_of_every_dimension(self):
        program = self.folder / "core_alone"
        done = self.compiled("-o", program)
        self.assertEqual(done.returncode, 0, done.stderr)
        done = subprocess.run([program], capture_output=True, text=True, check=False)
        self.assertEqual((done.stdout, done.returncode), ("all is right\n", 0))


if __name__ == "__main__":
    unittest.main()
