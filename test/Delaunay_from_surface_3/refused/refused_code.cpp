// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls that must not compile: each gives one error, the message behind it. test_refused_code.py
// compiles this file and looks for them.

#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/surface/No_subgraph.h>
#include <CGAL/Winding_number_3.h>
#include <CGAL/bounded_degree_spanning_subgraph.h>
#include <CGAL/circumspheres_3.h>
#include <CGAL/delaunay_3_arrays.h>
#include <CGAL/insert_points_3.h>
#include <CGAL/insert_weighted_points_3.h>
#include <CGAL/inside_of_surface_3.h>
#include <CGAL/periodic_delaunay_3_arrays.h>
#include <CGAL/surface_of.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_3;
using Vertex_base = CGAL::Triangulation_vertex_base_with_info_3<int, K>;
using Tds =
    CGAL::Triangulation_data_structure_3<Vertex_base, CGAL::Delaunay_triangulation_cell_base_3<K>>;
using Without_info = CGAL::Delaunay_triangulation_3<K>;
using With_info = CGAL::Delaunay_triangulation_3<K, Tds>;
namespace parameters = CGAL::parameters;

struct Thinning_visitor : CGAL::Default_surface_insertion_visitor_3
{
  bool accept(std::size_t, std::size_t, const Point&) { return false; }
};

// As traits were before there was a core.
struct Old_traits
{
  using Surface_subgraph = CGAL::Delaunay_from_surface_3::Full_graph;
  using Insertion_plan = CGAL::Delaunay_from_surface_3::Geometric_rounds;
  template <class Target, class Subgraph>
  using Insertion_hints_3 = CGAL::Delaunay_from_surface_3::Traced_hints_3<Target, Subgraph>;
  Surface_subgraph surface_subgraph_object() const { return {}; }
  Insertion_plan insertion_plan_object(unsigned int seed) const { return Insertion_plan(seed); }
};

// A class of numbers that need not be whole.
struct Real
{
  double value;
  operator double() const { return value; }
};
template <>
struct std::numeric_limits<Real> : std::numeric_limits<double>
{
};

void call(Without_info& without_info, With_info& with_info, const std::vector<Point>& points,
          const std::vector<std::pair<Point, int>>& numbered,
          const std::vector<std::pair<Point, std::string>>& named, const std::vector<int>& infos,
          CGAL::Regular_triangulation_3<K>& weighted, std::string& text,
          const CGAL::Delaunay_3_arrays<std::int32_t>& arrays,
          const CGAL::Periodic_3_arrays<std::int32_t>& in_box,
          std::vector<std::pair<std::size_t, std::size_t>>& edges)
{
  // expected: this_function_does_not_know_that_named_parameter_see_its_documentation<CGAL::internal_np::vertex_to_vertex_map_t>
  CGAL::insert_points_3(without_info, points, parameters::vertex_to_vertex_map(1));
  // expected: infos need a vertex base with info
  CGAL::insert_points_3(without_info, numbered);
  // expected: these infos cannot be assigned to the info of the vertex base
  CGAL::insert_points_3(with_info, named);
  // expected: infos are given twice
  CGAL::insert_points_3(with_info, numbered,
                        CGAL::Delaunay_from_surface_3::vertex_info_range(infos));
  // expected: a visitor is a model of SurfaceInsertionVisitor_3
  CGAL::insert_points_3(without_info, points, parameters::visitor(1));
  // expected: a visitor is a model of SurfaceInsertionVisitor_3
  CGAL::insert_points_3(without_info, points, parameters::visitor(std::ref(text)));
  // expected: visitors leave no points out
  CGAL::insert_points_3(without_info, points, parameters::visitor(Thinning_visitor()));
  // expected: traits say by through_core who inserts
  CGAL::insert_points_3(without_info, points, std::vector<std::vector<int>>(), Old_traits());
  // expected: points with weights are inserted by insert_points_3() of CGAL/insert_weighted_points_3.h
  CGAL::insert_points_3(weighted, points, std::vector<std::vector<int>>());
  // expected: points with weights are the Weighted_point_3 of a kernel
  CGAL::insert_points_3(weighted, points);
  // expected: points are those of a kernel, or have coordinates p[0], p[1] and p[2]
  CGAL::insert_points_3(without_info, infos);
  // expected: points are those of a kernel, or have coordinates p[0], p[1] and p[2]
  CGAL::insert_points_3(without_info, std::vector<std::array<double, 2>>());
  // expected: behind the points come faces, ranges of indices, or named parameters
  CGAL::insert_points_3(without_info, points, 0);
  // expected: faces have indices of points, which are integers
  CGAL::insert_points_3(without_info, points, std::vector<std::vector<double>>());
  // expected: faces have indices of points, which are integers
  CGAL::delaunay_3_arrays(points, std::vector<std::array<float, 3>>());
  // expected: faces have indices of points, which are integers
  CGAL::inside_of_surface_3(points, std::vector<std::array<long double, 4>>(), arrays);
  // expected: faces have indices of points, which are integers
  CGAL::Winding_number_3(points, std::vector<std::array<Real, 3>>());
  // expected: is an inaccessible base of
  CGAL::circumspheres_3(in_box, points);
  // expected: faces have indices of vertices, which are integers
  CGAL::bounded_degree_spanning_subgraph(CGAL::surface_of(8, std::vector<std::array<double, 3>>()),
                                         std::back_inserter(edges));
}
