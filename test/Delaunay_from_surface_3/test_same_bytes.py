# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Every compiler, with whatever optimization and instructions, makes the triangulations in fixed_inputs.h; so does the
core where it is compiled. test_inputs_of_others has one to eight threads, test_wheel has Python, and
`scripts/test_elsewhere print_same_bytes` other systems."""

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
COMPILED = "-DCGAL_DELAUNAY_FROM_SURFACE_3_COMPILED"
OPTIONS = [["-O0"], ["-O2", "-DNDEBUG"], ["-O3", "-DNDEBUG", "-march=native", "-ffp-contract=off"],
           ["-O3", "-DNDEBUG", "-march=native", "-ffp-contract=fast"], ["-O1", "-mno-avx2", "-mno-fma"],
           ["-O2", "-DNDEBUG", COMPILED]]


def output_of(compiler, options, folder):
    units = [HERE / "print_same_bytes.cpp", *([ROOT / "src/core.cpp"] if COMPILED in options else [])]
    # clang has no -frounding-math that it keeps with all options
    rounding = ["-frounding-math"] if "clang" not in compiler else []
    subprocess.run([compiler, "-std=c++17", "-w", *rounding, *options, f"-I{ROOT / 'include'}", f"-I{HERE / 'include'}",
                    *units, "-o", folder / "program", "-pthread", "-lmpfr", "-lgmp"], check=True)
    return [subprocess.run([folder / "program", threads], capture_output=True, text=True, check=False)
            for threads in ("1", "3", "8")]


class Same_bytes(unittest.TestCase):
    def test_compilers(self):
        compilers = [name for name in dict.fromkeys([os.environ.get("CXX", "c++"), "g++", "clang++"]) if shutil.which(name)]
        for compiler in compilers:
            for options in OPTIONS:
                with self.subTest(f"{compiler} {' '.join(options)}"), tempfile.TemporaryDirectory() as folder:
                    for done in output_of(compiler, options, Path(folder)):
                        self.assertEqual(done.returncode, 0, done.stdout)
                        self.assertEqual(done.stdout.count("\n"), 13)


if __name__ == "__main__":
    unittest.main()
