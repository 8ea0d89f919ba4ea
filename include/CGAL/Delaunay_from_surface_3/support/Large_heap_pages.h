// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_LARGE_HEAP_PAGES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_LARGE_HEAP_PAGES_H

#include <CGAL/Delaunay_from_surface_3/support/Large_page_allocator.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// CGAL's containers take their memory in blocks of less than a megabyte, which glibc cuts, one after
// the other, from the end of the heap of the thread that asks. Left to themselves they are touched
// one small page after the other. Here the heap grows in large steps first, and what it grows by is
// advised to be in large pages. A piece of memory is taken and given back, no more: where malloc
// works in another way, nothing is gained and nothing lost.
class Large_heap_pages
{
public:
  // This thread is to take so many bytes altogether. A few pages are not worth the last of them,
  // which is filled in part.
  explicit Large_heap_pages(std::size_t bytes)
    : m_to_come(bytes >= 8 * large_page ? bytes : 0)
  {
  }

  // It is to take so many of them next.
  void expect(std::size_t bytes)
  {
    if (m_ready < bytes && m_to_come > 0) {
      const std::size_t step = (std::min)(m_to_come, largest_step);
      if (m_ready == 0) // glibc maps a piece of such a size aside, until one has been freed
        grow_heap(step);
      grow_heap(step);
      m_ready = step;
    }
    m_ready -= (std::min)(bytes, m_ready);
    m_to_come -= (std::min)(bytes, m_to_come);
  }

private:
  // Larger pieces than 32 megabytes are mapped aside always.
  static constexpr std::size_t largest_step = std::size_t(30) << 20;

  static void grow_heap(std::size_t bytes)
  {
#if defined(__GLIBC__) && defined(__linux__) && defined(MADV_HUGEPAGE)
    void* const piece = std::malloc(bytes);
    void* begin = piece;
    std::size_t room = bytes;
    if (piece != nullptr && std::align(large_page, large_page, begin, room) != nullptr)
      madvise(begin, room / large_page * large_page, MADV_HUGEPAGE);
    std::free(piece);
#else
    (void)bytes;
#endif
  }

  std::size_t m_to_come;
  std::size_t m_ready = 0; // of what was taken and given back
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_LARGE_HEAP_PAGES_H
