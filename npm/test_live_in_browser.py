# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Opens the live page of scripts/live in Chromium without a window, and drops files onto it. FOLDER is where
scripts/wasm has made the npm package."""

import base64
import json
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from headless_chromium import arrays_of, chromium, report_in, served
from program_case import ROOT, TORUS, ProgramCase

# Opens the page in a frame, does something with it, and writes a report.
USER = """<!DOCTYPE html>
<meta charset="utf-8">
<pre id="report"></pre>
<iframe id="live" src="live.html" width="900" height="700"></iframe>
<script type="module">
const seen = [];
const frame = document.getElementById("live");
const wait = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
const page = () => frame.contentDocument;
const element = (id) => page().getElementById(id);
const shown = () => element("view").contentWindow;

async function until(condition) {
  for (let k = 0; k < 2000 && !condition(); ++k)
    await wait(20);
  if (!condition())
    throw new Error(`it takes too long: ${condition}`);
}

const isDone = () => element("share").hidden && (element("result").textContent || element("problem").textContent);
let before; // what the frame showed

// An expression of the page in the frame.
function inView(expression) {
  const script = shown().document.createElement("script");
  script.text = `window.value = ${expression}`;
  shown().document.body.append(script);
  return shown().value;
}

// What is to be seen when the work that was begun has ended.
async function look(name) {
  await until(isDone);
  const result = {name, result: element("result").textContent, problem: element("problem").textContent};
  if (result.problem === "") {
    const text = (id) => shown().document.getElementById(id)?.textContent;
    await until(() => shown().document !== before && (text("cut") || /WebGL/.test(text("problem"))));
    before = shown().document;
    await until(() => shown().document.readyState === "complete");
    await wait(50); // the page, too, has learnt of it
    Object.assign(result, {counts: text("counts"), title: text("name"), cut: text("cut"),
      layers: [...shown().document.querySelectorAll("#layers label")].map((label) => label.textContent),
      ...inView(`({inside: isInside.reduce((a, b) => a + b, 0), tetrahedra: tetrahedra.length / 4, sites: sites.length,
        weights: weights.length, triangles: triangles.length / 3, hull: hull.length / 3})`)});
  }
  seen.push(result);
}

function drop(name, bytes, onto = frame.contentWindow) {
  const files = new DataTransfer();
  files.items.add(new File([bytes], name));
  onto.document.body.dispatchEvent(new DragEvent("drop", {dataTransfer: files, bubbles: true, cancelable: true}));
}

async function dropped(name, bytes) {
  drop(name, bytes);
  await look(name);
}

const bytesOf = (base64) => Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));

