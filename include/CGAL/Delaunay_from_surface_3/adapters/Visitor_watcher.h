// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_VISITOR_WATCHER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_VISITOR_WATCHER_H

// A visitor may be a model of SurfaceInsertionVisitor_3, or a callable that is told about progress.

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Visitor>
using Go_further = decltype(std::declval<Visitor&>().go_further());

template <class Visitor>
constexpr bool is_visitor = is_detected<Go_further, Visitor>;

// Calls `progress` with the share of the points that are inserted, before the first insertion,
// every so often, and when all are. `false` stops the work; what returns nothing never does.
template <class Progress>
class Progress_visitor : public Default_surface_insertion_visitor_3
{
  static constexpr std::size_t interval = 256;

public:
  Progress_visitor(Progress progress, std::size_t number_of_points)
    : m_progress(std::move(progress))
    , m_number_of_points(number_of_points)
  {
  }

  // By the core, now and then; by CGAL's insertion, before each.
  bool go_further(std::size_t inserted) { return tell(inserted); }
  bool go_further() { return m_asked++ % interval != 0 || tell(m_asked - 1); }

  template <class Target, class Hints>
  void insertion_ends(const Target&, const Hints&)
  {
    tell(m_number_of_points);
  }

private:
  bool tell(std::size_t inserted)
  {
    m_told = (std::max)(m_told, inserted);
    const double share = m_number_of_points == 0 ? 1. : double(m_told) / double(m_number_of_points);
    if constexpr (std::is_void<std::invoke_result_t<Progress&, double>>::value) {
      m_progress(share);
      return true;
    } else {
      return static_cast<bool>(m_progress(share));
    }
  }

  Progress m_progress;
  std::size_t m_number_of_points;
  std::size_t m_asked = 0, m_told = 0;
};

template <class Progress>
constexpr bool is_progress()
{
  constexpr bool is_callable = std::is_invocable<Progress&, double>::value;
  static_assert(is_callable,
                "a visitor is a model of SurfaceInsertionVisitor_3, or a callable with one double");
  return is_callable;
}

// A visitor in std::ref() serves as it is. Any other is copied, since its functions may change it;
// get_parameter_reference() would give a dangling reference.
template <class Visitor>
decltype(auto) visitor_of_caller(const Visitor& visitor, std::size_t number_of_points)
{
  if constexpr (is_visitor<Visitor>)
    return Visitor(visitor);
  else if constexpr (is_progress<Visitor>())
    return Progress_visitor<Visitor>(visitor, number_of_points);
  else
    return Default_surface_insertion_visitor_3();
}

template <class Visitor>
decltype(auto) visitor_of_caller(const std::reference_wrapper<Visitor>& visitor,
                                 std::size_t number_of_points)
{
  if constexpr (is_visitor<Visitor>)
    return visitor.get();
  else if constexpr (is_progress<Visitor>())
    return Progress_visitor<std::reference_wrapper<Visitor>>(visitor, number_of_points);
  else
    return Default_surface_insertion_visitor_3();
}

// Whether the visitor has a phase_begins() of its own: it is then told of every point.
template <class Visitor>
using Phase_begins = decltype(&Visitor::phase_begins);

template <class Visitor>
constexpr bool follows_all_points =
    !std::is_same<detected_or_t<void, Phase_begins, Visitor>,
                  Phase_begins<Default_surface_insertion_visitor_3>>::value;

// Whether go_further() takes the number of points inserted.
template <class Visitor>
using Go_further_with_number = decltype(std::declval<Visitor&>().go_further(std::size_t()));

template <class Visitor>
constexpr bool counts_points = is_detected<Go_further_with_number, Visitor>;

// What a visitor gets in place of target and hints where the core inserts.
struct Core_target
{
  const Insertion_counts& m_counts;
  Insertion_counts counts() const { return m_counts; }
};
struct Core_hints
{
};

// A function that earlier visitors had, and that nobody calls.
template <class Visitor>
using Accept_of_visitor = decltype(&Visitor::accept);

// Tells a caller's visitor what the core, or the loop of the paper, is doing, in the floating-point
// mode of whoever called the package.
template <class Visitor>
class Visitor_watcher final : public Watcher
{
  using Phase = Surface_insertion_phase;
  static_assert(!is_detected<Accept_of_visitor, Visitor>,
                "visitors leave no points out: accept() would not be called");

public:
  // Keeps references.
  Visitor_watcher(Visitor& visitor, const Rounding_to_nearest& rounding)
    : m_visitor(visitor)
    , m_rounding(rounding)
  {
  }

  void phase_begins(Phase phase) override
  {
    m_rounding.in_mode_of_caller([&] { m_visitor.phase_begins(phase); });
  }
  void order_is_replaced(const char* reason) override
  {
    m_rounding.in_mode_of_caller([&] { m_visitor.order_is_replaced(std::string(reason)); });
  }
  void insertion_begins(std::size_t number_of_threads) override
  {
    m_rounding.in_mode_of_caller([&] { m_visitor.insertion_begins(number_of_threads); });
  }
  void round_begins(std::size_t round, std::size_t number_of_points) override
  {
    m_rounding.in_mode_of_caller([&] { m_visitor.round_begins(round, number_of_points); });
  }
  void insertion_ends(const Insertion_counts& counts) override
  {
    insertion_ends(Core_target{counts}, Core_hints());
  }
  bool go_further(std::size_t inserted) override
  {
    if constexpr (counts_points<Visitor>)
      return m_rounding.in_mode_of_caller([&] { return m_visitor.go_further(inserted); });
    else
      return go_further();
  }
  bool follows_points() const override { return follows_all_points<Visitor>; }

  // What only the paper's way, or CGAL's insertion in place of the core's, reports.

  void surface_is_irregular(const std::string& reason)
  {
    m_rounding.in_mode_of_caller([&] { m_visitor.surface_is_irregular(reason); });
  }
  void subgraph_is_replaced(const std::string& reason)
  {
    m_rounding.in_mode_of_caller([&] { m_visitor.subgraph_is_replaced(reason); });
  }
  void target_is_replaced(const std::string& reason)
  {
    m_rounding.in_mode_of_caller([&] { m_visitor.target_is_replaced(reason); });
  }
  void trace_ends(std::size_t number_of_located_points)
  {
    m_rounding.in_mode_of_caller([&] { m_visitor.trace_ends(number_of_located_points); });
  }
  template <class Target, class Hints>
  void insertion_ends(const Target& target, const Hints& hints)
  {
    m_rounding.in_mode_of_caller([&] { m_visitor.insertion_ends(target, hints); });
  }
  bool go_further()
  {
    return m_rounding.in_mode_of_caller([&] { return m_visitor.go_further(); });
  }

private:
  Visitor& m_visitor;
  const Rounding_to_nearest& m_rounding;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_VISITOR_WATCHER_H
