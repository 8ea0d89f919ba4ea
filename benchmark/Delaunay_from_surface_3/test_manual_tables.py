# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""README and the pages of the manual that show measured results have the tables that their scripts make of the
committed JSON."""

import json
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

    def test_cluster(self):
        """Its figures stand in sentences."""
        def counts(name):
            record = json.loads((HERE / f"results/{name}.json").read_text())["results"][0]
            self.assertEqual(record["input"], "elephant")
            return {count["tiles"]: count for count in record["counts"]}

        def sent(count):
            return [str(round(count["load"]["bytes_sent_per_own_point"][key])) for key in ("mean", "worst")]

        text = " ".join((MANUAL / "On_a_cluster.txt").read_text().split())
        large, small = counts("tiles_load_2M"), counts("tiles_load")
        mean, worst = sent(large[1024])
        self.assertIn(f"sends {mean} bytes for each of its points (the worst {worst}), in {large[1024]['rounds']} rounds, in up to "
                      f"{large[1024]['load']['most_messages_of_a_tile']} messages", text)
        mean, worst = sent(large[64])
        self.assertIn(f"in 64 tiles {mean} bytes ({worst})", text)
        self.assertIn(f"in {small[1024]['rounds']} rounds.", text)
        self.assertEqual([count["pairs_that_differed"] > 0 for count in (large[1024], small[1024])], [False, True])

    def test_readme(self):
        self.check(["../../README.md"], "readme_tables.py", "compare_peers.json", "threads_256k.json",
                   "orders_200k.json", "demo_meshes.json", "python.json")

    def test_consumers(self):
        self.check(["Consumers.txt"], "consumer_tables.py", "consumers.json", "thinning.json", "python.json")

    def test_parts(self):
        self.check(["Delaunay_from_surface_3.txt"], "part_tables.py", "parts.json")

    def test_sources(self):
        self.check(["Sources.txt"], "source_tables.py", "sources*.json")

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
