// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_METHODS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_METHODS_H

// The ways to build the triangulation, each in three forms: bare (for the time), with a clock read
// at every change of phase (for the shares of the phases), and counting. And plain CGAL's triangulation,
// which the others must equal, and which is verified.

#include <Delaunay_from_surface_3_comparison/counts.h>
#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_meters/orders.h>

#include <Hilbert_neighbor_hints.h> // from the examples

#include <Delaunay_from_surface_3_meters/Surface_net_rounds.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_hints.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/surface/Bounded_degree_subgraph.h>
#include <CGAL/Delaunay_from_surface_3/surface/No_subgraph.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/Tracing_traits_3.h>
#include <CGAL/enum.h>
#include <CGAL/insert_surface_vertices_3.h>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace comparison {

struct Build
{
  Time time;
  std::optional<std::array<double, 3>> stages; // none where they cannot be seen from outside
};

struct Method
{
  std::string name;
  std::string description;
  // From nothing; `look` sees the triangulation before it is destroyed. Neither looking nor
  // destroying is part of the time.
  std::function<Build(const Mesh&, unsigned int seed, const Look& look)> build;
  // Empty where phases cannot be seen.
  std::function<Json(const Mesh&, unsigned int seed)> time_phases;
  // Empty where nothing can be counted.
  std::function<Json(const Mesh&, unsigned int seed)> count;
};

// CGAL's own insert(first, last).
template <class Tr>
Build build_by_plain(const Mesh& mesh, unsigned int, const Look& look)
{
  Tr tr;
  const Time time = time_of([&] { insert_plain(tr, mesh); });
  look(&tr);
  return {time, std::nullopt};
}

template <class Tr, class Traits>
Build build_by_package(const Mesh& mesh, unsigned int seed, const Look& look)
{
  Tr tr;
  Stage_visitor visitor;
  const Time time = time_of([&] { insert_by_package<Traits>(tr, mesh, seed, visitor); });
  look(&tr);
  return {time, visitor.seconds()};
}

template <class Tr, class Traits>
Json phases_of_package(const Mesh& mesh, unsigned int seed)
{
  Tr tr;
  Timing_visitor visitor;
  const Time total = time_of([&] { insert_by_package<Traits>(tr, mesh, seed, visitor); });
  return phases_as_json(total, visitor);
}

template <class Traits>
Method surface_method(const std::string& name, const std::string& description)
{
  Method method = {name, description, build_by_package<Triangulation, Traits>,
                   phases_of_package<Triangulation, Traits>, nullptr};
  if constexpr (Traits::through_core)
    method.count = counts_of_kernel<Traits>;
  else
    method.count = counts_of_insertion<Traits>;
  return method;
}

// Policies that the core could serve, but CGAL's insertion does.
template <class Policies>
struct By_cgal : Policies
{
  static constexpr bool through_core = false;
};

// The order of the paper, and CGAL's insertion from where the hints say.
template <template <class Target, class Subgraph> class Hints>
struct In_random_order
  : CGAL::Surface_insertion_policies_3<CGAL::Delaunay_from_surface_3::No_subgraph,
                                       meters::Random_log_star_rounds, Hints>
{
  static constexpr bool through_core = false;
};

