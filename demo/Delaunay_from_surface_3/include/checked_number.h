// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_CHECKED_NUMBER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_CHECKED_NUMBER_H

#include <limits>
#include <stdexcept>
#include <string>

// Returns a number in [lowest, highest]; Boost alone would take -1 for 4294967295.
inline unsigned int checked_number(const std::string& option, long long value, long long lowest,
                                   long long highest = (std::numeric_limits<unsigned int>::max)())
{
  if (value < lowest || value > highest)
    throw std::runtime_error("option '--" + option + "' needs a whole number from " +
                             std::to_string(lowest) + " to " + std::to_string(highest));
  return static_cast<unsigned int>(value);
}

// More threads would not insert, and TBB does not bear any number.
constexpr long long most_threads = 64;

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_CHECKED_NUMBER_H
