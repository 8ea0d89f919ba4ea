// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The claims of Choi 2002, measured: what it costs to locate a point, by history and by walk, from
// the last trace and from elsewhere; how many triangles a trace crosses; what becomes of it when T
// is not Delaunay; the total work of the paper's Q; and that of walks, in random rounds and sorted.

#include <Delaunay_from_surface_3_comparison/counts.h>
#include <Delaunay_from_surface_3_comparison/run_program.h>
#include <Delaunay_from_surface_3_comparison/surfaces.h>
#include <Delaunay_from_surface_3_surfaces/adversarial.h>
#include <Delaunay_from_surface_3_surfaces/delaunay_marching_cubes.h>
#include <Delaunay_from_surface_3_surfaces/genus_surface.h>
#include <Delaunay_from_surface_3_surfaces/io.h>
#include <Delaunay_from_surface_3_surfaces/edit.h>
#include <Delaunay_from_surface_3_surfaces/marching_cubes.h>
#include <Delaunay_from_surface_3_surfaces/restricted_delaunay.h>
#include <Delaunay_from_surface_3_surfaces/refine.h>
#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_theory/laboratory.h>

#include <Delaunay_from_surface_3_meters/meters.h>
#include <Delaunay_from_surface_3_meters/orders.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/Tracing_traits_3.h>
#include <CGAL/euclidean_minimum_spanning_tree_3.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <functional>
#include <future>
#include <iostream>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace theory;
using comparison::Mesh;
using comparison::per_point;
using comparison::Phase;

const char* const introduction =
    R"(Measures what it costs to locate points while a surface is inserted in the order of the paper.

  location_costs --data-dir meshes --cache-dir surfaces --output location_costs.json)";

struct Options
{
  std::vector<std::string> surfaces;
  std::vector<std::size_t> sizes, subgraph_sizes, work_sizes;
  std::size_t hypothesis_size = 32768, threads = 1, seeds = 5;
  std::string data_dir, cache_dir;
  unsigned int seed = 0;
  bool rounds = false;
};

// --- The surfaces on which the theory is measured, by name ------------------------------------------

struct Theory_surface
{
  std::string name;
  std::string description;
  bool meets_assumptions;   // all triangles Delaunay, and D(S) of linear size as far as can be seen
  std::size_t largest_size; // up to which it is measured
  std::function<Indexed_surface(std::size_t n)> make;
  std::size_t least_size = 0;
};

// `data_dir` holds bunny00.off and armadillo.off. What takes Mesh_3 minutes to make is kept in
// `cache_dir`, unless that is empty.
std::vector<Theory_surface> theory_surfaces(const std::string& data_dir,
                                            const std::string& cache_dir, std::uint64_t seed)
{
  const auto cached = [cache_dir](const std::string& name, Indexed_surface (*make)(std::size_t)) {
    return [=](std::size_t n) {
      const std::string file = cache_dir + "/" + name + "_" + std::to_string(n) + ".ply";
      if (!cache_dir.empty() && std::ifstream(file))
        return surfaces::from_mesh(surfaces::read_mesh(file));
      Indexed_surface surface = make(n);
      if (!cache_dir.empty())
        surfaces::write_surface(surface, file);
      return surface;
    };
  };
  const auto scan = [data_dir, seed](const std::string& file, double (*jitter)(std::size_t)) {
    return [=](std::size_t n) {
      return surfaces::resized(
          surfaces::read_mesh((data_dir.empty() ? "." : data_dir) + "/" + file), n, jitter(n),
          seed);
    };
  };
  const auto same_jitter = [](std::size_t) { return 0.05; };
  // The bend of a surface over an edge goes with the square of the length of the edge.
  const auto jitter_as_bend = [](std::size_t n) { return 0.05 * std::sqrt(16384. / double(n)); };
  const std::size_t any = std::size_t(1) << 30;
  return {
      {"delaunay-sphere", "restricted Delaunay triangulation of the unit sphere", true, any,
       cached("delaunay-sphere", surfaces::delaunay_sphere)},
      {"delaunay-genus-3", "restricted Delaunay triangulation of three joined tori with oval tubes",
       true, any, cached("delaunay-genus-3", surfaces::delaunay_genus_3)},
      {"bunny", "bunny00.off, simplified or densified, then with jitter of 5 % of the edge length",
       false, any, scan("bunny00.off", same_jitter)},
      {"armadillo",
       "armadillo.off, simplified or densified, then with jitter of 5 % of the edge length", false,
       any, scan("armadillo.off", same_jitter)},
      {"bunny-alike",
       "bunny00.off, simplified or densified, then with jitter in proportion to the square of the "
       "edge length, "
       "5 % of the edge length at 16384 points",
       false, any, scan("bunny00.off", jitter_as_bend)},
      {"delaunay-round-genus-3",
       "restricted Delaunay triangulation of three joined tori with round tubes: D(S) is larger",
       false, 131072, cached("delaunay-round-genus-3", surfaces::delaunay_round_genus_3)},
      {"genus-50", "a chain of fifty tori", false, any,
       [seed](std::size_t n) { return surfaces::genus_surface(50, n, 0, seed); }, 12000}};
}

