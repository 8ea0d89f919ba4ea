// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What test_npm.py runs in Node.js and in a browser: returns the lines of fixed_inputs.h as they come out here, and
// what is wrong.

export async function test(library) {
  const lines = [], faults = [];
  const check = (name, is) => is || faults.push(name);
  await library.init();
  for (const [name, points] of Object.entries(fixedInputs()))
    lines.push(lineOf(name, library.delaunay3Sync(points)));
  for (const part of [testArrays, testForms, testBoxes, testWeights, testRefusals, testMemory, testWorker])
    await part(library, check).catch((error) => faults.push(`${part.name}: ${error.stack}`));
  return {lines, faults};
}

// As in fixed_inputs.h: the same points on every machine.

class SplitMix {
  constructor(seed) {
    this.state = BigInt(seed);
  }

  next() {
    this.state = BigInt.asUintN(64, this.state + 0x9e3779b97f4a7c15n);
    let z = this.state;
    z = BigInt.asUintN(64, (z ^ (z >> 30n)) * 0xbf58476d1ce4e5b9n);
    z = BigInt.asUintN(64, (z ^ (z >> 27n)) * 0x94d049bb133111ebn);
    return z ^ (z >> 31n);
  }

  bits(n) {
    return Number(this.next() >> BigInt(64 - n));
  }
}

function pointsOf(n, next) {
  return Float64Array.from(Array.from({length: n}, (_, i) => next(i)).flat());
}

function pointsAtSquare(square) {
  const points = [], range = Array.from({length: 199}, (_, i) => i - 99);
  for (const x of range)
    for (const y of range)
      for (const z of range)
        if (x * x + y * y + z * z === square)
          points.push([x, y, z]);
  return points;
}

function fixedInputs() {
  let random = new SplitMix(1);
  const three = (n) => [random.bits(n), random.bits(n), random.bits(n)];
  const inputs = {
    "cube": pointsOf(3000, () => three(53).map((x) => x * 2 ** -53)),
    "near duplicates": pointsOf(3000, (i) => {
      random = new SplitMix(Math.floor(i / 2));
      const [x, y, z] = three(24);
      return [x + i % 2, y, z];
    }),
    "grid": pointsOf(1331, (i) => [.1 * Math.floor(i / 121), .1 * (Math.floor(i / 11) % 11), .1 * (i % 11)]),
    "integer sphere": pointsAtSquare(5861).flat(),
    "plane": pointsOf(900, (i) => [Math.floor(i / 30), i % 30, Math.floor(i / 30) + 2 * (i % 30)]),
    "line": pointsOf(500, (i) => [i * 7 % 500, 2 * (i * 7 % 500), -(i * 7 % 500)]),
    "skew lines": pointsOf(120, (i) => [i % 2 ? 0 : i / 2, i % 2 ? (i - 1) / 2 : 0, i % 2]),
  };
  random = new SplitMix(1);
  inputs["thin sheet"] = pointsOf(2000, () => [random.bits(30), random.bits(30), random.bits(53) * 2 ** -83]);
  random = new SplitMix(1);
  inputs["far away"] = pointsOf(2000, () => [2 ** 52 + random.bits(20), 2 ** 40 + random.bits(20), random.bits(20) * 2 ** -20]);
  return inputs;
}

// A line of the table in fixed_inputs.h.
function lineOf(name, {dimension, numberOfPoints, numberOfSimplices, simplices}) {
  const rows = Array.from({length: numberOfSimplices}, (_, c) => {
    const row = simplices.slice((dimension + 1) * c, (dimension + 1) * (c + 1)).sort();
    return [...Array(3 - dimension).fill(-1), ...row];
  });
  rows.sort((a, b) => a[0] - b[0] || a[1] - b[1] || a[2] - b[2] || a[3] - b[3]);
  let high = 0xcbf29ce4, low = 0x84222325; // FNV-1a, 64 bits in two halves
  for (const byte of new Uint8Array(Int32Array.from(rows.flat()).buffer)) {
    low = (low ^ byte) >>> 0;
    const product = low * 0x1b3;
    high = (Math.imul(high, 0x1b3) + (low << 8) + Math.floor(product / 2 ** 32)) >>> 0;
    low = product >>> 0;
  }
  const hex = (x) => x.toString(16).padStart(8, "0");
  return `{"${name}", ${numberOfPoints}, ${numberOfSimplices}, 0x${hex(high)}${hex(low)}}`;
}

function randomPoints(n) {
  const random = new SplitMix(n);
  return pointsOf(n, () => [0, 1, 2].map(() => random.bits(30) * 2 ** -30));
}

// Six times the volume of the simplex at these points.
function determinant(points, corners) {
  const [a, b, c, d] = [...corners].map((v) => points.subarray(3 * v, 3 * v + 3));
  const [[x, y, z], [u, v, w], [p, q, r]] = [b, c, d].map((e) => [0, 1, 2].map((k) => e[k] - a[k]));
  return x * (v * r - w * q) - y * (u * r - w * p) + z * (u * q - v * p);
}

