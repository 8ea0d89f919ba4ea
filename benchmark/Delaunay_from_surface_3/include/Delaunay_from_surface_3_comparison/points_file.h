// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_POINTS_FILE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_POINTS_FILE_H

// How points go to programs of all kinds: the number of points as an unsigned integer of 8 bytes,
// then x, y, z of each as doubles, all in the machine's byte order; of points with weights x, y, z and
// the weight, which the size of the file tells. And how the programs answer.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <sys/resource.h>

namespace comparison {

template <class Point, class = void>
struct Has_weight : std::false_type
{
};
template <class Point>
struct Has_weight<Point, std::void_t<decltype(std::declval<const Point&>().weight())>>
  : std::true_type
{
};

// `Points`: a range of anything with x(), y() and z(), and with weight() if they have weights.
template <class Points>
void write_points_file(const Points& points, const std::string& file_name)
{
  std::vector<double> numbers;
  std::uint64_t n = 0;
  for (const auto& p : points) {
    numbers.insert(numbers.end(), {p.x(), p.y(), p.z()});
    if constexpr (Has_weight<std::decay_t<decltype(p)>>::value)
      numbers.push_back(p.weight());
    ++n;
  }
  std::ofstream file(file_name, std::ios::binary);
  file.write(reinterpret_cast<const char*>(&n), sizeof n);
  file.write(reinterpret_cast<const char*>(numbers.data()),
             static_cast<std::streamsize>(numbers.size() * sizeof(double)));
  if (!file.flush())
    throw std::runtime_error("cannot write '" + file_name + "'");
}

struct Numbers_of_points
{
  std::vector<double> numbers; // all of the first point, then of the second …
  bool have_weights;           // 4 numbers each, not 3
};

inline Numbers_of_points read_points_file(const std::string& file_name)
{
  std::ifstream file(file_name, std::ios::binary);
  std::uint64_t n = 0;
  file.read(reinterpret_cast<char*>(&n), sizeof n);
  const bool have_weights =
      file && n > 0 && std::filesystem::file_size(file_name) == sizeof n + 4 * n * sizeof(double);
  std::vector<double> numbers(file ? (have_weights ? 4 : 3) * n : 0);
  file.read(reinterpret_cast<char*>(numbers.data()),
            static_cast<std::streamsize>(numbers.size() * sizeof(double)));
  if (!file)
    throw std::runtime_error("cannot read points from '" + file_name + "'");
  return {std::move(numbers), have_weights};
}

// What a peer measures: from when this is made, as it has its points the way it wants them, to stop(),
// when it has the tetrahedra. CPU time is that of all threads of the process.
class Stopwatch
{
public:
  void stop()
  {
    const Used end;
    m_user = end.user - m_begin.user;
    m_system = end.system - m_begin.system;
    m_wall = end.clock - m_begin.clock;
  }
  double user_seconds() const { return m_user; }
  double system_seconds() const { return m_system; }
  double wall_seconds() const { return m_wall.count(); }

private:
  using Clock = std::chrono::steady_clock;

  // By the process until now, in seconds.
  struct Used
  {
    Used()
    {
      rusage usage = {};
      getrusage(RUSAGE_SELF, &usage);
      user = seconds(usage.ru_utime);
      system = seconds(usage.ru_stime);
    }
    static double seconds(const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); }

    double user, system;
    Clock::time_point clock = Clock::now();
  };

  Used m_begin;
  double m_user = 0, m_system = 0;
  std::chrono::duration<double> m_wall = {};
};

// What it prints at the end: the times, the number of finite tetrahedra and of threads, and of a
// library other than CGAL its name, its version and how it was built.
inline void print_answer(const Stopwatch& watch, std::size_t tetrahedra, unsigned threads = 1,
                         const std::string& library = "", const std::string& built_as = "")
{
  std::printf("cpu_seconds %.6f\nuser_seconds %.6f\nsystem_seconds %.6f\nwall_seconds %.6f\n"
              "tetrahedra %zu\nthreads %u\n",
              watch.user_seconds() + watch.system_seconds(), watch.user_seconds(),
              watch.system_seconds(), watch.wall_seconds(), tetrahedra, threads);
  if (!library.empty())
    std::printf("library %s%s%s\n", library.c_str(), built_as.empty() ? "" : " ", built_as.c_str());
}

// The whole program, which is called with the number of threads, where it takes one, and the file of
// points: run(threads, coordinates), or run(threads, numbers, have_weights) if it takes weights.
// Returns the exit status.
template <class Run>
int run_peer(const std::string& name, bool has_threads, int argc, char** argv, const Run& run)
try {
  const int threads = has_threads && argc == 3 ? std::atoi(argv[1]) : 1;
  if (argc != 2 + has_threads || threads < 1)
    throw std::runtime_error("usage: " + name + (has_threads ? " THREADS" : "") +
                             " FILE-OF-POINTS");
  const Numbers_of_points points = read_points_file(argv[argc - 1]);
  if constexpr (std::is_invocable_v<Run, unsigned, const std::vector<double>&, bool>)
    run(unsigned(threads), points.numbers, points.have_weights);
  else if (!points.have_weights)
    run(unsigned(threads), points.numbers);
  else
    throw std::runtime_error("takes no weights");
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s: %s\n", name.c_str(), error.what());
  return EXIT_FAILURE;
}

} // namespace comparison

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_POINTS_FILE_H
