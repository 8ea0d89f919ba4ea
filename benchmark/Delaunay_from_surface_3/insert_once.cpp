// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Inserts the vertices of a mesh once with plain CGAL and once with the default, in functions of
// their own, whose instructions count_instructions.py counts. Prints the number of vertices.
//
// With the name of a method it makes that call alone, and prints what it took: see
// measure_single_calls.py. With that of an order, it inserts point by point in this order, with functions
// of their own for the parts; or, with `plain` or `traces`, by one call.

#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_files/parse_text.h>
#include <Delaunay_from_surface_3_files/read_polygon_soup.h>
#include <Delaunay_from_surface_3_surfaces/io.h>

#include <Delaunay_from_surface_3_meters/Surface_net_rounds.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/Triangulation_target_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/delaunay_3_arrays.h>
#include <CGAL/insert_points_3.h>
#include <CGAL/insert_surface_vertices_3.h>
#include <CGAL/Tracing_traits_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#if defined(CGAL_LINKED_WITH_TBB)
#include <tbb/global_control.h>
#endif

#include <sys/mman.h>
#include <sys/resource.h>

#if defined(__GNUC__)
#define INSERT_ONCE_NOT_INLINE extern "C" __attribute__((noinline))
#else
#define INSERT_ONCE_NOT_INLINE extern "C"
#endif

using Triangulation = CGAL::Delaunay_triangulation_3<CGAL::Epick>;

INSERT_ONCE_NOT_INLINE void insert_once_by_plain_cgal(Triangulation& tr,
                                                      const files::Polygon_soup& soup)
{
  tr.insert(soup.points.begin(), soup.points.end());
}

INSERT_ONCE_NOT_INLINE void insert_once_by_default(Triangulation& tr,
                                                   const files::Polygon_soup& soup)
{
  CGAL::insert_points_3(tr, soup.points, soup.faces);
}

INSERT_ONCE_NOT_INLINE void insert_once_by_traces(Triangulation& tr, const surfaces::Mesh& mesh)
{
  CGAL::insert_surface_vertices_3(tr, mesh, CGAL::Tracing_traits_3());
}

namespace DFS = CGAL::Delaunay_from_surface_3;
using Target = DFS::Triangulation_target_3<Triangulation>;
using Hints = DFS::Planned_hints_3<Target, surfaces::Mesh>;

INSERT_ONCE_NOT_INLINE void insert_once_plan(const std::string& order, const surfaces::Mesh& mesh,
                                             DFS::Insertion_order& plan)
{
  const std::vector<CGAL::Epick::Point_3> points(mesh.points().begin(), mesh.points().end());
  const auto index_map = get(CGAL::vertex_index, mesh);
  if (order == "spatial-sort")
    plan = DFS::Spatial_sort_order()(points, CGAL::Epick(), mesh, index_map);
  else if (order == "nets")
    plan = DFS::Surface_net_rounds()(points, CGAL::Epick(), mesh, index_map);
  else if (order == "paper")
    plan = DFS::Log_star_rounds()(points, CGAL::Epick(), mesh, index_map);
  else
    throw std::runtime_error("no order " + order + ": plain, traces, spatial-sort, nets or paper");
}

INSERT_ONCE_NOT_INLINE void insert_once_locate(const Target& target, std::size_t i,
                                               const Hints& hints, Target::Location& location)
{
  location = target.locate(i, hints.start(i));
}

INSERT_ONCE_NOT_INLINE void insert_once_update(Target& target, std::size_t i, Hints& hints,
                                               const Target::Location& location)
{
  target.insert(i, location, hints);
}

// Where the counts of the first end; there is something in it, or calls would be left out.
INSERT_ONCE_NOT_INLINE void insert_once_between(const Triangulation& tr)
{
  std::cout << tr.number_of_vertices() << "\n";
}

