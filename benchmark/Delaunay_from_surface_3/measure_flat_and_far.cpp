// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures the default beside plain CGAL where coordinates are of very different size, and where
// points span no space: with the faces, and the points alone. Times in turn, and which stages of
// the predicates decided. Writes JSON.

#include <Delaunay_from_surface_3_comparison/counts.h>
#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_comparison/read_command_line.h>
#include <Delaunay_from_surface_3_comparison/write_measured.h>
#include <Delaunay_from_surface_3_surfaces/degenerate.h>
#include <Delaunay_from_surface_3_surfaces/flat_and_far.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/insert_points_3.h>

#include <boost/program_options.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace po = boost::program_options;
namespace DFS = CGAL::Delaunay_from_surface_3;
using comparison::Json;
using comparison::rounded;
using surfaces::Indexed_surface;
using Triangulation = CGAL::Delaunay_triangulation_3<CGAL::Epick>;

constexpr std::uint64_t seed = 2024;

std::vector<surfaces::Flat_or_far_family> all_families()
{
  std::vector<surfaces::Flat_or_far_family> families = surfaces::flat_and_far_families();
  families.push_back({"all points equal", "",
                      [](std::size_t n, std::uint64_t) { return surfaces::all_equal(n); }});
  families.push_back(
      {"collinear", "", [](std::size_t n, std::uint64_t) { return surfaces::collinear(n); }});
  families.push_back({"coplanar", "square lattice",
                      [](std::size_t n, std::uint64_t) { return surfaces::coplanar(n); }});
  return families;
}

template <class... Parameters>
void insert_by_default(Triangulation& tr, const Indexed_surface& surface, bool has_faces,
                       const Parameters&... parameters)
{
  if (has_faces)
    CGAL::insert_points_3(tr, surface.points, surface.faces, parameters...);
  else
    CGAL::insert_points_3(tr, surface.points, parameters...);
}

Json stages(const comparison::Take_counts& counts, std::size_t n)
{
  static const char* const names[] = {"half_digit",    "one_digit",  "balanced",
                                      "double_double", "two_digits", "any_width"};
  Json json;
  for (int s = 0; s < DFS::NUMBER_OF_EXACT_STAGES; ++s)
    json[names[s]] = rounded(
        double(counts.kernel.sphere_tests_by_stage[s] + counts.kernel.facet_tests_by_stage[s]) /
            double(n),
        1e2);
  return json;
}

Json measure_case(const surfaces::Flat_or_far_family& family, const Indexed_surface& surface,
                  bool has_faces, std::size_t repetitions)
{
  const std::size_t n = surface.points.size();
  std::vector<double> ratios, plain, by_default;
  for (std::size_t r = 0; r < repetitions; ++r) {
    Triangulation expected, tr;
    plain.push_back(comparison::time_of([&] {
                      expected.insert(surface.points.begin(), surface.points.end());
                    }).cpu);
    by_default.push_back(
        comparison::time_of([&] { insert_by_default(tr, surface, has_faces); }).cpu);
    ratios.push_back(plain.back() / by_default.back());
    if (r == 0 && !(tr == expected))
      throw std::runtime_error(family.name + ": not equal to plain CGAL");
  }
  Triangulation tr;
  comparison::Take_counts counts;
  insert_by_default(tr, surface, has_faces, CGAL::parameters::visitor(std::ref(counts)));
  return {{"family", family.name},
          {"kind", family.kind},
          {"inserted", has_faces ? "faces" : "points"},
          {"points", n},
          {"median_plain_cpu", rounded(comparison::median(plain))},
          {"median_default_cpu", rounded(comparison::median(by_default))},
          {"median_ratio", rounded(comparison::median(ratios), 1e3)},
          {"cells_tested_to_start",
           rounded(double(counts.kernel.cells_tested_to_start) / double(n), 1e2)},
          {"decided_by", stages(counts, n)}};
}

struct Options
{
  std::vector<std::size_t> sizes = {5000, 20000, 100000};
  std::size_t repetitions = 3;
  std::string output = "flat_and_far.json";
};

Options read_options(int argc, char** argv)
{
  Options o;
  po::options_description options("Measures the default beside plain CGAL where coordinates are of "
                                  "very different size.\n\nOptions");
  auto add = options.add_options();
  add("help,h", "say this and stop");
  add("sizes", po::value(&o.sizes)->multitoken()->value_name("N..."), "numbers of vertices");
  add("repetitions,r", po::value(&o.repetitions)->value_name("N"), "of each, in turn");
  add("output,o", po::value(&o.output)->value_name("FILE"), "where the JSON goes");
  comparison::read_command_line(argc, argv, options);
  return o;
}

void measure_into(const Options& options, Json& report)
{
  report["flat_and_far_repetitions"] = options.repetitions;
  report["results"] = Json::array();
  for (const std::size_t n : options.sizes)
    for (const surfaces::Flat_or_far_family& family : all_families()) {
      const Indexed_surface surface = family.make(n, seed);
      for (const bool has_faces : {true, false}) {
        Json result = measure_case(family, surface, has_faces, options.repetitions);
        std::cerr << result.dump() << "\n";
        report["results"].push_back(std::move(result));
      }
    }
}

} // namespace

int main(int argc, char** argv)
{
  return comparison::write_measured("measure_flat_and_far", argc, argv, read_options, measure_into);
}
