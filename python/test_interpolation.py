# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""Tests the interpolators of the installed module: against SciPy, exact arithmetic, and linear functions."""

import doctest
import itertools
import pickle
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from fractions import Fraction
from pathlib import Path

import numpy as np
import scipy.interpolate

import delaunay_from_surface as dfs
from delaunay_from_surface import _interpolation
from test_module import flat_sets, random_points, skew_lines, turned_lattice

HERE = Path(__file__).resolve().parent
BOTH = (dfs.LinearInterpolator, dfs.NaturalNeighborInterpolator)


def linear(x):
    return x @ [1., -2., 3.]


def crystal(basis, n=4):
    """Cells of a cubic lattice, with atoms at `basis` in each."""
    cells = np.array(list(itertools.product(range(n), repeat=3)), dtype=float)
    return (cells[:, None] + np.array(basis)).reshape(-1, 3)


def sets():
    """Points that are hard to interpolate between, of ordinary size."""
    turn = np.linalg.qr(random_points(3))[0]
    kinds = {name: points for name, points in flat_sets().items() if name not in ("tiny", "denormal", "huge", "scales")}
    fcc = crystal([[0, 0, 0], [0, .5, .5], [.5, 0, .5], [.5, .5, 0]], 3)
    return {**kinds, "axis-parallel": crystal([[0, 0, 0]]), "fcc": fcc @ turn,
            "bcc": crystal([[0, 0, 0], [.5, .5, .5]], 3), "UTM": turned_lattice(4) + [5e5, 4.6e6, 100],
            "clusters": np.vstack([random_points(20), .5 + random_points(20, 2) * 1e-7,
                                   .3 + random_points(9, 3) * 1e-14])}


def inside_of(triangulation, n, seed=1):
    """Points in tetrahedra, up to rounding, also near corners, edges and facets."""
    rng = np.random.default_rng(seed)
    weights = rng.random((n, 4)) ** rng.choice([1, 9, 90], (n, 1))
    simplices = triangulation.simplices[rng.integers(0, triangulation.nsimplex, n)]
    corners = np.asarray(triangulation.points, float)[simplices]
    return np.einsum("ij,ijk->ik", weights / weights.sum(axis=1)[:, None], corners)


