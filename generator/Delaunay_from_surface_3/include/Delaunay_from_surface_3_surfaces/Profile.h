// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_PROFILE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_PROFILE_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace surfaces {

/// A planar domain that CAD would extrude: an outer loop, counterclockwise, and holes, clockwise,
/// one after the other in `points`. No two loops meet.
struct Profile
{
  using Point_2 = Indexed_surface::Kernel::Point_2;

  std::vector<Point_2> points;
  std::vector<std::size_t> loop_ends;

  /// Ends the loop of the points added since the last one ended.
  void end_loop() { loop_ends.push_back(points.size()); }

  /// The edges of the loops, the domain on their left.
  std::vector<std::pair<std::size_t, std::size_t>> edges() const
  {
    std::vector<std::pair<std::size_t, std::size_t>> result;
    std::size_t first = 0;
    for (const std::size_t end : loop_ends) {
      for (std::size_t k = first; k < end; ++k)
        result.emplace_back(k, k + 1 == end ? first : k + 1);
      first = end;
    }
    return result;
  }
};

/// The counterclockwise triangles of the constrained Delaunay triangulation of a profile, with no
/// points but those of its loops: fans and needles, as CAD kernels give planar faces.
inline std::vector<Indexed_surface::Face> planar_face(const Profile& profile)
{
  using Kernel = Indexed_surface::Kernel;
  using Vb = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
  using Fb = CGAL::Constrained_triangulation_face_base_2<Kernel>;
  using Tds = CGAL::Triangulation_data_structure_2<Vb, Fb>;
  using Triangulation =
      CGAL::Constrained_Delaunay_triangulation_2<Kernel, Tds, CGAL::No_constraint_intersection_tag>;
  std::vector<std::pair<Profile::Point_2, std::size_t>> numbered;
  for (std::size_t k = 0; k < profile.points.size(); ++k)
    numbered.emplace_back(profile.points[k], k);
  Triangulation tr;
  tr.insert(numbered.begin(), numbered.end());
  std::vector<Triangulation::Vertex_handle> vertex(numbered.size());
  for (const auto v : tr.finite_vertex_handles())
    vertex[v->info()] = v;

  std::vector<Triangulation::Face_handle> inside;
  for (const auto& [s, t] : profile.edges())
    tr.insert_constraint(vertex[s], vertex[t]);
  CGAL::Unique_hash_map<Triangulation::Face_handle, bool> is_inside(false);
  const auto enter = [&](Triangulation::Face_handle f) {
    if (!is_inside[f])
      inside.push_back(f);
    is_inside[f] = true;
  };
  for (const auto& [s, t] : profile.edges()) {
    Triangulation::Face_handle f;
    int i;
    if (tr.is_edge(vertex[s], vertex[t], f, i)) // f is on one side: the domain is on the left
      enter(f->vertex(Triangulation::ccw(i)) == vertex[s] ? f : f->neighbor(i));
  }
  for (std::size_t k = 0; k < inside.size(); ++k)
    for (int i = 0; i < 3; ++i)
      if (const auto f = inside[k]; !f->is_constrained(i))
        enter(f->neighbor(i));

  std::vector<Indexed_surface::Face> faces;
  for (const auto f : inside)
    faces.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  return faces;
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_PROFILE_H
