# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""Tests filtration() of the installed module, against rational arithmetic and against GUDHI."""

import itertools
import subprocess
import sys
import threading
import unittest
from fractions import Fraction
from pathlib import Path

import numpy as np

import delaunay_from_surface as dfs
from test_module import flat_sets, random_points, turned_lattice

try:
    import gudhi
except ImportError:
    gudhi = None
    print("skipped: comparisons with GUDHI, which was not found")


def values_of(filtration):
    """Values by vertices."""
    return {tuple(row): value for rows, values in zip(filtration.simplices, filtration.values)
            for row, value in zip(rows.tolist(), values.tolist())}


def simplices_in_order(filtration):
    all_of_them = [tuple(row) for rows in filtration.simplices for row in rows.tolist()]
    return [all_of_them[place] for place in filtration.order]


def solved(rows):
    """The solution of linear equations, by elimination, in fractions."""
    n = len(rows)
    for k in range(n):
        pivot = next(i for i in range(k, n) if rows[i][k] != 0)
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [x / rows[k][k] for x in rows[k]]
        for i in range(n):
            if i != k:
                rows[i] = [x - rows[i][k] * y for x, y in zip(rows[i], rows[k])]
    return [row[n] for row in rows]


class Smallest:
    """The smallest sphere orthogonal to those around points, exactly."""

    def __init__(self, points, weights):
        a, edges = points[0], [[x - y for x, y in zip(p, points[0])] for p in points[1:]]
        gram = [[sum(x * y for x, y in zip(e, f)) for f in edges] + [(sum(x * x for x in e) + weights[0] - w) / 2]
                for e, w in zip(edges, weights[1:])]
        self.center = [x + sum(t * e[i] for t, e in zip(solved(gram), edges)) for i, x in enumerate(a)]
        self.square = sum((x - y) ** 2 for x, y in zip(self.center, a)) - weights[0]

    def is_inside(self, point, weight):
        return sum((x - y) ** 2 for x, y in zip(self.center, point)) - weight < self.square


def exact_values(simplices, points, weights):
    """The values of all faces, by their definition: the points inside are looked for among all."""
    points = [[Fraction(x) for x in p] for p in points.tolist()]
    weights = [Fraction(w) for w in weights.tolist()]
    levels = [{tuple(sorted(row)) for row in simplices.tolist()}]
    while len(next(iter(levels[0]))) > 1:
        levels.insert(0, {face for s in levels[0] for face in itertools.combinations(s, len(s) - 1)})
    exact = {}
    for level in reversed(levels):
        least = {}
        for coface, value in exact.items():
            if len(coface) == len(next(iter(level))) + 1:
                for face in itertools.combinations(coface, len(coface) - 1):
                    least[face] = min(value, least.get(face, value))
        for s in level:
            sphere = Smallest([points[i] for i in s], [weights[i] for i in s])
            is_free = not any(sphere.is_inside(p, w) for i, (p, w) in enumerate(zip(points, weights)) if i not in s)
            exact[s] = sphere.square if is_free or s not in least else least[s]
    return exact


