// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Interpolates values at the vertices of a Delaunay triangulation: linearly in its tetrahedra, or
// between natural neighbours. One pass over the queries finds their tetrahedra, weights and sums.
//
// The natural neighbours of q are those whose Voronoi cells would share a facet with that of q. By
// Laplace's weights (Belikov, Ivanov, Kontorovich, Korytnik, Semenov 1997; Hiyoshi, Sugihara 1999;
// Sukumar, Moran, Semenov, Belikov 2001) each counts by the area of the facet over its distance. If
// q were inserted, tetrahedra (q, i, j, k) would fill its conflict zone, one at each facet of that.
// With q as the origin, let w be squared lengths, and let two of these facets, (i, j, k) and (j, i,
// l), meet in an edge. A Voronoi edge of q joins the centres of the two spheres. It is as long as
// |i x j| t / 2 with
//   t = D / (V V'),  D = |i j k l| in the columns x, y, z, w,  V = |i j k|, V' = |j i l|,
// and seen from the midpoint of (q, i) it is j · (j - i) |i| / (2 |i x j|) away, in the facet
// between q and i. So without roots
//   8 area_i / |i| = Σ t j · (j - i), over all edges (i, j).
// The sum over all i is that of t |i - j|^2, where nothing cancels; errors are measured by it. Ties
// are decided as in the triangulation, so that each V is positive, and each D at least 0. Where D
// is 0, as in a lattice, the Voronoi edge has no length, and the sums do not depend on the decision.
//
// On the hull the cell of q is unbounded, and the weights are the limits from inside. If q is 1/s away
// from the plane of some facets, their V is proportional to 1/s, and so are the D of edges between two
// of them. So these edges and those around the facets have a t proportional to s, and only they count:
// with plane coordinates x and y,
//   t = |1 i j k l| / (|1 i j k| |1 j i l|), in the columns 1, x, y, w, and 1, x, y, or
//   t = |i j k| / (|1 i j k| |i j|), in the columns x, y, w, and 1, x, y, and x, y.
// If q is on an edge of the hull, this edge alone counts, and weights are linear on it.

#include "Corners.h"
#include "Unlocked.h"
#include "functions.h"
#include "interruptible.h"
#include "numpy_rows.h"

#include <CGAL/Delaunay_from_surface_3/arrays/Find_simplex.h>
#include <CGAL/Delaunay_from_surface_3/arrays/measures_of_simplices.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/exact_signs.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Sort_by_halves.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
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
using python::Point_of;
using python::Points;
using python::Rows;

using Point = std::array<double, 3>;
using Reals = py::array_t<double, py::array::c_style>;
using Places = py::array_t<std::int64_t, py::array::c_style>;
using View = core::Simplices_view<Index>;

[[noreturn]] void refuse_triangulation()
{
  throw std::invalid_argument("the simplices are not the Delaunay triangulation of the points");
}

void check_point(const Point& p)
{
  for (const double x : p)
    if (!core::is_finite_number(x))
      throw std::invalid_argument("a coordinate of a point is not a finite number any more");
}

// The rows of values at the points.
struct Values
{
  const double* data;
  std::size_t columns;

  explicit Values(const Reals& values)
    : data(values.data())
    , columns(std::size_t(values.shape(1)))
  {
  }

  const double* row(Index v) const { return data + columns * std::size_t(v); }
  bool are_finite(Index v) const
  {
    return std::all_of(row(v), row(v) + columns, [](double x) { return std::isfinite(x); });
  }

  // Adds the row of v. A value that is not finite counts only where its weight is more than `least`.
  void add(double weight, Index v, double* to, double least = 0) const
  {
    for (std::size_t j = 0; weight != 0 && j < columns; ++j)
      if (const double x = row(v)[j]; std::isfinite(x) || weight > least)
        to[j] += weight * x;
  }
};

// Finds the vertex nearest to a point, for one thread, from the last one found: no vertex is nearer
// than all its neighbours in a Delaunay triangulation unless it is the nearest of all.
class Nearest_vertex
{
public:
  // Keeps pointers to both arrays: the neighbours of v are items[first[v]], …, items[first[v + 1] - 1].
  // Looking at one is a step.
  Nearest_vertex(Point_of point_of, const Places& first, const Numbers& items, Index any)
    : m_point_of(point_of)
    , m_first(first.data())
    , m_items(items.data())
    , m_number(first.size() - 1)
    , m_number_of_items(items.size())
    , m_last(any)
  {
  }

