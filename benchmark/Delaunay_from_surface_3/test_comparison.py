# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Runs compare_with_plain at small sizes, with all that it can measure, measure_threads and measure_weights beside other
programs, measure_single_calls.py and critical_path.py, and looks at what they have written."""

import json
import math
import os
import shutil
import subprocess
import sys
import unittest
from pathlib import Path
from random import Random

import speed_tables
from manual_tables import read
from program_case import TORUS, ProgramCase

HERE = Path(__file__).resolve().parent
PEER = os.path.abspath(os.environ["PLAIN_PEER"])
COMMANDS = {"tetgen": ("TETGEN_PEER", ""), "geogram": ("GEOGRAM_PEER", "1"), "geogram-2": ("GEOGRAM_PEER", "2"),
            "hxt": ("HXT_PEER", "1"), "hxt-2": ("HXT_PEER", "2")}
LIBRARIES = {name: f"{os.path.abspath(os.environ[variable])} {threads}"
             for name, (variable, threads) in COMMANDS.items() if variable in os.environ}
MEASURE_THREADS = os.environ.get("MEASURE_THREADS", "")
METHODS = ["plain", "plain-fast", "default", "default-fast", "compact-spatial", "compact-nets", "nets", "plain-order", "tracing",
           "tracing-hilbert", "random-last", "random-insert", "random-hilbert", "random-fast"]
PEERS = [word for name, command in {"again": PEER, "broken": "false", "mute": "echo", **LIBRARIES}.items()
         for word in ("--peer", f"{name}={command}")]


class Comparison(ProgramCase):
    program = os.environ["COMPARE_WITH_PLAIN"]

    def refuses(self, message, *arguments):
        super().refuses(f"[^\n]*{message}", *arguments, "--output", "refused.json", prefix="compare_with_plain: ")

    def compare(self, name, *arguments):
        result = self.run_program(*arguments, "--output", name)
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads((self.folder / name).read_text())["results"]

    def between(self, low, value, high):
        self.assertGreater(value, low)
        self.assertLess(value, high)

    def check_method(self, name, method):
        self.assertEqual((method["method"], method["equal"], method["equal_checked_by"]), (name, True, "=="))
        self.between(0, method["median_cpu"], 100)
        self.between(0, method["ratio_plain_to_method"], 1000)
        self.between(0, method["ratio_method_to_yardstick"], 1000)
        self.between(300, method["memory"]["result_above_input_per_point"], 10000)
        self.between(300, method["memory"]["peak_above_input_per_point"], 10000)

    def check_counts(self, methods):
        for name in ("default", "default-fast", "compact-spatial"):  # the compact triangulation
            self.between(0, methods[name]["stages"]["build"], 100)
            self.between(0, methods[name]["stages"]["export"], 100)
            self.between(0, methods[name]["phases"]["seconds"]["update"], 100)
        for name in ("default", "compact-spatial"):
            self.between(1, methods[name]["kernel"]["cells_tested_to_start"], 200)
            self.between(20, methods[name]["kernel"]["sphere_tests"], 200)
        entered = {name: methods[name]["predicates"]["location"]["cells_entered"] for name in ("random-last", "random-hilbert")}
        self.between(0, entered["random-hilbert"], entered["random-last"] / 2)
        for name in ("nets", "plain-order", "tracing", "tracing-hilbert"):  # CGAL's insertion
            self.between(5, methods[name]["predicates"]["update"]["in_sphere"], 200)
        # The order decides what is destroyed, whoever inserts; only the beginnings differ.
        for ours, cgal in (("compact-nets", "nets"), ("compact-spatial", "plain-order")):
            destroyed = methods[cgal]["cells"]["destroyed"]
            self.between(5, destroyed, 100)
            self.between(destroyed - 2, methods[ours]["cells"]["destroyed"], destroyed + 2)

    def check_peers(self, again, broken, mute, *libraries, generic=True):
        self.assertEqual((again["method"], again["threads"], again["has_as_many_tetrahedra"]), ("again", 1, True))
        self.between(1e6, again["memory"]["peak_bytes"], 1e10)
        self.assertEqual(broken["left_out"], "exit code 1")
        self.assertEqual(mute["left_out"], "it does not print cpu_seconds and tetrahedra")
        for peer in libraries:
            name, _, threads = peer["method"].partition("-")
            self.assertEqual((peer["library"].split()[0].lower(), peer["threads"]), (name, int(threads or 1)))
            self.between(0, peer["median_wall"], 100)
            self.between(5000, peer["tetrahedra"], 50000)
            if generic:
                self.assertTrue(peer["has_as_many_tetrahedra"], peer)

    def test_all_that_can_be_measured(self):
        results = self.compare("all.json", "--surfaces", "genus-3", "sphere-exact-shuffled", "--sizes", 2500,
                               "--repetitions", 2, "--memory", "--methods", *METHODS[1:],
                               *PEERS)
        self.assertEqual([r["surface"] for r in results], ["genus-3", "sphere-exact-shuffled"])
        for result in results:
            methods = dict(zip(METHODS, result["methods"]))
            for name, method in methods.items():
                self.check_method(name, method)
            self.check_counts(methods)
            self.check_peers(*result["methods"][len(METHODS):], generic=result["surface"] == "genus-3")
            self.between(0, result["yardstick"]["verification"], 100)
            self.between(0, result["yardstick"]["total"], 100)
        # Cospherical points are where the first filter must give up.
        self.between(0.1, methods["default"]["kernel"]["first_filter_failures"], 100)

        torus = self.compare("torus.json", "--mesh", TORUS, "--sizes", 0, 1000, "--methods", "default", "--only-times",
                             "--repetitions", 1)
        self.assertEqual([(r["surface"], r["points"]) for r in torus], [("torus", 960), ("torus", 1000)])

        tables = speed_tables.gains(read(self.folder / "all.json"))
        self.assertIn("\n| genus-3 | ", tables)

    @unittest.skipUnless(MEASURE_THREADS, "skipped: measure_threads was not built")
    def test_peers_beside_threads(self):
        subprocess.run([os.path.abspath(MEASURE_THREADS), "--surfaces", "genus-3", "--sizes", "2500", "-r", "2", *PEERS,
                        "--output", "threads.json"], cwd=self.folder, check=True, capture_output=True)
        report = json.loads((self.folder / "threads.json").read_text())
        result, = report["results"]
        self.assertIn("--peer again=", report["command"])
        self.check_peers(*result["peers"])

    def test_peers_that_take_weights(self):
        subprocess.run([os.path.abspath(os.environ["MEASURE_WEIGHTS"]), "--sizes", "1000", "2000", "-r", "2", *PEERS,
                        "--output", "weights.json"], cwd=self.folder, check=True, capture_output=True)
        report = json.loads((self.folder / "weights.json").read_text())
        for result in report["results"]:
            again, broken, mute, *libraries = result["peers"]
            self.assertEqual((again["left_out"], broken["left_out"]), ("exit code 1", "exit code 1"))
            self.assertIn("does not print", mute["left_out"])
            for peer in libraries:
                if not peer["method"].startswith("geogram"):
                    self.assertEqual(peer["left_out"], "exit code 1")
                    continue
                self.between(0, peer["ratio_method_to_arrays"], 1000)
                if not result["set"].startswith("lattice"):
                    self.assertEqual(peer["tetrahedra"], result["tetrahedra"])

        lines = speed_tables.weights({"name": "weights", **report}).splitlines()
        self.assertEqual(len([line for line in lines if line.startswith("| cube, ")]), 3)
        self.assertIn("For 1,000 points geometric means are filled ", lines[-3])
        geogram = [column.strip() for column in lines[2].split("|") if "Geogram" in column]
        self.assertEqual(geogram, ["Geogram", "Geogram by 2 threads"] if "geogram" in LIBRARIES else [])

    def ellipsoid(self, name):
        random = Random(1)
        cloud = [[axis * x / math.hypot(*p) for axis, x in zip((3, 2, 1), p)]
                 for p in ([random.gauss(0, 1) for _ in range(3)] for _ in range(30000))]
        return self.write(name, "OFF 30000 0 0", *(" ".join(map(repr, p)) for p in cloud))

    def test_single_calls(self):
        program = os.path.abspath(os.environ["INSERT_ONCE"])
        command = [sys.executable, HERE / "measure_single_calls.py", TORUS, "--program", program, "--rest", "0", "0.01",
                   "--methods", "default", "points", "arrays", "--other", f"again={program}", "--repetitions", "2",
                   "--output", self.folder / "single_calls.json"]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        results = json.loads((self.folder / "single_calls.json").read_text())["results"]
        self.assertEqual([result["rest"] for result in results], [0, 0.01])
        for result in results:
            self.assertEqual(list(result["calls"]), ["plain", "default", "default, again", "points", "points, again",
                                                     "arrays", "arrays, again"])
            self.between(0, result["touched"]["small_page"]["median"], 1e5)
            for call in result["calls"].values():
                self.assertEqual(len(call["cpu"]), 2)
                self.between(0, call["median_wall"], 100)
                self.between(0, call["median_faults"], 1e5)

    @unittest.skipUnless(MEASURE_THREADS, "skipped: peers beside single calls, as there are no threads")
    def test_single_calls_beside_peers(self):
        mesh = self.ellipsoid("ellipsoid_30k.off")  # of smaller ones the system does not know the user time
        output = self.folder / "peers.json"
        command = [sys.executable, HERE / "measure_single_calls.py", mesh, "--program", os.path.abspath(os.environ["INSERT_ONCE"]),
                   "--rest", "0", "--repetitions", "1", "--methods", "default", "arrays", "default:2", "arrays:2", "parallel:2",
                   "--output", output, "--peer"]
        peers = {"again": PEER, **LIBRARIES}
        subprocess.run([*command, *(f"{name}={peer}" for name, peer in peers.items())], check=True, stdout=subprocess.DEVNULL)
        result, = json.loads(output.read_text())["results"]
        for name in peers:
            call = result["calls"][name]
            self.assertEqual(call["tetrahedra"], result["tetrahedra"], name)
            self.assertEqual(call["threads"], 1 + name.endswith("-2"), name)
            self.between(0, call["median_wall"], 100)
            self.assertAlmostEqual(call["median_cpu"], call["median_user"] + call["median_system"], 5)
        lines = speed_tables.peers(read(output)).splitlines()
        self.assertIn("| program | threads | time | ellipsoid | geometric mean |", lines)
        self.assertRegex("\n".join(lines), r"\n\| CGAL \| 1 \| user \+ system \| \d+\.\d\d \|")
        self.assertIn("Numbers of tetrahedra that differ from plain %CGAL's: none.", lines)
        cube = self.write("cube.ply", "ply")
        self.assertIn("cube.ply: peers need a mesh in OFF", subprocess.run([*command[:2], cube, *command[3:], f"again={PEER}"], capture_output=True, text=True).stderr)

    @unittest.skipUnless(shutil.which("valgrind"), "skipped: instructions of threads, as valgrind was not found")
    def test_critical_path(self):
        mesh = self.ellipsoid("ellipsoid.off")
        subprocess.run([sys.executable, HERE / "critical_path.py", mesh, "--threads", "1", "4", "--program",
                        os.path.abspath(os.environ["ARRAYS_BY_THREADS"]), "--output", self.folder / "critical_path.json"],
                       check=True, stdout=subprocess.DEVNULL)
        one, four = json.loads((self.folder / "critical_path.json").read_text())["results"]
        self.assertEqual(one["critical_path"], one["work"])
        self.between(1, four["work"] / one["work"], 1.45)  # what threads do in addition
        alone = sum(longest for part, (longest, _) in four["parts"].items() if part.endswith("alone"))
        evenly = alone + (four["work"] - alone) / 4  # who executes most depends on the turns, and these on the load
        self.between(2.2, one["work"] / evenly, 4)
        self.between(evenly - 1, four["critical_path"], four["work"])
        for part, (longest, work) in four["parts"].items():
            self.assertLessEqual(work / 4, longest + 0.1, part)  # of rounding
        self.assertEqual({part.split(",")[0] for part in four["parts"]}, {"order", "permute", "insertion", "export"})
        self.between(0.7, four["parts"]["insertion, shared"][1] / four["work"], 1)

    def test_what_it_refuses(self):
        self.refuses("a peer is given as NAME=COMMAND, not as 'false'", "--peer", "false")
        self.refuses("'default' is a method", "--peer", "default=false")
        self.refuses("there is no surface 'moon'", "--surfaces", "moon")
        self.refuses("there is no method 'magic'", "--methods", "magic")
        self.refuses("--repetitions must be at least 1", "--repetitions", 0)
        self.refuses(r"nowhere\.off: No such file", "--mesh", "nowhere.off")


if __name__ == "__main__":
    unittest.main()
