# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Tests the installed module, against SciPy and against the program delaunay_from_surface."""

import doctest
import os
import signal
import subprocess
import tempfile
import threading
import time
import typing
import unittest
from fractions import Fraction
from pathlib import Path

import numpy as np
import scipy.spatial

import delaunay_from_surface as dfs
from delaunay_from_surface import _delaunay_from_surface as core

TORUS = Path(__file__).resolve().parents[1] / "examples/Delaunay_from_surface_3/data/torus.off"


def random_points(n, seed=1):
    return np.random.default_rng(seed).random((n, 3))


def skew_lines(n):
    """The points of one are neighbours of all points of the other: n * n / 4 tetrahedra."""
    points = np.zeros((n, 3))
    points[::2, 0] = points[1::2, 1] = np.linspace(0, 1, n // 2)
    points[1::2, 2] = 1
    return points


def cell_set(simplices):
    return {tuple(sorted(map(int, s))) for s in simplices}


def torus():
    words = [w for line in TORUS.read_text().splitlines() for w in line.split("#")[0].split()]
    n, m = int(words[1]), int(words[2])
    points = np.array(words[4:4 + 3 * n], dtype=float).reshape(n, 3)
    faces = np.array(words[4 + 3 * n:4 + 3 * n + 4 * m], dtype=int).reshape(m, 4)[:, 1:]
    return points, faces


def cells_of_program(points):
    """What the program makes of different points, with GMP: sets of indices."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "points.off"
        file.write_text(f"OFF\n{len(points)} 0 0\n" + "".join("%r %r %r\n" % tuple(map(float, p)) for p in points))
        subprocess.run([os.environ["DELAUNAY_FROM_SURFACE"], file, "-o", Path(folder) / "points.mesh"], check=True,
                       capture_output=True)
        words = (Path(folder) / "points.mesh").read_text().split()
    first = words.index("Tetrahedra") + 2
    corners = np.array(words[first:-1], dtype=int).reshape(-1, 5)[:, :4] - 1
    return cell_set(corners)


class Results(unittest.TestCase):
    def check_neighbors(self, result):
        for i in range(result.dimension + 1):
            others = np.delete(result.simplices, i, axis=1)
            inside = result.neighbors[:, i] >= 0
            across = result.simplices[result.neighbors[inside, i]]
            has_facet = (others[inside][:, :, None] == across[:, None, :]).any(axis=2).all()
            self.assertTrue(has_facet)
            back = result.neighbors[result.neighbors[inside, i]]
            self.assertTrue((back == np.flatnonzero(inside)[:, None]).any(axis=1).all())

    def test_scipy(self):
        for n in (4, 5, 300, 3000):
            points = random_points(n)
            scipy_result = scipy.spatial.Delaunay(points)
            result = dfs.delaunay3(points, neighbors=True, seed=n)
            self.assertEqual(cell_set(result.simplices), cell_set(scipy_result.simplices))
            self.assertEqual((result.neighbors < 0).sum(), (scipy_result.neighbors < 0).sum())
            self.assertEqual(result.dimension, 3)
            self.check_neighbors(result)
            a, b, c, d = (points[result.simplices[:, k]] for k in range(4))
            self.assertTrue((np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) > 0).all())

    def test_program_on_degenerate_points(self):
        grid = np.stack(np.meshgrid(*3 * [np.arange(5)]), axis=-1).reshape(-1, 3)
        sphere = np.array([p for p in np.ndindex(53, 53, 53) if sum((x - 26) ** 2 for x in p) == 26 ** 2]) - 26
        rng = np.random.default_rng(7)
        # Exponents so different that the last stage of the predicates decides, with exact numbers.
        wild = np.ldexp(rng.integers(-4, 5, (60, 3)), rng.integers(-200, 200, (60, 3)))
        for points in (grid, sphere / 7., np.unique(wild, axis=0), np.vstack([grid * 1e-30, 1. + grid])):
            points = np.unique(np.asarray(points, dtype=float), axis=0)
            self.assertEqual(cell_set(dfs.delaunay3(points).simplices), cells_of_program(points))

    def test_faces(self):
        points, faces = torus()
        expected = cells_of_program(points)
        for given in (None, faces, faces.astype(np.int32), np.asfortranarray(faces), faces.astype(np.uint16)[::-2],
                      faces.tolist(), [tuple(f) for f in faces.tolist()] + [[0, 1], [], list(range(7))]):
            self.assertEqual(cell_set(dfs.delaunay3(points, given).simplices), expected)

    def test_kinds_of_points(self):
        points = random_points(200).astype(np.float32)
        expected = cell_set(dfs.delaunay3(points.astype(float)).simplices)
        for given in (points, points.astype(float)[:, :], np.asfortranarray(points), points[::-1][::-1],
                      points.astype(">f8"), points.tolist(), np.repeat(points, 2, axis=1)[:, ::2]):
            self.assertEqual(cell_set(dfs.delaunay3(given).simplices), expected)
        integers = np.random.default_rng(2).integers(0, 99, (200, 3))
        self.assertEqual(cell_set(dfs.delaunay3(integers).simplices),
                         cell_set(dfs.delaunay3(integers.astype(float)).simplices))

    def test_duplicates_and_low_dimensions(self):
        points = np.array([[1, 1, 1], [0, 0, 0], [1, 0, 0], [0, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], dtype=float)
        result = dfs.delaunay3(points)
        self.assertEqual(result.vertices.tolist(), [0, 1, 2, 1, 4, 5, 0])
        self.assertTrue(set(result.simplices.ravel().tolist()) <= {0, 1, 2, 4, 5})
        for expected, count, points in ((-1, 0, np.zeros((0, 3))), (0, 1, np.ones((3, 3))),
                                        (1, 2, [[0, 0, 0], [4, 4, 4], [1, 1, 1]]),
                                        (2, 2, [[0, 0, 7], [1, 0, 7], [0, 1, 7], [2, 3, 7]])):
            result = dfs.delaunay3(points, neighbors=True)
            self.assertEqual((result.dimension, result.simplices.shape),
                             (expected, (count, max(expected, 0) + 1)))
            if expected >= 1:
                self.check_neighbors(result)

    def test_arrays_outlive_the_result(self):
        result = dfs.delaunay3(random_points(5000), neighbors=True)
        neighbors, copy = result.neighbors, result.neighbors.copy()
        self.assertEqual(result.simplices.strides, (32, 4))  # both are views of one array
        del result
        dfs.delaunay3(random_points(5000, seed=2))
        self.assertTrue((neighbors == copy).all())
        self.assertTrue(dfs.delaunay3(random_points(50)).simplices.flags.c_contiguous)
        self.assertIsNone(dfs.delaunay3(random_points(50)).neighbors)

    def test_threads(self):
        points, faces = torus()
        grid = np.stack(np.meshgrid(*3 * [np.arange(20.)]), axis=-1).reshape(-1, 3)
        for points, faces in ((random_points(20000), None), (np.vstack([grid, grid[::3]]), None), (points, faces),
                              (points[:2], None), (points[:0], None), (points * [1, 1, 0], faces)):
            one = dfs.delaunay3(points, faces)
            for threads in (2, 5, None, 1000):
                many = dfs.delaunay3(points, faces, neighbors=True, threads=threads)
                self.assertEqual(cell_set(many.simplices), cell_set(one.simplices))
                self.assertTrue((many.vertices == one.vertices).all())
                self.assertEqual(many.dimension, one.dimension)
                if many.dimension > 0:
                    self.check_neighbors(many)

    def test_positive_orientation(self):
        """Promised, and decided by exact arithmetic."""
        grid = np.stack(np.meshgrid(*3 * [np.arange(5)]), axis=-1).reshape(-1, 3) * .1
        for points in (grid, random_points(500).astype(np.float32), random_points(500) * 1e-160):
            for threads in (1, 2):
                result = dfs.delaunay3(points, threads=threads)
                exact = [[Fraction(float(x)) for x in p] for p in points]
                for s in result.simplices[:2000].tolist():
                    a, b, c, d = (exact[v] for v in s)
                    (x, y, z), (u, v, w), (p, q, r) = ([t - o for t, o in zip(corner, a)] for corner in (b, c, d))
                    self.assertGreater(x * (v * r - w * q) - y * (u * r - w * p) + z * (u * q - v * p), 0)

    def test_nothing(self):
        for nothing in ([], (), np.zeros(0), np.zeros((0, 3)), np.zeros(0, dtype=np.float32)):
            result = dfs.delaunay3(nothing)
            self.assertEqual((result.dimension, result.simplices.shape, result.vertices.shape), (-1, (0, 1), (0,)))

    def test_seeds(self):
        points = random_points(500)
        one, other, again = (dfs.delaunay3(points, seed=s).simplices for s in (1, 2, 1))
        self.assertEqual(cell_set(one), cell_set(other))
        self.assertTrue(np.array_equal(one, again))
        self.assertFalse(np.array_equal(one, other))


class Refusals(unittest.TestCase):
    def refuses(self, error, message, *arguments, **keywords):
        with self.assertRaisesRegex(error, message):
            dfs.delaunay3(*arguments, **keywords)

    def test_points(self):
        points = random_points(20)
        self.refuses(ValueError, r"points: expected an array of shape \(n, 3\), got \(20, 2\)", points[:, :2])
        self.refuses(ValueError, r"points: expected an array of shape \(n, 3\), got \(60,\)", points.ravel())
        self.refuses(TypeError, "points: expected numbers, got entries of type complex128", points.astype(complex))
        self.refuses(TypeError, "points: expected", points.astype(str))
        self.refuses(TypeError, "points: expected", [[1, 2, 3], [4, 5]])
        for masked in (np.ma.masked_array(points, mask=points > 0.5), np.ma.masked_array(points),
                       list(np.ma.masked_array(points, mask=points > 0.5))):
            self.refuses(ValueError, "points: a masked array is not read", masked)
        points[7, 1] = np.nan
        self.refuses(ValueError, "^points: point 7: its y coordinate is not a finite number$", points)

    def test_faces(self):
        points = random_points(20)
        self.refuses(ValueError, r"face 1: the index 20 is not one of the 20 points", points, [[0, 1, 2], [3, 4, 20]])
        self.refuses(ValueError, r"face 0: the index -1 is not one of", points, np.array([[0, 1, -1]]))
        self.refuses(TypeError, r"faces: expected integers, got entries of type float64", points, np.zeros((4, 3)))
        self.refuses(ValueError, r"faces: expected an array of shape \(m, k\)", points, np.zeros(4, dtype=int))
        self.refuses(TypeError, r"faces: face 1: expected sequences of integers", points, [[0, 1, 2], [0.5, 1, 2]])
        self.refuses(TypeError, r"faces: face 0: expected sequences of integers", points, 7)
        self.refuses(ValueError, r"faces: face 0: an index is too large", points, [[0, 1, 2 ** 70]])
        large = np.array([[0, 1, 2], [0, 1, 2 ** 63]], dtype=np.uint64)
        masked = np.ma.masked_array([[0, 1, 2], [1, 2, 3]], mask=[[False] * 3, [True] * 3])
        for given in (large, large.astype(">u8")):
            self.refuses(ValueError, "faces: face 1: the index 9223372036854775808 is too large", points, given)
        for given in (masked, list(masked), tuple(masked)):
            self.refuses(ValueError, "faces: a masked array is not read", points, given)
        for function in (dfs.subgraph, dfs.surface_topology):
            with self.assertRaisesRegex(ValueError, "faces: face 1: the index 9223372036854775808 is too large"):
                function(large)
            with self.assertRaisesRegex(ValueError, "faces: a masked array is not read"):
                function(masked)

    def test_arguments(self):
        for threads in (0, -1):
            self.refuses(ValueError, f"threads: expected a whole number from 1 on, or None for all, got {threads}",
                         random_points(5), threads=threads)
        self.refuses(TypeError, "", random_points(5), threads=1.5)
        for seed in (-1, 2 ** 32):
            self.refuses(ValueError, "seed: expected a whole number from 0 to 4294967295", random_points(5), seed=seed)
        self.refuses(TypeError, "", random_points(5), seed="one")
        with self.assertRaises(TypeError):
            dfs.delaunay3(random_points(5), None, True)


class Control(unittest.TestCase):
    def test_progress(self):
        shares = []
        dfs.delaunay3(random_points(400000), progress=shares.append)
        self.assertGreaterEqual(len(shares), 5)
        self.assertEqual(shares, sorted(shares))
        self.assertEqual((shares[0], shares[-1]), (0., 1.))

    def test_progress_by_the_clock(self):
        """Few points may take long, and many may take no time."""
        slow, quick = [], []
        dfs.delaunay3(skew_lines(4000), progress=slow.append)
        self.assertGreaterEqual(len(slow), 5)
        dfs.delaunay3(random_points(5000), progress=quick.append)
        self.assertLess(len(quick), len(slow))

    def test_stop(self):
        with self.assertRaisesRegex(dfs.Stopped, "progress returned False"):
            dfs.delaunay3(random_points(400000), progress=lambda share: share == 0)

        def fail(share):
            raise LookupError("in the user's function")
        with self.assertRaisesRegex(LookupError, "in the user's function"):
            dfs.delaunay3(random_points(20000), progress=fail)
        with self.assertRaises(TypeError):
            dfs.delaunay3(random_points(20000), progress=7)

    def test_interrupt(self):
        for threads in (1, 3):
            begin = time.monotonic()
            killer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
            with self.assertRaises(KeyboardInterrupt):
                killer.start()
                while time.monotonic() < begin + 60:
                    dfs.delaunay3(random_points(200000), threads=threads)
            self.assertLess(time.monotonic(), begin + 30)

    def test_many_threads(self):
        """Progress, stops and exceptions come to the thread that has called, and the others have ended by then."""
        shares = []
        dfs.delaunay3(random_points(400000), progress=shares.append, threads=3)
        self.assertEqual(shares, sorted(shares))
        self.assertEqual((shares[0], shares[-1]), (0., 1.))
        with self.assertRaises(dfs.Stopped):
            dfs.delaunay3(random_points(400000), progress=lambda share: share < .1, threads=3)

        def fail(share):
            if share > .1:
                raise LookupError("in the user's function")
        with self.assertRaisesRegex(LookupError, "in the user's function"):
            dfs.delaunay3(random_points(400000), progress=fail, threads=3)

    def test_array_that_changes(self):
        """What another thread writes meanwhile is read or not, and never makes the module fail."""
        points, faces = random_points(30000), np.random.default_rng(3).integers(0, 30000, (60000, 3))
        for threads in (1, 2):
            done = threading.Event()

            def spoil():
                rng = np.random.default_rng(4)
                while not done.wait(1e-4):
                    points[rng.integers(0, len(points), 100)] = rng.choice([np.nan, 1e300, 0, -5], (100, 3))
                    faces[rng.integers(0, len(faces), 100)] = rng.integers(-2 ** 40, 2 ** 40)
                    points[:], faces[:] = random_points(30000), rng.integers(0, 30000, (60000, 3))
            thread = threading.Thread(target=spoil)
            thread.start()
            try:
                for _ in range(8):
                    try:
                        dfs.delaunay3(points, faces, threads=threads)
                    except ValueError as error:
                        self.assertRegex(str(error), "is not a finite number|is not one of the 30000 points|too large")
            finally:
                done.set()
                thread.join()

    def test_no_leak(self):
        """Of calls that return and calls that fail, on either way out."""
        points, spoilt = random_points(60), np.full((60, 3), np.nan)

        def call(times):
            for i in range(times):
                dfs.delaunay3(points, [[0, 1, 2]] if i % 2 else None, neighbors=i % 3 == 0)
                for wrong in ({"points": spoilt}, {"points": points, "faces": [[0, 1, 60]]},
                              {"points": points, "progress": lambda share: 1 / 0}):
                    try:
                        dfs.delaunay3(**wrong)
                    except (ValueError, ZeroDivisionError):
                        pass
            return int(Path("/proc/self/statm").read_text().split()[1])
        if not Path("/proc/self/statm").exists():
            self.skipTest("memory is measured on Linux only")
        call(500)
        before = call(500)
        self.assertLess(call(2500) - before, 256)  # pages of 4096 bytes

    def test_interrupt_between_few_points(self):
        shares = []
        killer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        with self.assertRaises(KeyboardInterrupt):
            killer.start()
            dfs.delaunay3(skew_lines(4000), progress=shares.append)
            killer.join()
        self.assertLess(shares[-1], 1)

    def test_other_threads_run(self):
        ticks, done = [], threading.Event()

        def tick():
            while not done.wait(0.001):
                ticks.append(time.monotonic())
        thread = threading.Thread(target=tick)
        thread.start()
        begin = time.monotonic()
        dfs.delaunay3(random_points(100000))
        end = time.monotonic()
        done.set()
        thread.join()
        self.assertGreater(len([t for t in ticks if begin < t < end]), 20)


class Surfaces(unittest.TestCase):
    def test_torus(self):
        points, faces = torus()
        component, = dfs.surface_topology(faces)
        self.assertEqual(component[:6], (960, 2880, 1920, 0, 0, 1))
        for is_tree, edges in ((False, 961), (True, 959)):
            ends = dfs.subgraph(faces, tree=is_tree)
            degree = np.bincount(ends.ravel(), minlength=960)
            self.assertLessEqual(degree.max(), component.subgraph_degree_bound)
            graph = scipy.sparse.coo_matrix((np.ones(len(ends)), ends.T), shape=(960, 960))
            self.assertEqual(scipy.sparse.csgraph.connected_components(graph, directed=False)[0], 1)
            self.assertEqual(len(ends) if is_tree else min(len(ends), edges), edges)

    def test_components_and_refusals(self):
        triangle = [[0, 1, 2]]
        component, = dfs.surface_topology(triangle, 5)
        self.assertEqual(component, (3, 3, 1, 1, 1, 0, 3, True))
        self.assertEqual(dfs.surface_topology([]), [])
        with self.assertRaisesRegex(ValueError, r"edge \(0, 1\) is in more than two faces"):
            dfs.subgraph([[0, 1, 2], [0, 1, 3], [0, 1, 4]])
        with self.assertRaisesRegex(ValueError, "faces: face 0: the index 2 is not one of a vertex"):
            dfs.subgraph(triangle, 2)
        with self.assertRaisesRegex(ValueError, "triangle"):
            dfs.subgraph([[0, 1, 2, 3]])


class Module(unittest.TestCase):
    def test_needs_no_other_library(self):
        for library in (b"libgmp", b"libmpfr", b"libtbb", b"libboost"):
            self.assertNotIn(library, Path(core.__file__).read_bytes())

    def test_documentation(self):
        self.assertEqual(doctest.testmod(dfs).failed, 0)
        for name in dfs.__all__:
            self.assertTrue(getattr(dfs, name).__doc__, name)
        for function in (dfs.delaunay3, dfs.subgraph, dfs.surface_topology):
            self.assertIn("return", typing.get_type_hints(function))
        self.assertRegex(dfs.__version__, r"^\d+\.\d+\.\d+$")
        self.assertTrue(Path(dfs.__file__).with_name("py.typed").exists())


if __name__ == "__main__":
    unittest.main()
