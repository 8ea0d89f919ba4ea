// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_REPORT_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_REPORT_H

// What the laboratory counted, as JSON.

#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_theory/count_locations.h>
#include <Delaunay_from_surface_3_theory/fractions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace theory {

using comparison::Json;
using comparison::rounded;

inline const char* name_of(std::size_t way)
{
  static const char* const names[NUMBER_OF_WAYS] = {"history-root",   "history-trace",
                                                    "conflicts-root", "conflicts-trace",
                                                    "walk-neighbor",  "walk-random"};
  return names[way];
}

inline Json per_point(std::size_t cells_entered, std::size_t calls, std::size_t points)
{
  const double n = double((std::max)(points, std::size_t(1)));
  return {{"cells_entered", rounded(double(cells_entered) / n, 1e4)},
          {"calls", rounded(double(calls) / n, 1e4)}};
}

// Cells entered and calls per located point, by way; the trace's share of `history-trace` apart,
// per point.
inline Json locations_as_json(const std::vector<Round_cost>& rounds)
{
  Json result;
  for (std::size_t way = 0; way < NUMBER_OF_WAYS; ++way) {
    Location_cost sum;
    for (const Round_cost& round : rounds)
      sum += round.ways[way];
    if (sum.points > 0)
      result[name_of(way)] = per_point(sum.cells_entered, sum.calls, sum.points);
  }
  const auto add_traces = [&](Way way, Location_cost Round_cost::*part) {
    Location_cost trace;
    for (const Round_cost& round : rounds)
      trace += round.*part;
    const Json traces = per_point(trace.cells_entered, trace.calls, rounds.back().end);
    if (result.contains(name_of(way))) {
      result[name_of(way)]["trace_cells_entered"] = traces["cells_entered"];
      result[name_of(way)]["trace_calls"] = traces["calls"];
    }
  };
  add_traces(HISTORY_FROM_TRACE, &Round_cost::trace);
  add_traces(CONFLICTS_FROM_TRACE, &Round_cost::conflict_trace);
  return result;
}

// Theorem 3: the crossings of T with D(S_{N_h}), by the number of all points.
inline Json traces_as_json(const std::vector<Round_cost>& rounds)
{
  Json traces = Json::array();
  const double n = double(rounds.back().end);
  for (std::size_t h = 0; h + 1 < rounds.size(); ++h) {
    const Location_cost& trace = rounds[h].trace;
    Json result = {{"after", rounds[h].end},
                   {"crossings_per_point", rounded(double(rounds[h].crossings) / n, 1e4)},
                   {"located", trace.points}};
    result.update(per_point(trace.cells_entered, trace.calls, trace.points));
    traces.push_back(result);
  }
  return traces;
}

// Theorem 5: in round h a descent from the last trace, or from the root before there is one, takes
// O(log^(h) n). `lemma_4` is the mean of 4 ln(i/k) for the points s_i of the round and a trace
// after s_k: what is expected if no point is ever outside the convex hull.
inline Json rounds_as_json(const std::vector<Round_cost>& rounds)
{
  Json result = Json::array();
  std::size_t k = 0;
  double log_h = double(rounds.back().end);
  for (const Round_cost& round : rounds) {
    log_h = std::log2(log_h);
    double logarithms = 0;
    for (std::size_t i = k + 1; i <= round.end; ++i)
      logarithms += 4 * std::log(double(i) / double((std::max)(k, std::size_t(1))));
    Json row = {{"points", round.end - k},
                {"iterated_log", rounded(log_h, 1e4)},
                {"lemma_4", rounded(logarithms / double(round.end - k), 1e4)}};
    for (const Way way : {HISTORY_FROM_ROOT, HISTORY_FROM_TRACE})
      row[name_of(way)] =
          rounded(double(round.ways[way].cells_entered) / double(round.ways[way].points), 1e4);
    result.push_back(row);
    k = round.end;
  }
  return result;
}

// How far the assumptions hold, when all points are in. Sorts T.
inline Json assumptions_as_json(Laboratory& laboratory, const Indexed_surface& surface,
                                const Edges& edges_of_surface, Edges subgraph)
{
  const auto& tr = laboratory.triangulation();
  const auto vertices = laboratory.take_vertices();
  std::sort(subgraph.begin(), subgraph.end());
  const Edges delaunay = delaunay_edges(tr, vertices);
  const Edges emst = euclidean_minimum_spanning_tree(surface.points, delaunay, edges_of_surface);
  const auto share_in = [](const Edges& edges, const Edges& sorted) {
    return rounded(fraction(edges, [&](const Edge& e) { return contains(sorted, e); }));
  };
  std::vector<std::size_t> degrees(surface.points.size(), 0);
  for (const Edge& e : subgraph)
    ++degrees[e[0]], ++degrees[e[1]];
  const double n = double(surface.points.size());
  return {{"subgraph_edges_delaunay", share_in(subgraph, delaunay)},
          {"surface_edges_delaunay", share_in(edges_of_surface, delaunay)},
          {"surface_triangles_delaunay", rounded(delaunay_triangles(tr, vertices, surface.faces))},
          {"emst_edges_in_surface", share_in(emst, edges_of_surface)},
          {"emst_edges_in_subgraph", share_in(emst, subgraph)},
          {"subgraph_edges_per_point", rounded(double(subgraph.size()) / n, 1e4)},
          {"subgraph_degree", *std::max_element(degrees.begin(), degrees.end())},
          {"delaunay_cells_per_point", rounded(double(tr.number_of_cells()) / n, 1e4)},
          {"cells_created_per_point",
           rounded(double(laboratory.history().number_of_nodes()) / n, 1e4)}};
}

// Least squares: y = a + b log2 n.
inline Json fit(const std::vector<double>& n, const std::vector<double>& y)
{
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  const double m = double(n.size());
  for (std::size_t k = 0; k < n.size(); ++k) {
    const double x = std::log2(n[k]);
    sx += x, sy += y[k], sxx += x * x, sxy += x * y[k];
  }
  const double b = (m * sxy - sx * sy) / (m * sxx - sx * sx);
  return {{"a", rounded((sy - b * sx) / m, 1e4)}, {"b", rounded(b, 1e4)}};
}

} // namespace theory

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_THEORY_REPORT_H