// Those on which the total work is counted, other points for every seed. With a tube of genus 0 that
// has long thin cells around its axis, or without.
std::vector<Theory_surface> work_surfaces(std::uint64_t seed, bool with_tube)
{
  const std::size_t any = std::size_t(1) << 30;
  const auto cube = [seed](std::size_t n) { return surfaces::points_in_box(n, 1, 1, 1, seed); };
  std::vector<Theory_surface> all = {
      {"cube", "random points in a cube, without a surface", true, any, cube},
      {"torus", "a torus, jitter of 5 % of the edge length", true, any,
       [seed](std::size_t n) { return surfaces::genus_surface(1, n, 0.05, seed); }},
      {"hub", "six walls that bulge inwards, and a point in the middle, in no face", true, any,
       [seed](std::size_t n) { return surfaces::room(n, seed); }},
      {"genus-50", "a chain of fifty tori", false, any,
       [seed](std::size_t n) { return surfaces::genus_surface(50, n, 0, seed); }, 12000}};
  if (with_tube)
    all.push_back({"tube", "a round tube in rings", false, any,
                   [](std::size_t n) { return surfaces::round_tube(n); }});
  return all;
}

// Volumes of about so many points, and what they are.
struct Named_volume
{
  std::string name, description;
  std::function<surfaces::Volume(std::size_t n)> make;
};

const std::vector<Named_volume>& volumes()
{
  static const std::vector<Named_volume> all = {
      {"marching-cubes", "marching cubes on a smooth sum of waves",
       [](std::size_t n) {
         const auto side = std::size_t(std::lround(std::sqrt(double(n) / 4.2)));
         return surfaces::random_waves(side, 6, 1);
       }},
      {"noise", "marching cubes on nothing but noise", [](std::size_t n) {
         const auto side = std::size_t(std::lround(std::cbrt(double(n) / 1.4)));
         return surfaces::noise(side, 1);
       }}};
  return all;
}

const char* const delaunay_prefix = "delaunay-"; // to the name of a volume

std::vector<Theory_surface> with_marching_cubes(std::vector<Theory_surface> surfaces)
{
  const std::size_t any = std::size_t(1) << 30;
  for (const Named_volume& volume : volumes()) {
    surfaces.push_back({volume.name, volume.description, false, any, [&volume](std::size_t n) {
                          return surfaces::marching_cubes(volume.make(n));
                        }});
    surfaces.push_back({delaunay_prefix + volume.name,
                        volume.description + ", with Delaunay triangles", false, any,
                        [&volume](std::size_t n) {
                          return surfaces::delaunay_marching_cubes(volume.make(n)).surface;
                        }});
  }
  surfaces.push_back({"room", "six walls that bulge inwards, and a point in the middle, in no face",
                      false, any, [](std::size_t n) { return surfaces::room(n, 1); }});
  return surfaces;
}

