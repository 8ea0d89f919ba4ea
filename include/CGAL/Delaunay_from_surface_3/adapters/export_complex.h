// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_EXPORT_COMPLEX_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_EXPORT_COMPLEX_H

// Writes the cells into an empty triangulation through the public interface of its data structure.
//
// Cells are made in ascending order, each joined to its neighbours before it, so that a compact cell
// is read once and its memory can take a handle, or go back to the system while CGAL's grows. Linear.

#include <CGAL/Delaunay_from_surface_3/adapters/surface_input.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Page_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/shared_words.h>

#include <CGAL/Triangulation_hierarchy_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Holds the handles of the cells made so far in the memory of the compact cells, from the beginning
// of each block on, so that no other memory is touched. A handle is no larger than a compact cell,
// so the handle of the k-th cell of a block overwrites only the first k, which have been read.
template <class Tds>
class Cells_made
{
  using Cell = typename Tds::Cell;
  using Compact = Compact_cell;
  static_assert(sizeof(Compact) >= sizeof(Cell*), "handles overwrite only what was read");

public:
  using Handle = typename Tds::Cell_handle;

  // Holds the handles of one block, by place in it.
  class Block
  {
  public:
    explicit Block(Compact* first)
      : m_begin(reinterpret_cast<char*>(first))
    {
    }

    const void* address(std::size_t k) const { return m_begin + k * sizeof(Cell*); }
    void set(std::size_t k, Handle handle)
    {
      Cell* const cell = &*handle;
      std::memcpy(m_begin + k * sizeof(Cell*), &cell, sizeof(Cell*));
    }
    Handle operator[](std::size_t k) const
    {
      Cell* cell;
      std::memcpy(&cell, address(k), sizeof(Cell*));
      return Tds::Cell_range::s_iterator_to(*cell);
    }

  private:
    char* m_begin;
  };

  // Each block has `size_of_block` cells, except for the last.
  Cells_made(Built& built, std::size_t size_of_block)
    : m_cells(built.cells)
    , m_size(size_of_block)
  {
  }

  // Returns the block that begins with cell `first`.
  Block block(std::size_t first) const { return Block(m_cells + first); }

  // Returns how many compact cells the handles of `number` cells overwrite.
  static std::size_t cells_overwritten(std::size_t number)
  {
    return (number * sizeof(Cell*) + sizeof(Compact) - 1) / sizeof(Compact);
  }

  const void* address(std::size_t c) const { return block(first(c)).address(c - first(c)); }
  Handle operator[](std::size_t c) const { return block(first(c))[c - first(c)]; }

private:
  // Returns the first cell of the block of cell c.
  std::size_t first(std::size_t c) const { return c < m_size ? 0 : c - c % m_size; }

  Compact* m_cells;
  std::size_t m_size;
};

template <class Tr>
std::true_type has_upper_levels(const Triangulation_hierarchy_3<Tr>*);
std::false_type has_upper_levels(const void*);

// Elements with a time stamp, in CGAL's containers, are made one after the other.
template <class Element>
using Says_of_time_stamp = typename Element::Has_timestamp;

template <class Element>
constexpr bool has_time_stamp = detected_or_t<std::false_type, Says_of_time_stamp, Element>::value;

template <class Range>
std::size_t blocks_of_export(const Executor& executor, std::size_t n)
{
  constexpr std::size_t least = 4096;
  return has_time_stamp<typename Range::value_type> ? 1 : number_of_blocks(executor, n, least);
}

// Calls body(begin, end) for portions of first, …, last - 1, in ascending order, each of which makes
// at most as many elements in `range`. CGAL's containers allocate blocks, each of 16 elements more
// than the last, and touch them page by page; so the heap takes pages for each portion before, and
// for a block more, since the last one may reach beyond.
template <class Range, class Body>
void for_each_portion(const Range& range, std::size_t first, std::size_t last, const Body& body)
{
  constexpr std::size_t portion = large_page / sizeof(Compact_cell); // which is released as a whole
  for (std::size_t begin = first, end; begin < last; begin = end) {
    end = (std::min)(last, begin / portion * portion + portion);
    const std::size_t block = std::size_t(6 * std::sqrt(double(range.capacity())));
    take_pages_for_heap((end - begin + block) * sizeof(typename Range::value_type));
    body(begin, end);
  }
}

