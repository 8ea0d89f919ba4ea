# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The figures of manual and readme: text can be read, alternative texts say what is seen, nothing is missing or left
over, and the plots are those of the committed results."""

import re
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
MANUAL = ROOT / "doc/Delaunay_from_surface_3"
FIGURES = MANUAL / "fig"
PAGE, NARROW_PAGE = 864, 420  # pixels
LEAST_TEXT = 11  # pixels
MADE_WITH = "3.6"  # Matplotlib; another version may write other bytes

FIGURE = re.compile(r"\\dfsFigureBegin\{((?:[^{}]|\{[^{}]*\})*)\}")
SIZE = re.compile(r"(?:^|[;\s])font(?:-size)?:\s*(?:[a-z]+\s+)*([\d.]+)px")


def size_in(style):
    match = SIZE.search(style or "")
    return float(match[1]) if match else None


def text_sizes(svg):
    """Of all text, in pixels of the drawing; and the width of the drawing."""
    root = ElementTree.fromstring(svg)
    rules = {selector.strip(): size_in(body) for element in root.iter() if element.tag.endswith("style")
             for selector, body in re.findall(r"([^{}]+)\{([^{}]*)\}", element.text or "")}
    sizes = []

    def visit(element, size):
        tag = element.tag.split("}")[-1]
        of_classes = [rules.get("." + name) for name in element.get("class", "").split()]
        attribute = element.get("font-size")
        for found in (rules.get(tag), *of_classes, float(attribute.rstrip("px")) if attribute else None,
                      size_in(element.get("style"))):
            size = found or size
        if tag in ("text", "tspan") and (element.text or "").strip():
            sizes.append(size)
        for child in element:
            visit(child, size)

    visit(root, 16)
    return sizes, float(root.get("viewBox").split()[2])


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
    def test_text_can_be_read(self):
        for path in sorted(FIGURES.glob("*.svg")):
            sizes, width = text_sizes(path.read_text())
            page = NARROW_PAGE if path.name == "times.svg" else PAGE
            if sizes:
                self.assertGreaterEqual(min(sizes) * page / width, LEAST_TEXT, path.name)

    def test_small_text_is_found(self):
        svg = ('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 864 9"><style>text{font:14px sans-serif}.s{'
               'font-size:12px}</style><text>a</text><g class="s"><text class="s">b<tspan font-size="10">c</tspan>'
               '</text></g><text style="font: bold 9.5px \'DejaVu Sans\'; fill: red">d</text></svg>')
        self.assertEqual(text_sizes(svg), ([14, 12, 10, 9.5], 864))

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
        self.assertEqual(shown, {Path(word).name for word in listed.split() if "/fig/" in word})
        in_readme = {(ROOT / path).resolve() for _, path in images_of_readme()}
        there = {path for path in FIGURES.iterdir() if path.suffix in (".svg", ".webp", ".png")}
        self.assertEqual({FIGURES / name for name in shown} | in_readme, there)

    def test_plots_are_those_of_the_results(self):
        with tempfile.TemporaryDirectory() as folder:
            result = subprocess.run([HERE / "draw_figures", folder], text=True, capture_output=True)
            if result.returncode == 3:
                self.skipTest("skipped: the plots are not drawn, as Matplotlib was not found")
            self.assertEqual(result.returncode, 0, result.stderr)
            drawn = sorted(Path(folder).iterdir())
            self.assertGreater(len(drawn), 8)
            if f"with Matplotlib {MADE_WITH}" not in result.stdout:
                self.skipTest(f"skipped: the plots were made with Matplotlib {MADE_WITH}, and are not compared")
            for path in drawn:
                self.assertEqual(path.read_text(), (FIGURES / path.name).read_text(),
                                 f"{path.name} is not what draw_figures makes of the results: run it")


if __name__ == "__main__":
    unittest.main()
