# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""Tiles by a Dask cluster of processes on this machine: the same as in memory, also when workers are killed."""

import contextlib
import os
import shutil
import signal
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path

import numpy as np

import delaunay_from_surface as dfs

try:
    import dask.array
    from distributed import Client, LocalCluster, wait
except ImportError:
    print("skipped: tiles by Dask, as dask.distributed (Debian: python3-dask, python3-distributed) was not found")
    sys.exit()

sys.path.insert(0, str(Path(__file__).resolve().parent))
from test_module import cell_set, random_points  # pylint: disable=wrong-import-position


def torus(n):
    s, t = 2 * np.pi * random_points(n, 5)[:, :2].T
    return np.column_stack(((2 + .5 * np.cos(s)) * np.cos(t), (2 + .5 * np.cos(s)) * np.sin(t), .5 * np.sin(s)))


class ByDask(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.cluster = LocalCluster(n_workers=2, threads_per_worker=1, host="127.0.0.1", dashboard_address=None,
                                   silence_logs=50)
        cls.addClassCleanup(cls.cluster.close)
        cls.client = Client(cls.cluster)
        cls.addClassCleanup(cls.client.close)

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.points = random_points(3000)
        self.file = self.folder / "points.npy"
        np.save(self.file, self.points)

    def check(self, tiles, points):
        expected = dfs.delaunay3(points).simplices
        cells = tiles.cells()
        self.assertEqual((cells.shape, cells.dtype, cells.numblocks), (expected.shape, np.int64, (len(tiles), 1)))
        self.assertEqual(cell_set(self.client.compute(cells).result()), cell_set(expected))
        self.assertEqual((tiles.report["points"], tiles.report["certified"]), (len(points), True))
        tile = self.client.compute(tiles[1]).result()
        np.testing.assert_array_equal(tile.points, points[tile.ids])
        self.assertEqual(len(tile.cells), tiles.numbers_of_cells[1])

    def test_a_file_and_an_array(self):
        tiles = dfs.delaunay3_dask(self.file, self.client, self.folder / "of file", tiles=7, vtu=True)
        self.check(tiles, self.points)
        self.assertTrue((self.folder / "of file/tiles.pvtu").exists())
        array = dask.array.from_array(self.points.astype(np.float32), chunks=(1000, 2))
        for _ in range(2):  # nothing is left to be done
            self.check(dfs.delaunay3_dask(array, self.client, self.folder / "of array", tiles=5),
                       self.points.astype(np.float32).astype(float))
        with self.assertRaisesRegex(OSError, "is of another array"):
            dfs.delaunay3_dask(array + 1, self.client, self.folder / "of array", tiles=5)
        for k in range(2):  # the name does not tell these apart
            other = dask.array.from_array(self.points + k, chunks=(1000, 3), name="mine")
            with self.assertRaisesRegex(OSError, "is of another array of this name") if k else contextlib.nullcontext():
                named = dfs.delaunay3_dask(other, self.client, self.folder / "named", tiles=5)
        keys = {named[0].key}  # tile 0 of more tiles is another
        named.numbers_of_cells.append(1)
        self.assertNotIn(named[0].key, keys)

    def test_killed_workers(self):
        """One after the first round, as soon as it has a task; and then whichever, again and again."""
        points = random_points(30000, 3)
        np.save(self.file, points)
        output, killed = self.folder / "tiles", []
        is_over = threading.Event()

        def kill():
            state = output / "state"
            while not is_over.is_set():
                if (state / "closed-0").exists() and (not killed or (len(killed) < 3 and time.monotonic() > killed[-1] + 2)):
                    busy = [address for address, tasks in self.client.processing().items() if tasks]
                    workers = [w for w in self.cluster.workers.values() if w.worker_address in busy]
                    if workers:
                        os.kill(workers[0].process.process.pid, signal.SIGKILL)
                        killed.append(time.monotonic())
                time.sleep(.005)
        killer = threading.Thread(target=kill)
        killer.start()
        try:
            tiles = dfs.delaunay3_dask(self.file, self.client, output, tiles=40)
        finally:
            is_over.set()
            killer.join()
        self.assertGreater(len(killed), 0)
        self.check(tiles, points)

    def test_more_tiles_where_one_is_too_large(self):
        np.save(self.file, random_points(9000))
        tiles = dfs.delaunay3_dask(self.file, self.client, self.folder / "tiles", memory="1M")
        self.assertGreater(len(tiles), 10)
        np.save(self.file, torus(20000))  # begins again more than once
        tiles = dfs.delaunay3_dask(self.file, self.client, self.folder / "torus", memory=1250000)
        self.assertGreater(len(tiles), 60)
        with self.assertRaisesRegex(MemoryError, "tiles would do"):
            dfs.delaunay3_dask(self.file, self.client, self.folder / "given", tiles=2, memory="1M")

    def test_refusals(self):
        output = self.folder / "tiles"
        np.save(self.folder / "nan.npy", np.full((10, 3), np.nan))
        for points, error, says in ((self.folder / "none.npy", OSError, "none.npy"),
                                    ([self.folder / "nan.npy"], ValueError, "point 0"), (self.points, TypeError, "from_array"),
                                    (dask.array.zeros((5, 2)), ValueError, r"shape \(n, 3\)"),
                                    (dask.array.zeros((5, 3), dtype=complex), TypeError, "complex128"),
                                    (dask.array.ma.masked_array(dask.array.zeros((5, 3)), mask=True), ValueError, "mask")):
            with self.assertRaisesRegex(error, says):
                dfs.delaunay3_dask(points, self.client, output, tiles=2)
        for arguments in ({"memory": "8X"}, {"tiles": 0}):
            with self.assertRaises(ValueError):
                dfs.delaunay3_dask(self.file, self.client, output, **arguments)
        for refused, says in ((np.full((10, 3), np.nan), "point 0"), (random_points(100) * [1, 1, 0], "one plane")):
            array = dask.array.from_array(refused, chunks=(50, 3))
            with self.assertRaisesRegex(ValueError, says):
                dfs.delaunay3_dask(array, self.client, output, tiles=2)
        # What others have in a folder of the same name stays, and is not taken for the array's.
        (output / "points").mkdir()
        (output / "points" / "notes.txt").write_text("precious")
        np.save(output / "points" / "00000.npy", np.full((10, 3), np.nan))
        with self.assertRaisesRegex(ValueError, "point 0"):
            dfs.delaunay3_dask([output / "points" / "00000.npy"], self.client, output, tiles=2)
        array = dask.array.from_array(self.points, chunks=(1000, 3))
        with self.assertRaisesRegex(OSError, "has files of points that are not of this array: name another folder"):
            dfs.delaunay3_dask(array, self.client, output, tiles=2)
        self.assertEqual(sorted(file.name for file in (output / "points").iterdir()), ["00000.npy", "notes.txt"])
        (output / "points" / "00000.npy").unlink()
        with self.assertRaisesRegex(ValueError, "point 0"):
            dfs.delaunay3_dask(dask.array.from_array(np.full((10, 3), np.nan)), self.client, output, tiles=2)
        self.assertEqual([file.name for file in (output / "points").iterdir()], ["notes.txt"])
        shutil.rmtree(output / "points")
        old = self.client.persist(dfs.delaunay3_dask(array, self.client, output, tiles=2).cells())  # nothing of those is left
        wait(old)
        shutil.rmtree(output)
        tiles = dfs.delaunay3_dask(self.file, self.client, output, tiles=2)
        np.save(self.file, random_points(3000, 9))
        shutil.rmtree(output)
        other = dfs.delaunay3_dask(self.file, self.client, output, tiles=2)
        self.assertNotEqual(cell_set(self.client.compute(other.cells()).result()), cell_set(self.client.compute(old).result()))
        with self.assertRaises(IndexError):
            tiles[2]


if __name__ == "__main__":
    unittest.main()
