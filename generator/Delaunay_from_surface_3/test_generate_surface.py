# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Runs the program generate_surface as a user would."""

import os
import resource
import unittest

from program_case import TORUS, ProgramCase


class Generate_surface(ProgramCase):
    program = os.environ["GENERATE_SURFACE"]

    def refuses(self, message, *arguments, **keywords):
        super().refuses(message, *arguments, "--output", "refused.off", prefix="generate_surface: ", **keywords)

    def test_shapes(self):
        self.works("--shape", "sphere", "--vertices", 100, "--noise", 0.01, "--output", "sphere.ply", "--check",
                   prints=["100 vertices, 196 faces", "1 components, Euler characteristic 2"])
        self.works("--shape", "loop", "--input", TORUS, "--output", "loop.off", prints=["3840 vertices, 7680 faces"])
        for name in ("cube", "plummer", "soneira-peebles", "boxes"):  # points without faces
            self.works("--shape", name, "--vertices", 9000, "--output", "points.off", prints=[r"\d+ vertices, 0 faces"])
        self.assertEqual(sorted(self.files()), ["loop.off", "points.off", "sphere.ply"])

    def test_numbers_without_sense(self):
        for number in ("inf", "nan", "-inf"):
            self.refuses("--noise must be a finite number", "--shape", "sphere", "--noise", number)
            self.refuses("--thickness must be a finite number", "--shape", "thin-plate", "--thickness", number)
            self.refuses("the jitter must be", "--shape", "sphere", "--jitter", number)
        self.refuses("the coordinates of this surface are too large", "--shape", "sphere", "--noise", 1e308)
        self.refuses("--vertices must lie between", "--shape", "sphere", "--vertices", -1)

    def test_inputs(self):
        for name, message, *lines in (
                ("index.off", "face 0: it has a vertex that is not one of the 3", "OFF", "3 1 0", "0 0 0", "1 0 0",
                 "0 1 0", "3 0 1 1000000"),
                ("index.obj", "face 0: it has a vertex that is not one of the 3", "v 0 0 0", "v 1 0 0", "v 0 1 0",
                 "f 1 2 4"),
                ("nan.off", "a coordinate is not a finite number", "OFF", "3 1 0", "0 0 0", "1 0 nan", "0 1 0", "3 0 1 2"),
                ("points.off", "there is no mesh in it", "OFF", "3 0 0", "0 0 0", "1 0 0", "0 1 0")):
            with self.subTest(name):
                self.write(name, *lines)
                self.refuses(rf"{name}: [^\n]*{message}", "--shape", "loop", "--input", name)
        self.refuses(r"nowhere\?\.off: No such file", "--shape", "loop", "--input", "nowhere\n.off")

    def test_output_over_input(self):
        mine = self.folder / "mine.off"
        mine.write_bytes(TORUS.read_bytes())
        super().refuses(".*mine.off: would overwrite the input", "--shape", "loop", "--input", "mine.off", "--output",
                        mine, prefix="generate_surface: ")
        self.assertEqual(mine.read_bytes(), TORUS.read_bytes())

    def test_a_disk_that_is_full(self):
        """Nothing is left of the file, and an older one stays."""
        self.write("refused.off", "an older result")
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))
        for name in ("refused.off", "refused.ply"):
            super().refuses("refused.*: cannot be written", "--shape", "sphere", "--output", name,
                            prefix="generate_surface: ", preexec_fn=limit, restore_signals=False)


if __name__ == "__main__":
    unittest.main()