std::vector<Theory_surface> chosen_surfaces(const Options& options)
{
  std::vector<Theory_surface> chosen;
  const std::vector<Theory_surface> all =
      theory_surfaces(options.data_dir, options.cache_dir, options.seed);
  for (const Theory_surface& surface :
       options.subgraph_sizes.empty() ? all : with_marching_cubes(all)) {
    const auto& names = options.surfaces;
    if (names.empty() || std::find(names.begin(), names.end(), surface.name) != names.end())
      chosen.push_back(surface);
  }
  if (!options.surfaces.empty() && chosen.size() != options.surfaces.size())
    throw std::invalid_argument("a surface of --surfaces is not known (--help lists them)");
  return chosen;
}

template <template <class, class> class Hints, class Subgraph = DFS::Full_graph>
using Random_order_traits =
    CGAL::Surface_insertion_policies_3<Subgraph, meters::Random_log_star_rounds, Hints>;

// Cells entered and calls per point, and the same for the traces.
template <class Traits, class Triangulation>
Json counts_of_run(const Mesh& mesh, unsigned int seed)
{
  Triangulation tr;
  comparison::Counting_visitor visitor(comparison::Counted_calls{&tr.geom_traits().counts()});
  comparison::insert_by_package<Traits>(tr, mesh, seed, visitor);
  const std::size_t n = mesh.number_of_vertices();
  const meters::Predicate_counts location = visitor.total(Phase::LOCATION),
                                 trace = visitor.total(Phase::TRACE);
  Json result = {{"cells_entered", per_point(location.cells_entered(), n)},
                 {"calls", per_point(location.all(), n)}};
  if (trace.all() > 0) {
    result["trace_cells_entered"] = per_point(trace.cells_entered(), n);
    result["trace_calls"] = per_point(trace.all(), n);
  }
  return result;
}

using Counted_fast_triangulation =
    CGAL::Delaunay_triangulation_3<comparison::Counting_kernel, CGAL::Fast_location>;

// Ways to locate that have an order or a triangulation of their own, by name.
std::map<std::string, std::function<Json(const Mesh&, unsigned int seed)>> whole_runs()
{
  using namespace comparison;
  return {{"walk-trace", counts_of_run<meters::Random_tracing_traits, Counted_triangulation>},
          {"fast-location",
           counts_of_run<Random_order_traits<meters::No_hint_3>, Counted_fast_triangulation>},
          {"plain", counts_of_run<CGAL::Plain_insertion_traits_3, Counted_triangulation>}};
}

// --- What is measured ----------------------------------------------------------------------------------

// Everything that is counted on one surface.
Json counts_on(const Indexed_surface& surface, unsigned int seed)
{
  const Edges edges = edges_of(surface), subgraph = bounded_degree_edges(surface);
  Laboratory laboratory(surface.points, edges, subgraph, seed);
  const std::vector<Round_cost> rounds = laboratory.run();
  Json result = {{"points", surface.points.size()},
                 {"euler_characteristic", surfaces::euler_characteristic(surface)},
                 {"assumptions", assumptions_as_json(laboratory, surface, edges, subgraph)},
                 {"locations", locations_as_json(rounds)},
                 {"traces", traces_as_json(rounds)},
                 {"rounds", rounds_as_json(rounds)}};
  return result;
}

Json count(const Theory_surface& surface, std::size_t size, unsigned int seed)
{
  const Indexed_surface indexed = surface.make(size);
  Json result = {{"surface", surface.name}, {"size", size}};
  result.update(counts_on(indexed, seed));
  const Mesh mesh = surfaces::to_mesh<Mesh>(indexed);
  for (const auto& [name, count_of] : whole_runs())
    result["locations"][name] = count_of(mesh, seed);
  return result;
}

