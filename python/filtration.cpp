// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The simplices of all dimensions of a triangulation, with the values at which they enter its alpha
// complex (Edelsbrunner, Mücke 1994; with weights Edelsbrunner 1992).
//
// Through the corners of a simplex goes a smallest sphere; with weights it is orthogonal to the
// spheres around the corners. Its squared radius is the value of the simplex if no other point is
// inside, and else the least value of a coface. A point is inside if and only if the vertex opposite
// in some coface is, and that is where the centre of the coface's sphere lies beyond the simplex: with
// weights, too, the vertex has a power to the sphere of the simplex of twice its own height above it
// times that of the centre. So each simplex tells which of its faces its centre is beyond. These signs
// are exact; values are right up to the last digit.

#include "Corners.h"
#include "functions.h"
#include "interruptible.h"
#include "numpy_rows.h"

#include <CGAL/Delaunay_from_surface_3/arrays/measures_of_simplices.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace py = pybind11;
namespace core = CGAL::Delaunay_from_surface_3::core;

namespace {

using python::array_from;
using python::In_box;
using python::Index;
using python::Numbers;
using python::Points;
using python::Rows;

// The stages state errors of products that go through 17 roundings; here these are up to 30. So
// signs and values are only known if twice that error is small enough.
constexpr double for_signs = 0.5, for_values = 0x1p-58;

template <class Corner>
constexpr bool has_weight = core::is_weighted<decltype(core::place_of(std::declval<Corner>()))>;

// A smallest sphere by its centre: the barycentric coordinates, and the square of the distance from
// the first corner, which are quotients of these.
template <class Number, std::size_t K>
struct Center
{
  std::array<Number, K> coordinates; // times twice the denominator
  Number square, denominator;        // four times the square
};

// Finds the centre from the differences of the other corners from the first; their lifts w are
// squares plus the weight of the first less their own.
template <std::size_t K, class In>
auto center_of(const In& in)
{
  using core::cross;
  using core::dot;
  Center<typename In::Number, K> c;
  const auto u = core::vector_of(in.rows[0]);
  const auto& s = in.rows[0].w;
  if constexpr (K == 2) {
    c.denominator = dot(u, u);
    c.coordinates[1] = s;
    c.square = s * s;
  } else if constexpr (K == 3) {
    const auto v = core::vector_of(in.rows[1]), n = cross(u, v);
    const auto& t = in.rows[1].w;
    const auto uv = dot(u, v);
    c.denominator = dot(n, n);
    c.coordinates[1] = s * dot(v, v) - t * uv;
    c.coordinates[2] = t * dot(u, u) - s * uv;
    c.square = s * c.coordinates[1] + t * c.coordinates[2];
  } else {
    const auto v = core::vector_of(in.rows[1]), w = core::vector_of(in.rows[2]);
    const auto p = cross(v, w), q = cross(w, u), r = cross(u, v);
    auto n = p;
    for (std::size_t i = 0; i < 3; ++i)
      n[i] = s * p[i] + in.rows[1].w * q[i] + in.rows[2].w * r[i];
    const auto six = dot(u, p);
    c.denominator = six * six;
    c.coordinates = {six, dot(n, p), dot(n, q), dot(n, r)};
    c.square = dot(n, n);
  }
  c.coordinates[0] = c.denominator + c.denominator;
  for (std::size_t k = 1; k < K; ++k)
    c.coordinates[0] = c.coordinates[0] - c.coordinates[k];
  return c;
}

// Sets bit k if the centre is beyond the facet opposite to corner k. Returns whether that is sure.
template <std::size_t K, class In>
bool find_facets(const In& in, const Center<typename In::Number, K>& center, unsigned& beyond)
{
  beyond = 0;
  for (std::size_t k = 0; k < K; ++k) {
    const auto& coordinate = center.coordinates[k];
    if (!in.is_known(coordinate, coordinate, for_signs))
      return false;
    beyond |= unsigned(in.rounded(coordinate).value < 0) << k;
  }
  return true;
}

// Represents (high + low) 2^exponent.
struct Two_doubles
{
  double high, low;
  int exponent;
};

template <class Products>
Two_doubles in_two_doubles(const core::Bounded_number<core::Double_double<Products>>& n)
{
  return {n.value.high, n.value.low, 0};
}
Two_doubles in_two_doubles(const core::Big_integer& n)
{
  Two_doubles result = {0, 0, 0};
  result.high = n.scaled_double(result.exponent);
  int exponent;
  const double rest =
      (n - core::Big_integer(result.high, -result.exponent)).scaled_double(exponent);
  result.low = std::ldexp(rest, exponent - result.exponent);
  return result;
}

// Returns n 2^exponent / d, rounded little more than once.
double quotient_of(const Two_doubles& n, const Two_doubles& d, int exponent)
{
  const double q = n.high / d.high, product = q * d.high;
  const double error = core::Portable_products::error(q, d.high, product);
  const double rest = ((n.high - product) - error) + (n.low - q * d.low);
  return std::ldexp(q + rest / d.high, n.exponent - d.exponent + exponent);
}

// Sets the squared radius, divided by 4^exponent. Returns whether it has its digits. With weights the
// last row has the weight of the first corner as lift.
template <std::size_t K, class In>
bool find_value(const In& in, const Center<typename In::Number, K>& center, int exponent,
                double& value)
{
  const auto& d = center.denominator;
  auto n = center.square;
  if constexpr (std::extent_v<decltype(in.rows)> == K) {
    const auto twice = in.rows[K - 1].w + in.rows[K - 1].w;
    n = n - d * (twice + twice);
  }
  if (!in.is_known(n, n, for_values) || !in.is_known(d, d, for_values))
    return false;
  value = quotient_of(in_two_doubles(n), in_two_doubles(d), 2 * (in.unit - 1 - exponent));
  return true;
}

// What is asked for of the smallest sphere of a simplex.
struct Sphere
{
  double value = core::no_measure;
  unsigned beyond = 0;
};

// The corners of a simplex but the first, as this sees them; where values are computed with weights
// there is one more, the first without its weight.
template <std::size_t K, bool has_values, class Corner>
class Seen_from_first
{
public:
  static constexpr std::size_t size = K - 1 + (has_values && has_weight<Corner> ? 1 : 0);
  using Place = decltype(core::place_of(std::declval<const Corner&>()));

