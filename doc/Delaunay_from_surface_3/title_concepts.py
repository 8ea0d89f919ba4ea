#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Calls concepts concepts, which Doxygen calls classes: title_concepts.py FOLDER_OF_HTML"""

import re
import sys
from pathlib import Path

CONCEPTS = {path.stem for path in (Path(__file__).resolve().parent / "Concepts").glob("*.h")}
TITLE = re.compile(rf"\b({'|'.join(CONCEPTS)}) Class Reference\b")
LISTED = re.compile(rf'>class (&#160;</td>.*?<a class="el" href="[^"]*">(?:{"|".join(CONCEPTS)})</a>)')


def main():
    for path in Path(sys.argv[1]).glob("*.html"):
        old = path.read_text(encoding="utf-8")
        new = LISTED.sub(r">concept \1", TITLE.sub(r"Concept \1", old))
        if new != old:
            path.write_text(new, encoding="utf-8")


if __name__ == "__main__":
    main()
