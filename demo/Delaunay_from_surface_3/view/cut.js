// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The triangulation on the page that delaunay_from_surface --view writes, and the plane that cuts it.

"use strict";
const $ = (id) => document.getElementById(id);

// --- The data: little-endian numbers as base64, each array in a <script> of its own ---

function read(id, Type) {
  const element = $(id);
  if (!element)
    return new Type(0);
  const text = atob(element.textContent.trim());
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i)
    bytes[i] = text.charCodeAt(i);
  element.remove();
  return new Type(bytes.buffer, 0, Number(element.dataset.count));
}

const info = JSON.parse($("info").textContent);
const points = read("points", Float32Array);        // x, y, z; the longest side of their box goes from -1 to 1
const tetrahedra = read("tetrahedra", Uint32Array); // four points each
const isInside = read("inside", Uint8Array);        // of each tetrahedron; none if the surface has no inside
const triangles = read("triangles", Uint32Array);   // of the surface
const hull = read("hull", Uint32Array);             // those of the hull, if there is no surface
const rounds = read("rounds", Uint8Array);          // of each point, from 0; none if there is one round only
const subgraph = read("subgraph", Uint32Array);     // two points for each edge

// Of a ball around all points, in whose middle is that of their box.
function radius() {
  let square = 0;
  for (let i = 0; i < points.length; i += 3)
    square = Math.max(square, points[i] ** 2 + points[i + 1] ** 2 + points[i + 2] ** 2);
  return Math.sqrt(square);
}

// --- The plane: the points x with normal · x = offset; what lies beyond is cut off ---

const normal = new THREE.Vector3();
const heights = new Float32Array(points.length / 3); // normal · x of every point
let lowest = 0, highest = 0, offset = 0;
const clippingPlane = new THREE.Plane();

function setNormal(direction) {
  normal.copy(direction).normalize();
  lowest = Infinity, highest = -Infinity;
  for (let i = 0; i < heights.length; ++i) {
    heights[i] = normal.x * points[3 * i] + normal.y * points[3 * i + 1] + normal.z * points[3 * i + 2];
    lowest = Math.min(lowest, heights[i]), highest = Math.max(highest, heights[i]);
  }
}

// From 0, where everything is cut off, to 1.
function setOffset(share) {
  offset = lowest + (highest - lowest) * share;
  clippingPlane.normal.copy(normal).negate();
  clippingPlane.constant = offset;
}

// --- The cells that the plane meets ---

// Positions, three numbers each.
class Positions {
  constructor(count) { this.array = new Float32Array(3 * count), this.size = 0; }
  add(a, b = a) { // a point, or where the edge from a to b meets the plane
    const t = a === b ? 0 : (offset - heights[a]) / (heights[b] - heights[a]);
    for (let k = 0; k < 3; ++k)
      this.array[this.size++] = points[3 * a + k] + t * (points[3 * b + k] - points[3 * a + k]);
  }
  writeTo(geometry) {
    geometry.dispose(); // what the last one holds on the graphics card
    geometry.setAttribute("position", new THREE.BufferAttribute(this.array.subarray(0, this.size), 3));
  }
}

// The section of a tetrahedron, which begins at place t of the array, is a triangle or a quadrangle.
function addSection(t, faces, lines) {
  const above = [], below = [], corners = [];
  for (let k = t; k < t + 4; ++k)
    (heights[tetrahedra[k]] > offset ? above : below).push(tetrahedra[k]);
  above.forEach((a, i) => (i % 2 ? below.reverse() : below).forEach((b) => corners.push([a, b])));
  for (let i = 2; i < corners.length; ++i)
    for (const j of [0, i - 1, i])
      faces.add(...corners[j]);
  corners.forEach((corner, i) => {
    lines.add(...corner);
    lines.add(...corners[(i + 1) % corners.length]);
  });
}

function addWhole(t, faces, lines) {
  for (let i = 0; i < 4; ++i)
    for (let j = 0; j < 4; ++j) {
      if (i !== j)
        faces.add(tetrahedra[t + j]);
      if (i < j)
        lines.add(tetrahedra[t + i]), lines.add(tetrahedra[t + j]);
    }
}

// Where the tetrahedra with points on both sides begin: those outside or of which that is not known, and
// those inside.
function cellsAtPlane() {
  const found = [[], []];
  for (let t = 0; t < tetrahedra.length; t += 4) {
    const above = (heights[tetrahedra[t]] > offset) + (heights[tetrahedra[t + 1]] > offset) +
      (heights[tetrahedra[t + 2]] > offset) + (heights[tetrahedra[t + 3]] > offset);
    if (above !== 0 && above !== 4)
      found[isInside[t / 4] | 0].push(t);
  }
  return found;
}