  // Keeps pointers.
  explicit Seen_from_first(const std::array<Corner, K>& corners)
    : origin(core::place_of(corners[0]))
  {
    for (std::size_t k = 1; k < K; ++k)
      others[k - 1] = core::place_of(corners[k]);
    if constexpr (size == K && core::is_copy<Place>) {
      std::copy_n(origin.point, 3, m_bare);
      others[K - 1] = origin;
      others[K - 1].point = m_bare;
    } else if constexpr (size == K) {
      std::copy_n(&origin[0], 3, m_bare);
      others[K - 1] = Place(m_bare);
    }
  }
  Seen_from_first(const Seen_from_first&) = delete;
  Seen_from_first& operator=(const Seen_from_first&) = delete;

  template <class Numbers>
  auto in_rounded() const
  {
    return core::Bounded_rows<Numbers, int(size), Place>(others, origin);
  }
  auto in_integers() const { return core::Integer_rows<int(size), Place>(others, origin); }
  // Whether there are such integers: points may have been changed since they were triangulated.
  bool is_finite() const
  {
    return core::is_finite_place(origin) &&
           std::all_of(others, others + size, core::is_finite_place<Place>);
  }

  Place origin, others[size];

private:
  double m_bare[4] = {};
};

// Finds the value, and facets if these are wanted, in sums of two doubles.
template <class Products, std::size_t K, bool has_facets, class Seen>
bool find_in_double_doubles(const Seen& seen, int exponent, Sphere& sphere)
{
  const auto in = seen.template in_rounded<core::Bounded_double_doubles<Products>>();
  const auto center = center_of<K>(in);
  return find_value<K>(in, center, exponent, sphere.value) &&
         (!has_facets || find_facets<K>(in, center, sphere.beyond));
}

#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS
template <std::size_t K, bool has_facets, class Seen>
CGAL_DELAUNAY_FROM_SURFACE_3_ALL_IN_VECTORS bool
find_in_fused_double_doubles(const Seen& seen, int exponent, Sphere& sphere)
{
  return find_in_double_doubles<core::Fused_products, K, has_facets>(seen, exponent, sphere);
}
#endif

template <bool has_facets, class Corner, std::size_t K>
Sphere sphere_with_value(const std::array<Corner, K>& corners, int exponent)
{
  const Seen_from_first<K, true, Corner> seen(corners);
  Sphere sphere;
  const auto is_found = [&] {
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS
    if (core::machine_has_vectors())
      return find_in_fused_double_doubles<K, has_facets>(seen, exponent, sphere);
#endif
    return find_in_double_doubles<core::Portable_products, K, has_facets>(seen, exponent, sphere);
  };
  if (!is_found() && seen.is_finite()) {
    const auto in = seen.in_integers();
    const auto center = center_of<K>(in);
    find_value<K>(in, center, exponent, sphere.value);
    if (has_facets)
      find_facets<K>(in, center, sphere.beyond);
  }
  return sphere;
}

// Returns the facets that the centre of the smallest sphere is beyond.
template <class Corner, std::size_t K>
unsigned facets_beyond(const std::array<Corner, K>& corners)
{
  const Seen_from_first<K, false, Corner> seen(corners);
  unsigned beyond = 0;
  core::measure_in_stages<int(K) - 1>(seen.others, seen.origin, [&](const auto& in) {
    return find_facets<K>(in, center_of<K>(in), beyond);
  });
  return beyond;
}

// What values are computed of: corner_of(vertex) is a corner as the measures take it.
template <class CornerOf>
struct Space
{
  CornerOf corner_of;
  std::size_t number_of_points;
  bool has_values;
  int exponent; // lengths are divided by 2 to its power

