// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_TILES_COMMAND_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_TILES_COMMAND_H

#include "Report.h"

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_in_files.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>

#include <Delaunay_from_surface_3_files/Output_file.h>

#include <boost/program_options.hpp>

#include <cctype>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace core = CGAL::Delaunay_from_surface_3::core;

// The arguments of `delaunay_from_surface tiles`, and of `delaunay_from_surface_mpi`.
struct Tiles_command : Printing
{
  std::vector<std::string> inputs;
  std::string output, join;
  CGAL::Tiles_options options;
  unsigned int threads = 1;
  std::optional<unsigned int> task;
  bool next = false, vtu = false, neighbors = false;
  bool help = false; // by MPI

  CGAL::Point_files_3 points() const
  {
    return CGAL::Point_files_3(std::vector<std::filesystem::path>(inputs.begin(), inputs.end()));
  }

  // Shows progress by messages. Keeps a reference.
  void show_progress(Messages& messages)
  {
    options.progress = [&messages](const char* what, std::size_t done, std::size_t all) {
      const std::string text =
          std::string(what) + ": " + std::to_string(done) + " of " + std::to_string(all);
      done == 0 ? messages.step(text) : messages.show(text);
      return true;
    };
  }
};

inline void report_tiles(const std::string& output, const CGAL::Tiles_report& result,
                         Report& report)
{
  report("output", output);
  report("points", result.points);
  report("tiles", result.tiles);
  report("rounds", result.rounds);
  report("points told", result.told);
  report("points kept", result.kept);
  report("most points kept by a tile", result.most_kept);
  report("finite and infinite cells", result.cells);
  report("certificate", "holds: the tiles are the Delaunay triangulation of all points, up to a "
                        "collision of hashes of 128 bits");
}

// A file in which tiles are joined. Nothing of it stays if a signal ends the program once it is made.
class Joined_file : public core::Joined_tiles
{
public:
  Joined_file(const CGAL::Tile_source_3& points, const std::filesystem::path& folder,
              const std::filesystem::path& file)
    : Joined_tiles(points, folder, file)
  {
    files::remove_files_on_signal();
    m_remove_on_signal.watch(unfinished());
  }

private:
  files::Remove_on_signal m_remove_on_signal;
};

// Returns the bytes of 8G, 500M, …
inline std::uint64_t parse_memory(const std::string& text)
{
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  static const std::string units = "KMGT";
  double factor = 1;
  if (*end != 0) {
    const std::size_t unit = units.find(char(std::toupper(static_cast<unsigned char>(*end++))));
    factor = unit == std::string::npos ? 0 : double(std::uint64_t(1) << (10 * (unit + 1)));
  }
  if (factor > 1 && std::toupper(static_cast<unsigned char>(*end)) == 'B')
    ++end; // 8GB
  if (text.empty() || *end != 0 || !(number * factor >= 1e6) || number * factor > 1e18)
    throw std::runtime_error("option '--memory' needs a size of at least 1M, as 500M, 8G or 1T");
  return std::uint64_t(number * factor);
}

