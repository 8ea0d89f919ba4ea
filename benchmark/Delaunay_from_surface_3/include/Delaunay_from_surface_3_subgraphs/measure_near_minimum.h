// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPHS_MEASURE_NEAR_MINIMUM_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPHS_MEASURE_NEAR_MINIMUM_H

// Trees of nearly minimum degree: on triangulations made to need a large degree or to mislead, on
// the meshes of a folder, and what the exchanges cost.

#include <Delaunay_from_surface_3_triangle_lists/Embedded_graph.h>
#include <Delaunay_from_surface_3_triangle_lists/bouquet.h>
#include <Delaunay_from_surface_3_triangle_lists/stacked_complete_graph.h>

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/surface/surface_topology.h>
#include <CGAL/Delaunay_from_surface_3/surface/write_near_minimum_degree_tree.h>
#include <CGAL/bounded_degree_spanning_subgraph.h>
#include <CGAL/certify_spanning_subgraph.h>
#include <CGAL/near_minimum_degree_spanning_tree.h>
#include <CGAL/surface_of.h>

#include <CGAL/boost/graph/IO/OFF.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <iterator>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace subgraphs {

using Witnesses = std::vector<CGAL::Delaunay_from_surface_3::Minimum_degree_witness>;

inline std::size_t least_degree(const Witnesses& witnesses)
{
  std::size_t least = 0;
  for (const auto& witness : witnesses)
    least = (std::max)(least, witness.least_degree());
  return least;
}

inline nlohmann::ordered_json measure_near_minimum(const std::string& name,
                                                   const triangle_lists::Triangle_list& s)
{
  std::mt19937 random(1);
  const triangle_lists::Embedded_graph g = embed(s, random);
  const auto topology = CGAL::Delaunay_from_surface_3::surface_topology(g.surface());
  std::vector<triangle_lists::Embedded_graph::Edge> subgraph, tree, near_minimum;
  Witnesses witnesses;
  CGAL::bounded_degree_spanning_subgraph(g.surface(), std::back_inserter(subgraph));
  CGAL::bounded_degree_spanning_tree(g.surface(), std::back_inserter(tree));
  CGAL::near_minimum_degree_spanning_tree(g.surface(), std::back_inserter(near_minimum),
                                          std::back_inserter(witnesses));
  const auto certify = [&](const auto& edges) {
    return CGAL::certify_spanning_subgraph(g.surface(), edges);
  };
  const auto found = certify(near_minimum);
  if (!found.is_valid_near_minimum_tree())
    throw std::runtime_error("the tree of " + name + " does not keep what it promises");
  const auto& component = topology.components.front();
  return {{"surface", name},
          {"vertices", num_vertices(g.graph)},
          {"genus", component.genus()},
          {"bound_of_the_paper", 12 * component.genus()},
          {"maximum_degree_of_subgraph", certify(subgraph).maximum_degree},
          {"maximum_degree_of_tree", certify(tree).maximum_degree},
          {"maximum_degree", found.maximum_degree},
          {"bound", component.near_minimum_tree_degree_bound()},
          {"least_degree_by_witness", least_degree(witnesses)}};
}

inline nlohmann::ordered_json measure_near_minimum_families()
{
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const int n : {7, 19, 31}) {
    rows.push_back(measure_near_minimum("stacked K_" + std::to_string(n),
                                        triangle_lists::stacked_complete_graph(n)));
    const std::size_t c = std::size_t(n) * std::size_t(n - 1) / 3, x = std::size_t(n);
    rows.back()["least_degree"] = (c + 2 * x - 2) / x; // X are the n vertices
  }
  for (const int genus : {1, 2, 3, 6}) {
    triangle_lists::Bouquet bouquet = triangle_lists::orientable_bouquet(genus);
    bouquet.has_pockets = true;
    rows.push_back(measure_near_minimum("bouquet with pockets", triangulated(bouquet)));
  }
  return rows;
}

