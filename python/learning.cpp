// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Compares triangulations of points that have moved, and finds edges in a periodic box.

#include "Unlocked.h"
#include "functions.h"
#include "interruptible.h"
#include "numpy_rows.h"

#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/shared_words.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;
namespace core = CGAL::Delaunay_from_surface_3::core;

namespace {

using python::Index;
using python::number_as_met;
using python::Numbers;

// Simplices, copied so that nothing is read that another thread writes meanwhile: their corners
// and, in a box, by how many periods each of these is moved.
struct Simplices
{
  std::size_t number, corners;
  std::vector<Index> points, offsets;

  Simplices(const Numbers& simplices, const py::object& given_offsets, std::size_t n)
  {
    const python::Rows rows(simplices);
    number = rows.size();
    corners = rows.corners();
    points = python::checked_copy(rows, n);
    if (given_offsets.is_none())
      return;
    const auto array =
        given_offsets.cast<py::array_t<Index, py::array::c_style | py::array::forcecast>>();
    if (std::size_t(array.size()) != 3 * points.size())
      throw py::value_error("offsets: expected three for each corner of the simplices");
    offsets.assign(array.data(), array.data() + array.size());
  }

  Index least(std::size_t c) const
  {
    const auto row = points.begin() + std::ptrdiff_t(corners * c);
    return *std::min_element(row, row + std::ptrdiff_t(corners));
  }
};

// Returns the corners in ascending order and, in a box, by how many periods these are moved from
// the first: the same for every order of the corners, and for every copy.
template <std::size_t corners, bool is_in_box>
auto key_of(const Simplices& simplices, std::size_t c)
{
  constexpr std::size_t size = is_in_box ? 4 : 1;
  std::array<std::array<Index, size>, corners> places;
  for (std::size_t k = 0; k < corners; ++k) {
    places[k][0] = simplices.points[corners * c + k];
    for (std::size_t a = 1; a < size; ++a)
      places[k][a] = simplices.offsets[3 * (corners * c + k) + a - 1];
  }
  for (std::size_t last = corners - 1; last > 0; --last) // so few that the simplest way is the best
    for (std::size_t k = 0; k < last; ++k)
      if (places[k + 1] < places[k])
        std::swap(places[k], places[k + 1]);
  std::array<Index, size * corners> key;
  for (std::size_t k = 0; k < corners; ++k)
    for (std::size_t a = 0; a < size; ++a)
      key[size * k + a] = places[k][a] - (a == 0 ? 0 : places[0][a]);
  return key;
}

// Finds simplices with the same least vertex by their keys.
template <class Key>
class Key_table
{
public:
  static constexpr std::uint32_t none = std::uint32_t(-1);

  void reset(std::size_t size)
  {
    m_entries.clear();
    m_mask = 15;
    while (m_mask < 2 * size)
      m_mask = 2 * m_mask + 1;
    m_chains.assign(m_mask + 1, none);
  }

  void add(const Key& key, std::uint32_t number)
  {
    std::uint32_t& chain = m_chains[place(key)];
    m_entries.push_back({key, number, chain});
    chain = std::uint32_t(m_entries.size() - 1);
  }

  // Returns the number that was added with this key, or `none`.
  std::uint32_t find(const Key& key) const
  {
    std::uint32_t i = m_chains[place(key)];
    while (i != none && m_entries[i].key != key)
      i = m_entries[i].next;
    return i == none ? none : m_entries[i].number;
  }

private:
  struct Entry
  {
    Key key;
    std::uint32_t number, next;
  };

  std::size_t place(const Key& key) const
  {
    std::uint64_t hash = 0;
    for (const Index number : key)
      hash = ((hash ^ hash >> 32) + std::uint32_t(number)) * 0x9e3779b97f4a7c15;
    return std::size_t(hash >> 32) & m_mask;
  }

