// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces as packages of CGAL's make them: how Delaunay they are, and what the triangulation of
// their vertices takes with plain CGAL and with this package, in turn. Writes JSON.

#include <Delaunay_from_surface_3_comparison/counts.h>
#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_comparison/run_program.h>
#include <Delaunay_from_surface_3_sources/Source.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/contains_euclidean_minimum_spanning_tree.h>
#include <CGAL/euclidean_minimum_spanning_tree_3.h>
#include <CGAL/insert_points_3.h>
#include <CGAL/insert_surface_vertices_3.h>
#include <Delaunay_from_surface_3_meters/delaunay_share.h>

#include <boost/iterator/function_output_iterator.hpp>
#include <boost/program_options.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using comparison::Json;
using comparison::Mesh;
using comparison::rounded;
using comparison::Triangulation;
using sources::Indexed_surface;
using Vertex = Triangulation::Vertex_handle;

// A vertex where the surface is no manifold becomes several at the same point.
Mesh mesh_of(Indexed_surface surface)
{
  CGAL::Polygon_mesh_processing::orient_polygon_soup(surface.points, surface.faces);
  return surfaces::to_mesh<Mesh>(surface);
}

using Edges = std::vector<std::pair<Vertex, Vertex>>;

std::pair<Vertex, Vertex> sorted(Vertex v, Vertex w)
{
  return std::minmax(v, w); // NOLINT: a pair of copies
}

// The edges of the surface, each once.
Edges edges_of(const Mesh& mesh, const std::map<Mesh::Vertex_index, Vertex>& vertices)
{
  Edges edges;
  for (const auto e : mesh.edges())
    edges.push_back(sorted(vertices.at(mesh.vertex(e, 0)), vertices.at(mesh.vertex(e, 1))));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::size_t largest_degree(const Edges& edges)
{
  std::map<Vertex, std::size_t> degrees;
  std::size_t largest = 0;
  for (const auto& [v, w] : edges)
    for (const Vertex u : {v, w})
      largest = (std::max)(largest, ++degrees[u]);
  return largest;
}

double share_of_spanning_tree(const Triangulation& tr, const Edges& edges)
{
  std::size_t all = 0, found = 0;
  CGAL::euclidean_minimum_spanning_tree_3(
      tr, boost::make_function_output_iterator([&](const std::pair<Vertex, Vertex>& e) {
        ++all;
        found += std::binary_search(edges.begin(), edges.end(), sorted(e.first, e.second));
      }));
  return all == 0 ? 1 : double(found) / double(all);
}

// How far the hypothesis of the paper holds.
Json properties_of(const Mesh& mesh)
{
  Triangulation tr;
  std::map<Mesh::Vertex_index, Vertex> vertices;
  CGAL::insert_surface_vertices_3(
      tr, mesh,
      CGAL::parameters::vertex_to_vertex_output_iterator(std::inserter(vertices, vertices.end())));
  const auto share = meters::delaunay_share(
      tr, mesh, boost::associative_property_map<std::map<Mesh::Vertex_index, Vertex>>(vertices));
  const Edges edges = edges_of(mesh, vertices);
  const auto of = [](std::size_t part, std::size_t all) {
    return rounded(double(part) / double(all));
  };
  return {{"vertices", tr.number_of_vertices()},
          {"triangles", share.triangles},
          {"triangles_delaunay", of(share.delaunay_triangles, share.triangles)},
          {"other_triangles", share.triangles - share.delaunay_triangles},
          {"edges_delaunay", of(share.delaunay_edges, share.edges)},
          {"largest_degree", largest_degree(edges)},
          {"contains_emst", CGAL::contains_euclidean_minimum_spanning_tree(mesh, tr)},
          {"emst_edges_in_surface", rounded(share_of_spanning_tree(tr, edges))},
          {"cells", tr.number_of_cells()}};
}

template <class Traits>
comparison::Take_counts counts_of(const Indexed_surface& surface)
{
  comparison::Take_counts counts;
  Triangulation tr;
  CGAL::insert_points_3(tr, surface.points, surface.faces, Traits(),
                        CGAL::parameters::visitor(std::ref(counts)));
  return counts;
}

// For each point. They do not depend on the machine.
Json cells_destroyed(const Indexed_surface& surface)
{
  const std::size_t n = surface.points.size();
  const auto plain =
      counts_of<comparison::Zone_counting_traits<CGAL::Plain_insertion_traits_3>>(surface);
  const auto ours = counts_of<CGAL::Surface_insertion_traits_3>(surface);
  return {{"plain_destroyed", comparison::per_point(plain.cells_destroyed, n)},
          {"ours_destroyed", comparison::per_point(ours.kernel.cells_destroyed, n)},
          {"ours_tested_to_start", comparison::per_point(ours.kernel.cells_tested_to_start, n)}};
}

void measure(const sources::Source& source, comparison::Gains& gains)
{
  sources::Made made = source.make();
  auto& [points, faces] = made.surface;
  // S is what the triangles have as corners.
  CGAL::Polygon_mesh_processing::remove_isolated_points_in_polygon_soup(points, faces);
  Json found = {{"made_from", source.made_from}};
  if (made.held)
    found["held"] = {{"vertices", made.held->vertices}, {"weighted", made.held->weighted}};
  found.update(properties_of(mesh_of(made.surface)));
  found.update(cells_destroyed(made.surface));
  gains.line(
      source.name, points.size(),
      [&] {
        auto tr = std::make_unique<Triangulation>();
        tr->insert(made.surface.points.begin(), made.surface.points.end());
        return tr;
      },
      [&] {
        auto tr = std::make_unique<Triangulation>();
        CGAL::insert_points_3(*tr, made.surface.points, made.surface.faces);
        return tr;
      },
      [&](Json& line, const auto& expected, const auto& ours) {
        if (!(*expected == *ours))
          throw std::runtime_error(source.name + ": not equal to plain CGAL");
        line.update(found);
      });
}

void measure(const sources::Task& task, const std::string& word, comparison::Gains& gains)
{
  for (const auto& list :
       {sources::scans(task), sources::meshing(task), sources::reconstruction(task),
        sources::iso_surfaces(task), sources::processing(task)})
    for (const sources::Source& source : list) {
      if (source.name.find(word) == std::string::npos)
        continue;
      try {
        measure(source, gains);
      } catch (const sources::Missing& missing) {
        gains.skip(source.name, missing.what());
      }
    }
}

} // namespace

int main(int argc, char** argv)
{
  std::string data_dir, word;
  comparison::Program program("measure_sources",
                              "Measures surfaces as packages of CGAL's make them.");
  program.option("data-dir,d", data_dir, "FOLDER",
                 "where armadillo.off and others are (Debian: libcgal-demo)");
  program.option("only", word, "WORD", "sources with this in their name alone");
  return comparison::run_gains(program, argc, argv, [&](std::size_t n, comparison::Gains& gains) {
    measure({n, data_dir}, word, gains);
  });
}
