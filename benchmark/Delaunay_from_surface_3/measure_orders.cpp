// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures how the default keeps up with plain CGAL where an order of insertion can go wrong:
// solids as CAD makes them, in three numberings and with coordinates rounded in four ways, and
// surfaces that are degenerate, wrong or of quadratic size; or where walks can go astray. Times in
// turn, and counts. Or only counts, beside those of nets of the surface. Writes JSON.

#include <Delaunay_from_surface_3_comparison/counts.h>
#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_comparison/run_program.h>
#include <Delaunay_from_surface_3_comparison/surfaces.h>
#include <Delaunay_from_surface_3_surfaces/adversarial.h>
#include <Delaunay_from_surface_3_surfaces/cad.h>
#include <Delaunay_from_surface_3_surfaces/edit.h>
#include <Delaunay_from_surface_3_surfaces/genus_surface.h>
#include <Delaunay_from_surface_3_surfaces/io.h>
#include <Delaunay_from_surface_3_surfaces/lattice_surface.h>
#include <Delaunay_from_surface_3_surfaces/parametric.h>
#include <Delaunay_from_surface_3_surfaces/refine.h>

#include <Delaunay_from_surface_3_meters/Surface_net_rounds.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/insert_points_3.h>
#include <CGAL/insert_surface_vertices_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace DFS = CGAL::Delaunay_from_surface_3;
using comparison::Json;
using comparison::per_point;
using comparison::rounded;
using surfaces::Indexed_surface;
using Triangulation = CGAL::Delaunay_triangulation_3<CGAL::Epick>;
using Mesh = CGAL::Surface_mesh<Indexed_surface::Point_3>;

constexpr std::uint64_t seed = 2024;

struct Case
{
  std::string family, kind, coordinates;
  Indexed_surface surface;
};

const std::vector<std::string> roundings = {"as computed", "float", "3 decimals", "6 decimals"};

void round_coordinates(Indexed_surface& surface, std::size_t way)
{
  if (way == 1)
    surfaces::round_to_float(surface);
  if (way >= 2)
    surfaces::round_to_decimals(surface, way == 2 ? 3 : 6);
}

using Measure = std::function<void(const Case&)>;

void for_cad_solids(std::size_t n, const Measure& measure)
{
  const std::vector<std::string> numberings = {"by profile", "by ring", "shuffled"};
  std::size_t way = 0;
  for (const surfaces::Cad_family& family : surfaces::cad_families())
    for (std::size_t k = 0; k < numberings.size(); ++k, ++way) {
      Indexed_surface surface = family.make(n, seed, surfaces::Numbering(k));
      round_coordinates(surface, way % roundings.size());
      measure({family.name, numberings[k], roundings[way % roundings.size()], surface});
    }
}

void for_other_surfaces(std::size_t n, const Measure& measure)
{
  const auto computed = roundings[0];
  measure({"genus 3", "", computed, surfaces::genus_surface(3, n, 0.05, seed)});
  measure({"sphere with noise", "", computed, surfaces::sphere(n, 0.01, seed)});
  measure({"grid torus", "", computed, surfaces::grid_torus(n)});
  measure({"terrain", "", computed, surfaces::terrain(n, seed)});
  measure({"thin plate", "", computed, surfaces::thin_plate(n, 0.01)});
  if (n <= 20000) // to find more such points takes too long
    measure({"sphere, exactly", "integers", computed, surfaces::integer_sphere(n)});
  measure({"nearly flat", "noise of 1e-12", computed, surfaces::nearly_flat(n, 1e-12, seed)});
  measure({"star", "hub is vertex 0", computed, surfaces::star(n, seed)});
  measure({"faces at random", "", computed, surfaces::faces_at_random(n, seed)});
  if (n <= 3000) // its triangulation has n^2/4 cells
    measure({"two lines", "quadratic", computed, surfaces::two_lines(n)});
}

// As a mesh where it is one, else as a soup; as points where there are no faces.
class Insertion
{
public:
  explicit Insertion(const Indexed_surface& surface)
    : m_surface(surface)
  {
    namespace PMP = CGAL::Polygon_mesh_processing;
    m_is_mesh = !surface.faces.empty() && PMP::is_polygon_soup_a_polygon_mesh(surface.faces);
    if (m_is_mesh)
      m_mesh = surfaces::to_mesh<Mesh>(surface);
  }

  void by_default(Triangulation& tr, comparison::Take_counts& counts) const
  {
    if (m_surface.faces.empty())
      CGAL::insert_points_3(tr, m_surface.points, CGAL::parameters::visitor(std::ref(counts)));
    else
      with(CGAL::Surface_insertion_traits_3(), tr, counts);
  }

  template <class Traits>
  void with(const Traits& traits, Triangulation& tr, comparison::Take_counts& counts) const
  {
    const auto np = CGAL::parameters::visitor(std::ref(counts));
    if (m_is_mesh)
      CGAL::insert_surface_vertices_3(tr, m_mesh, traits, np);
    else
      CGAL::insert_points_3(tr, m_surface.points, m_surface.faces, traits, np);
  }

