// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Measures cells of Voronoi diagrams and, with weights, power diagrams: volumes, facets, and polyhedra.
//
// A facet crosses an edge of the triangulation, and its corners are the centres of the tetrahedra in the
// ring around the edge. Centres coincide where tetrahedra lie in one sphere, as in lattices: whether
// they do is decided by exact arithmetic, so that such a facet has its true number of corners, and the
// area 0 if that is less than three.

#include "Corners.h"
#include "Power_shares.h"
#include "Unlocked.h"
#include "functions.h"
#include "interruptible.h"

#include <CGAL/Delaunay_from_surface_3/arrays/measures_of_simplices.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/exact_signs.h>
#include <CGAL/Delaunay_from_surface_3/support/Disjoint_sets.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace py = pybind11;
namespace core = CGAL::Delaunay_from_surface_3::core;

namespace {

using python::array_from;
using python::Index;
using python::Numbers;
using python::Points;
using python::Rows;

using Vector = std::array<double, 3>;
using Offset = std::array<int, 3>;

// The tetrahedron across a facet. A corner of the facet has another number there; the number of the
// corner opposite is that of the one opposite there.
struct Across
{
  Index cell = -1;           // beyond the hull
  unsigned char corners = 0; // two bits for each
  bool has_same_center = false;

  std::size_t corner(std::size_t k) const { return corners >> (2 * k) & 3u; }
};

// Returns a corner of facet k, the first of the tetrahedron if possible.
std::size_t corner_beside(std::size_t k)
{
  return k == 0 ? 1 : 0;
}

[[noreturn]] void refuse_neighbors()
{
  throw std::invalid_argument("neighbors: they are not those of the simplices");
}

// Tetrahedra with their neighbours; in a box these are copies, which share the copy of a facet.
template <class CornerOf>
class Tetrahedra
{
public:
  // Keeps references.
  Tetrahedra(const Rows& vertices, const Rows& neighbors, std::size_t n, const CornerOf& corner_of)
    : m_vertices(vertices)
    , m_neighbors(neighbors)
    , m_n(n)
    , m_corner_of(corner_of)
  {
    if (neighbors.corners() != 4 || neighbors.size() != vertices.size())
      throw std::invalid_argument("neighbors: expected four for each tetrahedron");
  }

  static constexpr bool has_weights =
      core::is_weighted<decltype(core::place_of(std::declval<const CornerOf&>()(0, 0, 0)))>;

  std::size_t size() const { return m_vertices.size(); }
  std::size_t number_of_points() const { return m_n; }
  Index vertex(std::size_t c, std::size_t k) const { return m_vertices.number(c, k, m_n); }
  auto corner(std::size_t c, std::size_t k) const
  {
    return m_corner_of(c, k, std::size_t(vertex(c, k)));
  }
  Offset offset(std::size_t c, std::size_t k) const
  {
    const std::int16_t* const offsets = m_corner_of.offsets();
    if (offsets == nullptr)
      return {0, 0, 0};
    const std::int16_t* const of_corner = offsets + 12 * c + 3 * k;
    return {of_corner[0], of_corner[1], of_corner[2]};
  }

  Index neighbor(std::size_t c, std::size_t k) const
  {
    const Index d = m_neighbors.entry(c, k);
    if (d >= 0 && std::size_t(d) >= size())
      refuse_neighbors();
    return d;
  }

  // Calls f(corners) with those from the k-th on, in an order of the same orientation: the j-th is j ^ k.
  template <class F>
  auto with_corners_from(std::size_t c, std::size_t k, const F& f) const
  {
    const decltype(corner(c, 0)) corners[4] = {corner(c, k), corner(c, k ^ 1), corner(c, k ^ 2),
                                               corner(c, k ^ 3)};
    return f(corners);
  }

  // Returns the centre relative to corner k.
  Vector center(std::size_t c, std::size_t k) const
  {
    return with_corners_from(
        c, k, [](const auto& corners) { return core::circumsphere_of(corners).center; });
  }

  // Returns the exponent of a power of 2 in which squares and cubes are neither too large nor too small:
  // 0 for usual coordinates.
  int unit() const
  {
    int exponent;
    std::frexp(m_corner_of.largest(), &exponent);
    return std::abs(exponent) > 200 ? exponent : 0;
  }

  // Returns what lies across a facet, but not whether the centres are the same.
  Across across(std::size_t c, std::size_t k) const { return across(c, k, neighbor(c, k)); }
  // ... where the neighbour has been read.
  Across across(std::size_t c, std::size_t k, Index d) const
  {
    if (d < 0)
      return {};
    for (std::size_t j = 0; j < 4; ++j)
      if (m_neighbors.entry(std::size_t(d), j) == Index(c) && (d != Index(c) || j != k)) {
        Across across = {d, 0, false};
        if (match_corners(c, k, j, across))
          return across;
      }
    refuse_neighbors();
  }

  // Returns whether a tetrahedron and that across facet k have the same centre, exactly.
  bool have_same_center(std::size_t c, std::size_t k, const Across& across) const
  {
    const auto d = std::size_t(across.cell);
    const std::size_t j = across.corner(k), s = corner_beside(k);
    const Offset by = difference(offset(c, s), offset(d, across.corner(s))), there = offset(d, j);
    std::array corners = {corner(c, 0), corner(c, 1), corner(c, 2), corner(c, 3), corner(d, j)};
    set_offsets(corners, {offset(c, 0), offset(c, 1), offset(c, 2), offset(c, 3),
                          Offset{there[0] + by[0], there[1] + by[1], there[2] + by[2]}});
    const decltype(core::place_of(corners[0])) places[4] = {
        core::place_of(corners[0]), core::place_of(corners[1]), core::place_of(corners[2]),
        core::place_of(corners[3])};
    return core::exact_sign<core::Exact_sphere>(places, core::place_of(corners[4])).is_perturbed;
  }

