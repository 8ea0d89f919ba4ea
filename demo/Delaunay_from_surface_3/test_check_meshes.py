# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Runs scripts/check_meshes on a folder of small meshes, and with programs that fail."""

import json
import os
import unittest

from program_case import ROOT, TORUS, ProgramCase


class Check_meshes(ProgramCase):
    program = ROOT / "scripts/check_meshes"

    def check(self, *options, program=os.environ["DELAUNAY_FROM_SURFACE"]):
        result = self.run_program("meshes", "--program", program, "--json", "all.json", *options)
        return result, json.loads((self.folder / "all.json").read_text())

    def setUp(self):
        super().setUp()
        (self.folder / "meshes/more").mkdir(parents=True)
        self.write("meshes/torus.off", TORUS.read_bytes())
        self.write("meshes/more/points.OFF", "OFF", "3 0 0", "0 0 0", "1 0 0", "5 0 0")
        self.write("meshes/notes.txt", "no mesh")

    def stand_in(self, text):
        path = self.write("stand_in", "#!/bin/sh", text)
        path.chmod(0o755)
        return path

    def test_good_and_bad_meshes(self):
        self.write("meshes/words.off", "once upon a time")
        self.write("meshes/scan.xyz", "0 0 0", "1 0 0", "0 1 0", "0 0 1", "2 2 2")
        self.write("meshes/scan.pts", "4", "0 0 0", "1 0 0", "0 1 0", "0 0 1")
        result, report = self.check("--least-vertices", 900, "--traits", "plain")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertRegex(result.stdout, r"\Amore/points.OFF: equal, 3 vertices, [^\n]*\nscan.pts: equal, 4 vertices, [^\n]*\n"
                         r"scan.xyz: equal, 5 vertices, [^\n]*\ntorus.off: equal, 960 vertices, "
                         r"plain [0-9.]+ s, package [0-9.]+ s, ratio [0-9.]+\nwords.off: error: error: [^\n]*\n"
                         r"meshes: 5, equal: 4, different: 0, error: 1, crash: 0, too long: 0\n"
                         r"ratio, [^\n]* of 1 meshes: geometric mean [^\n]*\n\Z")
        ratio = report["meshes"][3]["ratio"]
        self.assertEqual([m["state"] for m in report["meshes"]], ["equal"] * 4 + ["error"])
        self.assertAlmostEqual(report["summary"]["ratios"]["geometric_mean"], ratio)
        self.assertEqual(report["summary"]["ratios"]["share_below_1"], int(ratio < 1))

    def test_programs_that_fail(self):
        for text, state in (("exit 2", "different"), ("kill -9 $$", "crash"), ("exec sleep 60", "too long")):
            with self.subTest(state):
                values = "echo 'vertices: 3'; echo 'plain CPU seconds: 3'; echo 'package CPU seconds: 2'; "
                result, report = self.check("--time-limit", 1, program=self.stand_in(values + text))
                self.assertEqual(result.returncode, 1, result.stderr)
                self.assertEqual([m["state"] for m in report["meshes"]], [state, state])

    def test_no_folder(self):
        result = self.run_program("nowhere")
        self.assertEqual(result.returncode, 2)
        self.assertIn("nowhere is not a folder", result.stderr)


if __name__ == "__main__":
    unittest.main()
