// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// What index.mjs needs of WebAssembly besides delaunay_3.h. scripts/wasm compiles it with the one file.

#include "delaunay_3.h"

extern "C" {

__attribute__((import_module("delaunay_3"), import_name("go_further"))) int
delaunay_3_go_further(void*, double share);

// Is delaunay_3_build_watched() with one thread; JavaScript's function is told the share.
__attribute__((export_name("build"))) delaunay_3_status build_for_host(const double* points,
                                                                       const double* weights,
                                                                       size_t n, const double* box,
                                                                       delaunay_3** result)
{
  return delaunay_3_build_watched(points, weights, n, box, 1, delaunay_3_go_further, nullptr,
                                  result, nullptr);
}

// Replaces libc++abi's, which would link printf, and with it imports of a system.
[[noreturn]] void abort_message(const char*, ...)
{
  __builtin_trap();
}
}
