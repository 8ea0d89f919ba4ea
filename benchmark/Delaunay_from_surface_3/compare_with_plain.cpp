// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Builds the Delaunay triangulations of surfaces by CGAL's own range insertion, by the ways of this
// package and by other programs, in turns, and writes what was measured as JSON.

#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_comparison/methods.h>
#include <Delaunay_from_surface_3_comparison/peers.h>
#include <Delaunay_from_surface_3_comparison/run_program.h>
#include <Delaunay_from_surface_3_comparison/surfaces.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace {

using namespace comparison;

const char* const introduction =
    R"(Compares ways to build the Delaunay triangulation of a surface's vertices with CGAL's own
insert(first, last): times, phases, counts, memory, and whether the results are equal.

  compare_with_plain --data-dir meshes --output results.json
  compare_with_plain --surfaces genus-3 sphere --sizes 16384 65536 --methods plain default
  compare_with_plain --surfaces sphere --sizes 65536 --methods default --peer tetgen=./tetgen_peer

Every repetition runs all methods and peers, each time beginning with another one. Phases, counts
and memory come from runs of their own, since to measure them takes time.)";

struct Options
{
  std::vector<std::string> surfaces, meshes, methods, peers;
  std::vector<std::size_t> sizes = {16384, 65536, 262144, 1048576};
  std::size_t repetitions = 3, largest_compared = 300000;
  std::string data_dir;
  std::uint64_t seed = 0;
  bool memory = false, only_times = false, list = false;
};

void list()
{
  std::cout << std::left;
  for (const Named_surface& surface : with_twins(named_surfaces("")))
    std::cout << "surface " << std::setw(24) << surface.name << surface.description << '\n';
  for (const Method& method : all_methods())
    std::cout << "method  " << std::setw(24) << method.name << method.description << '\n';
}

// The items with the given names, in their order.
template <class Item>
std::vector<Item> chosen(const std::vector<Item>& all, const std::vector<std::string>& names,
                         const std::string& what)
{
  std::vector<Item> items;
  for (const std::string& name : names) {
    const auto is_it = [&name](const Item& item) { return item.name == name; };
    const auto found = std::find_if(all.begin(), all.end(), is_it);
    if (found == all.end())
      throw std::invalid_argument("there is no " + what + " '" + name + "' (--list lists them)");
    items.push_back(*found);
  }
  return items;
}

// The first method is plain CGAL, whatever was chosen.
std::vector<Method> chosen_methods(const Options& options)
{
  const std::vector<Method> all = all_methods();
  if (options.methods.empty())
    return all;
  std::vector<std::string> names = options.methods;
  names.erase(std::remove(names.begin(), names.end(), all.front().name), names.end());
  names.insert(names.begin(), all.front().name);
  return chosen(all, names, "method");
}

// Those named and those of --mesh; all named ones if neither is given.
std::vector<Named_surface> chosen_surfaces(const Options& options)
{
  std::vector<Named_surface> all = named_surfaces(options.data_dir), files;
  if (options.surfaces.empty() && options.meshes.empty())
    return all;
  for (const std::string& file : options.meshes)
    files.push_back(surface_of_file(file));
  std::vector<Named_surface> named = with_twins(all);
  const std::vector<Named_surface> twins = with_twins(files);
  named.insert(named.end(), twins.begin(), twins.end());
  std::vector<Named_surface> result = chosen(named, options.surfaces, "surface");
  for (const Named_surface& file : files) // unless they were named, or their twins were
    if (std::none_of(options.surfaces.begin(), options.surfaces.end(), [&](const std::string& s) {
          return s == file.name || s == file.name + "-shuffled";
        }))
      result.push_back(file);
  return result;
}

std::vector<Peer> chosen_peers(const Options& options)
{
  std::vector<Peer> peers;
  const std::vector<Method> methods = all_methods();
  for (const std::string& text : options.peers) {
    peers.push_back(parse_peer(text));
    for (const Method& method : methods)
      if (method.name == peers.back().name)
        throw std::invalid_argument("'" + method.name + "' is a method, a peer needs another name");
  }
  return peers;
}

// --- All that is measured on one surface ---------------------------------------------------------

// What one method did, run by run.
struct Method_record
{
  std::vector<double> cpu, wall;
  std::array<std::vector<double>, 3> stages;
  bool is_equal = true;

  void add(const Build& build)
  {
    cpu.push_back(build.time.cpu);
    wall.push_back(build.time.wall);
    for (std::size_t s = 0; build.stages && s < stages.size(); ++s)
      stages[s].push_back((*build.stages)[s]);
  }

