// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPHS_DEGREES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPHS_DEGREES_H

// Degrees on random triangulations of surfaces of all kinds, beside their bounds; all these surfaces come
// as graphs with rotation system, as some are not orientable. And trees of nearly minimum degree: on
// triangulations made to need a large degree or to mislead, on the meshes of a folder, and what the
// exchanges cost.

#include <Delaunay_from_surface_3_files/one_line.h>
#include <Delaunay_from_surface_3_files/read_polygon_soup.h>
#include <Delaunay_from_surface_3_triangle_lists/Triangle_list.h>
#include <Delaunay_from_surface_3_triangle_lists/Surface_recipe.h>
#include <Delaunay_from_surface_3_triangle_lists/bouquet.h>

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/surface/surface_topology.h>
#include <CGAL/Delaunay_from_surface_3/surface/Reduce_degrees.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/bounded_degree_spanning_subgraph.h>
#include <CGAL/certify_spanning_subgraph.h>
#include <CGAL/near_minimum_degree_spanning_tree.h>
#include <CGAL/surface_of.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <iterator>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace subgraphs {

using triangle_lists::Embedded_graph;
using triangle_lists::Surface_recipe;
using triangle_lists::Triangle_list;

struct Named_recipe
{
  std::string name;
  int shape, handles, cross_caps, punctures, copies;   // as in Surface_recipe
  std::size_t components, euler_genus, boundary_loops; // the latter two of all components together
};

inline const std::vector<Named_recipe>& named_recipes()
{
  static const std::vector<Named_recipe> recipes = {
      {"sphere", 0, 0, 0, 0, 0, 1, 0, 0},
      {"disc", 3, 0, 0, 0, 0, 1, 0, 1},
      {"annulus", 8, 0, 0, 0, 0, 1, 0, 2},
      {"sphere, 5 holes", 0, 0, 0, 5, 0, 1, 0, 5},
      {"torus", 5, 0, 0, 0, 0, 1, 2, 0},
      {"torus, 1 hole", 5, 0, 0, 1, 0, 1, 2, 1},
      {"torus, 3 holes", 5, 0, 0, 3, 0, 1, 2, 3},
      {"genus 2", 5, 1, 0, 0, 0, 1, 4, 0},
      {"genus 3", 5, 2, 0, 0, 0, 1, 6, 0},
      {"genus 3, 2 holes", 5, 2, 0, 2, 0, 1, 6, 2},
      {"genus 10", 5, 9, 0, 0, 0, 1, 20, 0},
      {"projective plane", 6, 0, 0, 0, 0, 1, 1, 0},
      {"Möbius band", 7, 0, 0, 0, 0, 1, 1, 1},
      {"Klein bottle", 6, 0, 1, 0, 0, 1, 2, 0},
      {"Klein bottle, 2 holes", 6, 0, 1, 2, 0, 1, 2, 2},
      {"5 cross-caps", 6, 0, 4, 0, 0, 1, 5, 0},
      {"torus and 2 annuli", 5, 0, 0, 0, 2, 3, 2, 4},
      {"projective plane and Möbius band", 6, 0, 0, 0, 1, 2, 2, 1}};
  return recipes;
}

// Small ones, where a bound is near, and a large one now and then.
inline Triangle_list random_triangulation(const Named_recipe& named, int seed)
{
  const bool is_large = seed % 100 == 99;
  Surface_recipe recipe;
  recipe.field = {named.shape,
                  4,
                  named.handles,
                  named.cross_caps,
                  is_large ? 10000 : 15 + 25 * named.punctures + seed % 40,
                  is_large ? 60000 : seed % 300,
                  named.punctures,
                  named.copies,
                  0,
                  seed};
  return cook(recipe);
}

// Not all small surfaces have room for all holes.
inline bool has_topology(const Named_recipe& named,
                         const CGAL::Delaunay_from_surface_3::Surface_topology& topology)
{
  std::size_t euler_genus = 0, boundary_loops = 0;
  for (const auto& component : topology.components) {
    euler_genus += component.euler_genus();
    boundary_loops += component.number_of_boundary_loops;
  }
  return topology.components.size() == named.components && euler_genus == named.euler_genus &&
         boundary_loops == named.boundary_loops;
}

// The paper speaks of spheres, discs, and closed orientable surfaces: null elsewhere.
inline nlohmann::ordered_json
bound_of_the_paper(const CGAL::Delaunay_from_surface_3::Surface_topology& topology)
{
  std::size_t bound = 3;
  for (const auto& component : topology.components) {
    const std::size_t h = component.euler_genus(), b = component.number_of_boundary_loops;
    if (!component.is_orientable || b > 1 || (b == 1 && h > 0))
      return nullptr;
    bound = (std::max)(bound, 6 * h);
  }
  return bound;
}