  // Returns whether the point at corner k lies in the plane of the facet between its cell and that of
  // corner j, exactly.
  bool is_in_facet(std::size_t c, std::size_t k, std::size_t j) const
  {
    bool is_in_facet = false;
    if constexpr (has_weights) {
      const auto of_facet = corner(c, j);
      const decltype(core::place_of(of_facet)) others[1] = {core::place_of(of_facet)};
      core::measure_in_stages<1>(others, core::place_of(corner(c, k)), [&](const auto& in) {
        const auto& power = in.rows[0].w; // of the point to the other, less that to itself
        is_in_facet = in.rounded(power).value == 0;
        return in.is_known(power, power);
      });
    }
    return is_in_facet;
  }

  // Returns the position of the first corner relative to another.
  Vector first_from(std::size_t c, std::size_t k) const
  {
    return k == 0 ? Vector() : core::rounded_difference(corner(c, 0), corner(c, k));
  }

  static Offset difference(const Offset& a, const Offset& b)
  {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }

private:
  // Finds the corners of facet k among those of the other tetrahedron without its corner j: they have the
  // same vertices, and in a box all are moved alike.
  bool match_corners(std::size_t c, std::size_t k, std::size_t j, Across& across) const
  {
    const auto d = std::size_t(across.cell);
    const std::size_t s = corner_beside(k);
    const Vertices here = vertices(c), there = vertices(d);
    for (std::size_t first = 0; first < 4; ++first) {
      if (first == j || there[first] != here[s])
        continue;
      const Offset by = difference(offset(d, first), offset(c, s));
      std::size_t corners = j << 2 * k, number = 0;
      for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t b = 0; b < 4; ++b)
          if (here[a] == there[b] && a != k && b != j &&
              difference(offset(d, b), offset(c, a)) == by) {
            corners |= b << 2 * a;
            ++number;
          }
      if (number == 3) {
        across.corners = static_cast<unsigned char>(corners);
        return true;
      }
    }
    return false;
  }

  using Vertices = std::array<Index, 4>;
  Vertices vertices(std::size_t c) const
  {
    return {vertex(c, 0), vertex(c, 1), vertex(c, 2), vertex(c, 3)};
  }

  template <std::size_t size>
  static void set_offsets(std::array<std::array<double, size>, 5>&, const std::array<Offset, 5>&)
  {
  }
  // Moves them all to the middle, since only differences count, and offsets of copies are short.
  template <bool has_weight>
  static void set_offsets(std::array<core::Copy_place<has_weight>, 5>& corners,
                          const std::array<Offset, 5>& offsets)
  {
    for (std::size_t a = 0; a < 3; ++a) {
      const auto [least, most] =
          std::minmax({offsets[0][a], offsets[1][a], offsets[2][a], offsets[3][a], offsets[4][a]});
      if (most - least > 2 * (std::numeric_limits<std::int16_t>::max)())
        throw std::invalid_argument(
            "box: corners are more than 65534 periods away from each other");
      for (std::size_t i = 0; i < 5; ++i)
        corners[i].shift[a] = std::int16_t(offsets[i][a] - (least + most) / 2);
    }
  }

  const Rows& m_vertices;
  const Rows& m_neighbors;
  const std::size_t m_n;
  const CornerOf& m_corner_of;
};

// Calls f(tetrahedra), unlocked. If not all points are used, one thread may.
template <bool has_weight, class F>
auto with_tetrahedra_of(const Points& points, const py::object& weights, const Numbers& simplices,
                        const Numbers& neighbors, const py::object& in_box, bool are_all_used,
                        const F& f)
{
  python::refuse_obstacle();
  const Rows vertices(simplices), across(neighbors);
  return python::with_corners_of<has_weight>(
      points, weights, vertices, in_box,
      [&](const auto& corner_of) {
        const python::Unlocked unlocked;
        const core::Rounding_to_nearest rounding;
        return f(Tetrahedra(vertices, across, std::size_t(points.shape(0)), corner_of));
      },
      are_all_used);
}
template <class F>
auto with_tetrahedra(const Points& points, const py::object& weights, const Numbers& simplices,
                     const Numbers& neighbors, const py::object& in_box, const F& f,
                     bool are_all_used = true)
{
  return weights.is_none() ? with_tetrahedra_of<false>(points, weights, simplices, neighbors,
                                                       in_box, are_all_used, f)
                           : with_tetrahedra_of<true>(points, weights, simplices, neighbors, in_box,
                                                      are_all_used, f);
}

// Calls take(i, find(i)) for i = 0, …, number-1, in turn. Several threads find.
template <class Find, class Take>
void find_in_turn(std::size_t number, const Find& find, const core::Executor& executor,
                  const Take& take)
{
  constexpr std::size_t group = 1 << 14;
  std::vector<decltype(find(0))> found((std::min)(group, number));
  for (std::size_t begin = 0; begin < number; begin += group) {
    const std::size_t size = (std::min)(group, number - begin);
    core::for_each_block(executor, size, core::number_of_blocks(executor, size, 1024),
                         [&](std::size_t first, std::size_t last, std::size_t) {
                           for (std::size_t i = first; i < last; ++i)
                             found[i] = find(begin + i);
                         });
    executor.interruption_point();
    for (std::size_t i = 0; i < size; ++i)
      take(begin + i, found[i]);
  }
}

