# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The figures of manual and readme: alternative texts say what is seen, nothing is missing or left over, and all plots can be
drawn from the results."""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from program_case import python_with

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
MANUAL = ROOT / "doc/Delaunay_from_surface_3"
FIGURES = MANUAL / "fig"

FIGURE = re.compile(r"\\dfsFigureBegin\{((?:[^{}]|\{[^{}]*\})*)\}")


def figures_of_manual():
    """[(page, [name, file, alternative text])]"""
    return [(page.name, [part.replace("\\,", ",").strip() for part in re.split(r"(?<!\\),", match[1])])
            for page in sorted(MANUAL.glob("*.txt")) for match in FIGURE.finditer(page.read_text())]


def images_of_readme():
    """[(alternative text, path)]"""
    text = (ROOT / "README.md").read_text()
    found = re.findall(r"!\[([^\]]*)\]\(([^)\s]*)\)", text)
    for tag in re.findall(r"<img [^>]*>", text):
        found.append((re.search(r'alt="([^"]*)"', tag)[1], re.search(r'src="([^"]*)"', tag)[1]))
    return [(alt, path) for alt, path in found if "://" not in path]


class Figures(unittest.TestCase):
    def test_alternative_texts_say_what_is_seen(self):
        for page, parts in figures_of_manual():
            self.assertEqual(len(parts), 3, f"{page}: {parts[0]} has no alternative text")
            self.assertGreater(len(parts[2]), 50, f"{page}: {parts[0]}")
            self.assertNotIn('"', parts[2], f"{page}: {parts[0]}")
        for alt, path in images_of_readme():
            self.assertGreater(len(alt), 50, path)

    def test_nothing_is_missing_or_left_over(self):
        shown = {parts[1] for _, parts in figures_of_manual()}
        listed = re.search(r"HTML_EXTRA_FILES +=((?:.*\\\n)*.*)", (MANUAL / "Doxyfile.in").read_text())[1]
        images = [word for word in listed.split() if word.endswith((".svg", ".webp", ".png"))]
        self.assertEqual(shown, {Path(word).name for word in images})
        in_readme = {(ROOT / path).resolve() for _, path in images_of_readme()}
        there = {path for path in FIGURES.iterdir() if path.suffix in (".svg", ".webp", ".png")}
        self.assertEqual({FIGURES / Path(word).name for word in images if "/fig/" in word} | in_readme, there)

    def test_help_without_matplotlib(self):
        """With nothing but Python's own modules."""
        for option in ("--help", "-h"):
            done = subprocess.run([sys.executable, "-S", "-B", HERE / "draw_figures.py", option], text=True, capture_output=True)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn("Draws the plots", done.stdout)

    def test_plots_are_drawn(self):
        python = python_with("matplotlib")
        if python is None:
            self.skipTest("skipped: nothing is drawn, as Matplotlib was not found")
        with tempfile.TemporaryDirectory() as folder:
            drawn = subprocess.run([python, "-B", HERE / "draw_figures.py", folder], text=True, capture_output=True)
            self.assertEqual(drawn.returncode, 0, drawn.stderr)
            for path in Path(folder).iterdir():
                self.assertTrue((FIGURES / path.name).exists(), path.name)


if __name__ == "__main__":
    unittest.main()
