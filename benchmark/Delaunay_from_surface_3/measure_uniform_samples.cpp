// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures locally uniform subsets: the degrees of the surface Delaunay triangulation and of D(S)
// on samples as they are and thinned; and what nested subsets are worth as rounds of insertion, by
// cells destroyed, beside nets of the surface and random rounds. Only counts. Writes JSON.

#include <Delaunay_from_surface_3_comparison/counts.h>
#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_comparison/run_program.h>
#include <Delaunay_from_surface_3_uniform/locally_uniform_subset.h>

#include <Delaunay_from_surface_3_surfaces/cad.h>
#include <Delaunay_from_surface_3_surfaces/genus_surface.h>
#include <Delaunay_from_surface_3_surfaces/io.h>
#include <Delaunay_from_surface_3_surfaces/parametric.h>
#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/restricted_delaunay.h>
#include <Delaunay_from_surface_3_surfaces/refine.h>

#include <Delaunay_from_surface_3_meters/Surface_net_rounds.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/insert_points_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace DFS = CGAL::Delaunay_from_surface_3;
using comparison::Json;
using comparison::rounded;
using surfaces::Indexed_surface;
using Point = Indexed_surface::Point_3;
using Triangulation = CGAL::Delaunay_triangulation_3<CGAL::Epick>;

constexpr std::uint64_t seed = 2024;

// --- Points on one smooth surface, spread in ways that are not locally uniform ------------------

using Vector = Indexed_surface::Vector_3;

struct Sample
{
  std::string name;
  std::vector<Point> points;
};

// Three joined tori with oval tubes, of genus 3.
surfaces::Oval_torus_chain shape_of_samples()
{
  return surfaces::Oval_torus_chain(3);
}

// The point of the surface that Newton's method finds from p, in the plane of p's x if `in_plane`.
template <class Shape>
std::optional<Point> on_surface(const Shape& shape, Point p, bool in_plane)
{
  constexpr double h = 1e-5;
  for (int step = 0; step < 20; ++step) {
    const double f = shape(p);
    if (std::abs(f) < 1e-12)
      return p;
    const auto slope = [&](const Vector& v) { return (shape(p + v) - shape(p - v)) / (2 * h); };
    const Vector gradient(in_plane ? 0 : slope({h, 0, 0}), slope({0, h, 0}), slope({0, 0, h}));
    if (gradient.squared_length() < 0.04) // nearly tangent to the plane
      return std::nullopt;
    p = p - f / gradient.squared_length() * gradient;
  }
  return std::nullopt;
}

// Random points in a thin shell around the surface, moved by `place` and then onto the surface;
// `place` may refuse them.
template <class Place>
std::vector<Point> points_on_surface(std::size_t n, std::uint64_t seed, bool in_plane,
                                     const Place& place)
{
  const surfaces::Oval_torus_chain shape = shape_of_samples();
  surfaces::Random random(seed);
  std::vector<Point> points;
  while (points.size() < n) {
    const double x = random.uniform(-3.4, 3.4), y = random.uniform(-1.7, 1.7);
    const Point in_box(x, y, random.uniform(-0.7, 0.7));
    if (std::abs(shape(in_box)) > 0.02)
      continue;
    if (const std::optional<Point> p = place(in_box, random))
      if (const std::optional<Point> q = on_surface(shape, *p, in_plane))
        points.push_back(*q);
  }
  return points;
}

// Samples of n points each.
std::vector<Sample> samples(std::size_t n, std::uint64_t seed)
{
  using Maybe = std::optional<Point>;
  const auto anywhere = [](const Point& p, surfaces::Random&) { return Maybe(p); };
  // Thirty times as dense at one end as at the other.
  const auto denser_at_one_end = [](const Point& p, surfaces::Random& random) {
    return random.uniform(0, 1) < std::pow(30, -(p.x() + 3.4) / 6.8) ? Maybe(p) : std::nullopt;
  };
  // On curves in parallel planes, on which the points are ten times as near to each other as the
  // planes are: the area is about 80, and 6.8 / step curves have a length of 80 / 6.8 each.
  const double step = std::sqrt(10 * 80 / double(n));
  const auto on_curves = [step](const Point& p, surfaces::Random&) {
    return Maybe(Point(step * std::round(p.x() / step), p.y(), p.z()));
  };
  return {{"at random", points_on_surface(n, seed, false, anywhere)},
          {"denser at one end", points_on_surface(n, seed, false, denser_at_one_end)},
          {"on curves", points_on_surface(n, seed, true, on_curves)}};
}

