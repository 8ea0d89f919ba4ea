// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_ASKING_VISITOR_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_ASKING_VISITOR_H

// Points may be left out: a visitor that has accept() is asked, in the order of insertion, what it
// says of a point and the vertex nearest to it.
//
// A target that begins with four points at once cannot ask about them in their turn. So the first
// points are asked here, before there is a target, until those accepted do not lie in one plane.

#include <CGAL/Delaunay_from_surface_3/internal/driver/Visitor_in_mode_of_caller.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

template <class Visitor, class Point, class = void>
struct Has_accept : std::false_type
{
};
template <class Visitor, class Point>
struct Has_accept<Visitor, Point,
                  std::void_t<decltype(std::declval<Visitor&>().accept(
                      std::size_t(), std::size_t(), std::declval<const Point&>()))>>
  : std::true_type
{
};

// Is there one with any arguments, that is no template and the only one?
template <class Visitor, class = void>
struct Names_accept : std::false_type
{
};
template <class Visitor>
struct Names_accept<Visitor, std::void_t<decltype(&Visitor::accept)>> : std::true_type
{
};

// Does a visitor leave points out?
template <class Visitor, class Point>
constexpr bool accepts_points()
{
  constexpr bool has_accept = Has_accept<Visitor, Point>::value;
  static_assert(has_accept || !Names_accept<Visitor>::value,
                "the accept() of a visitor takes the numbers of two points and a point");
  return has_accept;
}

// Four points or fewer, none of which lies in the span of those before it.
template <class Geom_traits>
class Simplex_of_points
{
  using Point = typename Geom_traits::Point_3;

public:
  explicit Simplex_of_points(const Geom_traits& gt)
    : m_gt(gt)
  {
  }

  bool is_complete() const { return m_size == 4; }

  // Takes p, which outlives this, if it is independent of the others.
  void add(const Point& p)
  {
    if (m_size == 0 || (m_size == 1 && p != *m_points[0]) ||
        (m_size == 2 &&
         m_gt.coplanar_orientation_3_object()(*m_points[0], *m_points[1], p) != COLLINEAR) ||
        (m_size == 3 &&
         m_gt.orientation_3_object()(*m_points[0], *m_points[1], *m_points[2], p) != COPLANAR))
      m_points[m_size++] = &p;
  }

private:
  const Geom_traits& m_gt;
  const Point* m_points[4];
  std::size_t m_size = 0;
};

// Which of `places` has the point nearest to `p`; of several at the same distance, the
// lexicographically smallest. All are different.
template <class Geom_traits, class Point>
std::size_t nearest_place(const Geom_traits& gt, const std::vector<Point>& points,
                          const std::vector<std::size_t>& places, const Point& p)
{
  return *std::min_element(places.begin(), places.end(), [&](std::size_t i, std::size_t j) {
    const Comparison_result c = gt.compare_distance_3_object()(p, points[i], points[j]);
    return c != EQUAL ? c == SMALLER : gt.compare_xyz_3_object()(points[i], points[j]) == SMALLER;
  });
}

// What insert_one_by_one() asks. Points are numbered by their places in the order of insertion.
template <class Visitor>
class Asking_visitor : public Visitor_in_mode_of_caller<Visitor>
{
public:
  static constexpr bool is_asked = true;

  // order[k] is what the caller calls the point at place k; keeps a reference.
  Asking_visitor(const Visitor_in_mode_of_caller<Visitor>& visitor,
                 const std::vector<std::size_t>& order)
    : Visitor_in_mode_of_caller<Visitor>(visitor)
    , m_order(order)
  {
  }

  // Was the point left out before its turn?
  bool has_left_out(std::size_t i) const { return i < m_is_accepted.size() && !m_is_accepted[i]; }

  // May point i be inserted, where the vertex nearest to it, `point`, is that of point `nearest`,
  // or of none?
  template <class Point>
  bool may_insert(std::size_t i, std::size_t nearest, const Point& point)
  {
    if (i < m_is_accepted.size())
      return m_is_accepted[i];
    return this->accept(m_order[i], nearest < m_order.size() ? m_order[nearest] : nearest, point);
  }

  // Asks about the first points, once. Those left out become equal to the very first, so that no
  // target begins with them. Returns whether those accepted do not lie in one plane; not if that
  // would take more points than can be compared with each other in next to no time.
  template <class Geom_traits, class Point>
  bool ask_first(const Geom_traits& gt, std::vector<Point>& points)
  {
    if (m_is_accepted.empty()) {
      Simplex_of_points<Geom_traits> simplex(gt);
      std::vector<std::size_t> places; // those of the vertices
      while (m_is_accepted.size() < (std::min)(points.size(), std::size_t(1000)) &&
             !simplex.is_complete())
        ask_next(gt, points, places, simplex);
      m_spans_space = simplex.is_complete();
    }
    return m_spans_space;
  }

private:
  template <class Geom_traits, class Point>
  void ask_next(const Geom_traits& gt, std::vector<Point>& points, std::vector<std::size_t>& places,
                Simplex_of_points<Geom_traits>& simplex)
  {
    const std::size_t i = m_is_accepted.size();
    const std::size_t nearest = places.empty() ? i : nearest_place(gt, points, places, points[i]);
    const bool is_vertex = nearest != i && points[nearest] == points[i];
    const bool is_accepted = nearest == i || is_vertex || may_insert(i, nearest, points[nearest]);
    m_is_accepted.push_back(is_accepted);
    if (!is_accepted) {
      points[i] = points[0];
    } else if (!is_vertex) {
      places.push_back(i);
      simplex.add(points[i]);
    }
  }

  const std::vector<std::size_t>& m_order;
  std::vector<char> m_is_accepted; // of those that are known
  bool m_spans_space = false;
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_ASKING_VISITOR_H
