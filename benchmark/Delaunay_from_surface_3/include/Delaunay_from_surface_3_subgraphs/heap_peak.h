// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPHS_HEAP_PEAK_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPHS_HEAP_PEAK_H

// Counts what is allocated by `new`: include it in one file of a program only, as it replaces
// operator new.

#include <malloc.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace subgraphs {

inline std::size_t heap_now = 0, heap_most = 0;

/// How much more than at its construction was allocated at the worst moment since.
class Heap_peak
{
public:
  Heap_peak()
    : m_start(heap_now)
  {
    heap_most = heap_now;
  }
  std::size_t bytes() const { return heap_most - m_start; }

private:
  std::size_t m_start;
};

} // namespace subgraphs

void* operator new(std::size_t size)
{
  void* memory = std::malloc(size);
  if (memory == nullptr)
    throw std::bad_alloc();
  subgraphs::heap_now += malloc_usable_size(memory);
  subgraphs::heap_most = (std::max)(subgraphs::heap_most, subgraphs::heap_now);
  return memory;
}

void operator delete(void* memory) noexcept
{
  if (memory != nullptr)
    subgraphs::heap_now -= malloc_usable_size(memory);
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
  operator delete(memory);
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPHS_HEAP_PEAK_H
