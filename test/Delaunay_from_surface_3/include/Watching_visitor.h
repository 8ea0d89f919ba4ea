// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_WATCHING_VISITOR_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_WATCHING_VISITOR_H

#include "input.h"

namespace tests {
namespace input {

// Counts everything, stops before the given insertion, or throws there.
struct Watching_visitor : CGAL::Default_surface_insertion_visitor_3
{
  std::size_t stop_before = std::size_t(-1), throw_before = std::size_t(-1);
  std::size_t asked = 0, points_in_rounds = 0, located_by_traces = 0;
  std::vector<std::string> reasons, reasons_of_subgraph;
  std::map<CGAL::Surface_insertion_phase, std::size_t> phases;
  CGAL::Surface_insertion_phase phase = CGAL::Surface_insertion_phase::DONE;

  static constexpr bool follows_points = true;

  void notice(CGAL::Surface_insertion_notice what, const std::string& reason)
  {
    if (what == CGAL::Surface_insertion_notice::SURFACE_IS_IRREGULAR)
      reasons.push_back(reason);
    else if (what == CGAL::Surface_insertion_notice::SUBGRAPH_IS_REPLACED)
      reasons_of_subgraph.push_back(reason);
  }
  void phase_begins(CGAL::Surface_insertion_phase p, std::size_t number)
  {
    ++phases[phase = p];
    if (p == CGAL::Surface_insertion_phase::ROUND)
      points_in_rounds += number;
    else if (p == CGAL::Surface_insertion_phase::TRACE)
      located_by_traces += number;
  }
  bool go_further(std::size_t)
  {
    if (asked == throw_before)
      throw std::runtime_error("the visitor throws");
    return asked++ != stop_before;
  }
};

template <class Traits>
Watching_visitor watch(Triangulation& tr, Watching_visitor visitor = Watching_visitor(),
                       Index_map* map = nullptr)
{
  Index_map unused;
  CGAL::insert_points_3(
      tr, torus().points, torus().surface.faces, Traits(),
      parameters::visitor(std::ref(visitor))
          .vertex_to_vertex_output_iterator(std::back_inserter(map ? *map : unused)));
  return visitor;
}

} // namespace input
} // namespace tests

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_WATCHING_VISITOR_H
