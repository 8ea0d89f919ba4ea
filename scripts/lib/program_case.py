# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""What the tests of programs share. CMake's add_python_test() puts the paths of programs into the environment."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TORUS = ROOT / "examples/Delaunay_from_surface_3/data/torus.off"


def python_with(module):
    """A Python that has the module: this one, or the system's; None if neither does."""
    return next((python for python in (sys.executable, "/usr/bin/python3")
                 if os.path.exists(python) and subprocess.run([python, "-c", f"import {module}"],
                                                              capture_output=True).returncode == 0), None)


class ProgramCase(unittest.TestCase):
    """Runs `program` in an empty folder of the test's own, as a user would."""

    program = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_program(self, *arguments, **keywords):
        return subprocess.run([os.path.abspath(self.program), *map(str, arguments)], cwd=keywords.pop("cwd", self.folder), text=True,
                              stdout=keywords.pop("stdout", subprocess.PIPE), stderr=subprocess.PIPE, **keywords)

    def works(self, *arguments, prints=(), notes="", **keywords):
        """It ends with 0, prints what is expected, and writes `notes` and nothing else to the standard error."""
        result = self.run_program(*arguments, **keywords)
        self.assertEqual(result.returncode, 0, result.stderr)
        for expected in prints:
            self.assertRegex(result.stdout, expected)
        self.assertRegex(result.stderr, rf"\A{notes}\Z")
        return result.stdout

    def refuses(self, message, *arguments, prefix="error: ", **keywords):
        """It ends with 1 and one line on the standard error, leaves nothing behind, and changes nothing."""
        before = self.files()
        result = self.run_program(*arguments, **keywords)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertRegex(result.stderr, rf"\A{prefix}{message}[^\n]*\n\Z")
        self.assertEqual(self.files(), before)

    def write(self, name, *lines):
        path = self.folder / name
        path.write_bytes(lines[0] if lines and isinstance(lines[0], bytes) else
                         "".join(line + "\n" for line in lines).encode())
        return path

    def files(self):
        return {path.name: path.read_bytes() for path in self.folder.iterdir() if path.is_file()}