def subtract(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def circumcenter(a, b, c):
    """Of a tetrahedron with its first corner at 0."""
    normals = cross(b, c), cross(c, a), cross(a, b)
    return [sum(dot(p, p) * n[i] for p, n in zip((a, b, c), normals)) / (2 * dot(a, normals[0])) for i in range(3)]


def exact_weights(points, q):
    """Laplace's, as fractions: q is inserted, and the facets of its Voronoi cell are polygons of circumcentres. None on
    the hull, where some are unbounded."""
    n = len(points)
    made = dfs.delaunay3(np.vstack([points, [q]]))
    if (made.convex_hull == n).any():
        return None
    origin = [Fraction(x) for x in map(float, q)]
    at = {}  # for each natural neighbour i: its tetrahedra (q, i, j, k), by j
    for simplex in made.simplices[(made.simplices == n).any(axis=1)].tolist():
        place = simplex.index(n)
        a, b, c = (simplex[i] for i in ((1, 2, 3), (2, 0, 3), (0, 1, 3), (2, 1, 0))[place])
        center = circumcenter(*(subtract([Fraction(x) for x in map(float, points[v])], origin) for v in (a, b, c)))
        for i, j, k in ((a, b, c), (b, c, a), (c, a, b)):
            at.setdefault(i, {})[j] = k, center
    weights = {}
    for i, around in at.items():
        edge = subtract([Fraction(x) for x in map(float, points[i])], origin)
        twice = sum(dot(edge, cross(center, around[k][1])) for k, center in around.values())
        weights[i] = abs(twice) / dot(edge, edge)
    total = sum(weights.values())
    result = np.zeros(n)
    for i, weight in weights.items():
        result[i] = float(weight / total)
    return result


class Interpolators(unittest.TestCase):
    def test_data(self):
        for name, points in sets().items():
            values = np.random.default_rng(4).normal(size=(len(points), 2)) + 1e5
            made = dfs.delaunay3(points)
            for kind in BOTH:
                with self.subTest(name, kind=kind.__name__):
                    np.testing.assert_array_equal(kind(made, values)(points), values[made.vertices])

    def test_linear_functions(self):
        for name, points in sets().items():
            made = dfs.delaunay3(points)
            xi = np.vstack([inside_of(made, 300), points[made.simplices[:50, :2]].mean(axis=1, dtype=float)])
            is_inside = made.find_simplex(xi) >= 0
            self.assertGreater(is_inside.sum(), 200)
            expected, size = linear(xi), np.ptp(linear(points)) + 8 * np.spacing(np.abs(linear(points)).max()) / 1e-12
            for kind in BOTH:
                with self.subTest(name, kind=kind.__name__):
                    found = kind(made, linear(np.asarray(points, float)))(xi)
                    np.testing.assert_array_equal(np.isnan(found), ~is_inside)
                    self.assertLess(np.abs(found - expected)[is_inside].max(), 1e-12 * size)

    def test_scipy(self):
        points, xi = random_points(500), random_points(2000, 2)
        values = np.random.default_rng(5).normal(size=(500, 2, 3))
        for given in (values[:, 0, 0], values, values + 1j * values[:, ::-1], values.astype(np.float32)):
            for fill in (np.nan, -7):
                theirs = scipy.interpolate.LinearNDInterpolator(points, given, fill)
                ours = dfs.LinearInterpolator(points, given, fill)
                for arguments in ((xi,), (xi.reshape(20, 100, 3),), tuple(xi.T), (xi[:9, :1], xi[:5, 0], .5),
                                  (tuple(xi[:3].T),), (.5, .5, .5), ([.5, .5, .5],), (np.zeros((0, 3)),)):
                    expected, found = theirs(*arguments), ours(*arguments)
                    self.assertEqual((expected.shape, expected.dtype), (found.shape, found.dtype))
                    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12)

    def test_values_that_are_not_finite(self):
        points = crystal([[0, 0, 0]], 3)
        values = np.where(points[:, 0] < 2, 1, np.nan)
        for kind in BOTH:
            found = kind(points, values)([[.5, .5, .5], [1, 1, 1], [1, .5, .75], [1.5, 1, 1], [2, 2, 2]])
            expected = [1, 1, 1, np.nan, np.nan]
            if kind is dfs.NaturalNeighborInterpolator:
                expected[2] = np.nan  # the points at x = 2 are its neighbours
            np.testing.assert_array_equal(found, expected)
            queries = np.full((4, 3), .5)
            queries[[0, 1, 2], [0, 1, 2]] = np.nan, np.inf, -np.inf
            for outside in ("fill", "nearest"):
                found = kind(points, np.ones(27), -7, outside=outside)(queries)
                np.testing.assert_array_equal(found, [np.nan] * 3 + [1])

    def test_values_without_weight(self):
        """On a facet the fourth corner has none, and in a lattice those in a plane with no Voronoi edge."""
        points = 3 * np.floor(random_points(60) * 2**20)  # a third of a sum is a double
        made = dfs.delaunay3(points)
        for k in range(4):
            corners = np.delete(made.simplices, k, axis=1)
            values = np.full((len(points), len(corners)), np.nan)
            values[corners.T, np.arange(len(corners))] = 1
            found = dfs.LinearInterpolator(made, values)(points[corners].sum(axis=1) / 3)
            np.testing.assert_array_equal(np.isnan(np.diag(found)), False)
            np.testing.assert_allclose(np.diag(found), 1, atol=1e-12)
        corners = 1e300 * np.vstack([np.zeros(3), np.eye(3)])
        self.assertEqual(dfs.LinearInterpolator(corners, [0, np.inf, 0, 0], np.array(7.))([1e-100, 0, 0]), np.inf)
        lattice = .1 * crystal([[0, 0, 0]])
        for centre in itertools.product((1, 2), repeat=3):
            x = .1 * np.array(centre)
            values = np.where(np.abs(lattice - x).max(axis=1) < .05, 1, np.nan)
            for kind in BOTH:
                np.testing.assert_array_equal(kind(lattice, values)([x]), [1])
        unit = 2**40 + 12345  # a query on the sphere of a cell, with more digits than products have
        lattice, x = 10. * unit * crystal([[0, 0, 0]]), unit * np.array([12., 10, 6])
        weights = exact_weights(lattice, x)
        is_on_sphere = (np.abs(lattice - 5 * unit).max(axis=1) == 5 * unit) & (weights == 0)
        self.assertGreater(is_on_sphere.sum(), 0)
        np.testing.assert_allclose(dfs.NaturalNeighborInterpolator(lattice, np.where(is_on_sphere, np.nan, 1))([x]), 1)
        box = dfs.delaunay3(crystal([[0, 0, 0]]), box=(4, 4, 4))
        found = dfs.LinearInterpolator(box, np.where(box.points[:, 0] == 3, 1, np.inf))([[-1, .5, .25], [3, 9.25, .75], [3.5, 0, 0]])
        np.testing.assert_array_equal(found, [1, 1, np.inf])

    def test_signs_of_zeros(self):
        for points in (random_points(50), dfs.delaunay3(random_points(50), box=(1, 1, 1))):
            for kind in BOTH[:1 if isinstance(points, dfs.Periodic3) else 2]:
                found = kind(points, np.full(50, -0.))(random_points(50))
                self.assertTrue(np.signbit(found).all() and (found == 0).all())

    def test_tensors(self):
        """What NumPy does not read itself."""
        class Dlpack:
            def __init__(self, array):
                self._array = array

            def __dlpack__(self, **arguments):
                return self._array.__dlpack__(**arguments)

            def __dlpack_device__(self):
                return self._array.__dlpack_device__()

        points, xi = random_points(50), random_points(50, 2)
        for kind in BOTH:
            made = kind(Dlpack(points), Dlpack(linear(points)))
            np.testing.assert_array_equal(made(Dlpack(xi)), made(xi))
            np.testing.assert_array_equal(made(*map(Dlpack, np.ascontiguousarray(xi.T))), made(xi))

    def test_equal_points(self):
        points = np.vstack([random_points(50), random_points(50)])
        made = dfs.delaunay3(points)
        for kind in BOTH:
            found = kind(made, np.r_[:50, [np.nan] * 50])(points + 1e-3)
            np.testing.assert_array_equal(np.isnan(found), made.find_simplex(points + 1e-3) < 0)
            np.testing.assert_array_equal(kind(made, np.r_[:50, [np.nan] * 50])(points), np.r_[:50, :50])

    def test_nearest(self):
        lattice = crystal([[0, 0, 0]])
        on_lattice = np.array(list(itertools.product(np.arange(-2, 6, .5), repeat=3)))
        cases = [(random_points(200), 3 * random_points(500, 2) - 1), (lattice, on_lattice),
                 (skew_lines(60), 4 * on_lattice), (random_points(9) + 1e8, 2e8 * random_points(50)),
                 (lattice * 2. ** 900, on_lattice * 2. ** 900), (lattice * 2. ** -900, on_lattice * 2. ** -900),
                 (turned_lattice(3).astype(np.float32), 1e8 * random_points(50))]
        for points, xi in cases:
            distances = [[sum((Fraction(a) - Fraction(b)) ** 2 for a, b in zip(p, x)) for p in points.tolist()]
                         for x in xi[::7].tolist()]
            expected = [row.index(min(row)) for row in distances]
            made = dfs.delaunay3(points)
            is_outside = made.find_simplex(xi[::7]) < 0
            self.assertTrue(is_outside.any())
            for kind in BOTH:
                found = kind(made, np.arange(len(points)), outside="nearest")(xi[::7])
                others = kind(made, np.arange(len(points)))(xi[::7])
                np.testing.assert_array_equal(found, np.where(is_outside, expected, others))

    def test_threads(self):
        points, xi = random_points(300), 1.2 * random_points(5000, 2)
        for kind in BOTH:
            for outside in ("fill", "nearest"):
                one, many = (kind(points, points, outside=outside, threads=threads)(xi) for threads in (1, 5))
                np.testing.assert_array_equal(one, many)

    def test_interrupt(self):
        """Ctrl-C is seen within a call."""
        made = dfs.NaturalNeighborInterpolator(random_points(1000), np.arange(1000))
        xi = random_points(2000000, 2)
        previous = signal.signal(signal.SIGALRM, lambda *_: (_ for _ in ()).throw(KeyboardInterrupt))
        try:
            signal.setitimer(signal.ITIMER_REAL, .5)
            with self.assertRaises(KeyboardInterrupt):
                made(xi)
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, previous)

    def test_pickle_and_repr(self):
        for kind in BOTH:
            made = kind(random_points(50), np.arange(50), -1, outside="nearest")
            again = pickle.loads(pickle.dumps(made))
            np.testing.assert_array_equal(made(random_points(50, 2)), again(random_points(50, 2)))
            self.assertEqual(repr(made), f"<{kind.__name__}: float64 (50,) on {made.triangulation!r}>")

    def test_refused(self):
        points, plane = random_points(20), random_points(20) * [1, 1, 0]
        for kind in BOTH:
            for error, message, *arguments in (
                    (ValueError, r"there are no tetrahedra, the points have dimension 2", plane, np.ones(20)),
                    (ValueError, r"there are no tetrahedra, the points have dimension -1", [], []),
                    (ValueError, r"values: .*shape \(20, …\), one for each point, got \(19,\)", points, np.ones(19)),
                    (ValueError, r"values: .*got \(\)", points, 1.),
                    (TypeError, "values: .*type object", points, [None] * 20),
                    (TypeError, "values: .*type <U1", points, ["a"] * 20),
                    (ValueError, "points: .*got", points[:, :2], np.ones(20)),
                    (ValueError, "values: a masked array", points, np.ma.masked_array(np.ones(20), np.arange(20) == 3)),
                    (ValueError, "values: a masked array", points, [np.ma.masked] * 20),
                    (TypeError, "fill_value: expected a real number", points, np.ones(20), 1j),
                    (TypeError, "fill_value: expected a real number, .* got '3'", points, np.ones(20), "3"),
                    (TypeError, "fill_value: expected a number, .* got None", points, np.ones(20) * 1j, None),
                    (ValueError, "fill_value: 1000.* too large", points, np.ones(20), 10**400),
                    (ValueError, "fill_value: .* too large", points, np.ones(20), np.longdouble("1e4000"))):
                with self.assertRaisesRegex(error, message):
                    kind(*arguments)
            with self.assertRaisesRegex(ValueError, "outside: expected .* got 'linear'"):
                kind(points, np.ones(20), outside="linear")
            with self.assertRaisesRegex(ValueError, "threads"):
                kind(points, np.ones(20), threads=0)
            made = kind(points, np.ones(20))
            for error, message, *arguments in (
                    (ValueError, r"xi: .*got \(2,\)", [.5, .5]), (ValueError, r"xi: .*got \(4, 2\)", np.ones((4, 2))),
                    (TypeError, "xi: .*got 2 arguments", 1, 2), (TypeError, "xi: .*complex128", 1, 2, 1j),
                    (ValueError, "xi: a masked array", np.ma.masked_array(points, points < .5)),
                    (ValueError, "xi: a masked array", [np.ma.masked_array([1, 1, 1.], [1, 0, 0])]),
                    (ValueError, "broadcast", [1, 2], [1, 2, 3], 1)):
                with self.assertRaisesRegex(error, message):
                    made(*arguments)


