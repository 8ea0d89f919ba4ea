// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_VISITOR_OBSERVER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_VISITOR_OBSERVER_H

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
using Go_further = decltype(std::declval<Visitor&>().go_further(std::size_t()));

template <class Visitor>
constexpr bool is_visitor = is_detected<Go_further, Visitor>;

// Calls `progress` with the share of the points that are inserted: before the first insertion, every
// 256 points or more, and when all are inserted. `false` stops the work; if it returns nothing, it
// never does.
template <class Progress>
class Progress_visitor : public Default_surface_insertion_visitor_3
{
public:
  Progress_visitor(Progress progress, std::size_t number_of_points)
    : m_progress(std::move(progress))
    , m_number_of_points(number_of_points)
  {
  }

  // If the work begins anew, the number falls, and the share waits.
  bool go_further(std::size_t inserted)
  {
    if (inserted > m_asked && inserted < m_asked + 256)
      return true;
    m_asked = inserted;
    m_farthest = (std::max)(m_farthest, inserted);
    return tell(m_farthest);
  }

  template <class Target, class Hints>
  void insertion_ends(const Target&, const Hints&)
  {
    tell(m_number_of_points);
  }

private:
  bool tell(std::size_t inserted)
  {
    const double share = inserted >= m_number_of_points // copies in a periodic box may be more
                             ? 1.
                             : double(inserted) / double(m_number_of_points);
    if constexpr (std::is_void<std::invoke_result_t<Progress&, double>>::value) {
      m_progress(share);
      return true;
    } else {
      return static_cast<bool>(m_progress(share));
    }
  }

  Progress m_progress;
  std::size_t m_number_of_points;
  std::size_t m_asked = 0, m_farthest = 0; // numbers of inserted points
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

// A visitor gets these in place of target and hints where the core inserts.
struct Core_target
{
  const Insertion_counts& m_counts;
  Insertion_counts counts() const { return m_counts; }
};
struct Core_hints
{
};

// Earlier visitors could leave points out by this function, which nobody calls.
template <class Visitor>
using Accept_of_visitor = decltype(&Visitor::accept);

// Tells a caller's visitor what the core, or the loop of the paper, is doing, in the floating-point
// mode of whoever called the package.
template <class Visitor>
class Visitor_observer final : public Observer
{
  using Phase = Surface_insertion_phase;
  using Notice = Surface_insertion_notice;
  static_assert(!is_detected<Accept_of_visitor, Visitor>,
                "visitors leave no points out: accept() would not be called");

public:
  // Keeps references.
  Visitor_observer(Visitor& visitor, const Rounding_to_nearest& rounding)
    : m_visitor(visitor)
    , m_rounding(rounding)
  {
  }

  void phase_begins(Phase phase, std::size_t number = 0) override
  {
    const bool is_of_point = phase == Phase::LOCATION || phase == Phase::UPDATE;
    if (Visitor::follows_points || !is_of_point)
      m_rounding.in_mode_of_caller([&] { m_visitor.phase_begins(phase, number); });
  }
  void notice(Notice what, const char* reason) override { notice(what, std::string(reason)); }
  void notice(Notice what, const std::string& reason)
  {
    m_rounding.in_mode_of_caller([&] { m_visitor.notice(what, reason); });
  }
  void insertion_ends(const Insertion_counts& counts) override
  {
    insertion_ends(Core_target{counts}, Core_hints());
  }
  template <class Target, class Hints>
  void insertion_ends(const Target& target, const Hints& hints)
  {
    m_rounding.in_mode_of_caller([&] { m_visitor.insertion_ends(target, hints); });
  }
  bool go_further(std::size_t inserted) override
  {
    return m_rounding.in_mode_of_caller([&] { return m_visitor.go_further(inserted); });
  }
  bool follows_points() const override { return Visitor::follows_points; }

private:
  Visitor& m_visitor;
  const Rounding_to_nearest& m_rounding;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_VISITOR_OBSERVER_H