  Json as_json() const
  {
    Json result = with_median("cpu", cpu);
    result.update(with_median("wall", wall));
    if (!stages[0].empty())
      for (std::size_t s = 0; s < stages.size(); ++s)
        result["stages"][stage_names[s]] = rounded(median(stages[s]));
    return result;
  }
};

class Comparison
{
public:
  Comparison(const Options& options, Launcher& launcher)
    : m_options(options)
    , m_launcher(launcher)
    , m_methods(chosen_methods(options))
    , m_peers(chosen_peers(options))
    , m_seed(static_cast<unsigned int>(options.seed))
  {
  }

  const std::vector<Method>& methods() const { return m_methods; }

  // Adds "methods" and "yardstick" to `result`; returns whether all were equal.
  bool run(const Mesh& mesh, Json& result)
  {
    m_records.assign(m_methods.size(), {});
    m_peer_records.clear();
    for (const Peer& peer : m_peers)
      m_peer_records.emplace_back(peer);
    m_verification.clear();
    std::vector<Json> memory;
    if (m_options.memory) // first: the process holds little more than the mesh
      for (const Method& method : m_methods)
        memory.push_back(memory_as_json(memory_of_build(method.name,
                                                        [&](const auto& look) {
                                                          method.build(mesh, m_seed,
                                                                       [&look](auto) { look(); });
                                                        }),
                                        double(mesh.number_of_vertices())));
    const Reference plain(mesh, m_options.largest_compared); // warms up, too
    time_all(mesh, plain);

    result["yardstick"] = yardstick();
    const double plain_cpu = median(m_records.front().cpu);
    bool all_equal = true;
    for (std::size_t m = 0; m < m_methods.size(); ++m) {
      Json method = method_as_json(m, plain_cpu, result["yardstick"]);
      method["equal_checked_by"] = plain.how_compared();
      if (m_options.memory)
        method["memory"] = memory[m];
      if (!m_options.only_times)
        add_phases_and_counts(m_methods[m], mesh, method);
      say(method, m_records[m].is_equal ? "equal" : "DIFFERENT");
      all_equal = all_equal && m_records[m].is_equal;
      result["methods"].push_back(std::move(method));
    }
    for (const Peer_record& record : m_peer_records) {
      Json peer = record.as_json(plain_cpu, plain.number_of_tetrahedra());
      if (record.failure().empty())
        say(peer, peer["has_as_many_tetrahedra"] ? "as many tetrahedra" : "other tetrahedra");
      else
        std::cerr << "  peer " << std::string(peer["method"]) << " left out: " << record.failure()
                  << '\n';
      result["methods"].push_back(std::move(peer));
    }
    return all_equal;
  }

private:
  // Alternating repetitions; the r-th begins with the r-th, so that none always comes first.
  void time_all(const Mesh& mesh, const Reference& plain)
  {
    std::optional<Points_file> points;
    if (!m_peers.empty())
      points.emplace(mesh.points());
    const std::size_t number = m_methods.size() + m_peers.size();
    for (std::size_t r = 0; r < m_options.repetitions; ++r) {
      for (std::size_t k = 0; k < number; ++k) {
        const std::size_t m = (r + k) % number;
        if (m < m_methods.size())
          time_method(m, mesh, plain, r == 0);
        else
          m_peer_records[m - m_methods.size()].run(m_launcher, points->name());
      }
      const Time verified = time_of([&] {
        if (!plain.is_locally_delaunay())
          throw std::runtime_error("plain CGAL's triangulation is not Delaunay");
      });
      m_verification.push_back(verified.cpu);
    }
  }

  // The same seed makes the same triangulation every time: it is compared once.
  void time_method(std::size_t m, const Mesh& mesh, const Reference& plain, bool is_compared)
  {
    Method_record& record = m_records[m];
    record.add(m_methods[m].build(mesh, m_seed, [&](auto tr) {
      if (is_compared)
        record.is_equal = std::visit([&](auto* t) { return plain.is_equal(*t); }, tr);
    }));
  }

  // What an algorithm would take that were told the result: to verify it, and to write it into
  // CGAL's data structure.
  Json yardstick() const
  {
    Json result = {{"verification", rounded(median(m_verification))}};
    for (std::size_t m = 0; m < m_methods.size(); ++m)
      if (m_methods[m].name == "default") {
        result["export"] = rounded(median(m_records[m].stages[2]));
        result["total"] = rounded(double(result["verification"]) + double(result["export"]));
      }
    return result;
  }