// Makes the cells of one block in ascending order, and joins each to its neighbours before it.
template <class Tds>
class Export_block
{
  using Cell_handle = typename Tds::Cell_handle;
  using Numbers = Compact_numbers;
  using Made = Cells_made<Tds>;
  using Block = typename Made::Block;

public:
  // Where a neighbour is not made yet, `scratch` stands for it until it is: which ones these are cannot
  // be predicted. Neighbours in later blocks are kept in pairs.
  template <class Vertex>
  void make(typename Tds::Cell_range& range, Built& built, const std::vector<Vertex>& vertices,
            Block cells, Cell_handle scratch, std::size_t first, std::size_t last)
  {
    // Before this cell there are handles to keep.
    const std::size_t kept = first + Made::cells_overwritten(last - first);
    for_each_portion(range, first, last, [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c < end; ++c) {
        const Compact_cell cell = built.cells[c];
        const std::size_t own = c - first;
        cells.set(own, scratch);
        fetch_ahead(built, cells, c, first, last);
        if (Numbers::is_dead(cell))
          continue;
        const Cell_handle made = range.emplace(vertices[cell.v[0]], vertices[cell.v[1]],
                                               vertices[cell.v[2]], vertices[cell.v[3]]);
        for (int i = 0; i < 4; ++i) {
          const Id neighbor = cell.neighbors[i];
          const Cell_handle there = cells[place_or(neighbor, first, own)];
          made->set_neighbor(i, there);
          there->set_neighbor(int(neighbor & 3), made);
          if (std::size_t(neighbor >> 2) >= last)
            m_neighbors_out.push_back({Numbers::encode(Id(c), unsigned(i)), neighbor});
        }
        cells.set(own, made);
      }
      if (end > kept)
        built.release_cells((std::max)(begin, kept), end);
    });
  }

  // To be called when all blocks have made their cells: sets part `part` of `parts`.
  void set_neighbors_out(const Made& cells, std::size_t part, std::size_t parts) const
  {
    const std::size_t n = m_neighbors_out.size(), last = n * (part + 1) / parts;
    for (std::size_t k = n * part / parts; k < last; ++k) {
      const Neighbors_out& ahead = m_neighbors_out[(std::min)(k + prefetch_distance, last - 1)];
      prefetch(cells.address(ahead.there >> 2));
      const Neighbors_out& near = m_neighbors_out[(std::min)(k + prefetch_distance / 2, last - 1)];
      prefetch(&*cells[near.there >> 2]);
      const Neighbors_out& out = m_neighbors_out[k];
      const Cell_handle here = cells[out.here >> 2], there = cells[out.there >> 2];
      here->set_neighbor(int(out.here & 3), there);
      there->set_neighbor(int(out.there & 3), here);
    }
  }

private:
  struct Neighbors_out
  {
    Id here, there;
  };

  // Returns the place of a neighbour in its block, or `own` if the neighbour is in a block before or
  // not made yet.
  static std::size_t place_or(Id neighbor, std::size_t first, std::size_t own)
  {
    return (std::min)(std::size_t(neighbor >> 2) - first, own);
  }

  // Prefetches handles some cells ahead, and then what will be written: the neighbours, with which
  // CGAL's cells begin, often lie in two cache lines. The distances were chosen by trial; no
  // measurement of them is kept.
  static void fetch_ahead(const Built& built, const Block& cells, std::size_t c, std::size_t first,
                          std::size_t last)
  {
    constexpr std::size_t handles_ahead = 32, cells_ahead = 16;
    for (const Id neighbor : built.cells[(std::min)(c + handles_ahead, last - 1)].neighbors)
      prefetch(cells.address(place_or(neighbor, first, c - first)));
    for (const Id neighbor : built.cells[(std::min)(c + cells_ahead, last - 1)].neighbors)
      prefetch(reinterpret_cast<const Cell_handle*>(&*cells[place_or(neighbor, first, c - first)]) +
               (neighbor & 3));
  }

  std::vector<Neighbors_out> m_neighbors_out;
};

