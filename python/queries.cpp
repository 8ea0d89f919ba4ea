// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Answers questions about a triangulation that is made: all is computed from NumPy's arrays of
// points and simplices, whose numbers are checked when they are read.

#include "Corners.h"
#include "Unlocked.h"
#include "functions.h"
#include "interruptible.h"
#include "numpy_rows.h"

#include <CGAL/Delaunay_from_surface_3/arrays/Find_in_box.h>
#include <CGAL/Delaunay_from_surface_3/arrays/Find_simplex.h>
#include <CGAL/Delaunay_from_surface_3/arrays/complete_arrays.h>
#include <CGAL/Delaunay_from_surface_3/arrays/is_valid_arrays.h>
#include <CGAL/Delaunay_from_surface_3/arrays/measures_of_simplices.h>
#include <CGAL/Delaunay_from_surface_3/arrays/spanning_trees.h>
#include <CGAL/Delaunay_from_surface_3/support/Disjoint_sets.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace py = pybind11;
namespace core = CGAL::Delaunay_from_surface_3::core;

namespace {

using python::array_from;
using python::checked_copy;
using python::In_box;
using python::Index;
using python::number_as_met;
using python::Numbers;
using python::Point_of;
using python::Points;
using python::Rows;

// Calls f with the number of corners as a constant.
template <class F>
auto with_corners(std::size_t corners, const F& f)
{
  switch (corners) {
  case 4:
    return f(std::integral_constant<std::size_t, 4>());
  case 3:
    return f(std::integral_constant<std::size_t, 3>());
  case 2:
    return f(std::integral_constant<std::size_t, 2>());
  default:
    throw py::value_error("simplices: expected an array of shape (m, d + 1)");
  }
}

Numbers neighbors(const Numbers& simplices, std::size_t n, std::size_t threads)
{
  const Rows rows(simplices);
  const std::size_t corners = rows.corners();
  std::vector<Index> found(corners * rows.size(), -1);
  if (corners > 1) {
    const python::Unlocked unlocked;
    std::vector<Index> vertices = checked_copy(rows, n);
    const python::Interruptible_executor executor(threads);
    number_as_met(vertices.data(), vertices.size(), n, executor);
    const core::Matched_facets matched = with_corners(corners, [&](auto constant) {
      constexpr std::size_t number = decltype(constant)::value;
      return core::match_facets<number>(
          core::Corners_view<Index>{vertices.data(), number, rows.size()}, n,
          [&](std::size_t c, std::size_t k, std::size_t d) { found[number * c + k] = Index(d); },
          executor);
    });
    if (!matched.are_pairs)
      throw std::invalid_argument("simplices: more than two have a facet in common");
  }
  return array_from(std::move(found), {simplices.shape(0), simplices.shape(1)});
}

// Takes the queries in groups, so that they are not all copied at once.
Numbers find_simplex(const Points& points, const Numbers& simplices, const Numbers& neighbors,
                     const Points& queries, std::size_t threads)
{
  python::refuse_obstacle();
  const Rows vertices(simplices), across(neighbors);
  if (vertices.corners() != 4 || across.corners() != 4 || vertices.size() != across.size())
    throw py::value_error("find_simplex: expected tetrahedra");
  const core::Simplices_view<Index> view = {
      vertices.data(), vertices.stride(),           across.data(), across.stride(), vertices.size(),
      vertices.size(), std::size_t(points.shape(0))};
  const Point_of point_of = {python::Points_view(points)};
  const core::Rounding_to_nearest rounding;
  const python::Interruptible_executor executor(threads);
  const auto number = std::size_t(queries.shape(0));
  std::vector<Index> found(number);
  std::vector<double> coordinates;
  constexpr std::size_t group = 1 << 20;
  for (std::size_t first = 0; first < number; first += group) {
    const std::size_t size = (std::min)(group, number - first);
    python::copy_points(python::Points_view(queries, first), size, "xi: point", coordinates, first);
    {
      const python::Unlocked unlocked;
      core::find_simplices(view, point_of, core::Point_array(coordinates.data(), size),
                           found.data() + first, executor);
    }
  }
  return array_from(std::move(found), {queries.shape(0)});
}

py::tuple adjacent_vertices(const Numbers& simplices, std::size_t n, std::size_t threads)
{
  const Rows rows(simplices);
  core::Adjacent_vertices<Index> adjacent;
  {
    const python::Unlocked unlocked;
    const std::vector<Index> vertices = checked_copy(rows, n);
    const std::size_t corners = rows.corners();
    adjacent = core::adjacent_vertices<Index>(
        rows.size(), corners, n,
        [&](std::size_t c, std::size_t k) { return vertices[corners * c + k]; },
        python::Interruptible_executor(threads));
  }
  const auto firsts = py::ssize_t(adjacent.first.size());
  const auto items = py::ssize_t(adjacent.items.size());
  return py::make_tuple(array_from(std::move(adjacent.first), {firsts}),
                        array_from(std::move(adjacent.items), {items}));
}

Numbers minimum_spanning_tree(const Points& points, const Numbers& simplices, std::size_t threads)
{
  const Rows rows(simplices);
  const auto n = std::size_t(points.shape(0));
  std::vector<double> coordinates;
  python::copy_points(python::Points_view(points), n, "points: point", coordinates);
  std::vector<Index> tree;
  {
    const python::Unlocked unlocked;
    const python::Interruptible_executor executor(threads);
    const core::Rounding_to_nearest rounding;
    const core::Lengths_between lengths(core::Point_array(coordinates.data(), n));
    const std::vector<Index> vertices = checked_copy(rows, n);
    const std::size_t corners = rows.corners();
    if (corners > 4)
      throw CGAL::Surface_input_error("expected simplices of at most four corners");
    std::vector<core::Measured_edge<std::uint32_t>> edges;
    if (corners > 1)
      edges = core::edges_of_simplices(
          rows.size(), corners, n,
          [&](std::size_t c, std::size_t k) { return vertices[corners * c + k]; }, lengths,
          executor);
    core::keep_minimum_spanning_forest(edges, n, lengths, executor);
    for (const auto& e : edges)
      tree.insert(tree.end(), {Index(e.ends[0]), Index(e.ends[1])});
  }
  const auto number = py::ssize_t(tree.size() / 2);
  return array_from(std::move(tree), {number, 2});
}

// The simplices as those look at them who find points: with neighbours, or without.
struct Simplices_of
{
  const core::Points_in_box points;
  const core::Simplices_in_box<Index> view;

