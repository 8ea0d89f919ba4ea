// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures the subgraphs of bounded degree: time and memory per vertex, degrees by genus with both
// kinds of cut, degrees beside their bounds on surfaces of all kinds, trees of nearly minimum degree,
// and what a user would otherwise take. Writes JSON.

#include <Delaunay_from_surface_3_comparison/run_program.h>
#include <Delaunay_from_surface_3_meters/system_of_loops.h>
#include <Delaunay_from_surface_3_subgraphs/degrees.h>
#include <Delaunay_from_surface_3_surfaces/edit.h>
#include <Delaunay_from_surface_3_surfaces/genus_surface.h>
#include <Delaunay_from_surface_3_surfaces/parametric.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/bounded_degree_spanning_subgraph.h>
#include <CGAL/certify_spanning_subgraph.h>
#include <CGAL/squared_distance_3.h>
#include <CGAL/surface_of.h>
#include <CGAL/Delaunay_from_surface_3/surface/cut_graph.h>

#include <boost/graph/depth_first_search.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <iterator>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include <malloc.h>

namespace DFS = CGAL::Delaunay_from_surface_3;

// What is allocated by `new` is counted.
namespace {

std::size_t heap_now = 0, heap_most = 0;

// How much more than at its construction was allocated at the worst moment since.
class Heap_peak
{
public:
  Heap_peak()
    : m_start(heap_now)
  {
    heap_most = heap_now;
  }
  std::size_t bytes() const { return heap_most - m_start; }

private:
  std::size_t m_start;
};

} // namespace

void* operator new(std::size_t size)
{
  void* memory = std::malloc(size);
  if (memory == nullptr)
    throw std::bad_alloc();
  heap_now += malloc_usable_size(memory);
  heap_most = (std::max)(heap_most, heap_now);
  return memory;
}

void operator delete(void* memory) noexcept
{
  if (memory != nullptr)
    heap_now -= malloc_usable_size(memory);
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
  operator delete(memory);
}

namespace {

namespace internal = CGAL::Delaunay_from_surface_3::internal;
using nlohmann::ordered_json;
using surfaces::Indexed_surface;
using Mesh = CGAL::Surface_mesh<Indexed_surface::Point_3>;
using Edges = std::vector<Mesh::Edge_index>;

struct Options
{
  std::vector<std::size_t> sizes = {100000, 1000000, 10000000};
  std::vector<std::size_t> genera = {0, 1, 2, 3, 5, 10, 50};
  std::size_t vertices_by_genus = 200000, repetitions = 3, largest_for_others = 1000000;
  int triangulations = 1000;
  std::vector<std::size_t> near_minimum_genera;
  std::string near_minimum_files;
};

// --- What one would take from Boost.Graph to span a surface: no bound on the degree ----------------

// The minimum spanning tree by edge length.
template <class EdgeOutputIterator>
void minimum_spanning_tree(const Mesh& mesh, EdgeOutputIterator out)
{
  std::vector<double> lengths(num_edges(mesh));
  for (auto e : edges(mesh))
    lengths[e.idx()] =
        CGAL::squared_distance(mesh.point(source(e, mesh)), mesh.point(target(e, mesh)));
  boost::kruskal_minimum_spanning_tree(
      mesh, out,
      boost::weight_map(
          boost::make_iterator_property_map(lengths.begin(), get(boost::edge_index, mesh)))
          .vertex_index_map(get(boost::vertex_index, mesh)));
}

template <class EdgeOutputIterator>
struct Tree_edge_writer : boost::default_dfs_visitor
{
  EdgeOutputIterator out;

  explicit Tree_edge_writer(EdgeOutputIterator o)
    : out(o)
  {
  }