// Measures cells by the shares of tetrahedra, as seen from the points. Where a point lies so far outside
// of its cell that these nearly cancel each other, they are found again as seen from a point within.
// Results do not depend on threads.
template <class CornerOf>
class Measure_cells
{
public:
  // Keeps references.
  Measure_cells(const Tetrahedra<CornerOf>& tetrahedra, const core::Executor& executor)
    : m_tetrahedra(tetrahedra)
    , m_executor(executor)
    , m_unit(tetrahedra.unit())
    , m_cells(tetrahedra.number_of_points())
  {
  }

  int unit() const { return m_unit; }

  // Calls take(c, shares) for each tetrahedron, and then take_again(c, k, shares) for those at cells whose
  // shares are found again, as seen from near corner k.
  template <class Take, class TakeAgain>
  void measure(const Take& take, const TakeAgain& take_again)
  {
    const auto shares_of = [&](std::size_t c) {
      return m_tetrahedra.with_corners_from(
          c, 0, [&](const auto& corners) { return python::power_shares_of(corners, m_unit); });
    };
    find_in_turn(m_tetrahedra.size(), shares_of, m_executor,
                 [&](std::size_t c, const python::Power_shares& shares) {
                   take(c, shares);
                   for (std::size_t k = 0; k < 4; ++k) {
                     Cell& cell = m_cells[std::size_t(m_tetrahedra.vertex(c, k))];
                     cell.volume += shares.volumes[k];
                     cell.size += std::abs(shares.volumes[k]);
                   }
                 });
    find_unbounded();
    choose_points();
    const auto shares_again = [&](std::size_t i) {
      const Corner& at = m_corners[i];
      const Vector& within = m_within[at.cell].sum;
      return m_tetrahedra.with_corners_from(at.tetrahedron, at.corner, [&](const auto& corners) {
        return python::power_shares_of(corners, m_unit, &within);
      });
    };
    find_in_turn(m_corners.size(), shares_again, m_executor,
                 [&](std::size_t i, const python::Power_shares& shares) {
                   const Corner& at = m_corners[i];
                   m_within[at.cell].volume += shares.volumes[0];
                   take_again(at.tetrahedron, at.corner, shares);
                 });
  }

  // Returns whether the shares of a cell were found again.
  bool is_seen_from_within(std::size_t v) const { return m_cells[v].within != none; }

  // Returns the volumes, -1 if they are unbounded.
  std::vector<double> volumes() const
  {
    std::vector<double> volumes;
    volumes.reserve(m_cells.size());
    for (const Cell& cell : m_cells) {
      const double volume = cell.within == none ? cell.volume : m_within[cell.within].volume;
      volumes.push_back(cell.is_unbounded ? -1 : std::ldexp((std::max)(volume, 0.), 3 * m_unit));
    }
    return volumes;
  }

private:
  static constexpr std::uint32_t none = std::uint32_t(-1);

  // The sums of shares and of their absolute values.
  struct Cell
  {
    double volume = 0, size = 0;
    std::uint32_t within = none;
    bool is_unbounded = false;
  };
  // A cell that is seen from within; of the centres of its tetrahedra, relative to its point, the sum,
  // which becomes the mean, and the sum of squares.
  struct Within
  {
    std::size_t number = 0;
    Vector sum = {};
    double squares = 0, volume = 0;
  };
  struct Corner
  {
    std::size_t tetrahedron;
    unsigned corner;
    std::uint32_t cell; // in m_within
  };

  void find_unbounded()
  {
    for (std::size_t c = 0; c < m_tetrahedra.size(); ++c)
      for (std::size_t k = 0; k < 4; ++k)
        if (m_tetrahedra.neighbor(c, k) < 0)
          for (std::size_t j = 1; j < 4; ++j)
            m_cells[std::size_t(m_tetrahedra.vertex(c, k ^ j))].is_unbounded = true;
  }

  // Unbounded cells, too, may be far from their points if these have weights.
  void choose_points()
  {
    for (Cell& cell : m_cells)
      if (cell.is_unbounded ? m_tetrahedra.has_weights : !(cell.size <= 256 * cell.volume)) {
        cell.within = std::uint32_t(m_within.size());
        m_within.emplace_back();
      }
    if (m_within.empty())
      return;
    list_corners();
    find_in_turn(
        m_corners.size(),
        [&](std::size_t i) {
          return m_tetrahedra.center(m_corners[i].tetrahedron, m_corners[i].corner);
        },
        m_executor,
        [&](std::size_t i, const Vector& center) {
          Within& within = m_within[m_corners[i].cell];
          ++within.number;
          within.squares += core::dot(center, center);
          for (std::size_t a = 0; a < 3; ++a)
            within.sum[a] += center[a];
        });
    for (Cell& cell : m_cells)
      if (cell.within != none && !find_mean(m_within[cell.within], cell.is_unbounded))
        cell.within = none;
    list_corners();
  }

  void list_corners()
  {
    m_corners.clear();
    for (std::size_t c = 0; c < m_tetrahedra.size(); ++c)
      for (unsigned k = 0; k < 4; ++k) {
        const std::uint32_t within = m_cells[std::size_t(m_tetrahedra.vertex(c, k))].within;
        if (within != none)
          m_corners.push_back({c, k, within});
      }
  }

