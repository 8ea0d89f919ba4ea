#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Writes the manual's page Bibliography.txt, of the entries of geom.bib: bibliography.py [--check]

An entry is a section whose heading is all that a citation prints: at most three names, or the first and "et al.", and
the year. With --check nothing is written; the exit status says whether the page is that of the entries.
"""

import re
import sys
import textwrap
from pathlib import Path

HERE = Path(__file__).resolve().parent
PAGE = HERE / "Bibliography.txt"
ENTRY = re.compile(r"^@(\w+)\{([^,]+),\n(.*?)^\}$", re.MULTILINE | re.DOTALL)
FIELD = re.compile(r"^ *(\w+) *= \{(.*)\},?$", re.MULTILINE)
LETTERS = {'{\\"u}': "ü", "{\\'e}": "é", "{\\c{c}}": "ç", "{$\\Omega$}": "Ω", "\\&": "&amp;", "--": "–", "~": " "}


def plain(text):
    """Without TeX; the word CGAL is no link."""
    for tex, letter in LETTERS.items():
        text = text.replace(tex, letter)
    return re.sub(r"\bCGAL\b", "%CGAL", re.sub(r"\\url\{(.*)\}", r"\1", text).replace("{", "").replace("}", ""))


def read(path=HERE / "geom.bib"):
    """The fields of all entries, by key."""
    return {key: {"type": kind, **{name: plain(value) for name, value in FIELD.findall(fields)}}
            for kind, key, fields in ENTRY.findall(path.read_text(encoding="utf-8"))}


def surname(author):
    return author.split()[-1]


def initials(author):
    """Jean-Daniel Boissonnat: J.-D. Boissonnat"""
    *given, family = author.split()
    return " ".join([*("-".join(part[0] + "." for part in name.split("-")) for name in given), family])


def heading(entry):
    if "key" in entry:
        return entry["key"]
    authors = entry["author"].split(" and ")
    names = ", ".join(map(surname, authors)) if len(authors) <= 3 else surname(authors[0]) + " et al."
    return f"{names} {entry['year']}"


def reference(entry):
    """Authors. Title. Where, when. Addresses."""
    names = entry["author"].split(" and ")
    authors = ", ".join(initials(name) for name in names if name != "others") + " and others" * ("others" in names)
    where = [f"In <em>{entry['booktitle']}</em>"] if "booktitle" in entry else []
    if "journal" in entry:
        number = f"({entry['number']})" if "number" in entry else ""
        pages = f":{entry['pages']}" if "pages" in entry else ""
        where.append(f"<em>{entry['journal']}</em>, {entry['volume']}{number}{pages}")
    elif entry["type"] == "techreport":
        where.append(f"{entry['number']}, {entry['institution']}")
    elif "pages" in entry:
        where.append(f"pages {entry['pages']}")
    where += [entry[name] for name in ("publisher", "howpublished", "year") if name in entry]
    parts = [authors, entry["title"], ", ".join(where)]
    if "doi" in entry:
        parts.append(f'<a href="https://doi.org/{entry["doi"]}">doi:{entry["doi"]}</a>')
    return ". ".join(parts + ([entry["note"]] if "note" in entry else [])) + "."


def page(entries):
    lines = ["// Written by bibliography.py, of geom.bib, which a tree of CGAL reads itself.",
             "/// \\cond STANDALONE_MANUAL", "/*!",
             "\\page delaunay_from_surface_3_bibliography Bibliography"]
    for key, entry in sorted(entries.items(), key=lambda item: heading(item[1]).casefold()):
        lines += ["", f"\\section bib_{key} {heading(entry)}", "",
                  textwrap.fill(reference(entry), 110, break_long_words=False, break_on_hyphens=False)]
    return "\n".join([*lines, "*/", "/// \\endcond", ""])


def main():
    text = page(read())
    if sys.argv[1:] == ["--check"]:
        return int(PAGE.read_text(encoding="utf-8") != text)
    PAGE.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
