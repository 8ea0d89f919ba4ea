// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_SURFACE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_SURFACE_H

#include <Delaunay_from_surface_3_files/read_polygon_soup.h>

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/insert_points_3.h>
#include <CGAL/insert_surface_vertices_3.h>
#include <CGAL/insert_weighted_points_3.h>
#include <CGAL/tags.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iomanip>
#include <sstream>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
using Regular = CGAL::Regular_triangulation_3<Kernel>; // of --weights
using Mesh = CGAL::Surface_mesh<Point>;

// The contents of a file. The points are in the order of the file, also as vertices of the mesh.
struct Surface
{
  std::vector<Point> points;
  std::vector<Regular::Weighted_point> weighted; // the same points, if they have weights
  std::vector<std::vector<std::size_t>> faces;
  Mesh mesh; // the same points and faces again, if they are a manifold
  bool is_manifold = false;
  std::size_t collapsed_triangles = 0; // they were in the file, and are left out
  std::size_t announced_points = 0;    // by the file; there may be fewer
  bool has_more = false;               // in the file than its header announces
};

// The default traits with many threads.
struct Parallel_traits : CGAL::Surface_insertion_traits_3
{
};

template <class Traits>
using Concurrency_of = std::conditional_t<std::is_same<Traits, Parallel_traits>::value,
                                          CGAL::Parallel_tag, CGAL::Sequential_tag>;

// Inserts the surface by the function of the package that fits it; `np` are its named parameters.
template <class Tr, class Traits, class NamedParameters>
void insert_surface(Tr& tr, const Surface& surface, const Traits& traits, const NamedParameters& np)
{
  using Tag = Concurrency_of<Traits>;
  if (surface.is_manifold)
    CGAL::insert_surface_vertices_3<Tag>(tr, surface.mesh, traits, np);
  else
    CGAL::insert_points_3<Tag>(tr, surface.points, surface.faces, traits, np);
}

// Inserts its points with their weights.
template <class Traits, class NamedParameters>
void insert_surface(Regular& tr, const Surface& surface, const Traits&, const NamedParameters& np)
{
  CGAL::insert_points_3<Concurrency_of<Traits>>(tr, surface.weighted, np);
}

// Does the same, watched by `visitor`; returns the vertex of each point, Vertex_handle() of those
// that are hidden.
template <class Tr, class Traits, class Visitor>
std::vector<typename Tr::Vertex_handle> insert_and_watch(Tr& tr, const Surface& surface,
                                                         const Traits& traits, unsigned int seed,
                                                         Visitor& visitor)
{
  std::vector<typename Tr::Vertex_handle> vertices(surface.points.size());
  const auto keep = [&](const auto& pair) { vertices[std::size_t(pair.first)] = pair.second; };
  insert_surface(tr, surface, traits,
                 CGAL::parameters::random_seed(seed)
                     .visitor(std::ref(visitor))
                     .vertex_to_vertex_output_iterator(boost::make_function_output_iterator(keep)));
  return vertices;
}

// Reads a surface in this format, first as a polygon soup, and also as a mesh if its faces are a
// manifold; with weights, faces have no use. The package checks the coordinates and weights.
inline Surface read_surface(const std::string& file_name, const std::string& format,
                            bool with_weights)
{
  files::Polygon_soup soup = files::read_polygon_soup(file_name, format, with_weights);
  Surface surface;
  surface.points = std::move(soup.points);
  surface.faces = std::move(soup.faces);
  surface.collapsed_triangles = soup.collapsed_triangles;
  surface.announced_points = soup.announced_points;
  surface.has_more = soup.has_more;
  namespace PMP = CGAL::Polygon_mesh_processing;
  for (std::size_t i = 0; i < soup.weights.size(); ++i)
    surface.weighted.emplace_back(surface.points[i], soup.weights[i]);
  surface.is_manifold =
      !with_weights && !surface.faces.empty() && PMP::is_polygon_soup_a_polygon_mesh(surface.faces);
  if (surface.is_manifold)
    PMP::polygon_soup_to_polygon_mesh(surface.points, surface.faces, surface.mesh);
  return surface;
}

// Edges with something wrong: their number, and the first of them.
struct Bad_edges
{
  const char* name;
  std::size_t number = 0, ends[2] = {0, 0};

  void add(std::size_t a, std::size_t b)
  {
    if (number++ == 0) {
      ends[0] = a;
      ends[1] = b;
    }
  }
};

// Returns "open edges: 3, first 17-42 at (0.5, 0, 1)": numbers of points, and the midpoint.
inline std::string in_words(const Bad_edges& edges, const Surface& surface)
{
  std::ostringstream text;
  text << std::setprecision(10); // as precise as millimetres on a map
  const Point &p = surface.points[edges.ends[0]], &q = surface.points[edges.ends[1]];
  text << edges.name << ": " << edges.number << ", first " << edges.ends[0] << '-' << edges.ends[1]
       << " at (" << p.x() / 2 + q.x() / 2 << ", " << p.y() / 2 + q.y() / 2 << ", "
       << p.z() / 2 + q.z() / 2 << ')';
  return text.str();
}

// Says why faces are not a closed mesh of triangles, in words, numbers and places; equal points are
// one. To be called only if the faces are not such a mesh.
inline std::string why_not_closed(const Surface& surface,
                                  const CGAL::Delaunay_3_arrays<std::int32_t>& arrays)
{
  // The sides of all faces, sorted by edge: its ends, and whether the side leads to the larger.
  std::vector<std::tuple<std::size_t, std::size_t, bool>> sides;
  std::size_t other_faces = 0;
  for (const std::vector<std::size_t>& face : surface.faces) {
    bool has_repeated = false;
    for (std::size_t k = 0; k < face.size(); ++k) {
      const auto a = std::size_t(arrays.vertex_of_point(face[k]));
      const auto b = std::size_t(arrays.vertex_of_point(face[(k + 1) % face.size()]));
      has_repeated = has_repeated || a == b;
      sides.emplace_back((std::min)(a, b), (std::max)(a, b), a < b);
    }
    other_faces += std::size_t(face.size() != 3 || has_repeated);
  }
  std::sort(sides.begin(), sides.end());

  Bad_edges open{"open edges"}, same{"edges with two faces in the same direction"},
      many{"edges with more than two faces"};
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    const auto [a, b, leads_up] = sides[first];
    while (last < sides.size() && std::get<0>(sides[last]) == a && std::get<1>(sides[last]) == b)
      ++last;
    if (a == b)
      continue;
    if (last - first == 1)
      open.add(a, b);
    else if (last - first == 2 && std::get<2>(sides[first + 1]) == leads_up)
      same.add(a, b);
    else if (last - first > 2)
      many.add(a, b);
  }

  std::string result;
  const auto add = [&](const std::string& text) { result += (result.empty() ? "" : "; ") + text; };
  for (const Bad_edges& edges : {open, same, many})
    if (edges.number > 0)
      add(in_words(edges, surface));
  if (other_faces > 0)
    add("faces that are no triangles: " + std::to_string(other_faces));
  if (result.empty())
    return surface.faces.empty() ? "no faces"
                                 : "sheets that touch in a vertex, or points given twice";
  return result;
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_SURFACE_H