  // Returns whether it is a place from which to see the cell: an unbounded one that is as large as the
  // distance is seen from its point. The mean is rounded so that integers need few digits more.
  static bool find_mean(Within& within, bool is_unbounded)
  {
    const auto number = double(within.number);
    for (double& x : within.sum)
      x /= number;
    const double square = core::dot(within.sum, within.sum);
    if (is_unbounded && !(within.squares / number < 257. / 256 * square))
      return false;
    int exponent;
    std::frexp((std::max)({std::abs(within.sum[0]), std::abs(within.sum[1]),
                           std::abs(within.sum[2]), std::sqrt(within.squares / number)}),
               &exponent);
    for (double& x : within.sum)
      x = std::ldexp(std::rint(std::ldexp(x, 48 - exponent)), exponent - 48);
    return std::isfinite(within.sum[0] + within.sum[1] + within.sum[2]);
  }

  const Tetrahedra<CornerOf>& m_tetrahedra;
  const core::Executor& m_executor;
  const int m_unit;
  std::vector<Cell> m_cells;
  std::vector<Within> m_within;
  std::vector<Corner> m_corners;
};

// A tetrahedron in the ring around an edge: the ends of the edge, and the other two corners, in positive
// orientation. The next one lies across the facet opposite to the first of these.
struct Step
{
  std::size_t cell;
  std::array<unsigned char, 4> at;
  bool joins_next = false; // whether the next has the same centre

  std::size_t edge() const { return python::number_of_edge(at[0], at[1]); }
  std::size_t place() const { return 6 * cell + edge(); }
  Step turned() const { return {cell, {at[1], at[0], at[3], at[2]}}; }
  Step next(const Across& across) const
  {
    const auto corner = [&](std::size_t m) {
      return static_cast<unsigned char>(across.corner(at[m]));
    };
    return {std::size_t(across.cell), {corner(0), corner(1), corner(3), corner(2)}};
  }
};

// Returns edge `place` % 6 of tetrahedron `place` / 6.
Step step_at(std::size_t place)
{
  static constexpr std::array<unsigned char, 4> corners[6] = {
      {0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}};
  return {place / 6, corners[place % 6]};
}

// Returns the same from the end that comes first, and of two copies of a point from that from which the
// other is moved by a positive offset.
template <class CornerOf>
Step directed_step_at(const Tetrahedra<CornerOf>& tetrahedra, std::size_t place)
{
  const Step step = step_at(place);
  const auto end = [&](std::size_t m) {
    return std::pair(tetrahedra.vertex(step.cell, step.at[m]),
                     tetrahedra.offset(step.cell, step.at[m]));
  };
  return end(1) < end(0) ? step.turned() : step;
}

// The tetrahedra around an edge, counterclockwise as seen from its second end.
class Ring
{
public:
  std::vector<Step> steps;
  bool is_closed = false;

  // Rings of so many tetrahedra. Keeps a reference.
  Ring(core::Steps& count, std::size_t tetrahedra)
    : m_count(count)
    , m_most(6 * tetrahedra)
  {
  }

  // Finds it from this step on, and returns true unless it meets a step where it is to be left.
  template <class AcrossOf, class IsLeft>
  bool find(const Step& first, const AcrossOf& across, const IsLeft& is_left)
  {
    steps.clear();
    is_closed = false;
    Step step = first;
    for (std::size_t number = 0; number <= m_most; ++number, m_count()) {
      const Across to = across(step.cell, step.at[2]);
      step.joins_next = to.has_same_center;
      steps.push_back(step);
      if (to.cell < 0)
        return meets_other_end(first.turned(), across, is_left);
      step = step.next(to);
      is_closed = step.cell == first.cell && step.at == first.at;
      if (is_closed || is_left(step))
        return is_closed;
    }
    refuse_neighbors();
  }
  template <class AcrossOf>
  bool find(const Step& first, const AcrossOf& across)
  {
    return find(first, across, [](const Step&) { return false; });
  }

  // Returns 0 if there are less than three.
  int number_of_corners() const
  {
    const auto number = std::count_if(steps.begin(), steps.end(),
                                      [](const Step& step) { return !step.joins_next; });
    return number < 3 ? 0 : int(number);
  }

private:
  template <class AcrossOf, class IsLeft>
  bool meets_other_end(Step step, const AcrossOf& across, const IsLeft& is_left)
  {
    for (std::size_t number = 0; number <= m_most; ++number, m_count()) {
      const Across to = across(step.cell, step.at[2]);
      if (to.cell < 0)
        return true;
      step = step.next(to);
      if (is_left(step))
        return false;
    }
    refuse_neighbors();
  }

  core::Steps& m_count;
  const std::size_t m_most;
};

struct Facet
{
  std::array<Index, 2> ends;
  Offset offset;
  int corners;
  double area;
  std::size_t place;
};

// What the facets take from one tetrahedron: in one place, since rings jump from one to the next.
struct Part
{
  std::array<Across, 4> across;
  std::array<double, 6> areas;
  std::array<bool, 6> is_done = {}; // of edges
  Vector center;                    // relative to the first corner
};

// Parts are sorted by space, since tetrahedra are not: across facets their numbers are those of parts.
struct Parts
{
  std::vector<std::uint32_t> number_of;  // the part of each tetrahedron
  std::vector<std::uint32_t> tetrahedra; // that of each part
  std::vector<Part> parts;

  Part& of(std::size_t tetrahedron) { return parts[number_of[tetrahedron]]; }
  const Part& of(std::size_t tetrahedron) const { return parts[number_of[tetrahedron]]; }
};

