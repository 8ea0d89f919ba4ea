// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes a surface with its cut graph (red) and its subgraph of bounded degree (blue) as coloured
// PLY. Edges are drawn as thin prisms, which every viewer shows: ParaView, MeshLab.

#include <CGAL/bounded_degree_spanning_subgraph.h>
#include <CGAL/Delaunay_from_surface_3/subgraph/cut_graph.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<K::Point_3>;
using Edges = std::vector<Mesh::Edge_index>;

struct Coloured_soup
{
  std::vector<K::Point_3> points;
  std::vector<const char*> colours; // of points
  std::vector<std::array<std::size_t, 3>> triangles;

  std::size_t add(const K::Point_3& p, const char* colour)
  {
    points.push_back(p);
    colours.push_back(colour);
    return points.size() - 1;
  }
};

void add_surface(const Mesh& mesh, Coloured_soup& soup)
{
  for (auto v : mesh.vertices())
    soup.add(mesh.point(v), "225 225 220");
  for (auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    soup.triangles.push_back({mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))});
  }
}

// A prism with three sides around every edge, an eighth or so of an edge thick.
void add_edges(const Mesh& mesh, const Edges& edges, const char* colour, double thickness,
               Coloured_soup& soup)
{
  for (auto e : edges) {
    const K::Point_3 p = mesh.point(mesh.vertex(e, 0)), q = mesh.point(mesh.vertex(e, 1));
    const K::Vector_3 along = q - p;
    const K::Vector_3 other =
        std::abs(along.x()) < std::abs(along.y()) ? K::Vector_3(1, 0, 0) : K::Vector_3(0, 1, 0);
    K::Vector_3 u = CGAL::cross_product(along, other);
    if (u.squared_length() == 0)
      continue; // an edge of length 0
    u = u / std::sqrt(u.squared_length());
    K::Vector_3 v = CGAL::cross_product(along, u);
    v = v / std::sqrt(v.squared_length());
    const double r = thickness * std::sqrt(along.squared_length());
    std::array<std::size_t, 6> corner;
    for (int i = 0; i < 3; ++i) {
      const K::Vector_3 offset =
          r * (std::cos(2 * CGAL_PI * i / 3) * u + std::sin(2 * CGAL_PI * i / 3) * v);
      corner[i] = soup.add(p + offset, colour);
      corner[i + 3] = soup.add(q + offset, colour);
    }
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      soup.triangles.push_back({corner[i], corner[j], corner[j + 3]});
      soup.triangles.push_back({corner[i], corner[j + 3], corner[i + 3]});
    }
  }
}

bool write_ply(const Coloured_soup& soup, const std::string& file_name)
{
  std::ofstream file(file_name);
  file << "ply\nformat ascii 1.0\nelement vertex " << soup.points.size()
       << "\nproperty double x\nproperty double y\nproperty double z\n"
          "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face "
       << soup.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::size_t i = 0; i < soup.points.size(); ++i)
    file << soup.points[i] << ' ' << soup.colours[i] << '\n';
  for (const auto& t : soup.triangles)
    file << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  return bool(file.flush());
}

int main(int argc, char** argv)
{
  Mesh mesh;
  if (!CGAL::IO::read_OFF(argc > 1 ? argv[1] : "data/torus.off", mesh)) {
    std::cerr << "cannot read the mesh\n";
    return EXIT_FAILURE;
  }
  Edges cut, subgraph;
  CGAL::Delaunay_from_surface_3::cut_graph(mesh, std::back_inserter(cut));
  CGAL::bounded_degree_spanning_subgraph(mesh, std::back_inserter(subgraph));

  Coloured_soup soup;
  add_surface(mesh, soup);
  add_edges(mesh, subgraph, "40 90 170", 0.04, soup);
  add_edges(mesh, cut, "210 50 60", 0.08, soup);
  const std::string file_name = argc > 2 ? argv[2] : "cut_and_subgraph.ply";
  if (!write_ply(soup, file_name)) {
    std::cerr << "cannot write " << file_name << "\n";
    return EXIT_FAILURE;
  }
  std::cout << file_name << ": " << cut.size() << " edges of the cut, " << subgraph.size()
            << " of the subgraph\n";
  return EXIT_SUCCESS;
}
