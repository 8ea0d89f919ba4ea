// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_OPEN_ALONG_CUT_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_OPEN_ALONG_CUT_H

// Opens the surface along the cut graph, with copies of the vertices on it: step 3 of the cut.
//
// The edges of the cut graph divide the list of a vertex into sectors; a vertex with two sectors or
// more gets one copy per sector, whose list is the sector with the cut edge at either end. Then the
// neighbours' lists are redirected to the copies: u hears from every copy that lists it, and names
// that copy where it named the origin. Along a cut edge uv two copies of v list u; the third corner
// of the triangle on this side tells which one is meant.
// Invariant: afterwards every component is a disc and every list names a vertex by the copy that
// lies in the same disc corner.
// Cost: O(length of the lists of vertices on the cut), plus one pass over the vertices.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Rotation_system.h>
#include <CGAL/Delaunay_from_surface_3/surface/cut_graph.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Holds the surface cut open into discs: the rotation system, plus copies of vertices on the cut.
//
// Invariant: vertices 0 .. n-1 are the surface's own; n, n+1, … are the copies. A vertex that has
// copies is dead itself: no list names it any more. Around a vertex on the rim of a disc (a copy, a
// vertex with one sector on the boundary, a corner of an opened face) the live part of its list
// lies between its two rim neighbours.
// Cost: 4 bytes per dart of a copy and 16 per copy; no memory if nothing is cut.

template <class Index>
struct Opened_surface
{
  Rotation_system<Index>& surface;
  std::vector<Index> copy_first = {0}; // as Rotation_system::first, for the copies
  std::vector<Index> copy_neighbor;    // as Rotation_system::neighbor
  std::vector<Index> copy_origin;      // the surface vertex that a copy was made of
  std::vector<Index> copy_start;       // the position in the origin's list where its list starts
  std::vector<Index> rim;              // every vertex on the rim of a disc, each once

  explicit Opened_surface(Rotation_system<Index>& s)
    : surface(s)
  {
  }

  Index number_of_surface_vertices() const { return surface.number_of_vertices(); }
  Index number_of_copies() const { return static_cast<Index>(copy_origin.size()); }
  Index number_of_vertices() const { return number_of_surface_vertices() + number_of_copies(); }
  bool is_copy(Index v) const { return v >= number_of_surface_vertices(); }

  Index origin(Index v) const
  {
    return is_copy(v) ? copy_origin[v - number_of_surface_vertices()] : v;
  }

  Star<Index> star(Index v) const
  {
    if (!is_copy(v))
      return surface.star(v);
    const Index c = v - number_of_surface_vertices();
    return {copy_neighbor.data() + copy_first[c], copy_neighbor.data() + copy_first[c + 1]};
  }

  // Returns the surface's dart at a position of v's list.
  std::size_t dart(Index v, Index position) const
  {
    if (!is_copy(v))
      return std::size_t(surface.first[v]) + position;
    const Index c = v - number_of_surface_vertices();
    const Index o = copy_origin[c];
    const Index p = copy_start[c] + position;
    const Index degree = surface.degree(o);
    return std::size_t(surface.first[o]) + (p < degree ? p : p - degree);
  }
};

template <class Index>
class Open_along_cut
{
public:
  Open_along_cut(const Cut_candidate<Index>& cut, std::vector<Index> scratch,
                 Opened_surface<Index>& opened)
    : m_cut(cut)
    , m_opened(opened)
    , m_surface(opened.surface)
    , m_slot(std::move(scratch))
  {
  }

  // Makes the copies, and puts them and the boundary vertices without copies on the rim. The caller
  // opens spheres.
  void operator()()
  {
    m_slot.assign(m_surface.number_of_vertices(), Buckets<Index>::empty);
    reserve();
    for (Index v = 0; v < m_surface.number_of_vertices(); ++v) {
      if (has_copies(v))
        make_copies(v);
      else if (m_surface.on_boundary[v])
        m_opened.rim.push_back(v);
    }
    m_head_of_copied.assign(m_opened.number_of_copies(), Buckets<Index>::empty);
    m_heard_of.assign(m_opened.number_of_copies(), Buckets<Index>::empty);
    for (Index c = 0; c < m_opened.number_of_copies(); ++c)
      tell_neighbors(c);
    for (Index u = 0; u < m_surface.number_of_vertices(); ++u)
      if (head(u) != Buckets<Index>::empty)
        turn_list_to_copies(u);
    for (Index c = 0; c < m_opened.number_of_copies(); ++c)
      m_opened.rim.push_back(vertex_of_copy(c));
  }

private:
  // m_slot[v] is v's first copy if v has copies, otherwise the head of v's bucket.
  bool has_copies(Index v) const { return m_cut.degree[v] > (m_surface.on_boundary[v] ? 2u : 1u); }
  Index& head(Index v) { return has_copies(v) ? m_head_of_copied[m_slot[v]] : m_slot[v]; }
  Index vertex_of_copy(Index c) const { return m_surface.number_of_vertices() + c; }