class Exactness(unittest.TestCase):
    def agree(self, points, weights=None):
        """The same simplices, and values up to one unit of the last digit."""
        triangulation = dfs.delaunay3(points, weights=weights)
        found = values_of(dfs.filtration(triangulation))
        used = np.asarray(points, dtype=float)
        zero = np.zeros(len(points))
        exact = exact_values(triangulation.simplices, used, zero if weights is None else weights)
        self.assertEqual(found.keys(), exact.keys())
        for s, value in exact.items():
            if value > Fraction(np.finfo(float).max):
                self.assertEqual(found[s], np.inf)
            else:
                error = abs(Fraction(found[s]) - value)
                self.assertLessEqual(error, Fraction(np.spacing(abs(float(value)))), (s, found[s], float(value)))

    def test_general_position(self):
        for n in range(1, 12):
            self.agree(random_points(n, n))

    def test_where_points_are_not_in_general_position(self):
        sphere = np.random.default_rng(2).normal(size=(12, 3))
        plane = np.column_stack([random_points(9)[:, :2], np.full(9, .1)])
        for points in (turned_lattice(2), turned_lattice(2).round(), turned_lattice(3)[:14], turned_lattice(3)[:10].round() + 1e8,
                       sphere / np.linalg.norm(sphere, axis=1)[:, None], plane, np.vstack([plane, [[0, 0, 5]]]),
                       random_points(9).astype(np.float32), np.ldexp(random_points(9), -500), np.ldexp(random_points(9), 400),
                       np.vstack([random_points(7), random_points(7)]), [[0, 0, 0], [1, 0, 0], [3, 0, 0]], [[1, 2, 3], [1, 2, 3]],
                       np.exp(np.random.default_rng(3).normal(size=(10, 3)) * 30)):
            self.agree(np.asarray(points))

    def test_flat_tetrahedra(self):
        """Simplices with a volume by rounding alone have large spheres that doubles know nothing of."""
        for name, points in flat_sets().items():
            if name not in ("tiny", "denormal", "huge", "scales"):  # whose squares are no doubles
                with self.subTest(name):
                    self.agree(np.asarray(points, dtype=float)[:20])

    def test_numbers_of_very_different_size(self):
        """Integers of the largest size: no stage before them knows these signs."""
        corners = np.array([[0, 0, 0], [1, 0, 0], [.5, 2. ** -500, 0], [.5, 0, 2. ** -480], [.5, -2. ** -300, 2. ** -511]])
        self.agree(corners)
        self.agree(np.vstack([corners, [[2. ** 300, 0, 0], [0, 2. ** 400, 1]]]))
        wide = np.array([[1e-320, 0, 0], [0, 1e-310, 3e-319], [1, 1, 1], [1 + 2 ** -52, 1, 1], [3e-300, 2e-150, 1]])
        self.agree(wide)

    def test_weights(self):
        for n in range(1, 10):
            points = random_points(n, n)
            for weights in (np.zeros(n), np.random.default_rng(n).random(n) * .1, np.random.default_rng(n).normal(size=n)):
                self.agree(points, weights)
        lattice = np.array(list(itertools.product(range(2), repeat=3)), dtype=float)
        for weights in (np.ones(8), np.arange(8) % 3 - 1., np.array([.5, 1, 2, 1, .25, 1, 1, 0])):
            self.agree(lattice, weights)
        points = random_points(8)
        self.agree(points * 1e-5, np.full(8, 1e10) + np.arange(8) * 1e-12)  # what differs is nothing beside the weights
        self.agree(np.ldexp(points, -400), np.ldexp(random_points(8)[:, 0], -800))

    def test_alpha_complex_with_weights(self):
        """It takes the same values, which are right near 0, too, and where coordinates differ much in size."""
        for points, alpha in ((np.vstack([random_points(60, 0), 1e170 * (random_points(4) + 1)]), .2),
                              (np.vstack([1e-100 * random_points(60), 1e300 * (random_points(4) + .1)]), 5e-101)):
            plain = dfs.delaunay3(points).alpha_complex(alpha)
            weighted = dfs.delaunay3(points, weights=np.zeros(len(points))).alpha_complex(alpha)
            self.assertEqual([len(rows) for rows in plain], [len(rows) for rows in weighted])
            self.assertEqual(plain.triangles.tolist(), weighted.triangles.tolist())
        for seed in (13, 43):
            random = np.random.default_rng(seed)
            points, weights = random.integers(0, 7, (30, 3)) / 10., random.integers(0, 12, 30) * .01
            triangulation = dfs.delaunay3(points, weights=weights)
            found = triangulation.alpha_complex(0)
            mine = [triangulation.simplices[found.simplices], found.triangles, found.edges, found.vertices[:, None]]
            exact = exact_values(triangulation.simplices, points, weights)
            self.assertEqual({tuple(sorted(row)) for rows in mine for row in rows.tolist()},
                             {simplex for simplex, value in exact.items() if value <= 0})

    def test_values_of_gudhi(self):
        """The same simplices, and squared radii that differ by two units of the last digit at most."""
        if gudhi is None:
            self.skipTest("skipped: GUDHI was not found")
        for seed in range(30):
            random = np.random.default_rng(seed)
            n = int(random.integers(4, 400))
            points = random.random((n, 3)) if seed % 3 else random.normal(size=(n, 3)) * [1, 10, .1] + 100
            ours = values_of(dfs.filtration(points))
            theirs = {tuple(s): value for s, value in gudhi.AlphaComplex(points=points, precision="exact").create_simplex_tree(
                ).get_filtration()}
            self.assertEqual(ours.keys(), theirs.keys())
            self.assertLessEqual(max(abs(ours[s] - theirs[s]) / np.spacing(theirs[s]) for s in ours), 2)

    def test_weighted_values_of_gudhi(self):
        if gudhi is None:
            self.skipTest("skipped: GUDHI was not found")
        for seed in range(10):
            random = np.random.default_rng(seed)
            points, weights = random.random((150, 3)), random.random(150) * 10. ** -(seed % 4)
            ours = values_of(dfs.filtration(points, weights=weights))
            tree = gudhi.AlphaComplex(points=points, weights=weights.tolist(), precision="exact").create_simplex_tree()
            theirs = {tuple(sorted(s)): value for s, value in tree.get_filtration()}
            self.assertEqual(ours.keys(), theirs.keys())
            for s, value in theirs.items():
                self.assertLessEqual(abs(ours[s] - value), 2 * np.spacing(abs(value)))