  // Returns the one with the smallest number of several.
  Index operator()(const Point& q, core::Steps& step)
  {
    for (bool is_nearest = false; !is_nearest;) {
      const Index v = m_last;
      for_neighbors(v, step, [&](Index u) {
        const int sign = compare(q, u, m_last);
        m_last = sign < 0 ? u : m_last;
      });
      is_nearest = m_last == v;
    }
    // Those at the same distance are on an empty sphere, and joined by edges.
    m_equal.clear();
    m_equal.add(m_last);
    for (std::size_t i = 0; i < m_equal.items().size(); ++i)
      for_neighbors(m_equal.items()[i], step, [&](Index u) {
        if (!m_equal.has(u) && compare(q, u, m_last) == 0)
          m_equal.add(u);
      });
    return *std::min_element(m_equal.items().begin(), m_equal.items().end());
  }

private:
  template <class Visit>
  void for_neighbors(Index v, core::Steps& step, const Visit& visit) const
  {
    const std::int64_t first = m_first[v], last = m_first[v + 1];
    if (first < 0 || last > m_number_of_items)
      refuse_triangulation();
    for (std::int64_t i = first; i < last; ++i) {
      const Index u = m_items[i];
      if (u < 0 || u >= m_number)
        refuse_triangulation();
      visit(u);
      step();
    }
  }

  // Compares the distances of two vertices.
  int compare(const Point& q, Index u, Index v) const
  {
    const Point a = m_point_of(std::size_t(u)), b = m_point_of(std::size_t(v));
    const double s = core::squared_distance(a.data(), q.data()),
                 t = core::squared_distance(b.data(), q.data());
    // Each is off by at most 5 roundings; underflow is negligible.
    if (s + t > 1e-200 && s + t < 1e300 && std::abs(s - t) > 0x1p-49 * (s + t))
      return s < t ? -1 : 1;
    check_point(a);
    check_point(b);
    const double* const places[2] = {a.data(), b.data()};
    const core::Big_differences<2> from(places, q.data());
    return sign_of(from.rows[0].w - from.rows[1].w);
  }

  const Point_of m_point_of;
  const std::int64_t* const m_first;
  const Index* const m_items;
  const std::int64_t m_number, m_number_of_items;
  Index m_last;
  core::Short_set<Index> m_equal;
};

// Returns a bound on the error of a number.
template <class Numbers, int N, class Place, class Number>
double error_in(const core::Bounded_rows<Numbers, N, Place>&, const Number& n)
{
  return Numbers::error * n.size + 0x1p-1000;
}
template <int N, class Place, class Number>
double error_in(const core::Integer_rows<N, Place>&, const Number&)
{
  return 0;
}

// What an edge (i, j), with the apices k and l of its two facets, adds to the weights of i and j. All are
// numbers of vertices of the conflict zone. The weights may be of any size, and have an exponent.
struct Share
{
  std::size_t ends[2], apices[2];
  double weights[2] = {0, 0};
  double error = std::numeric_limits<double>::infinity();
  int exponent = 0;

  double total() const { return weights[0] + weights[1]; }
  double shifted(double number, int to) const
  {
    return exponent == to ? number : std::ldexp(number, exponent - to);
  }

  // Sets the weights to |d / (u v)|, of this degree, times j · (j - i) and i · (i - j), where i and j are
  // the first rows.
  template <class Rows, class Number>
  void set(const Rows& in, const Number& d, const Number& u, const Number& v, int degree)
  {
    const auto &i = in.rows[0], &j = in.rows[1];
    const Number ij = i.x * j.x + i.y * j.y + i.z * j.z;
    const Number factors[2] = {j.w - ij, i.w - ij};
    const core::Scaled_double over = in.rounded(d), first = in.rounded(u), second = in.rounded(v);
    const core::Scaled_double by[2] = {in.rounded(factors[0]), in.rounded(factors[1])};
    const auto over_both = [&](double n) {
      return n / std::abs(first.value) / std::abs(second.value);
    };
    const double relative =
        error_in(in, u) / std::abs(first.value) + error_in(in, v) / std::abs(second.value);
    const double t = over_both(std::abs(over.value));
    const double error_of_t = 2 * over_both(error_in(in, d)) + 2 * relative * t;
    const int largest = (std::max)(by[0].exponent, by[1].exponent);
    exponent = over.exponent - first.exponent - second.exponent + largest + (degree + 2) * in.unit;
    error = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      const double factor = by[k].exponent == largest
                                ? by[k].value
                                : std::ldexp(by[k].value, by[k].exponent - largest);
      weights[k] = t * factor;
      error += (t + error_of_t) * error_in(in, factors[k]) + error_of_t * std::abs(factor);
    }
    if (!(relative < .25) || !std::isfinite(total()))
      error = std::numeric_limits<double>::infinity();
  }
};

