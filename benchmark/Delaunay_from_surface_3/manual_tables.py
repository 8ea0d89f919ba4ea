# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""What all scripts need that put measured results on a page of the manual: tables in Markdown, and blocks of
text that belong between <!-- NAME --> and <!-- end -->."""

import argparse
import json
import math
import os
import re
import sys
from pathlib import Path


def cell(value, form="{}"):
    return "–" if value is None else form.format(value)


def table(titles, rows, left=1):
    """The first columns are aligned to the left, the others, numbers, to the right."""
    lines = ["| " + " | ".join(titles) + " |", "|" + "---|" * left + "--:|" * (len(titles) - left)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def thousands(number):
    """1000000: 1,000,000"""
    return f"{number:,}"


def geometric_mean(values):
    return math.exp(sum(map(math.log, values)) / len(values))


def range_of(values, form):
    low, high = form.format(min(values)), form.format(max(values))
    return low if low == high else f"{low} to {high}"


def loads_of(report):
    """The load averages of the machine that a report gives, before and after."""
    machine = report["machine"] if isinstance(report.get("machine"), dict) else {}
    named = [machine.get("load_before"), machine.get("load_after"), report.get("load_average_at_start"),
             report.get("load_average_at_end")]
    return [load for load in named if load is not None]


def cpu_of(report):
    return report["machine"]["cpu"].replace("(R)", "").replace(" Processor", "")


def measured(*reports):
    """On which of the two machines, under which load, and where the figures are."""
    texts = [f'{cpu_of(r).split()[1]}, load {range_of(loads_of(r), "{:.1f}")}, `{r["name"]}`' for r in reports]
    return "; ".join(texts) + "."


def machine_of(report):
    m = report["machine"]
    return (f'Machine: {m["cpu"]}, {m["cores"]} cores, {int(m["memory"].split()[0]) / 1e6:.0f} GB. '
            f'Compiler: {m["compiler"]}, `{" ".join(m["flags"].split())}`. %CGAL {m["cgal"]}')


def commands_of(*reports):
    return "\\verbatim\n" + "\n".join(report["command"] for report in reports) + "\n\\endverbatim"


BLOCK = re.compile(r"<!-- (\w+) -->\n.*?<!-- end -->", re.S)


def filled(pages, blocks):
    """The pages with the text between <!-- NAME --> and <!-- end --> replaced by the block of that name. Every block
    has one place in them, or it would go stale unseen."""
    places = [match[1] for page in pages for match in BLOCK.finditer(page)]
    wrong = sorted({name for name in [*places, *blocks] if name not in blocks or places.count(name) != 1})
    if wrong:
        raise ValueError(f"needs one block and one place each: {', '.join(wrong)}")
    return [BLOCK.sub(lambda match: f"<!-- {match[1]} -->\n\n{blocks[match[1]]}\n\n<!-- end -->", page)
            for page in pages]


def refill(manual, blocks, check):
    before = [Path(name).read_text(encoding="utf-8") for name in manual]
    try:
        after = filled(before, blocks)
    except ValueError as error:
        sys.exit(f"{program()}: {', '.join(map(str, manual))}: {error}")
    for name, old, new in zip(manual, before, after):
        if check and old != new:
            sys.exit(f"{program()}: the tables in {name} are not those of the results; --manual without --check "
                     "refills them")
        if not check:
            Path(name).write_text(new, encoding="utf-8")


def program():
    return os.path.basename(sys.argv[0])


def add_options(parser):
    parser.add_argument("--tables", action="store_true", help="print the tables of the manual")
    parser.add_argument("--manual", metavar="FILE", nargs="+", help="put the tables where they belong in these texts")
    parser.add_argument("--check", action="store_true", help="only say whether the texts have these tables")


def serve(arguments, blocks):
    """Does what the options of add_options() ask for. Blocks are {name: text}."""
    if arguments.check and not arguments.manual:
        sys.exit(f"{program()}: --check needs --manual")
    if arguments.tables:
        print("\n\n".join(f"<!-- {name} -->\n\n{text}" for name, text in blocks.items()))
    if arguments.manual:
        refill(arguments.manual, blocks, arguments.check)


def read(file_name):
    with open(file_name, encoding="utf-8") as file:
        return {"name": Path(file_name).stem, **json.load(file)}


def fill_from_results(description, all_blocks, writers):
    """The whole of a script whose blocks are all_blocks(reports); `writers` are the programs whose JSON it reads."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", metavar="JSON", help=f"what {writers} wrote")
    add_options(parser)
    arguments = parser.parse_args()
    serve(arguments, all_blocks([read(name) for name in arguments.files]))
