// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_MPI_PEER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_MPI_PEER_H

// What programs that run by MPI beside ours have in common: each rank reads its part of a file of
// points, and all tell what they took. They are measured from when all ranks have their points until
// all have their results. One file of a program includes this: what is sent is counted by functions
// that stand before MPI's.

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <mpi.h>
#include <sys/resource.h>

namespace comparison {

using Mpi_peer_point = std::array<double, 3>;

inline std::uint64_t bytes_sent_by_mpi = 0;

inline void count_sent(std::uint64_t number, MPI_Datatype type)
{
  int size = 0;
  PMPI_Type_size(type, &size);
  bytes_sent_by_mpi += number * std::uint64_t(size);
}

struct Mpi_peer_input
{
  int rank = 0, ranks = 1;
  std::uint64_t all = 0, first = 0;   // how many points there are, and the first of this rank
  std::vector<Mpi_peer_point> points; // of this rank
  Mpi_peer_point lowest{}, highest{}; // of all
};

// Of a file as points_file.h has it.
inline Mpi_peer_input read_part(const std::string& file_name)
{
  Mpi_peer_input input;
  MPI_Comm_rank(MPI_COMM_WORLD, &input.rank);
  MPI_Comm_size(MPI_COMM_WORLD, &input.ranks);
  std::ifstream file(file_name, std::ios::binary);
  file.read(reinterpret_cast<char*>(&input.all), sizeof input.all);
  const auto first_of = [&](int rank) {
    return input.all * std::uint64_t(rank) / std::uint64_t(input.ranks);
  };
  input.first = first_of(input.rank);
  input.points.resize(first_of(input.rank + 1) - input.first);
  file.seekg(std::streamoff(sizeof input.all + input.first * sizeof(Mpi_peer_point)));
  file.read(reinterpret_cast<char*>(input.points.data()),
            std::streamsize(input.points.size() * sizeof(Mpi_peer_point)));
  if (!file || input.points.empty())
    throw std::runtime_error("cannot read points from '" + file_name + "'");
  input.lowest = input.highest = input.points.front();
  for (const Mpi_peer_point& p : input.points)
    for (std::size_t i = 0; i < 3; ++i) {
      input.lowest[i] = p[i] < input.lowest[i] ? p[i] : input.lowest[i];
      input.highest[i] = p[i] > input.highest[i] ? p[i] : input.highest[i];
    }
  MPI_Allreduce(MPI_IN_PLACE, input.lowest.data(), 3, MPI_DOUBLE, MPI_MIN, MPI_COMM_WORLD);
  MPI_Allreduce(MPI_IN_PLACE, input.highest.data(), 3, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  return input;
}

// From when all ranks have made one until all have called stop().
class Mpi_stopwatch
{
public:
  void stop()
  {
    m_cpu = double(std::clock()) / CLOCKS_PER_SEC - m_cpu;
    rusage usage = {};
    getrusage(RUSAGE_SELF, &usage);
    m_peak = double(usage.ru_maxrss) * 1024;
    m_sent = bytes_sent_by_mpi - m_sent;
    PMPI_Barrier(MPI_COMM_WORLD);
    m_wall = MPI_Wtime() - m_wall;
  }
  // By the first rank; CPU and bytes of all ranks, memory of that which took most.
  void print(const std::string& library) const
  {
    const double cpu = reduced(m_cpu, MPI_SUM), peak = reduced(m_peak, MPI_MAX),
                 sent = reduced(double(m_sent), MPI_SUM);
    if (is_first())
      std::printf("wall_seconds %.6f\ncpu_seconds %.6f\npeak_bytes_of_a_rank %.0f\n"
                  "bytes_sent %.0f\nlibrary %s\n",
                  m_wall, cpu, peak, sent, library.c_str());
  }
  static double reduced(double value, MPI_Op operation)
  {
    double result = 0;
    PMPI_Reduce(&value, &result, 1, MPI_DOUBLE, operation, 0, MPI_COMM_WORLD);
    return result;
  }
  static bool is_first()
  {
    int rank = 0;
    PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
    return rank == 0;
  }

private:
  static double wall_when_all_are_here()
  {
    PMPI_Barrier(MPI_COMM_WORLD);
    return MPI_Wtime();
  }
  double m_wall = wall_when_all_are_here(), m_cpu = double(std::clock()) / CLOCKS_PER_SEC,
         m_peak = 0;
  std::uint64_t m_sent = bytes_sent_by_mpi;
};

// The sum over all ranks.
inline void print_number(const char* name, double value)
{
  const double sum = Mpi_stopwatch::reduced(value, MPI_SUM);
  if (Mpi_stopwatch::is_first())
    std::printf("%s %.17g\n", name, sum);
}

// The coordinates of the vertices of this rank's cells, one cell after the other, into PREFIX.RANK;
// nothing without a prefix.
inline void write_corners(const std::string& prefix, int rank,
                          const std::vector<Mpi_peer_point>& corners)
{
  if (prefix.empty())
    return;
  std::ofstream file(prefix + "." + std::to_string(rank), std::ios::binary);
  file.write(reinterpret_cast<const char*>(corners.data()),
             std::streamsize(corners.size() * sizeof(Mpi_peer_point)));
  if (!file.flush())
    throw std::runtime_error("cannot write '" + prefix + "'");
}

// run(file of points, tiles of a rank, prefix or nothing), between MPI's beginning and its end.
template <class Run>
int run_mpi_peer(const char* name, int argc, char** argv, const Run& run)
{
  MPI_Init(&argc, &argv);
  try {
    const int tiles = argc == 3 || argc == 4 ? std::atoi(argv[2]) : 0;
    if (tiles <= 0)
      throw std::runtime_error("usage: " + std::string(name) +
                               " FILE-OF-POINTS TILES-OF-A-RANK [PREFIX-OF-CELLS]");
    run(argv[1], tiles, argc == 4 ? argv[3] : "");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name, error.what());
    MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
  }
  MPI_Finalize();
  return EXIT_SUCCESS;
}

} // namespace comparison

// NOLINTBEGIN: the names and the arguments are MPI's.
extern "C" int MPI_Send(const void* buffer, int n, MPI_Datatype type, int to, int tag,
                        MPI_Comm comm)
{
  comparison::count_sent(std::uint64_t(n), type);
  return PMPI_Send(buffer, n, type, to, tag, comm);
}
extern "C" int MPI_Isend(const void* buffer, int n, MPI_Datatype type, int to, int tag,
                         MPI_Comm comm, MPI_Request* request)
{
  comparison::count_sent(std::uint64_t(n), type);
  return PMPI_Isend(buffer, n, type, to, tag, comm, request);
}
extern "C" int MPI_Issend(const void* buffer, int n, MPI_Datatype type, int to, int tag,
                          MPI_Comm comm, MPI_Request* request)
{
  comparison::count_sent(std::uint64_t(n), type);
  return PMPI_Issend(buffer, n, type, to, tag, comm, request);
}
extern "C" int MPI_Alltoallv(const void* sent, const int* numbers, const int* places,
                             MPI_Datatype type, void* received, const int* received_numbers,
                             const int* received_places, MPI_Datatype received_type, MPI_Comm comm)
{
  int rank = 0, ranks = 1;
  PMPI_Comm_rank(comm, &rank);
  PMPI_Comm_size(comm, &ranks);
  for (int r = 0; r < ranks; ++r)
    if (r != rank)
      comparison::count_sent(std::uint64_t(numbers[r]), type);
  return PMPI_Alltoallv(sent, numbers, places, type, received, received_numbers, received_places,
                        received_type, comm);
}
// NOLINTEND

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_MPI_PEER_H
