// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_PERIODIC_PERIODIC_TRIANGULATION_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_PERIODIC_PERIODIC_TRIANGULATION_H

// Triangulates points in a periodic box, their *home*, and as many of their copies around as determine
// the stars of the points at home. The box may lack periods, as in slabs and wires.
//
// Copies are added until each cell with a vertex at home is certain. A finite cell is, if no copy of a
// point that is not inserted touches its ball. An infinite cell is, if the copies of each of
// its vertices at home by one period to either side, along each axis, are inserted: its plane supports
// these, too, so it is parallel to the periods, and all copies of all points lie on its inner side. When
// all are certain, the star of each point at home is that in the triangulation of all copies.
//
// Copies farther than K = D / L + 1 periods L need not be looked at, where D is the length of the vector
// of all periods. Let v be a vertex at home, c the centre of a cell's ball, both without their
// coordinates along axes that have no period, and let a copy of a point q touch the ball. Every point
// has a copy within D / 2 of any place. If |v - c| <= D / 2, a copy of q within D / 2 of c touches the
// ball, too, since it is no farther from c, and is within D of v. Else a copy of v within D / 2 of the
// place at this distance from v, towards c, is within D of v, and in the ball.

#include <CGAL/Delaunay_from_surface_3/core/build_impl.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Copy_vertex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Fill_star.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Inserter.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Ordered_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/periodic/Box_of_points.h>
#include <CGAL/Delaunay_from_surface_3/core/periodic/Empty_ball.h>
#include <CGAL/Delaunay_from_surface_3/core/periodic/Leaves_of_box.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Box>
class Periodic_triangulation
{
  using Vertex = Copy_vertex<Box::has_weight>;
  using Complex = Compact_complex<Vertex>;
  using Leaf_copy = typename Leaves_of_box<Box>::Copy;

public:
  // Keeps references.
  Periodic_triangulation(const Box& box, Observer& observer, const Executor& executor)
    : m_box(box)
    , m_observer(observer)
    , m_executor(executor)
    , m_leaves(box, Point_array(positions_of(box).data(), box.number_of_points()), executor)
  {
  }

  template <template <class> class Insert>
  Built_in_box build(const Build_options& options)
  {
    Built_in_box result;
    result.built = begin<Insert>(options);
    m_built = static_cast<Ordered_complex<Vertex>*>(result.built.get());
    if (m_built->has_started() && m_built->outcome == Insertion_outcome::COMPLETE)
      complete();
    if (m_built->has_started() && m_built->outcome == Insertion_outcome::COMPLETE) {
      auto memory = std::make_unique<Memory>();
      memory->copies = std::move(complex().all_own_coordinates().copies);
      for (Periodic_copy& c : memory->copies)
        for (std::size_t a = 0; a < 3; ++a)
          c.shift[a] = std::int16_t(c.shift[a] - m_box.home(c.point)[a]);
      memory->home = m_box.home_from_user();
      result.copies = memory->copies.data();
      result.number_of_copies = memory->copies.size();
      result.home = memory->home.empty() ? nullptr : memory->home.data();
      result.memory = std::move(memory);
      result.has_short_edges = 4 * m_largest_radius < m_box.shortest_period();
    }
    return result;
  }

private:
  struct Memory final : Built_in_box::Memory
  {
    std::vector<Periodic_copy> copies;
    std::vector<std::array<std::int32_t, 3>> home;
  };

  // Inserts the points and a layer of copies around.
  template <template <class> class Insert>
  std::unique_ptr<Built> begin(const Build_options& options)
  {
    Source_of_copies<Box> source(m_box);
    for (std::size_t i = 0; i < m_box.number_of_points(); ++i)
      source.add(i, Shift{0, 0, 0});
    Leaf_copy neighbor = {};
    while (m_box.number_of_points() > 0 && m_leaves.lacks_neighbor(0, neighbor))
      m_leaves.request(neighbor); // so that few points span the space
    m_leaves.request_layer();
    for (const Leaf_copy& copy : m_leaves.take_requested())
      m_leaves.visit_points(copy.leaf, [&](std::size_t i) { source.add(i, copy.shift); });
    return build_by<Vertex, Insert>(source, options, m_observer, m_executor);
  }

