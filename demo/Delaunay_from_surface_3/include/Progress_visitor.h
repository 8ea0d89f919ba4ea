// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_PROGRESS_VISITOR_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_PROGRESS_VISITOR_H

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>

#include <cstddef>
#include <iostream>
#include <string>

#include <unistd.h>

// One line on the standard error that is overwritten again and again, if that is a terminal.
class Progress_line
{
public:
  ~Progress_line() { clear(); }

  void show(const std::string& text)
  {
    if (m_is_terminal)
      std::cerr << "\r\033[K" << text << std::flush;
    m_is_empty = false;
  }

  void clear()
  {
    if (m_is_terminal && !m_is_empty)
      std::cerr << "\r\033[K" << std::flush;
    m_is_empty = true;
  }

private:
  bool m_is_terminal = isatty(STDERR_FILENO) != 0;
  bool m_is_empty = true;
};

// Shows how many points are inserted, and says what is odd about the surface.
class Progress_visitor : public CGAL::Default_surface_insertion_visitor_3
{
public:
  explicit Progress_visitor(std::size_t number_of_points)
    : m_number_of_points(number_of_points)
  {
  }

  void surface_is_irregular(const std::string& reason) { note(reason); }

  void subgraph_is_replaced(const std::string& reason)
  {
    note(reason + "; a spanning forest serves instead");
  }

  bool go_further()
  {
    if (m_inserted++ % 4096 == 0)
      m_line.show("inserting: " + std::to_string(100 * (m_inserted - 1) / m_number_of_points) +
                  " %");
    return true;
  }

private:
  void note(const std::string& text)
  {
    m_line.clear();
    std::cerr << "note: " << text << '\n';
  }

  Progress_line m_line;
  std::size_t m_number_of_points, m_inserted = 0;
};

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_PROGRESS_VISITOR_H
