// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// 3D Delaunay triangulations in typed arrays. The C library delaunay_3, compiled to WebAssembly, does the work. Each
// triangulation has an instance with a memory of its own: so it needs not be freed, and one that failed leaves nothing.

const isNode = typeof process === "object" && Boolean(process.versions?.node);

// The statuses of delaunay_3.h.
const statuses = ["OK", "NOT_FINITE", "BAD_INDEX", "BAD_ARGUMENT", "TOO_MANY", "NO_MEMORY", "FAILED", "NOT_EXACT", "BAD_BOX",
  "STOPPED", "NO_INSIDE"];
const [NOT_FINITE, BAD_INDEX, BAD_ARGUMENT, TOO_MANY, NO_MEMORY, FAILED] = [1, 2, 3, 4, 5, 6];

// What these functions throw: the message of the C library, its status, and if one is to blame, the number of the point,
// weight, face or query in `where`.
export class Delaunay3Error extends Error {
  constructor(status, message, where) {
    super(message);
    this.name = "Delaunay3Error";
    this.status = status;
    this.where = where;
  }
}

function refuse(message) {
  throw new Delaunay3Error("BAD_ARGUMENT", message);
}

let module; // WebAssembly.Module, once it is compiled
let compiling;

// Compiles the library, once; `source` is its place, content or module, for those who keep delaunay_3.wasm elsewhere.
export function init(source = new URL("./delaunay_3.wasm", import.meta.url)) {
  compiling ??= compiled(source).then((it) => { module = it; }, (error) => {
    compiling = undefined;
    throw error;
  });
  return compiling;
}

async function compiled(source) {
  if (source instanceof WebAssembly.Module)
    return source;
  if (source instanceof URL || typeof source === "string") {
    if (isNode && new URL(source, import.meta.url).protocol === "file:") {
      const {readFile} = await import(/* webpackIgnore: true */ /* @vite-ignore */ "node:fs/promises");
      source = await readFile(new URL(source, import.meta.url));
    } else {
      source = await fetch(source);
    }
  }
  if (typeof Response === "function" && source instanceof Response) {
    if (!source.ok)
      throw new Error(`${source.url}: ${source.status} ${source.statusText}`);
    source = await source.arrayBuffer();
  }
  return WebAssembly.compile(source);
}

// Is thrown by the library's end_call, to leave it.
class Ending {
  constructor(status, where) {
    this.status = status;
    this.where = status === NOT_FINITE || status === BAD_INDEX ? where : undefined;
  }
}

// The library in a memory of its own.
class Library {
  constructor(goFurther) {
    if (module === undefined)
      refuse("await init() first");
    this.isBroken = false;
    this.functions = new WebAssembly.Instance(module, {delaunay_3: {
      end_call: (status, where) => { throw new Ending(status, where); },
      go_further: (_, share) => goFurther(share) !== false,
    }}).exports;
    this.functions._initialize();
  }

  error(status, where) {
    const bytes = new Uint8Array(this.functions.memory.buffer, this.functions.delaunay_3_message(status) >>> 0);
    const message = String.fromCharCode(...bytes.subarray(0, bytes.indexOf(0)));
    return new Delaunay3Error(statuses[status], where === undefined ? message : `${message}: number ${where}`, where);
  }

  // Returns what a function returns. What ends it becomes an error.
  call(name, ...values) {
    const stack = this.functions.__stack_pointer, top = stack.value;
    if (this.isBroken)
      throw this.error(FAILED);
    try {
      return this.functions[name](...values);
    } catch (ending) {
      stack.value = top;
      if (ending instanceof Ending)
        throw this.error(ending.status, ending.where);
      this.isBroken = true;
      throw ending instanceof WebAssembly.RuntimeError ? this.error(FAILED) : ending;
    }
  }

  check(status) {
    if (status !== 0)
      throw this.error(status);
  }

