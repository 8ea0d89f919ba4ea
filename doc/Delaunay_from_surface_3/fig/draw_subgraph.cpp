// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Draws the figures on subgraphs of bounded degree: the cut of a torus step by step, on the square
// it unrolls to, and a tree of it; the peeling of a disc step by step; a tree of the stacked K_7.
//
//   draw_subgraph FOLDER

#include "Svg.h"

#include <Delaunay_from_surface_3_triangle_lists/bouquet.h>

#include <CGAL/Delaunay_from_surface_3/surface/Bounded_degree_marks.h>
#include <CGAL/Delaunay_from_surface_3/surface/Peel_discs.h>
#include <CGAL/near_minimum_degree_spanning_tree.h>
#include <CGAL/surface_of.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace internal = CGAL::Delaunay_from_surface_3::internal;
using figures::Place;
using figures::Svg;
using Segments = std::vector<std::vector<Place>>;

const char* const style =
    ".e{fill:none;stroke:#d5d5d0;stroke-width:.8}.h{fill:none;stroke:#1b5fa8;stroke-width:1.6;"
    "stroke-linecap:round}"
    ".c{fill:none;stroke:#d23b45;stroke-width:2.6;stroke-linecap:round}.g{fill:none;stroke:#c98a1b;"
    "stroke-width:1.4}"
    ".v{fill:#fff;stroke:#333;stroke-width:1}.z{fill:#d23b45}.l{fill:#eef2f6;stroke:none}"
    "text{font:14px sans-serif;fill:#333;text-anchor:middle}";

// --- the cut of a torus, on the square ---

constexpr int grid = 9;

struct Flat_torus
{
  std::vector<Place> places; // in the unit square
  internal::Rotation_system<std::uint32_t> surface;
};

Flat_torus flat_torus()
{
  Flat_torus torus;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> shift(-0.28, 0.28);
  torus.surface.on_boundary.assign(grid * grid, false);
  torus.surface.first.assign(1, 0);
  for (int r = 0; r < grid; ++r)
    for (int c = 0; c < grid; ++c) {
      torus.places.push_back({(c + 0.5 + shift(random)) / grid, (r + 0.5 + shift(random)) / grid});
      for (const auto& [dr, dc] : {std::pair(0, 1), std::pair(1, 1), std::pair(1, 0),
                                   std::pair(0, -1), std::pair(-1, -1), std::pair(-1, 0)})
        torus.surface.neighbor.push_back(
            std::uint32_t((r + dr + grid) % grid * grid + (c + dc + grid) % grid));
      torus.surface.first.push_back(std::uint32_t(torus.surface.neighbor.size()));
    }
  return torus;
}

// Edges that leave the square are drawn from both of their ends.
Segments segments(const Flat_torus& torus, const internal::Dart_marks& marks, double left)
{
  Segments result;
  const auto near_one = [](double x, double to) { return x - std::round(x - to); };
  const auto on_sheet = [&](Place p) { return Place{left + 230 * p.x, 10 + 230 * p.y}; };
  for (std::uint32_t v = 0; v < torus.surface.number_of_vertices(); ++v)
    for (std::uint32_t dart = torus.surface.first[v]; dart < torus.surface.first[v + 1]; ++dart) {
      if (!marks[dart])
        continue;
      const Place p = torus.places[v], q = torus.places[torus.surface.neighbor[dart]];
      const Place from_p = {near_one(q.x, p.x), near_one(q.y, p.y)},
                  from_q = {near_one(p.x, q.x), near_one(p.y, q.y)};
      result.push_back({on_sheet(p), on_sheet(from_p)});
      if (std::abs(from_p.x - q.x) + std::abs(from_p.y - q.y) > 0.5)
        result.push_back({on_sheet(q), on_sheet(from_q)});
    }
  return result;
}

// Marks in a style, over one another.
using Layers = std::vector<std::pair<std::string, internal::Dart_marks>>;