// Makes the cells. Returns their handles by cell, which lie in the memory of the compact cells.
template <class Tds, class Vertex>
Cells_made<Tds> export_cells(Tds& tds, Built& built, const std::vector<Vertex>& vertices,
                             typename Tds::Cell_handle scratch, const Executor& executor)
{
  using Range = typename Tds::Cell_range;
  const std::size_t n = built.cells_end, number = blocks_of_export<Range>(executor, n);
  const Cells_made<Tds> cells(built, size_of_block(n, number));
  std::vector<Range> ranges(number);
  std::vector<Export_block<Tds>> blocks(number);
  ranges[0].swap(tds.cells());
  for_each_block(executor, n, number, [&](std::size_t first, std::size_t last, std::size_t b) {
    const auto own = b == 0 ? scratch : ranges[b].emplace();
    blocks[b].make(ranges[b], built, vertices, cells.block(first), own, first, last);
    ranges[b].erase(own);
  });
  for_each_block(executor, number, number, [&](std::size_t, std::size_t, std::size_t part) {
    for (const auto& block : blocks)
      block.set_neighbors_out(cells, part, number);
  });
  for (Range& range : ranges)
    tds.cells().merge(range);
  return cells;
}

// Returns the k-th vertex to be created, k > 0: in the order of the numbers, or, if `order` is not
// null, in the order in which that first names points.
struct Creation_order
{
  const std::vector<std::size_t>* order;
  const Id* vertices; // by point
  bool is_own() const { return order == nullptr; }
  std::size_t operator()(std::size_t k) const
  {
    return is_own() ? k : std::size_t(vertices[(*order)[k - 1]]);
  }
};

// Makes the vertices, except for the infinite one. Returns their handles by vertex, or null handles
// for numbers without a vertex. point(v) and in_order(k) are as in export_complex().
template <class Triangulation, class PointOf, class InOrder>
std::vector<typename Triangulation::Vertex_handle>
export_vertices(Triangulation& tr, std::size_t end, const PointOf& point, const InOrder& in_order,
                const Executor& executor)
{
  using Range = typename Triangulation::Triangulation_data_structure::Vertex_range;
  std::vector<typename Triangulation::Vertex_handle> vertices(end);
  vertices[0] = tr.infinite_vertex();
  const std::size_t number = in_order.is_own() ? blocks_of_export<Range>(executor, end) : 1;
  std::vector<Range> ranges(number);
  ranges[0].swap(tr.tds().vertices());
  for_each_block(executor, end, number, [&](std::size_t first, std::size_t last, std::size_t b) {
    const auto make = [&](std::size_t k, std::size_t portion_end) {
      for (; k < portion_end; ++k) {
        const std::size_t v = in_order(k);
        const bool is_new = vertices[v] == typename Triangulation::Vertex_handle();
        if (const auto* const p = is_new ? point(v) : nullptr) {
          vertices[v] = ranges[b].emplace();
          vertices[v]->set_point(*p);
        }
      }
    };
    for_each_portion(ranges[b], (std::max)(first, std::size_t(1)), last, make);
  });
  for (Range& range : ranges)
    tr.tds().vertices().merge(range);
  return vertices;
}