class Order(unittest.TestCase):
    def is_valid(self, filtration):
        """Values ascend, and of equal ones dimensions and places; so each face comes before what it bounds."""
        values, dimensions = np.concatenate(filtration.values), np.repeat(
            np.arange(len(filtration.values)), [len(v) for v in filtration.values])
        order = filtration.order
        keys = list(zip(values[order].tolist(), dimensions[order].tolist(), order.tolist()))
        self.assertEqual(keys, sorted(keys))
        place = {s: k for k, s in enumerate(simplices_in_order(filtration))}
        self.assertEqual(len(place), len(order))
        for s, k in place.items():
            for face in itertools.combinations(s, len(s) - 1):
                if face:
                    self.assertLess(place[face], k)

    def test_order(self):
        for points in (random_points(100), turned_lattice(4), turned_lattice(4).round(), turned_lattice(4).astype(np.float32)):
            self.is_valid(dfs.filtration(points))
            self.is_valid(dfs.filtration(points, kind="delaunay"))
            self.is_valid(dfs.filtration(points, weights=np.random.default_rng(4).random(len(points)) - .5))

    def test_rows_are_in_order(self):
        for threads in (1, 2, 5):
            filtration = dfs.filtration(random_points(6000), threads=threads)
            for rows in filtration.simplices:
                self.assertTrue((rows[:, 1:] > rows[:, :-1]).all())
                self.assertEqual(rows.tolist(), sorted(rows.tolist()))
            self.assertEqual(sum((-1) ** d * len(rows) for d, rows in enumerate(filtration.simplices)), 1)

    def test_vertices_enter_at_0(self):
        self.assertEqual(str(dfs.filtration(random_points(9), weights=np.zeros(9)).values[0][0]), "0.0")

    def test_is_the_same_for_any_number_of_threads(self):
        points, weights = random_points(20000), random_points(20000)[:, 0] * 1e-4
        for arguments in ({}, {"weights": weights}, {"box": (1, 1, None)}, {"kind": "delaunay"}):
            one, many = (dfs.filtration(points, threads=threads, **arguments) for threads in (1, 3))
            for ours, theirs in zip((*one.simplices, *one.values, one.order), (*many.simplices, *many.values, many.order)):
                self.assertEqual(ours.tobytes(), theirs.tobytes())

    def test_equal_and_negative_numbers_are_sorted(self):
        from delaunay_from_surface import _delaunay_from_surface as core
        random = np.random.default_rng(5)
        for values in (random.normal(size=3000), random.integers(-3, 3, 3000).astype(float), np.zeros(0), np.array([0., -0., 0.]),
                       np.nextafter(1, 2) * np.ones(50), 1 + random.integers(-9, 9, 3000) * 2. ** -52,
                       np.array([np.inf, -np.inf, 5e-324, -5e-324, 0])):
            self.assertEqual(core.sorted_places(values).tolist(), np.argsort(values, kind="stable").tolist())

    def test_of_few_dimensions(self):
        self.assertEqual(values_of(dfs.filtration(np.zeros((0, 3)))), {})
        self.assertEqual(len(dfs.filtration(np.zeros((0, 3))).order), 0)
        self.assertEqual(values_of(dfs.filtration([[1, 2, 3]])), {(0,): 0})
        self.assertEqual(values_of(dfs.filtration([[0, 0, 0], [0, 0, 2], [0, 0, 2]])), {(0,): 0, (1,): 0, (0, 1): 1})
        flat = values_of(dfs.filtration([[0, 0, 0], [2, 0, 0], [0, 2, 0], [9, 9, 0]]))
        self.assertEqual(flat[0, 1, 2], 2)
        self.assertEqual(max(map(len, flat)), 3)

    def test_kind(self):
        points = random_points(50)
        alpha, delaunay = dfs.filtration(points), dfs.filtration(dfs.delaunay3(points), kind="delaunay")
        self.assertEqual([rows.tolist() for rows in alpha.simplices], [rows.tolist() for rows in delaunay.simplices])
        self.assertEqual({value for values in delaunay.values for value in values}, {0})

    def test_points_that_have_been_changed(self):
        """The result is worth nothing, but there is one."""
        points = random_points(300)
        triangulation = dfs.delaunay3(points)
        for value in (np.nan, np.inf, 1e300, 0):
            points[::3] = value
            self.assertEqual(len(dfs.filtration(triangulation).simplices[3]), triangulation.nsimplex)

    def test_simplices_that_change_during_a_call(self):
        """Another thread writes into them: they are copied first, so they are refused, or there is a result."""
        triangulation = dfs.delaunay3(random_points(20000))
        simplices, rows = triangulation.simplices, triangulation.simplices.copy()
        is_over = threading.Event()

        def write():
            while not is_over.is_set():
                simplices[:] = 19999 - rows
                simplices[:] = rows
        writer = threading.Thread(target=write)
        writer.start()
        try:
            for _ in range(5):
                self.assertEqual(len(dfs.filtration(triangulation, threads=2).simplices[3]), len(rows))
        finally:
            is_over.set()
            writer.join()

    def test_refusals(self):
        with self.assertRaisesRegex(ValueError, "kind: expected one of alpha, delaunay, got 'rips'"):
            dfs.filtration(random_points(9), kind="rips")
        with self.assertRaisesRegex(ValueError, "weights: those of a triangulation cannot be changed"):
            dfs.filtration(dfs.delaunay3(random_points(9)), weights=np.ones(9))
        with self.assertRaisesRegex(ValueError, "box: those of a triangulation cannot be changed"):
            dfs.filtration(dfs.delaunay3(random_points(9)), box=(1, 1, 1))
        with self.assertRaisesRegex(ValueError, "threads: expected a whole number"):
            dfs.filtration(random_points(9), threads=0)


