# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""README and the pages of the manual that show measured results have the tables that fill_manual.py makes of the
committed JSON."""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import fill_manual

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PAGES = sorted({page for page, *_ in fill_manual.TABLES})
MOST_ROWS = 11  # of a table on a page of the manual


def fill(root, *options):
    return subprocess.run([sys.executable, "-B", HERE / "fill_manual.py", "--root", root, *options], text=True,
                          capture_output=True)


class Manual_tables(unittest.TestCase):
    def test_pages_have_the_tables_of_the_results(self):
        result = fill(ROOT, "--check")
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_stale_figures_are_seen(self):
        """And a table without its place; filled, each page is as it was."""
        texts = {page: (ROOT / page).read_text() for page in PAGES}
        with tempfile.TemporaryDirectory() as folder:
            for page, text in texts.items():
                (Path(folder) / page).parent.mkdir(parents=True, exist_ok=True)
                (Path(folder) / page).write_text(text)
            for page, text in texts.items():
                first, *_ = fill_manual.BLOCK.finditer(text)
                stale = re.sub(r"\d", "x", first[0], count=1)
                for changed in (stale, first[0].replace(first[1], "no_" + first[1], 1)):
                    self.assertNotEqual(changed, first[0])
                    (Path(folder) / page).write_text(text.replace(first[0], changed))
                    result = fill(folder, "--check")
                    self.assertEqual(result.returncode, 1)
                    self.assertRegex(result.stderr, f"^fill_manual.py: .*{re.escape(page)}")
                (Path(folder) / page).write_text(text.replace(first[0], stale))
                self.assertEqual(fill(folder).returncode, 0)
                self.assertEqual((Path(folder) / page).read_text(), text)

    def test_no_table_is_long(self):
        for page in PAGES:
            if page.endswith(".txt"):
                rows = [len(re.findall(r"^\|", block[0], re.M)) for block in fill_manual.BLOCK.finditer((ROOT / page).read_text())]
                self.assertLessEqual(max(rows), MOST_ROWS + 2, page)

    def test_all_results_are_listed(self):
        self.assertEqual(sorted(fill_manual.SHOWS), sorted(path.stem for path in (HERE / "results").glob("*.json")))


if __name__ == "__main__":
    unittest.main()
