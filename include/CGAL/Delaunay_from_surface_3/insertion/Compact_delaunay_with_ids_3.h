// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INSERTION_COMPACT_DELAUNAY_WITH_IDS_3_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSERTION_COMPACT_DELAUNAY_WITH_IDS_3_H

// Choi 2002, Fig. 1, lines 2b and 2c, on numbered cells of 32 bytes; the result is written into the
// user's triangulation at the end.
//
// Invariant: between insertions the cells are the (perturbed) Delaunay triangulation of the points
// inserted. Cost: that of the conflict zones, as with CGAL's insertion; the export is linear.

#include <CGAL/Delaunay_from_surface_3/Insertion_counts.h>
#include <CGAL/Delaunay_from_surface_3/insertion/insert_one_by_one.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_triangulation.h>
#include <CGAL/Delaunay_from_surface_3/internal/compact/Scaled_points.h>
#include <CGAL/Delaunay_from_surface_3/internal/compact/export_complex.h>
#include <CGAL/Delaunay_from_surface_3/internal/compact/has_predicates_of_kernel.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/is_delaunay.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/starting_simplex.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Parallel_triangulation.h>
#include <CGAL/Delaunay_from_surface_3/internal/parallel/Tbb_executor.h>
#include <CGAL/Delaunay_from_surface_3/support/blocks.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Insertion

inserts points into a compact triangulation of its own and writes that into the user's empty
triangulation when it is finished; any vertex and cell base will do. The result equals that of
CGAL's own insertion on every input: signs that floating point cannot certify come from integers
that are as wide as need be, and CGAL's symbolic perturbation.

It serves geometric traits with exact predicates, such as
`Exact_predicates_inexact_constructions_kernel`, `Exact_predicates_exact_constructions_kernel` and
`Filtered_kernel<Simple_cartesian<float>>`, if all coordinates are doubles; empty triangulations;
points that do not all lie in one plane: see `obstacle()`. The rounding mode must be to nearest, also
to denormal numbers. If the compiler is free to change operations, as by `-ffast-math`, integers
decide everything, which takes long.

Memory while it inserts: 32 bytes per cell and 36 per point if an `Id` has 32 bits, and twice as
much if it has 64. The export gives the cells back as it goes.

\tparam Triangulation a `CGAL::Delaunay_triangulation_3`
\tparam Id an unsigned integer type for the numbers of vertices and cells: there can be
\f$2^{b-2}\f$ cells for b bits. A constructor or an insertion that needs more throws a
`std::length_error`; `Wider_target` can take the work over from the beginning.
\tparam Executor runs the threads that insert; by default there is one. See `Parallel_target`.

\cgalModels{InsertionTarget_3}
*/
template <class Triangulation, class Id, class Executor = internal::Alone>
class Compact_delaunay_with_ids_3
{
  using Geom_traits = typename Triangulation::Geom_traits;
  using Complex = internal::Compact_complex<Id>;
  static constexpr bool is_parallel = !std::is_base_of<internal::Alone, Executor>::value;
  using Kernel = std::conditional_t<is_parallel, internal::Parallel_triangulation<Id, Executor>,
                                    internal::Compact_triangulation<Id>>;

public:
  using Point = typename Triangulation::Point;     ///< the points inserted.
  using Vertex = Id;                               ///< the number of a vertex; `Vertex()`: none.
  using Cell = Id;                                 ///< the number of a cell.
  using Location = internal::Compact_location<Id>; ///< a cell in conflict with the point.
  using Threads = Executor;                        ///< what runs the threads that insert.

  /// the same with ids of twice as many bits, or `void` if those here have 64.
  using Wider_target = std::conditional_t<
      sizeof(Id) == 8, void,
      Compact_delaunay_with_ids_3<Triangulation,
                                  std::conditional_t<sizeof(Id) == 4, std::uint64_t, std::uint32_t>,
                                  Executor>>;

  /// the same for many threads; `void` without TBB.
  using Parallel_target = std::conditional_t<
      std::is_void<internal::Parallel_executor>::value, void,
      Compact_delaunay_with_ids_3<Triangulation, Id, internal::Parallel_executor>>;

  /// `false`: `obstacle()` is to be asked.
  static constexpr bool serves_everything = false;

