// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_INSERTION_PLANS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_INSERTION_PLANS_H

// Provides the core's orders for the points of any kernel, and code that the public plans share.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/core/build.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/core/order/spaced_rounds.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Page_array.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/Random.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/algorithm.h>
#include <CGAL/assertions.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Sorts indices by their points. Sorting (point, index) pairs keeps the points beside each other in
// memory; sorting bare indices would miss the cache at every comparison.
template <class Point, class GeomTraits, class Sort>
void sort_indices(const std::vector<Point>& points, const GeomTraits& gt,
                  std::vector<std::size_t>::iterator first, std::vector<std::size_t>::iterator last,
                  const Sort& sort)
{
  using Item = std::pair<Point, std::size_t>;
  using Adapter = Spatial_sort_traits_adapter_3<GeomTraits, First_of_pair_property_map<Item>>;

  std::vector<Item> items;
  items.reserve(static_cast<std::size_t>(last - first));
  for (auto it = first; it != last; ++it)
    items.emplace_back(points[*it], *it);

  sort(items.begin(), items.end(), Adapter(First_of_pair_property_map<Item>(), gt));

  for (const Item& item : items)
    *first++ = item.second;
}

// Sorts the first `number_of_rounds` rounds, or all if there are fewer, each along a Hilbert curve
// through its points.
template <class Point, class GeomTraits>
void hilbert_sort_rounds(const std::vector<Point>& points, const GeomTraits& gt,
                         Insertion_order& plan, std::size_t number_of_rounds)
{
  auto first = plan.order.begin();
  for (std::size_t h = 0; h < (std::min)(number_of_rounds, plan.round_ends.size()); ++h) {
    const auto last = plan.order.begin() + std::ptrdiff_t(plan.round_ends[h]);
    sort_indices(points, gt, first, last,
                 [](auto b, auto e, const auto& traits) { hilbert_sort(b, e, traits); });
    first = last;
  }
}

inline std::vector<std::size_t> identity_order(std::size_t n)
{
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t(0));
  return order;
}

// Returns a uniformly random permutation of 0, …, n-1, which CGAL's random numbers determine.
inline std::vector<std::size_t> random_order(std::size_t n, unsigned int seed)
{
  std::vector<std::size_t> order = identity_order(n);
  Random random(seed);
  cpp98::random_shuffle(order.begin(), order.end(), random);
  return order;
}

// Returns x, y and z of one point after the other, as doubles near them.
template <class Point>
Large_vector<double> rounded_coordinates(const std::vector<Point>& points)
{
  Large_vector<double> coordinates;
  coordinates.reserve(3 * points.size());
  for (const Point& p : points) {
    coordinates.push_back(to_double(p.x()));
    coordinates.push_back(to_double(p.y()));
    coordinates.push_back(to_double(p.z()));
  }
  return coordinates;
}

template <class Point>
Insertion_order order_by_core(const std::vector<Point>& points, Build_options options)
{
  const auto coordinates = rounded_coordinates(points);
  Given_points source(Point_array(coordinates.data(), points.size()));
  Observer nobody;
  options.inserts = false;
  return copy_of(build(source, options, nobody, Alone())->order);
}

