/* Copyright (c) 2026 The authors of Delaunay_from_surface_3
 *
 * SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * 3D Delaunay triangulations, for C and for all languages that can call C. They are
 * exact, with any number of threads. The result equals CGAL's Delaunay_triangulation_3, or its
 * Regular_triangulation_3 for points with weights, but CGAL is not needed. Points may also lie in a
 * periodic box.
 *
 *   delaunay_3* d;
 *   delaunay_3_cells cells;
 *   if (delaunay_3_build(points, n, NULL, 0, 1, &d, NULL) == DELAUNAY_3_OK) {
 *     delaunay_3_get(d, &cells);
 *     for (c = 0; c < cells.number; ++c)
 *       use(cells.vertices + c * cells.stride);
 *     delaunay_3_free(d);
 *   }
 *
 * Compiled with -DDELAUNAY_3_ONE_THREAD it needs no threads, and uses one however many are asked for. The
 * same holds with -fno-exceptions; statuses are as ever, but a call that fails leaves its memory behind,
 * and only one thread may call at a time.
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
  DELAUNAY_3_NOT_FINITE,   /* a coordinate or weight is not a finite number */
  DELAUNAY_3_BAD_INDEX,    /* a triangle has an index that is not one of a point */
  DELAUNAY_3_BAD_ARGUMENT, /* no thread, an unknown level, null for an array that has entries */
  DELAUNAY_3_TOO_MANY,     /* more than 2^30 cells, or 2^31 - 2 points or triangles */
  DELAUNAY_3_NO_MEMORY,
  DELAUNAY_3_FAILED, /* a fault of the library */
  DELAUNAY_3_NOT_EXACT, /* the library is compiled with -ffast-math, -Ofast or parts of them, or
                           denormal numbers become zero in a mode that cannot be left; checked at
                           each call */
  DELAUNAY_3_BAD_BOX, /* a period is not positive, less than 1/10000 of the diagonal of the box, or so
                        small that points are 2^29 of them away or corners of a cell more than 32767
                        of them apart; or the points lie in a plane or on a line parallel to all axes
                        with periods */
  DELAUNAY_3_STOPPED, /* the caller's function returned 0 */
  DELAUNAY_3_NO_INSIDE /* the surface is not orientable, or so open that less volume is surely inside
                          than in doubt */
} delaunay_3_status;

/* Corner k of cell c is point vertices[c * stride + k]; the neighbour opposite to it is cell
 * neighbors[c * stride + k]. The simplices come first, positively oriented, and then the infinite
 * cells, whose last corner is -1. Each cell has dimension + 1 corners: 4 unless the points lie in
 * one plane. If points coincide, the first is the corner; vertex_of_point names it. It is -1 for a
 * point that is hidden by others with larger weights, and in no cell. */
typedef struct delaunay_3_cells
{
  int dimension; /* -1 if there are no points */
  size_t number, number_with_infinite, stride;
  const int32_t *vertices, *neighbors;
  size_t number_of_points;
  const int32_t* vertex_of_point;
} delaunay_3_cells;

/* During a call numbers are rounded to nearest, denormal ones kept; then the old mode is back. */

/* Triangulates n points, given by three coordinates each. Triangles of a surface on the points,
 * given by three indices each, are checked and never change the result; there may be none. The last
 * three functions read points and weights again, so these must stay where they are. If a point or triangle is
 * refused, *where is its number; after any failure, *result is null. `where` may be null, but
 * `result` may not; `points` and `triangles` may be null if there are none. */
delaunay_3_status delaunay_3_build(const double* points, size_t n, const int32_t* triangles,
                                   size_t number_of_triangles, int threads, delaunay_3** result,
                                   size_t* where);

/* Does the same for points with weights, one for each, which may be negative: the regular
 * triangulation, or weighted Delaunay triangulation. Weights are squared radii. */
delaunay_3_status delaunay_3_build_weighted(const double* points, const double* weights, size_t n,
                                            int threads, delaunay_3** result, size_t* where);

/* Does the same for points in a periodic box: the triangulation of all their copies, each cell of which
 * stands for all its copies. `box` has the period along each axis, INFINITY along one that has none.
 * `weights` may be null. Points may lie anywhere. Corner k of cell c is the point vertices[c * stride + k]
 * moved by offsets[12 * c + 3 * k + a] periods along each axis a; the first corner with the smallest index
 * is not moved. Without a period along some axis there is a hull: there neighbours are -1. There are no
 * infinite cells. Points that are equal but for whole periods are one vertex. */
delaunay_3_status delaunay_3_build_periodic(const double* points, const double* weights, size_t n,
                                            const double* box, int threads, delaunay_3** result,
                                            size_t* where);

/* Does what any of the three does; `weights` and `box` may be null. Calls go_further(data, share), in
 * this thread, every 256 points or more often, with the share of the points that are inserted. The call
 * ends with DELAUNAY_3_STOPPED when that returns 0. It must not throw, and is called with rounding to
 * nearest. */
delaunay_3_status delaunay_3_build_watched(const double* points, const double* weights, size_t n,
                                           const double* box, int threads,
                                           int (*go_further)(void* data, double share), void* data,
                                           delaunay_3** result, size_t* where);

/* Returns these offsets, which live as long as the triangulation; null if there are none. */
const int16_t* delaunay_3_offsets(const delaunay_3* d);

/* Returns the meaning of a status, in English. */
const char* delaunay_3_message(delaunay_3_status status);

/* Gives access to the cells, which live as long as the triangulation; there are none for null. */
void delaunay_3_get(const delaunay_3* d, delaunay_3_cells* cells);

void delaunay_3_free(delaunay_3* d); /* d may be null */

/* Finds for each of n points the tetrahedron with the smallest number that contains it, boundary
 * included, or -1 if there is none. Arrays may be null if n is 0. In a box one of its copies contains
 * it; a point that is 2^29 or more periods away is a bad argument. */
delaunay_3_status delaunay_3_find(const delaunay_3* d, const double* points, size_t n, int threads,
                                  int32_t* found, size_t* where);

/* Finds the winding number of a surface at the mean of the corners of each tetrahedron, up to about 0.01:
 * one number for each, about 1 or -1 inside a closed surface. A tetrahedron is inside if it is at least
 * 1/2 or at most -1/2. Triangles, given as above, may have gaps and overlap; those that disagree with
 * their neighbours are turned. Bad arguments are points in a plane, with weights or in a box, and no
 * triangles. */
delaunay_3_status delaunay_3_winding_numbers(const delaunay_3* d, const int32_t* triangles,
                                             size_t number_of_triangles, int threads, double* numbers,
                                             size_t* where);

/* Returns 1 if it is the Delaunay or regular triangulation, else 0; or, with a minus sign, the status that
 * prevented the check (without memory it may still be valid; a box is a bad argument). Level 0 checks
 * that neighbours agree, 1 also spheres of cells around vertices, 2 orientations, and 3 all, by Delaunay's lemma. */
int delaunay_3_is_valid(const delaunay_3* d, int level);

#ifdef __cplusplus
}
#endif

#endif /* DELAUNAY_3_H */
