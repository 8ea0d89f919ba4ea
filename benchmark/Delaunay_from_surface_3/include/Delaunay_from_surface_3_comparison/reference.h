// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_REFERENCE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_REFERENCE_H

// Plain CGAL's triangulation of a surface: what the others must equal, and what is verified.

#include <Delaunay_from_surface_3_comparison/triangulations.h>

#include <CGAL/enum.h>

#include <cstddef>

namespace comparison {

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

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_REFERENCE_H
