# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The manual on its own links CGAL's and can be linked, and its formulas are drawn; and it builds as one of CGAL's
manuals, by CGAL's macros."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from headless_chromium import LISTEN, chromium, report_in

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
MANUAL = ROOT / "doc/Delaunay_from_surface_3"
CONCEPTS = sorted(path.stem for path in (MANUAL / "Concepts").glob("*.h"))
CGAL_TAGS = HERE / "manual/cgal.tag"
MATHJAX = Path(os.environ["MATHJAX"])
HAS_MATHJAX = (MATHJAX / "MathJax.js").exists()

# Nothing but files, and what is in the page: the page is told of all else that it asks for.
ONLY_FILES = """<meta http-equiv="Content-Security-Policy"
  content="default-src file: data: 'unsafe-inline' 'unsafe-eval'">
"""
# What a reader sees when all formulas are drawn.
LOOK = """<script>
window.MathJax = {AuthorInit: () => MathJax.Hub.Register.StartupHook("End", () => {
  const count = (selector) => document.querySelectorAll(selector).length;
  const report = document.createElement("pre");
  report.id = "report";
  report.textContent = JSON.stringify({problems, formulas: count("span.formula"),
    drawn: count("span.formula > .MathJax_SVG > svg path, span.formula > .MathJax_SVG > svg use"),
    with_a_drawing: count("span.formula:has(> .MathJax_SVG > svg)"), errors: count("merror, .MathJax_Error"),
    text: document.querySelector("div.contents").innerText});
  document.body.append(report);
})};
</script>
"""
# Where a narrow window has what.
MEASURE = """<script>
addEventListener("load", () => {
  const top = (selector) => document.querySelector(selector).getBoundingClientRect().top + scrollY;
  const report = document.createElement("pre");
  report.id = "report";
  report.textContent = JSON.stringify({title: top("div.headertitle > div.title"), tree: top("#nav-tree"),
    width: document.documentElement.scrollWidth, window: innerWidth});
  document.body.append(report);
});
</script>
"""

PAGES_WITH_FORMULAS = ("index.html", "delaunay_from_surface_3_the_paper.html",
                       "classCGAL_1_1Delaunay__from__surface__3_1_1Log__star__rounds.html")

# Doxygen needs bibtex for \cite; that all keys exist is the matter of test_bibliography.
NO_BIBTEX = re.compile(r"bibtex|\.bbl|\\cite command|^citelist")


def finish_pages(html, mathjax):
    return subprocess.run([sys.executable, "-B", MANUAL / "finish_pages.py", html, mathjax], capture_output=True,
                          text=True, check=True).stdout


def doxygen(doxyfile):
    done = subprocess.run([os.environ["DOXYGEN"], doxyfile], cwd=MANUAL, capture_output=True, text=True, check=False)
    return done.stderr.splitlines()


