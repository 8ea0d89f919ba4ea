// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_LOCALLY_UNIFORM_SUBSET_3_H
#define CGAL_LOCALLY_UNIFORM_SUBSET_3_H

// Choi 2002, §3.1: "locally uniform samples" (Funke, Ramos 2002), on which "the surface Delaunay
// triangulation has a bounded degree". Here by greedy packing; they have another way.
//
// Invariant: the sizes of the points kept do not decrease, so a point left out, which is in the ball
// of one kept before it, is nearer to that than its own size.

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/door/check_named_parameters.h>
#include <CGAL/Delaunay_from_surface_3/samples/read_distinct_points.h>
#include <CGAL/Delaunay_from_surface_3/samples/make_lipschitz.h>
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

// When the degree is bounded. Let the sizing field f be L-Lipschitz for some L < 1: for t up to 1, t
// times the spacing is t-Lipschitz. Let p and q be kept and neighbours on the surface: a point c of it
// is as far from p as from q, and no point that is kept is nearer to it. Let c be at most r away from a
// point s of the whole sample. A point within f(s) of s is kept, so |cp| <= r + f(s) <= r + f(p) +
// L (r + |cp|). Where r is at most k f(p) with a constant k, this gives |cp| <= C f(p) with
// C = (1 + k + k L) / (1 - L). All neighbours of p are then in a ball of radius 2 C f(p) around it,
// their sizes are at least (1 - 2 C L) f(p), and so are their distances from each other. If 2 C L < 1,
// which takes an L of less than 1/3, their number is bounded.

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

writes the indices of some of the points, in ascending order: no two of these are near each other,
and every other is near one of them, where a sizing field says what is near.

The surface Delaunay triangulation of a locally uniform sample has bounded degree
(\cgalCite{choi-dtsm-02}, §3.1, of \cgalCite{fr-ssrnl-02}, who thin dense samples in another way:
they estimate normals too, and their \f$O(n \log n)\f$ holds in the worst case). For the subsets
found here this is proved if the sample is dense and the sizing field changes slowly, with a
Lipschitz constant well below 1; for others it is measured: \ref dfs_statements_uniform.

The sizing field is what `sizing` says, made 1-Lipschitz: the size of p is the minimum over all points
q of what it says for q, plus the distance of p and q. A function that is 1-Lipschitz stays as it is,
up to rounding. Points are looked at from the smallest size on, then by their indices, and a point is
kept if it is in no ball of a point that was kept. A ball's radius is the size of its center, and its
boundary does not belong to it. So

- two points that are kept have at least the distance of the smaller of their sizes, and half of
the larger one;
- a point that is left out is nearer than its size to one that is kept, or equal to it.

Coordinates are rounded to doubles; points that are equal then count as equal, and of these the
first one is looked at, with the smallest of their sizes. The distances hold up to rounding.

Subsets for several factors of the same sizing field are not nested, subsets of subsets are
(\ref dfs_example_thinning).

<b>Complexity</b>: \f$O(n \log n)\f$ for two trees of n points (`CGAL::Kd_tree`), in which n queries for
sizes are made, and one for each point that is kept. These find each point at most a constant number
of times for all sizes between s and 2s. The trees give no bound on what a query looks at besides; on
surfaces that is little.

\tparam PointRange a range of points, or of items that `point_map` turns into points
\tparam Sizing a function that gets the index of a point and returns its size, a number convertible
to `double`: some multiple of `neighbor_spacing_3()`, a constant, the distance to the nearest pole, …
\tparam OutputIterator a model of `OutputIterator` that accepts `std::size_t`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the points, of any kernel
\param sizing is called once for each point
\param out receives the indices of the points that are kept
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
below; any other does not compile

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{the points of the items of `points`}
    \cgalParamType{a model of `ReadablePropertyMap` from the items to points}
    \cgalParamDefault{`CGAL::Identity_property_map`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the output iterator past the last index written

\throws Surface_input_error if a size is negative or not a finite number, a coordinate is not a finite
number, or points are so far from each other that the square of their distance is too large for a
double; nothing is then written

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
