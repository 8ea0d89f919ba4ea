# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Runs the program delaunay_from_surface as a user would, and checks exit codes, output and files."""

import json
import math
import os
import random
import re
import resource
import signal
import struct
import subprocess
import time
import unittest
from fractions import Fraction
from itertools import combinations
from pathlib import Path

from program_case import ROOT, TORUS, ProgramCase

DATA = Path(__file__).parent / "data"
PLANE_NOTE = r"note: the points lie in one plane: CGAL's own insertion takes the compact triangulation's place\n"
SOUP_NOTE = r"note: [a-z_]+\.[a-z]+: not a consistently oriented manifold mesh, taken as a polygon soup\n"
TETRAHEDRON = ["v 0 0 0", "v 1 0 0", "v 0 1 0", "v 0 0 1", "f 1 3 2", "f 1 2 4", "f 2 3 4", "f 3 1 4"]
PLY_VERTICES = ["ply", "format ascii 1.0", "element vertex 4", "property double x", "property double y",
                "property double z"]
PLY_CORNERS = ["0 0 0", "1 0 0", "0 1 0", "0 0 1"]


def squared_power_radius(points, weights=(0, 0, 0, 0)):
    """Of a tetrahedron, by Cramer's rule; with the centre."""
    edges = [[a - b for a, b in zip(p, points[0])] for p in points[1:]]

    def det(m):
        return sum(m[0][i] * (m[1][(i + 1) % 3] * m[2][(i + 2) % 3] - m[1][(i + 2) % 3] * m[2][(i + 1) % 3])
                   for i in range(3))
    squares = [(sum(x * x for x in e) + weights[0] - w) / 2 for e, w in zip(edges, weights[1:])]
    center = [det([[s if k == j else e[k] for k in range(3)] for e, s in zip(edges, squares)]) / det(edges)
              for j in range(3)]
    return sum(x * x for x in center) - weights[0], [a + x for a, x in zip(points[0], center)]


def volume_of_origin(a, b, c):
    """That of the tetrahedron of the origin and three points."""
    return sum(a[i] * (b[(i + 1) % 3] * c[(i + 2) % 3] - b[(i + 2) % 3] * c[(i + 1) % 3]) for i in range(3)) / 6


def circumradius(points):
    return squared_power_radius(points)[0] ** 0.5


class Program(ProgramCase):
    program = os.environ["DELAUNAY_FROM_SURFACE"]

    def test_what_it_says_about_itself(self):
        text = (Path(__file__).parent / "help.txt").read_text()
        self.assertEqual(self.works("--help"), text)
        self.assertEqual(self.works("tiles", "a.npy", "b.npy", "--memory", "8G", "--help"), text)
        self.assertLessEqual(max(map(len, text.splitlines())), 80)
        script = subprocess.run([ROOT / "scripts/run", "--help"], capture_output=True, text=True, check=True)
        self.assertEqual(script.stdout, text)
        page = (Path(__file__).parent / "delaunay_from_surface.1").read_text().replace("\\-", "-")
        for option in set(re.findall(r"--[a-z-]+", text)):
            self.assertIn(option, page)
        self.works("--version", prints=[r"\Adelaunay_from_surface \d+\.\d+\.\d+ \(CGAL [0-9.]+"])

    def test_a_mesh_by_all_traits(self):
        number = r" +[0-9.]+\n"
        # What the default does, in its own counts; for the others the calls of the predicates.
        counts = {True: [rf"\ncells destroyed:{number}", rf"\nsphere tests:{number}", r"\nintegers of any width: +0\n"],
                  False: [r"\nall +locate +960 ", r"\nall +update +960 "]}
        for traits in ("default", "tracing", "plain"):
            self.works(TORUS, "--traits", traits, "--seed", 3, "--compare", "--repetitions", 2, "--stats", prints=[
                r"\nsurface: +triangle mesh\n", rf"\ntraits: +{traits}\n", r"\nseed: +3\n", r"\ndimension: +3\n",
                r"\nvertices: +960\n", r"\nduplicates: +0\n", r"\nfinite cells: +8317\n", r"\nrepetitions: +2\n",
                rf"\npackage CPU seconds:{number}", rf"\nplain CPU seconds:{number}", rf"\nCPU ratio:{number}",
                rf"\nwall ratio:{number}", r"\nequal: +yes\n", r"\nDelaunay edges: +2880 of 2880 ",
                r"\nDelaunay triangles: +1920 of 1920 ", rf"\nlocate:{number}", *counts[traits == "default"]])
        self.works(TORUS, "--traits", "tracing", "--stats", prints=[r"\n1 +trace +\d+ ", r"\nall +trace +\d+ "])
        self.works(TORUS, prints=[r"\nfinite cells: +8317\n", r"cells: +\d+\n\Z"])  # and nothing after that


