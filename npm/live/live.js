// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The live page: what is dropped onto it is triangulated by a worker, and shown by the page of a view in a frame.

"use strict";
const $ = (id) => document.getElementById(id);

function bytesOf(base64) {
  const text = atob(base64.trim()), bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i)
    bytes[i] = text.charCodeAt(i);
  return bytes;
}

function base64Of(array) {
  const bytes = new Uint8Array(array.buffer, array.byteOffset, array.byteLength), parts = [];
  for (let i = 0; i < bytes.length; i += 24573) // a multiple of 3
    parts.push(btoa(String.fromCharCode(...bytes.subarray(i, i + 24573))));
  return parts;
}

const wasm = bytesOf($("wasm").textContent);
const [pageBefore, pageAfter] = JSON.parse($("page").textContent).split("<!--data-->");
const workerAddress = URL.createObjectURL(new Blob([JSON.parse($("worker").textContent)], {type: "text/javascript"}));

let file;     // what was opened last: its name and, once they are read, its bytes
let worker;   // while it works
let turn = 0; // changes when something begins or ends
let shownFile, shownArrays = "", lastHash = ""; // of the view: the names of its arrays, and how it was last set up

// --- What is shown ---

// An element for data of the page, in parts. This script may not contain the tag itself.
function elementOf(id, content, count = 0) {
  const tag = "script";
  return [`<${tag} type="text/plain" id="${id}" data-count="${count}">`, ...content, `</${tag}>\n`];
}

// The part of the address that keeps what is seen of a file. Other arrays have other layers.
function hashFor(names) {
  lastHash = $("view").contentDocument?.readyState === "complete" && $("view").contentWindow.hashOfView?.() || lastHash;
  const hash = file === shownFile ? lastHash : "";
  return names === shownArrays ? hash : hash.replace(/&show=[^&]*/, "");
}

function show(view) {
  const info = JSON.stringify({name: file.name}).replaceAll("<", "\\u003c"), arrays = Object.entries(view).filter(([, array]) => array.length > 0);
  const names = arrays.map(([id]) => id).join(), hash = hashFor(names);
  const parts = [pageBefore, ...elementOf("info", [info]),
    ...arrays.flatMap(([id, array]) => elementOf(id, base64Of(array), array.length)), pageAfter];
  $("view").onload = () => {
    takeFiles($("view").contentWindow);
    if (hash)
      $("view").contentWindow.setUp(hash);
  };
  $("view").srcdoc = parts.join("");
  [shownFile, shownArrays, lastHash] = [file, names, hash];
}

function tell(result, problem = "") {
  $("result").textContent = result;
  $("problem").textContent = problem;
}

function begin() {
  end();
  tell("");
  $("share").value = 0;
  $("share").hidden = $("stop").hidden = false;
}

function end() {
  ++turn;
  worker?.terminate();
  worker = undefined;
  $("share").hidden = $("stop").hidden = true;
}

const counted = (n, what) => `${n.toLocaleString("en")} ${what}`;

function finish({view, note, seconds, hasRadii, numberOfPoints, numberOfSimplices, dimension}) {
  end();
  $("controls").hidden = false;
  $("for-radii").hidden = !hasRadii;
  tell(`${counted(numberOfPoints, "points")}, ${counted(numberOfSimplices, dimension === 3 ? "tetrahedra" : "triangles, as all points lie in a plane")}, in ` +
    `${seconds.toFixed(2)} s${note ? `; ${note}` : ""}`);
  try {
    show(view);
  } catch (error) {
    $("problem").textContent = `${file.name}: ${error instanceof RangeError ? "it is too large to be shown" : error.message}`;
  }
}

function fail(problem) {
  end();
  tell("", problem);
}

// Begins anew with what is chosen.
function run() {
  if (file.bytes === undefined)
    return;
  begin();
  const settings = {gap: $("is-box").checked ? Number($("gap").value) : undefined,
    growth: $("has-weights").checked ? Number($("growth").value) : undefined};
  worker = new Worker(workerAddress);
  const mine = turn;
  worker.onmessage = ({data: {share, result, problem}}) => {
    if (mine !== turn) // what was on its way comes too late
      return;
    if (result)
      finish(result);
    else if (problem !== undefined)
      fail(problem);
    else
      $("share").value = share;
  };
  worker.onmessageerror = worker.onerror = (event) => fail(`${file.name}: ${event.message ?? "the worker did not start"}`);
  worker.postMessage({name: file.name, bytes: file.bytes, wasm, settings});
}

