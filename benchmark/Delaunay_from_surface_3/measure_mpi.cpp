// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures tiles by MPI on the points of an elephant: by one rank, by all and, beside them, the sequential
// call of arrays, first of as many points for any number of ranks, then of as many for each rank. The points
// are in memory, and the tiles are counted, not written. The first rank writes JSON.
//
//   mpirun -n 2 measure_mpi --data meshes --output mpi.json

#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_comparison/run_program.h>
#include <Delaunay_from_surface_3_comparison/surfaces.h>

#include <CGAL/Tiles_by_mpi_3.h>
#include <CGAL/delaunay_3_arrays.h>
#include <CGAL/delaunay_3_tiles.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace {

using comparison::Json;
using Points = std::vector<std::array<double, 3>>;

double rounded(double seconds)
{
  return comparison::rounded(seconds, 1e3);
}

Points points_of_elephant(std::size_t n, const std::string& data)
{
  Points points;
  for (const auto& p : comparison::named_surfaces(data)[1].make(n, 2024).points)
    points.push_back({p.x(), p.y(), p.z()});
  return points;
}

std::string version_of_mpi()
{
  char text[MPI_MAX_LIBRARY_VERSION_STRING] = {};
  int length = 0;
  MPI_Get_library_version(text, &length);
  return std::string(text).substr(0, std::string(text).find(','));
}

// The median of several runs, which are arrays of numbers, by the first of these.
template <class Run>
Json median_of(unsigned runs, const Run& run)
{
  std::vector<Json> results;
  for (unsigned k = 0; k < runs; ++k)
    results.push_back(run());
  std::sort(results.begin(), results.end(),
            [](const Json& a, const Json& b) { return a["seconds"] < b["seconds"]; });
  return results[runs / 2];
}

Json measure_arrays(const Points& points)
{
  const double begin = MPI_Wtime();
  const auto arrays = CGAL::delaunay_3_arrays(points);
  return {{"engine", "arrays"},
          {"points", points.size()},
          {"cells", arrays.number_of_cells()},
          {"seconds", rounded(MPI_Wtime() - begin)}};
}

// By all ranks of a communicator, which have one tile each.
Json measure_tiles(const Points& points, MPI_Comm communicator)
{
  CGAL::Tiles_by_mpi_3 engine(communicator);
  CGAL::Tiles_options options;
  options.number_of_tiles = std::uint32_t(engine.number_of_ranks());
  std::size_t given = 0;
  MPI_Barrier(communicator);
  const double begin = MPI_Wtime();
  const auto report = CGAL::delaunay_3_tiles(
      engine, CGAL::Tile_array_source_3(points.front().data(), points.size()),
      [&](const CGAL::Delaunay_3_tile& tile) { given += tile.number_of_owned_cells; }, options);
  const double seconds = MPI_Wtime() - begin;
  return {{"engine", "mpi"},
          {"ranks", engine.number_of_ranks()},
          {"points", report.points},
          {"cells", report.cells},
          {"told", report.told},
          {"kept", report.kept},
          {"rounds", report.rounds},
          {"bytes_sent_by_first_rank", engine.bytes_sent()},
          {"seconds", rounded(seconds)},
          {"share_of_exchange", rounded(engine.seconds_of_exchange() / seconds)}};
}

} // namespace

int main(int argc, char** argv)
{
  MPI_Init(&argc, &argv);
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  try {
    std::string data = ".";
    std::size_t strong = 2000000, weak = 1000000;
    unsigned runs = 5;
    comparison::Program program("measure_mpi", "Measures tiles by MPI");
    program.option("data", data, "FOLDER", "the folder with refined_elephant.off");
    program.option("strong", strong, "N", "points, for any number of ranks");
    program.option("weak", weak, "N", "points for each rank");
    program.option("runs", runs, "N", "how many, of which the median is given");
    Json report = program.begin(argc, argv);
    report["command"] =
        "mpirun -n " + std::to_string(ranks) + " " + report["command"].get<std::string>();
    report["machine"]["mpi"] = version_of_mpi();
    report["results"] = Json::array();
    MPI_Comm alone = MPI_COMM_NULL;
    MPI_Comm_split(MPI_COMM_WORLD, rank, 0, &alone);
    for (const std::size_t n : {strong, weak}) {
      const Points points = points_of_elephant(n, data),
                   more = points_of_elephant(weak * std::size_t(ranks), data);
      if (rank == 0) { // the others wait
        report["results"].push_back(median_of(runs, [&] { return measure_arrays(points); }));
        report["results"].push_back(median_of(runs, [&] { return measure_tiles(points, alone); }));
      }
      report["results"].push_back(median_of(
          runs, [&] { return measure_tiles(n == strong ? points : more, MPI_COMM_WORLD); }));
    }
    if (rank == 0)
      program.write(report);
  } catch (const std::exception& e) {
    std::cerr << "measure_mpi: " << e.what() << "\n";
    MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
  }
  MPI_Finalize();
  return EXIT_SUCCESS;
}