class Surfaces(ProgramCase):
    """Those that are less than a mesh of triangles, and the formats."""

    program = os.environ["DELAUNAY_FROM_SURFACE"]

    def test_a_rhombus_with_the_wrong_diagonal(self):
        """The edge 0-1 and both triangles are not Delaunay."""
        faces = ["3 0 1 2", "3 1 0 3"]
        corners = ["-2 0 0", "2 0 0", "0 1 0", "0 -1 0"]
        self.write("rhombus.off", "OFF", "6 2 0", *corners, "0 0 5", "0 0 -5", *faces)
        self.works("rhombus.off", "--compare", "--stats", prints=[
            r"surface: +triangle mesh\n", r"\nother edges: +1 of 5 \(20\.0000 %\)\n",
            r"\nDelaunay triangles: +0 of 2 ", r"\nother triangles: +2 of 2 ", r"\nequal: +yes\n"])
        self.write("flat.off", "OFF", "4 2 0", *corners, *faces)
        self.works("flat.off", "--compare", "--stats", "--output", "flat.vtu", prints=[
            r"\ndimension: +2\n", r"\nwritten: +2 triangles to flat.vtu\n", r"\nother edges: +1 of 5 ",
            r"\nall +locate +4 ", r"\nequal: +yes\n"], notes=PLANE_NOTE)

    def test_three_sheets_at_an_edge(self):
        self.write("three_sheets.off", "OFF", "5 3 0", "0 0 0", "0 0 1", "1 0 0", "-1 1 0", "-1 -1 0", "3 0 1 2",
                   "3 0 1 3", "3 0 1 4")
        self.works("three_sheets.off", "--compare", "--stats", prints=[
            r"\nsurface: +polygon soup\n", r"\nDelaunay triangles: +3 of 3 ", r"\nequal: +yes\n"],
            notes=r"note: faces that are not triangles: 0, edges with more than two faces: 1\n" + SOUP_NOTE)

    def test_polygons(self):
        self.write("polygons.off", "OFF", "5 2 0", "0 0 0", "1 0 0", "1 1 0", "0 1 0", "2 0 1", "4 0 1 2 3", "3 1 4 2")
        self.works("polygons.off", "--compare", "--stats", prints=[
            r"\nsurface: +polygon mesh\n", r"\nDelaunay edges: +6 of 6 ", r"\nDelaunay triangles: +1 of 1 ",
            r"\npolygons: +1 \(not counted as triangles\)\n", r"\nequal: +yes\n"],
            notes=r"note: faces that are not triangles: 1\n")

    def test_equal_points(self):
        """Vertices 1 and 3, 2 and 4 are the same points: two triangles with one edge in common."""
        self.write("seam.off", "OFF", "7 2 0", "0 0 0", "1 0 0", "0 1 0", "1 0 0", "0 1 0", "1 1 0", "0 0 1", "3 0 1 2",
                   "3 3 5 4")
        self.works("seam.off", "--compare", "--stats", "--output", "seam.mesh", prints=[
            r"\nsurface vertices: +7\n", r"\nvertices: +5\n", r"\nduplicates: +2\n", r"\nDelaunay edges: +5 of 5 ",
            r"\nequal: +yes\n"])
        self.write("same.off", "OFF", "2 0 0", "1 2 3", "1 2 3")
        self.works("same.off", "--compare", "--stats", "--output", "same.vtu", prints=[
            r"\ndimension: +0\n", r"\nduplicates: +1\n", r"\nequal: +yes\n"],
            notes=PLANE_NOTE + r"note: same.off: there are no faces[^\n]*\n")

    def test_points_without_faces(self):
        self.write("points.off", "OFF", "3 0 0", "0 0 0", "1 0 0", "5 0 0")
        self.works("points.off", "--compare", "--stats", "--output", "points.mesh", prints=[
            r"\nsurface: +points without faces\n", r"\ndimension: +1\n",
            r"\nDelaunay edges: +not counted in dimension 1\n", r"\nwritten: +2 edges to points.mesh\n",
            r"\nequal: +yes\n"],
            notes=PLANE_NOTE + r"note: points.off: there are no faces, its points are taken alone\n")

    def test_points_in_every_format(self):
        corners = ["0 0 0", "1 0 0", "0 1 0", "0 0 1"]
        self.write("vertices.obj", "# no faces", *("v " + p for p in corners))
        self.write("points.xyz", *(p + " 0 0 1" for p in corners))
        self.write("points.pts", "4", *(p + " -1200 255 255 255" for p in corners))
        self.write("points.off", "OFF", "4 0 0", *corners)
        self.write("points.ply", *PLY_VERTICES, "end_header", *corners)
        for name in ("vertices.obj", "points.xyz", "points.pts", "points.off", "points.ply"):
            with self.subTest(name):
                self.works(name, prints=[r"\nsurface: +points without faces\n", r"\nfinite cells: +1\n"],
                           notes=rf"note: {name}: there are no faces, its points are taken alone\n")

    def test_marks_of_editors(self):
        """What stands before a text in UTF-8, and ends of lines as Windows has them."""
        self.write("mark.xyz", b"\xef\xbb\xbf0 0 0\r\n1 0 0\r\n0 1 0\r\n0 0 1\r\n")
        self.works("mark.xyz", "--quiet", "--json", prints=[r'"finite_cells": 1\b'])

    def test_carriage_returns_alone(self):
        """As systems had them whose editors are still around."""
        self.write("mac.off", b"OFF # a comment\r4 2 0\r\r0 0 0\r1 0 0\r0 1 0\r0 0 1\r3 0 2 1\r3 0 1 3\r")
        self.write("mac.obj", "\r".join(TETRAHEDRON).encode())
        self.write("mac.xyz", b"0 0 0\r1 0 0\r0 1 0\r0 0 1")
        for name in ("mac.off", "mac.obj", "mac.xyz"):
            self.works(name, "--quiet", "--json", prints=[r'"finite_cells": 1\b'])
        for end in (b"\r\r\n", b"\r"):  # a text made one of Windows twice, and ends of all kinds in one
            self.write("mixed.xyz", b"# a comment\n0 0 0" + end + b"1 0 0" + end + b"0 1 0" + end + b"0 0 1\n")
            self.works("mixed.xyz", "--quiet", "--json", prints=[r'"finite_cells": 1\b'])
        self.write("wrong.xyz", b"0 0 0\r\r\n1 0 0\r0 x 0\n")
        self.refuses("wrong.xyz: cannot be read as .xyz: line 3: 'x' is not a number", "wrong.xyz")
        self.write("short.off", b"OFF\r4 1 0\r0 0 0\r1 0 0\r")
        self.refuses("short.off: cannot be read as .off: line 4: the file ends too early", "short.off")

    def test_lines_of_obj_that_go_on(self):
        self.write("long.obj", "# a comment does not go on \\", "v 0 0 \\", "0", "v 1 \\", " \\", "0 0", "v 0 1 0",
                   "v 0 0 1", "f 1\\", "2\\", "3 4", "o name \\", "f 1 2 3")
        crlf = (self.folder / "long.obj").read_bytes().replace(b"\n", b"\r\n")
        self.write("crlf.obj", crlf)
        self.write("end.obj", (self.folder / "long.obj").read_bytes() + b"f 1 2 3 \\")
        for name, faces in (("long.obj", 1), ("crlf.obj", 1), ("end.obj", 2)):
            self.works(name, "--quiet", "--json", prints=[rf'"surface_faces": {faces}\b', r'"finite_cells": 1\b'])
        for wrong, message in (("v 1\\ 2 3", r"line 1: '1\\' is not a number"),
                               ("v 1 \\\n2", "line 1: a vertex has too few"),
                               ("v 1 2 \\\n3\nv 1 x", "line 3: 'x' is not a number")):
            self.write("wrong.obj", wrong)
            self.refuses(r"wrong.obj: cannot be read as .obj: " + message, "wrong.obj")
        self.write("points.xyz", "0 0 0 \\", "1 0 0", "0 1 0", "0 0 1")  # elsewhere it is passed over
        self.works("points.xyz", "--quiet", "--json", prints=[r'"finite_cells": 1\b'])

    def test_points_that_are_announced(self):
        corners = ["0 0 0", "1 0 0", "0 1 0", "0 0 1"]
        alone = "note: points.pts: there are no faces, its points are taken alone\n"
        self.write("points.pts", "2", *corners[:2], "3", *corners[2:])
        self.works("points.pts", notes=r"note: points.pts: 5 points are announced, and only 4 are there\n" + alone)
        self.write("points.pts", str(2 ** 64 - 2), "7", *corners)
        self.works("points.pts", notes=rf"note: points.pts: {2 ** 64 - 1} points are announced, and only 4[^\n]*\n" + alone)
        self.write("points.pts", "3", *corners)
        self.works("points.pts", notes=alone)

    def test_more_than_is_announced(self):
        """It is passed over, and said; columns that are not announced would be taken for the next points."""
        more = r"note: (more\.[a-z]+): what follows is passed over, as the header announces only 4 points and 2 faces\n"
        self.write("more.off", "OFF", "4 2 0", *PLY_CORNERS, "3 0 2 1", "3 0 1 3", "3 1 2 3")
        self.works("more.off", notes=more)
        faces = [*PLY_VERTICES, "element face 2", "property list uchar int vertex_indices", "end_header"]
        self.write("more.ply", *faces, *PLY_CORNERS, "3 0 2 1", "3 0 1 3", "3 1 2 3")
        self.works("more.ply", notes=more)
        self.write("wide.ply", *faces, *(p + " 0 0 1" for p in PLY_CORNERS), "3 0 2 1", "3 0 1 3")
        self.refuses("wide.ply: cannot be read as .ply: the first vertex has 6 numbers in its line, and the",
                     "wide.ply")
        triangle = struct.pack("<12fH", 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0)
        self.write("more.stl", bytes(80) + struct.pack("<I", 1) + 2 * triangle)
        self.works("more.stl", notes=PLANE_NOTE + more.replace("4 points and 2", "3 points and 1"))

    def test_texts_of_stl(self):
        """In capital letters, behind a mark of UTF-8, a tab or nothing: CGAL's reader took some for binary first and kept
        the points that it found so. A binary file may begin as a text does, and have more behind it."""
        corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
        triangles = [[corners[i] for i in f] for f in ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3))]
        facets = ["\tfacet normal nan 0 0\n\t\touter loop\n" + "".join(f"\t\t\tvertex {x} {y} {z:.1e}\n" for x, y, z in t)
                  + "\t\tendloop\n\tendfacet\n" for t in triangles]
        text = "solid\ta loop of facets\n" + "".join(facets) + "endsolid a\n"
        binary = b"solid " + bytes(74) + struct.pack("<I", 4) + b"".join(
            struct.pack("<12fH", *3 * [float("nan")], *(x for p in t for x in p), 0) for t in triangles)
        for content in (text, text.upper(), "\ufeff" + text, text.replace("\n", "\r\n"), text.replace("\n", "\r"),
                        text.replace("\n", " "), text.replace("nan 0 0", "1 0"), "\n \n" + text, "made by hand\n" + text,
                        "\n".join(f"solid {k}\n{f}endsolid" for k, f in enumerate(facets)), binary, binary + b"more",
                        text.replace("endsolid a", "endsolid Solid"), text.replace("endsolid a", "endsolid a solid part")):
            with self.subTest(content[:40]):
                self.write("part.stl", content if isinstance(content, bytes) else content.encode())
                self.works("part.stl", "--output", "part.mesh", prints=[
                    r"\nsurface: +triangle mesh\n", r"\nsurface vertices: +4\n", r"\nsurface faces: +4\n"])
        for message, content in (
                ("it is cut short: the keyword endsolid is missing", text[:-len("endsolid a\n")]),
                ("it is cut short: the keyword endsolid is missing", text + "solid b\n"),
                ("line 8: 'facet' stands where endfacet should", text.replace("\tendfacet\n", "", 1)),
                ("line 6: 'endloop' stands where vertex should", text.replace("\t\t\tvertex 1 0 0.0e+00\n", "", 1)),
                ("line 7: 'vertex' stands where endloop should", text.replace("\t\tendloop", "\t\t\tvertex 1 1 1\n\t\tendloop", 1)),
                ("triangle 1: a coordinate is not a finite number", text.replace("1.0e+00", "nan")),
                ("line 4: the file ends too early", text[:75]),
                ("it is damaged, cut short or in another format", binary.replace(b"solid ", b"binary")[:-1])):
            with self.subTest(message):
                self.write("part.stl", content if isinstance(content, bytes) else content.encode())
                self.refuses(r"part.stl: cannot be read as .stl: (line \d+: )?" + message, "part.stl")

    def test_collapsed_triangles(self):
        """Rounding has put two corners of a triangle at one point, and all three of another."""
        corners = {"1": "0 0 0", "2": "1 0 0", "3": "0 1 0", "4": "0 0 1"}
        facets = ["1 3 2", "1 2 4", "2 3 4", "3 1 4", "1 1 2", "3 3 3"]
        self.write("part.stl", "solid part", *(line for f in facets for line in (
            "facet normal 0 0 0", "outer loop", *("vertex " + corners[k] for k in f.split()), "endloop", "endfacet")),
            "endsolid part")
        self.works("part.stl", "--inside", "--output", "part.mesh", prints=[
            r"\nsurface: +triangle mesh\n", r"\nsurface faces: +4\n", r"\nwritten: +1 tetrahedra to part.mesh\n"],
            notes=r"note: part.stl: triangles with two corners at one point, left out: 2\n")

    def test_indices_of_obj(self):
        self.write("indices.obj", "v 0 0 0", "v 1 0 0", "v 0 1 0", "f -3//1 -2//1 -1/7/1", "g a", "v 0 0 1", "f 1 4 2")
        self.works("indices.obj", "--stats", prints=[r"\nsurface: +triangle mesh\n", r"\nDelaunay edges: +5 of 5 "])
        for face in ("0 1 2", "-4 1 2", "1 2 x", "1 2 4"):
            self.write("wrong.obj", "v 0 0 0", "v 1 0 0", "v 0 1 0", "f " + face)
            self.refuses(r"wrong.obj: cannot be read as .obj: face 0: it has a vertex that is not", "wrong.obj")

    def test_standard_input_and_output(self):
        arguments = [os.path.abspath(self.program), "-", "--from", "off", "--output", "-", "--to", "mesh"]
        result = subprocess.run(arguments, input=TORUS.read_text(), capture_output=True, text=True, check=True)
        self.assertRegex(result.stdout, r"\AMeshVersionFormatted 2\n")
        self.assertRegex(result.stderr, r"\nwritten: +8317 tetrahedra to -\n")
        for error, words in (("the standard input needs '--from'", ["-"]),
                             ("'--output -' needs '--to'", [TORUS, "--output", "-"]),
                             ("TetGen's three files do not fit", [TORUS, "--output", "-", "--to", "tetgen"])):
            self.refuses(error, *words, stdin=subprocess.DEVNULL)
        self.refuses("the standard input is empty", "-", "--from", "off", stdin=subprocess.DEVNULL)

    def test_formats(self):
        self.write("tetrahedron.obj", *TETRAHEDRON)
        self.write("ascii.PLY", *PLY_VERTICES, "element face 2", "property list uchar int vertex_indices",
                   "end_header", *PLY_CORNERS, "3 0 2 1", "3 0 1 3")
        self.write("tetrahedron.stl", "solid t", "facet normal 0 0 0", "outer loop", "vertex 0 0 0", "vertex 1 0 0",
                   "vertex 0 1 0", "endloop", "endfacet", "facet normal 0 0 0", "outer loop", "vertex 1 0 0",
                   "vertex 0 0 0", "vertex 0 0 1", "endloop", "endfacet", "endsolid t")
        # Colors, normals and comments are passed over.
        self.write("colors.off", "# a comment", "CNOFF", "4 2 0 # vertices, faces, edges", "",
                   *(f"{p} 0 0 1 255 0 0 # red" for p in PLY_CORNERS), "3 0 2 1 0.5 0.5 0.5", "3 0 1 3 7")
        self.write("homogeneous.off", "4OFF", "4 2 0", *(" ".join(str(2 * int(x)) for x in p.split()) + " 2"
                                                        for p in PLY_CORNERS), "3 0 2 1", "3 0 1 3")
        for order, name in (("<", "little"), (">", "big")):
            header = "\n".join([
                "ply", f"format binary_{name}_endian 1.0", "comment made here", "element vertex 4",
                "property uchar red", "property float x", "property float y", "property double z", "element face 2",
                "property list ushort uint vertex_index", "element other 1", "property list int float a",
                "end_header\n"])
            vertices = [struct.pack(order + "Bffd", 1, *map(float, p.split())) for p in PLY_CORNERS]
            faces = [struct.pack(order + "H3I", 3, *f) for f in ((0, 2, 1), (0, 1, 3))]
            self.write(f"{name}.ply", header.encode() + b"".join(vertices + faces) + struct.pack(order + "i2f", 2, 0, 0))
        # What other programs write: faces over several lines, no blank behind the keyword, carriage returns alone.
        self.write("lines.off", "OFF4 2 0", *PLY_CORNERS, "3 0", "2 ", "1", "3", "0 1 3 255 0 0")
        header, content = (self.folder / "little.ply").read_bytes().split(b"end_header\n")
        self.write("mac.ply", header.replace(b"\n", b"\r") + b"end_header\r" + content)
        for name in ("tetrahedron.obj", "ascii.PLY", "tetrahedron.stl", "colors.off", "homogeneous.off", "little.ply",
                     "big.ply", "lines.off", "mac.ply"):
            with self.subTest(name):
                self.works(name, "--compare", "--output", "tetrahedron.mesh", prints=[
                    r"\nsurface: +triangle mesh\n", r"\nvertices: +4\n", r"\nfinite cells: +1\n", r"\nequal: +yes\n"])
                self.assertIn("\n0 0 0 0\n1 0 0 0\n0 ", (self.folder / "tetrahedron.mesh").read_text())


