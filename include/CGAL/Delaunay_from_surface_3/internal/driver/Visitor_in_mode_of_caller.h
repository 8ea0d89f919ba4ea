// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_VISITOR_IN_MODE_OF_CALLER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_VISITOR_IN_MODE_OF_CALLER_H

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// Calls the visitor in the floating-point mode of whoever called the package.
template <class Visitor>
class Visitor_in_mode_of_caller
{
public:
  Visitor_in_mode_of_caller(Visitor& visitor, const Rounding_to_nearest& rounding)
    : m_visitor(visitor)
    , m_rounding(rounding)
  {
  }

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
  void order_is_replaced(const std::string& reason)
  {
    m_rounding.in_mode_of_caller([&] { m_visitor.order_is_replaced(reason); });
  }
  void insertion_begins(std::size_t number_of_threads)
  {
    m_rounding.in_mode_of_caller([&] { m_visitor.insertion_begins(number_of_threads); });
  }
  void phase_begins(Surface_insertion_phase phase)
  {
    m_rounding.in_mode_of_caller([&] { m_visitor.phase_begins(phase); });
  }
  void round_begins(std::size_t round, std::size_t number_of_points)
  {
    m_rounding.in_mode_of_caller([&] { m_visitor.round_begins(round, number_of_points); });
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
  template <class Point>
  bool accept(std::size_t i, std::size_t nearest, const Point& point)
  {
    return m_rounding.in_mode_of_caller(
        [&] { return static_cast<bool>(m_visitor.accept(i, nearest, point)); });
  }
  bool go_further()
  {
    return m_rounding.in_mode_of_caller([&] { return m_visitor.go_further(); });
  }

private:
  Visitor& m_visitor;
  const Rounding_to_nearest& m_rounding;
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_VISITOR_IN_MODE_OF_CALLER_H
