/* Copyright (c) 2026 The authors of Delaunay_from_surface_3
 *
 * SPDX-License-Identifier: LGPL-3.0-or-later
 *
 * Triangulates random points and asks where their middle is. Needs delaunay_3.h and delaunay_3.cpp, which
 * scripts/amalgamate makes, and nothing else:
 *
 *   c++ -O2 -std=c++17 -c delaunay_3.cpp && cc triangulate.c delaunay_3.o -lstdc++ -lm -lpthread
 */
#include "delaunay_3.h"

#include <stdio.h>
#include <stdlib.h>

int main(void)
{
  static double points[3 * 10000];
  const double middle[3] = {.5, .5, .5};
  delaunay_3* d;
  delaunay_3_cells cells;
  int32_t c;
  size_t i;
  for (i = 0; i < 3 * 10000; ++i)
    points[i] = rand() / (double)RAND_MAX;
  const delaunay_3_status status = delaunay_3_build(points, 10000, NULL, 0, 2, &d, NULL);
  if (status != DELAUNAY_3_OK)
    return puts(delaunay_3_message(status)), 1;
  delaunay_3_get(d, &cells);
  delaunay_3_find(d, middle, 1, 1, &c, NULL);
  const int32_t* v = cells.vertices + (size_t)c * cells.stride;
  printf("%s: points %d, %d, %d and %d of %d are around the middle\n",
         delaunay_3_is_valid(d, 3) == 1 ? "valid" : "wrong", v[0], v[1], v[2], v[3],
         (int)cells.number_of_points);
  delaunay_3_free(d);
  return 0;
}