  Simplices_of(const Points& given, const Rows& vertices, const Rows* neighbors,
               const In_box& in_box)
    : points(std::size_t(given.shape(0)), Point_of{python::Points_view(given)}, in_box.box())
    , view{{vertices.data(), vertices.stride(), neighbors == nullptr ? nullptr : neighbors->data(),
            neighbors == nullptr ? 0 : neighbors->stride(), vertices.size(), vertices.size(),
            std::size_t(given.shape(0))},
           in_box.offsets(),
           points}
  {
  }
};

// Calls write(c, corners) for each tetrahedron c; corner_of(c, k, i) is its corner k, which is point
// i of n.
template <class CornerOf, class Write>
void measure_rows(const Rows& rows, std::size_t n, std::size_t threads, const CornerOf& corner_of,
                  const Write& write)
{
  const python::Unlocked unlocked;
  const python::Interruptible_executor executor(threads);
  const std::size_t blocks = core::number_of_blocks(executor, rows.size(), 4096);
  core::for_each_block(executor, rows.size(), blocks,
                       [&](std::size_t first, std::size_t last, std::size_t) {
                         core::Steps step(executor);
                         for (std::size_t c = first; c < last; ++c, step()) {
                           decltype(corner_of(c, 0, 0)) corners[4];
                           for (std::size_t k = 0; k < 4; ++k)
                             corners[k] = corner_of(c, k, std::size_t(rows.number(c, k, n)));
                           write(c, corners);
                         }
                       });
}

// The same for corners as measures_of_simplices.h takes them: coordinates or, in a box, copies, with
// weights or without.
template <bool has_weight = false, class Write>
void measure(const Points& points, const py::object& weights, const Numbers& simplices,
             const py::object& in_box, std::size_t threads, const Write& write)
{
  const Rows rows(simplices);
  python::with_corners_of<has_weight>(points, weights, rows, in_box, [&](const auto& corner_of) {
    measure_rows(rows, std::size_t(points.shape(0)), threads, corner_of, write);
  });
}

py::array volumes(const Points& points, const Numbers& simplices, const py::object& in_box,
                  std::size_t threads)
{
  std::vector<double> result(std::size_t(simplices.shape(0)));
  measure(points, py::none(), simplices, in_box, threads,
          [&](std::size_t c, const auto& corners) { result[c] = core::volume_of(corners); });
  return array_from(std::move(result), {simplices.shape(0)});
}

py::tuple circumspheres(const Points& points, const Numbers& simplices, const py::object& in_box,
                        std::size_t threads)
{
  const auto m = std::size_t(simplices.shape(0));
  std::vector<double> centers(3 * m), radii(m);
  measure(points, py::none(), simplices, in_box, threads, [&](std::size_t c, const auto& corners) {
    const core::Circumsphere sphere = core::circumsphere_of(corners);
    for (std::size_t i = 0; i < 3; ++i)
      centers[3 * c + i] = python::coordinate(corners[0], i) + sphere.center[i];
    radii[c] = sphere.radius();
  });
  return py::make_tuple(array_from(std::move(centers), {py::ssize_t(m), 3}),
                        array_from(std::move(radii), {py::ssize_t(m)}));
}

py::tuple power_spheres(const Points& points, const py::object& weights, const Numbers& simplices,
                        const py::object& in_box, std::size_t threads)
{
  const auto m = std::size_t(simplices.shape(0));
  std::vector<double> centers(3 * m), squared_radii(m);
  measure<true>(points, weights, simplices, in_box, threads,
                [&](std::size_t c, const auto& corners) {
                  const core::Power_sphere sphere = core::power_sphere_of(corners);
                  for (std::size_t i = 0; i < 3; ++i)
                    centers[3 * c + i] = python::coordinate(corners[0], i) + sphere.center[i];
                  squared_radii[c] = sphere.squared_radius;
                });
  return py::make_tuple(array_from(std::move(centers), {py::ssize_t(m), 3}),
                        array_from(std::move(squared_radii), {py::ssize_t(m)}));
}

// Returns whether gradients are so small that rounding x - corners[3] and the products with it cannot
// cause an error of 1e-9 inside. Each product has five roundings: the gradient, the difference, the
// product, and two sums.
bool are_harmless(const std::array<std::array<double, 3>, 3>& gradients,
                  const std::array<double, 3> (&corners)[4])
{
  constexpr double most = 1e-9 / (5 * 0x1p-53);
  for (const std::array<double, 3>& g : gradients)
    for (std::size_t k = 0; k < 3; ++k) {
      double sum = 0;
      for (std::size_t i = 0; i < 3; ++i)
        sum += std::abs(g[i] * (corners[k][i] - corners[3][i]));
      if (!(sum < most / 3)) // the fourth coordinate is 1 minus the sum of the three
        return false;
    }
  return true;
}

py::array transform(const Points& points, const Numbers& simplices, std::size_t threads)
{
  const auto m = std::size_t(simplices.shape(0));
  std::vector<double> result(12 * m);
  const Rows rows(simplices);
  if (rows.corners() != 4)
    throw py::value_error("simplices: expected tetrahedra");
  const Point_of point_of = {python::Points_view(points)};
  const auto corner_of = [&](std::size_t, std::size_t, std::size_t i) { return point_of(i); };
  measure_rows(rows, std::size_t(points.shape(0)), threads, corner_of,
               [&](std::size_t c, const auto& corners) {
                 double* to = result.data() + 12 * c;
                 std::array<std::array<double, 3>, 3> gradients = core::gradients_of(corners);
                 if (!are_harmless(gradients, corners))
                   for (std::array<double, 3>& gradient : gradients)
                     gradient.fill(core::no_measure);
                 for (const std::array<double, 3>& gradient : gradients)
                   to = std::copy(gradient.begin(), gradient.end(), to);
                 std::copy(corners[3].begin(), corners[3].end(), to);
               });
  return array_from(std::move(result), {py::ssize_t(m), 4, 3});
}

// Returns NaN for points whose simplex is negative.
py::array barycentric(const Points& points, const Numbers& simplices, const Points& queries,
                      const py::array_t<std::int64_t>& simplices_of_queries, std::size_t threads)
{
  const auto number = std::size_t(queries.shape(0));
  const Rows rows(simplices);
  if (rows.corners() != 4)
    throw py::value_error("simplices: expected tetrahedra");
  const Point_of point_of = {python::Points_view(points)};
  const Point_of query_of = {python::Points_view(queries)};
  const auto n = std::size_t(points.shape(0));
  const auto simplex_of = simplices_of_queries.unchecked<1>();
  std::vector<double> result(4 * number, core::no_measure);
  {
    const python::Unlocked unlocked;
    const python::Interruptible_executor executor(threads);
    const std::size_t blocks = core::number_of_blocks(executor, number, 4096);
    core::for_each_block(
        executor, number, blocks, [&](std::size_t first, std::size_t last, std::size_t) {
          core::Steps step(executor);
          for (std::size_t q = first; q < last; ++q, step()) {
            const std::int64_t c = simplex_of(py::ssize_t(q));
            if (c < 0)
              continue;
            if (std::size_t(c) >= rows.size())
              throw std::out_of_range("barycentric: " + std::to_string(c) + " is not one of the " +
                                      std::to_string(rows.size()) + " simplices");
            std::array<double, 3> corners[4];
            for (std::size_t k = 0; k < 4; ++k)
              corners[k] = point_of(std::size_t(rows.number(std::size_t(c), k, n)));
            const std::array<double, 4> weights = core::barycentric_of(corners, query_of(q));
            std::copy(weights.begin(), weights.end(), result.begin() + std::ptrdiff_t(4 * q));
          }
        });
  }
  return array_from(std::move(result), {py::ssize_t(number), 4});
}

// Returns NaN for points whose simplex is negative. Each simplex is moved by an offset.
py::array barycentric_in_box(const Points& points, const Numbers& simplices,
                             const py::object& in_box, const Points& queries,
                             const py::array_t<std::int64_t>& simplices_of_queries,
                             const py::array_t<std::int64_t>& offsets_of_queries,
                             std::size_t threads, bool are_zeros_decided)
{
  const auto number = std::size_t(queries.shape(0));
  const Rows rows(simplices);
  if (rows.corners() != 4)
    throw py::value_error("simplices: expected tetrahedra");
  const In_box of_simplices(in_box, rows);
  const Point_of query_of = {python::Points_view(queries)};
  const auto simplex_of = simplices_of_queries.unchecked<1>();
  const auto offset_of = offsets_of_queries.unchecked<2>();
  std::vector<double> result(4 * number, core::no_measure);
  {
    const python::Unlocked unlocked;
    const Simplices_of simplices_of(points, rows, nullptr, of_simplices);
    const python::Interruptible_executor executor(threads);
    const std::size_t blocks = core::number_of_blocks(executor, number, 4096);
    core::for_each_block(
        executor, number, blocks, [&](std::size_t first, std::size_t last, std::size_t) {
          core::Steps step(executor);
          for (std::size_t q = first; q < last; ++q, step()) {
            core::Simplex_copy<Index> copy = {-1, {0, 0, 0}};
            const std::int64_t c = simplex_of(py::ssize_t(q));
            if (c < 0)
              continue;
            if (std::size_t(c) >= rows.size())
              throw std::out_of_range("barycentric: " + std::to_string(c) + " is not one of the " +
                                      std::to_string(rows.size()) + " simplices");
            copy.simplex = Index(c);
            std::array<double, 3> wrapped = query_of(q);
            const core::Number_of_periods back = core::wrap(
                simplices_of.points.periods(), wrapped.data(), "xi: point " + std::to_string(q));
            for (std::size_t a = 0; a < 3; ++a) {
              const std::int64_t by = offset_of(py::ssize_t(q), py::ssize_t(a));
              if (std::abs(double(by)) > 0x1p31 || std::abs(double(by - back[a])) > 0x1p30)
                throw std::invalid_argument("barycentric: offset: more than 2^30 periods");
              copy.offset[a] = std::int32_t(by - back[a]);
            }
            core::Copy_place<false> corners[4];
            for (std::size_t k = 0; k < 4; ++k)
              corners[k] = simplices_of.view.corner(copy, k);
            const std::array<double, 4> weights = core::barycentric_of(
                corners, simplices_of.points.place(wrapped.data()), are_zeros_decided);
            std::copy(weights.begin(), weights.end(), result.begin() + std::ptrdiff_t(4 * q));
          }
        });
  }
  return array_from(std::move(result), {py::ssize_t(number), 4});
}

// Takes the queries in groups, as find_simplex().
py::tuple find_copies(const Points& points, const Numbers& simplices, const Numbers& neighbors,
                      const py::object& in_box, const Points& queries, std::size_t threads)
{
  python::refuse_obstacle();
  const Rows vertices(simplices), across(neighbors);
  if (vertices.corners() != 4 || across.corners() != 4 || vertices.size() != across.size())
    throw py::value_error("find_simplex: expected tetrahedra");
  const In_box of_simplices(in_box, vertices);
  const core::Rounding_to_nearest rounding;
  const python::Interruptible_executor executor(threads);
  const Simplices_of simplices_of(points, vertices, &across, of_simplices);
  const auto number = std::size_t(queries.shape(0));
  std::vector<Index> found(number), offsets(3 * number);
  std::vector<double> coordinates;
  constexpr std::size_t group = 1 << 20;
  for (std::size_t first = 0; first < number; first += group) {
    const std::size_t size = (std::min)(group, number - first);
    python::copy_points(python::Points_view(queries, first), size, "xi: point", coordinates, first);
    const python::Unlocked unlocked;
    core::find_in_box(simplices_of.view, core::Point_array(coordinates.data(), size), first,
                      executor, [&](std::size_t i, const core::Simplex_copy<Index>& copy) {
                        found[first + i] = copy.simplex;
                        for (std::size_t a = 0; a < 3; ++a)
                          offsets[3 * (first + i) + a] = copy.offset[a];
                      });
  }
  return py::make_tuple(array_from(std::move(found), {py::ssize_t(number)}),
                        array_from(std::move(offsets), {py::ssize_t(number), 3}));
}

bool is_valid(const Points& points, const Numbers& simplices, const Numbers& vertices_of_points,
              int dimension, int level, std::size_t threads, const py::object& weights)
{
  python::refuse_obstacle();
  const Rows rows(simplices);
  const auto n = std::size_t(points.shape(0));
  if (vertices_of_points.ndim() != 1 || std::size_t(vertices_of_points.shape(0)) != n ||
      dimension < -1 || dimension > 3 ||
      rows.corners() != std::size_t((std::max)(dimension, 0)) + 1)
    return false;
  std::vector<double> coordinates, old_weights;
  python::copy_points(python::Points_view(points), n, "points: point", coordinates);
  const bool are_weighted = !weights.is_none();
  if (are_weighted) {
    const py::array_t<double> of_points = python::array_of_weights(weights, n);
    old_weights.assign(of_points.data(), of_points.data() + n);
  }
  const auto vertex = vertices_of_points.unchecked<1>();
  const python::Unlocked unlocked;
  const core::Rounding_to_nearest rounding;
  const python::Interruptible_executor executor(threads);
  std::vector<Index> old_vertices(n); // copied, since another thread may write meanwhile
  for (std::size_t i = 0; i < n; ++i) {
    old_vertices[i] = vertex(py::ssize_t(i));
    const bool is_hidden = are_weighted && old_vertices[i] == -1;
    if (!is_hidden && // not the first at its place
        (old_vertices[i] < 0 || std::size_t(old_vertices[i]) > i))
      return false;
  }
  std::vector<std::array<Index, 4>> cells(rows.size(), {-1, -1, -1, -1});
  for (std::size_t c = 0; c < rows.size(); ++c)
    for (std::size_t k = 0; k < rows.corners(); ++k)
      if ((cells[c][k] = rows.entry(c, k)) < 0 || std::size_t(cells[c][k]) >= n)
        return false;
  const std::vector<Index> met =
      number_as_met(cells.empty() ? nullptr : cells[0].data(), 4 * cells.size(), n, executor);
  std::vector<Index> number_of(n), vertices(n);
  std::vector<double> met_coordinates(3 * n), met_weights(old_weights.size());
  for (std::size_t i = 0; i < n; ++i)
    number_of[std::size_t(met[i])] = Index(i);
  for (std::size_t i = 0; i < n; ++i) {
    const Index old_vertex = old_vertices[std::size_t(met[i])];
    vertices[i] = old_vertex < 0 ? old_vertex : number_of[std::size_t(old_vertex)];
    if (are_weighted)
      met_weights[i] = old_weights[std::size_t(met[i])];
    std::copy_n(coordinates.data() + 3 * std::size_t(met[i]), 3, met_coordinates.data() + 3 * i);
  }
  const auto arrays = core::complete_arrays<Index>(dimension, cells, std::move(vertices), executor);
  if (!arrays.has_value())
    return false;
  const core::Point_array met_points(met_coordinates.data(), n);
  const auto wanted = CGAL::Delaunay_validity_level(level);
  return are_weighted ? core::is_valid_if_linked<core::Weighted_vertex>(
                            *arrays, met_points, wanted, executor, met_weights.data())
                      : core::is_valid_if_linked(*arrays, met_points, wanted, executor);
}

} // namespace

void python::define_queries(py::module_& m)
{
  m.def("array_of_points", [](const py::object& object, const std::string& name) {
    return python::array_of_points(object, name);
  });
  m.def("array_of_weights", &python::array_of_weights);
  m.def("read_alike", [](const py::object& object, const std::string& name) -> py::object {
    python::refuse_mask(name, object);
    const bool is_read = python::is_array_alike(object) && !py::isinstance<py::array>(object);
    return is_read ? py::object(python::array_from_any(name, object, "numbers")) : object;
  });
  m.def("neighbors", &neighbors);
  m.def("find_simplex", &find_simplex);
  m.def("find_copies", &find_copies);
  m.def("adjacent_vertices", &adjacent_vertices);
  m.def("minimum_spanning_tree", &minimum_spanning_tree);
  m.def("volumes", &volumes);
  m.def("circumspheres", &circumspheres);
  m.def("power_spheres", &power_spheres);
  m.def("transform", &transform);
  m.def("barycentric", &barycentric);
  m.def("barycentric_in_box", &barycentric_in_box);
  m.def("is_valid", &is_valid);
}
