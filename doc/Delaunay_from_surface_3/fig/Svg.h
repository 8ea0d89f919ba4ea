// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_FIG_SVG_H
#define DELAUNAY_FROM_SURFACE_3_FIG_SVG_H

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace figures {

// A place on the sheet, in pixels; y points downwards.
struct Place
{
  double x, y;
};

// An SVG drawing. Shapes are styled by class names, which the style sheet explains.
class Svg
{
public:
  Svg(int width, int height, const std::string& style)
  {
    m_out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width << ' ' << height
          << "\" width=\"" << width << "\" height=\"" << height << "\">\n<style>" << style
          << "</style>\n<rect width=\"" << width << "\" height=\"" << height
          << "\" fill=\"#fff\"/>\n";
  }

  void polygon(const std::string& style, const std::vector<Place>& corners)
  {
    path(style, {corners}, "z");
  }

  void line(const std::string& style, const std::vector<Place>& corners)
  {
    path(style, {corners}, "");
  }

  // Many in one path: a smaller file.
  void polygons(const std::string& style, const std::vector<std::vector<Place>>& all)
  {
    path(style, all, "z");
  }

  void lines(const std::string& style, const std::vector<std::vector<Place>>& all)
  {
    path(style, all, "");
  }

  void circle(const std::string& style, Place center, double radius)
  {
    m_out << "<circle class=\"" << style << "\" cx=\"" << rounded(center.x) << "\" cy=\""
          << rounded(center.y) << "\" r=\"" << rounded(radius) << "\"/>\n";
  }

  void rectangle(const std::string& style, Place corner, double width, double height)
  {
    m_out << "<rect class=\"" << style << "\" x=\"" << rounded(corner.x) << "\" y=\""
          << rounded(corner.y) << "\" width=\"" << rounded(width) << "\" height=\""
          << rounded(height) << "\"/>\n";
  }

  void text(const std::string& style, Place place, const std::string& words)
  {
    m_out << "<text class=\"" << style << "\" x=\"" << rounded(place.x) << "\" y=\""
          << rounded(place.y) << "\">" << words << "</text>\n";
  }

  // Everything until end_clip() is seen in this rectangle only.
  void begin_clip(const std::string& name, Place corner, double width, double height)
  {
    m_out << "<clipPath id=\"" << name << "\"><rect x=\"" << corner.x << "\" y=\"" << corner.y
          << "\" width=\"" << width << "\" height=\"" << height
          << "\"/></clipPath><g clip-path=\"url(#" << name << ")\">\n";
  }

  void end_clip() { m_out << "</g>\n"; }

  void write(const std::string& file_name) const
  {
    std::ofstream file(file_name);
    file << m_out.str() << "</svg>\n";
    if (!file.flush())
      throw std::runtime_error("cannot write " + file_name);
  }

private:
  static double rounded(double x) { return std::round(10 * x) / 10; }

  void path(const std::string& style, const std::vector<std::vector<Place>>& all, const char* end)
  {
    m_out << "<path class=\"" << style << "\" d=\"";
    for (const std::vector<Place>& corners : all) {
      char command = 'M';
      for (const Place& p : corners) {
        m_out << command << rounded(p.x) << ' ' << rounded(p.y);
        command = 'L';
      }
      m_out << end;
    }
    m_out << "\"/>\n";
  }

  std::ostringstream m_out;
};

} // namespace figures

#endif // DELAUNAY_FROM_SURFACE_3_FIG_SVG_H