  static std::vector<double> positions_of(const Box& box)
  {
    std::vector<double> positions;
    positions.reserve(3 * box.number_of_points());
    for (std::size_t i = 0; i < box.number_of_points(); ++i) {
      const auto p = box.position(i, box.home(i));
      positions.insert(positions.end(), p.begin(), p.end());
    }
    return positions;
  }

  Complex& complex() { return m_built->complex; }
  const Complex& complex() const { return m_built->complex; }
  const Periodic_copy& copy_of(Id v) const
  {
    return complex().all_own_coordinates().copies[Complex::point_of_vertex(v)];
  }
  bool is_at_home(Id v) const { return v != Complex::infinite && copy_of(v).is_at_home; }

  // Inserts copies until all cells with vertices at home are certain.
  void complete()
  {
    leave_out_points();
    m_leaves.find_safe_depths();
    std::vector<Id> open;
    bool is_certain = request_for(
        complex().cells_end(), [](std::size_t c) { return Id(c); }, open);
    Write_alone<Vertex>::forget_labels(complex()); // of another inserter
    Inserter<Alone_with_complex<Vertex>> inserter(complex());
    std::size_t asked = number_of_vertices();
    while (!is_certain) {
      Id last = 0;
      for (const Leaf_copy& copy : m_leaves.take_requested()) {
        if (number_of_vertices() > asked + 256) {
          asked = number_of_vertices();
          if (!m_observer.go_further(asked)) {
            m_built->outcome = Insertion_outcome::STOPPED;
            return;
          }
        }
        m_leaves.visit_points(copy.leaf, [&](std::size_t i) {
          last = insert(inserter, i, copy.shift, nearer(i, copy.shift, last, copy.near), open);
        });
      }
      std::sort(open.begin(), open.end());
      open.erase(std::unique(open.begin(), open.end()), open.end());
      const std::vector<Id> cells = std::exchange(open, {});
      is_certain = request_for(
          cells.size(), [&](std::size_t k) { return cells[k]; }, open);
    }
    m_built->counts += inserter.zone.counts;
    m_observer.insertion_ends(m_built->counts);
    m_observer.phase_begins(Surface_insertion_phase::FINISH, 0);
    if constexpr (Vertex::has_weight)
      leave_out_hidden_vertices(*m_built, false);
    m_built->show();
  }

  std::size_t number_of_vertices() const { return complex().all_own_coordinates().copies.size(); }

  // Leaves out those at home that are equal to another there, or hidden.
  void leave_out_points()
  {
    for (std::size_t k = 0; k < m_built->vertices.size(); ++k) {
      const std::size_t i = m_built->order.order[k];
      const Id v = m_built->vertices[k];
      if (i < m_box.number_of_points() && v != Complex::vertex_of_point(k) &&
          (v == 0 || is_at_home(v)))
        m_leaves.leave_out(i);
    }
  }

