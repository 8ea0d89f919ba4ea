# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""Tests what is there for programs that triangulate in every step: tensors, points that move, batches, and what stands
for the triangulations of others, against TetGen and CGAL where these are found."""

import contextlib
import copy
import importlib.util
import inspect
import io
import itertools
import os
import pickle
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import types
import unittest
import unittest.mock
from pathlib import Path

import numpy as np

import delaunay_from_surface as dfs
from delaunay_from_surface import _delaunay_from_surface as core
from delaunay_from_surface import cgalwdt, cpp, tetgen
from test_module import ROOT, cell_set, random_points


class Tensor:
    """Stands for a tensor that requires a gradient and lies on a device: NumPy may not read it as it is."""

    def __init__(self, array, device="cuda:0", is_detached=False):
        self.array, self.device, self.is_detached, self.shape = np.asarray(array), device, is_detached, np.shape(array)

    def __array__(self, *arguments, **keywords):
        raise RuntimeError("Can't call numpy() on Tensor that requires grad.")

    def __dlpack__(self, **keywords):
        raise BufferError("Can't export tensors that require gradient")

    def __dlpack_device__(self):
        return (2, 0)

    def __len__(self):
        return len(self.array)

    def __iter__(self):
        return (Tensor(part, self.device, self.is_detached) for part in self.array)

    def detach(self):
        return type(self)(self.array, self.device, True)

    def cpu(self):
        return type(self)(self.array, "cpu", self.is_detached)

    def to(self, device):
        return Tensor(self.array, device, True)

    def numpy(self):
        if self.device != "cpu" or not self.is_detached:
            raise TypeError("can't convert")
        return self.array


class OnlyDLPack:
    """An array that has no other protocol."""

    def __init__(self, array):
        self.array = np.asarray(array, order="C")

    def __dlpack__(self, **keywords):
        return self.array.__dlpack__(**keywords)

    def __dlpack_device__(self):
        return self.array.__dlpack_device__()


class OnlyInterface:
    """The same for NumPy's own protocol."""

    def __init__(self, array):
        self.array = np.asarray(array, order="C")
        self.__array_interface__ = self.array.__array_interface__


def kinds():
    """By name what makes something that holds an array's values."""
    makers = {"a tensor": Tensor, "an array interface": OnlyInterface}
    if hasattr(np, "from_dlpack"):
        makers["DLPack"] = OnlyDLPack
    if importlib.util.find_spec("torch") is not None:
        import torch
        makers["PyTorch"] = lambda array: torch.tensor(np.ascontiguousarray(array),
                                                       requires_grad=array.dtype.kind == "f")
    return makers


class Tensors(unittest.TestCase):
    def test_found(self):
        if importlib.util.find_spec("torch") is None:
            self.skipTest("skipped: PyTorch was not found; stand-ins are read all the same")

    def test_arguments_of_all_functions(self):
        """Whatever holds the values, the result is that of NumPy's array."""
        points, weights, xi = random_points(200), random_points(67).ravel()[:200] * .01, random_points(40, 7)
        hull = dfs.delaunay3(points).convex_hull
        triangulation, box = dfs.delaunay3(points), dfs.delaunay3(points, box=(1, 1, 1))
        found, copies = triangulation.find_simplex(xi), box.find_copies(xi)
        uses = {
            "points": lambda t: dfs.delaunay3(t(points)).simplices,
            "float32": lambda t: dfs.delaunay3(t(points.astype(np.float32))).simplices,
            "weights": lambda t: dfs.delaunay3(t(points), weights=t(weights)).simplices,
            "faces": lambda t: dfs.delaunay3(points, t(hull), inside=True).winding_numbers,
            "faces, checked": lambda t: dfs.delaunay3(points, t(hull)).simplices,
            "in a box": lambda t: dfs.delaunay3(t(points), box=(1, 1, 1), weights=t(weights)).simplices,
            "find_simplex": lambda t: triangulation.find_simplex(t(xi)),
            "find_simplex, of one": lambda t: triangulation.find_simplex(t(xi[0])),
            "find_simplex, many dimensions": lambda t: triangulation.find_simplex(t(xi.reshape(4, 10, 3))),
            "barycentric": lambda t: triangulation.barycentric(t(xi), t(found)),
            "find_copies": lambda t: box.find_copies(t(xi)).offsets,
            "barycentric in a box": lambda t: box.barycentric(t(xi), t(copies.simplices), t(copies.offsets)),
            "the same, found anew": lambda t: box.barycentric(t(xi), t(copies.simplices)),
            "subgraph": lambda t: dfs.subgraph(t(hull)),
            "topology": lambda t: np.array(dfs.surface_topology(t(hull))),
            "batch": lambda t: np.concatenate([one.simplices for one in dfs.delaunay3_batch([t(points), t(xi)],
                                                                                            [t(weights), None])]),
            "moving": lambda t: dfs.Moving(t(points), weights=t(weights)).simplices,
            "moving, later": lambda t: dfs.Moving(xi).update(t(points), t(weights)).simplices,
            "TetGen": lambda t: tetgen.TetGen(t(points), t(np.zeros(0, dtype=int))).tetrahedralize()[1]}
        for what, use in uses.items():
            expected = use(np.asarray)
            self.assertGreater(np.size(expected), 0, what)
            for kind, make in kinds().items():
                np.testing.assert_array_equal(use(make), expected, f"{what}, {kind}")

    def test_without_a_copy(self):
        points = random_points(50)
        for kind, make in kinds().items():
            for array in (points, points.astype(np.float32)):
                given = make(array)
                values = given.detach().numpy() if kind == "PyTorch" else given.array
                self.assertTrue(np.shares_memory(dfs.delaunay3(given).points, values), kind)

    def test_results_are_taken(self):
        """torch.from_numpy() warns of arrays that it may not write into, and refuses negative strides."""
        made = dfs.Moving(random_points(100))
        edges = dfs.delaunay3(random_points(100), neighbors=True)
        for array in (made.simplices, made.neighbors, made.edges, made.changes.simplices_new, edges.simplices,
                      edges.vertices):
            self.assertTrue(array.flags.writeable and min(array.strides) > 0 and array.dtype == np.int32)
            if importlib.util.find_spec("torch") is not None:
                import torch
                tensor = torch.from_numpy(array)
                self.assertEqual(tensor.data_ptr(), array.__array_interface__["data"][0])

    def test_refusals_name_the_argument(self):
        class Unreadable(Tensor):
            def numpy(self):
                raise TypeError("Got unsupported ScalarType BFloat16")
        for name, use in (("points", lambda t: dfs.delaunay3(t)), ("faces", lambda t: dfs.subgraph(t)),
                          ("weights", lambda t: dfs.delaunay3(random_points(5), weights=t)),
                          ("faces", lambda t: dfs.delaunay3(random_points(5), t, inside=True)),
                          ("xi", lambda t: dfs.delaunay3(random_points(5)).find_simplex(t)),
                          ("simplex", lambda t: dfs.delaunay3(random_points(5)).barycentric(random_points(5), t))):
            with self.assertRaisesRegex(TypeError, f"^{name}: expected an array of ") as caught:
                use(Unreadable(random_points(5)))
            self.assertIn("BFloat16", str(caught.exception.__cause__))

    def test_what_devices_report(self):
        """That is passed on; what cannot be read is refused by the argument's name."""
        class Failing(Tensor):
            def cpu(self):
                raise RuntimeError("CUDA error: out of memory")

        class Elsewhere(OnlyDLPack):
            def __dlpack__(self, **keywords):
                raise BufferError("cannot export")
        points = random_points(5)
        with self.assertRaisesRegex(RuntimeError, "^CUDA error: out of memory$"):
            dfs.delaunay3(Failing(points))
        if "DLPack" in kinds():
            with self.assertRaisesRegex(TypeError, "^weights: expected an array of numbers$") as caught:
                dfs.delaunay3(points, weights=Elsewhere(points[:, 0]))
            self.assertIsInstance(caught.exception.__cause__, BufferError)

    def test_boxes_and_radii(self):
        points, periods = random_points(50), np.ones(3)
        expected = dfs.delaunay3(points, box=periods).alpha_complex(.2)
        for kind, make in kinds().items():
            made = dfs.delaunay3(points, box=make(periods)).alpha_complex(make(np.array(.2)))
            np.testing.assert_array_equal(made.simplices, expected.simplices, kind)
        for error, message, box in ((TypeError, "the period along x: expected a number, .* got '1'", "123"),
                                    (ValueError, "a masked array is not read", np.ma.masked_array(periods, [0, 1, 0])),
                                    (TypeError, "expected three periods, got 7", 7)):
            with self.assertRaisesRegex(error, f"^box: {message}"):
                dfs.Moving(points, box=box)

    def test_cupy(self):
        """Its arrays have get(), and refuse NumPy."""
        class OnDevice:
            __cuda_array_interface__ = {}

            def get(self):
                return random_points(30)

            def __array__(self, *arguments, **keywords):
                raise TypeError("Implicit conversion to a NumPy array is not allowed.")
        np.testing.assert_array_equal(dfs.delaunay3(OnDevice()).simplices, dfs.delaunay3(random_points(30)).simplices)


