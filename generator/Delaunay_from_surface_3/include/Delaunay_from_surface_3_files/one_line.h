// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_FILES_ONE_LINE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_FILES_ONE_LINE_H

#include <algorithm>
#include <string>

namespace files {

// A message that fits a terminal, whatever names and files have put into it.
inline std::string one_line(std::string text)
{
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 32 || c == 127; }, '?');
  return text;
}

} // namespace files

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_FILES_ONE_LINE_H
