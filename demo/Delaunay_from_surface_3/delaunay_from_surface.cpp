// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program delaunay_from_surface reads a surface from a file, and writes the Delaunay
// triangulation of its vertices to another. help.txt says what it can do.

#include "Options.h"
#include "Report.h"
#include "Surface.h"
#include "statistics.h"
#include "tiles_command.h"
#include "write_output.h"
#include "write_view.h"

#include <Delaunay_from_surface_3_files/Output_file.h>
#include <Delaunay_from_surface_3_files/one_line.h>

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/Tracing_traits_3.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <type_traits>
#include <vector>

const int exit_different = 2;

// Shows how many points are inserted, and notes if the surface is odd.
class Progress_visitor : public CGAL::Default_surface_insertion_visitor_3
{
public:
  Progress_visitor(std::size_t number_of_points, Messages& messages)
    : m_messages(messages)
    , m_number_of_points(number_of_points)
  {
  }

  void notice(CGAL::Surface_insertion_notice what, const std::string& reason)
  {
    using Notice = CGAL::Surface_insertion_notice;
    if (what == Notice::SUBGRAPH_IS_REPLACED) {
      m_messages.note(reason + "; a spanning forest serves instead");
    } else if (what == Notice::CORE_IS_REPLACED) {
      m_messages.note(reason + ": CGAL's own insertion takes the compact triangulation's place");
    } else if (what == Notice::ORDER_IS_REPLACED) {
      m_messages.note("another order of the points is tried: " + reason);
      m_next_shown = 0;
      m_order_is_replaced = true;
    } else {
      m_messages.note(reason);
    }
  }

  bool has_replaced_order() const { return m_order_is_replaced; }

  void phase_begins(CGAL::Surface_insertion_phase phase, std::size_t)
  {
    using Phase = CGAL::Surface_insertion_phase;
    if (phase == Phase::PLAN)
      m_messages.step("ordering the points");
    else if (phase == Phase::INSERTION)
      m_messages.step("inserting");
    else if (phase == Phase::FINISH)
      m_messages.step("handing the triangulation over");
  }

  bool go_further(std::size_t inserted)
  {
    if (inserted >= m_next_shown) {
      m_messages.show("inserting: " + std::to_string(100 * inserted / m_number_of_points) + " %");
      m_next_shown = inserted + 4096;
    }
    return true;
  }

private:
  Messages& m_messages;
  std::size_t m_number_of_points, m_next_shown = 0;
  bool m_order_is_replaced = false;
};

#ifdef CGAL_LINKED_WITH_TBB

// Has as many threads as asked for, even more than the machine has. TBB makes them when there is
// work, and ends the process if it cannot; so there is some work at once, before files are opened.
class Threads
{
public:
  explicit Threads(unsigned number)
    : m_limit(tbb::global_control::max_allowed_parallelism, number)
    , m_arena(int(number))
  {
    m_arena.execute([number] { meet(number); });
  }

  template <class F>
  auto execute(const F& f)
  {
    return m_arena.execute(f);
  }

private:
  // Each thread waits for all, but not for long.
  static void meet(unsigned number)
  {
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(500);
    std::atomic<unsigned> here(0);
    const auto wait = [&](unsigned) {
      ++here;
      while (here < number && std::chrono::steady_clock::now() < end)
        std::this_thread::yield();
    };
    tbb::parallel_for(0u, number, wait, tbb::simple_partitioner());
  }

  const tbb::global_control m_limit;
  tbb::task_arena m_arena;
};

#endif // CGAL_LINKED_WITH_TBB

std::string kind_of(const Surface& surface)
{
  if (surface.is_manifold)
    return CGAL::is_triangle_mesh(surface.mesh) ? "triangle mesh" : "polygon mesh";
  if (!surface.weighted.empty())
    return "points with weights";
  return surface.faces.empty() ? "points without faces" : "polygon soup";
}

void report_input(const Options& options, const Surface& surface, Report& report)
{
  report("input", options.input);
  report("surface", kind_of(surface));
  report("surface vertices", surface.points.size());
  report("surface faces", surface.faces.size());
  report("traits", options.traits);
  report("seed", options.seed);
  if (options.threads > 1)
    report("threads", options.threads);
}

// Notes what is good to know but no error.
void note_what_is_odd(const Options& options, const Surface& surface, Messages& messages)
{
  if (surface.collapsed_triangles > 0)
    messages.note(options.input + ": triangles with two corners at one point, left out: " +
                  std::to_string(surface.collapsed_triangles));
  if (surface.announced_points > surface.points.size())
    messages.note(options.input + ": " + std::to_string(surface.announced_points) +
                  " points are announced, and only " + std::to_string(surface.points.size()) +
                  " are there");
  if (surface.has_more)
    messages.note(options.input + ": what follows is passed over, as the header announces only " +
                  std::to_string(surface.points.size()) + " points and " +
                  std::to_string(surface.faces.size() + surface.collapsed_triangles) + " faces");
  if (options.weights) {
    if (!surface.faces.empty())
      messages.note(options.input + ": its faces are passed over, as its points have weights");
  } else if (surface.faces.empty()) {
    messages.note(options.input + ": there are no faces, its points are taken alone");
  } else if (!surface.is_manifold) {
    messages.note(options.input +
                  ": not a consistently oriented manifold mesh, taken as a polygon soup");
  }
}