async function open(given) {
  begin();
  file = {name: given.name};
  const mine = turn;
  try {
    file.bytes = new Uint8Array(await given.arrayBuffer());
  } catch (error) { // it is a folder, say
    return mine === turn ? fail(`${given.name}: ${error.message}`) : undefined;
  }
  if (mine !== turn)
    return;
  $("is-box").checked = $("has-weights").checked = false;
  run();
}

// --- Examples ---

const asFile = (name, lines) => new File([lines.join("\n")], name);

// A tube around the curve of a trefoil.
function knot() {
  const around = 300, across = 24, vertices = [], faces = [];
  const curve = (t) => [Math.sin(t) + 2 * Math.sin(2 * t), Math.cos(t) - 2 * Math.cos(2 * t), -Math.sin(3 * t)];
  for (let i = 0; i < around; ++i) {
    const t = 2 * Math.PI * i / around, [x, y, z] = curve(t), [a, b, c] = curve(t + 1e-4).map((q, k) => (q - [x, y, z][k]) / 1e-4);
    const length = Math.hypot(a, b), normal = [-b / length, a / length, 0], all = Math.hypot(a, b, c);
    const other = [-c * a / length / all, -c * b / length / all, length / all];
    for (let j = 0; j < across; ++j) {
      const s = 2 * Math.PI * j / across;
      vertices.push([x, y, z].map((q, k) => q + 0.5 * (Math.cos(s) * normal[k] + Math.sin(s) * other[k])).join(" "));
      const next = (i + 1) % around * across, here = i * across, k = (j + 1) % across;
      faces.push(`4 ${here + j} ${next + j} ${next + k} ${here + k}`);
    }
  }
  return asFile("knot.off", [`OFF`, `${vertices.length} ${faces.length} 0`, ...vertices, ...faces]);
}

// Random numbers that are the same each time.
function* randomNumbers(seed = 1) {
  for (;;) {
    seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
    yield seed / 2 ** 32;
  }
}

function cloud() {
  const random = randomNumbers(), number = () => random.next().value;
  return asFile("cloud.xyz", Array.from({length: 2000}, () => `${number()} ${number()} ${number()}`));
}

// Atoms of two sizes, each of which touches the one before.
function chain() {
  const random = randomNumbers(7), atoms = [];
  let place = [0, 0, 0];
  for (let i = 0; i < 300; ++i) {
    const step = [0, 0, 0].map(() => random.next().value - 0.5), length = Math.hypot(...step);
    const pulled = step.map((x, k) => 1.5 * x / length - 0.06 * place[k]); // towards the middle
    place = place.map((x, k) => x + pulled[k]);
    atoms.push(`${place.join(" ")} ${i % 3 === 0 ? 1.7 : 1.2}`);
  }
  return asFile("chain.xyz", atoms);
}

// --- What the user does ---

function listen() {
  $("file").addEventListener("change", () => {
    open($("file").files[0]);
    $("file").value = ""; // the same may be chosen again
  });
  for (const [id, make] of Object.entries({knot, cloud, chain}))
    $(id).addEventListener("click", () => open(make()));
  $("stop").addEventListener("click", () => fail(`${file.name}: stopped`));
  for (const [box, slider] of [["is-box", "gap"], ["has-weights", "growth"]]) {
    $(box).addEventListener("change", run);
    $(slider).addEventListener("change", () => {
      $(box).checked = true;
      run();
    });
  }
  takeFiles(window);
}

// What is dropped onto a window.
function takeFiles(target) {
  const mark = (isOver) => document.body.classList.toggle("is-over", isOver);
  target.addEventListener("dragover", (event) => {
    event.preventDefault();
    mark(true);
  });
  target.addEventListener("dragleave", (event) => event.relatedTarget ?? mark(false));
  target.addEventListener("drop", (event) => {
    event.preventDefault();
    mark(false);
    if (event.dataTransfer.files.length > 0)
      open(event.dataTransfer.files[0]);
  });
}

listen();
open(knot());
