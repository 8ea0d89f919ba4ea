// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Reads what is dropped onto the live page: meshes and clouds in .off, .ply, .obj, .stl, .xyz, .pts, .txt and .csv.

// Returns {points, triangles, radii}: flat typed arrays. There are no triangles if the file has points only, and polygons
// become fans. Radii are null unless the file has one for each point: the fourth and last column of .xyz, .txt or .csv, if no
// number in it is negative, a column of that name, or PLY's property "radius".
export function readSurface(name, bytes) {
  const ending = name.toLowerCase().match(/\.[a-z]+$/)?.[0];
  const reader = readers[ending];
  if (!reader)
    throw new Error(`${name}: expected a file whose name ends in ${Object.keys(readers).join(", ")}`);
  const file = new Reading(name);
  try {
    const hasMark = bytes[0] === 0xef && bytes[1] === 0xbb && bytes[2] === 0xbf; // of UTF-8
    reader(file, hasMark ? bytes.subarray(3) : bytes);
  } catch (error) {
    throw error instanceof RangeError ? new Error(`${name}: it is too large for a browser, or ends too early`) : error;
  }
  return file.surface();
}

// What was read so far, and how to say where it is wrong.
class Reading {
  points = [];
  corners = []; // of triangles
  radii = [];
  line = 0; // 0 in binary files

  constructor(name) { this.name = name; }

  refuse(what) {
    throw new Error(`${this.name}${this.line > 0 ? `, line ${this.line}` : ""}: ${what}`);
  }

  number(word) {
    const x = word === undefined || word === "" ? NaN : Number(word);
    return Number.isFinite(x) ? x : this.refuse(word === undefined ? "a number is missing" : `'${inShort(word)}' is not a finite number`);
  }

  index(word) {
    const i = this.number(word);
    return Number.isInteger(i) ? i : this.refuse(`'${word}' is not an index`);
  }

  count(word, what) {
    const n = this.index(word);
    return n >= 0 && n < 2 ** 31 ? n : this.refuse(`'${word}' is not a number of ${what}`);
  }

  radius(word) {
    const radius = this.number(word);
    return radius >= 0 ? radius : this.refuse(`the radius ${word} is negative`);
  }

  addPoint(words, from = 0) {
    for (let k = from; k < from + 3; ++k)
      this.points.push(this.number(words[k]));
  }

  // A polygon; its indices are checked when all points are known.
  addPolygon(indices) {
    for (let k = 2; k < indices.length; ++k)
      this.corners.push(indices[0], indices[k - 1], indices[k]);
  }

  surface() {
    const n = this.points.length / 3, wrong = this.corners.find((i) => i < 0 || i >= n);
    this.line = 0;
    if (wrong !== undefined)
      this.refuse(`a face has the corner ${wrong}, and there are ${n} points`);
    return {points: Float64Array.from(this.points), triangles: Int32Array.from(this.corners),
      radii: this.radii.length === n && n > 0 ? Float64Array.from(this.radii) : null};
  }
}

const inShort = (word) => (String(word).length > 20 ? `${String(word).slice(0, 20)}…` : word);

const textOf = (bytes) => new TextDecoder("latin1").decode(bytes); // one letter for each byte

// The words of each line that has some. The file is told the line's number.
function* rows(file, text, comment = "#", separator = /\s+/) {
  for (let from = 0; from < text.length;) {
    let to = from;
    while (to < text.length && text[to] !== "\n" && text[to] !== "\r")
      ++to;
    ++file.line;
    const row = text.slice(from, to).split(comment, 1)[0].trim().replace(/\s*[,;]+$/, "");
    from = text[to] === "\r" && text[to + 1] === "\n" ? to + 2 : to + 1;
    if (row !== "")
      yield row.split(separator);
  }
}

// The next row of an iterator.
function nextRow(file, iterator, what) {
  const {value, done} = iterator.next();
  return done ? file.refuse(`the file ends before ${what}`) : value;
}

// What is not announced may be what was meant.
function refuseMore(file, iterator, announced) {
  if (!iterator.next().done)
    file.refuse(`the file goes on, and its header announces ${announced}`);
}

// --- Points alone ---

