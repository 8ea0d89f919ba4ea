// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_TRIANGULATIONS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_TRIANGULATIONS_H

// The types that are compared.

#include <Delaunay_from_surface_3_meters/Predicate_counting_traits_3.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <functional>
#include <variant>

namespace comparison {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Counting_kernel = meters::Predicate_counting_traits_3<Kernel>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
using Fast_triangulation = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Fast_location>;
using Counted_triangulation = CGAL::Delaunay_triangulation_3<Counting_kernel>;

// Looks at a triangulation of one of the types that are timed.
using Look = std::function<void(std::variant<const Triangulation*, const Fast_triangulation*>)>;

// CGAL's own insertion of a range of points, in the order of the mesh.
template <class Tr>
void insert_plain(Tr& tr, const Mesh& mesh)
{
  tr.insert(mesh.points().begin(), mesh.points().end());
}

} // namespace comparison

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_TRIANGULATIONS_H
