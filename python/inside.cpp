// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The winding numbers of a surface around tetrahedra.

#include "Unlocked.h"
#include "functions.h"
#include "interruptible.h"
#include "numpy_rows.h"

#include <CGAL/Delaunay_from_surface_3/Inside_3.h>
#include <CGAL/Delaunay_from_surface_3/inside/find_inside.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;
namespace internal = CGAL::Delaunay_from_surface_3::internal;

namespace {

// Returns the numbers, how sure they are, and a warning, which may be empty.
py::tuple winding_numbers(const python::Points& points, const python::Numbers& simplices,
                          const python::Numbers& neighbors, const python::Numbers& vertices,
                          const py::object& faces, std::size_t threads)
{
  const python::Rows rows(simplices), across(neighbors);
  if (rows.corners() != 4)
    throw py::value_error("inside: the surface has no inside: there are no tetrahedra");
  if (across.corners() != 4 || across.size() != rows.size())
    throw py::value_error("inside: expected four neighbours of each tetrahedron");
  const auto n = std::size_t(points.shape(0));
  std::vector<double> coordinates;
  python::copy_points(python::Points_view(points), n, "points: point", coordinates);
  const std::vector<python::Index> vertex_of =
      python::checked_copy(python::Rows(vertices.attr("reshape")(-1, 1)), n);
  CGAL::Inside_3 inside = python::with_faces(faces, [&](const auto& read) {
    const python::Unlocked unlocked;
    const internal::Rounding_to_nearest rounding;
    const python::Interruptible_executor executor(threads);
    const internal::Point_array array(coordinates.data(), n);
    return internal::find_inside(
        array, read, rows.size(),
        [&](std::size_t c) {
          return std::array<python::Index, 4>{rows.number(c, 0, n), rows.number(c, 1, n),
                                              rows.number(c, 2, n), rows.number(c, 3, n)};
        },
        [&](std::size_t c) {
          const python::Index* const row = across.data() + across.stride() * c;
          return std::array<python::Index, 4>{row[0], row[1], row[2], row[3]};
        },
        [&](std::size_t i) { return vertex_of[i]; }, executor);
  });
  const auto shares = py::make_tuple(
      inside.number_of_turned, inside.number_of_doubtful, inside.number_of_multiple,
      inside.doubtful_volume, inside.share_of_openings, inside.missing_area, inside.crossed_volume);
  const std::string warning = internal::warning_of(inside);
  return py::make_tuple(
      python::array_from(std::move(inside.winding_numbers), {py::ssize_t(rows.size())}), shares,
      warning);
}

} // namespace

void python::define_inside(py::module_& m)
{
  m.def("winding_numbers", &winding_numbers);
}