  // Reserves memory for the lists, which would take three times as much while they grow and move.
  void reserve()
  {
    std::size_t entries = 0;
    for (Index v = 0; v < m_surface.number_of_vertices(); ++v)
      if (has_copies(v))
        entries += std::size_t(m_surface.degree(v)) + m_cut.degree[v];
    m_opened.copy_neighbor.reserve(entries);
    m_told.reserve(entries);
  }

  void make_copies(Index v)
  {
    const Star<Index> star = m_surface.star(v);
    const Index degree = star.size();
    const Index base = m_surface.first[v];
    Index start = 0;
    while (!m_cut.marks[base + start])
      ++start;
    m_slot[v] = m_opened.number_of_copies();
    const Index sectors = m_cut.degree[v] - (m_surface.on_boundary[v] ? 1 : 0);
    for (Index sector = 0; sector < sectors; ++sector) {
      m_opened.copy_origin.push_back(v);
      m_opened.copy_start.push_back(start);
      Index i = start;
      do {
        m_opened.copy_neighbor.push_back(star[i]);
        i = i + 1 < degree ? i + 1 : 0;
      } while (!m_cut.marks[base + i]);
      m_opened.copy_neighbor.push_back(star[i]);
      m_opened.copy_first.push_back(static_cast<Index>(m_opened.copy_neighbor.size()));
      start = i;
    }
  }

  bool is_last_copy(Index c) const
  {
    return c + 1 == m_opened.number_of_copies() ||
           m_opened.copy_origin[c + 1] != m_opened.copy_origin[c];
  }

  // Tells the neighbours in c's list of c, but each edge at the origin only once: the last edge of
  // a sector is the first of the following one, if there is one.
  void tell_neighbors(Index c)
  {
    const bool at_end = m_surface.on_boundary[m_opened.copy_origin[c]] && is_last_copy(c);
    const Index end = m_opened.copy_first[c + 1] - (at_end ? 0 : 1);
    for (Index i = m_opened.copy_first[c]; i < end; ++i)
      m_told.add(head(m_opened.copy_neighbor[i]), c);
  }

  void turn_list_to_copies(Index u)
  {
    m_told.for_each(head(u), [&](Index c) { m_heard_of[m_slot[m_opened.copy_origin[c]]] = c; });
    if (!has_copies(u)) {
      for (Index dart = m_surface.first[u]; dart < m_surface.first[u + 1]; ++dart)
        turn_to_copy(m_surface.neighbor[dart]);
      return;
    }
    Index c = m_slot[u];
    do {
      const Index begin = m_opened.copy_first[c], last = m_opened.copy_first[c + 1] - 1;
      const Index third_at_begin = origin_at(begin + 1), third_at_last = origin_at(last - 1);
      turn_to_copy_across_cut(u, m_opened.copy_neighbor[begin], third_at_begin);
      for (Index i = begin + 1; i < last; ++i)
        turn_to_copy(m_opened.copy_neighbor[i]);
      turn_to_copy_across_cut(u, m_opened.copy_neighbor[last], third_at_last);
    } while (!is_last_copy(c++));
  }

  Index origin_at(Index i) const { return m_opened.origin(m_opened.copy_neighbor[i]); }

  void turn_to_copy(Index& v)
  {
    if (has_copies(v))
      v = vertex_of_copy(m_heard_of[m_slot[v]]);
  }

  // Replaces v by its copy in whose list u and the third corner stand side by side at an end.
  void turn_to_copy_across_cut(Index u, Index& v, Index third)
  {
    if (!has_copies(v))
      return;
    Index c = m_heard_of[m_slot[v]];
    const Index begin = m_opened.copy_first[c], last = m_opened.copy_first[c + 1] - 1;
    const bool is_here = (origin_at(begin) == u && origin_at(begin + 1) == third) ||
                         (origin_at(last) == u && origin_at(last - 1) == third);
    if (!is_here)
      c = c == m_slot[v] ? last_copy(c) : c - 1;
    v = vertex_of_copy(c);
  }

  Index last_copy(Index c) const
  {
    const Index v = m_opened.copy_origin[c];
    return c + m_cut.degree[v] - (m_surface.on_boundary[v] ? 2 : 1);
  }

  const Cut_candidate<Index>& m_cut;
  Opened_surface<Index>& m_opened;
  Rotation_system<Index>& m_surface;
  std::vector<Index> m_slot;
  std::vector<Index> m_head_of_copied; // at the first copy of a vertex
  std::vector<Index> m_heard_of;       // at the first copy of a vertex: the last copy heard of
  Buckets<Index> m_told;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_OPEN_ALONG_CUT_H
