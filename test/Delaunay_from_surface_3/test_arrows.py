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
            "CGAL/insert_it_3.h": f"{PACKAGE}/plan/Order.h",
            f"{PACKAGE}/plan/Order.h": f"{PACKAGE}/plan/Other.h",
            f"{PACKAGE}/plan/Other.h": f"{PACKAGE}/internal/support/sort.h",
            f"{PACKAGE}/internal/support/sort.h": "vector",
        }), (0, "all arrows go down\n"))

    def test_up(self):
        self.assertEqual(self.check_tree({
            f"{PACKAGE}/internal/plan/nets.h": f"{PACKAGE}/plan/Order.h",
            f"{PACKAGE}/plan/Order.h": None,
        }), (1, "Delaunay_from_surface_3/internal/plan/nets.h:2: up, from internal plan to plan: "
                "Delaunay_from_surface_3/plan/Order.h\n"))

    def test_sideways(self):
        self.assertEqual(self.check_tree({
            f"{PACKAGE}/plan/Order.h": f"{PACKAGE}/trace/Hints_3.h",
            f"{PACKAGE}/trace/Hints_3.h": None,
        }), (1, "Delaunay_from_surface_3/plan/Order.h:2: sideways, from plan to trace: "
                "Delaunay_from_surface_3/trace/Hints_3.h\n"))

    def test_order_knows_no_kernel(self):
        self.assertEqual(self.check_tree({
            f"{PACKAGE}/core/order/Nets.h": f"{PACKAGE}/core/kernel/Cell.h",
            f"{PACKAGE}/core/kernel/Cell.h": None,
        }), (1, "Delaunay_from_surface_3/core/order/Nets.h:2: though it knows nothing of it, from core order to "
                "core kernel: Delaunay_from_surface_3/core/kernel/Cell.h\n"))

    def test_another_library(self):
        self.assertEqual(self.check_tree({f"{PACKAGE}/core/kernel/Cell.h": "CGAL/enum.h",
                                          f"{PACKAGE}/internal/compact/Export.h": "CGAL/enum.h"}),
                         (1, "Delaunay_from_surface_3/core/kernel/Cell.h:2: core kernel names another library's "
                             "header: CGAL/enum.h\n"))

    def test_surface_knows_subgraphs_and_no_triangulation(self):
        self.assertEqual(self.check_tree({
            f"{PACKAGE}/surface/Tree.h": f"{PACKAGE}/internal/subgraph/Stars.h",
            f"{PACKAGE}/internal/subgraph/Stars.h": None,
        }), (0, "all arrows go down\n"))
        for header, room in (("internal/plan/nets.h", "internal plan"), ("internal/trace/walk.h", "internal trace"),
                             ("internal/compact/cells.h", "internal compact")):
            self.assertEqual(self.check_tree({
                f"{PACKAGE}/surface/Tree.h": f"{PACKAGE}/{header}",
                f"{PACKAGE}/{header}": None,
            }), (1, f"Delaunay_from_surface_3/surface/Tree.h:2: sideways, from surface to {room}: "
                    f"Delaunay_from_surface_3/{header}\n"))
        self.assertEqual(self.check_tree({
            f"{PACKAGE}/internal/subgraph/Stars.h": f"{PACKAGE}/surface/Tree.h",
            f"{PACKAGE}/surface/Tree.h": None,
        })[0], 1)

    def test_no_room(self):
        self.assertEqual(self.check_tree({f"{PACKAGE}/attic/Old.h": None}),
                         (1, "Delaunay_from_surface_3/attic/Old.h: stands in no room\n"))

    def test_nothing_to_check(self):
        self.assertEqual(self.check_tree({})[0], 2)


if __name__ == "__main__":
    unittest.main()
