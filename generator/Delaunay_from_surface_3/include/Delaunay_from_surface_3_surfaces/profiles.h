// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_PROFILES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_PROFILES_H

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
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

namespace internal {

constexpr double turn = 2 * 3.14159265358979323846;

inline double share(std::size_t k, std::size_t n)
{
  return static_cast<double>(k) / static_cast<double>(n);
}

// n + 1 points of a circular arc from the angle a to the angle b, in turns.
inline void add_arc(Profile& profile, double x, double y, double radius, double a, double b,
                    std::size_t n)
{
  for (std::size_t k = 0; k <= n; ++k) {
    const double angle = turn * (a + (b - a) * share(k, n));
    profile.points.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle));
  }
}

} // namespace internal

/// Ends the profile with a round hole of `n` points. \pre it lies inside, away from other loops
inline void add_hole(Profile& profile, double x, double y, double radius, std::size_t n)
{
  for (std::size_t k = 0; k < n; ++k) {
    const double angle = -internal::turn * internal::share(k, n);
    profile.points.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle));
  }
  profile.end_loop();
}

/// A NACA airfoil of four digits with chord 1 and a closed trailing edge: `camber` and `thickness`
/// in shares of the chord, the largest camber at `position` (Jacobs, Ward, Pinkerton: The
/// characteristics of 78 related airfoil sections, NACA Report 460, 1933). 2 `half` points, dense
/// at both edges.
inline Profile airfoil(std::size_t half, double camber, double position, double thickness)
{
  const auto surface_point = [=](double x, double side) {
    const double y = 5 * thickness *
                     (0.2969 * std::sqrt(x) - 0.1260 * x - 0.3516 * x * x + 0.2843 * x * x * x -
                      0.1036 * x * x * x * x);
    const double rest = x < position ? position : 1 - position;
    const double slope = 2 * camber / (rest * rest) * (position - x);
    const double line =
        camber - camber / (rest * rest) * (position - x) * (position - x); // zero at both edges
    const double angle = std::atan(slope);
    return Profile::Point_2(x - side * y * std::sin(angle), line + side * y * std::cos(angle));
  };
  Profile profile;
  for (std::size_t k = 0; k < half; ++k) // from the trailing edge over the upper side
    profile.points.push_back(
        surface_point((1 + std::cos(internal::turn / 2 * internal::share(k, half))) / 2, 1));
  for (std::size_t k = 0; k < half; ++k)
    profile.points.push_back(
        surface_point((1 - std::cos(internal::turn / 2 * internal::share(k, half))) / 2, -1));
  profile.end_loop();
  return profile;
}

/// A gear with a bore: every tooth has flanks of `n` points and a tip and a root of two points.
inline Profile gear(std::size_t teeth, std::size_t n, double root_radius)
{
  Profile profile;
  for (std::size_t t = 0; t < teeth; ++t)
    for (std::size_t k = 0; k < 2 * n; ++k) {
      const bool rises = k < n;
      const double s =
          internal::share(rises ? k : 2 * n - 1 - k, n - 1); // 0 at the root, 1 at the tip
      const double half_width = 0.17 - 0.09 * s * s;         // of a tooth, in steps
      const double angle = internal::turn *
                           (static_cast<double>(t) + (rises ? -half_width : half_width)) /
                           static_cast<double>(teeth);
      const double radius = root_radius + (1 - root_radius) * s;
      profile.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
  profile.end_loop();
  add_hole(profile, 0, 0, 0.4 * root_radius, (std::max)(std::size_t(8), 2 * teeth));
  return profile;
}

/// An I-beam of height 1 whose web meets the flanges in fillets of `n` + 1 points each.
inline Profile i_beam(std::size_t n, double width, double flange, double web, double fillet)
{
  Profile profile;
  const double x = width / 2, w = web / 2, inner = 0.5 - flange;
  const auto add = [&](double px, double py) { profile.points.emplace_back(px, py); };
  add(-x, -0.5);
  add(x, -0.5);
  add(x, -inner);
  internal::add_arc(profile, w + fillet, -inner + fillet, fillet, 0.75, 0.5, n);
  internal::add_arc(profile, w + fillet, inner - fillet, fillet, 0.5, 0.25, n);
  add(x, inner);
  add(x, 0.5);
  add(-x, 0.5);
  add(-x, inner);
  internal::add_arc(profile, -w - fillet, inner - fillet, fillet, 0.25, 0, n);
  internal::add_arc(profile, -w - fillet, -inner + fillet, fillet, 0, -0.25, n);
  add(-x, -inner);
  profile.end_loop();
  return profile;
}

/// A plate with `ribs` ribs on top that stand on fillets of `n` + 1 points, a step of 1 from rib to
/// rib.
inline Profile ribbed_plate(std::size_t ribs, std::size_t n, double height, double thickness)
{
  const double width = 0.2, fillet = 0.15;
  Profile profile;
  profile.points.emplace_back(-1, -thickness);
  profile.points.emplace_back(static_cast<double>(ribs), -thickness);
  profile.points.emplace_back(static_cast<double>(ribs), 0);
  for (std::size_t r = ribs; r-- > 0;) { // from right to left
    const double x = static_cast<double>(r);
    internal::add_arc(profile, x + width / 2 + fillet, fillet, fillet, 0.75, 0.5, n);
    profile.points.emplace_back(x + width / 2, height);
    profile.points.emplace_back(x - width / 2, height);
    internal::add_arc(profile, x - width / 2 - fillet, fillet, fillet, 0, -0.25, n);
  }
  profile.points.emplace_back(-1, 0);
  profile.end_loop();
  return profile;
}

/// A rectangle with `rows` times `columns` holes of `n` points, a step of 1 from hole to hole.
inline Profile drilled_rectangle(std::size_t rows, std::size_t columns, std::size_t n,
                                 double hole_radius)
{
  const double x = static_cast<double>(columns) - 0.5, y = static_cast<double>(rows) - 0.5;
  Profile profile;
  profile.points = {{-0.5, -0.5}, {x, -0.5}, {x, y}, {-0.5, y}};
  profile.end_loop();
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < columns; ++c)
      add_hole(profile, static_cast<double>(c), static_cast<double>(r), hole_radius, n);
  return profile;
}

