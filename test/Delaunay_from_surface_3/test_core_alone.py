# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Programs that use the core, with no header of CGAL, Boost or TBB in reach: its own, and that of scripts/try_it."""

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


class TryIt(unittest.TestCase):
    def test_try_it(self):
        """In a copy of what it needs, by nothing but a compiler."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        here = Path(folder.name)
        root = here / "unpacked"
        for name in ("include", "src", "scripts", "examples"):
            shutil.copytree(HERE.parent.parent / name, root / name)
        points = here / "points.xyz"
        cells = here / "cells.vtk"

        def run(*words, **variables):
            path = {"PATH": "/usr/bin:/bin", "CXX": os.environ.get("CXX", "c++"), "CXXFLAGS": "-O0", **variables}
            return subprocess.run([root / "scripts/try_it", *words], capture_output=True, text=True, check=False, env=path,
                                  cwd=here)

        done = run()
        self.assertRegex(done.stdout, r"^== building with .*\n960 points, \d+ tetrahedra, .* threads; checked: it is the "
                         r"Delaunay triangulation\n$", done.stderr)
        points.write_text("# a cube and its middle\n" + "".join(f"{i % 2} {i // 2 % 2} {i // 4} red\n" for i in range(8)) + "\n.5 .5 .5\n")
        done = run("points.xyz", "cells.vtk", THREADS="1")
        self.assertRegex(done.stdout, r"^9 points, 12 tetrahedra, .* with 1 threads; checked: .*\nwritten: cells\.vtk\n$", done.stderr)
        words = cells.read_text().split()
        at = words.index("CELLS")
        self.assertEqual(words[at + 1:at + 3], ["12", "60"])
        self.assertEqual({tuple(words[i:i + 1]) for i in range(at + 3, at + 63, 5)}, {("4",)})
        self.assertEqual({int(word) for word in words[at + 3:at + 63]}, set(range(9)))
        self.assertEqual(words[-14:], ["CELL_TYPES", "12", *["10"] * 12])
        before = points.read_text()
        for output in ("points.xyz", "other.off", ".vtk"):
            self.assertEqual(run("points.xyz", output).stderr,
                             f"error: {output}: nothing is written over points; name a file that ends in .vtk\n")
        self.assertEqual((points.read_text(), sorted(path.name for path in here.iterdir())),
                         (before, ["cells.vtk", "points.xyz", "unpacked"]))
        points.write_text("1 2 3\n4 nan 6\n")
        self.assertEqual(run(points).stderr, f"error: {points}: a coordinate or weight is not a finite number; it is that of point 1\n")
        points.write_text("1 2 3\n\n4 5\n")
        self.assertEqual(run(points).stderr, f"error: {points}: line 3 has no three numbers\n")
        for text, message in (("OFF\n3 0 0\n1 2 3\n", "it ends before its last vertex"), ("OFF\nx\n", "there is no number of vertices"),
                              ("1 2 3\n", "the first line is not OFF")):
            (here / "points.off").write_text(text)
            self.assertEqual(run("points.off").stderr, f"error: points.off: {message}\n")
        self.assertEqual(run("none.xyz").stderr, "error: none.xyz: No such file or directory\n")
        self.assertEqual(run("points.off", "a", "b").returncode, 2)


if __name__ == "__main__":
    unittest.main()
