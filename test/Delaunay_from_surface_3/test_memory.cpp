// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What an insertion needs at the peak, beyond the points, and what it asks of the system. A process
// of its own: the peak is what the system has counted since it began.

#define BOOST_TEST_MODULE test_memory
#include <boost/test/included/unit_test.hpp>

#include <Delaunay_from_surface_3_surfaces/genus_surface.h>

#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/support/Page_array.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_in_files.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>
#include <CGAL/delaunay_3_arrays.h>
#include <CGAL/insert_points_3.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#if defined(__linux__)
#include <malloc.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace {

std::size_t bytes_taken_at_once = 0, bytes_given_back = 0;

} // namespace

#if defined(__linux__)
// Takes the place of the system's, and counts.
extern "C" int madvise(void* begin, std::size_t bytes, int advice) noexcept
{
#if defined(MADV_POPULATE_WRITE)
  if (advice == MADV_POPULATE_WRITE)
    bytes_taken_at_once += bytes;
#endif
  if (advice == MADV_DONTNEED)
    bytes_given_back += bytes;
  return int(syscall(SYS_madvise, begin, bytes, advice));
}
#endif

namespace {

using namespace CGAL::Delaunay_from_surface_3::internal;
using CGAL::Delaunay_from_surface_3::core::take_pages_for_heap;
using Triangulation =
    CGAL::Delaunay_triangulation_3<CGAL::Exact_predicates_inexact_constructions_kernel>;

// In bytes; 0 where the system does not say it.
std::size_t memory(const std::string& name)
{
  std::ifstream status("/proc/self/status");
  std::string word;
  std::size_t kilobytes = 0;
  while (status >> word)
    if (word == name + ":")
      status >> kilobytes;
  return 1024 * kilobytes;
}

// The peak since now is counted anew, if the system allows it.
bool forget_peak()
{
  std::ofstream file("/proc/self/clear_refs");
  file << "5" << std::flush;
  return bool(file) && memory("VmHWM") > 0;
}

template <class Work>
double bytes_per_point(std::size_t n, const Work& work)
{
  const std::size_t before = memory("VmRSS");
  work();
  return double(memory("VmHWM") - before) / double(n);
}

// The parts of memory for which large pages are advised, by name; without one it is that of an array.
std::vector<std::string> in_large_pages()
{
  std::vector<std::string> names;
  std::ifstream parts("/proc/self/smaps");
  std::string name;
  for (std::string line; std::getline(parts, line);) {
    std::istringstream words(line);
    std::string first, word;
    words >> first;
    if (first.find('-') != std::string::npos) {
      name.clear();
      for (int k = 0; k < 5 && words >> word; ++k) // permissions, offset, device, inode, name
        name = k == 4 ? word : "";
    }
    while (first == "VmFlags:" && words >> word)
      if (word == "hg")
        names.push_back(name);
  }
  return names;
}

// How many large pages are advised when the cells are all there, before they are handed over.
struct Visitor_at_export : CGAL::Default_surface_insertion_visitor_3
{
  std::size_t advised = 0, taken_before = 0;
  void phase_begins(CGAL::Surface_insertion_phase phase, std::size_t)
  {
    if (phase == CGAL::Surface_insertion_phase::FINISH)
      advised = in_large_pages().size(), taken_before = bytes_taken_at_once, bytes_given_back = 0;
  }
};

// A clock that says how long the next touch takes.
struct Touch_clock
{
  static std::size_t touches, slow; // the number of one that takes long
  static bool is_before;
  static std::chrono::microseconds now()
  {
    is_before = !is_before;
    if (is_before)
      return std::chrono::microseconds(0);
    return std::chrono::microseconds(touches++ == slow ? 4500 : 90);
  }
};
std::size_t Touch_clock::touches = 0;
std::size_t Touch_clock::slow = 0;
bool Touch_clock::is_before = false;

// Which large pages of memory that begins at one are there, in part at least.
std::vector<std::size_t> large_pages_there(void* begin, std::size_t bytes)
{
  std::vector<std::size_t> pages;
#if defined(__linux__)
  const auto small = std::size_t(sysconf(_SC_PAGESIZE));
  std::vector<unsigned char> is_there((bytes + small - 1) / small);
  BOOST_TEST_REQUIRE(mincore(begin, bytes, is_there.data()) == 0);
  for (std::size_t k = 0; k < is_there.size(); ++k)
    if ((is_there[k] & 1) != 0 && (pages.empty() || pages.back() != k * small / large_page))
      pages.push_back(k * small / large_page);
#else
  (void)begin, (void)bytes;
#endif
  return pages;
}

} // namespace

