# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The pages of the manual that show measured results have the tables that their scripts make of the committed JSON."""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
MANUAL = HERE.parents[1] / "doc/Delaunay_from_surface_3"


class Manual_tables(unittest.TestCase):
    def run_script(self, script, patterns, page, *options):
        results = sorted(path for pattern in patterns for path in (HERE / "results").glob(pattern))
        return subprocess.run([sys.executable, "-B", HERE / script, *results, "--manual", page, *options], text=True,
                              capture_output=True)

    def check(self, page, script, *patterns):
        text = (MANUAL / page).read_text()
        result = self.run_script(script, patterns, MANUAL / page, "--check")
        self.assertEqual(result.returncode, 0, result.stderr)

        # A stale figure, and a table without its place, are seen; the first is made good again.
        stale = re.sub(r"\d \|\n\n<!-- end", "x |\n\n<!-- end", text)
        with tempfile.TemporaryDirectory() as folder:
            copy = Path(folder) / page
            for changed in (stale, re.sub("<!-- [a-z]", "<!-- a", text)):
                self.assertNotEqual(changed, text)
                copy.write_text(changed)
                result = self.run_script(script, patterns, copy, "--check")
                self.assertEqual(result.returncode, 1)
                self.assertIn(f"{script}: ", result.stderr)
            copy.write_text(stale)
            result = self.run_script(script, patterns, copy)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual(copy.read_text(), text)

    def test_performance(self):
        self.check("Performance.txt", "plot_results.py", "compare_*.json", "paper_*.json")

    def test_theory(self):
        self.check("Theory.txt", "plot_location_costs.py", "location_costs.json")

    def test_statements(self):
        self.check("Statements.txt", "statement_tables.py", "subgraphs_traced*.json")

    def test_subgraphs(self):
        self.check("bounded_degree_subgraphs.txt", "subgraph_tables.py", "subgraph_*.json")

    def test_orders(self):
        self.check("Orders.txt", "order_tables.py", "orders*.json", "nets_*.json", "*_meshes.json")

    def test_threads(self):
        self.check("Threads.txt", "thread_tables.py", "threads*.json")


if __name__ == "__main__":
    unittest.main()
