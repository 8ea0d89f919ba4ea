// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_RANGE_SUMMARY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_RANGE_SUMMARY_H

// What is to be known of all points before there are tiles, from ranges of them that nobody needs
// to have all at once.

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/starting_simplex.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Split_mix.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_point.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_source_3.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_tree.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiling.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Which points are drawn: those whose ids have hashes below a number.
struct Sampling
{
  std::uint64_t common,
      of_tree; // below the first: what all tiles are offered; the second is no less

  static std::uint64_t hash(std::uint64_t id) { return Split_mix(id)(); }

  // Of n points for so many tiles: of a tile's points 1 / share, but no more than 16384, as offers
  // of the sample take time and few of them spare others; and for the tree 256 of them if there are
  // so many.
  Sampling(std::uint64_t n, std::uint32_t tiles, std::size_t share)
    : common(part((std::min)(1. / (double(share) * tiles),
                             16384 / double((std::max)(n, std::uint64_t(1))))))
    , of_tree((std::max)(common, part(256. * tiles / double((std::max)(n, std::uint64_t(1))))))
  {
  }

private:
  static std::uint64_t part(double share)
  {
    return share >= 1 ? std::uint64_t(-1) : std::uint64_t(std::ldexp(share, 64));
  }
};

struct Range_summary
{
  double largest = 0, least = (std::numeric_limits<double>::max)();
  std::vector<Tile_point> basis;  // affinely independent, and as many as there are; in their order
  std::vector<Tile_point> sample; // for the tree
};

inline Tile_point tile_point(std::uint64_t id, const double* p)
{
  return {id, {p[0], p[1], p[2]}};
}

// The coordinates of a range; throws a Surface_input_error that names the first that is not finite.
inline std::vector<double> read_range(const Tile_source_3& source, std::uint64_t first,
                                      std::uint64_t last)
{
  std::vector<double> coordinates(std::size_t(3 * (last - first)));
  source.read(first, std::size_t(last - first), coordinates.data());
  const auto bad = std::find_if(coordinates.begin(), coordinates.end(),
                                [](double x) { return !is_finite_number(x); });
  if (bad != coordinates.end())
    throw Surface_input_error(source.name_of(first + std::uint64_t(bad - coordinates.begin()) / 3) +
                              ": a coordinate is not a finite number");
  return coordinates;
}

// Of points from `first` on.
inline Range_summary summary_of(const std::vector<double>& coordinates, std::uint64_t first,
                                const Sampling& sampling)
{
  Range_summary summary;
  const Point_array points(coordinates.data(), coordinates.size() / 3);
  for (const double x : coordinates) {
    const double size = std::abs(x);
    summary.largest = (std::max)(summary.largest, size);
    summary.least = size == 0 ? summary.least : (std::min)(summary.least, size);
  }
  for (std::size_t i = 0; i < points.size(); ++i)
    if (Sampling::hash(first + i) < sampling.of_tree || sampling.of_tree == std::uint64_t(-1))
      summary.sample.push_back(tile_point(first + i, points[i]));
  const Starting_simplex simplex =
      starting_simplex(points.size(), [&](std::size_t i) { return points[i]; });
  for (int k = 0; k <= simplex.dimension; ++k) {
    const std::size_t i = simplex.points[std::size_t(k)];
    summary.basis.push_back(tile_point(first + i, points[i]));
  }
  std::sort(summary.basis.begin(), summary.basis.end(),
            [](const Tile_point& p, const Tile_point& q) { return p.id < q.id; });
  return summary;
}

// Of the number of points, 64 of them from all over, and a stamp.
inline std::uint64_t fingerprint_of(const Tile_source_3& source, std::uint64_t stamp)
{
  std::uint64_t print = Split_mix(source.size() ^ stamp)();
  for (std::uint64_t k = 0; k < 64 && source.size() > 0; ++k) {
    double p[3];
    source.read((source.size() - 1) * k / 63, 1, p);
    for (const double x : p) {
      std::uint64_t bits;
      std::memcpy(&bits, &x, sizeof(bits));
      print = Split_mix(print ^ bits)();
    }
  }
  return print;
}

// The same with what the source says of changes.
inline std::uint64_t fingerprint_of(const Tile_source_3& source)
{
  return fingerprint_of(source, source.stamp());
}

// Of ranges in their order. What the bases span all points span.
inline Tiling tiling_of(const std::vector<Range_summary>& ranges, std::uint64_t n,
                        std::uint32_t number_of_tiles, const Sampling& sampling)
{
  double largest = 0, least = (std::numeric_limits<double>::max)();
  std::vector<Tile_point> bases, tree, common;
  for (const Range_summary& range : ranges) {
    largest = (std::max)(largest, range.largest);
    least = (std::min)(least, range.least);
    bases.insert(bases.end(), range.basis.begin(), range.basis.end());
    tree.insert(tree.end(), range.sample.begin(), range.sample.end());
  }
  std::copy_if(tree.begin(), tree.end(), std::back_inserter(common), [&](const Tile_point& p) {
    return Sampling::hash(p.id) < sampling.common || sampling.common == std::uint64_t(-1);
  });
  const Starting_simplex simplex =
      starting_simplex(bases.size(), [&](std::size_t i) { return bases[i].coordinates; });
  if (simplex.dimension < 3)
    throw Surface_input_error("the points lie in one plane: tiles are for points in space, "
                              "arrays for all points");
  std::array<Tile_point, 4> start;
  for (unsigned k = 0; k < 4; ++k)
    start[k] = bases[simplex.points[k]];
  return {Tile_tree(tree, number_of_tiles), start, largest, least, n, std::move(common)};
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_RANGE_SUMMARY_H