  template <class HalfedgeDescriptor, class Mesh>
  void tree_edge(HalfedgeDescriptor h, const Mesh& mesh)
  {
    *out++ = edge(halfedge(h, mesh), mesh);
  }
};

// A depth-first tree of every component.
template <class EdgeOutputIterator>
void depth_first_tree(const Mesh& mesh, EdgeOutputIterator out)
{
  std::vector<boost::default_color_type> colors(num_vertices(mesh));
  boost::depth_first_search(
      mesh, Tree_edge_writer<EdgeOutputIterator>(out),
      boost::make_iterator_property_map(colors.begin(), get(boost::vertex_index, mesh)));
}

// --- Times, memory, degrees --------------------------------------------------------------------------

// The function is called with a vector to write edges to; returns the smallest processor time of
// all calls.
template <class Function>
double nanoseconds_per_vertex(const Mesh& mesh, std::size_t repetitions, const Function& function)
{
  double best = 1e300;
  for (std::size_t r = 0; r < repetitions; ++r) {
    Edges edges;
    edges.reserve(2 * num_vertices(mesh));
    const std::clock_t start = std::clock();
    function(std::back_inserter(edges));
    best = (std::min)(best, double(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return best * 1e9 / double(num_vertices(mesh));
}

// Beyond the input and the output, at the worst moment.
template <class Function>
double bytes_per_vertex(const Mesh& mesh, const Function& function)
{
  Edges edges;
  edges.reserve(2 * num_vertices(mesh));
  const Heap_peak peak;
  function(std::back_inserter(edges));
  return double(peak.bytes()) / double(num_vertices(mesh));
}

template <class Function>
ordered_json measured(const Mesh& mesh, std::size_t repetitions, const Function& function)
{
  Edges edges;
  edges.reserve(2 * num_vertices(mesh));
  function(std::back_inserter(edges));
  const auto certificate = CGAL::certify_spanning_subgraph(CGAL::surface_of(mesh), edges);
  if (!certificate.is_spanning())
    throw std::runtime_error("what should span the surface does not");
  return {{"nanoseconds_per_vertex", nanoseconds_per_vertex(mesh, repetitions, function)},
          {"bytes_per_vertex", bytes_per_vertex(mesh, function)},
          {"maximum_degree", certificate.maximum_degree},
          {"cycles", certificate.number_of_independent_cycles}};
}

ordered_json measure_times(const std::string& name, const std::string& order,
                           const Indexed_surface& surface, const Options& options)
{
  const std::size_t repetitions = options.repetitions;
  const Mesh mesh = surfaces::to_mesh<Mesh>(surface);
  std::cerr << name << ", " << order << ", " << num_vertices(mesh) << " vertices\n";
  ordered_json result = {{"surface", name}, {"order", order}, {"vertices", num_vertices(mesh)}};
  result["subgraph"] = measured(mesh, repetitions, [&](auto out) {
    CGAL::bounded_degree_spanning_subgraph(CGAL::surface_of(mesh), out);
  });
  result["tree"] = measured(mesh, repetitions, [&](auto out) {
    CGAL::bounded_degree_spanning_tree(CGAL::surface_of(mesh), out);
  });
  result["cut_graph"]["nanoseconds_per_vertex"] = nanoseconds_per_vertex(
      mesh, repetitions, [&](auto out) { DFS::cut_graph(CGAL::surface_of(mesh), out); });
  if (num_vertices(mesh) > options.largest_for_others)
    return result;
  result["minimum_spanning_tree"] =
      measured(mesh, repetitions, [&](auto out) { minimum_spanning_tree(mesh, out); });
  result["depth_first_tree"] =
      measured(mesh, repetitions, [&](auto out) { depth_first_tree(mesh, out); });
  return result;
}

using Reader =
    internal::Halfedge_graph_reader<Mesh,
                                    boost::property_map<Mesh, boost::vertex_index_t>::const_type>;

// The subgraph, cut along loops through one vertex instead of the cut graph.
Edges subgraph_by_loops(const Mesh& mesh, internal::Subgraph_kind kind)
{
  const Reader reader(mesh, get(boost::vertex_index, mesh));
  internal::Rotation_system<std::uint32_t> surface;
  reader.read(surface);
  meters::Find_loops<std::uint32_t> find_loops(surface);
  auto cut = find_loops.as_cut_candidate(find_loops());
  internal::prune_cut(surface, cut);
  Edges edges;
  internal::write_marked(
      reader, surface, internal::Bounded_degree_marks<std::uint32_t>(surface, kind)(std::move(cut)),
      std::back_inserter(edges));
  return edges;
}

ordered_json degrees(const Mesh& mesh, const Edges& subgraph, const Edges& tree)
{
  const auto found = CGAL::certify_spanning_subgraph(CGAL::surface_of(mesh), subgraph);
  const auto found_of_tree = CGAL::certify_spanning_subgraph(CGAL::surface_of(mesh), tree);
  if (!found.is_valid_subgraph() || !found_of_tree.is_valid_tree())
    throw std::runtime_error("a subgraph does not keep what it promises");
  std::size_t above_3 = 0;
  for (std::size_t d = 4; d < found.number_of_vertices_of_degree.size(); ++d)
    above_3 += found.number_of_vertices_of_degree[d];
  return {{"maximum_degree", found.maximum_degree},
          {"maximum_degree_of_tree", found_of_tree.maximum_degree},
          {"vertices_above_3", above_3},
          {"share_above_3", double(above_3) / double(num_vertices(mesh))},
          {"vertices_of_degree", found.number_of_vertices_of_degree},
          {"vertices_of_degree_in_tree", found_of_tree.number_of_vertices_of_degree}};
}

ordered_json measure_degrees(std::size_t genus, std::size_t n)
{
  const Mesh mesh = surfaces::to_mesh<Mesh>(surfaces::genus_surface(genus, n, 0.05, 1));
  std::cerr << "genus " << genus << ", " << num_vertices(mesh) << " vertices\n";
  Edges subgraph, tree, cut;
  CGAL::bounded_degree_spanning_subgraph(CGAL::surface_of(mesh), std::back_inserter(subgraph));
  CGAL::bounded_degree_spanning_tree(CGAL::surface_of(mesh), std::back_inserter(tree));
  DFS::cut_graph(CGAL::surface_of(mesh), std::back_inserter(cut));
  ordered_json result = {{"genus", genus},
                         {"vertices", num_vertices(mesh)},
                         {"bound_of_the_paper", genus == 0 ? 3 : 12 * genus},
                         {"bound", genus == 0 ? 3 : 8 * genus},
                         {"bound_of_tree", genus == 0 ? 3 : 6 * genus},
                         {"cut_graph", degrees(mesh, subgraph, tree)}};
  result["cut_graph"]["cut_edges"] = cut.size();
  if (genus > 0) {
    std::vector<Edges> loops;
    meters::system_of_loops(CGAL::surface_of(mesh), std::back_inserter(loops));
    std::vector<Mesh::Edge_index> on_loops;
    for (const Edges& loop : loops)
      on_loops.insert(on_loops.end(), loop.begin(), loop.end());
    const std::size_t length = on_loops.size();
    std::sort(on_loops.begin(), on_loops.end());
    on_loops.erase(std::unique(on_loops.begin(), on_loops.end()), on_loops.end());
    result["loops"] = degrees(mesh, subgraph_by_loops(mesh, internal::Subgraph_kind::SUBGRAPH),
                              subgraph_by_loops(mesh, internal::Subgraph_kind::TREE));
    result["loops"]["cut_edges"] = on_loops.size();
    result["loops"]["length_of_all_loops"] = length;
  }
  return result;
}

ordered_json measure_near_minimum(const Options& options)
{
  ordered_json result = {{"families", subgraphs::measure_near_minimum_families()},
                         {"times", ordered_json::array()}};
  for (std::size_t genus : options.near_minimum_genera) {
    const Mesh mesh =
        surfaces::to_mesh<Mesh>(surfaces::genus_surface(genus, options.vertices_by_genus, 0.05, 1));
    std::cerr << "genus " << genus << ", " << num_vertices(mesh) << " vertices\n";
    result["times"].push_back(subgraphs::time_near_minimum(
        "genus " + std::to_string(genus), CGAL::surface_of(mesh), options.repetitions));
  }
  result["times"].push_back(
      subgraphs::time_stacked(31, options.vertices_by_genus, options.repetitions));
  return result;
}

ordered_json measure_all(const Options& options)
{
  ordered_json times = ordered_json::array(), by_genus = ordered_json::array(),
               by_surface = ordered_json::array();
  for (std::size_t n : options.sizes) {
    {
      Indexed_surface sphere = surfaces::sphere(n, 0.01, 1);
      times.push_back(measure_times("sphere", "coherent", sphere, options));
      surfaces::shuffle(sphere, 1);
      times.push_back(measure_times("sphere", "shuffled", sphere, options));
    }
    times.push_back(measure_times("disc", "coherent", surfaces::terrain(n, 1), options));
    times.push_back(
        measure_times("genus 3", "coherent", surfaces::genus_surface(3, n, 0.05, 1), options));
  }
  for (std::size_t genus : options.genera)
    by_genus.push_back(measure_degrees(genus, options.vertices_by_genus));
  if (options.triangulations > 0)
    for (const subgraphs::Named_recipe& recipe : subgraphs::named_recipes()) {
      std::cerr << recipe.name << "\n";
      by_surface.push_back(subgraphs::measure_bounds(recipe, options.triangulations));
    }
  ordered_json result = {{"times", times}, {"degrees", by_genus}, {"bounds", by_surface}};
  if (!options.near_minimum_genera.empty())
    result["near_minimum"] = measure_near_minimum(options);
  if (!options.near_minimum_files.empty())
    result["files"] = subgraphs::measure_near_minimum_files(options.near_minimum_files);
  return result;
}

} // namespace

int main(int argc, char** argv)
{
  Options o;
  comparison::Program program("measure_subgraphs",
                              "Measures subgraphs of bounded degree on generated surfaces.");
  program.option("sizes", o.sizes, "N...", "numbers of vertices, for times")->zero_tokens();
  program.option("genera", o.genera, "G...", "for degrees")->zero_tokens();
  program.option("vertices,n", o.vertices_by_genus, "N", "of each surface, for degrees");
  program.option("repetitions,r", o.repetitions, "N", "the fastest counts");
  program.option("others-up-to", o.largest_for_others, "N",
                 "minimum spanning trees and depth-first trees up to so many vertices");
  program.option("triangulations,t", o.triangulations, "N",
                 "of each kind of surface, for degrees beside their bounds");
  program.option("near-minimum", o.near_minimum_genera, "G...",
                 "trees of nearly minimum degree: families, and times for these genera");
  program.option("near-minimum-files", o.near_minimum_files, "FOLDER",
                 "degrees for all .off, .obj, .stl and .ply of a folder, and of those in it");
  return program.run(argc, argv, [&](ordered_json& report) { report.update(measure_all(o)); });
}
