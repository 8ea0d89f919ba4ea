// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_ORDERED_COMPLEX_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_ORDERED_COMPLEX_H

// Makes a complex whose vertices come in a given order, and starts it with four points.
//
// The point at place k of the order is vertex k + 1.

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Built.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Copy_vertex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Walk_to_conflict.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/exact_signs.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/obstacle_of_compiler.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/assertions.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/shared_words.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Holds affinely independent points: the first d + 1 of `points`, where d is the dimension of all
// points. Four are positively oriented.
struct Starting_simplex
{
  std::array<std::size_t, 4> points;
  int dimension; // -1 if there are no points
};

// Returns true if four points lie in a plane orthogonal to an axis, as coplanar points mostly do.
inline bool share_a_coordinate(const double* a, const double* b, const double* c, const double* d)
{
  for (int i = 0; i < 3; ++i)
    if (a[i] == b[i] && a[i] == c[i] && a[i] == d[i])
      return true;
  return false;
}

inline bool share_a_coordinate(Copy_place<false>, Copy_place<false>, Copy_place<false>,
                               Copy_place<false>)
{
  return false; // is for speed
}

// Returns the first such points among n, where point(i) returns the coordinates of the i-th. It is
// exact. Cost: O(n) at worst, a few tests as a rule.
template <class PointOf>
Starting_simplex starting_simplex(std::size_t n, const PointOf& point)
{
  std::size_t b = 1;
  while (b < n && are_equal(point(0), point(b)))
    ++b;
  std::size_t c = b + 1;
  while (c < n && are_collinear(point(0), point(b), point(c)))
    ++c;
  for (std::size_t d = c + 1; d < n; ++d) {
    if (share_a_coordinate(point(0), point(b), point(c), point(d)))
      continue;
    const int o = orientation(point(0), point(b), point(c), point(d));
    if (o != 0)
      return {o > 0 ? std::array<std::size_t, 4>{0, b, c, d}
                    : std::array<std::size_t, 4>{b, 0, c, d},
              3};
  }
  return {{0, b, c, 0}, n == 0 ? -1 : int(b < n) + int(c < n)};
}

// Starts a complex with such points, and notes their vertices in vertex_of. Returns one of the
// vertices, or 0 if the points lie in one plane.
template <class Vertex>
Id start_complex(const Starting_simplex& simplex, Compact_complex<Vertex>& complex,
                 std::vector<Id>& vertex_of)
{
  if (simplex.dimension < 3)
    return 0;
  std::array<Id, 4> v;
  for (std::size_t k = 0; k < 4; ++k)
    v[k] = vertex_of[simplex.points[k]] =
        Compact_complex<Vertex>::vertex_of_point(simplex.points[k]);
  CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT(orientation(position_of(complex.exact_place(v[0])),
                                                  position_of(complex.exact_place(v[1])),
                                                  position_of(complex.exact_place(v[2])),
                                                  position_of(complex.exact_place(v[3]))) > 0);
  complex.start(v);
  return v[0];
}

// Returns a point off the plane of a, b and c, which must not be collinear: a, moved by about the
// size of the triangle along the axis to which the plane seems most nearly orthogonal.
inline std::array<double, 3> apex_of_plane(const double* a, const double* b, const double* c)
{
  std::array<double, 3> areas; // seen along each axis, rounded: any but exactly 0 will do
  double size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t s = (k + 1) % 3, t = (k + 2) % 3;
    const double p[3] = {a[s], a[t], 0}, q[3] = {b[s], b[t], 0}, r[3] = {c[s], c[t], 0};
    const Row<double> u = row(q, p), v = row(r, p);
    const double area = std::abs(u.x * v.y - u.y * v.x);
    areas[k] = are_collinear(p, q, r) ? -1 : area >= 0 ? area : 0; // it is NaN on overflow
    size = (std::max)({size, std::abs(b[k] / 2 - a[k] / 2), std::abs(c[k] / 2 - a[k] / 2)});
  }
  std::array<double, 3> apex = {a[0], a[1], a[2]};
  double& x = apex[std::size_t(std::max_element(areas.begin(), areas.end()) - areas.begin())];
  const double moved = x < 0 ? x + size : x - size; // towards 0: it stays finite
  x = moved != x ? moved : x != 0 ? x / 2 : 1;
  return apex;
}

