// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_CHECK_TRIANGLES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_CHECK_TRIANGLES_H

// Checks that lists which were given, not derived from faces, describe triangles: where v's list
// has a next to b, a's list must have b next to v, and b's list v next to a.
//
// Each triangle is looked up from its heaviest corner only (by degree, then index) in the lists of
// the other two. When all these are there, and heaviest, middle and lightest corners are equally
// many, then no corner is left over.
// Cost: the sum over the edges of the smaller degree of its two ends, O(n) on surfaces of bounded
// genus (Chiba, Nishizeki 1985), one list with a million entries included; no memory.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Refuse_input.h>
#include <CGAL/Delaunay_from_surface_3/surface/Rotation_system.h>

#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Index>
struct Check_triangles
{
  const Rotation_system<Index>& surface;

  void operator()() const
  {
    std::size_t corners[3] = {0, 0, 0}; // by how many of the other two are heavier
    for (Index v = 0; v < surface.number_of_vertices(); ++v) {
      if (surface.degree(v) == 2 && !surface.on_boundary[v])
        check_pair_of_triangles(v);
      for_each_corner(v, [&](Index a, Index b) {
        const int heavier = (is_heavier(a, v) ? 1 : 0) + (is_heavier(b, v) ? 1 : 0);
        ++corners[heavier];
        if (heavier == 0) {
          require_corner(a, v, b);
          require_corner(b, v, a);
        }
      });
    }
    if (corners[0] != corners[1] || corners[0] != corners[2])
      refuse_lonely_corner();
  }

private:
  template <class Function>
  void for_each_corner(Index v, const Function& function) const
  {
    const Star<Index> star = surface.star(v);
    for (Index i = 0; i + 1 < star.size(); ++i)
      function(star[i], star[i + 1]);
    if (star.size() > 0 && !surface.on_boundary[v])
      function(star[star.size() - 1], star[0]);
  }

  bool is_heavier(Index a, Index b) const
  {
    const Index da = surface.degree(a), db = surface.degree(b);
    return da > db || (da == db && a > b);
  }

  bool has_corner(Index v, Index a, Index b) const
  {
    const Star<Index> star = surface.star(v);
    if (star.size() == 0) // though others' lists lead to v
      return false;
    const Index last = star.size() - 1;
    for (Index i = 0; i < last; ++i)
      if ((star[i] == a && star[i + 1] == b) || (star[i] == b && star[i + 1] == a))
        return true;
    return !surface.on_boundary[v] &&
           ((star[last] == a && star[0] == b) || (star[last] == b && star[0] == a));
  }

  // v's list shows the triangle v, a, w at the edge to w, so w's list must too.
  void require_corner(Index w, Index v, Index a) const
  {
    if (!has_corner(w, v, a))
      refuse("inconsistent lists: around " + vertex_name(v) + " the edges to " + vertex_name(w) +
             " and " + vertex_name(a) + " are neighbours, but in the list of " + vertex_name(w) +
             " the edges to " + vertex_name(v) + " and " + vertex_name(a) + " are not");
  }

  // Two edges around an inner vertex: only the sphere of two triangles has such.
  void check_pair_of_triangles(Index v) const
  {
    for (Index u : surface.star(v))
      if (surface.degree(u) != 2 || surface.on_boundary[u])
        refuse("inconsistent lists: " + vertex_name(v) +
               " has two edges and none is marked as boundary");
  }

  [[noreturn]] void refuse_lonely_corner() const
  {
    for (Index v = 0; v < surface.number_of_vertices(); ++v)
      for_each_corner(v, [&](Index a, Index b) {
        require_corner(a, v, b);
        require_corner(b, v, a);
      });
    refuse("inconsistent lists: a triangle is listed twice at a vertex");
  }
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_CHECK_TRIANGLES_H
