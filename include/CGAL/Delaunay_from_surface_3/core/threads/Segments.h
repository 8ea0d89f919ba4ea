// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_SEGMENTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_SEGMENTS_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The numbers first, …, last - 1, cut into as many segments as there are workers. What follows in
// an order by the surface is a patch of it: so workers meet at the seams only. A worker takes
// chunks from the front of its segment; then it takes half of what is left of the largest, from its
// end.
class Segments
{
public:
  using Range = std::pair<std::size_t, std::size_t>;

  Segments(std::size_t first, std::size_t last, std::size_t number)
    : m_first(first)
    , m_segments(number)
  {
    const std::size_t n = last - first;
    for (std::size_t t = 0; t < number; ++t)
      m_segments[t].ends = packed({n / number * t + (std::min)(t, n % number),
                                   n / number * (t + 1) + (std::min)(t + 1, n % number)});
  }

  // The next numbers of worker t, `chunk` or fewer; none if none are left at all.
  Range take(std::size_t t, std::size_t chunk)
  {
    for (;;) {
      std::uint64_t ends = m_segments[t].ends.load();
      Range range = unpacked(ends);
      while (range.first < range.second) {
        const std::size_t next = (std::min)(range.first + chunk, range.second);
        if (m_segments[t].ends.compare_exchange_weak(ends, packed({next, range.second})))
          return {m_first + range.first, m_first + next};
        range = unpacked(ends);
      }
      if (!steal_half_of_largest(t))
        return {m_first, m_first};
    }
  }

private:
  // One segment for one cache line.
  struct alignas(64) Segment
  {
    std::atomic<std::uint64_t> ends{0};
  };

  static std::uint64_t packed(const Range& range)
  {
    return std::uint64_t(range.first) << 32 | std::uint64_t(range.second);
  }
  static Range unpacked(std::uint64_t ends)
  {
    return {std::size_t(ends >> 32), std::size_t(ends & 0xffffffff)};
  }

  // Returns false if nothing is left. Segment t is empty; only its owner fills it.
  bool steal_half_of_largest(std::size_t t)
  {
    for (;;) {
      std::size_t largest = t, most = 0;
      std::uint64_t ends = 0;
      for (std::size_t s = 0; s < m_segments.size(); ++s) {
        const std::uint64_t those = m_segments[s].ends.load();
        const Range range = unpacked(those);
        if (range.first < range.second && range.second - range.first > most)
          largest = s, most = range.second - range.first, ends = those;
      }
      if (most == 0)
        return false;
      const Range range = unpacked(ends);
      const std::size_t middle = range.first + (range.second - range.first) / 2;
      if (m_segments[largest].ends.compare_exchange_strong(ends, packed({range.first, middle}))) {
        m_segments[t].ends.store(packed({middle, range.second}));
        return true;
      }
    }
  }

  std::size_t m_first;
  std::vector<Segment> m_segments;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_SEGMENTS_H
