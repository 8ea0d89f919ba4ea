# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The package's folders include each other downwards only, and scripts/check_arrows would say so."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
PACKAGE = "CGAL/Delaunay_from_surface_3"


def check(*arguments):
    done = subprocess.run([sys.executable, ROOT / "scripts" / "check_arrows", *arguments],
                          capture_output=True, text=True, check=False)
    return done.returncode, done.stdout


class Arrows(unittest.TestCase):
    def check_tree(self, headers):
        """Checks a tree of headers: a path and the header that it includes, or none."""
        with tempfile.TemporaryDirectory() as include:
            for path, included in headers.items():
                header = Path(include) / path
                header.parent.mkdir(parents=True, exist_ok=True)
                header.write_text(f"\n#include <{included}>\n" if included else "\n", encoding="utf-8")
            return check(include)

    def test_package(self):
        self.assertEqual(check(), (0, "all arrows go down\n"))

    def test_down_and_within_a_room(self):
        self.assertEqual(self.check_tree({
            "CGAL/insert_it_3.h": f"{PACKAGE}/paper/Order.h",
            f"{PACKAGE}/paper/Order.h": f"{PACKAGE}/paper/Other.h",
            f"{PACKAGE}/paper/Other.h": f"{PACKAGE}/support/sort.h",
            f"{PACKAGE}/support/sort.h": "vector",
        }), (0, "all arrows go down\n"))

    def test_up(self):
        self.assertEqual(self.check_tree({
            f"{PACKAGE}/core/order/nets.h": f"{PACKAGE}/paper/Order.h",
            f"{PACKAGE}/paper/Order.h": None,
        }), (1, "Delaunay_from_surface_3/core/order/nets.h:2: up, from core order to paper: "
                "Delaunay_from_surface_3/paper/Order.h\n"))

    def test_sideways(self):
        self.assertEqual(self.check_tree({
            f"{PACKAGE}/tiles/Forest.h": f"{PACKAGE}/arrays/Points.h",
            f"{PACKAGE}/arrays/Points.h": None,
        }), (1, "Delaunay_from_surface_3/tiles/Forest.h:2: sideways, from tiles to arrays: "
                "Delaunay_from_surface_3/arrays/Points.h\n"))

    def test_order_knows_no_kernel(self):
        self.assertEqual(self.check_tree({
            f"{PACKAGE}/core/order/Nets.h": f"{PACKAGE}/core/kernel/Cell.h",
            f"{PACKAGE}/core/kernel/Cell.h": None,
        }), (1, "Delaunay_from_surface_3/core/order/Nets.h:2: though it knows nothing of it, from core order to "
                "core kernel: Delaunay_from_surface_3/core/kernel/Cell.h\n"))

    def test_another_library(self):
        self.assertEqual(self.check_tree({f"{PACKAGE}/core/kernel/Cell.h": "CGAL/enum.h",
                                          f"{PACKAGE}/adapters/Export.h": "CGAL/enum.h"}),
                         (1, "Delaunay_from_surface_3/core/kernel/Cell.h:2: core kernel names another library's "
                             "header: CGAL/enum.h\n"))

    def test_mpi(self):
        one = f"{PACKAGE}/tiles/Ranks_of_mpi.h"
        self.assertEqual(self.check_tree({one: "mpi.h", "Tiles_by_mpi_3.h": one}),
                         (0, "all arrows go down\n"))
        self.assertEqual(self.check_tree({f"{PACKAGE}/adapters/Export.h": "mpi.h"}),
                         (1, f"Delaunay_from_surface_3/adapters/Export.h:2: MPI's header is named by "
                             "Delaunay_from_surface_3/tiles/Ranks_of_mpi.h alone\n"))

    def test_surface_knows_no_triangulation(self):
        for header, room, how in (("paper/trace.h", "paper", "up"), ("arrays/cells.h", "arrays", "sideways"),
                                  ("core/build.h", "core", "though it knows nothing of it"),
                                  ("core/kernel/cells.h", "core kernel", "though it knows nothing of it")):
            self.assertEqual(self.check_tree({
                f"{PACKAGE}/surface/Tree.h": f"{PACKAGE}/{header}",
                f"{PACKAGE}/{header}": None,
            }), (1, f"Delaunay_from_surface_3/surface/Tree.h:2: {how}, from surface to {room}: "
                    f"Delaunay_from_surface_3/{header}\n"))

    def test_no_room(self):
        self.assertEqual(self.check_tree({f"{PACKAGE}/attic/Old.h": None}),
                         (1, "Delaunay_from_surface_3/attic/Old.h: stands in no room\n"))

    def test_nothing_to_check(self):
        self.assertEqual(self.check_tree({})[0], 2)


if __name__ == "__main__":
    unittest.main()
