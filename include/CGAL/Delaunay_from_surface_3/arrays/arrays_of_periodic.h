// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_ARRAYS_OF_PERIODIC_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_ARRAYS_OF_PERIODIC_H

// Makes the arrays of a periodic triangulation: of all copies of a cell the one whose *first* corner,
// that of the point with the smallest index, is at home; of several copies of this point in the cell,
// the lexicographically smallest is the first.

#include <CGAL/Delaunay_from_surface_3/Periodic_3_arrays.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/arrays/arrays_of_built.h>
#include <CGAL/Delaunay_from_surface_3/core/build_periodic.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Index>
class Cells_of_box
{
  using Numbers = Compact_numbers;
  static constexpr Id none = Id(-1);

public:
  // Of n points. Keeps a reference, and uses the memory up.
  Cells_of_box(Built_in_box& in_box, std::size_t n)
    : m_number_of_points(n)
    , m_corners(in_box.copies)
    , m_number_of_copies(in_box.number_of_copies)
    , m_home(in_box.home)
    , m_built(std::move(in_box.built))
    , m_cells(m_built->cells)
    , m_end(m_built->cells_end)
    , m_has_short_edges(in_box.has_short_edges)
  {
  }

  Periodic_3_arrays<Index> arrays(const Point_array& points, const std::array<double, 3>& box)
  {
    m_built->give_up_vertices();
    name_points();
    number_cells();
    find_far_neighbors();
    move_cells();
    std::vector<Id>().swap(m_numbers);
    m_built->release_cells(m_number, m_end);
    const Memory_of_cells memory = m_built->take_cells();
    Page_array<Compact_cell> cells(memory.cells, memory.capacity);
    m_built.reset(); // with the order
    auto offsets = offsets_of_cells();
    const bool is_simplicial = m_has_short_edges || has_no_double_edges(offsets, points, box);
    const std::size_t copies = m_number_of_copies - m_number_of_points;
    Delaunay_3_arrays<Index> arrays(3, m_number, m_number,
                                    typename Delaunay_3_arrays<Index>::Entries(std::move(cells)),
                                    std::move(m_names));
    return Periodic_3_arrays<Index>(std::move(arrays), std::move(offsets), copies, is_simplicial);
  }

private:
  // A corner of a cell: the name of its point, and the shift from home.
  using Corner = Periodic_copy;
  using Corners = std::array<Corner, 4>;

  static bool is_before(const Corner& c, const Corner& d)
  {
    return c.point != d.point
               ? c.point < d.point
               : std::lexicographical_compare(c.shift, c.shift + 3, d.shift, d.shift + 3);
  }
  static bool are_at_home(const Corners& c)
  {
    return c[0].is_at_home && c[1].is_at_home && c[2].is_at_home && c[3].is_at_home;
  }

  void name_points()
  {
    const std::size_t n = m_number_of_points;
    std::vector<Index> of_vertex(m_built->vertices_end, Index(-1));
    m_names.assign(n, Index(-1));
    std::vector<Id> vertex(n, 0);
    for (std::size_t k = 0; k < m_built->order.size; ++k) {
      const std::size_t i = m_built->order.order[k];
      if (i < n && m_built->vertex_of[k] != 0) {
        vertex[i] = m_built->vertex_of[k];
        Index& name = of_vertex[vertex[i]];
        name = name < 0 ? Index(i) : (std::min)(name, Index(i));
      }
    }
    for (std::size_t i = 0; i < n; ++i)
      if (vertex[i] != 0)
        m_names[i] = of_vertex[vertex[i]];
    for (std::size_t i = 0; i < m_number_of_copies; ++i)
      m_corners[i].point = Id(m_names[m_corners[i].point]);
  }

  const Corner& corner(Id v) const { return m_corners[Numbers::point_of_vertex(v)]; }
  Corners corners(const Compact_cell& c) const
  {
    return {corner(c.v[0]), corner(c.v[1]), corner(c.v[2]), corner(c.v[3])};
  }
  static const Corner& first_of(const Corners& c)
  {
    return *std::min_element(c.begin(), c.end(), is_before);
  }

