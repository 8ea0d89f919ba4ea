# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""One program of units in several forms: header-only and with the core compiled, checked and not, for a newer processor,
of another version. A linker keeps one of all functions of one name, so these shall not have the same names."""

import os
import platform
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
COMPILED = "-DCGAL_DELAUNAY_FROM_SURFACE_3_COMPILED"
LIBRARY = [Path("core.cpp"), Path("core_regular.cpp"), Path("core_periodic.cpp"),
           Path("tiles/Point_files_3.cpp"), Path("tiles/Tiles_to_files.cpp")]
UNITS = {
    "header_only": ["-DNDEBUG"],
    "compiled": ["-DNDEBUG", COMPILED],
    "checked": ["-DCGAL_CHECK_EXPENSIVE", COMPILED],
    "of_another_version": ["-DNDEBUG"],
    "wide": ["-DNDEBUG", "-mavx512f", "-mfma"],
}


def functions(path):
    """The functions that an object or a library defines where others see them, by their names in the program."""
    lines = subprocess.run(["nm", "--defined-only", path], capture_output=True, text=True, check=True).stdout
    return {found.group(1) for found in re.finditer(r"^[0-9a-f]+ [TW] (\S+)$", lines, re.MULTILINE)}


def readable(names):
    return subprocess.run(["c++filt"], input="\n".join(names), capture_output=True, text=True, check=True).stdout.split("\n")


@unittest.skipUnless(platform.machine() == "x86_64", "the options are those of one processor")
class Mixtures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        newer = cls.folder / "newer"
        shutil.copytree(ROOT / "include", newer)
        form = newer / "CGAL" / "Delaunay_from_surface_3" / "support" / "form.h"
        text = form.read_text(encoding="utf-8")
        form.write_text(re.sub(r"VERSION v\w+", "VERSION v7_8_9", text), encoding="utf-8")
        running = [cls.start("main.cpp", "main", ROOT / "include", []),
                   *(cls.start(ROOT / "src" / source, source.stem, ROOT / "include", ["-O1", "-DNDEBUG"]) for source in LIBRARY)]
        running += [cls.start("unit.cpp", name, newer if name == "of_another_version" else ROOT / "include",
                              [f"-DUNIT={name}", *options]) for name, options in UNITS.items()]
        for process in running:
            if process.wait() != 0:
                raise RuntimeError(process.args)

    @classmethod
    def start(cls, source, name, include, options):
        """Without optimization: what could become part of another function is one of its own."""
        return subprocess.Popen([os.environ.get("CXX", "c++"), "-std=c++17", "-O0", "-frounding-math", f"-I{include}",
                                 "-c", HERE / "mixtures" / source, "-o", cls.folder / f"{name}.o", *options])

    def test_one_program(self):
        objects = [self.folder / f"{name}.o" for name in ("main", *UNITS, *(source.stem for source in LIBRARY))]
        program = self.folder / "program"
        subprocess.run([os.environ.get("CXX", "c++"), *objects, "-o", program, "-lmpfr", "-lgmp", "-pthread"], check=True)
        done = subprocess.run([program], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_no_bodies_in_common(self):
        """But for those of abstract classes, which do nothing, and of structs of the standard library's types, whose own
        members are shared anyway."""
        trivial = re.compile(r"::(Observer|Task|Executor|Point_source|Built|Tile_source_3|"
                             r"Tiles_\w+|Tile_files_error|Tile_too_large|Delaunay_3_tile)::")
        names = {name: functions(self.folder / f"{name}.o") for name in (*UNITS, *(source.stem for source in LIBRARY))}
        for one in names:
            for other in names:
                if one < other and not {one, other} <= {source.stem for source in LIBRARY}:
                    own = [name for name in names[one] & names[other]
                           if re.match(r"_ZNK?4CGAL(23Delaunay_from_surface_3(8internal|4core)|17delaunay_3_arrays|\d+v\d)", name)]
                    common = [name for name in readable(sorted(own)) if name and not trivial.search(name)]
                    self.assertEqual(common, [], f"{one} and {other}")
        self.assertTrue(any("v7_8_9" in name for name in names["of_another_version"]))

    def test_files_without_the_library(self):
        """One error, which says what is missing."""
        for line in ('CGAL::Point_files_3 points({"cloud.npy"});', 'CGAL::Tiles_in_files_3 engine("tiles");'):
            done = subprocess.run([os.environ.get("CXX", "c++"), "-std=c++17", "-fsyntax-only", f"-I{ROOT / 'include'}",
                                   "-x", "c++", "-"], input=f"#include <CGAL/delaunay_3_tiles.h>\nint main() {{ {line} }}\n",
                                  capture_output=True, text=True, check=False)
            error, = re.findall(r"error: (.*)", done.stderr)
            self.assertIn("is compiled: link Delaunay_from_surface_3::compiled", error)


if __name__ == "__main__":
    unittest.main()
