// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_REPORT_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_REPORT_H

#include <cstddef>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>

// Prints "key:      value"; all keys are shorter than the column is wide.
template <class Value>
void report(const std::string& key, const Value& value)
{
  std::cout << std::left << std::setw(24) << key + ':' << value << '\n';
}

inline std::string decimals(double value, int digits)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

// "12 of 2000 (0.6000 %)"
inline std::string fraction(std::size_t part, std::size_t whole)
{
  const double percent = whole == 0 ? 0. : 100. * double(part) / double(whole);
  return std::to_string(part) + " of " + std::to_string(whole) + " (" + decimals(percent, 4) +
         " %)";
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_REPORT_H