  // The corners of a facet, moved to where its first one is at home: they are the same for all copies.
  using Facet = std::array<Corner, 3>;
  Facet facet(const Compact_cell& c, unsigned k) const
  {
    Facet f;
    for (std::size_t j = 0; j < 3; ++j)
      f[j] = corner(c.v[facet_corners[k][j]]);
    std::sort(f.begin(), f.end(), is_before);
    const Corner first = f[0];
    for (Corner& corner : f)
      for (std::size_t a = 0; a < 3; ++a)
        corner.shift[a] = std::int16_t(corner.shift[a] - first.shift[a]);
    return f;
  }
  struct Hash
  {
    std::size_t operator()(const Facet& f) const
    {
      std::uint64_t h = 0;
      for (const Corner& corner : f)
        for (const std::uint64_t part :
             {std::uint64_t(corner.point), std::uint64_t(corner.shift[0]),
              std::uint64_t(corner.shift[1]), std::uint64_t(corner.shift[2])}) {
          h = (h ^ part) * 0x9e3779b97f4a7c15;
          h ^= h >> 29;
        }
      return std::size_t(h);
    }
  };
  struct Equal
  {
    bool operator()(const Facet& f, const Facet& g) const
    {
      return std::equal(f.begin(), f.end(), g.begin(), [](const Corner& c, const Corner& d) {
        return c.point == d.point && std::equal(c.shift, c.shift + 3, d.shift);
      });
    }
  };

  void number_cells()
  {
    m_numbers.assign(m_end, none);
    for (std::size_t c = 0; c < m_end; ++c) {
      if (Numbers::is_dead(m_cells[c]) || Numbers::is_infinite(m_cells[c]))
        continue;
      const Corners of = corners(m_cells[c]);
      if (are_at_home(of) || first_of(of).is_at_home)
        m_numbers[c] = Id(m_number++);
    }
  }

  // Facets beyond which there is a copy of a cell that is kept, or none, fit together in pairs. Those
  // that are left lie on the hull. (The copy itself may be wrong if it has no vertex at home.)
  void find_far_neighbors()
  {
    std::unordered_map<Facet, std::size_t, Hash, Equal> open;
    for (std::size_t c = 0; c < m_end; ++c)
      for (unsigned k = 0; m_numbers[c] != none && k < 4; ++k)
        if (m_numbers[m_cells[c].neighbors[k] >> 2] == none) {
          const std::size_t place = 4 * std::size_t(m_numbers[c]) + k;
          const auto [other, is_first] = open.emplace(facet(m_cells[c], k), place);
          if (!is_first) {
            m_far.emplace_back(place, Id(other->second / 4));
            m_far.emplace_back(other->second, Id(place / 4));
            open.erase(other);
          }
        }
    for (const auto& [f, place] : open)
      m_far.emplace_back(place, none);
    std::sort(m_far.begin(), m_far.end());
  }

  // Moves the cells to their numbers.
  void move_cells()
  {
    std::size_t far = 0;
    for (std::size_t c = 0; c < m_end; ++c) {
      if (m_numbers[c] == none)
        continue;
      const std::size_t number = m_numbers[c];
      Compact_cell cell = m_cells[c];
      for (unsigned k = 0; k < 4; ++k) {
        cell.neighbors[k] = m_numbers[cell.neighbors[k] >> 2];
        if (far < m_far.size() && m_far[far].first == 4 * number + k)
          cell.neighbors[k] = m_far[far++].second;
      }
      m_cells[number] = cell;
    }
  }

  using Offset = typename Periodic_3_arrays<Index>::Offset;
  using Offsets = std::vector<std::array<Offset, 4>>;

