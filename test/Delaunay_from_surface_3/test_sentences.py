# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The pages that people read have no long sentences. Tables, code, formulas and lists of authors are no sentences."""

import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGES = [path for pattern in ("*.md", "*/*.md", "doc/Delaunay_from_surface_3/*.txt") for path in sorted(ROOT.glob(pattern))
         if path.parent.name != "build" and path.name not in ("Bibliography.txt", "PackageDescription.txt")]
LONGEST = 35

# Blocks that are left out, and what stands for one word.
BLOCKS = (r"```.*?```", r"<!--.*?-->", r"<table.*?</table>", r"\\code.*?\\endcode", r"\\verbatim.*?\\endverbatim",
          r"\\f\[.*?\\f\]", r"\\htmlonly.*?\\endhtmlonly", r"\\(?:image|section|subsection|page|include|snippet)\b[^\n]*")
WORDS = (r"!\[[^\]]*\]\([^)]*\)", r"\[([^\]]*)\]\([^)]*\)", r"\\f\$.*?\\f\$", r"`[^`]*`",
         r"\\(?:cgalCite|link|ref|cite|anchor)\b(?:\{[^}]*\}|\s*[\w:]+)")


def paragraphs(text):
    """The lines between empty ones, each item of a list by itself, without tables, headings and indented code."""
    for block in BLOCKS:
        text = re.sub(block, "\n\n", text, flags=re.DOTALL)
    text = re.sub(r"\\dfsFigureBegin\{|\\dfsFigureEnd\{|\}(?=\s*\\dfsFigure)", "\n\n", text)
    text = re.sub(r"^(?:\||#|    |\\).*$", "", text, flags=re.MULTILINE)
    text = re.sub(r"^\s*(?:-#|[-*]|\d+\.)\s", "\n\n", text, flags=re.MULTILINE)
    return re.split(r"\n\s*\n", text)


def sentences(text):
    for paragraph in paragraphs(text):
        for words in WORDS:
            paragraph = re.sub(words, lambda found: found.group(found.lastindex or 0) if found.lastindex else "X", paragraph)
        paragraph = re.sub(r"<[^>]*>|\\[a-zA-Z]+", " ", paragraph).replace("\\", "")
        yield from re.split(r"(?<=[.!?:])[)”\"]?\s+(?=[A-Z`*(“\"])", " ".join(paragraph.split()))


def long_sentences():
    return [(len(re.findall(r"\w[\w’'.,-]*", sentence)), path.relative_to(ROOT), sentence) for path in PAGES
            for sentence in sentences(path.read_text(encoding="utf-8"))
            if len(re.findall(r"\w[\w’'.,-]*", sentence)) > LONGEST]


class Sentences(unittest.TestCase):
    def test_lengths(self):
        self.assertGreater(len(PAGES), 8)
        found = long_sentences()
        self.assertLessEqual(len(found), 2, "\n".join(f"{path}: {number} words: {text}" for number, path, text in found))

    def test_readme(self):
        """The rest is in the manual."""
        self.assertLessEqual(len((ROOT / "README.md").read_text(encoding="utf-8").split()), 1700)

    def test_counter(self):
        text = "# Heading\n\nOne `a b c` two. [Three four](x y z) five:\n\n| a | b |\n\n    code\n\n- six\n- seven, eight.\n"
        self.assertEqual([len(s.split()) for s in sentences(text) if s], [3, 3, 1, 2])


if __name__ == "__main__":
    unittest.main()