#if defined(__GLIBC__) && defined(MADV_POPULATE_WRITE)
// The share of the pages that are there in blocks just allocated.
double share_there(std::size_t number, std::size_t size)
{
  constexpr std::size_t page = 4096;
  std::vector<std::unique_ptr<char[]>> blocks;
  std::size_t there = 0, all = 0;
  for (std::size_t k = 0; k < number; ++k) {
    blocks.emplace_back(new char[size]);
    for (std::size_t i = page; i + page < size; i += page, ++all) {
      unsigned char is_there = 0;
      const auto at = reinterpret_cast<std::uintptr_t>(&blocks.back()[i]) / page * page;
      BOOST_TEST_REQUIRE(mincore(reinterpret_cast<void*>(at), page, &is_there) == 0);
      there += is_there & 1;
    }
  }
  return double(there) / double(all);
}

bool takes_pages_at_once()
{
  Page_array<char> array;
  array.reserve(24 * large_page, 0);
  const bool is_able = madvise(array.data(), 4096, MADV_POPULATE_WRITE) == 0;
  if (!is_able)
    BOOST_TEST_MESSAGE("skipped: the system takes pages one by one");
  return is_able;
}

// The first case, since in a heap with gaps blocks may lie elsewhere.
BOOST_AUTO_TEST_CASE(the_heap_keeps_pages_taken_for_it)
{
  if (!takes_pages_at_once())
    return;
  malloc_trim(0);
  BOOST_TEST(share_there(6, 1000000) < 0.2);
  malloc_trim(0);
  take_pages_for_heap(7000000);
  BOOST_TEST(share_there(6, 1000000) > 0.8);
}

// By plain CGAL none; by the export those of all of CGAL's cells, while the core's are given back.
BOOST_AUTO_TEST_CASE(pages_of_cgal_are_taken_at_once)
{
  if (!takes_pages_at_once())
    return;
  const auto surface = surfaces::genus_surface(1, 200000, 0.05);
  bytes_taken_at_once = 0;
  const Triangulation plain(surface.points.begin(), surface.points.end());
  BOOST_TEST(bytes_taken_at_once == 0u);
  Triangulation tr;
  Visitor_at_export visitor;
  malloc_trim(0);
  CGAL::insert_points_3(tr, surface.points, surface.faces,
                        CGAL::parameters::visitor(std::ref(visitor)));
  const double given_back = double(bytes_given_back) / double(tr.tds().number_of_cells());
  BOOST_TEST(given_back > 0.7 * sizeof(CGAL::Delaunay_from_surface_3::core::Compact_cell));
  const double taken = double(bytes_taken_at_once - visitor.taken_before);
  const double needed = double(tr.tds().number_of_cells()) * sizeof(*tr.infinite_cell());
  BOOST_TEST_MESSAGE("taken at once " << taken / needed << " of the bytes of cells");
  BOOST_TEST(taken > 0.9 * needed);
  BOOST_TEST(taken < 1.5 * needed);
}
#endif

// Second: once large blocks were given back, glibc takes larger ones than before from the heap,
// where what lies between them stays.
BOOST_AUTO_TEST_CASE(points_on_a_surface)
{
  if (!forget_peak())
    return;
  const auto surface = surfaces::genus_surface(1, 400000, 0.05);
  BOOST_TEST_REQUIRE(forget_peak());
  const double peak = bytes_per_point(
      surface.points.size(), [&] { CGAL::delaunay_3_arrays(surface.points, surface.faces); });
  BOOST_TEST_MESSAGE("surface: peak " << peak << " bytes per point");
  BOOST_TEST(peak < 300);
}

