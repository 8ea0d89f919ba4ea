// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The core, compiled once for all programs that link Delaunay_from_surface_3::compiled.

#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED
#define CGAL_DELAUNAY_FROM_SURFACE_3_LIBRARY

#include <CGAL/Delaunay_from_surface_3/core/build_impl.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Parallel_triangulation.h>

#include <memory>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE {

template std::unique_ptr<Built> build<One_thread>(Point_source&, Order_source&, const Request&,
                                                  Watcher&, const Executor&);
template std::unique_ptr<Built> build<Many_threads>(Point_source&, Order_source&, const Request&,
                                                    Watcher&, const Executor&);

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL
