// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_NEIGHBOR_SPACING_3_H
#define CGAL_NEIGHBOR_SPACING_3_H

#include <CGAL/Delaunay_from_surface_3/door/check_named_parameters.h>
#include <CGAL/Delaunay_from_surface_3/samples/read_distinct_points.h>

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

returns for each point, in their order, how far it is to its k-th nearest neighbor: how dense the
points are there. Points count as one if their coordinates are equal as doubles. Where there are
fewer than k others it is the distance to the farthest of them, and 0 if there is none. As a
function of the points this is 1-Lipschitz, up to rounding.

<b>Complexity</b>: \f$O(n \log n)\f$ for a tree of n points (`CGAL::Kd_tree`), in which n queries
are made. On points of a surface each takes about \f$O(k + \log n)\f$; there is no such bound for
all points.

\tparam PointRange a range of points, or of items that `point_map` turns into points
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the points, of any kernel; their coordinates are rounded to doubles
\param k the number of neighbors, at least 1: 6 is about the first ring on a surface, 12 and more even
out points that come along lines
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
below; any other does not compile

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{the points of the items of `points`}
    \cgalParamType{a model of `ReadablePropertyMap` from the items to points}
    \cgalParamDefault{`CGAL::Identity_property_map`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws Surface_input_error if a coordinate is not a finite number, or points are so far from each
other that the square of their distance is too large for a double

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
