// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes what render.py shows and no other program prints, in VTK's text format:
//   nets.vtk         a surface; for every vertex the round of Surface_net_rounds that inserts it
//   first_round.vtk  the cells of D(S_{N_1}) of the paper's rounds; which of them a path of T enters
//   path.vtk         that path: between the two vertices that are farthest apart along x
//
//   write_scenes MESH.off FOLDER

#include <Delaunay_from_surface_3_meters/Surface_net_rounds.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/surface/No_subgraph.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
using Path = std::vector<std::size_t>;

struct Surface
{
  Mesh mesh;
  std::vector<Point> points; // by vertex index
};

Surface read_surface(const std::string& file_name)
{
  Surface surface;
  if (!CGAL::IO::read_OFF(file_name, surface.mesh))
    throw std::runtime_error("cannot read " + file_name);
  for (const auto v : surface.mesh.vertices())
    surface.points.push_back(surface.mesh.point(v));
  return surface;
}

template <class Plan>
DFS::Insertion_order order_of(const Surface& surface, const Plan& plan)
{
  return plan(surface.points, Kernel(), surface.mesh, get(boost::vertex_index, surface.mesh));
}

// A VTK file with these points; the caller goes on.
std::ofstream begin_file(const std::string& file_name, const std::vector<Point>& points,
                         const std::string& kind)
{
  std::ofstream file(file_name);
  file.precision(9);
  file << "# vtk DataFile Version 3.0\nfigure\nASCII\nDATASET " << kind << "\nPOINTS "
       << points.size() << " double\n";
  for (const Point& p : points)
    file << p << '\n';
  return file;
}

void finish(std::ofstream& file, const std::string& file_name)
{
  if (!file.flush())
    throw std::runtime_error("cannot write " + file_name);
}

void write_nets(const Surface& surface, const std::string& file_name)
{
  const DFS::Insertion_order plan = order_of(surface, DFS::Surface_net_rounds());
  std::vector<std::size_t> round(surface.points.size());
  for (std::size_t h = 0, k = 0; h < plan.round_ends.size(); ++h)
    for (; k < plan.round_ends[h]; ++k)
      round[plan.order[k]] = h;

  std::ofstream file = begin_file(file_name, surface.points, "POLYDATA");
  const std::size_t faces = num_faces(surface.mesh);
  file << "POLYGONS " << faces << ' ' << 4 * faces << '\n';
  for (const auto f : surface.mesh.faces()) {
    file << 3;
    for (const auto v : vertices_around_face(halfedge(f, surface.mesh), surface.mesh))
      file << ' ' << std::size_t(v);
    file << '\n';
  }
  file << "POINT_DATA " << round.size() << "\nSCALARS round int\nLOOKUP_TABLE default\n";
  for (const std::size_t h : round)
    file << h << '\n';
  finish(file, file_name);
}

// The way in the forest T from the vertex with the least x to that with the largest.
Path path_across(const Surface& surface)
{
  std::vector<Mesh::Edge_index> forest;
  DFS::Spanning_forest()(surface.mesh, get(boost::vertex_index, surface.mesh),
                         std::back_inserter(forest));
  std::vector<std::vector<std::size_t>> neighbors(surface.points.size());
  for (const auto e : forest) {
    const std::size_t a = source(e, surface.mesh), b = target(e, surface.mesh);
    neighbors[a].push_back(b), neighbors[b].push_back(a);
  }
  const auto ends = std::minmax_element(surface.points.begin(), surface.points.end());
  const std::size_t first = std::size_t(ends.first - surface.points.begin());
  const std::size_t last = std::size_t(ends.second - surface.points.begin());

  std::map<std::size_t, std::size_t> towards = {{last, last}};
  Path queue = {last};
  for (std::size_t k = 0; k < queue.size() && towards.count(first) == 0; ++k)
    for (const std::size_t v : neighbors[queue[k]])
      if (towards.emplace(v, queue[k]).second)
        queue.push_back(v);
  Path path = {first};
  while (path.back() != last)
    path.push_back(towards.at(path.back()));
  return path;
}

void write_path(const Surface& surface, const Path& path, const std::string& file_name)
{
  std::vector<Point> points;
  for (const std::size_t v : path)
    points.push_back(surface.points[v]);
  std::ofstream file = begin_file(file_name, points, "POLYDATA");
  file << "LINES 1 " << points.size() + 1 << '\n' << points.size();
  for (std::size_t k = 0; k < points.size(); ++k)
    file << ' ' << k;
  file << '\n';
  finish(file, file_name);
}

void write_first_round(const Surface& surface, const Path& path, const std::string& file_name)
{
  const DFS::Insertion_order plan = order_of(surface, DFS::Log_star_rounds(0));
  std::vector<Point> points;
  for (std::size_t k = 0; k < plan.round_ends.front(); ++k)
    points.push_back(surface.points[plan.order[k]]);
  const Triangulation tr(points.begin(), points.end());

  std::set<Triangulation::Cell_handle> entered;
  for (std::size_t k = 1; k < path.size(); ++k)
    for (const auto& c :
         tr.segment_traverser_cell_handles(surface.points[path[k - 1]], surface.points[path[k]]))
      entered.insert(c);

  points.clear();
  std::map<Triangulation::Vertex_handle, std::size_t> number;
  for (const auto v : tr.finite_vertex_handles()) {
    number[v] = points.size();
    points.push_back(v->point());
  }
  std::ofstream file = begin_file(file_name, points, "UNSTRUCTURED_GRID");
  const std::size_t cells = tr.number_of_finite_cells();
  file << "CELLS " << cells << ' ' << 5 * cells << '\n';
  for (const auto c : tr.finite_cell_handles())
    file << 4 << ' ' << number[c->vertex(0)] << ' ' << number[c->vertex(1)] << ' '
         << number[c->vertex(2)] << ' ' << number[c->vertex(3)] << '\n';
  file << "CELL_TYPES " << cells << '\n';
  for (std::size_t k = 0; k < cells; ++k)
    file << "10\n"; // a tetrahedron
  file << "CELL_DATA " << cells << "\nSCALARS entered int\nLOOKUP_TABLE default\n";
  for (const auto c : tr.finite_cell_handles())
    file << entered.count(c) << '\n';
  finish(file, file_name);
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc != 3) {
    std::cerr << "usage: write_scenes MESH.off FOLDER\n";
    return 2;
  }
  try {
    const Surface surface = read_surface(argv[1]);
    const std::string folder = argv[2];
    write_nets(surface, folder + "/nets.vtk");
    const Path path = path_across(surface);
    write_path(surface, path, folder + "/path.vtk");
    write_first_round(surface, path, folder + "/first_round.vtk");
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return 1;
  }
}
