// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The extension behind the Python module delaunay_from_surface, whose docstrings say what it does.

#include "Interruptible_visitor.h"
#include "numpy_ranges.h"

#include <pybind11/stl.h>

#include <CGAL/Delaunay_from_surface_3/Too_few_ids.h>
#include <CGAL/Delaunay_from_surface_3/surface/surface_topology.h>
#include <CGAL/bounded_degree_spanning_subgraph.h>
#include <CGAL/delaunay_3_arrays.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace {

using Arrays = CGAL::Delaunay_3_arrays<std::int32_t>;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

struct Stopped : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

template <class Build>
Arrays without_lock(const Build& build, bool keeps_neighbors)
{
  const py::gil_scoped_release unlocked;
  Arrays arrays = build();
  arrays.drop_infinite_cells();
  if (!keeps_neighbors)
    arrays.drop_neighbors();
  return arrays;
}

// Views of the arrays, which live as long as one of them does.
py::tuple views_of(Arrays&& moved, bool with_neighbors)
{
  const auto* const arrays = new Arrays(std::move(moved));
  const py::capsule owner(arrays, [](void* p) { delete static_cast<const Arrays*>(p); });
  const auto view = [&](const std::int32_t* data) {
    const auto corners = py::ssize_t((std::max)(arrays->dimension(), 0) + 1);
    const auto stride = py::ssize_t(arrays->stride() * sizeof(std::int32_t));
    return py::array_t<std::int32_t>({py::ssize_t(arrays->number_of_cells()), corners},
                                     {stride, py::ssize_t(sizeof(std::int32_t))}, data, owner);
  };
  const py::array_t<std::int32_t> vertices({py::ssize_t(arrays->number_of_points())},
                                           {py::ssize_t(sizeof(std::int32_t))},
                                           arrays->vertices_of_points().data(), owner);
  py::object neighbors = py::none();
  if (with_neighbors)
    neighbors = view(arrays->neighbors_data());
  return py::make_tuple(view(arrays->vertices_data()), neighbors, vertices, arrays->dimension());
}

py::tuple delaunay3(const py::object& points_object, const py::object& faces_object, bool neighbors,
                    unsigned int seed, const py::object& progress)
{
  const py::array array = python::array_of_points(points_object);
  const auto points = python::points_of(array);
  python::Interruptible_visitor visitor(points.size(), progress);
  const auto np = CGAL::parameters::random_seed(seed).visitor(std::ref(visitor));
  Arrays arrays;
  try {
    if (faces_object.is_none())
      arrays = without_lock([&] { return CGAL::delaunay_3_arrays(points, np); }, neighbors);
    else
      arrays = python::with_faces(faces_object, [&](const auto& faces) {
        return without_lock([&] { return CGAL::delaunay_3_arrays(points, faces, np); }, neighbors);
      });
  } catch (const CGAL::Delaunay_from_surface_3::Too_few_ids& error) {
    PyErr_SetString(PyExc_OverflowError, error.what());
    throw py::error_already_set();
  }
  if (visitor.is_stopped())
    throw Stopped("progress returned False");
  visitor.finish();
  return views_of(std::move(arrays), neighbors);
}

// The surface of the faces, with vertices 0, …, n - 1.
Mesh mesh_of(const py::object& faces_object, std::optional<std::size_t> number_of_vertices)
{
  return python::with_faces(faces_object, [&](const auto& rows) {
    std::size_t n = 0, f = 0;
    std::vector<std::vector<std::size_t>> faces;
    for (const auto& row : rows) {
      faces.emplace_back();
      for (const std::int64_t index : row) {
        const bool is_refused =
            index < 0 || (number_of_vertices && std::size_t(index) >= *number_of_vertices);
        if (is_refused || index >= (std::int64_t(1) << 31))
          throw py::value_error("faces: face " + std::to_string(f) + ": the index " +
                                std::to_string(index) + " is not one of a vertex");
        faces.back().push_back(std::size_t(index));
        n = (std::max)(n, std::size_t(index) + 1);
      }
      ++f;
    }
    const py::gil_scoped_release unlocked;
    namespace PMP = CGAL::Polygon_mesh_processing;
    if (!PMP::is_polygon_soup_a_polygon_mesh(faces))
      throw std::invalid_argument("faces: they are not a consistently oriented manifold");
    Mesh mesh;
    PMP::polygon_soup_to_polygon_mesh(std::vector<Mesh::Point>(number_of_vertices.value_or(n)),
                                      faces, mesh);
    return mesh;
  });
}

py::array subgraph(const py::object& faces, std::optional<std::size_t> number_of_vertices,
                   bool is_tree)
{
  const Mesh mesh = mesh_of(faces, number_of_vertices);
  std::vector<std::int32_t> ends;
  {
    const py::gil_scoped_release unlocked;
    const auto out = boost::make_function_output_iterator([&](Mesh::Edge_index e) {
      ends.push_back(std::int32_t(source(e, mesh)));
      ends.push_back(std::int32_t(target(e, mesh)));
    });
    if (is_tree)
      CGAL::bounded_degree_spanning_tree(mesh, out);
    else
      CGAL::bounded_degree_spanning_subgraph(mesh, out);
  }
  return py::array_t<std::int32_t>({py::ssize_t(ends.size() / 2), py::ssize_t(2)}, ends.data());
}

py::list surface_topology(const py::object& faces, std::optional<std::size_t> number_of_vertices)
{
  const Mesh mesh = mesh_of(faces, number_of_vertices);
  py::list result;
  for (const auto& c : CGAL::Delaunay_from_surface_3::surface_topology(mesh).components)
    result.append(py::make_tuple(c.number_of_vertices, c.number_of_edges, c.number_of_triangles,
                                 c.number_of_boundary_loops, c.euler_characteristic(), c.genus(),
                                 c.subgraph_degree_bound()));
  return result;
}

} // namespace

PYBIND11_MODULE(_delaunay_from_surface, m)
{
  py::register_exception<Stopped>(m, "Stopped").attr("__doc__") =
      "Raised by delaunay3() when progress returns False.";
  m.attr("__version__") = DELAUNAY_FROM_SURFACE_3_VERSION;
#if defined(CGAL_USE_GMP)
  m.attr("uses_gmp") = true;
#else
  m.attr("uses_gmp") = false;
#endif
  m.def("delaunay3", &delaunay3);
  m.def("subgraph", &subgraph);
  m.def("surface_topology", &surface_topology);
}