class Boxes(unittest.TestCase):
    def test_is_that_of_the_copies(self):
        """Of 5 x 5 x 5 boxes of copies, which are not rounded here, the simplices that begin in the middle."""
        for weights in (None, np.random.default_rng(6).random(40) * .02):
            for box in ((1, 1, 1), (1, .5, None), (None, None, .75)):
                with self.subTest((weights is None, box)):
                    points = np.round(random_points(40, 6) * 2 ** 20) / 2 ** 20
                    filtration = dfs.filtration(points, weights=weights, box=box)
                    moves = np.array(list(itertools.product(*[[0] if p is None else [0, -2, -1, 1, 2] for p in box])))
                    periods = np.array([0 if p is None else p for p in box])
                    copies = (points + (moves * periods)[:, None]).reshape(-1, 3)
                    of_copies = dfs.filtration(copies, weights=None if weights is None else np.tile(weights, len(moves)))
                    expected = {}
                    for simplex, value in values_of(of_copies).items():
                        vertices = sorted((v % 40, *moves[v // 40]) for v in simplex)
                        if vertices[0][1:] == (0, 0, 0):
                            expected[tuple(tuple(map(int, v)) for v in vertices)] = value
                    found = {tuple((p, *o) for p, o in zip(row, moved)): value for rows, offsets, values in zip(
                        filtration.simplices, filtration.offsets, filtration.values)
                             for row, moved, value in zip(rows.tolist(), offsets.tolist(), values.tolist())}
                    self.assertEqual(found.keys(), expected.keys())
                    for simplex, value in expected.items():
                        self.assertAlmostEqual(found[simplex], value, delta=2 * np.spacing(abs(value)))

    def test_few_points(self):
        """A point and its copies: edges and tetrahedra that have it as their only vertex."""
        filtration = dfs.filtration([[.1, .2, .3]], box=(1, 1, 1))
        self.assertEqual([len(rows) for rows in filtration.simplices], [1, 7, 12, 6])
        self.assertEqual(sorted(filtration.values[1].tolist())[:3], [.25] * 3)
        self.assertEqual(filtration.values[3].tolist(), [.75] * 6)
        with self.assertRaisesRegex(ValueError, "to_gudhi: some simplices have the same vertices"):
            filtration.to_gudhi()

    def test_betti_numbers_of_the_torus(self):
        if gudhi is None:
            self.skipTest("skipped: GUDHI was not found")
        tree = dfs.filtration(random_points(300), box=(1, 1, 1)).to_gudhi()
        tree.compute_persistence(min_persistence=-1, persistence_dim_max=True)
        self.assertEqual(tree.betti_numbers(), [1, 3, 3, 1])


@unittest.skipIf(gudhi is None, "skipped: GUDHI was not found")
class Persistence(unittest.TestCase):
    def diagrams(self, tree):
        tree.compute_persistence(min_persistence=0)
        return [np.array(sorted(tree.persistence_intervals_in_dimension(d).tolist())) for d in range(3)]

    def test_is_that_of_gudhi(self):
        """On lattices, too, where triangulations differ."""
        cubic = np.array(list(itertools.product(range(5), repeat=3)), dtype=float)
        face_centred = cubic[cubic.sum(axis=1) % 2 == 0]
        for points in (random_points(200), cubic, face_centred, turned_lattice(4), np.round(random_points(150) * 6)):
            ours = self.diagrams(dfs.filtration(points).to_gudhi())
            theirs = self.diagrams(gudhi.AlphaComplex(points=np.unique(points, axis=0), precision="exact").create_simplex_tree())
            for mine, expected in zip(ours, theirs):
                mine, expected = (d[d[:, 1] - d[:, 0] > 1e-9] if len(d) else np.zeros((0, 2)) for d in (mine, expected))
                np.testing.assert_allclose(mine, expected, rtol=0, atol=1e-12)

    def test_example(self):
        done = subprocess.run([sys.executable, "-W", "error", Path(__file__).with_name("examples") / "persistence.py"],
                              capture_output=True, text=True, check=True)
        self.assertEqual([line.split(";")[0] for line in done.stdout.splitlines()],
                         ["2 components last", "4 loops last", "2 voids last"])

    def test_to_gudhi(self):
        filtration = dfs.filtration(random_points(60))
        tree = filtration.to_gudhi()
        self.assertEqual({tuple(s): value for s, value in tree.get_filtration()}, values_of(filtration))


if __name__ == "__main__":
    unittest.main()