  /// returns whether the numbers and predicates of the geometric traits can be served. Traits that
  /// bring predicates of their own are not: the filters here would go past them.
  static constexpr bool serves_geom_traits()
  {
    return std::is_same<typename Geom_traits::Point_3, Point>::value &&
           internal::has_predicates_of_kernel<Geom_traits,
                                              typename Kernel_traits<Point>::Kernel>() &&
           internal::has_exact_predicates<Geom_traits>();
  }

  /// is to insert `points` into `tr`; keeps references to both. If nothing stands against it, four
  /// of the points that do not lie in one plane are inserted at once. Linear.
  Compact_delaunay_with_ids_3(Triangulation& tr, const std::vector<Point>& points,
                              const Executor& executor = Executor())
    : m_tr(tr)
    , m_points(points)
    , m_scaled_points(points)
    , m_obstacle(obstacle_of_input())
    , m_complex(m_obstacle ? 0 : points.size(), m_scaled_points)
    , m_executor(executor)
    , m_kernel(m_complex, m_executor)
    , m_vertices(points.size(), Vertex())
  {
    if (!m_obstacle) {
      m_complex.keep_own_coordinates(m_scaled_points.own_coordinates());
      m_any_vertex = internal::start_complex(m_complex, m_vertices);
    }
    if (!m_obstacle && m_any_vertex == Vertex())
      m_obstacle = "the points lie in one plane";
  }

  /// returns why the points cannot be inserted this way; nothing if they can.
  const std::optional<std::string>& obstacle() const { return m_obstacle; }

  /// returns the number of points.
  std::size_t size() const { return m_vertices.size(); }

  /// returns the vertex at point `i`; none if the point is not inserted yet.
  Vertex vertex(std::size_t i) const { return internal::load_relaxed(m_vertices[i]); }

  /// returns a cell of `v`, or any cell if `v` is none.
  Cell cell(Vertex v) const
  {
    return internal::load_relaxed(m_complex.vertex(v != Vertex() ? v : m_any_vertex).cell);
  }

  /// finds a cell in conflict with point `i` by a walk from `start`, or the vertex at its place.
  Location locate(std::size_t i, Cell start)
  {
    return m_vertices[i] != Vertex() ? Location{start, m_vertices[i]}
                                     : m_kernel.locate(Complex::vertex_of_point(i), start);
  }

  /// does the same, and is not counted.
  Location locate(std::size_t i, Cell start) const
  {
    return m_vertices[i] != Vertex() ? Location{start, m_vertices[i]}
                                     : m_kernel.locate(Complex::vertex_of_point(i), start);
  }

  /// returns a vertex of the located cell that is nearest to point `i` up to rounding; finite.
  Vertex nearest_vertex(std::size_t i, const Location& location) const
  {
    if (location.vertex != Vertex())
      return location.vertex;
    return internal::nearest_vertex_of_cell(m_complex, Complex::vertex_of_point(i), location.cell);
  }

  /// returns whether `v` is closer to point `i` than `w`, up to rounding.
  bool is_closer(std::size_t i, Vertex v, Vertex w) const
  {
    return internal::is_closer(m_complex, Complex::vertex_of_point(i), v, w);
  }

  /// inserts point `i` where it was just located, and tells `observer` (a model of
  /// `UpdateObserver_3`). A point that is there already gets the vertex that is there.
  template <class Observer>
  void insert(std::size_t i, const Location& location, Observer& observer)
  {
    const auto insert_at = [this](const auto&... where) { return m_kernel.insert(where...); };
    insert_by(i, location, observer, insert_at);
  }

  /// does the same if `accepts(j, q)` says so of the vertex nearest to point `i`: that of point j,
  /// which is q; else tells `observer` of that one. Nothing is asked if a vertex is at point `i`.
  template <class Observer, class Accepts>
  void insert_if(std::size_t i, const Location& location, Observer& observer,
                 const Accepts& accepts)
  {
    const auto accepts_point = [&](std::size_t j) { return accepts(j, m_points[j]); };
    insert_by(i, location, observer, [&](Id p, Id cell, const auto& before) {
      return m_kernel.insert_if(p, cell, before, [&](Id nearest) {
        return accepts_point(Complex::point_of_vertex(nearest));
      });
    });
  }