// By MPI there are fewer options, and a tile may have any memory.
inline Tiles_command parse_tiles_command(int argc, char* argv[], bool by_mpi = false)
{
  namespace po = boost::program_options;
  Tiles_command command;
  std::string memory = "4G";
  long long tiles = 0, threads = 1, task = 0;
  bool weights = false;
  po::options_description all; // help.txt explains them
  auto add = all.add_options();
  add("output,o", po::value(&command.output))("tiles", po::value(&tiles));
  add("threads", po::value(&threads))("vtu", po::bool_switch(&command.vtu));
  add("weights", po::bool_switch(&weights)); // to say what to do
  add("join", po::value(&command.join))("input", po::value(&command.inputs));
  command.add_to(all);
  if (by_mpi) {
    add("help,h", po::bool_switch(&command.help));
  } else {
    add("memory", po::value(&memory))("neighbors", po::bool_switch(&command.neighbors));
    add("next", po::bool_switch(&command.next))("task", po::value(&task));
  }
  po::variables_map given = read_command_line(argc, argv, all, -1);
  po::notify(given);
  if (command.help)
    return command;
  if (weights)
    throw std::runtime_error("tiles know no weights; remedy: all points in memory, by "
                             "'delaunay_from_surface POINTS --weights'");
  if (command.inputs.empty())
    throw std::runtime_error("no points given");
  if (command.output.empty())
    throw std::runtime_error("option '--output' needs a folder for the tiles");
  if (!by_mpi)
    command.options.memory = parse_memory(memory);
  if (given.count("tiles") != 0) {
    command.options.number_of_tiles = checked_number("tiles", tiles, 1, 1000000);
    command.options.starts_again = by_mpi;
  }
  command.threads = checked_number("threads", threads, 1, most_threads);
  if (given.count("task") != 0)
    command.task = checked_number("task", task, 0);
  if (command.neighbors && (command.next || command.task))
    throw std::runtime_error(
        "'--neighbors' excludes '--next' and '--task'; give it when all tasks are done");
  if (!command.join.empty() && (command.next || command.task))
    throw std::runtime_error(
        "'--join' excludes '--next' and '--task'; give it when all tasks are done");
  if (command.next && command.task)
    throw std::runtime_error("'--next' and '--task' exclude each other");
  return command;
}

inline int run_tiles_command(Tiles_command& command)
{
  Messages messages(command.volume());
  const CGAL::Point_files_3 points = command.points();
  std::optional<Joined_file> cells, neighbors; // opened before there is any work to lose
  if (!command.join.empty()) {
    const std::filesystem::path file = command.join;
    cells.emplace(points, command.output, file);
    if (command.neighbors)
      neighbors.emplace(points, command.output,
                        file.parent_path() / (file.stem().string() + "-neighbors.npy"));
  }
  const core::Tiles_to_files tiles(command.output, command.threads, command.vtu, command.neighbors);
  // Points that are read at once take memory, too: 70 bytes. If tasks are done one by one, only one
  // is in memory.
  const std::uint64_t at_once = command.next || command.task ? 1 : command.threads;
  command.options.points_at_once =
      std::size_t((std::min)(std::uint64_t(4000000), command.options.memory / at_once / 100));
  command.show_progress(messages);
  if (command.next) {
    std::cout << tiles.next(points, command.options).number << '\n';
    return EXIT_SUCCESS;
  }
  if (command.task) {
    tiles.do_task(points, command.options, *command.task);
    return EXIT_SUCCESS;
  }
  const bool was_done = // and no other file is asked for
      command.join.empty() && !command.neighbors &&
      std::filesystem::exists(std::filesystem::path(command.output) / "tiles.json") &&
      tiles.next(points, command.options).number == 0;
  const CGAL::Tiles_report result = tiles.run(points, command.options);
  messages.clear();
  if (was_done)
    messages.note(command.output +
                  ": an earlier run wrote these tiles; nothing was left to be done");
  Report report(std::cout, command.style());
  report_tiles(command.output, result, report);
  if (cells)
    report("finite cells joined", cells->write());
  if (neighbors)
    neighbors->write("neighbors");
  report.finish();
  return EXIT_SUCCESS;
}

// Adds where help is found to what is wrong with the arguments.
inline Tiles_command parse_with_help(int argc, char* argv[], bool by_mpi)
{
  try {
    return parse_tiles_command(argc, argv, by_mpi);
  } catch (const std::exception& error) {
    throw std::runtime_error(std::string(error.what()) + " (--help explains all options)");
  }
}

inline int tiles_command(int argc, char* argv[])
{
  Tiles_command command = parse_with_help(argc, argv, false);
  try {
    return run_tiles_command(command);
  } catch (const CGAL::Surface_input_error& error) {
    throw std::runtime_error(error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    throw std::runtime_error(error.what());
  }
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_TILES_COMMAND_H
