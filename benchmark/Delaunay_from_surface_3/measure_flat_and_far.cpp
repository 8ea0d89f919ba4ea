// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures the default beside plain CGAL where coordinates are of very different size, and where
// points span no space: with the faces, and the points alone. Times in turn, and which stages of
// the predicates decided. Writes JSON.

#include <Delaunay_from_surface_3_comparison/counts.h>
#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_comparison/run_program.h>
#include <Delaunay_from_surface_3_surfaces/adversarial.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/insert_points_3.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace DFS = CGAL::Delaunay_from_surface_3;
using comparison::Json;
using comparison::per_point;
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

Json measure_case(const surfaces::Flat_or_far_family& family, const Indexed_surface& surface,
                  bool has_faces, std::size_t repetitions)
{
  const std::size_t n = surface.points.size();
  comparison::Turns turns;
  for (std::size_t r = 0; r < repetitions; ++r) {
    Triangulation expected, tr;
    turns.add([&] { expected.insert(surface.points.begin(), surface.points.end()); },
              [&] { insert_by_default(tr, surface, has_faces); });
    if (r == 0 && !(tr == expected))
      throw std::runtime_error(family.name + ": not equal to plain CGAL");
  }
  Triangulation tr;
  comparison::Take_counts counts;
  insert_by_default(tr, surface, has_faces, CGAL::parameters::visitor(std::ref(counts)));
  std::array<std::size_t, DFS::NUMBER_OF_EXACT_STAGES> decided;
  for (std::size_t s = 0; s < decided.size(); ++s)
    decided[s] = counts.kernel.sphere_tests_by_stage[s] + counts.kernel.facet_tests_by_stage[s];
  Json result = {{"family", family.name},
                 {"kind", family.kind},
                 {"inserted", has_faces ? "faces" : "points"},
                 {"points", n}};
  turns.add_to(result, "default");
  result["cells_tested_to_start"] = per_point(counts.kernel.cells_tested_to_start, n, 1e2);
  result["decided_by"] = comparison::by_exact_stage(decided, n, 1e2);
  return result;
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<std::size_t> sizes = {5000, 20000, 100000};
  std::size_t repetitions = 3;
  comparison::Program program(
      "measure_flat_and_far",
      "Measures the default beside plain CGAL where coordinates are of very different size.");
  program.option("sizes", sizes, "N...", "numbers of vertices");
  program.option("repetitions,r", repetitions, "N", "of each, in turn");
  return program.run(argc, argv, [&](Json& report) {
    report["flat_and_far_repetitions"] = repetitions;
    report["results"] = Json::array();
    for (const std::size_t n : sizes)
      for (const surfaces::Flat_or_far_family& family : all_families()) {
        const Indexed_surface surface = family.make(n, seed);
        for (const bool has_faces : {true, false}) {
          report["results"].push_back(measure_case(family, surface, has_faces, repetitions));
          std::cerr << report["results"].back().dump() << "\n";
        }
      }
  });
}