void draw_panel(Svg& svg, const Flat_torus& torus, int panel, const Layers& layers,
                const std::string& words)
{
  const double left = 8 + 237 * panel;
  svg.begin_clip("panel" + std::to_string(panel), {left, 10}, 230, 230);
  svg.rectangle("l", {left, 10}, 230, 230);
  for (const auto& [layer_style, marks] : layers)
    svg.lines(layer_style, segments(torus, marks, left));
  svg.end_clip();
  svg.text("", {left + 115, 262}, words);
}

// Each edge at one of its darts.
internal::Dart_marks all_edges(const internal::Rotation_system<std::uint32_t>& surface)
{
  internal::Dart_marks marks(surface.number_of_darts(), false);
  for (std::uint32_t v = 0; v < surface.number_of_vertices(); ++v)
    for (std::uint32_t dart = surface.first[v]; dart < surface.first[v + 1]; ++dart)
      marks[dart] = v < surface.neighbor[dart];
  return marks;
}

internal::Dart_marks subgraph_of(Flat_torus torus,
                                 internal::Subgraph_kind kind) // opening changes it
{
  return internal::Bounded_degree_marks<std::uint32_t>(torus.surface, kind)();
}

void draw_torus(const std::string& cut_file_name, const std::string& tree_file_name)
{
  const Flat_torus torus = flat_torus();
  const internal::Dart_marks all = all_edges(torus.surface);
  internal::Cut_candidate<std::uint32_t> candidate(torus.surface);
  internal::Search_triangles<std::uint32_t>(torus.surface, candidate)();
  const internal::Dart_marks uncrossed = candidate.marks;
  internal::prune_cut(torus.surface, candidate);
  internal::Dart_marks cut = candidate.marks;
  for (std::uint32_t v = 0; v < torus.surface.number_of_vertices(); ++v)
    if (candidate.degree[v] == 0)
      std::fill(cut.begin() + torus.surface.first[v], cut.begin() + torus.surface.first[v + 1],
                false);
  const internal::Dart_marks subgraph = subgraph_of(torus, internal::Subgraph_kind::SUBGRAPH);
  const internal::Dart_marks tree = subgraph_of(torus, internal::Subgraph_kind::TREE);
  internal::Dart_marks dropped = subgraph;
  for (std::size_t dart = 0; dart < dropped.size(); ++dart)
    dropped[dart] = subgraph[dart] && !tree[dart];

  Svg steps(720, 276, style);
  draw_panel(steps, torus, 0, {{"e", all}, {"g", uncrossed}}, "edges that the search leaves");
  draw_panel(steps, torus, 1, {{"e", all}, {"c", cut}}, "pruned: the cut graph");
  draw_panel(steps, torus, 2, {{"e", all}, {"h", subgraph}, {"c", cut}}, "the subgraph");
  steps.write(cut_file_name);

  Svg trees(483, 276, style);
  draw_panel(trees, torus, 0, {{"e", all}, {"h", subgraph}, {"c", cut}}, "the subgraph, its rim");
  draw_panel(trees, torus, 1, {{"e", all}, {"h", tree}, {"c", dropped}},
             "the tree, what is dropped");
  trees.write(tree_file_name);
}

// --- the peeling of a disc ---

// A hexagon of the triangular lattice, four steps wide.
struct Hexagon
{
  std::vector<Place> places; // on the first panel
  internal::Rotation_system<std::uint32_t> surface;
  std::uint32_t number_of_inner_vertices = 0;
};

