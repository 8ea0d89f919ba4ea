// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Draws the steps of the algorithm in the plane, where a closed curve stands for the surface: what
// the curve, its triangulations, traces, walks and conflict zones look like is computed, not
// painted. The order and the rounds are those of DFS::Log_star_rounds.
//
//   draw_steps FOLDER

#include "Svg.h"

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Segment = Kernel::Segment_2;
using Triangulation = CGAL::Delaunay_triangulation_2<Kernel>;
using Face = Triangulation::Face_handle;
using figures::Place;
using figures::Svg;

constexpr double pi = 3.14159265358979323846;
constexpr int panel_width = 430, panel_height = 340;

const char* const style =
    ".cell{fill:#f4f7fa;stroke:#9aa7b5;stroke-width:1;stroke-linejoin:round}"
    ".crossed{fill:#ffe3ad;stroke:#9aa7b5;stroke-width:1}"
    ".conflict{fill:#f6c6c2;stroke:#9aa7b5;stroke-width:1}"
    ".star{fill:#d3ecd6;stroke:#5b8f63;stroke-width:1.2;stroke-linejoin:round}"
    ".dead{fill:none;stroke:#c1272d;stroke-width:1.4;stroke-dasharray:4 4}"
    ".circle{fill:none;stroke:#d99a94;stroke-width:.8}"
    ".curve{fill:none;stroke:#c1272d;stroke-width:1.6;stroke-linejoin:round}"
    ".thick{fill:none;stroke:#c1272d;stroke-width:3;stroke-linejoin:round}"
    ".walk{fill:none;stroke:#1d3557;stroke-width:1.6;stroke-dasharray:5 3}"
    ".in{fill:#1d3557}.out{fill:#fff;stroke:#1d3557;stroke-width:1.2}"
    ".now{fill:#c1272d}.record{fill:none;stroke:#2a8f55;stroke-width:3}"
    ".bar0{fill:#dbe6f1}.bar1{fill:#9fbfdd}.bar2{fill:#6d9bc6}.bar3{fill:#4179ad}.bar4{fill:#"
    "27578a}"
    "text{font:14px sans-serif;fill:#222}.middle{text-anchor:middle}.end{text-anchor:end}"
    ".small{font-size:12px}.green{fill:#1f7042;font-weight:bold}.red{fill:#a01d22;font-weight:bold}"
    ".white{fill:#fff;font-size:12px;text-anchor:middle}";

// A closed curve through n points, their insertion order, and the panel they are drawn in.
struct Scene
{
  std::vector<Point> points;
  DFS::Insertion_order plan;
  double left = 0;

  Place place(const Point& p) const { return {left + 20 + p.x(), p.y()}; }
};

Scene make_scene(std::size_t n)
{
  struct No_graph
  {
  };
  Scene scene;
  std::vector<Kernel::Point_3> spatial;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 2 * pi * double(i) / double(n);
    const double r = 1 + 0.34 * std::cos(4 * t + 0.5) + 0.06 * std::cos(7 * t);
    scene.points.emplace_back(185 + 136 * r * std::cos(t), 160 + 104 * r * std::sin(t));
    spatial.emplace_back(scene.points.back().x(), scene.points.back().y(), 0);
  }
  scene.plan = DFS::Log_star_rounds(45)(spatial, Kernel(), No_graph(), No_graph());
  return scene;
}

// D(S_i)
Triangulation triangulation(const Scene& scene, std::size_t i)
{
  Triangulation tr;
  for (std::size_t k = 0; k < i; ++k)
    tr.insert(scene.points[scene.plan.order[k]]);
  return tr;
}

std::vector<bool> inserted(const Scene& scene, std::size_t i)
{
  std::vector<bool> is_in(scene.points.size(), false);
  for (std::size_t k = 0; k < i; ++k)
    is_in[scene.plan.order[k]] = true;
  return is_in;
}

void draw_face(Svg& svg, const Scene& scene, const std::string& what, Face f)
{
  svg.polygon(what, {scene.place(f->vertex(0)->point()), scene.place(f->vertex(1)->point()),
                     scene.place(f->vertex(2)->point())});
}

void draw_triangulation(Svg& svg, const Scene& scene, const Triangulation& tr)
{
  for (const Face f : tr.finite_face_handles())
    draw_face(svg, scene, "cell", f);
}

// T: the curve without its last edge.
void draw_curve(Svg& svg, const Scene& scene, const std::string& what, std::size_t first,
                std::size_t last)
{
  std::vector<Place> places;
  for (std::size_t i = first; i <= last; ++i)
    places.push_back(scene.place(scene.points[i]));
  svg.line(what, places);
}

void draw_points(Svg& svg, const Scene& scene, const std::vector<bool>& is_in)
{
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    svg.circle(is_in[i] ? "in" : "out", scene.place(scene.points[i]), is_in[i] ? 4.5 : 3);
}

