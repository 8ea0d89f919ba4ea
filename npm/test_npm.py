# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Makes the npm package, installs it from its tarball, and uses it in Node.js and in Chromium: the same triangulations as
everywhere. FOLDER is where it is made; CHROMIUM names the browser, if there is one."""

import gzip
import json
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
from headless_chromium import chromium, report_in, served

# How the tests run, and where they leave their report. The page is loaded, and its DOM dumped, when /done is there.
IN_NODE = """import * as library from "delaunay-3";
import {test} from "./test_npm.mjs";
console.log(JSON.stringify(await test(library)));
"""
PAGE = """<!DOCTYPE html>
<meta http-equiv="Content-Security-Policy" content="script-src 'self' 'nonce-1' 'wasm-unsafe-eval'">
<pre id="report"></pre>
<script type="module" nonce="1">
  import {test} from "/test_npm.mjs";
  const report = await import("/node_modules/delaunay-3/index.mjs").then(test).catch((error) => ({faults: [error.stack]}));
  document.getElementById("report").textContent = JSON.stringify(report);
  await fetch("/report", {method: "POST"});
</script>
<img src="/done" alt="">
"""


class Npm(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.made = Path(os.environ.get("FOLDER", ROOT / "build")) / "npm"
        subprocess.run([ROOT / "scripts/wasm", cls.made], check=True, stdout=subprocess.DEVNULL)
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.user = Path(folder.name)
        (cls.user / "package.json").write_text('{"private": true, "type": "module"}', encoding="utf-8")
        (cls.tarball,) = cls.made.glob("delaunay-3-*.tgz")
        subprocess.run(["npm", "install", "--offline", "--silent", "--no-audit", "--no-fund", cls.tarball], cwd=cls.user,
                       check=True, stdout=subprocess.DEVNULL)
        shutil.copy(HERE / "test_npm.mjs", cls.user)
        cls.package = cls.user / "node_modules/delaunay-3"

    def check(self, report):
        self.assertEqual(report["faults"], [])
        table = (ROOT / "test/Delaunay_from_surface_3/include/fixed_inputs.h").read_text(encoding="utf-8")
        self.assertEqual([line for line in report["lines"] if line not in table], [])
        self.assertEqual(len(report["lines"]), 9)

    def run_node(self, program):
        (self.user / "program.mjs").write_text(program, encoding="utf-8")
        done = subprocess.run(["node", "program.mjs"], cwd=self.user, capture_output=True, text=True, timeout=200, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def test_node(self):
        self.check(json.loads(self.run_node(IN_NODE)))

    @unittest.skipUnless(os.environ.get("CHROMIUM"), "Chromium was not found")
    def test_browser(self):
        (self.user / "page.html").write_text(PAGE, encoding="utf-8")
        with served(self.user) as address:
            dom = chromium(self.user, "--dump-dom", f"{address}/page.html")
        self.check(report_in(dom))

    def test_readme(self):
        """What it shows runs, line by line, and its comments say what comes out."""
        (program,) = re.findall(r"```js\n(.*?)```", (self.package / "README.md").read_text(encoding="utf-8"), re.DOTALL)
        expected = re.findall(r"console\.log\(.*\); *// (.*)", program)
        self.assertEqual(self.run_node(program).split("\n")[:-1], expected)

    def test_what_is_packed(self):
        files = {str(path.relative_to(self.package)) for path in self.package.rglob("*")}
        self.assertEqual(files, {"package.json", "README.md", "index.mjs", "index.d.ts", "worker.mjs", "delaunay_3.wasm", "LICENSE",
                                 "LICENSE.LGPL", "THIRD_PARTY.txt"})
        code = "".join((self.package / name).read_text(encoding="utf-8") for name in ("index.mjs", "worker.mjs"))
        self.assertNotRegex(code, r"\beval\b|new Function")
        self.assertLess(len(gzip.compress((self.package / "delaunay_3.wasm").read_bytes())), 600_000)
        self.assertLess(self.tarball.stat().st_size, 600_000)

    def test_names_of_statuses(self):
        header = (ROOT / "src/delaunay_3.h").read_text(encoding="utf-8")
        names = re.findall(r"^  DELAUNAY_3_([A-Z_]+)", header, re.MULTILINE)
        (listed,) = re.findall(r"const statuses = \[(.*?)\];", (HERE / "index.mjs").read_text(encoding="utf-8"), re.DOTALL)
        (typed,) = re.findall(r"type Status = (.*?);", (HERE / "index.d.ts").read_text(encoding="utf-8"), re.DOTALL)
        self.assertEqual(re.findall(r'"(\w+)"', listed), names)
        self.assertEqual(re.findall(r'"(\w+)"', typed), names[1:])


if __name__ == "__main__":
    unittest.main()