Hexagon hexagon()
{
  constexpr int radius = 4;
  using Cell = std::pair<int, int>;
  const Cell directions[] = {{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}};
  std::map<Cell, std::uint32_t> vertices;
  for (int q = -radius; q <= radius; ++q) // in the order of the map
    for (int r = -radius; r <= radius; ++r)
      if (std::abs(q + r) <= radius)
        vertices.emplace(Cell(q, r), std::uint32_t(vertices.size()));

  Hexagon result;
  result.surface.first.assign(1, 0);
  result.surface.on_boundary.assign(vertices.size(), false);
  result.places.resize(vertices.size());
  for (const auto& [cell, v] : vertices) {
    const auto [q, r] = cell;
    const auto neighbor = [&, q = q, r = r](std::size_t i) {
      return vertices.find(Cell(q + directions[i % 6].first, r + directions[i % 6].second));
    };
    result.places[v] = {123 + 24 * (q + 0.5 * r), 122 + 24 * 0.866 * r};
    // A list on the boundary starts behind the gap.
    std::size_t begin = 0;
    for (std::size_t i = 0; i < 6; ++i)
      if (neighbor(i) == vertices.end()) {
        result.surface.on_boundary[v] = true;
        if (neighbor(i + 1) != vertices.end())
          begin = i + 1;
      }
    for (std::size_t i = begin; i < begin + 6; ++i)
      if (neighbor(i) != vertices.end())
        result.surface.neighbor.push_back(neighbor(i)->second);
    result.surface.first.push_back(std::uint32_t(result.surface.neighbor.size()));
    result.number_of_inner_vertices += result.surface.on_boundary[v] ? 0 : 1;
  }
  return result;
}

Segments segments(const Hexagon& hexagon, const internal::Dart_marks& marks, double shift)
{
  Segments result;
  for (std::uint32_t v = 0; v < hexagon.surface.number_of_vertices(); ++v)
    for (std::uint32_t dart = hexagon.surface.first[v]; dart < hexagon.surface.first[v + 1]; ++dart)
      if (marks[dart]) {
        const Place p = hexagon.places[v], q = hexagon.places[hexagon.surface.neighbor[dart]];
        result.push_back({{p.x + shift, p.y}, {q.x + shift, q.y}});
      }
  return result;
}

void draw_peeling(const std::string& file_name)
{
  Hexagon disc = hexagon();
  const internal::Dart_marks all = all_edges(disc.surface);
  internal::Dart_marks subgraph(disc.surface.number_of_darts(), false);
  internal::Opened_surface<std::uint32_t> opened(disc.surface);
  for (std::uint32_t v = 0; v < disc.surface.number_of_vertices(); ++v)
    if (disc.surface.on_boundary[v]) {
      opened.rim.push_back(v);
      subgraph[disc.surface.first[v]] = true; // once around
    }
  internal::Peel_discs<std::uint32_t> peeling(opened, subgraph);
  peeling.start(disc.number_of_inner_vertices);

  Svg svg(720, 276, style);
  const char* const words[] = {"the rim, before the first step", "after 5 steps",
                               "no vertex is inside"};
  for (int panel = 0; panel < 3; ++panel) {
    const double shift = 237 * panel;
    svg.lines("e", segments(disc, all, shift));
    svg.lines("h", segments(disc, subgraph, shift));
    for (std::uint32_t v = 0; v < disc.surface.number_of_vertices(); ++v)
      if (peeling.is_on_cycle(v))
        svg.circle("z", {disc.places[v].x + shift, disc.places[v].y}, 3.4);
    svg.text("", {123 + shift, 262}, words[panel]);
    for (int steps = panel == 0 ? 5 : 1000; steps > 0 && peeling.peel_next(); --steps) {
    }
  }
  svg.write(file_name);
}

// --- a tree of the stacked K_7 ---

// The torus as the plane in which vertices x + 3y modulo 7 are the same: a window on it.
constexpr double unit = 62, window_width = 483, window_height = 270;

Place in_window(double x, double y)
{
  return {unit * (x + 0.5 * y) - 100, window_height - unit * 0.866 * y + 12};
}

