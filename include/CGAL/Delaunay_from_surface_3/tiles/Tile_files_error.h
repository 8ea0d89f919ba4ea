// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_FILES_ERROR_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_FILES_ERROR_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <stdexcept>

namespace CGAL {
/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {
/// \endcond

/*!
\ingroup PkgDelaunayFromSurface3Tiles

is thrown if a file cannot be read or written, or does not contain what it should. The message names
the file and the place, on one line.
*/
class Tile_files_error : public std::runtime_error
{
public:
  /// inherits the constructors, which take the message.
  using std::runtime_error::runtime_error;
};

/// \cond SKIP_IN_MANUAL
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_FILES_ERROR_H
