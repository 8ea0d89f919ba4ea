// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A surface from points alone: CGAL's advancing front accepts a Delaunay triangulation that is
// already built. The triangles are compared with those of CGAL's function that inserts the points
// itself; where facets are equally good, its choice depends on the order of the points. The second
// argument names a file for them, such as surface.off.

#include <CGAL/insert_points_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/Timer.h>
#include <CGAL/Triangulation_data_structure_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_3;
using Vertex_base = CGAL::Advancing_front_surface_reconstruction_vertex_base_3<K>;
using Cell_base = CGAL::Advancing_front_surface_reconstruction_cell_base_3<K>;
using Tds = CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base>;
using Triangulation = CGAL::Delaunay_triangulation_3<K, Tds>;
using Facets = std::vector<std::array<std::size_t, 3>>;

// Brings the triangles into one order, whichever side is outside: of equally good facets, the front
// starts from the first, which depends on the order of the vertices. Of equal points, any may be the
// vertex.
Facets sorted(Facets facets, const std::vector<Point>& points)
{
  std::map<Point, std::size_t> first;
  for (const Point& p : points)
    first.emplace(p, first.size());
  for (auto& facet : facets) {
    for (std::size_t& i : facet)
      i = first.at(points[i]);
    std::sort(facet.begin(), facet.end());
  }
  std::sort(facets.begin(), facets.end());
  return facets;
}

int main(int argc, char* argv[])
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("torus.off");
  std::vector<Point> points;
  if (!CGAL::IO::read_points(file_name, std::back_inserter(points))) {
    std::cerr << "Cannot read " << file_name << ": expected points as .xyz, .ply or .off\n";
    return EXIT_FAILURE;
  }
  std::error_code error_code; // if there is no such output yet
  if (argc > 2 && std::filesystem::equivalent(file_name, argv[2], error_code)) {
    std::cerr << argv[2] << " is the input: name another file\n";
    return EXIT_FAILURE;
  }

  CGAL::Timer ours;
  ours.start();
  // [front]
  // The info of the vertices must be the indices of their points.
  std::vector<std::pair<Point, std::size_t>> numbered;
  for (const Point& p : points)
    numbered.emplace_back(p, numbered.size());
  Triangulation tr;
  try {
    CGAL::insert_points_3(tr, numbered);
  } catch (const CGAL::Surface_input_error& error) {
    std::cerr << file_name << ": " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  CGAL::Advancing_front_surface_reconstruction<Triangulation> front(tr);
  front.run();
  Facets facets;
  CGAL::write_triple_indices(std::back_inserter(facets), front);
  // [front]
  ours.stop();

  if (argc > 2 && !CGAL::IO::write_polygon_soup(argv[2], points, facets,
                                                CGAL::parameters::stream_precision(17))) {
    std::cerr << "Cannot write " << argv[2] << '\n';
    return EXIT_FAILURE;
  }

  CGAL::Timer plain;
  plain.start();
  Facets plain_facets;
  CGAL::advancing_front_surface_reconstruction(points.begin(), points.end(),
                                               std::back_inserter(plain_facets));
  plain.stop();

  std::cout << points.size() << " points, " << facets.size() << " triangles in " << ours.time()
            << " s; plain CGAL: " << plain_facets.size() << " in " << plain.time() << " s\n";
  if (sorted(facets, points) == sorted(plain_facets, points))
    return EXIT_SUCCESS;
  std::cerr
      << "Some triangles differ from plain CGAL's: where points are noisy or on a grid, the front "
         "depends on addresses in memory, and varies with plain CGAL, too\n";
  return argc > 1 ? EXIT_SUCCESS : EXIT_FAILURE; // those of the sample are the same
}