  // Returns the sphere of a simplex whose cofaces have `least` as their least value, and whose own value
  // counts if it is free: but no more than that, although both are rounded.
  template <class Vertex, std::size_t K>
  Sphere sphere(const std::array<Vertex, K>& vertices, bool is_free, double least) const
  {
    if (!has_values)
      return {0, 0};
    std::array<std::decay_t<decltype(corner_of(vertices[0]))>, K> corners;
    for (std::size_t k = 0; k < K; ++k)
      corners[k] = corner_of(vertices[k]);
    using Corner = typename decltype(corners)::value_type;
    constexpr bool has_facets = K > 2 || (K == 2 && has_weight<Corner>);
    Sphere sphere;
    if constexpr (K == 1)
      sphere.value = vertex_value(corners[0]);
    else if (is_free)
      sphere = sphere_with_value<has_facets>(corners, exponent);
    else if constexpr (has_facets)
      sphere.beyond = facets_beyond(corners);
    sphere.value = is_free ? (std::min)(sphere.value, least) : least;
    return sphere;
  }

private:
  template <class Corner>
  double vertex_value(const Corner& corner) const
  {
    if constexpr (has_weight<Corner>)
      return std::ldexp(0. - core::weight_of(corner), -2 * exponent); // not -0.
    else
      return 0;
  }
};

// A vertex of a simplex: a point, or in a box a copy of one.
struct Vertex
{
  Index point;

  friend bool operator<(const Vertex& a, const Vertex& b) { return a.point < b.point; }
  friend bool operator==(const Vertex& a, const Vertex& b) { return a.point == b.point; }
  Vertex seen_from(const Vertex&) const { return *this; }
};

struct Moved_vertex
{
  Index point;
  std::array<Index, 3> offset;

  friend bool operator<(const Moved_vertex& a, const Moved_vertex& b)
  {
    return a.point != b.point ? a.point < b.point : a.offset < b.offset;
  }
  friend bool operator==(const Moved_vertex& a, const Moved_vertex& b)
  {
    return a.point == b.point && a.offset == b.offset;
  }
  Moved_vertex seen_from(const Moved_vertex& other) const
  {
    Moved_vertex moved = *this;
    for (std::size_t i = 0; i < 3; ++i)
      moved.offset[i] -= other.offset[i];
    return moved;
  }
};

template <class Vertex, std::size_t K>
std::array<Vertex, K> seen_from_first(std::array<Vertex, K> vertices)
{
  const Vertex first = vertices[0];
  for (Vertex& v : vertices)
    v = v.seen_from(first);
  return vertices;
}

// Simplices of one dimension in lexicographical order. Vertices ascend, and in a box the first one is
// not moved.
template <class Vertex, std::size_t K>
struct Simplices
{
  std::vector<std::array<Vertex, K>> vertices;
  std::vector<double> values;
  std::vector<unsigned char> beyond; // the facets that the centre is beyond
  std::vector<Index> numbers;        // of those that were given
  std::vector<std::size_t> first;    // that has this point, or a greater one, as its first

