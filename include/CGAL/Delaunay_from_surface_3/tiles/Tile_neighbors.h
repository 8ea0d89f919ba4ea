// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_NEIGHBORS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_NEIGHBORS_H

// The neighbours of the cells of all tiles, by global numbers: those that the cells have one after
// the other, in the order of the tiles. The neighbour of a cell may be another tile's, which
// neither need know; so facets that have one cell in a tile meet by the hash of their vertices, in
// parts, as many as there are tiles. Linear but for sorting.
//
// Tasks are done in three stages, those of a stage in any order, again and again if need be.

#include <CGAL/Delaunay_from_surface_3/core/order/Split_mix.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Records.h>
#include <CGAL/Delaunay_from_surface_3/tiles/join_tiles.h>
#include <CGAL/Delaunay_from_surface_3/tiles/run_tasks.h>
#include <CGAL/Delaunay_from_surface_3/tiles/write_tiles.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

class Tile_neighbors
{
public:
  // Of the tiles in a folder; `state` is another one, in which there is a folder for what lies
  // between.
  Tile_neighbors(std::filesystem::path folder, const std::filesystem::path& state,
                 std::uint32_t number_of_tiles)
    : m_folder(std::move(folder))
    , m_state(state / "neighbors")
    , m_tiles(number_of_tiles)
  {
    m_first.push_back(0);
    for (std::uint32_t t = 0; t < m_tiles; ++t)
      m_first.push_back(m_first.back() +
                        Rows_of_npy(file_of_tile(m_folder, "cells", t, "npy")).number);
  }

  // neighbors-T.npy of all tiles: the numbers of the cells opposite to the vertices; -1: none.
  void run(const Executor& executor) const
  {
    std::uint32_t done = 0;
    while (done < m_tiles && is_done(done))
      ++done;
    if (done == m_tiles) {
      std::filesystem::remove_all(m_state);
      return;
    }
    std::filesystem::create_directories(m_state);
    const auto run_stage = [&](void (Tile_neighbors::*task)(std::uint32_t) const) {
      run_tasks(executor, m_tiles, [&](std::size_t t) { (this->*task)(std::uint32_t(t)); });
    };
    run_stage(&Tile_neighbors::match_inside);
    run_stage(&Tile_neighbors::match_between);
    run_stage(&Tile_neighbors::write);
    std::filesystem::remove_all(m_state);
  }

private:
  static constexpr std::int64_t none = -1;

  // Of cell / 4, opposite to vertex cell % 4; vertices in ascending order.
  struct Facet
  {
    std::array<std::int64_t, 3> vertices;
    std::uint64_t slot;

    friend bool operator<(const Facet& f, const Facet& g) { return f.vertices < g.vertices; }
  };
  struct Neighbor
  {
    std::uint64_t slot;
    std::int64_t cell;
  };

  bool is_done(std::uint32_t t) const
  {
    return std::filesystem::exists(file_of_tile(m_folder, "neighbors", t, "npy"));
  }
  std::filesystem::path file(const char* kind, std::uint32_t t) const
  {
    return m_state / (kind + ("-" + std::to_string(t)));
  }

  std::vector<Facet> sorted_facets(std::uint32_t t) const
  {
    const auto file = file_of_tile(m_folder, "cells", t, "npy");
    const Rows_of_npy rows(file);
    std::vector<Global_cell> cells(std::size_t(rows.number));
    Bytes_reader from(file);
    from.seek(rows.first);
    from.read(cells.data(), cells.size() * sizeof(Global_cell));
    std::vector<Facet> facets;
    facets.reserve(4 * cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c)
      for (unsigned k = 0; k < 4; ++k) {
        facets.push_back({{cells[c][k ^ 1], cells[c][k ^ 2], cells[c][k ^ 3]}, 4 * c + k});
        std::sort(facets.back().vertices.begin(), facets.back().vertices.end());
      }
    std::sort(facets.begin(), facets.end());
    return facets;
  }

  // Calls two(f, g) for each two of sorted facets that are the same, and one(f) for the others.
  template <class Two, class One>
  static void match(const std::vector<Facet>& facets, const Two& two, const One& one)
  {
    for (std::size_t i = 0; i < facets.size(); ++i)
      if (i + 1 < facets.size() && facets[i].vertices == facets[i + 1].vertices) {
        two(facets[i], facets[i + 1]);
        ++i;
      } else {
        one(facets[i]);
      }
  }