// Finds the natural neighbours of a point and their weights, for one thread.
class Natural_neighbors
{
public:
  Natural_neighbors(const View& simplices, Point_of point_of)
    : m_simplices(simplices)
    , m_point_of(point_of)
  {
  }

  // Adds the values of the neighbours of q, which lies in simplex c. Those that are not finite count
  // where weights are greater than their errors.
  void operator()(const Point& q, Index c, const Values& values, double* to, core::Steps& step)
  {
    for (std::size_t k = 0; k < 4; ++k) {
      const auto v = m_simplices.vertex(std::size_t(c), k);
      if (m_point_of(v) == q)
        return values.add(1, Index(v), to);
    }
    dig(q, c, step);
    if (!m_hull.empty())
      weigh_in_plane(q);
    else
      weigh_in_space(q);
    double sum = 0;
    for (const double weight : m_weights)
      sum += weight;
    for (std::size_t i = 0; i < m_vertices.size(); ++i)
      values.add(m_weights[i] / sum, m_vertices[i], to, 1e-12);
  }

private:
  using Facet = std::array<std::size_t, 3>;

  struct Half_edge
  {
    std::uint64_t edge; // the same for both
    std::size_t from, to, apex;
  };

  // Finds the facets of the conflict zone, with corners numbered, and its vertices.
  void dig(const Point& q, Index c, core::Steps& step)
  {
    m_zone.clear();
    m_zone.add(c);
    m_facets.clear();
    m_hull.clear();
    for (std::size_t i = 0; i < m_zone.items().size(); ++i, step(16))
      for (unsigned k = 0; k < 4; ++k) {
        const auto inside = std::size_t(m_zone.items()[i]);
        const Index d = m_simplices.neighbor(inside, k);
        if (d >= 0 && m_zone.has(d))
          continue;
        if (d >= 0 && is_in_conflict(d, q)) {
          m_zone.add(d);
          continue;
        }
        Facet facet;
        for (std::size_t j = 0; j < 3; ++j)
          facet[j] = m_simplices.vertex(inside, core::facet_corners[k][j]);
        (d < 0 && side(facet, q) == 0 ? m_hull : m_facets).push_back(facet);
      }
    number_vertices();
  }