// Of one tile: while it is made, and while its cells are written.
BOOST_AUTO_TEST_CASE(tile_out_of_core)
{
  if (!forget_peak())
    return;
  const auto folder =
      std::filesystem::temp_directory_path() / ("memory-" + std::to_string(std::random_device()()));
  const auto surface = surfaces::genus_surface(1, 1200000, 0.05);
  std::vector<double> coordinates;
  for (const auto& p : surface.points)
    coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
  const CGAL::Tile_array_source_3 source(coordinates.data(), surface.points.size());
  CGAL::Tiles_options options;
  options.number_of_tiles = 1;
  options.points_at_once = 100000;
  const Tiles_to_files tiles(folder, 1, false);
  for (auto tasks = tiles.next(source, options); tasks.number > 0;
       tasks = tiles.next(source, options))
    for (std::size_t k = 0; k < tasks.number; ++k) {
      BOOST_TEST_REQUIRE(forget_peak());
      const double peak =
          bytes_per_point(surface.points.size(), [&] { tiles.do_task(source, options, k); });
      if (k == 0)
        BOOST_TEST_MESSAGE(tasks.stage << ": peak " << peak << " bytes per point");
      BOOST_TEST(peak < 250);
    }
  std::filesystem::remove_all(folder);
}

// A tile that would need more than it may have is refused before it has it: around a hub, of which it is
// told by others, and between two lines, where few points have many cells. When the array of
// its cells grows, the old one is still there, some 20 MB here, which earlier cases may have left.
BOOST_AUTO_TEST_CASE(tiles_that_are_too_large)
{
  if (!forget_peak())
    return;
  std::vector<double> hub = {0, 0, 0}, lines;
  for (int i = 0; i < 600000; ++i) {
    const double z = 1 - 2 * (i + .5) / 600000, r = std::sqrt(1 - z * z), a = 3.883222077450933 * i;
    hub.insert(hub.end(), {r * std::cos(a), r * std::sin(a), z});
  }
  for (int i = 0; i < 3000; ++i)
    lines.insert(lines.end(), {i / 3000., 0, 0, .5, i / 3000. - .5, 1});
  for (const std::vector<double>& coordinates : {hub, lines}) {
    const CGAL::Tile_array_source_3 source(coordinates.data(), coordinates.size() / 3);
    CGAL::Tiles_options options;
    options.number_of_tiles = 8;
    options.memory = std::uint64_t(50) << 20;
    const auto folder = std::filesystem::temp_directory_path() /
                        ("memory-" + std::to_string(std::random_device()()));
    const std::size_t before = memory("VmRSS");
    BOOST_TEST_REQUIRE(forget_peak());
    BOOST_CHECK_THROW(Tiles_to_files(folder, 1, false).run(source, options),
                      CGAL::Delaunay_from_surface_3::core::Tile_too_large);
    const double share = double(memory("VmHWM") - before) / double(options.memory);
    BOOST_TEST_MESSAGE("refused at " << share << " of the memory allowed");
    BOOST_TEST(share < 1.5);
    std::filesystem::remove_all(folder);
  }
}

BOOST_AUTO_TEST_CASE(points_in_a_cube)
{
  if (!forget_peak()) {
    BOOST_TEST_MESSAGE("skipped: the system does not tell the peak");
    return;
  }
  std::mt19937_64 random(1);
  std::vector<std::array<double, 3>> points(1500000);
  for (auto& p : points)
    for (double& x : p)
      x = std::uniform_real_distribution<double>()(random);
  const std::size_t n = points.size();
  CGAL::Delaunay_3_arrays<> arrays;
  const double peak = bytes_per_point(n, [&] { arrays = CGAL::delaunay_3_arrays(points); });
  BOOST_TEST_MESSAGE(double(arrays.number_of_cells()) / double(n)
                     << " cells per point, peak " << peak << " bytes per point");
  BOOST_TEST(peak < 280);
  const std::size_t kept = memory("VmRSS");
  BOOST_TEST_REQUIRE(forget_peak());
  arrays.separate();
  const double extra = (double(memory("VmHWM")) - double(kept)) / double(n);
  BOOST_TEST_MESSAGE("to separate them: " << extra << " bytes per point more");
  BOOST_TEST(extra < 120);
  arrays.drop_neighbors();
  BOOST_TEST(memory("VmRSS") < kept - 90 * n);
}