class Output(ProgramCase):
    program = os.environ["DELAUNAY_FROM_SURFACE"]

    def test_medit(self):
        self.write("tetrahedron.obj", *TETRAHEDRON)
        self.works("tetrahedron.obj", "-o", "tetrahedron.mesh", prints=[
            r"\nwritten: +1 tetrahedra to tetrahedron.mesh\n\Z"])
        self.assertRegex((self.folder / "tetrahedron.mesh").read_text(),
                         r"\AMeshVersionFormatted 2\nDimension 3\n\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n\n"
                         r"Tetrahedra\n1\n[1-4] [1-4] [1-4] [1-4] 0\n\nEnd\n\Z")

    def test_vtu(self):
        self.works(TORUS, "--output", "torus.vtu", prints=[r"\nwritten: +8317 tetrahedra to torus.vtu\n\Z"])
        content = (self.folder / "torus.vtu").read_bytes()
        self.assertIn(b'<Piece NumberOfPoints="960" NumberOfCells="8317">', content)
        # Four arrays of 8 + size bytes follow the underscore: coordinates, corners, ends and types.
        arrays = content.index(b'"raw">_') + 7
        closing_tags = 30
        sizes = [960 * 24, 8317 * 32, 8317 * 8, 8317, 960 * 8, 8317 * 8]
        self.assertEqual(len(content), arrays + sum(8 + size for size in sizes) + closing_tags)
        self.assertEqual(re.findall(rb'Name="([A-Za-z_]+)"', content), [
            b"Points", b"connectivity", b"offsets", b"types", b"input_index", b"circumradius"])
        offsets = [int(o) for o in re.findall(rb'offset="(\d+)"', content)]
        for offset, size in zip(offsets, sizes):
            self.assertEqual(struct.unpack_from("<Q", content, arrays + offset), (size,))
        first = struct.unpack_from("<4q", content, arrays + offsets[1] + 8)
        points = [struct.unpack_from("<3d", content, arrays + 8 + 24 * i) for i in first]
        radius, = struct.unpack_from("<d", content, arrays + offsets[5] + 8)
        self.assertAlmostEqual(radius, circumradius(points), 9)
        self.assertEqual(struct.unpack_from("<960q", content, arrays + offsets[4] + 8), tuple(range(960)))

    def test_radii_of_flat_tetrahedra(self):
        """A turned cube: the radii of tetrahedra that are flat but for rounding are those of fractions."""
        (self.folder / "cube.xyz").write_text("".join(
            f"{.6 * x - .8 * y!r} {.48 * x + .36 * y - .8 * z!r} {.64 * x + .48 * y + .6 * z!r}\n"
            for x in range(3) for y in range(3) for z in range(3)))
        self.works("cube.xyz", "--output", "cube.vtk", notes="note: cube.xyz: there are no faces, its points are taken alone\n")
        words = (self.folder / "cube.vtk").read_text().split()
        points = [[Fraction(float(w)) for w in words[words.index("double") + 1 + 3 * i:][:3]] for i in range(27)]
        number = int(words[words.index("CELLS") + 1])
        cells = [list(map(int, words[words.index("CELLS") + 4 + 5 * c:][:4])) for c in range(number)]
        radii = list(map(float, words[words.index("circumradius") + 5:][:number]))
        for cell, radius in zip(cells, radii):
            self.assertLess(abs(radius / circumradius([points[i] for i in cell]) - 1), 1e-12)

    def test_names_of_tetgen(self):
        """Only TetGen's own extensions are taken off: model.1 is a name, whose input is model.node."""
        (self.folder / "model.node").write_text("somebody's")
        self.works(TORUS, "--to", "tetgen", "-o", "model.1", prints=["written: .* to model.1.node, model.1.ele and model.1.neigh\n"])
        self.works(TORUS, "-o", "other.v2.ele")
        self.assertEqual(sorted(file.name for file in self.folder.glob("*.*") if file.suffix in (".node", ".ele", ".neigh")), [
            "model.1.ele", "model.1.neigh", "model.1.node", "model.node", "other.v2.ele", "other.v2.neigh", "other.v2.node"])
        self.assertEqual((self.folder / "model.node").read_text(), "somebody's")

    def test_other_formats(self):
        """All hold the same tetrahedra."""
        counts = {"vtk": r"CELLS 8317 41585\n4 \d+ \d+ \d+ \d+\n[^$]*\nCELL_TYPES 8317\n10\n[^$]*\nSCALARS input_index "
                         r"[^$]*\nSCALARS circumradius double 1\n",
                  "msh": r"\A\$MeshFormat\n2.2 0 8\n\$EndMeshFormat\n\$Nodes\n960\n1 [^$]*\n\$EndNodes\n\$Elements\n8317\n"
                         r"1 4 2 0 1 \d+ \d+ \d+ \d+\n[^$]*\n8317 4 [^$]*\$EndElements\n\$ElementData\n1\n\"circumradius\"",
                  "node": r"\A960 3 0 0\n0 ", "ele": r"\A8317 4 0\n0 \d+ ", "neigh": r"\A8317 4\n0 -?\d+ "}
        for name in ("torus.vtk", "torus.msh", "torus.ele"):
            self.works(TORUS, "--output", name, prints=[rf"\nwritten: +8317 tetrahedra to .*{name}\b"])
        for extension, pattern in counts.items():
            self.assertRegex((self.folder / f"torus.{extension}").read_text(), pattern)
        cells, neighbors = ([list(map(int, line.split()[1:])) for line in (self.folder / f"torus.{e}").read_text()
                             .splitlines()[1:]] for e in ("ele", "neigh"))
        for c, row in enumerate(neighbors):
            for k, n in enumerate(row):
                if n >= 0:
                    self.assertTrue(set(cells[c]) - {cells[c][k]} < set(cells[n]))
                    self.assertIn(c, neighbors[n])
        self.works(TORUS, "--output", "torus.cgal", prints=["written: +the triangulation to torus.cgal"])
        self.assertEqual((self.folder / "torus.cgal").read_bytes()[:8], struct.pack("<2i", 3, 960))

    def test_inside(self):
        """The volume of a cube's tetrahedra inside a smaller box is that of what is inside."""
        corners = [f"{x} {y} {z}" for x in (0, 1) for y in (0, 1) for z in (0, 1)]
        sides = ["4 0 1 3 2", "4 4 6 7 5", "4 0 4 5 1", "4 2 3 7 6", "4 0 2 6 4", "4 1 5 7 3"]
        triangles = [f"3 {a} {b} {c}" for a, b, c, d in (s.split()[1:] for s in sides)]
        triangles += [f"3 {a} {c} {d}" for a, b, c, d in (s.split()[1:] for s in sides)]
        self.write("cube.off", "OFF", "9 12 0", *corners, "3 3 3", *triangles)
        self.works("cube.off", "--output", "all.mesh", "--stats")
        self.works("cube.off", "--output", "inside.mesh", "--inside", prints=[r"\nwritten: +(5|6) tetrahedra to inside.mesh\n"])
        words = (self.folder / "inside.mesh").read_text().split()
        first = words.index("Tetrahedra") + 2
        used = {int(w) for k, w in enumerate(words[first:-1]) if k % 5 != 4}
        self.assertEqual(used, set(range(1, 9)))
        self.works("cube.off", "--output", "marked.vtk", "--mark-inside")
        marks = (self.folder / "marked.vtk").read_text().split("SCALARS inside double 1\nLOOKUP_TABLE default\n")[1]
        marks = marks.split("SCALARS")[0].split()
        self.assertEqual((set(marks), marks.count("1") in (5, 6)), ({"0", "1"}, True))

    def test_points_of_other_programs(self):
        """Names of columns are passed over; molecules, strips and what is compressed are refused with what to do."""
        corners = ["0 0 0", "1 0 0", "0 1 0", "0 0 1"]
        for k, first in enumerate(("//X Y Z", "// X Y Z R G B", "x y z", "X Y Z Nx Ny Nz", "//")):
            self.write("named.xyz", *([first] if k < 4 else [first, "4"]), *corners)
            self.works("named.xyz", "--quiet", "--json", prints=[r'"finite_cells": 1\b'])
        for count, comment, atoms in (("4", "water, and more", ["C 0 0 0", "H 1 0 0", "He 0 1 0", "O 0 0 1"]),
                                      (" 4 ", "0 0 0", [f"Na {c} 0.5" for c in corners]), ("2", "", ["C1 0 0 0", "C2 1 1e-3 1"]),
                                      ("3", "", ["8 0 0 0.1", "1 0.7 0 0.6", "1 -0.7 0 0.6"])):
            self.write("atoms.xyz", count, comment, *atoms)
            self.refuses(r"atoms.xyz: cannot be read as .xyz: it is a molecule, .*; remedy: .*tail -n \+3 FILE \| awk", "atoms.xyz")
        self.write("atoms.xyz", "4", *(f"{corner} 7" for corner in corners))  # a count, and points with an intensity
        self.works("atoms.xyz", "--quiet", "--json", prints=[r'"finite_cells": 1\b'])
        faces = ["3 0 2 1", "3 0 1 3", "3 0 3 2", "3 1 2 3"]
        for keyword in ("NCOFF", "CNOFF", "NSTOFF", "STCNOFF"):
            self.write("normals.off", keyword, "4 4 0", *(f"{corner} 0 0 1 9 9 9 255" for corner in corners), *faces)
            self.works("normals.off", "--quiet", "--json", prints=[r'"surface_faces": 4\b', r'"finite_cells": 1\b'])
        ply = (*PLY_VERTICES, "element face 1", "property list int float vertex_indices", "end_header", *corners)
        self.write("half.ply", *ply, "2.5 0 1 2")
        self.refuses("half.ply: cannot be read as .ply: .*a number of entries that is not whole", "half.ply")
        self.write("half.ply", *ply, "3 0 1.5 2")
        self.refuses("half.ply: ", "half.ply")
        self.write("none.ply", *PLY_VERTICES, "element face 0", "end_header", *corners)
        self.works("none.ply", "--quiet", "--json", prints=[r'"finite_cells": 1\b'])
        self.write("strips.ply", *PLY_VERTICES, "element tristrips 1", "property list int int vertex_indices", "end_header",
                   *corners, "4 0 1 2 3")
        self.refuses("strips.ply: cannot be read as .ply: its triangles are in strips, .*; remedy: export it with faces", "strips.ply")
        for name, remedy in (("a.obj.gz", r"zcat a.obj.gz \| delaunay_from_surface - --from obj"), ("b.gz", "zcat b.gz .* --from FORMAT"),
                             ("c.ply.bz2", "bzcat c.ply.bz2 .* --from ply"), ("d.STL.XZ", "xzcat d.STL.XZ .* --from stl")):
            self.write(name, "anything")
            self.refuses(f"{name}: is compressed; remedy: {remedy}", name)

    def test_no_inside(self):
        """What is not closed is counted, and placed."""
        sides = ["3 0 2 1", "3 0 1 3", "3 1 2 3", "3 2 0 3"]
        other = ["3 3 5 4", "3 3 4 6", "3 4 5 6", "3 5 3 6"]
        corners = ["0 0 0", "1 0 0", "0 1 0", "0 0 1", "1 0 1", "0 1 1", "0 0 2"]
        edge = r", first \d-\d at \([-0-9., ]+\)"
        for faces, why in ((sides[2:], f"open edges: 4{edge}"),
                           (sides[2:3], f"open edges: 3{edge}")):
            self.write("a.off", "OFF", f"7 {len(faces)} 0", *corners, *faces)
            self.refuses(rf"a.off: the surface has no inside: by its winding numbers too much is in doubt, "
                         rf"and its openings have \d+ % of its area, the largest \d+ %; "
                         rf"remedy: close them, and leave out walls inside the solid; {why}$",
                         "a.off", "--inside", "-o", "a.vtu")
            self.assertNotIn("a.vtu", self.files())
        for faces, why in ((sides[1:], f"open edges: 3{edge}"),
                           ([*sides, "3 0 1 4"], f"open edges: 2{edge}; edges with more than two faces: 1{edge}"),
                           (["3 0 0 1", *sides], "edges with more than two faces: 1.*; faces that are no triangles: 1"),
                           ([*sides, *other], "sheets that touch in a vertex, or points given twice")):
            self.write("a.off", "OFF", f"7 {len(faces)} 0", *corners, *faces)
            self.works("a.off", "--inside", "-o", "a.vtu", prints=[
                rf"\nnot closed: +{why}\nvolume inside: +[0-9.]+\n", r"\nfaces turned: +0\n", r"\ntetrahedra in doubt: +\d+ of \d+ ",
                r"\nvolume in doubt: +[0-9.]+ % of that inside\n", r"\nopenings: +[0-9.]+ % of the surface's area\n",
                r"\nfaces not Delaunay: +[0-9.]+ % of the surface's area\n", r"\nvolume possibly wrong: +[0-9.]+ %, which such faces cut off\n",
                r"\nin several parts: +0\n"],
                notes=rf"(note: faces[^\n]*\n)?(warning: a.off: \d+ % of the volume inside is in doubt, [^\n]*\n)?({SOUP_NOTE})?")
        self.write("points.off", "OFF", "7 0 0", *corners)
        self.refuses("points.off: it has no inside: there are no faces", "points.off", "--inside", "-o", "a.vtu")
        self.write("flat.off", "OFF", "3 1 0", *corners[:3], "3 0 1 2")
        self.refuses("flat.off: it has no inside: its points lie in a plane; open edges: 3, first 0-1 at ", "flat.off", "--inside", "-o", "a.vtu",
                     prefix=PLANE_NOTE + "error: ")

    def test_parts_that_are_hurt(self):
        """The torus with holes, flipped faces and some twice: nearly the same tetrahedra are inside."""
        lines = TORUS.read_text().split("\n")
        first = next(k for k, line in enumerate(lines) if line.startswith("3 "))
        faces = [line for line in lines[first:] if line]

        def inside(name, some):
            self.write(name, "OFF", f"960 {len(some)} 0", *lines[first - 960:first], *some)
            text = self.works(name, "--mark-inside", "-o", "a.vtk", "--json", notes=f"(note: faces that are not [^\\n]*\n)?({SOUP_NOTE})?")
            marks = (self.folder / "a.vtk").read_text().split("SCALARS inside double 1\nLOOKUP_TABLE default\n")[1]
            numbers = (self.folder / "a.vtk").read_text().split("SCALARS winding_number double 1\nLOOKUP_TABLE default\n")
            return json.loads(text), marks.split("SCALARS")[0].split(), numbers[1:]

        values, whole, numbers = inside("whole.off", faces)
        self.assertEqual((values["faces_turned"], len(numbers), set(whole)), (0, 1, {"0", "1"}))
        corners = [[float(x) for x in line.split()] for line in lines[first - 960:first]]
        volume = sum(volume_of_origin(*(corners[int(i)] for i in line.split()[1:])) for line in faces)
        self.assertAlmostEqual(values["volume_inside"], volume, delta=.05 * volume)
        self.assertAlmostEqual(values["volume_enclosed"], abs(volume), delta=1e-8 * abs(volume))
        self.assertNotIn("not_closed", values)
        flipped = [" ".join([*line.split()[:2], *line.split()[:1:-1]]) for line in faces[300:310]]
        for name, some in (("holes.off", faces[:100] + faces[104:]), ("flips.off", faces[:300] + flipped + faces[310:]),
                           ("twice.off", faces + faces[500:520])):
            values, marks, numbers = inside(name, some)
            self.assertEqual((values["faces_turned"], len(numbers), len(marks)), (10 * (name == "flips.off"), 1, len(whole)), name)
            self.assertIn("not_closed", values)
            self.assertNotIn("volume_enclosed", values)
            self.assertAlmostEqual(marks.count("1"), whole.count("1"), delta=20, msg=name)
            self.assertEqual(int(values["tetrahedra_in_doubt"].split()[0]) > 0, name != "flips.off", name)

    def boxes(self, name, *boxes, turned=lambda side: False, n=4):
        """Writes boxes, (corner, size) each, of squares cut in two; those sides are turned for which turned(number) holds."""
        points, faces = [], []
        for b, (corner, size) in enumerate(boxes):
            for axis in range(3):
                for far in (0, 1):
                    first = len(points)
                    for i in range(n + 1):
                        for j in range(n + 1):
                            p = {axis: far, (axis + 1) % 3: i / n, (axis + 2) % 3: j / n}
                            points.append(" ".join(repr(corner[k] + size * p[k]) for k in range(3)))
                    for i in range(n):
                        for j in range(n):
                            a = first + (n + 1) * i + j
                            c = a + n + 1
                            for t in ((a, c, c + 1), (a, c + 1, a + 1)):
                                flip = bool(far) == turned(6 * b + 2 * axis + far)
                                faces.append("3 %d %d %d" % (t[::-1] if flip else t))
        self.write(name, "OFF", f"{len(points)} {len(faces)} 0", *points, *faces)

    def volume_inside(self, name, notes=""):
        """That of what is written by --inside."""
        self.works(name, "--inside", "-o", "inside.mesh", notes=rf"{notes}({SOUP_NOTE})?")
        words = (self.folder / "inside.mesh").read_text().split()
        first = words.index("Vertices")
        p = [tuple(map(float, words[k:k + 3])) for k in range(first + 2, first + 2 + 4 * int(words[first + 1]), 4)]
        first = words.index("Tetrahedra")
        volume = 0
        for k in range(first + 2, first + 2 + 5 * int(words[first + 1]), 5):
            a, *others = (p[int(w) - 1] for w in words[k:k + 4])
            u, v, w = ([x - y for x, y in zip(q, a)] for q in others)
            volume += abs(u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0])) / 6
        return volume

    def test_parts(self):
        """What lies in two parts is inside; a part that looks inwards is a cavity; sides that are turned do not matter."""
        unit, large, moved = ((0, 0, 0), 1), ((-1, -1, -1), 3), ((.5, .25, .125), 1)
        inwards, all_of_first = (lambda side: side < 6), (lambda side: side in range(6))
        for boxes, turned, expected in (([unit, moved], lambda side: False, 2 - .5 * .75 * .875),
                                        ([unit, large], lambda side: False, 27), ([unit, large], inwards, 26),
                                        ([unit], all_of_first, 1), ([unit], lambda side: side == 3, 1),
                                        ([unit, ((2, 0, 0), 1)], inwards, 2), ([unit, large], lambda side: side == 5, 26 + 1),
                                        ([unit, unit], lambda side: False, 1)):
            self.boxes("boxes.off", *boxes, turned=turned, n=8)
            self.assertAlmostEqual(self.volume_inside("boxes.off"), expected, 9)
        self.boxes("boxes.off", unit, unit, turned=inwards)
        self.refuses("boxes.off: the surface has no inside: no tetrahedron is inside; there are no faces with an area, or each is given twice, ",
                     "boxes.off", "--inside", "-o", "inside.mesh")

    def test_volume_enclosed(self):
        """Only of one piece: two that look in opposite directions would have none."""
        corners = ["0 0 0", "1 0 0", "0 1 0", "0 0 1", "5 0 0", "6 0 0", "5 1 0", "5 0 1"]
        faces = ["3 0 2 1", "3 0 1 3", "3 0 3 2", "3 1 2 3", "3 4 5 6", "3 4 7 5", "3 4 6 7", "3 5 7 6"]
        for n, volume in ((1, 1 / 6), (2, None)):
            self.write("pieces.off", "OFF", f"{4 * n} {4 * n} 0", *corners[:4 * n], *faces[:4 * n])
            values = json.loads(self.works("pieces.off", "--inside", "-o", "a.vtk", "--json"))
            self.assertEqual(values.get("volume_enclosed"), volume and round(volume, 9))
            self.assertNotIn("not_closed", values)
            self.assertAlmostEqual(values["volume_inside"], n / 6, 8)

    def test_warnings_of_an_inside(self):
        """Where much of the volume may be wrong: of a coarse star, and below a wide opening; with --quiet, too."""
        rim = [(math.cos(.1 * math.pi * k), math.sin(.1 * math.pi * k), .3 * math.sin(.7 * math.pi * k)) for k in range(20)]
        faces = [f"3 0 {2 + k} {2 + (k + 1) % 20}" for k in range(20)] + [f"3 1 {2 + (k + 1) % 20} {2 + k}" for k in range(20)]
        self.write("star.off", "OFF", "22 40 0", "0 0 2", "0 0 -1", *("%r %r %r" % p for p in rim), *faces)
        crossed = r"\d+ % of the volume may be wrong, .* \d+ % of its area are no facets .*; remedy: refine the surface first, "
        for quiet in ([], ["--quiet"]):
            done = self.run_program("star.off", "--inside", "-o", "a.vtu", *quiet)
            self.assertEqual(done.returncode, 0)
            self.assertRegex(done.stderr, f"^warning: star.off: {crossed}")
        self.boxes("open.off", ((0, 0, 0), 1))
        lines = (self.folder / "open.off").read_text().split("\n")
        self.write("open.off", "OFF", "150 160 0", *lines[2:152], *lines[184:])
        self.works("open.off", "--inside", "-o", "a.vtu", notes=rf"warning: open.off: \d+ % of the volume inside is in doubt, [^\n]*; remedy: [^\n]*\n({SOUP_NOTE})?")

    def test_json(self):
        text = self.works(TORUS, "--json", "--stats", "--compare", "--repetitions", 1, "--traits", "tracing")
        values = json.loads(text)
        self.assertEqual((values["vertices"], values["finite_cells"], values["equal"]), (960, 8317, "yes"))
        self.assertEqual(values["rounds"][-2]["phase"], "update")
        self.assertIsNone(values["rounds"][-2]["cells"])
        self.assertGreater(json.loads(self.works(TORUS, "--json", "--stats", "--quiet"))["cells_destroyed"], 9)
        self.write('a "name".off', TORUS.read_text())
        self.assertEqual(json.loads(self.works('a "name".off', "--json"))["input"], 'a "name".off')

    def test_threads(self):
        if "built without TBB" in self.run_program(TORUS, "--threads", 2).stderr:
            self.skipTest("TBB was not found")
        self.works(TORUS, "--threads", 3, "--compare", "--repetitions", 1, prints=[r"\nthreads: +3\n", r"\nequal: +yes\n"])
        self.refuses("'--threads' needs the default traits", TORUS, "--threads", 2, "--traits", "plain")
        self.refuses("'--stats' counts what one thread does", TORUS, "--threads", 2, "--stats")
        for number in (0, 65, 9999999):
            self.refuses("option '--threads' needs a whole number from 1 to 64", TORUS, "--threads", number)

    def test_threads_that_cannot_be_made(self):
        """TBB ends the process, and no file is left."""
        if "built without TBB" in self.run_program(TORUS, "--threads", 2).stderr:
            self.skipTest("built without TBB")

        def limit():  # less than the stacks of all threads take
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            resource.setrlimit(resource.RLIMIT_AS, (300 << 20, 300 << 20))
        self.write("points.xyz", *(f"{i % 23} {i % 29} {i % 31}" for i in range(20000)))
        before = self.files()
        arguments = ("points.xyz", "--output", "points.vtu", "--threads")
        result = self.run_program(*arguments, 64, preexec_fn=limit)
        self.assertNotEqual(result.returncode, 0)
        self.assertEqual(set(os.listdir(self.folder)), set(before))
        self.assertEqual(self.run_program(*arguments, 1, preexec_fn=limit).returncode, 0)  # it is for the threads

    def test_quiet_and_verbose(self):
        self.write("points.xyz", "0 0 0", "1 0 0", "5 0 0")
        self.assertEqual(self.works("points.xyz", "--quiet", "--output", "points.vtu"), "")
        self.works(TORUS, "--verbose", "--output", "torus.vtu", notes=r"reading [^\n]*torus.off\nordering the points\n"
                   r"inserting\nhanding the triangulation over\nwriting torus.vtu\n")

    @unittest.skipUnless(hasattr(signal, "SIGTERM") and os.name == "posix", "signals of POSIX")
    def test_signals(self):
        """Nothing stays behind, the older file does, and who waits learns of the signal."""
        self.write("older.vtu", "an older result")
        self.write("large.xyz", *(f"{i * 7919 % 10007} {i * 104729 % 10009} {i * 1299709 % 10037}" for i in range(200000)))
        before = self.files()
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            process = subprocess.Popen([os.path.abspath(self.program), "large.xyz", "-o", "older.vtu"], cwd=self.folder,
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            while len(self.files()) == len(before) and process.poll() is None:
                time.sleep(0.01)
            self.assertEqual(len(self.files()), len(before) + 1)
            process.send_signal(number)
            self.assertEqual(process.wait(), -number)
            self.assertEqual(self.files(), before)

    def test_files_of_the_user_stay(self):
        """A link is followed, permissions are kept, and no name beside the output is used up."""
        older = self.write("older.mesh", "an older result")
        older.chmod(0o640)
        part = self.write("older.mesh.part", "a file of the user")
        (self.folder / "link.mesh").symlink_to("older.mesh")
        self.works(TORUS, "--output", "link.mesh")
        self.assertIn("MeshVersionFormatted", older.read_text())
        self.assertEqual(older.stat().st_mode & 0o777, 0o640)
        self.assertTrue((self.folder / "link.mesh").is_symlink())
        self.assertEqual(part.read_text(), "a file of the user\n")
        self.assertEqual(sorted(self.files()), ["link.mesh", "older.mesh", "older.mesh.part"])

    def test_a_link_to_nothing(self):
        """The link stays, and what it names appears."""
        (self.folder / "results").mkdir()
        (self.folder / "link.mesh").symlink_to("other.mesh")
        (self.folder / "other.mesh").symlink_to("results/torus.mesh")
        self.works(TORUS, "--output", "link.mesh")
        self.assertIn("MeshVersionFormatted", (self.folder / "results/torus.mesh").read_text())
        self.assertTrue((self.folder / "link.mesh").is_symlink() and (self.folder / "other.mesh").is_symlink())
        self.assertEqual([p.name for p in (self.folder / "results").iterdir()], ["torus.mesh"])
        (self.folder / "nowhere.mesh").symlink_to("nowhere/torus.mesh")
        (self.folder / "circle.mesh").symlink_to("circle.mesh")
        self.refuses(r"nowhere\.mesh: cannot be written: No such file", TORUS, "--output", "nowhere.mesh")
        self.refuses(r"circle\.mesh: cannot be written: Too many levels", TORUS, "--output", "circle.mesh")

    def test_names_of_one_file(self):
        """Nothing is overwritten that is read or written, by whatever name."""
        self.write("torus.off", TORUS.read_text())
        self.write("page.html", "three.js")
        (self.folder / "link.vtu").symlink_to("torus.off")
        (self.folder / "here").symlink_to(".")
        (self.folder / "view.html").symlink_to("result.vtu")  # nothing yet
        (self.folder / "node.html").symlink_to("result.node")
        for message, *words in (
                ("torus.off: '--output' would overwrite the surface", "-o", "torus.off", "--to", "vtu"),
                ("./torus.off: '--output' would overwrite the surface", "-o", "./torus.off", "--to", "vtu"),
                ("link.vtu: '--output' would overwrite the surface", "-o", "link.vtu"),
                ("a.html: '--view' would overwrite the file of '--output'", "-o", "a.html", "--to", "vtu", "--view", "a.html"),
                (".*a.html: '--view' would overwrite the file of '--output'", "-o", "a.html", "--to", "vtu", "--view",
                 self.folder / "here/./here/a.html"),
                ("view.html: '--view' would overwrite the file of '--output'", "-o", "result.vtu", "--view", "view.html"),
                ("node.html: '--view' would overwrite the file of '--output'", "-o", "result.ele", "--view", "node.html"),
                ("page.html: '--view' would overwrite the file of '--three-js'", "--view", "page.html")):
            three_js = ["--three-js", "page.html"] if "--view" in words else []
            self.refuses(message, "torus.off", *words, *three_js)
        # The input is not even looked for.
        self.refuses("missing.off: '--output' would overwrite the surface", "missing.off", "-o", "missing.off", "--to", "vtu")
        self.works("torus.off", "-o", "torus.vtu", "--quiet")

    def test_what_it_refuses(self):
        self.refuses(r"torus\.stl: unknown extension", TORUS, "--output", "torus.stl")
        self.refuses(r"unknown format 'stl'", TORUS, "--output", "torus.vtu", "--to", "stl")
        self.refuses(r"nowhere/torus\.vtu: cannot be written", TORUS, "--output", "nowhere/torus.vtu")
        self.refuses(r"n+\.vtu: cannot be written: File name too long", TORUS, "--output", 300 * "n" + ".vtu")
        (self.folder / "folder.vtu").mkdir()
        self.refuses(r"folder\.vtu: cannot be written", TORUS, "--output", "folder.vtu")
        # An error leaves the older output alone and nothing new behind.
        self.write("older.mesh", "an older result")
        self.refuses(r"missing\.off", "missing.off", "--output", "older.mesh")
        self.refuses(r"missing\.off", "missing.off", "--output", "never.vtu")

    def test_a_disk_that_is_full(self):
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))
        self.refuses(r"torus\.vtu: cannot be written", TORUS, "--output", "torus.vtu", preexec_fn=limit,
                     restore_signals=False)  # Python ignores the signal about it

    @unittest.skipUnless(os.path.exists("/dev/full"), "there is no /dev/full")
    def test_a_standard_output_that_is_full(self):
        with open("/dev/full", "w") as full:
            self.refuses("the results cannot be written", TORUS, stdout=full)


