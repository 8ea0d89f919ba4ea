// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILING_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILING_H

// The tiling of space: a tile owns the points in a leaf of a kd-tree (Bentley 1975), which is found
// by comparing a point's doubles with the splitting planes. So equal points have one owner, and no
// message carries an owner.
//
// Cost: O(s log T) for T tiles from a sample of s points, O(log T) for a point.

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Ordered_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/order/Split_mix.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// A point as tiles tell it to each other: 32 bytes. Its id is its place in the input.
struct Tile_point
{
  std::uint64_t id;
  double coordinates[3];
};

// The points that one tile tells another of.
struct Tile_message
{
  std::uint32_t from, to;
  std::vector<Tile_point> points;

  auto parts() { return std::tie(from, to, points); } // for pack()
};

// The id of a point, and the number of a tile that was told of it.
using Told = std::array<std::uint64_t, 2>;

// The data from which, with its own points, a tile can be made again as it was.
struct Tile_state
{
  std::vector<Tile_point> kept;     // others' points in its triangulation
  std::vector<std::uint64_t> known; // ids of all that was offered, ascending
  std::vector<Told> told;           // ascending

  auto parts() { return std::tie(kept, known, told); }
};

class Tile_tree
{
public:
  // The child below the plane is the next node; the child above it is node `above`.
  struct Node
  {
    double plane;
    std::uint32_t axis, above;
  };

  // Makes so many tiles with about equal shares of the sample, whose points are reordered.
  Tile_tree(std::vector<Tile_point>& sample, std::uint32_t number_of_tiles)
    : m_number_of_tiles(number_of_tiles)
  {
    split(sample.data(), sample.data() + sample.size(), number_of_tiles);
  }

  Tile_tree() = default;

  auto parts() { return std::tie(m_number_of_tiles, m_nodes); }

  std::uint32_t number_of_tiles() const { return m_number_of_tiles; }

  std::uint32_t owner(const double* p) const
  {
    std::uint32_t tile = 0, tiles = m_number_of_tiles;
    for (std::size_t node = 0; tiles > 1;) {
      const Node& n = m_nodes[node];
      const std::uint32_t below = tiles / 2;
      if (p[n.axis] < n.plane) { // 0 and -0 are the same
        tiles = below;
        ++node;
      } else {
        tile += below;
        tiles -= below;
        node = n.above;
      }
    }
    return tile;
  }

private:
  struct Cut
  {
    double plane = 0;
    unsigned axis = 0;
    std::ptrdiff_t below = 0, error = -1; // points below it; distance to the wanted number
  };

  void split(Tile_point* first, Tile_point* last, std::uint32_t tiles)
  {
    if (tiles <= 1)
      return;
    const std::size_t node = m_nodes.size();
    const std::uint32_t below = tiles / 2;
    const Cut cut =
        best_cut(first, last, (last - first) * std::ptrdiff_t(below) / std::ptrdiff_t(tiles));
    Tile_point* const middle = std::partition(
        first, last, [&](const Tile_point& p) { return p.coordinates[cut.axis] < cut.plane; });
    m_nodes.push_back({cut.plane, cut.axis, 0});
    split(first, middle, below);
    m_nodes[node].above = std::uint32_t(m_nodes.size());
    split(middle, last, tiles - below);
  }

  // Returns a cut across the longest axis for which about the wanted number of points is below:
  // many points may share a coordinate, as in a plane.
  static Cut best_cut(Tile_point* first, Tile_point* last, std::ptrdiff_t wanted)
  {
    double length[3] = {};
    unsigned axes[3] = {0, 1, 2};
    for (unsigned axis = 0; axis < 3 && first != last; ++axis) {
      const auto [low, high] =
          std::minmax_element(first, last, [axis](const Tile_point& p, const Tile_point& q) {
            return p.coordinates[axis] < q.coordinates[axis];
          });
      length[axis] = high->coordinates[axis] / 2 - low->coordinates[axis] / 2; // stays finite
    }
    std::stable_sort(axes, axes + 3, [&](unsigned a, unsigned b) { return length[a] > length[b]; });
    Cut best;
    for (const unsigned axis : axes) {
      const Cut cut = cut_across(first, last, wanted, axis);
      if (best.error < 0 || cut.error < best.error)
        best = cut;
      if (4 * best.error <= last - first)
        break;
    }
    return best;
  }

  // Cuts at the coordinate of the point that has `wanted` points before it, or at the next one.
  static Cut cut_across(Tile_point* first, Tile_point* last, std::ptrdiff_t wanted, unsigned axis)
  {
    if (first == last)
      return {0, axis, 0, 0};
    std::nth_element(first, first + wanted, last, [axis](const Tile_point& p, const Tile_point& q) {
      return p.coordinates[axis] < q.coordinates[axis];
    });
    const double at = first[wanted].coordinates[axis];
    double next = at;
    std::ptrdiff_t less = 0, same = 0;
    for (const Tile_point* p = first; p != last; ++p) {
      const double x = p->coordinates[axis];
      less += x < at;
      same += x == at;
      next = x > at && (next == at || x < next) ? x : next;
    }
    if (next != at && less + same - wanted < wanted - less)
      return {next, axis, less + same, less + same - wanted};
    return {at, axis, less, wanted - less};
  }

  std::uint32_t m_number_of_tiles = 0;
  std::vector<Node> m_nodes;
};

// The data that all tiles know.
struct Tiling
{
  Tile_tree tree;
  std::array<Tile_point, 4> start; // positively oriented; every tile keeps these
  double largest, least;           // absolute values of coordinates; 0 is ignored for the least
  std::uint64_t number_of_points;
  std::vector<Tile_point> sample; // of all points; each tile is offered these first

  auto parts() { return std::tie(tree, start, largest, least, number_of_points, sample); }
};

