# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""What scripts/amalgamate makes includes no header of others, and serves a C program; its functions one by one, with
threads and exceptions and without."""

import ctypes
import math
import os
import random
import re
import resource
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "examples/Delaunay_from_surface_3/without_cgal/triangulate.c"
OK, NOT_FINITE, BAD_INDEX, BAD_ARGUMENT, TOO_MANY, NO_MEMORY, FAILED, NOT_EXACT, BAD_BOX, STOPPED, NO_INSIDE = range(11)
GO_FURTHER = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_double)


class Cells(ctypes.Structure):
    _fields_ = [("dimension", ctypes.c_int), ("number", ctypes.c_size_t), ("number_with_infinite", ctypes.c_size_t),
                ("stride", ctypes.c_size_t), ("vertices", ctypes.POINTER(ctypes.c_int32)),
                ("neighbors", ctypes.POINTER(ctypes.c_int32)), ("number_of_points", ctypes.c_size_t),
                ("vertex_of_point", ctypes.POINTER(ctypes.c_int32))]


def array(kind, values):
    return (kind * max(len(values), 1))(*values)


def determinant(a, b, c, d):
    (x, y, z), (u, v, w), (p, q, r) = ([t - o for t, o in zip(corner, a)] for corner in (b, c, d))
    return x * (v * r - w * q) - y * (u * r - w * p) + z * (u * q - v * p)


class OneFile(unittest.TestCase):
    flags, left_out = ["-pthread"], r"\S*/(?:CGAL|boost|tbb)/\S*"

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.path = Path(cls.folder.name)
        subprocess.run([sys.executable, "-B", ROOT / "scripts/amalgamate", cls.path], check=True,
                       stdout=subprocess.DEVNULL)
        compiler = [*os.environ.get("CXX", "c++").split(), "-std=c++17", "-O1", "-Wall", "-Wextra", "-Werror", *cls.flags]
        cls.headers = subprocess.run([*compiler, "-M", "delaunay_3.cpp"], cwd=cls.path, check=True, capture_output=True,
                                     text=True).stdout
        cls.library = cls.path / "libdelaunay_3.so"
        subprocess.run([*compiler, "-shared", "-fPIC", "delaunay_3.cpp", "-o", cls.library], cwd=cls.path, check=True)
        ctypes.CDLL(None).mallopt(-8, 1)  # M_ARENA_MAX: memory that threads have had can be given back
        cls.c = ctypes.CDLL(str(cls.library))
        cls.c.delaunay_3_message.restype = ctypes.c_char_p
        cls.c.delaunay_3_offsets.restype = ctypes.POINTER(ctypes.c_int16)

    def build(self, points, triangles=(), threads=1):
        """(status, triangulation, where)"""
        self.points = array(ctypes.c_double, points)
        d, where = ctypes.c_void_p(1), ctypes.c_size_t(99)
        status = self.c.delaunay_3_build(self.points, ctypes.c_size_t(len(points) // 3),
                                         array(ctypes.c_int32, triangles), ctypes.c_size_t(len(triangles) // 3),
                                         threads, ctypes.byref(d), ctypes.byref(where))
        return status, d, where.value

    def test_needs_no_other_headers(self):
        self.assertEqual(re.findall(self.left_out, self.headers), [])

    def test_program(self):
        program = self.path / "triangulate"
        subprocess.run(["cc", "-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", f"-I{self.path}", PROGRAM,
                        self.library, "-o", program, f"-Wl,-rpath,{self.path}"], check=True)
        done = subprocess.run([program], check=True, capture_output=True, text=True)
        self.assertRegex(done.stdout, r"^valid: points \d+, \d+, \d+ and \d+ of 10000 are around the middle\n$")

    def test_one_thread(self):
        """At -O0, as it is compiled faster."""
        program, source = self.path / "alone", self.path / "delaunay_3.cpp"
        compiler = [*os.environ.get("CXX", "c++").split(), "-std=c++17", "-Wall", "-Wextra", "-Werror", "-DDELAUNAY_3_ONE_THREAD"]
        headers = subprocess.run([*compiler, "-M", source], check=True, capture_output=True, text=True).stdout
        self.assertEqual(re.findall(WithoutExceptions.left_out, headers), [])
        subprocess.run(["cc", "-c", f"-I{self.path}", PROGRAM, "-o", self.path / "alone.o"], check=True)
        subprocess.run([*compiler, source, self.path / "alone.o", "-o", program], check=True)
        self.assertRegex(subprocess.run([program], check=True, capture_output=True, text=True).stdout, "^valid: ")

    def test_triangulations(self):
        rng = random.Random(1)
        cube = [rng.random() for _ in range(3000)]
        lattice = [float(x) for i in range(5) for j in range(5) for k in range(5) for x in (i, j, k)]
        plane = [x for i in range(5) for j in range(5) for x in (i, j, i + j)]
        for points, dimension in ((cube, 3), (lattice, 3), (lattice * 2, 3), (plane, 2), ([0, 0, 0, 1, 2, 3], 1),
                                  ([1, 1, 1] * 2, 0), ([], -1)):
            for triangles in ((), (0, 1, 0, 1, 1, 1) if len(points) > 3 else ()):
                for threads in (1, 2, 100):
                    status, d, _ = self.build(points, triangles, threads)
                    self.assertEqual(status, OK)
                    cells = Cells()
                    self.c.delaunay_3_get(d, ctypes.byref(cells))
                    self.assertEqual((cells.dimension, cells.number_of_points), (dimension, len(points) // 3))
                    self.assertEqual([self.c.delaunay_3_is_valid(d, level) for level in range(-1, 5)],
                                     [-BAD_ARGUMENT, 1, 1, 1, 1, -BAD_ARGUMENT])
                    self.check_find(d, cells, points, threads)
                    self.c.delaunay_3_free(d)
        self.c.delaunay_3_free(None)

    def build_weighted(self, points, weights, threads=1):
        self.points, self.weights = array(ctypes.c_double, points), array(ctypes.c_double, weights)
        d, where = ctypes.c_void_p(1), ctypes.c_size_t(99)
        status = self.c.delaunay_3_build_weighted(self.points, self.weights, ctypes.c_size_t(len(points) // 3), threads,
                                                  ctypes.byref(d), ctypes.byref(where))
        return status, d, where.value

    def test_weights(self):
        rng = random.Random(2)
        cube = [rng.random() for _ in range(3000)]
        plane = [x for i in range(5) for j in range(5) for x in (i, j, i + j)]
        for points, dimension in ((cube, 3), (plane, 2), ([0, 0, 0, 1, 2, 3, 2, 4, 6], 1), ([1, 1, 1] * 2, 0), ([], -1)):
            n = len(points) // 3
            for weights in ([0.] * n, [rng.random() * .02 - .01 for _ in range(n)], [9.] * (n > 0) + [0.] * (n - 1)):
                for threads in (1, 2):
                    status, d, _ = self.build_weighted(points, weights, threads)
                    self.assertEqual(status, OK)
                    cells = Cells()
                    self.c.delaunay_3_get(d, ctypes.byref(cells))
                    self.assertEqual((cells.dimension, cells.number_of_points), (dimension, n))
                    self.assertEqual([self.c.delaunay_3_is_valid(d, level) for level in range(4)], [1] * 4)
                    hidden = sum(cells.vertex_of_point[i] < 0 for i in range(n))
                    self.assertEqual(hidden > 0, len(set(weights)) > 1 and
                                     (points is cube or dimension == 0 or dimension == 2 and weights[0] == 9.))
                    if hidden > 0:
                        self.weights[next(i for i in range(n) if cells.vertex_of_point[i] < 0)] = 100.
                        self.assertEqual(self.c.delaunay_3_is_valid(d, 3), 0)
                        self.weights[0] = math.nan
                        self.assertEqual(self.c.delaunay_3_is_valid(d, 3), -NOT_FINITE)
                    self.c.delaunay_3_free(d)
        for wrong in (math.nan, -math.inf):
            self.assertEqual(self.build_weighted(cube, [0.] * 7 + [wrong] + [0.] * 992)[::2], (NOT_FINITE, 7))
        self.assertEqual(self.c.delaunay_3_build_weighted(self.points, None, ctypes.c_size_t(10), 1,
                                                          ctypes.byref(ctypes.c_void_p()), None), BAD_ARGUMENT)

    def build_periodic(self, points, box, weights=None, threads=1):
        self.points, self.weights = array(ctypes.c_double, points), weights if weights is None else array(ctypes.c_double, weights)
        d, where = ctypes.c_void_p(1), ctypes.c_size_t(99)
        status = self.c.delaunay_3_build_periodic(self.points, self.weights, ctypes.c_size_t(len(points) // 3),
                                                  array(ctypes.c_double, box), threads, ctypes.byref(d), ctypes.byref(where))
        return status, d, where.value

    def test_boxes(self):
        """Tetrahedra are positive and fill full boxes, and contain the points that are found in them."""
        rng = random.Random(3)
        cube = [rng.random() for _ in range(900)]
        for points in (cube, cube[:3], [4 * x - 2 for x in cube], []):
            n = len(points) // 3
            for box in ((1, 1, 1), (1, 2, 1.5), (1, 1, math.inf), (math.inf, 1, math.inf)):
                if 0 < n < 9 and math.inf in box:
                    self.assertEqual(self.build_periodic(points, box)[0], BAD_BOX)
                    continue
                for weights in (None, [rng.random() * .01 for _ in range(n)]):
                    for threads in (1, 2):
                        status, d, _ = self.build_periodic(points, box, weights, threads)
                        self.assertEqual(status, OK)
                        self.check_box(d, points, box)
                        self.assertEqual(self.c.delaunay_3_is_valid(d, 0), -BAD_ARGUMENT)
                        self.c.delaunay_3_free(d)

    def check_box(self, d, points, box):
        cells, offsets = Cells(), self.c.delaunay_3_offsets(d)
        self.c.delaunay_3_get(d, ctypes.byref(cells))
        self.assertEqual(cells.number, cells.number_with_infinite)
        tetrahedra = []
        for c in range(cells.number):
            corners = []
            for k in range(4):
                v, offset = cells.vertices[c * cells.stride + k], offsets[12 * c + 3 * k:12 * c + 3 * k + 3]
                corners.append([x + (t * period if t else 0) for x, t, period in zip(points[3 * v:3 * v + 3], offset, box)])
                self.assertTrue(-1 <= cells.neighbors[c * cells.stride + k] < cells.number)
            tetrahedra.append(corners)
        volume = sum(determinant(*corners) for corners in tetrahedra) / 6
        self.assertTrue(all(determinant(*corners) > -1e-12 for corners in tetrahedra))
        if math.inf not in box and points:
            self.assertAlmostEqual(volume, math.prod(box))
        n = len(points) // 3
        found = array(ctypes.c_int32, [7] * n)
        self.assertEqual(self.c.delaunay_3_find(d, self.points, ctypes.c_size_t(n), 1, found, None), OK)
        for i in range(n):
            v = cells.vertex_of_point[i]
            if v >= 0:
                c = found[i]
                self.assertIn(v, cells.vertices[c * cells.stride:c * cells.stride + 4])
            else:
                self.assertGreaterEqual(found[i], 0)

    def test_watched(self):
        rng = random.Random(4)
        points = array(ctypes.c_double, [rng.random() for _ in range(30000)])
        weights = array(ctypes.c_double, [rng.random() * .001 for _ in range(10000)])
        for given in (None, weights):
            for box in (None, array(ctypes.c_double, [1, 1, 1])):
                for last in (.3, 2):
                    shares, d = [], ctypes.c_void_p()

                    def watch(data, share):
                        inner = ctypes.c_void_p() # a call within the call
                        self.c.delaunay_3_build(points, ctypes.c_size_t(5), None, ctypes.c_size_t(0), 1, ctypes.byref(inner), None)
                        self.c.delaunay_3_free(inner)
                        shares.append((data, share))
                        return share < last

                    go_further = GO_FURTHER(watch)
                    status = self.c.delaunay_3_build_watched(points, given, ctypes.c_size_t(10000), box, 2, go_further,
                                                             ctypes.c_void_p(7), ctypes.byref(d), None)
                    self.assertEqual((status, d.value is None), (STOPPED, True) if last < 1 else (OK, False))
                    self.assertTrue(all(data == 7 and 0 <= share <= 1 for data, share in shares))
                    self.assertEqual(shares, sorted(shares))
                    self.assertGreater(len(shares), 10)
                    self.c.delaunay_3_free(d)

    def test_winding_numbers(self):
        """Of two cubes, one in the other and turned: 1 between them, and 0 within the inner one."""
        points, faces = [], []
        for size, rounds in ((3, 1), (1, -1)):
            first = len(points) // 3
            points += [float(size * (1 - 2 * (i >> axis & 1))) for i in range(8) for axis in range(3)]
            for axis in range(3):
                b, c = 1 << (axis + 1) % 3, 1 << (axis + 2) % 3
                for base in (0, 1 << axis):
                    corners = [first + base + k for k in (0, b, b + c, c)][::rounds * (1 if base else -1)]
                    faces += corners[:3] + [corners[0], *corners[2:]]
        cells = Cells()
        for turned in (faces, faces[::-1]):
            status, d, _ = self.build(points)
            self.c.delaunay_3_get(d, ctypes.byref(cells))
            numbers = array(ctypes.c_double, [7.] * cells.number)
            find = lambda given, threads=1: self.c.delaunay_3_winding_numbers(
                d, array(ctypes.c_int32, given), ctypes.c_size_t(len(given) // 3), threads, numbers, None)
            for threads in (1, 2):
                self.assertEqual(find(turned, threads), OK)
                for c in range(cells.number):
                    is_inner = all(v >= 8 for v in cells.vertices[c * cells.stride:c * cells.stride + 4])
                    self.assertAlmostEqual(abs(numbers[c]), 0 if is_inner else 1, places=6)
            self.assertEqual(find([0, 1, 16]), BAD_INDEX)
            self.assertEqual(find(faces, 0), BAD_ARGUMENT)
            self.assertEqual(find([]), BAD_ARGUMENT)
            self.assertEqual(find(faces[:3]), NO_INSIDE)
            self.c.delaunay_3_free(d)
        self.assertEqual(self.c.delaunay_3_winding_numbers(None, array(ctypes.c_int32, faces), ctypes.c_size_t(1), 1, numbers, None),
                         BAD_ARGUMENT)
        for d in (self.build_weighted(points, [0.] * 16)[1], self.build_periodic(points, (9, 9, 9))[1], self.build(points[:9])[1]):
            self.assertEqual(find(faces), BAD_ARGUMENT)
            self.c.delaunay_3_free(d)

    def test_bad_boxes(self):
        points = [.1 * i * i % 1 for i in range(60)]
        for wrong in (0, -1, math.nan, 1e-6):
            self.assertEqual(self.build_periodic(points, (1, wrong, 1))[0], BAD_BOX)
        self.assertEqual(self.build_periodic(points[:33] + [math.nan] + points[34:], (1, 1, 1))[::2], (NOT_FINITE, 11))
        self.assertEqual(self.build_periodic(points, (1, 1, 1), [0] * 5 + [math.inf] + [0] * 14)[::2], (NOT_FINITE, 5))
        self.assertEqual(self.c.delaunay_3_build_periodic(self.points, None, ctypes.c_size_t(20), None, 1,
                                                          ctypes.byref(ctypes.c_void_p()), None), BAD_ARGUMENT)
        self.assertFalse(self.c.delaunay_3_offsets(None))
        _, d, _ = self.build(points)
        self.assertFalse(self.c.delaunay_3_offsets(d))
        self.c.delaunay_3_free(d)
        _, d, _ = self.build_periodic(points, (1, 1, 1))
        found = array(ctypes.c_int32, [0])
        for x, status in ((-1e6, OK), (1e12, BAD_ARGUMENT)):
            self.assertEqual(self.c.delaunay_3_find(d, array(ctypes.c_double, [x, 0, 0]), ctypes.c_size_t(1), 1, found, None), status)
        self.c.delaunay_3_free(d)

    def check_find(self, d, cells, points, threads):
        """Points are in the first cell that has them as a corner."""
        found = array(ctypes.c_int32, [7] * (len(points) // 3))
        status = self.c.delaunay_3_find(d, self.points, ctypes.c_size_t(len(points) // 3), threads, found, None)
        self.assertEqual(status, OK)
        first = {}
        for c in range(cells.number):
            for k in range(cells.dimension + 1):
                first.setdefault(cells.vertices[c * cells.stride + k], c)
        for i in range(len(points) // 3):
            self.assertEqual(found[i], first[cells.vertex_of_point[i]] if cells.dimension == 3 else -1)
        beyond = array(ctypes.c_double, [-9.] * 3)
        self.c.delaunay_3_find(d, beyond, ctypes.c_size_t(1), threads, found, None)
        self.assertEqual(found[0], -1)

    def test_refusals(self):
        points = [float(i * i % 7) for i in range(30)]
        for wrong in (math.nan, math.inf):
            self.assertEqual(self.build(points[:16] + [wrong] + points[17:])[::2], (NOT_FINITE, 5))
        for wrong in (-1, 10):
            status, d, where = self.build(points, [0, 1, 2, 3, wrong, 4])
            self.assertEqual((status, d.value, where), (BAD_INDEX, None, 1))
        for threads in (0, -3):
            self.assertEqual(self.build(points, threads=threads)[0], BAD_ARGUMENT)
        _, d, _ = self.build(points)
        where = ctypes.c_size_t()
        found = array(ctypes.c_int32, [0, 0])
        queries = array(ctypes.c_double, [0, 0, 0, 0, math.nan, 0])
        status = self.c.delaunay_3_find(d, queries, ctypes.c_size_t(2), 1, found, ctypes.byref(where))
        self.assertEqual((status, where.value), (NOT_FINITE, 1))
        self.c.delaunay_3_free(d)
        messages = [self.c.delaunay_3_message(status) for status in range(12)]
        self.assertEqual(len(set(messages)), 11)
        self.assertEqual(messages[FAILED], messages[11])

    def test_sizes_are_not_believed(self):
        _, d, _ = self.build([0.] * 30)
        c, found = self.c, array(ctypes.c_int32, [0])
        for n in (2 ** 31 - 1, 2 ** 32, 2 ** 40, 2 ** 61, 2 ** 64 // 3 + 1, 2 ** 64 - 1):
            for points in (None, self.points):
                other = ctypes.c_void_p(1)
                self.assertEqual(c.delaunay_3_build(points, ctypes.c_size_t(n), None, ctypes.c_size_t(0), 1,
                                                    ctypes.byref(other), None), TOO_MANY)
                self.assertIsNone(other.value)
                self.assertEqual(c.delaunay_3_build(self.points, ctypes.c_size_t(10), points, ctypes.c_size_t(n), 1,
                                                    ctypes.byref(other), None), TOO_MANY)
                self.assertEqual(c.delaunay_3_find(d, points, ctypes.c_size_t(n), 1, found, None), TOO_MANY)
        c.delaunay_3_free(d)

    def test_null_is_refused(self):
        _, d, _ = self.build([0.] * 30)
        c, one, none, found = self.c, ctypes.c_size_t(1), ctypes.c_size_t(0), array(ctypes.c_int32, [7])
        other, cells = ctypes.c_void_p(), Cells()
        for arguments, expected in (((None, one, None, none, 1, ctypes.byref(other)), BAD_ARGUMENT),
                                    ((self.points, one, None, one, 1, ctypes.byref(other)), BAD_ARGUMENT),
                                    ((self.points, one, None, none, 1, None), BAD_ARGUMENT),
                                    ((None, none, None, none, 1, ctypes.byref(other)), OK)):
            self.assertEqual(c.delaunay_3_build(*arguments, None), expected)
        for arguments, expected in (((None, self.points, one, 1, found), BAD_ARGUMENT),
                                    ((d, None, one, 1, found), BAD_ARGUMENT),
                                    ((d, self.points, one, 1, None), BAD_ARGUMENT), ((d, None, none, 1, None), OK)):
            self.assertEqual(c.delaunay_3_find(*arguments, None), expected)
        c.delaunay_3_get(None, ctypes.byref(cells))
        self.assertEqual((cells.dimension, cells.number, cells.number_of_points), (-1, 0, 0))
        c.delaunay_3_get(d, None)
        self.assertEqual(c.delaunay_3_is_valid(None, 3), -BAD_ARGUMENT)
        c.delaunay_3_free(d)
        c.delaunay_3_free(other)

    def test_validity_that_cannot_be_checked(self):
        rng = random.Random(2)
        _, d, _ = self.build([rng.random() for _ in range(60000)])
        ctypes.CDLL(None).malloc_trim(0)  # what other tests have left would do
        limits, used = resource.getrlimit(resource.RLIMIT_AS), int(Path("/proc/self/statm").read_text().split()[0])
        try:
            resource.setrlimit(resource.RLIMIT_AS, (used * resource.getpagesize(), limits[1]))
            is_valid = self.c.delaunay_3_is_valid(d, 3)
        finally:
            resource.setrlimit(resource.RLIMIT_AS, limits)
        self.assertEqual(is_valid, -NO_MEMORY)
        query = array(ctypes.c_double, self.points[300:303])
        self.points[300] = math.nan
        self.assertEqual(self.c.delaunay_3_is_valid(d, 3), -NOT_FINITE)
        found = array(ctypes.c_int32, [0])
        self.assertEqual(self.c.delaunay_3_find(d, query, ctypes.c_size_t(1), 1, found, None), BAD_ARGUMENT)
        self.c.delaunay_3_free(d)

    def test_compiled_for_speed_alone(self):
        """As with -Ofast: every call says that it would not be exact; at -O0, as it is compiled faster."""
        library = self.path / "libfast.so"
        compiler = [*os.environ.get("CXX", "c++").split(), "-std=c++17", "-O0", "-ffast-math"]
        subprocess.run([*compiler, "-shared", "-fPIC", "delaunay_3.cpp", "-o", library, "-pthread"], cwd=self.path,
                       check=True)
        # In a process of its own, as it may change the mode of this one.
        program = (f"import ctypes; c = ctypes.CDLL({str(library)!r}); d = ctypes.c_void_p()\n"
                   "p, n, o = (ctypes.c_double * 3)(1, 2, 3), ctypes.c_size_t(1), ctypes.c_size_t(0)\n"
                   "print(c.delaunay_3_build(p, n, None, o, 1, ctypes.byref(d), None), d.value,\n"
                   "      c.delaunay_3_find(None, p, n, 1, p, None), c.delaunay_3_is_valid(None, 3))")
        done = subprocess.run([sys.executable, "-c", program], check=True, capture_output=True, text=True)
        self.assertEqual(done.stdout, f"{NOT_EXACT} None {NOT_EXACT} {-NOT_EXACT}\n")


class WithoutExceptions(OneFile):
    """On one thread the same results and statuses."""
    flags = ["-fno-exceptions"]
    left_out = r"\S*/(?:CGAL|boost|tbb|thread|mutex|condition_variable)(?:/\S*)?(?!\S)"
    test_compiled_for_speed_alone = test_one_thread = None


if __name__ == "__main__":
    unittest.main()