try {
  await until(() => page().readyState === "complete" && element("share") && isDone());
  await look("at first");
  const problems = [];
  frame.contentWindow.addEventListener("securitypolicyviolation", (event) => problems.push(event.blockedURI));
  frame.contentWindow.addEventListener("error", (event) => problems.push(event.message));
  await (USE)();
  document.getElementById("report").textContent = JSON.stringify({seen, problems});
} catch (error) {
  document.getElementById("report").textContent = JSON.stringify({seen, problems: [error.stack]});
}
await fetch("/report", {method: "POST"});
</script>
<img src="/done" alt="">
"""

# Tells a server when the view is there, and takes its title.
WAIT = """<script>
const waiting = setInterval(() => {
  if (!$("view").contentDocument?.getElementById("cut")?.textContent)
    return;
  clearInterval(waiting);
  document.title = $("view").contentDocument.title;
  fetch("ADDRESS/report", {method: "POST", mode: "no-cors"});
}, 20);
</script>
<img src="ADDRESS/done" alt="">
"""


class LiveInBrowser(ProgramCase):
    program = os.environ["DELAUNAY_FROM_SURFACE"]

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.page = Path(folder.name) / "live.html"
        subprocess.run([ROOT / "scripts/live", cls.page, Path(os.environ["FOLDER"]) / "npm"], check=True, stdout=subprocess.DEVNULL)

    def use(self, use, *options):
        """What was seen when `use`, an asynchronous function of JavaScript, had done its work."""
        shutil.copy(self.page, self.folder)
        (self.folder / "user.html").write_text(USER.replace("(USE)", f"({use})"), encoding="utf-8")
        with served(self.folder) as address:
            dom = chromium(self.folder, "--window-size=1000,900", *options, "--dump-dom", f"{address}/user.html")
        report = report_in(dom)
        self.assertEqual(report["problems"], [])
        return {step["name"]: step for step in report["seen"]}

    def drop_all(self, files):
        """What was seen after each file, given by name and bytes, had been dropped."""
        drops = "".join(f"await dropped({json.dumps(name)}, bytesOf('{base64.b64encode(content).decode()}'));"
                        for name, content in files)
        return self.use(f"async () => {{ {drops} }}")

    def test_same_as_the_program(self):
        """What the page shows of a mesh is what the program's page shows."""
        seen = self.drop_all([(TORUS.name, TORUS.read_bytes())])
        step = seen[TORUS.name]
        self.works(TORUS, "--view", "page.html", "--quiet")
        arrays = arrays_of((self.folder / "page.html").read_text())
        self.assertEqual((step["tetrahedra"], step["inside"], step["triangles"]),
                         (len(arrays["tetrahedra"]) / 4, sum(arrays["inside"]), len(arrays["triangles"]) / 3))
        self.assertGreater(step["inside"], 0)
        self.assertEqual(step["title"], "torus.off")
        self.assertIn("cells inside", step["layers"])
        self.assertEqual((seen["at first"]["title"], seen["at first"]["counts"][:5]), ("knot.off", "7,200"))

    def test_broken_files(self):
        """The page says what is wrong, and where; then it goes on."""
        self.assertEqual(
            {name: step["problem"] for name, step in self.drop_all([
                ("a.off", b"OFF\n3 1 0\n0 0 0\n1 0 x\n0 1 0\n3 0 1 2\n"), ("b.doc", b""), ("c.xyz", b"0 0 0\n1 1 1\n2 2 2\n"),
                ("d.xyz", b"0 0 0\n"), ("e.obj", b"v 0 0 0\nf 1 2 3\n"), ("f.xyz", b"0 0 0\n1 0 0\n0 1 0\n0 0 1\n"),
                ("open.off", b"OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n")]).items() if name != "at first"},
            {"a.off": "a.off, line 4: 'x' is not a finite number",
             "b.doc": "b.doc: expected a file whose name ends in .off, .ply, .obj, .stl, .xyz, .pts, .txt, .csv",
             "c.xyz": "c.xyz: all points lie on a line", "d.xyz": "d.xyz: it has 1 points; three are needed",
             "e.obj": "e.obj: a face has the corner 1, and there are 1 points", "f.xyz": "", "open.off": ""})

    def test_no_inside(self):
        step = self.drop_all([("open.off", b"OFF\n5 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n3 0 1 2\n")])["open.off"]
        self.assertRegex(step["result"], "5 points, [0-9]+ tetrahedra, in .*; the surface has no inside")
        self.assertEqual(step["inside"], 0)

    def test_in_a_plane(self):
        step = self.drop_all([("plane.xyz", "".join(f"{x} {y} 1\n" for x in range(5) for y in range(4)).encode())])["plane.xyz"]
        self.assertRegex(step["result"], "20 points, 24 triangles, as all points lie in a plane")
        self.assertEqual((step["tetrahedra"], step["hull"]), (0, 24))

    def test_onto_the_frame(self):
        """Where a browser by itself would leave the page, and show the file."""
        step = self.use("""async () => {
  drop("cloud.xyz", "0 0 0\\n1 0 0\\n0 1 0\\n0 0 1\\n", shown());
  await look("cloud");
}""")["cloud"]
        self.assertEqual((step["title"], step["tetrahedra"], step["hull"]), ("cloud.xyz", 1, 4))

    def test_cells_in_a_box(self):
        """The Voronoi cells of points in a periodic box, and their power cells, fill it."""
        seen = self.use("""async () => {
  const fraction = (name) => {
    seen[seen.length - 1].fraction = inView(`(() => {
      const size = [0, 1, 2].map((k) => points.reduce(([low, high], x, i) =>
        i % 3 === k && siteOf(i / 3 | 0) === (i / 3 | 0) ? [Math.min(low, x), Math.max(high, x)] : [low, high], [9, -9]));
      const lengths = size.map(([low, high]) => high - low), gap = 0.05 * Math.max(...lengths);
      const box = lengths.reduce((product, length) => product * (length + gap), 1);
      const det = (a, b, c) => a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
      let sum = 0;
      isVertex.forEach((is, i) => {
        if (!is || siteOf(i) !== i)
          return;
        const {faces} = voronoiCell(i), corners = faces.flat(); // a power cell need not contain its point
        const within = [0, 1, 2].map((k) => corners.reduce((total, x) => total + x[k], 0) / corners.length);
        for (const face of faces)
          for (let k = 2; k < face.length; ++k)
            sum += Math.abs(det(...[face[0], face[k - 1], face[k]].map((x) => x.map((c, l) => c - within[l])))) / 6;
      });
      return sum / box;
    })()`);
  };
  element("chain").click();
  await look("chain");
  element("is-box").click();
  await look("box");
  fraction();
  element("has-weights").click();
  await look("box and weights");
  fraction();
  element("is-box").click();
  await look("weights");
}""")
        self.assertEqual((seen["chain"]["sites"], seen["chain"]["weights"]), (0, 0))
        self.assertGreater(seen["box"]["sites"], 300)
        self.assertAlmostEqual(seen["box"]["fraction"], 1, places=4)
        self.assertAlmostEqual(seen["box and weights"]["fraction"], 1, places=4)
        self.assertEqual(seen["box and weights"]["weights"], seen["box and weights"]["sites"])
        self.assertEqual((seen["weights"]["sites"], seen["weights"]["weights"]), (0, 300))

    def test_what_is_seen_stays(self):
        """A slider that is moved changes neither the view nor the chosen point."""
        seen = self.use("""async () => {
  const link = () => { seen[seen.length - 1].link = inView("hashOfView()"); };
  element("chain").click();
  await look("chain");
  element("has-weights").click();
  await look("weights");
  inView("(showVoronoi(5), turn(0.3, 0.1), zoom(1.5), document.getElementById('show-cells').click())");
  link();
  element("growth").value = 0.5;
  element("growth").dispatchEvent(new Event("change"));
  await look("smaller");
  link();
  element("knot").click();
  await look("other");
  link();
}""")
        self.assertRegex(seen["weights"]["link"], "show=surface,points,voronoi&.*point=5")
        self.assertEqual(seen["weights"]["link"], seen["smaller"]["link"])
        self.assertNotIn("point", seen["other"]["link"].replace("show=", ""))

    def test_what_is_overwritten(self):
        """The page is made anew, but no other file is overwritten."""
        other = self.write("part.off", "OFF")
        done = subprocess.run([ROOT / "scripts/live", other], capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, other.read_text()), (1, "OFF\n"))
        self.assertIn("part.off: it is not of this script; name another file", done.stderr)

    def test_from_a_file(self):
        """It needs no server."""
        page = self.page.read_text(encoding="utf-8").replace("img-src data:\">", "img-src data: http:; connect-src http:\">")
        with served(self.folder) as address:
            self.write("page.html", page.replace("</body>", WAIT.replace("ADDRESS", address) + "</body>"))
            dom = chromium(self.folder, "--dump-dom", f"file://{self.folder}/page.html")
        self.assertRegex(dom, '<output id="result">7,200 points, 84,656 tetrahedra, in ')
        self.assertIn("<title>knot.off</title>", dom)

    def test_without_webgl(self):
        """The triangulation is computed, and the view says why nothing is seen."""
        step = self.use("""async () => {
  seen.push({name: "problem", problem: shown().document.getElementById("problem").textContent});
}""", "--disable-3d-apis")
        self.assertRegex(step["problem"]["problem"], "This page needs WebGL")

    def test_stop(self):
        """What is stopped says so, and leaves the page as it was."""
        step = self.use("""async () => {
  const points = Float32Array.from({length: 3000000}, (_, i) => i * [0.618, 0.414, 0.732][i % 3] % 1);
  const header = `ply\\nformat binary_little_endian 1.0\\nelement vertex 1000000\\n${["x", "y", "z"].map((name) =>
    `property float ${name}\\n`).join("")}end_header\\n`;
  const large = new Blob([header, points]);
  drop("large.ply", large);
  element("stop").click(); // while it is read
  await wait(300);
  await look("stopped at once");
  drop("large.ply", large);
  await new Promise((resolve) => new MutationObserver((_, observer) => {
    if (element("share").value === 0)
      return;
    observer.disconnect();
    element("stop").click(); // as soon as there is progress
    resolve();
  }).observe(element("share"), {attributes: true}));
  await look("stopped");
  element("cloud").click();
  await look("cloud");
}""")
        self.assertEqual(step["stopped at once"]["problem"], "large.ply: stopped")
        self.assertEqual((step["stopped"]["problem"], step["cloud"]["title"]), ("large.ply: stopped", "cloud.xyz"))


if __name__ == "__main__":
    unittest.main()