// Sorts tetrahedra by their first corners along a curve of Morton's through 64 x 64 x 64 boxes.
template <class CornerOf>
core::Lists<std::uint32_t> sorted_by_space(const Tetrahedra<CornerOf>& tetrahedra)
{
  const std::size_t m = tetrahedra.size();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> least = {infinity, infinity, infinity},
                        most = {-infinity, -infinity, -infinity};
  std::vector<Vector> corners(m);
  for (std::size_t c = 0; c < m; ++c) {
    const auto corner = tetrahedra.corner(c, 0);
    for (std::size_t a = 0; a < 3; ++a) {
      const double x = corners[c][a] = python::coordinate(corner, a);
      least[a] = (std::min)(least[a], x);
      most[a] = (std::max)(most[a], x);
    }
  }
  std::vector<std::uint32_t> boxes(m);
  for (std::size_t c = 0; c < m; ++c)
    for (std::size_t a = 0; a < 3; ++a) {
      const double share = (corners[c][a] - least[a]) / (most[a] - least[a]);
      const auto number = unsigned(share >= 0 && share <= 1 ? 63 * share : 0); // or overflow
      for (unsigned bit = 0; bit < 6; ++bit)
        boxes[c] |= (number >> bit & 1u) << (3 * bit + unsigned(a));
    }
  return core::in_lists<std::uint32_t>(std::size_t(1) << 18,
                                       core::Listed_items(
                                           m, [&](std::size_t c) { return std::size_t(boxes[c]); },
                                           [](std::size_t c) { return std::uint32_t(c); }));
}

// Takes areas of facets from the shares; those of a facet from its first end, if that is seen from within,
// and else from the second if that is.
template <class CornerOf>
Parts parts_of(const Tetrahedra<CornerOf>& tetrahedra, Measure_cells<CornerOf>& cells)
{
  const std::size_t m = tetrahedra.size();
  Parts parts;
  const auto sorted = sorted_by_space(tetrahedra);
  parts.tetrahedra.assign(sorted.items.begin(), sorted.items.end());
  parts.number_of.resize(m);
  for (std::size_t i = 0; i < m; ++i)
    parts.number_of[parts.tetrahedra[i]] = std::uint32_t(i);
  parts.parts.resize(m);
  cells.measure(
      [&](std::size_t c, const python::Power_shares& shares) {
        parts.of(c).center = shares.center;
        parts.of(c).areas = shares.areas;
      },
      [&](std::size_t c, std::size_t k, const python::Power_shares& shares) {
        for (std::size_t j = 1; j < 4; ++j) {
          const std::size_t edge = python::number_of_edge(k, k ^ j);
          if (!cells.is_seen_from_within(std::size_t(tetrahedra.vertex(c, k ^ j))) ||
              directed_step_at(tetrahedra, 6 * c + edge).at[0] == k)
            parts.of(c).areas[edge] = shares.areas[j - 1];
        }
      });
  return parts;
}

// Returns whether the centres of tetrahedra on both sides of a facet surely differ. Each is known up to
// 2^-43 of its distance from the first corner (measures_of_simplices.h).
template <class CornerOf>
bool have_distant_centers(const Tetrahedra<CornerOf>& tetrahedra, const Parts& parts, std::size_t c,
                          std::size_t k, const Across& across)
{
  const auto d = std::size_t(across.cell);
  const std::size_t s = corner_beside(k);
  const Vector from = tetrahedra.first_from(c, s);
  const Vector from_there = tetrahedra.first_from(d, across.corner(s));
  const Vector &center = parts.of(c).center, &center_there = parts.of(d).center;
  double distance = 0, size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = center[i] + from[i], y = center_there[i] + from_there[i];
    distance = (std::max)(distance, std::abs(x - y));
    size += std::abs(center[i]) + std::abs(from[i]) + std::abs(center_there[i]) +
            std::abs(from_there[i]);
  }
  return distance > 0x1p-40 * size + 0x1p-1000; // false if one is not finite
}

// Finds what lies across facet k of tetrahedron c, in tetrahedron d, and writes it down for both.
template <class CornerOf>
void find_across(const Tetrahedra<CornerOf>& tetrahedra, std::size_t c, std::size_t k, Index d,
                 Parts& parts)
{
  Across to = tetrahedra.across(c, k, d);
  to.has_same_center =
      !have_distant_centers(tetrahedra, parts, c, k, to) && tetrahedra.have_same_center(c, k, to);
  Across back = {Index(parts.number_of[c]), 0, to.has_same_center};
  for (std::size_t a = 0; a < 4; ++a)
    back.corners = static_cast<unsigned char>(back.corners | a << 2 * to.corner(a));
  parts.of(std::size_t(d)).across[to.corner(k)] = back;
  to.cell = Index(parts.number_of[std::size_t(d)]);
  parts.of(c).across[k] = to;
}

template <class CornerOf>
void find_all_across(const Tetrahedra<CornerOf>& tetrahedra, Parts& parts,
                     const core::Executor& executor)
{
  const std::size_t m = tetrahedra.size();
  core::for_each_block(executor, m, core::number_of_blocks(executor, m, 4096),
                       [&](std::size_t first, std::size_t last, std::size_t) {
                         core::Steps step(executor);
                         for (std::size_t i = first; i < last; ++i, step())
                           for (std::size_t k = 0; k < 4; ++k) {
                             const std::size_t c = parts.tetrahedra[i];
                             const Index d = tetrahedra.neighbor(c, k);
                             if (d >= Index(c))
                               find_across(tetrahedra, c, k, d, parts);
                           }
                       });
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t k = 0; k < 4; ++k) {
      const Index d = tetrahedra.neighbor(parts.tetrahedra[i], k);
      if (parts.parts[i].across[k].cell != (d < 0 ? d : Index(parts.number_of[std::size_t(d)])))
        refuse_neighbors();
    }
}

