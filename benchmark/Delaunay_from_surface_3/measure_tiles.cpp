// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Counts what tiles tell each other and keep, on surfaces, solids, spheres, planes and cubes; and takes
// the time of the sequential call of arrays beside it. Writes JSON.

#include <Delaunay_from_surface_3_comparison/run_program.h>
#include <Delaunay_from_surface_3_comparison/surfaces.h>
#include <Delaunay_from_surface_3_surfaces/cad.h>

#include <CGAL/delaunay_3_arrays.h>
#include <CGAL/delaunay_3_tiles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace core = CGAL::Delaunay_from_surface_3::core;
using comparison::Json;
using Points = std::vector<std::array<double, 3>>;

constexpr std::uint64_t seed = 2024;

struct Options
{
  std::vector<std::size_t> sizes = {300000}, tiles = {16, 64, 256};
  std::vector<std::string> only;
  std::string data = ".";
};

double seconds_since(std::clock_t start)
{
  return double(std::clock() - start) / CLOCKS_PER_SEC;
}

double rounded(double x)
{
  return comparison::rounded(x, 1e3);
}

// Of something that each tile has so much of, for each of its own points.
struct Share
{
  double sum = 0, worst = 0;
  std::size_t own = 0;

  void add(double part, std::size_t points)
  {
    sum += part;
    own += points;
    if (points > 0)
      worst = (std::max)(worst, part / double(points));
  }
  Json json() const { return {{"mean", rounded(sum / double(own))}, {"worst", rounded(worst)}}; }
};

// What tiles would send each other, were each on a machine of its own: one message to each that is told
// of something in a round, of 16 bytes and 32 for a point.
struct Load
{
  std::vector<std::uint64_t> sent, received, messages_of; // bytes by tile; messages sent by it
  std::vector<std::uint64_t> by_round;                    // messages

  explicit Load(std::uint32_t tiles)
    : sent(tiles)
    , received(tiles)
    , messages_of(tiles)
  {
  }
  void add(const core::Tile_message& message)
  {
    const std::uint64_t bytes = 16 + 32 * message.points.size();
    sent[message.from] += bytes;
    received[message.to] += bytes;
    ++messages_of[message.from];
    ++by_round.back();
  }
  void add_shown(const CGAL::Tiles_here_3& engine, const core::Tile_pairs& pairs)
  {
    for (const auto& [a, b] : pairs)
      for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)})
        for (const core::Tile_message& message : engine.tiles()[from]->witnesses({to}))
          add(message);
  }
  Json json(const std::vector<core::Tile_certificate>& certificates) const
  {
    Share all_sent, all_received;
    std::uint64_t certificate = 0, partners = 0;
    for (const core::Tile_certificate& c : certificates) {
      all_sent.add(double(sent[c.tile]), std::size_t(c.own_points));
      all_received.add(double(received[c.tile]), std::size_t(c.own_points));
      certificate += 60 + 29 * c.common.size();
      partners = (std::max)(partners, std::uint64_t(c.common.size()));
    }
    return {{"messages_by_round", by_round},
            {"most_messages_of_a_tile", *std::max_element(messages_of.begin(), messages_of.end())},
            {"most_partners", partners},
            {"bytes_sent_per_own_point", all_sent.json()},
            {"bytes_received_per_own_point", all_received.json()},
            {"bytes_to_bring_a_point_home", 32},
            {"bytes_of_certificates", certificate}};
  }
};

