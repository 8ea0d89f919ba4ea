// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_SPACED_ROUNDS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_SPACED_ROUNDS_H

// The core has these orders: random rounds that grow geometrically, rounds of well-spaced points,
// and for points on a line the order along it.
//
// For spaced rounds, the points are sorted once, by halves. Along that order a point is a centre
// unless one of the last few centres is near; the points that are not centres are the last round.
// The centres are thinned out in the same way for the round before, and so on. A crowded point has
// a small Voronoi cell, so it destroys few cells if it comes late. Its walk starts at the centre
// that was near.
//
// The points themselves tell which distances are near: a fraction of the diagonals of boxes of
// eight successive points, so that neither the scale nor random numbers matter.
//
// Cost: one sort, and linear time after it.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Sort_by_halves.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Split_mix.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Finds the centres of sorted points, each named by its position. They are found in blocks of so many
// points that these hardly matter: the same whatever the number of threads.
class Spaced_centers
{
public:
  using Position = std::uint32_t;
  using Item = Sort_by_halves::Item;

  Spaced_centers(const Item* items, std::size_t n, const Executor& executor)
    : m_items(items)
    , m_executor(executor)
    , m_left(n)
  {
    std::iota(m_left.begin(), m_left.end(), Position(0));
    level.resize(n);
    center = m_left;
    sizes.push_back(n);
    while (m_left.size() > coarsest) {
      thin_out();
      for_each_block(m_executor, m_left.size(), number_of_blocks(m_executor, m_left.size(), block),
                     [this](std::size_t begin, std::size_t end, std::size_t) {
                       for (std::size_t k = begin; k < end; ++k)
                         ++level[m_left[k]];
                     });
      sizes.push_back(m_left.size());
    }
  }

  std::vector<unsigned char> level; // how often a point was a centre: less than 256 times
  std::vector<Position> center;     // the near one when a point was not one; else the point
  std::vector<std::size_t> sizes;   // by level, the number of points of this level or a higher one

private:
  static constexpr std::size_t coarsest = 64, group = 8, window = 6, block = 8192;
  static constexpr double spacing = 0.35;

  // Returns the squared diagonal of the box of the points first, …, last - 1.
  double squared_diagonal(std::size_t first, std::size_t last) const
  {
    double low[3], high[3];
    std::copy(coordinates(first), coordinates(first) + 3, low);
    std::copy(low, low + 3, high);
    for (std::size_t k = first + 1; k < last; ++k)
      for (int i = 0; i < 3; ++i) {
        low[i] = (std::min)(low[i], coordinates(k)[i]);
        high[i] = (std::max)(high[i], coordinates(k)[i]);
      }
    return squared_distance(low, high);
  }

  // Keeps the centres among the points left, about seven eighths of them at most.
  void thin_out()
  {
    const std::size_t n = m_left.size(), blocks = (n + block - 1) / block;
    std::vector<std::size_t> ends(blocks);
    for_each_block(m_executor, blocks, number_of_blocks(m_executor, blocks, 1),
                   [&](std::size_t begin, std::size_t end, std::size_t) {
                     for (std::size_t b = begin; b < end; ++b)
                       ends[b] = thin_out_block(b * block, (std::min)(n, (b + 1) * block));
                   });
    std::size_t m = ends[0];
    for (std::size_t b = 1; b < blocks; ++b)
      m = std::size_t(std::copy(m_left.begin() + std::ptrdiff_t(b * block),
                                m_left.begin() + std::ptrdiff_t(ends[b]),
                                m_left.begin() + std::ptrdiff_t(m)) -
                      m_left.begin());
    if (m > n - n / 8)
      m = every_second(m);
    m_left.resize(m);
  }

  // Moves the centres among the points begin, …, end - 1 to the front. Returns where they end.
  std::size_t thin_out_block(std::size_t begin, std::size_t end)
  {
    const auto squared_diagonal_at = [&](std::size_t first) {
      return squared_diagonal(first, (std::min)(first + group, end));
    };
    std::size_t m = begin;
    double before = squared_diagonal_at(begin), here = before, after = before;
    for (std::size_t first = begin; first < end; first += group) {
      before = here;
      here = after;
      if (first + group < end)
        after = squared_diagonal_at(first + group);
      const double near = spacing * spacing * (before + here + after) / 3;
      for (std::size_t k = first; k < (std::min)(first + group, end); ++k)
        m = keep_or_give_to_center(m_left[k], m, m > begin + window ? m - window : begin, near);
    }
    return m;
  }

  // Adds point i to the centres before m, or gives it to a near one from `oldest` on. Returns the end
  // of the centres.
  std::size_t keep_or_give_to_center(Position i, std::size_t m, std::size_t oldest, double near)
  {
    for (std::size_t c = m; c > oldest; --c)
      if (squared_distance(coordinates(c - 1), m_items[i].coordinates) < near) {
        center[i] = m_left[c - 1];
        return m;
      }
    m_left[m] = i;
    return m + 1;
  }