  void add(const std::array<Vertex, K>& of_one, const Sphere& sphere)
  {
    vertices.push_back(of_one);
    values.push_back(sphere.value);
    beyond.push_back((unsigned char)(sphere.beyond));
  }
};

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from)
{
  to.insert(to.end(), from.begin(), from.end());
}

// A simplex, or a face of one, and its number.
template <class Vertex, std::size_t K>
struct Candidate
{
  std::array<Vertex, K> vertices;
  std::uint32_t number;

  // Compares two with the same first vertex.
  friend bool operator<(const Candidate& f, const Candidate& g)
  {
    if constexpr (K == 3 && std::is_same_v<Vertex, ::Vertex>)
      return f.last_two() < g.last_two();
    else
      return std::lexicographical_compare(f.vertices.begin() + 1, f.vertices.end(),
                                          g.vertices.begin() + 1, g.vertices.end());
  }

private:
  std::uint64_t last_two() const
  {
    return std::uint64_t(vertices[1].point) << 32 | std::uint64_t(vertices[2].point);
  }
};

// Makes simplices, block by block: list(v, candidates) lists all whose first vertex is point v, and
// add(first, last, simplices) adds those of them that are one. There are many blocks for each worker,
// since most simplices belong to the points with small numbers.
template <class Vertex, std::size_t K, class List, class Add>
Simplices<Vertex, K> collect(std::size_t n, const List& list, const Add& add,
                             const core::Executor& executor)
{
  const std::size_t workers = core::number_of_blocks(executor, n, 1024),
                    blocks = workers > 1 ? (std::min)(16 * workers, n / 1024) : 1;
  std::vector<Simplices<Vertex, K>> found(blocks);
  core::for_each_block(executor, n, blocks,
                       [&](std::size_t first, std::size_t last, std::size_t b) {
                         std::vector<Candidate<Vertex, K>> candidates;
                         core::Steps step(executor);
                         for (std::size_t v = first; v < last; ++v) {
                           found[b].first.push_back(found[b].vertices.size());
                           candidates.clear();
                           list(v, candidates);
                           step(32 * candidates.size() + 1);
                           if constexpr (K > 1)
                             std::sort(candidates.begin(), candidates.end());
                           const auto* begin = candidates.data();
                           const auto* const all = begin + candidates.size();
                           for (const auto* end = begin; begin != all; begin = end) {
                             while (end != all && end->vertices == begin->vertices)
                               ++end;
                             add(begin, end, found[b]);
                           }
                         }
                       });
  Simplices<Vertex, K> all = std::move(found[0]);
  for (std::size_t b = 1; b < blocks; ++b) {
    for (std::size_t& first : found[b].first)
      first += all.vertices.size();
    append(all.first, found[b].first);
    append(all.vertices, found[b].vertices);
    append(all.values, found[b].values);
    append(all.beyond, found[b].beyond);
    append(all.numbers, found[b].numbers);
  }
  all.first.push_back(all.vertices.size());
  return all;
}

// Returns lists of the numbers 0, …, m-1: each is in the list of the point with which it begins.
template <class Begins>
core::Lists<std::uint32_t> lists_by_first(std::size_t m, std::size_t n, const Begins& begins,
                                          const core::Executor& executor)
{
  const auto list_of = [&](std::size_t i) {
    if (i % (1 << 16) == 0)
      executor.interruption_point();
    return std::size_t(begins(i));
  };
  return core::in_lists<std::uint32_t>(
      n, core::Listed_items(m, list_of, [](std::size_t i) { return std::uint32_t(i); }), executor);
}