// Says where the walk to a point starts (Choi 2002, Fig. 1, line 2b): at a near point that the
// order names, or else at the point inserted before. Each worker has a copy, for its own points.
template <class Vertex>
class Starting_cells
{
public:
  // `places` is Order_view::starting_places. `vertex_of` has the vertex of each place, 0 until it
  // is inserted. `vertex` is any vertex of the complex. Keeps references to the first three.
  Starting_cells(const Compact_complex<Vertex>& complex, const std::vector<Id>& vertex_of,
                 const std::size_t* places, Id vertex)
    : m_complex(complex)
    , m_vertex_of(vertex_of)
    , m_places(places)
    , m_previous(vertex)
  {
  }

  // Returns a cell of the vertex at which the walk to the point at place i starts.
  Id start(std::size_t i) const
  {
    if (i == 0 || m_places == nullptr)
      return cell(m_previous);
    std::size_t place = m_places[i];
    Id v = load_relaxed(m_vertex_of[place]);
    while (v == 0 && place != 0) // another worker has not inserted it yet
      v = load_relaxed(m_vertex_of[place = m_places[place]]);
    return cell(v == 0 ? m_previous : v);
  }

  void after_update(std::size_t /* i */, Id v) { m_previous = v; }

private:
  Id cell(Id v) const
  {
    const Id c = load_relaxed(m_complex.vertex(v).cell);
    return Vertex::has_weight && is_dead(c) ? living_cell(c) : c;
  }
  bool is_dead(Id c) const
  {
    return (load_relaxed(m_complex.cell(c).v[0]) & Compact_numbers::dead) != 0;
  }

  // The cell of a vertex that others hide by now may be dead. The one inserted before, or hidden, has
  // a living cell, unless other workers destroyed it; then the next one that lives is taken, among
  // those known when the chunk began. If there is none, the walk clashes, and is put off.
  [[gnu::cold]] Id living_cell(Id dead) const
  {
    Id c = load_relaxed(m_complex.vertex(m_previous).cell);
    if (!is_dead(c))
      return c;
    c = dead;
    for (std::size_t left = m_complex.cells_end(); left > 0 && is_dead(c); --left)
      c = std::size_t(c) + 1 < m_complex.cells_end() ? Id(c + 1) : Id(0);
    return c;
  }

  const Compact_complex<Vertex>& m_complex;
  const std::vector<Id>& m_vertex_of;
  const std::size_t* const m_places;
  Id m_previous;
};

// Scales by the power of 2 that brings the largest absolute coordinate into [2^57, 2^58), or as
// near as the range of doubles allows. Differences are then less than 2^59 (Fixed_integer.h,
// balanced_signs.h), and as large as that allows, so that few cells are so small that products of
// their coordinates underflow. Cost: linear.
class Power_of_scale
{
public:
  // Chooses the power for the points and, unless it is null, one more point. Weights, unless they
  // are null, are scaled by its square.
  Power_of_scale(const Point_array& points, const double* one_more, const double* weights = nullptr,
                 const Executor& executor = Alone())
  {
    if (obstacle_of_compiler() != nullptr)
      return;
    m_is_lattice = true;
    if (one_more != nullptr)
      look_at(one_more);
    std::vector<Power_of_scale> parts(number_of_blocks(executor, points.size(), 4096), *this);
    for_each_block(executor, points.size(), parts.size(),
                   [&](std::size_t first, std::size_t last, std::size_t b) {
                     Power_of_scale part = parts[b];
                     for (std::size_t i = first; i < last; ++i)
                       part.look_at(points[i]);
                     parts[b] = part;
                   });
    for (const Power_of_scale& part : parts)
      add(part);
    if (weights != nullptr)
      look_at_weights(weights, points.size());
    choose();
  }

  // Chooses the power for coordinates whose absolute values are 0 or from `least` to `largest`, and n
  // weights.
  Power_of_scale(double largest, double least, const double* weights = nullptr, std::size_t n = 0)
    : m_largest(largest)
    , m_least(least)
  {
    if (obstacle_of_compiler() != nullptr)
      return;
    look_at_weights(weights, n);
    choose();
  }

  // Returns true if no coordinate is rounded, as only coordinates that become smaller can be.
  bool is_exact() const { return m_is_exact; }

