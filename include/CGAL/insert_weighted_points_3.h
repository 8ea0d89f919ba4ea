// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INSERT_WEIGHTED_POINTS_3_H
#define CGAL_INSERT_WEIGHTED_POINTS_3_H

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/core/build_regular.h>
#include <CGAL/Delaunay_from_surface_3/paper/Triangulation_target_3.h>
#include <CGAL/Delaunay_from_points_3.h>
#include <CGAL/insert_points_3.h>

#include <CGAL/Default.h>
#include <CGAL/Iterator_range.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Reads coordinates and weights as doubles.
template <class Point>
class Doubles_of_points<Point, true> final : public Weighted_point_source
{
public:
  // Keeps a reference. Linear.
  explicit Doubles_of_points(const std::vector<Point>& points)
    : m_points(points)
    , m_positions(points)
    , m_not_double(points.size())
  {
    read();
  }

  Point_array points() override { return m_positions.points(); }
  const double* weights() override
  {
    if (m_weights.empty())
      read();
    return m_weights.data();
  }
  void give_up() override
  {
    m_positions.give_up();
    Large_vector<double>().swap(m_weights);
  }

  // Why they are not exact; empty if they are.
  std::string obstacle() const
  {
    return m_not_double < m_points.size()
               ? "the weight of point " + std::to_string(m_not_double) + " is not a double"
               : m_positions.obstacle();
  }

private:
  void read()
  {
    m_weights.reserve(m_points.size());
    for (std::size_t i = 0; i < m_points.size(); ++i) {
      const std::optional<double> exact = equal_double(m_points[i].weight());
      if (!exact)
        m_not_double = (std::min)(m_not_double, i);
      m_weights.push_back(exact ? *exact : CGAL::to_double(m_points[i].weight()));
    }
  }

  const std::vector<Point>& m_points;
  Doubles_of_points<Point, false> m_positions;
  Large_vector<double> m_weights;
  std::size_t m_not_double; // the first point whose weight is none, or the number of points
};

// Inserts points with weights. Vertices that a point hides are destroyed, so walks start from the
// cell of the insertion before, and not from a vertex: it is its own policy of hints.
template <class Triangulation>
class Regular_target : public Triangulation_target_3<Triangulation>
{
  using Base = Triangulation_target_3<Triangulation>;

public:
  using typename Base::Cell;
  using typename Base::Location;
  using typename Base::Vertex;
  static constexpr bool uses_subgraph = false, observes_conflict_zone = false;
  using Base::Base;

  Cell start(std::size_t) const { return m_cell; }
  void trace() const {}

  Location locate(std::size_t i, Cell start)
  {
    const Location at = Base::locate(i, start);
    m_cell = at.cell;
    return at;
  }

  void after_update(std::size_t, Vertex v)
  {
    if (v != Vertex()) // a point that is hidden leaves the cells as they are
      m_cell = v->cell();
  }

  // Does not return those that were destroyed: their memory is free, or has another vertex.
  std::vector<Vertex> take_vertices()
  {
    std::vector<Vertex> vertices = Base::take_vertices();
    const auto& there = this->triangulation().tds().vertices();
    for (std::size_t i = 0; i < vertices.size(); ++i)
      if (Vertex& v = vertices[i];
          v != Vertex() && !(there.is_used(v) && v->point().point() == this->point(i).point() &&
                             v->point().weight() == this->point(i).weight()))
        v = Vertex();
    return vertices;
  }

private:
  Cell m_cell;
};

