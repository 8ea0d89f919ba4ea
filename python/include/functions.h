// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_FUNCTIONS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_FUNCTIONS_H

#include <CGAL/Delaunay_from_surface_3/core/build.h>

#include <pybind11/pybind11.h>

#include <stdexcept>
#include <string>

namespace python {

// Throws if signs would not be right, as in a thread that takes denormal numbers for 0.
inline void refuse_obstacle()
{
  if (const char* const obstacle = CGAL::Delaunay_from_surface_3::core::obstacle_of_core())
    throw std::runtime_error(std::string("the module would be slow, or not exact: ") + obstacle);
}

// Each of these adds the functions of one file beside module.cpp to the extension.
void define_surface_functions(pybind11::module_& m);
void define_queries(pybind11::module_& m);
void define_cells(pybind11::module_& m);
void define_inside(pybind11::module_& m);
void define_interpolation(pybind11::module_& m);
void define_tiles(pybind11::module_& m);
void define_filtration(pybind11::module_& m);
void define_learning(pybind11::module_& m);

} // namespace python

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_FUNCTIONS_H