inline nlohmann::ordered_json measure_bounds(const Named_recipe& named, int triangulations)
{
  std::size_t fewest = (std::numeric_limits<std::size_t>::max)(), most = 0;
  std::size_t bound = 0, bound_of_tree = 0, degree = 0, degree_of_tree = 0;
  nlohmann::ordered_json paper;
  for (int seed = 0, made = 0; made < triangulations; ++seed) {
    if (seed > 2 * triangulations + 10)
      throw std::logic_error("the recipe for " + named.name + " makes other surfaces");
    std::mt19937 random(static_cast<unsigned>(seed));
    const Embedded_graph g = embed(random_triangulation(named, seed), random);
    const auto topology = CGAL::Delaunay_from_surface_3::surface_topology(g.surface());
    if (!has_topology(named, topology))
      continue;
    ++made;
    std::vector<Embedded_graph::Edge> subgraph, tree;
    CGAL::bounded_degree_spanning_subgraph(g.surface(), std::back_inserter(subgraph));
    CGAL::bounded_degree_spanning_tree(g.surface(), std::back_inserter(tree));
    const auto found = CGAL::certify_spanning_subgraph(g.surface(), subgraph);
    const auto found_of_tree = CGAL::certify_spanning_subgraph(g.surface(), tree);
    if (!found.is_valid_subgraph() || !found_of_tree.is_valid_tree())
      throw std::runtime_error("a subgraph of " + named.name + " does not keep what it promises");
    for (const auto& component : topology.components) {
      bound = (std::max)(bound, component.subgraph_degree_bound());
      bound_of_tree = (std::max)(bound_of_tree, component.tree_degree_bound());
    }
    paper = bound_of_the_paper(topology);
    degree = (std::max)(degree, found.maximum_degree);
    degree_of_tree = (std::max)(degree_of_tree, found_of_tree.maximum_degree);
    fewest = (std::min)(fewest, num_vertices(g.graph));
    most = (std::max)(most, num_vertices(g.graph));
  }
  return {{"surface", named.name},
          {"triangulations", triangulations},
          {"fewest_vertices", fewest},
          {"most_vertices", most},
          {"euler_genus", named.euler_genus},
          {"boundary_loops", named.boundary_loops},
          {"bound_of_the_paper", paper},
          {"bound", bound},
          {"maximum_degree", degree},
          {"bound_of_tree", bound_of_tree},
          {"maximum_degree_of_tree", degree_of_tree}};
}

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

// Into how many components a surface falls without the vertices of a witness, by the lists of
// neighbours alone: one pass over the edges.
inline std::size_t
components_without(const CGAL::Delaunay_from_surface_3::internal::Rotation_system<std::uint32_t>& g,
                   const std::vector<std::size_t>& removed)
{
  std::vector<bool> is_met(g.number_of_vertices(), false);
  for (const std::size_t v : removed)
    is_met[v] = true;
  std::size_t found = 0;
  std::vector<std::uint32_t> stack;
  for (std::uint32_t root = 0; root < g.number_of_vertices(); ++root) {
    if (is_met[root])
      continue;
    ++found;
    is_met[root] = true;
    for (stack.assign(1, root); !stack.empty();) {
      const std::uint32_t v = stack.back();
      stack.pop_back();
      for (const std::uint32_t u : g.star(v))
        if (!is_met[u]) {
          is_met[u] = true;
          stack.push_back(u);
        }
    }
  }
  return found;
}

// Processor time of the tree of bounded degree, of the exchanges that follow and of a check of the
// witness, the fastest of some repetitions, and what was done. The surface has one component.
template <class Reader>
nlohmann::ordered_json
time_near_minimum(const std::string& name,
                  const CGAL::Delaunay_from_surface_3::Triangulated_surface<Reader>& of,
                  std::size_t repetitions)
{
  namespace internal = CGAL::Delaunay_from_surface_3::internal;
  double tree_seconds = 1e300, exchange_seconds = 1e300, witness_seconds = 1e300;
  std::vector<std::size_t> degree, degree_before;
  internal::Reduction_counts counts;
  Witnesses witnesses;
  const auto seconds = [](std::clock_t start, std::clock_t end) {
    return double(end - start) / CLOCKS_PER_SEC;
  };
  std::size_t n = 0;
  for (std::size_t r = 0; r < repetitions; ++r) {
    const std::clock_t start = std::clock();
    internal::Rotation_system<std::uint32_t> surface;
    of.reader().read(surface);
    n = surface.number_of_vertices();
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
    tree_seconds = (std::min)(tree_seconds, seconds(start, middle));
    exchange_seconds = (std::min)(exchange_seconds, seconds(counted, end));
    const std::clock_t checked = std::clock();
    for (const auto& witness : witnesses)
      if (components_without(surface, witness.vertices) != witness.number_of_components)
        throw std::runtime_error(name + ": a witness that does not check");
    witness_seconds = (std::min)(witness_seconds, seconds(checked, std::clock()));
  }
  nlohmann::ordered_json result = {
      {"surface", name},
      {"vertices", n},
      {"maximum_degree_of_tree", *std::max_element(degree_before.begin(), degree_before.end())},
      {"vertices_of_degree_4_or_more",
       std::count_if(degree_before.begin(), degree_before.end(), [](auto d) { return d > 3; })},
      {"maximum_degree", *std::max_element(degree.begin(), degree.end())},
      {"least_degree_by_witness", least_degree(witnesses)},
      {"exchanges_nearby", counts.exchanges_nearby},
      {"phases", counts.phases},
      {"phases_in_vain", counts.phases_in_vain},
      {"nanoseconds_per_vertex_of_tree", tree_seconds * 1e9 / double(n)},
      {"nanoseconds_per_vertex_of_exchanges", exchange_seconds * 1e9 / double(n)}};
  if (!witnesses.empty()) {
    result["vertices_of_witness"] = witnesses.front().vertices.size();
    result["components_without_witness"] = witnesses.front().number_of_components;
    result["nanoseconds_per_vertex_of_witness"] = witness_seconds * 1e9 / double(n);
  }
  return result;
}

