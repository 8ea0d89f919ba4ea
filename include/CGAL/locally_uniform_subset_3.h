// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_LOCALLY_UNIFORM_SUBSET_3_H
#define CGAL_LOCALLY_UNIFORM_SUBSET_3_H

// Choi 2002, §3.1: "locally uniform samples" (Funke, Ramos 2002), on which "the surface Delaunay
// triangulation has a bounded degree". Here they are found by greedy packing, unlike there.
//
// Invariant: the sizes of the points kept do not decrease. So a point left out, which is in the
// ball of one kept before it, is nearer to that one than its own size.

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/adapters/check_named_parameters.h>
#include <CGAL/Delaunay_from_surface_3/samples/Distinct_points.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

// When the degree is bounded. Let the sizing field f be L-Lipschitz for some L < 1: for t up to 1,
// t times the spacing is t-Lipschitz. Let p and q be kept and neighbours on the surface: some point
// c of the surface is as far from p as from q, and no point that is kept is nearer to c. Let c be
// at most r away from a point s of the whole sample. A point within f(s) of s is kept, so
// |cp| <= r + f(s) <= r + f(p) + L (r + |cp|). If r is at most k f(p) with a constant k, this gives
// |cp| <= C f(p) with C = (1 + k + k L) / (1 - L). All neighbours of p are then in a ball of radius
// 2 C f(p) around it. Their sizes are at least (1 - 2 C L) f(p), and so are their distances from each
// other. If 2 C L < 1, which requires an L of less than 1/3, their number is bounded.

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// What `sizing` says, lowered to a 1-Lipschitz function; of equal points the smallest counts.
template <class Sizing>
std::vector<double> lipschitz_sizes(const Distinct_points& distinct, const Sizing& sizing)
{
  std::vector<double> sizes(distinct.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < distinct.number_of_all(); ++i) {
    const double size = static_cast<double>(sizing(i));
    if (!(size >= 0) || !std::isfinite(size))
      throw Surface_input_error("point " + std::to_string(i) +
                                ": its size is negative or not a finite number");
    double& least = sizes[distinct.number(i)];
    least = (std::min)(least, size);
  }
  make_lipschitz(distinct.points(), sizes);
  return sizes;
}

// From the smallest size on, each point that is in no ball of a point kept.
inline std::vector<bool> packing(const Distinct_points& distinct, const std::vector<double>& sizes)
{
  std::vector<std::size_t> order(distinct.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t k, std::size_t l) {
    return sizes[k] < sizes[l] ||
           (sizes[k] == sizes[l] && distinct.first_index(k) < distinct.first_index(l));
  });
  const Numbered_point_tree tree = distinct.tree();
  std::vector<bool> is_kept(distinct.size(), false), is_left_out(distinct.size(), false);
  std::vector<Numbered_point> ball;
  for (const std::size_t k : order) {
    if (is_left_out[k])
      continue;
    is_kept[k] = true;
    const Plain_point& p = distinct.points()[k];
    const double squared_size = sizes[k] * sizes[k];
    ball.clear();
    tree.search(std::back_inserter(ball), Fuzzy_sphere<Numbered_point_traits>(p, sizes[k]));
    for (const auto& [q, l] : ball)
      if (!is_kept[l] && squared_length_between(p, q) < squared_size)
        is_left_out[l] = true;
  }
  return is_kept;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3

/*!
\ingroup PkgDelaunayFromSurface3Samples

selects a subset of the points by a sizing field: no two points of the subset are near each other,
and every other point is near one of them. It writes the indices of the subset in ascending order.

The size of a point p is the minimum over all points q of `sizing` at q plus the distance from p to
q. This makes the sizing field 1-Lipschitz; a function that is 1-Lipschitz already remains
unchanged, up to rounding. The points are processed by increasing size, then by index. A point is
kept unless it is in the open ball around a point kept before, whose radius is the size of that
point. So

- two points that are kept have a distance of at least the smaller of their sizes, and at least half
of the larger one;
- a point that is left out is nearer than its size to one that is kept, or equal to it.

Coordinates are rounded to doubles, and points that are then equal count as one, with the first
index and the smallest size of these. The distances hold up to rounding, if sizes are 0 or at least
1e-154: distances are compared by their squares, which must not underflow.

The surface Delaunay triangulation of a locally uniform sample has bounded degree
(\cgalCite{choi-dtsm-02}, §3.1, after \cgalCite{fr-ssrnl-02}, who thin dense samples in another way:
they also estimate normals, and their bound \f$O(n \log n)\f$ holds in the worst case). For the
subsets found here this is proved if the sample is dense and the sizing field changes slowly, with a
Lipschitz constant below 1/3; for others it was measured: \ref dfs_statements_uniform.

Subsets for several multiples of the same sizing field are not nested; subsets of subsets are, as in
the example.

<b>Complexity</b>: \f$O(n \log n)\f$ for two trees of n points (`CGAL::Kd_tree`). They are queried n
times for sizes, and once for each point that is kept. For all sizes between s and 2s, the latter
queries find each point at most a constant number of times. The trees give no bound on the other
points that a query visits; on surfaces there are few.

\tparam PointRange a range of points of any kernel, or of items that `point_map` maps to such points
\tparam Sizing a function object that takes the index of a point and returns its size, a number
convertible to `double`: a multiple of `neighbor_spacing_3()`, a constant, the distance to the
nearest pole, …
\tparam OutputIterator a model of `OutputIterator` that accepts `std::size_t`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the points
\param sizing the sizing field, which is called once for each point
\param out receives the indices of the points that are kept, in ascending order
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
below; any other does not compile

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{maps the items of `points` to points}
    \cgalParamType{a model of `ReadablePropertyMap` from the items to points}
    \cgalParamDefault{`CGAL::Identity_property_map`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the output iterator past the last index written

\throws Surface_input_error if a size is negative or not a finite number, a coordinate is not a
finite number, or the squared diagonal of the bounding box of the points overflows a double; nothing
is then written

Example: \ref Delaunay_from_surface_3/locally_uniform_subset.cpp

\sa `neighbor_spacing_3()`
*/
template <class PointRange, class Sizing, class OutputIterator,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
OutputIterator locally_uniform_subset_3(const PointRange& points, const Sizing& sizing,
                                        OutputIterator out,
                                        const CGAL_NP_CLASS& np = parameters::default_values())
{
  using namespace Delaunay_from_surface_3::internal;
  check_named_parameters<internal_np::point_t>(np);
  const Distinct_points distinct = read_distinct_points(points, np);
  const std::vector<bool> is_kept = packing(distinct, lipschitz_sizes(distinct, sizing));
  for (std::size_t i = 0; i < distinct.number_of_all(); ++i)
    if (is_kept[distinct.number(i)] && distinct.first_index(distinct.number(i)) == i)
      *out++ = i;
  return out;
}

} // namespace CGAL

#endif // CGAL_LOCALLY_UNIFORM_SUBSET_3_H