def keys_of(rows, offsets=None):
    """Simplices as sets, in a box with the offsets of their corners from that which comes first."""
    if offsets is None:
        return [tuple(sorted(row)) for row in rows.tolist()]
    keys = []
    for row, moved in zip(rows.tolist(), offsets.tolist()):
        places = sorted((v, *o) for v, o in zip(row, moved))
        first = places[0]
        keys.append(tuple((v, x - first[1], y - first[2], z - first[3]) for v, x, y, z in places))
    return keys


def simplices_of(triangulation):
    return keys_of(triangulation.simplices, getattr(triangulation, "offsets", None))


def edges_of(triangulation):
    """From the simplices, pair by pair."""
    found = set()
    for key in simplices_of(triangulation):
        for a, b in itertools.combinations(key, 2):
            if isinstance(a, tuple):
                b, a = (b[0], *(p - q for p, q in zip(b[1:], a[1:]))), (a[0], 0, 0, 0)
                if a[0] == b[0] and b[1:] < (0, 0, 0):
                    b = (b[0], *(-p for p in b[1:]))
            found.add((a, b))
    return found


class Motion(unittest.TestCase):
    def agrees(self, moving):
        """What the changes say is what sets say, and the triangulation is what is made anew."""
        changes = moving.changes
        before, after = changes.before, changes.after
        self.assertIs(after, moving.triangulation)
        for old, new, gone, added in (
                ([] if before is None else simplices_of(before), simplices_of(after), changes.simplices_gone,
                 changes.simplices_new),
                ([] if before is None else self.edges(before), self.edges(after), changes.edges_gone,
                 changes.edges_new)):
            common = set(old) & set(new) if changes.is_compared else set()
            self.assertEqual((len(set(old)), len(set(new))), (len(old), len(new)))
            self.assertEqual(gone.tolist(), [i for i, key in enumerate(old) if key not in common])
            self.assertEqual(added.tolist(), [i for i, key in enumerate(new) if key not in common])
        self.assertEqual(set(self.edges(after)), edges_of(after))
        return changes

    @staticmethod
    def edges(triangulation):
        if not isinstance(triangulation, dfs.Periodic3):
            return [tuple(edge) for edge in triangulation.edges.tolist()]
        return [((a, 0, 0, 0), (b, *o)) for (a, b), o in zip(triangulation.edges.tolist(),
                                                             triangulation.edge_offsets.tolist())]

    def test_steps(self):
        for threads in (1, 3):
            points, moving = random_points(9000 if threads == 3 else 300), dfs.Moving(threads=threads)
            with self.assertRaisesRegex(ValueError, r"there is no triangulation yet: call update\(points\)"):
                moving.simplices
            self.assertEqual(repr(moving), "<Moving: nothing yet>")
            counts = []
            for step, length in enumerate((0, 0, 1e-3, 1e-2, 1)):
                points = points + np.random.default_rng(step).normal(0, length, points.shape)
                made = moving.update(points)
                self.assertEqual(cell_set(made.simplices), cell_set(dfs.delaunay3(points).simplices))
                counts.append(len(self.agrees(moving).simplices_gone) / len(made.simplices))
                np.testing.assert_array_equal(moving.simplices, made.simplices)
                np.testing.assert_array_equal(moving.neighbors, dfs.Delaunay3(points, made.simplices, None,
                                                                              made.vertices, 3).neighbors)
            self.assertEqual(counts[:2], [0, 0])
            self.assertTrue(0 < counts[2] < counts[3] < counts[4])

    def test_the_order_is_kept(self):
        points = random_points(2000)
        moving, order = dfs.Moving(points), dfs.InsertionOrder()
        for given in (points, points + 1e-4, points + 2e-4):
            expected = dfs.delaunay3(given, neighbors=True, order=order)
            np.testing.assert_array_equal(moving.update(given).simplices if given is not points else moving.simplices,
                                          expected.simplices)

    def test_motion(self):
        points = random_points(50)
        moving = dfs.Moving(points)
        self.assertEqual((moving.changes.is_compared, moving.changes.moved, moving.changes.distance),
                         (False, 50, np.inf))
        points[3] += [3, 0, 4]  # the copy is another
        points[7, 1] += .125
        self.assertEqual(moving.triangulation.points[7, 1] + .125, points[7, 1])
        moving.update(points)
        self.assertEqual((moving.changes.is_compared, moving.changes.moved), (True, 2))
        self.assertAlmostEqual(moving.changes.distance, 5, 14)
        self.assertEqual(repr(moving.changes), "<Changes: 2 of 50 points moved by up to 5>")
        moving.update(points)
        self.assertEqual((moving.changes.moved, moving.changes.distance, len(moving.changes.simplices_gone)), (0, 0, 0))
        for scale in (1e-300, 1e300):
            tiny = dfs.Moving(points * scale)
            tiny.update(points * scale + [0, 3 * scale, 4 * scale])
            self.assertAlmostEqual(tiny.changes.distance / scale, 5, 12)
        narrow = dfs.Moving(points.astype(np.float32))
        narrow.update(points.astype(np.float32) + np.float32(.25))
        self.assertAlmostEqual(narrow.changes.distance, .25 * 3 ** .5, 6)

    def test_lattices_and_duplicates(self):
        lattice = np.array(list(itertools.product(range(5), repeat=3)), dtype=float)
        moving = dfs.Moving(np.concatenate([lattice, lattice[:40]]))
        for k in range(4):
            points = np.concatenate([lattice, lattice[:40]])
            points[k::7] += 2.0 ** -k * np.array([1, 0, 1])  # some leave their equals, some become others'
            moving.update(points)
            changes = self.agrees(moving)
            self.assertEqual(cell_set(moving.simplices), cell_set(dfs.delaunay3(points).simplices))
            self.assertGreater(len(changes.simplices_new), 0)

    def test_hidden_points(self):
        rng = np.random.default_rng(5)
        points, weights = rng.random((300, 3)), rng.random(300) * .05
        moving = dfs.Moving(points, weights=weights)
        self.assertGreater(len(moving.triangulation.hidden), 20)
        for k in range(3):
            weights = weights + rng.normal(0, .004, 300)
            moving.update(points, weights)
            changes = self.agrees(moving)
            self.assertEqual((changes.moved, changes.distance), (0, 0))
            self.assertGreater(len(changes.simplices_new), 0)
        moving.update(points + .001)
        self.agrees(moving)
        np.testing.assert_array_equal(moving.triangulation.weights, weights)

    def test_boxes(self):
        for n, box, weights in ((60, (1, 1, 1), None), (60, (1, None, 1), None), (3, (1, 1, 1), None),
                                (1, (1, 1, 1), None),
                                (60, (1, 1, 1), .01)):
            points = random_points(n)
            weights = None if weights is None else weights * random_points(n)[:, 0]
            moving = dfs.Moving(points, box=box, weights=weights)
            self.agrees(moving)
            moving.update(points + [.25, .5, .125])
            self.assertEqual(len(self.agrees(moving).simplices_new), 0)
            moving.update(random_points(n) + .02 * random_points(n, 9))
            self.agrees(moving)
            expected = dfs.delaunay3(moving.triangulation.points, box=box, weights=weights)
            self.assertEqual(set(simplices_of(moving.triangulation)), set(simplices_of(expected)))
        shifted = random_points(60)
        moving = dfs.Moving(shifted, box=(1, 1, 1))
        shifted[5] += 1  # it is wrapped: its simplices have other offsets
        moving.update(shifted)
        with_it = (moving.triangulation.simplices == 5).any(axis=1).sum()
        self.assertEqual(len(self.agrees(moving).simplices_new), with_it)
        empty = dfs.Moving(np.zeros((0, 3)), box=(1, 1, 1))
        self.assertEqual((len(empty.simplices), len(empty.edges), len(empty.changes.edges_new)), (0, 0, 0))

    def test_other_numbers_and_dimensions(self):
        points = random_points(40)
        sets = [points, points[:39], points * [1, 1, 0], points * [1, 1, 0] + .01 * random_points(40, 2) * [1, 1, 0],
                points * [1, 0, 0],
                points[::-1] * [1, 0, 0], np.ones((40, 3)), points, np.zeros((0, 3)), np.zeros((0, 3)), points[:1],
                points]
        moving = dfs.Moving()
        for k, given in enumerate(sets):
            moving.update(given)
            changes = self.agrees(moving)
            self.assertEqual(changes.is_compared, k > 0 and len(sets[k - 1]) == len(given))
            if not changes.is_compared:
                self.assertEqual((changes.moved, changes.distance), (len(given), np.inf))
                self.assertEqual(len(changes.simplices_new), len(moving.simplices))

    def test_many_at_one_vertex(self):
        """Simplices with one least vertex: a list of all of them, which is not searched one by one."""
        around = np.random.default_rng(1).normal(size=(20000, 3))
        around /= np.linalg.norm(around, axis=1)[:, None]
        points = np.concatenate([[[0, 0, 0]], around * (1 + 1e-9 * random_points(20000)[:, :1])])
        moving = dfs.Moving(points)
        points[1:101] *= 1.001
        moving.update(points)
        self.assertGreater((moving.simplices == 0).any(axis=1).sum(), 35000)
        old, new = ({tuple(row) for row in np.sort(t.simplices, axis=1).tolist()} for t in (moving.changes.before,
                                                                                            moving.changes.after))
        self.assertEqual((len(moving.changes.simplices_gone), len(moving.changes.simplices_new)),
                         (len(old - new), len(new - old)))

    def test_types(self):
        moving = dfs.Moving(random_points(50), dtype="int64")
        for kind in (np.int64, np.dtype(np.int64), "int64"):
            self.assertEqual(dfs.Moving(random_points(9), dtype=kind).simplices.dtype, np.int64)
        moving.update(random_points(50) ** 1.1)
        changes = moving.changes
        for array in (moving.simplices, moving.neighbors, moving.edges, changes.simplices_gone, changes.simplices_new,
                      changes.edges_gone,
                      changes.edges_new):
            self.assertEqual(array.dtype, np.int64)
        self.assertEqual([dfs.Moving(random_points(9), dtype=f"torch.{name}").simplices.itemsize
                          for name in ("int", "int32", "long", "int64")], [4, 4, 8, 8])
        for wrong in ("float64", "int16", float, 7, "torch.bool", "torch.i4", "f8,(", ("i4", -1), None):
            with self.assertRaisesRegex(TypeError, "^dtype: expected int32 or int64, got "):
                dfs.Moving(dtype=wrong)

    def test_refusals_change_nothing(self):
        points = random_points(50)
        moving = dfs.Moving(points, weights=points[:, 0])
        kept, changes = moving.triangulation, moving.changes
        for error, message, arguments in (
                (ValueError, r"points: expected an array of shape \(n, 3\), got \(50, 2\)", (points[:, :2],)),
                (ValueError, "points: point 0: its x coordinate", (points * np.nan,)),
                (ValueError, r"weights: expected an array of shape \(49,\), one for each point", (points[:49],)),
                (ValueError, r"weights: expected an array of shape \(50,\)", (points, points[:3, 0]))):
            with self.assertRaisesRegex(error, message):
                moving.update(*arguments)
            self.assertIs(moving.triangulation, kept)
            self.assertIs(moving.changes, changes)
        moving.update(points)
        self.assertEqual(len(moving.changes.simplices_gone), 0)
        for wrong, error in ((0, ValueError), ("all", TypeError)):
            with self.assertRaisesRegex(error, "^threads: expected a whole number"):
                dfs.Moving(threads=wrong)
        with self.assertRaisesRegex(ValueError, "box: expected three periods"):
            dfs.Moving(box=(1, 1))

    def test_weights_are_read_at_once(self):
        points, weights = random_points(50), random_points(50)[:, 0] * .01
        expected = cell_set(dfs.delaunay3(points, weights=weights).simplices)
        given = weights.copy()
        for moving in (dfs.Moving(weights=given), dfs.Moving(weights=iter(weights))):
            given[:] = 0
            with self.assertRaisesRegex(ValueError, "^points: point 0"):
                moving.update(points * np.nan)
            self.assertEqual(cell_set(moving.update(points).simplices), expected)
        for error, message, wrong in ((TypeError, "expected an array of numbers|expected numbers", "abc"),
                                      (ValueError, "a masked array is not read", np.ma.masked_array(weights)),
                                      (ValueError, r"expected an array of shape \(n,\), .* got \(50, 3\)", points),
                                      (ValueError, "that of point 1 is not a finite number", [0, np.nan])):
            with self.assertRaisesRegex(error, f"^weights: {message}"):
                dfs.Moving(weights=wrong)

    def test_one_call_at_a_time(self):
        """In a box, too, where no order would be shared: what one call needs is not that of another."""
        points = random_points(50)
        for box in (None, (1, 1, 1)):
            moving, refusals = dfs.Moving(points, box=box), []

            class Meanwhile(OnlyInterface):
                def detach(self):
                    try:
                        moving.update(points)
                    except ValueError as error:
                        refusals.append(str(error))
                    return self

                def cpu(self):
                    return self

                def numpy(self):
                    return self.array
            moving.update(Meanwhile(points + .001))
            self.assertEqual(refusals, ["update: another call is at work on this Moving"])
            self.assertEqual((moving.changes.moved, moving.update(points).npoints), (50, 50))

    def test_strict_arithmetic(self):
        """NumPy may have been told to raise: a step is whole all the same."""
        points = random_points(50) * 1e-300
        later, moving = points + random_points(50, 2) * 1e-310, dfs.Moving(points)
        with np.errstate(all="raise"):
            moving.update(later)
        self.assertEqual(moving.changes.moved, 50)

    def test_copies(self):
        points = random_points(50)
        moving = dfs.Moving(points, weights=points[:, 0] * .1)
        for other in (copy.copy(moving), copy.deepcopy(moving), pickle.loads(pickle.dumps(moving))):
            np.testing.assert_array_equal(other.simplices, moving.simplices)
            self.assertEqual(cell_set(other.update(points + .001).simplices), cell_set(moving.simplices))
            self.assertEqual((other.changes.moved, len(other.changes.simplices_new)), (50, 0))

    def test_edges_in_a_box(self):
        """They are those of the Voronoi diagram, one by one, which is not made for them."""
        for n, scale in ((1, 0), (3, 0), (60, .05), (9000, 0)):
            points = random_points(n) + np.random.default_rng(n).integers(-2, 3, (n, 3))
            made = dfs.delaunay3(points, box=(1, None if n > 1 else 1, .9), weights=scale * random_points(n)[:, 0],
                                 threads=3)
            edges, offsets = made.edges, made.edge_offsets
            self.assertNotIn("_diagram", vars(made))
            facets = made.power_facets
            np.testing.assert_array_equal(np.column_stack([edges, offsets]),
                                          np.column_stack([facets.pairs, facets.offsets]))

    def test_what_the_extension_refuses(self):
        cells = dfs.delaunay3(random_points(20)).simplices
        with self.assertRaisesRegex(IndexError, "is not one of the 5 points"):
            core.changed_simplices(cells, None, cells, None, 5, 1)
        with self.assertRaisesRegex(ValueError, "offsets: expected three for each corner"):
            core.changed_simplices(cells, np.zeros(5, dtype=np.int16), cells, None, 20, 1)
        for wrong, offsets in ((cells[:, :3], np.zeros((len(cells), 3, 3))), (cells, None)):
            with self.assertRaisesRegex(ValueError, "simplices: expected tetrahedra with offsets"):
                core.edges_in_box(np.ascontiguousarray(wrong), offsets, 20, 1)
        with self.assertRaisesRegex(ValueError, "simplices: expected an array of shape"):
            core.changed_simplices(np.zeros((3, 5), dtype=np.int32), None, np.zeros((3, 5), dtype=np.int32), None, 20,
                                   1)


