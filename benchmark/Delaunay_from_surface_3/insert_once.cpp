// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Inserts the vertices of a mesh once with plain CGAL and once with the default, in functions of
// their own, whose instructions count_instructions.py counts. Prints the number of vertices.

#include <Delaunay_from_surface_3_files/Polygon_soup.h>
#include <Delaunay_from_surface_3_files/read_polygon_soup.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/insert_surface_points_3.h>

#include <cstdlib>
#include <exception>
#include <iostream>

#if defined(__GNUC__)
#define INSERT_ONCE_NOT_INLINE extern "C" __attribute__((noinline))
#else
#define INSERT_ONCE_NOT_INLINE extern "C"
#endif

using Triangulation = CGAL::Delaunay_triangulation_3<CGAL::Epick>;

INSERT_ONCE_NOT_INLINE void insert_once_by_plain_cgal(Triangulation& tr,
                                                      const files::Polygon_soup& soup)
{
  tr.insert(soup.points.begin(), soup.points.end());
}

INSERT_ONCE_NOT_INLINE void insert_once_by_default(Triangulation& tr,
                                                   const files::Polygon_soup& soup)
{
  CGAL::insert_surface_points_3(tr, soup.points, soup.faces);
}

// Where the counts of the first end; there is something in it, or calls would be left out.
INSERT_ONCE_NOT_INLINE void insert_once_between(const Triangulation& tr)
{
  std::cout << tr.number_of_vertices() << "\n";
}

int main(int argc, char** argv)
try {
  if (argc != 2) {
    std::cerr << "usage: insert_once MESH\n";
    return EXIT_FAILURE;
  }
  const files::Polygon_soup soup = files::read_polygon_soup(argv[1]);
  Triangulation expected, tr;
  insert_once_by_plain_cgal(expected, soup);
  insert_once_between(expected);
  insert_once_by_default(tr, soup);
  return tr.number_of_vertices() == expected.number_of_vertices() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch (const std::exception& error) {
  std::cerr << "insert_once: " << error.what() << '\n';
  return EXIT_FAILURE;
}
