// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the page that delaunay_from_surface --view writes shows, and what its user does. The program, or
// the live page, puts the data, three.js, cut.js, voronoi.js and this file into view.html. What follows # in the address sets the page up, and "copy link"
// writes it; each part may be left out:
//   axis=z       the plane's: x, y or z, or v for the view, turned towards the viewer; or 0.6,0,0.8, turned as it says
//   plane=0.4    where it is, from 0 to 1: at 1 nothing is cut
//   uncut        the surface is whole; whole: cells are, in place of their sections
//   show=surface,inside,…   the layers; rounds=3: how many of them
//   up=z         the axis that points up; turn=30,-20: by how many degrees the view is turned to the right, and up
//   zoom=1.2, pan=0.1,0,0   what is in the middle, where the longest side of the box goes from -1 to 1
//   point=17     whose Voronoi cell is shown

"use strict";
// --- What is shown ---

$("name").textContent = document.title = info.name;
$("counts").textContent = `${isVertex.reduce((sum, is) => sum + is, 0).toLocaleString()} vertices, ` +
  `${(tetrahedra.length / 4).toLocaleString()} tetrahedra`;

const layers = [];
const scene = new THREE.Scene();
const positions = new THREE.BufferAttribute(points, 3);

function addLayer(id, label, object, isShown, more = {}) {
  const layer = {id, object, isShown, ...more};
  object.visible = isShown;
  const html = `<label><input type="checkbox" id="show-${id}"><i class="swatch" style="background:var(--${id})"></i>` +
    `<span>${label}</span></label>`;
  $("layers").insertAdjacentHTML("beforeend", html);
  $(`show-${id}`).checked = isShown;
  $(`show-${id}`).addEventListener("change", (event) => {
    object.visible = event.target.checked;
    cutCells();
  });
  layers.push(layer);
  scene.add(object);
}

function onPoints(indices) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", positions);
  geometry.setIndex(new THREE.BufferAttribute(indices, 1));
  return geometry;
}

const clipped = {clippingPlanes: [clippingPlane]};
const faceted = {flatShading: true, side: THREE.DoubleSide, shininess: 0, specular: 0,
  polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1}; // lines lie in front

// Faces, and their edges.
function facesAndLines(more) {
  const group = new THREE.Group();
  group.add(new THREE.Mesh(new THREE.BufferGeometry(), new THREE.MeshPhongMaterial({...faceted, ...more})));
  const pen = new THREE.LineBasicMaterial({transparent: true, opacity: 0.6});
  group.add(new THREE.LineSegments(new THREE.BufferGeometry(), pen));
  group.children.forEach((child) => child.frustumCulled = false);
  return group;
}

const addCells = (id, label, kind) => addLayer(id, label, facesAndLines(), true, {kind});

// Nothing, until a point is chosen.
function addVoronoi() {
  addLayer("voronoi", `Voronoi cell of a point: <span id="chosen"></span>`, facesAndLines({transparent: true, opacity: 0.6}), true);
}

let chosen = -1; // the point, if there is one

function showVoronoi(i) {
  const layer = layers.find(({id}) => id === "voronoi");
  if (!layer)
    return;
  chosen = isVertex[siteOf(i)] ? i : -1;
  const {object} = layer, {faces, neighbors} = chosen < 0 ? {faces: []} : voronoiCell(i);
  const triangles = [], lines = [], at = points.subarray(3 * i, 3 * i + 3);
  const add = (array, ...corners) => corners.forEach((x) => array.push(...x.map((coordinate, k) => coordinate + at[k])));
  for (const face of faces)
    face.forEach((x, k) => {
      add(lines, x, face[(k + 1) % face.length]);
      if (k > 1)
        add(triangles, face[0], face[k - 1], x);
    });
  [triangles, lines].forEach((array, k) => {
    object.children[k].geometry.dispose();
    object.children[k].geometry.setAttribute("position", new THREE.BufferAttribute(Float32Array.from(array), 3));
  });
  $("chosen").textContent = chosen < 0 ? "click it" : `${neighbors} neighbours`;
  drawSoon();
}