class Weights(ProgramCase):
    program = os.environ["DELAUNAY_FROM_SURFACE"]

    # The sphere through the corners of this tetrahedron has the squared radius 12 and the power -9 at (1, 1, 1).
    CORNERS = ["0 0 0", "4 0 0", "0 4 0", "0 0 4"]

    def read_vtk(self, name):
        """Its tetrahedra, as sets of indices in the input, with their squared power radii."""
        words = (self.folder / name).read_text().split()
        indices = list(map(int, words[words.index("input_index") + 5:][:int(words[words.index("POINTS") + 1])]))
        number = int(words[words.index("CELLS") + 1])
        cells = [frozenset(indices[int(w)] for w in words[words.index("CELLS") + 4 + 5 * c:][:4]) for c in range(number)]
        return dict(zip(cells, map(float, words[words.index("squared_power_radius") + 5:][:number])))

    def test_every_format(self):
        """A point that the others hide, or not, comes first. Equal weights change the radius and nothing else."""
        hidden, seen = {frozenset((1, 2, 3, 4))}, {frozenset((0, *c)) for c in combinations((1, 2, 3, 4), 3)}
        header = ["ply", "format ascii 1.0", "element vertex 5", *PLY_VERTICES[3:]]
        faces = ["element face 1", "property list uchar int vertex_indices", "end_header"]
        places = [[1, 1, 1], *([float(x) for x in c.split()] for c in self.CORNERS)]
        for cells, weight, radius in ((hidden, 4, 2), (seen, 9, 3)):
            lines = [f"1 1 1 {weight - 16}", *(c + " 0" for c in self.CORNERS)]
            self.write("a.xyz", "x y z w", *lines)
            self.write("b.pts", "5", *(line + " 255 0 0" for line in lines))
            self.write("c.ply", *header, "property float weight", *faces, *lines, "3 0 1 2")
            lines = [f"{radius} 7 1 1 1", *("4 7 " + c for c in self.CORNERS)]
            self.write("d.ply", *header[:3], "property double radius", "property int a", *header[3:], *faces, *lines, "3 0 1 2")
            binary = "\n".join([*header, "property float radius", "property double weight", "end_header", ""])
            self.write("e.ply", binary.replace("ascii", "binary_big_endian").encode() + b"".join(
                struct.pack(">3dfd", *p, 1, w) for p, w in zip(places, (weight, 16, 16, 16, 16))))
            for name, radius in (("a.xyz", 12), ("b.pts", 12), ("c.ply", 12), ("d.ply", -4), ("e.ply", -4)):
                with self.subTest(name):
                    note = rf"note: {name}: its faces are passed over, as its points have weights\n" if name in ("c.ply", "d.ply") else ""
                    self.works(name, "--weights", "--compare", "--repetitions", 1, "--output", "out.vtk", prints=[
                        r"\nsurface: +points with weights\n", rf"\nvertices: +{5 - (cells == hidden)}\n", r"\nduplicates: +0\n",
                        rf"\nhidden points: +{int(cells == hidden)}\n", rf"\nfinite cells: +{len(cells)}\n", r"\nequal: +yes\n",
                        rf"\nwritten: +{len(cells)} tetrahedra to out.vtk\n"], notes=note)
                    found = self.read_vtk("out.vtk")
                    self.assertEqual(set(found), cells)
                    weights = {i: (weight - 16 if i == 0 else 0) + 12 - radius for i in range(5)}
                    for cell, value in found.items():
                        expected, _ = squared_power_radius([places[i] for i in sorted(cell)], [weights[i] for i in sorted(cell)])
                        self.assertAlmostEqual(value, expected, 9)
                        self.assertTrue(cells == seen or value == radius)
        self.works("-", "--from", "xyz", "--weights", "--json", input=(self.folder / "a.xyz").read_text(), prints=['"hidden_points": 0,'])
        self.works("a.xyz", "--json", "--quiet", prints=['"finite_cells": 4,'])  # without the option they are passed over

    def test_every_output(self):
        self.write("a.xyz", "1 1 1 -20", *(c + " 0" for c in self.CORNERS))
        for name, expected in (
                ("a.vtu", r'NumberOfPoints="4" NumberOfCells="1"[^$]*Name="squared_power_radius"'),
                ("a.msh", r'\$Nodes\n4\n[^$]*\$EndNodes\n\$Elements\n1\n[^$]*\$EndElements\n\$ElementData\n1\n"squared_power_radius"'),
                ("a.mesh", r"Vertices\n4\n0 0 0 0\n[^$]*Tetrahedra\n1\n"), ("a.node", r"\A4 3 0 0\n0 0 0 0\n"),
                ("a.ele", r"\A1 4 0\n"), ("a.neigh", r"\A1 4\n0 -1 -1 -1 -1\n")):
            self.works("a.xyz", "--weights", "--output", name, prints=[r"\nwritten: +1 tetrahedra to "])
            self.assertRegex((self.folder / name).read_bytes().decode("latin-1"), expected)

    def test_all_tetrahedra(self):
        """Those of four points whose power sphere leaves all others a positive power."""
        generator = random.Random(1)
        points = [[Fraction(generator.random()) for _ in range(3)] for _ in range(20)]
        weights = [Fraction(generator.uniform(-.3, .3)) for _ in points]
        cells = {}
        for cell in combinations(range(len(points)), 4):
            radius, center = squared_power_radius([points[i] for i in cell], [weights[i] for i in cell])
            if all(sum((x - c) ** 2 for x, c in zip(p, center)) - w - radius > 0
                   for i, (p, w) in enumerate(zip(points, weights)) if i not in cell):
                cells[frozenset(cell)] = radius
        hidden = len(points) - len(set().union(*cells))
        self.assertGreater(hidden, 1)
        self.write("points.xyz", *(" ".join(repr(float(x)) for x in (*p, w)) for p, w in zip(points, weights)))
        has_threads = "built without TBB" not in self.run_program(TORUS, "--threads", 2).stderr
        for threads in (1, 2) if has_threads else (1,):
            self.works("points.xyz", "--weights", "--threads", threads, "--compare", "--repetitions", 1, "--output", "out.vtk", prints=[
                rf"\nhidden points: +{hidden}\n", rf"\nfinite cells: +{len(cells)}\n", r"\nequal: +yes\n"])
            found = self.read_vtk("out.vtk")
            self.assertEqual(set(found), set(cells))
            for cell, radius in found.items():
                self.assertLess(abs(radius - cells[cell]), 1e-9 * (1 + abs(cells[cell])))

    def test_equal_points_and_planes(self):
        """At one place the heaviest counts, and its copies are duplicates; in a plane there are triangles."""
        self.write("a.xyz", *(c + " 1" for c in self.CORNERS), "4 0 0 0.5", "4 0 0 2", "4 0 0 2")
        self.works("a.xyz", "--weights", "--output", "out.vtk", prints=[
            r"\nvertices: +4\n", r"\nduplicates: +1\n", r"\nhidden points: +2\n"])
        self.assertEqual(set(self.read_vtk("out.vtk")), {frozenset((0, 2, 3, 5))})
        self.write("plane.xyz", "0 0 1 0", "3 0 1 0", "0 3 1 0", "1 1 1 -9")
        self.works("plane.xyz", "--weights", "--compare", "--output", "plane.vtu", prints=[
            r"\ndimension: +2\n", r"\nvertices: +3\n", r"\nhidden points: +1\n", r"\nwritten: +1 triangles to plane.vtu\n",
            r"\nequal: +yes\n"], notes=PLANE_NOTE)
        self.write("one.xyz", "1 2 3 -1", "1 2 3 4")
        self.works("one.xyz", "--weights", "--output", "one.mesh", prints=[
            r"\ndimension: +0\n", r"\nduplicates: +0\n", r"\nhidden points: +1\n"], notes=PLANE_NOTE)

    def test_weights_that_are_missing(self):
        for name, message, *lines in (
                ("a.xyz", "cannot be read as .xyz: line 3: vertex 1 has no weight; remedy: a fourth number in each line",
                 "# c", "0 0 0 1", "1 0 0", "0 1 0 1"),
                ("b.pts", "cannot be read as .pts: line 2: vertex 0 has no weight; remedy: ", "1", "0 0 0"),
                ("c.xyz", "cannot be read as .xyz: line 1: 'w' is not a number", "0 0 0 w"),
                ("d.xyz", "vertex 1: its weight is -?nan, not a finite number", "0 0 0 1", "1 0 0 nan"),
                ("e.pts", "vertex 0: its weight is inf, not a finite number", "0 0 0 1e999"),
                ("f.ply", "cannot be read as .ply: the vertices have no weights; remedy: a property weight or radius",
                 *PLY_VERTICES, "end_header", *PLY_CORNERS),
                ("g.ply", "vertex 3: its weight is inf, not a finite number", *PLY_VERTICES, "property double radius",
                 "end_header", *(c + " 1" for c in PLY_CORNERS[:3]), "0 0 1 1e200"),
                ("i.ply", "cannot be read as .ply: the radius of vertex 0 is negative", *PLY_VERTICES, "property double radius",
                 "end_header", *(c + " -1" for c in PLY_CORNERS)),
                ("h.ply", "cannot be read as .ply: there is no room for 4 'vertex'", *PLY_VERTICES, "property double weight",
                 "end_header", *(c + " 1" for c in PLY_CORNERS[:3]), "0 0 1")):
            with self.subTest(name):
                self.write(name, *lines)
                self.refuses(f"{re.escape(name)}: {message}", name, "--weights")

    def test_what_knows_no_weights(self):
        self.write("a.xyz", *(c + " 0" for c in self.CORNERS))
        for message, *words in (
                ("excludes '--inside': what is inside is found without", "--inside", "-o", "a.vtu"),
                ("excludes '--mark-inside': what is inside is found without", "--mark-inside", "-o", "a.vtu"),
                ("excludes '--view': a page shows no weights", "--view", "a.html"),
                ("excludes '--traits tracing': only the default", "--traits", "tracing"),
                ("excludes '--stats': it counts and times", "--stats"),
                ("excludes '--to cgal': what reads .cgal expects no", "-o", "a.cgal")):
            self.refuses(f"'--weights' {message}[^\n]*; remedy: ", "a.xyz", "--weights", *words)
        self.refuses("'--weights' cannot be read from .off; remedy: .xyz or .pts with four numbers", TORUS, "--weights")
        self.refuses("tiles know no weights; remedy: all points in memory", "tiles", "a.npy", "--weights", "--output", "tiles")
        self.works("a.xyz", "--weights", "--traits", "default", "--seed", 3, prints=[r"\nhidden points: +0\n"])