#if defined(__linux__)
// How many of the array's bytes are in memory.
std::size_t bytes_there(Page_array<char>& array)
{
  const auto page = std::uintptr_t(sysconf(_SC_PAGESIZE));
  const auto begin = (reinterpret_cast<std::uintptr_t>(array.data()) + page - 1) / page * page;
  const auto end = reinterpret_cast<std::uintptr_t>(array.data() + array.capacity()) / page * page;
  std::vector<unsigned char> is_there((end - begin) / page);
  BOOST_TEST_REQUIRE(mincore(reinterpret_cast<void*>(begin), end - begin, is_there.data()) == 0);
  std::size_t bytes = 0;
  for (const unsigned char there : is_there)
    bytes += (there & 1u) * page;
  return bytes;
}

// What the next call would fault in again. Below 32 MB it is kept, unless a result gives it back.
BOOST_AUTO_TEST_CASE(small_arrays_leave_their_pages_to_the_heap)
{
  for (const std::size_t size : {12 * large_page, 24 * large_page}) {
    Page_array<char> array;
    array.allocate(size);
    std::fill_n(array.data(), size, 'x');
    const std::size_t some = size / 3;
    BOOST_TEST(bytes_there(array) > size - large_page);
    array.release_before_end(0, some);
    if (size < 16 * large_page)
      BOOST_TEST(bytes_there(array) > size - large_page);
    else
      BOOST_TEST(bytes_there(array) < size - some + 2 * large_page);
    array.release(0, some);
    BOOST_TEST(bytes_there(array) < size - some + 2 * large_page);
    BOOST_TEST(std::count(array.data() + some, array.data() + size, 'x') ==
               std::ptrdiff_t(size - some));
  }
}

BOOST_AUTO_TEST_CASE(small_pages_are_taken_before_they_are_written)
{
  Page_array<char> array;
  array.reserve(24 * large_page, 0);
  const std::size_t first = large_page / 2, last = large_page; // in no large page
  BOOST_TEST(bytes_there(array) == 0u);
  array.touch(first, last);
#if defined(__GLIBC__) && defined(MADV_POPULATE_WRITE)
  if (!takes_pages_at_once())
    return;
  BOOST_TEST(bytes_there(array) >= last - first);
  BOOST_TEST(bytes_there(array) <= large_page); // all of it, if large pages are the rule
  BOOST_TEST(array.end_of_pages(first / 3) == large_page);
#endif
}
#endif

// One page at a time, just before it is used, and none any more after one that was dear.
BOOST_AUTO_TEST_CASE(large_pages_are_touched_until_one_is_dear)
{
  constexpr std::size_t pages = 32, bytes = pages * large_page;
  using Allocator = Large_page_allocator<char>;
  const auto give_back = [](char* data) { Allocator().deallocate(data, bytes); };
  const std::unique_ptr<char, decltype(give_back)> data(Allocator().allocate_untouched(bytes),
                                                        give_back);
  Large_pages large(bytes);
  BOOST_TEST(large.end() == bytes);
  BOOST_TEST(Large_pages(16 * large_page - 1).end() == 0u);
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  Touch_clock::touches = 0;
  Touch_clock::slow = 7;
  const auto touch = [&](std::size_t first, std::size_t last) {
    large.touch<Touch_clock>(data.get(), first, last);
    return Touch_clock::touches;
  };
  BOOST_TEST(touch(0, 1) == 1u);
  BOOST_TEST(touch(1, large_page) == 1u);
  BOOST_TEST(touch(1, 5 * large_page) == 5u);
  BOOST_TEST(touch(5 * large_page, 5 * large_page + 100) == 6u);
  BOOST_TEST(touch(5 * large_page + 100, 6 * large_page + 1) == 7u);
  const std::vector<std::size_t> seven = {0, 1, 2, 3, 4, 5, 6}, eight = {0, 1, 2, 3, 4, 5, 6, 7};
  BOOST_TEST(large_pages_there(data.get(), bytes) == seven, boost::test_tools::per_element());
  BOOST_TEST(touch(7 * large_page, bytes) == 8u);
  BOOST_TEST(large.end() == 0u);
  BOOST_TEST(touch(8 * large_page, bytes) == 8u);
  BOOST_TEST(large_pages_there(data.get(), bytes) == eight, boost::test_tools::per_element());
#endif
}