// Returns simplices with the given vertices, and with their given values or those of their spheres.
template <std::size_t K, class Vertex, class VerticesOf, class Space>
Simplices<Vertex, K> given(std::size_t number, const VerticesOf& vertices_of, const double* values,
                           const Space& space, const core::Executor& executor)
{
  const auto least = [&](std::size_t c) {
    const std::array<Vertex, K> vertices = vertices_of(c);
    return std::min_element(vertices.begin(), vertices.end())->point;
  };
  const auto lists = lists_by_first(number, space.number_of_points, least, executor);
  const auto list = [&](std::size_t v, auto& candidates) {
    for (const std::uint32_t* c = lists.begin(v); c != lists.end(v); ++c) {
      std::array<Vertex, K> vertices = vertices_of(*c);
      std::sort(vertices.begin(), vertices.end());
      candidates.push_back({seen_from_first(vertices), *c});
    }
  };
  const auto add = [&](const auto* one, const auto*, Simplices<Vertex, K>& to) {
    constexpr double none = std::numeric_limits<double>::infinity();
    Sphere sphere = space.sphere(one->vertices, values == nullptr, none);
    if (values != nullptr)
      sphere.value = values[one->number];
    to.add(one->vertices, sphere);
    to.numbers.push_back(Index(one->number));
  };
  return collect<Vertex, K>(space.number_of_points, list, add, executor);
}

// Returns the facets of simplices, each once. The number of a facet is (K + 1) times that of a
// simplex plus that of the vertex opposite.
template <std::size_t K, class Vertex, class Space>
Simplices<Vertex, K> facets_of(const Simplices<Vertex, K + 1>& simplices, const Space& space,
                               const core::Executor& executor)
{
  const auto lists = lists_by_first(
      simplices.vertices.size(), space.number_of_points,
      [&](std::size_t c) { return simplices.vertices[c][1].point; }, executor);
  const auto list = [&](std::size_t v, auto& candidates) {
    const auto list_facet = [&](std::size_t c, std::size_t opposite) {
      std::array<Vertex, K> vertices;
      for (std::size_t k = 0; k < K; ++k)
        vertices[k] = simplices.vertices[c][k + (k >= opposite)];
      candidates.push_back({opposite == 0 ? seen_from_first(vertices) : vertices,
                            std::uint32_t((K + 1) * c + opposite)});
    };
    for (const std::uint32_t* c = lists.begin(v); c != lists.end(v); ++c)
      list_facet(*c, 0);
    for (std::size_t c = simplices.first[v]; c < simplices.first[v + 1]; ++c)
      for (std::size_t k = 1; k <= K; ++k)
        list_facet(c, k);
  };
  const auto add = [&](const auto* first, const auto* last, Simplices<Vertex, K>& to) {
    double least = std::numeric_limits<double>::infinity();
    bool is_free = true;
    for (const auto* f = first; f != last; ++f) {
      const std::size_t coface = f->number / (K + 1), opposite = f->number % (K + 1);
      least = (std::min)(least, simplices.values[coface]);
      is_free = is_free && (simplices.beyond[coface] >> opposite & 1) == 0;
    }
    to.add(first->vertices, space.sphere(first->vertices, is_free, least));
  };
  if (simplices.vertices.size() > (std::numeric_limits<std::uint32_t>::max)() / (K + 1))
    throw std::length_error("the simplices have more than 2^32 facets");
  return collect<Vertex, K>(space.number_of_points, list, add, executor);
}

// Those of all dimensions.
template <class Vertex>
using Complex = std::tuple<Simplices<Vertex, 1>, Simplices<Vertex, 2>, Simplices<Vertex, 3>,
                           Simplices<Vertex, 4>>;

template <std::size_t K, class Vertex, class Space>
void add_faces(Complex<Vertex>& complex, const Space& space, const core::Executor& executor)
{
  if constexpr (K > 1) {
    std::get<K - 2>(complex) = facets_of<K - 1, Vertex>(std::get<K - 1>(complex), space, executor);
    add_faces<K - 1>(complex, space, executor);
  }
}