// T and the surface, changed so that T is no longer in D(S).
void break_hypothesis(const Theory_surface& surface, const Options& options,
                      const comparison::Program& program, Json& report)
{
  const Indexed_surface original = surface.make(options.hypothesis_size);
  const std::size_t n = original.points.size();
  const Edges edges = edges_of(original), subgraph = bounded_degree_edges(original);
  const Rooted_tree tree = depth_first_tree(subgraph, n);
  std::cerr << "hypothesis: " << surface.name << ", " << n << " points\n";
  const auto measure = [&](const std::string& change, double amount, const Indexed_surface& changed,
                           const Edges& T) {
    Laboratory laboratory(changed.points, edges, T, options.seed);
    const std::vector<Round_cost> rounds = laboratory.run();
    Json result = {
        {"surface", surface.name}, {"points", n}, {"change", change}, {"amount", amount}};
    result["assumptions"] = assumptions_as_json(laboratory, changed, edges, T);
    result["locations"] = locations_as_json(rounds);
    result["traces"] = traces_as_json(rounds);
    report["hypothesis"].push_back(result);
    program.write(report);
  };
  measure("none", 0, original, subgraph);
  for (const double share : {0.05, 0.1, 0.2, 0.3, 0.45}) {
    Indexed_surface changed = original;
    surfaces::jitter(changed, share, options.seed);
    measure("jitter", share, changed, subgraph);
  }
  for (const std::size_t k : {2, 4, 8, 16})
    measure("decimated", double(k), original, decimated(tree, k));
  measure("random spanning tree of F", 1, original, random_spanning_tree(edges, n, options.seed));
  for (const double share : {0.01, 0.1, 1.})
    measure("random edges", share, original, with_random_edges(tree, share, options.seed));
}

// How the surface with Delaunay triangles was made of a volume, and the CPU times of that and of
// plain insertion.
Json iso_surface_as_json(const surfaces::Volume& volume)
{
  surfaces::Delaunay_iso_surface made;
  const comparison::Time time =
      comparison::time_of([&] { made = surfaces::delaunay_marching_cubes(volume); });
  const auto& points = made.surface.points;
  const comparison::Time plain_time =
      comparison::time_of([&] { comparison::Triangulation(points.begin(), points.end()); });
  return {{"loops", made.loops},
          {"other_loops", made.other_loops},
          {"failed_loops", made.failed_loops},
          {"failed_triangles", made.failed_triangles},
          {"joined_squares", made.joined_squares},
          {"flat_diagonals", made.flat_diagonals},
          {"seconds", rounded(time.cpu, 1e3)},
          {"plain_seconds", rounded(plain_time.cpu, 1e3)}};
}

// EMST(S), which need not be in F.
Edges emst_of(const std::vector<comparison::Kernel::Point_3>& points)
{
  const comparison::Triangulation tr(points.begin(), points.end());
  std::map<comparison::Kernel::Point_3, std::size_t> number;
  for (std::size_t v = 0; v < points.size(); ++v)
    number[points[v]] = v;
  Edges emst;
  CGAL::euclidean_minimum_spanning_tree_3(
      tr, boost::make_function_output_iterator([&](const auto& e) {
        emst.push_back(edge(number.at(e.first->point()), number.at(e.second->point())));
      }));
  return emst;
}