// There is room for more cells than will be used; what is not used is not touched.
BOOST_AUTO_TEST_CASE(cells_are_touched_where_they_are_used)
{
  const std::size_t n = 100000, cells_of_page = large_page / sizeof(Compact_cell);
  Compact_complex<Compact_vertex> complex(n, [](std::size_t i) {
    return std::array<double, 3>{double(i), double(i % 10), 1.};
  });
  complex.start({1, 2, 3, 4});
  const auto there = [&] {
    return large_pages_there(complex.cells(), complex.capacity() * sizeof(*complex.cells())).size();
  };
#if defined(__linux__)
  BOOST_TEST_REQUIRE(complex.capacity() > 16 * cells_of_page);
  BOOST_TEST(there() == 1u);
  while (complex.cells_end() < 2 * cells_of_page)
    complex.cell(complex.new_cell()).v[0] = 0;
  BOOST_TEST(there() == 2u);
  complex.cell(complex.new_cell()).v[0] = 0;
  BOOST_TEST(there() == 3u);
#endif
}

// Meshes of four million points have 7.34 for each.
BOOST_AUTO_TEST_CASE(cells_of_many_points_are_not_moved)
{
  const std::size_t n = 2500000; // room for 14 each would be more than a gigabyte
  Compact_complex<Compact_vertex> complex(n, [](std::size_t i) {
    return std::array<double, 3>{double(i), 0., 0.};
  });
  complex.start({1, 2, 3, 4});
  BOOST_TEST(complex.capacity() >= 8 * n);
}

// Points on two lines have quadratically many.
BOOST_AUTO_TEST_CASE(cells_beyond_expectation_move_seldom)
{
  Compact_complex<Compact_vertex> complex(3000, [](std::size_t i) {
    return std::array<double, 3>{double(i), 0., 0.};
  });
  complex.start({1, 2, 3, 4});
  std::size_t moves = 0;
  while (complex.cells_end() < 2250000) {
    const auto* const before = complex.cells();
    complex.cell(complex.new_cell()).v[0] = 0;
    moves += complex.cells() != before;
  }
  BOOST_TEST(moves <= 3u);
}

// Of few points every array is in small pages, and the heap always is.
BOOST_AUTO_TEST_CASE(large_pages_for_large_arrays_alone)
{
  for (const std::size_t n : {10000, 150000}) {
    const auto surface = surfaces::genus_surface(1, int(n), 0.05);
    Triangulation tr;
    Visitor_at_export visitor;
    CGAL::insert_points_3(tr, surface.points, surface.faces,
                          CGAL::parameters::visitor(std::ref(visitor)));
    BOOST_TEST_MESSAGE(n << " points: " << visitor.advised << " arrays in large pages");
    BOOST_TEST(visitor.advised <= (n < 100000 ? 0u : 2u));
    for (const std::string& name : in_large_pages())
      BOOST_TEST(name != "[heap]");
  }
}

// All of them are on the convex hull: there are two infinite cells for each.
BOOST_AUTO_TEST_CASE(infinite_cells_of_separate_arrays)
{
  if (!forget_peak())
    return;
  std::mt19937_64 random(1);
  std::vector<std::array<double, 3>> points(400000);
  for (auto& p : points) {
    for (double& x : p)
      x = std::normal_distribution<double>()(random);
    const double length = std::hypot(p[0], p[1], p[2]);
    for (double& x : p)
      x /= length;
  }
  CGAL::Delaunay_3_arrays<> arrays = CGAL::delaunay_3_arrays(points);
  arrays.separate();
  const std::size_t infinite = arrays.number_of_cells() - arrays.number_of_simplices();
  BOOST_TEST_REQUIRE(infinite > points.size());
  const std::size_t kept = memory("VmRSS");
  arrays.drop_infinite_cells();
  const double freed = (double(kept) - double(memory("VmRSS"))) / double(infinite);
  BOOST_TEST_MESSAGE("given back: " << freed << " bytes per infinite cell");
  BOOST_TEST(freed > 24); // of 32
}
