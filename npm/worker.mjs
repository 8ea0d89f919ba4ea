// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// What delaunay3InWorker() runs in a thread of its own: one triangulation, and questions about it.

import {delaunay3Sync, init} from "./index.mjs";

let triangulation;

async function build(post, module, points, options) {
  await init(module);
  let last = -Infinity;
  const onProgress = (share) => {
    const now = performance.now();
    if (now - last > 50) {
      last = now;
      post({share});
    }
  };
  triangulation = delaunay3Sync(points, {...options, onProgress});
  post({share: 1});
  const {dimension, numberOfPoints, numberOfSimplices, simplices, neighbors, vertexOfPoint, offsets} = triangulation;
  return {dimension, numberOfPoints, numberOfSimplices, simplices, neighbors, vertexOfPoint, offsets};
}

async function answer(post, {number, what, values}) {
  try {
    const result = what === "build" ? await build(post, ...values) : triangulation[what](...values);
    const arrays = ArrayBuffer.isView(result) ? [result] : Object.values(result).filter(ArrayBuffer.isView);
    post({number, result}, arrays.map((array) => array.buffer));
  } catch (error) {
    post({number, error: {status: error.status, message: error.message, where: error.where}});
  }
}

if (typeof WorkerGlobalScope === "function") {
  addEventListener("message", ({data}) => answer((...message) => postMessage(...message), data));
} else {
  const {parentPort} = await import(/* webpackIgnore: true */ /* @vite-ignore */ "node:worker_threads");
  parentPort.on("message", (data) => answer((...message) => parentPort.postMessage(...message), data));
}
