// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_BUILT_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_BUILT_H

// A cell and a vertex as numbers. A cell is 32 bytes, half a cache line.
//
// One vertex, one number: that of the i-th point in the order of insertion is i + 1; 0 is the
// infinite vertex.
//
// Invariants: vertices of a cell are in positive orientation (with the infinite vertex in the place
// of a point beyond the hull); the infinite vertex is only ever the last of a cell. A link names a
// neighbour and, in its two lowest bits, which of the neighbour's facets is shared: 4 · cell +
// facet, as in TetGen's and HXT's meshes (Si 2015; Marot, Pellerin, Remacle 2019). A cell that is
// destroyed is `dead`, and so is one that is not in use; that mark is the highest bit of its first
// vertex.

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_counts.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE {

// Numbers of cells and vertices.
using Id = std::uint32_t;

struct Compact_cell
{
  Id v[4];
  Id links[4];
};

// `label` belongs to the insertion under way (Fill_star.h). It lies here, in bytes that alignment
// would leave empty, beside the coordinates that were just read. In an array of its own, as many
// threads need it (Explore_announced.h), it takes longer.
struct alignas(32) Compact_vertex
{
  double coordinates[3];
  Id cell; // any cell of the vertex
  Id label;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE

inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The corners of facet i, such that (p, corners) is positive for p on the inner side, and the
// infinite vertex stays the last.
inline constexpr unsigned char facet_corners[4][3] = {{1, 2, 3}, {2, 0, 3}, {0, 1, 3}, {2, 1, 0}};

// What the numbers say.
struct Compact_numbers
{
  static constexpr Id infinite = 0;
  static constexpr Id dead = Id(1) << 31; // of v[0]
  static constexpr std::size_t max_vertices = dead, max_cells = std::size_t(1) << 30;

  static Id vertex_of_point(std::size_t i) { return Id(i + 1); }
  static std::size_t point_of_vertex(std::size_t v) { return v - 1; }

  static bool is_dead(const Compact_cell& c) { return (c.v[0] & dead) != 0; }
  static Id first_vertex(const Compact_cell& c) { return Id(c.v[0] & Id(~dead)); }
  static bool is_infinite(const Compact_cell& c) { return c.v[3] == infinite; }
  static Id link(Id cell, unsigned facet) { return Id(Id(cell << 2) | facet); }

  // cells[link >> 2]; of a cell of 32 bytes the number times 4 is the address divided by 8, which
  // saves an operation.
  template <class Cell>
  static Cell& cell_of_link(Cell* cells, Id link)
  {
    using Byte = std::conditional_t<std::is_const<Cell>::value, const char, char>;
    return *reinterpret_cast<Cell*>(reinterpret_cast<Byte*>(cells) +
                                    std::size_t(link & Id(~Id(3))) * (sizeof(Cell) / 4));
  }
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM

inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE {

// An order of insertion owned elsewhere: see Insertion_order.
struct Order_view
{
  const std::size_t* order;
  std::size_t size;
  const std::size_t* round_ends;
  std::size_t number_of_rounds;
  const std::size_t* starting_places; // null if there are none
};

enum class Insertion_outcome {
  COMPLETE,
  STOPPED,       // by the watcher
  OVER_BUDGET,   // never returned: another order follows
  FLAT,          // nothing is inserted: the points lie in one plane
  TOO_MANY_CELLS // for numbers of 32 bits
};

// What build() makes: a complex, in memory of the core, which can give it up piece by piece while
// it is read once.
//
// One vertex, one number: the point at place k of the order is vertex k + 1.
class Built
{
public:
  virtual ~Built() = default;

  // The cells first, …, last - 1 are not read any more; none of the cells; none of the vertices.
  virtual void release_cells(std::size_t first, std::size_t last) = 0;
  virtual void give_up_cells() = 0;
  virtual void give_up_vertices() = 0;

  // The memory of the cells is the caller's from now on, that of a Page_array with such a capacity.
  virtual Compact_cell* take_cells(std::size_t& capacity) = 0;

  // Returns any cell of vertex v.
  virtual Id cell_of(std::size_t v) const = 0;

  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE bool has_started() const { return cells_end > 0; }

  Insertion_outcome outcome = Insertion_outcome::FLAT;
  int dimension = -1;    // of the points
  bool has_apex = false; // as the last vertex, off the plane of all others
  Insertion_counts counts;

  Order_view order = {nullptr, 0, nullptr, 0, nullptr};
  const Id* vertex_of = nullptr; // by place: 0 if there is none; that of an apex is the last
  std::size_t number_of_places = 0;
  Compact_cell* cells = nullptr;
  std::size_t cells_end = 0;    // dead ones too
  std::size_t vertices_end = 0; // 0 and unused ones too
};

// How many cells an order of the core may destroy for each point, before random rounds take its place.
constexpr std::size_t cells_per_point_of_core = 64;

// The order in which points are to be inserted.
struct Order_request
{
  // Not "= default", which may be a function of its own.
  // NOLINTNEXTLINE(modernize-use-equals-default)
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE Order_request() {}

  // Spaced rounds, or random rounds, which take their place when the budget is exceeded.
  enum Kind { SPACED, GEOMETRIC } kind = SPACED;

  // Of random rounds: 0 < ratio < 1, first_round > 0.
  unsigned int seed = 0;
  double ratio = 0.125;
  std::size_t first_round = 64;
};

// Where the order of insertion comes from: from the points, or from a caller's own plan. It is asked
// when it is needed, and need not do anything before.
class Order_source
{
public:
  virtual ~Order_source() = default;

  // Of the points, by as many threads as it can use. What is returned is valid until the next call
  // of make() or go_on().
  virtual Order_view make(const Point_array& points, const Executor& executor) = 0;

  // What that order may cost: the number of destroyed cells per point (Insertion_budget), or any
  // number.
  static constexpr std::size_t any_number = std::size_t(-1);
  virtual std::size_t cells_per_point() const = 0;

  // Whether the first points are spread over all at any time, so that of the cells which are then many
  // most must stay. Nothing is known of a caller's own plan, which may begin with hubs.
  virtual bool is_spread() const { return false; }

  // Goes on to the order that takes its place if that was exceeded; false if there is none, as there
  // may be where there is no budget.
  virtual bool go_on() = 0;
};

// Is told what the core does, and can stop it. All functions are called by the thread that called
// the core.
class Watcher
{
public:
  virtual ~Watcher() = default;

  virtual void phase_begins(Surface_insertion_phase) {}
  virtual void order_is_replaced(const char* /* reason */) {}
  virtual void insertion_begins(std::size_t /* number_of_threads */) {}
  virtual void round_begins(std::size_t /* round */, std::size_t /* number_of_points */) {}
  virtual void insertion_ends(const Insertion_counts&) {}

  // Is asked every 256 points, with the number inserted so far; `false` stops the work.
  virtual bool go_further(std::size_t /* inserted */) { return true; }

  // Whether it is told of the phases LOCATION and UPDATE, point by point. Not with many threads.
  virtual bool follows_points() const { return false; }
};

// Who inserts.
struct One_thread;
struct Many_threads;

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE

inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The header of each crew names the class.
template <class Crew>
struct Inserter_of;

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_BUILT_H
