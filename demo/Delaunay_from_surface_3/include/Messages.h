// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_MESSAGES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_MESSAGES_H

#include <Delaunay_from_surface_3_files/one_line.h>

#include <cstdio>
#include <iostream>
#include <string>

#if defined(_WIN32)
#include <io.h>
#else
#include <unistd.h>
#endif

inline bool standard_error_is_terminal()
{
#if defined(_WIN32)
  return _isatty(_fileno(stderr)) != 0;
#else
  return isatty(STDERR_FILENO) != 0;
#endif
}

// Writes messages beside the results to the standard error: notes, and the work that is being done.
// The latter is a line that is overwritten again and again on a terminal, and separate lines with
// --verbose.
class Messages
{
public:
  enum class Volume { QUIET, NORMAL, VERBOSE };

  explicit Messages(Volume volume)
    : m_volume(volume)
  {
  }
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;
  ~Messages() { clear(); }

  // Notes something odd that is no error.
  void note(const std::string& text)
  {
    clear();
    if (m_volume != Volume::QUIET)
      std::cerr << "note: " << files::one_line(text) << '\n';
  }

  // Warns that the result may not be as wanted, even with --quiet.
  void warn(const std::string& text)
  {
    clear();
    std::cerr << "warning: " << files::one_line(text) << '\n';
  }

  // Says that something begins that may take a while.
  void step(const std::string& text)
  {
    show(text);
    if (m_volume == Volume::VERBOSE)
      std::cerr << files::one_line(text) << '\n';
  }

  // Shows how far the work is.
  void show(const std::string& text)
  {
    if (!m_has_line)
      return;
    std::cerr << "\r\033[K" << files::one_line(text) << std::flush;
    m_is_empty = false;
  }

  // Clears the line. To be called before anything else is printed.
  void clear()
  {
    if (!m_is_empty)
      std::cerr << "\r\033[K" << std::flush;
    m_is_empty = true;
  }

private:
  const Volume m_volume;
  const bool m_has_line = m_volume == Volume::NORMAL && standard_error_is_terminal();
  bool m_is_empty = true;
};

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_MESSAGES_H
