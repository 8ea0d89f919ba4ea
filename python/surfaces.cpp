// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The functions that concern only surfaces, whose triangles are read as lists of numbers.

#include "Unlocked.h"
#include "functions.h"
#include "numpy_ranges.h"

#include <CGAL/Delaunay_from_surface_3/surface/Face_reader.h>
#include <CGAL/Delaunay_from_surface_3/surface/surface_topology.h>
#include <CGAL/Delaunay_from_surface_3/surface/Bounded_degree_marks.h>

#include <pybind11/stl.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace {

// Calls f(surface) without the lock, where the surface has the triangles and vertices 0, …, n - 1.
template <class F>
auto with_triangles(const py::object& faces, std::optional<std::size_t> number_of_vertices,
                    const F& f)
{
  return python::with_faces(faces, [&](const auto& rows) {
    std::size_t n = 0, i = 0;
    for (const auto& row : rows) {
      for (const std::int64_t index : row) {
        const bool is_refused =
            index < 0 || (number_of_vertices && std::size_t(index) >= *number_of_vertices);
        if (is_refused || index >= (std::int64_t(1) << 31))
          throw py::value_error("faces: face " + std::to_string(i) + ": the index " +
                                std::to_string(index) + " is not one of a vertex");
        n = (std::max)(n, std::size_t(index) + 1);
      }
      ++i;
    }
    const python::Unlocked unlocked;
    using Reader =
        CGAL::Delaunay_from_surface_3::internal::Face_reader<std::decay_t<decltype(rows)>>;
    return f(CGAL::Delaunay_from_surface_3::Triangulated_surface<Reader>(
        Reader(rows, number_of_vertices.value_or(n))));
  });
}

// Appends pairs of numbers one after the other.
class Append_ends
{
public:
  using iterator_category = std::output_iterator_tag;
  using value_type = void;
  using difference_type = void;
  using pointer = void;
  using reference = void;

  explicit Append_ends(std::vector<std::int32_t>& ends)
    : m_ends(&ends)
  {
  }
  Append_ends& operator*() { return *this; }
  Append_ends& operator++() { return *this; }
  Append_ends operator++(int) { return *this; }
  Append_ends& operator=(const std::pair<std::size_t, std::size_t>& edge)
  {
    m_ends->push_back(std::int32_t(edge.first));
    m_ends->push_back(std::int32_t(edge.second));
    return *this;
  }

private:
  std::vector<std::int32_t>* m_ends;
};

py::array subgraph(const py::object& faces, std::optional<std::size_t> number_of_vertices,
                   bool is_tree)
{
  std::vector<std::int32_t> ends;
  with_triangles(faces, number_of_vertices, [&](const auto& surface) {
    namespace internal = CGAL::Delaunay_from_surface_3::internal;
    using Kind = internal::Subgraph_kind;
    return internal::write_bounded_degree_subgraph(
        surface.reader(), is_tree ? Kind::TREE : Kind::SUBGRAPH, Append_ends(ends));
  });
  return py::array_t<std::int32_t>({py::ssize_t(ends.size() / 2), py::ssize_t(2)}, ends.data());
}

py::list surface_topology(const py::object& faces, std::optional<std::size_t> number_of_vertices)
{
  const auto topology = with_triangles(faces, number_of_vertices, [](const auto& surface) {
    return CGAL::Delaunay_from_surface_3::surface_topology(surface);
  });
  py::list result;
  for (const auto& c : topology.components)
    result.append(py::make_tuple(c.number_of_vertices, c.number_of_edges, c.number_of_triangles,
                                 c.number_of_boundary_loops, c.euler_characteristic(), c.genus(),
                                 c.subgraph_degree_bound(), c.is_orientable));
  return result;
}

} // namespace

void python::define_surface_functions(py::module_& m)
{
  m.def("subgraph", &subgraph);
  m.def("surface_topology", &surface_topology);
}