namespace {

using comparison::Json;

double seconds(const timeval& t)
{
  return double(t.tv_sec) + 1e-6 * double(t.tv_usec);
}

// In bytes; Linux only, 0 elsewhere.
std::size_t memory(const char* name)
{
  return 1024 *
         std::strtoull(comparison::value_in_file("/proc/self/status", name).c_str(), nullptr, 10);
}

// Returns the number of finite tetrahedra that a call has made.
using Tetrahedra = std::function<std::size_t()>;

// Each is called once, and what it makes is not destroyed.
Json what_it_takes(const std::function<Tetrahedra()>& call)
{
  std::ofstream("/proc/self/clear_refs") << "5"; // the peak of the reading is forgotten
  const std::size_t before = memory("VmRSS");
  rusage begin = {}, end = {};
  getrusage(RUSAGE_SELF, &begin);
  const double start = comparison::Steady_seconds()();
  const Tetrahedra tetrahedra = call();
  const double wall = comparison::Steady_seconds()() - start;
  getrusage(RUSAGE_SELF, &end);
  const std::size_t peak = memory("VmHWM");
  return {{"tetrahedra", tetrahedra()},
          {"wall", comparison::rounded(wall)},
          {"user", comparison::rounded(seconds(end.ru_utime) - seconds(begin.ru_utime))},
          {"system", comparison::rounded(seconds(end.ru_stime) - seconds(begin.ru_stime))},
          {"faults", end.ru_minflt - begin.ru_minflt + end.ru_majflt - begin.ru_majflt},
          {"bytes_before", before},
          {"bytes_at_peak", peak}};
}

using Methods = std::map<std::string, std::function<Tetrahedra()>>;

template <class Tr>
Tetrahedra tetrahedra_of(const Tr& tr)
{
  return [&tr] { return std::size_t(tr.number_of_finite_cells()); };
}

template <class Concurrency_tag>
Methods methods(Triangulation& tr, const files::Polygon_soup& soup)
{
  using CGAL::insert_points_3;
  const auto& points = soup.points;
  const auto& faces = soup.faces;
  return {
      {"default",
       [&] { return insert_points_3<Concurrency_tag>(tr, points, faces), tetrahedra_of(tr); }},
      {"points", [&] { return insert_points_3<Concurrency_tag>(tr, points), tetrahedra_of(tr); }},
      {"arrays",
       [&] {
         auto* const arrays =
             new auto(CGAL::delaunay_3_arrays<std::int32_t, Concurrency_tag>(points, faces));
         return [arrays] { return arrays->number_of_simplices(); };
       }},
  };
}

#if defined(CGAL_LINKED_WITH_TBB)
// Plain CGAL by many threads, with the grid of locks of its manual's example.
Tetrahedra insert_by_parallel_cgal(const files::Polygon_soup& soup)
{
  using Tds =
      CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_3<CGAL::Epick>,
                                           CGAL::Delaunay_triangulation_cell_base_3<CGAL::Epick>,
                                           CGAL::Parallel_tag>;
  using Parallel_triangulation = CGAL::Delaunay_triangulation_3<CGAL::Epick, Tds>;
  const auto box = CGAL::bbox_3(soup.points.begin(), soup.points.end());
  auto* const locks = new Parallel_triangulation::Lock_data_structure(box, 50);
  auto* const tr = new Parallel_triangulation(CGAL::Epick(), locks);
  tr->insert(soup.points.begin(), soup.points.end());
  return tetrahedra_of(*tr);
}
#endif

Json call_once(const std::string& method, std::size_t threads, const files::Polygon_soup& soup)
{
  auto& tr = *new Triangulation;
  Methods all = threads == 1 ? methods<CGAL::Sequential_tag>(tr, soup)
                             : methods<CGAL::Parallel_if_available_tag>(tr, soup);
  all["plain"] = [&] { return insert_once_by_plain_cgal(tr, soup), tetrahedra_of(tr); };
#if defined(CGAL_LINKED_WITH_TBB)
  all["parallel"] = [&] { return insert_by_parallel_cgal(soup); };
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
#else
  if (threads != 1)
    throw std::runtime_error("built without TBB, so with one thread");
#endif
  const auto found = all.find(method);
  if (found == all.end())
    throw std::runtime_error("no method " + method +
                             ": plain, parallel, default, points or arrays");
  Json report = what_it_takes(found->second);
  report["points"] = soup.points.size();
  return report;
}

// The counts of the parts say what each would save if it cost nothing: with perfect hints, a location.
std::size_t insert_in_order(const std::string& order, const files::Polygon_soup& soup,
                            const surfaces::Mesh& mesh)
{
  Triangulation tr;
  if (order == "plain")
    return insert_once_by_plain_cgal(tr, soup), tr.number_of_vertices();
  if (order == "traces")
    return insert_once_by_traces(tr, mesh), tr.number_of_vertices();
  DFS::Insertion_order plan;
  insert_once_plan(order, mesh, plan);
  std::vector<CGAL::Epick::Point_3> points;
  for (const std::size_t v : plan.order)
    points.push_back(mesh.point(surfaces::Mesh::Vertex_index(std::uint32_t(v))));
  Target target(tr, points);
  Hints hints(target, mesh, plan);
  Target::Location location;
  for (std::size_t i = 0; i < points.size(); ++i) {
    insert_once_locate(target, i, hints, location);
    insert_once_update(target, i, hints, location);
  }
  return tr.number_of_vertices();
}

// The first touch of so many bytes: microseconds per page, the fastest and slowest tenth left out.
Json touch(std::size_t bytes, std::size_t page, int advice)
{
  void* const data =
      mmap(nullptr, bytes + page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (data == MAP_FAILED)
    throw std::runtime_error("so much memory is not to be had");
  char* const first =
      static_cast<char*>(data) + (page - reinterpret_cast<std::uintptr_t>(data) % page) % page;
  madvise(first, bytes, advice);
  std::vector<double> times;
  for (std::size_t at = 0; at + page <= bytes; at += page) {
    const double start = comparison::Steady_seconds()();
    static_cast<volatile char&>(first[at]) = 0;
    times.push_back(1e6 * (comparison::Steady_seconds()() - start));
  }
  munmap(data, bytes + page);
  std::sort(times.begin(), times.end());
  const auto at = [&](std::size_t tenth) {
    return comparison::rounded(times[tenth * (times.size() - 1) / 10], 100);
  };
  return {{"tenth", at(1)}, {"median", at(5)}, {"nine_tenths", at(9)}};
}

#if defined(MADV_HUGEPAGE)
constexpr int in_large_pages = MADV_HUGEPAGE, in_small_pages = MADV_NOHUGEPAGE;
#else
constexpr int in_large_pages = MADV_NORMAL, in_small_pages = MADV_NORMAL;
#endif

Json touch_all(std::size_t bytes)
{
  bytes = (std::max)(bytes, std::size_t(1) << 21);
  return {{"bytes", bytes},
          {"large_page", touch(bytes, std::size_t(1) << 21, in_large_pages)},
          {"small_page", touch(bytes, 4096, in_small_pages)}};
}

} // namespace

int main(int argc, char** argv)
try {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.empty() || words.size() > 3 || words[0] == "--help") {
    std::cerr << "usage: insert_once MESH\n"
                 "       insert_once MESH plain|parallel|default|points|arrays [THREADS]\n"
                 "       insert_once MESH --order plain|traces|spatial-sort|nets|paper\n"
                 "       insert_once --touch BYTES\n";
    return words.size() == 1 ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  if (words[0] == "--touch") {
    std::cout << touch_all(std::stoul(words.at(1))) << "\n";
    return EXIT_SUCCESS;
  }
  const files::Polygon_soup soup = files::read_polygon_soup(words[0]);
  if (words.size() == 3 && words[1] == "--order") {
    std::cout << insert_in_order(words[2], soup, surfaces::read_mesh(words[0])) << "\n";
    return EXIT_SUCCESS;
  }
  if (words.size() >= 2) {
    const std::size_t threads = words.size() == 2 ? 1 : std::stoul(words[2]);
    std::cout << call_once(words[1], threads, soup) << "\n";
    return EXIT_SUCCESS;
  }
  Triangulation expected, tr;
  insert_once_by_plain_cgal(expected, soup);
  insert_once_between(expected);
  insert_once_by_default(tr, soup);
  return tr.number_of_vertices() == expected.number_of_vertices() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch (const std::exception& error) {
  std::cerr << "insert_once: " << error.what() << '\n';
  return EXIT_FAILURE;
}