// Fills `tr`, which is empty, and gives up the memory of `built`. point(v) leads to the point of
// vertex v, or is null if that vertex is in no cell. The vertices are made in the order in which
// in_order(1), … first names them; in_order.is_own() says that this is the order of their numbers.
// Returns the handles by vertex, the infinite vertex first, or null handles for numbers without a
// vertex. If there are several workers, each fills containers of its own, which are then merged in
// the order of the numbers. finish(cell) is called while cell(v) returns the cell of any vertex v, or
// the one that the core found for a hidden point.
template <class Triangulation, class PointOf, class InOrder, class Finish>
std::vector<typename Triangulation::Vertex_handle>
export_complex(Triangulation& tr, Built& built, const PointOf& point, const InOrder& in_order,
               const Executor& executor, const Finish& finish)
{
  using Vertex_handle = typename Triangulation::Vertex_handle;
  auto& tds = tr.tds();
  const auto vertices = export_vertices(tr, built.vertices_end, point, in_order, executor);
  Large_vector<Id> cell_of(vertices.size());
  const std::size_t number = number_of_blocks(executor, vertices.size(), 4096);
  for_each_block(executor, vertices.size(), number,
                 [&](std::size_t first, std::size_t last, std::size_t) {
                   for (std::size_t v = first; v < last; ++v)
                     cell_of[v] = built.cell_of(v);
                 });
  built.give_up_vertices();
  tds.set_dimension(3);
  const auto cells = export_cells(tds, built, vertices, tr.infinite_vertex()->cell(), executor);
  for_each_block(executor, vertices.size(), number,
                 [&](std::size_t first, std::size_t last, std::size_t) {
                   for (std::size_t v = first; v < last; ++v)
                     if (vertices[v] != Vertex_handle())
                       vertices[v]->set_cell(cells[cell_of[v]]);
                 });
  finish([&](std::size_t v) { return cells[cell_of[v]]; });
  built.give_up_cells();
  return vertices;
}

// Fills the upper levels of a triangulation with `Fast_location`: inserting draws a vertex's level.
template <class Triangulation>
void fill_upper_levels(Triangulation& tr,
                       const std::vector<typename Triangulation::Vertex_handle>& vertices)
{
  using Has_upper_levels = decltype(has_upper_levels(static_cast<Triangulation*>(nullptr)));
  if constexpr (Has_upper_levels::value) {
    for (std::size_t v = 1; v < vertices.size(); ++v) {
      if (vertices[v] == typename Triangulation::Vertex_handle())
        continue;
      const auto c = vertices[v]->cell();
      const auto p = vertices[v]->point(); // a copy: the insertion assigns it
      tr.insert(p, Triangulation::VERTEX, c, c->index(vertices[v]), 0);
    }
  } else {
    (void)tr, (void)vertices;
  }
}

// Fills `tr`, which is empty, with the complex, and gives up its memory. Returns the vertices by
// point, made in the order of insertion or in the order of the input; a hidden point has a null
// handle, and goes into its cell. Linear.
template <class Triangulation>
std::vector<typename Triangulation::Vertex_handle>
export_built(Built& built, const std::vector<typename Triangulation::Point>& points,
             bool creates_in_input_order, Triangulation& tr, const Executor& executor)
{
  using Vertex_handle = typename Triangulation::Vertex_handle;
  const std::size_t n = built.order.size;
  const std::size_t* const order = built.order.order;
  const auto point = [&](std::size_t v) -> const typename Triangulation::Point* {
    const std::size_t k = Compact_numbers::point_of_vertex(v);
    prefetch(&points[order[(std::min)(k + prefetch_distance, n - 1)]]);
    return built.vertex_of[k] == v ? &points[order[k]] : nullptr;
  };
  const auto places = creates_in_input_order ? inverse(order, n) : std::vector<std::size_t>();
  const Creation_order in_order = {creates_in_input_order ? &places : nullptr, built.vertex_of};
  constexpr bool may_hide = has_weight<typename Triangulation::Point>;
  const auto hide_points = [&](const auto& cell) {
    if constexpr (may_hide)
      for (std::size_t k = 0; k < n; ++k)
        if (built.vertex_of[k] == Compact_numbers::infinite)
          cell(Compact_numbers::vertex_of_point(k))->hide_point(points[order[k]]);
  };
  const auto handles = export_complex(tr, built, point, in_order, executor, hide_points);
  fill_upper_levels(tr, handles);

  std::vector<Vertex_handle> vertices(n);
  for_each_block(executor, n, number_of_blocks(executor, n, 4096),
                 [&](std::size_t first, std::size_t last, std::size_t) {
                   for (std::size_t k = first; k < last; ++k)
                     if (!may_hide || built.vertex_of[k] != Compact_numbers::infinite)
                       vertices[order[k]] = handles[built.vertex_of[k]];
                 });
  return vertices;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_EXPORT_COMPLEX_H
