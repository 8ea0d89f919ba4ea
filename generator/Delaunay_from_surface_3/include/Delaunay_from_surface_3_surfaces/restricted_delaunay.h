// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_RESTRICTED_DELAUNAY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_RESTRICTED_DELAUNAY_H

// Surfaces all of whose triangles are Delaunay: what the theorems of Choi 2002 ask for. They are
// restricted Delaunay triangulations, made by CGAL's Mesh_3.

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/implicit_shapes.h>

#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/make_mesh_3.h>

#include <cmath>
#include <cstddef>
#include <string>

namespace surfaces {

/// The unit sphere, as an implicit shape.
struct Unit_sphere
{
  using Point_3 = Indexed_surface::Point_3;

  double operator()(const Point_3& p) const
  {
    return std::sqrt(p.x() * p.x() + p.y() * p.y() + p.z() * p.z()) - 1;
  }
  double radius() const { return 1; }
  double feature() const { return 1; }
};

/// A chain of tori, flattened across: its tubes are no circles. Round tubes are a degenerate case,
/// as all points of a cross-section are as far from its middle, and D(S) then grows faster than n.
class Oval_torus_chain
{
public:
  using Point_3 = Indexed_surface::Point_3;

  explicit Oval_torus_chain(std::size_t genus)
    : m_round(genus)
  {
  }

  double operator()(const Point_3& p) const
  {
    return m_round(Point_3(p.x(), p.y() / 1.2, p.z() / 1.6));
  }
  double radius() const { return 1.6 * m_round.radius(); }
  double feature() const { return m_round.feature(); }

private:
  Torus_chain m_round;
};

namespace internal {

// The boundary between the cells inside and those outside, seen from outside.
template <class Complex>
Indexed_surface boundary_of_complex(const Complex& complex)
{
  using Triangulation = typename Complex::Triangulation;
  Indexed_surface surface;
  CGAL::Unique_hash_map<typename Complex::Vertex_handle, std::size_t> number(~std::size_t(0));
  for (auto f = complex.facets_in_complex_begin(); f != complex.facets_in_complex_end(); ++f) {
    auto [c, i] = complex.is_in_complex(f->first) ? *f : complex.triangulation().mirror_facet(*f);
    Indexed_surface::Face face;
    for (int k = 0; k < 3; ++k) {
      const auto v = c->vertex(Triangulation::vertex_triple_index(i, k));
      if (number[v] == ~std::size_t(0)) {
        number[v] = surface.points.size();
        surface.points.push_back(complex.triangulation().point(v).point());
      }
      face[std::size_t(k)] = number[v];
    }
    surface.faces.push_back(face);
  }
  return surface;
}

// Balls about triangles of the surface that hold no other of its points have at most radius `size`.
// Of the points of the triangulation all are on the surface, which is neither perturbed nor exuded:
// so its triangles are Delaunay. With a larger error bound points leave the surface, and Mesh_3
// hardly ends.
template <class Shape>
Indexed_surface meshed(const Shape& shape, const Indexed_surface::Point_3& inside, double size)
{
  using Kernel = Indexed_surface::Kernel;
  using Domain = CGAL::Labeled_mesh_domain_3<Kernel>;
  using Triangulation = typename CGAL::Mesh_triangulation_3<Domain>::type;
  using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
  namespace parameters = CGAL::parameters;

  const double radius =
      1.1 *
      (shape.radius() + std::sqrt(CGAL::squared_distance(inside, Kernel::Point_3(CGAL::ORIGIN))));
  const Domain domain = Domain::create_implicit_mesh_domain(
      [&shape](const Kernel::Point_3& p) { return shape(p); },
      Kernel::Sphere_3(inside, radius * radius), parameters::relative_error_bound = 1e-7);
  const CGAL::Mesh_criteria_3<Triangulation> criteria(parameters::facet_angle = 25,
                                                      parameters::facet_size = size);
  return boundary_of_complex(CGAL::make_mesh_3<Complex>(
      domain, criteria, parameters::no_perturb(), parameters::no_exude(), parameters::manifold()));
}

// The number of vertices goes with size^-2, so each try tells the size for the next.
template <class Shape>
Indexed_surface meshed_to_number(const Shape& shape, const Indexed_surface::Point_3& inside,
                                 std::size_t n)
{
  const double wanted = static_cast<double>(n), pilot = (std::min)(wanted, 4000.);
  double size = shape.feature() / 4;
  for (double found = 0; std::abs(found - pilot) > 0.03 * pilot;) {
    found = static_cast<double>(meshed(shape, inside, size).points.size());
    size *= std::sqrt(found / pilot);
  }
  Indexed_surface surface = meshed(shape, inside, size * std::sqrt(pilot / wanted));
  const double found = static_cast<double>(surface.points.size());
  require(std::abs(found - wanted) <= 0.1 * wanted, "a surface of " + std::to_string(n) +
                                                        " points came out with " +
                                                        std::to_string(surface.points.size()));
  return surface;
}

} // namespace internal

/// A restricted Delaunay triangulation of the unit sphere with `n` points, within 10 %.
inline Indexed_surface delaunay_sphere(std::size_t n)
{
  return internal::meshed_to_number(Unit_sphere(), {0, 0, 0}, n);
}

/// A restricted Delaunay triangulation of a chain of three oval tori with `n` points, within 10 %.
inline Indexed_surface delaunay_genus_3(std::size_t n)
{
  return internal::meshed_to_number(Oval_torus_chain(3), {1, 0, 0}, n); // where two rings touch
}

/// The same with round tubes: its Delaunay triangulation is larger.
inline Indexed_surface delaunay_round_genus_3(std::size_t n)
{
  return internal::meshed_to_number(Torus_chain(3), {1, 0, 0}, n);
}

} // namespace surfaces

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACES_RESTRICTED_DELAUNAY_H
