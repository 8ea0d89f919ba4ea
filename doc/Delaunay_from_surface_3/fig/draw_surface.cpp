// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Draws the teaser: a surface with a spanning forest T, the triangulation D(S_{N_1}) of the first
// round's points with the surface in it, and the Delaunay triangulation of all vertices. Both
// triangulations are cut by a plane.
//
//   draw_surface MESH.off TEASER.svg

#include "Svg.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/insert_surface_vertices_3.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/plan/Log_star_rounds.h>
#include <CGAL/Delaunay_from_surface_3/subgraph/Spanning_forest.h>
#include <CGAL/Tracing_traits_3.h>

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
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
using Inside = CGAL::Side_of_triangle_mesh<Mesh, Kernel>;
using figures::Place;
using figures::Svg;

constexpr int panel_width = 420, panel_height = 400, number_of_shades = 12;

// A parallel projection that fits the points into a panel.
class Camera
{
public:
  Camera(const std::vector<Point>& points, double turn, double tilt)
    : m_right(std::cos(turn), 0, -std::sin(turn))
    , m_up(-std::sin(turn) * std::sin(tilt), std::cos(tilt), -std::cos(turn) * std::sin(tilt))
    , m_back(CGAL::cross_product(m_right, m_up))
  {
    double min_x = 1e300, max_x = -1e300, min_y = 1e300, max_y = -1e300;
    for (const Point& p : points) {
      const Vector v = p - CGAL::ORIGIN;
      min_x = (std::min)(min_x, v * m_right), max_x = (std::max)(max_x, v * m_right);
      min_y = (std::min)(min_y, v * m_up), max_y = (std::max)(max_y, v * m_up);
    }
    m_scale =
        (std::min)((panel_width - 30) / (max_x - min_x), (panel_height - 70) / (max_y - min_y));
    m_x = (min_x + max_x) / 2, m_y = (min_y + max_y) / 2;
  }

  // Towards the viewer.
  const Vector& back() const { return m_back; }

  Place place(const Point& p, int panel) const
  {
    const Vector v = p - CGAL::ORIGIN;
    return {panel_width * (panel + 0.5) + m_scale * (v * m_right - m_x),
            (panel_height - 40) / 2. - m_scale * (v * m_up - m_y)};
  }

  // How bright a facet with this normal is, and whether it faces the viewer at all.
  int shade(const Vector& normal) const
  {
    const Vector light = m_back + 0.5 * m_up - 0.45 * m_right;
    const double brightness =
        (normal * light) / std::sqrt(normal.squared_length() * light.squared_length());
    return int(std::clamp(0.25 + 0.75 * brightness, 0., 0.999) * number_of_shades);
  }
  bool sees(const Vector& normal) const { return normal * m_back > 0; }

private:
  Vector m_right, m_up, m_back;
  double m_scale, m_x, m_y;
};

std::string shades(const std::string& name, double r, double g, double b)
{
  std::string style;
  for (int i = 0; i < number_of_shades; ++i) {
    const double light = 0.45 + 0.55 * i / (number_of_shades - 1);
    style += "." + name + std::to_string(i) + "{fill:rgb(" + std::to_string(int(r * light)) + "," +
             std::to_string(int(g * light)) + "," + std::to_string(int(b * light)) + ")}";
  }
  return style;
}

struct Surface
{
  Mesh mesh;
  std::vector<Point> points; // by vertex index
  std::vector<std::pair<std::size_t, std::size_t>> forest;
};

Surface read_surface(const std::string& file_name)
{
  Surface surface;
  if (!CGAL::IO::read_OFF(file_name, surface.mesh))
    throw std::runtime_error("cannot read " + file_name);
  for (const auto v : surface.mesh.vertices())
    surface.points.push_back(surface.mesh.point(v));
  std::vector<Mesh::Edge_index> edges;
  DFS::Spanning_forest()(surface.mesh, get(boost::vertex_index, surface.mesh),
                         std::back_inserter(edges));
  for (const auto e : edges)
    surface.forest.emplace_back(source(e, surface.mesh), target(e, surface.mesh));
  return surface;
}

// The faces that face the viewer, the farthest first.
void draw_mesh(Svg& svg, const Surface& surface, const Camera& camera, int panel)
{
  struct Face
  {
    double depth;
    int shade;
    std::vector<Place> corners;
  };
  std::vector<Face> faces;
  for (const auto f : surface.mesh.faces()) {
    std::vector<Point> p;
    for (const auto v : vertices_around_face(surface.mesh.halfedge(f), surface.mesh))
      p.push_back(surface.mesh.point(v));
    const Vector normal = CGAL::normal(p[0], p[1], p[2]);
    if (!camera.sees(normal))
      continue;
    Face face = {(CGAL::centroid(p[0], p[1], p[2]) - CGAL::ORIGIN) * camera.back(),
                 camera.shade(normal),
                 {}};
    for (const Point& q : p)
      face.corners.push_back(camera.place(q, panel));
    faces.push_back(face);
  }
  std::sort(faces.begin(), faces.end(),
            [](const Face& a, const Face& b) { return a.depth < b.depth; });
  for (const Face& face : faces)
    svg.polygon("s" + std::to_string(face.shade), face.corners);
}

