# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""Tests of Voronoi and power cells: run in a Python into which the module is installed."""

import copy
import ctypes
import itertools
import pickle
import platform
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import numpy as np
import scipy.spatial

import delaunay_from_surface as dfs

BASES = {"sc": [[0, 0, 0]], "bcc": [[0, 0, 0], [1, 1, 1]], "fcc": [[0, 0, 0], [0, 1, 1], [1, 0, 1], [1, 1, 0]]}


def crystal(kind, n):
    """A lattice with cubes of edge 2, whose coordinates are whole, and its box."""
    cubes = 2. * np.array(list(itertools.product(range(n), repeat=3)))
    return (cubes[:, None] + np.array(BASES[kind])).reshape(-1, 3), np.full(3, 2. * n)


def cell_of(diagram, i):
    return (diagram.power_cell if isinstance(diagram, dfs.Regular3) else diagram.voronoi_cell)(i)


def measures_of(diagram):
    """Volumes, surface areas and facets, whatever they are called."""
    name = "power" if isinstance(diagram, dfs.Regular3) else "voronoi"
    return [getattr(diagram, f"{name}_{measure}") for measure in ("volumes", "areas", "facets")]


def areas_with_normals(cell):
    """For each face its area times its normal."""
    corners = [cell.vertices[face] for face in cell.faces]
    return np.array([np.cross(c[1:-1] - c[0], c[2:] - c[0]).sum(axis=0) / 2 for c in corners])


def volume_of(cell):
    center = cell.vertices.mean(axis=0)
    return sum((cell.vertices[face[0]] - center) @ area for face, area in zip(cell.faces, areas_with_normals(cell))) / 3


def facets_of(diagram, i):
    """Those of point i as it sees them: neighbours, offsets, areas and solid angles, sorted."""
    _, _, facets = measures_of(diagram)
    ends, areas = facets[:2]
    offsets = facets.offsets if len(facets) > 2 else np.zeros((len(ends), 3), dtype=int)
    rows = [(ends[f, 1 - k], *(1 - 2 * k) * offsets[f], areas[f], diagram.solid_angles[f, k], diagram.facet_corners[f])
            for k in (0, 1) for f in np.flatnonzero((ends[:, k] == i) & (diagram.facet_corners != 0))]
    return sorted(rows)


