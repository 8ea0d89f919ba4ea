// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_READ_SOUP_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_READ_SOUP_H

#include <CGAL/Delaunay_from_surface_3/door/Insertion_input.h>
#include <CGAL/Delaunay_from_surface_3/door/check_named_parameters.h>
#include <CGAL/Delaunay_from_surface_3/door/read_items.h>
#include <CGAL/Delaunay_from_surface_3/door/soup_graph.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/is_detected.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Point>
bool are_all_equal(const std::vector<Point>& points)
{
  return std::all_of(points.begin(), points.end(), [&](const Point& p) { return p == points[0]; });
}

// Whether these are ranges of integers, which number points.
template <class FaceRange>
using Index_in_face =
    decltype(std::size_t(*std::begin(*std::begin(std::declval<const FaceRange&>()))));

template <class FaceRange>
constexpr bool are_faces = is_detected<Index_in_face, FaceRange>;

// The points and faces of a polygon soup, read and checked.
template <class Triangulation, class PointRange, class FaceRange, class NamedParameters>
class Read_soup
{
public:
  // Keeps a reference to the faces. Of fewer points than `least` the edges are not used.
  Read_soup(const PointRange& points, const FaceRange& faces, const NamedParameters& np,
            const Executor& executor, std::size_t least)
    : m_items(points, np)
    , m_soup(m_items.points().size() >= least && is_looked_at(m_items.points())
                 ? soup_graph(faces, m_items.points().size(), executor)
                 : soup_graph_without_edges(faces, m_items.points().size()))
    , m_graph(std::move(m_soup.graph), faces)
  {
  }

  // Refers to this object.
  auto input() const
  {
    return Insertion_input{m_items.points(),    m_graph,         Identity_index_map(),
                           m_soup.irregularity, Identity_name(), m_items.infos()};
  }

private:
  // Whether edges are used, or a visitor is told what the faces are like.
  static bool is_looked_at(const std::vector<typename Triangulation::Point>& points)
  {
    return is_given<NamedParameters, internal_np::visitor_t> || !are_all_equal(points);
  }

  const Read_items<Triangulation, PointRange, NamedParameters> m_items;
  Soup_graph m_soup;
  const Graph_of_faces<FaceRange> m_graph;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DOOR_READ_SOUP_H
