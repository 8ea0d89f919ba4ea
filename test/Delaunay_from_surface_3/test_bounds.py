# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Gappa proves the bounds of the filters: bounds/README.md says how. Constants and formulas are those in the headers."""

import shutil
import subprocess
import sys
import unittest
from fractions import Fraction
from pathlib import Path

FOLDER = Path(__file__).resolve().parent / "bounds"
sys.path.insert(0, str(FOLDER))

import scripts  # pylint: disable=wrong-import-position


def proves(text):
    done = subprocess.run(["gappa"], input=text, capture_output=True, text=True, check=False)
    if done.returncode != 0 and "some properties were not satisfied" not in done.stderr.lower():
        raise AssertionError(done.stderr)
    return done.returncode == 0


class Bounds(unittest.TestCase):
    def test_scripts_are_those_of_the_headers(self):
        self.assertEqual({path.stem for path in FOLDER.glob("*.g")}, set(scripts.SCRIPTS))
        for name in scripts.SCRIPTS:
            self.assertEqual((FOLDER / f"{name}.g").read_text(encoding="utf-8"), scripts.text_of(name),
                             f"{name}: python3 scripts.py writes it anew")

    def test_table(self):
        table = (FOLDER / "README.md").read_text(encoding="utf-8")
        for name, (_, constant, least) in scripts.SCRIPTS.items():
            self.assertIn(f"| `{name}` | {shown(constant())} | {shown(least)} |", table)

    @unittest.skipUnless(shutil.which("gappa"), "skipped: Gappa (Debian: gappa) was not found")
    def test_proofs(self):
        for name, (make, constant, least) in scripts.SCRIPTS.items():
            with self.subTest(name):
                self.assertGreaterEqual(constant(), least)
                self.assertTrue(proves(make(constant())))
                if name not in scripts.SLOW:
                    self.assertTrue(proves(make(least)))
                    self.assertFalse(proves(make(scripts.smaller(least))))  # a wrong one is found


def shown(constant):
    """As the headers write it."""
    constant = Fraction(constant)
    if constant.denominator == 1:
        return str(constant)
    power = constant.denominator.bit_length() - 1
    return f"2^-{power}" if constant == Fraction(1, 2**power) else f"{float(constant):.0e}"


if __name__ == "__main__":
    unittest.main()
