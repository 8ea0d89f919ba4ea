// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// One vertex of a degree that grows with n, with all that the paper assumes: T is the Euclidean
// minimum spanning tree, and the triangulation has linear size. The paper's Q locates a point by as
// many tests as it takes without the hub; a history by containment, which looks through whole
// stars, takes more and more.

#define BOOST_TEST_MODULE test_hub
#include <boost/test/included/unit_test.hpp>

#include <Delaunay_from_surface_3_surfaces/adversarial.h>

#include <Delaunay_from_surface_3_meters/History_hints_3.h>
#include <Delaunay_from_surface_3_meters/meters.h>
#include <Delaunay_from_surface_3_meters/orders.h>
#include <CGAL/Delaunay_from_surface_3/paper/Conflict_history_3.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <CGAL/Delaunay_from_surface_3/surface/No_subgraph.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/euclidean_minimum_spanning_tree_3.h>
#include <CGAL/insert_points_along_graph_3.h>

#include <boost/graph/adjacency_list.hpp>

#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;

using Kernel = surfaces::Indexed_surface::Kernel;
using Plain = CGAL::Delaunay_triangulation_3<Kernel>;
using Counted = CGAL::Delaunay_triangulation_3<meters::Predicate_counting_traits_3<Kernel>>;
using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;

namespace {

struct Room
{
  std::vector<Kernel::Point_3> points; // the hub is the last
  Graph tree;                          // T
  std::size_t degree_of_last;
  double cells_per_point;

  explicit Room(std::size_t n, bool has_hub = true)
    : points(surfaces::room(n, 1).points)
  {
    if (!has_hub)
      points.pop_back();
    std::map<Kernel::Point_3, std::size_t> number;
    for (std::size_t i = 0; i < points.size(); ++i)
      number[points[i]] = i;
    tree = Graph(points.size());
    const Plain tr(points.begin(), points.end());
    std::vector<std::pair<Plain::Vertex_handle, Plain::Vertex_handle>> edges;
    CGAL::euclidean_minimum_spanning_tree_3(tr, std::back_inserter(edges));
    for (const auto& e : edges)
      add_edge(number.at(e.first->point()), number.at(e.second->point()), tree);
    Plain::Vertex_handle last;
    tr.is_vertex(points.back(), last);
    degree_of_last = tr.degree(last);
    cells_per_point = double(tr.number_of_cells()) / double(points.size());
  }
};

// Predicate calls of line 2b per point: of all, and of those that have been traced.
struct Calls
{
  double all, traced;
};

template <template <class, class> class Hints>
Calls calls(const Room& room)
{
  Counted tr;
  const auto meter = [&tr] { return tr.geom_traits().counts(); };
  meters::Metering_visitor_3<decltype(meter)> visitor(meter);
  CGAL::insert_points_along_graph_3(
      tr, room.points, room.tree,
      CGAL::Surface_insertion_policies_3<DFS::Full_graph, meters::Random_log_star_rounds, Hints>(),
      CGAL::parameters::visitor(std::ref(visitor)));
  const auto location = CGAL::Surface_insertion_phase::LOCATION;
  const double n = double(room.points.size()), all = double(visitor.total(location).all());
  const auto& first = visitor.rounds()[1]; // [0] is what comes before
  return {all / n, (all - double(first[location].all())) / (n - double(first.number_of_points))};
}

} // namespace

// Where all points start at records. From the root it takes O(log n) for the first n / log n
// points, which is O(1) for each of all, but a constant that is reached slowly: the first points
// lie on the convex hull of so few that not many cells are in conflict with them. There the same
// room without a hub is the measure.
BOOST_AUTO_TEST_CASE(the_papers_location_is_flat_beside_a_hub)
{
  std::map<std::size_t, Calls> by_conflict, by_containment;
  for (const std::size_t n : {4096, 16384, 65536}) {
    const Room room(n);
    by_conflict[n] = calls<DFS::Conflict_history_hints_3>(room);
    if (n < 65536)
      by_containment[n] = calls<meters::History_hints_3>(room);
    const Calls by_walk = calls<DFS::Traced_hints_3>(room);
    const Calls without_hub = calls<DFS::Conflict_history_hints_3>(Room(n, false));
    BOOST_TEST_MESSAGE(room.points.size()
                       << " points, hub of degree " << room.degree_of_last << ", "
                       << room.cells_per_point
                       << " cells per point; calls per point, and per traced "
                       << "point: by conflict " << by_conflict[n].all << ", "
                       << by_conflict[n].traced << "; without the hub " << without_hub.all << ", "
                       << without_hub.traced << "; by containment " << by_containment[n].all << ", "
                       << by_containment[n].traced << "; by walk " << by_walk.all << ", "
                       << by_walk.traced);
    BOOST_TEST(room.degree_of_last > n / 4);
    BOOST_TEST(room.cells_per_point < 10.);
    BOOST_TEST(by_conflict[n].all < 1.3 * without_hub.all);
  }
  BOOST_TEST(by_conflict[16384].traced < 1.3 * by_conflict[4096].traced);
  BOOST_TEST(by_conflict[65536].traced < 1.3 * by_conflict[4096].traced);
  BOOST_TEST(by_containment[16384].traced > 2 * by_containment[4096].traced); // or this is no hub
}