function choosePoint(x, y) {
  const i = pointAt(x, y, camera, $("canvas"), $("cuts-surface").checked);
  if (i !== undefined)
    showVoronoi(i);
}

// Each round in its colour; the first, of few points, as the largest dots.
function addRounds() {
  const disc = document.createElement("canvas").getContext("2d");
  disc.canvas.width = disc.canvas.height = 32;
  disc.fillStyle = "white";
  disc.arc(16, 16, 15, 0, 7);
  disc.fill();
  const last = rounds.reduce((a, b) => Math.max(a, b), 0);
  const group = new THREE.Group();
  for (let r = 0; r <= last; ++r) {
    const indices = [];
    rounds.forEach((round, i) => { if (round === r) indices.push(i); });
    const material = new THREE.PointsMaterial({size: 3 + 9 * (1 - r / last) ** 2, sizeAttenuation: false,
      map: new THREE.CanvasTexture(disc.canvas), alphaTest: 0.5, ...clipped});
    material.color.setHSL(0.8 * r / last, 0.85, 0.5);
    group.add(new THREE.Points(onPoints(Uint32Array.from(indices)), material));
  }
  addLayer("rounds", `insertion rounds 1 to <span id="upto"></span>`, group, false);
  $("layers").insertAdjacentHTML("beforeend",
    `<input type="range" id="rounds-shown" min="1" max="${last + 1}" value="${last + 1}" aria-label="Rounds shown">`);
  $("rounds-shown").addEventListener("input", showRounds);
}

function showRounds() {
  const {object} = layers.find((layer) => layer.id === "rounds");
  const count = Number($("rounds-shown").value);
  object.children.forEach((child, r) => child.visible = r < count);
  $("upto").textContent = count;
  drawSoon();
}

// Points alone are dots in their hull, which is cut like a surface.
function addLayers() {
  if (triangles.length > 0)
    addLayer("surface", "surface", new THREE.Mesh(onPoints(triangles), new THREE.MeshPhongMaterial(faceted)), true);
  if (hull.length > 0)
    addLayer("surface", "hull", new THREE.Mesh(onPoints(hull), new THREE.MeshPhongMaterial(faceted)), true);
  if (triangles.length === 0) {
    const all = Uint32Array.from({length: points.length / 3}, (_, i) => i);
    addLayer("points", "points", new THREE.Points(onPoints(all), new THREE.PointsMaterial({size: 3, sizeAttenuation: false,
      ...clipped})), true);
  }
  if (isInside.length > 0) {
    addCells("inside", "cells inside", 1);
    addCells("outside", "cells outside", 0);
  } else {
    addCells("cells", "cells", 0);
  }
  if (subgraph.length > 0)
    addLayer("subgraph", "bounded-degree subgraph",
      new THREE.LineSegments(onPoints(subgraph), new THREE.LineBasicMaterial(clipped)), false);
  if (rounds.length > 0)
    addRounds();
  if (tetrahedra.length > 0)
    addVoronoi();
}

function cutCells() {
  const found = cellsAtPlane(), add = $("whole").checked ? addWhole : addSection;
  for (const {object, kind} of layers.filter((layer) => layer.kind !== undefined)) {
    const cells = object.visible ? found[kind] : [];
    const faces = new Positions(12 * cells.length), lines = new Positions(12 * cells.length);
    cells.forEach((t) => add(t, faces, lines));
    faces.writeTo(object.children[0].geometry);
    lines.writeTo(object.children[1].geometry);
  }
  $("cut").textContent = `${(found[0].length + found[1].length).toLocaleString()} cells meet the plane`;
  drawSoon();
}

function movePlane() {
  setOffset(Number($("plane").value));
  cutCells();
}

function cutSurface() {
  const surface = layers.find((layer) => layer.id === "surface");
  if (surface)
    surface.object.material.clippingPlanes = $("cuts-surface").checked ? clipped.clippingPlanes : null;
  drawSoon();
}

const toViewer = () => new THREE.Vector3(0, 0, 1).applyQuaternion(camera.quaternion);

function turnPlane(direction) {
  setNormal(direction);
  movePlane();
}