  // Room for so many numbers of a type.
  room(Type, length) {
    const bytes = length * Type.BYTES_PER_ELEMENT;
    const address = bytes < 0xffff0000 ? this.functions.malloc(bytes || 1) >>> 0 : 0;
    if (address === 0)
      throw this.error(NO_MEMORY);
    return address;
  }

  view(Type, address, length) {
    return new Type(this.functions.memory.buffer, address >>> 0, length);
  }

  put(Type, numbers) {
    const address = this.room(Type, numbers.length);
    this.view(Type, address, numbers.length).set(numbers);
    return address;
  }

  free(...addresses) {
    if (!this.isBroken)
      addresses.forEach((address) => this.functions.free(address));
  }
}

// Whether it is a typed array, of any realm, of numbers that are doubles.
const isTyped = (it) => ArrayBuffer.isView(it) && /^(?!Big).*Array$/.test(it[Symbol.toStringTag]);

// The numbers of rows, one after the other: of a typed array, an array of numbers, or an array of rows.
function flat(rows, width, name) {
  if (isTyped(rows)) {
    if (rows.length % width !== 0)
      refuse(`${name}: ${rows.length} numbers are not ${width} for each`);
    return rows;
  }
  if (!Array.isArray(rows))
    refuse(`${name}: expected a typed array or an array`);
  if (width === 1 || typeof rows[0] === "number" || rows.length === 0)
    return flat(Float64Array.from(rows, (x) => number(x, name)), width, name);
  const numbers = new Float64Array(width * rows.length);
  for (let i = 0; i < rows.length; ++i) { // forEach() would leave out holes
    if (rows[i]?.length !== width)
      refuse(`${name}: number ${i} has not ${width} numbers`);
    for (let k = 0; k < width; ++k)
      numbers[width * i + k] = number(rows[i][k], name);
  }
  return numbers;
}

function number(x, name) {
  return typeof x === "number" ? x : refuse(`${name}: ${typeof x} is not a number`);
}

// The periods along the three axes; null and undefined stand for none.
function periods(box) {
  if (!(Array.isArray(box) || isTyped(box)) || box.length !== 3)
    refuse("box: expected three periods");
  return Float64Array.from(box, (period) => number(period ?? Infinity, "box"));
}

// The first `width` numbers of each of n rows, which are `stride` numbers apart.
function shortened(rows, n, stride, width) {
  const result = new Int32Array(n * width);
  for (let i = 0; i < n; ++i)
    for (let k = 0; k < width; ++k)
      result[i * width + k] = rows[i * stride + k];
  return result;
}

// The facets of simplices that have no neighbour, seen from outside counterclockwise.
export function hullOf(simplices, neighbors, dimension) {
  const width = dimension + 1, hull = [];
  const others = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]];
  for (let i = 0; i < neighbors.length; ++i) {
    if (neighbors[i] >= 0)
      continue;
    const k = i % width, first = i - k;
    if (dimension === 3)
      hull.push(...others[k].map((j) => simplices[first + j]));
    else
      for (let j = 0; j < width; ++j)
        if (j !== k)
          hull.push(simplices[first + j]);
  }
  return Int32Array.from(hull);
}

// A triangulation. Its arrays are copied from WebAssembly's memory when they are first asked for.
class Delaunay3 {
  #library;
  #handle;
  #copies = {};
  #cells;