class Refusals(ProgramCase):
    program = os.environ["DELAUNAY_FROM_SURFACE"]

    def test_command_lines(self):
        self.refuses("no surface given")
        self.refuses("unrecognised option '--bogus'", "--bogus")
        self.refuses("unrecognised option '--comp'", TORUS, "--comp")
        self.refuses("too many positional options", TORUS, TORUS)
        self.refuses("unknown traits 'fast'", TORUS, "--traits", "fast")
        for seed in ("-1", "4294967296"):
            self.refuses("option '--seed' needs a whole number", TORUS, "--seed", seed)
        self.refuses(r"the argument \('one'\) for option '--seed' is invalid", TORUS, "--seed", "one")
        for message, *words in (("option '--to' needs '--output'", "--to", "vtu"),
                                ("options '--inside' and '--mark-inside' need '--output'", "--inside"),
                                ("'--inside' and '--mark-inside' exclude", "--inside", "--mark-inside", "-o", "a.vtu"),
                                ("a triangulation of CGAL is written as a whole", "--inside", "-o", "a.cgal"),
                                ("'--mark-inside' needs .vtu, .vtk or .msh", "--mark-inside", "-o", "a.mesh"),
                                (".* need '--output'; a page shows both", "--inside", "--view", "a.html"),
                                ("option '--output' needs the name of a file", "--output", ""),
                                ("option '--view' needs the name of a file", "--view", ""),
                                ("'--quiet' and '--verbose' exclude each other", "--quiet", "--verbose"),
                                ("unknown format 'las'", "--from", "las")):
            self.refuses(message, TORUS, *words)
        self.refuses("option '--repetitions' needs '--compare'", TORUS, "--repetitions", 3)
        self.refuses("option '--repetitions' needs a whole number", TORUS, "--compare", "--repetitions", 0)

    def test_names(self):
        self.refuses(r"missing\.off: No such file", "missing.off")
        self.refuses(r"new\?line\.off: No such file", "new\nline.off")
        self.refuses(r"\.: unknown extension", ".")
        self.refuses(r"n+\.off: File name too long", 300 * "n" + ".off")
        (self.folder / "folder.off").mkdir()
        self.refuses(r"folder\.off: is a directory", "folder.off")
        self.write("points.abc", "0 0 0")
        self.refuses(r"points\.abc: unknown extension; off, [a-z, ]+ and pts are read, .* with '--from'", "points.abc")
        (self.folder / "zero.off").symlink_to("/dev/zero")
        self.refuses(r"zero\.off: is not a plain file", "zero.off")

    def test_coordinates(self):
        self.write("nan.off", "OFF", "3 1 0", "0 0 0", "1 0 0", "0 nan 0", "3 0 1 2")
        self.refuses(r"nan\.off: vertex 2: its y coordinate is not a finite number", "nan.off")
        self.write("huge.off", "OFF", "3 1 0", "0 0 0", "1e400 0 0", "0 1 0", "3 0 1 2")
        self.refuses(r"huge\.off: vertex 1: its x coordinate is not a finite number", "huge.off")
        self.refuses(r"\S*nan\.ply: vertex 3: its y coordinate is not a finite number", DATA / "nan.ply")
        self.refuses(r"\S*inf\.ply: vertex 3: its z coordinate is not a finite number", DATA / "inf.ply")
        self.refuses(r"\S*nan\.stl: cannot be read as \.stl: triangle 4: a coordinate is not a finite number",
                     DATA / "nan.stl")

    def test_contents(self):
        big = "4000000000"
        for name, message, *lines in (
                ("empty.off", "the file is empty"),
                ("no_vertices.off", "there are no vertices", "OFF", "0 0 0"),
                ("words.off", "line 1: the keyword OFF is missing", "once upon a time"),
                ("short.off", "line 4: the file ends too early", "OFF", "4 1 0", "0 0 0", "1 0 0"),
                ("binary.off", "line 1: binary OFF is not read", "OFF BINARY", "xxxxxxxxxxxxx"),
                ("vertices.off", "line 2: there is no room for '4000000000' vertices", "OFF", big + " 0 0"),
                ("faces.off", "line 2: there is no room for '4000000000' faces", "OFF", f"1 {big} 0", "0 0 0"),
                ("corners.off", "line 4: there is no room for '4000000000' vertices of a face", "OFF", "1 1 0", "0 0 0",
                 f"{big} 0 0 0"),
                ("negative.off", "line 2: '-1' is not the number of vertices", "OFF", "-1 0 0"),
                ("flat.off", "line 3: a vertex has too few coordinates", "OFF", "1 0 0", "0 0"),
                ("colors.off", "line 3: 'x' is not a number", "COFF", "1 0 0", "0 0 x"),
                ("corner.off", "line 7: a face has too few vertices", "OFF", "4 3 0", *PLY_CORNERS, "3 0 1", "3 0 1 2", "3 0 1 2"),
                ("index.off", "face 0: it has a vertex that is not one of the 1", "OFF", "1 1 0", "0 0 0", "3 0 -1 0"),
                ("property.ply", "line 3: a property comes before the first element", "ply", "format ascii 1.0",
                 "property int x", "element vertex 1", "end_header", "0 0 0"),
                ("type.ply", "line 4: 'real' is no type", *PLY_VERTICES[:3], "property real x", "end_header"),
                ("end.ply", "line 7: the header has no end", *PLY_VERTICES),
                ("no_x.ply", "the vertices do not have the properties x, y and z", *PLY_VERTICES[:3],
                 "property double a", "end_header", *PLY_CORNERS),
                ("many.ply", "there is no room for 4000000000 'vertex'", "ply", "format ascii 1.0",
                 "element vertex " + big, *PLY_VERTICES[3:], "end_header", *PLY_CORNERS),
                ("list.ply", "a list claims to have more entries", *PLY_VERTICES, "element face 1",
                 "property list uint int vertex_indices", "end_header", *PLY_CORNERS, big + " 0 1 2"),
                ("count.ply", "a list claims to have more entries", *PLY_VERTICES, "element face 1",
                 "property list int int vertex_indices", "end_header", *PLY_CORNERS, "-3 0 1 2"),
                ("face.ply", "the faces do not have the property vertex_indices", *PLY_VERTICES, "element face 1",
                 "property list uint int corners", "end_header", *PLY_CORNERS, "3 0 1 2"),
                ("binary.ply", "the file ends too early",
                 b"ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                 b"property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                 + struct.pack("<fffBi", 0, 0, 0, 1, 0)[:-1]),
                ("index.obj", "face 1: it has a vertex that is not one of the 3", *TETRAHEDRON[:3], "f 1 2 3", "f 1 2 4"),
                ("words.obj", "there are no vertices in it", "once upon a time"),
                ("short.obj", "line 2: a vertex has too few coordinates", "# c", "v 1 2"),
                ("words.xyz", "line 2: 'b' is not a number", "1 2 3", "1 b 3"),
                ("zeros.xyz", "line 1: 'a??b' is not a number", b"a\0\1b 1 2\n"),
                ("wide.obj", "it is in UTF-16", "\ufeffv 1 2 3\n".encode("utf-16-le")),
                ("commas.xyz", "line 1: '1,2,3' is not a number: blanks separate numbers", "1,2,3"),
                ("short.pts", "line 2: a vertex has too few coordinates", "1", "1 2"),
                ("count.pts", "there are no vertices in it", big),
                ("short.stl", "it is cut short", "solid a", "facet")):
            with self.subTest(name):
                self.write(name, *lines)
                self.refuses(rf"{re.escape(name)}: (cannot be read as \.\w+: )?{re.escape(message)}", name)
        self.refuses(r"\S*negative_index\.ply: cannot be read as \.ply: face 0: it has a vertex that is not one of the 4",
                     DATA / "negative_index.ply")


if __name__ == "__main__":
    unittest.main()