// Colours are those of the style sheet, dark or light.
function paint() {
  const style = getComputedStyle(document.documentElement);
  const colour = (name) => style.getPropertyValue(`--${name}`).trim();
  scene.background = new THREE.Color(colour("ground"));
  for (const {id, object} of layers) {
    const [faces, lines] = id === "rounds" ? [] : object.children;
    if (lines)
      lines.material.color.set(colour("line"));
    const material = faces ? faces.material : object.material;
    if (material)
      material.color.set(colour(id));
  }
  drawSoon();
}

// --- The camera goes around what is in the middle, like a turntable: one axis always points up ---

const camera = new THREE.PerspectiveCamera(30, 1, 0.01, 100);
const light = new THREE.DirectionalLight(0xffffff, 0.45);
light.position.set(-0.3, 0.5, 1);
camera.add(light, new THREE.AmbientLight(0xffffff, 0.65));
scene.add(camera);
let renderer, isDrawn = true;
const wholeDistance = radius() / Math.sin(Math.PI / 12); // half the angle of view: the ball fits in all directions
const fromUp = {x: [0, 0, -Math.PI / 2], y: [0, 0, 0], z: [Math.PI / 2, 0, 0]}; // what turns y up
const view = {right: 0, up: 0, axis: "y", distance: wholeDistance, middle: new THREE.Vector3()};

function turn(right, up) {
  view.right += right;
  view.up = Math.min(Math.PI / 2, Math.max(-Math.PI / 2, view.up + up));
  camera.quaternion.setFromEuler(new THREE.Euler(...fromUp[view.axis]));
  camera.quaternion.multiply(new THREE.Quaternion().setFromEuler(new THREE.Euler(view.up, view.right, 0, "YXZ")));
  drawSoon();
}

function chooseUp(axis) {
  document.querySelector(`[name="up"][value="${axis}"]`).checked = true;
  view.axis = axis;
  turn(0, 0);
}

function zoom(factor) {
  view.distance = Math.min(50, Math.max(0.3, view.distance / factor));
  drawSoon();
}

// Moves what is seen, by pixels.
function pan(right, down) {
  const pixel = 2 * view.distance * Math.tan(camera.fov / 360 * Math.PI) / $("canvas").clientHeight;
  view.middle.add(new THREE.Vector3(-right, down, 0).multiplyScalar(pixel).applyQuaternion(camera.quaternion)).clampLength(0, 2);
  drawSoon();
}

function draw() {
  isDrawn = true;
  camera.position.set(0, 0, view.distance).applyQuaternion(camera.quaternion).add(view.middle);
  renderer.render(scene, camera);
}

function fitWindow() {
  const {clientWidth: width, clientHeight: height} = renderer.domElement;
  if (width === 0 || height === 0)
    return;
  renderer.setPixelRatio(window.devicePixelRatio);
  renderer.setSize(width, height, false);
  camera.aspect = width / height;
  camera.fov = 360 / Math.PI * Math.atan(Math.tan(Math.PI / 12) / Math.min(1, camera.aspect));
  camera.updateProjectionMatrix();
  drawSoon();
}

function drawSoon() {
  if (isDrawn && renderer)
    isDrawn = false, requestAnimationFrame(draw);
}

// --- What the user does ---

const axes = {__proto__: null, x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1]};

// Of the section along it most is seen.
function facingAxis() {
  const viewer = toViewer();
  return "xyz"[[2, 1, 0].reduce((a, b) => Math.abs(viewer.getComponent(b)) > Math.abs(viewer.getComponent(a)) ? b : a)];
}

// The plane faces the viewer, so that what is cut open can be seen, unless the name says how it is turned.
function chooseAxis(name) {
  const given = name.includes(",") ? name.split(",").map(Number) : axes[name];
  const direction = given ? new THREE.Vector3(...given) : toViewer();
  turnPlane(axes[name] && direction.dot(toViewer()) < 0 ? direction.negate() : direction);
  const axis = Object.keys(axes).find((key) => axes[key].every((x, k) => x === Math.abs(normal.getComponent(k))));
  document.querySelector(`[name="axis"][value="${axis || "v"}"]`).checked = true;
}

