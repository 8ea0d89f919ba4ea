# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Opens the page that delaunay_from_surface --view writes in Chromium without a window, and uses it."""

import os
import unittest

from headless_chromium import LISTEN, arrays_of, chromium, report_in
from program_case import TORUS, ProgramCase

# Before the page's own scripts: all is done before the page is loaded, and its DOM dumped.
AT_ONCE = "<script>window.requestAnimationFrame = (draw) => draw();</script>\n"

# After them: looks at the page, as often as asked to.
LOOK = """<script>
const steps = [];
const element = (id) => document.getElementById(id);
const press = (key, shiftKey) => document.body.dispatchEvent(new KeyboardEvent("keydown", {key, shiftKey, bubbles: true}));
function look(name) {
  const gl = element("canvas").getContext("webgl");
  const [width, height] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
  const pixels = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  const words = new Uint32Array(pixels.buffer);
  const sum = words.reduce((a, b) => (Math.imul(a, 31) + b) | 0, 7);
  // The longest way of a point from the middle of the picture, whose borders are 1 away.
  let reach = 0;
  for (let i = 0; i < points.length; i += 3) {
    const p = new THREE.Vector3(points[i], points[i + 1], points[i + 2]).project(camera);
    reach = Math.max(reach, Math.abs(p.x), Math.abs(p.y));
  }
  const cuts = element("cuts-surface").checked, axis = document.querySelector("[name=axis]:checked").value;
  const ground = [...pixels.slice(0, 3)];
  steps.push({name, width, height, colours: new Set(words).size, sum, cut: element("cut").textContent, reach, cuts, axis,
    plane: Number(element("plane").value), ground, link: location.hash});
}
</script>
"""

# Does what a user does.
USE = """<script>
function set(id, value) {
  element(id).value = value;
  element(id).dispatchEvent(new Event("input", {bubbles: true}));
}
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
"""

# Changes the view, follows the link to it, and goes back.
LINKS = """<script>
look("begin");
element("canvas").ownerDocument.querySelector("[name=up][value=z]").click();
look("up");
press("j"), press("i");
look("panned");
press("ArrowUp", true), press("+"), press("v"), press("ArrowRight", true), press("w"), press("3");
element("plane").value = 0.3;
element("plane").dispatchEvent(new Event("input", {bubbles: true}));
draw();
press("c");
look("moved");
const link = location.hash;
press("r");
look("reset");
setUp(link);
press("c");
look("again");
setUp(location.hash);
look("twice");
setUp("#axis=constructor&up=toString&turn=,&zoom=x&pan=1e999,0,0&plane=&rounds=q");
draw();
look("nonsense");
</script>
"""

# From one side and another, as wide and as high.
TURN = """<script>
look("begin");
for (let k = 0; k < 12; ++k) {
  turn(0.7, 0.4);
  draw();
  look("turned");
}
</script>
"""

# Clicks the foremost of the points that are seen, and then beside all.
CLICK = """<script>
const canvas = element("canvas");
function click(x, y, way = 0) {
  const {left, top} = canvas.getBoundingClientRect();
  for (const [type, by] of [["pointerdown", 0], ["pointermove", way], ["pointerup", way]])
    canvas.dispatchEvent(new PointerEvent(type, {pointerId: 1, clientX: left + x + by, clientY: top + y, bubbles: true}));
  draw();
}
look("begin");
const place = new THREE.Vector3(), depths = Array.from(heights, (height, i) =>
  height > offset ? Infinity : place.fromArray(points, 3 * i).distanceTo(camera.position));
const foremost = depths.indexOf(Math.min(...depths));
place.fromArray(points, 3 * foremost).project(camera);
click((place.x + 1) / 2 * canvas.clientWidth, (1 - place.y) / 2 * canvas.clientHeight, 20);
look("dragged");
reset();
draw();
click((place.x + 1) / 2 * canvas.clientWidth, (1 - place.y) / 2 * canvas.clientHeight);
press("c");
look("clicked");
click(0, 0);
look("beside");
const {faces, neighbors} = voronoiCell(foremost);
steps.push({chosen, foremost, neighbors, faces: faces.length, text: element("chosen").textContent});
</script>
"""