// Inserts in the order given, or, if it is empty, in that of the input.
template <class Triangulation, class Observer>
Inserted_points<typename Triangulation::Vertex_handle>
insert_with_weights(Triangulation& tr, const std::vector<typename Triangulation::Point>& points,
                    Insertion_order order, Observer& observer)
{
  if (order.order.empty() && !points.empty()) {
    order.order.resize(points.size());
    std::iota(order.order.begin(), order.order.end(), std::size_t(0));
    order.round_ends.push_back(points.size());
  }
  const auto ordered = permuted(points, order.order);
  Regular_target<Triangulation> target(tr, ordered);
  Inserted_points<typename Triangulation::Vertex_handle> inserted;
  inserted.is_complete = insert_in_traced_rounds(order, target, target, observer);
  inserted.vertices = permuted(target.take_vertices(), inverse(order.order));
  return inserted;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3

/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {
/// \endcond

/*!
\ingroup PkgDelaunayFromSurface3Points

inserts points with weights into a regular triangulation. The result equals that of `rt.insert(first,
last)`: it has the same cells and vertices, and hides the same set of points, each in a cell that
contains it. With either function, two things are not determined by the points: which of two cells a
hidden point on their common facet is kept in, and how often equal hidden points are kept. If the cell
base does not keep hidden points, they are discarded.

`insert_surface_vertices_3()` describes the state of `rt` after refused input, a stop or an
exception: if it was empty, it is unchanged.

If no `point_map` is given, pairs of a point and an info (`std::pair`, or the tuples of a
`boost::zip_iterator`) set the infos of the vertices; the infos of hidden points are lost. Of
several points of equal position and weight, the one with the smallest index determines the point
and info of their vertex.

CGAL's own insertion takes over if `rt` is not empty, if the points lie in one plane, if a
coordinate or a weight is not a double, or if the predicates of `Gt` are not the exact ones of a
kernel. It inserts with one thread.

<b>Complexity</b>: expected \f$O(n \log n)\f$ for the order of n points, plus the insertions.

\tparam ConcurrencyTag as for a `Delaunay_triangulation_3`
\tparam Gt,Tds,Lp the parameters of `Regular_triangulation_3`, whose points are the
`Weighted_point_3` of a kernel. The result is guaranteed only if `Gt` has exact predicates.
\tparam PointRange a range of weighted points, of pairs of these and infos, or of items that
`point_map` maps to weighted points
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param rt the triangulation into which the points are inserted
\param weighted_points the points
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": those for a
`Delaunay_triangulation_3`. Points that `point_map` returns have weights, too; `preserve_order` counts
the distinct points that are not hidden; and `vertex_to_vertex_output_iterator` receives every point.
The handle is `Vertex_handle()` if the point is hidden, or if it was not inserted because of a stop and
`rt` was not empty.

\return the number of vertices that `rt` has gained, which is negative if the points hide more
vertices than they become; 0 after a stop if it was empty

\throws Surface_input_error if a coordinate or a weight is not a finite number, the numbers of infos
and points differ, or the input order cannot be preserved as requested; `rt` is then unchanged

Example: \ref Delaunay_from_surface_3/weighted_alpha_shape.cpp

\sa `Regular_from_points_3`
*/
template <class ConcurrencyTag = Default, class Gt, class Tds, class Lp, class PointRange,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
std::ptrdiff_t insert_points_3(Regular_triangulation_3<Gt, Tds, Lp>& rt,
                               const PointRange& weighted_points,
                               const CGAL_NP_CLASS& np = parameters::default_values())
{
  using namespace Delaunay_from_surface_3::internal;
  using Triangulation = Regular_triangulation_3<Gt, Tds, Lp>;
  static_assert(has_weight<typename Triangulation::Point>,
                "the points of the triangulation are the Weighted_point_3 of a kernel");
  const Read_items<Triangulation, PointRange, CGAL_NP_CLASS> read(weighted_points, np);
  const Index_graph no_graph;
  const Insertion_input input{read.points(), no_graph,        Identity_index_map(),
                              std::nullopt,  Identity_name(), read.infos()};
  return insert_surface<Executor_by_tag<ConcurrencyTag, Triangulation>, internal_np::point_t>(
      rt, input, Surface_insertion_traits_3(), np);
}

/// \ingroup PkgDelaunayFromSurface3Points
/// does the same for the points in the range [`first`, `last`) of a model of `InputIterator`.
template <class ConcurrencyTag = Default, class Gt, class Tds, class Lp, class InputIterator,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
#ifdef DOXYGEN_RUNNING
std::ptrdiff_t
#else
std::enable_if_t<Delaunay_from_surface_3::internal::is_iterator<InputIterator>, std::ptrdiff_t>
#endif
insert_points_3(Regular_triangulation_3<Gt, Tds, Lp>& rt, InputIterator first, InputIterator last,
                const CGAL_NP_CLASS& np = parameters::default_values())
{
  return insert_points_3<ConcurrencyTag>(rt, make_range(first, last), np);
}

/// \cond SKIP_IN_MANUAL
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond

/// \ingroup PkgDelaunayFromSurface3Points
/// is a `Regular_triangulation_3`, of the same parameters, that inserts ranges by
/// `insert_points_3()`.
template <class Gt, class Tds = Default, class Lp = Default>
using Regular_from_points_3 = Triangulation_from_points_3<Regular_triangulation_3<Gt, Tds, Lp>>;

} // namespace CGAL

#endif // CGAL_INSERT_WEIGHTED_POINTS_3_H
