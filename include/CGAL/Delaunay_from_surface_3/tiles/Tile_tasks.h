// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_TASKS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_TASKS_H

// The tasks of a run in a folder: what each reads and writes. The same is written whenever it is
// done, but for the order of a tile's cells if several threads make it.

#include <CGAL/Delaunay_from_surface_3/support/Thread_executor.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Delaunay_tile.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Range_summary.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_certificate.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_folder.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_news.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_point.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_source_3.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiling.h>
#include <CGAL/Delaunay_from_surface_3/tiles/piece_of_tile.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Of a run: references.
struct Tile_tasks
{
  const Tile_folder& folder;
  const Tile_source_3& source;
  const Tiles_input& input;
  std::size_t limit;   // how many points a tile may keep
  std::size_t threads; // for one task

  std::size_t number_of_ranges() const
  {
    return std::size_t((input.points + input.points_at_once - 1) / input.points_at_once);
  }

  void summarize(std::size_t k) const
  {
    const std::uint64_t first = first_of_range(k);
    folder.write_summary(
        k, summary_of(read_range(source, first, first_of_range(k + 1)), first, sampling()));
  }

  Tiling make_tiling() const
  {
    std::vector<Range_summary> ranges;
    for (std::size_t k = 0; k < number_of_ranges(); ++k)
      ranges.push_back(folder.read_summary(k));
    return tiling_of(ranges, input.points, input.tiles, sampling());
  }

  // A range's points go to the tiles that own them.
  void bring_home(std::size_t k, const Tiling& tiling) const
  {
    const std::uint64_t first = first_of_range(k);
    const std::vector<double> coordinates = read_range(source, first, first_of_range(k + 1));
    const std::size_t n = coordinates.size() / 3;
    std::vector<std::uint32_t> owners(n);
    std::vector<std::uint64_t> ends(input.tiles + 1);
    for (std::size_t i = 0; i < n; ++i) {
      owners[i] = tiling.tree.owner(&coordinates[3 * i]);
      ++ends[owners[i] + 1];
    }
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<std::uint64_t> next = ends;
    std::vector<Tile_point> points(n);
    for (std::size_t i = 0; i < n; ++i)
      points[next[owners[i]]++] = tile_point(first + i, &coordinates[3 * i]);
    folder.write_home(k, ends, points);
  }

  // A tile hears what it was told in the round before, and tells; it also shows those that differ
  // from it why.
  void do_round(std::uint32_t t, const Tiling& tiling, std::size_t round,
                const Closed_round& before, const Tile_pairs& shown) const
  {
    Tile_state state;
    if (round > 0)
      state = folder.read_state(t, before.last_rounds[t]);
    std::optional<Delaunay_tile> tile; // made when something is new
    const auto make = [&] {
      if (!tile)
        tile.emplace(tiling, t, own_points(t), std::move(state), limit, Thread_executor(threads));
    };
    std::vector<Tile_message> questions;
    const auto hear = [&](std::vector<Tile_message> messages) {
      Tile_news news = news_of(std::move(messages), tiling, t, tile ? tile->known() : state.known);
      if (news.empty())
        return;
      make();
      tile->offer(std::move(news.offers));
      std::move(news.questions.begin(), news.questions.end(), std::back_inserter(questions));
    };
    if (round == 0)
      hear({{t, t, tiling.sample}});
    else
      hear_messages(t, round - 1, before, hear);
    const std::vector<std::uint32_t> partners = partners_of(t, shown);
    if (round > 0 && !tile && partners.empty()) // nothing is new
      return folder.write_state(t, round, state);
    make();
    std::vector<Tile_message> messages = tile->tell_and_answer(questions);
    for (Tile_message& message : tile->witnesses(partners))
      messages.push_back(std::move(message));
    if (!messages.empty())
      folder.write_post(t, round, messages);
    std::vector<Tile_message>().swap(messages);
    folder.write_state(t, round, std::move(*tile).state());
  }

  // What a tile has when all is done.
  void finish_tile(std::uint32_t t, const Tiling& tiling, const Closed_round& last) const
  {
    Tile_state state{folder.read_state(t, last.last_rounds[t]).kept, {}, {}}; // nothing is told now
    const Delaunay_tile tile(tiling, t, own_points(t), std::move(state), limit,
                             Thread_executor(threads));
    folder.write_piece(Piece_of_tile(tile));
    folder.write_certificate(certificate_of(tile, last.seed, input.compares_cells != 0));
  }

private:
  std::uint64_t first_of_range(std::size_t k) const
  {
    return (std::min)(input.points, k * input.points_at_once);
  }
  Sampling sampling() const
  {
    return Sampling(input.points, input.tiles, std::size_t(input.sample_share));
  }

  std::vector<Tile_point> own_points(std::uint32_t t) const
  {
    std::vector<Tile_point> own;
    for (std::size_t k = 0; k < number_of_ranges(); ++k)
      folder.append_home(k, t, own);
    return own;
  }

  // Calls hear(messages) for what the tile was told in a round, as often as it takes for no more points to
  // wait than it may keep.
  template <class Hear>
  void hear_messages(std::uint32_t t, std::size_t round, const Closed_round& closed,
                     const Hear& hear) const
  {
    std::vector<Tile_message> messages;
    std::size_t waiting = 0;
    for (const Posted& posted : closed.posts)
      if (posted.to == t) {
        messages.push_back({posted.from, t, {}});
        folder.append_message(posted, round, messages.back().points);
        waiting += messages.back().points.size();
        if (waiting > limit)
          hear(std::exchange(messages, {}));
        waiting = messages.empty() ? 0 : waiting;
      }
    hear(std::move(messages));
  }

  static std::vector<std::uint32_t> partners_of(std::uint32_t t, const Tile_pairs& pairs)
  {
    std::vector<std::uint32_t> partners;
    for (const auto& [a, b] : pairs)
      if (a == t || b == t)
        partners.push_back(a == t ? b : a);
    return partners;
  }
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_TASKS_H
