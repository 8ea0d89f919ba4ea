// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_LARGE_PAGES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_LARGE_PAGES_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/shared_words.h>

#include <chrono>
#include <cstddef>
#include <ctime>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

constexpr std::size_t large_page = std::size_t(1) << 21;

// Whether an array of so many bytes begins at a large page. Small ones do not take one for
// themselves.
constexpr bool begins_at_large_page(std::size_t bytes)
{
  return bytes >= 2 * large_page;
}

// What this thread has taken of a processor: on a busy machine the turns of others are not its own.
struct Thread_clock
{
  static std::chrono::nanoseconds now()
  {
#if defined(__linux__)
    timespec t;
    if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t) == 0)
      return std::chrono::seconds(t.tv_sec) + std::chrono::nanoseconds(t.tv_nsec);
#endif
    return std::chrono::nanoseconds(0);
  }
};

// Large pages for the memory of one array, as long as they are cheap: the first touch of one is one
// page fault instead of 512.
//
// Where a host takes free memory back from a virtual machine, it takes large pages, and leaves small
// ones. One that it must give again costs as much as eight or ten do in small pages. So each is
// advised and touched, by the clock, just before it is used, and after the first that is dear there
// are no more. Each array finds out for itself, since what was dear a moment ago may be cheap now,
// and no state has to outlive the array: it loses one page at most. Those that are too small to gain
// as much take none; glibc maps the others aside, so that no advice stays with the heap.
class Large_pages
{
public:
  static constexpr std::size_t fewest = 16;

  Large_pages() = default;
  explicit Large_pages(std::size_t bytes)
    : m_end(bytes >= fewest * large_page ? bytes / large_page * large_page : 0)
  {
  }

  // The bytes first, …, last - 1 of the array, which begins at a large page, are written next, for
  // the first time. Several threads may say so, each of its own.
  template <class Clock = Thread_clock>
  void touch(void* array, std::size_t first, std::size_t last)
  {
    std::size_t at = (first + large_page - 1) / large_page * large_page;
    for (; at < last && at < load_relaxed(m_end); at += large_page)
      if (!is_cheap<Clock>(static_cast<char*>(array) + at))
        store_relaxed(m_end, std::size_t(0));
  }

  // So many bytes are in large pages, if the system has them, once they have been touched.
  std::size_t end() const { return load_relaxed(m_end); }

private:
  // Advice: it is no error if it is not taken. A page at hand takes a tenth of a millisecond, one
  // that is not some five.
  template <class Clock>
  static bool is_cheap(char* page)
  {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    const auto before = Clock::now();
    madvise(page, large_page, MADV_HUGEPAGE);
    *static_cast<volatile char*>(page) = 0;
    return Clock::now() - before < std::chrono::milliseconds(1);
#else
    (void)page;
    return false;
#endif
  }

  std::size_t m_end = 0;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_LARGE_PAGES_H
