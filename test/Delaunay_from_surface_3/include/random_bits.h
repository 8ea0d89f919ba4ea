// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_RANDOM_BITS_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_RANDOM_BITS_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace fuzz {

// The same numbers on every machine, so that a seed repeats a case: the distributions of <random>
// are not specified, its engines are.
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : m_engine(seed)
  {
  }

  std::uint64_t bits() { return m_engine(); }
  std::size_t below(std::size_t n) { return std::size_t(bits() % n); }
  bool one_in(std::size_t n) { return below(n) == 0; }
  // Both included.
  int between(int low, int high) { return low + int(below(std::size_t(high - low) + 1)); }
  // In [0, 1) and (-1, 1).
  double unit() { return std::ldexp(double(bits() >> 11), -53); }
  double signed_unit() { return one_in(2) ? unit() : -unit(); }

  template <class T>
  void shuffle(std::vector<T>& items)
  {
    for (std::size_t i = items.size(); i > 1; --i)
      std::iter_swap(items.begin() + std::ptrdiff_t(i - 1),
                     items.begin() + std::ptrdiff_t(below(i)));
  }

private:
  std::mt19937_64 m_engine;
};

} // namespace fuzz

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_RANDOM_BITS_H
