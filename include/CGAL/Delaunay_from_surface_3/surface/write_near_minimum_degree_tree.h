// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_WRITE_NEAR_MINIMUM_DEGREE_TREE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_WRITE_NEAR_MINIMUM_DEGREE_TREE_H

// Reads a surface, marks the tree of bounded degree, exchanges edges, and writes the result.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/surface/Reduce_degrees.h>
#include <CGAL/Delaunay_from_surface_3/surface/write_bounded_degree_subgraph.h>

#include <algorithm>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Returns whether no vertex has more than three marked edges; each is marked at one of its darts.
template <class Index>
bool has_degree_of_3(const Rotation_system<Index>& surface, const Dart_marks& marks)
{
  std::vector<unsigned char> degree(surface.number_of_vertices(), 0);
  bool result = true;
  const auto count = [&](Index v) { result = result && ++degree[v] <= 3; };
  for (Index v = 0; v < surface.number_of_vertices(); ++v)
    for (Index dart = surface.first[v]; dart < surface.first[v + 1]; ++dart)
      if (marks[dart]) {
        count(v);
        count(surface.neighbor[dart]);
      }
  return result;
}

template <class Index>
Dart_marks near_minimum_degree_marks(Rotation_system<Index>& surface,
                                     std::vector<Minimum_degree_witness>& witnesses)
{
  Dart_marks marks;
  {
    Bounded_degree_marks<Index> find_tree(surface, Subgraph_kind::TREE);
    marks = find_tree();
    find_tree.close();
  }
  if (!has_degree_of_3(surface, marks))
    Reduce_degrees<Index>(surface, marks)(witnesses);
  return marks;
}

template <class Reader, class OutputIterator>
OutputIterator write_near_minimum_degree_tree(const Reader& reader, OutputIterator out,
                                              std::vector<Minimum_degree_witness>& witnesses)
{
  return with_rotation_system(reader, [&](auto& surface) {
    return write_marked(reader, surface, near_minimum_degree_marks(surface, witnesses), out);
  });
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_WRITE_NEAR_MINIMUM_DEGREE_TREE_H