template <class Vertex, class VerticesOf, class Space>
Complex<Vertex> complex_of(const Rows& rows, const VerticesOf& vertex_of, const double* values,
                           const Space& space, std::size_t threads)
{
  const python::Unlocked unlocked;
  const core::Rounding_to_nearest rounding;
  const python::Interruptible_executor executor(threads);
  Complex<Vertex> complex;
  const auto make = [&](auto constant) {
    constexpr std::size_t K = decltype(constant)::value;
    const auto vertices_of = [&](std::size_t c) {
      std::array<Vertex, K> vertices;
      for (std::size_t k = 0; k < K; ++k)
        vertices[k] = vertex_of(c, k);
      return vertices;
    };
    std::get<K - 1>(complex) = given<K, Vertex>(rows.size(), vertices_of, values, space, executor);
    add_faces<K>(complex, space, executor);
  };
  switch (rows.corners()) {
  case 1:
    make(std::integral_constant<std::size_t, 1>());
    break;
  case 2:
    make(std::integral_constant<std::size_t, 2>());
    break;
  case 3:
    make(std::integral_constant<std::size_t, 3>());
    break;
  case 4:
    make(std::integral_constant<std::size_t, 4>());
    break;
  default:
    throw std::invalid_argument("simplices: expected an array of shape (m, d + 1)");
  }
  return complex;
}

// Returns indices, offsets or None, values, and numbers of those that were given, if these were.
template <class Vertex_, std::size_t K>
py::tuple arrays_of(Simplices<Vertex_, K>&& simplices)
{
  constexpr bool are_moved = std::is_same_v<Vertex_, Moved_vertex>;
  const std::size_t number = simplices.vertices.size();
  std::vector<Index> points(K * number), offsets(are_moved ? 3 * K * number : 0);
  for (std::size_t i = 0; i < K * number; ++i) {
    const Vertex_& v = simplices.vertices[i / K][i % K];
    points[i] = v.point;
    if constexpr (are_moved)
      std::copy(v.offset.begin(), v.offset.end(), offsets.begin() + std::ptrdiff_t(3 * i));
  }
  std::vector<std::array<Vertex_, K>>().swap(simplices.vertices);
  const auto rows = py::ssize_t(number), columns = py::ssize_t(K);
  const std::vector<py::ssize_t> shape = {rows, columns, 3};
  const auto given = py::ssize_t(simplices.numbers.size());
  return py::make_tuple(array_from(std::move(points), {rows, columns}),
                        are_moved ? py::object(array_from(std::move(offsets), shape)) : py::none(),
                        array_from(std::move(simplices.values), {rows}),
                        array_from(std::move(simplices.numbers), {given}));
}

template <class Vertex>
py::list arrays_of(Complex<Vertex>&& complex, std::size_t corners)
{
  py::list arrays;
  std::apply(
      [&](auto&... of_dimension) { (arrays.append(arrays_of(std::move(of_dimension))), ...); },
      complex);
  return py::list(arrays[py::slice(0, py::ssize_t(corners), 1)]);
}