// Processor time of the tree of bounded degree and of the exchanges that follow, the fastest of
// some repetitions, and what was done.
template <class Mesh>
nlohmann::ordered_json time_near_minimum(const std::string& name, const Mesh& mesh,
                                         std::size_t repetitions)
{
  namespace internal = CGAL::Delaunay_from_surface_3::internal;
  using Index_map = typename boost::property_map<Mesh, boost::vertex_index_t>::const_type;
  double tree_seconds = 1e300, exchange_seconds = 1e300;
  std::vector<std::size_t> degree, degree_before;
  internal::Reduction_counts counts;
  Witnesses witnesses;
  for (std::size_t r = 0; r < repetitions; ++r) {
    const std::clock_t start = std::clock();
    const internal::Halfedge_graph_reader<Mesh, Index_map> reader(mesh,
                                                                  get(boost::vertex_index, mesh));
    internal::Rotation_system<std::uint32_t> surface;
    reader.read(surface);
    internal::Bounded_degree_marks<std::uint32_t> find_tree(surface, internal::Subgraph_kind::TREE);
    internal::Dart_marks marks = find_tree();
    const std::clock_t middle = std::clock();
    find_tree.close();
    witnesses.clear();
    counts = {};
    const auto count_degrees = [&] {
      std::vector<std::size_t> result(surface.number_of_vertices(), 0);
      for (std::uint32_t v = 0; v < surface.number_of_vertices(); ++v)
        for (std::uint32_t dart = surface.first[v]; dart < surface.first[v + 1]; ++dart)
          if (marks[dart]) {
            ++result[v];
            ++result[surface.neighbor[dart]];
          }
      return result;
    };
    degree_before = count_degrees();
    const std::clock_t counted = std::clock();
    if (!internal::has_degree_of_3(surface, marks))
      counts = internal::Reduce_degrees<std::uint32_t>(surface, marks)(witnesses);
    const std::clock_t end = std::clock();
    degree = count_degrees();
    tree_seconds = (std::min)(tree_seconds, double(middle - start) / CLOCKS_PER_SEC);
    exchange_seconds = (std::min)(exchange_seconds, double(end - counted) / CLOCKS_PER_SEC);
  }
  const double n = double(num_vertices(mesh));
  return {{"surface", name},
          {"vertices", num_vertices(mesh)},
          {"maximum_degree_of_tree", *std::max_element(degree_before.begin(), degree_before.end())},
          {"vertices_of_degree_4_or_more",
           std::count_if(degree_before.begin(), degree_before.end(), [](auto d) { return d > 3; })},
          {"maximum_degree", *std::max_element(degree.begin(), degree.end())},
          {"least_degree_by_witness", least_degree(witnesses)},
          {"exchanges_nearby", counts.exchanges_nearby},
          {"phases", counts.phases},
          {"phases_in_vain", counts.phases_in_vain},
          {"nanoseconds_per_vertex_of_tree", tree_seconds * 1e9 / n},
          {"nanoseconds_per_vertex_of_exchanges", exchange_seconds * 1e9 / n}};
}

// The meshes of a folder: how many trees of bounded degree have which largest degree, before and
// after.
template <class Mesh>
nlohmann::ordered_json measure_near_minimum_meshes(const std::string& folder)
{
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".off")
      paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::size_t closed = 0, with_boundary = 0, refused = 0;
  std::vector<std::size_t> before(1, 0), after(1, 0);
  const auto count = [](std::vector<std::size_t>& histogram, std::size_t degree) {
    histogram.resize((std::max)(histogram.size(), degree + 1), 0);
    ++histogram[degree];
  };
  for (const auto& path : paths) {
    Mesh mesh;
    if (!CGAL::IO::read_OFF(path.string(), mesh)) {
      ++refused;
      continue;
    }
    std::vector<typename Mesh::Edge_index> tree, near_minimum;
    try {
      CGAL::bounded_degree_spanning_tree(CGAL::surface_of(mesh), std::back_inserter(tree));
      CGAL::near_minimum_degree_spanning_tree(CGAL::surface_of(mesh),
                                              std::back_inserter(near_minimum));
    } catch (const CGAL::Surface_input_error&) {
      ++refused;
      continue;
    }
    const auto found = CGAL::certify_spanning_subgraph(CGAL::surface_of(mesh), near_minimum);
    if (!found.is_valid_near_minimum_tree())
      throw std::runtime_error(path.string() + ": the tree does not keep what it promises");
    ++(CGAL::is_closed(mesh) ? closed : with_boundary);
    count(before, CGAL::certify_spanning_subgraph(CGAL::surface_of(mesh), tree).maximum_degree);
    count(after, found.maximum_degree);
  }
  return {{"closed", closed},
          {"with_boundary", with_boundary},
          {"refused", refused},
          {"meshes_of_degree_of_tree", before},
          {"meshes_of_degree", after}};
}

} // namespace subgraphs

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPHS_MEASURE_NEAR_MINIMUM_H