  constructor(points, {weights, box, onProgress} = {}) {
    const library = new Library(onProgress ?? (() => true)), functions = library.functions;
    const coordinates = flat(points, 3, "points"), n = coordinates.length / 3;
    if (n >= 0x7fffffff)
      throw library.error(TOO_MANY);
    const given = weights == null ? undefined : flat(weights, 1, "weights");
    if (given !== undefined && given.length !== n)
      refuse(`weights: there are ${given.length}, and ${n} points`);
    const addresses = [library.put(Float64Array, coordinates), given ? library.put(Float64Array, given) : 0, n,
      box == null ? 0 : library.put(Float64Array, periods(box)), library.room(Uint32Array, 12)];
    library.check(library.call("build", ...addresses));
    this.#library = library;
    this.#handle = library.view(Uint32Array, addresses[4], 1)[0];
    functions.delaunay_3_get(this.#handle, addresses[4]);
    const [dimension, number, , stride, vertices, neighbors, , vertexOfPoint] =
      library.view(Int32Array, addresses[4], 8);
    this.#cells = {number, stride, vertices, neighbors, vertexOfPoint, offsets: functions.delaunay_3_offsets(this.#handle)};
    this.dimension = dimension;
    this.numberOfPoints = n;
    this.numberOfSimplices = number;
  }

  #copy(name, make) {
    return this.#copies[name] ??= make(this.#cells);
  }

  #rows(address) {
    const {number, stride} = this.#cells, width = this.dimension + 1;
    if (number === 0)
      return new Int32Array(0);
    return shortened(this.#library.view(Int32Array, address, (number - 1) * stride + width), number, stride, width);
  }

  get simplices() {
    return this.#copy("simplices", ({vertices}) => this.#rows(vertices));
  }

