// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_CELLS_MADE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_CELLS_MADE_H

#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Compact_cell.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <cstring>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The handles of the cells made so far, kept in the memory of the compact cells, from the beginning
// of each block on, so that no other memory is touched. A handle is no larger than a compact cell:
// that of the k-th cell of a block overwrites only the first k, which have been read.
template <class Tds, class Id>
class Cells_made
{
  using Cell = typename Tds::Cell;
  using Compact = Compact_cell<Id>;
  static_assert(sizeof(Compact) >= sizeof(Cell*), "handles overwrite only what was read");

public:
  using Handle = typename Tds::Cell_handle;

  // The handles of one block, by place in it.
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

  // Blocks have `size_of_block` cells.
  Cells_made(Built<Id>& built, std::size_t size_of_block)
    : m_cells(built.cells)
    , m_size(size_of_block)
  {
  }

  // The block that begins with cell `first`.
  Block block(std::size_t first) const { return Block(m_cells + first); }

  // How many compact cells the handles of `number` cells overwrite.
  static std::size_t cells_overwritten(std::size_t number)
  {
    return (number * sizeof(Cell*) + sizeof(Compact) - 1) / sizeof(Compact);
  }

  const void* address(std::size_t c) const { return block(first(c)).address(c - first(c)); }
  Handle operator[](std::size_t c) const { return block(first(c))[c - first(c)]; }

private:
  // The first cell of the block of cell c.
  std::size_t first(std::size_t c) const { return c < m_size ? 0 : c - c % m_size; }

  Compact* m_cells;
  std::size_t m_size;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_CELLS_MADE_H