class Standalone(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.html = Path(folder.name) / "html"
        subprocess.run([os.environ["CMAKE"], f"-DCGAL_PACKAGE_DIR={ROOT}",
                        f"-DDOC_OUTPUT_DIR={folder.name}", "-DPROJECT_VERSION=1.2.3",
                        f"-DDELAUNAY_FROM_SURFACE_3_DOC_TAGFILES={CGAL_TAGS}=https://cgal.example/manual",
                        "-P", ROOT / "cmake/configure_manual.cmake"], check=True)
        cls.warnings = doxygen(Path(folder.name) / "Doxyfile")
        cls.unfinished = {name: (cls.html / name).read_text(encoding="utf-8") for name in PAGES_WITH_FORMULAS}
        cls.said = finish_pages(cls.html, MATHJAX)

    def page(self, name):
        return (self.html / name).read_text(encoding="utf-8")

    def test_no_warnings(self):
        self.assertEqual(self.warnings, [])

    def test_links_cgal(self):
        link = 'href="https://cgal.example/manual/classCGAL_1_1Delaunay__triangulation__3.html"'
        self.assertIn(link, self.page("group__PkgDelaunayFromSurface3Ref.html"))

    def test_can_be_linked(self):
        tags = self.page("Delaunay_from_surface_3.tag")
        self.assertIn("<name>insert_surface_vertices_3</name>", tags)
        self.assertIn("<name>InsertionPlan</name>", tags)

    def test_concepts_are_called_concepts(self):
        listed = self.page("group__PkgDelaunayFromSurface3Concepts.html")
        for concept in CONCEPTS:
            pages = [page for page in self.html.glob("class*.html")
                     if re.fullmatch(rf"class\w*?{concept.replace('_', '__')}\.html", page.name)]
            self.assertEqual(len(pages), 1, concept)
            text = pages[0].read_text(encoding="utf-8")
            self.assertIn(f"Concept {concept}</", text)
            self.assertNotIn("Class Reference", text)
        self.assertEqual(listed.count(">concept &#160;"), len(CONCEPTS))
        self.assertIn("Class Reference", self.page("classCGAL_1_1Delaunay__from__surface__3_1_1Full__graph.html"))

    @unittest.skipUnless(HAS_MATHJAX and "CHROMIUM" in os.environ, "Chromium or MathJax was not found")
    def test_formulas_in_a_browser(self):
        self.assertEqual(self.said, "")
        for name in PAGES_WITH_FORMULAS:
            page = self.page(name).replace("<head>\n", "<head>\n" + ONLY_FILES + LISTEN + LOOK, 1)
            (self.html / "looked_at.html").write_text(page, encoding="utf-8")
            report = report_in(chromium(self.html, "--virtual-time-budget=60000", "--dump-dom",
                                        f"file://{self.html}/looked_at.html"))
            self.assertEqual(report["problems"], [], name)
            self.assertGreater(report["formulas"], 3, name)
            self.assertEqual((report["with_a_drawing"], report["errors"]), (report["formulas"], 0), name)
            self.assertGreater(report["drawn"], report["formulas"], name)
            self.assertNotRegex(report["text"], r"\\f\$|\\\(|\\log|Math Processing Error", name)

    @unittest.skipUnless("CHROMIUM" in os.environ, "Chromium was not found")
    def test_on_a_phone(self):
        """A page begins with its title, and nothing is wider than the window."""
        page = self.page("delaunay_from_surface_3_how_fast.html").replace("<head>\n", "<head>\n" + ONLY_FILES + LISTEN, 1)
        (self.html / "looked_at.html").write_text(page.replace("</body>", MEASURE + "</body>"), encoding="utf-8")
        report = report_in(chromium(self.html, "--window-size=500,900", "--virtual-time-budget=20000", "--dump-dom",
                                    f"file://{self.html}/looked_at.html"))
        self.assertTrue(0 < report["title"] < 130, report)
        self.assertGreater(report["tree"], report["title"])
        self.assertLessEqual(report["width"], report["window"])

    @unittest.skipUnless(HAS_MATHJAX, "MathJax was not found")
    def test_mathjax_where_there_are_formulas(self):
        for path in self.html.glob("*.html"):
            text = path.read_text(encoding="utf-8")
            self.assertEqual("mathjax/MathJax.js" in text, 'class="formula"' in text, path.name)

    def test_formulas_without_mathjax(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in self.unfinished.items():
                self.assertIn('src="mathjax/MathJax.js"', text)
                (Path(folder) / name).write_text(text, encoding="utf-8")
            self.assertRegex(finish_pages(folder, f"{folder}/nowhere"), r"^skipped: formulas .*libjs-mathjax")
            for name, text in self.unfinished.items():
                finished = (Path(folder) / name).read_text(encoding="utf-8")
                self.assertNotIn("athjax", finished.replace("MathJax", "mathjax").split("<body>")[0])
                self.assertEqual(finished.count("\\("), text.count("\\("))

    def test_words(self):
        """Says which page has grown longer than its reader would like; examples that a page shows are counted."""
        for page, most in (("Delaunay_from_surface_3", 4000), ("Six_tasks", 1500), ("How_it_works", 4000), ("How_fast", 1500),
                           ("The_paper", 6000)):
            text = (MANUAL / f"{page}.txt").read_text(encoding="utf-8")
            text += "".join((ROOT / "examples" / name).read_text(encoding="utf-8")
                            for name in re.findall(r"\\cgalExample\{(.*?)\}", text))
            words = sum(bool(re.search("[A-Za-z]{2}", word)) for word in text.split())
            self.assertGreater(words, 100)
            if words > most:
                print(f"warning: {page}.txt has {words} words; {most} are wished for")

    def test_every_page_is_linked(self):
        """From the tree beside the pages, or from another page."""
        texts = {path.name: path.read_text(encoding="utf-8") for path in self.html.iterdir()
                 if path.suffix in (".html", ".js")}
        for name in texts:
            if name.endswith(".html"):
                self.assertTrue(any(name in text for other, text in texts.items() if other != name), name)

    def test_nothing_is_fetched(self):
        for path in self.html.glob("*.html"):
            text = path.read_text(encoding="utf-8")
            self.assertNotRegex(text, r"""<(?:script|img|link|iframe)[^>]*(?:src|href)=["'](?:https?:)?//""", path.name)


class In_a_tree_of_CGAL(unittest.TestCase):
    def test_no_warnings(self):
        with tempfile.TemporaryDirectory() as folder:
            values = {"${CGAL_PACKAGE_DOC_DIR}": MANUAL, "${CGAL_PACKAGE_DIR}": ROOT, "${CGAL_DOC_VERSION}": "6.2",
                      "${CGAL_DOC_PACKAGE_DEFAULTS}": f"{folder}/defaults.dxy", "@OUTPUT@": folder,
                      "@TAGFILE@": CGAL_TAGS}
            for source, name in ((HERE / "manual/cgal_defaults.dxy", "defaults.dxy"),
                                 (MANUAL / "Doxyfile.in", "package.dxy")):
                text = source.read_text(encoding="utf-8")
                for key, value in values.items():
                    text = text.replace(key, str(value))
                (Path(folder) / name).write_text(text, encoding="utf-8")
            warnings = doxygen(Path(folder) / "package.dxy")
            self.assertEqual([line for line in warnings if not NO_BIBTEX.search(line)], [])
            self.assertIn("../CGAL/group__bgl__namedparameters.html",
                          (Path(folder) / "index.html").read_text(encoding="utf-8"))
            self.assertFalse((Path(folder) / "delaunay_from_surface_3_bibliography.html").exists())

    def test_what_cgal_reads_in_the_description(self):
        """By its script that writes how to cite each package, line by line."""
        text = (MANUAL / "PackageDescription.txt").read_text(encoding="utf-8")
        for macro in (r"cgalPkgDescriptionBegin\{[^}]+,\s?[^}]+\}", r"cgalPkgAuthors\{[^}]+\}",
                      r"cgalPkgBib\{cgal:[^}]+\}"):
            self.assertRegex(text, re.compile(rf"^\\{macro}$", re.MULTILINE))


if __name__ == "__main__":
    unittest.main()