  // Returns whether q is in the sphere of simplex d, by ties as in the triangulation.
  bool is_in_conflict(Index d, const Point& q) const
  {
    Point corners[4];
    const double* places[4];
    core::Row<double> rows[4];
    double m = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      corners[k] = m_point_of(m_simplices.vertex(std::size_t(d), k));
      places[k] = corners[k].data();
      rows[k] = core::row(places[k], q.data());
      m = (std::max)(m, rows[k].w);
    }
    const bool is_scaled = m_has_filter && m < 0x1p116;
    int sign = is_scaled ? core::sphere_sign_by_either(rows[0], rows[1], rows[2], rows[3]) : 0;
    if (sign == 0) {
      for (const Point& corner : corners)
        check_point(corner);
      sign = is_scaled ? core::exact_sign<core::Exact_sphere>(places, q.data()).sign
                       : core::wide_sign<core::Exact_sphere>(places, q.data()).sign;
    }
    return sign > 0;
  }

  int side(const Facet& facet, const Point& q) const
  {
    const Point a = m_point_of(facet[0]), b = m_point_of(facet[1]), c = m_point_of(facet[2]);
    return core::orientation(q.data(), a.data(), b.data(), c.data());
  }

  // Numbers the corners of the facets.
  void number_vertices()
  {
    m_vertices.clear();
    for (const auto* facets : {&m_facets, &m_hull})
      for (const Facet& facet : *facets)
        for (const std::size_t v : facet)
          m_vertices.push_back(Index(v));
    std::sort(m_vertices.begin(), m_vertices.end());
    m_vertices.erase(std::unique(m_vertices.begin(), m_vertices.end()), m_vertices.end());
    for (auto* facets : {&m_facets, &m_hull})
      for (Facet& facet : *facets)
        for (std::size_t& v : facet)
          v = std::size_t(std::lower_bound(m_vertices.begin(), m_vertices.end(), Index(v)) -
                          m_vertices.begin());
    m_places.clear();
    for (const Index v : m_vertices)
      m_places.push_back(m_point_of(std::size_t(v)));
    m_weights.assign(m_vertices.size(), 0);
  }

  // Sets the half-edges of facets, so that those of an edge follow each other.
  void find_edges(const std::vector<Facet>& facets)
  {
    m_edges.clear();
    for (const Facet& f : facets)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint64_t i = f[k], j = f[(k + 1) % 3];
        m_edges.push_back(
            {(std::min)(i, j) << 32 | (std::max)(i, j), f[k], f[(k + 1) % 3], f[(k + 2) % 3]});
      }
    std::sort(m_edges.begin(), m_edges.end(), [](const Half_edge& a, const Half_edge& b) {
      return a.edge != b.edge ? a.edge < b.edge : a.from < b.from;
    });
  }
  bool is_double(std::size_t e) const
  {
    return e + 1 < m_edges.size() && m_edges[e].edge == m_edges[e + 1].edge &&
           m_edges[e].from == m_edges[e + 1].to;
  }

  void weigh_in_space(const Point& q)
  {
    find_edges(m_facets);
    m_shares.clear();
    for (std::size_t e = 0; e < m_edges.size(); e += 2) {
      if (!is_double(e))
        refuse_triangulation();
      add_share(m_edges[e], m_edges[e + 1]);
    }
    add_shares(q, [](Share& share, const auto& in) {
      using Number = std::decay_t<decltype(in.rows[0].x)>;
      const auto &i = in.rows[0], &j = in.rows[1], &k = in.rows[2], &l = in.rows[3];
      const core::Sphere_cofactors<Number> cofactors(i, j, k, l);
      share.set(in, Number(cofactors.lifted(i, j, k, l)), Number(cofactors.of[2]),
                Number(cofactors.of[3]), -1);
    });
  }

  void add_share(const Half_edge& edge, const Half_edge& back)
  {
    m_shares.push_back({{edge.from, edge.to}, {edge.apex, back.apex}});
  }

  // Leaves the facets in one plane: on an edge of the hull q has those of several.
  void keep_one_plane()
  {
    const Facet first = m_hull[0];
    const auto is_apart = [&](std::size_t v) {
      return core::orientation(place(v), place(first[0]), place(first[1]), place(first[2])) != 0;
    };
    const auto is_in_another = [&](const Facet& f) {
      return std::any_of(f.begin(), f.end(), is_apart);
    };
    m_hull.erase(std::remove_if(m_hull.begin(), m_hull.end(), is_in_another), m_hull.end());
  }

  void weigh_in_plane(const Point& q)
  {
    keep_one_plane();
    find_edges(m_hull);
    m_shares.clear();
    for (std::size_t e = 0; e < m_edges.size(); e += is_double(e) ? 2 : 1) {
      const Half_edge& edge = m_edges[e];
      if (!is_double(e) && core::are_collinear(q.data(), place(edge.from), place(edge.to)))
        return weigh_on_edge(q, edge.from, edge.to);
      add_share(edge, is_double(e) ? m_edges[e + 1] : edge);
    }
    add_shares(q, [normal = axis_of_plane()](Share& share, const auto& in) {
      using Number = std::decay_t<decltype(in.rows[0].x)>;
      core::Row<Number> rows[4]; // (x, y, w) in the plane
      for (std::size_t k = 0; k < 4; ++k) {
        const std::array<Number, 3> v = core::vector_of(in.rows[k]);
        rows[k].x = v[(normal + 1) % 3];
        rows[k].y = v[(normal + 2) % 3];
        rows[k].z = in.rows[k].w;
      }
      const auto &i = rows[0], &j = rows[1], &k = rows[2], &l = rows[3];
      const auto area = [](const auto& a, const auto& b, const auto& c) {
        return Number(core::minor_of(a, b) + core::minor_of(b, c) + core::minor_of(c, a));
      };
      const Number ijk = core::determinant_of(i, j, k);
      if (share.apices[0] == share.apices[1])
        return share.set(in, ijk, area(i, j, k), Number(core::minor_of(i, j)), 0);
      const Number ikl = core::determinant_of(i, k, l), ijl = core::determinant_of(i, j, l),
                   jkl = core::determinant_of(j, k, l);
      share.set(in, Number((jkl - ikl) + (ijl - ijk)), area(i, j, k), area(j, i, l), 0);
    });
  }

  // Returns the axis along which the projection of the plane has the largest area.
  std::size_t axis_of_plane() const
  {
    std::size_t axis = 0;
    const double* const places[2] = {place(m_hull[0][1]), place(m_hull[0][2])};
    core::measure_in_stages<2>(places, place(m_hull[0][0]), [&](const auto& in) {
      using Rows = std::decay_t<decltype(in)>;
      const auto n = core::cross(core::vector_of(in.rows[0]), core::vector_of(in.rows[1]));
      axis = core::largest_of<Rows>(n);
      return core::is_known<Rows>(n);
    });
    return axis;
  }

  // Weighs by distances along one axis: that in which the ends differ most. There huge coordinates are
  // scaled, whose differences might overflow.
  void weigh_on_edge(const Point& q, std::size_t i, std::size_t j)
  {
    const Point &a = m_places[i], &b = m_places[j];
    double most = 0; // a fourth of the difference
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool is_huge = (std::max)(std::abs(a[axis]), std::abs(b[axis])) > 0x1p1000;
      const double scale = is_huge ? .25 : 1;
      const double from = scale * a[axis], at = scale * q[axis], to = scale * b[axis];
      const double difference = std::abs(to - from) * (is_huge ? 1 : .25);
      if (difference < most || to == from)
        continue;
      most = difference;
      m_weights[i] = std::abs(to - at);
      m_weights[j] = std::abs(at - from);
    }
  }

  // Calls set(share, rows) with the rows of one stage: in doubles, in sums of two, or in integers.
  template <class Set>
  void measure(Share& share, int stage, const Point& q, const Set& set) const
  {
    using Place = const double*;
    using Sums = core::Bounded_double_doubles<core::Portable_products>;
    const Place places[4] = {place(share.ends[0]), place(share.ends[1]), place(share.apices[0]),
                             place(share.apices[1])};
    if (stage == 0)
      set(share, core::Bounded_rows<core::Bounded_doubles, 4, Place>(places, q.data()));
    else if (stage == 1)
      set(share, core::Bounded_rows<Sums, 4, Place>(places, q.data()));
    else
      set(share, core::Integer_rows<4, Place>(places, q.data()));
  }

  // Sets the shares by as many stages as it takes, and adds them to the weights.
  template <class Set>
  void add_shares(const Point& q, const Set& set)
  {
    for (Share& share : m_shares)
      measure(share, 0, q, set);
    for (int stage = 1; stage < 3; ++stage) {
      const int exponent = largest_exponent();
      double least = 0; // of the sum
      for (const Share& share : m_shares)
        if (share.total() > share.error)
          least += share.shifted(share.total() - share.error, exponent);
      for (Share& share : m_shares)
        if (!(share.shifted(share.error, exponent) <= 0x1p-46 * least))
          measure(share, stage, q, set);
    }
    const int exponent = largest_exponent();
    for (const Share& share : m_shares)
      for (std::size_t k = 0; k < 2; ++k)
        m_weights[share.ends[k]] += share.shifted(share.weights[k], exponent);
  }

  // Returns that of the largest share that is known.
  int largest_exponent() const
  {
    int largest = (std::numeric_limits<int>::min)();
    for (const Share& share : m_shares)
      if (share.total() > share.error)
        largest = (std::max)(largest, share.exponent + std::ilogb(share.total()));
    return largest == (std::numeric_limits<int>::min)() ? 0 : largest;
  }

  const double* place(std::size_t v) const { return m_places[v].data(); }

  const View m_simplices;
  const Point_of m_point_of;
  const bool m_has_filter = core::obstacle_of_compiler() == nullptr;
  core::Short_set<Index> m_zone;
  std::vector<Facet> m_facets, m_hull; // m_hull are those on the hull in a plane with q
  std::vector<Index> m_vertices;
  std::vector<Point> m_places;
  std::vector<double> m_weights;
  std::vector<Half_edge> m_edges;
  std::vector<Share> m_shares;
};

