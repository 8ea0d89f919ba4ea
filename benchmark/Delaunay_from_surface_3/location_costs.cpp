// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The claims of Choi 2002, measured: what it costs to locate a point, by history and by walk, from
// the last trace and from elsewhere; how many triangles a trace crosses; what becomes of it when T
// is not Delaunay; and the total work of the paper's Q.

#include <Delaunay_from_surface_3_comparison/machine.h>
#include <Delaunay_from_surface_3_comparison/read_command_line.h>
#include <Delaunay_from_surface_3_surfaces/adversarial.h>
#include <Delaunay_from_surface_3_surfaces/delaunay_marching_cubes.h>
#include <Delaunay_from_surface_3_surfaces/jitter.h>
#include <Delaunay_from_surface_3_surfaces/marching_cubes.h>
#include <Delaunay_from_surface_3_surfaces/topology.h>
#include <Delaunay_from_surface_3_theory/report.h>
#include <Delaunay_from_surface_3_theory/surfaces.h>
#include <Delaunay_from_surface_3_theory/total_work.h>
#include <Delaunay_from_surface_3_theory/whole_runs.h>

#include <CGAL/euclidean_minimum_spanning_tree_3.h>

#include <boost/iterator/function_output_iterator.hpp>
#include <boost/program_options.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
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
namespace po = boost::program_options;

const char* const introduction =
    R"(Measures what it costs to locate points while a surface is inserted in the order of the paper.

  location_costs --data-dir meshes --cache-dir surfaces --output location_costs.json

Cells entered and predicate calls are counted in runs that are not timed.

Options)";

struct Options
{
  std::vector<std::string> surfaces;
  std::vector<std::size_t> sizes, time_sizes, subgraph_sizes, work_sizes;
  std::size_t hypothesis_size = 32768, threads = 1, seeds = 5;
  std::string output = "location_costs.json", data_dir, cache_dir, command;
  unsigned int seed = 0;
};

po::options_description describe(Options& o)
{
  po::options_description options(introduction);
  auto add = options.add_options();
  add("help,h", "say this and stop");
  add("surfaces", po::value(&o.surfaces)->multitoken()->value_name("NAME..."),
      "delaunay-sphere, delaunay-genus-3, bunny, armadillo, bunny-alike, delaunay-round-genus-3, "
      "genus-50; default: all; for --subgraph-sizes also marching-cubes, delaunay-marching-cubes, "
      "noise, delaunay-noise, room; for --work-sizes cube, torus, hub, genus-50");
  add("sizes", po::value(&o.sizes)->multitoken()->value_name("N..."),
      "numbers of points to count at; default: the powers of 2 from 1024 to 1048576");
  add("time-sizes", po::value(&o.time_sizes)->multitoken()->value_name("N..."),
      "numbers of points to measure times at; default: 16384 131072 1048576");
  add("hypothesis-size",
      po::value(&o.hypothesis_size)->value_name("N")->default_value(o.hypothesis_size),
      "number of points with which the hypothesis is made to fail; 0: not at all");
  add("subgraph-sizes", po::value(&o.subgraph_sizes)->multitoken()->value_name("N..."),
      "numbers of points to compare subgraphs T at, with both histories; then nothing else is "
      "measured");
  add("work-sizes", po::value(&o.work_sizes)->multitoken()->value_name("N..."),
      "numbers of points to count the total work of the paper's Q at, with T = EMST and the "
      "subgraph of bounded degree; then nothing else is measured");
  add("seeds", po::value(&o.seeds)->value_name("N")->default_value(o.seeds),
      "how many seeds for that, from --seed on");
  add("output,o", po::value(&o.output)->value_name("FILE")->default_value(o.output),
      "where the JSON goes");
  add("data-dir,d", po::value(&o.data_dir)->value_name("FOLDER"),
      "where bunny00.off and armadillo.off are (Debian: libcgal-demo)");
  add("cache-dir", po::value(&o.cache_dir)->value_name("FOLDER"),
      "where surfaces are kept that take minutes to make");
  add("threads", po::value(&o.threads)->value_name("N")->default_value(o.threads),
      "how many surfaces to count on at a time; times are measured one at a time");
  add("seed", po::value(&o.seed)->value_name("N")->default_value(o.seed),
      "of surfaces and insertion orders");
  return options;
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

void write(const Json& report, const std::string& file_name)
{
  std::ofstream file(file_name);
  file << report.dump(1) << '\n';
  if (!file.flush())
    throw std::runtime_error("cannot write '" + file_name + "'");
}

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
  for (const Whole_run& run : whole_runs())
    if (run.count)
      result["locations"][run.name] = run.count(mesh, seed);
  return result;
}

Json time(const Theory_surface& surface, std::size_t size, unsigned int seed)
{
  const Mesh mesh = surfaces::to_mesh<Mesh>(surface.make(size));
  Json seconds;
  for (const Whole_run& run : whole_runs())
    seconds[run.name] = run.time(mesh, seed);
  return {{"surface", surface.name},
          {"size", size},
          {"points", mesh.number_of_vertices()},
          {"load_average", rounded(comparison::load_average(), 100)},
          {"seconds", seconds}};
}

// T and the surface, changed so that T is no longer in D(S).
void break_hypothesis(const Theory_surface& surface, const Options& options, Json& report)
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
    write(report, options.output);
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

