// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_BY_THREADS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_BY_THREADS_H

// Defines build() for any executor. Programs without threads need not compile this.

#include <CGAL/Delaunay_from_surface_3/core/build_impl.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Insert_alone.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Ordered_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Parallel_triangulation.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <memory>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Inserts chunks of a round of Choi 2002, Fig. 1, lines 2b and 2c, by several workers.

template <class Vertex>
class Insert_by_workers
{
public:
  // Keeps references.
  Insert_by_workers(Ordered_complex<Vertex>& points, const Executor& executor, Observer& observer)
    : m_points(points)
    , m_observer(observer)
    , m_triangulation(points.complex, executor)
  {
  }

  std::size_t size_of_chunk(std::size_t inserted) const
  {
    return m_triangulation.size_of_chunk(inserted);
  }
  std::size_t number_of_threads() const { return m_triangulation.number_of_workers(); }

  // Inserts the points at the places first, …, last - 1; returns false if the observer stopped it.
  bool operator()(std::size_t first, std::size_t last)
  {
    return m_triangulation.insert_chunk(
        first, last, m_points.vertices, m_points.starting_cells(),
        [&](std::size_t inserted) { return m_observer.go_further(inserted); });
  }

  // To be called when all points are inserted.
  void finish() { m_triangulation.finish(); }

  Insertion_counts counts() const { return m_triangulation.counts(); }

private:
  Ordered_complex<Vertex>& m_points;
  Observer& m_observer;
  Parallel_triangulation<Vertex> m_triangulation;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM

inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE {

CGAL_DELAUNAY_FROM_SURFACE_3_INLINE std::unique_ptr<Built> build(Point_source& points,
                                                                 const Build_options& options,
                                                                 Observer& observer,
                                                                 const Executor& executor)
{
  return executor.number_of_workers() > 1
             ? build_by<Insert_by_workers>(points, options, observer, executor)
             : build_by<Insert_alone>(points, options, observer, executor);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_BUILD_BY_THREADS_H
