# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The patches for CGAL apply to the headers of the versions that are tested, and change no result."""

import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PATCHES = ROOT / "doc/Delaunay_from_surface_3/patches"
LIBRARIES = ["-lgmp", "-lmpfr"]


def versions():
    """The include folders of all CGAL that are here, by version."""
    found = {}
    for include in (Path(os.environ["CGAL_INCLUDE"]), *sorted((ROOT / "build/cgal").glob("*/usr/include"))):
        header = include / "CGAL/version.h"
        if header.is_file():
            version = re.search(r"^#define CGAL_VERSION ([\d.]+)", header.read_text(encoding="utf-8"), re.M).group(1)
            found.setdefault(version, include)
    return found


def headers_of(patch):
    """What it changes, below the include folder; that of a package is folded into one."""
    lines = patch.read_text(encoding="utf-8").splitlines()
    return [(re.sub(r"^.*/include/", "", new[4:]), old == "--- /dev/null")
            for old, new in zip(lines, lines[1:]) if old.startswith("--- ") and new.startswith("+++ ")]


def program(folder, name, include, patched=None):
    """Compiles patched.cpp with CGAL as it is or, before it, with the headers in `patched`."""
    folders = [*([patched] if patched else []), ROOT / "include", ROOT / "generator/Delaunay_from_surface_3/include"]
    launcher = os.environ.get("LAUNCHER", "").split()
    subprocess.run([*launcher, os.environ.get("CXX", "c++"), "-std=c++17", "-O0", "-DNDEBUG", "-frounding-math",
                    *(f"-I{path}" for path in folders), *([] if include == Path("/usr/include") else [f"-I{include}"]),
                    "-c", HERE / "patched/patched.cpp", "-o", folder / f"{name}.o"], check=True)
    subprocess.run([os.environ.get("CXX", "c++"), folder / f"{name}.o", "-o", folder / name, *LIBRARIES], check=True)
    return subprocess.run([folder / name], capture_output=True, text=True, check=True)


class Patches(unittest.TestCase):
    def setUp(self):
        if not shutil.which("patch"):
            self.skipTest("there is no patch (Debian: patch)")
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def patched(self, version, include, *names):
        """A folder with the headers that these patches change, changed."""
        folder = self.folder / version
        for name in names:
            for header, is_new in headers_of(PATCHES / name):
                (folder / "include" / header).parent.mkdir(parents=True, exist_ok=True)
                if not is_new:
                    shutil.copy(include / header, folder / "include" / header)
            done = subprocess.run(["patch", "--batch", "--no-backup-if-mismatch", "--fuzz=1", "-p2", "-i", PATCHES / name],
                                  cwd=folder, capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, f"{version}, {name}: {done.stdout}")
        return folder / "include"

    def test_all_are_listed(self):
        text = (PATCHES / "README.md").read_text(encoding="utf-8")
        self.assertEqual({path.name for path in PATCHES.glob("*.patch")}, set(re.findall(r"^\| `(.*\.patch)`", text, re.M)))

    def test_results(self):
        """Of the installed version, or of all that are here."""
        for version, include in versions().items():
            if "ALL" not in os.environ and include != Path(os.environ["CGAL_INCLUDE"]):
                continue
            with self.subTest(version):
                patched = self.patched(version, include, "Alpha_shapes_3.patch", "Advancing_front_surface_reconstruction.patch")
                before = program(self.folder, f"plain_{version}", include)
                after = program(self.folder, f"patched_{version}", include, patched)
                self.assertEqual((before.stderr, after.stderr), ("", "patched\n"))
                self.assertGreater(before.stdout.count("face "), 1000)
                self.assertTrue(after.stdout == before.stdout) # thousands of lines are not to be shown

    def test_others_apply(self):
        for version, include in versions().items():
            if (include / "CGAL/Tetrahedral_remeshing/internal/Medial_axis_kd_tree.h").is_file():
                self.patched(version, include, "Medial_axis_kd_tree.patch")

    def test_all_apply(self):
        for version, include in versions().items():
            self.patched(version, include, "Alpha_shapes_3.patch", "Advancing_front_surface_reconstruction.patch")


if __name__ == "__main__":
    unittest.main()
