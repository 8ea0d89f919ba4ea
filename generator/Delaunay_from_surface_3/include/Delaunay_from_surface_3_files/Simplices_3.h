// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_FILES_SIMPLICES_3_H
#define DELAUNAY_FROM_SURFACE_3_FILES_SIMPLICES_3_H

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>
#include <CGAL/Delaunay_from_surface_3/arrays/measures_of_simplices.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace files {

// is what the functions that write files take: points, and the simplices on them that are to be
// written. `simplices_of()` makes it; anybody may change it, or fill it from elsewhere.
struct Simplices_3
{
  // one number for each simplex.
  struct Data
  {
    std::string name;           // letters, digits and underscores.
    std::vector<double> values; // by simplex.
  };

  int dimension = 3;                         // 3: tetrahedra, 2: triangles, 1: edges, 0: points.
  std::vector<std::array<double, 3>> points; // their coordinates.
  std::vector<std::int64_t> input_indices;   // of each point: where it was in the input.
  std::vector<std::int64_t> simplices;       // `dimension + 1` indices of points for each.
  std::vector<std::int64_t> neighbors;       // as many: simplices, or -1. Empty: not known.
  std::vector<Data> data;                    // what else is known of the simplices.

  // returns how many points a simplex has.
  std::size_t corners() const { return std::size_t(dimension) + 1; }

  // returns the number of simplices.
  std::size_t size() const { return simplices.size() / corners(); }
};

// returns those finite cells `c` of a triangulation for which `is_wanted(c)` holds, and all its
// different points, in the order of the input. The neighbours are left out if the arrays have none.
// Linear.
//
// points: the points of which `arrays` was made: a range of points of any kernel, of
// `std::array<double, 3>`, or of anything with coordinates `p[0]`, `p[1]`, `p[2]`
// arrays: what `delaunay_3_arrays()` returned
// is_wanted: a function from cell numbers to `bool`
template <class PointRange, class Index, class IsWanted>
Simplices_3 simplices_of(const PointRange& points, const CGAL::Delaunay_3_arrays<Index>& arrays,
                         const IsWanted& is_wanted)
{
  Simplices_3 result;
  result.dimension = arrays.dimension() < 0 ? 0 : arrays.dimension();
  std::vector<std::int64_t> point_numbers(arrays.number_of_points(), -1);
  auto p = std::begin(points);
  for (std::size_t i = 0; i < point_numbers.size(); ++i, ++p)
    if (std::size_t(arrays.vertex_of_point(i)) == i) {
      point_numbers[i] = std::int64_t(result.points.size());
      result.points.push_back(
          {CGAL::to_double((*p)[0]), CGAL::to_double((*p)[1]), CGAL::to_double((*p)[2])});
      result.input_indices.push_back(std::int64_t(i));
    }

  std::vector<std::int64_t> cell_numbers(arrays.number_of_simplices(), -1);
  std::int64_t count = 0;
  for (std::size_t c = 0; c < cell_numbers.size(); ++c)
    if (is_wanted(c))
      cell_numbers[c] = count++;
  for (std::size_t c = 0; c < cell_numbers.size(); ++c)
    for (std::size_t k = 0; cell_numbers[c] >= 0 && k < result.corners(); ++k) {
      result.simplices.push_back(point_numbers[std::size_t(arrays.vertices(c)[k])]);
      if (arrays.neighbors_data() != nullptr) {
        const Index n = arrays.neighbors(c)[k];
        result.neighbors.push_back(arrays.is_infinite(n) ? -1 : cell_numbers[std::size_t(n)]);
      }
    }
  return result;
}

// does the same for all finite cells.
template <class PointRange, class Index>
Simplices_3 simplices_of(const PointRange& points, const CGAL::Delaunay_3_arrays<Index>& arrays)
{
  return simplices_of(points, arrays, [](std::size_t) { return true; });
}

// returns the radii of the spheres through the points of tetrahedra, up to rounding, however flat they
// are; infinity where a radius is no finite double. \pre the dimension is 3
inline Simplices_3::Data circumradii(const Simplices_3& s)
{
  Simplices_3::Data data = {"circumradius", {}};
  data.values.reserve(s.size());
  for (std::size_t c = 0; c < s.size(); ++c) {
    std::array<double, 3> corners[4];
    for (std::size_t k = 0; k < 4; ++k)
      corners[k] = s.points[std::size_t(s.simplices[4 * c + k])];
    data.values.push_back(CGAL::Delaunay_from_surface_3::internal::circumsphere_of(corners).radius);
  }
  return data;
}

namespace internal {

// Writes numbers with as many digits as a double needs, and leaves the stream as it was.
class Full_precision
{
public:
  explicit Full_precision(std::ostream& out)
    : m_out(out)
    , m_precision(out.precision(std::numeric_limits<double>::max_digits10))
  {
  }
  Full_precision(const Full_precision&) = delete;
  Full_precision& operator=(const Full_precision&) = delete;
  ~Full_precision() { m_out.precision(m_precision); }

private:
  std::ostream& m_out;
  std::streamsize m_precision;
};

// "x y z" for each point, with `begin(i)` before it and `end` after it.
template <class Begin>
void write_points(std::ostream& out, const Simplices_3& s, const Begin& begin, const char* end)
{
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    begin(i);
    out << s.points[i][0] << ' ' << s.points[i][1] << ' ' << s.points[i][2] << end;
  }
}

// The same for the indices of each simplex, which `first` is added to.
template <class Begin>
void write_rows(std::ostream& out, const Simplices_3& s, const std::vector<std::int64_t>& entries,
                std::int64_t first, const Begin& begin, const char* end)
{
  for (std::size_t c = 0; c < s.size(); ++c) {
    begin(c);
    for (std::size_t k = 0; k < s.corners(); ++k)
      out << entries[c * s.corners() + k] + first << (k + 1 < s.corners() ? " " : end);
  }
}

} // namespace internal
} // namespace files

#endif // DELAUNAY_FROM_SURFACE_3_FILES_SIMPLICES_3_H
