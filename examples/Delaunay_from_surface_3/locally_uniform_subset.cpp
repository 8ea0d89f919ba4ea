// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Thins points before they are inserted, more and more coarsely. Where the points are denser, more
// are kept. Each subset is a subset of the previous one.

#include <CGAL/insert_points_3.h>
#include <CGAL/locally_uniform_subset_3.h>
#include <CGAL/neighbor_spacing_3.h>

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Item = std::pair<K::Point_3, double>; // a point, and its spacing

int main(int argc, char* argv[])
try {
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("torus.off");
  std::vector<K::Point_3> points;
  std::vector<std::vector<std::size_t>> unused_faces;
  if (!CGAL::IO::read_polygon_soup(file_name, points, unused_faces) || points.empty()) {
    std::cerr << "Cannot read " << file_name << '\n';
    return EXIT_FAILURE;
  }

  const std::vector<double> spacing = CGAL::neighbor_spacing_3(points);
  std::vector<Item> items;
  for (std::size_t i = 0; i < points.size(); ++i)
    items.emplace_back(points[i], spacing[i]);

  const auto np = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Item>());
  for (const double factor : {0.5, 1., 2., 4.}) {
    std::vector<std::size_t> kept;
    CGAL::locally_uniform_subset_3(
        items, [&](std::size_t i) { return factor * items[i].second; }, std::back_inserter(kept),
        np);
    std::vector<Item> subset;
    for (const std::size_t i : kept)
      subset.push_back(items[i]);
    items = std::move(subset);

    CGAL::Delaunay_triangulation_3<K> tr;
    CGAL::insert_points_3(tr, items, np);
    std::cout << "factor " << factor << ": " << items.size() << " of " << points.size()
              << " points, " << tr.number_of_finite_cells() << " tetrahedra\n";
    if (tr.number_of_vertices() != items.size()) // they are distinct
      return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
} catch (const CGAL::Surface_input_error& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