class Linear(unittest.TestCase):
    def test_flat_tetrahedra(self):
        """Where SciPy's is NaN: in a lattice far away, at some of its points, too; and in a sheet."""
        turn = np.linalg.qr(random_points(3))[0]
        lattice, far = crystal([[0, 0, 0]], 8), [5e5, 4.6e6, 100]
        for points, xi in ((lattice @ turn + far, (.01 + 6.98 * random_points(5000, 2)) @ turn + far),
                           (random_points(2000) * [1, 1, 1e-9] @ turn, None)):
            values = np.random.default_rng(6).random(len(points))
            made = dfs.LinearInterpolator(points, values)
            xi = inside_of(made.triangulation, 5000) if xi is None else xi
            found = made(xi)
            is_outside = made.triangulation.find_simplex(xi) < 0
            self.assertLess(is_outside.mean(), .01)
            np.testing.assert_array_equal(np.isnan(found), is_outside)
            self.assertGreater(found[~is_outside].min(), values.min() - 1e-12)
            self.assertLess(found[~is_outside].max(), values.max() + 1e-12)

    def test_scales(self):
        for name, points in flat_sets().items():
            made = dfs.delaunay3(points)
            simplex = made.find_simplex(points)
            self.assertTrue((simplex >= 0).all(), name)
            np.testing.assert_array_equal(dfs.LinearInterpolator(made, np.arange(len(points)))(points), made.vertices)

    def test_gradients(self):
        points, xi = random_points(100), random_points(400, 2)
        values = np.random.default_rng(7).normal(size=(100, 2)) + [0, 1j]
        made = dfs.LinearInterpolator(points, values)
        gradients = made.gradients(xi.reshape(20, 20, 3))
        self.assertEqual((gradients.shape, gradients.dtype), ((20, 20, 2, 3), np.complex128))
        gradients = gradients.reshape(400, 2, 3)
        simplex = made.triangulation.find_simplex(xi)
        self.assertTrue(np.isnan(gradients[simplex < 0]).all())
        corners = made.triangulation.simplices[simplex]
        edges = points[corners[:, 1:]] - points[corners[:, :1]]
        differences = values[corners[:, 1:]] - values[corners[:, :1]]
        found = np.einsum("qei,qvi->qev", edges, gradients)[simplex >= 0]
        np.testing.assert_allclose(found, differences[simplex >= 0], atol=1e-10)
        of_linear = dfs.LinearInterpolator(points, linear(points)).gradients(.5, .5, .5)
        np.testing.assert_allclose(of_linear, [1, -2, 3], atol=1e-11)
        self.assertEqual(made.gradients(np.zeros((0, 3))).shape, (0, 2, 3))
        xi[0, 1] = np.nan
        self.assertTrue(np.isnan(made.gradients(xi)[0]).all())
        tiny = dfs.LinearInterpolator(2.**-1040 * crystal([[0, 0, 0]]), np.ones(64))
        np.testing.assert_array_equal(tiny.gradients(2.**-1040, 2.**-1040, 2.**-1040), [0, 0, 0])

    def test_boxes(self):
        points = 10 * random_points(300) - 3
        values = np.random.default_rng(8).normal(size=(300, 2))
        copies = np.array(list(itertools.product(range(-1, 2), repeat=3)))
        images = (points % 2 + 2 * copies[:, None]).reshape(-1, 3)
        expected = dfs.LinearInterpolator(images, np.tile(values, (27, 1)))
        made = dfs.LinearInterpolator(dfs.delaunay3(points, box=(2, 2, 2)), values, threads=2)
        xi = 20 * random_points(2000, 3) - 10
        np.testing.assert_allclose(made(xi), expected(xi % 2), atol=1e-9)
        np.testing.assert_allclose(made.gradients(xi), expected.gradients(xi % 2), rtol=1e-6, atol=1e-6)
        np.testing.assert_allclose(made(points), values, atol=1e-12)
        np.testing.assert_array_equal(made.gradients(xi % 2), made.gradients(xi % 2 + 2. ** 28))
        with self.assertRaisesRegex(ValueError, "xi: point 2 is .*periods"):
            made([[.5, np.nan, .5], [.5, .5, .5], [1e10, .5, .5]])
        xi[5] = np.inf
        self.assertTrue(np.isnan(made(xi)[5]).all() and np.isfinite(np.delete(made(xi), 5, 0)).all())
        turned = .1 * crystal([[0, 0, 0]], 6) @ np.array([[2, -1, 2], [2, 2, -1], [-1, 2, 2]]) / 3 + 100.123
        of, heights = dfs.delaunay3(turned, box=(.6, .6, .6)), random_points(216)[:, 0]
        found, corners = dfs.LinearInterpolator(of, heights).gradients(turned), of.simplices[of.find_simplex(turned)]
        for gradient, v, offsets in zip(found, corners, of.offsets[of.find_simplex(turned)]):
            a, b, c, d = ([Fraction(x) + int(by) * Fraction(.6) for x, by in zip(turned[u], o)] for u, o in zip(v, offsets))
            b, c, d = (subtract(x, a) for x in (b, c, d))
            steps = [Fraction(heights[u] - heights[v[3]]) - Fraction(heights[v[0]] - heights[v[3]]) for u in v[1:]]
            normals = cross(c, d), cross(d, b), cross(b, c)
            expected = [float(sum(step * n[i] for step, n in zip(steps, normals)) / dot(b, normals[0])) for i in range(3)]
            np.testing.assert_allclose(gradient, expected, rtol=0, atol=1e-9 * np.abs(expected).max())
        slab = dfs.LinearInterpolator(dfs.delaunay3(points, box=(2, 2, None)), linear(points * [0, 0, 1]), -7)
        np.testing.assert_allclose(slab([[99, -99, 0], [1, 1, 99]]), [0, -7], atol=1e-12)
        np.testing.assert_allclose(slab.gradients([99, -99, 0]), [[0, 0, 3]], atol=1e-9)
        self.assertTrue(np.isnan(slab.gradients([99, -99, 99])).all())
        with self.assertRaisesRegex(ValueError, "outside: .*periodic boxes"):
            dfs.LinearInterpolator(slab.triangulation, values, outside="nearest")
        with self.assertRaisesRegex(ValueError, "not made for periodic boxes: use LinearInterpolator"):
            dfs.NaturalNeighborInterpolator(slab.triangulation, values)

    def test_weights(self):
        points, weights = random_points(300), random_points(300, 2)[:, 0] ** 9 * .1
        made = dfs.delaunay3(points, weights=weights)
        self.assertGreater(len(made.hidden), 0)
        values = linear(points)
        values[made.hidden] = np.nan
        xi = inside_of(made, 300)
        expected = np.where(made.find_simplex(xi) < 0, np.nan, linear(xi))
        np.testing.assert_allclose(dfs.LinearInterpolator(made, values)(xi), expected, atol=1e-12)
        with self.assertRaisesRegex(ValueError, "outside: .*weights"):
            dfs.LinearInterpolator(made, values, outside="nearest")
        with self.assertRaisesRegex(ValueError, "not made for points with weights: use LinearInterpolator"):
            dfs.NaturalNeighborInterpolator(made, values)