class Cells(unittest.TestCase):
    """Of all four kinds."""

    @classmethod
    def setUpClass(cls):
        random = np.random.default_rng(1)
        points, weights = random.random((150, 3)), random.random(150) * .01
        cls.points, cls.weights = points, weights
        cls.kinds = {"points": dfs.delaunay3(points), "weights": dfs.delaunay3(points, weights=weights),
                     "box": dfs.delaunay3(points, box=(1, 1, 1)),
                     "slab": dfs.delaunay3(points, box=(1, 1, None)),
                     "weights in a box": dfs.delaunay3(points, weights=weights, box=(1, 1, 1)),
                     "few": dfs.delaunay3(points[:3], box=(1, 2, .5)), "one": dfs.delaunay3(points[:1], box=(1, 1, 1)),
                     "few weights": dfs.delaunay3(points[:5], weights=weights[:5], box=(1, .7, .5)),
                     "float32": dfs.delaunay3(points.astype(np.float32)),
                     "far": dfs.delaunay3(points + [5e5, 5e6, 100], box=(1, 1, 1)),
                     "bcc": dfs.delaunay3(*crystal("bcc", 3)[:1], box=(6, 6, 6)),
                     "tiny": dfs.delaunay3(points * 1e-60, box=(1e-60,) * 3),
                     "spheres": dfs.delaunay3(np.concatenate([crystal("fcc", 3)[0], [[3.5, 3.5, 3.5]]]))}

    def test_polyhedra(self):
        """They have the volumes, areas and neighbours that the arrays have, and are closed and convex."""
        for name, diagram in self.kinds.items():
            volumes, areas, _ = measures_of(diagram)
            self.assertGreater(np.count_nonzero(volumes > 0), 0, name)
            for i in np.flatnonzero(volumes > 0)[:40]:
                with self.subTest(name, point=i):
                    cell = cell_of(diagram, i)
                    normals = areas_with_normals(cell)
                    sizes = np.linalg.norm(normals, axis=1)
                    scale = np.abs(cell.vertices - cell.vertices.mean(axis=0)).max()
                    tolerance = 1e-9 if name in ("far", "spheres") else 1e-12
                    self.assertLess(np.abs(normals.sum(axis=0)).max(), tolerance * areas[i])
                    self.assertAlmostEqual(volume_of(cell) / volumes[i], 1, delta=1000 * tolerance)
                    self.assertAlmostEqual(sizes.sum() / areas[i], 1, delta=1000 * tolerance)
                    edges = {(a, b) for face in cell.faces for a, b in zip(face, np.roll(face, -1))}
                    self.assertEqual(edges, {(b, a) for a, b in edges})
                    self.assertEqual(len(edges), sum(map(len, cell.faces)))
                    self.assertEqual(len(cell.vertices) - len(edges) // 2 + len(cell.faces), 2)
                    for face, normal in zip(cell.faces, normals / sizes[:, None]):
                        heights = (cell.vertices - cell.vertices[face].mean(axis=0)) @ normal
                        self.assertLess(heights.max(), 1e-6 * scale)
                    seen = facets_of(diagram, i)
                    self.assertEqual([tuple(row[:4]) for row in seen],
                                     [(j, *offset) for j, offset in zip(cell.neighbors, cell.offsets)])
                    self.assertEqual([row[6] for row in seen], [len(face) for face in cell.faces])
                    np.testing.assert_allclose([row[4] for row in seen], sizes, rtol=1e-6, atol=1e-9 * areas[i])

    def test_faces_are_halfway(self):
        """Each lies in the plane between two points, as given: also of points given in other copies of the box."""
        moved = self.points + np.random.default_rng(2).integers(-3, 4, (150, 3))
        for diagram, weights in ((dfs.delaunay3(moved, box=(1, 1, 1)), np.zeros(150)),
                                 (dfs.delaunay3(moved, box=(1, 1, 1), weights=self.weights), self.weights)):
            for i in np.flatnonzero(measures_of(diagram)[0] > 0)[:20]:
                cell = cell_of(diagram, i)
                for face, j, offset in zip(cell.faces, cell.neighbors, cell.offsets):
                    x = cell.vertices[face]
                    powers = [((x - p) ** 2).sum(axis=1) - weights[k]
                              for k, p in ((i, moved[i]), (j, moved[j] + offset))]
                    np.testing.assert_allclose(*powers, atol=1e-12)

    def test_sums(self):
        for name, diagram in self.kinds.items():
            volumes, areas, facets = measures_of(diagram)
            with self.subTest(name):
                is_hull = np.isin(np.arange(diagram.npoints), diagram.convex_hull)
                np.testing.assert_array_equal(volumes == -1, is_hull)
                np.testing.assert_array_equal(areas == -1, is_hull)
                np.testing.assert_array_equal(diagram.coordination() == -1, is_hull)
                self.assertTrue((facets.areas >= -1).all())
                np.testing.assert_array_equal(facets.areas == -1, diagram.facet_corners == -1)
                np.testing.assert_array_equal((diagram.solid_angles == -1).all(axis=1), facets.areas == -1)
                self.assertTrue((facets.areas[diagram.facet_corners == 0] == 0).all())
                self.assertFalse(np.isin(diagram.facet_corners, (1, 2)).any())
                if isinstance(diagram, dfs.Periodic3) and np.isfinite(diagram.box).all():
                    tolerance = 1e-9 if name == "far" else 1e-12
                    self.assertAlmostEqual(volumes.sum() / diagram.box.prod(), 1, delta=tolerance)
                sums = np.bincount(facets[0].ravel(), diagram.solid_angles.ravel(), diagram.npoints)
                of_point = sums[diagram.vertices][volumes > 0] / (4 * np.pi)
                if isinstance(diagram, dfs.Regular3):
                    self.assertLess(np.abs(of_point - np.rint(of_point)).max(), 1e-9)
                    self.assertLessEqual(set(np.rint(of_point)), {0, 1})
                else:
                    np.testing.assert_allclose(of_point, 1, rtol=1e-9)

    def test_scipy(self):
        """Finite cells as polyhedra of scipy.spatial.Voronoi."""
        voronoi, ours = scipy.spatial.Voronoi(self.points), self.kinds["points"]
        expected = {tuple(sorted(pair)): len(vertices) for pair, vertices in
                    zip(voronoi.ridge_points.tolist(), voronoi.ridge_vertices) if -1 not in vertices}
        is_bounded = ours.facet_corners >= 0
        pairs = map(tuple, ours.voronoi_facets.points[is_bounded].tolist())
        self.assertEqual(dict(zip(pairs, ours.facet_corners[is_bounded].tolist())), expected)
        for i in np.flatnonzero(ours.voronoi_volumes > 0):
            hull = scipy.spatial.ConvexHull(voronoi.vertices[voronoi.regions[voronoi.point_region[i]]])
            self.assertAlmostEqual(hull.volume / ours.voronoi_volumes[i], 1, 9)
            self.assertAlmostEqual(hull.area / ours.voronoi_areas[i], 1, 9)

    def test_threads(self):
        points = np.random.default_rng(3).random((5000, 3))
        for weights in (None, np.zeros(5000)):
            one, many = (dfs.delaunay3(points, box=(1, 1, 1), weights=weights, threads=1) for _ in range(2))
            many.__dict__["_threads"] = 5
            np.testing.assert_array_equal(measures_of(many)[0], measures_of(one)[0])
            for ours, expected in zip(measures_of(many)[2], measures_of(one)[2]):
                np.testing.assert_array_equal(ours, expected)
            np.testing.assert_array_equal(many.solid_angles, one.solid_angles)
            again = dfs.delaunay3(points, box=(1, 1, 1), weights=weights)
            again.facet_corners  # the volumes come with them
            np.testing.assert_array_equal(measures_of(again)[0], measures_of(one)[0])

    def test_tiny_numbers(self):
        """Of coordinates whose squares vanish, corners and angles are those of larger ones."""
        ours = self.kinds["box"]
        tiny = dfs.delaunay3(np.ldexp(self.points, -900), box=np.ldexp(np.ones(3), -900))
        np.testing.assert_array_equal(tiny.facet_corners, ours.facet_corners)
        np.testing.assert_allclose(tiny.solid_angles, ours.solid_angles, atol=1e-12)
        enlarged = np.ldexp(tiny.voronoi_cell(7).vertices, 900)
        np.testing.assert_allclose(enlarged, ours.voronoi_cell(7).vertices, rtol=1e-12)

    def test_extreme_scales(self):
        """Areas are compared, and volumes of facets added up, in a unit in which they are neither 0 nor infinite."""
        ours = self.kinds["box"]
        for exponent, area, volume in ((-600, 0, 0), (400, None, np.inf), (520, np.inf, np.inf)):
            for box in (np.ldexp(np.ones(3), exponent), None):
                scaled = dfs.delaunay3(np.ldexp(self.points, exponent), box=box)
                expected = ours if box is not None else self.kinds["points"]
                is_bounded = expected.voronoi_volumes > 0
                np.testing.assert_array_equal(scaled.voronoi_volumes, np.where(is_bounded, volume, -1))
                if area is None:
                    np.testing.assert_array_equal(scaled.voronoi_areas[is_bounded],
                                                  np.ldexp(expected.voronoi_areas[is_bounded], 2 * exponent))
                else:
                    np.testing.assert_array_equal(scaled.voronoi_areas, np.where(is_bounded, area, -1))
                np.testing.assert_array_equal(scaled.coordination(min_area=.05), expected.coordination(min_area=.05))

    def test_far_from_cells(self):
        """Cells do not change where all points move, and weights accordingly: volumes and areas keep their digits."""
        points = np.floor(self.points * 1024) / 1024
        ours = dfs.delaunay3(points)
        for move in (2. ** 8, 2. ** 20):
            far = [dfs.delaunay3(points + move, weights=2 * move * points.sum(axis=1)) for _ in range(2)]
            far[0].power_facets  # the volumes come with them
            far[1].__dict__["_threads"] = 3
            for diagram in far:
                np.testing.assert_allclose(diagram.power_volumes, ours.voronoi_volumes, rtol=1e-12)
                np.testing.assert_array_equal(diagram.facet_corners, ours.facet_corners)
                np.testing.assert_allclose(diagram.power_facets.areas, ours.voronoi_facets.areas, rtol=1e-9)
            np.testing.assert_array_equal(far[1].power_volumes, far[0].power_volumes)
            np.testing.assert_array_equal(far[1].power_facets.areas, far[0].power_facets.areas)

    def test_vanishing_cells(self):
        """Of a weight with which a cell is but a point, the volume is 0 and not a little less."""
        points, box = crystal("bcc", 3)
        is_center = np.arange(len(points)) % 2 == 1
        for of_box in (box, None):
            ours = dfs.delaunay3(points, weights=np.where(is_center, -3., 0), box=of_box)
            is_bounded = is_center & (ours.power_volumes != -1)
            self.assertGreater(np.count_nonzero(is_bounded), 0)
            self.assertTrue((ours.power_volumes[is_bounded] >= 0).all())
            self.assertLess(ours.power_volumes[is_bounded].max(), 1e-14)

    def test_points_in_planes_of_facets(self):
        """From a point in the plane of a facet its solid angle is 0, also where the point is a corner or on an edge."""
        points = np.array(list(itertools.product(range(5), repeat=3)), dtype=float)
        for move, share, number in (((.5, .5, .5), 1 / 8, 3), ((.5, .5, 0), 1 / 4, 4), ((.5, 0, 0), 1 / 2, 5)):
            ours = dfs.delaunay3(points + move, weights=2 * (points @ move))
            ends, angles = ours.power_facets.points, ours.solid_angles
            self.assertTrue(np.isfinite(angles).all())
            of_center = angles[(ends == 62) & (ours.facet_corners > 0)[:, None]]
            self.assertAlmostEqual(of_center.sum() / (4 * np.pi), share, 12)
            self.assertEqual([np.count_nonzero(of_center == 0), np.count_nonzero(of_center > .1)], [6 - number, number])
            self.assertEqual(ours.coordination(min_solid_angle=.1)[62], number)
        points, _ = crystal("bcc", 4)
        ours = dfs.delaunay3(points, weights=np.where(np.arange(len(points)) % 2 == 1, -3., 0))
        self.assertTrue(np.isfinite(ours.solid_angles).all())

    def test_copies_far_apart(self):
        """Points given 20000 and 40000 periods away: tetrahedra have no larger offsets than that, but two together have."""
        points = np.array(list(itertools.product(range(4), range(4), range(12))), dtype=float)
        near = dfs.delaunay3(points, box=(4, 4, None))
        points[:, 0] += 4 * 20000 * (np.sign(points[:, 2] - 6) + 1)
        far = dfs.delaunay3(points, box=(4, 4, None))
        self.assertEqual(set(far.facet_corners), {-1, 0, 4})
        for i in np.flatnonzero(near.voronoi_volumes > 0):
            self.assertEqual(len(far.voronoi_cell(i).faces), 6)

    def test_many_facets(self):
        """Of a point with 20000 neighbours, in whatever order the tetrahedra are: linear."""
        angles = np.arange(20000) * (2 * np.pi / 20000)
        ring = np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=1)
        far = [[0, 0, 50], [0, 0, -50], [50, 0, 0], [-50, 30, 0], [-40, -50, 3]]
        points = np.concatenate([[[0, 0, .1], [0, 0, -.1]], ring, far])
        ours = dfs.delaunay3(points)
        simplices = ours.simplices[np.argsort(-ours.simplices.max(axis=1), kind="stable")]
        sorted_ones = dfs.Delaunay3(points, simplices, None, ours.vertices, 3, 1)
        many = dfs.Delaunay3(points, simplices, sorted_ones.neighbors, ours.vertices, 3, 16)
        start = time.process_time()
        cell = sorted_ones.voronoi_cell(0)
        self.assertEqual(len(cell.faces), np.count_nonzero(many.facet_corners[(many.voronoi_facets.points == 0).any(axis=1)]))
        self.assertLess(time.process_time() - start, 5)

    def test_rounding_of_caller(self):
        """Measures do not depend on how the caller's thread rounds."""
        if platform.machine() not in ("x86_64", "AMD64") or not sys.platform.startswith("linux"):
            self.skipTest("skipped: the number of the mode is not known")
        upwards, math = 0x800, ctypes.CDLL("libm.so.6")

        def measures():
            ours = dfs.delaunay3(self.points)
            ours.neighbors, ours.convex_hull
            self.assertEqual(math.fesetround(upwards if is_upwards else 0), 0)
            try:
                return [ours.voronoi_volumes, ours.volumes, ours.circumradii, ours.transform,
                        ours.barycentric(self.points, np.zeros(len(self.points), dtype=int))]
            finally:
                math.fesetround(0)

        is_upwards = False
        expected = measures()
        is_upwards = True
        for measure, ours in zip(expected, measures()):
            np.testing.assert_array_equal(ours, measure)

    def test_cannot_be_changed(self):
        """What later answers are made of."""
        ours = dfs.delaunay3(self.points)
        for array in (ours.voronoi_volumes, ours.voronoi_areas, ours.facet_corners, ours.solid_angles,
                      *ours.voronoi_facets):
            with self.assertRaisesRegex(ValueError, "read-only"):
                array[:] = 0
        ours.coordination()[:] = 0

    def test_equal_and_hidden_points(self):
        points = np.floor(self.points * 2 ** 20) / 2 ** 20  # so that moves are not rounded
        twice = np.concatenate([points, points[:50] + [1, 0, -2]])
        ours = dfs.delaunay3(twice, box=(1, 1, 1))
        for i in (3, 17):
            self.assertEqual(ours.voronoi_volumes[150 + i], ours.voronoi_volumes[i])
            first, second = ours.voronoi_cell(i), ours.voronoi_cell(150 + i)
            np.testing.assert_allclose(second.vertices, first.vertices + [1, 0, -2], atol=1e-12)
            np.testing.assert_array_equal(second.offsets, first.offsets + [1, 0, -2])
            self.assertEqual(ours.coordination()[i], ours.coordination()[150 + i])
        heavy = dfs.delaunay3(twice[:150], weights=np.where(np.arange(150) == 5, .2, 0), box=(1, 1, 1))
        hidden = heavy.hidden[0]
        for values in (heavy.power_volumes, heavy.power_areas, heavy.coordination()):
            self.assertEqual(values[hidden], 0)
        with self.assertRaisesRegex(ValueError, f"power_cell: point {hidden} is hidden"):
            heavy.power_cell(hidden)

    def test_refusals(self):
        ours, weighted = self.kinds["points"], self.kinds["weights"]
        on_hull = ours.convex_hull[0, 0]
        for error, message, call in (
                (ValueError, f"voronoi_cell: point {on_hull}: its cell is unbounded",
                 lambda: ours.voronoi_cell(on_hull)),
                (ValueError, "voronoi_cell: i: expected a whole number from 0 to 149, got 150",
                 lambda: ours.voronoi_cell(150)),
                (TypeError, "voronoi_cell: i: expected a whole number", lambda: ours.voronoi_cell(.5)),
                (ValueError, "coordination: min_area: expected a share from 0 to 1, got 2",
                 lambda: ours.coordination(min_area=2)),
                (ValueError, "min_solid_angle: .* got nan", lambda: ours.coordination(min_solid_angle=float("nan"))),
                (ValueError, "voronoi_areas: .*use power_areas", lambda: weighted.voronoi_areas),
                (ValueError, "voronoi_facets: .*use power_facets", lambda: weighted.voronoi_facets),
                (ValueError, "voronoi_cell: .*use power_cell", lambda: weighted.voronoi_cell(0))):
            with self.assertRaisesRegex(error, message):
                call()
        both = dfs.delaunay3(self.points % 1, weights=np.zeros(len(self.points)), box=(1, 1, 1))
        for of_weights in (weighted, both):
            for name in dir(dfs.Delaunay3):
                if name.startswith(("voronoi", "circum", "minimum")) or name == "inside":
                    with self.assertRaisesRegex(ValueError, f"{name}: the points (have weights|are in a periodic box): "):
                        value = getattr(of_weights, name)
                        value(0) if name == "voronoi_cell" else value()
        for frozen in (pickle.loads(pickle.dumps(both)), copy.deepcopy(both)):
            self.assertFalse(frozen.weights.flags.writeable or frozen.box.flags.writeable)
        flat = dfs.delaunay3(self.points * [1, 1, 0])
        for name in ("voronoi_areas", "voronoi_facets", "facet_corners", "solid_angles"):
            with self.assertRaisesRegex(ValueError, f"{name}: there are no tetrahedra"):
                getattr(flat, name)
        wrong = dfs.Delaunay3(self.points, ours.simplices, ours.neighbors[::-1].copy(), ours.vertices, 3)
        with self.assertRaisesRegex(ValueError, "neighbors: they are not those of the simplices"):
            wrong.voronoi_facets