  Json method_as_json(std::size_t m, double plain_cpu, const Json& yardstick) const
  {
    Json result = {{"method", m_methods[m].name}};
    result.update(m_records[m].as_json());
    const double cpu = result["median_cpu"];
    result["ratio_plain_to_method"] = rounded(plain_cpu / cpu, 1e4);
    if (yardstick.contains("total"))
      result["ratio_method_to_yardstick"] = rounded(cpu / double(yardstick["total"]), 1e4);
    result["equal"] = m_records[m].is_equal;
    return result;
  }

  void add_phases_and_counts(const Method& method, const Mesh& mesh, Json& result) const
  {
    if (method.time_phases)
      result["phases"] = method.time_phases(mesh, m_seed);
    if (method.count)
      result.update(method.count(mesh, m_seed));
  }

  static void say(const Json& method, const std::string& verdict)
  {
    std::cerr << "  " << std::left << std::setw(20) << std::string(method["method"]) << std::right
              << std::fixed << std::setprecision(3) << std::setw(9) << double(method["median_cpu"])
              << " s  " << std::setw(6) << double(method["ratio_plain_to_method"]) << " x  "
              << verdict << '\n';
  }

  const Options& m_options;
  Launcher& m_launcher;
  std::vector<Method> m_methods;
  std::vector<Peer> m_peers;
  unsigned int m_seed;
  std::vector<Method_record> m_records;
  std::vector<Peer_record> m_peer_records;
  std::vector<double> m_verification;
};

// Writes what is measured at once, should the rest be interrupted.
void measure_into(const Options& options, Launcher& launcher, const Program& program, Json& report)
{
  if (options.repetitions == 0)
    throw std::invalid_argument("--repetitions must be at least 1");
  if (options.list) {
    list();
    std::exit(EXIT_SUCCESS);
  }
  Comparison comparison(options, launcher);
  report["load_average_at_start"] = rounded(load_average(), 100);
  report["repetitions"] = options.repetitions;
  for (const Method& method : comparison.methods())
    report["methods"][method.name] = method.description;
  report["results"] = Json::array();
  bool all_equal = true;
  for (const Named_surface& surface : chosen_surfaces(options))
    for (const std::size_t size : options.sizes) {
      if (size < surface.least_size && !(surface.is_file && size == 0)) {
        std::cerr << surface.name << ", " << size << " points: left out, it is made from "
                  << surface.least_size << " on\n";
        continue;
      }
      const Mesh mesh = surfaces::to_mesh<Mesh>(surface.make(size, options.seed));
      std::cerr << surface.name << ", " << mesh.number_of_vertices() << " points\n";
      Json result = {{"surface", surface.name},
                     {"description", surface.description},
                     {"size", size},
                     {"points", mesh.number_of_vertices()},
                     {"faces", mesh.number_of_faces()}};
      all_equal = comparison.run(mesh, result) && all_equal;
      report["results"].push_back(std::move(result));
      report["load_average_at_end"] = rounded(load_average(), 100);
      program.write(report);
    }
  if (!all_equal)
    throw std::runtime_error("a triangulation differs from CGAL's");
}

} // namespace

int main(int argc, char** argv)
{
  Launcher launcher; // before anything large is in memory
  Options o;
  Program program("compare_with_plain", introduction);
  program.option("list", o.list, "list surfaces and methods and stop");
  program.option("surfaces", o.surfaces, "NAME...", "default: all but those in random order");
  program.option("mesh", o.meshes, "FILE...",
                 "more surfaces, densified like the bunny and named after their files");
  program.option(
      "sizes", o.sizes, "N...",
      "numbers of points; default: 16384 65536 262144 1048576. A surface skips those it is "
      "too detailed for. 0 takes those of --mesh as they are.");
  program.option("methods", o.methods, "NAME...",
                 "default: all; plain always runs. random-last and random-insert are slow "
                 "for many points.");
  program.option("peer", o.peers, "NAME=COMMAND",
                 "one more method, by a program of its own; may be repeated");
  program.option("repetitions,r", o.repetitions, "N", "how often every time is measured");
  program.option("memory", o.memory,
                 "measure the memory of every method as well, in a process for each");
  program.option("only-times", o.only_times, "leave out phases and counts");
  program.option(
      "equal-up-to", o.largest_compared, "N",
      "compare with == up to so many points, above only the numbers of cells, facets and "
      "edges");
  program.option("data-dir,d", o.data_dir, "FOLDER",
                 "where bunny00.off and refined_elephant.off are (Debian: libcgal-demo)");
  program.option("seed", o.seed, "N", "of surfaces and insertion orders");
  return program.run(argc, argv, [&](Json& report) { measure_into(o, launcher, program, report); });
}
