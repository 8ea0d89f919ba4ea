// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_LARGE_PAGE_ALLOCATOR_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_LARGE_PAGE_ALLOCATOR_H

#include <cstddef>
#include <limits>
#include <new>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

constexpr std::size_t large_page = std::size_t(1) << 21;

// Whether an array of so many bytes begins at a large page. Small ones do not take one for
// themselves.
constexpr bool has_large_pages(std::size_t bytes)
{
  return bytes >= 2 * large_page;
}

// Memory for large arrays that live for a short time: in large pages where the system offers them,
// so that their first touch is one page fault instead of 512.
template <class T>
struct Large_page_allocator
{
  using value_type = T;

  Large_page_allocator() = default;
  template <class U>
  Large_page_allocator(const Large_page_allocator<U>&)
  {
  }

  T* allocate(std::size_t n)
  {
    if (n > (std::numeric_limits<std::size_t>::max)() / sizeof(T))
      throw std::bad_alloc();
    void* const data = ::operator new(n * sizeof(T), alignment(n));
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    if (has_large_pages(n * sizeof(T))) // advice: it is no error if it is not taken
      madvise(data, n * sizeof(T) / large_page * large_page, MADV_HUGEPAGE);
#endif
    return static_cast<T*>(data);
  }

  void deallocate(T* data, std::size_t n)
  {
    ::operator delete(data, alignment(n));
  }

  friend bool operator==(const Large_page_allocator&, const Large_page_allocator&)
  {
    return true;
  }
  friend bool operator!=(const Large_page_allocator&, const Large_page_allocator&)
  {
    return false;
  }

private:
  static constexpr std::align_val_t alignment(std::size_t n)
  {
    return std::align_val_t(has_large_pages(n * sizeof(T)) ? large_page : 64);
  }
};

template <class T>
using Large_vector = std::vector<T, Large_page_allocator<T>>;

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_LARGE_PAGE_ALLOCATOR_H
