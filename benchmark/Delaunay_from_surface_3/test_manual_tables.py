# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""README and the pages of the manual that show measured results have the tables that their scripts make of the
committed JSON."""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
MANUAL = HERE.parents[1] / "doc/Delaunay_from_surface_3"


class Manual_tables(unittest.TestCase):
    def run_script(self, script, patterns, pages, *options):
        results = sorted(path for pattern in patterns for path in (HERE / "results").glob(pattern))
        return subprocess.run([sys.executable, "-B", HERE / script, *results, "--manual", *pages, *options], text=True,
                              capture_output=True)

    def check(self, pages, script, *patterns):
        texts = {page: (MANUAL / page).read_text() for page in pages}
        result = self.run_script(script, patterns, [MANUAL / page for page in pages], "--check")
        self.assertEqual(result.returncode, 0, result.stderr)

        # A stale figure, and a table without its place, are seen on each page; the first is made good again.
        with tempfile.TemporaryDirectory() as folder:
            copies = {page: Path(folder) / Path(page).name for page in pages}
            for page, text in texts.items():
                for name, copy in copies.items():
                    copy.write_text(texts[name])
                stale = re.sub(r"\d \|\n\n<!-- end", "x |\n\n<!-- end", text)
                for changed in (re.sub("<!-- [a-z]", "<!-- a", text), stale):
                    self.assertNotEqual(changed, text)
                    copies[page].write_text(changed)
                    result = self.run_script(script, patterns, copies.values(), "--check")
                    self.assertEqual(result.returncode, 1)
                    self.assertIn(f"{script}: ", result.stderr)
                result = self.run_script(script, patterns, copies.values())
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertEqual(copies[page].read_text(), text)

    def test_performance(self):
        self.check(["Performance.txt", "Performance_tables.txt"], "plot_results.py", "compare_*.json", "paper_*.json")

    def test_readme(self):
        self.check(["../../README.md"], "readme_tables.py", "compare_peers.json", "threads_256k.json",
                   "orders_200k.json", "demo_meshes.json", "python.json")

    def test_consumers(self):
        self.check(["Consumers.txt"], "consumer_tables.py", "consumers.json", "thinning.json", "python.json")

    def test_parts(self):
        self.check(["Delaunay_from_surface_3.txt"], "part_tables.py", "parts.json")

    def test_sources(self):
        self.check(["Sources.txt"], "source_tables.py", "sources*.json")

    def test_paper(self):
        self.check(["The_paper.txt"], "paper_tables.py")

    def test_orders(self):
        self.check(["Orders.txt"], "order_tables.py", "orders*.json", "flat_and_far.json", "nets_*.json", "*_meshes.json",
                   "single_calls.json", "calls_*.json")

    def test_where_results_come_from(self):
        sources = (HERE / "measure_all").read_text() + (HERE / "README.md").read_text()
        for path in (HERE / "results").glob("*.json"):
            self.assertIn(path.stem, sources)

    def test_threads(self):
        self.check(["Threads.txt"], "thread_tables.py", "threads*.json")


if __name__ == "__main__":
    unittest.main()
