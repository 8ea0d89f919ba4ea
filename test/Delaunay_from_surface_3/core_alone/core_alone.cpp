// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The core by itself, as a program would use it that has never heard of CGAL: points of every
// dimension, degenerate ones, in both orders, into arrays.

#include <CGAL/Delaunay_from_surface_3/arrays/Find_simplex.h>
#include <CGAL/Delaunay_from_surface_3/arrays/arrays_of_built.h>
#include <CGAL/Delaunay_from_surface_3/arrays/complete_arrays.h>
#include <CGAL/Delaunay_from_surface_3/arrays/is_valid_arrays.h>
#include <CGAL/Delaunay_from_surface_3/core/build.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace core = CGAL::Delaunay_from_surface_3::core;
using Arrays = CGAL::Delaunay_3_arrays<std::int32_t>;

namespace {

int failures = 0;

void check(bool holds, const char* what, const char* where)
{
  if (!holds)
    std::printf("%s: %s\n", where, what);
  failures += !holds;
}

// Those of an x × y × z lattice, as it is or mapped to another plane or line, times a scale.
std::vector<double> lattice(int x, int y, int z, double scale, bool is_sheared = false)
{
  std::vector<double> coordinates;
  for (int i = 0; i < x; ++i)
    for (int j = 0; j < y; ++j)
      for (int k = 0; k < z; ++k)
        for (const int c : {i, j, is_sheared ? i + j + k : k})
          coordinates.push_back(scale * c);
  return coordinates;
}

std::vector<std::array<std::int32_t, 4>> simplices_of(const Arrays& arrays)
{
  std::vector<std::array<std::int32_t, 4>> simplices(arrays.number_of_simplices());
  for (std::size_t c = 0; c < simplices.size(); ++c)
    simplices[c] = arrays.vertices(c);
  return simplices;
}

// Neighbours and infinite cells are found again from the simplices alone.
void check_completion(const Arrays& arrays, const core::Point_array& points, const char* where)
{
  const auto completed = core::complete_arrays<std::int32_t>(
      arrays.dimension(), simplices_of(arrays), arrays.vertices_of_points(), core::Alone());
  check(completed.has_value(), "facets in pairs", where);
  const Arrays& complete = *completed;
  check(complete.number_of_cells() == arrays.number_of_cells(), "infinite cells", where);
  check(core::is_valid(complete, points, CGAL::Delaunay_validity_level::DELAUNAY),
        "is not valid when completed", where);
  for (std::size_t c = 0; c < arrays.number_of_simplices() && arrays.dimension() > 0; ++c)
    for (std::size_t k = 0; k <= std::size_t(arrays.dimension()); ++k) {
      const std::int32_t d = arrays.neighbors(c)[k];
      check(arrays.is_infinite(d) || complete.neighbors(c)[k] == d, "neighbour", where);
    }
}

// A vertex is found in the first of its tetrahedra, and has the others' vertices around it.
void check_queries(const Arrays& arrays, const core::Point_array& points, const char* where)
{
  const auto simplices = simplices_of(arrays);
  const auto adjacent = core::adjacent_vertices<std::int32_t>(
      simplices.size(), 4, points.size(),
      [&](std::size_t c, std::size_t k) { return simplices[c][k]; }, core::Alone());
  const core::Simplices_view<std::int32_t> view = {arrays.vertices_data(),
                                                   arrays.stride(),
                                                   arrays.neighbors_data(),
                                                   arrays.stride(),
                                                   arrays.number_of_simplices(),
                                                   arrays.number_of_cells(),
                                                   points.size()};
  const auto point_of = [&](std::size_t i) {
    return std::array<double, 3>{points[i][0], points[i][1], points[i][2]};
  };
  core::Find_simplex<std::int32_t, decltype(point_of)> find(view, point_of);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto v = arrays.vertex_of_point(i);
    const auto first = std::find_if(simplices.begin(), simplices.end(), [&](const auto& simplex) {
      return std::find(simplex.begin(), simplex.end(), v) != simplex.end();
    });
    check(find(point_of(i)) == first - simplices.begin(), "simplex of a vertex", where);
    const auto begin = adjacent.items.begin() + adjacent.first[i];
    const auto end = adjacent.items.begin() + adjacent.first[i + 1];
    check(std::is_sorted(begin, end) && (end - begin >= 3 || v != std::int32_t(i)),
          "adjacent vertices", where);
    if (v == std::int32_t(i))
      for (const auto w : *first)
        check(w == v || std::binary_search(begin, end, w), "adjacent vertex", where);
  }
}

