// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

export type TypedNumbers = Float64Array | Float32Array | Int32Array | Uint32Array | Int16Array | Uint16Array | Int8Array |
  Uint8Array | Uint8ClampedArray;

/** Rows of three numbers: one after the other, or an array for each. */
export type Triples = TypedNumbers | readonly number[] | readonly (readonly number[] | TypedNumbers)[];

export interface Options {
  /** One number for each point, a squared radius, which may be negative: the regular triangulation. */
  weights?: TypedNumbers | readonly number[] | null;
  /** The periods along the three axes of a periodic box; null or Infinity along one that has none. */
  box?: readonly (number | null)[] | TypedNumbers | null;
  /** Is told which share of the points is inserted, from 0 to 1. */
  onProgress?: (share: number) => void | boolean;
}

export type Status = "NOT_FINITE" | "BAD_INDEX" | "BAD_ARGUMENT" | "TOO_MANY" | "NO_MEMORY" | "FAILED" | "NOT_EXACT" | "BAD_BOX" |
  "STOPPED" | "NO_INSIDE";

/** What all functions throw, with the message of the C library. */
export class Delaunay3Error extends Error {
  readonly status: Status;
  /** The number of the point, weight, face or query that is to blame. */
  readonly where?: number;
}

interface Arrays {
  /** 3, or less if the points lie in a plane, on a line or in one place; -1 if there are none. */
  readonly dimension: -1 | 0 | 1 | 2 | 3;
  readonly numberOfPoints: number;
  readonly numberOfSimplices: number;
  /** dimension + 1 indices of points for each simplex; tetrahedra are positively oriented. */
  readonly simplices: Int32Array;
  /** The simplex opposite to each of these corners, or -1 outside the hull. */
  readonly neighbors: Int32Array;
  /** The first point in the same place, for each point; -1 if it is hidden by weights. */
  readonly vertexOfPoint: Int32Array;
  /** In a box, 12 numbers for each simplex: corner k is moved by offsets[12 c + 3 k + a] periods along axis a. Else null. */
  readonly offsets: Int16Array | null;
  /** The facets of the convex hull, counterclockwise from outside: 3 indices for each, none in a box. */
  readonly hull: Int32Array;
}

export interface Delaunay3 extends Arrays {
  /** The tetrahedron with the least number that contains each query, boundary included; -1 if there is none. Exact. */
  find(queries: Triples): Int32Array;
  /** The winding number of a surface at the middle of each tetrahedron. The surface may have gaps, and parts that overlap. */
  windingNumbers(faces: Triples): Float64Array;
  /** 1 for each tetrahedron inside a surface: where its winding number is 1/2 or more, or -1/2 or less. */
  inside(faces: Triples): Uint8Array;
  /** Checks the triangulation anew: level 0 that neighbours agree, up to level 3 that it is Delaunay. Not in a box. */
  isValid(level?: 0 | 1 | 2 | 3): boolean;
}

export interface Delaunay3InWorker extends Arrays {
  find(queries: Triples): Promise<Int32Array>;
  windingNumbers(faces: Triples): Promise<Float64Array>;
  inside(faces: Triples): Promise<Uint8Array>;
  isValid(level?: 0 | 1 | 2 | 3): Promise<boolean>;
  /** Ends the worker. The arrays remain. */
  close(): void;
}

/** Triangulates points. */
export function delaunay3(points: Triples, options?: Options): Promise<Delaunay3>;

/** Does the same at once, once init() has ended. If onProgress returns false, it throws. */
export function delaunay3Sync(points: Triples, options?: Options): Delaunay3;

/** Does the same in a worker; while it builds, the signal ends it. */
export function delaunay3InWorker(points: Triples, options?: Options & {signal?: AbortSignal}): Promise<Delaunay3InWorker>;

/** Compiles the library, once. Give a place, a response, bytes or a module if delaunay_3.wasm is not beside index.mjs. */
export function init(source?: string | URL | Response | BufferSource | WebAssembly.Module): Promise<void>;