// Where the vertices of the complete graph and those in the triangles are, in and near the window.
std::map<std::size_t, std::vector<Place>> places_of(const triangle_lists::Triangle_list& stacked)
{
  std::map<std::array<std::size_t, 3>, std::size_t> apex;
  for (std::size_t t = 0; t < stacked.triangles.size(); t += 3) {
    const auto& first = stacked.triangles[t];
    const auto& second = stacked.triangles[t + 1];
    std::array<std::size_t, 3> corners = {std::size_t(first[0]), std::size_t(first[1]),
                                          std::size_t(second[1])};
    std::sort(corners.begin(), corners.end());
    apex[corners] = std::size_t(first[2]);
  }
  const auto number = [](int x, int y) { return std::size_t(((x + 3 * y) % 7 + 7) % 7); };
  std::map<std::size_t, std::vector<Place>> places;
  for (int y = -2; y < 8; ++y)
    for (int x = -6; x < 12; ++x) {
      places[number(x, y)].push_back(in_window(x, y));
      std::array<std::size_t, 3> up = {number(x, y), number(x + 1, y), number(x, y + 1)};
      std::array<std::size_t, 3> down = {number(x + 1, y), number(x, y + 1), number(x + 1, y + 1)};
      std::sort(up.begin(), up.end());
      std::sort(down.begin(), down.end());
      places[apex.at(up)].push_back(in_window(x + 1 / 3., y + 1 / 3.));
      places[apex.at(down)].push_back(in_window(x + 2 / 3., y + 2 / 3.));
    }
  return places;
}

// Every copy of an edge: between copies of its ends that are as near as neighbours are.
template <class Edges>
Segments copies_of(const Edges& edges, const std::map<std::size_t, std::vector<Place>>& places)
{
  const auto is_near_window = [](Place p) {
    return p.x > -unit && p.x < window_width + unit && p.y > -unit && p.y < window_height + unit;
  };
  Segments result;
  for (const auto& [u, v] : edges)
    for (const Place& p : places.at(u))
      for (const Place& q : places.at(v))
        if (is_near_window(p) && std::hypot(p.x - q.x, p.y - q.y) < 1.01 * unit)
          result.push_back({p, q});
  return result;
}

void draw_stacked(const std::string& file_name)
{
  const triangle_lists::Triangle_list stacked = triangle_lists::stacked_complete_graph(7);
  const auto places = places_of(stacked);
  std::vector<std::pair<std::size_t, std::size_t>> edges, tree;
  for (const auto& t : stacked.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      edges.emplace_back(std::minmax(std::size_t(t[k]), std::size_t(t[(k + 1) % 3])));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  CGAL::near_minimum_degree_spanning_tree(
      CGAL::surface_of(std::size_t(stacked.n), stacked.triangles), std::back_inserter(tree));

  Svg svg(int(window_width), int(window_height), style);
  svg.begin_clip("window", {0, 0}, window_width, window_height);
  svg.lines("e", copies_of(edges, places));
  svg.lines("h", copies_of(tree, places));
  for (const auto& [v, copies] : places)
    for (const Place& p : copies)
      if (p.x > -9 && p.x < window_width + 9 && p.y > -9 && p.y < window_height + 9) {
        svg.circle("v", p, v < 7 ? 9 : 2.5);
        if (v < 7)
          svg.text("", {p.x, p.y + 5}, std::to_string(v));
      }
  svg.end_clip();
  svg.write(file_name);
}

} // namespace

int main(int argc, char** argv)
try {
  if (argc != 2)
    throw std::invalid_argument("usage: draw_subgraph FOLDER");
  const std::string folder = argv[1];
  draw_torus(folder + "/subgraph_cut.svg", folder + "/subgraph_tree.svg");
  draw_peeling(folder + "/subgraph_peel.svg");
  draw_stacked(folder + "/stacked_k7.svg");
} catch (const std::exception& e) {
  std::cerr << "draw_subgraph: " << e.what() << "\n";
  return EXIT_FAILURE;
}
