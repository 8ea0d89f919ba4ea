# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Reads the page that delaunay_from_surface --view writes; test_view_in_browser.py opens it."""

import json
import os
import re
import subprocess
import unittest
from pathlib import Path

from headless_chromium import arrays_of
from program_case import TORUS, ProgramCase

TETRAHEDRON = ["OFF", "4 4 0", "0 0 0", "2 0 0", "0 2 0", "0 0 2", "3 0 2 1", "3 0 1 3", "3 1 2 3", "3 2 0 3"]


class View(ProgramCase):
    program = os.environ["DELAUNAY_FROM_SURFACE"]

    def page(self, surface, *options):
        three = self.write("three.min.js", "var THREE = {};")
        self.works(surface, "--view", "page.html", "--three-js", three, "--quiet", *options)
        return (self.folder / "page.html").read_text()

    def test_numbers(self):
        self.works(TORUS, "--output", "torus.vtk", "--mark-inside")
        text = (self.folder / "torus.vtk").read_text()
        cells = text.split("CELLS 8317 41585\n")[1].split("\n")[:8317]
        marks = text.split("SCALARS inside double 1\nLOOKUP_TABLE default\n")[1].split()[:8317]
        page = self.page(TORUS)
        arrays = arrays_of(page)
        self.assertEqual([list(arrays["tetrahedra"][k:k + 4]) for k in range(0, 4 * 8317, 4)],
                         [[int(w) for w in cell.split()[1:]] for cell in cells])
        self.assertEqual([str(mark) for mark in arrays["inside"]], marks)
        self.assertEqual((len(arrays["points"]), len(arrays["triangles"])), (3 * 960, 3 * 1920))
        self.assertEqual((min(arrays["points"]), max(arrays["points"])), (-1, 1))
        self.assertEqual(set(arrays["rounds"]), set(range(max(arrays["rounds"]) + 1)))
        self.assertGreaterEqual(len(arrays["subgraph"]), 2 * 959)
        self.assertEqual(set(arrays["subgraph"]), set(range(960)))
        self.assertEqual(json.loads(re.search(r'id="info">(.*?)</script>', page)[1]), {"name": "torus.off"})
        # Nothing is fetched, and nothing can be.
        self.assertIn("default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'", page)
        self.assertNotRegex(page, r"<link|<img|\bsrc=|\bhref=|@import|url\(")

    def test_duplicates_and_coordinates(self):
        """Far from the origin, and with a point twice."""
        lines = TETRAHEDRON[:1] + ["5 4 0", "0 0 0", "1e300 0 0", "0 1e300 0", "0 0 1e300", "1e300 0 0"]
        self.write("large.off", *lines, "3 0 2 1", "3 0 4 3", "3 4 2 3", "3 2 0 3")
        arrays = arrays_of(self.page("large.off"))
        self.assertEqual(list(arrays["points"]), [-1, -1, -1, 1, -1, -1, -1, 1, -1, -1, -1, 1])
        self.assertEqual(sorted(arrays["tetrahedra"]), [0, 1, 2, 3])
        self.assertEqual(list(arrays["triangles"]), [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3])
        self.assertEqual(list(arrays["inside"]), [1])  # nearly closed: the two points are one

    def test_doubt(self):
        """What is in doubt inside is said with the page as with a file, and once."""
        lines = ["OFF", "8 10 0", *(f"{x} {y} {z}" for z in (0, 1) for y in (0, 1) for x in (0, 1))]
        faces = ["0 2 3", "0 3 1", "0 1 5", "0 5 4", "2 6 7", "2 7 3", "0 4 6", "0 6 2", "1 3 7", "1 7 5"]
        self.write("open.off", *lines, *("3 " + f for f in faces))  # a cube without its lid
        three = self.write("three.min.js", "var THREE = {};")
        for options in ((), ("--output", "a.vtu", "--mark-inside")):
            result = self.run_program("open.off", "--view", "page.html", "--three-js", three, *options)
            self.assertEqual(result.stderr.count("in doubt, near openings"), 1, result.stderr)

    def test_less_than_a_closed_surface(self):
        """A soup has no inside and no subgraph, points alone have no surface; polygons become triangles."""
        self.write("points.xyz", *TETRAHEDRON[2:6])
        arrays = arrays_of(self.page("points.xyz"))
        self.assertEqual(set(arrays), {"points", "tetrahedra", "hull"})
        self.assertEqual(sorted(arrays["hull"]), [0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3])
        self.write("soup.off", "OFF", "5 3 0", *TETRAHEDRON[2:6], "-1 -1 -1", "3 0 1 2", "3 0 1 3", "4 0 1 2 4")
        arrays = arrays_of(self.page("soup.off"))
        self.assertTrue({"points", "tetrahedra", "triangles"} <= set(arrays))
        self.assertEqual(list(arrays["triangles"]), [0, 1, 2, 0, 1, 3, 0, 1, 2, 0, 2, 4])
        self.assertFalse({"inside", "subgraph"} & set(arrays))
        for traits in ("plain", "tracing"):
            self.assertEqual("rounds" in arrays_of(self.page(TORUS, "--traits", traits)), traits == "tracing")

    def test_names(self):
        self.write("<!--<script> &.off", *TETRAHEDRON)
        page = self.page("<!--<script> &.off")
        self.assertEqual(json.loads(re.search(r'id="info">(.*?)</script>', page)[1]), {"name": "<!--<script> &.off"})
        arguments = [os.path.abspath(self.program), "-", "--from", "off", "--view", self.folder / "b.html",
                     "--three-js", self.folder / "three.min.js"]
        subprocess.run(arguments, input=TORUS.read_text(), text=True, check=True, capture_output=True)
        self.assertIn('"name": "standard input"', (self.folder / "b.html").read_text())

    def test_what_it_refuses(self):
        three = self.write("three.min.js", "var THREE = {};")
        self.write("empty.js", b"")
        for name in ("missing.js", "empty.js"):
            self.refuses(rf"'--view' needs three.js, and {name} cannot be read: install Debian's package libjs-three, "
                         "or name a three.min.js by '--three-js'", TORUS, "--view", "a.html", "--three-js", name)
        self.refuses(r"a\.vtu: a page for a browser is \.html", TORUS, "--view", "a.vtu", "--three-js", three)
        self.refuses("option '--three-js' needs '--view'", TORUS, "--three-js", three)
        self.refuses("nowhere/a.html: cannot be written", TORUS, "--view", "nowhere/a.html", "--three-js", three)
        self.write("line.xyz", "0 0 0", "1 0 0", "5 0 0")
        result = self.run_program("line.xyz", "--view", "a.html", "--three-js", three)
        self.assertRegex(result.stderr, r"\nerror: a.html: there are no tetrahedra to be viewed\n\Z")
        self.assertEqual((result.returncode, "a.html" in self.files()), (1, False))


if __name__ == "__main__":
    unittest.main()