template <class CornerOf>
Facet facet_of(const Tetrahedra<CornerOf>& tetrahedra, const Parts& parts, const Ring& ring)
{
  const Step& first = ring.steps.front();
  const Step s = directed_step_at(tetrahedra, 6 * parts.tetrahedra[first.cell] + first.edge());
  Facet facet = {
      {tetrahedra.vertex(s.cell, s.at[0]), tetrahedra.vertex(s.cell, s.at[1])},
      tetrahedra.difference(tetrahedra.offset(s.cell, s.at[1]), tetrahedra.offset(s.cell, s.at[0])),
      -1,
      -1,
      s.place()};
  if (ring.is_closed) {
    facet.corners = ring.number_of_corners();
    facet.area = 0;
    if (facet.corners > 0)
      for (const Step& step : ring.steps)
        facet.area += parts.parts[step.cell].areas[step.edge()];
    facet.area = (std::max)(facet.area, 0.);
  }
  return facet;
}

// Finds the facets whose rings have their least place from parts first to last-1. Each part of a ring is
// walked through but once in these.
template <class CornerOf>
std::deque<Facet> facets_from(const Tetrahedra<CornerOf>& tetrahedra, Parts& parts,
                              std::size_t first, std::size_t last, const core::Executor& executor)
{
  core::Steps count(executor);
  Ring ring(count, tetrahedra.size());
  std::deque<Facet> facets;
  const auto across = [&](std::size_t c, std::size_t k) { return parts.parts[c].across[k]; };
  const auto is_here = [&](const Step& step) { return first <= step.cell && step.cell < last; };
  for (std::size_t place = 6 * first; place < 6 * last; ++place, count()) {
    if (parts.parts[place / 6].is_done[place % 6])
      continue;
    const auto is_left = [&](const Step& step) {
      return step.place() < place || // it is found from there, or has been
             (is_here(step) && parts.parts[step.cell].is_done[step.edge()]);
    };
    if (ring.find(step_at(place), across, is_left))
      facets.push_back(facet_of(tetrahedra, parts, ring));
    for (const Step& step : ring.steps)
      if (is_here(step)) // others belong to other threads, which find out again
        parts.parts[step.cell].is_done[step.edge()] = true;
  }
  return facets;
}

