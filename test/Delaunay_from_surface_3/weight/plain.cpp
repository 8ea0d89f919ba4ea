// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What a user's file is before this package comes in.

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

void insert(CGAL::Delaunay_triangulation_3<Kernel>& tr,
            const CGAL::Surface_mesh<Kernel::Point_3>& mesh)
{
  tr.insert(mesh.points().begin(), mesh.points().end());
}
