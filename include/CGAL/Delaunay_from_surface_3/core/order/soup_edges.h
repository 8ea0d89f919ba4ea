// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_SOUP_EDGES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_SOUP_EDGES_H

// The edges of faces that are lists of points.

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/core/order/lower_neighbors.h>
#include <CGAL/Delaunay_from_surface_3/support/Large_page_allocator.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/blocks.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

struct Soup_edges
{
  bool has_lists = false;
  Lists<std::uint32_t> lower; // of each point those of its neighbours that have smaller numbers
  // None if all faces are triangles and no edge has more than two.
  std::optional<std::string> irregularity;
};

template <class IndexRange>
void check_face(const IndexRange& face, std::size_t f, std::size_t number_of_points)
{
  for (const auto& index : face)
    if (index < decltype(index + 0)(0) || std::size_t(index) >= number_of_points)
      throw Surface_input_error("face " + std::to_string(f) + ": the index " +
                                std::to_string(index) + " is not one of the " +
                                std::to_string(number_of_points) + " points");
}

template <class Range>
constexpr bool has_random_access =
    std::is_convertible<typename std::iterator_traits<decltype(std::begin(
                            std::declval<const Range&>()))>::iterator_category,
                        std::random_access_iterator_tag>::value;

// Of so many faces, from this one on.
template <class Iterator>
std::size_t count_sides(Iterator it, std::size_t number)
{
  std::size_t sides = 0;
  for (; number > 0; --number, ++it) {
    const auto& face = *it;
    sides += std::size_t(std::distance(std::begin(face), std::end(face)));
  }
  return sides;
}

// Appends the sides of the faces with numbers first, …, last - 1, of which `it` is the first: every
// edge as often as there are faces that have it. Returns how many faces are not triangles.
template <class Iterator>
std::size_t append_sides(Iterator it, std::size_t first, std::size_t last,
                         std::size_t number_of_points, Large_vector<Numbered_edge>& sides)
{
  using Index = std::uint32_t;
  std::size_t non_triangles = 0;
  for (std::size_t f = first; f < last; ++f, ++it) {
    const auto& face = *it;
    check_face(face, f, number_of_points);
    const auto k = std::distance(std::begin(face), std::end(face));
    non_triangles += k != 3;
    if (k == 0)
      continue;
    auto s = Index(*std::next(std::begin(face), k - 1));
    for (const auto& index : face) {
      const auto t = Index(index);
      if (s != t)
        sides.emplace_back(s, t);
      s = t;
    }
  }
  return non_triangles;
}

// What one thread keeps of the lists first, …, last - 1: the items begin, …, end - 1.
template <class Index>
struct Kept_items
{
  std::size_t first = 0, last = 0;
  Index begin = 0, end = 0;
  std::size_t more_than_twice = 0; // so many items were there
};

// Keeps one of the equal items of each of the lists first, …, last - 1, whose places are free for
// that. The begins of all but the first are moved.
template <class Index>
Kept_items<Index> keep_one_of_each(Lists<Index>& lists, std::size_t first, std::size_t last)
{
  Kept_items<Index> all = {first, last, lists.first[first], lists.first[first]};
  // Of an item, among all that are kept, and 1; it counts if the list is its own.
  Large_vector<Index> place(lists.size(), 0);
  std::vector<unsigned char> times;
  Index k = all.begin;
  for (std::size_t v = first; v < last; ++v) {
    const Index begin = all.end - all.begin, end = lists.first[v + 1];
    if (v != first) // that of the first list is read by the thread before
      lists.first[v] = all.end;
    times.clear();
    for (; k < end; ++k) {
      const Index u = lists.items[k];
      if (place[u] > begin) {
        unsigned char& t = times[place[u] - 1 - begin];
        all.more_than_twice += t == 2;
        t += t < 3;
      } else {
        lists.items[all.end] = u;
        place[u] = Index(++all.end - all.begin);
        times.push_back(1);
      }
    }
  }
  return all;
}

// Keeps one of the equal items of each list. Returns how many items were there more than twice.
template <class Index>
std::size_t keep_one_of_each(Lists<Index>& lists, const Executor& executor)
{
  const std::size_t n = lists.size(), blocks = number_of_blocks(executor, n, 4096);
  std::vector<Kept_items<Index>> kept(blocks);
  for_each_block(executor, n, blocks, [&](std::size_t first, std::size_t last, std::size_t b) {
    if (first < last)
      kept[b] = keep_one_of_each(lists, first, last);
  });
  Index end = 0;
  std::size_t more_than_twice = 0;
  for (const Kept_items<Index>& items : kept) { // close the gaps
    std::copy(lists.items.begin() + items.begin, lists.items.begin() + items.end,
              lists.items.begin() + end);
    for (std::size_t v = items.first; v < items.last; ++v)
      lists.first[v] -= Index(items.begin - end);
    end += items.end - items.begin;
    more_than_twice += items.more_than_twice;
  }
  lists.first[n] = end;
  lists.items.resize(end);
  return more_than_twice;
}

// The edges of the faces; none if there are more sides than numbers of 32 bits. Linear: the sides of the faces are sorted by counting. Several threads read
// faces in random access.
template <class FaceRange>
Soup_edges soup_edges(const FaceRange& faces, std::size_t number_of_points,
                      const Executor& executor = Alone())
{
  using Index = std::uint32_t;
  const auto begin = std::begin(faces);
  const auto n = std::size_t(std::distance(begin, std::end(faces)));
  const std::size_t blocks = has_random_access<FaceRange> ? number_of_blocks(executor, n, 4096) : 1;
  std::vector<std::size_t> numbers(blocks), non_triangles(blocks);
  for_each_block(executor, n, blocks, [&](std::size_t first, std::size_t last, std::size_t b) {
    numbers[b] = count_sides(std::next(begin, std::ptrdiff_t(first)), last - first);
  });
  const std::size_t number_of_sides =
      std::accumulate(numbers.begin(), numbers.end(), std::size_t(0));
  if ((std::max)(number_of_points, number_of_sides) >= (std::numeric_limits<Index>::max)())
    return {};

  std::vector<Large_vector<Numbered_edge>> sides(blocks);
  for_each_block(executor, n, blocks, [&](std::size_t first, std::size_t last, std::size_t b) {
    sides[b].reserve(numbers[b]);
    non_triangles[b] = append_sides(std::next(begin, std::ptrdiff_t(first)), first, last,
                                    number_of_points, sides[b]);
  });
  Lists<Index> lists = lower_neighbors(sides, number_of_points, executor);
  sides.clear();
  const std::size_t polygons =
      std::accumulate(non_triangles.begin(), non_triangles.end(), std::size_t(0));
  const std::size_t non_manifold_edges = keep_one_of_each(lists, executor);

  Soup_edges soup = {true, std::move(lists), std::nullopt};
  if (polygons + non_manifold_edges > 0)
    soup.irregularity = "faces that are not triangles: " + std::to_string(polygons) +
                        ", edges with more than two faces: " + std::to_string(non_manifold_edges);
  return soup;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_SOUP_EDGES_H