Arrays arrays_of(const std::vector<double>& coordinates, core::Build_options::Rounds rounds,
                 const char* where)
{
  const std::size_t n = coordinates.size() / 3;
  core::Given_points points(core::Point_array(coordinates.data(), n));
  core::Build_options options;
  options.rounds = rounds;
  options.adds_apex = true;
  core::Observer nobody;
  const auto built = core::build(points, options, nobody, core::Alone());
  const Arrays arrays = core::arrays_of_built<std::int32_t>(*built, points, core::Alone());
  check(core::is_valid(arrays, points.points(), CGAL::Delaunay_validity_level::DELAUNAY),
        "is no Delaunay triangulation", where);
  check_completion(arrays, points.points(), where);
  if (arrays.dimension() == 3)
    check_queries(arrays, points.points(), where);
  return arrays;
}

// Unit cells of a lattice, of which each is filled by as many simplices as its perturbed
// triangulation has: two triangles, five or six tetrahedra.
void check_lattice(int x, int y, int z, const char* where)
{
  const int cells = (x > 1 ? x - 1 : 1) * (y > 1 ? y - 1 : 1) * (z > 1 ? z - 1 : 1);
  const int dimension = int(x > 1) + int(y > 1) + int(z > 1);
  const int least[] = {1, 1, 2, 5}, most[] = {1, 1, 2, 6};
  for (const double scale : {1., 0x1p-1070, 0x1p1000, .1})
    for (const auto rounds : {core::Build_options::SPACED, core::Build_options::RANDOM}) {
      const Arrays arrays = arrays_of(lattice(x, y, z, scale), rounds, where);
      check(arrays.dimension() == dimension, "dimension", where);
      check(arrays.number_of_points() == std::size_t(x * y * z), "points", where);
      check(arrays.number_of_vertices() == std::size_t(x * y * z), "vertices", where);
      if (scale == .1 && dimension == 3)
        continue; // rounded, it has slivers
      const auto simplices = int(arrays.number_of_simplices());
      check(simplices >= least[dimension] * cells && simplices <= most[dimension] * cells,
            "number of simplices", where);
    }
}

} // namespace

int main()
{
  check(arrays_of({}, core::Build_options::SPACED, "nothing").dimension() == -1, "dimension",
        "nothing");
  check_lattice(1, 1, 1, "a point");
  check_lattice(1, 9, 1, "a line");
  check_lattice(7, 1, 6, "a plane");
  check_lattice(5, 6, 7, "space");
  const Arrays sheared =
      arrays_of(lattice(6, 7, 1, 1, true), core::Build_options::SPACED, "a sheared plane");
  check(sheared.dimension() == 2, "dimension", "a sheared plane");
  check(sheared.number_of_simplices() == 60, "number of simplices", "a sheared plane");
  std::vector<double> twice = lattice(4, 4, 4, 1);
  twice.insert(twice.end(), twice.begin(), twice.end());
  const Arrays duplicates = arrays_of(twice, core::Build_options::SPACED, "every point twice");
  check(duplicates.number_of_points() == 128, "points", "every point twice");
  check(duplicates.number_of_vertices() == 64, "vertices", "every point twice");
  if (failures == 0)
    std::printf("all is right\n");
  return failures != 0;
}
