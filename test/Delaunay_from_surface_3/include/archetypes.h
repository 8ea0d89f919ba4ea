// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_ARCHETYPES_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_ARCHETYPES_H

// Models of the concepts that can do no more than the concepts ask for, and are neither
// default-constructible, copyable nor assignable where that is not asked for. What compiles with
// them uses nothing that is not documented.

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/paper/Triangulation_target_3.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace tests {

// A graph that models VertexListGraph and EdgeListGraph and nothing else: its descriptors are of
// types of their own.
class Graph_archetype
{
public:
  struct Vertex
  {
    std::size_t hidden = 0;
    friend bool operator==(const Vertex& a, const Vertex& b) { return a.hidden == b.hidden; }
    friend bool operator!=(const Vertex& a, const Vertex& b) { return a.hidden != b.hidden; }
  };

  struct Edge
  {
    Vertex hidden[2];
    friend bool operator==(const Edge& a, const Edge& b)
    {
      return a.hidden[0] == b.hidden[0] && a.hidden[1] == b.hidden[1];
    }
    friend bool operator!=(const Edge& a, const Edge& b) { return !(a == b); }
  };

  // A readable map, and no more.
  class Index_map
  {
  public:
    using key_type = Vertex;
    using value_type = unsigned short;
    using reference = unsigned short;
    using category = boost::readable_property_map_tag;
    friend unsigned short get(const Index_map&, const Vertex& v)
    {
      return static_cast<unsigned short>(v.hidden);
    }
  };

  struct Category : boost::vertex_list_graph_tag, boost::edge_list_graph_tag
  {
  };
  using vertex_descriptor = Vertex;
  using edge_descriptor = Edge;
  using vertex_iterator = std::vector<Vertex>::const_iterator;
  using edge_iterator = std::vector<Edge>::const_iterator;
  using vertices_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using directed_category = boost::undirected_tag;
  using edge_parallel_category = boost::allow_parallel_edge_tag;
  using traversal_category = Category;

  explicit Graph_archetype(std::size_t n)
  {
    for (std::size_t i = 0; i < n; ++i)
      m_vertices.push_back(Vertex{i});
  }
  Graph_archetype(const Graph_archetype&) = delete;
  Graph_archetype& operator=(const Graph_archetype&) = delete;

  void join(std::size_t s, std::size_t t)
  {
    m_edges.push_back(Edge{{m_vertices[s], m_vertices[t]}});
  }

  friend std::pair<vertex_iterator, vertex_iterator> vertices(const Graph_archetype& g)
  {
    return {g.m_vertices.begin(), g.m_vertices.end()};
  }
  friend std::pair<edge_iterator, edge_iterator> edges(const Graph_archetype& g)
  {
    return {g.m_edges.begin(), g.m_edges.end()};
  }
  friend std::size_t num_vertices(const Graph_archetype& g) { return g.m_vertices.size(); }
  friend std::size_t num_edges(const Graph_archetype& g) { return g.m_edges.size(); }
  friend Vertex source(const Edge& e, const Graph_archetype&) { return e.hidden[0]; }
  friend Vertex target(const Edge& e, const Graph_archetype&) { return e.hidden[1]; }

private:
  std::vector<Vertex> m_vertices;
  std::vector<Edge> m_edges;
};

// InsertionPlan: the points as they come, in two rounds.
class Plan_archetype
{
public:
  explicit Plan_archetype(const std::string&) {}

  template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
  CGAL::Delaunay_from_surface_3::Insertion_order operator()(const std::vector<Point>& points,
                                                            const GeomTraits&, const Graph&,
                                                            VertexIndexMap) const
  {
    CGAL::Delaunay_from_surface_3::Insertion_order plan;
    for (std::size_t i = 0; i < points.size(); ++i)
      plan.order.push_back(i);
    if (points.size() > 1)
      plan.round_ends.push_back(points.size() / 2);
    if (!points.empty())
      plan.round_ends.push_back(points.size());
    return plan;
  }
};

// SurfaceSubgraph: every second edge.
class Subgraph_archetype
{
public:
  explicit Subgraph_archetype(const std::string&) {}

  template <class Graph, class VertexIndexMap, class EdgeOutputIterator>
  EdgeOutputIterator operator()(const Graph& graph, VertexIndexMap, EdgeOutputIterator out) const
  {
    bool is_odd = false;
    const auto range = edges(graph);
    for (auto e = range.first; e != range.second; ++e)
      if ((is_odd = !is_odd))
        *out++ = *e;
    return out;
  }
};

// InsertionHints_3: any cell is a correct start.
template <class Target, class Subgraph>
class Hints_archetype
{
public:
  static constexpr bool observes_conflict_zone = false;
  static constexpr bool uses_subgraph = true;

  Hints_archetype(const Target& target, const Subgraph&,
                  const CGAL::Delaunay_from_surface_3::Insertion_order&)
    : m_target(target)
  {
  }
  Hints_archetype(const Hints_archetype&) = delete;
  Hints_archetype& operator=(const Hints_archetype&) = delete;

  typename Target::Cell start(std::size_t) { return m_target.cell(typename Target::Vertex()); }
  template <class CellIterator>
  void before_update(std::size_t, CellIterator, CellIterator)
  {
  }
  void after_update(std::size_t, typename Target::Vertex) {}
  std::size_t trace() { return 0; }

private:
  const Target& m_target;
};

// SurfaceInsertionTraits_3: not default-constructible, and its functors neither.
class Traits_archetype
{
public:
  using Surface_subgraph = Subgraph_archetype;
  using Insertion_plan = Plan_archetype;
  template <class Target, class Subgraph>
  using Insertion_hints_3 = Hints_archetype<Target, Subgraph>;
  static constexpr bool through_core = false;

  explicit Traits_archetype(const std::string& name)
    : m_name(name)
  {
  }
  Traits_archetype(const Traits_archetype&) = delete;
  Traits_archetype& operator=(const Traits_archetype&) = delete;

  Surface_subgraph surface_subgraph_object() const { return Subgraph_archetype(m_name); }
  Insertion_plan insertion_plan_object(unsigned int) const { return Plan_archetype(m_name); }

private:
  std::string m_name;
};

// SurfaceInsertionVisitor_3: derived from nothing, not default-constructible.
class Visitor_archetype
{
public:
  explicit Visitor_archetype(std::size_t* insertions)
    : m_insertions(insertions)
  {
  }
  static constexpr bool follows_points = true;
  void notice(CGAL::Surface_insertion_notice, const std::string&) {}
  void phase_begins(CGAL::Surface_insertion_phase, std::size_t) {}
  template <class Target, class Hints>
  void insertion_ends(const Target&, const Hints&)
  {
  }
  bool go_further(std::size_t) { return ++*m_insertions > 0; }

private:
  std::size_t* m_insertions;
};

} // namespace tests

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_ARCHETYPES_H