  void by_plain_cgal(Triangulation& tr) const
  {
    tr.insert(m_surface.points.begin(), m_surface.points.end());
  }

private:
  const Indexed_surface& m_surface;
  Mesh m_mesh;
  bool m_is_mesh;
};

// Of the sorted values, the largest that lies below their true median in 95 of 100 cases, by the
// binomial distribution; the smallest if there are fewer than five.
double lower_limit(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  double share = 0, binomial = std::pow(0.5, double(values.size()));
  std::size_t k = 0;
  for (; k < values.size() && share + binomial <= 0.05; ++k) {
    share += binomial;
    binomial *= double(values.size() - k) / double(k + 1);
  }
  return values[k == 0 ? 0 : k - 1];
}

Json description_of(const Case& c)
{
  return {{"family", c.family},
          {"kind", c.kind},
          {"coordinates", c.coordinates},
          {"points", c.surface.points.size()}};
}

Json as_json(const comparison::Take_counts& counts, std::size_t n)
{
  return {{"cells_destroyed", per_point(counts.kernel.cells_destroyed, n, 1e2)},
          {"cells_tested_to_start", per_point(counts.kernel.cells_tested_to_start, n, 1e2)},
          {"order_was_replaced", counts.order_was_replaced}};
}

Json measure_case(const Case& c, std::size_t repetitions)
{
  const Insertion insertion(c.surface);
  comparison::Turns turns;
  comparison::Take_counts counts;
  for (std::size_t r = 0; r < repetitions; ++r) {
    Triangulation expected, tr;
    turns.add([&] { insertion.by_plain_cgal(expected); },
              [&] { insertion.by_default(tr, counts); });
    if (r == 0 && !(tr == expected))
      throw std::runtime_error(c.family + ": not equal to plain CGAL");
  }
  Json result = description_of(c);
  turns.add_to(result, "default");
  result["lower_limit_of_ratio"] = rounded(lower_limit(turns.ratios), 1e3);
  result.update(as_json(counts, c.surface.points.size()));
  return result;
}

// Nets of the surface in blocks of another size; see Surface_net_rounds.
struct Nets_in_blocks
  : CGAL::Surface_insertion_policies_3<DFS::No_subgraph, DFS::Surface_net_rounds,
                                       DFS::Planned_hints_3>
{
  std::size_t block = 1;
  Insertion_plan insertion_plan_object(unsigned int seed) const
  {
    return Insertion_plan(seed, block);
  }
};

Json count_case(const Case& c, const std::vector<std::size_t>& blocks)
{
  const Insertion insertion(c.surface);
  const auto counts_of = [&](const auto& traits) {
    Triangulation tr;
    comparison::Take_counts counts;
    insertion.with(traits, tr, counts);
    return as_json(counts, c.surface.points.size());
  };
  Json result = description_of(c);
  result["nets"] = Json::array();
  for (const std::size_t block : blocks) {
    Nets_in_blocks traits;
    traits.block = block;
    result["nets"].push_back(counts_of(traits));
  }
  result["spaced_rounds"] = counts_of(CGAL::Surface_insertion_traits_3());
  return result;
}

struct Options
{
  std::vector<std::size_t> sizes = {3000, 20000, 200000};
  std::size_t repetitions = 9;
  std::vector<std::size_t> blocks;
  std::string scan;
  bool walks = false;
};

void measure_into(const Options& options, Json& report)
{
  if (options.blocks.empty())
    report["repetitions"] = options.repetitions;
  else
    report["blocks"] = options.blocks;
  report["walks"] = options.walks;
  report["results"] = Json::array();
  const Measure measure = [&](const Case& c) {
    Json result = options.blocks.empty() ? measure_case(c, options.repetitions)
                                         : count_case(c, options.blocks);
    std::cerr << result.dump() << "\n";
    report["results"].push_back(std::move(result));
  };
  for (const std::size_t n : options.sizes) {
    if (options.walks) {
      comparison::for_walk_cases(
          n, seed, [&](const char* family, const std::string& kind, Indexed_surface surface) {
            measure({family, kind, roundings[0], std::move(surface)});
          });
      continue;
    }
    for_cad_solids(n, measure);
    for_other_surfaces(n, measure);
    if (!options.scan.empty())
      measure({"scan", "refined", roundings[0],
               surfaces::densified(surfaces::read_mesh(options.scan), n, 0.05, seed)});
  }
}

} // namespace

int main(int argc, char** argv)
{
  Options o;
  comparison::Program program(
      "measure_orders",
      "Measures the default beside plain CGAL where an order of insertion can go wrong.");
  program.option("sizes", o.sizes, "N...", "numbers of vertices");
  program.option("repetitions,r", o.repetitions, "N", "of each, in turn");
  program.option("blocks", o.blocks, "N...",
                 "count only, with nets in blocks of so many vertices (1: by index)");
  program.option("walks", o.walks,
                 "where walks can go astray, in place of solids and other surfaces");
  program.option("scan", o.scan, "FILE", "a mesh that is refined to these sizes, too");
  return program.run(argc, argv, [&](Json& report) { measure_into(o, report); });
}
