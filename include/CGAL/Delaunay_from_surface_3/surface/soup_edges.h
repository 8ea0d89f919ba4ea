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

// Presents edges as items: the list of the upper end gets the lower one.
class Edges_as_items
{
public:
  explicit Edges_as_items(const Large_vector<Numbered_edge>& edges)
    : m_edges(&edges)
  {
  }

  std::size_t size() const { return m_edges->size(); }
  std::size_t list(std::size_t k) const { return (*m_edges)[k].upper; }
  std::uint32_t item(std::size_t k) const { return (*m_edges)[k].lower; }

private:
  const Large_vector<Numbered_edge>* m_edges;
};

// Returns, for each of n vertices, its neighbours with smaller numbers.
inline Lists<std::uint32_t> lower_neighbors(const Large_vector<Numbered_edge>& edges, std::size_t n)
{
  return in_lists<std::uint32_t>(n, Edges_as_items(edges));
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

// Holds the counts made while faces are read.
struct Face_counts
{
  std::size_t sides = 0, non_triangles = 0;
};

// Counts the sides of the faces first, …, last - 1, of which `it` is the first, in numbers[larger
// end]: every edge as often as there are faces that have it.
template <class Iterator>
Face_counts count_sides(Iterator it, std::size_t first, std::size_t last,
                        std::size_t number_of_points, std::uint32_t* numbers)
{
  Face_counts counts;
  for (std::size_t f = first; f < last; ++f, ++it) {
    const auto& face = *it;
    check_face(face, f, number_of_points);
    const auto size = std::distance(std::begin(face), std::end(face));
    counts.sides += std::size_t(size);
    counts.non_triangles += size != 3;
    for_each_side(face, size,
                  [&](std::uint32_t s, std::uint32_t t) { ++numbers[(std::max)(s, t)]; });
  }
  return counts;
}

// Puts the smaller ends of the same sides at the places given for the larger ends. Some hundreds of
// sides are read at a time, so that the memory they lead to is known in advance.
template <class Iterator>
void place_sides(Iterator it, std::size_t number, std::uint32_t* places, std::uint32_t* items)
{
  constexpr std::size_t many = 512;
  Large_vector<Numbered_edge> sides;
  sides.reserve(many + 16);
  for (; number > 0; --number, ++it) {
    const auto& face = *it;
    for_each_side(face, std::distance(std::begin(face), std::end(face)),
                  [&](std::uint32_t s, std::uint32_t t) { sides.emplace_back(s, t); });
    if (sides.size() >= many) {
      place_items(Edges_as_items(sides), places, items);
      sides.clear();
    }
  }
  place_items(Edges_as_items(sides), places, items);
}

// Returns how many blocks there may be: each has a number for every point, and the numbers of all
// blocks but one are together at most four times the items.
inline std::size_t most_blocks(std::size_t points, std::size_t items)
{
  return 1 + 4 * items / (points + 1);
}

// Tells what one thread keeps of the lists first, …, last - 1: the items begin, …, end - 1.
template <class Index>
struct Kept_items
{
  std::size_t first = 0, last = 0;
  Index begin = 0, end = 0;
  std::size_t more_than_twice = 0; // the number of items that came more than twice
};

// Keeps one of the equal items of each of the lists first, …, last - 1, packed at their front.
// Moves the beginnings of all these lists but the first.
template <class Index>
Kept_items<Index> keep_one_of_each(Lists<Index>& lists, std::size_t first, std::size_t last)
{
  Kept_items<Index> all = {first, last, lists.first[first], lists.first[first]};
  // Holds the place of an item among all that are kept, plus 1; it is valid if in the current list.
  Large_vector<Index> place(lists.size(), 0);
  std::vector<unsigned char> times;
  Index k = all.begin;
  for (std::size_t v = first; v < last; ++v) {
    const Index begin = all.end - all.begin, end = lists.first[v + 1];
    if (v != first) // the thread before reads the beginning of the first list
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

// Keeps one of the equal items of each list. Returns how many of them came more than twice.
template <class Index>
std::size_t keep_one_of_each(Lists<Index>& lists, const Executor& executor)
{
  const std::size_t n = lists.size();
  const std::size_t blocks =
      (std::min)(number_of_blocks(executor, n, 4096), most_blocks(n, lists.items.size()));
  std::vector<Kept_items<Index>> kept(blocks);
  for_each_block(executor, n, blocks, [&](std::size_t first, std::size_t last, std::size_t b) {
    if (first < last)
      kept[b] = keep_one_of_each(lists, first, last);
  });
  Index end = 0;
  std::size_t more_than_twice = 0;
  for (const Kept_items<Index>& items : kept) { // close the gaps
    if (items.begin != end)
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
  const std::size_t blocks =
      !has_random_access<FaceRange>
          ? 1
          : (std::min)(number_of_blocks(executor, n, 4096), most_blocks(number_of_points, 3 * n));
  const auto face = [&](std::size_t f) { return std::next(begin, std::ptrdiff_t(f)); };
  const auto first = [&](std::size_t b) { return n * b / blocks; };

  Sort_into_lists<Index> sort(number_of_points, blocks, executor);
  std::vector<Face_counts> counts(blocks);
  sort.count([&](std::size_t b, Index* numbers) {
    counts[b] = count_sides(face(first(b)), first(b), first(b + 1), number_of_points, numbers);
  });
  Face_counts all;
  for (const Face_counts& c : counts) {
    all.sides += c.sides;
    all.non_triangles += c.non_triangles;
  }
  if (all.sides >= too_many)
    return {};
  Lists<Index> lists = sort.place([&](std::size_t b, Index* places, Index* items) {
    place_sides(face(first(b)), first(b + 1) - first(b), places, items);
  });
  const std::size_t non_manifold_edges = keep_one_of_each(lists, executor);

  Soup_edges soup = {true, std::move(lists), std::nullopt};
  if (all.non_triangles + non_manifold_edges > 0)
    soup.irregularity = "faces that are not triangles: " + std::to_string(all.non_triangles) +
                        ", edges with more than two faces: " + std::to_string(non_manifold_edges);
  return soup;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_SOUP_EDGES_H