// Returns what a plan of the core's asks of it.
template <class Plan>
Build_options options_of(const Plan& plan)
{
  Build_options options;
  plan.ask(options);
  return options;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal

// Geometric_rounds and Spaced_rounds are the public faces of core/order/spaced_rounds.h.

/*!
\ingroup PkgDelaunayFromSurface3Plans

draws a random order, without using a surface, and cuts it into rounds that grow geometrically. Each
round is then sorted by halves: it is split at the median across its longest extent, the half that
is nearer to the preceding point comes first, and so on. This is a biased randomised insertion order
(\cgalCite{acr-icbr-03}): random enough for the expected size of the conflict zones, and coherent
enough for short walks and good use of caches.

<b>Complexity</b>: expected \f$O(n \log n)\f$ for n points.

\cgalModels{InsertionPlan}
*/
class Geometric_rounds
{
public:
  /*!
  makes the plan.

  \param seed determines the random order
  \param ratio the number of points before a round, divided by the number of points up to its end
  \param first_round the largest number of points of the first round

  \pre 0 < `ratio` < 1
  \pre `first_round` > 0
  */
  explicit Geometric_rounds(unsigned int seed = 0, double ratio = 0.125,
                            std::size_t first_round = 64)
    : m_seed(seed)
    , m_ratio(ratio)
    , m_first_round(first_round)
  {
    CGAL_precondition(0 < ratio && ratio < 1 && first_round > 0);
  }

  /// returns order and rounds of `points`. The graph is not used.
  template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
  Insertion_order operator()(const std::vector<Point>& points, const GeomTraits&, const Graph&,
                             VertexIndexMap) const
  {
    return internal::order_by_core(points, internal::options_of(*this));
  }

  /// returns the round ends …, ⌊ratio ⌊ratio n⌋⌋, ⌊ratio n⌋, n, and none for n = 0.
  std::vector<std::size_t> round_ends(std::size_t n) const
  {
    return internal::geometric_round_ends(n, m_ratio, m_first_round);
  }

  /// \cond
  using Plan_of_core = Geometric_rounds;

  void ask(internal::Build_options& options) const
  {
    options.rounds = internal::Build_options::RANDOM;
    options.seed = m_seed;
    options.ratio = m_ratio;
    options.first_round = m_first_round;
  }
  /// \endcond

private:
  unsigned int m_seed;
  double m_ratio;
  std::size_t m_first_round;
};

/*!
\ingroup PkgDelaunayFromSurface3Plans

makes rounds of well-spaced points without using a surface. The points are sorted once by halves, as
`Geometric_rounds` sorts a round. Along that order a point becomes a centre unless one of the last
six centres is nearer than .35 of the diagonal of a box of eight successive points: the root mean
square over the point's own box and the two beside it. The points that are not centres form the last
round. The same is done with the centres to get the round before, and so on, until at most 64 are
left. If fewer than an eighth of the points are near a centre, only every second centre is kept.
Each point starts at its centre (`Insertion_order::starting_places`).

Points that come late are crowded, and so destroy few cells. This was measured on surfaces and in
volumes. No bound is proved, so there is a budget.

<b>Complexity</b>: \f$O(n \log n)\f$ for n points.

\cgalModels{InsertionPlan}
*/
class Spaced_rounds
{
public:
  /// the budget (`InsertionPlan::cells_per_point`).
  static constexpr std::size_t cells_per_point = internal::Build_options::usual_number;

  /// makes the plan. Only `fallback_plan()` uses the seed: this order has no random numbers.
  explicit Spaced_rounds(unsigned int seed = 0)
    : m_seed(seed)
  {
  }

  /// returns order, rounds and starting places of `points`. The graph is not used.
  template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
  Insertion_order operator()(const std::vector<Point>& points, const GeomTraits&, const Graph&,
                             VertexIndexMap) const
  {
    return internal::order_by_core(points, internal::options_of(*this));
  }

  /// returns the plan that is used when the budget is exceeded; the bound of \cgalCite{acr-icbr-03}
  /// holds for it.
  Geometric_rounds fallback_plan() const { return Geometric_rounds(m_seed); }

  /// \cond
  using Plan_of_core = Spaced_rounds;

  void ask(internal::Build_options& options) const { options.seed = m_seed; }
  /// \endcond

private:
  unsigned int m_seed;
};

// Spatial_sort_order is the control: the order of CGAL's own insert(first, last), in one round.

/*!
\ingroup PkgDelaunayFromSurface3Plans

orders the points by `CGAL::spatial_sort()`, all in one round. This is the order in which
`Delaunay_triangulation_3::insert(first, last)` inserts; with `Previous_hint_3` it reproduces that
function insertion by insertion. The seed is not used: `spatial_sort()` has its own.

<b>Complexity</b>: expected \f$O(n \log n)\f$ for n points.

\cgalModels{InsertionPlan}
*/
class Spatial_sort_order
{
public:
  /// makes the plan, which is the same for every seed.
  explicit Spatial_sort_order(unsigned int /* seed */ = 0) {}

  /// returns the order of `points`. The graph is not used.
  template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
  Insertion_order operator()(const std::vector<Point>& points, const GeomTraits& gt, const Graph&,
                             VertexIndexMap) const
  {
    using namespace Delaunay_from_surface_3::internal;
    Insertion_order plan;
    plan.order = identity_order(points.size());
    sort_indices(points, gt, plan.order.begin(), plan.order.end(),
                 [](auto b, auto e, const auto& traits) { spatial_sort(b, e, traits); });
    if (!points.empty())
      plan.round_ends.push_back(points.size());
    return plan;
  }
};

// Log_star_rounds follows Choi 2002, §2: "Let s_1, s_2, …, s_n be a random ordering", and Fig. 1,
// line 2a: the traces come after s_i with i = N_h = ⌈n / log^(h) n⌉, 1 <= h <= log* n.

/*!
\ingroup PkgDelaunayFromSurface3Plans

is the plan of the paper (\cgalCite{choi-dtsm-02}, §2 and Fig.\ 1): a uniformly random order, and
rounds that end at \f$N_h = \lceil n / \log^{(h)} n \rceil\f$ (log to base 2, iterated h times) for
all h with \f$\log^{(h)} n \ge 1\f$, of which the largest is \f$\log^* n\f$, and at n. Where two
round ends coincide, or one is not less than n, the empty round is dropped.

Rounds are sorted unless you choose otherwise. The set of points inserted by the end of each round is
still random, and walks from one point to the next are short. But inside a sorted round the order is
not random, so the paper's bounds on location and on cells created do not apply there.

<b>Complexity</b>: \f$O(n)\f$ for n points, plus expected \f$O(k \log k)\f$ for the k points of
sorted rounds, which is \f$O(n)\f$ for the first round.

\cgalModels{InsertionPlan}
*/
class Log_star_rounds
{
public:
  /// the rounds that follow a Hilbert curve.
  enum Sorted_rounds {
    NO_ROUND,    ///< the paper's order, required by the bounds of `Conflict_history_hints_3`
    FIRST_ROUND, ///< the paper's order as far as walks allow: no trace comes before this round
    ALL_ROUNDS   ///< for speed on a machine with caches
  };

  /// makes the plan. `seed` determines the random order.
  explicit Log_star_rounds(unsigned int seed = 0, Sorted_rounds sorted = ALL_ROUNDS)
    : m_seed(seed)
    , m_sorted(sorted)
  {
  }

  /// returns order and rounds of `points`. The graph is not used.
  template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
  Insertion_order operator()(const std::vector<Point>& points, const GeomTraits& gt, const Graph&,
                             VertexIndexMap) const
  {
    Insertion_order plan;
    plan.order = internal::random_order(points.size(), m_seed);
    plan.round_ends = round_ends(points.size());
    const std::size_t all = plan.round_ends.size();
    internal::hilbert_sort_rounds(points, gt, plan,
                                  m_sorted == ALL_ROUNDS ? all : std::size_t(m_sorted));
    return plan;
  }

  /// returns the round ends N_1 < N_2 < … < n, including n; none for n = 0.
  static std::vector<std::size_t> round_ends(std::size_t n)
  {
    std::vector<std::size_t> ends;
    // log* n is the largest h with log^(h) n >= 1: the loop runs for exactly these h.
    double log_h = n > 1 ? std::log2(double(n)) : 0.;
    while (log_h >= 1.) {
      const auto end = static_cast<std::size_t>(std::ceil(double(n) / log_h));
      if (end < n && (ends.empty() || end > ends.back()))
        ends.push_back(end);
      log_h = std::log2(log_h);
    }
    if (n > 0)
      ends.push_back(n);
    return ends;
  }

private:
  unsigned int m_seed;
  Sorted_rounds m_sorted;
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_INSERTION_PLANS_H