class Crystals(unittest.TestCase):
    """Cells that are known."""

    SHAPES = {  # faces with so many corners, their distance from the point, the surface area, and the vertices
        "sc": ({4: 6}, {4: 1}, 24, 8),
        "bcc": ({4: 6, 6: 8}, {4: 1, 6: 3 ** .5 / 2}, 3 + 6 * 3 ** .5, 24),
        "fcc": ({4: 12}, {4: .5 ** .5}, 6 * 2 ** .5, 14)}

    def check(self, diagram, i, kind):
        faces, distances, area, vertices = self.SHAPES[kind]
        cell = cell_of(diagram, i)
        self.assertEqual({size: sum(len(face) == size for face in cell.faces) for size in map(len, cell.faces)}, faces)
        self.assertEqual(len(cell.vertices), vertices)
        normals = areas_with_normals(cell)
        for face, normal in zip(cell.faces, normals / np.linalg.norm(normals, axis=1)[:, None]):
            self.assertAlmostEqual((cell.vertices[face[0]] - diagram.points[i]) @ normal, distances[len(face)], 12)
        self.assertAlmostEqual(measures_of(diagram)[1][i], area, 12)
        self.assertAlmostEqual(measures_of(diagram)[0][i], 8 / len(BASES[kind]), 12)

    def test_exact_lattices(self):
        for kind in BASES:
            points, box = crystal(kind, 3)
            for weights in (None, np.full(len(points), .25)):
                for of_box in (box, None, (box[0], None, box[2])):
                    diagram = dfs.delaunay3(points, weights=weights, box=of_box)
                    with self.subTest(kind, box=of_box, weights=weights is not None):
                        inner = np.flatnonzero(np.linalg.norm(points - box / 2 + .5, axis=1) < 1)
                        self.assertGreater(len(inner), 0)
                        for i in inner:
                            self.check(diagram, i, kind)
                        self.assertEqual(set(diagram.coordination()[inner]), {sum(self.SHAPES[kind][0].values())})

    def test_one_cube(self):
        """In a box so small that neighbours are copies of the points themselves."""
        for kind in BASES:
            points, box = crystal(kind, 1)
            self.check(dfs.delaunay3(points, box=box), 0, kind)

    def test_coordination(self):
        """The nearest and second neighbours of bcc; thresholds leave out facets of rounded and shaken lattices."""
        points, box = crystal("bcc", 4)
        ours = dfs.delaunay3(points, box=box)
        share = 1 / (3 + 6 * 3 ** .5) / 2  # of a square, which is smaller than a hexagon
        for least, number in ((0, 14), (share * .99, 14), (share * 1.01, 8), (.15, 0)):
            self.assertEqual(set(ours.coordination(min_area=least)), {number})
        squares = ours.solid_angles[ours.facet_corners == 4].max() / ours.solid_angles.max()
        for least, number in ((0, 14), (squares * .99, 14), (squares * 1.01, 8), (.999999, 8)):
            self.assertEqual(set(ours.coordination(min_solid_angle=least)), {number})
        self.assertEqual(set(ours.coordination(min_area=share * .99, min_solid_angle=squares * 1.01)), {8})
        points, box = crystal("fcc", 4)
        for scale, noise in ((4.05 / 2, 0), (1, 1e-6)):
            shaken = scale * points + noise * np.random.default_rng(1).random(points.shape)
            ours = dfs.delaunay3(shaken, box=scale * box)
            self.assertGreater(ours.coordination().max(), 12)
            self.assertEqual(set(ours.coordination(min_area=1e-3)), {12})
            self.assertEqual(set(ours.coordination(min_solid_angle=1e-3)), {12})


