# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""What one call of the package adds to a user's file: machine code, and headers."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
INCLUDE = HERE.parent.parent / "include"
COMPILED = "-DCGAL_DELAUNAY_FROM_SURFACE_3_COMPILED"
MOST, MOST_COMPILED = 280_000, 40_000  # bytes
MOST_HEADERS = 40  # with the core compiled


def bytes_of_code(name, folder, *options):
    """The code and constants of a unit that is compiled as users do it; None without binutils."""
    unit = Path(folder) / f"{name}.o"
    subprocess.run([os.environ.get("CXX", "c++"), "-std=c++17", "-O3", "-DNDEBUG", "-frounding-math", f"-I{INCLUDE}",
                    "-c", HERE / "weight" / f"{name}.cpp", "-o", unit, *options], check=True)
    sections = subprocess.run(["size", unit], capture_output=True, text=True, check=True).stdout
    return int(sections.splitlines()[1].split()[0])


class Weight(unittest.TestCase):
    def test_code_that_a_call_adds(self):
        version = subprocess.run([os.environ.get("CXX", "c++"), "--version"], capture_output=True, text=True,
                                 check=True).stdout
        if "Free Software Foundation" not in version:
            self.skipTest("the limit is one for g++")
        with tempfile.TemporaryDirectory() as folder:
            plain, surface = (bytes_of_code(name, folder) for name in ("plain", "surface"))
            compiled = bytes_of_code("surface", folder, COMPILED)
        print(f"plain CGAL {plain} bytes, one call {surface - plain} more, with the core compiled {compiled - plain}")
        self.assertGreater(plain, 50_000)
        self.assertLess(surface - plain, MOST)
        self.assertLess(compiled - plain, MOST_COMPILED)

    def test_headers_that_a_call_includes(self):
        done = subprocess.run([os.environ.get("CXX", "c++"), "-std=c++17", f"-I{INCLUDE}", COMPILED, "-M",
                               HERE / "weight" / "surface.cpp"], capture_output=True, text=True, check=True)
        headers = {path for path in done.stdout.split() if path.startswith(str(INCLUDE))}
        self.assertIn(str(INCLUDE / "CGAL" / "insert_surface_vertices_3.h"), headers)
        self.assertLessEqual(len(headers), MOST_HEADERS, sorted(headers))
        self.assertEqual([path for path in headers if "/core/kernel/" in path], [])


if __name__ == "__main__":
    unittest.main()
