// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_CHECK_INSERTION_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_CHECK_INSERTION_H

// Everything that a caller can see of one insertion, next to plain CGAL's.

#include "insertion_case.h"

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/insert_points_3.h>
#include <CGAL/insert_points_along_graph_3.h>
#include <CGAL/insert_surface_vertices_3.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace fuzz {

struct Stop : std::runtime_error
{
  Stop()
    : std::runtime_error("the visitor's own")
  {
  }
};

struct Hostile_visitor : CGAL::Default_surface_insertion_visitor_3
{
  explicit Hostile_visitor(const Insertion_case& c)
    : insertion(c)
  {
  }

  static constexpr bool follows_points = true;

  void look() { keeps_rounding &= rounding == nullptr || rounding->is_kept(); }
  void notice(CGAL::Surface_insertion_notice what, const std::string&)
  {
    is_replaced |= what == CGAL::Surface_insertion_notice::CORE_IS_REPLACED;
    look();
  }
  template <class Target, class Hints>
  void insertion_ends(const Target&, const Hints&)
  {
    look();
  }
  void phase_begins(CGAL::Surface_insertion_phase, std::size_t) { look(); }
  bool go_further(std::size_t)
  {
    look();
    if (number_of_insertions++ != insertion.stops_at)
      return true;
    has_stopped = true;
    if (insertion.stops_by_exception)
      throw Stop();
    return false;
  }

  const Insertion_case& insertion;
  std::size_t number_of_insertions = 0;
  const Rounding* rounding = nullptr;
  bool keeps_rounding = true, has_stopped = false, is_replaced = false;
};

// --- the ways to give points and a surface -----------------------------------------------------

// Without a surface: Traits are those of the function.
struct As_points
{
  template <class Tr, class Traits, class NamedParameters>
  static std::ptrdiff_t insert(Tr& tr, const std::vector<typename Tr::Point>& points, const Faces&,
                               const Traits&, const NamedParameters& np)
  {
    return CGAL::insert_points_3(tr, points, np);
  }
};

struct As_soup
{
  template <class Tr, class Traits, class NamedParameters>
  static std::ptrdiff_t insert(Tr& tr, const std::vector<typename Tr::Point>& points,
                               const Faces& faces, const Traits& traits, const NamedParameters& np)
  {
    return CGAL::insert_points_3(tr, points, faces, traits, np);
  }
};

struct As_graph
{
  template <class Tr, class Traits, class NamedParameters>
  static std::ptrdiff_t insert(Tr& tr, const std::vector<typename Tr::Point>& points,
                               const Faces& faces, const Traits& traits, const NamedParameters& np)
  {
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS> graph(points.size());
    for (const Indices& face : faces)
      for (std::size_t k = 0; k < face.size(); ++k)
        add_edge(face[k], face[(k + 1) % face.size()], graph);
    return CGAL::insert_points_along_graph_3(tr, points, graph, traits, np);
  }
};

// Of the faces those that fit together.
struct As_mesh
{
  template <class Tr, class Traits, class NamedParameters>
  static std::ptrdiff_t insert(Tr& tr, const std::vector<typename Tr::Point>& points,
                               const Faces& faces, const Traits& traits, const NamedParameters& np)
  {
    using Mesh = CGAL::Surface_mesh<typename Tr::Point>;
    Mesh mesh;
    for (const auto& p : points)
      mesh.add_vertex(p);
    for (const Indices& face : faces)
      if (face.size() == 3 && face[0] != face[1] && face[1] != face[2] && face[2] != face[0])
        mesh.add_face(typename Mesh::Vertex_index(unsigned(face[0])),
                      typename Mesh::Vertex_index(unsigned(face[1])),
                      typename Mesh::Vertex_index(unsigned(face[2])));
    return CGAL::insert_surface_vertices_3(tr, mesh, traits, np);
  }
};

// --- the check -------------------------------------------------------------------------------------

template <class Tr>
std::vector<typename Tr::Point> points_of(const Points& points)
{
  std::vector<typename Tr::Point> converted;
  for (const Coordinates& p : points)
    converted.emplace_back(p[0], p[1], p[2]);
  return converted;
}

// The vertices of a mesh have their own type of index.
inline std::size_t index_of(std::size_t i)
{
  return i;
}
template <class Descriptor>
std::size_t index_of(Descriptor v)
{
  return std::size_t(v);
}

