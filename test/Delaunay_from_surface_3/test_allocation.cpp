// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Whichever allocation fails, an empty triangulation stays empty and usable. Not with
// `Fast_location`: its upper levels are filled by CGAL's own insertion, which keeps a table per
// thread. An exception leaves entries there, and a later insertion into any triangulation of that
// type stumbles on them.

#define BOOST_TEST_MODULE test_allocation
#include <boost/test/included/unit_test.hpp>

#include <Delaunay_from_surface_3_surfaces/sphere.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/insert_surface_points_3.h>

#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

// Allocations until one fails; 0: none fails.
std::size_t countdown = 0;

void* allocate(std::size_t size, std::size_t alignment)
{
  if (countdown > 0 && --countdown == 0)
    throw std::bad_alloc();
  const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
  if (void* p = std::aligned_alloc(alignment, rounded == 0 ? alignment : rounded))
    return p;
  throw std::bad_alloc();
}

// A function of its own: where a compiler sees free() take what operator new has returned, it
// warns.
#if defined(__GNUC__)
__attribute__((noinline))
#endif
void release(void* p) noexcept
{
  std::free(p);
}

} // namespace

void* operator new(std::size_t size)
{
  return allocate(size, alignof(std::max_align_t));
}
void* operator new[](std::size_t size)
{
  return allocate(size, alignof(std::max_align_t));
}
void* operator new(std::size_t size, std::align_val_t a)
{
  return allocate(size, std::size_t(a));
}
void operator delete(void* p) noexcept
{
  release(p);
}
void operator delete[](void* p) noexcept
{
  release(p);
}
void operator delete(void* p, std::size_t) noexcept
{
  release(p);
}
void operator delete[](void* p, std::size_t) noexcept
{
  release(p);
}
void operator delete(void* p, std::align_val_t) noexcept
{
  release(p);
}
void operator delete(void* p, std::size_t, std::align_val_t) noexcept
{
  release(p);
}

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

template <class Triangulation>
void check_failures_one_by_one(const surfaces::Indexed_surface& surface)
{
  const Triangulation stock(surface.points.begin(), surface.points.end());
  std::size_t failures = 0;
  for (bool failed = true; failed; failures += failed) {
    Triangulation tr;
    countdown = failures + 1;
    failed = false;
    try {
      CGAL::insert_surface_points_3(tr, surface.points, surface.faces);
    } catch (const std::bad_alloc&) {
      failed = true;
    } catch (...) {
      countdown = 0; // so that the failure can be reported
      throw;
    }
    countdown = 0;
    if (!failed)
      break;
    BOOST_TEST_REQUIRE(tr.number_of_vertices() == 0u);
    BOOST_TEST_REQUIRE(tr.is_valid());
    if (failures % 16 == 0) {
      tr.insert(surface.points.begin(), surface.points.end());
      BOOST_TEST((tr == stock));
    }
  }
  BOOST_TEST_MESSAGE(failures << " allocations");
  BOOST_TEST(failures > 20u);
}

BOOST_AUTO_TEST_CASE(each_allocation_fails_once)
{
  check_failures_one_by_one<CGAL::Delaunay_triangulation_3<Kernel>>(surfaces::sphere(400, 0.05));
}
