#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""What Doxygen leaves to be done on the manual's pages: finish_pages.py FOLDER_OF_HTML FOLDER_OF_MATHJAX

- Concepts are called concepts, which Doxygen calls classes.
- The word CGAL means the library, and is no link to the namespace.
- The pages of folders, which Doxygen writes, links from nowhere, and leaves empty, are removed.
- Names in tables and titles may be broken after an underscore, unless a digit follows, after a slash, and after two
  colons, so that they are not wider than they must be; elsewhere only on a narrow window. Options of programs are not
  broken after their hyphens.
- MathJax 2, which draws the formulas, is copied beside the pages: of it what they need, so that nothing is fetched when
  they are read. Pages without formulas do not ask for it. Where it is not found none does, and formulas are shown as
  TeX has them.
"""

import re
import shutil
import sys
from pathlib import Path

CONCEPTS = {path.stem for path in (Path(__file__).resolve().parent / "Concepts").glob("*.h")}
TITLE = re.compile(rf"\b({'|'.join(CONCEPTS)}) Class Reference\b")
LISTED = re.compile(rf'>class (&#160;</td>.*?<a class="el" href="[^"]*">(?:{"|".join(CONCEPTS)})</a>)')

NAME_OF_LIBRARY = re.compile(r'<a class="el" href="namespaceCGAL\.html" title="[^"]*">CGAL</a>')

# TeX is read, SVG is drawn with glyphs that are scripts too, and MathML is left for screen readers.
PARTS_OF_MATHJAX = ["MathJax.js", "extensions/AssistiveMML.js", "extensions/MathEvents.js", "extensions/tex2jax.js",
                    "extensions/toMathML.js", "jax/element/mml", "jax/input/TeX", "jax/output/SVG/autoload",
                    "jax/output/SVG/config.js", "jax/output/SVG/fonts/TeX", "jax/output/SVG/jax.js"]
LOADING = re.compile(r'<script type="text/x-mathjax-config">.*?</script>\s*<script[^>]*MathJax\.js"></script>\s*', re.S)
TABLE = re.compile(r'<table class="markdownTable">.*?</table>', re.S)
CODE = re.compile(r"<code>.*?</code>")
HEADLINE = re.compile(r'<div class="title">[^<]*')
OPTION = re.compile(r"(?<=[ >])-[-\w]+")
# With what must not be torn from it at the end of a line. Doxygen has put a blank between "(" and a formula.
FORMULA = re.compile(r"(\( )?(\\\(.*?\\\))([,.;:)]*)")


def copy_mathjax(source, target):
    shutil.rmtree(target, ignore_errors=True)
    for part in PARTS_OF_MATHJAX:
        (target / part).parent.mkdir(parents=True, exist_ok=True)
        if (source / part).is_dir():
            shutil.copytree(source / part, target / part)
        else:
            shutil.copyfile(source / part, target / part)


def breakable(text, where):
    def break_names(part):
        return re.sub(r"_(?!\d)|/|::", r"\g<0>" + where, part[0])
    return re.sub(r">[^<]+", break_names, text)


def with_breakable_names(page):
    page = HEADLINE.sub(lambda title: breakable(title[0], "<wbr/>"), page)
    parts = re.split(f"({TABLE.pattern})", page, flags=re.S) # tables are the odd ones
    for i, where in ((0, '<wbr class="narrow"/>'), (1, "<wbr/>")):
        parts[i::2] = [CODE.sub(lambda code, where=where: breakable(code[0], where), part) for part in parts[i::2]]
    return "".join(parts)


def whole_options(match):
    return OPTION.sub(r'<span class="option">\g<0></span>', match[0])


def whole_formula(match):
    return f'<span class="formula">{"(" if match[1] else ""}{match[2]}{match[3]}</span>'


def main():
    html, mathjax = Path(sys.argv[1]), Path(sys.argv[2])
    has_mathjax = all((mathjax / part).exists() for part in PARTS_OF_MATHJAX)
    if has_mathjax:
        copy_mathjax(mathjax, html / "mathjax")
    else:
        print(f"skipped: formulas are left in TeX, as MathJax 2 (Debian: libjs-mathjax) was not found in {mathjax}")
    for path in html.glob("dir_*.html"):
        path.unlink()
    for path in html.glob("*.html"):
        old = path.read_text(encoding="utf-8")
        new = LISTED.sub(r">concept \1", TITLE.sub(r"Concept \1", old))
        new = NAME_OF_LIBRARY.sub("CGAL", new)
        new = with_breakable_names(CODE.sub(whole_options, new))
        needs_mathjax = has_mathjax and FORMULA.search(new)
        new = FORMULA.sub(whole_formula, new) if needs_mathjax else LOADING.sub("", new)
        if new != old:
            path.write_text(new, encoding="utf-8")


if __name__ == "__main__":
    main()