template <class Tr>
std::string difference(const Tr& tr, const Tr& plain)
{
  if (!tr.is_valid())
    return "the triangulation is not valid";
  if (tr.number_of_vertices() != plain.number_of_vertices())
    return std::to_string(tr.number_of_vertices()) + " vertices, plain CGAL has " +
           std::to_string(plain.number_of_vertices());
  return tr == plain ? "" : "the triangulation is not plain CGAL's";
}

// Whether the triangulation can still be used. Of several nearest vertices either may come first.
template <class Tr>
std::string difference_later(Tr& tr, Tr& plain, const Points& later_points)
{
  bool removes = false;
  for (const auto& p : points_of<Tr>(later_points)) {
    if (removes && plain.number_of_vertices() > 0) {
      const auto v = plain.nearest_vertex(p);
      typename Tr::Vertex_handle w;
      if (!tr.is_vertex(v->point(), w))
        return "after later insertions and removals: a vertex is missing";
      tr.remove(w);
      plain.remove(v);
    }
    tr.insert(p);
    plain.insert(p);
    removes = !removes;
  }
  const std::string wrong = difference(tr, plain);
  return wrong.empty() ? "" : "after later insertions and removals: " + wrong;
}

template <class Map, class Tr>
std::string mistake_in_map(const Map& map, const Tr& tr,
                           const std::vector<typename Tr::Point>& points)
{
  if (map.size() != points.size())
    return std::to_string(map.size()) + " pairs in the map";
  std::vector<bool> is_named(points.size(), false);
  for (const auto& [i, v] : map) {
    if (i >= points.size() || is_named[i])
      return "the map has no bijection of indices";
    is_named[i] = true;
    if (!tr.tds().is_vertex(v) || v->point() != points[i])
      return "the map has a wrong vertex for point " + std::to_string(i);
  }
  return "";
}

// After a stop: an empty triangulation is as before, another one is Delaunay.
template <class Tr>
std::string mistake_after_stop(const Tr& tr, const Insertion_case& c,
                               const Hostile_visitor& visitor)
{
  if (!visitor.has_stopped)
    return "it stopped, and was not told to";
  if (c.old_points.empty() && tr.number_of_vertices() > 0)
    return "an empty triangulation has changed";
  std::vector<typename Tr::Point> inserted;
  for (auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
    inserted.push_back(v->point());
  const std::string wrong = difference(tr, Tr(inserted.begin(), inserted.end()));
  return wrong.empty() ? "" : "after a stop: " + wrong;
}

template <class Tr, class Traits, class Form>
std::string check_insertion(const Insertion_case& c, Tally& tally)
{
  const auto points = points_of<Tr>(c.points), old_points = points_of<Tr>(c.old_points);
  Tr tr, plain;
  for (Tr* t : {&tr, &plain})
    t->insert(old_points.begin(), old_points.end());
  plain.insert(points.begin(), points.end());

  Hostile_visitor visitor(c);
  std::vector<std::pair<std::size_t, typename Tr::Vertex_handle>> map;
  bool is_complete = false;
  std::ptrdiff_t gained = 0;
  {
    const Rounding rounding(*c.rounding);
    visitor.rounding = &rounding;
    const auto note = boost::make_function_output_iterator([&](const auto& pair) {
      visitor.look();
      map.emplace_back(index_of(pair.first), pair.second);
    });
    try {
      gained = Form::insert(tr, points, c.faces, Traits(),
                            CGAL::parameters::random_seed(c.seed)
                                .visitor(std::ref(visitor))
                                .vertex_to_vertex_output_iterator(note));
      is_complete = !visitor.has_stopped;
    } catch (const Stop&) {
    }
    if (!rounding.is_kept())
      return "the caller's rounding mode was not restored";
    visitor.rounding = nullptr;
  }
  tally.count(visitor.is_replaced ? "target: CGAL's instead" : "target: that of the traits");
  if (!visitor.keeps_rounding)
    return "the visitor was called in another rounding mode";
  if (!is_complete) {
    tally.count("stopped");
    return mistake_after_stop(tr, c, visitor);
  }
  if (gained !=
      std::ptrdiff_t(
          plain.number_of_vertices() -
          (old_points.empty() ? 0 : Tr(old_points.begin(), old_points.end()).number_of_vertices())))
    return "it returned " + std::to_string(gained);
  for (const std::string& wrong : {difference(tr, plain), mistake_in_map(map, tr, points)})
    if (!wrong.empty())
      return wrong;
  return difference_later(tr, plain, c.later_points);
}

} // namespace fuzz

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_CHECK_INSERTION_H
