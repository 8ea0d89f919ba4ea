# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""What the live page reads: the same surface from all formats, and messages for files that are broken. NODE names Node.js."""

import json
import os
import random
import struct
import subprocess
import tempfile
import unittest
from pathlib import Path

from program_case import ROOT

# Reads the files of the folder, and prints what they hold, or what is wrong with them.
READ = """
import {readFileSync, readdirSync} from "node:fs";
import {readSurface} from "%s";
for (const name of readdirSync(process.argv[2]).sort()) {
  try {
    const {points, triangles, radii} = readSurface(name, new Uint8Array(readFileSync(`${process.argv[2]}/${name}`)));
    console.log(JSON.stringify([name, [...points], [...triangles], radii && [...radii]]));
  } catch (error) {
    console.log(JSON.stringify([name, error instanceof TypeError ? error.stack : error.message]));
  }
}
"""

POINTS = [(0, 0, 0), (2, 0, 0), (2, 1.5, 0), (0, 1.5, 0), (0.25, 0.5, -1e-3)]
FACES = [(3, 2, 1, 0), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]
TRIANGLES = [(f[0], f[k - 1], f[k]) for f in FACES for k in range(2, len(f))]


def rows(items):
    return "".join(" ".join(map(str, item)) + "\n" for item in items)


def counted(faces):
    return rows([(len(face), *face) for face in faces])


def ply(form, order="<"):
    header = (f"ply\nformat {form} 1.0\ncomment made by J\xf6rg\nelement vertex {len(POINTS)}\nproperty float x\nproperty double y\n"
              "property float z\nproperty uchar red\nelement face 5\nproperty list uchar int vertex_indices\nproperty short flag\n"
              "element edge 1\nproperty int a\nend_header\n").encode("latin1")
    if form == "ascii":
        return header + (rows([(*p, 7) for p in POINTS]) + rows([(len(f), *f, -1) for f in FACES]) + "3\n").encode()
    return header + b"".join([struct.pack(order + "fdfB", *p, 7) for p in POINTS] +
                             [struct.pack(f"{order}B{len(f)}ih", len(f), *f, -1) for f in FACES] + [struct.pack(order + "i", 3)])


def binary_stl():
    return (b"solid it is not, but begins so".ljust(80) + struct.pack("<I", len(TRIANGLES)) +
            b"".join(struct.pack("<12fH", 0, 0, 0, *POINTS[a], *POINTS[b], *POINTS[c], 0) for a, b, c in TRIANGLES))


def text_stl():
    facets = (" facet normal 0 0 0\n  outer loop\n" + rows([("vertex", *POINTS[v]) for v in t]) + "endloop\nendfacet\n" for t in TRIANGLES)
    return f"solid a b\n{''.join(facets)}endsolid\n".encode()