// --- Degrees in D(S), and in the surface Delaunay triangulation: the triangles of D(S) whose Voronoi
// edges end on either side of the surface --------------------------------------------------------

struct Degrees
{
  std::size_t vertices = 0; // with an edge
  std::size_t largest = 0;
  double mean = 0;
};

using Edges = std::vector<std::pair<std::size_t, std::size_t>>;

Degrees degrees_of(const Edges& edges, std::size_t n)
{
  std::vector<std::size_t> degree(n, 0);
  for (const auto& [i, j] : edges)
    ++degree[i], ++degree[j];
  const std::size_t vertices =
      n - std::size_t(std::count(degree.begin(), degree.end(), std::size_t(0)));
  return {vertices, *std::max_element(degree.begin(), degree.end()),
          2 * double(edges.size()) / double(vertices)};
}

// At each vertex the longest edge is divided by the shortest.
double largest_ratio(const Edges& edges, const std::vector<Point>& points)
{
  std::vector<double> longest(points.size(), 0), shortest(points.size(), 1e300);
  for (const auto& [i, j] : edges)
    for (const std::size_t k : {i, j}) {
      const double d = CGAL::squared_distance(points[i], points[j]);
      longest[k] = (std::max)(longest[k], d);
      shortest[k] = (std::min)(shortest[k], d);
    }
  double ratio = 0;
  for (std::size_t k = 0; k < points.size(); ++k)
    ratio = (std::max)(ratio, longest[k] / shortest[k]);
  return std::sqrt(ratio);
}

void sort_and_unite(Edges& edges)
{
  for (auto& [i, j] : edges)
    if (j < i)
      std::swap(i, j);
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
}

// `shape` is negative inside.
Json surface_degrees(const std::vector<Point>& points, const surfaces::Oval_torus_chain& shape)
{
  using Kernel = CGAL::Epick;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_3<std::size_t, Kernel>;
  using Cell_base =
      CGAL::Triangulation_cell_base_with_info_3<bool, Kernel,
                                                CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
  using Tr =
      CGAL::Delaunay_triangulation_3<Kernel,
                                     CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base>>;
  std::vector<std::pair<Point, std::size_t>> numbered;
  for (const Point& p : points)
    numbered.emplace_back(p, numbered.size());
  Tr tr;
  CGAL::insert_points_3(tr, numbered);
  for (const auto c : tr.all_cell_handles())
    c->info() = !tr.is_infinite(c) && shape(tr.dual(c)) < 0;

  Edges surface, delaunay;
  std::size_t triangles = 0;
  for (const auto& [c, i] : tr.finite_facets())
    if (c->info() != c->neighbor(i)->info()) {
      ++triangles;
      for (int k = 0; k < 3; ++k)
        surface.emplace_back(c->vertex(Tr::vertex_triple_index(i, k))->info(),
                             c->vertex(Tr::vertex_triple_index(i, (k + 1) % 3))->info());
    }
  sort_and_unite(surface);
  for (const auto& e : tr.finite_edges())
    delaunay.emplace_back(e.first->vertex(e.second)->info(), e.first->vertex(e.third)->info());

  const Degrees of_surface = degrees_of(surface, points.size()),
                of_delaunay = degrees_of(delaunay, points.size());
  const auto euler_characteristic =
      std::ptrdiff_t(of_surface.vertices + triangles) - std::ptrdiff_t(surface.size());
  return {{"points", points.size()},
          {"surface_vertices", of_surface.vertices},
          {"euler_characteristic", euler_characteristic},
          {"surface_largest_degree", of_surface.largest},
          {"surface_mean_degree", rounded(of_surface.mean, 1e2)},
          {"largest_ratio_of_edges", rounded(largest_ratio(surface, points), 1e1)},
          {"delaunay_largest_degree", of_delaunay.largest},
          {"delaunay_mean_degree", rounded(of_delaunay.mean, 1e2)}};
}