  // Makes every second of m points the centre of the next, where distances do not help.
  std::size_t every_second(std::size_t m)
  {
    for (std::size_t k = 1; k < m; k += 2)
      center[m_left[k]] = m_left[k - 1];
    for (std::size_t k = 0; k < m; k += 2)
      m_left[k / 2] = m_left[k];
    return (m + 1) / 2;
  }

  const double* coordinates(std::size_t k) const { return m_items[m_left[k]].coordinates; }

  const Item* m_items;
  const Executor& m_executor;
  std::vector<Position> m_left; // ascending
};

// Returns spaced rounds of fewer than 2^32 points, the same whatever the number of threads.
inline Insertion_order spaced_rounds(const Point_array& points, const Executor& executor = Alone())
{
  const std::size_t n = points.size();
  Insertion_order result;
  if (n == 0)
    return result;
  result.order.resize(n);
  std::iota(result.order.begin(), result.order.end(), std::size_t(0));
  Sort_by_halves sort;
  sort(points, result.order.data(), result.order.data() + n, executor);
  const Spaced_centers centers(sort.items(), n, executor);
  const std::vector<std::size_t>& sizes = centers.sizes;
  result.round_ends.assign(sizes.rbegin(), sizes.rend());

  // The next places, by block of positions and by level.
  const std::size_t blocks = number_of_blocks(executor, n, 4096), levels = sizes.size();
  std::vector<std::vector<std::size_t>> next(blocks, std::vector<std::size_t>(levels));
  for_each_block(executor, n, blocks, [&](std::size_t begin, std::size_t end, std::size_t b) {
    for (std::size_t i = begin; i < end; ++i)
      ++next[b][centers.level[i]];
  });
  for (std::size_t level = 0; level < levels; ++level) {
    std::size_t place = level + 1 < levels ? sizes[level + 1] : 0;
    for (auto& of_block : next)
      place += std::exchange(of_block[level], place);
  }
  std::vector<Spaced_centers::Position> places(n); // by position
  for_each_block(executor, n, blocks, [&](std::size_t begin, std::size_t end, std::size_t b) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t place = next[b][centers.level[i]]++;
      places[i] = static_cast<Spaced_centers::Position>(place);
      result.order[place] = sort.items()[i].index;
    }
  });
  result.starting_places.resize(n);
  for_each_block(executor, n, blocks, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t place = places[i], of_center = places[centers.center[i]];
      result.starting_places[place] = of_center != place ? of_center : place - (place > 0);
    }
  });
  return result;
}

// A biased randomised insertion order (Amenta, Choi, Rote 2003) has rounds that grow geometrically,
// each in a spatially coherent order.
//
// Cost: O(n log n) expected.

// Returns …, ⌊ratio ⌊ratio n⌋⌋, ⌊ratio n⌋, n: rounds are cut off at the end until at most
// `first_round` points are left.
inline std::vector<std::size_t> geometric_round_ends(std::size_t n, double ratio,
                                                     std::size_t first_round)
{
  std::vector<std::size_t> ends;
  for (std::size_t end = n; end > 0;) {
    ends.push_back(end);
    end = end <= first_round ? 0 : static_cast<std::size_t>(std::floor(double(end) * ratio));
  }
  std::reverse(ends.begin(), ends.end());
  return ends;
}

// Returns a random order, in these rounds, each sorted by halves.
inline Insertion_order geometric_rounds(const Point_array& points, unsigned int seed, double ratio,
                                        std::size_t first_round)
{
  Insertion_order result;
  result.order.resize(points.size());
  std::iota(result.order.begin(), result.order.end(), std::size_t(0));
  Split_mix(seed).shuffle(result.order.begin(), result.order.end());
  result.round_ends = geometric_round_ends(points.size(), ratio, first_round);
  Sort_by_halves sort;
  std::size_t first = 0;
  for (const std::size_t end : result.round_ends) {
    sort(points, result.order.data() + first, result.order.data() + end);
    first = end;
  }
  return result;
}

// Returns the order of points on a line, in one round: along the axis on which the first two
// different points are farthest apart. Cost: O(n log n), or O(n) if they come in that order.
inline Insertion_order order_along_line(const Point_array& points)
{
  const std::size_t n = points.size();
  std::size_t other = 1, axis = 0;
  while (other < n && std::equal(points[0], points[0] + 3, points[other]))
    ++other;
  for (std::size_t c = 1; other < n && c < 3; ++c)
    if (std::abs(points[other][c] - points[0][c]) > std::abs(points[other][axis] - points[0][axis]))
      axis = c;
  std::vector<std::pair<double, std::size_t>> places(n);
  for (std::size_t i = 0; i < n; ++i)
    places[i] = {points[i][axis], i};
  if (!std::is_sorted(places.begin(), places.end()))
    std::sort(places.begin(), places.end());
  Insertion_order plan;
  plan.order.reserve(n);
  for (const auto& place : places)
    plan.order.push_back(place.second);
  if (n > 0)
    plan.round_ends.push_back(n);
  return plan;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_SPACED_ROUNDS_H
