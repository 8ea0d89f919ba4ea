/* Copyright (c) 2026 The authors of Delaunay_from_surface_3
 *
 * SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * 3D Delaunay triangulations, for C and for all languages that can call C. Exact, with as many threads
 * as wanted; the result is that of CGAL's Delaunay_triangulation_3, and no CGAL is needed. Six functions.
 *
 *   delaunay_3* d;
 *   delaunay_3_cells cells;
 *   if (delaunay_3_build(points, n, NULL, 0, 1, &d, NULL) == DELAUNAY_3_OK) {
 *     delaunay_3_get(d, &cells);
 *     for (c = 0; c < cells.number; ++c)
 *       use(cells.vertices + c * cells.stride);
 *     delaunay_3_free(d);
 *   }
 */

#ifndef DELAUNAY_3_H
#define DELAUNAY_3_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct delaunay_3 delaunay_3;

typedef enum delaunay_3_status {
  DELAUNAY_3_OK = 0,
  DELAUNAY_3_NOT_FINITE,   /* a coordinate */
  DELAUNAY_3_BAD_INDEX,    /* in a triangle */
  DELAUNAY_3_BAD_ARGUMENT, /* no thread, a level that there is not, null for an array that has entries */
  DELAUNAY_3_TOO_MANY,     /* more than 2^30 cells, or 2^31 - 2 points or triangles */
  DELAUNAY_3_NO_MEMORY,
  DELAUNAY_3_FAILED, /* a fault of the library */
  DELAUNAY_3_NOT_EXACT /* the library is compiled with -ffast-math, -Ofast or parts of them, or denormal
                          numbers become zero in a mode that cannot be left; asked at each call */
} delaunay_3_status;

/* Corner k of cell c is point vertices[c * stride + k], neighbour k, opposite to it, neighbors[c * stride
 * + k]. Cells come as simplices first, positively oriented, then as infinite ones, whose last corner is
 * -1. Each has dimension + 1 corners: 4 if the points lie in no plane. Of points that coincide the first
 * is the corner; vertex_of_point names it. */
typedef struct delaunay_3_cells
{
  int dimension; /* -1 if there are no points */
  size_t number, number_with_infinite, stride;
  const int32_t *vertices, *neighbors;
  size_t number_of_points;
  const int32_t* vertex_of_point;
} delaunay_3_cells;

/* During a call, numbers are rounded to nearest, and denormal ones kept; then the caller's mode is back. */

/* Of n points, three coordinates each. Triangles of a surface on the points, three indices each, are
 * checked and never change the result; there may be none. The points are read again by the last two
 * functions, so they stay where they are. Where something is refused, *where is the point or the
 * triangle, if anybody wants to know, and *result is null. `where` may be null, `result` may not; points
 * and triangles only if there are none. */
delaunay_3_status delaunay_3_build(const double* points, size_t n, const int32_t* triangles,
                                   size_t number_of_triangles, int threads, delaunay_3** result,
                                   size_t* where);

/* What a status means, in English. */
const char* delaunay_3_message(delaunay_3_status status);

/* Where the cells are, as long as the triangulation is. Of null there are none. */
void delaunay_3_get(const delaunay_3* d, delaunay_3_cells* cells);

void delaunay_3_free(delaunay_3* d); /* which may be null */

/* For each of n points the tetrahedron that contains it, its boundary included, with the smallest number;
 * -1 outside. Arrays may be null if n is 0. */
delaunay_3_status delaunay_3_find(const delaunay_3* d, const double* points, size_t n, int threads,
                                  int32_t* found, size_t* where);

/* Whether it is the Delaunay triangulation: 1 or 0; or the status, with a minus sign, that kept it from
 * being checked (without memory it may still be valid). Level 0: links between cells; 1: spheres of cells
 * around vertices; 2: orientations; 3: all, by Delaunay's lemma. */
int delaunay_3_is_valid(const delaunay_3* d, int level);

#ifdef __cplusplus
}
#endif

#endif /* DELAUNAY_3_H */
