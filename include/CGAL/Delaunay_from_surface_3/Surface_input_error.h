// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_INPUT_ERROR_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_INPUT_ERROR_H

#include <stdexcept>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Progress

is thrown when something cannot serve as input: a coordinate that is not a finite number, an index
out of range or given twice, a graph whose number of vertices differs from the number of points, a
surface that is not a simple triangulated manifold where one is needed, and what else the functions
name. The message says what is wrong and where, on one line. Input is checked before the first
change of the triangulation.
*/
class Surface_input_error : public std::invalid_argument
{
public:
  /// is constructed from the message, as `std::invalid_argument` is.
  using std::invalid_argument::invalid_argument;
};

} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_INPUT_ERROR_H