  std::vector<std::uint32_t> m_chains;
  std::size_t m_mask = 0;
  std::vector<Entry> m_entries;
};

// Returns lists of the simplices by their least vertices.
core::Lists<std::uint32_t> by_least_vertex(const Simplices& simplices, std::size_t n,
                                           const core::Executor& executor)
{
  return core::in_lists<std::uint32_t>(n,
                                       core::Listed_items(
                                           simplices.number,
                                           [&](std::size_t c) {
                                             if (c % (1 << 16) == 0)
                                               executor.interruption_point();
                                             return std::size_t(simplices.least(c));
                                           },
                                           [](std::size_t c) { return std::uint32_t(c); }),
                                       executor);
}

// Calls f(c) for each simplex in list v, and prefetches the corners of one that comes later.
template <class F>
void for_each_in_list(const Simplices& simplices, const core::Lists<std::uint32_t>& lists,
                      std::size_t v, const F& f)
{
  const std::uint32_t* const end = lists.items.data() + lists.items.size();
  for (const std::uint32_t* c = lists.begin(v); c != lists.end(v); ++c) {
    if (end - c > std::ptrdiff_t(core::prefetch_distance))
      core::prefetch(simplices.points.data() + simplices.corners * c[core::prefetch_distance]);
    f(*c);
  }
}

// Marks the simplices that both have: those before that stay, and those after that were there.
// Expected linear: only those with the same least of the n vertices are compared, by hashing.
template <std::size_t corners, bool is_in_box>
void mark_common(const Simplices& before, const Simplices& after, std::size_t n,
                 std::vector<char>& stays, std::vector<char>& was_there,
                 const core::Executor& executor)
{
  const core::Lists<std::uint32_t> old_lists = by_least_vertex(before, n, executor);
  const core::Lists<std::uint32_t> new_lists = by_least_vertex(after, n, executor);
  const std::size_t blocks = core::number_of_blocks(executor, n, 4096);
  const auto mark = [&](std::size_t first, std::size_t last, std::size_t) {
    Key_table<decltype(key_of<corners, is_in_box>(before, 0))> table;
    core::Steps step(executor);
    for (std::size_t v = first; v < last; ++v, step()) {
      table.reset(std::size_t(old_lists.end(v) - old_lists.begin(v)));
      for_each_in_list(before, old_lists, v, [&](std::uint32_t c) {
        table.add(key_of<corners, is_in_box>(before, c), c);
        step();
      });
      for_each_in_list(after, new_lists, v, [&](std::uint32_t c) {
        const std::uint32_t old = table.find(key_of<corners, is_in_box>(after, c));
        if (old != table.none)
          stays[old] = was_there[c] = 1;
        step();
      });
    }
  };
  core::for_each_block(executor, n, blocks, mark);
}

// Renumbers the points of both, so that those that are near in space are near in memory. Edges come
// in the order of their points.
void number_alike(Simplices& before, Simplices& after, std::size_t n,
                  const core::Executor& executor)
{
  if (before.corners < 3)
    return;
  const std::vector<Index> met =
      number_as_met(before.points.data(), before.points.size(), n, executor);
  std::vector<Index> number_of(n);
  for (std::size_t i = 0; i < n; ++i)
    number_of[std::size_t(met[i])] = Index(i);
  core::Steps step(executor);
  for (std::size_t i = 0; i < after.points.size(); ++i, step())
    after.points[i] = number_of[std::size_t(after.points[i])];
}

// Returns the places that are not marked, ascending.
std::vector<Index> unmarked(const std::vector<char>& marks)
{
  std::vector<Index> places;
  for (std::size_t i = 0; i < marks.size(); ++i)
    if (!marks[i])
      places.push_back(Index(i));
  return places;
}

using Mark_common = void (*)(const Simplices&, const Simplices&, std::size_t, std::vector<char>&,
                             std::vector<char>&, const core::Executor&);

// Returns nothing for simplices that can have none in common.
Mark_common marker_for(const Simplices& before, const Simplices& after)
{
  const bool is_in_box = !before.offsets.empty() && !after.offsets.empty();
  if (before.corners != after.corners || is_in_box != !before.offsets.empty() ||
      is_in_box != !after.offsets.empty())
    return nullptr;
  switch (before.corners) {
  case 4:
    return is_in_box ? mark_common<4, true> : mark_common<4, false>;
  case 3:
    return is_in_box ? nullptr : mark_common<3, false>;
  case 2:
    return is_in_box ? mark_common<2, true> : mark_common<2, false>;
  case 1:
    return is_in_box ? nullptr : mark_common<1, false>;
  default:
    throw py::value_error("simplices: expected an array of shape (m, d + 1)");
  }
}

// Returns which simplices, or edges, are no longer there, and which are new: places in `before` and
// in `after`. Both are of n points; in a box, offsets of their corners are given.
py::tuple changed_simplices(const Numbers& before, const py::object& offsets_before,
                            const Numbers& after, const py::object& offsets_after, std::size_t n,
                            std::size_t threads)
{
  Simplices old_ones(before, offsets_before, n), new_ones(after, offsets_after, n);
  std::vector<char> stays(old_ones.number, 0), was_there(new_ones.number, 0);
  std::vector<Index> gone, added;
  const Mark_common mark = marker_for(old_ones, new_ones);
  {
    const python::Unlocked unlocked;
    if (mark != nullptr) {
      const python::Interruptible_executor executor(threads);
      number_alike(old_ones, new_ones, n, executor);
      mark(old_ones, new_ones, n, stays, was_there, executor);
    }
    gone = unmarked(stays);
    added = unmarked(was_there);
  }
  const auto number_gone = py::ssize_t(gone.size()), number_added = py::ssize_t(added.size());
  return py::make_tuple(python::array_from(std::move(gone), {number_gone}),
                        python::array_from(std::move(added), {number_added}));
}

// An edge in a box: its ends, and by how many periods the second is moved, if the first is not.
using Edge_in_box = std::array<Index, 5>;

// Adds edges of tetrahedra, each once, in lexicographical order: those between these corners, which
// are one vertex, and vertices with larger numbers, or copies of its own that are moved forwards.
void add_edges(const Simplices& tetrahedra, const std::uint32_t* corner, const std::uint32_t* end,
               std::vector<Edge_in_box>& edges)
{
  const auto old = std::ptrdiff_t(edges.size());
  for (; corner != end; ++corner) {
    const std::size_t from = *corner, first = from - from % 4;
    for (std::size_t k = first; k < first + 4; ++k) {
      Edge_in_box edge{tetrahedra.points[from], tetrahedra.points[k], 0, 0, 0};
      for (std::size_t a = 0; a < 3; ++a)
        edge[2 + a] = tetrahedra.offsets[3 * k + a] - tetrahedra.offsets[3 * from + a];
      if (edge > Edge_in_box{edge[0], edge[0], 0, 0, 0})
        edges.push_back(edge);
    }
  }
  std::sort(edges.begin() + old, edges.end());
  edges.erase(std::unique(edges.begin() + old, edges.end()), edges.end());
}

// Returns the edges of tetrahedra of n points, and by how many periods their second ends are moved.
py::tuple edges_in_box(const Numbers& simplices, const py::object& offsets, std::size_t n,
                       std::size_t threads)
{
  const Simplices tetrahedra(simplices, offsets, n);
  if (tetrahedra.corners != 4 || tetrahedra.offsets.empty() != tetrahedra.points.empty())
    throw py::value_error("simplices: expected tetrahedra with offsets");
  std::vector<Index> ends, moved;
  {
    const python::Unlocked unlocked;
    const python::Interruptible_executor executor(threads);
    const auto vertex_of = [&](std::size_t k) {
      if (k % (1 << 16) == 0)
        executor.interruption_point();
      return std::size_t(tetrahedra.points[k]);
    };
    const core::Lists<std::uint32_t> corners = core::in_lists<std::uint32_t>(
        n,
        core::Listed_items(tetrahedra.points.size(), vertex_of,
                           [](std::size_t k) { return std::uint32_t(k); }),
        executor);
    std::vector<std::vector<Edge_in_box>> found(core::number_of_blocks(executor, n, 4096));
    core::for_each_block(executor, n, found.size(),
                         [&](std::size_t first, std::size_t last, std::size_t b) {
                           core::Steps step(executor);
                           for (std::size_t v = first; v < last; ++v, step())
                             add_edges(tetrahedra, corners.begin(v), corners.end(v), found[b]);
                         });
    for (const std::vector<Edge_in_box>& edges : found)
      for (const Edge_in_box& edge : edges) {
        ends.insert(ends.end(), edge.begin(), edge.begin() + 2);
        moved.insert(moved.end(), edge.begin() + 2, edge.end());
      }
  }
  const auto number = py::ssize_t(ends.size() / 2);
  return py::make_tuple(python::array_from(std::move(ends), {number, 2}),
                        python::array_from(std::move(moved), {number, 3}));
}

} // namespace

void python::define_learning(py::module_& m)
{
  m.def("edges_in_box", &edges_in_box);
  m.def("changed_simplices", &changed_simplices);
}
