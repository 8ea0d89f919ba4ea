// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The Euclidean minimum spanning tree, tile by tile. Of the edges in a tile, only a minimum
// spanning forest is kept: any other edge is the longest of a cycle, so a minimum spanning tree
// does not need it.

#include <CGAL/delaunay_3_tiles.h>
#include <CGAL/euclidean_minimum_spanning_tree_3.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <tuple>
#include <utility>
#include <vector>

using Triangulation =
    CGAL::Delaunay_triangulation_3<CGAL::Exact_predicates_inexact_constructions_kernel>;
using Edge = std::tuple<double, std::size_t, std::size_t>; // its length, and vertices below n

std::vector<Edge> shortest_forest(std::vector<Edge> edges, std::size_t n)
{
  std::sort(edges.begin(), edges.end());
  boost::disjoint_sets_with_storage<> trees(n);
  std::vector<Edge> forest;
  for (const Edge& e : edges) {
    const std::size_t v = trees.find_set(std::get<1>(e)), w = trees.find_set(std::get<2>(e));
    if (v != w) {
      trees.link(v, w);
      forest.push_back(e);
    }
  }
  return forest;
}

int main(int argc, char* argv[])
{
  const std::size_t n = argc > 1 ? std::size_t(std::atoi(argv[1])) : 4000;
  std::vector<std::array<double, 3>> points; // on a spiral around a ball
  Triangulation tr;
  for (std::size_t i = 0; i < n; ++i) {
    const double z = 1 - (2 * double(i) + 1) / double(n), r = std::sqrt(1 - z * z);
    points.push_back({r * std::cos(2.4 * double(i)), r * std::sin(2.4 * double(i)), z});
    tr.insert(Triangulation::Point(points[i][0], points[i][1], points[i][2]));
  }
  CGAL::Tiles_here_3 engine; // Tiles_in_files_3 if they do not fit into memory
  CGAL::Tiles_options options;
  options.number_of_tiles = 8;
  std::vector<Edge> candidates;
  const auto add_candidates = [&](const CGAL::Delaunay_3_tile& tile) {
    std::vector<Edge> edges;
    for (const auto& cell : tile.cells)
      for (int k = 0; k < 4 && cell[k] >= 0; ++k)
        for (int j = 0; j < k; ++j) {
          const auto &p = tile.points[cell[j]], &q = tile.points[cell[k]];
          edges.emplace_back(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]), cell[j], cell[k]);
        }
    for (const auto& [length, v, w] : shortest_forest(std::move(edges), tile.ids.size()))
      candidates.emplace_back(length, tile.ids[v], tile.ids[w]);
  };
  const CGAL::Tile_array_source_3 source(points.front().data(), n);
  CGAL::delaunay_3_tiles(engine, source, add_candidates, options);

  double length = 0, expected = 0;
  const std::vector<Edge> tree = shortest_forest(candidates, n);
  for (const Edge& edge : tree)
    length += std::get<0>(edge);
  std::vector<std::pair<Triangulation::Vertex_handle, Triangulation::Vertex_handle>> whole;
  CGAL::euclidean_minimum_spanning_tree_3(tr, std::back_inserter(whole));
  for (const auto& [v, w] : whole)
    expected += std::sqrt(CGAL::squared_distance(v->point(), w->point()));
  std::cout << candidates.size() << " of " << tr.number_of_finite_edges()
            << " edges are candidates; " << tree.size() << " edges join " << n << " points; length "
            << length << '\n';
  return tree.size() + 1 == n && std::abs(length / expected - 1) < 1e-12 ? EXIT_SUCCESS
                                                                         : EXIT_FAILURE;
}
