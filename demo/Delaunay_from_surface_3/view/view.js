// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the page that delaunay_from_surface --view writes shows, and what its user does. The program puts the
// data, three.js, cut.js and this file into view.html. What follows # in the address sets the page up:
//   #axis=z&plane=0.4&show=surface,inside&whole&rounds=3&turn=30,-20&zoom=1.2
// At first the surface is whole, unless the address has a plane; as soon as that is moved it cuts the surface, too.

"use strict";
// --- What is shown ---

$("name").textContent = document.title = info.name;
$("counts").textContent = `${(points.length / 3).toLocaleString()} vertices, ` +
  `${(tetrahedra.length / 4).toLocaleString()} tetrahedra`;

const layers = [];
const scene = new THREE.Scene();
const positions = new THREE.BufferAttribute(points, 3);

function addLayer(id, label, object, isShown, more = {}) {
  const layer = {id, object, ...more};
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

function addCells(id, label, kind) {
  const group = new THREE.Group();
  group.add(new THREE.Mesh(new THREE.BufferGeometry(), new THREE.MeshPhongMaterial(faceted)));
  const pen = new THREE.LineBasicMaterial({transparent: true, opacity: 0.6});
  group.add(new THREE.LineSegments(new THREE.BufferGeometry(), pen));
  group.children.forEach((child) => child.frustumCulled = false);
  addLayer(id, label, group, true, {isCells: true, kind});
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

function addLayers() {
  if (triangles.length > 0)
    addLayer("surface", "surface", new THREE.Mesh(onPoints(triangles), new THREE.MeshPhongMaterial(faceted)), true);
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
}

function cutCells() {
  const found = cellsAtPlane(), add = $("whole").checked ? addWhole : addSection;
  for (const {object, kind} of layers.filter((layer) => layer.isCells)) {
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

// The user's plane shows what is behind it.
function cutFromNowOn() {
  $("cuts-surface").checked = true;
  cutSurface();
}

function turnPlane(direction) {
  setNormal(direction);
  movePlane();
}

// Colours are those of the style sheet, dark or light.
function paint() {
  const style = getComputedStyle(document.documentElement);
  const colour = (name) => style.getPropertyValue(`--${name}`).trim();
  scene.background = new THREE.Color(colour("ground"));
  for (const {id, object, isCells} of layers) {
    if (isCells)
      object.children[1].material.color.set(colour("line"));
    const material = isCells ? object.children[0].material : object.material;
    if (material)
      material.color.set(colour(id));
  }
  drawSoon();
}

// --- The camera goes around the origin ---

const camera = new THREE.PerspectiveCamera(30, 1, 0.01, 100);
const light = new THREE.DirectionalLight(0xffffff, 0.45);
light.position.set(-0.3, 0.5, 1);
camera.add(light, new THREE.AmbientLight(0xffffff, 0.65));
scene.add(camera);
let renderer, isDrawn = true;
let distance = radius() / Math.sin(Math.PI / 12); // half the angle of view: the ball fits in all directions

function turn(right, up) {
  camera.quaternion.multiply(new THREE.Quaternion().setFromEuler(new THREE.Euler(up, right, 0)));
  drawSoon();
}

function zoom(factor) {
  distance = Math.min(50, Math.max(0.3, distance / factor));
  drawSoon();
}

function draw() {
  isDrawn = true;
  camera.position.set(0, 0, distance).applyQuaternion(camera.quaternion);
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
  if (isDrawn)
    isDrawn = false, requestAnimationFrame(draw);
}

// --- What the user does ---

// The plane faces the viewer, so that what is cut open can be seen.
function chooseAxis(name) {
  document.querySelector(`[name="axis"][value="${name}"]`).checked = true;
  const viewer = new THREE.Vector3(0, 0, 1).applyQuaternion(camera.quaternion);
  const axis = {x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1]}[name];
  const direction = axis ? new THREE.Vector3(...axis) : viewer;
  turnPlane(direction.dot(viewer) < 0 ? direction.negate() : direction);
}

function flipPlane() {
  cutFromNowOn();
  $("plane").value = 1 - Number($("plane").value);
  turnPlane(normal.clone().negate());
}

function step(by) {
  cutFromNowOn();
  $("plane").value = Number($("plane").value) + by;
  movePlane();
}

function cutAlong(axis) {
  cutFromNowOn();
  chooseAxis(axis);
}

const keys = {x: () => cutAlong("x"), y: () => cutAlong("y"), z: () => cutAlong("z"), v: () => cutAlong("v"),
  f: flipPlane, w: () => $("whole").click(), ArrowLeft: () => step(-0.01), ArrowRight: () => step(0.01)};

function pressKey(event) {
  const isForInput = event.target.matches("input[type=range], input[type=radio]") && event.key.startsWith("Arrow");
  if (event.ctrlKey || event.altKey || event.metaKey || isForInput)
    return;
  if (keys[event.key])
    keys[event.key]();
  else if (layers[event.key - 1])
    $(`show-${layers[event.key - 1].id}`).click();
}

// One pointer turns, two zoom.
function followPointers(canvas) {
  const pointers = new Map();
  const spread = () => {
    const [p, q] = [...pointers.values()];
    return Math.hypot(p.x - q.x, p.y - q.y);
  };
  canvas.addEventListener("pointerdown", (event) => {
    pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
  });
  window.addEventListener("pointermove", (event) => {
    const pointer = pointers.get(event.pointerId);
    if (!pointer)
      return;
    const before = {...pointer}, wide = pointers.size === 2 ? spread() : 0;
    Object.assign(pointer, {x: event.clientX, y: event.clientY});
    if (pointers.size === 2)
      zoom(spread() / wide);
    else
      turn(-0.008 * (pointer.x - before.x), -0.008 * (pointer.y - before.y));
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
    cutFromNowOn();
    if (!isWaiting)
      isWaiting = true, requestAnimationFrame(() => { isWaiting = false, movePlane(); });
  });
  $("whole").addEventListener("change", movePlane);
  $("cuts-surface").addEventListener("change", cutSurface);
  for (const input of document.querySelectorAll("[name=axis]"))
    input.addEventListener("change", () => cutAlong(input.value));
  window.addEventListener("keydown", pressKey);
  followPointers($("canvas"));
  new ResizeObserver(() => { fitWindow(), draw(); }).observe($("canvas")); // which has cleared it: no frame may come between
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", paint);
  // What was drawn before may be gone: sizes and styles come late, and a graphics card may be taken away for a while.
  window.addEventListener("load", () => { fitWindow(), draw(); });
  $("canvas").addEventListener("webglcontextrestored", () => { fitWindow(), draw(); });
}

// --- The beginning ---

// What the address asks for.
function setUp() {
  const wishes = new URLSearchParams(location.hash.slice(1));
  const [right, up] = (wishes.get("turn") || "30,-20").split(",").map((degrees) => degrees * Math.PI / 180);
  turn(right, 0), turn(0, up);
  zoom(Number(wishes.get("zoom") || 1));
  if (wishes.has("show"))
    for (const {id, object} of layers)
      $(`show-${id}`).checked = object.visible = wishes.get("show").split(",").includes(id);
  $("whole").checked = wishes.has("whole");
  $("plane").value = wishes.get("plane") || 0.6;
  $("cuts-surface").checked = wishes.has("plane");
  cutSurface();
  if (rounds.length > 0) {
    $("rounds-shown").value = wishes.get("rounds") || $("rounds-shown").max;
    showRounds();
  }
  chooseAxis(wishes.get("axis") || longestAxis());
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
  setUp();
  fitWindow();
  draw();
  listen();
}

begin();
