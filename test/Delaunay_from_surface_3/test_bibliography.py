# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Citations in the manual and in comments name entries of the bibliography, and each entry is cited."""

import re
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MANUAL = ROOT / "doc/Delaunay_from_surface_3"

# Names and a year: "Choi 2002", "Lazarus et al. 2001", "Marot, Pellerin, Remacle 2019".
NAMES_AND_YEAR = re.compile(r"(?:[A-Z][a-z][\w-]+, )*[A-Z][\w-]+(?: et al\.)? (?:19|20)\d\d\b")


def texts(*folders):
    return [path.read_text(encoding="utf-8")
            for folder in folders for path in sorted((ROOT / folder).rglob("*"))
            if path.suffix in {".h", ".cpp", ".txt"} and path.name != "Bibliography.txt"]


def comments(text):
    """Those that begin with //, as one line."""
    return " ".join(line.strip(" /") for line in re.findall(r"//(?!.*Copyright).*", text))


class Bibliography(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        page = (MANUAL / "Bibliography.txt").read_text(encoding="utf-8")
        cls.headings = dict(re.findall(r"^\\section bib_(\S+) (.*)$", page, re.MULTILINE))
        cls.cited_keys = {key for text in texts("include", "doc")
                          for key in re.findall(r"\\cgalCite\{([^}]*)\}", text)}
        cls.cited_names = {name for text in texts("include", "examples", "generator", "benchmark", "demo")
                           for name in NAMES_AND_YEAR.findall(comments(text))}

    def test_page_is_that_of_the_entries(self):
        done = subprocess.run([sys.executable, "-B", MANUAL / "bibliography.py", "--check"], check=False)
        self.assertEqual(done.returncode, 0, "run doc/Delaunay_from_surface_3/bibliography.py")

    def test_what_is_cited_exists(self):
        self.assertEqual(self.cited_keys - set(self.headings), set())
        self.assertIn("Choi 2002", self.cited_names)
        self.assertEqual(self.cited_names - set(self.headings.values()), set())

    def test_what_exists_is_cited(self):
        self.assertEqual({key for key, heading in self.headings.items()
                          if key not in self.cited_keys and heading not in self.cited_names}, set())


if __name__ == "__main__":
    unittest.main()
