// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_COMPARISON_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_COMPARISON_H

// All that is measured on one surface.

#include <Delaunay_from_surface_3_comparison/launcher.h>
#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_comparison/memory.h>
#include <Delaunay_from_surface_3_comparison/methods.h>
#include <Delaunay_from_surface_3_comparison/options.h>
#include <Delaunay_from_surface_3_comparison/peers.h>
#include <Delaunay_from_surface_3_comparison/reference.h>

#include <array>
#include <cstddef>
#include <iomanip>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace comparison {

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

} // namespace comparison

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_COMPARISON_H
