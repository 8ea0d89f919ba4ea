# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""What all scripts need that put measured results on a page of the manual: tables in Markdown, and blocks of
text that belong between <!-- NAME --> and <!-- end -->."""

import os
import re
import sys


def cell(value, form="{}"):
    return "–" if value is None else form.format(value)


def table(titles, rows, left=1):
    """The first columns are aligned to the left, the others, numbers, to the right."""
    lines = ["| " + " | ".join(titles) + " |", "|" + "---|" * left + "--:|" * (len(titles) - left)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def machine_of(report):
    m = report["machine"]
    return (f'Machine: {m["cpu"]}, {m["cores"]} cores, {int(m["memory"].split()[0]) / 1e6:.0f} GB. '
            f'Compiler: {m["compiler"]}, `{" ".join(m["flags"].split())}`. %CGAL {m["cgal"]}')


def commands_of(*reports):
    return "\\verbatim\n" + "\n".join(report["command"] for report in reports) + "\n\\endverbatim"


BLOCK = re.compile(r"<!-- (\w+) -->\n.*?<!-- end -->", re.S)


def filled(page, blocks):
    """The page with the text between <!-- NAME --> and <!-- end --> replaced by the block of that name. Every block
    has one place there, or it would go stale unseen."""
    places = [match[1] for match in BLOCK.finditer(page)]
    wrong = sorted({name for name in [*places, *blocks] if name not in blocks or places.count(name) != 1})
    if wrong:
        raise ValueError(f"needs one block and one place each: {', '.join(wrong)}")
    return BLOCK.sub(lambda match: f"<!-- {match[1]} -->\n\n{blocks[match[1]]}\n\n<!-- end -->", page)


def refill(manual, blocks, check):
    with open(manual, encoding="utf-8") as file:
        before = file.read()
    try:
        after = filled(before, blocks)
    except ValueError as error:
        sys.exit(f"{program()}: {manual}: {error}")
    if check and before != after:
        sys.exit(f"{program()}: the tables in {manual} are not those of the results; --manual without --check "
                 "refills them")
    if not check:
        with open(manual, "w", encoding="utf-8") as file:
            file.write(after)


def program():
    return os.path.basename(sys.argv[0])


def add_options(parser):
    parser.add_argument("--tables", action="store_true", help="print the tables of the manual")
    parser.add_argument("--manual", metavar="FILE", help="put the tables where they belong in this text")
    parser.add_argument("--check", action="store_true", help="only say whether the text has these tables")


def serve(arguments, blocks):
    """Does what the options of add_options() ask for. Blocks are {name: text}."""
    if arguments.check and not arguments.manual:
        sys.exit(f"{program()}: --check needs --manual")
    if arguments.tables:
        print("\n\n".join(f"<!-- {name} -->\n\n{text}" for name, text in blocks.items()))
    if arguments.manual:
        refill(arguments.manual, blocks, arguments.check)