// Plain CGAL is the first: the others are compared with it.
inline std::vector<Method> all_methods()
{
  using namespace CGAL;
  using namespace CGAL::Delaunay_from_surface_3;
  using Default = Surface_insertion_traits_3;
  using By_nets = Surface_insertion_policies_3<No_subgraph, Surface_net_rounds, Planned_hints_3>;
  return {
      {"plain", "dt.insert(first, last) of CGAL", build_by_plain<Triangulation>, nullptr,
       [](const Mesh& mesh, unsigned int) { return counts_of_plain(mesh); }},
      {"plain-fast", "the same into a triangulation with Fast_location",
       build_by_plain<Fast_triangulation>, nullptr, nullptr},
      surface_method<Default>("default",
                              "Surface_insertion_traits_3: spaced rounds, compact triangulation"),
      {"default-fast", "the same into a triangulation with Fast_location",
       build_by_package<Fast_triangulation, Default>,
       phases_of_package<Fast_triangulation, Default>, nullptr},
      surface_method<By_nets>("compact-nets", "nets of the surface, compact triangulation"),
      surface_method<Surface_insertion_policies_3<Full_graph, Spatial_sort_order, Previous_hint_3>>(
          "compact-spatial", "plain CGAL's order, which needs no surface; compact triangulation"),
      surface_method<By_cgal<By_nets>>(
          "nets", "nets of the surface, their starting points, CGAL's insertion"),
      surface_method<Plain_insertion_traits_3>(
          "plain-order", "Plain_insertion_traits_3: plain CGAL's insertions, our loop"),
      surface_method<By_cgal<Surface_insertion_policies_3<
          Full_graph, meters::Neighbor_started_rounds<Geometric_rounds>, Planned_hints_3>>>(
          "geometric-started", "rounds that grow geometrically, neighbour inserted last before"),
      surface_method<Surface_insertion_policies_3<Full_graph, Geometric_rounds, Neighbor_hints_3>>(
          "geometric-neighbor", "rounds that grow geometrically, nearest inserted neighbour"),
      surface_method<
          By_cgal<Surface_insertion_policies_3<Full_graph, Geometric_rounds, Previous_hint_3>>>(
          "geometric-previous", "rounds that grow geometrically, point inserted before"),
      surface_method<
          Surface_insertion_policies_3<Bounded_degree_subgraph, Geometric_rounds, Traced_hints_3>>(
          "geometric-traced", "rounds that grow geometrically, traces"),
      surface_method<Tracing_traits_3>("tracing-hilbert",
                                       "Tracing_traits_3: the paper's rounds, sorted, and traces"),
      surface_method<meters::Random_tracing_traits>(
          "tracing", "Tracing_traits_3(FIRST_ROUND): the paper's random order and traces"),
      surface_method<In_random_order<Previous_hint_3>>("random-last",
                                                       "random order, point inserted before"),
      surface_method<In_random_order<meters::No_hint_3>>("random-insert",
                                                         "random order, insert(p) of CGAL"),
      surface_method<In_random_order<Hilbert_neighbor_hints>>(
          "random-hilbert", "random order, nearest inserted point along a Hilbert curve"),
      {"random-fast", "random order, insert(p) of CGAL with Fast_location",
       build_by_package<Fast_triangulation, In_random_order<meters::No_hint_3>>, nullptr, nullptr},
  };
}

// Two triangulations of one set of points with exact predicates that agree in all these are hardly
// different; it is what is checked where operator== would take longer than the measurement.
template <class Tr1, class Tr2>
bool have_same_counts(const Tr1& a, const Tr2& b)
{
  return a.number_of_vertices() == b.number_of_vertices() &&
         a.number_of_cells() == b.number_of_cells() &&
         a.number_of_finite_cells() == b.number_of_finite_cells() &&
         a.number_of_finite_facets() == b.number_of_finite_facets() &&
         a.number_of_finite_edges() == b.number_of_finite_edges();
}

class Reference
{
public:
  // Compares with == if the mesh has at most `largest_compared` vertices.
  Reference(const Mesh& mesh, std::size_t largest_compared)
    : m_compares_exactly(mesh.number_of_vertices() <= largest_compared)
  {
    insert_plain(m_plain, mesh);
    m_number_of_tetrahedra = m_plain.number_of_finite_cells();
  }

  template <class Tr>
  bool is_equal(const Tr& tr) const
  {
    return m_compares_exactly ? tr == m_plain : have_same_counts(tr, m_plain);
  }

  const char* how_compared() const
  {
    return m_compares_exactly ? "==" : "numbers of vertices, cells, finite cells, facets and edges";
  }

  std::size_t number_of_tetrahedra() const { return m_number_of_tetrahedra; }

  // One in-sphere test for every facet between two finite cells: whether all are locally Delaunay.
  bool is_locally_delaunay() const
  {
    const auto in_sphere = m_plain.geom_traits().side_of_oriented_sphere_3_object();
    std::size_t violations = 0;
    for (const auto c : m_plain.finite_cell_handles())
      for (int i = 0; i < 4; ++i) {
        const auto d = c->neighbor(i);
        if (d < c && !m_plain.is_infinite(d))
          violations += in_sphere(c->vertex(0)->point(), c->vertex(1)->point(),
                                  c->vertex(2)->point(), c->vertex(3)->point(),
                                  d->vertex(d->index(c))->point()) == CGAL::ON_POSITIVE_SIDE;
      }
    return violations == 0;
  }

private:
  Triangulation m_plain;
  bool m_compares_exactly;
  std::size_t m_number_of_tetrahedra;
};

} // namespace comparison

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_METHODS_H