// A stacked complete graph, stacked again until it has so many vertices: the same witness serves.
inline nlohmann::ordered_json time_stacked(int n, std::size_t vertices, std::size_t repetitions)
{
  triangle_lists::Triangle_list s = triangle_lists::stacked_complete_graph(n);
  std::size_t times = 1;
  for (; std::size_t(s.n) < vertices; ++times)
    s = stacked(s);
  return time_near_minimum("K_" + std::to_string(n) + ", stacked " + std::to_string(times) +
                               " times",
                           CGAL::surface_of(std::size_t(s.n), s.triangles), repetitions);
}

// What is found on the triangles of a file, or why they are refused. Points that are repeated are
// merged. CGAL's reader of .ply crashes on some files.
inline nlohmann::ordered_json measure_near_minimum_file(const std::filesystem::path& path,
                                                        const std::string& name)
{
  files::Polygon_soup soup;
  try {
    soup = files::read_polygon_soup(path.string());
  } catch (const std::runtime_error& error) {
    return {{"file", name}, {"refused", files::one_line(error.what())}};
  }
  auto& points = soup.points;
  auto& faces = soup.faces;
  CGAL::Polygon_mesh_processing::merge_duplicate_points_in_polygon_soup(points, faces);
  const auto surface = CGAL::surface_of(points.size(), faces);
  std::vector<std::pair<std::size_t, std::size_t>> tree, near_minimum;
  Witnesses witnesses;
  try {
    CGAL::bounded_degree_spanning_tree(surface, std::back_inserter(tree));
    CGAL::near_minimum_degree_spanning_tree(surface, std::back_inserter(near_minimum),
                                            std::back_inserter(witnesses));
  } catch (const CGAL::Surface_input_error& error) {
    return {{"file", name}, {"vertices", points.size()}, {"refused", error.what()}};
  }
  const auto found = CGAL::certify_spanning_subgraph(surface, near_minimum);
  if (!found.is_valid_near_minimum_tree())
    throw std::runtime_error(name + ": the tree does not keep what it promises");
  std::size_t loops = 0, bound = 0, euler_genus = 0;
  const auto topology = CGAL::Delaunay_from_surface_3::surface_topology(surface);
  for (const auto& component : topology.components) {
    loops += component.number_of_boundary_loops;
    bound = (std::max)(bound, component.near_minimum_tree_degree_bound());
    euler_genus += component.euler_genus();
  }
  nlohmann::ordered_json result = {
      {"file", name},
      {"vertices", points.size()},
      {"components", topology.components.size()},
      {"boundary_loops", loops},
      {"orientable", topology.is_orientable()},
      {"euler_genus", euler_genus},
      {"maximum_degree_of_tree", CGAL::certify_spanning_subgraph(surface, tree).maximum_degree},
      {"maximum_degree", found.maximum_degree},
      {"bound", bound}};
  for (const auto& witness : witnesses)
    result["witnesses"].push_back({{"vertices", witness.vertices.size()},
                                   {"components_without", witness.number_of_components},
                                   {"least_degree", witness.least_degree()}});
  return result;
}

// The files of a folder and of those in it, one row each.
inline nlohmann::ordered_json measure_near_minimum_files(const std::string& folder)
{
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".off" || extension == ".obj" || extension == ".stl" || extension == ".ply")
      paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const auto& path : paths)
    rows.push_back(
        measure_near_minimum_file(path, std::filesystem::relative(path, folder).string()));
  return rows;
}

} // namespace subgraphs

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPHS_DEGREES_H
