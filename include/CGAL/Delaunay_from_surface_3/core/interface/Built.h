// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_BUILT_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_BUILT_H

// These types cross the border of the compiled core: cells and vertices as numbers, the complex
// that build() makes, its order of insertion, and its observer. A cell is half a cache line.
//
// The point at place i of the order of insertion is vertex i + 1; vertex 0 is the infinite one. A
// point with a weight that is in no cell, because others hide it, has the vertex 0.
//
// Invariants: the vertices of a cell are positively oriented, with the infinite vertex in the place
// of a point beyond the hull; the infinite vertex is always the last one of its cell. A neighbour
// is encoded as 4 · cell + facet, where the facet is the shared one as the neighbour numbers it, as
// in TetGen's and HXT's meshes (Si 2015; Marot, Pellerin, Remacle 2019). A cell that is destroyed
// or not in use is `dead`: the highest bit of its first vertex is set.

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_counts.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE {

// Cells and vertices have numbers of this type.
using Id = std::uint32_t;

struct Compact_cell
{
  Id v[4];
  Id neighbors[4];
};

// `label` belongs to the insertion under way (Fill_star.h). It uses bytes that alignment would
// leave empty, beside coordinates that were just read. Labels in an array of their own, which
// several threads need (Explore_announced.h), are slower.
struct alignas(32) Compact_vertex
{
  using Place = const double*; // what predicates know of it (Sphere_filter.h)
  using Exact_place = Place;
  static constexpr bool has_weight = false;
  static constexpr std::size_t size = 3; // of `coordinates`, with a weight

  double coordinates[3];
  Id cell; // any cell of the vertex
  Id label;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE

inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Lists the corners of facet i such that (p, corners) is positive if p is on the inner side. The
// infinite vertex stays the last.
inline constexpr unsigned char facet_corners[4][3] = {{1, 2, 3}, {2, 0, 3}, {0, 1, 3}, {2, 1, 0}};

// Encodes and decodes the numbers.
struct Compact_numbers
{
  static constexpr Id infinite = 0;
  static constexpr Id dead = Id(1) << 31; // a bit of v[0]
  static constexpr std::size_t max_vertices = dead, max_cells = std::size_t(1) << 30;

  static Id vertex_of_point(std::size_t i) { return Id(i + 1); }
  static std::size_t point_of_vertex(std::size_t v) { return v - 1; }

  static bool is_dead(const Compact_cell& c) { return (c.v[0] & dead) != 0; }
  static Id first_vertex(const Compact_cell& c) { return Id(c.v[0] & Id(~dead)); }
  static bool is_infinite(const Compact_cell& c) { return c.v[3] == infinite; }
  static Id encode(Id cell, unsigned facet) { return Id(Id(cell << 2) | facet); }

  // Returns cells[neighbor >> 2]. Without a shift: 8 times 4 · cell is the offset of a cell of 32
  // bytes.
  template <class Cell>
  static Cell& cell_of_neighbor(Cell* cells, Id neighbor)
  {
    using Byte = std::conditional_t<std::is_const<Cell>::value, const char, char>;
    return *reinterpret_cast<Cell*>(reinterpret_cast<Byte*>(cells) +
                                    std::size_t(neighbor & Id(~Id(3))) * (sizeof(Cell) / 4));
  }
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM

inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE {

// A copy of a point in a periodic box, moved by so many periods.
struct Periodic_copy
{
  Id point;
  std::int16_t shift[3];
  bool is_at_home; // it is the point itself
};

// Refers to an order of insertion that is owned elsewhere (see Insertion_order).
struct Order_view
{
  const std::size_t* order;
  std::size_t size;
  const std::size_t* round_ends;
  std::size_t number_of_rounds;
  const std::size_t* starting_places; // null if the order names no such places
};

enum class Insertion_outcome {
  COMPLETE,
  STOPPED,       // by the observer
  OVER_BUDGET,   // the given order costs too much
  FLAT,          // nothing is inserted: the points lie in one plane
  TOO_MANY_CELLS // for numbers of 32 bits
};

struct Memory_of_cells
{
  Compact_cell* cells;
  std::size_t capacity;
};

// Holds the complex that build() makes, in the core's memory, which the caller can release step by
// step while it reads the cells once.
//
// The point at place k of the order is vertex k + 1.
class Built
{
public:
  virtual ~Built() = default;

  // These release the memory of the cells first, …, last - 1, of all cells, and of all vertices,
  // which the caller does not read any more.
  virtual void release_cells(std::size_t first, std::size_t last) = 0;
  virtual void give_up_cells() = 0;
  virtual void give_up_vertices() = 0;

  // Gives the memory of the cells, that of a Page_array, to the caller.
  virtual Memory_of_cells take_cells() = 0;

  // Returns any cell of vertex v.
  virtual Id cell_of(std::size_t v) const = 0;

  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE bool has_started() const { return cells_end > 0; }

  Insertion_outcome outcome = Insertion_outcome::FLAT;
  int dimension = -1;    // of the points
  bool has_apex = false; // the last vertex is one, off the plane of all others
  Insertion_counts counts;

  Order_view order = {nullptr, 0, nullptr, 0, nullptr};
  const Id* vertex_of = nullptr; // by place, 0 if not inserted or hidden; an apex comes last
  std::size_t number_of_places = 0;
  Compact_cell* cells = nullptr;
  std::size_t cells_end = 0;    // counts dead ones, too
  std::size_t vertices_end = 0; // counts 0 and unused ones, too
};

// Holds what build_in_box() makes: the triangulation of points in a box, their *home*, and of copies
// around, as many as determine the stars of the points at home.
struct Built_in_box
{
  class Memory
  {
  public:
    virtual ~Memory() = default;
  };

  std::unique_ptr<Built> built; // the points come first, in their order, and then the copies

  // By vertex, less 1: the shifts are from home.
  Periodic_copy* copies = nullptr;
  std::size_t number_of_copies = 0;

  // By point: how many periods home is away from the user's point; null if none is.
  const std::array<std::int32_t, 3>* home = nullptr;

  // All edges are shorter than half the shortest period.
  bool has_short_edges = false;

  std::unique_ptr<Memory> memory; // of both arrays
};

// Says what a caller asks of build().
struct Build_options
{
  // "= default" could be compiled as a function of its own.
  // NOLINTNEXTLINE(modernize-use-equals-default)
  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE Build_options() {}

  // The rounds that the core makes. Spaced rounds destroy the fewest cells and give every point a
  // start beside it, but no bound is proved for them: they have a budget, and when it is exceeded,
  // the insertions begin anew in random rounds, which destroy more cells and walk further. Spaced
  // rounds take 16 bytes per point, random rounds 8.
  enum Rounds { SPACED, RANDOM } rounds = SPACED;

  // Random rounds depend on these: 0 < ratio < 1, first_round > 0.
  unsigned int seed = 0;
  double ratio = 0.125;
  std::size_t first_round = 64;

  // Spaced rounds, or a given order, may destroy this many cells per point (Insertion_budget). If a
  // given order destroys more, the outcome is OVER_BUDGET.
  static constexpr std::size_t any_number = std::size_t(-1), usual_number = 64;
  std::size_t cells_per_point = usual_number;

  // An order that takes the place of the core's own: a permutation of the points that outlives the
  // result of build(). It is not checked. Points on a line are ordered along it all the same.
  const Order_view* given = nullptr;

  // True if the points inserted so far, in the given order, are always spread over all, so that most
  // of many cells must stay. A caller's own plan may begin with hubs.
  bool is_spread = false;

  // Makes each point start where the order says, or else from the one before, which makes
  // walks longer.
  bool uses_starting_places = true;

  // Gives points in one plane an apex off it. The cells at it are then their triangles, with the
  // same perturbation. Otherwise such points are not triangulated.
  bool adds_apex = false;

  // Ends, if false, when there is an order: the result has nothing else.
  bool inserts = true;

  // Finds a cell that contains each hidden point: for the one at place k of the order it is
  // Built::cell_of(Compact_numbers::vertex_of_point(k)). Without weights no point is hidden.
  bool locates_hidden = false;

  // If there would be more cells, dead ones included, the outcome is TOO_MANY_CELLS.
  std::size_t most_cells = std::size_t(1) << 30;
};

// Is told what the core does, and can stop it. The thread that called the core calls all functions.
class Observer
{
public:
  virtual ~Observer() = default;

  // For the number see Surface_insertion_phase.
  virtual void phase_begins(Surface_insertion_phase, std::size_t /* number */) {}
  virtual void notice(Surface_insertion_notice, const char* /* reason */) {}
  virtual void insertion_ends(const Insertion_counts&) {}

  // Is asked every 256 points or more often, with the number of points inserted so far, which many
  // threads only estimate; `false` stops the work.
  virtual bool go_further(std::size_t /* inserted */) { return true; }

  // Returns true if it wants to be told of LOCATION and UPDATE, point by point; many threads do not
  // tell it of these.
  virtual bool follows_points() const { return false; }
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE

inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Returns a view of an order that is kept elsewhere.
inline Order_view view_of(const Insertion_order& order)
{
  return {order.order.data(), order.order.size(), order.round_ends.data(), order.round_ends.size(),
          order.starting_places.empty() ? nullptr : order.starting_places.data()};
}

// Returns a copy, which owns its arrays.
inline Insertion_order copy_of(const Order_view& view)
{
  Insertion_order order;
  order.order.assign(view.order, view.order + view.size);
  order.round_ends.assign(view.round_ends, view.round_ends + view.number_of_rounds);
  if (view.starting_places != nullptr)
    order.starting_places.assign(view.starting_places, view.starting_places + view.size);
  return order;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_BUILT_H
