// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_MARKS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_MARKS_H

// Each cell has a byte per worker, its mark, which says: "the cell is in my conflict zone". Each
// byte has one writer, so that nothing is ever compared and swapped: two workers that announce
// their zones in this way, and then look for the other's mark, cannot both overlook the other
// (Dekker's handshake; Dijkstra 1965).

#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/support/Page_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/shared_words.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

class Marks
{
public:
  static constexpr unsigned most_workers = 64;
  static constexpr std::uint8_t set = 0x80; // a mark that is set; 0 if it is not

  // Makes marks for so many workers, up to most_workers, but for no cells yet.
  explicit Marks(unsigned number_of_workers)
  {
    while ((1u << m_shift) < number_of_workers)
      ++m_shift;
  }

  // Makes room for n cells. No other worker may run.
  void reset(std::size_t n)
  {
    deallocate(); // first, so that both are never allocated
    m_bytes.reserve(n << m_shift, 0);
  }

  // Clears the marks of the cells first, …, last - 1, which have none before. Several workers may call
  // it, each for cells of its own.
  void clear(std::size_t first, std::size_t last)
  {
    m_bytes.touch(first << m_shift, last << m_shift);
    if constexpr (is_watched) // a worker that withdraws may read a mark meanwhile
      for (std::size_t b = first << m_shift; b < last << m_shift; ++b)
        store_relaxed(m_bytes[b], std::uint8_t(0));
    else
      std::memset(m_bytes.data() + (first << m_shift), 0, (last - first) << m_shift);
  }

  void deallocate() { m_bytes.deallocate(); }

  std::uint8_t& mark(std::size_t cell, unsigned worker)
  {
    return m_bytes[(cell << m_shift) + worker];
  }

  unsigned shift() const { return m_shift; } // logarithm of the number of bytes per cell
  const std::uint8_t* bytes() const { return m_bytes.data(); }
  std::uint8_t* bytes() { return m_bytes.data(); }

private:
  unsigned m_shift = 1; // a cell has at least two marks
  Page_array<std::uint8_t> m_bytes;
};

// Returns the marks of a cell, except one worker's, as one number: 0 if no other worker has the
// cell. The bytes of a cell are read as words.
template <class Word, unsigned number_of_words = 1>
class Other_marks
{
public:
  Other_marks(const std::uint8_t* bytes, unsigned worker)
    : m_words(reinterpret_cast<const Word*>(bytes))
  {
    for (unsigned b = 0; b < sizeof(m_others); ++b)
      reinterpret_cast<unsigned char*>(m_others)[b] = b == worker ? 0 : 255;
  }

  Word operator()(std::size_t cell) const
  {
    const Word* const words = m_words + number_of_words * cell;
    Word others = 0;
    for (unsigned k = 0; k < number_of_words; ++k)
      others |= load_acquire(words[k]) & m_others[k];
    return others;
  }

private:
  const Word* m_words;
  Word m_others[number_of_words];
};

// Does the same byte by byte, for ThreadSanitizer: what is written as a byte must be read as a
// byte.
class Other_marks_by_byte
{
public:
  Other_marks_by_byte(const std::uint8_t* bytes, unsigned worker, unsigned shift)
    : m_bytes(bytes)
    , m_worker(worker)
    , m_shift(shift)
  {
  }

  std::uint8_t operator()(std::size_t cell) const
  {
    std::uint8_t others = 0;
    for (unsigned b = 0; b < 1u << m_shift; ++b)
      others |= b == m_worker ? std::uint8_t(0) : load_acquire(m_bytes[(cell << m_shift) + b]);
    return others;
  }

private:
  const std::uint8_t* m_bytes;
  unsigned m_worker, m_shift;
};

// Calls f(others), where others(cell) returns the marks of a cell except the worker's.
template <class F>
auto with_other_marks(const Marks& marks, unsigned worker, const F& f)
{
  if constexpr (is_watched)
    return f(Other_marks_by_byte(marks.bytes(), worker, marks.shift()));
  switch (marks.shift()) {
  case 1:
    return f(Other_marks<std::uint16_t>(marks.bytes(), worker));
  case 2:
    return f(Other_marks<std::uint32_t>(marks.bytes(), worker));
  case 3:
    return f(Other_marks<std::uint64_t>(marks.bytes(), worker));
  case 4:
    return f(Other_marks<std::uint64_t, 2>(marks.bytes(), worker));
  case 5:
    return f(Other_marks<std::uint64_t, 4>(marks.bytes(), worker));
  default:
    return f(Other_marks<std::uint64_t, 8>(marks.bytes(), worker));
  }
}

// Holds a complex that has started, for several workers: its cells and vertices, the marks of the
// cells, and blocks of fresh cells.
template <class Vertex>
class Shared_complex
{
  using Complex = Compact_complex<Vertex>;

public:
  Shared_complex(Complex& complex, unsigned number_of_workers)
    : m_complex(complex)
    , m_marks(number_of_workers)
  {
  }

  // To be called once the complex has started.
  void begin()
  {
    if (m_marks.bytes() == nullptr)
      make_room(m_complex.cells_end());
  }

  Complex& complex() { return m_complex; }
  Marks& marks() { return m_marks; }

  // Adds fresh cells, which are dead, to `free_cells`; returns false if there are none left. This
  // is the only function here that several workers may call at once.
  bool take_block(std::vector<Id>& free_cells)
  {
    constexpr std::size_t block = 256;
    const std::size_t first = m_next.fetch_add(block, std::memory_order_relaxed);
    const std::size_t last = (std::min)(first + block, m_complex.capacity());
    if (first >= last)
      return false;
    // Pages are taken for many blocks at once, by the worker whose block has their first cell.
    constexpr std::size_t piece = small_pages / sizeof(Compact_cell);
    const std::size_t begin = (last - 1) / piece * piece;
    if (begin >= first)
      m_complex.touch_cells(begin, (std::min)(begin + piece, m_complex.capacity()));
    m_marks.clear(first, last);
    for (std::size_t c = last; c-- > first;) {
      for (unsigned k = 0; k < 4; ++k) {
        store_relaxed(m_complex.cell(c).v[k], Id(k == 0 ? Complex::dead : 0));
        store_relaxed(m_complex.cell(c).neighbors[k], Id(0));
      }
      free_cells.push_back(Id(c));
    }
    return true;
  }

  // Makes room for n cells, or as many as are allowed, all of them available. No worker may run.
  void make_room(std::size_t n)
  {
    const std::size_t used = (std::min)(m_next.load(), m_complex.capacity());
    m_complex.make_room(n);
    m_marks.reset(m_complex.capacity());
    m_next = (std::max)(used, m_complex.cells_end());
    m_marks.clear(0, m_next);
  }

  // Tells the complex how many cells are handed out. No worker may run.
  void note_cells() { m_complex.use_cells((std::min)(m_next.load(), m_complex.capacity())); }

  // Makes more room than before. No worker may run.
  void grow()
  {
    note_cells();
    make_room(Complex::more_room(m_complex.capacity()));
  }

  // Tells the complex all cells, even fresh ones, which are dead. Finds a cell of the infinite
  // vertex. Gives the marks back.
  void finish()
  {
    m_marks.deallocate();
    note_cells();
    for (std::size_t c = m_complex.cells_end(); c-- > 0;)
      if (!Complex::is_dead(m_complex.cell(c)) && Complex::is_infinite(m_complex.cell(c))) {
        m_complex.vertex(Complex::infinite).cell = Id(c);
        break;
      }
  }

private:
  Complex& m_complex;
  Marks m_marks;
  std::atomic<std::size_t> m_next{0};
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_MARKS_H
