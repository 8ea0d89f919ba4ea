// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Builds the Delaunay triangulation of points in files by the processes that mpirun or srun has
// started, and writes it tile by tile. The first process speaks for all.

#include "Report.h"
#include "tiles_command.h"

#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_in_files.h>
#include <CGAL/Tiles_by_mpi_3.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

const char* const help =
    R"(Usage: mpirun -n RANKS delaunay_from_surface_mpi POINTS... --output FOLDER [OPTION...]

Builds the 3D Delaunay triangulation of more points than one machine holds, in
tiles that the ranks have in memory. POINTS and FOLDER are what they are for
`delaunay_from_surface tiles`, which explains them: all ranks see them by these
names. FOLDER gets cells-T.npy, ids-T.npy and points-T.npy for each tile T, and
tiles.json when all is done and checked; what a run that did not end has left
there is removed.

  -o, --output FOLDER   the folder of the tiles
  --tiles NUMBER        how many tiles (one for each rank and thread)
  --threads NUMBER      how many threads a rank has, up to 64 (1)
  --vtu                 write tile-T.vtu, too, and tiles.pvtu for ParaView
  --join FILE.npy       the first rank writes the cells of all tiles into a file;
                        nothing else is done if they are there already
  --json                print the results as JSON
  --quiet, --verbose    print nothing but errors; say what is done

A rank that fails ends all: its number, and what went wrong, are on one line of
the standard error. Exit code: 0 if all went well, else 1.
)";

// Returns the options that all ranks must share, with their names. Points are compared by value.
std::vector<std::pair<const char*, std::string>> common_options(const Tiles_command& command)
{
  return {{"output", command.output},
          {"join", command.join},
          {"tiles", std::to_string(command.options.number_of_tiles)},
          {"vtu", std::to_string(command.vtu)},
          {"json", std::to_string(command.json)}};
}

void agree_on_command(core::Ranks_of_mpi& ranks, const Tiles_command& command)
{
  const auto options = common_options(command);
  std::vector<std::vector<char>> mine;
  ranks.together([&] {
    for (const auto& option : options)
      mine.emplace_back(option.second.begin(), option.second.end());
  });
  const auto all = ranks.all_gather(mine); // those of rank 0 are first
  ranks.together([&] {
    for (std::size_t k = 0; k < options.size(); ++k)
      if (all[k] != mine[k])
        throw std::runtime_error("was given other options than rank 0: --" +
                                 std::string(options[k].first));
  });
}

// Throws if ranks see different points, which would not be noticed, as each reads only a part of
// them. 64 points are compared; the times of the files may differ.
void agree_on_points(const core::Ranks_of_mpi& ranks, const Tiles_command& command,
                     const CGAL::Point_files_3& points)
{
  std::uint64_t print = 0;
  ranks.together([&] { print = core::fingerprint_of(points, 0); });
  const std::uint64_t n = ranks.of_first(points.size()), theirs = ranks.of_first(print);
  ranks.together([&] {
    if (points.size() != n)
      throw std::runtime_error("sees " + std::to_string(points.size()) + " points, and rank 0 " +
                               std::to_string(n));
    if (print != theirs)
      throw std::runtime_error(command.inputs.front() +
                               ": there are other points in the files than rank 0 sees there");
  });
}

void finish(Report& report)
{
  report.finish();
  if (!std::cout.flush())
    throw std::runtime_error("the results cannot be written to the standard output");
}

// Finishes the work that concerns all tiles, on one rank, when all are written.
void finish(const Tiles_command& command, const CGAL::Tiles_report& result,
            const CGAL::Tiles_by_mpi_3& engine, Joined_file* joined)
{
  core::finish_tiles(command.output, result, command.vtu);
  Report report(std::cout, command.style());
  report_tiles(command.output, result, report);
  report("ranks", engine.number_of_ranks());
  report("bytes sent by rank 0", engine.bytes_sent());
  report("seconds of exchange", engine.seconds_of_exchange(), 3);
  if (joined != nullptr)
    report("finite cells joined", joined->write());
  finish(report);
}

// Joins tiles that were finished before.
void join_alone(const Tiles_command& command, Joined_file& joined)
{
  Report report(std::cout, command.style());
  report("output", command.output);
  report("tiles", core::number_of_tiles_in(command.output));
  report("finite cells joined", joined.write());
  finish(report);
}

// Begins on one rank, and locks the folder. Returns whether all that was asked for is done by then.
bool begin_output(const Tiles_command& command, const CGAL::Point_files_3& points,
                  std::optional<Joined_file>& joined, std::shared_ptr<void>& lock)
{
  if (!command.join.empty())
    joined.emplace(points, command.output, command.join); // before anything is removed
  const bool has_ended =
      !command.join.empty() && !command.vtu && core::tiles_have_ended(command.output, points);
  if (!has_ended)
    lock = core::begin_tiles(command.output, points);
  if (has_ended)
    join_alone(command, *joined);
  return has_ended;
}

void run(Tiles_command& command, core::Ranks_of_mpi& ranks, CGAL::Tiles_by_mpi_3& engine,
         Messages& messages)
{
  const bool is_first = engine.rank() == 0;
  if (is_first)
    command.show_progress(messages);
  if (command.options.number_of_tiles == 0)
    command.options.number_of_tiles =
        unsigned(engine.number_of_ranks()) * unsigned(ranks.of_first(command.threads));
  std::optional<CGAL::Point_files_3> points;
  std::optional<Joined_file> joined; // opened before there is any work to lose
  ranks.together([&] { points.emplace(command.points()); });
  agree_on_points(ranks, command, *points);
  std::shared_ptr<void> lock;
  bool has_ended = false;
  ranks.together([&] { has_ended = is_first && begin_output(command, *points, joined, lock); });
  if (ranks.sum(has_ended ? 1 : 0) > 0)
    return;
  const auto write = [&](const CGAL::Delaunay_3_tile& tile) {
    core::write_tile(command.output, tile, command.vtu);
  };
  const CGAL::Tiles_report result = CGAL::delaunay_3_tiles(engine, *points, write, command.options);
  messages.clear();
  ranks.together([&] {
    if (is_first)
      finish(command, result, engine, joined ? &*joined : nullptr);
  });
}

} // namespace

int main(int argc, char* argv[])
{
  int threads = MPI_THREAD_SINGLE, rank = 0, exit_code = EXIT_SUCCESS;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &threads);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  try {
    Tiles_command command;
    core::Ranks_of_mpi ranks(MPI_COMM_WORLD);
    ranks.together([&] {
      command = parse_with_help(argc, argv, true);
      if (command.threads > 1 && threads < MPI_THREAD_FUNNELED)
        throw std::runtime_error("this MPI does not support threads: use '--threads 1'");
    });
    if (ranks.sum(command.help ? 1 : 0) > 0) {
      std::cout << (rank == 0 ? help : "");
    } else {
      agree_on_command(ranks, command);
      Messages messages(rank > 0 ? Messages::Volume::QUIET : command.volume());
      CGAL::Tiles_by_mpi_3 engine(MPI_COMM_WORLD, command.threads);
      run(command, ranks, engine, messages);
    }
  } catch (const std::exception& e) { // thrown by all
    if (rank == 0)
      std::cerr << "error: " << files::one_line(e.what()) << '\n';
    exit_code = EXIT_FAILURE;
  }
  MPI_Finalize();
  return exit_code;
}
