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

import fill_manual

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PAGES = sorted({page for _, page, _, _ in fill_manual.TABLES})
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

    def fill(self, root, *options):
        return subprocess.run([sys.executable, "-B", HERE / "fill_manual.py", "--root", root, *options], text=True,
                              capture_output=True)

    def test_pages_have_the_tables_of_the_results(self):
        result = self.fill(ROOT, "--check")
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_stale_figures_are_seen(self):
        texts = {page: (ROOT / page).read_text() for page in PAGES}
        with tempfile.TemporaryDirectory() as folder:
            for page, text in texts.items():
                (Path(folder) / page).parent.mkdir(parents=True, exist_ok=True)
                (Path(folder) / page).write_text(text)
            for page, text in texts.items():
                stale = re.sub(r"\d(\D*\n\n<!-- end)", r"x\1", text, count=1)
                for changed in (stale, re.sub(r"<!-- (?=\w+ -->\n(?!.*<!-- end))", "<!-- no_", text, count=1)):
                    self.assertNotEqual(changed, text)
                    (Path(folder) / page).write_text(changed)
                    result = self.fill(folder, "--check")
                    self.assertEqual(result.returncode, 1)
                    self.assertRegex(result.stderr, f"^fill_manual.py: .*{re.escape(page)}")
                (Path(folder) / page).write_text(stale)
                self.assertEqual(self.fill(folder).returncode, 0)
                self.assertEqual((Path(folder) / page).read_text(), text)

    def test_theory(self):
        self.check(["Theory.txt"], "plot_location_costs.py", "location_costs.json")

    def test_statements(self):
        self.check(["Statements.txt"], "statement_tables.py", "subgraphs_traced*.json", "uniform_samples.json",
                   "paper_256k.json")

    def test_subgraphs(self):
        self.check(["bounded_degree_subgraphs.txt"], "subgraph_tables.py", "subgraph_*.json")

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
