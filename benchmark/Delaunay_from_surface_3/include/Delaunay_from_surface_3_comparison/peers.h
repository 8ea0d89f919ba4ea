// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_PEERS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_PEERS_H

// Programs that build the same triangulation in their own way. README.md says what is asked of one.

#include <Delaunay_from_surface_3_comparison/launcher.h>
#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_comparison/points_file.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <unistd.h>

namespace comparison {

struct Peer
{
  std::string name, command;
};

// From NAME=COMMAND.
inline Peer parse_peer(const std::string& text)
{
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos || equals + 1 == text.size())
    throw std::invalid_argument("a peer is given as NAME=COMMAND, not as '" + text + "'");
  return {text.substr(0, equals), text.substr(equals + 1)};
}

// The points of a mesh in a file that lives as long as this.
class Points_file
{
public:
  template <class Points>
  explicit Points_file(const Points& points)
    : m_name((std::filesystem::temp_directory_path() /
              ("delaunay_from_surface_3-" + std::to_string(getpid()) + ".points"))
                 .string())
  {
    write_points_file(points, m_name);
  }
  Points_file(const Points_file&) = delete;
  Points_file& operator=(const Points_file&) = delete;
  ~Points_file()
  {
    std::error_code ignored;
    std::filesystem::remove(m_name, ignored);
  }

  const std::string& name() const { return m_name; }

private:
  std::string m_name;
};

// What comes after `key` on the line that begins with it.
inline std::optional<std::string> value_in_output(const std::string& output, const std::string& key)
{
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word, value;
    if (words >> word && word == key && std::getline(words >> std::ws, value) && !value.empty())
      return value;
  }
  return std::nullopt;
}

// What a peer did on one surface, run by run. A peer that fails once is not asked again.
class Peer_record
{
public:
  explicit Peer_record(Peer peer)
    : m_peer(std::move(peer))
  {
  }

  void run(Launcher& launcher, const std::string& points_file)
  {
    if (!m_failure.empty())
      return;
    const Outcome outcome = launcher.run(m_peer.command + " '" + points_file + "'");
    const auto seconds = value_in_output(outcome.output, "cpu_seconds");
    const auto tetrahedra = value_in_output(outcome.output, "tetrahedra");
    if (outcome.exit_code != 0)
      m_failure = "exit code " + std::to_string(outcome.exit_code);
    else if (!seconds || !tetrahedra)
      m_failure = "it does not print cpu_seconds and tetrahedra";
    if (!m_failure.empty())
      return;
    m_cpu.push_back(std::stod(*seconds));
    if (const auto wall = value_in_output(outcome.output, "wall_seconds"))
      m_wall.push_back(std::stod(*wall));
    m_threads = value_in_output(outcome.output, "threads");
    m_library = value_in_output(outcome.output, "library");
    m_tetrahedra = std::stoul(*tetrahedra);
    m_peak_bytes = std::max(m_peak_bytes, outcome.peak_bytes);
  }

  const std::string& failure() const { return m_failure; }

  // `plain`: its median time, and what it found.
  Json as_json(double plain_cpu, std::size_t plain_tetrahedra) const
  {
    Json result = {{"method", m_peer.name}, {"command", m_peer.command}};
    if (!m_failure.empty()) {
      result["left_out"] = m_failure;
      return result;
    }
    if (m_library)
      result["library"] = *m_library;
    if (m_threads)
      result["threads"] = std::stoul(*m_threads);
    result.update(with_median("cpu", m_cpu));
    if (!m_wall.empty())
      result.update(with_median("wall", m_wall));
    result["ratio_plain_to_method"] = rounded(plain_cpu / double(result["median_cpu"]), 1e4);
    result["tetrahedra"] = m_tetrahedra;
    result["has_as_many_tetrahedra"] = m_tetrahedra == plain_tetrahedra;
    result["memory"] = {{"peak_bytes", m_peak_bytes}};
    return result;
  }

private:
  Peer m_peer;
  std::vector<double> m_cpu, m_wall;
  std::optional<std::string> m_threads, m_library;
  std::size_t m_tetrahedra = 0, m_peak_bytes = 0;
  std::string m_failure;
};

} // namespace comparison

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_PEERS_H
