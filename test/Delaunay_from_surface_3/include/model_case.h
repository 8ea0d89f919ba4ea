// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_MODEL_CASE_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_MODEL_CASE_H

// What the model of the handshake inserts into, and how its cells lie in memory. See
// insertion_model.h.

#include "memory_models.h"

#include <string>
#include <vector>

namespace model {

struct Point
{
  int x, height;
};

// What a worker is to insert, and the vertex from whose cell its walk starts.
struct Task
{
  Byte vertex;
  Byte start;
};

// Vertices 1, 2, …, n form the chain at first, the k-th cell between k + 1 and k + 2.
struct Case
{
  const char* name;
  std::vector<Point> points;            // vertex v is points[v - 1]
  unsigned chain;                       // so many of them are there at first
  std::vector<std::vector<Task>> tasks; // of each worker
  unsigned fresh_cells;                 // that each worker has
  bool tries_again;                     // once, what clashed

  unsigned number_of_workers() const { return unsigned(tasks.size()); }
  unsigned number_of_cells() const { return chain - 1 + number_of_workers() * fresh_cells; }
  Point point(Byte v) const { return v == 0 ? Point{0, 0} : points[v - 1u]; }
  bool is_below(Byte p, Byte a, Byte b) const
  {
    const Point q = point(p), s = point(a), t = point(b);
    const int turn = (t.x - s.x) * (q.height - s.height) - (q.x - s.x) * (t.height - s.height);
    return t.x > s.x ? turn < 0 : turn > 0;
  }
};

// --- cells in memory ---------------------------------------------------------------------------

constexpr Byte busy = 128; // the highest bit of the first vertex

inline Byte encode(unsigned cell, unsigned facet)
{
  return Byte(2 * cell + facet);
}

// Facet k is opposite to vertex k: it is the other vertex. encode(c, k) leads to cell c through
// its facet k. Behind the cells each vertex has the number of a cell.
struct Layout
{
  unsigned workers, cells;

  explicit Layout(const Case& c)
    : workers(c.number_of_workers())
    , cells(c.number_of_cells())
  {
  }

  Location v(unsigned cell, unsigned k) const { return cell * (4 + workers) + k; }
  Location neighbor(unsigned cell, unsigned k) const { return v(cell, 2 + k); }
  Location mark(unsigned cell, unsigned worker) const { return v(cell, 4 + worker); }
  Location cell_of(Byte vertex) const { return v(cells, 0) + vertex - 1u; }
};

inline std::vector<Byte> initial_memory(const Case& c)
{
  const Layout at(c);
  std::vector<Byte> memory(at.cell_of(Byte(c.points.size() + 1)), 0);
  const unsigned last = c.chain - 2;
  for (unsigned k = 0; k < c.number_of_cells(); ++k) {
    memory[at.v(k, 0)] = k <= last ? Byte(k + 1) : busy;
    if (k <= last) {
      memory[at.v(k, 1)] = Byte(k + 2);
      memory[at.neighbor(k, 0)] = k < last ? encode(k + 1, 1) : encode(k, 0);
      memory[at.neighbor(k, 1)] = k > 0 ? encode(k - 1, 0) : encode(k, 1);
      memory[at.cell_of(Byte(k + 1))] = memory[at.cell_of(Byte(k + 2))] = Byte(k);
    }
  }
  return memory;
}

} // namespace model

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_MODEL_CASE_H
