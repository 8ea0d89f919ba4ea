// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_NEWS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_NEWS_H

// What is new in what a tile was told.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_point.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiling.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

struct Tile_news
{
  std::vector<Tile_point> offers;      // by id, each once
  std::vector<Tile_message> questions; // about points of the tile's own

  bool empty() const { return offers.empty() && questions.empty(); }
};

// Of tile t, which knows ids that ascend. The sample is from the tile itself, and asks nothing.
inline Tile_news news_of(std::vector<Tile_message> messages, const Tiling& tiling, std::uint32_t t,
                         const std::vector<std::uint64_t>& known)
{
  Tile_news news;
  std::size_t number = 0;
  for (const Tile_message& message : messages)
    number += message.points.size();
  news.offers.reserve(number);
  for (Tile_message& message : messages) {
    Tile_message question{message.from, t, {}};
    for (const Tile_point& p : message.points)
      if (tiling.tree.owner(p.coordinates) == t)
        question.points.push_back(p);
      else
        news.offers.push_back(p);
    if (message.from != t && !question.points.empty())
      news.questions.push_back(std::move(question));
    std::vector<Tile_point>().swap(message.points);
  }
  std::sort(news.offers.begin(), news.offers.end(),
            [](const Tile_point& p, const Tile_point& q) { return p.id < q.id; });
  auto k = known.begin();
  std::uint64_t last = std::uint64_t(-1);
  const auto is_old = [&](const Tile_point& p) {
    while (k != known.end() && *k < p.id)
      ++k;
    const bool is_known = (k != known.end() && *k == p.id) || p.id == last;
    last = p.id;
    return is_known;
  };
  news.offers.erase(std::remove_if(news.offers.begin(), news.offers.end(), is_old),
                    news.offers.end());
  return news;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILE_NEWS_H
