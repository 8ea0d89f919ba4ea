// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_ORDER_OF_CORE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_ORDER_OF_CORE_H

#include <CGAL/Delaunay_from_surface_3/Insertion_counts.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/core/order/spaced_rounds.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/assertions.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// A view of an order that is kept elsewhere.
inline Order_view view_of(const Insertion_order& order)
{
  return {order.order.data(), order.order.size(), order.round_ends.data(), order.round_ends.size(),
          order.starting_places.empty() ? nullptr : order.starting_places.data()};
}

// A copy, which owns its arrays.
inline Insertion_order copy_of(const Order_view& view)
{
  Insertion_order order;
  order.order.assign(view.order, view.order + view.size);
  order.round_ends.assign(view.round_ends, view.round_ends + view.number_of_rounds);
  if (view.starting_places != nullptr)
    order.starting_places.assign(view.starting_places, view.starting_places + view.size);
  return order;
}

// Whether it is an order of n points: a permutation, rounds that end later and later, the last with
// the last point, and no starting places or one before each. Linear.
inline bool is_order(const Insertion_order& order, std::size_t n)
{
  std::vector<char> is_there(n);
  for (const std::size_t i : order.order)
    if (i >= n || is_there[i]++ != 0)
      return false;
  for (std::size_t h = 0; h < order.round_ends.size(); ++h)
    if (order.round_ends[h] <= (h == 0 ? 0 : order.round_ends[h - 1]))
      return false;
  for (std::size_t k = 1; k < order.starting_places.size(); ++k)
    if (order.starting_places[k] >= k)
      return false;
  return order.order.size() == n && (order.round_ends.empty() ? 0 : order.round_ends.back()) == n &&
         (order.starting_places.empty() || order.starting_places.size() == n);
}

// The order requested. Rounds are random where there are too many points for numbers of 32 bits.
inline Insertion_order order_of_points(const Point_array& points, const Order_request& request,
                                       const Executor& executor)
{
  const bool are_few = points.size() < (std::numeric_limits<std::uint32_t>::max)();
  Insertion_order order =
      request.kind == Order_request::SPACED && are_few
          ? spaced_rounds(points, executor)
          : geometric_rounds(points, request.seed, request.ratio, request.first_round);
  CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT_EXPENSIVE(is_order(order, points.size()));
  return order;
}

// The order that the core makes itself: in spaced rounds, within a budget; then in random rounds.
class Order_of_core final : public Order_source
{
public:
  explicit Order_of_core(const Order_request& request)
    : m_request(request)
  {
  }

  Order_view make(const Point_array& points, const Executor& executor) override
  {
    m_order = order_of_points(points, m_request, executor);
    return view_of(m_order);
  }
  std::size_t cells_per_point() const override
  {
    return is_spread() ? cells_per_point_of_core : any_number;
  }
  bool is_spread() const override { return m_request.kind == Order_request::SPACED; }
  bool go_on() override
  {
    m_order = Insertion_order(); // before there is another
    return std::exchange(m_request.kind, Order_request::GEOMETRIC) != Order_request::GEOMETRIC;
  }

private:
  Order_request m_request;
  Insertion_order m_order;
};

// The order of the last call, for points that have moved a little: the caller keeps it from call to
// call. Where there is none yet, or it is one of fewer or more points, or it costs too much by now,
// a new one is made and kept.
class Kept_order final : public Order_source
{
public:
  // Keeps a reference.
  Kept_order(Insertion_order& kept, std::unique_ptr<Order_source> source)
    : m_kept(kept)
    , m_source(std::move(source))
  {
  }

  Order_view make(const Point_array& points, const Executor& executor) override
  {
    m_is_given = !m_is_spent && m_kept.order.size() == points.size();
    if (!m_is_given)
      m_kept = copy_of(m_source->make(points, executor));
    else if (!is_order(m_kept, points.size()))
      throw Surface_input_error("what is given as the order of the points is none");
    return view_of(m_kept);
  }
  std::size_t cells_per_point() const override { return m_source->cells_per_point(); }
  bool is_spread() const override { return m_source->is_spread(); }
  bool go_on() override
  {
    m_is_spent = true;
    return m_is_given || m_source->go_on(); // a given order is followed by the first of the source
  }

private:
  Insertion_order& m_kept;
  std::unique_ptr<Order_source> m_source;
  bool m_is_given = false; // by the caller
  bool m_is_spent = false; // the given order costs too much
};

// How much work an order may cause before another takes its place. No order but a random one
// bounds the cells that insertions destroy (Amenta, Choi, Rote 2003). So
// the whole costs no more than the budget, what is done between two looks at it, and one insertion
// in that order. No order is to blame for what all do: where many cells must stay, as a quadratic
// number does, about as many are destroyed. Of an order that is spread over the points this is allowed.
class Insertion_budget
{
public:
  // A budget of destroyed cells for each point inserted; the first points share that of a thousand,
  // since few points do not tell a good order from a bad one. The largest number is never exceeded.
  explicit Insertion_budget(std::size_t cells_per_point, bool is_spread = false)
    : m_cells_per_point(double(cells_per_point))
    , m_is_spread(is_spread)
  {
  }

  // Walks have a threshold of their own: each may be exceeded for reasons that are none of the other's.
  // A step of a walk makes one test; a destroyed cell makes two or three, and is replaced as well.
  bool is_exceeded(const Insertion_counts& counts, std::size_t inserted) const
  {
    const double stay =
        m_is_spread ? double(counts.cells_created) - double(counts.cells_destroyed) : 0;
    const double most =
        cells_per_point(inserted) * (double(inserted) + 1000) + (std::max)(stay, 0.);
    return double(counts.cells_destroyed) > most ||
           double(counts.cells_tested_to_start) > steps_per_cell * most;
  }

private:
  static constexpr double steps_per_cell = 2, many_points = 1e6;

  // On smooth tori orders destroy a number of cells that grows with the logarithm of that of the
  // points. Where there are many, another sixteenth is allowed for each doubling. Asked rarely, so
  // nothing of it goes into the loop that asks.
  [[gnu::cold]] double cells_per_point(std::size_t inserted) const
  {
    const double doublings = std::log2((std::max)(double(inserted) / many_points, 1.));
    return m_cells_per_point * (1 + doublings / 16);
  }

  double m_cells_per_point;
  bool m_is_spread;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_ORDER_OF_CORE_H