// The finite faces that the segment goes through. It is sampled: faces that it only touches are
// none.
std::vector<Face> crossed_faces(const Triangulation& tr, const Segment& segment)
{
  std::vector<Face> faces;
  for (int i = 1; i < 200; ++i) {
    const Face f = tr.locate(segment.source() + i / 200. * segment.to_vector());
    if (!tr.is_infinite(f) && std::find(faces.begin(), faces.end(), f) == faces.end())
      faces.push_back(f);
  }
  return faces;
}

// The vertex of the cell of p that is nearest to p; never the infinite one.
Point nearest_vertex_in_cell(const Triangulation& tr, const Point& p)
{
  const Face f = tr.locate(p);
  Point nearest;
  bool is_first = true;
  for (int i = 0; i < 3; ++i) {
    if (tr.is_infinite(f->vertex(i)))
      continue;
    const Point& q = f->vertex(i)->point();
    if (is_first || CGAL::has_smaller_distance_to_point(p, q, nearest))
      nearest = q;
    is_first = false;
  }
  return nearest;
}

void caption(Svg& svg, int panel, const std::string& words)
{
  svg.text("middle", {panel_width * (panel + 0.5), panel_height - 12.}, words);
}

void draw_surface_step(const std::string& folder, Scene scene)
{
  Svg svg(2 * panel_width, panel_height, style);
  svg.polygon("curve", [&] {
    std::vector<Place> all;
    for (const Point& p : scene.points)
      all.push_back(scene.place(p));
    return all;
  }());
  draw_points(svg, scene, inserted(scene, 0));
  caption(svg, 0, "the surface F and its points S");
  scene.left = panel_width;
  const std::size_t n_1 = scene.plan.round_ends[0];
  draw_triangulation(svg, scene, triangulation(scene, n_1));
  draw_curve(svg, scene, "curve", 0, scene.points.size() - 1);
  draw_points(svg, scene, inserted(scene, n_1));
  caption(svg, 1,
          "T, and D(S<tspan baseline-shift='sub' font-size='11.5'>N₁</tspan>) of the first round");
  svg.write(folder + "/step_surface.svg");
}

// The longest run of points between two inserted ones that lies in finite faces.
std::pair<std::size_t, std::size_t> longest_gap(const Triangulation& tr, const Scene& scene,
                                                const std::vector<bool>& is_in)
{
  std::pair<std::size_t, std::size_t> best = {0, 0};
  std::size_t first = 0;
  for (std::size_t i = 0; i < is_in.size(); ++i) {
    if (is_in[i] && is_in[first] && i - first > best.second - best.first)
      best = {first, i};
    if (is_in[i] || tr.is_infinite(tr.locate(scene.points[i])))
      first = i;
  }
  return best;
}

void draw_trace_step(const std::string& folder, Scene scene)
{
  const std::size_t n_1 = scene.plan.round_ends[0];
  const Triangulation tr = triangulation(scene, n_1);
  const std::vector<bool> is_in = inserted(scene, n_1);
  const auto [first, last] = longest_gap(tr, scene, is_in);

  Svg svg(2 * panel_width, panel_height, style);
  draw_triangulation(svg, scene, tr);
  for (std::size_t i = first; i < last; ++i)
    for (const Face f : crossed_faces(tr, Segment(scene.points[i], scene.points[i + 1])))
      draw_face(svg, scene, "crossed", f);
  draw_curve(svg, scene, "curve", 0, scene.points.size() - 1);
  draw_curve(svg, scene, "thick", first, last);
  draw_points(svg, scene, is_in);
  caption(svg, 0, "the trace walks along T, from cell to cell");

  scene.left = panel_width;
  draw_triangulation(svg, scene, tr);
  draw_curve(svg, scene, "curve", first, last);
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    if (!is_in[i] && first < i && i < last) {
      const auto v = nearest_vertex_in_cell(tr, scene.points[i]);
      svg.line("walk", {scene.place(scene.points[i]), scene.place(v)});
      svg.circle("record", scene.place(v), 8);
    }
  draw_points(svg, scene, is_in);
  caption(svg, 1, "each point records a vertex of its cell");
  svg.write(folder + "/step_trace.svg");
}

// The place in the order of the point, among those whose recorded cell is dead when their turn
// comes, that is farthest from its recorded vertex.
std::size_t instructive_turn(const Scene& scene)
{
  const std::size_t n_1 = scene.plan.round_ends[0];
  const Triangulation first = triangulation(scene, n_1);
  std::size_t best = n_1;
  double farthest = 0;
  for (std::size_t k = n_1 + 4; k < scene.points.size(); ++k) {
    const Point& p = scene.points[scene.plan.order[k]];
    const Triangulation now = triangulation(scene, k);
    const Face then = first.locate(p);
    if (first.is_infinite(then) || now.is_infinite(now.locate(p)) ||
        now.triangle(now.locate(p)) == first.triangle(then))
      continue;
    const Point v = nearest_vertex_in_cell(first, p);
    const double distance = CGAL::squared_distance(v, p);
    if (distance > farthest && crossed_faces(now, Segment(v, p)).size() > 2)
      farthest = distance, best = k;
  }
  return best;
}