  get neighbors() {
    return this.#copy("neighbors", ({neighbors, number}) => {
      const rows = this.#rows(neighbors);
      for (let i = 0; i < rows.length; ++i) // infinite cells come last
        if (rows[i] >= number)
          rows[i] = -1;
      return rows;
    });
  }

  get vertexOfPoint() {
    return this.#copy("vertexOfPoint", ({vertexOfPoint}) =>
      this.#library.view(Int32Array, vertexOfPoint, this.numberOfPoints).slice());
  }

  get offsets() {
    return this.#copy("offsets", ({offsets, number}) =>
      offsets === 0 ? null : this.#library.view(Int16Array, offsets, 12 * number).slice());
  }

  get hull() {
    return this.#copy("hull", ({offsets}) =>
      offsets === 0 ? hullOf(this.simplices, this.neighbors, this.dimension) : new Int32Array(0));
  }

  find(queries) {
    const numbers = flat(queries, 3, "queries"), n = numbers.length / 3, library = this.#library;
    const found = library.room(Int32Array, n);
    let points = 0; // free() takes it
    try {
      points = library.put(Float64Array, numbers);
      library.check(library.call("delaunay_3_find", this.#handle, points, n, 1, found, 0));
      return library.view(Int32Array, found, n).slice();
    } finally {
      library.free(points, found);
    }
  }

  windingNumbers(faces) {
    const numbers = flat(faces, 3, "faces"), triangles = Int32Array.from(numbers), library = this.#library;
    const wrong = triangles.findIndex((index, i) => index !== numbers[i]);
    if (wrong >= 0)
      throw library.error(BAD_INDEX, Math.floor(wrong / 3));
    if (numbers.length === 0 || this.dimension < 3)
      refuse(numbers.length === 0 ? "faces: there are none" : "faces: there are no tetrahedra");
    const n = this.numberOfSimplices;
    const result = library.room(Float64Array, n);
    let given = 0;
    try {
      given = library.put(Int32Array, triangles);
      library.check(library.call("delaunay_3_winding_numbers", this.#handle, given, triangles.length / 3, 1, result, 0));
      return library.view(Float64Array, result, n).slice();
    } finally {
      library.free(given, result);
    }
  }

  inside(faces) {
    return Uint8Array.from(this.windingNumbers(faces), (number) => Number(Math.abs(number) >= 0.5));
  }

  isValid(level = 3) {
    if (![0, 1, 2, 3].includes(level))
      refuse("level: expected 0, 1, 2 or 3");
    const result = this.#library.call("delaunay_3_is_valid", this.#handle, level);
    this.#library.check(Math.max(0, -result));
    return result === 1;
  }
}

// The triangulation, of points with weights if there are any, in a periodic box if there is one.
export async function delaunay3(points, options) {
  await init();
  return delaunay3Sync(points, options);
}

// The same at once, once init() has ended.
export function delaunay3Sync(points, options) {
  return new Delaunay3(points, options);
}

// The same in a thread of its own, so that a page remains alive; the functions of the result are asynchronous.
export async function delaunay3InWorker(points, {weights, box, onProgress, signal} = {}) {
  signal?.throwIfAborted();
  await init();
  const thread = new Thread(await startWorker(), onProgress);
  const stop = () => thread.close(signal.reason);
  signal?.addEventListener("abort", stop);
  try {
    if (signal?.aborted)
      stop();
    return new Delaunay3InWorker(thread, await thread.ask("build", module, points, {weights, box}));
  } catch (error) {
    thread.close(error);
    throw error;
  } finally {
    signal?.removeEventListener("abort", stop);
  }
}

async function startWorker() {
  if (!isNode)
    return new Worker(new URL("./worker.mjs", import.meta.url), {type: "module"});
  const {Worker: NodeWorker} = await import(/* webpackIgnore: true */ /* @vite-ignore */ "node:worker_threads");
  const worker = new NodeWorker(new URL("./worker.mjs", import.meta.url));
  worker.on("message", (data) => worker.onmessage({data}));
  worker.on("error", (error) => worker.onerror(error));
  worker.on("messageerror", (error) => worker.onmessageerror(error));
  worker.on("exit", (code) => worker.onerror({message: `with the code ${code}`}));
  return worker;
}

// Asks a worker, and keeps what it has not answered. Only this keeps a program of node alive.
class Thread {
  #asked = new Map();
  #number = 0;
  #closed;

  constructor(worker, onProgress) {
    this.worker = worker;
    worker.onmessage = ({data: {number, share, result, error}}) => {
      if (this.#closed !== undefined) // what was on its way comes too late
        return;
      if (share !== undefined)
        return this.#tell(onProgress, share);
      const {resolve, reject} = this.#asked.get(number);
      this.#asked.delete(number);
      if (this.#asked.size === 0)
        worker.unref?.();
      if (error === undefined)
        resolve(result);
      else
        reject(new Delaunay3Error(error.status ?? "FAILED", error.message, error.where));
    };
    worker.onerror = (event) => this.close(new Delaunay3Error("FAILED", `the worker has ended: ${event.message ?? "its script was not found"}`));
    worker.onmessageerror = () => this.close(new Delaunay3Error("FAILED", "what the worker sends cannot be read; there may be too little memory"));
  }

  #tell(onProgress, share) {
    try {
      if (onProgress?.(share) === false)
        this.close(new Delaunay3Error("STOPPED", "onProgress() has returned false"));
    } catch (error) {
      this.close(error);
    }
  }

  ask(what, ...values) {
    return new Promise((resolve, reject) => {
      if (this.#closed !== undefined)
        return reject(this.#closed);
      this.worker.postMessage({number: ++this.#number, what, values}); // may throw; an answer comes later
      this.#asked.set(this.#number, {resolve, reject});
      this.worker.ref?.();
    });
  }

  close(reason = new Delaunay3Error("STOPPED", "the triangulation is closed")) {
    this.#closed ??= reason;
    this.worker.terminate();
    this.#asked.forEach(({reject}) => reject(this.#closed));
    this.#asked.clear();
  }
}

class Delaunay3InWorker {
  #thread;
  #hull;

  constructor(thread, arrays) {
    this.#thread = thread;
    Object.assign(this, arrays);
  }

  get hull() {
    return this.#hull ??= this.offsets === null ? hullOf(this.simplices, this.neighbors, this.dimension) : new Int32Array(0);
  }

  find(queries) { return this.#thread.ask("find", queries); }
  windingNumbers(faces) { return this.#thread.ask("windingNumbers", faces); }
  inside(faces) { return this.#thread.ask("inside", faces); }
  isValid(level) { return this.#thread.ask("isValid", level); }
  close() { this.#thread.close(); }
}
