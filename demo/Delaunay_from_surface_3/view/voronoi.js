// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The Voronoi cell of one point: what remains of a box around everything if each neighbour cuts off the half-space that
// is nearer to it. With weights it is the power cell.

"use strict";
const weights = read("weights", Float32Array); // of each point, a squared radius; none without weights
const sites = read("sites", Uint32Array);      // in a periodic box, for each point: of which it is an image; else none
const moves = read("moves", Int32Array);       // and by how many periods along each axis

const siteOf = (i) => (sites.length > 0 ? sites[i] : i);

// Of the points, those that have cells: all but those that are hidden by weights, or stand in the place of another.
const isVertex = new Uint8Array(points.length / 3);
for (const array of [tetrahedra, hull, triangles])
  array.forEach((i) => { isVertex[siteOf(i)] = 1; });

// Tells neighbours q of p apart: by number, and in a box by where its images are.
const keyOf = (p, q) => (sites.length > 0 ? [siteOf(q), ...[0, 1, 2].map((k) => moves[3 * q + k] - moves[3 * p + k])].join() : q);

// The half-spaces x · n <= d of the neighbours, where x goes out from the point, and so does n to the neighbour. In a
// box tetrahedra stand for their images: those of all images of the point are moved to it.
function halfSpaces(i) {
  const found = new Map();
  for (let t = 0; t < tetrahedra.length; t += 4)
    for (let k = t; k < t + 4; ++k) {
      const p = tetrahedra[k];
      if (siteOf(p) !== siteOf(i))
        continue;
      for (let l = t; l < t + 4; ++l) {
        if (l === k)
          continue;
        const q = tetrahedra[l], n = [0, 1, 2].map((c) => points[3 * q + c] - points[3 * p + c]);
        const square = n[0] ** 2 + n[1] ** 2 + n[2] ** 2;
        const d = (square + (weights.length > 0 ? weights[p] - weights[q] : 0)) / 2;
        found.set(keyOf(p, q), {n, d});
      }
    }
  return [...found.values()];
}

const lengthAlong = ({n, d}, x) => n[0] * x[0] + n[1] * x[1] + n[2] * x[2] - d;

// What a half-space leaves of a convex polygon, and in `cut` where it cuts it.
function clipPolygon(corners, halfSpace, cut) {
  const heights = corners.map((x) => lengthAlong(halfSpace, x)), left = [];
  corners.forEach((a, i) => {
    const j = (i + 1) % corners.length, b = corners[j];
    if (heights[i] <= 0)
      left.push(a);
    if ((heights[i] <= 0) !== (heights[j] <= 0)) {
      const share = heights[i] / (heights[i] - heights[j]);
      const x = a.map((coordinate, k) => coordinate + share * (b[k] - coordinate));
      left.push(x);
      cut.push(x);
    }
  });
  return left;
}

// Points of a plane through n, which are the corners of a convex polygon, around it.
function inOrder(corners, [a, b, c]) {
  const u = Math.abs(a) > Math.abs(b) ? [-c, 0, a] : [0, -c, b], v = [b * u[2] - c * u[1], c * u[0] - a * u[2], a * u[1] - b * u[0]];
  const middle = [0, 1, 2].map((k) => corners.reduce((sum, x) => sum + x[k], 0) / corners.length);
  const along = (x, w) => w.reduce((sum, y, k) => sum + y * (x[k] - middle[k]), 0);
  const scale = Math.hypot(a, b, c);
  const angles = new Map(corners.map((x) => [x, Math.atan2(along(x, v) / scale, along(x, u))]));
  return [...corners].sort((x, y) => angles.get(x) - angles.get(y));
}

// The faces of a convex polyhedron from which a half-space cuts off a part.
function clipPolyhedron(faces, halfSpace) {
  const cut = [], left = faces.map((face) => clipPolygon(face, halfSpace, cut)).filter((face) => face.length > 2);
  return cut.length > 2 && left.length > 0 ? [...left, inOrder(cut, halfSpace.n)] : left;
}

// The box in which cells are shown, from a point: half as long again as that of all points, or around an image of one.
function boxAround(i) {
  const low = [0, 1, 2].map((k) => (sites.length > 0 ? -3 : -1.5 - points[3 * i + k])), high = low.map((x) => x + (sites.length > 0 ? 6 : 3));
  const corner = (bits) => [0, 1, 2].map((k) => (bits >> k & 1 ? high : low)[k]);
  return [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]].map((face) => face.map(corner));
}

// The polygons of the cell of a point, from that point; and how many neighbours it has.
function voronoiCell(i) {
  const planes = halfSpaces(i);
  return {faces: planes.reduce(clipPolyhedron, boxAround(i)), neighbors: planes.length};
}

// The foremost point near a place of the picture, which pixels give, or undefined. What the plane cuts off is not seen.
function pointAt(x, y, camera, {clientWidth: width, clientHeight: height}, isCut) {
  let best, nearest = Infinity;
  const place = new THREE.Vector3();
  for (let i = 0; i < heights.length; ++i) {
    if (!isVertex[siteOf(i)] || (isCut && heights[i] > offset))
      continue;
    const depth = place.fromArray(points, 3 * i).distanceTo(camera.position);
    place.project(camera);
    const away = Math.hypot((place.x + 1) / 2 * width - x, (1 - place.y) / 2 * height - y) / 12;
    if (Math.abs(place.z) < 1 && away < 1 && away + 4 * depth < nearest)
      nearest = away + 4 * depth, best = i;
  }
  return best;
}