  // Compact_complex::exact_size() of what was scaled. It is 0 if huge weights make the scaled unit so
  // small that determinants, which are multiples of its fifth power, might underflow.
  double exact_size() const
  {
    const double unit = std::ldexp(m_factor, m_unit);
    return m_is_lattice && m_is_exact && m_largest > 0 && unit > 0x1p-150 ? 0x1p19 * unit * unit
                                                                          : 0;
  }

  std::array<double, 3> operator()(const double* p) const
  {
    return {p[0] * m_factor, p[1] * m_factor, p[2] * m_factor};
  }
  double weight(double w) const { return w * m_factor * m_factor; }

  // Returns the point that was scaled to p, if that is exact.
  std::array<double, 3> before(const double* p) const
  {
    return {p[0] / m_factor, p[1] / m_factor, p[2] / m_factor};
  }

private:
  void look_at(const double* p)
  {
    for (int k = 0; k < 3; ++k) {
      const double size = std::abs(p[k]);
      m_largest = (std::max)(m_largest, size);
      m_least = size == 0 ? m_least : (std::min)(m_least, size);
    }
    for (int k = 0; m_is_lattice && k < 3; ++k)
      if (p[k] != 0)
        look_at_unit(Bits_of_double(p[k]).exponent);
  }

  // Takes what another one has seen.
  void add(const Power_of_scale& other)
  {
    m_largest = (std::max)(m_largest, other.m_largest);
    m_least = (std::min)(m_least, other.m_least);
    m_is_lattice = m_is_lattice && other.m_is_lattice;
    if (m_is_lattice)
      look_at_unit(other.m_unit);
  }

  // All are multiples of 2^exponent. A lattice that has so many of these across is of no use.
  void look_at_unit(int exponent)
  {
    m_unit = (std::min)(m_unit, exponent);
    m_is_lattice = m_largest < std::ldexp(1., m_unit + 32);
  }

  // The square root of their largest difference counts as a coordinate. They may be much larger
  // themselves, if only they stay finite.
  void look_at_weights(const double* weights, std::size_t n)
  {
    if (n == 0)
      return;
    const auto [least, most] = std::minmax_element(weights, weights + n);
    const double difference = *most - *least; // may overflow
    m_largest =
        (std::max)(m_largest, is_finite_number(difference) ? std::sqrt(difference)
                                                           : 2 * std::sqrt(*most / 4 - *least / 4));
    for (std::size_t i = 0; i < n; ++i) {
      const double size = std::abs(weights[i]);
      m_largest_weight = (std::max)(m_largest_weight, size);
      m_least_weight = size == 0 ? m_least_weight : (std::min)(m_least_weight, size);
      if (m_is_lattice && size != 0 && difference != 0)
        look_at_unit(int(std::floor(Bits_of_double(size).exponent / 2.)));
    }
  }

  void choose()
  {
    constexpr double least = (std::numeric_limits<double>::min)();
    int exponent = 0, of_weight = -1000;
    std::frexp(m_largest, &exponent);
    if (m_largest_weight > 0)
      std::frexp(m_largest_weight, &of_weight);
    m_factor = std::ldexp(1., (std::min)({58 - exponent, 1000, (1000 - of_weight) / 2}));
    m_is_exact = m_factor >= 1 || (m_least * m_factor > least && weight(m_least_weight) > least);
  }

  double m_largest = 0, m_least = (std::numeric_limits<double>::max)();
  double m_largest_weight = 0, m_least_weight = (std::numeric_limits<double>::max)();
  int m_unit = 1000; // all coordinates are multiples of 2^m_unit, and weights of its square,
  bool m_is_lattice = false; // if this is true
  double m_factor = 0;       // 0 if doubles cannot be trusted, so that no filter decides anything
  bool m_is_exact = false;
};

// Holds the complex that build() makes, as the core sees it.
template <class Vertex>
class Ordered_complex final : public Built
{
public:
  // Takes an order over.
  void keep(Insertion_order&& made)
  {
    m_order = std::move(made);
    order = view_of(m_order);
  }

