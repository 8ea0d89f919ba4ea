# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Runs `delaunay_from_surface tiles` as a user would: killed again and again, with little memory, task by task by several
processes, and on bad input. With LONG=1 in the environment the points are 30 million, and the limit is 2 GB."""

import array
import ast
import fcntl
import json
import os
import random
import resource
import shutil
import signal
import struct
import subprocess
import time
import unittest

from program_case import ProgramCase

LONG = os.environ.get("LONG") == "1"
POINTS, MEMORY, LIMIT = (30000000, "1200M", 2000) if LONG else (60000, "4M", 300)


def write_points(path, n, seed=1):
    """Random ones near a sphere, which is as large as it is far from the origin."""
    source = random.Random(seed)
    with open(path, "wb") as file:
        for first in range(0, n, 100000):
            numbers = array.array("d")
            for _ in range(min(100000, n - first)):
                x, y, z = (source.gauss(0, 1) for _ in range(3))
                scale = source.uniform(.98, 1) / (x * x + y * y + z * z) ** .5
                numbers.extend((1 + scale * x, scale * y, scale * z))
            numbers.tofile(file)


def read_npy(path):
    """Its type, shape and numbers."""
    data = path.read_bytes()
    length, = struct.unpack("<H", data[8:10])
    head = ast.literal_eval(data[10:10 + length].decode())
    numbers = array.array({"<i8": "q", "<f8": "d"}[head["descr"]])
    numbers.frombytes(data[10 + length:])
    return head["shape"], numbers


class Tiles(ProgramCase):
    program = os.environ["DELAUNAY_FROM_SURFACE"]

    def command(self, *arguments):
        return [self.program, "tiles", *map(str, arguments)]

    def works(self, *arguments, **options):
        return super().works("tiles", *arguments, **options)

    def fails(self, *arguments, says, **options):
        self.refuses(f".*(?:{says})", "tiles", *arguments, **options)

    def test_killed_and_resumed_with_little_memory(self):
        points = self.folder / "points.raw"
        write_points(points, POINTS)

        def limit():
            resource.setrlimit(resource.RLIMIT_AS, (LIMIT * 2**20, LIMIT * 2**20))
        arguments = (points, "--memory", MEMORY, "--output")
        whole = self.folder / "whole"
        begin = time.monotonic()
        report = json.loads(self.works(*arguments, whole, "--json", preexec_fn=limit))
        lapse = (time.monotonic() - begin) / 4  # so the first call is killed
        self.assertEqual(report["points"], POINTS)
        self.assertIn("holds", report["certificate"])
        source, kills = random.Random(2), 0
        while True:
            with subprocess.Popen(self.command(*arguments, self.folder / "killed"), stdout=subprocess.DEVNULL,
                                  preexec_fn=limit) as process:
                try:
                    process.wait(timeout=source.uniform(lapse / 10, lapse))
                    break
                except subprocess.TimeoutExpired:
                    self.assertFalse((self.folder / "killed/tiles.json").exists())
                    process.kill()
                    kills += 1
                    lapse *= 1.2  # whatever a single step takes
        self.assertEqual(process.returncode, 0)
        self.assertGreater(kills, 0)
        self.assertEqual(json.loads((whole / "tiles.json").read_text()),
                         json.loads((self.folder / "killed/tiles.json").read_text()))
        if not LONG:
            for file in whole.glob("*.npy"):
                self.assertEqual(file.read_bytes(), (self.folder / "killed" / file.name).read_bytes())
        self.assertEqual([], [*self.folder.glob("**/*.unfinished")])
        self.works(*arguments, whole, "--quiet")
        self.works(*arguments, whole, notes="note: .*whole: an earlier run wrote these tiles; nothing was left to be done\n")

    def test_by_several_processes(self):
        points, output = self.folder / "points.raw", self.folder / "tiles"
        write_points(points, 3000)
        arguments = (points, "--tiles", 5, "--output", output, "--vtu")
        stages = 0
        while (n := int(self.works(*arguments, "--next"))) > 0:
            tasks = [*range(n), 0]  # one twice
            random.Random(stages).shuffle(tasks)
            processes = [subprocess.Popen(self.command(*arguments, "--task", k)) for k in tasks]
            self.assertEqual({process.wait() for process in processes}, {0})
            stages += 1
        self.assertGreater(stages, 5)
        self.fails(*arguments, "--task", 5, says="there are tasks 0 to 4 only")
        here = self.folder / "here"
        self.works(points, "--tiles", 5, "--output", here, "--threads", 2, "--join", self.folder / "all.npy",
                   "--quiet")
        self.assertEqual((here / "tiles.json").read_text(), (output / "tiles.json").read_text())
        shape, joined = read_npy(self.folder / "all.npy")
        cells = []
        for t in range(5):
            (vertices, _), coordinates = read_npy(output / f"points-{t:05}.npy")
            (same,), ids = read_npy(output / f"ids-{t:05}.npy")
            self.assertEqual((vertices, len(coordinates)), (same, 3 * len(ids)))
            cells += read_npy(output / f"cells-{t:05}.npy")[1]
            piece = (output / f"tile-{t:05}.vtu").read_bytes()
            self.assertIn(b'GlobalIds="id"', piece)
            self.assertTrue(piece.endswith(b"</VTKFile>\n"))
            self.assertIn(f'Source="tile-{t:05}.vtu"', (output / "tiles.pvtu").read_text())
        self.assertEqual((shape, cells), ((len(cells) // 4, 4), list(joined)))
        numbers = array.array("d")
        numbers.frombytes(points.read_bytes())
        self.assertEqual(list(coordinates[:3]), list(numbers[3 * ids[0]:3 * ids[0] + 3]))

    def test_bad_input(self):
        points, output = self.folder / "points.raw", self.folder / "tiles"
        write_points(points, 500)
        self.fails("--output", output, says="no points given")
        self.fails(points, says="'--output' needs a folder")
        self.fails(self.folder / "none.npy", "--output", output, says="none.npy: cannot be read: No such file")
        for memory in ("", "8X", "1K", "-1G", "nan", "8GG"):
            self.fails(points, "--output", output, f"--memory={memory}", says="memory")
        for tiles in (0, -1, 1000001, "x"):
            self.fails(points, "--output", output, f"--tiles={tiles}", says="tiles")
        self.fails(points, "--output", output, "--next", "--task", 0, says="exclude each other")
        self.fails(points, "--output", points, says="points.raw/state: cannot be written")
        bad = self.folder / "bad.raw"
        bad.write_bytes(points.read_bytes() + struct.pack("<3d", 1, float("inf"), 1))
        self.fails(points, bad, "--output", output, says="bad.raw: point 500: a coordinate is not a finite number")
        self.assertFalse((output / "tiles.json").exists())
        self.works(points, "--output", output, "--quiet")  # nothing of it is left
        self.fails(points, bad, "--output", output, says="holds the state of a run on another input, of 500 points")
        full = self.folder / "full"
        self.fails(points, "--output", full, "--tiles", 3, says="File too large|No space left|cannot be written",
                   preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (8000, 8000)), restore_signals=False)
        self.assertEqual([], [*full.glob("**/*.unfinished"), *full.glob("*.npy")])
        self.works(points, "--output", full, "--tiles", 3, "--quiet")  # goes on when there is room

    def test_a_tile_that_is_too_large(self):
        points = self.folder / "points.raw"
        write_points(points, 20000)
        self.fails(points, "--output", self.folder / "given", "--tiles", 2, "--memory", "2M",
                   says="tile [01] of .* keeps more than .* that it may; point .* tiles would do")
        report = json.loads(self.works(points, "--output", self.folder / "chosen", "--memory", "2MB", "--json"))
        self.assertGreater(report["tiles"], 4)

    def test_in_a_folder_that_is_used(self):
        points, output = self.folder / "points.raw", self.folder / "tiles"
        write_points(points, 500)
        output.mkdir()
        folder = os.open(output, os.O_RDONLY)
        self.addCleanup(os.close, folder)
        fcntl.flock(folder, fcntl.LOCK_SH)  # as who does a task
        self.fails(points, "--output", output, says="tiles: another run is at work there")
        self.works(points, "--output", output, "--next")
        fcntl.flock(folder, fcntl.LOCK_EX)
        self.fails(points, "--output", output, "--task", 0, says="tiles: another run is at work there")
        fcntl.flock(folder, fcntl.LOCK_UN)
        self.works(points, "--output", output, "--quiet")
        self.fails(points, "--output", output, "--vtu", says="tiles: a tile has been removed, or tiles are written without .vtu")

    def test_input_and_output_that_are_not_overwritten(self):
        points, output = self.folder / "points.raw", self.folder / "tiles"
        write_points(points, 500)
        self.works(points, "--tiles", 3, "--output", output, "--quiet")
        tile = output / "points-00001.npy"
        before = tile.read_bytes()
        self.fails(tile, "--output", output, says="points-00001.npy: would be overwritten")
        self.fails(tile.name, "--output", ".", says="points-00001.npy: would be overwritten", cwd=output)
        self.assertEqual(tile.read_bytes(), before)
        shutil.rmtree(output / "state")
        (output / "tiles.json").unlink()
        (output / "cells-00000.npy").unlink()
        self.fails(points, "--tiles", 3, "--output", output, says="cells-00001.npy: is of another run")
        pipe = self.folder / "pipe"
        os.mkfifo(pipe)
        self.fails(points, "--output", self.folder / "others", "--join", pipe,
                   says="pipe: cannot be written: it is no regular file")

    def test_join_writes_over_nothing_that_is_read(self):
        """Whatever it is called, and before there is any work: no tile is written."""
        points, other, output = self.folder / "a.npy", self.folder / "b-neighbors.npy", self.folder / "tiles"
        head = b"{'descr': '<f8', 'fortran_order': False, 'shape': (200, 3), }".ljust(117) + b"\n"
        for path in (points, other):
            write_points(self.folder / "raw", 200, seed=len(path.name))
            path.write_bytes(b"\x93NUMPY\1\0" + struct.pack("<H", 118) + head + (self.folder / "raw").read_bytes())
        (self.folder / "link.npy").symlink_to(points)
        os.link(points, self.folder / "hard.npy")
        (self.folder / "folder").symlink_to(output)
        output.mkdir()
        before = points.read_bytes(), other.read_bytes()
        for join, more, says in (
                (points, [], "a.npy: would overwrite the points of .*a.npy: name another file"),
                (self.folder / "link.npy", [], "link.npy: would overwrite the points of .*a.npy"),
                (self.folder / "hard.npy", [], "hard.npy: would overwrite the points of .*a.npy"),
                (self.folder / "b.npy", ["--neighbors"], "b-neighbors.npy: would overwrite the points of .*b-neighbors.npy"),
                (output / "cells-00000.npy", [], "cells-00000.npy: would overwrite a file of the run: name another file"),
                (output / "points-00007.npy", [], "points-00007.npy: would overwrite a file of the run"),
                (output / "tiles.json", [], "tiles.json: would overwrite a file of the run"),
                (output / "tiles.pvtu", [], "tiles.pvtu: would overwrite a file of the run"),
                (output / "state" / "input", [], "input: would overwrite a file of the run"),
                (output / "state" / "neighbors" / "all.npy", [], "all.npy: would overwrite a file of the run"),
                (self.folder / "folder" / "ids-00000.npy", [], "ids-00000.npy: would overwrite a file of the run"),
                (self.folder / "missing" / "all.npy", [], "all.npy: cannot be written: No such file or directory"),
                (self.folder, [], "cannot be written: Is a directory")):
            self.fails(points, other, "--tiles", 2, "--output", output, "--join", join, *more, says=says)
            self.assertEqual((points.read_bytes(), other.read_bytes(), list(output.iterdir())), (*before, []))
        for option in (["--next"], ["--task", 0]):
            self.fails(points, "--output", output, "--join", self.folder / "all.npy", *option,
                       says="'--join' excludes '--next' and '--task'; give it when all tasks are done")
        self.works(points, other, "--tiles", 2, "--output", output, "--join", output / "all.npy", "--neighbors", "--quiet")
        self.assertEqual(read_npy(output / "all.npy")[0], read_npy(output / "all-neighbors.npy")[0])

    def test_interrupted_before_it_joins(self):
        """Nothing of the joined file stays, and the work goes on."""
        points = self.folder / "points.raw"
        write_points(points, 20000)
        for end in (signal.SIGINT, signal.SIGTERM):
            output = self.folder / end.name
            arguments = (points, "--tiles", 9, "--output", output, "--join", self.folder / "all.npy")
            with subprocess.Popen(self.command(*arguments), stdout=subprocess.DEVNULL) as process:
                while not (output / "state" / "input").exists() and process.poll() is None:
                    time.sleep(.01)
                self.assertEqual(len([*self.folder.glob("all.npy-*.unfinished")]), 1)
                process.send_signal(end)
            self.assertEqual(process.returncode, -end)
            self.assertEqual([], [*self.folder.glob("all.npy*")])
        self.works(*arguments, "--quiet")
        self.assertEqual(len([*self.folder.glob("all.npy*")]), 1)

    def test_files_of_others_stay(self):
        """Only what a run has left is removed, and only where it is; folders that cannot be read are not looked into."""
        points, output = self.folder / "points.raw", self.folder / "tiles"
        write_points(points, 500)
        (output / "below").mkdir(parents=True)
        (output / "lost+found").mkdir()
        strangers = ["film.unfinished", "film-12.unfinished", "cells-00000.npy.unfinished", "cells-1.npy-7.unfinished",
                     "below/cells-00000.npy-77.unfinished", "below/film-3.unfinished", "state-old.unfinished", "tiles.json-x1.unfinished"]
        ours = ["cells-00000.npy-77.unfinished", "tiles.json-12.unfinished", "tile-00003.vtu-5.unfinished"]
        for name in (*strangers, *ours):
            (output / name).write_text("precious")
        os.chmod(output / "lost+found", 0)
        self.works(points, "--tiles", 3, "--output", output, "--quiet")
        for name in strangers:
            self.assertEqual((output / name).read_text(), "precious", name)
        self.assertEqual([name for name in ours if (output / name).exists()], [])
        self.assertTrue((output / "tiles.json").exists())
        if os.geteuid() == 0:  # whom no mode keeps out: the same as another user, if there is one
            return
        os.chmod(output, 0o300)
        self.addCleanup(os.chmod, output, 0o700)
        self.fails(points, "--tiles", 3, "--output", output, says="tiles: cannot be read: Permission denied")


if __name__ == "__main__":
    unittest.main()
