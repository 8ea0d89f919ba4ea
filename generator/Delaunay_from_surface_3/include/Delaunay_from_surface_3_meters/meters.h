// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_METERS_METERS_H
#define DELAUNAY_FROM_SURFACE_3_METERS_METERS_H

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/enum.h>
#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace meters {

// reads a meter whenever a phase begins, and adds up by round and phase: seconds with a clock, calls
// with `Predicate_counts`. The meter is read twice per point: a clock must be cheap, and takes part of
// the time that it measures.
//
// One visitor serves one insertion. It is to be passed by `std::ref()`.
//
// Meter: a function object without arguments; what it returns can be copied, value-initialised,
// subtracted, and added with `+=`
template <class Meter>
class Metering_visitor_3 : public CGAL::Default_surface_insertion_visitor_3
{
public:
  // what the meter shows.
  using Reading = decltype(std::declval<Meter&>()());

  // what was metered in one round, or before the first.
  struct Round
  {
    std::size_t number_of_points = 0;        // points of the round; after a stop not all are in.
    std::size_t number_of_traced_points = 0; // points of the next round, for which T is traced.

    // returns what was metered in `phase`.
    const Reading& operator[](CGAL::Surface_insertion_phase phase) const
    {
      return readings[std::size_t(phase)];
    }

    // what was metered, by phase.
    std::array<Reading, std::size_t(CGAL::Surface_insertion_phase::DONE) + 1> readings = {};
  };

  // begins to meter when the insertion begins. A `meter` left out is default-constructed.
  explicit Metering_visitor_3(Meter meter = Meter())
    : m_meter(std::move(meter))
    , m_rounds(1)
  {
  }

  // returns what came before the first round (plan and subgraph), and then round by round;
  // `FINISH` is in the last.
  const std::vector<Round>& rounds() const { return m_rounds; }

  // returns the sum for `phase`, of all rounds and what came before the first.
  Reading total(CGAL::Surface_insertion_phase phase) const
  {
    Reading sum = {};
    for (const Round& round : m_rounds)
      sum += round[phase];
    return sum;
  }

  static constexpr bool follows_points = true;

  // reads the meter, and adds what it gained to the phase that ends; opens the account of another
  // round.
  void phase_begins(CGAL::Surface_insertion_phase phase, std::size_t number)
  {
    const Reading now = m_meter();
    // What is running before the first phase and after the last is not ours.
    if (m_phase != CGAL::Surface_insertion_phase::DONE)
      m_rounds.back().readings[std::size_t(m_phase)] += now - m_last;
    m_phase = phase;
    m_last = now;
    if (phase == CGAL::Surface_insertion_phase::ROUND) {
      m_rounds.emplace_back();
      m_rounds.back().number_of_points = number;
    } else if (phase == CGAL::Surface_insertion_phase::TRACE) {
      m_rounds.back().number_of_traced_points = number;
    }
  }

private:
  Meter m_meter;
  std::vector<Round> m_rounds;
  CGAL::Surface_insertion_phase m_phase = CGAL::Surface_insertion_phase::DONE;
  Reading m_last = {};
};

// holds how often a triangulation called its predicates.
struct Predicate_counts
{
  std::size_t orientation = 0;          // calls of `Orientation_3`.
  std::size_t negative_orientation = 0; // those that returned `CGAL::NEGATIVE`.
  std::size_t in_sphere = 0;            // calls of `Side_of_oriented_sphere_3`.
  std::size_t other = 0; // calls of the planar predicates and of comparisons of points.

  // returns all calls.
  std::size_t all() const { return orientation + in_sphere + other; }

  // returns how many cells the walks that these counts belong to have entered, the starting cells not
  // counted. In dimension 3 a walk goes through a facet exactly when the orientation test with that
  // facet is negative, and into an infinite cell in the same way.
  // \pre The counts are of walks in dimension 3 only: of the phases `LOCATION` and `TRACE`. Conflict
  // searches test orientations too, for other ends.
  std::size_t cells_entered() const { return negative_orientation; }

  Predicate_counts& operator+=(const Predicate_counts& other_counts)
  {
    orientation += other_counts.orientation;
    negative_orientation += other_counts.negative_orientation;
    in_sphere += other_counts.in_sphere;
    other += other_counts.other;
    return *this;
  }

