// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_FACE_READER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_FACE_READER_H

// Reads a triangle soup as a rotation system, and turns marked darts back into pairs of vertices.
//
// Invariant: see Rotation_system.h. The list of v begins in the first face that has v, and
// goes around as the halfedges that lead to v would if that face is oriented as given; how other
// faces are oriented does not matter. The list of a boundary vertex begins at the border found by
// going back from there. Input outside the definition is refused, and the message names the fault:
// a face that is no triangle or has a vertex twice, an edge with more than two faces, a pinched
// vertex. Cost: linear; reading takes two passes over the faces and one over the corners at each
// vertex, and for_each_marked() reads again.

#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Rotation_system.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class FaceRange>
class Face_reader
{
public:
  using Edge = std::pair<std::size_t, std::size_t>;

  Face_reader(const FaceRange& faces, std::size_t number_of_vertices)
    : m_faces(faces)
    , m_number_of_vertices(number_of_vertices)
  {
    static_assert(
        is_index<std::decay_t<decltype(*std::begin(*std::begin(faces)))>>,
        "faces have indices of vertices, which are integers: convert other numbers first");
  }

  std::size_t number_of_darts() const // an upper bound
  {
    return 6 * std::size_t(std::distance(std::begin(m_faces), std::end(m_faces)));
  }

  std::size_t number_of_vertices() const { return m_number_of_vertices; }

  static Edge ends(const Edge& e) { return e; }

  template <class Index>
  void read(Rotation_system<Index>& surface) const
  {
    const std::vector<std::array<Index, 3>> triangles = read_triangles<Index>();
    const Lists<Index> corners =
        in_lists<Index>(m_number_of_vertices,
                        Listed_items(
                            3 * triangles.size(),
                            [&](std::size_t k) { return std::size_t(triangles[k / 3][k % 3]); },
                            [](std::size_t k) { return Index(k); }));
    surface.on_boundary.assign(m_number_of_vertices, false);
    surface.first.assign(1, 0);
    surface.first.reserve(m_number_of_vertices + 1);
    surface.neighbor.reserve(3 * triangles.size() + triangles.size() / 8);
    Scratch<Index> scratch(m_number_of_vertices);
    for (std::size_t v = 0; v < m_number_of_vertices; ++v) {
      read_star(Index(v), corners.begin(v), corners.end(v), triangles, scratch, surface);
      surface.first.push_back(Index(surface.neighbor.size()));
    }
  }

  // Calls function(dart, edge) for every marked dart. The surface that was read may have been
  // opened since, so that its lists name copies of vertices; so the faces are read again.
  template <class Index, class Function>
  void for_each_marked(const Rotation_system<Index>&, const Dart_marks& marks,
                       const Function& function) const
  {
    Rotation_system<Index> surface;
    read(surface);
    for (Index v = 0; v < surface.number_of_vertices(); ++v)
      for (Index dart = surface.first[v]; dart < surface.first[v + 1]; ++dart)
        if (marks[dart])
          function(dart, Edge(v, surface.neighbor[dart]));
  }

private:
  template <class Index>
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  // Holds the edges at one vertex, each with its other end and the one or two corners beside it.
  template <class Index>
  struct Scratch
  {
    struct Edge
    {
      Index neighbor;
      std::array<Index, 2> corners;
    };

    explicit Scratch(std::size_t n)
      : place(n, none<Index>)
    {
    }

    std::vector<Index> place; // the place of a neighbour in `edges`
    std::vector<Edge> edges;
  };

  template <class Index>
  std::vector<std::array<Index, 3>> read_triangles() const
  {
    std::vector<std::array<Index, 3>> triangles;
    std::size_t f = 0;
    for (const auto& face : m_faces) {
      std::array<Index, 3> t = {0, 0, 0};
      std::size_t k = 0;
      for (const auto& v : face) {
        if (v < decltype(v + 0)(0) || std::size_t(v) >= m_number_of_vertices)
          refuse("face " + std::to_string(f) + ": the index " + std::to_string(v) +
                 " is not one of a vertex");
        t[k++ % 3] = Index(v);
      }
      if (k != 3)
        refuse("face " + std::to_string(f) + " is not a triangle");
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
        refuse("face " + std::to_string(f) + " has a vertex twice");
      triangles.push_back(t);
      ++f;
    }
    return triangles;
  }

  // Returns the other ends of the edges at corner k: the next and the previous vertex of its face.
  template <class Index>
  static std::array<Index, 2> ends(const std::vector<std::array<Index, 3>>& triangles, Index k)
  {
    const std::array<Index, 3>& t = triangles[k / 3];
    return {t[(k + 1) % 3], t[(k + 2) % 3]};
  }

  template <class Index>
  void read_star(Index v, const Index* begin, const Index* end,
                 const std::vector<std::array<Index, 3>>& triangles, Scratch<Index>& scratch,
                 Rotation_system<Index>& surface) const
  {
    if (begin == end)
      return;
    auto& edges = scratch.edges;
    edges.clear();
    for (const Index* k = begin; k != end; ++k)
      for (const Index u : ends(triangles, *k)) {
        Index& place = scratch.place[u];
        if (place == none<Index>) {
          place = Index(edges.size());
          edges.push_back({u, {*k, none<Index>}});
        } else if (edges[place].corners[1] == none<Index>)
          edges[place].corners[1] = *k;
        else
          refuse(edge_name(v, u) + " is in more than two faces");
      }

    // The walk starts at the edge to the previous vertex of the first face; on the boundary, it
    // first goes back across that edge to the border.
    const std::size_t corners = std::size_t(end - begin);
    Index corner = *begin, start = scratch.place[ends(triangles, *begin)[1]];
    if (edges.size() == corners + 1) {
      surface.on_boundary[v] = true;
      std::size_t steps = 0; // a closed fan beside an open one would make this loop endless
      for (Index back = other_corner(edges[start], corner); back != none<Index>;
           back = other_corner(edges[start], corner)) {
        if (++steps > corners)
          refuse_pinched(v);
        corner = back;
        start = other_edge(triangles, scratch, start, corner);
      }
    }
    std::size_t met = 0;
    for (Index e = start; corner != none<Index>; ++met) {
      surface.neighbor.push_back(edges[e].neighbor);
      e = other_edge(triangles, scratch, e, corner);
      corner = other_corner(edges[e], corner);
      if (corner == none<Index> && edges.size() == corners + 1)
        surface.neighbor.push_back(edges[e].neighbor);
      if (e == start)
        corner = none<Index>;
    }
    if (met != corners || edges.size() > corners + 1)
      refuse_pinched(v);
    for (const auto& e : edges)
      scratch.place[e.neighbor] = none<Index>;
  }

  [[noreturn]] static void refuse_pinched(std::size_t v)
  {
    refuse(vertex_name(v) + " is pinched: its edges form more than one fan");
  }

  template <class Edge, class Index>
  static Index other_corner(const Edge& edge, Index corner)
  {
    return edge.corners[0] == corner ? edge.corners[1] : edge.corners[0];
  }

  template <class Index>
  static Index other_edge(const std::vector<std::array<Index, 3>>& triangles,
                          const Scratch<Index>& scratch, Index edge, Index corner)
  {
    const std::array<Index, 2> both = ends(triangles, corner);
    return scratch.place[both[0] == scratch.edges[edge].neighbor ? both[1] : both[0]];
  }

  const FaceRange& m_faces;
  std::size_t m_number_of_vertices;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_FACE_READER_H
