# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Calls that must not compile give one error each, and it says what is wrong."""

import os
import re
import subprocess
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
SOURCE = HERE / "refused" / "refused_code.cpp"
INCLUDE = HERE.parent.parent / "include"


class RefusedCode(unittest.TestCase):
    def test_messages(self):
        expected = re.findall(r"// expected: (.*)", SOURCE.read_text(encoding="utf-8"))
        done = subprocess.run([os.environ.get("CXX", "c++"), "-std=c++17", "-fsyntax-only", f"-I{INCLUDE}", SOURCE],
                              capture_output=True, text=True, check=False)
        errors = [line for line in done.stderr.splitlines() if "error:" in line]
        self.assertNotEqual(done.returncode, 0)
        self.assertGreater(len(expected), 0)
        for message in expected:
            self.assertEqual(sum(message in line for line in errors), expected.count(message), "\n".join([message, *errors]))
        self.assertEqual(len(errors), len(expected), "\n".join(errors))


if __name__ == "__main__":
    unittest.main()