// The total work of the paper's Q, with both T where there are faces: other points and another
// order for every seed.
void count_work(const Options& options, Json& report)
{
  for (const std::size_t size : options.work_sizes)
    for (unsigned int seed = options.seed; seed < options.seed + options.seeds; ++seed)
      for (const Theory_surface& surface : work_surfaces(seed)) {
        const auto& names = options.surfaces;
        if (size < surface.least_size ||
            (!names.empty() && std::find(names.begin(), names.end(), surface.name) == names.end()))
          continue;
        const Indexed_surface indexed = surface.make(size);
        std::map<std::string, Edges> subgraphs = {
            {"Euclidean minimum spanning tree", emst_of(indexed.points)}};
        if (!indexed.faces.empty())
          subgraphs["subgraph of bounded degree"] = bounded_degree_edges(indexed);
        for (const auto& [name, T] : subgraphs) {
          Json result = {{"surface", surface.name},
                         {"size", size},
                         {"points", indexed.points.size()},
                         {"T", name},
                         {"seed", seed}};
          result.update(Total_work(indexed.points, T, seed)());
          std::cerr << result.dump() << '\n';
          report["work"].push_back(result);
          write(report, options.output);
        }
      }
}

// a + b log2 n for every surface and way, without and with the cells that traces enter.
Json fits(const Json& results)
{
  struct Series
  {
    std::vector<double> n, cells, with_traces;
  };
  std::map<std::string, std::map<std::string, Series>> all;
  for (const Json& result : results)
    for (const auto& [way, cost] : result["locations"].items()) {
      Series& series = all[result["surface"]][way];
      const double cells = cost["cells_entered"];
      series.n.push_back(result["points"]);
      series.cells.push_back(cells);
      series.with_traces.push_back(cells + cost.value("trace_cells_entered", 0.));
    }
  Json report = Json::object();
  for (const auto& [surface, ways] : all)
    for (const auto& [way, series] : ways)
      if (series.n.size() > 1) {
        report[surface][way] = fit(series.n, series.cells);
        if (series.with_traces != series.cells)
          report[surface][way]["with_traces"] = fit(series.n, series.with_traces);
      }
  return report;
}

Json description_of(const Options& options, const std::vector<Theory_surface>& surfaces)
{
  Json names = Json::object();
  for (const Theory_surface& surface : surfaces)
    names[surface.name] = surface.description;
  return {{"program", "location_costs"},
          {"command", options.command},
          {"machine", comparison::describe_machine(DELAUNAY_FROM_SURFACE_3_COMPILER_FLAGS)},
          {"surfaces", names},
          {"fits", Json::object()},
          {"results", Json::array()},
          {"hypothesis", Json::array()},
          {"subgraphs", Json::array()},
          {"times", Json::array()}};
}

// Calls measure(surface, size) for all surfaces and sizes, smaller sizes first, and hands every
// result to keep() as soon as it is there. Counts depend on nothing that other threads do; times
// do.
template <class Measure, class Keep>
void everywhere(const std::vector<Theory_surface>& surfaces, const std::vector<std::size_t>& sizes,
                std::size_t number_of_threads, const Measure& measure, const Keep& keep)
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
      const Json result = measure(*jobs[k].first, jobs[k].second);
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

// What is measured is written at once, should the rest be interrupted.
void run(const Options& options)
{
  if (!options.work_sizes.empty()) {
    Json report = description_of(options, work_surfaces(options.seed));
    for (const char* list : {"fits", "results", "hypothesis", "subgraphs", "times"})
      report.erase(list);
    count_work(options, report);
    return;
  }
  const std::vector<Theory_surface> surfaces = chosen_surfaces(options);
  Json report = description_of(options, surfaces);
  const auto keep_in = [&](const char* list) {
    return [&report, &options, list](const Json& result) {
      report[list].push_back(result);
      report["fits"] = fits(report["results"]);
      write(report, options.output);
    };
  };
  if (!options.subgraph_sizes.empty()) {
    everywhere(
        surfaces, options.subgraph_sizes, options.threads,
        [&](const Theory_surface& surface, std::size_t size) {
          return compare_subgraphs(surface, size, options.seed);
        },
        keep_in("subgraphs"));
    return;
  }
  for (const Theory_surface& surface : surfaces)
    if (options.hypothesis_size > 0 && surface.meets_assumptions)
      break_hypothesis(surface, options, report);
  everywhere(
      surfaces, options.sizes, options.threads,
      [&](const Theory_surface& surface, std::size_t size) {
        return count(surface, size, options.seed);
      },
      keep_in("results"));
  everywhere(
      surfaces, options.time_sizes, 1,
      [&](const Theory_surface& surface, std::size_t size) {
        return time(surface, size, options.seed);
      },
      keep_in("times"));
}

} // namespace

int main(int argc, char** argv)
{
  try {
    Options options;
    const po::options_description description = describe(options);
    comparison::read_command_line(argc, argv, description);
    if (options.sizes.empty())
      for (std::size_t size = 1024; size <= 1048576; size *= 2)
        options.sizes.push_back(size);
    if (options.time_sizes.empty())
      options.time_sizes = {16384, 131072, 1048576};
    options.command = comparison::command_line("location_costs", argc, argv);
    if (options.threads == 0)
      throw std::invalid_argument("--threads must be at least 1");
    run(options);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << "location_costs: " << error.what() << '\n';
  }
  return EXIT_FAILURE;
}
