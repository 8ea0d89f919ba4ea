// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The compiled library, as a part of the extension. Its source defines that it is compiled.

#undef CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED
#include <src/core.cpp>
#include <src/core_regular.cpp>
#include <src/core_periodic.cpp>
#include <src/tiles/Point_files_3.cpp>
#include <src/tiles/Tiles_to_files.cpp>
