// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_PROGRESS_VISITOR_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_PROGRESS_VISITOR_H

#include "Messages.h"

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>

#include <cstddef>
#include <string>

// Shows how many points are inserted, and notes if the surface is odd.
class Progress_visitor : public CGAL::Default_surface_insertion_visitor_3
{
public:
  Progress_visitor(std::size_t number_of_points, Messages& messages)
    : m_messages(messages)
    , m_number_of_points(number_of_points)
  {
  }

  void notice(CGAL::Surface_insertion_notice what, const std::string& reason)
  {
    using Notice = CGAL::Surface_insertion_notice;
    if (what == Notice::SUBGRAPH_IS_REPLACED) {
      m_messages.note(reason + "; a spanning forest serves instead");
    } else if (what == Notice::CORE_IS_REPLACED) {
      m_messages.note(reason + ": CGAL's own insertion takes the compact triangulation's place");
    } else if (what == Notice::ORDER_IS_REPLACED) {
      m_messages.note("another order of the points is tried: " + reason);
      m_next_shown = 0;
      m_order_is_replaced = true;
    } else {
      m_messages.note(reason);
    }
  }

  bool has_replaced_order() const { return m_order_is_replaced; }

  void phase_begins(CGAL::Surface_insertion_phase phase, std::size_t)
  {
    using Phase = CGAL::Surface_insertion_phase;
    if (phase == Phase::PLAN)
      m_messages.step("ordering the points");
    else if (phase == Phase::INSERTION)
      m_messages.step("inserting");
    else if (phase == Phase::FINISH)
      m_messages.step("handing the triangulation over");
  }

  bool go_further(std::size_t inserted)
  {
    if (inserted >= m_next_shown) {
      m_messages.show("inserting: " + std::to_string(100 * inserted / m_number_of_points) + " %");
      m_next_shown = inserted + 4096;
    }
    return true;
  }

private:
  Messages& m_messages;
  std::size_t m_number_of_points, m_next_shown = 0;
  bool m_order_is_replaced = false;
};

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_PROGRESS_VISITOR_H
