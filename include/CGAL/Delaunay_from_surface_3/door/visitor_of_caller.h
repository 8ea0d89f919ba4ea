// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_VISITOR_OF_CALLER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_VISITOR_OF_CALLER_H

// A visitor may be a model of SurfaceInsertionVisitor_3, or a callable that is told about progress.

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/is_detected.h>

#include <algorithm>
#include <cstddef>
#include <functional>
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

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_VISITOR_OF_CALLER_H
