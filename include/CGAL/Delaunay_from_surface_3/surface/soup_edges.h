// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_SOUP_EDGES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_SOUP_EDGES_H

// Collects the edges of faces that are lists of points.

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/Page_array.h>
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

// A graph is stored in lists, each edge once, at its end with the larger number.

// Holds an edge of a graph whose vertices are numbered, by the larger and the smaller number.
struct Numbered_edge
{
  std::uint32_t upper, lower;

  Numbered_edge(std::uint32_t s, std::uint32_t t)
    : upper((std::max)(s, t))
    , lower((std::min)(s, t))
  {
  }
};

// Returns, for each of n vertices, its neighbours with smaller numbers.
inline Lists<std::uint32_t> lower_neighbors(const Large_vector<Numbered_edge>& edges, std::size_t n)
{
  const auto list_of = [&](std::size_t k) { return std::size_t(edges[k].upper); };
  const auto item_of = [&](std::size_t k) { return edges[k].lower; };
  return in_lists<std::uint32_t>(n, Listed_items(edges.size(), list_of, item_of));
}

struct Soup_edges
{
  bool has_lists = false;
  Lists<std::uint32_t> lower; // lists the neighbours of each point that have smaller numbers
  // Is empty if all faces are triangles and no edge has more than two.
  std::optional<std::string> irregularity;
};

template <class IndexRange>
void check_face(const IndexRange& face, std::size_t f, std::size_t number_of_points)
{
  static_assert(is_index<std::decay_t<decltype(*std::begin(face))>>,
                "faces have indices of points, which are integers: convert other numbers first");
  for (const auto& index : face)
    if (index < decltype(index + 0)(0) || std::size_t(index) >= number_of_points)
      throw Surface_input_error("face " + std::to_string(f) + ": the index " +
                                std::to_string(index) + " is not one of the " +
                                std::to_string(number_of_points) + " points");
}

template <class FaceRange>
void check_faces(const FaceRange& faces, std::size_t number_of_points)
{
  std::size_t f = 0;
  for (const auto& face : faces)
    check_face(face, f++, number_of_points);
}

template <class Range>
constexpr bool has_random_access =
    std::is_convertible<typename std::iterator_traits<decltype(std::begin(
                            std::declval<const Range&>()))>::iterator_category,
                        std::random_access_iterator_tag>::value;

// Calls side(s, t) for each side of a face that joins two points.
template <class IndexRange, class Side>
void for_each_side(const IndexRange& face, std::ptrdiff_t size, const Side& side)
{
  if (size == 0)
    return;
  auto s = std::uint32_t(*std::next(std::begin(face), size - 1));
  for (const auto& index : face) {
    const auto t = std::uint32_t(index);
    if (s != t)
      side(s, t);
    s = t;
  }
}

// Keeps one of the equal items of each list. Returns how many of them came more than twice.
template <class Index>
std::size_t keep_one_of_each(Lists<Index>& lists)
{
  Large_vector<Index> place(lists.size(), 0); // of an item kept, plus 1; valid in the current list
  std::vector<unsigned char> times;           // how often it came; 3 stands for more, too
  std::size_t more_than_twice = 0;
  Index end = 0;
  for (std::size_t v = 0; v < lists.size(); ++v) {
    Index k = std::exchange(lists.first[v], end);
    times.clear();
    for (; k < lists.first[v + 1]; ++k) {
      const Index u = lists.items[k];
      if (place[u] > lists.first[v]) {
        unsigned char& t = times[place[u] - 1 - lists.first[v]];
        more_than_twice += t == 2;
        t += t < 3;
      } else {
        lists.items[end] = u;
        place[u] = ++end;
        times.push_back(1);
      }
    }
  }
  lists.first[lists.size()] = end;
  lists.items.resize(end);
  return more_than_twice;
}

// Returns the edges of the faces, or no lists if points or sides are too many for 32-bit numbers.
// Linear: the sides are sorted by counting, in two passes over the faces. Several threads read the
// faces if these have random access.
template <class FaceRange>
Soup_edges soup_edges(const FaceRange& faces, std::size_t number_of_points,
                      const Executor& executor = Alone())
{
  using Index = std::uint32_t;
  const std::size_t too_many = (std::numeric_limits<Index>::max)();
  if (number_of_points >= too_many) {
    check_faces(faces, number_of_points);
    return {};
  }
  const auto begin = std::begin(faces);
  const auto n = std::size_t(std::distance(begin, std::end(faces)));
  // Each block has a number for every point, so that the numbers of all blocks but one are together
  // at most four times the sides.
  const std::size_t blocks =
      !has_random_access<FaceRange>
          ? 1
          : (std::min)(number_of_blocks(executor, n, 4096), 1 + 12 * n / (number_of_points + 1));
  // Calls visit(face, f, size) for the faces of a block.
  const auto for_each_face = [&](std::size_t b, const auto& visit) {
    std::size_t f = n * b / blocks;
    for (auto it = std::next(begin, std::ptrdiff_t(f)); f < n * (b + 1) / blocks; ++f, ++it) {
      const auto& face = *it;
      visit(face, f, std::distance(std::begin(face), std::end(face)));
    }
  };

  Sort_into_lists<Index> sort(number_of_points, blocks, executor);
  std::vector<std::size_t> sides(blocks, 0), non_triangles(blocks, 0);
  sort.count([&](std::size_t b, Index* numbers) {
    for_each_face(b, [&](const auto& face, std::size_t f, std::ptrdiff_t size) {
      check_face(face, f, number_of_points);
      sides[b] += std::size_t(size);
      non_triangles[b] += size != 3;
      for_each_side(face, size, [&](Index s, Index t) { ++numbers[(std::max)(s, t)]; });
    });
  });
  if (std::accumulate(sides.begin(), sides.end(), std::size_t(0)) >= too_many)
    return {};
  Soup_edges soup;
  soup.has_lists = true;
  soup.lower = sort.place([&](std::size_t b, Index* places, Index* items) {
    for_each_face(b, [&](const auto& face, std::size_t, std::ptrdiff_t size) {
      for_each_side(face, size, [&](Index s, Index t) {
        items[places[(std::max)(s, t)]++] = (std::min)(s, t);
      });
    });
  });
  const std::size_t non_manifold_edges = keep_one_of_each(soup.lower);
  const std::size_t others =
      std::accumulate(non_triangles.begin(), non_triangles.end(), std::size_t(0));
  if (others + non_manifold_edges > 0)
    soup.irregularity = "faces that are not triangles: " + std::to_string(others) +
                        ", edges with more than two faces: " + std::to_string(non_manifold_edges);
  return soup;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_SOUP_EDGES_H