# Writes what was seen into the page.
REPORT = """<script>
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

    def use(self, page, *scripts, options=("--window-size=420,600",)):
        page = page.replace("<head>\n", "<head>\n" + LISTEN + AT_ONCE, 1)
        page = page.replace("</body>", "".join([LOOK, *scripts]) + "</body>")
        (self.folder / "used.html").write_text(page)
        return report_in(chromium(self.folder, *options, "--dump-dom", f"file://{self.folder}/used.html"))

    def test_as_a_user(self):
        page = self.write_page(TORUS)
        report = self.use(page, USE, REPORT)
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

        # At first it is cut in the middle.
        self.assertEqual((report["steps"][0]["cuts"], report["steps"][0]["plane"]), (True, 0.5))

    def test_links(self):
        """A link shows the same; without one the page is as it was at first."""
        report = self.use(self.write_page(TORUS), LINKS, REPORT)
        steps = report["steps"]
        self.assertEqual(report["problems"], [])
        sums = {step["name"]: step["sum"] for step in steps}
        self.assertEqual({step["link"] for step in steps if step["name"] == "again"}, {steps[3]["link"]})
        self.assertRegex(steps[3]["link"], r"#axis=-?[.\d]+,-?[.\d]+,-?[.\d]+&plane=0.3&show=surface,inside,voronoi&up=z&turn=.*&rounds=\d+&whole$")
        self.assertEqual([sums["twice"], sums["reset"], sums["nonsense"]], [sums["again"], sums["begin"], sums["begin"]])
        cuts = {step["name"]: step["cut"] for step in steps}
        self.assertEqual(cuts["again"], cuts["moved"])  # but for rounding, the same picture
        self.assertEqual(len({sums[name] for name in ("begin", "up", "panned", "moved")}), 4)

    def test_voronoi(self):
        """The cell of a point that is clicked is shown, and stays; a drag chooses none."""
        steps = self.use(self.write_page(TORUS), CLICK, REPORT)["steps"]
        seen = {step["name"]: step for step in steps[:-1]}
        self.assertNotEqual(seen["clicked"]["sum"], seen["begin"]["sum"])
        self.assertEqual(seen["beside"]["sum"], seen["clicked"]["sum"])
        self.assertEqual(steps[-1]["chosen"], steps[-1]["foremost"])
        self.assertEqual(steps[-1]["text"], f"{steps[-1]['neighbors']} neighbours")
        self.assertTrue(4 <= steps[-1]["faces"] <= steps[-1]["neighbors"] + 6)
        self.assertIn(f"&point={steps[-1]['chosen']}", seen["clicked"]["link"])
        self.assertNotIn("point=", seen["dragged"]["link"])

    def test_points_alone(self):
        """They are dots in their hull, which is cut."""
        self.write("points.xyz", *(f"{x} {y} {z}" for x in range(4) for y in range(5) for z in range(3)))
        page = self.write_page("points.xyz")
        steps = self.use(page, '<script>look("begin"); press("u"); look("whole");</script>', REPORT)["steps"]
        self.assertGreater(steps[0]["colours"], 20)
        self.assertNotEqual(steps[0]["sum"], steps[1]["sum"])
        self.assertRegex(page, 'id="hull"')
        self.assertEqual(len(arrays_of(page)["hull"]), 3 * (2 * 2 * (3 * 4 + 4 * 2 + 3 * 2)))

    def test_nothing_is_cut_off(self):
        """Whatever the shape of part and window, and from all sides; the plane faces the viewer."""
        for size in ((1, 1, 1), (9, 1, 1), (1, 9, 1), (1, 1, 9), (5, 5, 1), (1, 0.01, 2)):
            corners = [" ".join(str(s * x) for s, x in zip(size, corner)) for corner in
                       ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))]
            self.write("box.off", "OFF", "8 6 0", *corners, "4 0 3 2 1", "4 4 5 6 7", "4 0 1 5 4", "4 1 2 6 5", "4 2 3 7 6",
                       "4 3 0 4 7")
            page = self.write_page("box.off")
            for window in ("420,600", "1200,420"):
                report = self.use(page, TURN, REPORT, options=[f"--window-size={window}"])
                self.assertEqual((report["problems"], len(report["steps"])), ([], 13))
                reaches = [step["reach"] for step in report["steps"]]
                self.assertLessEqual(max(reaches), 1, (size, window))
                self.assertGreater(max(reaches), 0.3, (size, window))
                self.assertEqual(report["steps"][0]["axis"], "z")
                self.assertGreater(report["steps"][0]["colours"], 3)

    def test_dark(self):
        """The ground is that of the style sheet, light or dark."""
        page = self.write_page(TORUS)
        grounds = {}
        for scheme in (0, 1):
            options = ["--window-size=420,600", f"--blink-settings=preferredColorScheme={scheme}"]
            steps = self.use(page, '<script>look("begin");</script>', REPORT, options=options)["steps"]
            self.assertGreater(steps[0]["colours"], 20)
            grounds[scheme] = steps[0]["ground"]
        self.assertEqual(sorted(grounds.values()), [[0x14, 0x18, 0x1e], [0xf7, 0xf8, 0xfa]])

    def test_lost_context(self):
        """What a graphics card has forgotten is drawn again."""
        page = self.write_page(TORUS).replace("<head>\n", "<head>\n" + LISTEN, 1)
        script = REPORT.replace("<script>\n", """<script>
