# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Opens the page that delaunay_from_surface --view writes in Chromium without a window, and uses it."""

import os
import unittest

from headless_chromium import LISTEN, chromium, report_in
from program_case import TORUS, ProgramCase
from test_view import arrays_of

# Before the page's own scripts: all is done before the page is loaded, and its DOM dumped.
AT_ONCE = "<script>window.requestAnimationFrame = (draw) => draw();</script>\n"

# After them: does what a user does, and writes what it saw into the page.
USE = """<script>
const steps = [];
const element = (id) => document.getElementById(id);
function look(name) {
  const gl = element("canvas").getContext("webgl");
  const [width, height] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
  const pixels = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  const words = new Uint32Array(pixels.buffer);
  const sum = words.reduce((a, b) => (Math.imul(a, 31) + b) | 0, 7);
  steps.push({name, width, colours: new Set(words).size, sum, cut: element("cut").textContent});
}
function set(id, value) {
  element(id).value = value;
  element(id).dispatchEvent(new Event("input", {bubbles: true}));
}
const press = (key) => document.body.dispatchEvent(new KeyboardEvent("keydown", {key, bubbles: true}));
const pointer = (type, x, y) => element("canvas").dispatchEvent(
  new PointerEvent(type, {pointerId: 1, clientX: x, clientY: y, bubbles: true}));
function use() {
  look("begin");
  press("x");
  look("x");
  for (const share of [0.1, 0.4, 0.8]) {
    set("plane", share);
    look("x " + share);
  }
  press("ArrowLeft");
  look("left");
  press("w");
  look("whole");
  for (const key of ["z", "f", "v", "1", "2", "3", "4", "5"]) {
    press(key);
    look(key);
  }
  set("rounds-shown", 2);
  look("rounds");
  pointer("pointerdown", 100, 100), pointer("pointermove", 180, 140), pointer("pointerup", 180, 140);
  look("drag");
  element("canvas").dispatchEvent(new WheelEvent("wheel", {deltaY: -300, cancelable: true}));
  look("wheel");
}
use();
</script>
<script>
const report = document.createElement("pre");
report.id = "report";
report.textContent = JSON.stringify({problems, steps, title: document.title,
  overflow: document.documentElement.scrollWidth > innerWidth});
document.body.append(report);
</script>
"""


class ViewInBrowser(ProgramCase):
    program = os.environ["DELAUNAY_FROM_SURFACE"]

    def write_page(self, *arguments):
        self.works(*arguments, "--view", "page.html", "--quiet")
        return (self.folder / "page.html").read_text()

    def use(self, page):
        page = page.replace("<head>\n", "<head>\n" + LISTEN + AT_ONCE, 1).replace("</body>", USE + "</body>")
        (self.folder / "used.html").write_text(page)
        return report_in(chromium(self.folder, "--window-size=420,600", "--dump-dom",
                                  f"file://{self.folder}/used.html"))

    def test_as_a_user(self):
        page = self.write_page(TORUS)
        report = self.use(page)
        self.assertEqual(report["problems"], [])
        self.assertEqual((report["title"], report["overflow"]), ("torus.off", False))
        steps = {step["name"]: step for step in report["steps"]}
        for step in report["steps"]:
            self.assertGreater(step["colours"], 0 if step["name"] == "3" else 1 if step["name"] == "4" else 20, step)
        self.assertEqual(steps["3"]["colours"], 1) # surface and cells have been taken away
        # Everything that is done changes the picture.
        sums = [step["sum"] for step in report["steps"]]
        for before, after in zip(report["steps"], report["steps"][1:]):
            self.assertNotEqual(before["sum"], after["sum"], after["name"])
        self.assertGreater(len(set(sums)), 12)
        # The cells that the plane meets are those of the triangulation.
        arrays = arrays_of(page)
        for name, share in (("x", 0.5), ("x 0.1", 0.1), ("x 0.4", 0.4), ("x 0.8", 0.8), ("left", 0.79)):
            self.assertEqual(steps[name]["cut"], f"{self.cells_cut(arrays, share):,} cells meet the plane")

    @staticmethod
    def cells_cut(arrays, share):
        heights = arrays["points"][0::3]
        lowest, highest = min(heights), max(heights)
        is_above = [height > lowest + (highest - lowest) * share for height in heights]
        tetrahedra = arrays["tetrahedra"]
        return sum(0 < sum(is_above[v] for v in tetrahedra[t:t + 4]) < 4 for t in range(0, len(tetrahedra), 4))

    def test_without_webgl(self):
        self.write_page(TORUS)
        dom = chromium(self.folder, "--disable-3d-apis", "--dump-dom", f"file://{self.folder}/page.html")
        self.assertRegex(dom, r'<p id="problem"[^>]*>This page needs WebGL')


if __name__ == "__main__":
    unittest.main()