const isName = (word) => /^(?:\/\/)?["a-z_]/i.test(word) && !/^(?:nan|inf)/i.test(word);

// Where the coordinates and the radius stand, by the names of columns.
function columnsOf(names) {
  const plain = names.map((name) => name.replace(/["/]/g, "").toLowerCase());
  const columns = ["x", "y", "z"].map((name) => plain.indexOf(name)), isRadius = (name) => name === "radius" || (name === "r" && !plain.includes("g"));
  const radius = plain.findIndex(isRadius); // "r" may be red
  return !columns.includes(-1) ? {columns, radius} : names.length === 3 ? {columns: [0, 1, 2], radius: -1} : undefined;
}

// A line of a molecule, which is no title.
const isAtom = (words) => words.length === 4 && /^[A-Z][a-z]?$/.test(words[0]) && words.slice(1).every((word) => Number.isFinite(Number(word)));

function readColumns(file, text, mayHaveRadii, separator) {
  let width = 0, at, announced, isFirst = true, isTitle = false;
  for (let words of rows(file, text, "#", separator)) {
    const isCount = isFirst && words.length === 1; // as in .pts files, and in chemists' .xyz files, where a title follows
    const isHeader = (isFirst && words.every(isName)) || (isTitle && !isAtom(words) && words.some((word) => word === "" || Number.isNaN(Number(word))));
    isFirst = false;
    if (isHeader && !isTitle)
      at = columnsOf(words) ?? file.refuse("no columns are named x, y and z");
    if (isCount)
      announced = file.count(words[0], "points");
    isTitle = isCount;
    if (isCount || isHeader)
      continue;
    if (isAtom(words)) // without its element
      words = words.slice(1);
    if (words.length < 3)
      file.refuse("expected three numbers");
    width ||= words.length;
    if (words.length !== width)
      file.refuse(`expected ${width} numbers, as in the lines before`);
    at ??= {columns: [0, 1, 2], radius: mayHaveRadii && width === 4 ? 3 : -1, isGuess: true};
    file.addPoint(at.columns.map((k) => words[k]));
    if (at.isGuess && Number(words[at.radius]) < 0) { // it is something else
      at.radius = -1;
      file.radii = [];
    }
    if (at.radius >= 0)
      file.radii.push(file.radius(words[at.radius]));
  }
  const n = file.points.length / 3;
  if (announced !== undefined && announced !== n)
    file.refuse(`the first line announces ${announced} points, and there are ${n}`);
}

// With semicolons, commas may be decimal ones, which are refused.
function readCsv(file, text) {
  readColumns(file, text, true, text.includes(";") ? /\s*;\s*/ : /\s*,\s*|\s+/);
}

// --- OFF ---

function readOff(file, text) {
  const iterator = rows(file, text);
  let words = nextRow(file, iterator, "the word OFF");
  const joined = /^([A-Z]+)(\d+)$/i.exec(words[0]); // as ModelNet writes it
  if (joined)
    words.splice(0, 1, joined[1], joined[2]);
  const kind = /^\d/.test(words[0]) ? "OFF" : words.shift(); // which may be missing
  if (!/^(ST)?C?N?OFF$/i.test(kind))
    file.refuse(`expected OFF, not '${inShort(kind)}'`);
  if (words[0]?.toUpperCase() === "BINARY")
    file.refuse("binary OFF is not read: write it as text, or as PLY");
  if (words.length === 0)
    words = nextRow(file, iterator, "the number of points");
  const n = file.count(words[0], "points"), m = file.count(words[1] ?? "0", "faces");
  for (let i = 0; i < n; ++i)
    file.addPoint(nextRow(file, iterator, `point ${i} of ${n}`));
  for (let i = 0; i < m; ++i) {
    const face = nextRow(file, iterator, `face ${i} of ${m}`), size = file.count(face[0], "corners");
    if (face.length <= size)
      file.refuse(`expected ${size} corners`);
    file.addPolygon(face.slice(1, size + 1).map((word) => file.index(word)));
  }
  refuseMore(file, iterator, `${n} points and ${m} faces`);
}

// --- OBJ ---

function readObj(file, text) {
  for (const [what, ...words] of rows(file, text.replace(/^([^#\r\n]*)\\\r?\n/gm, "$1 ")))
    if (what === "v")
      file.addPoint(words);
    else if (what === "f")
      file.addPolygon(words.map((word) => {
        const i = file.index(word.split("/", 1)[0]);
        const from = i > 0 ? i - 1 : file.points.length / 3 + i;
        return i !== 0 && from >= 0 ? from : file.refuse(i === 0 ? "corners count from 1" : `there is no point ${i}`);
      }));
}

// --- STL: its corners become points, equal ones one ---

function readStl(file, bytes) {
  const data = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength), known = new Map();
  const corner = (words) => {
    const key = words.map((x) => x + 0).join(), i = known.get(key) ?? known.size; // -0 is 0
    if (i === known.size) {
      known.set(key, i);
      file.addPoint(words);
    }
    return i;
  };
  const n = bytes.length >= 84 ? data.getUint32(80, true) : -1;
  const isText = /^\s*solid/i.test(textOf(bytes.subarray(0, 80))) && /facet|endsolid/i.test(textOf(bytes.subarray(0, 2000)));
  if (bytes.length === 84 + 50 * n || !isText) {
    if (n < 0 || bytes.length < 84 + 50 * n)
      file.refuse(n < 0 ? "it is no STL file" : `the file ends before triangle ${Math.floor((bytes.length - 84) / 50)} of ${n}`);
    for (let i = 0; i < n; ++i)
      file.addPolygon([12, 24, 36].map((at) =>
        corner([0, 4, 8].map((k) => file.number(data.getFloat32(84 + 50 * i + at + k, true))))));
    return;
  }
  let corners = [], isOpen = true;
  for (const [what, ...words] of rows(file, textOf(bytes))) {
    if (/^(end)?solid$/i.test(what))
      isOpen = what.length === 5;
    if (what.toLowerCase() === "vertex")
      corners.push(corner([0, 1, 2].map((k) => file.number(words[k]))));
    else if (what.toLowerCase() === "endfacet") {
      file.addPolygon(corners);
      corners = [];
    }
  }
  if (corners.length > 0 || isOpen)
    file.refuse(`the file ends within a ${corners.length > 0 ? "facet" : "solid: endsolid is missing"}`);
}

// --- PLY ---

const plyTypes = {char: ["Int8", 1], uchar: ["Uint8", 1], short: ["Int16", 2], ushort: ["Uint16", 2], int: ["Int32", 4],
  uint: ["Uint32", 4], float: ["Float32", 4], double: ["Float64", 8]};
Object.assign(plyTypes, {int8: plyTypes.char, uint8: plyTypes.uchar, int16: plyTypes.short, uint16: plyTypes.ushort,
  int32: plyTypes.int, uint32: plyTypes.uint, float32: plyTypes.float, float64: plyTypes.double});

// The format, the elements with their properties, and where the header ends.
function plyHeader(file, bytes) {
  const text = textOf(bytes.subarray(0, 1 << 20)), end = /^end_header[ \t]*(\r\n|\n|\r)/m.exec(text);
  if (!/^ply\s/.test(text) || !end)
    file.refuse(end ? "expected ply" : "there is no end_header");
  const elements = [];
  let format;
  for (const [what, ...words] of rows(file, text.slice(0, end.index), "\n")) {
    if (what === "format")
      format = words[0];
    else if (what === "element")
      elements.push({name: words[0], count: file.count(words[1], "elements"), properties: []});
    else if (what === "property") {
      const isList = words[0] === "list", types = isList ? words.slice(1, 3) : words.slice(0, 1);
      if (elements.length === 0 || words.length !== types.length + (isList ? 2 : 1) || types.some((type) => !Object.hasOwn(plyTypes, type)))
        file.refuse(`the property '${words.join(" ")}' is not known`);
      elements[elements.length - 1].properties.push({name: words[words.length - 1], isList, types});
    }
  }
  ++file.line;
  return {format, elements, size: end.index + end[0].length};
}

// What returns the next number, of the type that is given: of text, with what is left of it, or of bytes.
function plyNumbers(file, format, bytes) {
  if (format === "ascii") {
    const words = (function* () {
      for (const row of rows(file, textOf(bytes)))
        yield* row;
    })();
    return Object.assign(() => file.number(nextRow(file, words, "all of its elements")), {words});
  }
  if (!/^binary_(little|big)_endian$/.test(format))
    file.refuse(`the format '${format}' is not known`);
  file.line = 0;
  const data = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength), isLittle = format === "binary_little_endian";
  let at = 0;
  return (type) => {
    const [name, size] = plyTypes[type];
    if (at + size > bytes.length)
      file.refuse("the file ends before all of its elements");
    at += size;
    return data[`get${name}`](at - size, isLittle);
  };
}

function readPly(file, bytes) {
  const {format, elements, size} = plyHeader(file, bytes);
  const next = plyNumbers(file, format, bytes.subarray(size));
  for (const {name, count, properties} of elements)
    for (let i = 0; i < count && properties.length > 0; ++i) {
      const values = {};
      for (const {name: key, isList, types} of properties)
        if (isList)
          values[key] = Array.from({length: file.count(next(types[0]), "corners")}, () => next(types[1]));
        else
          values[key] = next(types[0]);
      if (name === "vertex") {
        file.addPoint([values.x, values.y, values.z]);
        if ("radius" in values)
          file.radii.push(file.radius(values.radius));
      } else if (name === "tristrips") {
        file.refuse("strips of triangles are not read: write triangles");
      } else if (name === "face") {
        file.addPolygon((values.vertex_indices ?? values.vertex_index ?? file.refuse("the faces do not have the property vertex_indices"))
          .map((i) => file.index(i)));
      }
    }
  if (next.words)
    refuseMore(file, next.words, "fewer numbers");
}

const asText = (reader, ...more) => (file, bytes) => reader(file, textOf(bytes), ...more);

const readers = {__proto__: null, ".off": asText(readOff), ".ply": readPly, ".obj": asText(readObj), ".stl": readStl,
  ".xyz": asText(readColumns, true), ".pts": asText(readColumns, false), ".txt": asText(readColumns, true), ".csv": asText(readCsv)};
