// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_POINTS_FILE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_POINTS_FILE_H

// How points go to programs of all kinds: the number of points as an unsigned integer of 8 bytes,
// then x, y, z of each as doubles, all in the machine's byte order. And how the programs answer.

#include <chrono>
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

namespace comparison {

// `Points`: a range of anything with x(), y() and z().
template <class Points>
void write_points_file(const Points& points, const std::string& file_name)
{
  std::vector<double> coordinates;
  for (const auto& p : points)
    coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
  const std::uint64_t n = coordinates.size() / 3;
  std::ofstream file(file_name, std::ios::binary);
  file.write(reinterpret_cast<const char*>(&n), sizeof n);
  file.write(reinterpret_cast<const char*>(coordinates.data()),
             static_cast<std::streamsize>(coordinates.size() * sizeof(double)));
  if (!file.flush())
    throw std::runtime_error("cannot write '" + file_name + "'");
}

// x, y, z of the first point, then of the second …
inline std::vector<double> read_points_file(const std::string& file_name)
{
  std::ifstream file(file_name, std::ios::binary);
  std::uint64_t n = 0;
  file.read(reinterpret_cast<char*>(&n), sizeof n);
  std::vector<double> coordinates(file ? 3 * n : 0);
  file.read(reinterpret_cast<char*>(coordinates.data()),
            static_cast<std::streamsize>(coordinates.size() * sizeof(double)));
  if (!file)
    throw std::runtime_error("cannot read points from '" + file_name + "'");
  return coordinates;
}

// What a peer measures: from when this is made, as it has its points the way it wants them, to stop(),
// when it has the tetrahedra. CPU time is that of all threads of the process.
class Stopwatch
{
public:
  void stop()
  {
    m_cpu = std::clock() - m_cpu;
    m_wall = Clock::now() - m_begin;
  }
  double cpu_seconds() const { return double(m_cpu) / CLOCKS_PER_SEC; }
  double wall_seconds() const { return m_wall.count(); }

private:
  using Clock = std::chrono::steady_clock;
  std::clock_t m_cpu = std::clock();
  Clock::time_point m_begin = Clock::now();
  std::chrono::duration<double> m_wall = {};
};

// What it prints at the end: the times, the number of finite tetrahedra and of threads, and of a
// library other than CGAL its name, its version and how it was built.
inline void print_answer(const Stopwatch& watch, std::size_t tetrahedra, unsigned threads = 1,
                         const std::string& library = "", const std::string& built_as = "")
{
  std::printf("cpu_seconds %.6f\nwall_seconds %.6f\ntetrahedra %zu\nthreads %u\n",
              watch.cpu_seconds(), watch.wall_seconds(), tetrahedra, threads);
  if (!library.empty())
    std::printf("library %s%s%s\n", library.c_str(), built_as.empty() ? "" : " ", built_as.c_str());
}

// The whole program, which is called with the number of threads, where it takes one, and the file of
// points: run(threads, coordinates). Returns the exit status.
template <class Run>
int run_peer(const std::string& name, bool has_threads, int argc, char** argv, const Run& run)
try {
  const int threads = has_threads && argc == 3 ? std::atoi(argv[1]) : 1;
  if (argc != 2 + has_threads || threads < 1)
    throw std::runtime_error("usage: " + name + (has_threads ? " THREADS" : "") +
                             " FILE-OF-POINTS");
  run(unsigned(threads), read_points_file(argv[argc - 1]));
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s: %s\n", name.c_str(), error.what());
  return EXIT_FAILURE;
}

} // namespace comparison

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_POINTS_FILE_H