  // Replaces the vertices of cells by points, and returns the offsets of these.
  Offsets offsets_of_cells()
  {
    Offsets offsets(m_number);
    for (std::size_t c = 0; c < m_number; ++c) {
      const Corners of = corners(m_cells[c]);
      if (m_home != nullptr || !are_at_home(of)) {
        const auto from = offset(first_of(of));
        std::array<std::int32_t, 3> least = from, most = from;
        for (std::size_t k = 0; k < 4; ++k) {
          const auto to = offset(of[k]);
          for (std::size_t a = 0; a < 3; ++a) {
            least[a] = (std::min)(least[a], to[a]);
            most[a] = (std::max)(most[a], to[a]);
            if (most[a] - least[a] > (std::numeric_limits<std::int16_t>::max)())
              throw Surface_input_error(
                  "corners of a tetrahedron of points " + std::to_string(first_of(of).point) +
                  " and " + std::to_string(of[k].point) +
                  " are too many periods apart: wrap the points into the box first");
            offsets[c][k][a] = std::int16_t(to[a] - from[a]);
          }
        }
      }
      for (std::size_t k = 0; k < 4; ++k)
        m_cells[c].v[k] = of[k].point;
    }
    return offsets;
  }
  // From the user's point.
  std::array<std::int32_t, 3> offset(const Corner& c) const
  {
    std::array<std::int32_t, 3> t = {c.shift[0], c.shift[1], c.shift[2]};
    for (std::size_t a = 0; a < 3 && m_home != nullptr; ++a)
      t[a] += m_home[c.point][a];
    return t;
  }

  // Returns true if no edge joins a point to itself, and no two have the same ends. Of two such edges one
  // is at least half as long as a period; so only points at long edges can have two.
  bool has_no_double_edges(const Offsets& offsets, const Point_array& points,
                           const std::array<double, 3>& box) const
  {
    const double half = .49 * *std::min_element(box.begin(), box.end());
    const auto visit_edges = [&](const auto& visit) {
      for (std::size_t c = 0; c < m_number; ++c)
        for (unsigned j = 0; j < 4; ++j)
          for (unsigned k = 0; k < j; ++k) {
            const bool is_ordered = m_cells[c].v[j] < m_cells[c].v[k];
            const unsigned from = is_ordered ? j : k, to = is_ordered ? k : j;
            Offset offset;
            for (std::size_t a = 0; a < 3; ++a)
              offset[a] = std::int16_t(offsets[c][to][a] - offsets[c][from][a]);
            visit(m_cells[c].v[from], m_cells[c].v[to], offset);
          }
    };
    std::vector<bool> is_at_long_edge(m_number_of_points);
    bool has_loop = false;
    visit_edges([&](Id p, Id q, const Offset& offset) {
      double square = 0;
      for (std::size_t a = 0; a < 3; ++a) {
        const double moved = offset[a] == 0 ? 0 : offset[a] * box[a];
        square += std::pow((points[q][a] - points[p][a] + moved) / half, 2);
      }
      has_loop = has_loop || p == q;
      if (!(square < 1))
        is_at_long_edge[p] = is_at_long_edge[q] = true;
    });
    std::map<std::array<Id, 2>, Offset> edges;
    bool has_double_edge = false;
    visit_edges([&](Id p, Id q, const Offset& offset) {
      if (!has_loop && is_at_long_edge[p] && is_at_long_edge[q])
        has_double_edge |= edges.insert({{p, q}, offset}).first->second != offset;
    });
    return !has_loop && !has_double_edge;
  }

  const std::size_t m_number_of_points;
  Corner* const m_corners; // by vertex; copies, until points are named
  const std::size_t m_number_of_copies;
  const std::array<std::int32_t, 3>* const m_home; // null if nothing is moved
  std::unique_ptr<Built> m_built;
  Compact_cell* m_cells;
  const std::size_t m_end;
  std::vector<Index> m_names;                    // the smallest index of a point equal to each
  std::vector<Id> m_numbers;                     // by cell
  std::size_t m_number = 0;                      // of cells that are kept
  std::vector<std::pair<std::size_t, Id>> m_far; // neighbours that are copies, by place
  const bool m_has_short_edges;
};

// Makes the arrays of what was built, which is used up; empty after a stop.
template <class Index>
Periodic_3_arrays<Index> arrays_of_box(Built_in_box& in_box, const Point_array& points,
                                       const std::array<double, 3>& box)
{
  const Built& built = *in_box.built;
  if (built.outcome == Insertion_outcome::TOO_MANY_CELLS)
    throw Too_many_cells();
  if (built.outcome == Insertion_outcome::STOPPED || points.size() == 0)
    return {};
  if (built.outcome == Insertion_outcome::FLAT)
    throw Surface_input_error("box: the points lie in a plane or on a line that is parallel to all "
                              "axes with periods: they have no tetrahedra");
  return Cells_of_box<Index>(in_box, points.size()).arrays(points, box);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ARRAYS_ARRAYS_OF_PERIODIC_H