VORO = r"""
#include <cstdio>
#include <cstdlib>
#include <vector>
#include <voro++/voro++.hh>

template <class Container, class Put>
int print_cells(const double* box, const Put& put)
{
  Container cells(0, box[0], 0, box[1], 0, box[2], 6, 6, 6, true, true, true, 8);
  double p[4];
  for (int i = 0; std::scanf("%lf %lf %lf %lf", p, p + 1, p + 2, p + 3) == 4; ++i)
    put(cells, i, p);
  voro::c_loop_all loop(cells);
  voro::voronoicell_neighbor cell;
  if (loop.start())
    do
      if (cells.compute_cell(cell, loop)) {
        std::vector<int> neighbors;
        std::vector<double> areas;
        cell.neighbors(neighbors);
        cell.face_areas(areas);
        std::printf("%d %.17g %.17g", loop.pid(), cell.volume(), cell.surface_area());
        for (std::size_t k = 0; k < areas.size(); ++k)
          std::printf(" %d %.17g", neighbors[k], areas[k]);
        std::puts("");
      }
    while (loop.inc());
  return 0;
}

int main(int, char** arguments)
{
  const double box[3] = {std::atof(arguments[1]), std::atof(arguments[2]), std::atof(arguments[3])};
  if (arguments[4][0] == 'p')
    return print_cells<voro::container_poly>(
        box, [](auto& cells, int i, double* p) { cells.put(i, p[0], p[1], p[2], p[3]); });
  return print_cells<voro::container>(
      box, [](auto& cells, int i, double* p) { cells.put(i, p[0], p[1], p[2]); });
}
"""


