// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_METERS_METERING_VISITOR_3_H
#define DELAUNAY_FROM_SURFACE_3_METERS_METERING_VISITOR_3_H

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>

#include <array>
#include <cstddef>
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
    std::size_t number_of_traced_points = 0; // points that follow the trace at its end.

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

} // namespace meters

#endif // DELAUNAY_FROM_SURFACE_3_METERS_METERING_VISITOR_3_H