// Subgraphs for T side by side: the bounded degree subgraph, the minimum spanning forest of F, any
// spanning forest, and the Euclidean minimum spanning tree, which need not be in F.
Json compare_subgraphs(const Theory_surface& surface, std::size_t size, unsigned int seed)
{
  const Indexed_surface indexed = surface.make(size);
  const std::size_t n = indexed.points.size();
  const Edges edges = edges_of(indexed);
  const Edges emst = emst_of(indexed.points);
  const std::map<std::string, Edges> subgraphs = {
      {"subgraph of bounded degree", bounded_degree_edges(indexed)},
      {"minimum spanning forest of F", minimum_spanning_forest(indexed)},
      {"a spanning forest of F", random_spanning_tree(edges, n, seed)},
      {"Euclidean minimum spanning tree", emst},
      {"all of F", edges}};
  Json result = {{"surface", surface.name}, {"size", size}, {"points", n}};
  for (const auto& [name, T] : subgraphs) {
    Laboratory laboratory(indexed.points, edges, T, seed);
    const std::vector<Round_cost> rounds = laboratory.run();
    result["subgraphs"][name] = {
        {"assumptions", assumptions_as_json(laboratory, indexed, edges, T)},
        {"locations", locations_as_json(rounds)},
        {"traces", traces_as_json(rounds)}};
  }
  for (const Named_volume& volume : volumes())
    if (surface.name == delaunay_prefix + volume.name)
      result["iso_surface"] = iso_surface_as_json(volume.make(size));
  return result;
}

// The total work of the paper's Q, with both T where there are faces.
Json work_of_history(const Indexed_surface& indexed, unsigned int seed)
{
  std::map<std::string, Edges> subgraphs = {
      {"Euclidean minimum spanning tree", emst_of(indexed.points)}};
  if (!indexed.faces.empty())
    subgraphs["subgraph of bounded degree"] = bounded_degree_edges(indexed);
  Json results = Json::array();
  for (const auto& [name, T] : subgraphs) {
    results.push_back({{"T", name}});
    results.back().update(Total_work(indexed.points, T, seed)());
  }
  return results;
}

// That of Tracing_traits_3, with the rounds in random order and sorted, and of plain CGAL; nothing
// without faces.
Json work_of_rounds(const Indexed_surface& indexed, unsigned int seed)
{
  Json results = Json::array();
  if (indexed.faces.empty())
    return results;
  const Mesh mesh = surfaces::to_mesh<Mesh>(indexed);
  results.push_back(
      {{"plain", comparison::counts_of_insertion<CGAL::Plain_insertion_traits_3>(mesh, seed)},
       {"random", comparison::counts_of_insertion<meters::Random_tracing_traits>(mesh, seed)},
       {"sorted", comparison::counts_of_insertion<CGAL::Tracing_traits_3>(mesh, seed)}});
  return results;
}

// Counts one of these with other points and another order for every seed.
void count_work(const Options& options, const comparison::Program& program, Json& report)
{
  for (const std::size_t size : options.work_sizes)
    for (unsigned int seed = options.seed; seed < options.seed + options.seeds; ++seed)
      for (const Theory_surface& surface : work_surfaces(seed, options.rounds)) {
        const auto& names = options.surfaces;
        if (size < surface.least_size ||
            (!names.empty() && std::find(names.begin(), names.end(), surface.name) == names.end()))
          continue;
        const Indexed_surface indexed = surface.make(size);
        for (const Json& work :
             options.rounds ? work_of_rounds(indexed, seed) : work_of_history(indexed, seed)) {
          Json result = {{"surface", surface.name},
                         {"size", size},
                         {"points", indexed.points.size()},
                         {"seed", seed}};
          result.update(work);
          std::cerr << result.dump() << '\n';
          report["work"].push_back(result);
          program.write(report);
        }
      }
}

// Calls measure(surface, size, seed) for all surfaces and sizes, smaller sizes first, and hands every
// result to keep() as soon as it is there. Counts depend on nothing that other threads do.
template <class Keep>
void everywhere(const std::vector<Theory_surface>& surfaces, const std::vector<std::size_t>& sizes,
                unsigned int seed, std::size_t number_of_threads,
                Json (*measure)(const Theory_surface&, std::size_t, unsigned int), const Keep& keep)
{
  std::vector<std::pair<const Theory_surface*, std::size_t>> jobs;
  for (const std::size_t size : sizes)
    for (const Theory_surface& surface : surfaces)
      if (surface.least_size <= size && size <= surface.largest_size)
        jobs.emplace_back(&surface, size);
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  const auto work = [&] {
    for (std::size_t k = next++; k < jobs.size(); k = next++) {
      const Json result = measure(*jobs[k].first, jobs[k].second, seed);
      const std::lock_guard<std::mutex> lock(mutex);
      std::cerr << result["surface"] << ' ' << result["points"] << '\n';
      keep(result);
    }
  };
  std::vector<std::future<void>> workers;
  for (std::size_t t = 0; t < number_of_threads; ++t)
    workers.push_back(std::async(std::launch::async, work));
  for (std::future<void>& worker : workers)
    worker.get(); // throws what the thread threw
}

