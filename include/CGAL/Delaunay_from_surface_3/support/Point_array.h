// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_POINT_ARRAY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_POINT_ARRAY_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Number>
Number dot(const std::array<Number, 3>& a, const std::array<Number, 3>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Number>
std::array<Number, 3> cross(const std::array<Number, 3>& a, const std::array<Number, 3>& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class Number>
std::array<Number, 3> minus(const std::array<Number, 3>& a, const std::array<Number, 3>& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// Returns the squared distance of two points, rounded; it is infinite in case of overflow.
inline double squared_distance(const double* p, const double* q)
{
  const double x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];
  return x * x + y * y + z * z;
}

// A box with edges along the axes; empty at first.
struct Bounds
{
  double low[3] = {infinity, infinity, infinity}, high[3] = {-infinity, -infinity, -infinity};

  void add(const double* p)
  {
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = (std::min)(low[a], p[a]);
      high[a] = (std::max)(high[a], p[a]);
    }
  }
  bool is_empty() const { return low[0] > high[0]; }
  double size() const
  {
    double longest = 0;
    for (std::size_t a = 0; a < 3; ++a)
      longest = (std::max)(longest, high[a] - low[a]);
    return longest;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM

inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE {

// n points as n × 3 doubles, owned elsewhere.
class Point_array
{
public:
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE Point_array(const double* coordinates,
                                                         std::size_t size)
    : m_coordinates(coordinates)
    , m_size(size)
  {
  }

  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE std::size_t size() const { return m_size; }
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE const double* operator[](std::size_t i) const
  {
    return m_coordinates + 3 * i;
  }

private:
  const double* m_coordinates;
  std::size_t m_size;
};

// A source of points. They may be asked for again after they were given up.
class Point_source
{
public:
  virtual ~Point_source() = default;

  virtual Point_array points() = 0;

  // Says that points will not be needed for long: those that can be read again need not be kept.
  virtual void give_up() {}
};

// A source of points that have weights, one for each of points().
class Weighted_point_source : public Point_source
{
public:
  virtual const double* weights() = 0;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE

inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Returns whether a coordinate is a finite number, judging by its bits: with -ffast-math, compilers
// assume that std::isfinite() is true.
inline bool is_finite_number(double x)
{
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof(bits));
  return (bits >> 52 & 0x7ff) != 0x7ff;
}

// Returns null if there are no weights.
inline const double* weights_of(Point_source&)
{
  return nullptr;
}
inline const double* weights_of(Weighted_point_source& source)
{
  return source.weights();
}

// Points that are available all the time.
class Given_points final : public Point_source
{
public:
  explicit Given_points(const Point_array& points)
    : m_points(points)
  {
  }
  Point_array points() override { return m_points; }

private:
  const Point_array m_points;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_POINT_ARRAY_H
