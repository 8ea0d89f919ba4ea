// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_LARGE_PAGE_ALLOCATOR_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_LARGE_PAGE_ALLOCATOR_H

#include <CGAL/Delaunay_from_surface_3/support/Large_pages.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <limits>
#include <new>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Memory for large arrays that live for a short time and are filled at once: in large pages where
// the system has them at hand.
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
    T* const data = allocate_untouched(n);
    Large_pages(n * sizeof(T)).touch(data, 0, n * sizeof(T));
    return data;
  }

  // For who touches it little by little.
  T* allocate_untouched(std::size_t n)
  {
    if (n > (std::numeric_limits<std::size_t>::max)() / sizeof(T))
      throw std::bad_alloc();
    return static_cast<T*>(::operator new(n * sizeof(T), alignment(n)));
  }

  void deallocate(T* data, std::size_t n) { ::operator delete(data, alignment(n)); }

  friend bool operator==(const Large_page_allocator&, const Large_page_allocator&) { return true; }
  friend bool operator!=(const Large_page_allocator&, const Large_page_allocator&) { return false; }

private:
  static constexpr std::align_val_t alignment(std::size_t n)
  {
    return std::align_val_t(begins_at_large_page(n * sizeof(T)) ? large_page : 64);
  }
};

template <class T>
using Large_vector = std::vector<T, Large_page_allocator<T>>;

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_LARGE_PAGE_ALLOCATOR_H