addEventListener("load", () => {
  look("before");
  const extension = element("canvas").getContext("webgl").getExtension("WEBGL_lose_context");
  element("canvas").addEventListener("webglcontextlost", () => setTimeout(() => extension.restoreContext(), 100));
  element("canvas").addEventListener("webglcontextrestored", () => {
    look("after");
    finish();
  });
  extension.loseContext();
});
function finish() {
""", 1).replace("</script>", "}\n</script>")
        (self.folder / "lost.html").write_text(page.replace("</body>", LOOK + script + "</body>"))
        steps = report_in(chromium(self.folder, "--window-size=420,600", "--virtual-time-budget=5000", "--dump-dom",
                                   f"file://{self.folder}/lost.html"))["steps"]
        self.assertEqual([step["name"] for step in steps], ["before", "after"])
        self.assertEqual(steps[0]["sum"], steps[1]["sum"])
        self.assertGreater(steps[0]["colours"], 20)

    def test_no_frame_is_black(self):
        """Whoever changes the canvas' size has cleared it: it is drawn before the next frame, which may show it."""
        page = self.write_page(TORUS).replace("<head>\n", "<head>\n" + LISTEN, 1)
        script = REPORT.replace("<script>\n", """<script>
// Called behind the page's own observer, when the browser has laid out a frame; it asks for no more frames itself.
window.requestAnimationFrame = () => 0;
// Virtual time runs ahead while nothing is waited for, and a busy browser lays out no frame in time; each of these waits.
const wait = setInterval(() => {
  element("canvas").getContext("webgl").readPixels(0, 0, 1, 1, 6408, 5121, new Uint8Array(4));
}, 10);
new ResizeObserver(() => {
  look("observed");
  if (steps.length === 1)
    setTimeout(() => { element("canvas").style.width = "200px"; }, 50);
  else
    finish();
}).observe(element("canvas"));
function finish() {
clearInterval(wait);
""", 1).replace("</script>", "}\n</script>")
        (self.folder / "observed.html").write_text(page.replace("</body>", LOOK + script + "</body>"))
        steps = report_in(chromium(self.folder, "--window-size=420,600", "--virtual-time-budget=100000", "--dump-dom",
                                   f"file://{self.folder}/observed.html"))["steps"]
        self.assertEqual(len(steps), 2)
        for step in steps:
            self.assertGreater(step["colours"], 20, step)
        self.assertNotEqual(steps[0]["width"], steps[1]["width"])

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
