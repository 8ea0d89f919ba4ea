// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The part of the compiled core for points in a periodic box, which programs without boxes do not link.

#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED
#define CGAL_DELAUNAY_FROM_SURFACE_3_LIBRARY

#include <CGAL/Delaunay_from_surface_3/core/build_periodic.h>
