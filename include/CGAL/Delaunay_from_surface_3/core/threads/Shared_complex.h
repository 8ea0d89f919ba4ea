// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_SHARED_COMPLEX_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_SHARED_COMPLEX_H

#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Lanes.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/shared_words.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The cells and vertices of a complex that has started, with the lanes of the cells, and fresh
// cells in chunks.
template <class Id>
class Shared_complex
{
  using Complex = Compact_complex<Id>;

public:
  Shared_complex(Complex& complex, unsigned number_of_workers)
    : m_complex(complex)
    , m_lanes(number_of_workers)
  {
  }

  // To be called once the complex has started.
  void begin()
  {
    if (m_lanes.bytes() == nullptr)
      make_room(m_complex.cells_end());
  }

  Complex& complex() { return m_complex; }
  Lanes& lanes() { return m_lanes; }

  // Adds fresh cells, dead ones, to `free_cells`; returns whether there were any. Of all functions
  // here only this may be called by several workers at once.
  bool take_chunk(std::vector<Id>& free_cells)
  {
    constexpr std::size_t chunk = 256;
    const std::size_t first = m_next.fetch_add(chunk, std::memory_order_relaxed);
    const std::size_t last = (std::min)(first + chunk, m_complex.capacity());
    m_complex.touch_cells(first, last);
    for (std::size_t c = last; c-- > first;) {
      for (unsigned k = 0; k < 4; ++k) {
        store_relaxed(m_complex.cell(c).v[k], Id(k == 0 ? Complex::dead : 0));
        store_relaxed(m_complex.cell(c).links[k], Id(0));
      }
      free_cells.push_back(Id(c));
    }
    return first < last;
  }

  // Makes room for at least n cells, all of them available. No worker may run.
  void make_room(std::size_t n)
  {
    const std::size_t used = (std::min)(m_next.load(), m_complex.capacity());
    m_complex.make_room(n);
    m_lanes.reset(m_complex.capacity());
    m_next = (std::max)(used, m_complex.cells_end());
  }

  // More room than before.
  void grow()
  {
    m_complex.use_cells((std::min)(m_next.load(), m_complex.capacity()));
    make_room(Complex::more_room(m_complex.capacity()));
  }

  // All cells are told to the complex, fresh ones too: they are dead. A cell of the infinite vertex
  // is found. The lanes are given back.
  void finish()
  {
    m_lanes.deallocate();
    m_complex.use_cells((std::min)(m_next.load(), m_complex.capacity()));
    for (std::size_t c = m_complex.cells_end(); c-- > 0;)
      if (!Complex::is_dead(m_complex.cell(c)) && Complex::is_infinite(m_complex.cell(c))) {
        m_complex.vertex(Complex::infinite).cell = Id(c);
        break;
      }
  }

private:
  Complex& m_complex;
  Lanes m_lanes;
  std::atomic<std::size_t> m_next{0};
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_SHARED_COMPLEX_H