  // Returns the vertex that is nearer to a copy of a point: v, unless it is 0, or w.
  Id nearer(std::size_t i, const Shift& shift, Id v, Id w) const
  {
    if (v == 0)
      return w;
    const auto p = m_box.position(m_box.copy(i, shift));
    const double *const q = complex().vertex(v).coordinates, *const r =
                                                                 complex().vertex(w).coordinates;
    double to_v = 0, to_w = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      to_v += (p[a] - q[a]) * (p[a] - q[a]);
      to_w += (p[a] - r[a]) * (p[a] - r[a]);
    }
    return to_v < to_w ? v : w;
  }

  // Inserts a copy of a point, and adds its star to `open`. Returns its vertex, or one near it.
  Id insert(Inserter<Alone_with_complex<Vertex>>& inserter, std::size_t i, const Shift& shift,
            Id near, std::vector<Id>& open)
  {
    const Periodic_copy copy = m_box.copy(i, shift);
    const auto p = m_box.position(copy);
    typename Complex::Coordinates_of_point coordinates;
    std::copy(p.begin(), p.end(), coordinates.begin());
    if constexpr (Vertex::has_weight)
      coordinates[3] = m_box.weight(i);
    const Id v = complex().add_vertex(coordinates);
    complex().all_own_coordinates().copies.push_back(copy);
    Id start = complex().vertex(near).cell;
    if (Vertex::has_weight && Complex::is_dead(complex().cell(start)))
      start = complex().vertex(Complex::infinite).cell;
    const Compact_location location = inserter.walk(v, start, Read_alone());
    if (Vertex::has_weight && location.vertex == v) // hidden
      complex().vertex(v).cell = location.cell;
    if (location.vertex != 0)
      return location.vertex;
    inserter.dig(v, location.cell);
    inserter.fill(v);
    open.insert(open.end(), inserter.zone.cells.begin(),
                inserter.zone.cells.begin() + std::ptrdiff_t(inserter.zone.number_of_cells));
    return v;
  }

  // Requests what the cells cell_of(0), …, cell_of(n - 1) need to be certain; those that need something
  // are added to `open`. Returns true if none does.
  template <class CellOf>
  bool request_for(std::size_t n, const CellOf& cell_of, std::vector<Id>& open)
  {
    struct Needed
    {
      std::vector<Id> cells;
      std::vector<Leaf_copy> copies;
      double largest_radius = 0;
    };
    const std::size_t blocks = number_of_blocks(m_executor, n, 4096);
    std::vector<Needed> needed(blocks);
    for_each_block(m_executor, n, blocks, [&](std::size_t first, std::size_t last, std::size_t b) {
      for (std::size_t k = first; k < last; ++k) {
        Leaf_copy copy;
        if (!is_certain(complex().cell(cell_of(k)), copy, needed[b].largest_radius)) {
          needed[b].cells.push_back(cell_of(k));
          needed[b].copies.push_back(copy);
        }
      }
    });
    for (const Needed& of_block : needed) {
      open.insert(open.end(), of_block.cells.begin(), of_block.cells.end());
      for (const Leaf_copy& copy : of_block.copies)
        m_leaves.request(copy);
      m_largest_radius = (std::max)(m_largest_radius, of_block.largest_radius);
    }
    return open.empty();
  }

  // Returns true if the cell is certain, or has no vertex at home; else a copy that it needs.
  bool is_certain(const Compact_cell& cell, Leaf_copy& copy, double& largest_radius) const
  {
    if (Complex::is_dead(cell))
      return true;
    const Id* const at_home =
        std::find_if(cell.v, cell.v + 4, [this](Id v) { return is_at_home(v); });
    if (at_home == cell.v + 4)
      return true;
    copy.near = *at_home;
    if (Complex::is_infinite(cell))
      return std::all_of(cell.v, cell.v + 3, [&](Id v) {
        return !is_at_home(v) || !m_leaves.lacks_neighbor(copy_of(v).point, copy);
      });
    const auto place = [&](unsigned k) { return complex().place(cell.v[k]); };
    const auto exact = [&](unsigned k) { return complex().exact_place(cell.v[k]); };
    const typename Vertex::Place places[4] = {place(0), place(1), place(2), place(3)};
    const typename Vertex::Exact_place exact_places[4] = {exact(0), exact(1), exact(2), exact(3)};
    const Empty_ball ball(places, exact_places, m_box.rounding());
    largest_radius = (std::max)(largest_radius, ball.radius());
    return (ball.is_known() && m_leaves.is_safe(ball)) ||
           !m_leaves.find_deepest(ball, complex().vertex(*at_home).coordinates, copy);
  }

  const Box& m_box;
  Observer& m_observer;
  const Executor& m_executor;
  Leaves_of_box<Box> m_leaves;
  Ordered_complex<Vertex>* m_built = nullptr;
  double m_largest_radius = 0; // of the cells that were looked at
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_PERIODIC_PERIODIC_TRIANGULATION_H