/// A ring of `n` points on each of its two circles, of radius 1 and `bore`.
inline Profile annulus(std::size_t n, double bore)
{
  Profile profile;
  for (std::size_t k = 0; k < n; ++k)
    profile.points.emplace_back(std::cos(internal::turn * internal::share(k, n)),
                                std::sin(internal::turn * internal::share(k, n)));
  profile.end_loop();
  add_hole(profile, 0, 0, bore, n);
  return profile;
}

/// A closed solid with `layers` copies of a profile, the walls of quadrangles cut in two, and
/// planar faces at both ends. `position(k, layer)` is where the k-th point of the profile is; a map
/// that keeps its orientation when looked at against the direction of the layers. The points are
/// numbered layer by layer. \pre `layers >= 2`
template <class Position>
Indexed_surface swept(const Profile& profile, std::size_t layers, const Position& position)
{
  const std::size_t n = profile.points.size(), top = (layers - 1) * n;
  Indexed_surface surface;
  for (std::size_t layer = 0; layer < layers; ++layer)
    for (std::size_t k = 0; k < n; ++k)
      surface.points.push_back(position(k, layer));
  for (const Indexed_surface::Face& f : planar_face(profile)) {
    surface.faces.push_back({f[0], f[2], f[1]});
    surface.faces.push_back({top + f[0], top + f[1], top + f[2]});
  }
  const auto edges = profile.edges();
  for (std::size_t first = 0; first < top; first += n)
    for (const auto& [s, t] : edges) {
      surface.faces.push_back({first + s, first + t, first + n + t});
      surface.faces.push_back({first + s, first + n + t, first + n + s});
    }
  return surface;
}

/// A closed solid with `rings` rings of `segments` points and a hub at each end that a fan of
/// triangles joins to the last ring. `position(segment, ring)`; the points are numbered ring by
/// ring, then the two hubs. \pre `segments >= 3`, `rings >= 1`
template <class Position>
Indexed_surface turned(std::size_t segments, std::size_t rings, const Position& position,
                       const Indexed_surface::Point_3& first_hub,
                       const Indexed_surface::Point_3& last_hub)
{
  const std::size_t n = segments * rings;
  Indexed_surface surface;
  for (std::size_t r = 0; r < rings; ++r)
    for (std::size_t s = 0; s < segments; ++s)
      surface.points.push_back(position(s, r));
  surface.points.push_back(first_hub);
  surface.points.push_back(last_hub);
  for (std::size_t s = 0; s < segments; ++s) {
    const std::size_t t = (s + 1) % segments;
    surface.faces.push_back({n, t, s});
    for (std::size_t first = 0; first + segments < n; first += segments) {
      surface.faces.push_back({first + s, first + t, first + segments + t});
      surface.faces.push_back({first + s, first + segments + t, first + segments + s});
    }
    surface.faces.push_back({n + 1, n - segments + s, n - segments + t});
  }
  return surface;
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_PROFILES_H
