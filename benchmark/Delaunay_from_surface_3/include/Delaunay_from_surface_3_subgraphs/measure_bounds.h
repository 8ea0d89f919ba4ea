// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPHS_MEASURE_BOUNDS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPHS_MEASURE_BOUNDS_H

// Degrees on random triangulations of surfaces of all kinds, beside their bounds. All surfaces come
// as graphs with rotation system, as some are not orientable.

#include <Delaunay_from_surface_3_triangle_lists/Embedded_graph.h>
#include <Delaunay_from_surface_3_triangle_lists/Surface_recipe.h>

#include <CGAL/Delaunay_from_surface_3/surface/surface_topology.h>
#include <CGAL/bounded_degree_spanning_subgraph.h>
#include <CGAL/certify_spanning_subgraph.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
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

} // namespace subgraphs

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPHS_MEASURE_BOUNDS_H