void draw_record_step(const std::string& folder, Scene scene)
{
  const std::size_t n_1 = scene.plan.round_ends[0], k = instructive_turn(scene);
  const Point p = scene.points[scene.plan.order[k]];
  const Triangulation then = triangulation(scene, n_1), now = triangulation(scene, k);
  const Face recorded = then.locate(p);
  const Point v = nearest_vertex_in_cell(then, p);
  const auto mark = [&](Svg& svg) {
    svg.circle("now", scene.place(p), 5);
    svg.circle("record", scene.place(v), 8);
    svg.text("red", {scene.place(p).x - 4, scene.place(p).y - 11},
             "s<tspan baseline-shift='sub' font-size='11.5'>i</tspan>");
    svg.text("green", {scene.place(v).x - 5, scene.place(v).y - 13}, "v");
  };

  Svg svg(2 * panel_width, panel_height, style);
  draw_triangulation(svg, scene, then);
  draw_face(svg, scene, "crossed", recorded);
  draw_points(svg, scene, inserted(scene, n_1));
  mark(svg);
  caption(svg, 0, "traced: the cell of a point, and its vertex v");

  scene.left = panel_width;
  draw_triangulation(svg, scene, now);
  for (const Face f : crossed_faces(now, Segment(v, p)))
    draw_face(svg, scene, "crossed", f);
  draw_face(svg, scene, "dead", recorded);
  svg.line("walk", {scene.place(v), scene.place(p)});
  draw_points(svg, scene, inserted(scene, k));
  mark(svg);
  caption(svg, 1, "later: the cell is gone, v is not; walk from v");
  svg.write(folder + "/step_record.svg");
}

void draw_update_step(const std::string& folder, Scene scene)
{
  const std::size_t k = instructive_turn(scene);
  const Point p = scene.points[scene.plan.order[k]];
  Triangulation tr = triangulation(scene, k);
  std::vector<Face> conflicts;
  tr.get_conflicts(p, std::back_inserter(conflicts));

  Svg svg(2 * panel_width, panel_height, style);
  draw_triangulation(svg, scene, tr);
  for (const Face f : conflicts)
    if (!tr.is_infinite(f))
      draw_face(svg, scene, "conflict", f);
  svg.begin_clip("left", {0, 0}, panel_width, panel_height - 35);
  for (const Face f : conflicts)
    if (!tr.is_infinite(f)) {
      const Point center = tr.circumcenter(f);
      const double radius = std::sqrt(CGAL::squared_distance(center, f->vertex(0)->point()));
      svg.circle("circle", scene.place(center), radius);
    }
  svg.end_clip();
  draw_points(svg, scene, inserted(scene, k));
  svg.circle("now", scene.place(p), 5);
  caption(svg, 0, "the cells in conflict with the point are destroyed");

  scene.left = panel_width;
  const auto vertex = tr.insert(p);
  draw_triangulation(svg, scene, tr);
  for (const Face f : tr.finite_face_handles())
    if (f->has_vertex(vertex))
      draw_face(svg, scene, "star", f);
  draw_points(svg, scene, inserted(scene, k + 1));
  svg.circle("now", scene.place(p), 5);
  caption(svg, 1, "and replaced by its star");
  svg.write(folder + "/step_update.svg");
}

// The rounds of both plans for a million points, as shares of a line.
void draw_rounds(const std::string& folder)
{
  constexpr std::size_t n = 1000000;
  constexpr double left = 150, width = 660;
  Svg svg(2 * panel_width, 190, style);
  const auto bars = [&](double y, const std::string& name, const std::vector<std::size_t>& ends) {
    svg.text("end", {left - 12, y + 23}, name);
    double x = left;
    for (std::size_t h = 0; h < ends.size(); ++h) {
      const double right = left + width * double(ends[h]) / double(n);
      svg.rectangle("bar" + std::to_string(h % 5), {x, y}, right - x, 34);
      if (right - x > 25 && h + 1 < ends.size())
        svg.text("small middle", {right, y + 50}, std::to_string(ends[h]));
      x = right;
    }
  };
  bars(20, "Log_star_rounds", DFS::Log_star_rounds::round_ends(n));
  bars(100, "Geometric_rounds", DFS::Geometric_rounds().round_ends(n));
  svg.text("small", {left, 180}, "0");
  svg.text("small end", {left + width, 180}, "n = 1000000");
  svg.write(folder + "/rounds.svg");
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc != 2) {
    std::cerr << "usage: draw_steps FOLDER\n";
    return 2;
  }
  try {
    const Scene scene = make_scene(80);
    draw_surface_step(argv[1], scene);
    draw_trace_step(argv[1], scene);
    draw_record_step(argv[1], scene);
    draw_update_step(argv[1], scene);
    draw_rounds(argv[1]);
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return 1;
  }
}
