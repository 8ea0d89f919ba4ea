// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_CHECK_EQUAL_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_CHECK_EQUAL_H

// The differential test: what the package makes of points and a surface is what CGAL's own range
// insertion makes of the points.

#include "named_surfaces.h"

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/adapters/surface_input.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/insert_points_3.h>
#include <CGAL/insert_surface_vertices_3.h>

#include <boost/test/unit_test.hpp>
#include <boost/type_index.hpp>

#include <cstddef>
#include <functional>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace tests {

template <class Triangulation>
std::vector<typename Triangulation::Point> points_of(const Indexed_surface& surface)
{
  std::vector<typename Triangulation::Point> points;
  for (const auto& p : surface.points)
    points.push_back(
        CGAL::Delaunay_from_surface_3::internal::converted_point<typename Triangulation::Point>(p));
  return points;
}

// Fails where the subgraph refuses the surface.
struct Regular_surface_visitor : CGAL::Default_surface_insertion_visitor_3
{
  void notice(CGAL::Surface_insertion_notice what, const std::string& reason)
  {
    if (what == CGAL::Surface_insertion_notice::SURFACE_IS_IRREGULAR ||
        what == CGAL::Surface_insertion_notice::SUBGRAPH_IS_REPLACED)
      BOOST_ERROR(reason);
  }
};

// A surface with CGAL's own triangulation of its points.
template <class Triangulation>
class Plain_case
{
public:
  using Point = typename Triangulation::Point;
  using Vertex_handle = typename Triangulation::Vertex_handle;

  explicit Plain_case(const Named_surface& named)
    : m_named(named)
    , m_points(points_of<Triangulation>(named.surface))
    , m_plain(m_points.begin(), m_points.end())
  {
  }

  const std::vector<Point>& points() const { return m_points; }
  const Triangulation& plain() const { return m_plain; }

  // Inserts the surface with Traits and compares everything a caller can see.
  template <class Traits>
  void check(unsigned int seed = 0) const
  {
    BOOST_TEST_CONTEXT(m_named.name << ", seed " << seed << ", "
                                    << boost::typeindex::type_id<Traits>().pretty_name())
    {
      Triangulation tr;
      std::vector<std::pair<std::size_t, Vertex_handle>> map;
      const std::ptrdiff_t gained = CGAL::insert_points_3(
          tr, m_points, m_named.surface.faces, Traits(),
          CGAL::parameters::random_seed(seed).vertex_to_vertex_output_iterator(
              std::back_inserter(map)));
      BOOST_TEST((tr == m_plain));
      BOOST_TEST(tr.is_valid());
      BOOST_TEST(gained == std::ptrdiff_t(m_plain.number_of_vertices()));
      check_map(tr, map);
    }
  }

  // The same from a mesh, where the surface is one: a soup has no halfedges, which T of bounded
  // degree needs.
  template <class Traits>
  void check_as_mesh(unsigned int seed = 0) const
  {
    namespace PMP = CGAL::Polygon_mesh_processing;
    if (!PMP::is_polygon_soup_a_polygon_mesh(m_named.surface.faces))
      return;
    BOOST_TEST_CONTEXT(m_named.name << " as mesh, seed " << seed)
    {
      using Mesh = CGAL::Surface_mesh<Indexed_surface::Point_3>;
      const Mesh mesh = surfaces::to_mesh<Mesh>(m_named.surface);
      BOOST_TEST_REQUIRE(mesh.number_of_vertices() == m_points.size());
      Triangulation tr;
      Regular_surface_visitor visitor;
      CGAL::insert_surface_vertices_3(
          tr, mesh, Traits(), CGAL::parameters::random_seed(seed).visitor(std::ref(visitor)));
      BOOST_TEST((tr == m_plain));
      BOOST_TEST(tr.is_valid());
    }
  }

private:
  void check_map(const Triangulation& tr,
                 const std::vector<std::pair<std::size_t, Vertex_handle>>& map) const
  {
    BOOST_TEST_REQUIRE(map.size() == m_points.size());
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < map.size(); ++i)
      wrong += map[i].first != i || !tr.tds().is_vertex(map[i].second) ||
               map[i].second->point() != m_points[i];
    BOOST_TEST(wrong == 0u);
  }

  const Named_surface& m_named;
  std::vector<Point> m_points;
  Triangulation m_plain;
};

} // namespace tests

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_CHECK_EQUAL_H