template <class Tr>
void report_result(const Surface& surface, const Tr& tr,
                   const std::vector<typename Tr::Vertex_handle>& vertices, Report& report)
{
  const auto hidden =
      std::size_t(std::count(vertices.begin(), vertices.end(), typename Tr::Vertex_handle()));
  report("dimension", tr.dimension());
  report("vertices", tr.number_of_vertices());
  report("duplicates", surface.points.size() - hidden - tr.number_of_vertices());
  if (!surface.weighted.empty())
    report("hidden points", hidden);
  report("finite cells", tr.number_of_finite_cells());
  report("cells", tr.number_of_cells());
}

template <class Tr, class Traits>
int run(const Options& options, const Surface& surface, Output& output, Report& report,
        Messages& messages, const Traits& traits)
{
  constexpr bool is_delaunay = std::is_same<Tr, Triangulation>::value;
  Tr tr;
  std::vector<typename Tr::Vertex_handle> vertices;
  Seconds seconds;
  Progress_visitor visitor(surface.points.size(), messages);
  try {
    seconds =
        time_of([&] { vertices = insert_and_watch(tr, surface, traits, options.seed, visitor); });
  } catch (const CGAL::Surface_input_error& error) {
    throw std::runtime_error(options.input + ": " + error.what());
  }
  messages.clear();
  report("CPU seconds", seconds.cpu, 6);
  report_result(surface, tr, vertices, report);
  if constexpr (is_delaunay)
    check_that_view_is_possible(options, tr);
  if (!options.output.empty()) {
    messages.step("writing " + options.output);
    write(options, surface, tr, vertices, output, report, messages);
    messages.clear();
  }
  if constexpr (is_delaunay)
    if (!options.view.empty()) {
      messages.step("writing " + options.view);
      write_view(options, surface, tr, vertices, traits, visitor.has_replaced_order(),
                 output.view(), report, messages);
      messages.clear();
    }
  note_what_is_odd(options, surface, messages); // beside an error it would be in the way

  bool is_equal = true;
  if (options.compare)
    is_equal = compare_with_plain(surface, traits, options.seed, options.repetitions, tr, report,
                                  messages);
  if constexpr (is_delaunay && !std::is_same<Traits, Parallel_traits>::value)
    if (options.stats) {
      messages.step("counting");
      report_surface(surface, tr, vertices, report);
      report_seconds(surface, traits, options.seed, report);
      report_insertions(surface, traits, options.seed, report);
      messages.clear();
    }
  return is_equal ? EXIT_SUCCESS : exit_different;
}

int run(const Options& options, Report& report, Messages& messages)
{
#ifdef CGAL_LINKED_WITH_TBB
  std::optional<Threads> threads;
  if (options.threads > 1)
    threads.emplace(options.threads);
#endif
  Output output(options);
  messages.step("reading " + options.input);
  const Surface surface = read_surface(options.input, options.from, options.weights);
  check_that_there_are_faces(options, surface);
  messages.clear();
  report_input(options, surface, report);
  if (options.traits == "tracing")
    return run<Triangulation>(options, surface, output, report, messages, CGAL::Tracing_traits_3());
  if (options.traits == "plain")
    return run<Triangulation>(options, surface, output, report, messages,
                              CGAL::Plain_insertion_traits_3());
  const auto run_by_default = [&](const auto& traits) {
    return options.weights ? run<Regular>(options, surface, output, report, messages, traits)
                           : run<Triangulation>(options, surface, output, report, messages, traits);
  };
#ifdef CGAL_LINKED_WITH_TBB
  if (threads)
    return threads->execute([&] { return run_by_default(Parallel_traits()); });
#endif
  return run_by_default(CGAL::Surface_insertion_traits_3());
}

// Results go to the standard output, unless the tetrahedra do.
int run(const Options& options)
{
  std::ostream& out = options.output == "-" ? std::cerr : std::cout;
  Report report(out, options.style());
  Messages messages(options.volume());
  files::remove_files_on_signal();
  const int exit_code = run(options, report, messages);
  report.finish();
  return exit_code;
}

// Prints one clear line, whatever went wrong.
int fail(const std::string& message)
{
  std::cout.flush();
  std::cerr << "error: " << files::one_line(message) << '\n';
  return EXIT_FAILURE;
}

bool asks_for_help(int argc, char* argv[])
{
  return std::any_of(argv + 1, argv + argc, [](const std::string& argument) {
    return argument == "--help" || argument == "-h";
  });
}

int main(int argc, char* argv[])
{
  try {
    if (argc > 1 && std::string(argv[1]) == "tiles" && asks_for_help(argc, argv))
      argc = 2, argv[1] = const_cast<char*>("--help"); // the help explains both commands
    if (argc > 1 && std::string(argv[1]) == "tiles") {
      const int exit_code = tiles_command(argc - 1, argv + 1);
      return std::cout.flush() ? exit_code
                               : fail("the results cannot be written to the standard output");
    }
    std::optional<Options> options;
    try {
      options = parse_command_line(argc, argv);
    } catch (const std::exception& error) {
      return fail(std::string(error.what()) + " (--help explains all options)");
    }
    const int exit_code = options ? run(*options) : EXIT_SUCCESS;
    if (!std::cout.flush())
      return fail("the results cannot be written to the standard output");
    return exit_code;
  } catch (const std::bad_alloc&) {
    return fail("there is not enough memory");
  } catch (const std::runtime_error& error) {
    return fail(error.what());
  } catch (const std::exception& error) {
    return fail(std::string("this should not happen, please report it: ") + error.what());
  }
}