  friend Predicate_counts operator-(Predicate_counts a, const Predicate_counts& b)
  {
    a.orientation -= b.orientation;
    a.negative_orientation -= b.negative_orientation;
    a.in_sphere -= b.in_sphere;
    a.other -= b.other;
    return a;
  }
};

// is a geometric traits class for `Delaunay_triangulation_3` that counts the calls of its predicates.
// It is a type of its own, for which CGAL does not take its inexact walk, whose steps cannot be
// observed, and the core leaves it to CGAL's insertion, since it would filter calls away:
// all steps are counted, and times taken with it mean nothing. All copies share one
// `Predicate_counts`; they are not to be used by several threads.
//
// A triangulation copies its traits. The counts of `tr` are `tr.geom_traits().counts()`, and a copy of
// `tr` adds to the same.
//
// Kernel: a kernel that models `DelaunayTriangulationTraits_3`, such as
// `Exact_predicates_inexact_constructions_kernel`
template <class Kernel>
class Predicate_counting_traits_3 : public Kernel
{
  // Calls Predicate and then hands its result to Count.
  template <class Predicate, class Count>
  class Counting
  {
  public:
    Counting(Predicate predicate, Predicate_counts* counts)
      : m_predicate(std::move(predicate))
      , m_counts(counts)
    {
    }

    template <class... Arguments>
    auto operator()(const Arguments&... arguments) const
    {
      const auto result = m_predicate(arguments...);
      Count()(*m_counts, result);
      return result;
    }

  private:
    Predicate m_predicate;
    Predicate_counts* m_counts;
  };

  struct Count_orientation
  {
    void operator()(Predicate_counts& counts, CGAL::Orientation o) const
    {
      ++counts.orientation;
      counts.negative_orientation += o == CGAL::NEGATIVE;
    }
  };

  struct Count_in_sphere
  {
    void operator()(Predicate_counts& counts, CGAL::Oriented_side) const { ++counts.in_sphere; }
  };

  struct Count_other
  {
    template <class Result>
    void operator()(Predicate_counts& counts, Result) const
    {
      ++counts.other;
    }
  };

public:
  // \name Predicates that are counted
  // The names of `Predicate_counts` say where.
  // @{

  using Orientation_3 = Counting<typename Kernel::Orientation_3, Count_orientation>;
  using Side_of_oriented_sphere_3 =
      Counting<typename Kernel::Side_of_oriented_sphere_3, Count_in_sphere>;
  using Coplanar_orientation_3 = Counting<typename Kernel::Coplanar_orientation_3, Count_other>;
  using Coplanar_side_of_bounded_circle_3 =
      Counting<typename Kernel::Coplanar_side_of_bounded_circle_3, Count_other>;
  using Compare_xyz_3 = Counting<typename Kernel::Compare_xyz_3, Count_other>;
  using Compare_distance_3 = Counting<typename Kernel::Compare_distance_3, Count_other>;

  // @}

  // starts at zero, with the predicates of `kernel`.
  explicit Predicate_counting_traits_3(const Kernel& kernel = Kernel())
    : Kernel(kernel)
    , m_counts(std::make_shared<Predicate_counts>())
  {
  }

  // returns the counts of this object and all its copies.
  const Predicate_counts& counts() const { return *m_counts; }

  // \name Function objects
  // Each returns the counting predicate, which counts as long as this object or a copy of it lives.
  // @{

  Orientation_3 orientation_3_object() const
  {
    return {Kernel::orientation_3_object(), m_counts.get()};
  }
  Side_of_oriented_sphere_3 side_of_oriented_sphere_3_object() const
  {
    return {Kernel::side_of_oriented_sphere_3_object(), m_counts.get()};
  }
  Coplanar_orientation_3 coplanar_orientation_3_object() const
  {
    return {Kernel::coplanar_orientation_3_object(), m_counts.get()};
  }
  Coplanar_side_of_bounded_circle_3 coplanar_side_of_bounded_circle_3_object() const
  {
    return {Kernel::coplanar_side_of_bounded_circle_3_object(), m_counts.get()};
  }
  Compare_xyz_3 compare_xyz_3_object() const
  {
    return {Kernel::compare_xyz_3_object(), m_counts.get()};
  }
  Compare_distance_3 compare_distance_3_object() const
  {
    return {Kernel::compare_distance_3_object(), m_counts.get()};
  }

  // @}

private:
  std::shared_ptr<Predicate_counts> m_counts;
};

} // namespace meters

#endif // DELAUNAY_FROM_SURFACE_3_METERS_METERS_H