// Returns the facets of all edges, sorted by their ends and offsets.
template <class CornerOf>
std::vector<Facet> facets_of(const Tetrahedra<CornerOf>& tetrahedra, Parts&& parts,
                             const core::Executor& executor)
{
  const std::size_t m = tetrahedra.size(), n = tetrahedra.number_of_points();
  std::vector<std::deque<Facet>> found(core::number_of_blocks(executor, m, 4096));
  core::for_each_block(executor, m, found.size(),
                       [&](std::size_t first, std::size_t last, std::size_t b) {
                         found[b] = facets_from(tetrahedra, parts, first, last, executor);
                       });
  parts = Parts(); // the memory is needed now
  std::vector<std::size_t> ends(n + 1);
  for (const std::deque<Facet>& of_block : found)
    for (const Facet& facet : of_block)
      ++ends[std::size_t(facet.ends[0]) + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<Facet> sorted(ends[n]);
  for (std::deque<Facet>& of_block : found) {
    for (const Facet& facet : of_block)
      sorted[ends[std::size_t(facet.ends[0])]++] = facet;
    of_block = {};
  }
  auto begin = sorted.begin();
  for (std::size_t v = 0; v < n; ++v) { // ends[v] is that of its list now
    const auto end = sorted.begin() + std::ptrdiff_t(ends[v]);
    std::sort(begin, end, [](const Facet& f, const Facet& g) {
      return std::tie(f.ends[1], f.offset) < std::tie(g.ends[1], g.offset);
    });
    begin = end;
  }
  return sorted;
}

// Returns what `item` returns for each facet, as rows of so many entries.
template <class T, class Item>
py::array column_of(const std::vector<Facet>& facets, py::ssize_t entries, const Item& item)
{
  std::vector<T> column;
  column.reserve(std::size_t(entries) * facets.size());
  for (const Facet& facet : facets)
    item(facet, column);
  const auto number = py::ssize_t(facets.size());
  return entries == 1 ? array_from(std::move(column), {number})
                      : array_from(std::move(column), {number, entries});
}

// Returns the volumes of the cells, and of each facet its two points, its offset in a box, its area, its
// number of corners, and its place, where its ring is found again; all measures are -1 if they are
// unbounded. Areas have to be multiplied by a power of 2, whose exponent comes last.
py::tuple cell_facets(const Points& points, const py::object& weights, const Numbers& simplices,
                      const Numbers& neighbors, const py::object& in_box, std::size_t threads)
{
  std::vector<double> volumes;
  int exponent = 0;
  const std::vector<Facet> facets =
      with_tetrahedra(points, weights, simplices, neighbors, in_box, [&](const auto& tetrahedra) {
        const python::Interruptible_executor executor(threads);
        Measure_cells cells(tetrahedra, executor);
        Parts parts = parts_of(tetrahedra, cells);
        volumes = cells.volumes();
        exponent = 2 * cells.unit();
        find_all_across(tetrahedra, parts, executor);
        return facets_of(tetrahedra, std::move(parts), executor);
      });
  const auto append = [](auto& column, const auto& items) {
    column.insert(column.end(), items.begin(), items.end());
  };
  return py::make_tuple(
      array_from(std::move(volumes), {points.shape(0)}),
      column_of<Index>(facets, 2, [&](const Facet& f, auto& to) { append(to, f.ends); }),
      column_of<Index>(facets, 3, [&](const Facet& f, auto& to) { append(to, f.offset); }),
      column_of<double>(facets, 1, [](const Facet& f, auto& to) { to.push_back(f.area); }),
      column_of<Index>(facets, 1, [](const Facet& f, auto& to) { to.push_back(f.corners); }),
      column_of<std::int64_t>(
          facets, 1, [](const Facet& f, auto& to) { to.push_back(std::int64_t(f.place)); }),
      exponent);
}

// Returns the volumes of the cells alone.
py::array cell_volumes(const Points& points, const py::object& weights, const Numbers& simplices,
                       const Numbers& neighbors, const py::object& in_box, std::size_t threads)
{
  return array_from(with_tetrahedra(points, weights, simplices, neighbors, in_box,
                                    [&](const auto& tetrahedra) {
                                      const python::Interruptible_executor executor(threads);
                                      Measure_cells cells(tetrahedra, executor);
                                      cells.measure([](auto&&...) {}, [](auto&&...) {});
                                      return cells.volumes();
                                    }),
                    {points.shape(0)});
}

// Returns 0 for 0: if a corner of a facet is rounded to the point from which it is seen.
Vector unit_vector(const Vector& v)
{
  const double size = (std::max)({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  if (size == 0)
    return v;
  const Vector near_1 = {v[0] / size, v[1] / size, v[2] / size};
  const double length = std::sqrt(core::dot(near_1, near_1));
  return {near_1[0] / length, near_1[1] / length, near_1[2] / length};
}

// Returns the solid angle of a polygon as seen from the origin: positive if it is counterclockwise as seen
// from beyond. Source: A. van Oosterom, J. Strackee, The solid angle of a plane triangle, IEEE
// Transactions on Biomedical Engineering 30 (1983).
double solid_angle_of(const std::vector<Vector>& polygon)
{
  double half = 0;
  const Vector a = unit_vector(polygon[0]);
  Vector b = unit_vector(polygon[1]);
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Vector c = unit_vector(polygon[i]);
    half += std::atan2(core::dot(a, core::cross(b, c)),
                       1 + core::dot(a, b) + core::dot(b, c) + core::dot(c, a));
    b = c;
  }
  return 2 * half;
}

// Returns the solid angles of facets, given by their places, from either end; -1 if they are unbounded,
// and 0 from a point in their plane.
py::array solid_angles(const Points& points, const py::object& weights, const Numbers& simplices,
                       const Numbers& neighbors, const py::object& in_box,
                       const py::array_t<std::int64_t, py::array::c_style>& places,
                       std::size_t threads)
{
  const auto number = std::size_t(places.size());
  const std::int64_t* const place = places.data();
  std::vector<double> angles(2 * number, -1);
  with_tetrahedra(points, weights, simplices, neighbors, in_box, [&](const auto& tetrahedra) {
    const std::size_t m = tetrahedra.size();
    const python::Interruptible_executor executor(threads);
    std::vector<Vector> centers(m);
    core::for_each_block(executor, m, core::number_of_blocks(executor, m, 4096),
                         [&](std::size_t first, std::size_t last, std::size_t) {
                           core::Steps step(executor);
                           for (std::size_t c = first; c < last; ++c, step())
                             centers[c] = tetrahedra.center(c, 0);
                         });
    const auto across = [&](std::size_t c, std::size_t k) { return tetrahedra.across(c, k); };
    core::for_each_block(
        executor, number, core::number_of_blocks(executor, number, 4096),
        [&](std::size_t first, std::size_t last, std::size_t) {
          core::Steps count(executor);
          Ring ring(count, m);
          std::vector<Vector> polygon;
          for (std::size_t f = first; f < last; ++f) {
            if (place[f] < 0 || std::size_t(place[f]) >= 6 * m)
              throw std::out_of_range("places: there is no such edge");
            const Step start = directed_step_at(tetrahedra, std::size_t(place[f]));
            ring.find(start, across);
            for (std::size_t end = 0; end < 2 && ring.is_closed; ++end) {
              angles[2 * f + end] = 0;
              if (tetrahedra.is_in_facet(start.cell, start.at[end], start.at[1 - end]))
                continue;
              polygon.clear();
              for (const Step& s : ring.steps) {
                const Vector from = tetrahedra.first_from(s.cell, s.at[end]);
                const Vector& o = centers[s.cell];
                polygon.push_back({o[0] + from[0], o[1] + from[1], o[2] + from[2]});
              }
              angles[2 * f + end] = (end == 0 ? 1 : -1) * solid_angle_of(polygon);
            }
          }
        });
  });
  return array_from(std::move(angles), {py::ssize_t(number), 2});
}

// The tetrahedra at a vertex, each as often as it has copies there, and which of them have the same centre.
class Star
{
public:
  // Throws if the vertex is at the hull.
  template <class CornerOf>
  Star(const Tetrahedra<CornerOf>& tetrahedra, std::size_t cell, std::size_t corner,
       core::Steps& count)
  {
    add(4 * cell + corner);
    std::vector<std::array<std::size_t, 2>> same;
    for (std::size_t i = 0; i < m_corners.size(); ++i, count()) {
      const std::size_t c = m_corners[i] / 4, at = m_corners[i] % 4;
      for (std::size_t k = 0; k < 4; ++k)
        if (k != at) {
          const Across across = tetrahedra.across(c, k);
          if (across.cell < 0)
            throw std::invalid_argument("its cell is unbounded");
          const std::size_t number = add(4 * std::size_t(across.cell) + across.corner(at));
          if (tetrahedra.have_same_center(c, k, across))
            same.push_back({i, number});
        }
    }
    core::Disjoint_sets<std::size_t> sets(m_corners.size());
    for (const auto& pair : same)
      sets.unite(pair[0], pair[1]);
    for (std::size_t i = 0; i < m_corners.size(); ++i)
      m_centers.push_back(sets.root(i));
    m_are_marked.resize(m_corners.size());
  }

  // Each is four times a tetrahedron, plus the corner that is the vertex.
  const std::vector<std::size_t>& corners() const { return m_corners; }

  // Returns a number that is the same for tetrahedra with the same centre.
  std::size_t center(const Step& step) const
  {
    return m_centers[m_numbers.at(4 * step.cell + step.at[0])];
  }

  // Marks the edge of a step, from the vertex, and returns whether it was not marked.
  bool mark(const Step& step)
  {
    bool& is_marked = m_are_marked[m_numbers.at(4 * step.cell + step.at[0])][step.at[1]];
    return !std::exchange(is_marked, true);
  }

private:
  std::size_t add(std::size_t corner)
  {
    const auto added = m_numbers.emplace(corner, m_corners.size());
    if (added.second)
      m_corners.push_back(corner);
    return added.first->second;
  }

  std::vector<std::size_t> m_corners, m_centers;
  std::vector<std::array<bool, 4>> m_are_marked;
  std::map<std::size_t, std::size_t> m_numbers;
};

// A facet of one cell: the point beyond, its offset in a box, and the centres at its corners,
// counterclockwise as seen from there.
struct Face
{
  Index neighbor;
  Offset offset;
  std::vector<std::size_t> centers;
};

// Marks the edges of the star.
template <class CornerOf>
std::vector<Face> faces_of(const Tetrahedra<CornerOf>& tetrahedra, Star& star, core::Steps& count)
{
  const auto across = [&](std::size_t c, std::size_t k) { return tetrahedra.across(c, k); };
  std::vector<Face> faces;
  Ring ring(count, tetrahedra.size());
  for (const std::size_t corner : star.corners())
    for (std::size_t j = 0; j < 4; ++j) {
      const std::size_t c = corner / 4, k = corner % 4;
      if (j == k)
        continue;
      Step first = step_at(6 * c + python::number_of_edge(j, k));
      if (first.at[0] != k)
        first = first.turned();
      if (!star.mark(first))
        continue;
      ring.find(first, across);
      Face face = {tetrahedra.vertex(c, j),
                   tetrahedra.difference(tetrahedra.offset(c, j), tetrahedra.offset(c, k)),
                   {}};
      for (const Step& step : ring.steps) {
        star.mark(step);
        if (face.centers.empty() || star.center(step) != face.centers.back())
          face.centers.push_back(star.center(step));
      }
      if (face.centers.front() == face.centers.back())
        face.centers.pop_back();
      if (face.centers.size() > 2)
        faces.push_back(std::move(face));
    }
  std::sort(faces.begin(), faces.end(), [](const Face& f, const Face& g) {
    return std::tie(f.neighbor, f.offset) < std::tie(g.neighbor, g.offset);
  });
  return faces;
}

// Returns the polyhedron around a corner of a tetrahedron: vertices relative to the corner, and of each
// face its vertices, the point beyond, and its offset in a box.
py::tuple cell_polyhedron(const Points& points, const py::object& weights, const Numbers& simplices,
                          const Numbers& neighbors, const py::object& in_box, std::size_t simplex,
                          std::size_t corner)
{
  std::vector<double> vertices;
  std::vector<Face> faces;
  with_tetrahedra(
      points, weights, simplices, neighbors, in_box,
      [&](const auto& tetrahedra) {
        const python::Interruptible_executor executor(1);
        core::Steps count(executor);
        Star star(tetrahedra, simplex, corner, count);
        faces = faces_of(tetrahedra, star, count);
        std::map<std::size_t, std::size_t> numbers;
        for (Face& face : faces)
          for (std::size_t& center : face.centers) {
            const auto numbered = numbers.emplace(center, numbers.size());
            if (numbered.second) {
              const std::size_t c = star.corners()[center] / 4, k = star.corners()[center] % 4;
              const Vector center = tetrahedra.center(c, k);
              vertices.insert(vertices.end(), center.begin(), center.end());
            }
            center = numbered.first->second;
          }
      },
      false);
  py::list lists;
  std::vector<Index> beyond, offsets;
  for (const Face& face : faces) {
    std::vector<Index> of_face(face.centers.begin(), face.centers.end());
    const auto size = py::ssize_t(of_face.size());
    lists.append(array_from(std::move(of_face), {size}));
    beyond.push_back(face.neighbor);
    offsets.insert(offsets.end(), face.offset.begin(), face.offset.end());
  }
  const auto rows = py::ssize_t(vertices.size() / 3), number = py::ssize_t(faces.size());
  return py::make_tuple(array_from(std::move(vertices), {rows, 3}), lists,
                        array_from(std::move(beyond), {number}),
                        array_from(std::move(offsets), {number, 3}));
}

} // namespace

void python::define_cells(py::module_& m)
{
  m.def("cell_volumes", &cell_volumes);
  m.def("cell_facets", &cell_facets);
  m.def("solid_angles", &solid_angles);
  m.def("cell_polyhedron", &cell_polyhedron);
}
