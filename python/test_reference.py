# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""The reference of the Python module: Sphinx makes it without a warning, and nothing public is missing."""

import ast
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent


class Reference(unittest.TestCase):
    def test_pages(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, "-B", "-m", "sphinx", "-q", "-W", "--keep-going", "-b", "html", "-d", f"{folder}/trees",
                                   HERE / "reference", f"{folder}/html"], capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            pages = "".join(path.read_text(encoding="utf-8") for path in Path(folder, "html").glob("*.html"))
        shown = re.findall(r'<dt class="sig[^>]* id="delaunay_from_surface\.(\w+)"', pages)
        tree = ast.parse((HERE / "src/delaunay_from_surface/__init__.py").read_text(encoding="utf-8"))
        (names,) = (ast.literal_eval(node.value) for node in tree.body
                    if isinstance(node, ast.Assign) and getattr(node.targets[0], "id", "") == "__all__")
        self.assertEqual(sorted(shown), sorted(names))
        self.assertNotIn("pybind11", pages)


if __name__ == "__main__":
    unittest.main()