Json measure_sample(const Sample& sample, const std::vector<double>& factors)
{
  const surfaces::Oval_torus_chain shape = shape_of_samples();
  Json result = {{"sample", sample.name},
                 {"all", surface_degrees(sample.points, shape)},
                 {"subsets", Json::array()}};
  const std::vector<double> spacing = uniform::neighbor_spacing(sample.points);
  for (const double factor : factors) {
    std::vector<double> sizes = spacing;
    for (double& size : sizes)
      size *= factor;
    std::vector<Point> points;
    for (const std::size_t i : uniform::locally_uniform_subset(sample.points, std::move(sizes)))
      points.push_back(sample.points[i]);
    Json subset = surface_degrees(points, shape);
    subset["factor"] = factor;
    result["subsets"].push_back(std::move(subset));
  }
  return result;
}

// --- Plans to be compared --------------------------------------------------------------------------

// The sets of points of Surface_net_rounds, in the order in which uniform samples come.
// The starting places of the nets belong to their order, and are dropped.
class Hilbert_sorted_nets
{
public:
  explicit Hilbert_sorted_nets(unsigned int seed = 0)
    : m_plan(seed)
  {
  }

  template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
  DFS::Insertion_order operator()(const std::vector<Point>& points, const GeomTraits& gt,
                                  const Graph& graph, VertexIndexMap index_map) const
  {
    auto plan = m_plan(points, gt, graph, index_map);
    DFS::internal::hilbert_sort_rounds(points, gt, plan, plan.round_ends.size());
    plan.starting_places.clear();
    return plan;
  }

private:
  DFS::Surface_net_rounds m_plan;
};

// Nested locally uniform subsets as rounds.
//
// A round is what the next subset leaves out of the one before. The factor of the spacing doubles
// from subset to subset, down to a few dozen points. Each round follows a Hilbert curve. Points of
// the same size come in random order, lest the subsets be as regular as the numbering.
class Uniform_rounds
{
public:
  explicit Uniform_rounds(unsigned int seed = 0)
    : m_seed(seed)
  {
  }

  template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
  DFS::Insertion_order operator()(const std::vector<Point>& points, const GeomTraits& gt,
                                  const Graph&, VertexIndexMap) const
  {
    using namespace DFS;
    const std::vector<double> spacing = uniform::neighbor_spacing(points);
    std::vector<std::size_t> left = internal::random_order(points.size(), m_seed);
    std::vector<std::vector<std::size_t>> rounds; // from the last to the first
    for (double factor = 1; left.size() > 64; factor *= 2) {
      auto [kept, left_out] = split(points, left, spacing, factor);
      if (!left_out.empty())
        rounds.push_back(std::move(left_out));
      left = std::move(kept);
    }
    if (!left.empty())
      rounds.push_back(std::move(left));

    Insertion_order plan;
    for (auto round = rounds.rbegin(); round != rounds.rend(); ++round) {
      plan.order.insert(plan.order.end(), round->begin(), round->end());
      plan.round_ends.push_back(plan.order.size());
    }
    internal::hilbert_sort_rounds(points, gt, plan, plan.round_ends.size());
    return plan;
  }

private:
  using Indices = std::vector<std::size_t>;