function flipPlane() {
  $("plane").value = 1 - Number($("plane").value);
  turnPlane(normal.clone().negate());
}

function step(by) {
  $("plane").value = Number($("plane").value) + by;
  movePlane();
}

const keys = {x: () => chooseAxis("x"), y: () => chooseAxis("y"), z: () => chooseAxis("z"), v: () => chooseAxis("v"),
  p: () => choosePoint($("canvas").clientWidth / 2, $("canvas").clientHeight / 2), f: flipPlane, w: () => $("whole").click(), u: () => $("cuts-surface").click(), r: reset, c: copyLink,
  ArrowLeft: () => step(-0.01), ArrowRight: () => step(0.01), "+": () => zoom(1.1), "-": () => zoom(1 / 1.1),
  i: () => pan(0, -20), k: () => pan(0, 20), j: () => pan(-20, 0), l: () => pan(20, 0)};
const keysWithShift = {ArrowLeft: () => turn(-0.1, 0), ArrowRight: () => turn(0.1, 0), ArrowUp: () => turn(0, -0.1),
  ArrowDown: () => turn(0, 0.1)};

function pressKey(event) {
  const isForInput = event.target.matches("input[type=range], input[type=radio]") && event.key.startsWith("Arrow");
  if (event.ctrlKey || event.altKey || event.metaKey || isForInput)
    return;
  const does = (event.shiftKey && keysWithShift[event.key]) || keys[event.key];
  if (does)
    does();
  else if (layers[event.key - 1])
    $(`show-${layers[event.key - 1].id}`).click();
}

// One pointer turns; with shift, or another button than the first, it moves what is seen; two zoom and move.
function followPointers(canvas) {
  const pointers = new Map();
  const spread = () => {
    const [p, q] = [...pointers.values()];
    return Math.hypot(p.x - q.x, p.y - q.y);
  };
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("pointerdown", (event) => {
    pointers.set(event.pointerId, {x: event.clientX, y: event.clientY, pans: event.shiftKey || event.button > 0, isClick: pointers.size === 0});
  });
  window.addEventListener("pointermove", (event) => {
    const pointer = pointers.get(event.pointerId);
    if (!pointer)
      return;
    const before = {...pointer}, wide = pointers.size === 2 ? spread() : 0;
    Object.assign(pointer, {x: event.clientX, y: event.clientY});
    const right = pointer.x - before.x, down = pointer.y - before.y;
    pointer.way = (pointer.way || 0) + Math.abs(right) + Math.abs(down);
    if (pointers.size === 2)
      zoom(wide > 0 ? spread() / wide : 1), pan(right / 2, down / 2);
    else if (pointer.pans)
      pan(right, down);
    else
      turn(-0.008 * right, -0.008 * down);
  });
  window.addEventListener("pointerup", (event) => {
    const pointer = pointers.get(event.pointerId), {left, top} = canvas.getBoundingClientRect();
    if (pointer && pointer.isClick && !(pointer.way > 4)) // else it was a drag
      choosePoint(event.clientX - left, event.clientY - top);
  });
  for (const name of ["pointerup", "pointercancel"])
    window.addEventListener(name, (event) => pointers.delete(event.pointerId));
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoom(Math.exp(-0.001 * event.deltaY));
  }, {passive: false});
}

function listen() {
  let isWaiting = false; // cut once a frame, however fast the slider moves
  $("plane").addEventListener("input", () => {
    if (!isWaiting)
      isWaiting = true, requestAnimationFrame(() => { isWaiting = false, movePlane(); });
  });
  $("whole").addEventListener("change", movePlane);
  $("cuts-surface").addEventListener("change", cutSurface);
  for (const input of document.querySelectorAll("[name=axis]"))
    input.addEventListener("change", () => chooseAxis(input.value));
  for (const input of document.querySelectorAll("[name=up]"))
    input.addEventListener("change", () => chooseUp(input.value));
  $("reset").addEventListener("click", reset);
  $("copy").addEventListener("click", copyLink);
  window.addEventListener("hashchange", () => setUp(location.hash));
  window.addEventListener("keydown", pressKey);
  followPointers($("canvas"));
  new ResizeObserver(() => { fitWindow(), draw(); }).observe($("canvas")); // which has cleared it: no frame may come between
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", paint);
  // What was drawn before may be gone: sizes and styles come late, and a graphics card may be taken away for a while.
  window.addEventListener("load", () => { fitWindow(), draw(); });
  $("canvas").addEventListener("webglcontextrestored", () => { fitWindow(), draw(); });
}