void describe(const std::vector<Theory_surface>& surfaces, Json& report)
{
  for (const Theory_surface& surface : surfaces)
    report["surfaces"][surface.name] = surface.description;
}

// Writes what is measured at once, should the rest be interrupted.
void measure_into(const Options& options, const comparison::Program& program, Json& report)
{
  if (options.threads == 0)
    throw std::invalid_argument("--threads must be at least 1");
  if (!options.work_sizes.empty()) {
    describe(work_surfaces(options.seed, options.rounds), report);
    count_work(options, program, report);
    return;
  }
  const std::vector<Theory_surface> surfaces = chosen_surfaces(options);
  describe(surfaces, report);
  for (const char* list : {"results", "hypothesis", "subgraphs"})
    report[list] = Json::array();
  const auto keep_in = [&](const char* list) {
    return [&report, &program, list](const Json& result) {
      report[list].push_back(result);
      program.write(report);
    };
  };
  if (!options.subgraph_sizes.empty()) {
    everywhere(surfaces, options.subgraph_sizes, options.seed, options.threads, compare_subgraphs,
               keep_in("subgraphs"));
    return;
  }
  for (const Theory_surface& surface : surfaces)
    if (options.hypothesis_size > 0 && surface.meets_assumptions)
      break_hypothesis(surface, options, program, report);
  everywhere(surfaces, options.sizes, options.seed, options.threads, count, keep_in("results"));
}

} // namespace

int main(int argc, char** argv)
{
  Options o;
  for (std::size_t size = 1024; size <= 1048576; size *= 2)
    o.sizes.push_back(size);
  comparison::Program program("location_costs", introduction);
  program.option("surfaces", o.surfaces, "NAME...",
                 "delaunay-sphere, delaunay-genus-3, bunny, armadillo, bunny-alike, "
                 "delaunay-round-genus-3, genus-50; default: all; for --subgraph-sizes also "
                 "marching-cubes, delaunay-marching-cubes, noise, delaunay-noise, room; for "
                 "--work-sizes cube, torus, hub, genus-50, and with --rounds tube");
  program.option("sizes", o.sizes, "N...",
                 "numbers of points to count at; default: the powers of 2 from 1024 to 1048576");
  program.option("hypothesis-size", o.hypothesis_size, "N",
                 "number of points with which the hypothesis is made to fail; 0: not at all");
  program.option("subgraph-sizes", o.subgraph_sizes, "N...",
                 "numbers of points to compare subgraphs T at, with both histories; then nothing "
                 "else is measured");
  program.option("work-sizes", o.work_sizes, "N...",
                 "numbers of points to count the total work of the paper's Q at, with T = EMST and "
                 "the subgraph of bounded degree; then nothing else is measured");
  program.option("rounds", o.rounds,
                 "count that of walks and traces in place of Q, in random rounds and sorted");
  program.option("seeds", o.seeds, "N", "how many seeds for that, from --seed on");
  program.option("data-dir,d", o.data_dir, "FOLDER",
                 "where bunny00.off and armadillo.off are (Debian: libcgal-demo)");
  program.option("cache-dir", o.cache_dir, "FOLDER",
                 "where surfaces are kept that take minutes to make");
  program.option("threads", o.threads, "N", "how many surfaces to count on at a time");
  program.option("seed", o.seed, "N", "of surfaces and insertion orders");
  return program.run(argc, argv, [&](Json& report) { measure_into(o, program, report); });
}