function rowsOf(array, width) {
  return Array.from({length: array.length / width}, (_, i) => array.subarray(width * i, width * (i + 1)));
}

async function testArrays({delaunay3}, check) {
  const points = randomPoints(2000), d = await delaunay3(points);
  const tetrahedra = rowsOf(d.simplices, 4), neighbors = rowsOf(d.neighbors, 4), hull = rowsOf(d.hull, 3);
  check("sizes", d.dimension === 3 && d.numberOfPoints === 2000 && tetrahedra.length === d.numberOfSimplices);
  check("positive", tetrahedra.every((t) => determinant(points, t) > 0));
  check("neighbours agree", neighbors.every((row, c) => row.every((e) => e === -1 || neighbors[e].includes(c))));
  const volume = tetrahedra.reduce((sum, t) => sum + determinant(points, t), 0);
  const ofHull = hull.reduce((sum, t) => sum + determinant(points, [0, ...t]), 0);
  check("hull", Math.abs(volume - ofHull) < 1e-9 && volume > 5);
  check("valid", d.isValid() && d.isValid(0));
  check("vertices", d.vertexOfPoint.every((v, i) => v === i));
  check("no box", d.offsets === null);
  const queries = tetrahedra.map((t) => [0, 1, 2].map((k) => t.reduce((sum, v) => sum + points[3 * v + k], 0) / 4));
  check("find", d.find(queries).every((c, i) => c === i) && d.find([2, 2, 2])[0] === -1 && d.find([]).length === 0);
  check("inside hull", d.inside(d.hull).every((is) => is === 1));
  check("winding", d.windingNumbers(d.hull).every((number) => Math.abs(number - 1) < 1e-6));
}

async function testForms({delaunay3}, check) {
  const points = randomPoints(500).map(Math.fround), expected = String((await delaunay3(points)).simplices);
  for (const form of [new Float32Array(points), [...points], rowsOf(points, 3), rowsOf(points, 3).map((row) => [...row])])
    check("forms", String((await delaunay3(form)).simplices) === expected);
  for (const [given, dimension] of [[[], -1], [[1, 2, 3, 1, 2, 3], 0], [[0, 0, 0, 1, 2, 3], 1]]) {
    const d = await delaunay3(given);
    check(`dimension ${dimension}`, d.dimension === dimension && d.simplices.length === (dimension + 1) * d.numberOfSimplices);
  }
  check("duplicates", String((await delaunay3([1, 2, 3, 1, 2, 3])).vertexOfPoint) === "0,0");
  const square = await delaunay3([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]);
  check("square", square.numberOfSimplices === 2 && square.simplices.length === 6 && square.hull.length === 8);
}

async function testBoxes({delaunay3}, check) {
  const points = randomPoints(300);
  for (const box of [[1, 1, 1], [1, null, Infinity]]) {
    const d = await delaunay3(points, {box}), offsets = d.offsets;
    const moved = new Float64Array(12 * d.numberOfSimplices);
    d.simplices.forEach((v, i) => {
      for (let k = 0; k < 3; ++k)
        moved[3 * i + k] = points[3 * v + k] + (offsets[3 * i + k] && offsets[3 * i + k] * box[k]);
    });
    const volumes = rowsOf(d.simplices, 4).map((_, c) => determinant(moved, [0, 1, 2, 3].map((k) => 4 * c + k)));
    check("box: positive", volumes.every((volume) => volume > 0) && d.hull.length === 0);
    check("box: hull", d.neighbors.includes(-1) === box.includes(null));
    if (!box.includes(null))
      check("box: full", Math.abs(volumes.reduce((sum, volume) => sum + volume) - 6) < 1e-9);
    check("box: find", d.find([7.5, .5, .5])[0] >= 0);
  }
}

async function testWeights({delaunay3}, check) {
  const points = randomPoints(300), weights = Array.from({length: 300}, (_, i) => i % 7 / 100);
  const d = await delaunay3(points, {weights});
  check("weights", d.isValid() && d.vertexOfPoint.includes(-1) && rowsOf(d.simplices, 4).every((t) => determinant(points, t) > 0));
  check("weights: box", (await delaunay3(points, {weights: Float64Array.from(weights), box: [1, 1, 1]})).offsets !== null);
}

function refused(f, Delaunay3Error, ...expected) {
  try {
    f();
  } catch (error) {
    return error instanceof Delaunay3Error && error.message.length > 9 &&
      expected.every((value, i) => value === [error.status, error.where][i]);
  }
  return false;
}