  /// returns how many threads may insert at the same time.
  std::size_t number_of_threads() const { return m_kernel.number_of_workers(); }

  /// returns how many points a call of `insert_round()` should have at once, at least, when so many
  /// are inserted: for many threads enough to be worth their start.
  std::size_t size_of_piece(std::size_t inserted) const { return m_kernel.size_of_piece(inserted); }

  /// inserts the points `first`, …, `last - 1`: one after the other, or by several threads. Then
  /// each thread has a copy of `hints`, and of the visitor only `go_further()` is called, in the
  /// thread that called this.
  template <class Hints, class Visitor>
  bool insert_round(std::size_t first, std::size_t last, Hints& hints, Visitor& visitor)
  {
    if constexpr (is_parallel)
      return m_kernel.insert_round(first, last, m_vertices, hints,
                                   [&] { return visitor.go_further(); });
    else
      return insert_one_by_one(*this, first, last, hints, visitor);
  }

  /// is to create the user's vertices in the order in which `order` first names them, a permutation
  /// of 0, …, n-1, of which a reference is kept. Without it they come in the order of insertion.
  void create_vertices_in_order(const std::vector<std::size_t>& order) { m_order = &order; }

  /// writes the triangulation into the user's.
  void finish()
  {
    using namespace Delaunay_from_surface_3::internal;
    finish_insertions();
    const auto point = [this](std::size_t v) -> const Point* {
      const std::size_t i = Complex::point_of_vertex(v);
      return m_vertices[i] == v ? &m_points[i] : nullptr;
    };
    m_handles = export_complex(m_tr, m_complex, point, Creation_order<Vertex>{m_order, m_vertices},
                               m_executor);
    fill_upper_levels(m_tr, m_handles);
    m_handles.front() = {}; // points that were left out have no vertex, nor that at infinity
  }

  /// gives the vertices of the points away, none if the work was not finished; to be called last.
  std::vector<typename Triangulation::Vertex_handle> take_vertices()
  {
    std::vector<typename Triangulation::Vertex_handle> handles(m_points.size());
    if (!m_handles.empty())
      for (std::size_t i = 0; i < handles.size(); ++i)
        handles[i] = m_handles[m_vertices[i]];
    return handles;
  }

  /// returns what the insertions did.
  Insertion_counts counts() const { return m_kernel.counts(); }

protected:
  /// \cond
  // For a target that hands the cells over in another way. It may give up the points that were to
  // be inserted once it is constructed: their coordinates are in the complex.
  Complex& complex() { return m_complex; }

  // To be called before that.
  void finish_insertions()
  {
    m_kernel.finish();
    CGAL_expensive_postcondition(internal::is_delaunay(m_complex));
  }
  /// \endcond

private:
  template <class Observer, class Insert>
  void insert_by(std::size_t i, const Location& location, Observer& observer,
                 const Insert& insert_at)
  {
    const Id p = location.vertex != Vertex() ? location.vertex : Complex::vertex_of_point(i);
    const auto before = [&](const Id* first, const Id* last) {
      if constexpr (Observer::observes_conflict_zone)
        observer.before_update(i, first, last);
    };
    const Id v = location.vertex != Vertex() ? p : insert_at(p, location.cell, before);
    m_vertices[i] = v == p ? p : Vertex();
    observer.after_update(i, v);
  }

  std::optional<std::string> obstacle_of_input() const
  {
    if (m_tr.number_of_vertices() > 0)
      return "the triangulation is not empty";
    return m_scaled_points.obstacle();
  }

  Triangulation& m_tr;
  const std::vector<Point>& m_points;
  internal::Scaled_points<Point> m_scaled_points;
  std::optional<std::string> m_obstacle;
  Complex m_complex;
  Executor m_executor;
  Kernel m_kernel;
  std::vector<Vertex> m_vertices;
  Vertex m_any_vertex = Vertex(); // where no other is known
  std::vector<typename Triangulation::Vertex_handle> m_handles;
  const std::vector<std::size_t>* m_order = nullptr;
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INSERTION_COMPACT_DELAUNAY_WITH_IDS_3_H