// Adds the values of the corners of a simplex by the barycentric coordinates.
class Corners
{
public:
  Corners(const View& simplices, Point_of point_of)
    : m_simplices(simplices)
    , m_point_of(point_of)
  {
  }

  void operator()(const Point& q, Index c, const Values& values, double* to, core::Steps&) const
  {
    Point corners[4];
    Index v[4];
    bool are_finite = true;
    for (std::size_t k = 0; k < 4; ++k) {
      v[k] = Index(m_simplices.vertex(std::size_t(c), k));
      corners[k] = m_point_of(std::size_t(v[k]));
      are_finite = are_finite && values.are_finite(v[k]);
    }
    const std::array<double, 4> weights = core::barycentric_of(corners, q, !are_finite);
    for (std::size_t k = 0; k < 4; ++k)
      values.add(weights[k], v[k], to);
  }

private:
  const View m_simplices;
  const Point_of m_point_of;
};

bool is_finite_point(const double* p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

// Interpolates at some queries, which it sorts in space. Outside the hull a query gets the values
// of the nearest vertex, if `nearest` is not null, or `fill`.
template <class Method>
void interpolate_block(const View& view, Point_of point_of, const core::Point_array& queries,
                       std::vector<std::size_t>& order, const Values& values, const double* fill,
                       Nearest_vertex* nearest, const core::Executor& executor, double* results)
{
  core::Sort_by_halves()(queries, order.data(), order.data() + order.size());
  core::Find_simplex<Index, Point_of> find(view, point_of);
  Method method(view, point_of);
  core::Steps step(executor);
  for (const std::size_t i : order) {
    step(64); // about as many cells are on the way
    const Point q = {queries[i][0], queries[i][1], queries[i][2]};
    double* const to = results + values.columns * i;
    const Index c = find(q);
    if (c >= 0 || nearest != nullptr)
      std::fill(to, to + values.columns, -0.); // to which 0 and -0 may be added
    if (c >= 0)
      method(q, c, values, to, step);
    else if (nearest != nullptr)
      values.add(1, (*nearest)(q, step), to);
    else
      std::copy(fill, fill + values.columns, to);
  }
}

// Returns NaN for queries that are not finite. Takes them in groups, so that they are not all
// copied at once.
template <class Method>
py::array interpolated(const Points& points, const Numbers& simplices, const Numbers& neighbors,
                       const Reals& values, const Reals& fill, const py::object& lists,
                       const Points& queries, std::size_t threads)
{
  python::refuse_obstacle();
  const Rows vertices(simplices), across(neighbors);
  const auto n = std::size_t(points.shape(0));
  if (vertices.corners() != 4 || across.corners() != 4 || vertices.size() != across.size() ||
      vertices.size() == 0)
    throw py::value_error("interpolation: expected tetrahedra");
  if (values.ndim() != 2 || std::size_t(values.shape(0)) != n || fill.ndim() != 1 ||
      fill.shape(0) != values.shape(1))
    throw py::value_error("interpolation: expected values for each point");
  Places first_neighbors;
  Numbers items;
  const bool has_nearest = !lists.is_none();
  if (has_nearest)
    std::tie(first_neighbors, items) = lists.cast<std::pair<Places, Numbers>>();
  if (has_nearest && std::size_t(first_neighbors.size()) != n + 1)
    throw py::value_error("interpolation: expected the neighbours of each point");
  const View view = {vertices.data(),
                     vertices.stride(),
                     across.data(),
                     across.stride(),
                     vertices.size(),
                     vertices.size(),
                     n};
  const Point_of point_of = {python::Points_view(points)};
  const Values rows(values);
  const core::Rounding_to_nearest rounding;
  const python::Interruptible_executor executor(threads);
  const auto number = std::size_t(queries.shape(0));
  std::vector<double> results(rows.columns * number, core::no_measure), coordinates;
  constexpr std::size_t group = 1 << 20;
  for (std::size_t begin = 0; begin < number; begin += group) {
    const std::size_t size = (std::min)(group, number - begin);
    const python::Points_view copied(queries, begin);
    coordinates.resize(3 * size);
    for (std::size_t i = 0; i < 3 * size; ++i)
      coordinates[i] = copied(i / 3, i % 3);
    const python::Unlocked unlocked;
    const core::Point_array of_group(coordinates.data(), size);
    core::for_each_block(
        executor, size, core::number_of_blocks(executor, size, 256),
        [&](std::size_t first, std::size_t last, std::size_t) {
          std::vector<std::size_t> order;
          for (std::size_t i = first; i < last; ++i)
            if (is_finite_point(of_group[i]))
              order.push_back(i);
          Nearest_vertex nearest(point_of, first_neighbors, items, Index(view.vertex(0, 0)));
          interpolate_block<Method>(view, point_of, of_group, order, rows, fill.data(),
                                    has_nearest ? &nearest : nullptr, executor,
                                    results.data() + rows.columns * begin);
        });
  }
  return array_from(std::move(results), {py::ssize_t(number), py::ssize_t(rows.columns)});
}

// Returns the gradients of linear functions with these values at the corners of simplices: an array of
// shape (q, 3, k). Where the number of a simplex is negative they are NaN.
template <class CornerOf>
py::array gradients_at(const CornerOf& corner_of, const Rows& vertices, std::size_t n,
                       const Values& rows, const Numbers& simplices_of_queries, std::size_t threads)
{
  const auto number = std::size_t(simplices_of_queries.shape(0));
  const auto simplex_of = simplices_of_queries.unchecked<1>();
  std::vector<double> result(3 * rows.columns * number, core::no_measure);
  {
    const python::Unlocked unlocked;
    const python::Interruptible_executor executor(threads);
    core::for_each_block(
        executor, number, core::number_of_blocks(executor, number, 4096),
        [&](std::size_t first, std::size_t last, std::size_t) {
          core::Steps step(executor);
          for (std::size_t q = first; q < last; ++q, step(rows.columns + 1)) {
            const Index c = simplex_of(py::ssize_t(q));
            if (c < 0)
              continue;
            if (std::size_t(c) >= vertices.size())
              throw std::out_of_range("interpolation: there is no simplex " + std::to_string(c));
            Index v[4];
            decltype(corner_of(0, 0, 0)) corners[4];
            for (std::size_t k = 0; k < 4; ++k) {
              v[k] = vertices.number(std::size_t(c), k, n);
              corners[k] = corner_of(std::size_t(c), k, std::size_t(v[k]));
            }
            const std::array<Point, 3> of_weights = core::gradients_of(corners);
            double* to = result.data() + 3 * rows.columns * q;
            for (std::size_t i = 0; i < 3; ++i)
              for (std::size_t j = 0; j < rows.columns; ++j) {
                double sum = 0;
                for (std::size_t k = 0; k < 3; ++k)
                  if (const double d = rows.row(v[k])[j] - rows.row(v[3])[j]; d != 0)
                    sum += d * of_weights[k][i]; // which may be infinite
                *to++ = sum;
              }
          }
        });
  }
  return array_from(std::move(result), {py::ssize_t(number), 3, py::ssize_t(rows.columns)});
}

// Does so without a box, or in one: a gradient is the same in all copies of a simplex.
py::array linear_gradients(const Points& points, const Numbers& simplices, const py::object& in_box,
                           const Reals& values, const Numbers& simplices_of_queries,
                           std::size_t threads)
{
  const Rows vertices(simplices);
  const auto n = std::size_t(points.shape(0));
  if (vertices.corners() != 4 || values.ndim() != 2 || std::size_t(values.shape(0)) != n)
    throw py::value_error("interpolation: expected values at the corners of tetrahedra");
  const Values rows(values);
  const auto at_corners = [&](const auto& corner_of) {
    return gradients_at(corner_of, vertices, n, rows, simplices_of_queries, threads);
  };
  if (in_box.is_none())
    return at_corners(python::Corners_of_points<false>(points, nullptr));
  const python::In_box box(in_box, vertices);
  return at_corners(python::Corners_in_box<false>(points, nullptr, box));
}

} // namespace

void python::define_interpolation(py::module_& m)
{
  m.def("interpolate_linearly", &interpolated<Corners>);
  m.def("interpolate_naturally", &interpolated<Natural_neighbors>);
  m.def("linear_gradients", &linear_gradients);
}
