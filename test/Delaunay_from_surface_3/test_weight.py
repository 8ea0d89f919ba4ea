# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""How much machine code one call of the package adds to a user's file."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
INCLUDE = HERE.parent.parent / "include"
MOST = 330_000  # bytes


def bytes_of_code(name, folder):
    """The code and constants of a unit that is compiled as users do it; None without binutils."""
    unit = Path(folder) / f"{name}.o"
    subprocess.run([os.environ.get("CXX", "c++"), "-std=c++17", "-O3", "-DNDEBUG", "-frounding-math", f"-I{INCLUDE}",
                    "-c", HERE / "weight" / f"{name}.cpp", "-o", unit], check=True)
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
        print(f"plain CGAL {plain} bytes, one call {surface}: {surface - plain} more")
        self.assertGreater(plain, 50_000)
        self.assertLess(surface - plain, MOST)


if __name__ == "__main__":
    unittest.main()
