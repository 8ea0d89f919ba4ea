// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_INSERT_BY_WORKERS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_INSERT_BY_WORKERS_H

// One piece of a round of Choi 2002, Fig. 1, lines 2b and 2c, by many threads
// (Parallel_triangulation.h). No point can be left out: what is nearest to it depends on what others
// insert.

#include <CGAL/Delaunay_from_surface_3/core/interface/Watcher.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/crews.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Ordered_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Parallel_triangulation.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/assertions.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Id>
class Insert_by_workers
{
public:
  // Keeps references.
  Insert_by_workers(Ordered_complex<Id>& points, const Executor& executor, Watcher& watcher)
    : m_points(points)
    , m_watcher(watcher)
    , m_triangulation(points.complex, executor)
  {
    CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT(!watcher.leaves_points_out());
  }

  std::size_t size_of_piece(std::size_t inserted) const
  {
    return m_triangulation.size_of_piece(inserted);
  }
  std::size_t number_of_threads() const { return m_triangulation.number_of_workers(); }

  // Inserts the points at the places first, …, last - 1; false if the watcher stopped it.
  bool operator()(std::size_t first, std::size_t last)
  {
    return m_triangulation.insert_round(
        first, last, m_points.vertex_of, m_points.starting_cells(),
        [&](std::size_t inserted) { return m_watcher.go_further(inserted); });
  }

  // To be called when all is inserted.
  void finish() { m_triangulation.finish(); }

  Insertion_counts counts() const { return m_triangulation.counts(); }

private:
  Ordered_complex<Id>& m_points;
  Watcher& m_watcher;
  Parallel_triangulation<Id> m_triangulation;
};

template <>
struct Inserter_of<Many_threads>
{
  template <class Id>
  using type = Insert_by_workers<Id>;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_THREADS_INSERT_BY_WORKERS_H
