// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures locally uniform subsets: the degrees of the surface Delaunay triangulation and of D(S)
// on samples as they are and thinned; and what nested subsets are worth as rounds of insertion, by
// cells destroyed, beside nets of the surface and random rounds. Only counts. Writes JSON.

#include <Delaunay_from_surface_3_comparison/counts.h>
#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_comparison/read_command_line.h>
#include <Delaunay_from_surface_3_comparison/write_measured.h>
#include <Delaunay_from_surface_3_uniform/Hilbert_sorted_nets.h>
#include <Delaunay_from_surface_3_uniform/Uniform_rounds.h>
#include <Delaunay_from_surface_3_uniform/locally_uniform_subset.h>
#include <Delaunay_from_surface_3_uniform/samples.h>
#include <Delaunay_from_surface_3_uniform/surface_degrees.h>

#include <Delaunay_from_surface_3_surfaces/cad.h>
#include <Delaunay_from_surface_3_surfaces/genus_surface.h>
#include <Delaunay_from_surface_3_surfaces/io.h>
#include <Delaunay_from_surface_3_surfaces/parametric.h>
#include <Delaunay_from_surface_3_surfaces/simplify.h>
#include <Delaunay_from_surface_3_surfaces/sphere.h>

#include <CGAL/Delaunay_from_surface_3/paper/Surface_net_rounds.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/insert_points_3.h>

#include <boost/program_options.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace po = boost::program_options;
namespace DFS = CGAL::Delaunay_from_surface_3;
using comparison::Json;
using comparison::rounded;
using surfaces::Indexed_surface;
using Point = Indexed_surface::Point_3;
using Triangulation = CGAL::Delaunay_triangulation_3<CGAL::Epick>;

constexpr std::uint64_t seed = 2024;

Json degrees_json(const uniform::Surface_degrees& found)
{
  return {{"points", found.points},
          {"surface_vertices", found.surface.vertices},
          {"euler_characteristic", found.euler_characteristic},
          {"surface_largest_degree", found.surface.largest},
          {"surface_mean_degree", rounded(found.surface.mean, 1e2)},
          {"largest_ratio_of_edges", rounded(found.largest_ratio_of_edges, 1e1)},
          {"delaunay_largest_degree", found.delaunay.largest},
          {"delaunay_mean_degree", rounded(found.delaunay.mean, 1e2)}};
}

Json measure_sample(const uniform::Sample& sample, const std::vector<double>& factors)
{
  const surfaces::Oval_torus_chain shape = uniform::shape_of_samples();
  Json result = {{"sample", sample.name},
                 {"all", degrees_json(uniform::surface_degrees(sample.points, shape))},
                 {"subsets", Json::array()}};
  const std::vector<double> spacing = uniform::neighbor_spacing(sample.points);
  for (const double factor : factors) {
    std::vector<double> sizes = spacing;
    for (double& size : sizes)
      size *= factor;
    std::vector<Point> points;
    for (const std::size_t i : uniform::locally_uniform_subset(sample.points, std::move(sizes)))
      points.push_back(sample.points[i]);
    Json subset = degrees_json(uniform::surface_degrees(points, shape));
    subset["factor"] = factor;
    result["subsets"].push_back(std::move(subset));
  }
  return result;
}

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
      uniform::Uniform_rounds()(surface.points, CGAL::Epick(), 0, 0).round_ends;
  return {{"surface", name},
          {"points", surface.points.size()},
          {"rounds", ends.size()},
          {"nets", destroyed(surface, With_plan<DFS::Surface_net_rounds>())},
          {"sorted_nets", destroyed(surface, With_plan<uniform::Hilbert_sorted_nets>())},
          {"uniform", destroyed(surface, With_plan<uniform::Uniform_rounds>())},
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

struct Options
{
  std::vector<std::size_t> sizes = {15000, 60000};
  std::vector<double> factors = {0.25, 1, 2};
  std::size_t levels_size = 40000;
  std::string data_dir = ".", output = "uniform_samples.json";
};

Options read_options(int argc, char** argv)
{
  Options o;
  po::options_description options("Measures locally uniform subsets, by degrees and as rounds of "
                                  "insertion.\n\nOptions");
  auto add = options.add_options();
  add("help,h", "say this and stop");
  add("sizes", po::value(&o.sizes)->multitoken()->value_name("N..."),
      "numbers of points of samples");
  add("factors", po::value(&o.factors)->multitoken()->value_name("F..."), "of the spacing");
  add("levels-size", po::value(&o.levels_size)->value_name("N"),
      "number of points of the surfaces that are inserted");
  add("data-dir", po::value(&o.data_dir)->value_name("DIR"), "holds bunny00.off and armadillo.off");
  add("output,o", po::value(&o.output)->value_name("FILE"), "where the JSON goes");
  comparison::read_command_line(argc, argv, options);
  return o;
}

void measure_into(const Options& options, Json& report)
{
  report["samples"] = report["levels"] = Json::array();
  for (const std::size_t n : options.sizes)
    for (const uniform::Sample& sample : uniform::samples(n, seed)) {
      report["samples"].push_back(measure_sample(sample, options.factors));
      std::cerr << report["samples"].back().dump() << "\n";
    }
  for (const auto& [name, surface] : surfaces_of_levels(options.levels_size, options.data_dir)) {
    report["levels"].push_back(measure_levels(name, surface));
    std::cerr << report["levels"].back().dump() << "\n";
  }
}

} // namespace

int main(int argc, char** argv)
{
  return comparison::write_measured("measure_uniform_samples", argc, argv, read_options,
                                    measure_into);
}
