// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_SPLIT_MIX_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_SPLIT_MIX_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Makes random numbers from the seed alone, with any library: splitmix64 (Steele, Lea, Flood 2014).
class Split_mix
{
public:
  explicit Split_mix(std::uint64_t seed)
    : m_state(seed)
  {
  }

  std::uint64_t operator()()
  {
    std::uint64_t x = m_state += 0x9e3779b97f4a7c15;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
  }

  // Returns one of 0, …, n - 1, for n > 0: the numbers of 64 bits are spread as evenly as possible.
  std::uint64_t below(std::uint64_t n)
  {
    const std::uint64_t x = (*this)();
    if (n >> 32 != 0)
      return x % n;
    return ((x >> 32) * n + ((x & 0xffffffff) * n >> 32)) >> 32; // x n / 2^64
  }

  // Makes every order equally likely, as far as the numbers are random.
  template <class Iterator>
  void shuffle(Iterator first, Iterator last)
  {
    using std::swap;
    for (std::ptrdiff_t n = last - first; n > 1; --n)
      swap(first[n - 1], first[static_cast<std::ptrdiff_t>(below(std::uint64_t(n)))]);
  }

private:
  std::uint64_t m_state;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_SPLIT_MIX_H