async function testRefusals({delaunay3Sync, Delaunay3Error}, check) {
  const points = randomPoints(100), d = delaunay3Sync(points), far = Float64Array.from(points);
  far[17] = NaN;
  const cases = [
    ["NOT_FINITE", 5, () => delaunay3Sync(far)],
    ["NOT_FINITE", 7, () => delaunay3Sync(points, {weights: Array.from({length: 100}, (_, i) => i === 7 ? Infinity : 0)})],
    ["NOT_FINITE", 1, () => d.find([1, 2, 3, 4, NaN, 6])],
    ["BAD_INDEX", 1, () => d.inside([0, 1, 2, 3, 100, 4])],
    ["BAD_INDEX", 0, () => d.inside(new Int32Array([0, -1, 2]))],
    ["BAD_INDEX", 1, () => d.inside([[0, 1, 2], [2, 1, .5]])],
    ["NO_INSIDE", undefined, () => d.inside([0, 1, 2])],
    ["BAD_ARGUMENT", undefined, () => d.inside([])],
    ["BAD_BOX", undefined, () => delaunay3Sync(points, {box: [1, 0, 1]})],
    ["BAD_ARGUMENT", undefined, () => delaunay3Sync(points, {box: [1, 1]})],
    ["BAD_ARGUMENT", undefined, () => delaunay3Sync(points, {weights: [1, 2]})],
    ["BAD_ARGUMENT", undefined, () => delaunay3Sync(points, {box: [1, 1, 1]}).isValid()],
    ["BAD_ARGUMENT", undefined, () => d.isValid(4)],
    ["BAD_ARGUMENT", undefined, () => d.isValid(NaN)],
    ["STOPPED", undefined, () => delaunay3Sync(points, {onProgress: () => false})],
  ];
  for (const wrong of [points.subarray(1), [1, 2], [[1, 2, 3], [4, 5]], [[1, 2, "3"]], ["1", "2", "3"], new BigInt64Array(3),
    new DataView(new ArrayBuffer(24)), "123", null, undefined, 7, {length: 3}, Object.assign([], {0: [1, 2, 3], 2: [4, 5, 6]})])
    cases.push(["BAD_ARGUMENT", undefined, () => delaunay3Sync(wrong)]);
  for (const [status, where, f] of cases)
    check(`refusal ${status}: ${f}`, refused(f, Delaunay3Error, status, where));
  check("alive after refusals", d.isValid() && d.find([.5, .5, .5])[0] >= 0);
  const own = new Error("mine");
  try {
    delaunay3Sync(points, {onProgress: () => { throw own; }});
  } catch (error) {
    check("an exception of the caller's", error === own);
  }
}

async function testMemory({delaunay3Sync, Delaunay3Error}, check) {
  // More than WebAssembly's 4 GB; where not even this much is to be had, JavaScript refuses it.
  let points;
  try {
    points = new Float64Array(3 * 180e6);
  } catch (error) {
    return check("RangeError", error instanceof RangeError);
  }
  check("no memory", refused(() => delaunay3Sync(points), Delaunay3Error, "NO_MEMORY", undefined));
}

async function testWorker({delaunay3Sync, delaunay3InWorker, Delaunay3Error}, check) {
  const points = randomPoints(100000), d = delaunay3Sync(points), shares = [];
  const w = await delaunay3InWorker(points, {onProgress: (share) => shares.push(share)});
  for (const name of ["simplices", "neighbors", "vertexOfPoint", "hull"])
    check(`worker: ${name}`, w[name].every((x, i) => x === d[name][i]) && w[name].length === d[name].length);
  check("worker: progress", shares.length > 1 && shares.every((x, i) => x >= (shares[i - 1] ?? 0)) && shares.at(-1) === 1);
  check("worker: find", (await w.find([.5, .5, .5]))[0] === d.find([.5, .5, .5])[0]);
  check("worker: questions", await w.isValid(0) && (await w.inside(w.hull)).every((is) => is === 1));
  const error = await w.find([NaN, 0, 0]).catch((it) => it);
  check("worker: refusal", error instanceof Delaunay3Error && error.status === "NOT_FINITE" && error.where === 0);
  w.close();
  check("worker: closed", (await w.find([0, 0, 0]).catch((it) => it)).status === "STOPPED");
  const wrong = await delaunay3InWorker([1, 2, NaN]).catch((it) => it);
  check("worker: bad input", wrong.status === "NOT_FINITE" && wrong.where === 0);
  const stopped = await delaunay3InWorker(points, {onProgress: () => false}).catch((it) => it);
  check("worker: stopped", stopped.status === "STOPPED");
  const thrown = await delaunay3InWorker(points, {onProgress: () => { throw new Error("mine"); }}).catch((it) => it);
  check("worker: its caller's error", thrown.message === "mine");
  const controller = new AbortController();
  const ended = delaunay3InWorker(points, {signal: controller.signal, onProgress: () => controller.abort(new Error("enough"))});
  check("worker: abort", (await ended.catch((it) => it)).message === "enough");
}