def recorded(k):
    """Ten sets of points and weights, the same for ever: NumPy does not change this generator. Some as TetWeave and
    DMesh begin with: a ball, float32; some near a surface or in clusters."""
    random = np.random.RandomState(k)
    n = (30, 100, 300, 1000, 2000)[k % 5]
    points = random.normal(size=(n, 3))
    if k in (2, 3):
        points *= (random.random_sample(n) ** (1 / 3) / np.linalg.norm(points, axis=1))[:, None]
    elif k in (4, 5, 6):
        points *= (1 + .05 * random.random_sample(n)[:, None]) / np.linalg.norm(points, axis=1)[:, None]
    elif k > 6:
        points = random.random_sample((8, 3))[random.randint(8, size=n)] + .01 * points
    spacing = n ** (-1 / 3) * (.01 if k > 6 else 1)
    return points.astype(np.float32), (random.random_sample(n) * spacing ** 2).astype(np.float32)


class StandIns(unittest.TestCase):
    """What stands for the triangulations of others, against these."""

    def compiled(self, name, header, *options):
        """The program of the benchmark that has the other's tetrahedra, if the other's header is found."""
        source = ROOT / "benchmark/Delaunay_from_surface_3" / f"{name}.cpp"
        compiler = shutil.which("c++")
        look = [compiler, "-x", "c++", "-include", header, "-E", os.devnull]
        if compiler is None or subprocess.run(look, capture_output=True, check=False).returncode != 0:
            self.skipTest(f"skipped: {header} was not found")
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        program = Path(folder.name) / name
        subprocess.run([compiler, "-std=c++17", "-DNDEBUG", "-frounding-math", "-w", source, "-o", program, *options],
                       check=True)
        return program

    def test_against_tetgen(self):
        program = self.compiled("cells_of_tetgen", "tetgen.h", "-ltet")
        for k in range(10):
            points = recorded(k)[0]
            given = np.int32(len(points)).tobytes() + points.astype(float).tobytes()
            expected = np.frombuffer(subprocess.run(program, input=given, capture_output=True, check=True).stdout,
                                     dtype=np.int32)
            nodes, tets = tetgen.TetGen(points, np.array([], dtype=int)).tetrahedralize(switches="Q")
            self.assertEqual(cell_set(tets), cell_set(expected.reshape(-1, 4)), k)
            np.testing.assert_array_equal(nodes, points)

    def test_against_cgal(self):
        program = self.compiled("cells_of_cgal", "CGAL/Regular_triangulation_3.h", "-lmpfr", "-lgmp")
        sets = [recorded(k) for k in range(10)]
        lattice = np.array(list(itertools.product(range(6), repeat=3)), dtype=np.float32)
        sets += [(lattice, np.zeros(216, dtype=np.float32)), (lattice, (np.arange(216) % 5 == 0).astype(np.float32)),
                 # No two are equal in both: CGAL has another name for these.
                 (np.concatenate([lattice, lattice[:50]]), np.arange(266, dtype=np.float32) % 7 / 16)]
        given = b"".join(np.int32(len(points)).tobytes() + np.column_stack([points, weights]).astype(float).tobytes()
                         for points, weights in sets)
        answer = io.BytesIO(subprocess.run(program, input=given, capture_output=True, check=True).stdout)
        hidden = 0
        for k, (points, weights) in enumerate(sets):
            m = int(np.frombuffer(answer.read(4), dtype=np.int32)[0])
            rows = np.frombuffer(answer.read(56 * m), dtype=float).reshape(-1, 7)
            ours = cgalwdt.CGALWDTStruct.forward(types.SimpleNamespace(positions=points, weights=weights), True, False,
                                                 50, True)
            self.assertEqual((ours.tets_point_id.dtype, ours.tets_cc.dtype), (np.int32, np.float32))
            self.assertEqual(cell_set(ours.tets_point_id), cell_set(rows[:, :4].astype(int)), k)
            places = {frozenset(row): center for row, center in zip(rows[:, :4].astype(int).tolist(), rows[:, 4:])}
            self.check_centers(points, weights, ours,
                               np.array([places[frozenset(row)] for row in ours.tets_point_id.tolist()]), k)
            hidden += len(points) - len(np.unique(ours.tets_point_id))
        self.assertGreater(hidden, 100)

    def check_centers(self, points, weights, ours, centers, k):
        """CGAL's are rounded on the way: where the tetrahedra are round they agree."""
        edges = points[ours.tets_point_id[:, 1:]].astype(float) - points[ours.tets_point_id[:, :1]]
        are_round = np.abs(np.linalg.det(edges)) > 1e-3 * np.prod(np.linalg.norm(edges, axis=2), axis=1)
        self.assertGreater(are_round.mean(), .5)
        np.testing.assert_allclose(ours.tets_cc[are_round], centers[are_round], rtol=1e-6,
                                   atol=1e-6 * np.abs(centers[are_round]).max(),
                                   err_msg=str(k))

    def test_tensors(self):
        points, weights = recorded(3)
        torch = types.SimpleNamespace(Tensor=Tensor, from_numpy=lambda array: Tensor(array, "cpu", True))
        expected = dfs.delaunay3(points, weights=weights)
        with unittest.mock.patch.dict(sys.modules, torch=torch):
            given = types.SimpleNamespace(positions=Tensor(points), weights=Tensor(weights[:, None]))
            made = cgalwdt.CGALWDTStruct.forward(given, True, True, 50, True)
            bare = cgalwdt.CGALWDTStruct.forward(given, True, False, dtype="int64")
            wide = cpp.triangulate(Tensor(points), dtype="torch.int64")
        self.assertIs(made.points, given)
        self.assertGreater(made.time_sec, 0)
        for tensor in (made.tets_point_id, made.tets_cc, bare.tets_point_id, bare.tets_cc, wide):
            self.assertIsInstance(tensor, Tensor)
            self.assertEqual(tensor.device, "cuda:0")
        self.assertEqual(cell_set(made.tets_point_id.array), cell_set(expected.simplices))
        self.assertEqual((made.tets_cc.array.dtype, made.tets_cc.shape, bare.tets_cc.shape),
                         (np.float32, (expected.nsimplex, 3), (0,)))
        self.assertEqual((bare.tets_point_id.array.dtype, wide.array.dtype), (np.int64, np.int64))
        if importlib.util.find_spec("torch") is None:
            return
        import torch as pytorch
        positions = pytorch.tensor(points, requires_grad=True)
        made = cgalwdt.CGALWDTStruct.forward(types.SimpleNamespace(positions=positions,
                                                                   weights=pytorch.tensor(weights)), True, False, 50,
                                             True)
        self.assertEqual((made.tets_point_id.dtype, made.tets_cc.dtype), (pytorch.int32, pytorch.float32))
        self.assertEqual(cell_set(made.tets_point_id.numpy()), cell_set(expected.simplices))
        self.assertEqual(cpp.triangulate(positions, dtype=pytorch.int64).dtype, pytorch.int64)

    def test_weights(self):
        points, weights = recorded(2)
        expected = cell_set(dfs.delaunay3(points, weights=weights).simplices)

        def forward(given):
            return cgalwdt.CGALWDTStruct.forward(types.SimpleNamespace(positions=points, weights=given), True, False, 50,
                                                 True)
        for given in (iter(weights), list(weights), weights[:, None]):
            self.assertEqual(cell_set(forward(given).tets_point_id), expected)
        for error, wrong in ((ValueError, np.ma.masked_array(weights, np.arange(len(weights)) == 7)),
                             (ValueError, np.ma.masked_array(weights[:, None])), (ValueError, weights[:-1]),
                             (ValueError, weights[None]), (TypeError, None)):
            with self.assertRaisesRegex(error, "^weights: "):
                forward(wrong)

    def test_far_centers(self):
        """They are infinite, without a warning."""
        points = random_points(60) * [1e3, 1e3, 0]
        points[3, 2] = 1e-38
        with np.errstate(all="raise"):
            made = cgalwdt.CGALWDTStruct.forward(types.SimpleNamespace(positions=points, weights=np.zeros(60)),
                                                 compute_cc=True)
        self.assertFalse(np.isfinite(made.tets_cc).all())

    def test_in_a_plane(self):
        flat = recorded(1)[0] * np.float32([1, 1, 0])
        nodes, tets = tetgen.TetGen(flat).tetrahedralize()
        made = cgalwdt.CGALWDTStruct.forward(types.SimpleNamespace(positions=flat, weights=flat[:, 0]), True, False,
                                             50, True)
        self.assertEqual((tets.shape, made.tets_point_id.shape, made.tets_cc.shape), ((0, 4), (0, 4), (0, 3)))

    def test_tetgen(self):
        """Equal points are left out, tetrahedra are positively oriented, and what needs TetGen itself is refused."""
        points = np.concatenate([recorded(3)[0]] * 2)
        made = tetgen.TetGen(points)
        self.assertIsNone(made.elem)
        nodes, tets = made.tetrahedralize("Qz", threads=2, dtype="int64")
        self.assertIs(made.node, nodes)
        self.assertIs(made.elem, tets)
        self.assertEqual((nodes.dtype, nodes.shape, tets.dtype, tets.max() < 1000),
                         (np.float64, points.shape, np.int64, True))
        corners = nodes[tets]
        self.assertGreater(np.linalg.det(corners[:, 1:] - corners[:, :1]).min(), 0)
        for switches in ("pq1.2", "w", "Qv"):
            with self.assertRaisesRegex(ValueError,
                                        "^switches: expected 'Q', for the Delaunay tetrahedra of points alone, got"):
                made.tetrahedralize(switches=switches)
        with self.assertRaisesRegex(TypeError, "^switches: expected a text such as 'Q', got None"):
            made.tetrahedralize(switches=None)
        flat = np.array([3, 0, 1, 2, 3, 1, 2, 3])
        for error, message, faces in ((ValueError, r"got an array of shape \(8,\)", flat),
                                      (ValueError, r"got an array of shape \(2, 4\)", Tensor(flat.reshape(2, 4))),
                                      (ValueError, "got 2 of them", [[0, 1, 2], [1, 2, 3, 4]]),
                                      (TypeError, "expected None, .* got generator", (face for face in []))):
            with self.assertRaisesRegex(error, f"^faces: .*{message}"):
                tetgen.TetGen(points, faces)
        for none in (None, [], np.zeros((0, 3), dtype=int)):
            given = points.copy()
            made = tetgen.TetGen(given, none)
            given[:] = 0  # the copy is another
            self.assertEqual(cell_set(made.tetrahedralize()[1]), cell_set(tets))
        with self.assertRaisesRegex(ValueError, r"^points: expected an array of shape \(n, 3\)"):
            tetgen.TetGen(points[:, :2])
        for use in (lambda: made.tetrahedralize(dtype="int8"), lambda: cpp.triangulate(points, dtype=float)):
            with self.assertRaisesRegex(TypeError, "^dtype: expected int32 or int64"):
                use()