  // Makes the complex of the points in the order and, unless it is null, of an apex in the place after
  // the last. Inserts the first four that do not lie in one plane. `weights` are those of the points,
  // if vertices have any.
  void start(const Point_array& points, const double* apex, const Executor& executor = Alone(),
             std::size_t most_cells = Compact_numbers::max_cells, const double* weights = nullptr)
  {
    using Coordinates = typename Compact_complex<Vertex>::Coordinates_of_point;
    has_apex = apex != nullptr;
    vertices.assign(order.size + has_apex, 0);
    const Power_of_scale scaled(points, apex, weights, executor);
    const auto point = [&](std::size_t k) {
      return k < order.size ? points[order.order[k]] : apex;
    };
    const auto with_weight = [&](const auto& p, [[maybe_unused]] std::size_t k,
                                 [[maybe_unused]] const auto& scale) -> Coordinates {
      if constexpr (Vertex::has_weight) // that of the apex does not matter, if it is no larger
        return {p[0], p[1], p[2], scale(weights[order.order[k < order.size ? k : 0]])};
      else
        return {p[0], p[1], p[2]};
    };
    complex = Compact_complex<Vertex>(
        vertices.size(),
        [&](std::size_t k) {
          return with_weight(scaled(point(k)), k, [&](double w) { return scaled.weight(w); });
        },
        executor);
    CGAL_DELAUNAY_FROM_SURFACE_3_ASSERT_EXPENSIVE(std::all_of(
        complex.vertices() + 1, complex.vertices() + complex.vertices_end(), [](const auto& v) {
          return std::all_of(v.coordinates, v.coordinates + 3,
                             [](double x) { return std::abs(x) <= 0x1p58; });
        }));
    if (!scaled.is_exact()) {
      std::vector<Coordinates> own;
      own.reserve(vertices.size());
      for (std::size_t k = 0; k < vertices.size(); ++k)
        own.push_back(with_weight(point(k), k, [](double w) { return w; }));
      complex.keep_own_coordinates(std::move(own));
    }
    complex.set_exact_size(scaled.exact_size());
    complex.limit_cells(most_cells);
    m_any_vertex = start_complex(starting_simplex(vertices.size(), point), complex, vertices);
    show();
  }

  // Does the same for copies of points in a periodic box (Box_of_points.h), which are scaled.
  template <class Source>
  void start_copies(Source& source, const Executor& executor, std::size_t most_cells)
  {
    const Point_array positions = source.points();
    vertices.assign(order.size, 0);
    complex = Compact_complex<Vertex>(
        order.size,
        [&](std::size_t k) {
          typename Compact_complex<Vertex>::Coordinates_of_point p;
          std::copy_n(positions[order.order[k]], 3, p.begin());
          if constexpr (Vertex::has_weight)
            p[3] = source.weight(order.order[k]);
          return p;
        },
        executor);
    auto copies = source.copies();
    for (std::size_t k = 0; k < order.size; ++k)
      copies.copies[k] = source.copies().copies[order.order[k]];
    complex.keep_own_coordinates(std::move(copies));
    complex.limit_cells(most_cells);
    const auto point = [&](std::size_t k) {
      return position_of(complex.exact_place(Compact_numbers::vertex_of_point(k)));
    };
    m_any_vertex = start_complex(starting_simplex(vertices.size(), point), complex, vertices);
    show();
  }

  // To be called after the complex has changed.
  void show()
  {
    vertex_of = vertices.data();
    number_of_places = vertices.size();
    cells = complex.cells();
    cells_end = complex.cells_end();
    vertices_end = complex.vertices_end();
  }

  Starting_cells<Vertex> starting_cells() const
  {
    return Starting_cells<Vertex>(complex, vertices, order.starting_places, m_any_vertex);
  }

  void release_cells(std::size_t first, std::size_t last) override
  {
    complex.memory_of_cells().release_before_end(first, last);
  }
  void give_up_cells() override { complex.memory_of_cells().deallocate(); }
  void give_up_vertices() override { complex.memory_of_vertices().deallocate(); }
  Id cell_of(std::size_t v) const override { return complex.vertex(v).cell; }
  Memory_of_cells take_cells() override
  {
    const std::size_t capacity = complex.memory_of_cells().capacity();
    return {complex.memory_of_cells().give_away(), capacity};
  }

  Compact_complex<Vertex> complex;
  std::vector<Id> vertices; // by place, 0 until the point is inserted

private:
  Insertion_order m_order;
  Id m_any_vertex = 0; // any vertex of the complex
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_ORDERED_COMPLEX_H