  // Those of `from` in the subset, and the others.
  template <class Point>
  static std::pair<Indices, Indices> split(const std::vector<Point>& points, const Indices& from,
                                           const std::vector<double>& spacing, double factor)
  {
    std::vector<Point> here;
    for (const std::size_t i : from)
      here.push_back(points[i]);
    std::vector<double> sizes;
    for (const std::size_t i : from)
      sizes.push_back(factor * spacing[i]);
    Indices kept, left_out;
    const Indices places = uniform::locally_uniform_subset(here, std::move(sizes));
    auto next = places.begin();
    for (std::size_t k = 0; k < from.size(); ++k) {
      const bool is_kept = next != places.end() && *next == k;
      (is_kept ? kept : left_out).push_back(from[k]);
      next += is_kept;
    }
    return {kept, left_out};
  }

  unsigned int m_seed;
};

// Each point is located from the one before it.
template <class Plan>
using With_plan = CGAL::Surface_insertion_policies_3<DFS::No_subgraph, Plan, DFS::Previous_hint_3>;

template <class Traits>
Json destroyed(const Indexed_surface& surface, const Traits& traits)
{
  Triangulation tr;
  comparison::Take_counts counts;
  CGAL::insert_points_3(tr, surface.points, surface.faces, traits,
                        CGAL::parameters::visitor(std::ref(counts)));
  return {{"cells_destroyed",
           rounded(double(counts.kernel.cells_destroyed) / double(surface.points.size()), 1e2)},
          {"order_was_replaced", counts.order_was_replaced}};
}

Json measure_levels(const std::string& name, const Indexed_surface& surface)
{
  const std::vector<std::size_t> ends =
      Uniform_rounds()(surface.points, CGAL::Epick(), 0, 0).round_ends;
  return {{"surface", name},
          {"points", surface.points.size()},
          {"rounds", ends.size()},
          {"nets", destroyed(surface, With_plan<DFS::Surface_net_rounds>())},
          {"sorted_nets", destroyed(surface, With_plan<Hilbert_sorted_nets>())},
          {"uniform", destroyed(surface, With_plan<Uniform_rounds>())},
          {"random_rounds", destroyed(surface, With_plan<DFS::Geometric_rounds>())}};
}

using Named_surface = std::pair<std::string, Indexed_surface>;

std::vector<Named_surface> surfaces_of_levels(std::size_t n, const std::string& data_dir)
{
  std::vector<Named_surface> all;
  for (const std::string name : {"bunny00", "armadillo"})
    all.emplace_back(name, surfaces::resized(surfaces::read_mesh(data_dir + "/" + name + ".off"), n,
                                             0.05, seed));
  all.emplace_back("genus 3", surfaces::genus_surface(3, n, 0.05, seed));
  all.emplace_back("sphere with noise", surfaces::sphere(n, 0.01, seed));
  all.emplace_back("grid torus", surfaces::grid_torus(n));
  all.emplace_back("terrain", surfaces::terrain(n, seed));
  for (const surfaces::Cad_family& family : surfaces::cad_families())
    all.emplace_back(family.name, family.make(n, seed, surfaces::Numbering(2))); // shuffled
  return all;
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<std::size_t> sizes = {15000, 60000};
  std::vector<double> factors = {0.25, 1, 2};
  std::size_t levels_size = 40000;
  std::string data_dir = ".";
  comparison::Program program(
      "measure_uniform_samples",
      "Measures locally uniform subsets, by degrees and as rounds of insertion.");
  program.option("sizes", sizes, "N...", "numbers of points of samples");
  program.option("factors", factors, "F...", "of the spacing");
  program.option("levels-size", levels_size, "N",
                 "number of points of the surfaces that are inserted");
  program.option("data-dir", data_dir, "DIR", "holds bunny00.off and armadillo.off");
  return program.run(argc, argv, [&](Json& report) {
    report["samples"] = report["levels"] = Json::array();
    for (const std::size_t n : sizes)
      for (const Sample& sample : samples(n, seed)) {
        report["samples"].push_back(measure_sample(sample, factors));
        std::cerr << report["samples"].back().dump() << "\n";
      }
    for (const auto& [name, surface] : surfaces_of_levels(levels_size, data_dir)) {
      report["levels"].push_back(measure_levels(name, surface));
      std::cerr << report["levels"].back().dump() << "\n";
    }
  });
}