// --- The beginning ---

// What the address asks for, or what is shown without any wishes: cut in the middle.
function setUp(hash) {
  $("copied").textContent = "";
  const wishes = new URLSearchParams(hash.slice(1));
  const numbers = (name, ...usual) => {
    const given = (wishes.get(name) || "").split(",").map(parseFloat);
    return given.length === usual.length && given.every(Number.isFinite) ? given : usual;
  };
  const [right, up] = numbers("turn", 30, -20).map((degrees) => degrees * Math.PI / 180);
  view.right = view.up = 0;
  chooseUp(axes[wishes.get("up")] ? wishes.get("up") : "y");
  turn(right, up);
  view.distance = wholeDistance;
  zoom(numbers("zoom", 1)[0]);
  view.middle.set(...numbers("pan", 0, 0, 0)).clampLength(0, 2);
  for (const {id, object, isShown} of layers)
    $(`show-${id}`).checked = object.visible = wishes.has("show") ? wishes.get("show").split(",").includes(id) : isShown;
  $("whole").checked = wishes.has("whole");
  $("plane").value = numbers("plane", 0.5)[0];
  $("cuts-surface").checked = !wishes.has("uncut");
  cutSurface();
  const [point] = numbers("point", -1);
  showVoronoi(point);
  if (rounds.length > 0) {
    $("rounds-shown").value = numbers("rounds", Number($("rounds-shown").max))[0];
    showRounds();
  }
  const axis = wishes.get("axis") || "";
  chooseAxis(axes[axis] || axis === "v" ? axis : numbers("axis", 0, 0, 0).some(Boolean) ? axis : facingAxis());
}

// The part of the address that sets up what is seen now.
function hashOfView() {
  const short = (x) => String(Number(x.toFixed(3))), degrees = (angle) => short(angle * 180 / Math.PI);
  const axis = document.querySelector("[name=axis]:checked").value, isUsual = axes[axis] && normal.dot(toViewer()) > 1e-3;
  const parts = [`axis=${isUsual ? axis : normal.toArray().map(short).join()}`, `plane=${$("plane").value}`, `show=${layers.filter(({object}) => object.visible).map(({id}) => id).join()}`,
    `up=${view.axis}`, `turn=${degrees(view.right)},${degrees(view.up)}`, `zoom=${short(wholeDistance / view.distance)}`,
    `pan=${view.middle.toArray().map(short).join()}`];
  if (rounds.length > 0)
    parts.push(`rounds=${$("rounds-shown").value}`);
  if (chosen >= 0)
    parts.push(`point=${siteOf(chosen)}`);
  return `#${parts.concat($("whole").checked ? ["whole"] : [], $("cuts-surface").checked ? [] : ["uncut"]).join("&")}`;
}

// Some frames may not have an address of their own.
function setAddress(hash) {
  try {
    history.replaceState(null, "", hash || location.pathname + location.search);
  } catch (error) {
    return false;
  }
  return true;
}

function reset() {
  setAddress("");
  setUp("");
}

function copyLink() {
  const hash = hashOfView(), isAddress = setAddress(hash), tell = (text) => { $("copied").textContent = text; };
  const copied = isAddress && navigator.clipboard ? navigator.clipboard.writeText(location.href) : Promise.reject();
  copied.then(() => tell("copied"), () => tell(isAddress ? "it is the address of this page now" : hash));
}

function begin() {
  try {
    renderer = new THREE.WebGLRenderer({canvas: $("canvas"), antialias: true, preserveDrawingBuffer: true});
  } catch (error) {
    $("problem").textContent = "This page needs WebGL, which this browser does not have or has turned off.";
    return;
  }
  renderer.localClippingEnabled = true;
  addLayers();
  paint();
  setUp(location.hash);
  fitWindow();
  draw();
  listen();
}

begin();