class AsVoro(unittest.TestCase):
    """Cells of Voro++'s library, whose program writes no more than six digits."""

    @classmethod
    def setUpClass(cls):
        if shutil.which("c++") is None or not Path("/usr/include/voro++/voro++.hh").exists():
            raise unittest.SkipTest("skipped: voro++ or a compiler was not found")
        cls.folder = tempfile.TemporaryDirectory()
        source, cls.program = (Path(cls.folder.name) / name for name in ("cells.cpp", "cells"))
        source.write_text(VORO, encoding="ascii")
        subprocess.run(["c++", "-O1", source, "-lvoro++", "-o", cls.program], check=True)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def check(self, points, box, weights=None):
        ours = dfs.delaunay3(points, box=box, weights=weights)
        radii = np.zeros(len(points)) if weights is None else np.sqrt(weights)
        rows = "\n".join(" ".join(map(repr, row)) for row in np.column_stack([points, radii]).tolist())
        done = subprocess.run([self.program, *map(str, box), "c" if weights is None else "p"], input=rows, check=True,
                              capture_output=True, text=True)
        volumes, areas, facets = measures_of(ours)
        shared = np.zeros((len(points),) * 2)  # the areas between two points
        for k in (0, 1):
            np.add.at(shared, (facets[0][:, k], facets[0][:, 1 - k]), facets.areas)
        found = set()
        for line in done.stdout.splitlines():
            i, volume, area, *faces = map(float, line.split())
            i = int(i)
            found.add(i)
            self.assertAlmostEqual(volumes[i] / volume, 1, delta=1e-10)
            self.assertAlmostEqual(areas[i] / area, 1, delta=1e-10)
            theirs = np.bincount(np.array(faces[::2], dtype=int), faces[1::2], len(points))
            np.testing.assert_allclose(shared[i], theirs, atol=1e-10 * area, rtol=0)
        self.assertEqual(found, set(np.flatnonzero(volumes > 0)))

    def test_random(self):
        random = np.random.default_rng(7)
        for box in ((1, 1, 1), (2, .7, 1.3)):
            points = random.random((600, 3)) * box
            self.check(points, box)
            self.check(points, box, random.random(600) * .004)

    def test_packing(self):
        """Of few and many neighbours: a cluster in a box, and a lattice that is shaken."""
        random = np.random.default_rng(8)
        self.check(np.concatenate([.5 + .03 * random.normal(size=(200, 3)), random.random((200, 3))]), (1, 1, 1))
        points, box = crystal("fcc", 4)
        self.check(points + .3 * random.random(points.shape) + .1, box)


class Example(unittest.TestCase):
    def test_crystal(self):
        done = subprocess.run([sys.executable, Path(__file__).with_name("examples").resolve() / "crystal.py"],
                              capture_output=True, text=True, check=True)
        self.assertIn("neighbours of the vacancy: 12.80 cubic ångström each; coordination numbers 11 for 12 of them\n",
                      done.stdout)
        self.assertIn("coordination numbers 12 for 2035 of them\n", done.stdout)


if __name__ == "__main__":
    unittest.main()