// The data on all points that is needed before there are tiles. It is gathered from ranges of
// points, so that no process needs to have all at once.

// The rule that draws points: it takes those whose ids have hashes below a number.
struct Sampling
{
  std::uint64_t common,
      of_tree; // bounds: for what all tiles are offered; for the tree, no less

  static std::uint64_t hash(std::uint64_t id) { return Split_mix(id)(); }

  // Draws from n points for so many tiles. The sample that tiles are offered has 1 / share of a
  // tile's points, but no more than 16384, as offers take time and few of them spare others; the
  // tree gets 256 points per tile if there are so many.
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
  std::vector<Tile_point> basis;  // affinely independent, as many as possible, in their order
  std::vector<Tile_point> sample; // for the tree

  auto parts() { return std::tie(largest, least, basis, sample); }
};

inline Tile_point tile_point(std::uint64_t id, const double* p)
{
  return {id, {p[0], p[1], p[2]}};
}

// Returns the coordinates of a range; throws a Surface_input_error that names the first point that
// is not finite.
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

// Summarizes the points with ids from `first` on.
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

// Returns a hash of the number of points, 64 of them from all over, and a stamp.
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

// Does the same with the source's own stamp.
inline std::uint64_t fingerprint_of(const Tile_source_3& source)
{
  return fingerprint_of(source, source.stamp());
}

// Merges summaries, given in the order of their ranges. The bases span what all points span.
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
    throw Surface_input_error("the points lie in one plane, which tiles do not support; "
                              "remedy: use arrays");
  std::array<Tile_point, 4> start;
  for (unsigned k = 0; k < 4; ++k)
    start[k] = bases[simplex.points[k]];
  return {Tile_tree(tree, number_of_tiles), start, largest, least, n, std::move(common)};
}

// Out of core, 250 of these bytes are for the triangulation. In memory a tile keeps its result
// beside it, and takes half as much again.
constexpr std::uint64_t bytes_per_point_kept = 300;
constexpr std::uint64_t most_points_of_tile = std::uint64_t(1) << 27; // its cells take 30 bits

// Returns how many points a tile may keep if `at_once` tiles are in memory at once.
inline std::size_t most_points_kept(const Tiles_options& options, std::size_t at_once)
{
  const std::uint64_t memory = options.memory / (std::max)(at_once, std::size_t(1));
  return std::size_t(options.memory == 0
                         ? most_points_of_tile
                         : (std::min)(most_points_of_tile, (std::max)(memory / bytes_per_point_kept,
                                                                      std::uint64_t(64))));
}

// Returns how many points are read at a time. Each takes 70 bytes while points are sorted by tiles.
inline std::size_t most_points_read(const Tiles_options& options, std::size_t at_once)
{
  constexpr std::uint64_t least = 1 << 14; // each range is a file, of which every tile reads a part
  const std::uint64_t fit =
      (std::max)(options.memory / (std::max)(at_once, std::size_t(1)) / 100, least);
  const std::size_t most =
      options.memory == 0 ? options.points_at_once
                          : std::size_t((std::min)(std::uint64_t(options.points_at_once), fit));
  return std::clamp(most, std::size_t(1), std::size_t(1) << 30);
}

// Returns the number of tiles for n points, if the worst tile keeps five times its own points,
// of which it has up to a tenth more than others.
inline std::uint32_t number_of_tiles(const Tiles_options& options, std::uint64_t n,
                                     std::size_t at_once)
{
  const std::uint64_t most = n / (std::max)(options.least_points, std::uint32_t(1)) + 1;
  if (options.number_of_tiles > 0)
    return std::uint32_t((std::min)(most, std::uint64_t(options.number_of_tiles)));
  const double kept = 5.5 * double(n);
  const double tiles = kept / double(most_points_kept(options, at_once)) + 1;
  return std::uint32_t((std::min)(double(most), (std::min)(tiles, 1e6)));
}

// Returns the exception for a tile that keeps more points than it may. When it is thrown, the hub
// may not have all its neighbors yet.
inline Tile_too_large tile_too_large(std::uint32_t tile, std::size_t own_points, std::size_t limit,
                                     std::uint64_t hub, std::size_t neighbors_of_hub,
                                     std::uint32_t tiles)
{
  const bool has_hub = neighbors_of_hub > limit / 2;
  const double share = 6. * double(own_points) / double(limit); // as the worst tile measured
  const double enough = double(tiles) * (share > 2 ? share : 2) + 1;
  const auto more = std::uint32_t(enough < 4e9 ? enough : 4e9); // capped to fit 32 bits
  return {"tile " + std::to_string(tile) + " of " + std::to_string(own_points) +
              " points keeps more than the " + std::to_string(limit) + " that it may; point " +
              std::to_string(hub) + " alone has " + std::to_string(neighbors_of_hub) +
              " neighbors; " +
              (has_hub ? "no number of tiles will do, only more memory"
                       : std::to_string(more) + " tiles would do"),
          has_hub ? 0 : more, tiles};
}

// To be called if a tile of a run with n points was too large: sets the number of tiles that would
// do. Returns false if there is none, or if the work must not begin again. Throws if so many tiles
// are not allowed.
inline bool ask_for_more_tiles(Tiles_options& options, const Tile_too_large& error, std::uint64_t n,
                               std::uint32_t tiles)
{
  options.number_of_tiles = error.number_of_tiles();
  if (error.number_of_tiles() == 0)
    return false;
  const std::uint32_t most = number_of_tiles(options, n, 1);
  if (most <= tiles)
    throw Tile_too_large(std::string(error.what()) + ", but there may be " + std::to_string(most) +
                             " only, of " + std::to_string(options.least_points) + " points each",
                         0);
  return options.starts_again;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILING_H
