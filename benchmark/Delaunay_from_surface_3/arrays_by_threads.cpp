// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes arrays of the vertices of a mesh by so many of the package's own threads, whatever cores there
// are, and tells for critical_path.py where each phase begins, and which part of it threads share: to
// valgrind, if it runs the program, and by CPU time. Prints the latter as JSON.

#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_files/read_polygon_soup.h>

#include <CGAL/Delaunay_from_surface_3/arrays/arrays_of_built.h>
#include <CGAL/Delaunay_from_surface_3/core/build.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/Thread_executor.h>

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED
#include <CGAL/Delaunay_from_surface_3/core/build_by_threads.h>
#endif

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#else
#define CALLGRIND_DUMP_STATS_AT(text) (void)(text)
#endif

#include <ctime>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <map>
#include <memory>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace core = CGAL::Delaunay_from_surface_3::core;
using comparison::Json;
using Phase = CGAL::Surface_insertion_phase;

double cpu_seconds_of_thread()
{
  timespec t = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

// Adds up what each phase took, by the caller's thread alone and in tasks that threads share.
class Record
{
public:
  void begin(const std::string& phase)
  {
    end_of_part_alone();
    m_phase = phase;
  }

  // To be called by the caller's thread before and after tasks, end_of_task() by the thread of each.
  void begin_tasks()
  {
    end_of_part_alone();
    m_name = &*m_names.insert(m_phase + " shared " + std::to_string(m_names.size())).first;
  }
  void end_of_task() const { CALLGRIND_DUMP_STATS_AT(m_name->c_str()); }
  void end_of_tasks(const std::vector<double>& seconds)
  {
    m_seconds[{m_phase, "shared"}] += std::accumulate(seconds.begin(), seconds.end(), 0.);
    m_start = cpu_seconds_of_thread();
  }

  Json report() const
  {
    Json parts = Json::array();
    for (const auto& [name, seconds] : m_seconds)
      if (name.first != "before")
        parts.push_back({{"phase", name.first},
                         {"part", name.second},
                         {"cpu_seconds", comparison::rounded(seconds)}});
    return parts;
  }

private:
  void end_of_part_alone()
  {
    CALLGRIND_DUMP_STATS_AT(m_names.insert(m_phase + " alone 0").first->c_str());
    m_seconds[{m_phase, "alone"}] += cpu_seconds_of_thread() - m_start;
    m_start = cpu_seconds_of_thread();
  }

  std::set<std::string> m_names; // valgrind reads them later
  const std::string* m_name = nullptr;
  std::string m_phase = "before";
  double m_start = cpu_seconds_of_thread();
  std::map<std::pair<std::string, std::string>, double> m_seconds;
};

class Timed_task final : public core::Task
{
public:
  Timed_task(const core::Task& task, const Record& record, std::vector<double>& seconds)
    : m_task(task)
    , m_record(record)
    , m_seconds(seconds)
  {
  }
  void operator()(std::size_t t) const override
  {
    const double start = cpu_seconds_of_thread();
    m_task(t);
    m_seconds[t] = cpu_seconds_of_thread() - start;
    m_record.end_of_task();
  }

private:
  const core::Task& m_task;
  const Record& m_record;
  std::vector<double>& m_seconds; // of each task
};

class Recorded_threads final : public core::Executor
{
public:
  Recorded_threads(std::size_t number, Record& record)
    : m_threads(number)
    , m_record(record)
  {
  }
  std::size_t number_of_workers() const override { return m_threads.number_of_workers(); }
  void run(std::size_t number, const core::Task& task) const override
  {
    if (number < 2)
      return m_threads.run(number, task);
    m_record.begin_tasks();
    std::vector<double> seconds(number);
    m_threads.run(number, Timed_task(task, m_record, seconds));
    m_record.end_of_tasks(seconds);
  }

private:
  core::Thread_executor m_threads;
  Record& m_record;
};

class Recorded_phases final : public core::Observer
{
public:
  explicit Recorded_phases(Record& record)
    : m_record(record)
  {
  }
  void phase_begins(Phase phase, std::size_t) override
  {
    if (phase == Phase::PLAN)
      m_record.begin("order");
    else if (phase == Phase::SUBGRAPH)
      m_record.begin("permute");
    else if (phase == Phase::INSERTION)
      m_record.begin("insertion");
    else if (phase == Phase::FINISH)
      m_record.begin("export");
  }

private:
  Record& m_record;
};

} // namespace

int main(int argc, char** argv)
{
  if (argc != 3) {
    std::cerr << "usage: arrays_by_threads MESH THREADS\n";
    return EXIT_FAILURE;
  }
  try {
    std::vector<double> coordinates;
    {
      const files::Polygon_soup soup = files::read_polygon_soup(argv[1]);
      for (const auto& p : soup.points)
        coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
    }
    char* volatile large = new char[1 << 20]; // so the allocator joins what it got back now
    delete[] large;
    Record record;
    const Recorded_threads threads(std::size_t(std::max(1, std::atoi(argv[2]))), record);
    Recorded_phases phases(record);
    core::Given_points points(core::Point_array(coordinates.data(), coordinates.size() / 3));
    const auto built = core::build(points, core::Build_options(), phases, threads);
    const auto arrays = core::arrays_of_built<std::int32_t>(*built, points, threads);
    record.begin("after");
    std::cout << Json({{"points", coordinates.size() / 3},
                       {"cells", arrays.number_of_cells()},
                       {"parts", record.report()}})
              << "\n";
  } catch (const std::exception& error) {
    std::cerr << argv[1] << ": " << error.what() << "\n";
    return EXIT_FAILURE;
  }
}