// The tiles run to their end, and what each was told is counted on the way.
Json count_tiles(const Points& points, std::uint32_t tiles)
{
  CGAL::Tiles_options options;
  options.number_of_tiles = tiles;
  const std::clock_t start = std::clock();
  CGAL::Tiles_here_3 engine;
  engine.begin(CGAL::Tile_array_source_3(points.front().data(), points.size()), options);
  const double own_seconds = seconds_since(start);
  std::vector<std::uint64_t> told(tiles);
  std::vector<std::uint64_t> by_round;
  Load load(tiles);
  const auto run_to_rest = [&] {
    do {
      load.by_round.push_back(0);
      by_round.push_back(0);
      std::vector<core::Tile_message> messages = engine.tell();
      for (const core::Tile_message& message : messages) {
        by_round.back() += message.points.size();
        told[message.to] += message.points.size();
        load.add(message);
      }
      engine.deliver(std::move(messages));
    } while (by_round.back() > 0);
  };
  run_to_rest();
  const double rest = seconds_since(start);
  const auto draw = [] { return std::uint64_t(seed); };
  auto certificates = engine.gather(draw);
  const double all = seconds_since(start);
  std::uint64_t shown = 0; // as the driver does it, where tiles are small
  for (auto pairs = core::tiles_that_differ(certificates); !pairs.empty();
       pairs = core::tiles_that_differ(certificates)) {
    shown += pairs.size();
    load.add_shown(engine, pairs);
    engine.show(pairs);
    run_to_rest();
    certificates = engine.gather(draw);
  }
  if (!core::is_certified(certificates, tiles, points.size()))
    throw std::runtime_error("the certificate does not hold");
  Share shares_told, kept, needed;
  for (std::uint32_t t = 0; t < tiles; ++t) {
    const auto own = std::size_t(certificates[t].own_points);
    const auto piece = engine.tile(t);
    shares_told.add(double(told[t]), own);
    kept.add(double(certificates[t].points_kept), own);
    needed.add(double(piece.ids.size() - piece.number_of_own_vertices), own);
  }
  return {{"tiles", tiles},
          {"rounds", by_round.size()},
          {"told_by_round", by_round},
          {"needed", needed.json()},
          {"told", shares_told.json()},
          {"kept", kept.json()},
          {"pairs_that_differed", shown},
          {"load", load.json(certificates)},
          {"seconds_own", rounded(own_seconds)},
          {"seconds_offers", rounded(rest - own_seconds)},
          {"seconds_certificate", rounded(all - rest)}};
}

Json measure(const std::string& name, const surfaces::Indexed_surface& surface,
             const Options& options)
{
  Points points;
  for (const auto& p : surface.points)
    points.push_back({p.x(), p.y(), p.z()});
  const std::clock_t start = std::clock();
  const auto arrays = CGAL::delaunay_3_arrays(points);
  Json result = {{"input", name},
                 {"points", points.size()},
                 {"cells", arrays.number_of_cells()},
                 {"seconds_arrays", rounded(seconds_since(start))},
                 {"counts", Json::array()}};
  for (const std::size_t tiles : options.tiles)
    result["counts"].push_back(count_tiles(points, std::uint32_t(tiles)));
  std::cerr << result.dump() << '\n';
  return result;
}

// Points exactly in two planes that meet at an angle.
surfaces::Indexed_surface tilted_planes(std::size_t n)
{
  surfaces::Indexed_surface points;
  const auto side = std::size_t(std::sqrt(double(n / 2)));
  for (std::size_t i = 0; i < side; ++i)
    for (std::size_t j = 0; j < side; ++j) {
      points.points.emplace_back(double(i), double(j), 0.);
      points.points.emplace_back(double(i), double(j), double(i + side));
    }
  return points;
}

void measure_into(const Options& options, Json& report)
{
  report["results"] = Json::array();
  auto inputs = comparison::named_surfaces(options.data);
  for (const char* name : {"dragon", "cheese"}) {
    const std::string file =
        name == std::string("dragon") ? "ChineseDragon-10kv.off" : "cheese.off";
    inputs.push_back(comparison::densified_mesh(name, 20000, options.data + "/" + file));
  }
  for (const auto& family : surfaces::cad_families())
    inputs.push_back({family.name, "", 100, [make = family.make](std::size_t n, std::uint64_t s) {
                        return make(n, s, surfaces::Numbering(0));
                      }});
  inputs.push_back(
      {"tilted-planes", "", 100, [](std::size_t n, std::uint64_t) { return tilted_planes(n); }});
  inputs.push_back({"cube", "", 100, [](std::size_t n, std::uint64_t s) {
                      return surfaces::points_in_box(n, 1, 1, 1, s);
                    }});
  for (const std::size_t n : options.sizes)
    for (const auto& input : inputs)
      if (options.only.empty() ||
          std::find(options.only.begin(), options.only.end(), input.name) != options.only.end())
        report["results"].push_back(measure(input.name, input.make(n, seed), options));
}

} // namespace

int main(int argc, char** argv)
{
  Options o;
  comparison::Program program("measure_tiles", "Counts what tiles tell each other and keep");
  program.option("sizes", o.sizes, "N...", "numbers of points (300000)");
  program.option("tiles", o.tiles, "N...", "numbers of tiles (16 64 256)");
  program.option("only", o.only, "NAME...", "names of inputs; all if not given");
  program.option("data", o.data, "FOLDER",
                 "the folder with bunny00.off, refined_elephant.off and others");
  return program.run(argc, argv, [&](Json& report) { measure_into(o, report); });
}
