// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_ARRAYS_OF_TRIANGULATION_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_ARRAYS_OF_TRIANGULATION_H

// The arrays of a CGAL triangulation, of any dimension. Expected linear time: handles are hashed.

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>

#include <boost/unordered_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

// Changes the order of a cell's entries such that entry k of d + 1 comes last, but the orientation
// stays.
template <class Entry>
void rotate_to_end(std::array<Entry, 4>& entries, int k, int dimension)
{
  if (k == dimension)
    return;
  std::swap(entries[std::size_t(k)], entries[std::size_t(dimension)]);
  if (dimension > 1) { // two before it, too, so that the permutation is even
    const std::size_t i = k == 0 ? 1 : 0,
                      j = dimension == 2 ? std::size_t(k) : 3 - std::size_t(k) - i;
    std::swap(entries[i], entries[j]);
  }
}

// Calls f with every cell of a triangulation of any dimension, infinite ones included. Below
// dimension 3 its iterator of cells is empty: there cells are facets, edges, or vertices.
template <class Triangulation, class F>
void for_each_cell(const Triangulation& tr, const F& f)
{
  if (tr.dimension() == 3)
    for (auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c)
      f(typename Triangulation::Cell_handle(c));
  else if (tr.dimension() == 2)
    for (auto facet = tr.all_facets_begin(); facet != tr.all_facets_end(); ++facet)
      f(facet->first);
  else if (tr.dimension() == 1)
    for (auto edge = tr.all_edges_begin(); edge != tr.all_edges_end(); ++edge)
      f(edge->first);
  else
    for (auto v = tr.all_vertices_begin(); v != tr.all_vertices_end(); ++v)
      f(v->cell());
}

// The numbers of a triangulation's vertices and cells.
template <class Triangulation, class Index>
class Numbered_triangulation
{
  using Vertex_handle = typename Triangulation::Vertex_handle;
  using Cell_handle = typename Triangulation::Cell_handle;
  using Arrays = CGAL::Delaunay_3_arrays<Index>;

public:
  // `vertices` has the vertices of all points.
  Numbered_triangulation(const Triangulation& tr, const std::vector<Vertex_handle>& vertices,
                         bool has_neighbors)
    : m_tr(tr)
    , m_vertices(vertices)
  {
    m_vertex_numbers.reserve(tr.number_of_vertices() + 1);
    m_vertex_numbers.emplace(tr.infinite_vertex(), Arrays::none);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      m_vertex_numbers.emplace(vertices[i], Index(i)); // unless an equal point has one
    for (const bool is_infinite : {false, true}) {
      for_each_cell(tr, [&](Cell_handle c) {
        if (has_infinite_vertex(c) == is_infinite)
          m_cells.push_back(c);
      });
      m_number_of_simplices = is_infinite ? m_number_of_simplices : m_cells.size();
    }
    m_cell_numbers.reserve(has_neighbors ? m_cells.size() : 0);
    for (std::size_t c = 0; has_neighbors && c < m_cells.size(); ++c)
      m_cell_numbers.emplace(m_cells[c], Index(c));
  }

  Arrays arrays() const
  {
    typename Arrays::Entries cells;
    cells.allocate(8 * m_cells.size());
    for (std::size_t c = 0; c < m_cells.size(); ++c)
      write_cell(m_cells[c], cells.data() + 8 * c);
    std::vector<Index> vertices_of_points(m_vertices.size());
    for (std::size_t i = 0; i < m_vertices.size(); ++i)
      vertices_of_points[i] = m_vertex_numbers.at(m_vertices[i]);
    return Arrays(m_tr.dimension(), m_number_of_simplices, m_cells.size(), std::move(cells),
                  std::move(vertices_of_points));
  }

private:
  bool has_infinite_vertex(Cell_handle c) const
  {
    for (int i = 0; i <= m_tr.dimension(); ++i)
      if (m_tr.is_infinite(c->vertex(i)))
        return true;
    return false;
  }

  void write_cell(Cell_handle c, Index* out) const
  {
    const int d = m_tr.dimension();
    std::array<std::pair<Index, Index>, 4> entries; // a vertex and the neighbour opposite to it
    entries.fill({Arrays::none, Arrays::none});
    for (int i = 0; i <= d; ++i)
      entries[std::size_t(i)] = {m_vertex_numbers.at(c->vertex(i)),
                                 m_cell_numbers.empty() ? Arrays::none
                                                        : m_cell_numbers.at(c->neighbor(i))};
    if (has_infinite_vertex(c))
      rotate_to_end(entries, c->index(m_tr.infinite_vertex()), d);
    for (std::size_t i = 0; i < 4; ++i) {
      out[i] = entries[i].first;
      out[4 + i] = entries[i].second;
    }
  }

  const Triangulation& m_tr;
  const std::vector<Vertex_handle>& m_vertices;
  boost::unordered_map<Vertex_handle, Index> m_vertex_numbers;
  std::vector<Cell_handle> m_cells;
  std::size_t m_number_of_simplices = 0;
  boost::unordered_map<Cell_handle, Index> m_cell_numbers;
};

// Returns the arrays; vertices[i] is the vertex of point i. Neighbours take most of the time, and
// can be left out.
template <class Index, class Triangulation>
CGAL::Delaunay_3_arrays<Index>
arrays_of_triangulation(const Triangulation& tr,
                        const std::vector<typename Triangulation::Vertex_handle>& vertices,
                        bool has_neighbors = true)
{
  CGAL::Delaunay_3_arrays<Index> arrays;
  if (!vertices.empty())
    arrays = Numbered_triangulation<Triangulation, Index>(tr, vertices, has_neighbors).arrays();
  if (!has_neighbors)
    arrays.drop_neighbors();
  return arrays;
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_ARRAYS_OF_TRIANGULATION_H
