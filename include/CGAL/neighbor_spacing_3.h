// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_NEIGHBOR_SPACING_3_H
#define CGAL_NEIGHBOR_SPACING_3_H

#include <CGAL/Delaunay_from_surface_3/adapters/check_named_parameters.h>
#include <CGAL/Delaunay_from_surface_3/samples/Distinct_points.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Samples

computes the distance from each point to its k-th nearest neighbor, a measure of the spacing of the
points there. Points count as one if their coordinates are equal as doubles. If there are
fewer than k others, it is the distance to the farthest of them, and 0 if there is none. As a
function of the points, this spacing is 1-Lipschitz, up to rounding. It is computed by squares:
distances below about 1e-154 lose digits, and those below 1e-162 are 0.

<b>Complexity</b>: \f$O(n \log n)\f$ for a tree of n points (`CGAL::Kd_tree`), which is queried n
times. On points of a surface each query takes about \f$O(k + \log n)\f$; there is no such bound for
arbitrary points.

\tparam PointRange a range of points of any kernel, or of items that `point_map` maps to such points
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the points; their coordinates are rounded to doubles
\param k the number of neighbors, at least 1. On a surface, 6 is about the first ring; 12 and more
even out points that lie along lines.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
below; any other does not compile

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{maps the items of `points` to points}
    \cgalParamType{a model of `ReadablePropertyMap` from the items to points}
    \cgalParamDefault{`CGAL::Identity_property_map`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the distances, in the order of `points`

\throws Surface_input_error if a coordinate is not a finite number, or the squared diagonal of the
bounding box of the points overflows a double

\pre `k` > 0

Example: \ref Delaunay_from_surface_3/locally_uniform_subset.cpp

\sa `locally_uniform_subset_3()`
*/
template <class PointRange, typename CGAL_NP_TEMPLATE_PARAMETERS>
std::vector<double> neighbor_spacing_3(const PointRange& points, std::size_t k = 12,
                                       const CGAL_NP_CLASS& np = parameters::default_values())
{
  using namespace Delaunay_from_surface_3::internal;
  check_named_parameters<internal_np::point_t>(np);
  CGAL_precondition(k > 0);
  const Distinct_points distinct = read_distinct_points(points, np);
  const Numbered_point_tree tree = distinct.tree();
  using Search = Orthogonal_k_neighbor_search<Numbered_point_traits>;
  const unsigned int with_itself =
      static_cast<unsigned int>(k < distinct.size() ? k + 1 : distinct.size());

  std::vector<double> of_distinct;
  of_distinct.reserve(distinct.size());
  for (const Plain_point& p : distinct.points()) {
    const Search search(tree, p, with_itself);
    double squared = 0;
    for (const auto& neighbor : search)
      squared = (std::max)(squared, neighbor.second);
    of_distinct.push_back(std::sqrt(squared));
  }
  return distinct.spread(of_distinct);
}

} // namespace CGAL

#endif // CGAL_NEIGHBOR_SPACING_3_H
