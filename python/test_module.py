# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""Tests the installed module, against SciPy and against the program delaunay_from_surface."""

import ast
import copy
import doctest
import importlib.util
import inspect
import itertools
import os
import pickle
import re
import signal
import subprocess
import sys
import tempfile
import textwrap
import threading
import time
import types
import typing
import unittest
import unittest.mock
import warnings
import weakref
from fractions import Fraction
from pathlib import Path

import numpy as np
import scipy.sparse.csgraph
import scipy.spatial

import delaunay_from_surface as dfs
from delaunay_from_surface import _delaunay_from_surface as core
from delaunay_from_surface import cpp

ROOT = Path(__file__).resolve().parents[1]
TORUS = ROOT / "examples/Delaunay_from_surface_3/data/torus.off"


def random_points(n, seed=1):
    return np.random.default_rng(seed).random((n, 3))


def skew_lines(n):
    """The points of one are neighbours of all points of the other: n * n / 4 tetrahedra."""
    points = np.zeros((n, 3))
    points[::2, 0] = points[1::2, 1] = np.linspace(0, 1, n // 2)
    points[1::2, 2] = 1
    return points


def turned_lattice(n, seed=1):
    turn, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    return np.array(list(itertools.product(range(n), repeat=3)), dtype=float) @ turn


def flat_sets():
    """Points with tetrahedra so flat that they have a volume by rounding alone, and at all scales."""
    sphere = np.random.default_rng(2).normal(size=(60, 3))
    flat = np.column_stack([random_points(40)[:, :2], np.full(40, .1)]) @ np.linalg.qr(random_points(3))[0]
    spread = np.exp(np.random.default_rng(3).normal(size=(30, 3)) * 100)
    return {"cube": turned_lattice(2), "lattice": turned_lattice(3), "far": turned_lattice(3) + 1e8,
            "single": turned_lattice(3).astype(np.float32), "tiny": turned_lattice(3) * 1e-90,
            "denormal": turned_lattice(3) * 1e-311, "huge": turned_lattice(3) * 2e307, "plane": np.vstack([flat, [[0, 0, 5]]]),
            "sphere": sphere / np.linalg.norm(sphere, axis=1)[:, None], "scales": spread,
            "equal": np.vstack([turned_lattice(2), turned_lattice(2)])}


def cell_set(simplices):
    return {tuple(sorted(map(int, s))) for s in simplices}


class SplitMix:
    """splitmix64, as the C++ code has it."""

    def __init__(self, seed):
        self.state = seed

    def bits(self, n):
        mask = 2 ** 64 - 1
        self.state = x = self.state + 0x9e3779b97f4a7c15 & mask
        x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9 & mask
        x = (x ^ x >> 27) * 0x94d049bb133111eb & mask
        return (x ^ x >> 31) >> 64 - n

    def below(self, n):
        return self.bits(64) * n >> 64


def fixed_points(name):
    """Those of fixed_inputs.h, a header of the C++ tests."""
    r = SplitMix(1)

    def near(i):
        r.state = i // 2
        return r.bits(24) + i % 2, r.bits(24), r.bits(24)

    def of_any_size():
        c, e = r.below(9) - 4, r.below(200) - 100
        return c * 2. ** e

    def on_cone(i):
        p, q = i % 128, 128
        c, s = (q * q - p * p << 40) // (p * p + q * q), (2 * p * q << 40) // (p * p + q * q)
        return [(c, s, 0), (-s, c, 0), (-c, -s, 0), (s, -c, 0), (0, 0, 2 ** 42)][i // 128]

    return np.array({
        "cube": lambda: [[r.bits(53) * 2. ** -53 for _ in range(3)] for _ in range(3000)],
        "near duplicates": lambda: [near(i) for i in range(3000)],
        "grid": lambda: [[.1 * k for k in p] for p in np.ndindex(11, 11, 11)],
        "lattice with duplicates": lambda: [[r.below(9) for _ in range(3)] for _ in range(3000)],
        "integer sphere": lambda: [p for p in itertools.product(range(-77, 78), repeat=3)
                                   if p[0] ** 2 + p[1] ** 2 + p[2] ** 2 == 5861],
        "plane": lambda: [(i, j, i + 2 * j) for i in range(30) for j in range(30)],
        "line": lambda: [(i * 7 % 500, 2 * (i * 7 % 500), -(i * 7 % 500)) for i in range(500)],
        "thin sheet": lambda: [(r.bits(30), r.bits(30), r.bits(53) * 2. ** -83) for _ in range(2000)],
        "all sizes": lambda: [[of_any_size() for _ in range(3)] for _ in range(300)],
        "skew lines": lambda: [(0, i // 2, 1) if i % 2 else (i // 2, 0, 0) for i in range(120)],
        "cone": lambda: [(x, y, 0) for x in range(-1088, 1089) for y in range(-1088, 1089)
                         if x * x + y * y == 1185665] + [(0, 0, 3000)],
        "rounded cone": lambda: [on_cone(i) for i in range(513)],
        "far away": lambda: [(2. ** 52 + r.bits(20), 2. ** 40 + r.bits(20), r.bits(20) * 2. ** -20) for _ in range(2000)],
    }[name](), dtype=float)


def hash_of(simplices):
    """FNV-1a, of sorted numbers of 32 bits; -1 in front where a simplex has fewer than four."""
    cells = np.full((len(simplices), 4), -1, dtype="<i4")
    cells[:, 4 - simplices.shape[1]:] = np.sort(simplices, axis=1)
    value = 0xcbf29ce484222325
    for byte in cells[np.lexsort(cells.T[::-1])].tobytes():
        value = (value ^ byte) * 0x100000001b3 & 2 ** 64 - 1
    return value


def contains(corners, x):
    """Whether a positive tetrahedron contains a point, its facets included; exact."""
    corners, x = ([[t if isinstance(t, Fraction) else Fraction(float(t)) for t in p] for p in points] for points in (corners, [x]))
    x, = x

    def is_positive(a, b, c, d):
        (x, y, z), (u, v, w), (p, q, r) = ([t - o for t, o in zip(corner, a)] for corner in (b, c, d))
        return x * (v * r - w * q) - y * (u * r - w * p) + z * (u * q - v * p) >= 0
    return all(is_positive(*corners[:k], x, *corners[k + 1:]) for k in range(4))


def smallest_sphere(corners):
    """Through two or three points."""
    edges = corners[1:] - corners[0]
    offset = np.linalg.solve(2 * edges @ edges.T, (edges ** 2).sum(axis=1)) @ edges
    return corners[0] + offset, np.linalg.norm(offset)


class OfPoints(np.ndarray):
    """As np.matrix, which is never flat, and arrays of PyVista."""


class OfUser(dfs.Delaunay3):
    """A derived class, with the constructor that it has."""


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

    def test_same_bytes(self):
        header = (ROOT / "test/Delaunay_from_surface_3/include/fixed_inputs.h").read_text(encoding="utf-8")
        table = re.findall(r'\{"([\w ]+)", (\d+), (\d+), 0x(\w{16})\}', header)
        self.assertEqual(len(table), 13)
        for name, n, m, value in table:
            points = fixed_points(name)
            for threads in (1, 4):
                simplices = dfs.delaunay3(points, threads=threads).simplices
                self.assertEqual((len(points), len(simplices), f"{hash_of(simplices):016x}"), (int(n), int(m), value), name)

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
        ours = dfs.delaunay3(points.view(OfPoints))
        self.assertEqual((type(ours.points), cell_set(ours.simplices)), (np.ndarray, expected))
        self.assertTrue(np.shares_memory(ours.points, points))
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
        self.assertFalse(result.simplices.flags.owndata or result.neighbors.flags.owndata)
        del result
        dfs.delaunay3(random_points(5000, seed=2))
        self.assertTrue((neighbors == copy).all())
        self.assertTrue(dfs.delaunay3(random_points(50)).simplices.flags.c_contiguous)

    def test_threads(self):
        points, faces = torus()
        grid = np.stack(np.meshgrid(*3 * [np.arange(20.)]), axis=-1).reshape(-1, 3)
        for points, faces in ((random_points(20000), None), (np.vstack([grid, grid[::3]]), None), (points, faces),
                              (points[:2], None), (points[:0], None), (points * [1, 1, 0], faces)):
            one = dfs.delaunay3(points, faces)
            for threads in (2, 5, None, 64):
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
        points, faces = torus()
        one, other, again = (dfs.delaunay3(points, faces, seed=s).simplices for s in (1, 2, 1))
        self.assertEqual(cell_set(one), cell_set(other))
        self.assertTrue(np.array_equal(one, again))
        self.assertTrue(np.array_equal(one, other))  # the order has random numbers only where it is replaced


class AsScipy(unittest.TestCase):
    """The names of scipy.spatial.Delaunay."""

    @classmethod
    def setUpClass(cls):
        cls.points = random_points(2000)
        cls.scipy = scipy.spatial.Delaunay(cls.points)
        cls.ours = dfs.delaunay3(cls.points)
        cls.grid = np.stack(np.meshgrid(*3 * [np.arange(6.)]), axis=-1).reshape(-1, 3)

    def test_sizes(self):
        self.assertEqual((self.ours.npoints, self.ours.nsimplex, self.ours.ndim), (2000, self.scipy.nsimplex, 3))
        for name in ("min_bound", "max_bound"):
            self.assertTrue((getattr(self.ours, name) == getattr(self.scipy, name)).all())
        self.assertIs(self.ours.points, self.points)
        self.assertEqual(repr(self.ours), f"<Delaunay3: 2000 points, {self.scipy.nsimplex} tetrahedra>")
        self.assertEqual(repr(dfs.delaunay3([])), "<Delaunay3: 0 points, 0 simplices>")

    def test_neighbors_when_asked_for(self):
        """The same as those that were kept."""
        for points in (self.points, self.grid, self.grid * [1, 1, 0], self.grid * [0, 1, 0], self.points[:1]):
            for threads in (1, 2):
                later, kept = dfs.delaunay3(points, threads=threads), dfs.delaunay3(points, neighbors=True)
                if threads == 1:
                    self.assertTrue(np.array_equal(later.simplices, kept.simplices))
                    self.assertTrue(np.array_equal(later.neighbors, kept.neighbors))
                Results.check_neighbors(self, later)
        wrong = dfs.Delaunay3(self.points, np.array([[0, 1, 2, 3]] * 3, dtype=np.int32), None, self.ours.vertices, 3)
        with self.assertRaisesRegex(ValueError, "more than two have a facet in common"):
            wrong.neighbors
        wrong.simplices[1] = 2000
        with self.assertRaisesRegex(IndexError, "2000 is not one of the 2000 points"):
            wrong.neighbors

    def test_convex_hull(self):
        hull = self.ours.convex_hull
        self.assertEqual(cell_set(hull), cell_set(self.scipy.convex_hull))
        a, b, c = (self.points[hull[:, k]] for k in range(3))
        self.assertTrue((np.einsum("ij,ij->i", np.cross(b - a, c - a), .5 - a) < 0).all())
        flat = dfs.delaunay3(self.grid * [1, 1, 0])
        self.assertEqual((len(flat.convex_hull), flat.convex_hull.shape[1]), (20, 2))
        self.assertEqual(dfs.delaunay3([[0, 0, 0], [2, 2, 2], [1, 1, 1]]).convex_hull.ravel().tolist(), [0, 1])

    def test_vertex_neighbor_vertices(self):
        for threads in (1, 2):
            first, items = dfs.delaunay3(self.points, threads=threads).vertex_neighbor_vertices
            their_first, their_items = self.scipy.vertex_neighbor_vertices
            self.assertTrue((first == their_first).all())
            for i in range(2000):
                self.assertEqual(items[first[i]:first[i + 1]].tolist(),
                                 sorted(their_items[their_first[i]:their_first[i + 1]].tolist()))

    def test_coplanar(self):
        points = np.vstack([self.points, self.points[5:8]])
        ours = dfs.delaunay3(points)
        self.assertEqual(ours.coplanar[:, [0, 2]].tolist(), [[2000, 5], [2001, 6], [2002, 7]])
        self.assertEqual({frozenset(pair) for pair in scipy.spatial.Delaunay(points).coplanar[:, [0, 2]].tolist()},
                         {frozenset(pair) for pair in ours.coplanar[:, [0, 2]].tolist()})
        for _, simplex, vertex in ours.coplanar.tolist():
            self.assertIn(vertex, ours.simplices[simplex])
        self.assertEqual(self.ours.coplanar.shape, (0, 3))
        self.assertTrue((ours.vertex_to_simplex[2000:] == -1).all())
        corners = ours.simplices[ours.vertex_to_simplex[:2000]]
        self.assertTrue((corners == np.arange(2000)[:, None]).any(axis=1).all())

    def test_find_simplex(self):
        xi = np.random.default_rng(5).random((20000, 3)) * 1.2 - .1
        expected = self.scipy.find_simplex(xi)
        corners = np.append(np.sort(self.scipy.simplices, axis=1), [[-1] * 4], axis=0)[expected]
        for threads in (1, 2, None):
            found = self.ours.find_simplex(xi, threads=threads)
            self.assertEqual(found.dtype, np.int32)
            ours = np.append(np.sort(self.ours.simplices, axis=1), [[-1] * 4], axis=0)[found]
            self.assertTrue((ours == corners).all())
        self.assertTrue((found == dfs.delaunay3(self.points, neighbors=True).find_simplex(xi)).all())
        self.assertEqual(self.ours.find_simplex(xi[:60].reshape(3, 4, 5, 3)).shape, (3, 4, 5))
        self.assertEqual(self.ours.find_simplex([.5, .5, .5]).shape, ())
        self.assertEqual(self.ours.find_simplex(np.zeros((0, 3))).shape, (0,))
        self.assertEqual(self.ours.find_simplex([]).shape, (0,))
        narrow = dfs.delaunay3(self.points.astype(np.float32))
        wide = dfs.delaunay3(self.points.astype(np.float32).astype(float))
        self.assertEqual((narrow.points.dtype, wide.points.dtype), (np.float32, np.float64))
        self.assertTrue((narrow.find_simplex(xi) == wide.find_simplex(xi)).all())

    def test_find_simplex_on_facets(self):
        """Of all simplices that contain a point, by exact arithmetic, the first."""
        for points in (self.grid, self.grid * .1, np.vstack([self.grid, skew_lines(60)])):
            ours = dfs.delaunay3(points)
            corners = ours.points[ours.simplices]
            rng = np.random.default_rng(6)
            some = corners[rng.integers(0, len(corners), 40)]
            xi = np.concatenate([some[:, 0], some[:, :2].mean(axis=1), (some[:, 0] + some[:, 1] + 2 * some[:, 2]) / 4,
                                 some.mean(axis=1), points[:3] - [1e-300, 0, 0], points[:3] * 1.5])
            found = ours.find_simplex(xi)
            for x, number in zip(xi, found.tolist()):
                low, high = corners.min(axis=1), corners.max(axis=1)
                near = np.flatnonzero(((low <= x) & (x <= high)).all(axis=1))
                self.assertEqual(number, next((i for i in near.tolist() if contains(corners[i], x)), -1))

    def test_find_simplex_refuses(self):
        with self.assertRaisesRegex(ValueError, "^xi: point 1: its z coordinate is not a finite number$"):
            self.ours.find_simplex([[0, 0, 0], [0, 0, np.nan]])
        for wrong in ([[0, 0]], 7, np.zeros(4)):
            with self.assertRaisesRegex(ValueError, r"xi: expected an array of shape \(n, 3\)"):
                self.ours.find_simplex(wrong)
        with self.assertRaisesRegex(ValueError, "xi: a masked array is not read"):
            self.ours.find_simplex(np.ma.masked_array(np.zeros((2, 3)), mask=True))
        with self.assertRaisesRegex(ValueError, "threads: expected"):
            self.ours.find_simplex([[0, 0, 0]], threads=0)
        with self.assertRaisesRegex(ValueError, "barycentric: 1 simplices for 2 points"):
            self.ours.barycentric([[0, 0, 0], [1, 1, 1]], [0])
        with self.assertRaisesRegex(ValueError, "find_simplex: there are no tetrahedra, the points have dimension 2"):
            dfs.delaunay3(self.grid * [1, 1, 0]).find_simplex([[0, 0, 0]])

    def test_find_simplex_in_points_that_change(self):
        """No crash, and no walk without end."""
        other, change = "the simplices are not a triangulation of the points", "a coordinate of a point is not a finite number any more"
        for spoilt, why in ((np.nan, change), (np.inf, change), (0., other), (random_points(43, seed=9), other)):
            points = random_points(300)
            ours = dfs.delaunay3(points)
            points[::7] = spoilt
            with self.assertRaisesRegex(ValueError, why):
                ours.find_simplex(random_points(2000, seed=8))
        ours = dfs.delaunay3(self.points, neighbors=True)
        for array, why in ((ours.neighbors, r"a neighbour of simplex \d+ is 1073741824, but there are \d+ cells"),
                           (ours.simplices, r"a vertex of simplex \d+ is 1073741824, but there are \d+ points")):
            array[:] = 2 ** 30
            with self.assertRaisesRegex(IndexError, why):
                ours.find_simplex(random_points(2000, seed=8))

    def test_barycentric(self):
        xi = np.random.default_rng(5).random((500, 3)) * 1.2 - .1
        simplex = self.ours.find_simplex(xi)
        coordinates = self.ours.barycentric(xi)
        inside = simplex >= 0
        self.assertTrue(np.isnan(coordinates[~inside]).all())
        again = np.einsum("ij,ijk->ik", coordinates[inside], self.points[self.ours.simplices[simplex[inside]]])
        self.assertTrue(np.allclose(again, xi[inside], atol=1e-9))
        transform = self.ours.transform[simplex[inside]]
        first = np.einsum("ijk,ik->ij", transform[:, :3], xi[inside] - transform[:, 3])
        self.assertTrue(np.allclose(first, coordinates[inside, :3]))
        self.assertEqual(self.ours.barycentric(xi.reshape(5, 100, 3)).shape, (5, 100, 4))

    def test_measures(self):
        hull = scipy.spatial.ConvexHull(self.points)
        self.assertAlmostEqual(self.ours.volumes.sum(), hull.volume, places=9)
        self.assertTrue((self.ours.volumes > 0).all())
        distance = np.linalg.norm(self.points[self.ours.simplices] - self.ours.circumcenters[:, None], axis=2)
        self.assertTrue(np.allclose(distance, self.ours.circumradii[:, None], rtol=1e-6))
        tiny = dfs.delaunay3(random_points(50) * 1e-200)
        self.assertTrue(np.allclose(tiny.circumradii, dfs.delaunay3(random_points(50)).circumradii * 1e-200, rtol=1e-6))

    def test_measures_of_flat_tetrahedra(self):
        """Against fractions, where doubles know no digit of the volumes."""
        def det(a, b, c):
            return sum(a[i] * (b[i - 2] * c[i - 1] - b[i - 1] * c[i - 2]) for i in range(3))

        def minus(a, b):
            return [x - y for x, y in zip(a, b)]
        for name, points in flat_sets().items():
            ours = dfs.delaunay3(points)
            points = ours.points.astype(float)
            xi = np.vstack([points, (points[ours.simplices[::3]] / 4).sum(axis=1)])
            simplex = ours.find_simplex(xi)
            weights = ours.barycentric(xi, simplex)
            self.assertTrue((weights[:len(points)] == (ours.simplices[simplex[:len(points)]] == ours.vertices[:, None])).all(), name)
            with np.errstate(all="ignore"):
                by_transform = np.einsum("ijk,ik->ij", ours.transform[simplex, :3], xi - ours.transform[simplex, 3])
            right = np.isnan(by_transform) | (np.abs(by_transform - weights[:, :3]) < 1e-9)
            self.assertTrue(right[simplex >= 0].all(), name)
            for c in range(0, ours.nsimplex, 5):
                corners = [[Fraction(x) for x in p] for p in points[ours.simplices[c]].tolist()]
                edges = [minus(p, corners[0]) for p in corners[1:]]
                six = det(*edges)
                halves = [sum(x * x for x in e) / 2 for e in edges]
                center = [det(*([h if i == j else e[i] for i in range(3)] for h, e in zip(halves, edges))) / six for j in range(3)]
                squared = sum(x * x for x in center)
                if Fraction(sys.float_info.min) < six / 6 < Fraction(sys.float_info.max):
                    self.assertLess(abs(Fraction(ours.volumes[c]) / (six / 6) - 1), 1e-12, name)
                if max(map(abs, center)) < Fraction(1e307):
                    self.assertLess(abs(Fraction(ours.circumradii[c]) ** 2 / squared - 1), 1e-12, name)
                    for i in range(3):
                        error = Fraction(ours.circumcenters[c, i]) - (corners[0][i] + center[i])
                        self.assertLess(abs(error), 1e-12 * (abs(corners[0][i]) + ours.circumradii[c]), name)
                for q in np.flatnonzero(simplex == c)[-2:]:
                    x = [Fraction(z) for z in xi[q].tolist()]
                    for k in range(4):
                        moved = corners[:k] + [x] + corners[k + 1:]
                        weight = det(*(minus(p, moved[0]) for p in moved[1:])) / six
                        self.assertLess(abs(Fraction(weights[q, k]) - weight), 1e-12, name)
        far = dfs.delaunay3(self.points)
        self.assertTrue(np.allclose(far.barycentric([[1e9, 0, 0]], [0]) @ far.points[far.simplices[0]], [[1e9, 0, 0]], atol=1e-3))
        self.assertTrue(np.isnan(far.barycentric([[np.nan, 0, 0], [0, 0, np.inf]], [0, 0])).all())
        with self.assertRaisesRegex(IndexError, f"barycentric: {far.nsimplex} is not one of the {far.nsimplex} simplices"):
            far.barycentric([[0, 0, 0]], [far.nsimplex])
        with self.assertRaises(IndexError):  # it does not become -1, which is outside
            far.barycentric([[0, 0, 0]], np.array([2**64 - 1], dtype=np.uint64))
        with self.assertRaisesRegex(TypeError, "barycentric: simplex: expected integers, got entries of type float64"):
            far.barycentric([[0, 0, 0]], [0.])

    def test_voronoi_volumes_at_flat_tetrahedra(self):
        cells = dfs.delaunay3(turned_lattice(5)).voronoi_volumes.reshape(5, 5, 5)
        self.assertLess(np.abs(cells[2, 2, 2] - 1), 1e-12)
        self.assertTrue((np.abs(dfs.delaunay3(turned_lattice(5) * 2.**-333).voronoi_volumes.reshape(5, 5, 5)[2, 2, 2]
                                * 2.**999 - 1) < 1e-12).all())

    def test_voronoi_volumes(self):
        for points in (self.points, np.vstack([self.grid, self.grid[:9]])):
            ours = dfs.delaunay3(points).voronoi_volumes
            voronoi = scipy.spatial.Voronoi(np.unique(points, axis=0))
            region = dict(zip(map(tuple, voronoi.points), voronoi.point_region))
            for point, volume in zip(points, ours):
                corners = voronoi.regions[region[tuple(point)]]
                if -1 in corners:
                    self.assertEqual(volume, -1)
                else:
                    expected = scipy.spatial.ConvexHull(voronoi.vertices[corners]).volume
                    self.assertLess(abs(volume - expected), 1e-7 * expected)

    def test_alpha_complex(self):
        points = random_points(60)
        ours = dfs.delaunay3(points)
        tree = scipy.spatial.cKDTree(points)
        for alpha in (0, .1, .15, .2, .4, np.inf):
            found = ours.alpha_complex(alpha)
            self.assertTrue((found.simplices == np.flatnonzero(ours.circumradii <= alpha)).all())
            triangles = cell_set(found.triangles)
            edges = cell_set(found.edges)
            np.testing.assert_array_equal(found.vertices, np.arange(60))
            for cell in ours.simplices[found.simplices].tolist():
                self.assertTrue({tuple(sorted(c)) for c in itertools.combinations(cell, 3)} <= triangles)
            for triangle in triangles:
                self.assertTrue(set(itertools.combinations(triangle, 2)) <= edges)
            # Edges and triangles whose smallest ball is empty are there from its radius on.
            for size, there in ((2, edges), (3, triangles)):
                for corners in {c for cell in ours.simplices.tolist()
                                for c in itertools.combinations(sorted(cell), size)}:
                    center, radius = smallest_sphere(points[list(corners)])
                    if len(tree.query_ball_point(center, radius * (1 - 1e-9))) == 0 and abs(radius - alpha) > 1e-9:
                        self.assertEqual(corners in there, radius < alpha)
        self.assertEqual(len(found.triangles), (4 * ours.nsimplex + len(ours.convex_hull)) // 2)
        with self.assertRaisesRegex(ValueError, "alpha_complex: expected a radius, got nan"):
            ours.alpha_complex(np.nan)
        with self.assertRaisesRegex(ValueError, "alpha_complex: expected a radius, got 'x'"):
            ours.alpha_complex("x")

    def test_alpha_complex_is_one(self):
        """With a radius that occurs as alpha, too: all faces of what is there are there, at any scale."""
        lattice = np.array(list(itertools.product(range(3), repeat=3)), dtype=float)
        hexagons = np.array([[x + y / 2, y * 3 ** .5 / 2, z * (8 / 3) ** .5] for x, y, z in lattice])
        body = np.vstack([lattice, lattice[:8] + .5])
        sets = [(lattice * h, [h / 2, h * 2 ** .5 / 2, h * 3 ** .5 / 2]) for h in (.07, .1, .3, .59, .7)]
        sets += [(points, None) for points in (hexagons, body * .1, turned_lattice(3), turned_lattice(3) * 1e-200,
                                               turned_lattice(3) * 1e-310, lattice * 1e300, random_points(60))]
        for points, alphas in sets:
            ours = dfs.delaunay3(points)
            if alphas is None:
                alphas = np.sort(ours.circumradii)[::max(1, ours.nsimplex // 5)]
            for alpha in alphas:
                found = ours.alpha_complex(alpha)
                triangles, edges = (set(map(tuple, c.tolist())) for c in (found.triangles, found.edges))
                self.assertTrue({t for cell in np.sort(ours.simplices[found.simplices]).tolist()
                                 for t in itertools.combinations(cell, 3)} <= triangles)
                self.assertTrue({e for t in triangles for e in itertools.combinations(t, 2)} <= edges)
        usual = dfs.delaunay3(random_points(60))
        for exponent in (-1000, -600, 600, 1000):
            scaled = dfs.delaunay3(np.ldexp(random_points(60), exponent)).alpha_complex(np.ldexp(.2, exponent))
            self.assertEqual([c.tolist() for c in scaled], [c.tolist() for c in usual.alpha_complex(.2)])

    def test_minimum_spanning_tree(self):
        for points in (self.points, self.grid, self.grid * [1, 1, 0], self.grid * [1, 0, 0], self.grid[:1], []):
            ours = dfs.delaunay3(points)
            tree = ours.minimum_spanning_tree()
            distinct = np.unique(ours.points, axis=0)
            self.assertEqual(tree.shape, (max(len(distinct) - 1, 0), 2))
            if len(tree) > 0:
                lengths = np.linalg.norm(ours.points[tree[:, 0]] - ours.points[tree[:, 1]], axis=1)
                self.assertTrue((np.diff(lengths) >= 0).all())
                expected = scipy.sparse.csgraph.minimum_spanning_tree(scipy.spatial.distance_matrix(distinct, distinct))
                self.assertAlmostEqual(lengths.sum(), expected.sum(), places=8)
                graph = scipy.sparse.coo_matrix((np.ones(len(tree)), tree.T), shape=2 * (len(points),))
                number, _ = scipy.sparse.csgraph.connected_components(graph, directed=False)
                self.assertEqual(number, 1 + len(points) - len(distinct))

    def test_minimum_spanning_tree_of_no_simplices(self):
        wrong = dfs.Delaunay3(self.points[:5], np.arange(5, dtype=np.int32)[None], None, np.arange(5, dtype=np.int32), 3)
        with self.assertRaisesRegex(ValueError, "at most four corners"):
            wrong.minimum_spanning_tree()

    def test_minimum_spanning_tree_at_all_scales(self):
        """Also where squares of lengths are no doubles: the tree is that of the usual scale."""
        points = np.round(random_points(100) * 2 ** 20) / 2 ** 20
        expected = dfs.delaunay3(points).minimum_spanning_tree().tolist()
        for exponent in (-1054, -600, -520, 400, 511, 600, 1000, 1023):
            scaled = dfs.delaunay3(np.ldexp(points, exponent))
            self.assertEqual(scaled.minimum_spanning_tree().tolist(), expected)
        doubled = dfs.delaunay3(np.ldexp(points * 2 - 1, 1023) * (1 - 2. ** -20))
        self.assertEqual(doubled.minimum_spanning_tree().tolist(), dfs.delaunay3(points * 2 - 1).minimum_spanning_tree().tolist())
        # Two scales in one set: each has its own tree.
        small = np.ldexp(points[:50], -700)
        tree = dfs.delaunay3(np.vstack([small, points[50:] + 1])).minimum_spanning_tree()
        self.assertEqual(tree[:49].tolist(), dfs.delaunay3(points[:50]).minimum_spanning_tree().tolist())

    def test_check(self):
        for points in (self.points, self.grid, self.grid * [1, 1, 0], self.grid * [0, 1, 0], self.points[:1], [],
                       np.vstack([self.grid * .1, self.grid * .1])):
            ours = dfs.delaunay3(points)
            for level in ("links", "euler", "orientation", "delaunay"):
                self.assertTrue(ours.check(level))
            if ours.nsimplex > 1:
                without = dfs.Delaunay3(ours.points, ours.simplices[1:], None, ours.vertices, ours.dimension)
                self.assertFalse(without.check())
        turned = dfs.Delaunay3(self.points, self.ours.simplices[:, [1, 0, 2, 3]], None, self.ours.vertices, 3)
        self.assertEqual([turned.check(level) for level in ("links", "euler", "orientation")], [True, True, False])
        for wrong in (-1, len(self.points)):
            simplices, vertices = self.ours.simplices.copy(), self.ours.vertices.copy()
            simplices[3, 1] = vertices[5] = wrong
            self.assertFalse(dfs.Delaunay3(self.points, simplices, None, self.ours.vertices, 3).check("links"))
            self.assertFalse(dfs.Delaunay3(self.points, self.ours.simplices, None, vertices, 3).check("links"))
        moved = self.points.copy()
        moved[7] = .5
        for level, expected in (("euler", True), ("orientation", False), ("delaunay", False)):
            self.assertEqual(dfs.Delaunay3(moved, self.ours.simplices, None, self.ours.vertices, 3).check(level),
                             expected)
        with self.assertRaisesRegex(ValueError, "check: expected one of links, .*, delaunay, got 'all'"):
            self.ours.check("all")

    def test_huge_numbers(self):
        """Measures may be infinite, and nobody is warned."""
        huge = dfs.delaunay3((self.points - .5) * 1.7e308)
        self.assertTrue(huge.check())
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertEqual(len(huge.alpha_complex(np.inf).simplices), huge.nsimplex)

    def test_pickle(self):
        for ours in (self.ours, dfs.delaunay3(self.points, neighbors=True), dfs.delaunay3([])):
            again = pickle.loads(pickle.dumps(ours))
            for name in ("points", "simplices", "vertices", "neighbors"):
                self.assertTrue(np.array_equal(getattr(again, name), getattr(ours, name)))
            self.assertEqual(again.dimension, ours.dimension)
        self.assertTrue(again.check())
        of_a_user = pickle.loads(pickle.dumps(OfUser(self.points, self.ours.simplices, None, self.ours.vertices, 3)))
        self.assertIs(type(of_a_user), OfUser)
        self.assertTrue(copy.deepcopy(self.ours).check())
        self.assertIs(weakref.ref(self.ours)(), self.ours)


def smallest_orthogonal_sphere(points, weights):
    """The centre and squared radius of the smallest sphere with the same power to all of up to three points."""
    sides = points[1:] - points[0]
    lifts = np.einsum("ij,ij->i", sides, sides) + weights[0] - weights[1:]
    shares = np.linalg.lstsq(2 * sides @ sides.T, lifts, rcond=None)[0] if len(sides) else np.zeros(0)
    center = points[0] + shares @ sides
    return center, ((center - points[0]) ** 2).sum() - weights[0]


class Regular(unittest.TestCase):
    def setUp(self):
        random = np.random.default_rng(7)
        self.points = random.random((400, 3))
        self.weights = random.random(400) * .02
        self.ours = dfs.delaunay3(self.points, weights=self.weights)

    def test_zero_weights(self):
        for points in (self.points, turned_lattice(4), [[0, 0, 0]], self.points * [1, 1, 0], []):
            plain = dfs.delaunay3(points, neighbors=True)
            for weight in (0, -3, 1e300):
                same = dfs.delaunay3(points, weights=np.full(len(points), weight), neighbors=True)
                for name in ("simplices", "neighbors", "vertices"):
                    np.testing.assert_array_equal(getattr(plain, name), getattr(same, name))
                self.assertEqual(len(same.hidden), 0)

    def test_convex_hull_in_four_dimensions(self):
        for scale in (.001, .02, .2):
            weights = self.weights * scale / .02
            ours = dfs.delaunay3(self.points, weights=weights)
            lifted = np.column_stack([self.points, (self.points ** 2).sum(axis=1) - weights])
            hull = scipy.spatial.ConvexHull(lifted)
            below = hull.simplices[hull.equations[:, 3] < 0]
            self.assertEqual(cell_set(ours.simplices), cell_set(below))
            np.testing.assert_array_equal(ours.hidden, np.setdiff1d(np.arange(400), below))
            self.assertTrue(ours.check())
        self.assertGreater(len(ours.hidden), 100)

    def test_hidden(self):
        hidden = self.ours.hidden
        self.assertGreater(len(hidden), 0)
        self.assertTrue((self.ours.vertices[hidden] == -1).all())
        self.assertTrue((self.ours.vertex_to_simplex[hidden] == -1).all())
        self.assertTrue((self.ours.find_simplex(self.points[hidden]) >= 0).all())
        self.assertIn(f"{len(hidden)} hidden points", repr(self.ours))
        points = np.vstack([self.points, self.points[:30]])
        again = dfs.delaunay3(points, weights=np.append(self.weights, self.weights[:30]))
        self.assertEqual(set(again.coplanar[:, 0]), {i + 400 for i in range(30) if i not in hidden})
        self.assertEqual(set(again.hidden) - set(hidden), {i + 400 for i in range(30) if i in hidden})
        heavy = dfs.delaunay3(np.vstack([self.points, [.5, .5, .5]]), weights=np.append(np.zeros(400), 100))
        self.assertEqual(heavy.dimension, 3)
        self.assertGreater(len(heavy.hidden), 300)

    def test_power_diagram(self):
        ours = self.ours
        volumes, (pairs, areas) = ours.power_volumes, ours.power_facets
        hull = set(ours.convex_hull.ravel())
        self.assertEqual(set(np.flatnonzero(volumes == -1)), hull)
        self.assertTrue((volumes[ours.hidden] == 0).all())
        # Centres at a vertex span its cell, and those at an edge the facet.
        for i in np.setdiff1d(np.unique(ours.simplices), list(hull))[:60]:
            at = (ours.simplices == i).any(axis=1)
            cell = scipy.spatial.ConvexHull(ours.power_centers[at], qhull_options="QJ")
            self.assertAlmostEqual(volumes[i], cell.volume, delta=1e-6 * cell.volume + 1e-12)
            mine = areas[(pairs == i).any(axis=1)]
            self.assertTrue((mine > -1e-12).all())
            self.assertAlmostEqual(mine.sum(), cell.area, delta=1e-6 * cell.area + 1e-9)
        # Areas are derivatives of volumes.
        step = 1e-7
        inner_areas = np.where((volumes[pairs] > 0).all(axis=1), areas, 0)
        i, j = pairs[np.argmax(inner_areas)]
        moved = self.weights.copy()
        moved[j] += step
        change = (dfs.delaunay3(self.points, weights=moved).power_volumes[i] - volumes[i]) / step
        length = np.linalg.norm(self.points[i] - self.points[j])
        self.assertAlmostEqual(change, -inner_areas.max() / (2 * length), delta=1e-3 * abs(change))
        lattice = np.array(list(itertools.product(range(5), repeat=3)), dtype=float)
        inner = ((lattice > 0) & (lattice < 4)).all(axis=1)
        ones = dfs.delaunay3(lattice, weights=np.full(125, -2.))
        np.testing.assert_allclose(ones.power_volumes[inner], 1, rtol=1e-13)
        centers, squares = ours.power_centers, ours.squared_power_radii
        for k in range(4):
            corner = ours.simplices[:, k]
            power = ((centers - self.points[corner]) ** 2).sum(axis=1) - self.weights[corner]
            np.testing.assert_allclose(power, squares, atol=1e-8, rtol=1e-6)

    def test_alpha_complex(self):
        points, weights = self.points[:60], self.weights[:60] * 3
        ours = dfs.delaunay3(points, weights=weights)
        for alpha in (0, .05, .1, .2, .4, np.inf):
            found = ours.alpha_complex(alpha)
            self.assertTrue((found.simplices == np.flatnonzero(ours.squared_power_radii <= alpha ** 2)).all())
            faces = {3: set(map(tuple, found.triangles.tolist())), 2: set(map(tuple, found.edges.tolist())),
                     1: {(v,) for v in found.vertices.tolist()}}
            for cell in ours.simplices[found.simplices].tolist():
                self.assertTrue(set(itertools.combinations(sorted(cell), 3)) <= faces[3])
            for size in (3, 2):
                for face in faces[size]:
                    self.assertTrue(set(itertools.combinations(face, size - 1)) <= faces[size - 1])
            for size, there in faces.items():
                for corners in {c for cell in ours.simplices.tolist() for c in itertools.combinations(sorted(cell), size)}:
                    center, square = smallest_orthogonal_sphere(points[list(corners)], weights[list(corners)])
                    powers = ((points - center) ** 2).sum(axis=1) - weights
                    if (powers >= square - 1e-9).all() and abs(square - alpha ** 2) > 1e-9:
                        self.assertEqual(corners in there, square < alpha ** 2)
        with self.assertRaisesRegex(ValueError, "alpha_complex: expected a radius, got -1"):
            ours.alpha_complex(-1)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertEqual(len(ours.alpha_complex(1e200).simplices), ours.nsimplex)
        for exponent in (-500, 400):
            scaled = dfs.delaunay3(np.ldexp(points, exponent), weights=np.ldexp(np.ldexp(weights, exponent), exponent))
            for one, other in zip(scaled.alpha_complex(np.ldexp(.1, exponent)), ours.alpha_complex(.1)):
                np.testing.assert_array_equal(one, other)
        plain, same = dfs.delaunay3(points), dfs.delaunay3(points, weights=np.zeros(60))
        for alpha in (.1, .2, .3):
            for one, other in zip(plain.alpha_complex(alpha), same.alpha_complex(alpha)):
                np.testing.assert_array_equal(one, other)

    @unittest.skipUnless(importlib.util.find_spec("gudhi"), "GUDHI (Debian: python3-gudhi) was not found")
    def test_alpha_complex_is_that_of_gudhi(self):
        """So persistence is, too. Its filtration has squares of radii."""
        import gudhi
        for n, share, less in ((60, .02, 0), (200, .02, 0), (60, .2, 0), (60, .001, .3)):
            points, weights = self.points[:n], self.weights[:n] / .02 * share - less
            tree = gudhi.AlphaComplex(points=points.tolist(), weights=weights.tolist(), precision="exact").create_simplex_tree()
            values = {tuple(sorted(simplex)): value for simplex, value in tree.get_filtration()}
            ours = dfs.delaunay3(points, weights=weights)
            for alpha in (0, .05, .1, .2, .4, .8):
                found = ours.alpha_complex(alpha)
                mine = {(v,) for v in found.vertices.tolist()} | cell_set(found.edges) | cell_set(found.triangles)
                mine |= cell_set(ours.simplices[found.simplices])
                self.assertTrue(mine <= set(values))
                for simplex, value in values.items():
                    if abs(value - alpha ** 2) > 1e-9:
                        self.assertEqual(simplex in mine, value < alpha ** 2, (n, share, alpha, simplex))

    def test_shift_threads_and_order(self):
        shifted = dfs.delaunay3(self.points, weights=self.weights + 4.)
        exact = dfs.delaunay3(self.points, weights=(self.weights + 4.) - 4.)  # without the digits that were lost
        self.assertEqual(cell_set(shifted.simplices), cell_set(exact.simplices))
        order = dfs.InsertionOrder()
        weights = self.weights
        for _ in range(3):
            weights = weights * .9
            kept = dfs.delaunay3(self.points, weights=weights, order=order, threads=2)
            self.assertEqual(cell_set(kept.simplices), cell_set(dfs.delaunay3(self.points, weights=weights).simplices))
        self.assertEqual(len(order), 400)

    def test_flat(self):
        rows = np.column_stack([self.points[:, :2], np.zeros(400)])
        flat = dfs.delaunay3(rows, weights=self.weights)
        self.assertEqual(flat.dimension, 2)
        self.assertGreater(len(flat.hidden), 0)
        line = dfs.delaunay3(np.arange(30.).reshape(10, 3), weights=[0] * 4 + [10000] + [0] * 5)
        self.assertEqual((line.dimension, cell_set(line.simplices)), (1, {(0, 4), (4, 9)}))
        self.assertTrue(flat.check() and line.check())
        self.assertEqual(dfs.delaunay3([[1, 2, 3]] * 3, weights=[1, 2, 2]).vertices.tolist(), [-1, 1, 1])

    def test_check(self):
        self.assertTrue(all(self.ours.check(level) for level in ("links", "euler", "orientation", "delaunay")))
        other = dfs.Regular3(self.weights * 2, *self.ours.__reduce__()[1][1:])
        self.assertFalse(other.check())
        shown = self.weights.copy()
        shown[self.ours.hidden[0]] += 1
        self.assertFalse(dfs.Regular3(shown, *self.ours.__reduce__()[1][1:]).check())

    def test_pickle(self):
        again = pickle.loads(pickle.dumps(self.ours))
        self.assertIs(type(again), dfs.Regular3)
        for name in ("points", "weights", "simplices", "vertices", "power_volumes"):
            np.testing.assert_array_equal(getattr(again, name), getattr(self.ours, name))

    def test_refusals(self):
        for weights, error, message in (
                ([1, 2], ValueError, r"weights: expected an array of shape \(400,\), one for each point, got \(2,\)"),
                (np.append(self.weights[1:], np.nan), ValueError, "weights: that of point 399 is not a finite number"),
                (np.zeros((400, 1)), ValueError, r"got \(400, 1\)"), (["x"] * 400, TypeError, "weights: expected numbers"),
                (np.ma.masked_array(self.weights), ValueError, "weights: a masked array"),
                (1., ValueError, "weights: expected an array of shape")):
            with self.assertRaisesRegex(error, message):
                dfs.delaunay3(self.points, weights=weights)
        with self.assertRaisesRegex(ValueError, "inside: the points have weights"):
            dfs.delaunay3(self.points, [[0, 1, 2]], weights=self.weights, inside=True)
        for name in ("circumcenters", "circumradii", "voronoi_volumes"):
            with self.assertRaisesRegex(ValueError, f"{name}: the points have weights"):
                getattr(self.ours, name)
        with self.assertRaisesRegex(ValueError, "minimum_spanning_tree: the points have weights"):
            self.ours.minimum_spanning_tree()


def copies_around(points, box, reach=1):
    """All copies up to so many periods away, with the indices of their points and their offsets."""
    steps = [range(-reach, reach + 1) if np.isfinite(period) else (0,) for period in box]
    offsets = np.array(list(itertools.product(*steps)))
    lengths = np.where(np.isfinite(box), box, 0)
    return ((points[None] + (offsets * lengths)[:, None]).reshape(-1, 3), np.tile(np.arange(len(points)), len(offsets)),
            np.repeat(offsets, len(points), axis=0))


def simplex_of_copies(indices, offsets):
    """The corners in order, moved so that the first is where it was given: the same for all copies."""
    corners = sorted(zip(map(int, indices), map(tuple, np.asarray(offsets, dtype=int).tolist())))
    first = corners[0][1]
    return tuple((i, tuple(a - b for a, b in zip(offset, first))) for i, offset in corners)


def simplices_of_copies(result):
    return [simplex_of_copies(*corners) for corners in zip(result.simplices, result.offsets)]


def without_rectangles(simplices):
    """Without those with three copies of one point: four of these may lie on a circle, as on the hull of a slab."""
    return {s for s in simplices if max(sum(i == j for j, _ in s) for i, _ in s) < 3}


class Periodic(unittest.TestCase):
    BOXES = ((1, 1, 1), (1, 1, None), (None, 1, np.inf), (1, 1.5, .8))

    def setUp(self):
        random = np.random.default_rng(5)
        self.points = random.random((80, 3))
        self.weights = random.random(80) * .06
        self.lattice = np.array(list(itertools.product(range(5), repeat=3))) * .2
        self.sets = {str(box): (self.points * np.where(np.isfinite(self.periods(box)), self.periods(box), 1), box)
                     for box in self.BOXES}

    @staticmethod
    def periods(box):
        return np.array([np.inf if period is None else period for period in box], dtype=float)

    def check_structure(self, ours):
        """Tetrahedra are kept as they should be, positive, and share facets in pairs with their neighbours."""
        self.assertEqual((ours.simplices.dtype, ours.offsets.dtype, ours.offsets.shape),
                         (np.int32, np.int16, (ours.nsimplex, 4, 3)))
        finite = np.isfinite(ours.box)
        self.assertTrue((ours.offsets[..., ~finite] == 0).all())
        self.assertTrue((ours.volumes > 0).all())
        lengths = np.where(finite, ours.box, 0)
        np.testing.assert_allclose(ours.corners, ours.points[ours.simplices] + ours.offsets * lengths, atol=1e-12)
        all_simplices = simplices_of_copies(ours)
        self.assertEqual(len(set(all_simplices)), len(all_simplices))
        facets = {}
        for c, (corners, offsets) in enumerate(zip(ours.simplices, ours.offsets)):
            self.assertTrue((offsets[min(range(4), key=lambda k: (corners[k], tuple(offsets[k])))] == 0).all())
            for k in range(4):
                facet = simplex_of_copies(np.delete(corners, k), np.delete(offsets, k, axis=0))
                facets.setdefault(facet, []).append((c, k))
        for sides in facets.values():
            if len(sides) == 2:
                for (c, k), (d, _) in (sides, sides[::-1]):
                    self.assertEqual(ours.neighbors[c, k], d)
            else:
                (c, k), = sides
                self.assertEqual(ours.neighbors[c, k], -1)
        hull = {simplex_of_copies(*facet) for facet in zip(ours.convex_hull, ours.convex_hull_offsets)}
        self.assertEqual(hull, {facet for facet, sides in facets.items() if len(sides) == 1})
        if finite.all():
            self.assertEqual(len(hull), 0)
            volume = ours.box.prod()
            self.assertAlmostEqual(ours.volumes.sum(), volume, delta=1e-12 * volume)

    def test_copies(self):
        """The tetrahedra are those of SciPy among copies around, of which those farther away have no part in them."""
        for name, (points, box) in self.sets.items():
            with self.subTest(name):
                ours = dfs.delaunay3(points, box=box)
                self.assertEqual(repr(ours).split(":")[0], "<Periodic3")
                self.check_structure(ours)
                around, indices, offsets = copies_around(points, self.periods(box))
                theirs = scipy.spatial.Delaunay(around).simplices
                at_home = (offsets[theirs] == 0).all(axis=2).any(axis=1)
                expected = {simplex_of_copies(indices[s], offsets[s]) for s in theirs[at_home]}
                self.assertEqual(*map(without_rectangles, (simplices_of_copies(ours), expected)))
                self.assertTrue(ours.is_simplicial_complex or len(box) == 3)
                for threads in (2, None):
                    again = dfs.delaunay3(points, box=box, threads=threads, seed=3)
                    self.assertEqual(set(simplices_of_copies(again)), set(simplices_of_copies(ours)))

    def test_voronoi_volumes(self):
        for name, (points, box) in self.sets.items():
            with self.subTest(name):
                ours = dfs.delaunay3(points, box=box)
                volumes = ours.voronoi_volumes
                around, indices, offsets = copies_around(points, self.periods(box))
                theirs = dfs.delaunay3(around).voronoi_volumes[(offsets == 0).all(axis=1)]
                self.assertEqual(set(np.flatnonzero(volumes == -1)), set(ours.convex_hull.ravel()))
                bounded = volumes >= 0
                np.testing.assert_allclose(volumes[bounded], theirs[bounded], rtol=1e-9)
                if np.isfinite(self.periods(box)).all():
                    self.assertTrue(bounded.all())
                    self.assertAlmostEqual(volumes.sum() / ours.box.prod(), 1, 12)
                distances = np.linalg.norm(ours.corners - ours.circumcenters[:, None], axis=2)
                np.testing.assert_allclose(distances, np.repeat(ours.circumradii[:, None], 4, axis=1), rtol=1e-7)

    def test_lattices(self):
        """Their tetrahedra are so flat that rounded corners would not do: the periods and the points are not multiples."""
        for scale, shift in ((1, 0), (.1, .3), (1e-200, 0), (1e150, 0), (1, 1e6)):
            ours = dfs.delaunay3(self.lattice * scale + shift, box=(scale,) * 3)
            self.assertAlmostEqual(ours.volumes.sum() / scale ** 3 if 1e-100 < scale < 1e100 else 1, 1, 12)
            if shift == 0 and .01 < scale < 100:
                np.testing.assert_allclose(ours.voronoi_volumes, .008 * scale ** 3, rtol=1e-9)
        whole = dfs.delaunay3(self.lattice * 5, box=(5, 5, 5), weights=np.full(125, 7.))
        np.testing.assert_allclose(whole.power_volumes, 1, rtol=1e-13)
        self.assertTrue(whole.is_simplicial_complex)

    def test_few_points(self):
        for points in ([[0, 0, 0]], [[.3, 5, -7]], [[0, 0, 0], [.5, .5, .5]], [[.1, .2, .3], [.1, .2, .3]]):
            for box in ((1, 1, 1), (1, 2, 3), (.1, 1, 10)):
                ours = dfs.delaunay3(points, box=box)
                self.assertFalse(ours.is_simplicial_complex)
                self.check_structure(ours)
                self.assertAlmostEqual(ours.voronoi_volumes[np.unique(ours.vertices)].sum(), np.prod(box), 9)
                x = random_points(50) * 9 - 4
                found = ours.find_copies(x)
                self.assertTrue((found.simplices >= 0).all())
                self.assertTrue((ours.barycentric(x) >= -1e-13).all())
        one = dfs.delaunay3([[.5, .5, .5]], box=(1, 1, 1))
        self.assertEqual((one.nsimplex, len(one.vertex_neighbor_vertices.indices)), (6, 14))
        none = dfs.delaunay3([], box=(1, 1, 1))
        self.assertEqual((none.nsimplex, none.dimension, none.corners.shape[-1], len(none.convex_hull)), (0, -1, 3, 0))

    def test_equal_points(self):
        points = np.vstack([self.points, self.points[:30] + [1, -2, 0]])
        points[80:] = np.where(points[80:] - [1, -2, 0] == points[:30], points[80:], self.points[:30])
        ours = dfs.delaunay3(points, box=(1, 1, 1))
        self.assertEqual(ours.vertices.tolist(), [*range(80), *range(30)])
        self.assertEqual(ours.coplanar[:, [0, 2]].tolist(), [[80 + i, i] for i in range(30)])
        np.testing.assert_allclose(ours.voronoi_volumes[80:], ours.voronoi_volumes[:30])

    def test_points_anywhere(self):
        """Moved by whole periods, they have the same tetrahedra with other offsets."""
        points = np.floor(self.points * 2 ** 20) / 2 ** 20
        moves = np.random.default_rng(1).integers(-9, 9, (80, 3))
        ours, moved = dfs.delaunay3(points, box=(1, 1, 1)), dfs.delaunay3(points + moves, box=(1, 1, 1))
        self.check_structure(moved)
        again = {simplex_of_copies(corners, offsets + moves[corners])
                 for corners, offsets in zip(moved.simplices, moved.offsets)}
        self.assertEqual(again, set(simplices_of_copies(ours)))
        np.testing.assert_allclose(np.sort(moved.volumes), np.sort(ours.volumes), rtol=1e-9)
        self.assertTrue((moved.find_simplex(points) >= 0).all())

    def test_weights(self):
        for name, (points, box) in self.sets.items():
            with self.subTest(name):
                ours = dfs.delaunay3(points, box=box, weights=self.weights)
                self.assertTrue(isinstance(ours, dfs.Periodic3) and isinstance(ours, dfs.Regular3))
                self.check_structure(ours)
                around, indices, offsets = copies_around(points, self.periods(box))
                lifted = np.column_stack([around, (around ** 2).sum(axis=1) - self.weights[indices]])
                hull = scipy.spatial.ConvexHull(lifted)
                theirs = hull.simplices[hull.equations[:, 3] < 0]
                at_home = (offsets[theirs] == 0).all(axis=2).any(axis=1)
                expected = {simplex_of_copies(indices[s], offsets[s]) for s in theirs[at_home]}
                self.assertEqual(*map(without_rectangles, (simplices_of_copies(ours), expected)))
                shown = np.unique(ours.simplices)
                np.testing.assert_array_equal(ours.hidden, np.setdiff1d(np.arange(80), shown))
                self.assertGreater(len(ours.hidden), 0)
                self.assertIn(f"{len(ours.hidden)} hidden points, box", repr(ours))
                powers = ((ours.power_centers[:, None] - ours.corners) ** 2).sum(axis=2) - self.weights[ours.simplices]
                np.testing.assert_allclose(powers, np.repeat(ours.squared_power_radii[:, None], 4, axis=1), atol=1e-7)
                volumes = ours.power_volumes
                self.assertTrue((volumes[ours.hidden] == 0).all())
                if np.isfinite(self.periods(box)).all():
                    self.assertAlmostEqual(volumes.sum() / ours.box.prod(), 1, 12)
                else:
                    self.assertEqual(set(np.flatnonzero(volumes == -1)), set(ours.convex_hull.ravel()))

    def test_power_facets(self):
        """Areas are derivatives of volumes, and those of a cell add up to its area."""
        points, weights = self.points[:20], self.weights[:20] * .5
        ours = dfs.delaunay3(points, box=(1, 1, 1), weights=weights)
        pairs, areas, offsets = ours.power_facets
        self.assertEqual(len({(*pair, *offset) for pair, offset in zip(pairs.tolist(), offsets.tolist())}), len(pairs))
        self.assertTrue((areas > -1e-12).all())
        same = pairs[:, 0] == pairs[:, 1]
        self.assertTrue(all(tuple(offset) > (0, 0, 0) for offset in offsets[same].tolist()))
        edges = points[pairs[:, 1]] + offsets - points[pairs[:, 0]]
        lengths = np.linalg.norm(edges, axis=1)
        step = 1e-7
        for j in range(3):
            moved = weights.copy()
            moved[j] += step
            change = (dfs.delaunay3(points, box=(1, 1, 1), weights=moved).power_volumes - ours.power_volumes) / step
            expected = np.zeros(20)
            for pair, share in zip(pairs[~same], (areas / (2 * lengths))[~same]):
                if j in pair:
                    expected[pair.sum() - j] -= share
                    expected[j] += share
            np.testing.assert_allclose(change, expected, atol=1e-4)
        # Gauss: a cell's volume is a third of the sum over its facets of area times distance.
        distances = (lengths ** 2 + weights[pairs[:, 0]] - weights[pairs[:, 1]]) / (2 * lengths)
        sums = np.zeros(20)
        np.add.at(sums, pairs[:, 0], areas * distances / 3)
        np.add.at(sums, pairs[:, 1], areas * (lengths - distances) / 3)
        np.testing.assert_allclose(sums, ours.power_volumes, rtol=1e-9)
        slab = dfs.delaunay3(points, box=(1, 1, None), weights=weights)
        at_hull = slab.power_facets.areas == -1
        corners = {simplex_of_copies(i[list(k)], o[list(k)]) for i, o in zip(slab.convex_hull, slab.convex_hull_offsets)
                   for k in ((0, 1), (0, 2), (1, 2))}
        self.assertEqual({simplex_of_copies(pair, [(0, 0, 0), offset]) for pair, offset in
                          zip(slab.power_facets.pairs[at_hull], slab.power_facets.offsets[at_hull])}, corners)

    def test_find(self):
        random = np.random.default_rng(3)
        for name, (points, box) in self.sets.items():
            periods = self.periods(box)
            lengths = np.where(np.isfinite(periods), periods, 0)
            for weights in (None, self.weights):
                with self.subTest(name):
                    ours = dfs.delaunay3(points, box=box, weights=weights)
                    x = random.random((200, 3)) * 7 * np.where(lengths > 0, 1, .2) - 3 * (lengths > 0)
                    x[:80], x[80:90] = points, points[:10] + lengths * [3, -5, 7]
                    found, offsets = ours.find_copies(x)
                    np.testing.assert_array_equal(ours.find_copies(x, threads=3).offsets, offsets)
                    np.testing.assert_array_equal(ours.find_simplex(x), found)
                    for q in range(0, 200, 4):
                        near = self.simplices_near(ours, x[q])
                        self.assertEqual(next((c for c in near if self.some_copy_contains(ours, c, x[q])), -1), found[q])
                        if found[q] >= 0:
                            self.assertTrue(contains(self.exact_corners(ours, found[q], offsets[q]), x[q]))
                        else:
                            self.assertFalse(np.isfinite(periods).all())
                    inner = found >= 0
                    shares = ours.barycentric(x, found, offsets)
                    np.testing.assert_array_equal(shares, ours.barycentric(x))
                    np.testing.assert_array_equal(shares, ours.barycentric(x, found))
                    self.assertTrue(np.isnan(shares[~inner]).all() and (shares[inner] > -1e-13).all())
                    corners = ours.corners[found] + (offsets * lengths)[:, None]
                    np.testing.assert_allclose(np.einsum("ij,ijk->ik", shares, corners)[inner], x[inner], atol=1e-12)
        ours = dfs.delaunay3(self.points, box=(1, 1, 1))
        self.assertEqual(ours.find_simplex([.5, .5, .5]).shape, ())
        self.assertEqual(ours.find_copies(np.full((2, 5, 3), .5)).offsets.shape, (2, 5, 3))
        self.assertEqual(ours.barycentric(np.full((2, 5, 3), .5)).shape, (2, 5, 4))
        far = np.array([[2. ** 28, -2. ** 28, .5]])
        np.testing.assert_allclose(ours.find_copies(far).offsets, [[2 ** 28, -2 ** 28, 0]], atol=2)
        with self.assertRaisesRegex(ValueError, r"xi: point 1 is 2\^29 or more periods away from the box along y"):
            ours.find_simplex([[0, 0, 0], [0, 1e10, 0]])
        with self.assertRaisesRegex(ValueError, "barycentric: other simplices than those of find_copies"):
            ours.barycentric([[.5, .5, .5]], [ours.find_simplex([.5, .5, .5]) ^ 1])
        with self.assertRaisesRegex(ValueError, "barycentric: there are offsets, but no simplices"):
            ours.barycentric([[.5, .5, .5]], offset=[[0, 0, 0]])
        with self.assertRaisesRegex(ValueError, "barycentric: 1 simplices and 2 numbers of offsets for 1 points"):
            ours.barycentric([[.5, .5, .5]], [0], [0, 0])
        with self.assertRaisesRegex(TypeError, "barycentric: offset: expected integers"):
            ours.barycentric([[.5, .5, .5]], [0], [[0., 0, 0]])
        with self.assertRaisesRegex(IndexError, "barycentric: 9999 is not one of"):
            ours.barycentric([[.5, .5, .5]], [9999], [[0, 0, 0]])
        with self.assertRaises(IndexError):
            ours.barycentric([[.5, .5, .5]], np.array([2**64 - 1], dtype=np.uint64), [[0, 0, 0]])

    @staticmethod
    def exact_corners(ours, simplex, offset):
        periods = [Fraction(float(period)) if np.isfinite(period) else 0 for period in ours.box]
        return [[Fraction(float(x)) + (int(k) + int(t)) * period
                 for x, k, t, period in zip(ours.points[i], offsets, offset, periods)]
                for i, offsets in zip(ours.simplices[simplex], ours.offsets[simplex])]

    @staticmethod
    def simplices_near(ours, x, slack=1e-9):
        """Those with a copy whose bounding box contains the point."""
        low, high = ours.corners.min(axis=1) - slack, ours.corners.max(axis=1) + slack
        periods = np.where(np.isfinite(ours.box), ours.box, 1)
        with_period = np.floor((x - low) / periods) >= np.ceil((x - high) / periods)
        return np.flatnonzero(np.where(np.isfinite(ours.box), with_period, (low <= x) & (x <= high)).all(axis=1))

    def some_copy_contains(self, ours, simplex, x):
        low, high = ours.corners[simplex].min(axis=0), ours.corners[simplex].max(axis=0)
        steps = []
        for axis, period in enumerate(ours.box):
            if np.isfinite(period):
                steps.append(range(int(np.floor((x[axis] - high[axis]) / period)), int(np.ceil((x[axis] - low[axis]) / period)) + 1))
            else:
                steps.append((0,))
        return any(contains(self.exact_corners(ours, simplex, offset), x) for offset in itertools.product(*steps))

    def test_alpha_complex(self):
        """That of the copies around; and with all simplices it has no Euler characteristic, as the torus has none."""
        for name, (points, box) in self.sets.items():
            for weights in (None, self.weights * .3):
                ours = dfs.delaunay3(points, box=box, weights=weights)
                around, indices, offsets = copies_around(points, self.periods(box))
                theirs = dfs.delaunay3(around, weights=None if weights is None else weights[indices])
                for alpha in (0, .08, .12, .16, .3):
                    with self.subTest((name, weights is None, alpha)):
                        found, of_copies = ours.alpha_complex(alpha), theirs.alpha_complex(alpha)
                        for faces, moved, expected in (
                                (ours.simplices[found.simplices], ours.offsets[found.simplices], theirs.simplices[of_copies.simplices]),
                                (found.triangles, found.triangle_offsets, of_copies.triangles),
                                (found.edges, found.edge_offsets, of_copies.edges)):
                            here = [simplex_of_copies(*face) for face in zip(faces, moved)]
                            self.assertEqual(len(set(here)), len(here))
                            at_home = (offsets[expected] == 0).all(axis=2).any(axis=1)
                            self.assertEqual(set(here), {simplex_of_copies(indices[s], offsets[s]) for s in expected[at_home]})
                        if weights is not None:
                            at_home = (offsets[of_copies.vertices] == 0).all(axis=1)
                            self.assertEqual(set(found.vertices), set(indices[of_copies.vertices[at_home]]))
                with self.assertRaisesRegex(ValueError, "alpha_complex: expected a radius, got -1"):
                    ours.alpha_complex(-1)
        for points in (self.points, self.points[:1], self.points[:3]):
            for weights in (None, self.weights[:len(points)]):
                ours = dfs.delaunay3(points, box=(1, 1, 1), weights=weights)
                whole = ours.alpha_complex(np.inf)
                self.assertEqual(len(whole.vertices) - len(whole.edges) + len(whole.triangles) - len(whole.simplices), 0)
                self.assertEqual(len(whole.triangles), 2 * ours.nsimplex)
                self.assertEqual(2 * len(whole.edges), len(ours.vertex_neighbor_vertices.indices))

    def test_neighbor_vertices(self):
        for name, (points, box) in {**self.sets, "few": (self.points[:3], (1, 1, 1))}.items():
            with self.subTest(name):
                ours = dfs.delaunay3(points, box=box)
                indptr, indices, offsets = ours.vertex_neighbor_vertices
                expected = {(i, j, *(b - a)) for corners, of in zip(ours.simplices.tolist(), ours.offsets.astype(int))
                            for (i, a), (j, b) in itertools.permutations(zip(corners, of), 2)}
                found = [(i, int(indices[k]), *offsets[k]) for i in range(len(points)) for k in range(indptr[i], indptr[i + 1])]
                self.assertEqual(found, sorted(expected))

    def test_numbers_of_rows(self):
        """Of few bits, and of many, which are sorted in another way."""
        rows = np.random.default_rng(1).integers(-2, 2, (500, 4)).astype(np.int32)
        for many in (rows, rows * 2 ** 29, rows[:0]):
            first, number = dfs._periodic._numbered(many)
            expected, index, inverse = np.unique(many, axis=0, return_index=True, return_inverse=True)
            np.testing.assert_array_equal(first, index)
            np.testing.assert_array_equal(number, inverse.reshape(-1))

    def test_pickle(self):
        for weights in (None, self.weights):
            ours = dfs.delaunay3(self.points, box=(1, 1, None), weights=weights)
            again = pickle.loads(pickle.dumps(ours))
            self.assertIs(type(again), type(ours))
            for name in ("points", "simplices", "neighbors", "vertices", "offsets", "box", "corners", "volumes"):
                np.testing.assert_array_equal(getattr(again, name), getattr(ours, name))
            self.assertEqual(again.is_simplicial_complex, ours.is_simplicial_complex)
            np.testing.assert_array_equal(again.find_simplex(random_points(9)), ours.find_simplex(random_points(9)))
            for name in ("offsets", "box", "corners", "is_simplicial_complex"):
                with self.assertRaises(AttributeError):
                    setattr(ours, name, 1)

    def test_progress(self):
        shares = []
        dfs.delaunay3(random_points(20000), box=(1, 1, 1), progress=shares.append)
        self.assertTrue(shares == sorted(shares) and shares[-1] == 1)
        with self.assertRaises(dfs.Stopped):
            dfs.delaunay3(random_points(20000), box=(1, 1, 1), progress=lambda share: False)

    def test_other_types(self):
        narrow = self.points.astype(np.float32)
        ours, wide = dfs.delaunay3(narrow, box=(1, 1, 1)), dfs.delaunay3(narrow.astype(float), box=np.ones(3, dtype=int))
        self.assertEqual(simplices_of_copies(ours), simplices_of_copies(wide))
        np.testing.assert_array_equal(ours.volumes, wide.volumes)
        np.testing.assert_array_equal(ours.find_simplex(narrow), wide.find_simplex(narrow))

    def check_what_others_make(self, ours):
        """Wrong arrays are refused when they are read."""
        kind, (box, offsets, flag, *arguments) = ours.__reduce__()
        at = 1 if isinstance(ours, dfs.Regular3) else 0
        points, simplices, neighbors = arguments[at:at + 3]

        def made(*instead):
            values = [box, offsets, flag, *arguments]
            for place, value in instead:
                values[place] = value
            return kind(*values)
        with self.assertRaisesRegex(ValueError, "neighbors: a triangulation in a periodic box is made with them"):
            made((5 + at, None))
        with self.assertRaisesRegex(ValueError, "the simplices are not a triangulation of the points in the box"):
            made((5 + at, np.roll(neighbors, 1, axis=0))).find_simplex(random_points(99))
        with self.assertRaisesRegex(ValueError, "offsets: expected three for each corner of the simplices"):
            _ = made((1, offsets[1:])).volumes
        with self.assertRaisesRegex(ValueError, "box: expected three periods"):
            _ = made((0, box[:2])).volumes
        with self.assertRaisesRegex(ValueError, "a coordinate of a point is not a finite number any more"):
            made((3 + at, points * [1, 1, np.nan])).find_simplex([0, 0, 0])
        with self.assertRaisesRegex(ValueError, "point 0 is 2.29 or more periods away from the box along x"):
            made((3 + at, points + 1e10)).find_simplex([0, 0, 0])
        for offset, message in ((2 ** 40, "barycentric: offset: more than 2.30 periods"),
                                (2 ** 20, "box: a corner is more than 32767 periods away from a point")):
            with self.assertRaisesRegex(ValueError, message):
                ours.barycentric([[0, 0, 0]], [0], [[0, offset, 0]])

    def test_refusals(self):
        points = self.points
        for box, error, message in (
                ((1, 0, 1), ValueError, "^box: the period along y is not positive: got 0$"),
                ((1, 1, -2.), ValueError, "box: the period along z is not positive: got -2.0"),
                ((np.nan, 1, 1), ValueError, "box: the period along x is not positive: got nan"),
                ((1, 1), ValueError, "box: expected three periods, one along each axis, got 2"),
                (3, TypeError, "box: expected three periods, got 3"),
                (np.ones(3, bool), TypeError, "box: the period along x: expected a number"),
                ((10**400, 1, 1), TypeError, "box: the period along x: expected a number"),
                (np.ma.array([1, 1, 1]), ValueError, "None stands for no period"),
                ((1, "a", 1), TypeError, "box: the period along y: expected a number, or None if there is no period, got 'a'"),
                ((1, 1, 1e-5), ValueError, "^box: the period along z is less than 1/10000 of the diagonal of the box$"),
                ((1e-10, None, None), ValueError, "box: the period along x is so small that point")):
            with self.assertRaisesRegex(error, message):
                dfs.delaunay3(points + (1 if box[0] == 1e-10 else 0) * np.arange(80)[:, None] if isinstance(box, tuple) else points,
                              box=box)
        for flat, box in ((points * [1, 1, 0], (1, 1, None)), (points * [0, 1, 1], (None, 1, None)), ([[0, 0, 0]], (1, None, 1))):
            with self.assertRaisesRegex(ValueError, "box: the points lie in a plane or on a line that is parallel to all axes"):
                dfs.delaunay3(flat, box=box)
        for keywords, message in (({"faces": [[0, 1, 2]]}, "faces: there are none in a periodic box"),
                                  ({"inside": True}, "faces: there are none in a periodic box"),
                                  ({"order": dfs.InsertionOrder()}, "order: it is not kept for a periodic box"),
                                  ({"weights": [1]}, r"weights: expected an array of shape \(80,\)"),
                                  ({"threads": 0}, "threads: expected a whole number")):
            with self.assertRaisesRegex(ValueError, message):
                dfs.delaunay3(points, box=(1, 1, 1), **keywords)
        with self.assertRaisesRegex(ValueError, "points: point 3: its x coordinate is not a finite number"):
            dfs.delaunay3(np.where(np.arange(240).reshape(80, 3) == 9, np.inf, points), box=(1, 1, 1))
        for weights in (None, self.weights):
            ours = dfs.delaunay3(points, box=(1, 1, 1), weights=weights)
            self.check_what_others_make(ours)
            for name in ("inside", "transform"):
                with self.assertRaisesRegex(ValueError, f"^{name}: the points are in a periodic box: "):
                    getattr(ours, name)
            for name, arguments in (("minimum_spanning_tree", ()), ("check", ())):
                with self.assertRaisesRegex(ValueError, f"^{name}: the points are in a periodic box: "):
                    getattr(ours, name)(*arguments)
            if weights is not None:
                for name in ("circumcenters", "circumradii", "voronoi_volumes"):
                    with self.assertRaisesRegex(ValueError, f"{name}: the points have weights"):
                        getattr(ours, name)


class Inside(unittest.TestCase):
    """Of a cube with more points on its sides, each side cut up alike."""

    @staticmethod
    def cube(n=6):
        points, faces = [], []
        for axis in range(3):
            for side in (0, 1):
                first = len(points)
                for i in range(n + 1):
                    for j in range(n + 1):
                        p = [0.0, 0.0, 0.0]
                        p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3] = side, i / n, j / n
                        points.append(p)
                corner = lambda i, j: first + (n + 1) * i + j
                for i in range(n):
                    for j in range(n):
                        square = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)]
                        square = square if side else square[::-1]
                        faces += [[square[0], square[1], square[2]], [square[0], square[2], square[3]]]
        return np.array(points), np.array(faces)

    def volume_inside(self, points, faces, **options):
        result = dfs.delaunay3(points, faces, inside=True, **options)
        return result.volumes[result.inside].sum(), result

    def test_parts_of_very_different_size(self):
        """A cube between two that are larger by up to 10^300, seen where products of lengths are no doubles."""
        cube, hull = map(np.array, self.cube(2))
        cube, n = 2 * cube - 1, len(cube)
        faces = np.vstack([hull, hull + n, hull + 2 * n])
        for exponent in (-60, -200, -365, -400, -540, -700, -1000):
            ours = dfs.delaunay3(np.vstack([cube - 3, cube + 3, np.ldexp(cube, exponent)]), faces, inside=True)
            part = ours.simplices // n
            self.assertTrue((ours.inside == (part == part[:, :1]).all(axis=1)).all(), exponent)

    def test_volumes(self):
        points, faces = self.cube()
        around = np.concatenate([points, [[4, 4, 4], [-3, -3, -3]]])
        for threads in (1, 2):
            volume, result = self.volume_inside(around, faces, threads=threads)
            self.assertAlmostEqual(volume, 1, 12)
            self.assertLess(np.abs(result.winding_numbers - result.inside).max(), 0.01)
        # With a hole, turned triangles and some twice.
        hurt = np.concatenate([np.delete(faces, [5], axis=0), faces[40:43]])
        hurt[[100, 200]] = hurt[[100, 200], ::-1]
        volume, result = self.volume_inside(around, hurt)
        self.assertAlmostEqual(volume, 1, 12)
        # Inside out, twice as large around it, and pickled.
        self.assertAlmostEqual(self.volume_inside(around, faces[:, ::-1])[0], 1, 12)
        both = np.concatenate([points, 2 * points - 0.5])
        volume, result = self.volume_inside(both, np.concatenate([faces, faces + len(points)]))
        self.assertAlmostEqual(volume, 8, 12)
        self.assertAlmostEqual(result.winding_numbers.max(), 2, 2)
        again = pickle.loads(pickle.dumps(result))
        np.testing.assert_array_equal(again.inside, result.inside)
        # A room in a solid: the inner walls are seen from inside.
        volume, _ = self.volume_inside(both, np.concatenate([faces[:, ::-1], faces + len(points)]))
        self.assertAlmostEqual(volume, 7, 12)

    def test_points_that_no_face_uses(self):
        points, faces = self.cube()
        for far in (1e3, 1e15, 1e100, 1e300):
            volume, result = self.volume_inside(np.concatenate([points, [[far, -far, far / 3]]]), faces)
            self.assertAlmostEqual(volume, 1, 12)
            self.assertEqual(result.inside_figures.number_of_doubtful, 0)

    def test_figures(self):
        """Faces that are turned are counted; where much may be wrong, a warning says so."""
        points, faces = self.cube()
        faces[:20] = faces[:20, ::-1]
        volume, result = self.volume_inside(points, faces)
        self.assertAlmostEqual(volume, 1, 12)
        self.assertEqual(result.inside_figures._replace(missing_area=0), (20, 0, 0, 0, 0, 0, 0))
        self.assertLess(result.inside_figures.missing_area, 1)  # other diagonals of squares
        self.assertEqual(pickle.loads(pickle.dumps(result)).inside_figures, result.inside_figures)
        self.assertIsNone(dfs.delaunay3(points, faces).inside_figures)
        # A star, whose points are joined by long faces that others cross.
        angles = np.arange(200) * (2 * np.pi / 200)
        rim = np.column_stack([np.cos(angles), np.sin(angles), .3 * np.sin(7 * angles)])
        numbers = np.arange(200)
        ends = np.column_stack([numbers + 2, (numbers + 1) % 200 + 2])
        cones = np.concatenate([np.insert(ends, 0, 0, axis=1), np.insert(ends[:, ::-1], 0, 1, axis=1)])
        with self.assertWarnsRegex(UserWarning, "^inside: .* of the volume may be wrong, .*remedy: refine the surface"):
            result = dfs.delaunay3(np.concatenate([[[0, 0, 2], [0, 0, -1]], rim]), cones, inside=True)
        self.assertGreater(result.inside_figures.missing_area, 0.2)
        self.assertGreater(result.inside_figures.crossed_volume, 0.1)

    def test_refusals(self):
        points, faces = self.cube()
        around = np.concatenate([points, [[4, 4, 4], [-3, -3, -3]]])
        for some in (faces[:72], faces[:0]):
            with self.assertRaisesRegex(ValueError, "^the surface has no inside: "):
                dfs.delaunay3(around, some, inside=True)
        with self.assertRaisesRegex(ValueError, "inside: there are no faces"):
            dfs.delaunay3(points, inside=True)
        with self.assertRaisesRegex(ValueError, "there are no tetrahedra"):
            dfs.delaunay3(points[:49], faces[:72], inside=True)
        with self.assertRaisesRegex(ValueError, "it has not been asked for"):
            dfs.delaunay3(points).inside


class StandsForTetraNerf(unittest.TestCase):
    """cpp.triangulate(); PyTorch itself is not there, so what it is asked for is."""

    def test_arrays(self):
        points = random_points(300).astype(np.float32)
        cells = cpp.triangulate(points)
        self.assertEqual((cells.dtype, cells.flags.c_contiguous), (np.int32, True))
        self.assertEqual(cell_set(cells), cell_set(dfs.delaunay3(points).simplices))
        self.assertEqual(cell_set(cpp.triangulate(points, threads=2)), cell_set(cells))
        self.assertEqual(cpp.triangulate(points * np.float32([1, 1, 0])).shape, (0, 4))
        self.assertEqual(cpp.triangulate(points[:0]).shape, (0, 4))
        with self.assertRaises(ValueError):
            cpp.triangulate(points[:, :2])
        if hasattr(np, "from_dlpack"):
            class Exporter:
                def __dlpack__(self, **keywords):
                    return points.__dlpack__(**keywords)

                def __dlpack_device__(self):
                    return points.__dlpack_device__()
            self.assertTrue((cpp.triangulate(Exporter()) == cells).all())

    def test_tensors(self):
        class Tensor:
            def __init__(self, array, device="cpu", is_detached=False):
                self.array, self.device, self.is_detached = array, device, is_detached

            def detach(self):
                return Tensor(self.array, self.device, True)

            def cpu(self):
                return Tensor(self.array, "cpu", self.is_detached)

            def to(self, device):
                return Tensor(self.array, device)

            def numpy(self):
                if self.device != "cpu" or not self.is_detached:
                    raise RuntimeError
                return self.array
        torch = types.SimpleNamespace(Tensor=Tensor, from_numpy=Tensor)
        points = random_points(300).astype(np.float32)
        with unittest.mock.patch.dict(sys.modules, torch=torch):
            cells = cpp.triangulate(Tensor(points, "cuda:0"))
            self.assertIsInstance(cpp.triangulate(points), np.ndarray)
        self.assertIsInstance(cells, Tensor)
        self.assertEqual(cells.device, "cuda:0")
        self.assertTrue((cells.array == dfs.delaunay3(points).simplices).all() and cells.array.flags.writeable)


class Meshes(unittest.TestCase):
    """to_meshio() and to_pyvista(), which are asked for the names that they have; meshio itself where it is there."""

    points = {3: random_points(30).astype(np.float32), 2: random_points(30) * [1, 1, 0], 1: random_points(30) * [1, 0, 0],
              0: np.ones((2, 3)), -1: np.zeros((0, 3))}

    def test_meshio(self):
        names = {3: "tetra", 2: "triangle", 1: "line", 0: "vertex", -1: "vertex"}
        stand_in = types.SimpleNamespace(Mesh=lambda points, cells: types.SimpleNamespace(points=points, cells=cells))
        for dimension, points in self.points.items():
            ours = dfs.delaunay3(points)
            with unittest.mock.patch.dict(sys.modules, meshio=stand_in):
                mesh = ours.to_meshio()
            (name, cells), = mesh.cells
            self.assertFalse(np.shares_memory(mesh.points, points) or np.shares_memory(cells, ours.simplices))
            np.testing.assert_array_equal(mesh.points, points)
            self.assertEqual((ours.dimension, name), (dimension, names[dimension]))
            self.assertTrue(np.array_equal(cells, ours.simplices) and cells.flags.c_contiguous)
        if importlib.util.find_spec("meshio"):
            block, = dfs.delaunay3(self.points[3]).to_meshio().cells
            self.assertEqual((block.type, block.data.shape[1]), ("tetra", 4))

    def test_in_a_box(self):
        """Each tetrahedron has points of its own."""
        ours = dfs.delaunay3(self.points[3], box=(1, 1, 1))
        meshio = types.SimpleNamespace(Mesh=lambda points, cells: (points, cells))
        kinds = types.SimpleNamespace(TETRA=10, TRIANGLE=5, LINE=3)
        pyvista = types.SimpleNamespace(CellType=kinds, UnstructuredGrid=lambda cells, points: (points, cells))
        with unittest.mock.patch.dict(sys.modules, meshio=meshio, pyvista=pyvista):
            for points, cells in (ours.to_meshio(), ours.to_pyvista()):
                cells = cells[10] if isinstance(cells, dict) else dict(cells)["tetra"]
                np.testing.assert_array_equal(points[cells], ours.corners)
                self.assertFalse(np.shares_memory(points, ours.corners))

    def test_vtk(self):
        if not importlib.util.find_spec("vtkmodules"):
            self.skipTest("skipped: VTK was not found")
        from vtkmodules.util.numpy_support import vtk_to_numpy
        for dimension, points in self.points.items():
            for ours in [dfs.delaunay3(points, neighbors=True)] + [dfs.delaunay3(points, box=(9, 9, 9))] * (dimension == 3):
                grid = ours.to_vtk()
                self.assertEqual(grid.GetNumberOfCells(), ours.nsimplex)
                cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(ours.simplices.shape)
                places = vtk_to_numpy(grid.GetPoints().GetData())[cells] if ours.nsimplex else np.zeros((0, 1, 3))
                np.testing.assert_array_equal(places, getattr(ours, "corners", ours.points[ours.simplices]))
                self.assertEqual({grid.GetCellType(c) for c in range(ours.nsimplex)}, {{3: 10, 2: 5, 1: 3, 0: 1}[dimension]}
                                 if ours.nsimplex else set())

    def test_pyvista(self):
        stand_in = types.SimpleNamespace(CellType=types.SimpleNamespace(TETRA=10, TRIANGLE=5, LINE=3, VERTEX=1),
                                         UnstructuredGrid=lambda *arguments: arguments)
        for dimension, points in self.points.items():
            ours = dfs.delaunay3(points, neighbors=True)
            with unittest.mock.patch.dict(sys.modules, pyvista=stand_in):
                grid = ours.to_pyvista()
            if dimension < 0:
                self.assertEqual(grid, ())
                continue
            cells = grid[0][{3: 10, 2: 5, 1: 3, 0: 1}[dimension]]
            self.assertTrue(np.array_equal(cells, ours.simplices) and cells.flags.c_contiguous)
            np.testing.assert_array_equal(grid[1], points)
            self.assertFalse(np.shares_memory(grid[1], points))

    def test_plot(self):
        class Grid:
            def __init__(self, *_):
                pass

            def plot(self, **options):
                return options

        stand_in = types.SimpleNamespace(CellType=types.SimpleNamespace(TETRA=10), UnstructuredGrid=Grid)
        with unittest.mock.patch.dict(sys.modules, pyvista=stand_in):
            ours = dfs.delaunay3(random_points(9))
            self.assertEqual(ours.plot(opacity=.5), {"show_edges": True, "opacity": .5})
            self.assertEqual(ours.plot(show_edges=False), {"show_edges": False})


class Examples(unittest.TestCase):
    def test_run(self):
        for name, line in (("interpolate", "mean error inside the hull: 0.0"), ("show_tetrahedra", "tetrahedra"),
                           ("power_diagram", "add up to 1.000000000"),
                           ("surface", "5000 points, 5000 of them in 10000 triangles; the volume within is 39.2"),
                           ("inside", "tetrahedra are inside; their volume is 25.0727, and that of the surface 25.0727"),
                           ("molecule", "5000 balls: 1520 at the surface, 3071 inside, 409 covered by others"),
                           ("tiles", "tetrahedra of volume 0.999037 in "),
                           ("transport", "2000 cells have the volumes that were asked for, to 1e-10, after")):
            done = subprocess.run([sys.executable, Path(__file__).with_name("examples") / f"{name}.py"],
                                  capture_output=True, text=True, check=True)
            if name != "show_tetrahedra" or "PyVista was not found" in done.stdout:
                self.assertIn(line, done.stdout)


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

        class Tensor:
            def __array__(self, *arguments, **keywords):
                raise RuntimeError("detach it first")
        with self.assertRaisesRegex(TypeError, "^points: expected an array of numbers$") as caught:
            dfs.delaunay3(Tensor())
        self.assertEqual(str(caught.exception.__cause__), "detach it first")
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
        self.refuses(ZeroDivisionError, "by zero", points, ([0, 1, k // (k - 2)] for k in range(3)))
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
        for threads in (0, -1, 65, 100, 2 ** 70):
            self.refuses(ValueError, f"threads: expected a whole number from 1 to 64, or None for all, got {threads}",
                         random_points(5), threads=threads)
        for threads in (1.5, "all", True, False):
            self.refuses(TypeError, f"threads: expected a whole number from 1 to 64, or None for all, got {threads!r}",
                         random_points(5), threads=threads)
        self.refuses(TypeError, "seed: expected a whole number from 0 to 4294967295, got True", random_points(5), seed=True)
        many = dfs.delaunay3(random_points(5), threads=64)
        self.assertEqual(len(many.neighbors), len(many.simplices))
        self.assertTrue((many.find_simplex(many.points, threads=64) >= 0).all())
        with self.assertRaisesRegex(ValueError, "^threads: expected a whole number from 1 to 64"):
            many.find_simplex(many.points, threads=65)

    def test_attributes_that_are_not_set(self):
        """What has been computed from them would not be theirs."""
        result = dfs.delaunay3(random_points(50))
        for name in ("points", "simplices", "vertices", "dimension", "neighbors", "volumes", "circumradii", "winding_numbers", "inside"):
            with self.assertRaises(AttributeError, msg=name):
                setattr(result, name, result.simplices)
        self.assertEqual(len(result.neighbors), len(result.simplices))
        with self.assertRaisesRegex(AttributeError, "neighbors: a triangulation does not change: make another one"):
            result.neighbors = result.simplices
        result.note = "mine"  # what is the caller's

    def test_faces_of_many_kinds(self):
        """The same cells inside, whatever the faces are written in."""
        corners = np.array([[x, y, z] for x in (0., 1) for y in (0., 1) for z in (0., 1)])
        points = np.concatenate([corners, [[4, 4, 4], [-3, 0, 0]]])
        squares = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]], dtype=np.int32)

        class Alike:
            def __array__(self, dtype=None, copy=None):
                return squares

        class Exporter:
            def __dlpack__(self, **keywords):
                return squares.__dlpack__(**keywords)

            def __dlpack_device__(self):
                return squares.__dlpack_device__()
        expected = dfs.delaunay3(points, squares, inside=True)
        self.assertAlmostEqual(expected.volumes[expected.inside].sum(), 1, 12)
        mixed = [*([len(face), *face] for face in squares[1:].tolist()), [3, 0, 1, 3], [3, 0, 3, 2]]
        kinds = {"memoryview": memoryview(squares), "array": Alike(), "lists": squares.tolist(), "VTK": np.insert(squares, 0, 4, axis=1).ravel(),
                 "VTK, narrow": np.insert(squares, 0, 4, axis=1).ravel().astype(np.uint8), "VTK, mixed": np.concatenate(mixed),
                 "generators": (iter(face) for face in squares.tolist())}
        if hasattr(np, "from_dlpack"):
            kinds["DLPack"] = Exporter()
        for name, faces in kinds.items():
            result = dfs.delaunay3(points, faces, inside=True)
            np.testing.assert_array_equal(result.points[result.simplices[result.inside]].sum(axis=(0, 1)),
                                          expected.points[expected.simplices[expected.inside]].sum(axis=(0, 1)), name)
        for faces in (np.array([3, 0, 1]), np.array([0, 0, 1, 2]), np.array([3, 0, 1, 2, 9, 1]), np.array([-3, 0, 1, 2])):
            with self.assertRaisesRegex(ValueError, r"faces: expected an array of shape \(m, k\), got .*nor is it one of VTK's"):
                dfs.delaunay3(points, faces)

    def test_points_of_many_kinds(self):
        points = random_points(40)
        records = np.zeros(40, dtype=[("x", float), ("y", np.float32), ("z", float)])
        exact = points.copy()
        exact[:, 1] = points[:, 1].astype(np.float32)
        for k, name in enumerate("xyz"):
            records[name] = exact[:, k]

        class Exporter:
            def __dlpack__(self, **keywords):
                return exact.__dlpack__(**keywords)

            def __dlpack_device__(self):
                return exact.__dlpack_device__()
        kinds = {"records": records, "generator": (tuple(p) for p in exact), "map": map(list, exact.tolist()), "memoryview": memoryview(exact)}
        if hasattr(np, "from_dlpack"):
            kinds["DLPack"] = Exporter()
        expected = dfs.delaunay3(exact).simplices
        for name, some in kinds.items():
            np.testing.assert_array_equal(dfs.delaunay3(some).simplices, expected, name)
        with self.assertRaisesRegex(ValueError, r"points: expected an array of shape \(n, 3\), got \(40, 2\)"):
            dfs.delaunay3(records[["x", "z"]])

    def test_a_daemon_at_the_end(self):
        """The interpreter ends while a thread of its own is in the middle of a call, and of the next one."""
        program = ("import threading, time, numpy as np, delaunay_from_surface as dfs\n"
                   "p = np.random.default_rng(0).random((30000, 3))\n"
                   "def work():\n"
                   "    while True:\n"
                   "        t = dfs.delaunay3(p, progress={progress}); t.check()\n"
                   "threading.Thread(target=work, daemon=True).start()\n"
                   "time.sleep({sleep})\n")
        # The thread has asked for the lock when the end begins, and is told so while modules are taken down.
        asked = ("import atexit, sys, time\n"
                 "def busy(seconds, now=time.time):\n"
                 "    end = now() + seconds\n"
                 "    while now() < end: pass\n"
                 "class Slow:\n"
                 "    def __del__(self, busy=busy): busy(.4)\n"
                 "sys.slow = Slow()\n"
                 "sys.setswitchinterval(.2)\n"
                 "atexit.register(busy, .15)\n")
        for late in ("", asked):
            for progress, sleep in (("None", .05), ("lambda share: True", .1), ("None", .2), ("lambda share: time.sleep(.05) or True", .1)):
                done = subprocess.run([sys.executable, "-c", late + program.format(progress=progress, sleep=sleep)], capture_output=True, check=False)
                self.assertEqual((done.returncode, done.stderr), (0, b""))

    def test_a_call_at_the_end(self):
        """The thread that ends the interpreter calls the module: it keeps the lock."""
        program = ("import os, sys, numpy as np, delaunay_from_surface as dfs\n"
                   "class Last:\n"
                   "    def __del__(self, t=dfs.delaunay3(np.random.default_rng(0).random((3000, 3))), write=os.write, ends=sys.is_finalizing):\n"
                   "        t.check()\n"
                   "        write(1, b'%d' % ends())\n"
                   "last = Last()\n")
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, check=False, timeout=60)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, b"1", b""))

    def test_files_of_any_name(self):
        """Those whose names are no text, and those that are not there."""
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(os.fsencode(folder), b"p\xff.npy")
            with open(name, "wb") as stream:
                np.save(stream, random_points(300))
            for file in (name, os.fsdecode(name), Path(os.fsdecode(name))):
                self.assertEqual(dfs.delaunay3_tiles(file, os.path.join(folder, "tiles"), tiles=2).report["points"], 300)
            with open(name, "wb") as stream:
                stream.write(b"nothing")
            with self.assertRaisesRegex(OSError, "p\udcff.npy: "):
                dfs.delaunay3_tiles(name, os.path.join(folder, "others"), tiles=2)
            with self.assertRaises(FileNotFoundError) as caught:
                dfs.delaunay3_tiles(os.path.join(folder, "missing.npy"), os.path.join(folder, "none"))
            self.assertIn("missing.npy", str(caught.exception))
            self.assertFalse(os.path.exists(os.path.join(folder, "none")))
        self.refuses(TypeError, "order: expected an InsertionOrder, got int", random_points(5), order=3)
        for seed in (-1, 2 ** 32):
            self.refuses(ValueError, "seed: expected a whole number from 0 to 4294967295", random_points(5), seed=seed)
        self.refuses(TypeError, "seed: expected a whole number from 0 to 4294967295, got 'one'", random_points(5), seed="one")
        for faces in (7, [0, 1, 2]):
            self.refuses(TypeError, "faces: expected sequences of integers", random_points(5), faces, inside=True)
        for number, error in ((-1, ValueError), (2 ** 31, ValueError), (3.5, TypeError)):
            for function in (dfs.subgraph, dfs.surface_topology):
                with self.assertRaisesRegex(error, f"number_of_vertices: expected a whole number from 0 to 2147483647, got {number}"):
                    function([[0, 1, 2]], number)
        flat = dfs.delaunay3(random_points(9) * [1, 1, 0])
        for name in ("transform", "volumes", "circumcenters", "circumradii", "voronoi_volumes"):
            with self.assertRaisesRegex(ValueError, f"{name}: there are no tetrahedra, the points have dimension 2"):
                getattr(flat, name)
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
        with self.assertRaises(dfs.Stopped):  # the last answer counts like the others
            dfs.delaunay3(random_points(300), progress=lambda share: share < 1)
        with self.assertRaises(dfs.Stopped):  # NumPy's False, too, as comparisons make it
            dfs.delaunay3(random_points(20000), progress=lambda share: np.float64(share) < 0)
        for nothing in (None, 0, ""):
            self.assertEqual(dfs.delaunay3(random_points(300), progress=lambda share: nothing).npoints, 300)

    def test_kept_order(self):
        """Of points that move: the same simplices, in the order of the first call."""
        points, random = random_points(3000), np.random.default_rng(5)
        order = dfs.InsertionOrder()
        self.assertEqual(len(order), 0)
        first = dfs.delaunay3(points, order=order)
        np.testing.assert_array_equal(first.simplices, dfs.delaunay3(points).simplices)
        for threads in (1, 1, 2):
            points = points + 1e-3 * random.random(points.shape)
            moved = dfs.delaunay3(points, order=order, threads=threads)
            self.assertEqual((len(order), cell_set(moved.simplices)), (3000, cell_set(dfs.delaunay3(points).simplices)))
        # Other points, other numbers of them, and orders that cost too much.
        self.assertEqual(cell_set(dfs.delaunay3(points[:700], order=order).simplices),
                         cell_set(dfs.delaunay3(points[:700]).simplices))
        self.assertEqual(len(order), 700)
        lines = skew_lines(700)
        self.assertEqual(cell_set(dfs.delaunay3(lines, order=order).simplices), cell_set(dfs.delaunay3(lines).simplices))
        self.assertEqual(len(dfs.delaunay3(np.zeros((0, 3)), order=order).simplices), 0)
        dfs.delaunay3(points, order=order)

        def again(share):
            with self.assertRaisesRegex(ValueError, "order: another call uses it"):
                dfs.delaunay3(points, order=order)
        dfs.delaunay3(points, order=order, progress=again)
        self.assertEqual(repr(order), "<InsertionOrder of 3000 points>")
        with self.assertRaises(TypeError):
            dfs.delaunay3(points, order=[1, 2])

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

    def test_memory(self):
        """One clear line, from every place where memory may end."""
        program = """if True:
            import resource, sys
            import numpy as np, delaunay_from_surface as dfs
            points = np.random.default_rng(1).random((1000000, 3))
            used = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
            for megabytes in (10, 40, 70, 100, 130, 170):
                resource.setrlimit(resource.RLIMIT_AS, (used + megabytes * 2 ** 20, resource.RLIM_INFINITY))
                for threads in (1, 2):
                    try:
                        dfs.delaunay3(points, threads=threads)
                    except MemoryError as error:
                        print(error)
            """
        if not Path("/proc/self/statm").exists():
            self.skipTest("memory is limited on Linux only")
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
        self.assertEqual(done.stderr, "")
        self.assertEqual(set(done.stdout.splitlines()), {"there is not enough memory to triangulate 1000000 points"})

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
        killer = threading.Timer(0.05, os.kill, (os.getpid(), signal.SIGINT))

        def progress(share):
            if not shares:
                killer.start()  # the rest takes some tenths of a second
            shares.append(share)
        with self.assertRaises(KeyboardInterrupt):
            dfs.delaunay3(skew_lines(4000), progress=progress)
            killer.join()
        self.assertLess(shares[-1], 1)

    def test_signals_in_long_calls(self):
        """Signals come every millisecond: who sees them at the end alone sees one."""
        points = random_points(200000)
        t = dfs.delaunay3(points)
        simplex, corner = np.nonzero(t.neighbors < 0)
        others = np.array([[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]])
        faces = t.simplices[simplex[:, None], others[corner]]
        t.vertex_neighbor_vertices, t.find_simplex(points[:1])
        calls = {
            "check": t.check,
            "find_simplex": lambda: t.find_simplex(np.repeat(points, 4, axis=0)),
            "minimum_spanning_tree": t.minimum_spanning_tree,
            "inside": lambda: dfs.delaunay3(points, faces, inside=True),
        }
        for name in ("neighbors", "vertex_neighbor_vertices", "voronoi_volumes", "transform"):
            calls[name] = lambda name=name: getattr(dfs.Delaunay3(points, t.simplices, None, t.vertices, 3), name)
        for name, call in calls.items():
            for raises in (False, True):
                seen = []

                def see(*_):
                    seen.append(name)
                    if raises and len(seen) == 2:
                        raise LookupError(name)

                def call_with_signals():
                    try:
                        signal.setitimer(signal.ITIMER_REAL, .001, .001)
                        call()
                    finally:
                        signal.setitimer(signal.ITIMER_REAL, 0)
                before = signal.signal(signal.SIGALRM, see)
                try:
                    with self.subTest(call=name, raises=raises):
                        if raises:
                            with self.assertRaisesRegex(LookupError, name):
                                call_with_signals()
                        else:
                            call_with_signals()
                            self.assertGreater(len(seen), 1)
                finally:
                    signal.signal(signal.SIGALRM, before)

    def test_cells_that_lie_over_each_other(self):
        """They wind twice around an edge; in a plane, around a vertex."""
        angles = np.radians([0, 115, 235, 355, 475, 590])
        radii = np.array([2, 2.1, 2, 2.2, 2.1, 2.3])
        points = np.vstack([[(0, 0, 1.), (0, 0, -1)], np.c_[radii * np.cos(angles), radii * np.sin(angles), 0 * angles]])
        cells = np.array([(1, 0, 2 + i, 2 + (i + 1) % 6) for i in range(6)], dtype=np.int32)
        twice = dfs.Delaunay3(points, cells, None, np.arange(8, dtype=np.int32), 3)
        self.assertEqual([twice.check(level) for level in ("links", "euler", "orientation", "delaunay")], [True] * 3 + [False])
        points = np.vstack([[(0, 0, 0.)], points[2:]])
        triangles = np.array([(0, 1 + i, 1 + (i + 1) % 6) for i in range(6)], dtype=np.int32)
        self.assertFalse(dfs.Delaunay3(points, triangles, None, np.arange(7, dtype=np.int32), 2).check())
        wrapped = dfs.Delaunay3(points, triangles.astype(np.int64), None, np.arange(7), 2)
        self.assertEqual(wrapped.simplices.dtype, np.int32)
        for wrong in (triangles.astype(np.int64) + 2**32, triangles + .7):
            with self.assertRaisesRegex(ValueError, "^simplices: expected numbers of 32 bits"):
                dfs.Delaunay3(points, wrong, None, np.arange(7, dtype=np.int32), 2)
        with self.assertRaisesRegex(IndexError, "simplices: 6 is not one of the 6 points"):
            dfs.Delaunay3(points[:6], triangles, None, np.arange(6, dtype=np.int32), 2).minimum_spanning_tree()
        for dimension in (2, 3):  # a full turn of many
            points = np.vstack([[(0, 0, 1.), (0, 0, -1)], np.c_[np.cos(angles / 590 * 350), np.sin(angles / 590 * 350), 0 * angles]])
            self.assertTrue(dfs.delaunay3(points if dimension == 3 else points[:, :2] @ np.eye(2, 3)).check())

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

    def test_orientation_does_not_matter(self):
        points, faces = torus()
        faces[::3] = faces[::3, ::-1]
        self.assertEqual(dfs.surface_topology(faces)[0][:6], (960, 2880, 1920, 0, 0, 1))
        band, = dfs.surface_topology([[i, (i + 1) % 5, (i + 2) % 5] for i in range(5)])
        self.assertEqual((band.is_orientable, band.genus, band.number_of_boundary_loops), (False, 1, 1))
        self.assertTrue(dfs.surface_topology(faces)[0].is_orientable)

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


class OutOfCore(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.points = random_points(2000)
        self.file = self.folder / "points.npy"
        np.save(self.file, self.points)

    def test_the_same_as_in_memory(self):
        steps = []
        tiles = dfs.delaunay3_tiles(self.file, self.folder / "tiles", tiles=5, workers=2, vtu=True,
                                    progress=lambda *step: steps.append(step))
        self.assertEqual((len(tiles), tiles.report["points"], tiles.report["certified"]), (5, 2000, True))
        cells = set()
        for k, (points, local) in enumerate(tiles):
            ids = tiles[k].ids
            np.testing.assert_array_equal(points, self.points[ids])
            cells |= cell_set(ids[local])
        self.assertEqual(cells, cell_set(dfs.delaunay3(self.points).simplices))
        self.assertIn(("writing", 5, 5), steps)
        self.assertTrue((self.folder / "tiles/tiles.pvtu").exists())
        with self.assertRaises(IndexError):
            tiles[5]

    def test_several_files_and_float32(self):
        np.save(self.folder / "more.npy", random_points(500, 2).astype(np.float32))
        tiles = dfs.delaunay3_tiles([self.file, str(self.folder / "more.npy")], self.folder / "tiles", memory="1M")
        self.assertEqual(tiles.report["points"], 2500)

    def test_stop_and_go_on(self):
        def stop(what, done, _):
            return not (what == "round 1" and done == 2)
        with self.assertRaises(dfs.Stopped):
            dfs.delaunay3_tiles(self.file, self.folder / "tiles", tiles=4, progress=stop)
        with self.assertRaisesRegex(FileNotFoundError, "tiles.json"):
            dfs.Tiles(self.folder / "tiles")
        with self.assertRaises(ZeroDivisionError):
            dfs.delaunay3_tiles(self.file, self.folder / "tiles", tiles=4, workers=2, progress=lambda *_: 1 / 0)
        whats = []
        dfs.delaunay3_tiles(self.file, self.folder / "tiles", tiles=4, progress=lambda what, *_: whats.append(what))
        self.assertNotIn("round 0", whats)

    def test_refusals(self):
        output = self.folder / "tiles"
        np.save(self.folder / "flat.npy", np.zeros((10, 3)))
        np.save(self.folder / "ints.npy", np.zeros((10, 3), int))
        np.save(self.folder / "nan.npy", np.full((10, 3), np.nan))
        for file, error, says in (("none.npy", OSError, "none.npy"), ("ints.npy", OSError, "float64 and float32"),
                                  ("flat.npy", ValueError, "one plane"), ("nan.npy", ValueError, "point 0")):
            with self.assertRaisesRegex(error, says):
                dfs.delaunay3_tiles(self.folder / file, output / file, tiles=2)
        for name, wrong, error in (("memory", "8X", ValueError), ("memory", 5, ValueError), ("memory", None, TypeError),
                                   ("tiles", 0, ValueError), ("tiles", 2.5, TypeError), ("workers", 0, ValueError),
                                   ("workers", "2", TypeError)):
            with self.assertRaisesRegex(error, f"^{name}: "):
                dfs.delaunay3_tiles(self.file, output, **{name: wrong})
        with self.assertRaisesRegex(ValueError, "^files: the list is empty; name at least one file of points$"):
            dfs.delaunay3_tiles([], output)
        with self.assertRaisesRegex(OSError, "name too long"):
            dfs.delaunay3_tiles(self.file, self.folder / ("x" * 300), tiles=2)
        with self.assertRaisesRegex(MemoryError, "tiles would do"):
            np.save(self.file, random_points(5000))
            dfs.delaunay3_tiles(self.file, output, tiles=1, memory=10**6)
        dfs.delaunay3_tiles(self.file, self.folder / "other", tiles=2)
        with self.assertRaisesRegex(OSError, "2 tiles"):
            dfs.delaunay3_tiles(self.file, self.folder / "other", tiles=3)


class Module(unittest.TestCase):
    def test_needs_no_other_library(self):
        for library in (b"libgmp", b"libmpfr", b"libtbb", b"libboost"):
            self.assertNotIn(library, Path(core.__file__).read_bytes())

    def test_import_is_quick(self):
        """It brings its own modules and what names their types, some milliseconds beside NumPy."""
        program = """if True:
            import sys
            import numpy
            before = set(sys.modules)
            import delaunay_from_surface
            print(*{name.split(".")[0] for name in set(sys.modules) - before})
            """
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
        self.assertLessEqual(set(done.stdout.split()), {"delaunay_from_surface", "numbers", "typing", "_typing"})

    def test_documentation(self):
        self.assertEqual(doctest.testmod(dfs).failed, 0)
        for name in dfs.__all__:
            self.assertTrue(getattr(dfs, name).__doc__, name)
        for function in (dfs.delaunay3, dfs.delaunay3_dask, dfs.delaunay3_tiles, dfs.subgraph, dfs.surface_topology):
            self.assertIn("return", typing.get_type_hints(function))
            self.assertEqual([name for name in inspect.signature(function).parameters
                              if not re.search(rf"\b{name}\b", function.__doc__)], [])
        for kind in (dfs.Delaunay3, dfs.Regular3, dfs.Periodic3, dfs.PeriodicRegular3):
            for name, member in vars(kind).items():
                if not name.startswith("_") and (callable(member) or hasattr(member, "__get__")):
                    self.assertTrue(member.__doc__, name)
        self.assertRegex(dfs.__version__, r"^\d+\.\d+\.\d+$")
        self.assertTrue(Path(dfs.__file__).with_name("py.typed").exists())


class Types(unittest.TestCase):
    """What type checkers are told."""

    def test_stub(self):
        """It has what the extension has, with as many parameters."""
        stub = Path(core.__file__).with_name("_delaunay_from_surface.pyi")
        functions, others = {}, set()
        for node in ast.parse(stub.read_text(encoding="utf-8")).body:
            if isinstance(node, ast.FunctionDef):
                functions[node.name] = len(node.args.args)
            elif isinstance(node, ast.ClassDef):
                others.add(node.name)
        self.assertEqual({name for name in vars(core) if not name.startswith("__")}, set(functions) | others)
        self.assertEqual({name: len(re.findall(r"\barg\d+:", getattr(core, name).__doc__)) for name in functions}, functions)

    def test_checker(self):
        """The package itself, and what users may write; what they may not is found."""
        if importlib.util.find_spec("mypy") is None:
            self.skipTest("mypy was not found")
        program = """if True:
            from typing import List
            import numpy as np
            import delaunay_from_surface as dfs
            from delaunay_from_surface import cpp
            points, shares = np.zeros((5, 3)), [0.]
            dfs.delaunay3([[0, 1, 2], (3., 4, 5)], [[0, 1, 1]], threads=np.int64(2), seed=np.uint8(3))
            ours = dfs.delaunay3(points.astype(np.float32), np.zeros((2, 3), dtype=np.uint16), inside=True, threads=None,
                                 progress=shares.append, order=dfs.InsertionOrder())
            dfs.delaunay3(points, progress=lambda share: share < .5)
            number: int = ours.simplices[0, 0] + ours.neighbors[0, 0] + ours.find_simplex([.5, .5, .5], threads=None)
            weights = ours.barycentric([[.5, .5, .5]], [3]) * ours.volumes[0]
            edges = ours.alpha_complex(np.float32(3)).edges.max() + dfs.subgraph([[0, 1, 2]], np.int64(3))
            power = dfs.delaunay3(points, weights=[1, 2, 3, 4, 5])
            slab = dfs.delaunay3(points, box=(1, 2., None))
            box = dfs.delaunay3(points, box=np.ones(3), weights=[1, 2, 3, 4, 5])
            length: float = slab.box[0] + slab.corners[0, 0, 0] + slab.voronoi_volumes[0] + box.power_facets.areas[0]
            slab.barycentric(points, *slab.find_copies(points)), slab.vertex_neighbor_vertices.offsets[0] + slab.offsets[0, 0]
            size: float = power.power_volumes[0] + power.power_facets.areas[0] + power.alpha_complex(3).vertices[0]
            cpp.triangulate(points, threads=2)
            for some, cells in dfs.delaunay3_tiles("cloud.npy", "tiles", memory="8G"):
                some[cells]
            try:
                print(dfs.__version__, ours.check("links"))
            except dfs.Stopped as stopped:
                print(stopped.args)
            """
        wrong = ['dfs.delaunay3(points, threads="all")', "dfs.delaunay3(points, [1, 2, 3])", "ours.check(3)",
                 "ours.power_volumes", "ours.offsets", "slab.power_volumes", "dfs.delaunay3(points, box=3)", "ours.simplices.no_such_member", "ours.points = 3", "dfs.no_such_function()"]
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "user.py"
            file.write_text("\n".join([textwrap.dedent(program.replace("if True:\n", "", 1)), *wrong]), encoding="utf-8")
            settings = Path(folder) / "mypy.ini"  # what Dask's own types say differs from one version to the next
            settings.write_text("[mypy]\n[mypy-dask.*,distributed.*]\nfollow_imports = skip\n", encoding="utf-8")
            checker = [sys.executable, "-m", "mypy", "--config-file", settings, "--strict", "--no-warn-return-any",
                       "--ignore-missing-imports", "--cache-dir", folder]
            done = subprocess.run([*checker, file], capture_output=True, text=True, cwd=folder, check=False)
            found = {int(line.split(":")[1]) for line in done.stdout.splitlines() if ": error:" in line}
            first = len(file.read_text(encoding="utf-8").splitlines()) - len(wrong) + 1
            self.assertEqual(found, set(range(first, first + len(wrong))), done.stdout + done.stderr)
            done = subprocess.run([*checker, Path(dfs.__file__).parent], capture_output=True, text=True, cwd=folder, check=False)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
