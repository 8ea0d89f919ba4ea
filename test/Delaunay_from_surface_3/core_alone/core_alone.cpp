// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The core by itself, as a program would use it that has never heard of CGAL: points of every
// dimension, degenerate ones, with edges and without, into arrays.

#include <CGAL/Delaunay_from_surface_3/arrays/arrays_of_built.h>
#include <CGAL/Delaunay_from_surface_3/arrays/is_valid_arrays.h>
#include <CGAL/Delaunay_from_surface_3/core/build.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Given_edges.h>
#include <CGAL/Delaunay_from_surface_3/core/order/lower_neighbors.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace core = CGAL::Delaunay_from_surface_3::internal;
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

// Successive points are joined, whatever they are.
core::Lists<std::uint32_t> path(std::size_t n)
{
  std::vector<core::Large_vector<core::Numbered_edge>> edges(1);
  for (std::size_t i = 1; i < n; ++i)
    edges[0].emplace_back(std::uint32_t(i), std::uint32_t(i - 1));
  return core::lower_neighbors(edges, n);
}

Arrays arrays_of(const std::vector<double>& coordinates, bool has_edges, const char* where)
{
  const std::size_t n = coordinates.size() / 3;
  core::Given_points points(core::Point_array(coordinates.data(), n));
  core::Given_edges edges(has_edges ? path(n) : core::Lists<std::uint32_t>());
  const auto orders = core::order_of_core(core::Order_request(), edges);
  core::Watcher nobody;
  const auto built = core::build<std::uint32_t, core::One_thread>(points, *orders, {true, true},
                                                                  nobody, core::Alone());
  const Arrays arrays = core::arrays_of_built<std::int32_t>(*built, points);
  check(core::is_valid(arrays, points.points(), CGAL::Delaunay_validity_level::DELAUNAY),
        "is no Delaunay triangulation", where);
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
    for (const bool has_edges : {false, true}) {
      const Arrays arrays = arrays_of(lattice(x, y, z, scale), has_edges, where);
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
  check(arrays_of({}, false, "nothing").dimension() == -1, "dimension", "nothing");
  check_lattice(1, 1, 1, "a point");
  check_lattice(1, 9, 1, "a line");
  check_lattice(7, 1, 6, "a plane");
  check_lattice(5, 6, 7, "space");
  const Arrays sheared = arrays_of(lattice(6, 7, 1, 1, true), true, "a sheared plane");
  check(sheared.dimension() == 2, "dimension", "a sheared plane");
  check(sheared.number_of_simplices() == 60, "number of simplices", "a sheared plane");
  std::vector<double> twice = lattice(4, 4, 4, 1);
  twice.insert(twice.end(), twice.begin(), twice.end());
  const Arrays duplicates = arrays_of(twice, true, "every point twice");
  check(duplicates.number_of_points() == 128, "points", "every point twice");
  check(duplicates.number_of_vertices() == 64, "vertices", "every point twice");
  if (failures == 0)
    std::printf("all is right\n");
  return failures != 0;
}