class NaturalNeighbors(unittest.TestCase):
    def test_exact_weights(self):
        checked = 0
        for name, points in sets().items():
            with self.subTest(name):
                made = dfs.delaunay3(points)
                places = np.asarray(points, float)
                xi = inside_of(made, 6 if name == "sphere" else 30)
                for x, weights in zip(xi, dfs.NaturalNeighborInterpolator(made, np.eye(len(points)))(xi)):
                    is_vertex = (places == x).all(axis=1).any()
                    expected = None if np.isnan(weights).any() or is_vertex else exact_weights(places, x)
                    if expected is not None:
                        checked += 1
                        np.testing.assert_allclose(weights, expected, rtol=0, atol=1e-13)
        self.assertGreater(checked, 200)

    def test_near_data(self):
        """Weights tend to 1 and 0, at all distances."""
        points = turned_lattice(4)
        made = dfs.NaturalNeighborInterpolator(points, np.eye(64))
        for distance in 10. ** -np.arange(1, 17):
            xi = points[np.linalg.norm(points - points.mean(axis=0), axis=1) < 1] + [distance, distance / 2, 0]
            found = made(xi)
            self.assertLess(1 - found.max(axis=1).min(), 20 * distance)
            for x, weights in zip(xi[:2], found):
                if not (points == x).all(axis=1).any():
                    np.testing.assert_allclose(weights, exact_weights(points, x), rtol=0, atol=1e-13)

    def test_scales(self):
        """Powers of 2 change nothing; and points of all sizes have weights."""
        points = turned_lattice(3)
        made = dfs.delaunay3(points)
        xi = inside_of(made, 50)
        expected = dfs.NaturalNeighborInterpolator(made, np.eye(27))(xi)
        for exponent in (-900, -300, 300, 1000):
            found = dfs.NaturalNeighborInterpolator(np.ldexp(points, exponent), np.eye(27))(np.ldexp(xi, exponent))
            np.testing.assert_array_equal(found, expected)
        for name in ("scales", "tiny", "denormal", "huge"):
            points = flat_sets()[name]
            made = dfs.delaunay3(points)
            xi = inside_of(made, 20)
            for x, weights in zip(xi, dfs.NaturalNeighborInterpolator(made, np.eye(len(points)))(xi)):
                is_vertex = (points == x).all(axis=1).any()
                expected = None if np.isnan(weights).any() or is_vertex else exact_weights(points, x)
                if expected is not None:
                    np.testing.assert_allclose(weights, expected, rtol=0, atol=1e-13, err_msg=name)

    def test_hull(self):
        """Where the cell is unbounded weights are the limits from inside."""
        rng = np.random.default_rng(9)
        face = rng.random((30, 3)) * [1, 1, 0]
        points = np.vstack([face, [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], random_points(30) + [0, 0, .1]])
        made = dfs.NaturalNeighborInterpolator(points, np.eye(len(points)))
        on_hull = rng.random((40, 3)) * [.8, .8, 0] + [.1, .1, 0]
        for x, weights in zip(on_hull, made(on_hull)):
            np.testing.assert_allclose(exact_weights(points, x + [0, 0, 1e-9]), weights, rtol=0, atol=1e-6)
            np.testing.assert_allclose(exact_weights(points, x + [0, 0, 1e-100]), weights, rtol=0, atol=1e-13)
            np.testing.assert_allclose(made([x + [0, 0, 1e-100]])[0], weights, rtol=0, atol=1e-13)
        turned = dfs.NaturalNeighborInterpolator(points[:, [2, 0, 1]], np.eye(len(points)))
        np.testing.assert_allclose(turned(on_hull[:, [2, 0, 1]]), made(on_hull), rtol=0, atol=1e-13)
        lattice = crystal([[0, 0, 0]])
        made = dfs.NaturalNeighborInterpolator(lattice, np.eye(64))
        edges = made([[.25, 0, 0], [3, 1.5, 3]])
        np.testing.assert_allclose(edges[0, [0, 16]], [.75, .25], atol=1e-15)
        np.testing.assert_allclose(edges[1, [55, 59]], [.5, .5], atol=1e-15)
        self.assertEqual(np.count_nonzero(edges), 4)
        grid = np.array(list(itertools.product(np.arange(0, 3.1, .25), repeat=3)))
        found = made(grid)
        self.assertFalse(np.isnan(found).any())
        np.testing.assert_allclose(found @ lattice, grid, atol=1e-14)
        self.assertGreaterEqual(found.min(), -1e-15)
        centres = np.flatnonzero((grid % 1 == .5).all(axis=1) & (grid < 3).all(axis=1))
        np.testing.assert_allclose(np.sort(found[centres], axis=1)[:, -8:], .125, atol=1e-15)

    def test_hull_of_denormal_numbers(self):
        lattice, unit = crystal([[0, 0, 0]]), 5e-324
        for spacing, shift in ((2, 1), (4, 2), (13, 7), (1, 0)):
            made = dfs.NaturalNeighborInterpolator(spacing * unit * lattice, linear(lattice))
            xi = unit * np.array([[shift, 0, 0], [0, shift, 3 * spacing], [3 * spacing, 0, shift]])
            np.testing.assert_allclose(made(xi), linear(xi / unit / spacing), rtol=0, atol=1e-12)
        for large in (1e300, 1e305, 1.7e308):  # along another axis
            for height, q, expected in ((2, 1, .5), (4, 2, .5), (8, 3, .375), (40, 13, .325)):
                points = [(large, 0, 0), (large, height * unit, 0), (0, 0, 0), (0, 0, 1e305)]
                made = dfs.NaturalNeighborInterpolator(points, [0, 1, 5, 7])
                self.assertAlmostEqual(made([(large, q * unit, 0)])[0], expected, 12)
        huge = dfs.NaturalNeighborInterpolator(2.**1022 * (lattice - 1.5), linear(lattice))
        np.testing.assert_allclose(huge([[-2.**1022, -1.5 * 2.**1022, 1.5 * 2.**1022]]), linear(np.array([.5, 0, 3])))

    def test_interrupt_in_large_zones(self):
        """Ctrl-C is seen while few queries have very many neighbours."""
        sphere = random_points(20000) - .5
        sphere /= np.linalg.norm(sphere, axis=1)[:, None]
        made = dfs.NaturalNeighborInterpolator(sphere, sphere[:, 0])
        previous = signal.signal(signal.SIGALRM, lambda *_: (_ for _ in ()).throw(KeyboardInterrupt))
        try:
            signal.setitimer(signal.ITIMER_REAL, .3)
            begin = time.monotonic()
            with self.assertRaises(KeyboardInterrupt):
                made(.1 * random_points(250))
            self.assertLess(time.monotonic() - begin, 5)  # all would take half a minute
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, previous)

    def test_many_neighbors(self):
        """Of a point between two skew lines all points are neighbours."""
        points = skew_lines(160)
        found = dfs.NaturalNeighborInterpolator(points, np.eye(160))([[.31, .42, .5], [.01, .29, .3]])
        for weights, x in zip(found, [[.31, .42, .5], [.01, .29, .3]]):
            np.testing.assert_allclose(weights @ points, x, atol=1e-12)
            self.assertGreater(weights.min(), -1e-15)


class Examples(unittest.TestCase):
    def test_documentation(self):
        self.assertEqual(doctest.testmod(_interpolation), (0, 8))

    def test_example(self):
        if not (HERE / "examples").is_dir():
            self.skipTest("the examples are not there")
        printed = subprocess.run([sys.executable, "-B", HERE / "examples/interpolate.py"], check=True,
                                 capture_output=True, text=True, cwd=tempfile.gettempdir()).stdout
        self.assertRegex(printed, "mean error inside the hull: 0.0")


if __name__ == "__main__":
    unittest.main()
