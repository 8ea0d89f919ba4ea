# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""scripts/shrink leaves the points without which nothing fails. The program is one that fails as it is told."""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SHRINK = Path(__file__).resolve().parents[2] / "scripts/shrink"
# Fails if it sees points 3 and 13, by their x.
PROGRAM = """#!{python}
import sys
xs = [float(line.split()[0]) for line in open(sys.argv[1])]
print('{{"sphere tests": %d}}' % (900 if 5. in xs and "--stats" in sys.argv else 40))
if 3. in xs and 13. in xs:
    {failure}
"""


class Shrink(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def shrink(self, name, text, failure, *options):
        program = self.folder / "program"
        program.write_text(PROGRAM.format(python=sys.executable, failure=failure))
        program.chmod(0o755)
        file = self.folder / name
        file.write_text(text)
        return subprocess.run([sys.executable, SHRINK, file, "--program", program, *options], capture_output=True, text=True,
                              check=False)

    def check(self, done, kind, xs):
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(done.stdout.startswith(f"// {kind}: {len(xs)} of 16 points"), done.stdout)
        self.assertEqual([float.fromhex(x) for x in re.findall(r"\{(-?0x[^,]*),", done.stdout)], xs)

    def test_kinds(self):
        lines = "".join(f"{i} {i * .1!r} -1e-300\n" for i in range(16))
        braces = ", ".join(f"{{{float(i).hex()}, 0, -0x1p-1074}}" for i in range(16)) + "\nfaces: {0, 1, 2}"
        off = f"OFF\n16 1 0\n# x y z\n{lines}3 0 1 2\n"
        for name, text in (("a.xyz", lines), ("a.txt", braces), ("a.off", off)):
            self.check(self.shrink(name, text, "sys.exit(2)"), "differs", [3., 13.])
        self.check(self.shrink("a.xyz", lines, "sys.exit(f'error: {len(xs)} are too many')"), "error: N are too many",
                   [3., 13.])
        self.check(self.shrink("a.xyz", lines, "import os; os.abort()"), "signal 6", [3., 13.])
        self.check(self.shrink("a.xyz", lines, "pass", "--tests", "300"), "slow", [5.])

    def test_refused(self):
        for text, message in (("1 2 3\n", "nothing fails with the 1 points of"), ("1 2 x\n", "could not be read")):
            done = self.shrink("a.xyz", text, "pass")
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stderr, rf"\Aerror: .*{message}")


if __name__ == "__main__":
    unittest.main()
