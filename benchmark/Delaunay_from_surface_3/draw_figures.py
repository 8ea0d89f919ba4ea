#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Draws the plots of manual and readme from the committed results. Needs Matplotlib (Debian: python3-matplotlib).

  draw_figures.py [FOLDER]      where they go; default: where the manual has them
"""

import argparse
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
MOST_BYTES = 30000


def figures():
    """For each the file, the name of the results, and what draws it, which needs Matplotlib."""
    import plots
    return [("times.svg", "calls_256k", plots.draw_times),
            ("where_time_goes.svg", "compare_64k", plots.draw_where_time_goes),
            ("paper_work.svg", "total_work", plots.draw_work)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default=HERE.parents[1] / "doc/Delaunay_from_surface_3/fig")
    folder = parser.parse_args().folder
    from manual_tables import read
    for name, results, draw in figures():
        draw(read(HERE / f"results/{results}.json"), folder / name)
        size = (folder / name).stat().st_size
        print(f"{name}: {size} bytes")
        if size > MOST_BYTES:
            sys.exit(f"draw_figures.py: {name} is larger than {MOST_BYTES} bytes")


if __name__ == "__main__":
    main()