  // Those of items in the order of the parts that they belong to; returns where each part ends.
  template <class Item, class Part>
  std::vector<std::uint64_t> sort_by_part(std::vector<Item>& items, const Part& part) const
  {
    std::sort(items.begin(), items.end(),
              [&](const Item& a, const Item& b) { return part(a) < part(b); });
    std::vector<std::uint64_t> ends(m_tiles + 1);
    for (const Item& item : items)
      ++ends[part(item) + 1];
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    return ends;
  }

  template <class Item>
  void append_part(const char* kind, std::uint32_t from_tile, std::uint32_t part,
                   std::vector<Item>& items) const
  {
    Record_reader(file(kind, from_tile), kind, 0).append_part(part, items);
  }

  template <class Item>
  void write_parts(const char* kind, std::uint32_t t, const std::vector<std::uint64_t>& ends,
                   const std::vector<Item>& items) const
  {
    Record_writer to(file(kind, t), kind, 1);
    to.put_parts(ends, items);
    to.finish();
  }

  std::uint32_t part_of(const Facet& facet) const
  {
    std::uint64_t h = 0;
    for (const std::int64_t v : facet.vertices)
      h = Split_mix(h ^ std::uint64_t(v))();
    return std::uint32_t(h % m_tiles);
  }
  std::uint32_t tile_of(std::uint64_t slot) const
  {
    return std::uint32_t(std::upper_bound(m_first.begin(), m_first.end(), slot / 4) -
                         m_first.begin() - 1);
  }

  void match_inside(std::uint32_t t) const
  {
    if (std::filesystem::exists(file("inside", t)))
      return;
    std::vector<Facet> open;
    std::vector<std::int64_t> neighbors(4 * (m_first[t + 1] - m_first[t]), none);
    match(
        sorted_facets(t),
        [&](const Facet& f, const Facet& g) {
          neighbors[f.slot] = std::int64_t(m_first[t] + g.slot / 4);
          neighbors[g.slot] = std::int64_t(m_first[t] + f.slot / 4);
        },
        [&](const Facet& f) {
          open.push_back({f.vertices, f.slot + 4 * m_first[t]});
        });
    const auto ends = sort_by_part(open, [&](const Facet& f) { return part_of(f); });
    write_parts("open", t, ends, open);
    Record_writer to(file("inside", t), "inside", 1);
    to.put(neighbors);
    to.finish();
  }

  void match_between(std::uint32_t part) const
  {
    if (std::filesystem::exists(file("between", part)))
      return;
    std::vector<Facet> facets;
    for (std::uint32_t t = 0; t < m_tiles; ++t)
      append_part("open", t, part, facets);
    std::sort(facets.begin(), facets.end());
    std::vector<Neighbor> pairs;
    match(
        facets,
        [&](const Facet& f, const Facet& g) {
          pairs.push_back({f.slot, std::int64_t(g.slot / 4)});
          pairs.push_back({g.slot, std::int64_t(f.slot / 4)});
        },
        [](const Facet&) {}); // of the convex hull
    const auto ends = sort_by_part(pairs, [&](const Neighbor& n) { return tile_of(n.slot); });
    write_parts("between", part, ends, pairs);
  }

  void write(std::uint32_t t) const
  {
    if (is_done(t))
      return;
    std::vector<std::int64_t> neighbors;
    Record_reader(file("inside", t), "inside", 0).get(neighbors);
    std::vector<Neighbor> pairs;
    for (std::uint32_t part = 0; part < m_tiles; ++part)
      append_part("between", part, t, pairs);
    for (const Neighbor& n : pairs)
      neighbors[n.slot - 4 * m_first[t]] = n.cell;
    std::vector<Global_cell> rows(neighbors.size() / 4);
    for (std::size_t i = 0; i < neighbors.size(); ++i)
      rows[i / 4][i % 4] = neighbors[i];
    write_npy(file_of_tile(m_folder, "neighbors", t, "npy"), "i8", 4, rows);
  }

  const std::filesystem::path m_folder, m_state;
  const std::uint32_t m_tiles;
  std::vector<std::uint64_t> m_first; // by tile: the number of its first cell
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_NEIGHBORS_H