Vector normal_at(const Mesh& mesh, std::size_t i)
{
  Vector sum = CGAL::NULL_VECTOR;
  for (const auto h : halfedges_around_target(halfedge(Mesh::Vertex_index(i), mesh), mesh))
    sum = sum + CGAL::normal(mesh.point(source(h, mesh)), mesh.point(target(h, mesh)),
                             mesh.point(target(next(h, mesh), mesh)));
  return sum;
}

// The edges of T on the side of the surface that is seen.
void draw_forest(Svg& svg, const Surface& surface, const Camera& camera, int panel)
{
  std::vector<std::vector<Place>> edges;
  for (const auto& [i, j] : surface.forest)
    if (camera.sees(normal_at(surface.mesh, i)) && camera.sees(normal_at(surface.mesh, j)))
      edges.push_back(
          {camera.place(surface.points[i], panel), camera.place(surface.points[j], panel)});
  svg.lines("t", edges);
}

// Where the edges between these points cross the plane that faces the viewer at this depth.
std::vector<Place> section(const std::vector<Point>& points, const Camera& camera, int panel,
                           double depth)
{
  const auto height = [&](const Point& p) { return (p - CGAL::ORIGIN) * camera.back() - depth; };
  std::vector<Place> places;
  Place middle = {0, 0};
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double a = height(points[i]), b = height(points[j]);
      if ((a < 0) == (b < 0))
        continue;
      places.push_back(camera.place(points[i] + a / (a - b) * (points[j] - points[i]), panel));
      middle.x += places.back().x, middle.y += places.back().y;
    }
  middle.x /= double(places.size()), middle.y /= double(places.size());
  const auto angle = [&](const Place& p) { return std::atan2(p.y - middle.y, p.x - middle.x); };
  std::sort(places.begin(), places.end(),
            [&](const Place& p, const Place& q) { return angle(p) < angle(q); });
  return places;
}

// The cells cut by the plane: those inside the surface in another colour, if there is `inside`.
void draw_cells(Svg& svg, const Triangulation& tr, const Inside* inside, const Camera& camera,
                int panel, double depth)
{
  std::vector<std::vector<Place>> inner, outer;
  for (const auto c : tr.finite_cell_handles()) {
    std::vector<Point> p;
    for (int i = 0; i < 4; ++i)
      p.push_back(c->vertex(i)->point());
    const std::vector<Place> corners = section(p, camera, panel, depth);
    if (corners.empty())
      continue;
    const Point middle = CGAL::centroid(p[0], p[1], p[2], p[3]);
    const bool is_inside = inside && (*inside)(middle) == CGAL::ON_BOUNDED_SIDE;
    (is_inside ? inner : outer).push_back(corners);
  }
  svg.polygons("o", outer);
  svg.polygons("i", inner);
}

// The surface cut by the plane.
void draw_outline(Svg& svg, const Surface& surface, const Camera& camera, int panel, double depth)
{
  std::vector<std::vector<Place>> outline;
  for (const auto f : surface.mesh.faces()) {
    std::vector<Point> p;
    for (const auto v : vertices_around_face(surface.mesh.halfedge(f), surface.mesh))
      p.push_back(surface.mesh.point(v));
    const std::vector<Place> ends = section(p, camera, panel, depth);
    if (!ends.empty())
      outline.push_back(ends);
  }
  svg.lines("t", outline);
}

void draw(const std::string& mesh_file, const std::string& svg_file)
{
  const Surface surface = read_surface(mesh_file);
  const Camera camera(surface.points, 0., 0.1);
  double depth = 0;
  for (const Point& p : surface.points)
    depth += (p - CGAL::ORIGIN) * camera.back() / double(surface.points.size());

  const DFS::Insertion_order plan = DFS::Log_star_rounds(0)(surface.points, Kernel(), surface.mesh,
                                                            get(boost::vertex_index, surface.mesh));
  Triangulation first_round, all;
  for (std::size_t k = 0; k < plan.round_ends.front(); ++k)
    first_round.insert(surface.points[plan.order[k]]);
  CGAL::insert_surface_vertices_3(all, surface.mesh, CGAL::Tracing_traits_3());
  const Inside inside(surface.mesh);

  Svg svg(3 * panel_width, panel_height,
          "path{stroke-linejoin:round;stroke-linecap:round;stroke:#3d4a5c;stroke-width:.3}"
          ".t{stroke:#c1272d;stroke-width:1.3;fill:none}.o{fill:#e3edf7}.i{fill:#f9b95c}"
          "text{font:15px sans-serif;text-anchor:middle;fill:#222}" +
              shades("s", 214, 222, 232));
  draw_mesh(svg, surface, camera, 0);
  draw_forest(svg, surface, camera, 0);
  draw_cells(svg, first_round, nullptr, camera, 1, depth);
  draw_outline(svg, surface, camera, 1, depth);
  draw_cells(svg, all, &inside, camera, 2, depth);
  const char* const captions[] = {"the surface F with a spanning forest T",
                                  "F in the triangulation of some points, cut",
                                  "the triangulation of all points, cut"};
  for (int panel = 0; panel < 3; ++panel)
    svg.text("", {panel_width * (panel + 0.5), panel_height - 14.}, captions[panel]);
  svg.write(svg_file);
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc != 3) {
    std::cerr << "usage: draw_surface MESH.off TEASER.svg\n";
    return 2;
  }
  try {
    draw(argv[1], argv[2]);
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return 1;
  }
}