GOOD = {
    "A.off": f"off\n5 5 0\n{rows(POINTS)}{counted(FACES)}".encode(), "B.off": f"5 5 0\n{rows(POINTS)}{counted(FACES)}".encode(),
    "C.obj": f"# C:\\models\\\n{rows(('v', *p) for p in POINTS)}{rows(('f', *(v + 1 for v in f)) for f in FACES)}".encode(),
    "D.ply": b"\xef\xbb\xbf" + ply("binary_little_endian"),
    "E.off": f"OFF5 5 0\n{rows(POINTS)}{counted(FACES)}".encode(),
    "a.off": f"# a comment\nOFF\n\n5 5 0\n{rows(POINTS)}{counted(FACES)}".encode(),
    "b.OFF": f"COFF 5 5 0 # counts\r\n{rows((*p, 255, 0, 0, 255) for p in POINTS)}{counted(FACES)}".replace("\n", "\r\n").encode(),
    "c.obj": (f"mtllib x\n{rows(('v', *p) for p in POINTS)}vt 0 0\nf 4 3 2 \\\n 1\nf 1/1/1 2/1 5//1\nf -4 -3 -1\n" +
              "f 3 4 5\ng q\nf 4 1 5").encode(),
    "d.ply": ply("ascii"), "e.ply": ply("binary_little_endian"), "f.ply": ply("binary_big_endian", ">"),
    "g.stl": binary_stl(), "h.stl": text_stl(),
}
CLOUDS = {
    "i.xyz": rows(POINTS).encode(), "j.pts": f"5\n{rows((*p, 9, 1, 2, 3) for p in POINTS)}".encode(),
    "k.csv": ("x, y, z\n" + rows(POINTS).replace(" ", ", ")).encode(), "l.txt": rows(POINTS).replace(" ", "\t").encode(),
    "m.csv": rows(POINTS).replace(" ", ";").encode(),
    "n.csv": ("id,z,x,y,\n" + "".join(f"{9 - i},{z},{x},{y},\n" for i, (x, y, z) in enumerate(POINTS))).encode(),
    "o.xyz": (b"\xef\xbb\xbf5\nfour corners, and 1\n" + rows(("C", *p) for p in POINTS).encode()),
    "o1.xyz": ("5\n\n" + rows(("C", *p) for p in POINTS)).encode(), "o2.csv": ("x,y,z,r,g,b\n" + "".join(
        f"{x},{y},{z},255,128,3\n" for x, y, z in POINTS)).encode(),
    "o3.xyz": rows((*p, p[2]) for p in POINTS).encode(), "p.txt": ("//X Y Z\n" + rows(POINTS)).encode(), "q.pts": rows((*p, 7) for p in POINTS).encode(),
}
BROKEN = {
    "n.off": (b"OFF\n2 0 0\n0 0 0\n", "n.off, line 3: the file ends before point 1 of 2"),
    "o.off": (b"OFF\n1 1 0\n0 0 0\n3 0 0\n", "o.off, line 4: expected 3 corners"),
    "p.off": (b"OFF BINARY\n", "p.off, line 1: binary OFF is not read: write it as text, or as PLY"),
    "q.off": (b"", "q.off: the file ends before the word OFF"),
    "r.obj": (b"v 0 0 0\nf 0 1 2\n", "r.obj, line 2: corners count from 1"),
    "s.ply": (b"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n",
              "s.ply, line 7: a number is missing"),
    "t.ply": (b"ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\nend_header\n", "t.ply, line 4: the property 'quad x' is not known"),
    "u.ply": (ply("binary_little_endian")[:-30], "u.ply: the file ends before all of its elements"),
    "v.stl": (binary_stl()[:-60].replace(b"solid", b"other"), "v.stl: the file ends before triangle 4 of 6"),
    "v1.stl": (text_stl()[:-60], "v1.stl, line 40: the file ends within a facet"),
    "v11.stl": (text_stl()[:-len("endsolid\n")], "v11.stl, line 43: the file ends within a solid: endsolid is missing"),
    "v12.ply": (b"ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
                b"0 0 0 9\n1 0 0 9\n", "v12.ply, line 9: the file goes on, and its header announces fewer numbers"),
    "v13.off": (b"OFF\n1 0 0\n0 0 0\n1 0 0\n", "v13.off, line 4: the file goes on, and its header announces 1 points and 0 faces"),
    "v14.ply": (ply("ascii").replace(b"indices", b"list"), "v14.ply, line 20: the faces do not have the property vertex_indices"),
    "v15.csv": (b"x,y,z,radius\n0,0,0,1\n1,0,0,-1\n", "v15.csv, line 3: the radius -1 is negative"),
    "v2.ply": (b"ply\nformat ascii 1.0\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n3 0 1 2\n",
               "v2.ply, line 6: strips of triangles are not read: write triangles"),
    "v3.obj": (b"v 0 0 0\nf -1 -2 1\n", "v3.obj, line 2: there is no point -2"),
    "v4.csv": (b"1,5;2,5;3,5\n", "v4.csv, line 1: '1,5' is not a finite number"),
    "v5.xyz": (b"nan nan nan\n1 2 3\n", "v5.xyz, line 1: 'nan' is not a finite number"),
    "v6.csv": (b"id,east,north,up\n1,2,3,4\n", "v6.csv, line 1: no columns are named x, y and z"),
    "v7.pts": (b"3\n0 0 0\n1 0 0\n", "v7.pts, line 3: the first line announces 3 points, and there are 2"),
    "w.xyz": (b"1,5 2,5 3,5\n", "w.xyz, line 1: '1,5' is not a finite number"),
    "x.xyz": (b"0 0 0 1\n0 0 1 1\n0 0 2\n", "x.xyz, line 3: expected 4 numbers, as in the lines before"),
    "y.xyz": (b"1 2 inf\n", "y.xyz, line 1: 'inf' is not a finite number"),
    "z.png": (b"\x89PNG", "z.png: expected a file whose name ends in .off, .ply, .obj, .stl, .xyz, .pts, .txt, .csv"),
}


class ReadSurface(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def read(self, files):
        """What each of the files holds, which are given by name and content."""
        for name, content in files.items():
            (self.folder / name).write_bytes(content)
        program = READ % (ROOT / "npm/live/read_surface.mjs").as_uri()
        done = subprocess.run([os.environ["NODE"], "--input-type=module", "-", self.folder], input=program,
                              capture_output=True, text=True, timeout=200, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return {name: content for name, *content in map(json.loads, done.stdout.splitlines())}

    def test_same_surface(self):
        expected = sorted(sorted(tuple(map(float, POINTS[v])) for v in t) for t in TRIANGLES)
        for name, (points, triangles, radii) in self.read(GOOD).items():
            found = [tuple(round(x, 6) for x in points[3 * v:3 * v + 3]) for v in triangles]
            self.assertEqual(len(points), 3 * len(POINTS), name)
            self.assertEqual(sorted(sorted(found[k:k + 3]) for k in range(0, len(found), 3)), expected, name)
            self.assertIsNone(radii)

    def test_points_alone(self):
        for name, content in self.read(CLOUDS).items():
            self.assertEqual(content, [[x for p in POINTS for x in p], [], None], name)

    def test_radii(self):
        files = {"a.xyz": rows((*p, 0.5) for p in POINTS).encode(),
                 "b.ply": b"ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
                          b"property float radius\nend_header\n" + rows((*p, 0.5) for p in POINTS).encode()}
        for content in self.read(files).values():
            self.assertEqual(content, [[x for p in POINTS for x in p], [], [0.5] * 5])

    def test_broken(self):
        self.assertEqual({name: content[0] for name, content in self.read({name: b for name, (b, _) in BROKEN.items()}).items()},
                         {name: message for name, (_, message) in BROKEN.items()})

    def test_mutations(self):
        """Whatever is in a file, it is read or refused by a message that begins with its name."""
        chance, files = random.Random(1), {}
        for name, content in {**GOOD, **CLOUDS}.items():
            for k in range(60):
                mutated = bytearray(content)
                for _ in range(chance.randint(1, 4)):
                    at = chance.randrange(len(mutated))
                    mutated[at:at + chance.choice((0, 1, 9))] = chance.choice((b"", b"\n", b"-1", b"1e9", b"\xff\xff\xff\x7f", b" "))
                files[f"{k:02}{name}"] = bytes(mutated)
        for name, content in self.read(files).items():
            if len(content) == 1:
                self.assertTrue(content[0].startswith(name), content[0])
            else:
                self.assertTrue(all(0 <= v < len(content[0]) / 3 for v in content[1]))


if __name__ == "__main__":
    unittest.main()
