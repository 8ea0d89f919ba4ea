# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Runs `delaunay_from_surface_mpi` as a user would: it writes what `delaunay_from_surface tiles` writes, and whatever
goes wrong on one rank ends all of them soon, with one line that says where."""

import fcntl
import json
import os
import struct
import subprocess
import unittest

from program_case import ProgramCase
from test_tiles_program import read_npy, write_points

PROGRAM, BY_MPI, MPIEXEC = (os.environ[name] for name in ("DELAUNAY_FROM_SURFACE", "DELAUNAY_FROM_SURFACE_MPI",
                                                          "MPIEXEC"))


class ByMpi(ProgramCase):
    def setUp(self):
        super().setUp()
        self.points, self.output = self.folder / "points.raw", self.folder / "tiles"
        write_points(self.points, 6000)

    def run_ranks(self, *commands):
        """One for each rank. That they end is a part of the test."""
        parts = [["-n", "1", *map(str, command)] for command in commands]
        words = [word for part in parts for word in (":", *part)][1:]
        return subprocess.run([MPIEXEC, *words], capture_output=True, text=True, check=False, timeout=60)

    def works(self, ranks, *arguments):
        run = self.run_ranks(*[(BY_MPI, *arguments)] * ranks)
        errors = [line for line in run.stderr.splitlines() if line.startswith("error:")]  # MPI may have notes
        self.assertEqual((errors, run.returncode), ([], 0))
        return run.stdout

    def fails(self, *commands, says):
        run = self.run_ranks(*commands)
        self.assertNotEqual(run.returncode, 0)
        errors = [line for line in run.stderr.splitlines() if line.startswith("error: ")]
        self.assertEqual(len(errors), 1, run.stderr)
        self.assertRegex(errors[0], f"^error: .*{says}")

    def test_the_same_as_out_of_core(self):
        here = self.folder / "here"
        subprocess.run([PROGRAM, "tiles", self.points, "--tiles", "5", "--output", here, "--vtu", "--quiet",
                        "--join", self.folder / "here.npy"], check=True)
        shape, cells = read_npy(self.folder / "here.npy")
        first = None
        for ranks, extra in ((1, ()), (2, ("--threads", 2)), (2, ("--vtu",))):
            output = self.folder / f"tiles-{ranks}-{len(extra)}-{'--vtu' in extra}"
            report = json.loads(self.works(ranks, self.points, "--tiles", 5, "--output", output, "--json",
                                           "--join", self.folder / "joined.npy", *extra))
            self.assertEqual((report["points"], report["ranks"]), (6000, ranks))
            self.assertEqual((output / "tiles.json").read_text(), (here / "tiles.json").read_text())
            self.assertEqual(read_npy(self.folder / "joined.npy")[0], shape)
            self.assertEqual({tuple(sorted(cells[i:i + 4])) for i in range(0, len(cells), 4)},
                             {tuple(sorted(joined[i:i + 4])) for joined in [read_npy(self.folder / "joined.npy")[1]]
                              for i in range(0, len(joined), 4)})
            files = {file.name: file.read_bytes() for file in output.glob("*.npy")}
            first = first or files
            self.assertEqual(files, first)  # whatever the number of ranks and threads
        self.assertEqual((output / "tiles.pvtu").read_text(), (here / "tiles.pvtu").read_text())
        self.assertEqual(len([*output.glob("tile-*.vtu")]), 5)

    def test_what_goes_wrong_on_one_rank(self):
        good = (BY_MPI, self.points, "--output", self.output)
        missing = self.folder / "missing.raw"
        self.fails(good, (BY_MPI, missing, "--output", self.output), says="rank 1: .*missing.raw: cannot be read: No")
        shorter = self.folder / "shorter.raw"
        shorter.write_bytes(self.points.read_bytes()[:24 * 5000])
        self.fails(good, (BY_MPI, shorter, "--output", self.output), says="rank 1: sees 5000 points, and rank 0 6000")
        other = self.folder / "other.raw"
        write_points(other, 6000, seed=2)
        self.fails(good, (BY_MPI, other, "--output", self.output), says="rank 1: .*other.raw: there are other points")
        for options in (("--tiles", 7), ("--vtu",), ("--join", self.folder / "joined.npy")):
            self.fails(good, (*good, *options), says=f"rank 1: .* other options than rank 0: {options[0]}")
        self.fails(good, (BY_MPI, self.points, "--output", self.folder / "there"), says="rank 1: .*: --output")
        self.assertEqual([], [*self.output.glob("*")])
        self.assertFalse((self.folder / "there").exists())
        bad = self.folder / "bad.raw"
        bad.write_bytes(struct.pack("<3d", 1, float("nan"), 1))
        both = (BY_MPI, self.points, bad, "--output", self.output)
        self.fails(both, both, says="rank 1: .*bad.raw: point 0: a coordinate is not a finite number")
        full = ("sh", "-c", 'trap "" XFSZ; ulimit -f 16; exec "$@"', "sh", *good)
        self.fails(good, full, says="rank 1: .*tiles/.*00001.npy: cannot be written: File too large")
        self.assertEqual([], [*self.output.glob("**/*.unfinished"), *self.output.glob("tiles.json")])
        self.fails(good, (*good, "--join", self.folder), (*good, "--threads", 99), says="threads")
        same = self.folder / "same.raw"  # at another time
        same.write_bytes(self.points.read_bytes())
        os.utime(same, (1, 1))
        done = self.run_ranks((*good, "--quiet"), (BY_MPI, same, "--output", self.output))  # over what is left
        self.assertEqual(done.returncode, 0, done.stderr)
        self.fails(good, good, says="rank 0: .*tiles.json: is of another run")

    def test_what_a_run_that_failed_left(self):
        self.output.mkdir()
        left = [self.output / name for name in ("cells-00007.npy", "ids-00007.npy", "points-100000.npy", "neighbors-00007.npy",
                                                "tile-00000.vtu", "tiles.pvtu", "cells-00001.npy-123.unfinished")]
        kept = [self.output / name for name in ("notes.txt", "points-a.npy", "points-1.npy")]
        for file in left + kept:
            file.write_text("text")
        command = (BY_MPI, self.points, "--output", self.output)
        self.fails(command, command, says="rank 0: .*: is not of a run that was stopped here")  # nobody has begun one
        self.assertEqual(left, [file for file in left if file.exists()])
        (self.output / "tiles.begun").touch()
        self.works(2, self.points, "--output", self.output, "--quiet")
        self.assertFalse((self.output / "tiles.begun").exists())
        self.assertEqual([], [file for file in left if file.exists()])
        self.assertEqual(kept, [file for file in kept if file.exists()])
        self.assertEqual(len([*self.output.glob("cells-*")]), 2)
        used = self.folder / "used"
        used.mkdir()
        folder = os.open(used, os.O_RDONLY)
        self.addCleanup(os.close, folder)
        fcntl.flock(folder, fcntl.LOCK_SH)  # as a run that is not over
        command = (BY_MPI, self.points, "--output", used)
        self.fails(command, command, says="rank 0: .*used: another run is at work there")
        self.assertEqual([], [*used.glob("*")])
        # Where points are is nothing to be overwritten.
        points = self.folder / "points-00005.npy"
        points.write_bytes((self.output / "points-00000.npy").read_bytes())
        command = (BY_MPI, points, "--output", self.folder)
        self.fails(command, command, says="rank 0: .*points-00005.npy: would be overwritten")
        self.assertTrue(points.exists())

    def test_join_that_cannot_be(self):
        command = (BY_MPI, self.points, "--output", self.output)
        for name, says in ((self.folder, "Is a directory"), (self.folder / "missing" / "a.npy", "No such file")):
            self.fails(*[(*command, "--join", name)] * 2, says=f"rank 0: .*: cannot be written: {says}")
            self.assertEqual([], [*self.output.glob("*")])  # nothing was begun
        (self.folder / "link.npy").symlink_to(self.points)
        before = self.points.read_bytes()
        for name, says in ((self.points, "would overwrite the points of"), (self.folder / "link.npy", "would overwrite the points of"),
                           (self.output / "cells-00001.npy", "would overwrite a file of the run"),
                           (self.output / "tiles.json", "would overwrite a file of the run")):
            self.fails(*[(*command, "--join", name)] * 2, says=f"rank 0: .*: {says}")
            self.assertEqual((before, []), (self.points.read_bytes(), [*self.output.glob("*")]))
        self.works(2, self.points, "--output", self.output, "--join", self.output / "all.npy", "--quiet")
        self.assertEqual([], [*self.output.glob("*.unfinished")])
        cells = sum(read_npy(file)[0][0] for file in self.output.glob("cells-*"))
        self.assertEqual(read_npy(self.output / "all.npy")[0], (cells, 4))

    def test_join_afterwards(self):
        command = (BY_MPI, self.points, "--output", self.output, "--tiles", 8, "--quiet",
                   "--join", self.folder / "all.npy")
        full = ("sh", "-c", 'trap "" XFSZ; ulimit -f 1000; exec "$@"', "sh", *command)
        self.fails(full, command, says="rank 0: .*all.npy: cannot be written: File too large")
        self.assertEqual([], [*self.folder.glob("all.npy*")])

        def times():
            return {file: file.stat().st_mtime_ns for file in self.output.iterdir()}

        before = times()
        self.assertIn(self.output / "tiles.json", before)
        self.works(2, *command[1:])
        self.assertEqual(times(), before)  # nothing was done again
        cells = sum(read_npy(file)[0][0] for file in self.output.glob("cells-*"))
        self.assertEqual(read_npy(self.folder / "all.npy")[0], (cells, 4))
        other = self.folder / "other.raw"
        write_points(other, 6000, seed=2)
        command = (BY_MPI, other, *command[2:])
        self.fails(command, command, says="rank 0: .*tiles.json: is of another run")

    def test_command_line(self):
        self.assertIn("mpirun -n RANKS", self.works(2, "--help"))
        good = (BY_MPI, self.points, "--output", self.output)
        done = self.run_ranks(good, (BY_MPI, "--help"))
        self.assertIn("mpirun -n RANKS", done.stdout)
        self.assertFalse(self.output.exists())
        for arguments, says in (((), "no points given"), ((self.points,), "'--output' needs a folder"),
                                ((self.points, "--tiles", "0"), "tiles"), (("--what",), "what.*--help explains")):
            self.fails((BY_MPI, *arguments), (BY_MPI, *arguments), says=says)
        flat = self.folder / "flat.raw"
        flat.write_bytes(b"".join(struct.pack("<3d", i % 7, i // 7, 2) for i in range(99)))
        command = (BY_MPI, flat, "--output", self.output)
        self.fails(command, command, says="the points lie in one plane")


if __name__ == "__main__":
    unittest.main()
