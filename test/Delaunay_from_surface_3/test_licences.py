# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Every header names its licence; one under the LGPL includes none under the GPL, of this package or of CGAL, however deep."""

import os
import re
import shutil
import subprocess
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
INCLUDE = ROOT / "include"
LESSER, GENERAL = "LGPL-3.0-or-later", "GPL-3.0-or-later"
LESSER_ROOMS = ("core", "arrays", "tiles", "inside", "support", "surface")


# REUSE-IgnoreStart: patterns, no licences of this file
def licence(path):
    found = re.search(r"SPDX-License-Identifier: *(.+)", Path(path).read_text(encoding="utf-8", errors="replace"))
    return found.group(1).strip() if found else None
# REUSE-IgnoreEnd


class Licences(unittest.TestCase):
    def setUp(self):
        self.licences = {path: licence(path) for path in sorted([*INCLUDE.rglob("*.h"), *(path for path in (ROOT / "src").rglob("*") if path.is_file())])}
        self.assertGreater(len(self.licences), 100)

    def test_every_header_has_one(self):
        self.assertEqual(set(self.licences.values()), {LESSER, GENERAL})
        for room in LESSER_ROOMS:
            for path in (INCLUDE / "CGAL" / "Delaunay_from_surface_3" / room).rglob("*.h"):
                self.assertEqual(self.licences[path], LESSER, path)

    def test_python_and_npm_are_lesser(self):
        """They include the package's own headers, and those of lesser rooms alone."""
        files = [path for pattern in ("*.cpp", "*.h", "*.py") for path in sorted((ROOT / "python").rglob(pattern))]
        self.assertGreater(len(files), 10)
        files += [path for name in ("host.cpp", "index.mjs", "worker.mjs", "index.d.ts") for path in [ROOT / "npm" / name]]
        for path in files:
            self.assertEqual(licence(path), LESSER, path)
            for name in re.findall(r"#include <CGAL/(.+)>", path.read_text(encoding="utf-8")):
                self.assertEqual(self.licences[INCLUDE / "CGAL" / name], LESSER, f"{path}: {name}")

    def test_texts_of_the_licences(self):
        for name, first in (("LICENSE", "GNU GENERAL PUBLIC LICENSE"), ("LICENSE.LGPL", "GNU LESSER GENERAL PUBLIC LICENSE")):
            self.assertTrue((ROOT / name).read_text(encoding="utf-8").lstrip().startswith(first), name)

            self.assertEqual((ROOT / name).read_bytes(), (ROOT / f"LICENSES/{LESSER if 'L' in name[7:] else GENERAL}.txt").read_bytes())

    @unittest.skipUnless("CI" in os.environ or shutil.which("reuse") and (ROOT / ".git").exists(), "reuse was not found, or this is no git clone")
    def test_every_file_has_one(self):
        """One: what names its licence itself is not in .reuse/dep5."""
        done = subprocess.run(["reuse", "--root", ROOT, "lint"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        files = subprocess.run(["reuse", "--root", ROOT, "spdx"], capture_output=True, text=True, check=True).stdout.split("\nFileName: ")[1:]
        self.assertGreater(len(files), 500)
        self.assertEqual([file.split("\n")[0] for file in files if file.count("\nLicenseInfoInFile: ") != 1], [])

    def test_lesser_includes_no_general(self):
        lines = [f"#include <{path.relative_to(INCLUDE)}>" for path, kind in self.licences.items()
                 if kind == LESSER and path.suffix == ".h" and INCLUDE in path.parents]
        done = subprocess.run([os.environ.get("CXX", "c++"), "-std=c++17", f"-I{INCLUDE}", "-M", "-x", "c++", "-"],
                              input="\n".join(lines) + "\n", capture_output=True, text=True, check=True)
        included = {Path(path) for path in done.stdout.split() if "/CGAL/" in path}
        self.assertGreater(len(included), len(lines))
        general = sorted(str(path) for path in included
                         if re.search(r"(?<!L)GPL", self.licences.get(path) or licence(path) or ""))
        self.assertEqual(general, [])


if __name__ == "__main__":
    unittest.main()