class Batches(unittest.TestCase):
    def sets(self):
        return [random_points(n, n) for n in (500, 0, 3, 1000, 40)] + [random_points(50) * [1, 1, 0],
                                                                       random_points(60).astype(np.float32)]

    def test_the_same_by_any_number_of_threads(self):
        sets = self.sets()
        for threads in (1, 2, 7, None):
            made = dfs.delaunay3_batch(sets, neighbors=True, threads=threads)
            self.assertEqual(len(made), len(sets))
            for points, one in zip(sets, made):
                alone = dfs.delaunay3(points, neighbors=True)
                self.assertIs(one.points, points)
                self.assertEqual(one.dimension, alone.dimension)
                np.testing.assert_array_equal(one.simplices, alone.simplices)
                np.testing.assert_array_equal(one.neighbors, alone.neighbors)

    def test_arrays_of_sets(self):
        points, weights = random_points(600).reshape(6, 100, 3), random_points(200).reshape(6, 100) * .05
        given = [(points, weights), (list(points), list(weights)), (iter(points), iter(weights)),
                 (Tensor(points), Tensor(weights))]
        for some, of_some in given:
            made = dfs.delaunay3_batch(some, of_some, threads=2)
            for k, one in enumerate(made):
                self.assertIsInstance(one, dfs.Regular3)
                np.testing.assert_array_equal(one.simplices, dfs.delaunay3(points[k], weights=weights[k]).simplices)
        self.assertTrue(np.shares_memory(dfs.delaunay3_batch(points)[3].points, points))
        ragged = np.empty(2, dtype=object)
        ragged[:] = points[0], points[1, :50]
        self.assertEqual([one.npoints for one in dfs.delaunay3_batch(ragged)], [100, 50])
        self.assertEqual(dfs.delaunay3_batch([]), [])
        self.assertEqual(dfs.delaunay3_batch(np.zeros((0, 9, 3))), [])
        mixed = dfs.delaunay3_batch(points[:2], [None, weights[1]], box=(1, 1, 1))
        self.assertEqual([type(one) for one in mixed], [dfs.Periodic3, dfs.PeriodicRegular3])
        np.testing.assert_array_equal(mixed[1].offsets, dfs.delaunay3(points[1], weights=weights[1],
                                                                      box=(1, 1, 1)).offsets)

    def test_refusals(self):
        sets = self.sets()
        sets[3][7, 1] = np.nan
        sets[4] = sets[4][:, :2]
        for threads in (1, 2, 5):
            with self.assertRaisesRegex(ValueError,
                                        "^set 3: points: point 7: its y coordinate is not a finite number$") as caught:
                dfs.delaunay3_batch(sets, threads=threads)
            self.assertIsInstance(caught.exception.__cause__, ValueError)
        points = random_points(600).reshape(6, 100, 3)
        for error, message, arguments in (
                (ValueError, r"points: expected an array of shape \(b, n, 3\), or a sequence .* got \(100, 3\)",
                 (points[0],)),
                (TypeError, "points: expected a sequence with one array for each set, got int", (7,)),
                (ValueError, "set 1: points: a masked array", ([points[0], np.ma.array(points[1])],)),
                (TypeError, "set 1: points: expected numbers, got entries of type complex128",
                 ([points[0], points[1] * 1j],)),
                (ValueError, "weights: expected those of 6 sets, one array for each or None, got 5",
                 (points, [None] * 5)),
                (ValueError, r"weights: expected an array of shape \(b, n\)", (points, np.zeros(6))),
                (ValueError, r"set 0: weights: expected an array of shape \(100,\)", (points, np.zeros((6, 99))))):
            with self.assertRaisesRegex(error, f"^{message}"):
                dfs.delaunay3_batch(*arguments, threads=2)
        with self.assertRaisesRegex(ValueError, "^threads: expected a whole number from 1 on"):
            dfs.delaunay3_batch(points, threads=0)

    def test_errors_of_others(self):
        class Failing:
            def __init__(self, error):
                self.error = error

            def __array__(self, *arguments, **keywords):
                raise self.error

        class Ending:
            def __array__(self, *arguments, **keywords):
                if threading.current_thread() is threading.main_thread():
                    time.sleep(.05)
                    return random_points(20)
                raise SystemExit(3)

        class Of_two(MemoryError):
            def __init__(self, shape, dtype):
                super().__init__(f"no room for {shape} of {dtype}")

        def files():
            yield random_points(20)
            raise TypeError("file 7")
        for error, message, sets in ((SystemExit, "^3$", [Ending() for _ in range(6)]),
                                     (MemoryError, r"^set 1: no room for 7 of int", [random_points(9),
                                                                                    Failing(Of_two(7, "int"))]),
                                     (OSError, "^disk$", [random_points(9), Failing(OSError("disk"))]),
                                     (TypeError, "^file 7$", files())):
            with self.assertRaisesRegex(error, message):
                dfs.delaunay3_batch(sets, threads=3)

    def test_few_threads(self):
        """Where no more threads can be started, those that work do it all."""
        sets, start = self.sets(), threading.Thread.start

        def start_one(thread):
            if started:
                raise RuntimeError("can't start new thread")
            started.append(thread)
            start(thread)
        started = []
        with unittest.mock.patch.object(threading.Thread, "start", start_one):
            made = dfs.delaunay3_batch(sets, threads=5)
        self.assertEqual([len(started), *(one.npoints for one in made)], [1, *map(len, sets)])

    def test_interrupted(self):
        """Ctrl-C ends all threads, in the middle of their sets."""
        sets = [random_points(150000, k) for k in range(60)]
        for threads in (1, 3):
            before = threading.active_count()
            timer = threading.Timer(.3, os.kill, (os.getpid(), signal.SIGINT))
            begin = time.monotonic()
            timer.start()
            with self.assertRaises(KeyboardInterrupt):
                dfs.delaunay3_batch(sets, threads=threads)
            self.assertLess(time.monotonic() - begin, 5)
            timer.join()
            self.assertEqual(threading.active_count(), before)


