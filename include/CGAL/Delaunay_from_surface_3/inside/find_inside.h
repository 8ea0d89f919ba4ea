// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_FIND_INSIDE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_FIND_INSIDE_H

// The winding numbers of tetrahedra, and whether they make an inside.

#include <CGAL/Delaunay_from_surface_3/Inside_3.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Sort_by_halves.h>
#include <CGAL/Delaunay_from_surface_3/inside/Unit_frame.h>
#include <CGAL/Delaunay_from_surface_3/inside/Winding_field.h>
#include <CGAL/Delaunay_from_surface_3/inside/Winding_tree.h>
#include <CGAL/Delaunay_from_surface_3/inside/solid_angle.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/blocks.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// What the numbers say, weighted by volumes.
class Judge_inside
{
  double m_sure = 0, m_doubtful = 0, m_inside = 0;

public:
  void add(double number, double volume, Inside_3& inside)
  {
    const double size = std::abs(number);
    const bool is_doubtful = std::abs(size - std::round(size)) > 0.1;
    inside.number_of_doubtful += std::size_t(is_doubtful);
    inside.number_of_multiple += std::size_t(size > 1.5);
    if (is_doubtful)
      m_doubtful += volume;
    else if (size > 0.5)
      m_sure += volume;
    if (size >= 0.5)
      m_inside += volume;
  }

  double doubtful_volume() const { return m_inside > 0 ? m_doubtful / m_inside : 0; }

  // Where more is in doubt than surely inside, and the openings are wide, the surface is no border of a
  // solid. Where an opening lies in a plane, as that of a hull without a deck, the numbers are more than
  // 1/2 up to there, however wide it is: then it is enough if not more is in doubt than inside.
  bool has_inside(double share_of_openings) const
  {
    constexpr double widest = 0.3;
    return m_inside > 0 &&
           (m_sure > m_doubtful || (share_of_openings <= widest && m_doubtful <= m_inside));
  }
};

// Of the queries first, …, last - 1, in an order in which successive ones are near each other.
inline void find_numbers(const Winding_tree& tree, const Point_array& queries, std::size_t first,
                         std::size_t last, double* numbers)
{
  constexpr std::size_t most = Winding_tree::most;
  std::vector<std::size_t> order(last - first);
  std::iota(order.begin(), order.end(), first);
  Sort_by_halves()(queries, order.data(), order.data() + order.size());
  Vector_3d q[most];
  double found[most];
  for (std::size_t k = 0; k < order.size(); k += most) {
    const std::size_t n = (std::min)(most, order.size() - k);
    for (std::size_t i = 0; i < n; ++i)
      q[i] = vector_of(queries[order[k + i]]);
    tree(q, n, found);
    for (std::size_t i = 0; i < n; ++i)
      numbers[order[k + i]] = found[i];
  }
}

// corners_of(c) are the four corners of tetrahedron c, of m. The area of what would close the surface has this
// share in its own.
template <class CornersOf>
Inside_3 find_inside(const Winding_field& field, std::size_t m, const CornersOf& corners_of,
                     double share_of_openings, const Executor& executor)
{
  Inside_3 inside;
  inside.winding_numbers.resize(m);
  std::vector<double> centers(3 * m);
  const std::size_t blocks = number_of_blocks(executor, m, 1024);
  for_each_block(executor, m, blocks, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t c = first; c < last; ++c) {
      const std::array<Vector_3d, 4> corners = field.in_frame(corners_of(c));
      for (std::size_t j = 0; j < 3; ++j)
        centers[3 * c + j] = (corners[0][j] + corners[1][j] + corners[2][j] + corners[3][j]) / 4;
    }
    find_numbers(field.tree, Point_array(centers.data(), m), first, last,
                 inside.winding_numbers.data());
  });
  Judge_inside judge;
  for (std::size_t c = 0; c < m; ++c) {
    const std::array<Vector_3d, 4> corners = field.in_frame(corners_of(c));
    const double volume = dot(minus(corners[1], corners[0]),
                              cross(minus(corners[2], corners[0]), minus(corners[3], corners[0])));
    judge.add(inside.winding_numbers[c], std::abs(volume), inside);
  }
  inside.doubtful_volume = judge.doubtful_volume();
  inside.share_of_openings = share_of_openings;
  if (!judge.has_inside(share_of_openings))
    throw Surface_input_error(
        "the surface has no inside: by its winding numbers more is in doubt than inside, and its "
        "openings have " +
        std::to_string(std::lround(100 * share_of_openings)) + " % of its area");
  return inside;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSIDE_FIND_INSIDE_H
