// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPHS_PLOT_TIMES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPHS_PLOT_TIMES_H

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace subgraphs {

/// Plots the time per vertex of `subgraph` over the number of vertices: level lines are linear
/// time.
inline void plot_times(const nlohmann::ordered_json& times, const std::string& file_name)
{
  std::map<std::string, std::vector<std::pair<double, double>>> curves;
  double least_n = 1e300, most_n = 0, most_time = 0;
  for (const auto& row : times) {
    const double n = row["vertices"], time = row["subgraph"]["nanoseconds_per_vertex"];
    curves[row["surface"].get<std::string>() + ", " + row["order"].get<std::string>()].emplace_back(
        n, time);
    least_n = (std::min)(least_n, n), most_n = (std::max)(most_n, n);
    most_time = (std::max)(most_time, time);
  }
  const double span = (std::max)(std::log10(most_n / least_n), 1e-9);
  const double top = 100 * std::ceil(most_time / 100);
  const auto x = [&](double n) { return 70 + 400 * std::log10(n / least_n) / span; };
  const auto y = [&](double time) { return 330 - 290 * time / top; };
  static const char* const colors[] = {"#1b6ca8", "#d1495b", "#2e8b57",
                                       "#8a6d3b", "#6a4c93", "#444444"};

  std::ofstream svg(file_name);
  svg << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 660 390\" width=\"660\" "
         "height=\"390\">\n"
         "<style>text{font:13px sans-serif;fill:#333}.axis{stroke:#bbb;fill:none}</style>\n"
         "<rect width=\"660\" height=\"390\" fill=\"#fff\"/>\n";
  for (double time = 0; time <= top; time += top / 5)
    svg << "<path class=\"axis\" d=\"M70 " << y(time) << "H470\"/><text x=\"62\" y=\""
        << y(time) + 4 << "\" text-anchor=\"end\">" << time << "</text>\n";
  for (double n = std::pow(10, std::ceil(std::log10(least_n) - 0.01)); n <= 1.1 * most_n; n *= 10)
    svg << "<path class=\"axis\" d=\"M" << x(n) << " 330v5\"/><text x=\"" << x(n)
        << "\" y=\"352\" text-anchor=\"middle\">10^" << std::lround(std::log10(n)) << "</text>\n";
  svg << "<text x=\"270\" y=\"378\" text-anchor=\"middle\">vertices</text>\n"
         "<text x=\"20\" y=\"24\">nanoseconds per vertex</text>\n";
  int i = 0;
  for (const auto& [name, points] : curves) {
    const char* color = colors[std::size_t(i) % std::size(colors)];
    svg << "<polyline fill=\"none\" stroke-width=\"2\" stroke=\"" << color << "\" points=\"";
    for (const auto& [n, time] : points)
      svg << x(n) << "," << y(time) << " ";
    svg << "\"/><path stroke-width=\"2\" stroke=\"" << color << "\" d=\"M490 " << 60 + 22 * i
        << "h20\"/><text x=\"516\" y=\"" << 64 + 22 * i << "\">" << name << "</text>\n";
    ++i;
  }
  svg << "</svg>\n";
  if (!svg.flush())
    throw std::runtime_error("cannot write " + file_name);
}

} // namespace subgraphs

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUBGRAPHS_PLOT_TIMES_H
