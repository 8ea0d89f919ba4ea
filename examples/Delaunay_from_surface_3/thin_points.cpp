// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Points are left out if they are too near a vertex of the cell that they fall into, as
// reconstruction from images thins its points. What is left out depends on the order of the
// insertions, which go one by one. All it takes is an insertion target of one's own, which asks
// before it inserts.

#include <CGAL/insert_points_along_graph_3.h>

#include <CGAL/Delaunay_from_surface_3/insertion/Compact_delaunay_3.h>
#include <CGAL/Delaunay_from_surface_3/insertion/insert_one_by_one.h>
#include <CGAL/Delaunay_from_surface_3/plan/Geometric_rounds.h>
#include <CGAL/Delaunay_from_surface_3/subgraph/Full_graph.h>
#include <CGAL/Delaunay_from_surface_3/trace/Previous_hint_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_insertion_policies_3.h>
#include <CGAL/Timer.h>
#include <CGAL/point_generators_3.h>
#include <CGAL/spatial_sort.h>

#include <boost/graph/adjacency_list.hpp>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <utility>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_3;
using Triangulation = CGAL::Delaunay_triangulation_3<K>;
namespace DFS = CGAL::Delaunay_from_surface_3;

const double least_distance = 0.03;

bool is_accepted(const Point& p, const Point& nearest)
{
  return CGAL::squared_distance(p, nearest) >= least_distance * least_distance;
}

// Inserts into a compact triangulation what is accepted.
template <class Tr>
class Thinning_target_3 : public DFS::Compact_delaunay_3<Tr>
{
  using Base = DFS::Compact_delaunay_3<Tr>;

public:
  using Wider_target = void; // 150 million points are enough here
  using typename Base::Location;
  using typename Base::Vertex;

  Thinning_target_3(Tr& tr, const std::vector<Point>& points)
    : Base(tr, points)
    , m_points(points)
    , m_point_of_vertex(points.size() + 1)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
      if (this->vertex(i) != Vertex()) // the first four are inserted at once
        m_point_of_vertex[this->vertex(i)] = i;
  }

  template <class Observer>
  void insert(std::size_t i, const Location& location, Observer& observer)
  {
    const Vertex nearest = this->nearest_vertex(i, location);
    if (location.vertex == Vertex() &&
        !is_accepted(m_points[i], m_points[m_point_of_vertex[nearest]]))
      return;
    Base::insert(i, location, observer);
    if (location.vertex == Vertex())
      m_point_of_vertex[this->vertex(i)] = i;
  }

  template <class Hints, class Visitor>
  bool insert_round(std::size_t first, std::size_t last, Hints& hints, Visitor& visitor)
  {
    return DFS::insert_one_by_one(*this, first, last, hints, visitor);
  }

  // None for a point that was left out.
  std::vector<typename Tr::Vertex_handle> take_vertices()
  {
    auto handles = Base::take_vertices();
    for (std::size_t i = 0; i < handles.size(); ++i)
      if (this->vertex(i) == Vertex())
        handles[i] = typename Tr::Vertex_handle();
    return handles;
  }

private:
  const std::vector<Point>& m_points;
  std::vector<std::size_t> m_point_of_vertex;
};

using Thinning_traits = CGAL::Surface_insertion_policies_3<DFS::Full_graph, DFS::Geometric_rounds,
                                                           DFS::Previous_hint_3, Thinning_target_3>;

// The same by plain CGAL, in its order.
void insert_thinned(Triangulation& tr, std::vector<Point> points)
{
  CGAL::spatial_sort(points.begin(), points.end());
  Triangulation::Cell_handle hint;
  for (const Point& p : points) {
    Triangulation::Locate_type type;
    int li, lj;
    const auto c = tr.locate(p, type, li, lj, hint);
    if (tr.dimension() == 3 && !is_accepted(p, tr.nearest_vertex_in_cell(p, c)->point()))
      hint = c;
    else
      hint = tr.insert(p, type, c, li, lj)->cell();
  }
}

int main(int argc, char* argv[])
{
  CGAL::Random random(7);
  CGAL::Random_points_on_sphere_3<Point> on_sphere(1., random);
  std::vector<Point> points;
  for (int i = 0, n = argc > 1 ? std::atoi(argv[1]) : 20000; i < n; ++i)
    points.push_back(*on_sphere++);

  CGAL::Timer ours, plain;
  ours.start();
  Triangulation tr;
  std::vector<Point> accepted;
  CGAL::insert_points_along_graph_3(
      tr, points, boost::adjacency_list<boost::vecS, boost::vecS>(points.size()), Thinning_traits(),
      CGAL::parameters::vertex_to_vertex_output_iterator(
          [&](std::size_t i, Triangulation::Vertex_handle) { accepted.push_back(points[i]); }));
  ours.stop();
  plain.start();
  Triangulation plain_tr;
  insert_thinned(plain_tr, points);
  plain.stop();

  std::cout << tr.number_of_vertices() << " of " << points.size() << " points in " << ours.time()
            << " s; plain CGAL, in its order: " << plain_tr.number_of_vertices() << " in "
            << plain.time() << " s\n";
  const bool is_delaunay = tr == Triangulation(accepted.begin(), accepted.end());
  return is_delaunay && accepted.size() == tr.number_of_vertices() ? EXIT_SUCCESS : EXIT_FAILURE;
}