class Wishes(unittest.TestCase):
    """Small things: bars, names of arguments, and what is said of things in the wrong place."""

    def bars(self, work):
        """What a stand-in for tqdm is told."""
        made = []

        class Stand:
            def __init__(self, total, desc):
                self.total, self.desc, self.n, self.is_closed = total, desc, 0, False
                made.append(self)

            def update(self, more):
                self.n += more

            def close(self):
                self.is_closed = True
        modules = {"tqdm": types.ModuleType("tqdm"), "tqdm.auto": types.SimpleNamespace(tqdm=Stand)}
        with unittest.mock.patch.dict(sys.modules, modules):
            work()
        return made

    def text(self, work):
        """What is written where there is no tqdm."""
        with unittest.mock.patch.dict(sys.modules,
                                      {"tqdm": None,
                                       "tqdm.auto": None}), contextlib.redirect_stderr(io.StringIO()) as stream:
            work()
        return stream.getvalue()

    def test_bars(self):
        points = random_points(3000)
        for work in (lambda: dfs.delaunay3(points, progress=True), lambda: dfs.delaunay3(points, box=(1, 1, 1),
                                                                                         progress=True)):
            bar, = self.bars(work)
            self.assertEqual((bar.n, bar.total, bar.is_closed), (100, 100, True))
            self.assertRegex(self.text(work),
                             r"^\rpercent of the points: 0 of 100(.*)\rpercent of the points: 100 of 100\n$")
        self.assertEqual(self.text(lambda: dfs.delaunay3(points, progress=False)), "")
        self.assertEqual(self.text(lambda: dfs.delaunay3(points, progress=np.False_)), "")
        self.assertIn("100 of 100", self.text(lambda: dfs.delaunay3(points, progress=np.True_)))
        bad = points.copy()
        bad[0, 0] = np.inf
        self.assertEqual(self.text(lambda: self.assertRaises(ValueError, dfs.delaunay3, bad, progress=True)), "")
        with self.assertRaisesRegex(TypeError, "^progress: expected a function, or True for a bar, got 'bar'$"):
            dfs.delaunay3(points, progress="bar")
        with tempfile.TemporaryDirectory() as folder:
            np.save(f"{folder}/points.npy", points)
            bars = self.bars(lambda: dfs.delaunay3_tiles(f"{folder}/points.npy", f"{folder}/tiles", tiles=3,
                                                         progress=True))
            self.assertEqual([bar.desc for bar in bars if bar.desc == "writing"], ["writing"])
            self.assertTrue(all(bar.is_closed and bar.n == bar.total for bar in bars))
            text = self.text(lambda: dfs.delaunay3_tiles(f"{folder}/points.npy", f"{folder}/more", tiles=3,
                                                         progress=True))
            self.assertRegex(text, r"\rwriting: 3 of 3\n$")
            self.assertEqual(text.count("\n"), len(bars))

    def test_threads_of_tiles(self):
        with tempfile.TemporaryDirectory() as folder:
            file = f"{folder}/points.npy"
            np.save(file, random_points(500))
            for k, names in enumerate(({"threads": 2}, {"workers": 2}, {"threads": None},
                                       {"threads": 1, "workers": 2})):
                self.assertEqual(len(dfs.delaunay3_tiles(file, f"{folder}/{k}", tiles=2, **names)), 2)
            with self.assertRaisesRegex(TypeError, "^workers: it is another name of threads: give one of them$"):
                dfs.delaunay3_tiles(file, f"{folder}/no", tiles=2, threads=2, workers=3)
            for name in ("threads", "workers"):
                for wrong, error in ((0, ValueError), ("2", TypeError), (2.5, TypeError)):
                    with self.assertRaisesRegex(error, f"^{name}: expected a whole number"):
                        dfs.delaunay3_tiles(file, f"{folder}/no", tiles=2, **{name: wrong})
            self.assertFalse(Path(f"{folder}/no").exists())

    def test_one_name_for_threads(self):
        """Of all public functions and methods."""
        for owner in (dfs, dfs.Delaunay3, dfs.Periodic3, dfs.PeriodicRegular3, cpp, tetgen.TetGen):
            for name, member in vars(owner).items():
                if inspect.isfunction(member) and not name.startswith("_") and member is not dfs.delaunay3_tiles:
                    others = {"workers", "n_jobs", "jobs", "num_threads", "nthreads", "processes"}
                    self.assertFalse(others & set(inspect.signature(member).parameters), name)

    def test_arrays_for_files(self):
        points = random_points(30)
        says = (r"expected the name of a file or folder, got an array of shape \(30, 3\): numpy.save\(\) writes it into a "
                "file$")
        for given in (points, Tensor(points), [points]):
            with self.assertRaisesRegex(TypeError, f"^files: {says}"):
                dfs.delaunay3_tiles(given, "tiles")
        with self.assertRaisesRegex(TypeError, "^files: expected the name of a file or folder, got int$"):
            dfs.delaunay3_tiles([3], "tiles")
        with tempfile.TemporaryDirectory() as folder:
            np.save(f"{folder}/points.npy", points)
            with self.assertRaisesRegex(TypeError, f"^output: {says}"):
                dfs.delaunay3_tiles(f"{folder}/points.npy", points)
            with self.assertRaisesRegex(TypeError, f"^folder: {says}"):
                dfs.Tiles(points)
            for missing in (f"{folder}/none.npy", [f"{folder}/points.npy", f"{folder}/none.npy"]):
                with self.assertRaisesRegex(FileNotFoundError, "none.npy"):
                    dfs.delaunay3_tiles(missing, f"{folder}/tiles")
                with self.assertRaisesRegex(FileNotFoundError, "none.npy"):
                    dfs.delaunay3_dask(missing, HereAndNow(), f"{folder}/tiles")
            with self.assertRaisesRegex(TypeError, f"^output: {says}"):
                dfs.delaunay3_dask(f"{folder}/points.npy", HereAndNow(), points)
            for client in (None, f"{folder}/tiles", {}, 4):
                with self.assertRaisesRegex(TypeError,
                                            f"^client: expected a distributed.Client, got {type(client).__name__}$"):
                    dfs.delaunay3_dask(f"{folder}/points.npy", client, f"{folder}/tiles")
            self.assertFalse(Path(f"{folder}/tiles").exists())

    def test_faces_of_pyvista(self):
        """In one array, with their numbers of corners: as `mesh.faces` has them. In a list they are refused."""
        points = random_points(200)
        hull = dfs.delaunay3(points).convex_hull
        flat = np.insert(hull, 0, 3, axis=1).ravel()
        np.testing.assert_array_equal(dfs.delaunay3(points, flat, inside=True).winding_numbers,
                                      dfs.delaunay3(points, hull, inside=True).winding_numbers)
        np.testing.assert_array_equal(dfs.subgraph(flat), dfs.subgraph(hull))
        for use in (lambda faces: dfs.delaunay3(points, faces), lambda faces: dfs.delaunay3(points, faces,
                                                                                            inside=True), dfs.subgraph):
            with self.assertRaisesRegex(TypeError, "^faces: .*expected sequences of integers"):
                use(flat.tolist())
            with self.assertRaisesRegex(ValueError,
                                        r"^faces: expected an array of shape \(m, k\), got .* nor is it one of VTK's"):
                use(hull.ravel())


class HereAndNow:
    """Stands for a client of Dask: what is submitted is done at once."""

    def submit(self, function, *arguments, **keywords):
        value = function(*arguments)
        return types.SimpleNamespace(result=lambda: value)

    def map(self, *arguments, **keywords):
        raise NotImplementedError


class Examples(unittest.TestCase):
    def test_run(self):
        done = subprocess.run([sys.executable, Path(__file__).with_name("examples") / "moving.py"],
                              capture_output=True, text=True, check=True)
        self.assertRegex(done.stdout, r"step 19: .* of \d+ tetrahedra are new, .* of \d+ edges")
        self.assertIn("every step is what is made anew", done.stdout)


if __name__ == "__main__":
    unittest.main()
