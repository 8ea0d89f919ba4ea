// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the live page runs in a worker: it reads a file, triangulates its points, and returns what the page of a view shows.
// scripts/live puts npm's index.mjs and read_surface.mjs before it.

// Of equal size along all axes: the middle of the points' box moves to 0, and its longest side to [-1, 1].
function scaleOf(points) {
  const low = [Infinity, Infinity, Infinity], high = low.map((x) => -x);
  points.forEach((x, i) => {
    low[i % 3] = Math.min(low[i % 3], x);
    high[i % 3] = Math.max(high[i % 3], x);
  });
  const half = low.map((x, k) => high[k] / 2 - x / 2); // halves do not overflow
  return {middle: low.map((x, k) => x / 2 + high[k] / 2), half, size: Math.max(...half)};
}

// Corners of cells in a box are points of their own, in each place where a cell has one: behind the points themselves, those
// that are moved by periods.
function imagesOf(triangulation, points, box) {
  const {simplices, offsets} = triangulation;
  const places = Array.from(points), sites = Array.from({length: points.length / 3}, (_, site) => site), known = new Map();
  const moves = Array.from(points, () => 0);
  const tetrahedra = Uint32Array.from(simplices, (site, i) => {
    const move = offsets.subarray(3 * i, 3 * i + 3);
    if (move.every((periods) => periods === 0))
      return site;
    const key = `${site} ${move.join(" ")}`;
    if (!known.has(key)) {
      known.set(key, sites.length);
      sites.push(site);
      moves.push(...move);
      move.forEach((periods, k) => places.push(points[3 * site + k] + periods * box[k]));
    }
    return known.get(key);
  });
  return {places, sites: Uint32Array.from(sites), moves: Int32Array.from(moves), tetrahedra};
}

// Which tetrahedra are inside, or why that is not known.
function insideOf(triangulation, triangles) {
  try {
    return {inside: triangulation.inside(triangles)};
  } catch (error) {
    if (error.status !== "NO_INSIDE")
      throw error;
    return {note: error.message};
  }
}

const isTriangle = (triangles, i) => triangles[i] !== triangles[i + 1] && triangles[i + 1] !== triangles[i + 2] &&
  triangles[i + 2] !== triangles[i];

// The arrays of a view. With weights, in a box or in a plane there are points only, as a surface then has no inside.
function viewOf(surface, triangulation, weights, box) {
  const {middle, size} = scaleOf(surface.points);
  const centered = (points) => Float32Array.from(points, (x, i) => (x - middle[i % 3]) / size);
  const scaled = (squares) => { // only differences count
    const least = squares ? squares.reduce((a, b) => Math.min(a, b)) : 0;
    return squares ? {weights: Float32Array.from(squares, (w) => (w - least) / size / size)} : {};
  };
  if (box) {
    const {places, sites, moves, tetrahedra} = imagesOf(triangulation, surface.points, box);
    return {points: centered(places), sites, moves, tetrahedra, ...scaled(weights && Float64Array.from(sites, (site) => weights[site]))};
  }
  const {simplices, vertexOfPoint, hull, dimension} = triangulation;
  const view = {points: centered(surface.points), tetrahedra: Uint32Array.from(dimension === 3 ? simplices : []), ...scaled(weights)};
  if (weights || surface.triangles.length === 0 || dimension !== 3)
    return {...view, hull: Uint32Array.from(dimension === 3 ? hull : simplices)};
  const triangles = Uint32Array.from(surface.triangles, (i) => vertexOfPoint[i]);
  const proper = triangles.filter((_, i) => isTriangle(triangles, i - i % 3));
  return {...view, triangles: proper, ...insideOf(triangulation, proper)};
}

// The periods: the sides of the points' box, and a gap, which is a share of the longest.
function boxOf(points, gap) {
  const {half, size} = scaleOf(points);
  return half.map((length) => 2 * (length + gap * size));
}

// `growth` multiplies the radii, from which weights are made; without it there are none. `gap` makes a box.
async function work(name, bytes, wasm, {growth, gap}, post) {
  const surface = readSurface(name, bytes);
  const n = surface.points.length / 3;
  if (n < 3)
    throw new Error(`${name}: it has ${n} points; three are needed`);
  const weights = growth !== undefined && surface.radii ? surface.radii.map((radius) => (growth * radius) ** 2) : undefined;
  const box = gap === undefined ? undefined : boxOf(surface.points, gap);
  await init(wasm);
  const start = performance.now();
  let last = start;
  const onProgress = (share) => {
    if (performance.now() - last > 50)
      last = performance.now(), post({share});
  };
  const triangulation = delaunay3Sync(surface.points, {weights, box, onProgress});
  const seconds = (performance.now() - start) / 1000;
  if (triangulation.dimension < 2)
    throw new Error(`${name}: all points lie on a line`);
  post({share: 1});
  const {note, ...view} = viewOf(surface, triangulation, weights, box);
  return {view, note, seconds, hasRadii: surface.radii !== null, numberOfPoints: n,
    numberOfSimplices: triangulation.numberOfSimplices, dimension: triangulation.dimension};
}

addEventListener("message", async ({data: {name, bytes, wasm, settings}}) => {
  try {
    const result = await work(name, bytes, wasm, settings, (message) => postMessage(message));
    postMessage({result}, Object.values(result.view).map((array) => array.buffer));
  } catch (error) {
    const message = String(error?.message ?? error);
    postMessage({problem: message.startsWith(name) ? message : `${name}: ${message}`});
  }
});