// Returns for each dimension what arrays_of() does. Values, times 4^exponent, are those of the alpha
// complex, and those of the given simplices may be given; without any all are 0. Numbers of points are
// read once, since they say how many simplices a point begins.
py::list filtration(const Points& points, const py::object& weights, const Numbers& simplices,
                    const py::object& in_box, const py::object& values, bool has_values,
                    int exponent, std::size_t threads)
{
  python::refuse_obstacle();
  using Reals = py::array_t<double, py::array::c_style | py::array::forcecast>;
  const Rows rows(simplices);
  const auto n = std::size_t(points.shape(0));
  const bool are_weighted = !weights.is_none(), are_given = !values.is_none();
  const Reals of_points = are_weighted ? weights.cast<Reals>() : Reals(0);
  const Reals of_simplices = are_given ? values.cast<Reals>() : Reals(0);
  if (are_weighted && std::size_t(of_points.size()) != n)
    throw py::value_error("weights: expected one for each point");
  if (are_given && std::size_t(of_simplices.size()) != rows.size())
    throw py::value_error("values: expected one for each simplex");
  const std::vector<Index> point_numbers = python::checked_copy(rows, n);
  const auto number = [&](std::size_t c, std::size_t k) {
    return point_numbers[rows.corners() * c + k];
  };
  const auto made = [&](auto vertex, const auto& vertex_of, const auto& corner_of) {
    const Space<std::decay_t<decltype(corner_of)>> space = {corner_of, n, has_values, exponent};
    return arrays_of(complex_of<decltype(vertex)>(rows, vertex_of,
                                                  are_given ? of_simplices.data() : nullptr, space,
                                                  threads),
                     rows.corners());
  };
  if (in_box.is_none()) {
    const auto vertex_of = [&](std::size_t c, std::size_t k) { return Vertex{number(c, k)}; };
    const auto in_space = [&](const auto& corner_of) {
      return made(Vertex(), vertex_of,
                  [&](Vertex v) { return corner_of(0, 0, std::size_t(v.point)); });
    };
    if (!are_weighted)
      return in_space(python::Corners_of_points<false>(points, nullptr));
    return in_space(python::Corners_of_points<true>(points, of_points.data()));
  }
  const In_box box(in_box, rows);
  const auto vertex_of = [&](std::size_t c, std::size_t k) {
    const std::int16_t* const o = box.offsets() + 3 * (rows.corners() * c + k);
    return Moved_vertex{number(c, k), {o[0], o[1], o[2]}};
  };
  const auto in_copies = [&](const auto& copies) {
    return made(Moved_vertex(), vertex_of, [&](const Moved_vertex& v) {
      return copies.copy(std::size_t(v.point), v.offset.data());
    });
  };
  if (!are_weighted)
    return in_copies(python::Corners_in_box<false>(points, nullptr, box));
  return in_copies(python::Corners_in_box<true>(points, of_points.data(), box));
}

// Represents doubles by integers with the same order.
std::uint64_t ordered_bits(double x)
{
  x += 0.; // there is one 0
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  return bits >> 63 != 0 ? ~bits : bits | std::uint64_t(1) << 63;
}

// The upper half of a key, and where it stands.
struct Half_key
{
  std::uint32_t bits, place;
};

// Sorts stably by groups of 11 bits, from the last to the first.
void sort_by_digits(std::vector<Half_key>& keys, const core::Executor& executor)
{
  std::vector<Half_key> sorted(keys.size());
  for (int shift = 0; shift < 32; shift += 11) {
    executor.interruption_point();
    std::vector<std::size_t> first((1 << 11) + 1, 0);
    for (const Half_key& key : keys)
      ++first[(key.bits >> shift & 0x7ff) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    for (const Half_key& key : keys)
      sorted[first[key.bits >> shift & 0x7ff]++] = key;
    keys.swap(sorted);
  }
}

// Returns the places of numbers in ascending order; equal ones stay in theirs.
py::array_t<std::int64_t>
sorted_places(const py::array_t<double, py::array::c_style | py::array::forcecast>& numbers)
{
  const auto n = std::size_t(numbers.size());
  if (n > (std::numeric_limits<std::uint32_t>::max)())
    throw std::length_error("there are more than 2^32 simplices");
  std::vector<std::int64_t> places;
  {
    const double* const number = numbers.data();
    const python::Unlocked unlocked;
    const python::Interruptible_executor executor(1);
    std::vector<Half_key> keys(n);
    for (std::size_t i = 0; i < n; ++i)
      keys[i] = {std::uint32_t(ordered_bits(number[i]) >> 32), std::uint32_t(i)};
    sort_by_digits(keys, executor);
    const auto is_less = [&](const Half_key& a, const Half_key& b) {
      return number[a.place] < number[b.place];
    };
    for (auto begin = keys.begin(), end = begin; begin != keys.end(); begin = end) {
      while (end != keys.end() && end->bits == begin->bits)
        ++end;
      if (!std::is_sorted(begin, end, is_less))
        std::stable_sort(begin, end, is_less);
    }
    places.reserve(n); // now that the keys are there only once
    for (const Half_key& key : keys)
      places.push_back(std::int64_t(key.place));
  }
  return array_from(std::move(places), {py::ssize_t(n)});
}

} // namespace

void python::define_filtration(py::module_& m)
{
  m.def("filtration", &filtration);
  m.def("sorted_places", &sorted_places);
}
