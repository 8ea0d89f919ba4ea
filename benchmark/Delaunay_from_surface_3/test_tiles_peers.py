# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Runs measure_tiles_peers.py on few points, with others beside tiles_peer that are wrong, fail or do not end."""

import json
import os
import subprocess
import unittest
from pathlib import Path

import use_tables
from program_case import TORUS, ProgramCase, python_with

HERE = Path(__file__).resolve().parent
PYTHON = python_with("numpy")
FAULTS = {  # after all has gone well, by the first rank, where cells are written
    "losing": "truncate --size=-96 $cells", "doubling": "head --bytes=96 $cells > $cells.more; cat $cells.more >> $cells",
    "failing": "exit 1", "hanging": "exec sleep 60"}


@unittest.skipUnless(PYTHON, "skipped: tiles are not measured beside others, as NumPy was not found")
class Tiles_peers(ProgramCase):
    program = os.path.abspath(os.environ["TILES_PEER"])

    def test_who_is_right(self):
        for name, fault in FAULTS.items():
            self.write(name, "#!/bin/bash", f'{self.program} "$@" || exit 1', 'cells=${3-none}.0',
                       f'if [ "${{OMPI_COMM_WORLD_RANK-${{PMI_RANK-}}}}" = 0 ]; then touch $cells; {fault}; fi').chmod(0o755)
        subprocess.run([PYTHON, "-B", HERE / "measure_tiles_peers.py", "--peers", f"ours={self.program}",
                        *map("{0}=./{0}".format, FAULTS),
                        "--surface", TORUS, "--points", "300", "--ranks", "2", "--many", "1", "--repetitions", "1", "--limit",
                        "8", "--only", "torus", "--output", "tiles_peers.json"],
                       cwd=self.folder, check=True, stdout=subprocess.DEVNULL)
        report = json.loads((self.folder / "tiles_peers.json").read_text())
        self.assertEqual([(r["input"], r["ranks"]) for r in report["results"]], 5 * [("torus", 2)])
        for r in report["results"]:
            self.assertEqual(r.get("left_out"), {"failing": "exit code 1", "hanging": "stopped after 8 s"}.get(r["peer"]), r)
            if "left_out" not in r:
                self.assertEqual((r["missing"], r["others"]), {"losing": (1, 0), "doubling": (0, 1)}.get(r["peer"], (0, 0)), r)
                self.assertGreater(r["bytes_sent"], 0)
                self.assertGreater(r["points_held"], r["points"])
                self.assertEqual(use_tables.is_wrong(r), r["peer"] in ("losing", "doubling"))


if __name__ == "__main__":
    unittest.main()
